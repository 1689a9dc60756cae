/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The data of a planar spline: points, knots, angles and end derivatives of a
 * problem, checked and brought to unit scale.
 *
 * Unit scale is a power of two for the points (coordinates below 1/2) and the
 * mean knot spacing for the parameter.  Both are undone exactly, or to one
 * rounding, where the solution is written.
 */
#ifndef PH_SOLVE_PLANAR_DATA_H
#define PH_SOLVE_PLANAR_DATA_H

#include "curve/problem.h"
#include "solve/planar_c2.h"

struct ph_planar_data {
  const double *points; /* [points_n][2], the user's */
  size_t n;             /* segments */
  bool closed;
  bool atph;             /* else all angles are 0 */
  int exponent;          /* unit scale = data times 2^exponent; even */
  double *h;             /* [n] knot spacings, mean 1 */
  double h_mean;         /* in the user's parameter */
  double *knots;         /* [n + 1], the user's parameter */
  double *chord;         /* [n] |c| at unit scale */
  struct ph_atph *space; /* [n] atph, [1] ph */
  struct ph_planar_c2 c2;
};

/*
 * ph_planar_data_of: reads and checks a problem.
 *
 * ret  PH_OK | PH_TOO_FEW_POINTS | PH_COINCIDENT_POINTS | PH_BAD_SHAPE |
 *      PH_BAD_VALUE | PH_ZERO_TANGENT | PH_TOO_LARGE | PH_NO_MEMORY
 */
enum ph_status ph_planar_data_of(const struct ph_problem *problem,
                                 struct ph_arena *arena,
                                 struct ph_planar_data *data,
                                 struct ph_diag *diag);

/* ph_planar_point: point k, 0 <= k <= n, of the user. */
static inline ph_cplx ph_planar_point(const struct ph_planar_data *d,
                                      size_t k) {
  size_t i = d->closed && k == d->n ? 0 : k;
  return ph_cplx_of(d->points[2 * i], d->points[2 * i + 1]);
}

#endif
