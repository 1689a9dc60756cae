/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The method tc: its schema, images where they are asked for, the warning of
 * loops, and scratch memory. */
#include "tc_unit.h"

static double points[] = {0, 0, 1, 0, 2, 1, 3, 1};

static struct unit_solution spline(void) {
  struct unit_solution s = {.result = {.offsets_n = 0}};
  unit_set_array(&s.problem, PH_F_POINTS, points, 4, 2);
  unit_set_word(&s.problem, PH_F_MODE, "spline");
  return s;
}

/* ---- the schema ---------------------------------------------------------- */

PH_TEST(test_schema) {
  const struct ph_schema *schema = &ph_method_tc.schema;
  bool seen[PH_FIELD_N] = {false};
  ck_assert_str_eq(schema->command, "tc");
  ck_assert_uint_gt(strlen(ph_method_tc.title), 0);
  ck_assert_uint_eq(ph_method_tc.dimension, 2);
  ck_assert_int_eq(ph_method_tc.kind, PH_CURVE_TC);
  for (size_t i = 0; i < schema->fields_n; i++) {
    const struct ph_field *f = &schema->fields[i];
    const char *name = ph_field_name(f->id);
    ck_assert_msg(!seen[f->id], "%s is there twice", name);
    seen[f->id] = true;
    ck_assert_ptr_eq(ph_field_find(schema, name, strlen(name)), f);
    ck_assert_msg(f->help && strlen(f->help) > 0, "%s", name);
    ck_assert_msg(f->help[strlen(f->help) - 1] != '.', "%s", name);
    ck_assert_msg(f->standard && strlen(f->standard) > 0, "%s", name);
    ck_assert_msg(!f->required, "%s", name);
    ck_assert_msg((f->kinds == PH_WORD) == (f->words != NULL), "%s", name);
    ck_assert_msg((f->kinds & PH_VECTORS ? 1u << 2 : 0) == f->dimensions, "%s",
                  name);
  }
  ck_assert_uint_eq(schema->fields_n, 21);
}

/* ---- images -------------------------------------------------------------- */

/* Pieces for all of [0,1] of every segment, in order. */
static void check_images(const struct ph_curve *curve) {
  size_t segment = 0;
  double at = 0;
  for (size_t i = 0; i < curve->blaschke.n; i++) {
    const struct ph_blaschke *b = &curve->blaschke.v[i];
    ck_assert_uint_eq(b->segment, segment);
    ck_abs(b->interval[0], at, 0);
    for (size_t k = 0; k < 6; k++) {
      ck_assert_double_gt(b->weights[k], 0);
    }
    at = b->interval[1];
    if (at >= 1) {
      segment++;
      at = 0;
    }
  }
  ck_assert_uint_eq(segment, curve->n);
}

PH_TEST(test_images) {
  double tangents[] = {1, -1, 1, 1};
  struct unit_solution s = spline();
  unit_tc_solve_ok(&s);
  ck_assert_uint_eq(s.result.curve.blaschke.n, 0);
  ck_assert_ptr_null(s.result.curve.blaschke.v);
  *unit_tc_field(&s, PH_F_BLASCHKE) = (struct ph_value){.kind = PH_BOOL};
  unit_tc_solve_ok(&s);
  ck_assert_uint_eq(s.result.curve.blaschke.n, 0);
  unit_tc_flag(&s, PH_F_BLASCHKE);
  unit_tc_solve_ok(&s);
  check_images(&s.result.curve);
  /* of all solutions, of which one has a loop */
  unit_set_array(&s.problem, PH_F_POINTS, points, 2, 2);
  unit_set_array(&s.problem, PH_F_TANGENTS, tangents, 2, 2);
  unit_set_word(&s.problem, PH_F_MODE, "g1");
  unit_set_word(&s.problem, PH_F_SOLUTIONS, "all");
  unit_tc_solve_ok(&s);
  ck_assert_uint_eq(s.result.solutions_n, 2);
  check_images(&s.result.curve);
  check_images(&s.result.solutions[0].curve);
  check_images(&s.result.solutions[1].curve);
  ck_assert_uint_gt(s.result.solutions[1].curve.blaschke.n, 1);
  unit_solution_free(&s);
}

/* ---- the warning --------------------------------------------------------- */

static void check_warning(const struct unit_solution *s, size_t segment,
                          const char *message) {
  const struct ph_warning *w = &s->result.warnings[0];
  ck_assert_uint_eq(s->result.warnings_n, 1);
  ck_assert_int_eq(w->diag.status, PH_W_LOOP);
  ck_assert_uint_eq(w->segment, segment);
  ck_assert_str_eq(w->diag.message, message);
}

/* Angles of 1.3 and 0.1 leave one cubic that is regular and has a loop; pairs
 * have none. */
