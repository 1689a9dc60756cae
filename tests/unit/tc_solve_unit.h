/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A problem of Tschirnhausen cubics with what became of it. */
#ifndef PH_TESTS_TC_SOLVE_UNIT_H
#define PH_TESTS_TC_SOLVE_UNIT_H

#include "cert_tc_unit.h"
#include "planar_unit.h"
#include "unit.h"

#include "solve/method.h"

#include <string.h>

/* {0} is a problem without fields; their arrays are the caller's. */
struct unit_tc_solved {
  struct ph_problem problem;
  struct ph_result result;
  struct ph_diag diag;
  struct ph_arena out, scratch;
};

/* unit_tc_field: the value of a field, to be set. */
static inline struct ph_value *unit_tc_field(struct unit_tc_solved *s,
                                             enum ph_field_id id) {
  return &s->problem.field[id];
}

static inline void unit_tc_flag(struct unit_tc_solved *s, enum ph_field_id id) {
  *unit_tc_field(s, id) = (struct ph_value){.kind = PH_BOOL, .flag = true};
}

/* unit_tc_solve: as the program does; scratch memory must be given back. */
static inline enum ph_status unit_tc_solve(struct unit_tc_solved *s) {
  struct ph_mark before, after;
  enum ph_status status;
  ck_assert_ptr_nonnull(ph_arena_array(&s->scratch, 1, 16));
  before = ph_arena_mark(&s->scratch);
  memset(&s->result, 0, sizeof s->result);
  memset(&s->diag, 0, sizeof s->diag);
  status = ph_method_tc.solve(&s->problem, &s->out, &s->scratch, &s->result,
                              &s->diag);
  after = ph_arena_mark(&s->scratch);
  ck_assert_ptr_eq(before.chunk, after.chunk);
  ck_assert_uint_eq(before.used, after.used);
  return status;
}

static inline void unit_tc_solve_ok(struct unit_tc_solved *s) {
  enum ph_status status = unit_tc_solve(s);
  ck_assert_msg(status == PH_OK, "%s: %s", s->diag.field, s->diag.message);
}

/* unit_tc_refused: a failure, its field, and a part of its message. */
static inline void unit_tc_refused(struct unit_tc_solved *s,
                                   enum ph_status status, const char *field,
                                   const char *part) {
  ck_assert_int_eq(unit_tc_solve(s), status);
  ck_assert_str_eq(s->diag.field, field);
  ck_assert_msg(strstr(s->diag.message, part) != NULL, "%s", s->diag.message);
}

static inline void unit_tc_free(struct unit_tc_solved *s) {
  ph_arena_free(&s->out);
  ph_arena_free(&s->scratch);
}

#endif
