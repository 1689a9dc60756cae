/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Random points on spheres, in families that are named for what is hard about
 * them, and the splines through them.
 */
#ifndef PH_TESTS_PROP_SPHERE_DATA_H
#define PH_TESTS_PROP_SPHERE_DATA_H

#include "problem_unit.h"
#include "unit.h"

#include "curve/segment/spherical.h"

enum { SPHERE_MAX = 40 }; /* points */

enum sphere_family {
  SPHERE_SMOOTH,   /* steps of 0.05 to 0.3, bending smoothly */
  SPHERE_WALK,     /* steps of 0.1 to 1.57 anywhere */
  SPHERE_FAR,      /* to 2.2 */
  SPHERE_FARTHEST, /* to 3 */
  SPHERE_CIRCLE,   /* a great circle, one after the other */
  SPHERE_RUNS,     /* parts of great circles */
  SPHERE_NEARLY,   /* great circles but for turns of 1e-9 to 1e-2 */
  SPHERE_DENSE,    /* steps of 1e-6 to 1e-3, bending smoothly */
  SPHERE_RING,     /* closed, once around */
  SPHERE_FAMILY_N
};

/* A problem.  Words are NULL where the field is absent. */
struct sphere_data {
  enum sphere_family family;
  bool closed;
  size_t n;
  ph_vec3 point[SPHERE_MAX]; /* unit vectors */
  ph_vec3 center;
  double radius;
  bool lonlat; /* how they are given: the sphere's center is no matter */
  const char *model, *ends, *knots, *criterion, *increase;
  double by;              /* V of increase */
  bool shape;             /* tensions are raised */
  double tension;         /* to begin with, at all points */
  ph_vec3 end_tangent[2]; /* given where ends is "clamped" */
};

/* sphere_of: n points of a family on the unit sphere; all else by default. */
void sphere_of(struct unit_random *r, enum sphere_family family, size_t n,
               struct sphere_data *data);

/* sphere_options: any model, ends, knots and tension. */
void sphere_options(struct unit_random *r, struct sphere_data *data);

/* sphere_any: any family, options and sphere, up to 12 points. */
void sphere_any(struct unit_random *r, struct sphere_data *data);

/* sphere_steps: the angles between neighbours; out  step[data->n].
 * ret  how many */
size_t sphere_steps(const struct sphere_data *data, double *step);

/*
 * sphere_solve: solves, then certifies, and looks at points and lengths by
 * itself: fails unless the curve is right, or there is none for a reason that
 * data can have, or the certificate refuses it.  Memory that the solver is to
 * give back is checked.
 *
 * inout solution  what it held is given back
 * ret   whether there is a curve
 */
bool sphere_solve(const struct sphere_data *data, size_t which,
                  struct unit_solution *solution);

/* sphere_must: the same; fails unless there is a curve. */
void sphere_must(const struct sphere_data *data, size_t which,
                 struct unit_solution *solution);

/* sphere_point: control point i of segment k, on the unit sphere. */
ph_vec3 sphere_point(const struct unit_solution *solution, size_t k, size_t i);

#endif
