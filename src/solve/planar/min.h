/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The fairest planar spline: angles of ATPH segments, or knot spacings of PH
 * quintics, that minimise a functional of its curvature [GON18, sec. 2.5].
 */
#ifndef PH_SOLVE_PLANAR_MIN_H
#define PH_SOLVE_PLANAR_MIN_H

#include "solve/planar/data.h"

/* See curve/energy.h. */
enum ph_planar_functional {
  PH_PLANAR_E,
  PH_PLANAR_MV,
  PH_PLANAR_IES,
  PH_PLANAR_IMV
};

struct ph_planar_min {
  double start;   /* for the data as given, in their unit; NaN: no solution */
  double minimum; /* the least that was found */
  size_t evaluations;
  bool at_bound; /* an angle or spacing is as small or large as is allowed */
};

/*
 * ph_planar_minimize: searches from several starts, one of them the data as
 * given, for a minimum over
 *
 *   atph  every angle, in [1e-3, 2 pi/3]; or with `scale` one factor on all
 *         of them, in the proportions that the data have
 *   ph    every knot spacing, in [1/20, 20] times what chordal knots have;
 *         the first and last knot stay
 *
 * Given end derivatives keep their values, per unit of the knots.
 *
 * inout data         at the minimiser; as given where there is no solution
 * out   b[unknowns]  the solution there
 * ret   PH_OK | PH_BAD_VALUE (`scale` of ph) | PH_NO_MEMORY |
 *       PH_NO_CONVERGENCE: the data have no solution, and the minimum is NaN;
 *       or the search was cut short while it still gained 1e-8 a
 *       step, and data, b and report are the best found
 */
enum ph_status ph_planar_minimize(struct ph_planar_data *data,
                                  enum ph_planar_functional functional,
                                  bool scale, struct ph_arena *scratch,
                                  ph_cplx *b, struct ph_planar_min *report,
                                  struct ph_diag *diag);

#endif
