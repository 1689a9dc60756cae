/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Proofs that a stationary point is a minimum (see newton.h). */
#include "solve/arclength/newton.h"

#include "solve/arclength/system.h"

/* Curvature below this part of the largest element of the Hessian is rounding:
 * of many points all is.  It is half of what the certificate takes for rounding
 * (check/stationary.c). */
static const double ROUNDING = 2048 * 2.2204460492503131e-16;

/* What rows, of size 1, yield: A + J^T J / yield is positive definite then.
 * More than the rounding of the matrix, so that rows that depend on each other
 * count; or nothing, beside near-cusps, where multipliers are so large that it
 * would not do. */
static const double YIELD[] = {5e-13, 0};
enum { YIELDS = sizeof YIELD / sizeof YIELD[0] };

bool ph_arc_is_minimum(const struct ph_arc_system *s, struct ph_arc_newton *w,
                       const double *x, const double *y) {
  struct ph_arc_weights weights = {
      .functional = 1, .pin = 1, .rounding = ROUNDING};
  bool proved = false;
  ph_arc_linearise(s, x, y, &w->linear);
  for (size_t k = 0; k < YIELDS && !proved; k++) {
    weights.yield = YIELD[k];
    proved = ph_arc_kkt_negative(s, x, y, &w->linear, &weights, w->kkt,
                                 w->minors) == s->y_n;
  }
  return proved;
}
