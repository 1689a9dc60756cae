/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Places on PH and ATPH segments and cubics: curves that are known in closed
 * form at any size and angle, and curves by chance against quadrature.
 */
#include "curve_unit.h"
#include "segment_unit.h"
#include "tc_curve_unit.h"
#include "unit.h"

#include "curve/segment/tc.h"

enum { STEPS = 32, CURVES = 100 };

/* ---- known curves -------------------------------------------------------- */

PH_TEST(test_circle) {
  static const double angles[] = {1e-6, 0.1, 1, 2, 3, 3.1};
  static const double radii[] = {1e-150, 0.37, 1, 5, 1e150};
  for (size_t n = 0; n < 30; n++) {
    const double angle = angles[n % 6], radius = radii[n / 6];
    struct unit_segments c;
    struct ph_sampler sampler;
    unit_circle(angle, radius, &c);
    sampler = unit_sampler(&c.curve, NULL, 0);
    ck_rel(sampler.length, 2 * radius * angle, 4e-16);
    for (int i = 0; i <= STEPS; i++) {
      double u = (double)i / STEPS, turn = 2 * angle * u, speed;
      double s = ph_sampler_length(&sampler, u, &speed);
      struct ph_sample at = ph_sampler_at(&sampler, u);
      ck_rel(s, radius * turn, 4e-15);
      ck_rel(speed, 2 * radius * angle, 4e-15);
      ck_abs(at.point.x / radius, sin(turn), 4e-15);
      ck_abs(at.point.y / radius, 1 - cos(turn), 4e-15);
      ck_abs(at.tangent.x, cos(turn), 4e-15);
      ck_abs(at.tangent.y, sin(turn), 4e-15);
      ck_rel(at.curvature * radius, 1, angle < 0.01 ? 1e-9 : 1e-13);
    }
    ph_arena_reset(&unit_arena);
  }
}

/* (cos t + sin t k) A0 turns A0 i A0* about z: a helix. */
PH_TEST(test_helix) {
  static const double angles[] = {0.1, 1, 2, 3, 3.1};
  for (size_t n = 0; n < 5; n++) {
    const struct unit_helix h = {angles[n], 0.7, 0.4};
    const double squares = h.a * h.a + h.b * h.b;
    struct unit_curve3 c;
    struct ph_sampler sampler;
    unit_helix_curve(&h, &c);
    sampler = unit_sampler(&c.curve, NULL, 0);
    for (int i = 0; i <= STEPS; i++) {
      double u = (double)i / STEPS, speed;
      double s = ph_sampler_length(&sampler, u, &speed);
      struct ph_sample at = ph_sampler_at(&sampler, u);
      ck_rel(s, 2 * h.alpha * u * sqrt(squares), 4e-15);
      ck_abs(unit_apart(at.point, unit_helix_at(&h, u, h.a, 0)), 0, 1e-14);
      ck_abs(ph_vec3_dot(at.tangent, at.tangent), 1, 1e-15);
      ck_abs(at.tangent.z, h.b / sqrt(squares), 4e-15);
      ck_rel(at.curvature, h.a / squares, 2e-13 / (h.alpha * h.alpha));
      ck_rel(at.torsion, h.b / squares, 2e-13 / (h.alpha * h.alpha));
    }
  }
}

