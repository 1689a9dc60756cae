/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Cusps of offsets: none is missed and none is counted twice.  This test
 * includes the source, for the form whose roots they are.
 */
#include "curve/offset/cusp.c" /* NOLINT */

#include "kernel/bern.h"
#include "unit.h"
#include "curve_unit.h"
#include "segment_unit.h"
#include "tc_curve_unit.h"

enum { SEGMENTS = 200 };

static struct ph_cusps cusps_of(const struct ph_curve *curve, double distance,
                                enum ph_normal normal) {
  struct ph_cusps cusps;
  struct ph_diag diag;
  ck_assert_int_eq(
      ph_cusps_of(curve, distance, normal, &unit_arena, &cusps, &diag), PH_OK);
  ck_assert((cusps.at != NULL) == (cusps.n > 0));
  return cusps;
}

/* Places that cusps should be at, as segment + u, in order. */
struct wanted {
  size_t n;
  double at[64];
};

static void want(struct wanted *wanted, double at) {
  ck_assert_uint_lt(wanted->n, sizeof wanted->at / sizeof wanted->at[0]);
  wanted->at[wanted->n++] = at;
}

/* The cusps are those, and t goes with u. */
static void ck_cusps(const struct ph_curve *curve, const struct ph_cusps *cusps,
                     const struct wanted *wanted, double tol) {
  ck_assert_uint_eq(cusps->n, wanted->n);
  for (size_t i = 0; i < cusps->n; i++) {
    const struct ph_place *at = &cusps->at[i];
    ck_assert_uint_lt(at->segment, curve->n);
    ck_assert(at->u >= 0 && at->u <= 1);
    ck_abs((double)at->segment + at->u, wanted->at[i], tol);
    ck_abs(at->t,
           curve->preimage.alpha ? at->u * curve->preimage.alpha[at->segment]
                                 : at->u,
           0);
  }
}

/* The value of a form at u, and the size of its terms; not at unit scale. */
static double value_of(const struct ph_seg3 *seg, const struct form *form,
                       double u, double *size) {
  double s[2], basis[DEGREE + 1], value = 0, scale;
  ph_atph_basis(&seg->space, u, s);
  scale = ldexp(pow(s[0] + s[1], DEGREE), 4 * exponent_of(seg->a));
  ph_bern_basis(DEGREE, s[1] / (s[0] + s[1]), basis);
  *size = 0;
  for (size_t k = 0; k <= DEGREE; k++) {
    double term = scale * basis[k] * form->b[k];
    value += term;
    *size += fabs(term);
  }
  return value;
}

/* The form is |w|^4 (1 - d kappa). */
PH_TEST(test_form) {
  struct unit_random r = unit_random_of(510);
  for (size_t n = 0; n < SEGMENTS; n++) {
    struct ph_seg2 seg = unit_seg2_random(&r);
    double d = unit_random_in(&r, -2, 2);
    struct unit_segments s;
    struct ph_seg3 in_space;
    struct form form;
    unit_seg2_curve(&seg, 1, &s);
    in_space = ph_seg3_of(&s.curve, 0);
    form = form_of(&in_space, d, PH_E2);
    for (size_t i = 0; i <= 20; i++) {
      double u = (double)i / 20, size;
      struct ph_curvature bending = ph_seg2_curvature(&seg, u);
      double speed2 = bending.speed * bending.speed;
      double value = value_of(&in_space, &form, u, &size);
      size += speed2 * (1 + fabs(d) * sqrt(bending.terms[0]));
      ck_abs(value, speed2 * (1 - d * bending.curvature), 1e-13 * size);
    }
  }
}

/* As many as 1 - d kappa has changes of sign at many points, where it is not
 * nearly zero without one. */
PH_TEST(test_count) {
  enum { STEPS = 4000 };
  struct unit_random r = unit_random_of(511);
  size_t some = 0;
  for (size_t n = 0; n < SEGMENTS; n++) {
    struct ph_seg2 seg = unit_seg2_random(&r);
    double d = unit_random_in(&r, -2, 2), before = 0;
    struct unit_segments s;
    struct ph_cusps cusps;
    struct wanted wanted = {.n = 0};
    for (size_t i = 0; i <= STEPS; i++) {
      double at = 1 - d * ph_seg2_curvature(&seg, (double)i / STEPS).curvature;
      if (i && (at > 0) != (before > 0)) {
        want(&wanted, ((double)i - 0.5) / STEPS);
      }
      before = at;
    }
    unit_seg2_curve(&seg, 1, &s);
    cusps = cusps_of(&s.curve, d, PH_E2);
    ck_cusps(&s.curve, &cusps, &wanted, 0.51 / STEPS);
    for (size_t i = 0; i < cusps.n; i++) {
      struct ph_curvature there = ph_seg2_curvature(&seg, cusps.at[i].u);
      ck_abs(d * there.curvature, 1, 1e-12 * (1 + fabs(d * there.rate)));
    }
    some += cusps.n > 0;
  }
  ck_assert_uint_ge(some, SEGMENTS / 5);
}

