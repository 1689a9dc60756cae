/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Problems of planar splines and their solutions (see planar_unit.h). */
#include "planar_unit.h"
#include "unit.h"

#include "curve/fair/describe.h"
#include "solve/method.h"

enum { DEGREE_MAX = 9 };

struct unit_solution unit_planar_of(const double *v, size_t n, bool closed) {
  struct unit_solution u = {0};
  unit_set_copy(&u, PH_F_POINTS, v, n, 2);
  unit_set_flag(&u.problem, PH_F_CLOSED, closed);
  return u;
}

void unit_planar_rule(struct unit_solution *u, const char *rule) {
  unit_set_word(&u->problem, PH_F_KNOTS, rule);
}

void unit_planar_atph(struct unit_solution *u, const double *alpha, size_t n) {
  unit_set_word(&u->problem, PH_F_BASIS, "atph");
  unit_set_copy(u, PH_F_ALPHA, alpha, n, 1);
}

void unit_planar_knots(struct unit_solution *u, const double *v, size_t n) {
  unit_set_copy(u, PH_F_KNOTS, v, n, 1);
}

void unit_planar_ends(struct unit_solution *u, const double v[4]) {
  unit_set_copy(u, PH_F_END_DERIVATIVES, v, 2, 2);
}

enum ph_status unit_planar_solve(struct unit_solution *u) {
  enum ph_status status = unit_solve(&ph_method_planar, u);
  if (status == PH_OK) {
    status = unit_certify("planar", u);
  }
  if (status == PH_OK) {
    status = ph_describe_planar(&u->result.curve, &u->scratch,
                                &u->result.diagnostics, &u->diag);
  }
  ck_assert_int_eq(u->diag.status, status);
  return status;
}

double unit_planar_size(const struct unit_solution *u) {
  const struct ph_value *points = &u->problem.field[PH_F_POINTS];
  double low[2] = {HUGE_VAL, HUGE_VAL}, high[2] = {-HUGE_VAL, -HUGE_VAL};
  for (size_t i = 0; i < 2 * points->n; i++) {
    low[i % 2] = fmin(low[i % 2], points->v[i]);
    high[i % 2] = fmax(high[i % 2], points->v[i]);
  }
  return hypot(high[0] / 2 - low[0] / 2, high[1] / 2 - low[1] / 2);
}

bool unit_planar_warned(const struct unit_solution *u, enum ph_status status) {
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
  return unit_bezier(ph_curve_points(curve, k), curve->degree, order, t);
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
    const size_t k = i / (a->degree + 1), j = i % (a->degree + 1);
    const double *p = ph_curve_points(a, k) + 2 * j;
    const double *q = ph_curve_points(b, k) + 2 * j;
    apart = unit_larger(apart, hypot(p[0] - q[0], p[1] - q[1]));
  }
  return apart;
}