/* A line that is run through with changing speed, w = (1 + u)^2 e^(i angle). */
PH_TEST(test_line) {
  const ph_cplx e = ph_cplx_polar(0.3), e2 = ph_cplx_polar(0.6);
  const ph_cplx w[3] = {e, ph_cplx_scale(2, e), ph_cplx_scale(4, e)};
  struct ph_seg2 seg = unit_seg2(0, w);
  struct unit_segments c;
  struct ph_sampler sampler;
  unit_seg2_curve(&seg, 1, &c);
  c.lengths[0] = 31.0 / 5;
  sampler = unit_sampler(&c.curve, NULL, 0);
  for (int i = 0; i <= STEPS; i++) {
    double u = (double)i / STEPS, v = 1 + u, speed;
    double s = ph_sampler_length(&sampler, u, &speed);
    struct ph_sample at = ph_sampler_at(&sampler, u);
    ck_abs(s, (v * v * v * v * v - 1) / 5, 2e-15);
    ck_rel(speed, v * v * v * v, 2e-15);
    ck_abs(at.point.x, s * e2.re, 4e-15);
    ck_abs(at.point.y, s * e2.im, 4e-15);
    ck_abs(at.tangent.x, e2.re, 1e-15);
    ck_abs(at.tangent.y, e2.im, 1e-15);
    ck_abs(at.curvature, 0, 1e-15);
  }
}

/* Cubics by the formulas of curve/segment/tc.h, for the part up to u. */
PH_TEST(test_cubics) {
  struct unit_random r = unit_random_of(1380);
  for (int n = 0; n < unit_count(CURVES); n++) {
    struct unit_cubics c;
    struct ph_sampler sampler;
    struct ph_tc tc;
    unit_cubics_random(&c, &r, 1, 1, ph_cplx_of(0, 0));
    sampler = unit_sampler(&c.curve, NULL, 0);
    tc.w[0] = ph_cplx_of(c.preimage[0], c.preimage[1]);
    tc.w[1] = ph_cplx_of(c.preimage[2], c.preimage[3]);
    for (int i = 1; i <= STEPS; i++) {
      double u = (double)i / STEPS, root = sqrt(u);
      struct ph_tc part = ph_tc_part(&tc, 0, u);
      struct ph_sample at = ph_sampler_at(&sampler, u);
      ph_cplx leg = unit_tc_at(&tc, u);
      double turn = 0.5 * ph_tc_turning(&part);
      ph_cplx w = ph_cplx_mul(ph_cplx_polar(turn), tc.w[0]);
      part.w[0] = ph_cplx_scale(root, tc.w[0]);
      part.w[1] = ph_cplx_scale(root, ph_cplx_between(tc.w[0], tc.w[1], u));
      ck_abs(unit_length(&sampler, u), ph_tc_length(&part), 4e-15);
      ck_abs(at.point.x, leg.re, 4e-15);
      ck_abs(at.point.y, leg.im, 4e-15);
      w = ph_cplx_scale(1 / ph_cplx_norm2(w), ph_cplx_mul(w, w));
      ck_abs(at.tangent.x, w.re, 1e-13);
      ck_abs(at.tangent.y, w.im, 1e-13);
    }
  }
}

/* ---- curves by chance ---------------------------------------------------- */

/* The length from u to v by quadrature in panels. */
static double quadrature(const struct ph_curve *curve, double u, double v) {
  enum { PANELS = 4 };
  struct ph_quad rule;
  double sum = 0, h = (v - u) / PANELS;
  ck_assert(ph_quad_gauss(&rule, 20));
  for (size_t i = 0; i < PANELS; i++) {
    for (size_t j = 0; j < rule.n; j++) {
      double at = u + h * ((double)i + rule.node[j]);
      ph_quat a = unit_curve3_preimage(curve, 0, at);
      sum += h * rule.weight[j] * ph_quat_dot(a, a);
    }
  }
  return sum;
}

/* Lengths from the start increase, meet both ends exactly and have the speed as
 * their derivative. */
