/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Proofs that a stationary point is a minimum (see newton.h). */
#include "solve/arclength/newton.h"

#include "solve/arclength/system.h"

/* Weights of J^T J that prove a minimum: of 10,000 directions that are noisy
 * 1e7 and 1e8 do, and each may fail where the other does not. */
static const double PROOF[] = {1e2, 1e4, 1e6, 1e8, 1e7};
enum { PROOFS = sizeof PROOF / sizeof PROOF[0] };
/* The same of a steep one. */
static const double PROOF_STEEP = 1e10;
/* Where that fails the diagonal is raised by this part of the largest element
 * of the Hessian, below which curvature is rounding: of many points all is.  It
 * is half of what the certificate takes for rounding (check/stationary.c). */
static const double ROUNDING = 2048 * 2.2204460492503131e-16;

bool ph_arc_is_positive(const struct ph_arc_system *s, struct ph_arc_newton *w,
                        const double *x, const double *y, double rho,
                        const struct ph_arc_weights *weights) {
  return ph_arc_penalised_factor(s, x, y, &w->linear, weights, rho,
                                 w->penalised);
}

/* Whether the Hessian is positive definite with this weight of J^T J, and a
 * shift of its rounding. */
static bool proves(const struct ph_arc_system *s, struct ph_arc_newton *work,
                   const double *x, const double *y, double rho,
                   double rounding) {
  struct ph_arc_weights weights = {
      .functional = 1, .pin = PH_ARC_PIN, .rounding = rounding};
  return ph_arc_is_positive(s, work, x, y, rho, &weights);
}

bool ph_arc_is_minimum(const struct ph_arc_system *s,
                       struct ph_arc_newton *work, const double *x,
                       const double *y) {
  ph_arc_linearise(s, x, y, &work->linear);
  for (size_t k = 0; k < 2 * PROOFS && !ph_arena_late(work->arena); k++) {
    size_t at = (k + work->proved) % (2 * PROOFS);
    if (proves(s, work, x, y, PROOF[at % PROOFS], at < PROOFS ? 0 : ROUNDING)) {
      work->proved = at;
      return true;
    }
  }
  return false;
}

bool ph_arc_is_steep(const struct ph_arc_system *s, struct ph_arc_newton *work,
                     const double *x, const double *y) {
  ph_arc_linearise(s, x, y, &work->linear);
  return proves(s, work, x, y, PROOF_STEEP, 0) ||
         proves(s, work, x, y, PROOF_STEEP, ROUNDING);
}