/* w = 1 + p t has kappa = 2 Im p / |w|^4 by t; that is 2 Im p at t = 0, and in
 * [-1,1] nowhere else.  All of these numbers are exact. */
static struct ph_seg2 linear(double from, double to) {
  const ph_cplx p = {0.25, 0.5}, one = {1, 0};
  ph_cplx w[3];
  w[0] = ph_cplx_add(one, ph_cplx_scale(from, p));
  w[1] = ph_cplx_add(one, ph_cplx_scale((from + to) / 2, p));
  w[2] = ph_cplx_add(one, ph_cplx_scale(to, p));
  return unit_seg2(0, w);
}

PH_TEST(test_at_knot) {
  struct ph_seg2 seg[2] = {linear(-1, 0), linear(0, 1)};
  struct unit_segments s;
  struct ph_cusps cusps;
  unit_seg2_curve(seg, 2, &s);
  cusps = cusps_of(&s.curve, 1, PH_E2);
  ck_assert_uint_eq(cusps.n, 1);
  ck_abs((double)cusps.at[0].segment + cusps.at[0].u, 1, 1e-12);
  ck_assert_uint_eq(cusps_of(&s.curve, -1, PH_E2).n, 0);
  ck_assert_uint_eq(cusps_of(&s.curve, 0, PH_E2).n, 0);
}

PH_TEST(test_at_half) {
  struct ph_seg2 seg = linear(-1, 1);
  struct unit_segments s;
  struct ph_cusps cusps;
  unit_seg2_curve(&seg, 1, &s);
  cusps = cusps_of(&s.curve, 0.5, PH_E2); /* u goes half as fast as t */
  ck_assert_uint_eq(cusps.n, 1);
  ck_abs(cusps.at[0].u, 0.5, 1e-12);
}

/* With one change of sign within, there is another at the joint of a closed
 * curve: the last one, on the first segment. */
PH_TEST(test_closed) {
  struct ph_seg2 seg[2] = {linear(-1, -0.25), linear(-0.25, 0.5)};
  struct wanted wanted = {.n = 2, .at = {1 + 1.0 / 3, 0}};
  struct unit_segments s;
  struct ph_cusps cusps;
  unit_seg2_curve(seg, 2, &s);
  cusps = cusps_of(&s.curve, 4.0 / 3, PH_E2); /* u goes 4/3 as fast as t */
  ck_assert_uint_eq(cusps.n, 1);
  s.curve.closed = true;
  cusps = cusps_of(&s.curve, 4.0 / 3, PH_E2);
  ck_cusps(&s.curve, &cusps, &wanted, 1e-12);
}

/* ---- in space ---- */

/* sigma (r' + d e') . e1, from the preimage by products. */
static double along(const struct ph_seg3 *seg, double u, double d,
                    enum ph_normal normal) {
  const ph_quat axis =
      normal == PH_E2 ? ph_quat_of(0, 0, 1, 0) : ph_quat_of(0, 0, 0, 1);
  ph_quat a[2], n1;
  double speed;
  ph_seg3_jet(seg, u, a, 2);
  speed = ph_quat_dot(a[0], a[0]);
  n1 = ph_quat_add(ph_quat_mul(ph_quat_mul(a[1], axis), ph_quat_conj(a[0])),
                   ph_quat_mul(ph_quat_mul(a[0], axis), ph_quat_conj(a[1])));
  return speed * speed +
         d * ph_vec3_dot(ph_quat_vector(n1), ph_quat_i(a[0], a[0])) / speed;
}

PH_TEST(test_form_in_space) {
  struct unit_random r = unit_random_of(512);
  struct unit_curve3 c;
  for (size_t n = 0; n < SEGMENTS; n++) {
    enum ph_normal normal = n % 2 ? PH_E2 : PH_E3;
    double d = unit_random_in(&r, -2, 2), scale;
    struct ph_seg3 seg;
    struct form form;
    unit_curve3_random(&c, 1, n % 3 != 0, 2, &r);
    seg = ph_seg3_of(&c.curve, 0);
    form = form_of(&seg, d, normal);
    scale = ldexp(1 + fabs(d), 4 * exponent_of(seg.a));
    for (size_t i = 0; i <= 20; i++) {
      double u = (double)i / 20, size;
      double value = value_of(&seg, &form, u, &size);
      ck_abs(value, along(&seg, u, d, normal), 1e-13 * (size + scale));
    }
  }
}

/* As many as the speed along the curve has changes of sign at many points; also
 * at knots, where the curvature jumps. */