static void ck_lengths(const struct ph_sampler *sampler) {
  const struct ph_curve *curve = sampler->curve;
  double before = 0, h = 1e-5, speed, unused;
  ck_abs(unit_length(sampler, 0), 0, 0);
  ck_abs(unit_length(sampler, 1), sampler->length, 0);
  ck_abs(sampler->length, curve->lengths[0], 0);
  for (int i = 1; i <= STEPS; i++) {
    double u = (double)i / STEPS, slope;
    double s = ph_sampler_length(sampler, u, &speed);
    ck_abs(s, quadrature(curve, 0, u), 1e-14 * curve->length);
    ck_assert(s > before);
    before = s;
    u -= 0.5 / STEPS;
    ph_sampler_length(sampler, u, &speed);
    slope = (ph_sampler_length(sampler, u + h, &unused) -
             ph_sampler_length(sampler, u - h, &unused)) /
            (2 * h);
    ck_abs(speed, slope, 1e-7 * curve->length);
    ck_assert(speed >= 0);
  }
  /* Next to an end, lengths are known to their own digits. */
  ck_rel(unit_length(sampler, 1e-9), quadrature(curve, 0, 1e-9), 4e-15);
}

PH_TEST(test_lengths) {
  struct unit_random r = unit_random_of(1381);
  for (int i = 0; i < unit_count(CURVES); i++) {
    struct unit_curve3 c;
    struct ph_sampler sampler;
    unit_curve3_random(&c, 1, i % 2, i % 3 ? 1 : 3, &r);
    sampler = unit_sampler(&c.curve, NULL, 0);
    ck_lengths(&sampler);
    ph_arena_reset(&unit_arena);
  }
}

/* Near-cusps: A passes at `gap` from 0 at u0, for angles up to nearly pi. */
PH_TEST_EACH(test_near_cusps, 5) {
  static const double angles[] = {0, 0.5, 2, 3.1, 3.14159};
  static const double gaps[] = {1e-2, 1e-4, 1e-8, 1e-12, 0};
  struct unit_random r = unit_random_of(1382);
  const double angle = angles[_i];
  for (size_t i = 0; i < 25; i++) {
    double gap = gaps[i % 5], u0 = (double)(i / 5) / 4, v = 1 - u0, b[3];
    double s0 = angle > 0 ? sin(angle * v / 2) / sin(angle / 2) : v;
    double s1 = angle > 0 ? sin(angle * u0 / 2) / sin(angle / 2) : u0;
    ph_quat a[3];
    struct unit_curve3 c;
    struct ph_sampler sampler;
    size_t most = 0;
    b[0] = s0 * s0;
    b[1] = 2 * s0 * s1;
    b[2] = s1 * s1;
    for (size_t j = 0; j < 3; j++) {
      ph_cplx p = unit_random_cplx(&r, 1), q = unit_random_cplx(&r, 1);
      a[j] = ph_quat_of(p.re, p.im, q.re, q.im);
      most = b[j] > b[most] ? j : most;
    }
    a[most] = ph_quat_of(gap, 0, 0, 0);
    for (size_t j = 0; j < 3; j++) {
      a[most] =
          j == most ? a[most] : ph_quat_sub(a[most], ph_quat_scale(b[j], a[j]));
    }
    a[most] = ph_quat_scale(1 / b[most], a[most]);
    a[1] = ph_quat_scale(1 / cos(angle / 2), a[1]);
    unit_curve3_of(&c, 1, angle > 0 ? &angle : NULL, a, ph_vec3_of(0, 0, 0));
    sampler = unit_sampler(&c.curve, NULL, 0);
    ck_lengths(&sampler);
    ph_arena_reset(&unit_arena);
  }
}

/* Points are good to some eps of what they are sums of. */
PH_TEST(test_points) {
  struct unit_random r = unit_random_of(1383);
  for (int i = 0; i < unit_count(CURVES); i++) {
    struct unit_curve3 c;
    struct ph_sampler sampler;
    unit_curve3_random(&c, 1, false, 2, &r);
    sampler = unit_sampler(&c.curve, NULL, 0);
    for (int k = 0; k <= STEPS; k++) {
      double u = (double)k / STEPS;
      ph_vec3 at = unit_bezier3(c.control_points, 5, 0, u);
      ck_abs(unit_apart(ph_sampler_at(&sampler, u).point, at), 0,
             8e-16 * (4 + c.curve.length));
    }
    ph_arena_reset(&unit_arena);
  }
}
