/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Problems and their solutions (see problem_unit.h). */
#include "problem_unit.h"
#include "unit.h"

#include "check/certify.h"

void unit_set_word(struct ph_problem *problem, enum ph_field_id id,
                   const char *word) {
  problem->field[id] =
      (struct ph_value){.kind = word ? PH_WORD : PH_ABSENT, .word = word};
}

void unit_set_number(struct ph_problem *problem, enum ph_field_id id,
                     double x) {
  problem->field[id] =
      (struct ph_value){.kind = isnan(x) ? PH_ABSENT : PH_NUMBER, .number = x};
}

void unit_set_flag(struct ph_problem *problem, enum ph_field_id id, bool flag) {
  problem->field[id] = (struct ph_value){.kind = PH_BOOL, .flag = flag};
}

void unit_set_array(struct ph_problem *problem, enum ph_field_id id, double *v,
                    size_t n, size_t dimension) {
  problem->field[id] =
      (struct ph_value){.kind = dimension == 1 ? PH_NUMBERS : PH_VECTORS,
                        .v = v,
                        .n = n,
                        .dimension = dimension};
}

double *unit_numbers(struct unit_solution *s, size_t n) {
  double *v = ph_arena_array(&s->arena, n, sizeof *v);
  ck_assert_ptr_nonnull(v);
  return v;
}

void unit_set_copy(struct unit_solution *s, enum ph_field_id id,
                   const double *v, size_t n, size_t dimension) {
  double *copy = unit_numbers(s, n * dimension);
  if (n > 0) {
    memcpy(copy, v, n * dimension * sizeof *v);
  }
  unit_set_array(&s->problem, id, copy, n, dimension);
}

/* A curve whose joints stand at the end of one segment and at the beginning of
 * the next one, so that tests can move one of these. */
static void put_apart(struct ph_curve *curve, struct ph_arena *arena) {
  const size_t n = (curve->degree + 1) * curve->dimension;
  double *apart;
  if (!curve->joined) {
    return;
  }
  apart = ph_arena_array(arena, curve->n, n * sizeof *apart);
  ck_assert_ptr_nonnull(apart);
  for (size_t k = 0; k < curve->n; k++) {
    memcpy(apart + n * k, ph_curve_points(curve, k), n * sizeof *apart);
  }
  curve->control_points = apart;
  curve->joined = false;
}

void unit_put_apart(struct unit_solution *s) {
  struct ph_result *r = &s->result;
  const double *first = r->curve.control_points;
  put_apart(&r->curve, &s->arena);
  for (size_t i = 0; i < r->solutions_n; i++) {
    struct ph_curve *curve = &r->solutions[i].curve;
    if (curve->control_points == first) {
      curve->control_points = r->curve.control_points;
      curve->joined = r->curve.joined;
    }
    put_apart(curve, &s->arena);
  }
}

enum ph_status unit_solve(const struct ph_method *method,
                          struct unit_solution *s) {
  struct ph_mark before = ph_arena_mark(&s->scratch), after;
  enum ph_status status;
  memset(&s->result, 0, sizeof s->result);
  memset(&s->diag, 0, sizeof s->diag);
  s->refused = false;
  status =
      method->solve(&s->problem, &s->arena, &s->scratch, &s->result, &s->diag);
  after = ph_arena_mark(&s->scratch); /* a first chunk may be kept, empty */
  ck_assert(!before.chunk || before.chunk == after.chunk);
  ck_assert_uint_eq(before.used, after.used);
  ck_assert(status == PH_OK || s->diag.status == status);
  if (status == PH_OK) {
    unit_put_apart(s);
  }
  return status;
}

enum ph_status unit_certify(const char *command, struct unit_solution *s) {
  enum ph_status status =
      ph_certify(command, &s->problem, &s->result.curve, &s->scratch,
                 &s->result.diagnostics, &s->diag);
  s->refused = status != PH_OK;
  return status;
}

void unit_solution_free(struct unit_solution *s) {
  ph_arena_free(&s->arena);
  ph_arena_free(&s->scratch);
  memset(s, 0, sizeof *s);
}

double unit_diagnostic(const struct ph_diagnostics *d,
                       enum ph_diagnostic which) {
  ck_assert_msg(d->known >> which & 1, "no %s", ph_diagnostic_name(which));
  return d->value[which];
}