PH_TEST(test_count_in_space) {
  enum { STEPS = 2000, CURVES = 100 };
  struct unit_random r = unit_random_of(513);
  struct unit_curve3 c;
  size_t some = 0;
  for (int n = 0; n < unit_count(CURVES); n++) {
    enum ph_normal normal = n % 2 ? PH_E2 : PH_E3;
    double d = unit_random_in(&r, -2, 2), before = 0;
    struct ph_cusps cusps;
    struct wanted wanted = {.n = 0};
    unit_curve3_random(&c, 2, n % 3 != 0, 1.5, &r);
    for (size_t i = 0; i < 2 * (STEPS + 1); i++) {
      size_t k = i / (STEPS + 1), step = i % (STEPS + 1);
      struct ph_seg3 seg = ph_seg3_of(&c.curve, k);
      double at = along(&seg, (double)step / STEPS, d, normal);
      if (i && (at > 0) != (before > 0)) {
        want(&wanted, (double)k + ((double)step - 0.5) / STEPS);
      }
      before = at;
    }
    cusps = cusps_of(&c.curve, d, normal);
    ck_cusps(&c.curve, &cusps, &wanted, 0.51 / STEPS);
    some += cusps.n > 0;
  }
  ck_assert_uint_ge(some, (size_t)unit_count(CURVES) / 5);
}

/* Any unit: the numbers go with the fourth power of A. */
PH_TEST_EACH(test_scales, 4) {
  static const int exponents[] = {-500, -300, 300, 500};
  static const ph_quat a[3] = {{1, 0, 0, -1}, {1, 0.1, 0.1, 0}, {1, 0, 0, 1}};
  struct unit_curve3 c;
  struct ph_cusps unscaled, scaled;
  int e = exponents[_i];
  unit_curve3_of(&c, 1, NULL, a, ph_vec3_of(0, 0, 0));
  unscaled = cusps_of(&c.curve, 0.5, PH_E2);
  ck_assert_uint_eq(unscaled.n, 2);
  for (size_t i = 0; i < 12; i++) {
    c.preimage[i] = ldexp(c.preimage[i], e);
  }
  scaled = cusps_of(&c.curve, ldexp(0.5, 2 * e), PH_E2);
  ck_assert_uint_eq(scaled.n, unscaled.n);
  ck_assert_uint_eq(scaled.at[0].segment, unscaled.at[0].segment);
  ck_rel(scaled.at[0].u, unscaled.at[0].u, 0);
}

/* The parameters in [0,1], sorted, at which 2 K d = |w|^4 on a cubic:
 * |w|^2 = A + 2 (R - A) u + M u^2 is sqrt(2 K d). */
static size_t cubic_cusps(const double w[4], double d, double u[2]) {
  double kd = d * (w[0] * w[3] - w[1] * w[2]);
  double slope = w[0] * (w[2] - w[0]) + w[1] * (w[3] - w[1]);
  double m = pow(w[2] - w[0], 2) + pow(w[3] - w[1], 2);
  double rest = w[0] * w[0] + w[1] * w[1] - sqrt(2 * fmax(kd, 0));
  double disc = slope * slope - m * rest;
  size_t n = 0;
  for (int side = -1; kd > 0 && disc > 0 && side <= 1; side += 2) {
    double x = (side * sqrt(disc) - slope) / m;
    if (x > 0 && x < 1) {
      u[n++] = x;
    }
  }
  return n;
}

PH_TEST(test_cubics) {
  struct unit_random r = unit_random_of(514);
  size_t some = 0;
  for (size_t n = 0; n < SEGMENTS; n++) {
    const double scale = n % 2 ? 1 : 1e100;
    double d = scale * unit_random_in(&r, -2, 2);
    struct unit_cubics c;
    struct ph_cusps cusps;
    struct wanted wanted = {.n = 0};
    double before = 0;
    unit_cubics_random(&c, &r, 3, scale, unit_random_cplx(&r, scale));
    for (size_t k = 0; k < 3; k++) {
      double u[2];
      size_t inside = cubic_cusps(c.preimage + 4 * k, d, u);
      double speed = hypot(c.preimage[4 * k], c.preimage[4 * k + 1]);
      double bend = 2 * (d / scale) * (unit_cubic_bend(&c, k) / scale);
      double sign = pow(speed / sqrt(scale), 4) - bend;
      if (k > 0 && (sign > 0) != (before > 0)) { /* at the joint */
        want(&wanted, (double)k);
      }
      for (size_t i = 0; i < inside; i++) {
        want(&wanted, (double)k + u[i]);
      }
      before = inside % 2 ? -sign : sign;
    }
    cusps = cusps_of(&c.curve, d, PH_E2);
    ck_cusps(&c.curve, &cusps, &wanted, 1e-6);
    some += cusps.n > 0;
  }
  ck_assert_uint_ge(some, SEGMENTS / 5);
}
