/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The curve of a result, from splines that are solved. */
#include "sphere_unit.h"
#include "unit.h"

#include "solve/sphere/sphere.h"

enum { N = 6 };

static const double center[3] = {-3, 0.5, 20}, radius = 7;

static double knots[N + 1];

static void set_up(struct unit_raise *t, bool closed) {
  const struct unit_raise_kind kind = {closed, PH_SPHERE_NATURAL,
                                       &ph_sphere_exact, 0.01, false};
  struct unit_random r = {781};
  ph_vec3 p[N];
  unit_sphere_path(&r, N, 0.2, 0.9, p);
  unit_raise_of(t, N, p, &kind);
  for (size_t k = 0; k <= t->u.data.m; k++) {
    knots[k] = 10 + 0.25 * (double)k;
  }
  for (size_t i = 0; i < N; i++) {
    t->u.spline.nu[i] = 0.5 * (double)i;
  }
  ck_assert(ph_sphere_solve(&t->u.spline, &t->u.work));
  t->u.data.knots = knots;
  t->u.data.radius = radius;
  memcpy(t->u.data.center, center, sizeof center);
}

/* The length of segment k on the unit sphere, by the trapezoids of a fine
 * polygon on it and of one of half as many sides, extrapolated. */
static double length_of(const struct ph_spherical *s) {
  enum { SIDES = 2048 };
  double length[2] = {0, 0};
  for (int half = 0; half < 2; half++) {
    int sides = SIDES >> half;
    ph_vec3 before = s->p[0];
    for (int j = 1; j <= sides; j++) {
      ph_vec3 now[4];
      ph_spherical_jet(s, (double)j / sides, now);
      length[half] += ph_vec3_abs(ph_vec3_sub(now[0], before));
      before = now[0];
    }
  }
  return (4 * length[0] - length[1]) / 3;
}

static void ck_curve(struct unit_raise *t, const struct ph_curve *curve) {
  double sum = 0;
  for (size_t k = 0; k < curve->n; k++) {
    struct ph_spherical s = unit_sphere_segment(&t->u, k);
    for (size_t j = 0; j < 4; j++) {
      const double *p = curve->control_points + (4 * k + j) * 3;
      ck_abs(p[0], center[0] + radius * s.p[j].x, 1e-14);
      ck_abs(p[1], center[1] + radius * s.p[j].y, 1e-14);
      ck_abs(p[2], center[2] + radius * s.p[j].z, 1e-14);
    }
    ck_rel(curve->lengths[k], radius * length_of(&s), 1e-10);
    sum += curve->lengths[k];
  }
  ck_rel(curve->length, sum, 1e-15);
  for (size_t k = 0; k <= curve->n; k++) {
    ck_rel(curve->knots[k], knots[k], 0);
  }
  for (size_t i = 0; i < N; i++) {
    ck_rel(curve->sphere.tensions[i], 0.5 * (double)i, 0);
    ck_assert_int_eq(curve->sphere.indicators[i], t->shape.q[i]);
  }
}

PH_TEST_EACH(test_curve, 2) {
  struct ph_diag diag = {0};
  struct ph_curve curve;
  struct unit_raise t;
  bool closed = _i == 1;
  set_up(&t, closed);
  ck_assert_int_eq(
      ph_sphere_curve(&t.u.spline, &t.shape, NULL, &unit_arena, &curve, &diag),
      PH_OK);
  ck_assert_int_eq(curve.kind, PH_CURVE_SPHERICAL_NU);
  ck_assert_int_eq(curve.closed, closed);
  ck_assert_uint_eq(curve.n, closed ? N : N - 1);
  ck_assert_uint_eq(curve.degree, 3);
  ck_assert_uint_eq(curve.dimension, 3);
  ck_rel(curve.sphere.radius, radius, 0);
  for (int c = 0; c < 3; c++) {
    ck_rel(curve.sphere.center[c], center[c], 0);
  }
  ck_curve(&t, &curve);
  unit_raise_free(&t);
}

/* A segment that is not finite has no length: an error that names it. */
PH_TEST(test_no_length) {
  struct ph_diag diag = {0};
  struct ph_curve curve;
  struct unit_raise t;
  set_up(&t, false);
  t.u.spline.l[3].y = (double)NAN;
  ck_assert_int_eq(
      ph_sphere_curve(&t.u.spline, &t.shape, NULL, &unit_arena, &curve, &diag),
      PH_E_NO_CONVERGENCE);
  ck_assert_int_eq(diag.status, PH_E_NO_CONVERGENCE);
  ck_assert_ptr_nonnull(strstr(diag.message, "has no length"));
  ck_assert_str_eq(diag.field, "segments[3]");
  unit_raise_free(&t);
}