PH_TEST(test_loop) {
  double a = 1.3, b = 0.1, v[] = {0, 0, 1, 0, 2, 0};
  double one[] = {cos(a), sin(a), cos(b), sin(b)};
  double two[] = {cos(a), sin(a), cos(b), sin(b), cos(a), sin(a)};
  struct unit_solution s = spline();
  unit_tc_solve_ok(&s);
  ck_assert_uint_eq(s.result.warnings_n, 0);
  unit_set_word(&s.problem, PH_F_MODE, "g1");
  unit_set_array(&s.problem, PH_F_POINTS, v, 2, 2);
  unit_set_array(&s.problem, PH_F_TANGENTS, one, 2, 2);
  unit_tc_solve_ok(&s);
  check_warning(&s, 0,
                "the curve of interval 0 has a loop or crosses itself (such "
                "intervals: 1)");
  unit_set_array(&s.problem, PH_F_POINTS, v, 3, 2);
  unit_set_array(&s.problem, PH_F_TANGENTS, two, 3, 2);
  unit_tc_solve_ok(&s);
  check_warning(&s, 0,
                "the curve of interval 0 has a loop or crosses itself (such "
                "intervals: 2)");
  unit_set_word(&s.problem, PH_F_MODE, "g1-pair");
  unit_tc_solve_ok(&s);
  ck_assert_uint_eq(s.result.warnings_n, 0);
  unit_solution_free(&s);
}

/* The segment is the first of the interval: two are before it. */
PH_TEST(test_loop_later) {
  double v[] = {0, 0, 1, 0, 2, 0};
  double d[] = {.5,           0,           3 * cos(-1.5), 3 * sin(-1.5),
                3 * cos(0.1), 3 * sin(0.1)};
  const char *const choices[] = {"best", "all"};
  for (size_t i = 0; i < 2; i++) {
    struct unit_solution s = spline();
    unit_set_word(&s.problem, PH_F_MODE, "c1");
    unit_set_array(&s.problem, PH_F_POINTS, v, 3, 2);
    unit_set_array(&s.problem, PH_F_DERIVATIVES, d, 3, 2);
    unit_set_word(&s.problem, PH_F_SOLUTIONS, choices[i]);
    unit_tc_solve_ok(&s);
    check_warning(&s, 2,
                  "the curve of interval 1 has a loop or crosses itself (such "
                  "intervals: 1)");
    unit_solution_free(&s);
  }
}

/* ---- ways ---------------------------------------------------------------- */

/* Every failure gives scratch memory back, which unit_tc_solve checks. */
PH_TEST(test_failures) {
  double tangents[] = {1, 1, 1, 1};
  struct unit_solution s = spline(), none = {.result = {.offsets_n = 0}};
  unit_tc_refused(&none, PH_E_MISSING_FIELD, "points",
                  "or curve or path must be given");
  unit_set_number(&s.problem, PH_F_TOLERANCE, 1);
  unit_tc_refused(&s, PH_E_BAD_VALUE, "tolerance",
                  "is for the mode approximate");
  unit_set_word(&s.problem, PH_F_MODE, "approximate");
  unit_set_number(&s.problem, PH_F_TOLERANCE, 1e-300);
  unit_tc_refused(&s, PH_E_NO_CONVERGENCE, "tolerance", "is no larger than");
  *unit_tc_field(&s, PH_F_TOLERANCE) = (struct ph_value){.kind = PH_ABSENT};
  unit_set_array(&s.problem, PH_F_POINTS, points, 2, 2);
  unit_set_array(&s.problem, PH_F_TANGENTS, tangents, 2, 2);
  unit_set_word(&s.problem, PH_F_MODE, "g1");
  unit_tc_refused(&s, PH_E_INFEASIBLE, "segments[0]",
                  "no Tschirnhausen cubic has angles");
  unit_solution_free(&s);
  unit_solution_free(&none);
}

/* One cubic, two, or as many as an approximation takes; intervals of each. */
PH_TEST(test_modes) {
  double v[] = {0, 0, 1, 0}, t[] = {1, -1, 1, 1};
  static const struct {
    const char *mode;
    size_t cubics;
  } modes[] = {{"g1", 1}, {"g1-auto", 1}, {"g1-pair", 2}};
  struct unit_solution s = spline();
  unit_tc_solve_ok(&s);
  ck_assert_uint_eq(s.result.intervals_n, 3);
  ck_assert_uint_eq(s.result.curve.n, 6);
  ck_assert_uint_eq(s.result.solutions_n, 0);
  unit_set_array(&s.problem, PH_F_POINTS, v, 2, 2);
  unit_set_array(&s.problem, PH_F_TANGENTS, t, 2, 2);
  for (size_t i = 0; i < COUNT(modes); i++) {
    unit_set_word(&s.problem, PH_F_MODE, modes[i].mode);
    unit_tc_solve_ok(&s);
    ck_assert_uint_eq(s.result.intervals_n, 1);
    ck_assert_uint_eq(s.result.curve.n, modes[i].cubics);
  }
  unit_solution_free(&s);
}
