/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the certificates share (see error.h). */
#include "check/error.h"

static enum ph_status conclude(const struct ph_check_error *check,
                               struct ph_diagnostics *diagnostics,
                               struct ph_diag *diag) {
  ph_diagnostics_set(diagnostics, check->what, check->reported);
  if (check->excess <= 1 && isfinite(check->reported)) {
    return PH_OK;
  }
  return ph_fail_at(diag, PH_E_NO_CONVERGENCE,
                    check->list ? check->list : "segments", check->where,
                    "is refused by its certificate: %s is %.3g, at most %.3g "
                    "is allowed",
                    ph_diagnostic_name(check->what), check->value,
                    check->allowed);
}

enum ph_status ph_check_conclude(const struct ph_check_error *const *check,
                                 size_t n, struct ph_diagnostics *diagnostics,
                                 struct ph_diag *diag) {
  enum ph_status status = PH_OK;
  for (size_t i = 0; i < n && status == PH_OK; i++) {
    status = check[i] ? conclude(check[i], diagnostics, diag) : PH_OK;
  }
  return status;
}

enum ph_status ph_check_finite(const struct ph_curve *curve,
                               struct ph_diag *diag) {
  size_t n = curve->n, points = ph_curve_points_n(curve) * curve->dimension;
  size_t preimage = n * curve->preimage.n * curve->preimage.dimension;
  if (ph_are_finite(curve->control_points, points) &&
      ph_are_finite(curve->preimage.v, preimage) &&
      ph_are_finite(curve->knots, n + 1) && ph_are_finite(curve->lengths, n) &&
      isfinite(curve->length) &&
      (!curve->preimage.alpha || ph_are_finite(curve->preimage.alpha, n)) &&
      (!curve->choice.tension || ph_are_finite(curve->choice.tension, n))) {
    return PH_OK;
  }
  return ph_fail(diag, PH_E_TOO_LARGE, NULL,
                 "the curve exceeds the range of a double");
}
