/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the certificates share: errors against their tolerances. */
#ifndef PH_CHECK_ERROR_H
#define PH_CHECK_ERROR_H

#include "base/diag.h"
#include "check/scale.h"
#include "curve/result.h"

#include <math.h>
#include <stdbool.h>

/* One error: the largest so far, whether all were within their tolerance, and
 * by how much the worst was not. */
struct ph_check_error {
  enum ph_diagnostic what;
  const char *list; /* what `where' counts; NULL: segments */
  bool done;        /* whether there was anything to check */
  double reported;  /* the largest, as in the record */
  double excess;    /* the largest error / allowed */
  double value;     /* the error and */
  double allowed;   /* its tolerance at the largest excess */
  size_t where;
};

/* ph_check_add: one more error, in the segment `where`; NaN is never allowed.
 *
 * in   unit     what the record's number is relative to
 * in   allowed  as large as the error may be, > 0
 */
static inline void ph_check_add(struct ph_check_error *check, size_t where,
                                double error, double unit, double allowed) {
  check->done = true;
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

/* ph_check_join: what was found further on, too. */
static inline void ph_check_join(struct ph_check_error *check,
                                 const struct ph_check_error *next) {
  check->done |= next->done;
  if (ph_check_is_larger(next->reported, check->reported)) {
    check->reported = next->reported;
  }
  if (ph_check_is_larger(next->excess, check->excess)) {
    check->excess = next->excess;
    check->value = next->value;
    check->allowed = next->allowed;
    check->where = next->where;
  }
}

/* ph_check_conclude: stores n errors, up to the first that exceeded its
 * tolerance anywhere: PH_E_NO_CONVERGENCE, with the worst place.  One that is
 * NULL was not asked for. */
enum ph_status ph_check_conclude(const struct ph_check_error *const *check,
                                 size_t n, struct ph_diagnostics *diagnostics,
                                 struct ph_diag *diag);

/* ph_check_finite: PH_E_TOO_LARGE unless all numbers of the curve are finite;
 * of angles[] some may be none. */
enum ph_status ph_check_finite(const struct ph_curve *curve,
                               struct ph_diag *diag);

#endif
