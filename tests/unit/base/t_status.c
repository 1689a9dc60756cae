/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The list of outcomes: codes are stable names, classes exit statuses. */
#include "unit.h"

#include "base/status.h"

/* What scripts rely on, written down a second time. */
static const struct {
  enum ph_status status;
  const char *code;
  int exit_status;
} expected[] = {
    {PH_OK, "ok", 0},
    {PH_E_SYNTAX, "syntax", 1},
    {PH_E_UNKNOWN_FIELD, "unknown-field", 1},
    {PH_E_MISSING_FIELD, "missing-field", 1},
    {PH_E_BAD_TYPE, "bad-type", 1},
    {PH_E_BAD_VALUE, "bad-value", 1},
    {PH_E_BAD_SHAPE, "bad-shape", 1},
    {PH_E_NOT_FINITE, "not-finite", 1},
    {PH_E_TOO_FEW_POINTS, "too-few-points", 1},
    {PH_E_COINCIDENT_POINTS, "coincident-points", 1},
    {PH_E_ZERO_TANGENT, "zero-tangent", 1},
    {PH_E_ANTIPODAL_POINTS, "antipodal-points", 1},
    {PH_E_NOT_ON_SPHERE, "not-on-sphere", 1},
    {PH_E_INFEASIBLE, "infeasible", 1},
    {PH_E_NO_CONVERGENCE, "no-convergence", 1},
    {PH_E_TOO_LARGE, "too-large", 1},
    {PH_E_LIMIT, "limit", 1},
    {PH_E_NOT_VERIFIED, "not-verified", 1},
    {PH_E_USAGE, "usage", 2},
    {PH_E_INPUT, "input", 3},
    {PH_E_OUTPUT, "output", 4},
    {PH_E_NO_MEMORY, "out-of-memory", 5},
    {PH_E_INTERNAL, "internal", 5},
    {PH_W_REVERSAL, "reversal", 1},
    {PH_W_LOOP, "loop", 1},
    {PH_W_OFFSET_CUSP, "offset-cusp", 1},
    {PH_W_OFFSET_GAP, "offset-gap", 1},
    {PH_W_OFFSET_EMPTY, "offset-empty", 1},
    {PH_W_OFFSET_TOUCH, "offset-touch", 1},
    {PH_W_SELF_CROSSING, "self-crossing", 1},
    {PH_W_LARGE_ALPHA, "large-alpha", 1},
    {PH_W_AMBIGUOUS, "ambiguous", 1},
    {PH_W_CUT_SHORT, "cut-short", 1},
    {PH_W_SHAPE_UNSATISFIABLE, "shape-unsatisfiable", 1},
    {PH_W_INFINITE_FUNCTIONAL, "infinite-functional", 1},
    {PH_W_WIGGLE, "wiggle", 1},
    {PH_W_INCONSISTENT_LENGTHS, "inconsistent-lengths", 1},
    {PH_W_SADDLE, "saddle", 1},
    {PH_W_LEAVES_PLANE, "leaves-plane", 1},
    {PH_W_NATURAL_UNKNOWN, "natural-unknown", 1},
    {PH_W_SHARP_CORNERS, "sharp-corners", 1},
    {PH_W_MOVED_POINTS, "moved-points", 1},
    {PH_W_DEGREES, "degrees", 1},
    {PH_W_MERGED_POINTS, "merged-points", 1},
    {PH_W_FAR_CONTACT, "far-contact", 1},
    {PH_W_VERTEX_INSIDE, "vertex-inside", 1},
    {PH_W_SIGN_CHANGE, "sign-change", 1},
    {PH_W_LARGE_ARC, "large-arc", 1},
    {PH_W_OUTSIDE, "outside", 1},
    {PH_W_G1_JOINTS, "g1-joints", 1},
    {PH_W_AUXILIARY_POINTS, "auxiliary-points", 1},
    {PH_W_NEAR_CUSP, "near-cusp", 1},
    {PH_W_SPLINE_PAIRS, "spline-pairs", 1},
    {PH_W_UNEVEN_CHORDS, "uneven-chords", 1},
    {PH_W_FOLDED, "folded", 1},
};

PH_TEST(test_codes) {
  ck_assert_uint_eq(COUNT(expected), PH_STATUS_N);
  for (size_t i = 0; i < COUNT(expected); i++) {
    enum ph_status status = expected[i].status;
    ck_assert_str_eq(ph_status_code(status), expected[i].code);
    ck_assert_int_eq((int)ph_status_class(status), expected[i].exit_status);
  }
}

/* A code is one word, lower case and digits, no other's; a meaning is a line.
 */
PH_TEST(test_form) {
  const char *letters = "abcdefghijklmnopqrstuvwxyz0123456789-";
  for (int i = 0; i < PH_STATUS_N; i++) {
    const char *code = ph_status_code((enum ph_status)i);
    const char *meaning = ph_status_meaning((enum ph_status)i);
    ck_assert_uint_ge(strlen(code), 2);
    ck_assert_uint_eq(strspn(code, letters), strlen(code));
    ck_assert(meaning[0] >= 'a' && meaning[0] <= 'z');
    ck_assert_ptr_null(strchr(meaning, '\n'));
    ck_assert_int_ne(meaning[strlen(meaning) - 1], '.');
    for (int j = 0; j < i; j++) {
      ck_assert_str_ne(code, ph_status_code((enum ph_status)j));
    }
  }
}

/* A warning fails its record under --strict only, and has a code of that
 * class. */
PH_TEST(test_warnings) {
  ck_assert(!ph_status_is_warning(PH_OK));
  for (int i = 0; i < PH_STATUS_N; i++) {
    enum ph_status status = (enum ph_status)i;
    bool warning = i >= PH_W_REVERSAL;
    ck_assert_int_eq(ph_status_is_warning(status), warning);
    ck_assert(!warning || ph_status_class(status) == PH_CLASS_RECORD);
  }
}
