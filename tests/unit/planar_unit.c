/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Problems of planar splines and their solutions (see planar_unit.h). */
#include "planar_unit.h"
#include "random_unit.h"
#include "unit.h"

#include "check/certify.h"
#include "curve/fair/describe.h"
#include "solve/method.h"

#include <string.h>

enum { DEGREE_MAX = 9 };

static double *copy_of(struct unit_planar *u, const double *v, size_t n) {
  double *copy = ph_arena_array(&u->arena, n, sizeof *copy);
  ck_assert_ptr_nonnull(copy);
  if (n) {
    memcpy(copy, v, n * sizeof *copy);
  }
  return copy;
}

struct unit_planar unit_planar_of(const double *v, size_t n, bool closed) {
  struct unit_planar u = {0};
  struct ph_value *points = &u.problem.field[PH_F_POINTS];
  points->kind = PH_VECTORS;
  points->dimension = 2;
  points->n = n;
  points->v = copy_of(&u, v, 2 * n);
  u.problem.field[PH_F_CLOSED].kind = PH_BOOL;
  u.problem.field[PH_F_CLOSED].flag = closed;
  return u;
}

void unit_planar_word(struct unit_planar *u, size_t field, const char *word) {
  u->problem.field[field] = (struct ph_value){.kind = PH_WORD, .word = word};
}

void unit_planar_rule(struct unit_planar *u, const char *rule) {
  unit_planar_word(u, PH_F_KNOTS, rule);
}

void unit_planar_atph(struct unit_planar *u, const double *alpha, size_t n) {
  unit_planar_word(u, PH_F_BASIS, "atph");
  u->problem.field[PH_F_ALPHA] = (struct ph_value){
      .kind = PH_NUMBERS, .v = copy_of(u, alpha, n), .n = n, .dimension = 1};
}

void unit_planar_knots(struct unit_planar *u, const double *v, size_t n) {
  u->problem.field[PH_F_KNOTS] = (struct ph_value){
      .kind = PH_NUMBERS, .v = copy_of(u, v, n), .n = n, .dimension = 1};
}

void unit_planar_ends(struct unit_planar *u, const double v[4]) {
  u->problem.field[PH_F_END_DERIVATIVES] = (struct ph_value){
      .kind = PH_VECTORS, .v = copy_of(u, v, 4), .n = 2, .dimension = 2};
}

enum ph_status unit_planar_solve(struct unit_planar *u) {
  struct ph_mark before = ph_arena_mark(&u->scratch), after;
  enum ph_status status;
  memset(&u->result, 0, sizeof u->result);
  memset(&u->diag, 0, sizeof u->diag);
  status = ph_method_planar.solve(&u->problem, &u->arena, &u->scratch,
                                  &u->result, &u->diag);
  after = ph_arena_mark(&u->scratch); /* a first chunk may be kept, empty */
  ck_assert(!before.chunk || before.chunk == after.chunk);
  ck_assert_uint_eq(before.used, after.used);
  if (status == PH_OK) {
    status = ph_certify("planar", &u->problem, &u->result.curve, &u->scratch,
                        &u->result.diagnostics, &u->diag);
  }
  if (status == PH_OK) {
    status = ph_describe_planar(&u->result.curve, &u->scratch,
                                &u->result.diagnostics, &u->diag);
  }
  ck_assert_int_eq(u->diag.status, status);
  return status;
}

void unit_planar_free(struct unit_planar *u) {
  ph_arena_free(&u->arena);
  ph_arena_free(&u->scratch);
}

double unit_planar_size(const struct unit_planar *u) {
  const struct ph_value *points = &u->problem.field[PH_F_POINTS];
  double low[2] = {HUGE_VAL, HUGE_VAL}, high[2] = {-HUGE_VAL, -HUGE_VAL};
  for (size_t i = 0; i < 2 * points->n; i++) {
    low[i % 2] = fmin(low[i % 2], points->v[i]);
    high[i % 2] = fmax(high[i % 2], points->v[i]);
  }
  return hypot(high[0] / 2 - low[0] / 2, high[1] / 2 - low[1] / 2);
}

bool unit_planar_warned(const struct unit_planar *u, enum ph_status status) {
  for (size_t i = 0; i < u->result.warnings_n; i++) {
    if (u->result.warnings[i].diag.status == status) {
      return true;
    }
  }
  return false;
}

ph_cplx unit_bezier(const double *p, size_t degree, size_t order, double t) {
  const long double u = (long double)t;
  long double x[DEGREE_MAX + 1], y[DEGREE_MAX + 1];
  ck_assert_uint_le(degree, DEGREE_MAX);
  for (size_t i = 0; i <= degree; i++) {
    x[i] = (long double)p[2 * i];
    y[i] = (long double)p[2 * i + 1];
  }
  for (; order > 0; order--, degree--) {
    for (size_t i = 0; i < degree; i++) {
      x[i] = (long double)degree * (x[i + 1] - x[i]);
      y[i] = (long double)degree * (y[i + 1] - y[i]);
    }
  }
  for (; degree > 0; degree--) {
    for (size_t i = 0; i < degree; i++) {
      x[i] = (1 - u) * x[i] + u * x[i + 1];
      y[i] = (1 - u) * y[i] + u * y[i + 1];
    }
  }
  return ph_cplx_of((double)x[0], (double)y[0]);
}

ph_cplx unit_curve(const struct ph_curve *curve, size_t k, size_t order,
                   double t) {
  size_t stride = 2 * (curve->degree + 1);
  return unit_bezier(curve->control_points + stride * k, curve->degree, order,
                     t);
}

ph_cplx unit_preimage(const struct ph_curve *curve, size_t k, size_t order,
                      double t) {
  size_t n = curve->preimage.n;
  return unit_bezier(curve->preimage.v + 2 * n * k, n - 1, order, t);
}

double unit_curves_apart(const struct ph_curve *a, const struct ph_curve *b) {
  double apart = 0;
  ck_assert_uint_eq(a->n, b->n);
  ck_assert_uint_eq(a->degree, b->degree);
  for (size_t i = 0; i < (a->degree + 1) * a->n; i++) {
    const double *p = a->control_points + 2 * i, *q = b->control_points + 2 * i;
    apart = unit_larger(apart, hypot(p[0] - q[0], p[1] - q[1]));
  }
  return apart;
}
