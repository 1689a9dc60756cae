/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Random data for curves of Tschirnhausen cubics, one family for each way to
 * find them, and the curves.
 */
#ifndef PH_TESTS_PROP_TC_DATA_H
#define PH_TESTS_PROP_TC_DATA_H

#include "problem_unit.h"
#include "unit.h"

#include "kernel/cplx.h"

enum { TC_MAX = 24 }; /* points */

enum tc_family {
  TC_ONE,         /* g1: one interval, tangents anywhere */
  TC_AUTO,        /* g1-auto: tangents anywhere */
  TC_FAIR,        /* g1-fair */
  TC_PAIR,        /* g1-pair */
  TC_LAMBDA,      /* g1-pair with a lambda: C1 */
  TC_CHORD,       /* g1-pair, joints on the chords at an angle that may be */
  TC_C1,          /* derivatives of 0.1 to 3 chords anywhere */
  TC_SPLINE,      /* points alone */
  TC_G2,          /* the same with continuous curvature */
  TC_APPROXIMATE, /* a Bezier curve, to a tolerance */
  TC_FAMILY_N
};

/* A problem.  Words are NULL and numbers NaN where the field is absent. */
struct tc_data {
  enum tc_family family;
  bool closed;
  size_t n;
  ph_cplx point[TC_MAX];  /* or control points of the Bezier curve */
  ph_cplx vector[TC_MAX]; /* tangents or derivatives of the families of such */
  const char *solutions, *ends;
  double lambda, joint_angle, joint_position, tolerance, pieces;
  ph_cplx end[2]; /* of splines: end_derivatives, where ends is "given" */
};

/*
 * tc_of: data of a family, up to 8 points, all else by default.  Coordinates of
 * points are multiples of 2^-20 and neighbours are 0.5 to 5 apart.
 */
void tc_of(struct unit_random *r, enum tc_family family, struct tc_data *data);

/* tc_segments: intervals between the points. */
size_t tc_intervals(const struct tc_data *data);

/* tc_chord: from the start of interval i to its end. */
ph_cplx tc_chord(const struct tc_data *data, size_t i);

/*
 * tc_solve: solves, certifies all curves, and looks by itself at points,
 * tangents and lengths: fails unless the curve is right, or is infeasible in a
 * family where that can be.  Memory that the solver is to give back is checked.
 *
 * inout solution  what it held is given back
 * ret   whether there is a curve
 */
bool tc_solve(const struct tc_data *data, size_t which,
              struct unit_solution *solution);

/* tc_must: the same; fails unless there is a curve. */
void tc_must(const struct tc_data *data, size_t which,
             struct unit_solution *solution);

/* tc_point: control point i of cubic k, and r' there for i = 0 and 3. */
ph_cplx tc_point(const struct ph_curve *curve, size_t k, size_t i);
ph_cplx tc_derivative(const struct ph_curve *curve, size_t k, size_t i);

#endif
