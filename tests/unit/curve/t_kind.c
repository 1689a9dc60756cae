/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Every row of the table of curve kinds has what the others rely on. */
#include "unit.h"

#include "curve/kind/kind.h"

static void ck_sampler(const struct ph_sampler_ops *ops) {
  ck_assert(ops->begin && ops->enter && ops->at && ops->length &&
            ops->chord_bound);
}

PH_TEST_EACH(test_complete, PH_CURVE_N) {
  const struct ph_kind *kind = ph_kinds[_i];
  ck_assert_ptr_nonnull(kind);
  if (kind->parts) { /* curve/surface */
    ck_assert(!kind->curve.begin && !kind->offset && !kind->bezier);
    return;
  }
  ck_sampler(&kind->curve);
  ck_sampler(&kind->beside);
  ck_assert((kind->no_erf != NULL) == !kind->erf);
  ck_assert(!kind->erf || kind->turn);
  ck_assert((kind->offset != NULL) ==
            (kind->offsets_n[0] + kind->offsets_n[1] > 0));
  ck_assert(!kind->bernstein || kind->bezier);
}

/* Frames are of curves in space: of all kinds that there may be. */
PH_TEST_EACH(test_frames, PH_CURVE_N) {
  const struct ph_kind *kind = ph_kinds[_i];
  if (kind->parts) {
    return;
  }
  ck_assert(kind->reference && kind->principal);
  ck_assert(kind->turn || kind->on_sphere);
}

PH_TEST(test_questions) {
  const struct ph_kind *ph = ph_kinds[PH_CURVE_PH];
  const struct ph_kind *sphere = ph_kinds[PH_CURVE_SPHERICAL_NU];
  ck_assert_int_eq(ph_kind_space(ph, 2), PH_PLANE);
  ck_assert_int_eq(ph_kind_space(ph, 3), PH_SPACE);
  ck_assert_int_eq(ph_kind_space(sphere, 3), PH_SPHERE);
  ck_assert_int_eq(ph_kind_space(ph_kinds[PH_CURVE_CONE], 3), PH_SURFACE);
  ck_assert_uint_eq(ph_kind_offsets(ph, 2), 1);
  ck_assert_uint_eq(ph_kind_offsets(ph, 3), PH_OFFSETS_SPATIAL);
  ck_assert_uint_eq(ph_kind_offsets(sphere, 3), 1);
}
