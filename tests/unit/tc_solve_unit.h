/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A problem of Tschirnhausen cubics with what became of it. */
#ifndef PH_TESTS_TC_SOLVE_UNIT_H
#define PH_TESTS_TC_SOLVE_UNIT_H

#include "cert_tc_unit.h"
#include "planar_unit.h"
#include "unit.h"

#include "solve/method.h"

/* unit_tc_field: the value of a field, to be set. */
static inline struct ph_value *unit_tc_field(struct unit_solution *s,
                                             enum ph_field_id id) {
  return &s->problem.field[id];
}

static inline void unit_tc_flag(struct unit_solution *s, enum ph_field_id id) {
  unit_set_flag(&s->problem, id, true);
}

static inline enum ph_status unit_tc_solve(struct unit_solution *s) {
  return unit_solve(&ph_method_tc, s);
}

static inline void unit_tc_solve_ok(struct unit_solution *s) {
  enum ph_status status = unit_tc_solve(s);
  ck_assert_msg(status == PH_OK, "%s: %s", s->diag.field, s->diag.message);
}

/* unit_tc_refused: a failure, its field, and a part of its message. */
static inline void unit_tc_refused(struct unit_solution *s,
                                   enum ph_status status, const char *field,
                                   const char *part) {
  ck_assert_int_eq(unit_tc_solve(s), status);
  ck_assert_str_eq(s->diag.field, field);
  ck_assert_msg(strstr(s->diag.message, part) != NULL, "%s", s->diag.message);
}

#endif
