/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The certificate of spatial Hermite interpolants: their shape (see certify.h).
 */
#include "check/certify.h"

#include "check/checks.h"
#include "check/shape_spatial.h"

/* Whether all segments keep the shape of the data. */
static void describe_shape(const struct ph_curve *curve,
                           struct ph_diagnostics *diagnostics) {
  bool shape_ok = true;
  for (size_t k = 0; curve->choice.shape_ok && k < curve->n; k++) {
    shape_ok = shape_ok && curve->choice.shape_ok[k];
  }
  if (curve->choice.shape_ok) {
    ph_diagnostics_set(diagnostics, PH_D_SHAPE_OK, shape_ok);
  }
}

void ph_check_spatial_shape(struct ph_check *v,
                            const struct ph_check_segment *s) {
  const struct ph_value *given = &v->problem->field[PH_F_PLANARITY];
  double planarity = given->kind == PH_NUMBER ? given->number : PH_PLANARITY;
  const bool *claimed = v->curve->choice.shape_ok;
  if (claimed && claimed[s->k] && v->fault == PH_CHECK_SHAPE_KEPT) {
    v->fault = (int)ph_check_shape_of(s->leg, v->space->mu, v->allow->square,
                                      s->reach, planarity);
    v->fault_at = s->k;
  }
}

enum ph_status ph_check_spatial_hermite(struct ph_check *v,
                                        struct ph_diagnostics *diagnostics) {
  static const char *const wrong[] = {
      [PH_CHECK_SHAPE_START] = "it is not convex at its start",
      [PH_CHECK_SHAPE_END] = "it is not convex at its end",
      [PH_CHECK_SHAPE_TORSION] = "its torsion changes sign"};
  if (v->fault != PH_CHECK_SHAPE_KEPT) {
    return ph_fail_at(v->diag, PH_E_NO_CONVERGENCE, "segments", v->fault_at,
                      "is refused by its certificate: %s is claimed, but %s",
                      ph_diagnostic_name(PH_D_SHAPE_OK), wrong[v->fault]);
  }
  describe_shape(v->curve, diagnostics);
  return PH_OK;
}
