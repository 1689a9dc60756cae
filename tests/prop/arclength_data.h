/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Random problems with prescribed arc lengths, in families that are named for
 * what is hard about them, and their solutions.
 */
#ifndef PH_TESTS_PROP_ARCLENGTH_DATA_H
#define PH_TESTS_PROP_ARCLENGTH_DATA_H

#include "problem_unit.h"
#include "unit.h"

#include "kernel/vec3.h"

enum { ARC_MAX = 16 }; /* intervals */

enum arc_family {
  ARC_SMOOTH,    /* a smooth curve at uneven parameters, exact lengths */
  ARC_PERTURBED, /* the same, lengths up to 1 % wrong */
  ARC_PLANE,     /* a smooth curve in some plane */
  ARC_WALK,      /* steps of 0.5 to 2 anywhere, 1.05 to 1.5 times as long */
  ARC_WILD,      /* steps of 1e-3 to 1, 1 + 1e-6 to 1 + 1e3 times as long */
  ARC_LINE,      /* one after the other on a line */
  ARC_FAMILY_N
};

/* What is given at the knots; lengths are given with all but the second. */
enum arc_given {
  ARC_POINTS,
  ARC_RELAXED,
  ARC_SOFT, /* points, and lengths with a deviation */
  ARC_DERIVATIVES,
  ARC_TANGENTS,
  ARC_GIVEN_N
};

struct arc_data {
  enum arc_family family;
  enum arc_given given;
  size_t n; /* intervals */
  bool closed;
  ph_vec3 point[ARC_MAX + 1];  /* also where they are not given */
  ph_vec3 vector[ARC_MAX + 1]; /* derivatives or tangents */
  double length[ARC_MAX];
  double sigma;
  int refine;        /* 0: by default */
  const char *knots; /* NULL: by default */
};

/* arc_of: a problem of a family with so many intervals, open. */
void arc_of(struct unit_random *r, enum arc_family family, enum arc_given given,
            size_t n, struct arc_data *data);

/* arc_closed: a closed smooth curve, of points. */
void arc_closed(struct unit_random *r, enum arc_given given, size_t n,
                struct arc_data *data);

/* arc_any: any family but ARC_LINE, anything given, n to ARC_MAX / 2. */
void arc_any(struct unit_random *r, struct arc_data *data);

/*
 * arc_solve: solves, then certifies and looks at points and lengths by itself:
 * fails unless the curve is right, or refused for a reason that data can have;
 * of wild data the certificate may be what refuses it.  Memory that the solver
 * is to give back is checked.
 *
 * inout solution  what it held is given back
 * ret   whether there is a curve
 */
bool arc_solve(const struct arc_data *data, size_t which,
               struct unit_solution *solution);

/* arc_must: the same; fails unless there is a curve. */
void arc_must(const struct arc_data *data, size_t which,
              struct unit_solution *solution);

/* arc_f: F of a solution. */
double arc_f(const struct unit_solution *solution);

/* arc_is_minimum: whether it is certified to be one. */
bool arc_is_minimum(const struct unit_solution *solution);

/* arc_point: control point i of segment k. */
ph_vec3 arc_point(const struct unit_solution *solution, size_t k, size_t i);

/* arc_length: of data interval i, by quadrature. */
double arc_length(const struct unit_solution *solution, size_t n, size_t i);

#endif
