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
  return ph_fail_at(diag, PH_NO_CONVERGENCE, "segments", check->where,
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
  size_t n = curve->n, points = n * (curve->degree + 1) * curve->dimension;
  size_t preimage = n * curve->preimage.n * curve->preimage.dimension;
  if (ph_are_finite(curve->control_points, points) &&
      ph_are_finite(curve->preimage.v, preimage) &&
      ph_are_finite(curve->knots, n + 1) && ph_are_finite(curve->lengths, n) &&
      isfinite(curve->length) &&
      (!curve->preimage.alpha || ph_are_finite(curve->preimage.alpha, n)) &&
      (!curve->choice.tension || ph_are_finite(curve->choice.tension, n))) {
    return PH_OK;
  }
  return ph_fail(diag, PH_TOO_LARGE, NULL,
                 "the curve exceeds the range of a double");
}

/* Powers S0^(4-j) S1^j at a node. */
static void powers_at(const double base[2], double power[5]) {
  double p = base[0] * base[0], q = base[1] * base[1], pq = base[0] * base[1];
  power[0] = p * p;
  power[1] = p * pq;
  power[2] = p * q;
  power[3] = q * pq;
  power[4] = q * q;
}

struct ph_check_space ph_check_space_of(const struct ph_quad *rule,
                                        double angle) {
  struct ph_check_space space = {.of = ph_atph_of(angle)};
  for (size_t i = 0; i < rule->n; i++) {
    double base[2];
    ph_atph_basis(&space.of, rule->node[i], base);
    powers_at(base, space.leg[i]);
    for (size_t j = 0; j < 5; j++) {
      space.mu[j] += rule->weight[i] * space.leg[i][j];
    }
    space.square[i][0] = base[0] * base[0];
    space.square[i][1] = 2 * space.of.c * base[0] * base[1];
    space.square[i][2] = base[1] * base[1];
  }
  for (size_t i = 0; i < rule->n; i++) {
    for (size_t j = 0; j < 5; j++) {
      space.leg[i][j] /= space.mu[j];
    }
  }
  return space;
}

void ph_check_space_for(struct ph_check_space *space,
                        const struct ph_quad *rule,
                        const struct ph_curve *curve, size_t k) {
  double angle = curve->preimage.alpha ? curve->preimage.alpha[k] : 0;
  if (!(angle <= space->of.angle && angle >= space->of.angle)) {
    *space = ph_check_space_of(rule, angle);
  }
}
