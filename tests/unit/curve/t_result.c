/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Results: names, kinds of diagnostics and which are known, warnings in order.
 */
#include "unit.h"

#include "curve/result.h"

PH_TEST(test_names) {
  ck_assert_str_eq(ph_curve_name(PH_CURVE_PH), "ph");
  ck_assert_str_eq(ph_diagnostic_name(PH_D_ITERATIONS), "iterations");
  ck_assert_str_eq(ph_diagnostic_name(PH_D_LENGTH_ERROR), "length_error");
  ck_assert_str_eq(ph_diagnostic_name(PH_D_F), "F");
  ck_assert_str_eq(ph_diagnostic_name(PH_D_SECOND_ORDER), "second_order");
  for (int i = 0; i < PH_DIAGNOSTIC_N; i++) {
    for (int j = 0; j < i; j++) {
      ck_assert_str_ne(ph_diagnostic_name((enum ph_diagnostic)i),
                       ph_diagnostic_name((enum ph_diagnostic)j));
    }
  }
}

/* What scripts rely on, written down a second time. */
PH_TEST(test_outcomes) {
  ck_assert_int_eq(PH_OUTCOME_N, 3);
  ck_assert_str_eq(ph_outcome_name(PH_OUTCOME_MINIMISER), "minimiser");
  ck_assert_str_eq(ph_outcome_name(PH_OUTCOME_SADDLE), "saddle");
  ck_assert_str_eq(ph_outcome_name(PH_OUTCOME_NO_SOLUTION), "no-convergence");
}

/* A diagnostic is a number, a flag or a word; scripts rely on which. */
PH_TEST(test_kinds) {
  for (int i = 0; i < PH_DIAGNOSTIC_N; i++) {
    const char *type = ph_diagnostic_type((enum ph_diagnostic)i);
    bool flag = i == PH_D_SIMPLE || i == PH_D_AT_BOUND || i == PH_D_SHAPE_OK ||
                i == PH_D_PLANAR || i == PH_D_REGULAR;
    ck_assert_str_eq(type, flag                     ? "flag"
                           : i == PH_D_SECOND_ORDER ? "outcome"
                           : i == PH_D_ROOT         ? "root"
                                                    : "number");
    ck_assert_int_eq(ph_words(type) != NULL,
                     i == PH_D_SECOND_ORDER || i == PH_D_ROOT);
    ck_assert_int_gt((int)strlen(ph_diagnostic_meaning((enum ph_diagnostic)i)),
                     0);
  }
}

/* Each has a bit of its own among those that are known. */
PH_TEST(test_all_known) {
  struct ph_diagnostics d = {0};
  ck_assert_int_le(PH_DIAGNOSTIC_N, 64);
  for (int i = 0; i < PH_DIAGNOSTIC_N; i++) {
    uint64_t before = d.known;
    ph_diagnostics_set(&d, (enum ph_diagnostic)i, i);
    ck_assert(d.known != before && (d.known & before) == before);
  }
  for (int i = 0; i < PH_DIAGNOSTIC_N; i++) {
    ck_abs(d.value[i], i, 0);
  }
}

PH_TEST(test_diagnostics) {
  struct ph_diagnostics d = {0};
  ph_diagnostics_set(&d, PH_D_LENGTH_ERROR, 0.5);
  ph_diagnostics_set(&d, PH_D_ITERATIONS, 3);
  for (int i = 0; i < PH_DIAGNOSTIC_N; i++) {
    int known = i == PH_D_LENGTH_ERROR || i == PH_D_ITERATIONS;
    ck_assert_int_eq((int)(d.known >> i & 1), known);
  }
  ck_abs(d.value[PH_D_LENGTH_ERROR], 0.5, 0);
  ck_abs(d.value[PH_D_ITERATIONS], 3, 0);
}

PH_TEST(test_warnings) {
  struct ph_result result = {0};
  for (size_t i = 0; i < PH_WARNINGS_MAX; i++) {
    size_t segment = i ? i : PH_NO_SEGMENT;
    ph_warn(&result, segment, PH_W_LOOP, "%zu", i);
  }
  ck_assert_uint_eq(result.warnings_n, PH_WARNINGS_MAX);
  ck_assert_uint_eq(result.warnings[0].segment, PH_NO_SEGMENT);
  ck_assert_uint_eq(result.warnings[5].segment, 5);
  ck_assert_str_eq(result.warnings[5].diag.message, "5");
  ck_assert_str_eq(result.warnings[5].diag.field, "");
  ck_assert_int_eq(result.warnings[5].diag.status, PH_W_LOOP);
}
