/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The tables of promises and of kinds: a row for each command that solves, and
 * no other; and for each kind. */
#include "unit.h"

#include "check/certify.h"
#include "check/kind.h"
#include "cli/command.h"

PH_TEST(every_command_has_one) {
  size_t solve = 0;
  for (size_t i = 0; i < ph_commands_n; i++) {
    const char *name = ph_commands[i].schema->command;
    const struct ph_promise *promise = ph_promise_of(name);
    if (ph_commands[i].use != PH_USE_VERIFY) {
      solve++;
      ck_assert_ptr_nonnull(promise);
      ck_assert_str_eq(promise->command, name);
      ck_assert(promise->kinds != 0);
      ck_assert(promise->kinds < PH_KIND(N));
      ck_assert(promise->dimension == 2 || promise->dimension == 3);
    } else {
      ck_assert_ptr_null(promise);
    }
  }
  ck_assert_uint_eq(solve, ph_promises_n);
  ck_assert_ptr_null(ph_promise_of(""));
  ck_assert_ptr_null(ph_promise_of("plana"));
  ck_assert_ptr_null(ph_promise_of("planar "));
}

/* What is of another command is refused before any rule looks at it. */
PH_TEST(others_are_refused) {
  double points[18] = {0};
  const struct ph_curve quintic = {.kind = PH_CURVE_PH,
                                   .dimension = 2,
                                   .degree = 5,
                                   .n = 1,
                                   .control_points = points};
  static const struct {
    const char *command, *field;
    enum ph_curve_kind kind;
    size_t dimension, degree, n;
  } rows[] = {{"planer", "command", PH_CURVE_PH, 2, 5, 1},
              {"planar", "curve", PH_CURVE_TC, 2, 5, 1},
              {"planar", "dimension", PH_CURVE_PH, 3, 5, 1},
              {"planar", "degree", PH_CURVE_PH, 2, 3, 1},
              {"planar", "segments", PH_CURVE_PH, 2, 5, 0},
              {"arclength", "curve", PH_CURVE_ATPH, 3, 5, 1},
              {"sphere", "curve", PH_CURVE_PH, 3, 3, 1},
              {"tc", "curve", PH_CURVE_PH, 2, 3, 1},
              {"cone", "strips", PH_CURVE_CONE, 3, 2, 1},
              {"bubble", "patches", PH_CURVE_BUBBLE, 3, 2, 1}};
  for (size_t i = 0; i < COUNT(rows); i++) {
    const struct ph_problem none = {.field = {{.kind = PH_ABSENT}}};
    struct ph_diagnostics diagnostics = {.known = 0};
    struct ph_arena scratch = {0};
    struct ph_curve curve = quintic;
    struct ph_diag diag = {.status = PH_OK};
    curve.kind = rows[i].kind;
    curve.dimension = rows[i].dimension;
    curve.degree = rows[i].degree;
    curve.n = rows[i].n;
    ck_assert_int_eq(ph_certify(rows[i].command, &none, &curve, &scratch,
                                &diagnostics, &diag),
                     PH_E_INTERNAL);
    ck_assert_str_eq(diag.field, rows[i].field);
  }
}

/* A kind that has no row, or none of its functions, would be a crash. */
PH_TEST(every_kind_has_one) {
  for (size_t kind = 0; kind < PH_CURVE_N; kind++) {
    const struct ph_check_kind *row = &ph_check_kinds[kind];
    unsigned made = 0;
    for (size_t i = 0; i < ph_promises_n; i++) {
      made |= ph_promises[i].kinds;
    }
    ck_assert(kind == PH_CURVE_CONE || kind == PH_CURVE_BUBBLE || /* surfaces */
              (row->load && row->jet && row->point && row->local));
    ck_assert(!row->sphere || !row->square);
    ck_assert(made >> kind & 1);
  }
}
