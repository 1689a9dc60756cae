/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * What the certificates share: errors against their tolerances, and the basis
 * of control points at the nodes of a Gauss rule.
 *
 * The derivative of the basis of control points p0, ..., p5 is
 *   r'(u) = sum_j (p[j+1] - p[j]) S0^(4-j) S1^j / mu_j                 (1)
 * with S0, S1 and mu as in kernel/atph.h; mu_j is integrated here by the same
 * Gauss rule.
 */
#ifndef PH_CHECK_ERROR_H
#define PH_CHECK_ERROR_H

#include "base/diag.h"
#include "check/scale.h"
#include "curve/result.h"
#include "kernel/atph.h"
#include "kernel/quad.h"

#include <math.h>
#include <stdbool.h>

/* Nodes: exact for degree 11, as |r'| has 4 and mu_j has 4; for angles below pi
 * 12 nodes reach rounding. */
enum { PH_CHECK_NODES_PH = 6, PH_CHECK_NODES_ATPH = 12 };

/* One error: the largest so far, whether all were within their tolerance, and
 * by how much the worst was not. */
struct ph_check_error {
  enum ph_diagnostic what;
  double reported; /* the largest, as in the record */
  double excess;   /* the largest error / allowed */
  double value;    /* the error and */
  double allowed;  /* its tolerance at the largest excess */
  size_t where;
};

/* ph_check_add: one more error, in the segment `where`; NaN is never allowed.
 *
 * in   unit     what the record's number is relative to
 * in   allowed  as large as the error may be, > 0
 */
static inline void ph_check_add(struct ph_check_error *check, size_t where,
                                double error, double unit, double allowed) {
  if (ph_check_is_larger(error / unit, check->reported)) {
    check->reported = error / unit;
  }
  if (ph_check_is_larger(error / allowed, check->excess)) {
    check->excess = error / allowed;
    check->value = error / unit;
    check->allowed = allowed / unit;
    check->where = where;
  }
}

/* ph_check_conclude: stores n errors, up to the first that exceeded its
 * tolerance anywhere: PH_NO_CONVERGENCE, with the worst place.  One that is
 * NULL was not asked for. */
enum ph_status ph_check_conclude(const struct ph_check_error *const *check,
                                 size_t n, struct ph_diagnostics *diagnostics,
                                 struct ph_diag *diag);

/* ph_check_finite: PH_TOO_LARGE unless all numbers of the curve are finite; of
 * angles[] some may be none. */
enum ph_status ph_check_finite(const struct ph_curve *curve,
                               struct ph_diag *diag);

/* A space of preimages, at the nodes. */
struct ph_check_space {
  struct ph_atph of;
  double mu[5];                          /* integrals of S0^(4-j) S1^j */
  double leg[PH_CHECK_NODES_ATPH][5];    /* S0^(4-j) S1^j / mu_j */
  double square[PH_CHECK_NODES_ATPH][3]; /* S0^2, 2 c S0 S1, S1^2 */
};

/* ph_check_space_of: the space of an angle in [0, pi); any other number gives
 * what no curve agrees with. */
struct ph_check_space ph_check_space_of(const struct ph_quad *rule,
                                        double angle);

/* ph_check_space_for: makes the space that of segment k, if it is not yet:
 * neighbours often share it. */
void ph_check_space_for(struct ph_check_space *space,
                        const struct ph_quad *rule,
                        const struct ph_curve *curve, size_t k);

/* ph_check_binomial: 1, 4, 6, 4, 1: what S0^(4-j) S1^j must be multiplied by
 * for a coefficient of r' that has the size of r'. */
static inline double ph_check_binomial(size_t j) {
  static const double binomial[5] = {1, 4, 6, 4, 1};
  return binomial[j];
}

#endif
