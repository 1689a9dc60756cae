/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What is said of problems whose points were joined. */
#include "unit.h"

#include "fields_unit.h"

#include "cli/merged.h"
#include "solve/method.h"

static struct ph_merge merge;
static struct ph_diag diag;

static void join(const struct ph_method *method,
                 const struct given given[GIVEN_MAX]) {
  struct ph_problem problem = unit_problem_of(given);
  ck_assert_int_eq(
      ph_merge(&method->schema, &unit_arena, &problem, &merge, &diag), PH_OK);
}

/* What is said of joined data names what was given. */
PH_TEST(test_tell) {
  join(&ph_method_arclength,
       (struct given[GIVEN_MAX]){
           {PH_F_MERGE, NUMBER(1)},
           {PH_F_POINTS, VECTORS(2, 0, 0, 0, 0, 2, 0, 2, 0, 5, 0)},
           {PH_F_LENGTHS, NUMBERS(1, 2, 3, 4)},
           {PH_F_KNOTS, NUMBERS(0, 1, 2, 3, 4)}});
  ph_fail_at(&diag, PH_E_BAD_VALUE, "lengths", 1,
             "fits points[1] and knots[2], segments[1].lengths[1], points");
  ph_merge_tell(&merge, &diag);
  ck_assert_str_eq(diag.field, "lengths[3]");
  ck_assert_str_eq(diag.message, "fits points[2] and knots[4], "
                                 "segments[1].lengths[1], points");
  ph_fail(&diag, PH_E_TOO_FEW_POINTS, "points", "must be 9, found 3");
  ph_merge_tell(&merge, &diag);
  ck_assert_str_eq(diag.message, "must be 9, found 3: merge joined 2 of 5");
}

PH_TEST(test_warning) {
  double v[40] = {0};
  struct given given[GIVEN_MAX] = {
      {PH_F_MERGE, NUMBER(1)},
      {PH_F_POINTS, {.kind = PH_VECTORS, .v = v, .n = 20, .dimension = 2}}};
  struct ph_result result = {.warnings_n = 0};
  v[38] = 3;
  join(&ph_method_planar, given);
  ph_warn(&result, 0, PH_W_LOOP, "points[1] is odd");
  ph_merge_result(&merge, &result);
  ck_assert_uint_eq(result.warnings_n, 2);
  ck_assert_str_eq(result.warnings[0].diag.message, "points[19] is odd");
  ck_assert_int_eq(result.warnings[1].diag.status, PH_W_MERGED_POINTS);
  ck_assert_str_eq(
      result.warnings[1].diag.message,
      "18 of 20 points were joined with neighbours nearer than 1: points[1], "
      "points[2], points[3], points[4], points[5], points[6], points[7], "
      "points[8], ...");
  ck_assert_uint_eq(result.merged_n, 18);
  ck_assert_uint_eq(result.merged[17], 18);
}
