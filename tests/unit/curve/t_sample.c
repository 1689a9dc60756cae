/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Samples of PH, ATPH and Bezier curves and cubics: curves that are known in
 * closed form, and curves by chance against definitions.  Those of spherical
 * curves are in t_sample_spherical.c.
 */
#include "segment_unit.h"
#include "curve_unit.h"
#include "planar_unit.h"
#include "tc_curve_unit.h"
#include "unit.h"

#include "curve/bezier/convert.h"
#include "curve/segment/seg3.h"

enum { N = 8 };

static struct ph_diag diag;

static struct ph_samples samples_of(const struct ph_curve *curve, size_t n) {
  struct ph_samples s = unit_samples_even(curve, n);
  ck_assert((s.torsion != NULL) == (curve->dimension == 3));
  ck_assert_ptr_null(s.lonlat);
  return s;
}

static ph_vec3 vector(const double *v, const struct ph_samples *s, size_t i) {
  return ph_vec3_get(v + s->dimension * i, s->dimension);
}

/* One planar segment with its length. */
static void planar_of(double angle, const ph_cplx w[3], double length,
                      struct unit_segments *out) {
  struct ph_seg2 seg = unit_seg2(angle, w);
  unit_seg2_curve(&seg, 1, out);
  out->lengths[0] = out->curve.length = length;
}

/* ---- known curves ------------------------------------------------------- */

PH_TEST(test_line) {
  const ph_cplx w[3] = {{2, 0}, {2, 0}, {2, 0}};
  struct unit_segments c;
  struct ph_samples s;
  planar_of(0, w, 4, &c);
  s = samples_of(&c.curve, N);
  for (size_t i = 0; i <= N; i++) {
    ck_assert_uint_eq(s.segment[i], 0);
    ck_abs(s.t[i], (double)i / N, 0);
    ck_abs(s.s[i], 4 * s.t[i], 1e-15);
    ck_vec3(vector(s.point, &s, i), ph_vec3_of(4 * s.t[i], 0, 0), 1e-15);
    ck_vec3(vector(s.tangent, &s, i), ph_vec3_of(1, 0, 0), 0);
    ck_abs(s.curvature[i], 0, 0);
  }
}

/* w = e^(it): a circle of radius 1/2, t its arc length. */
PH_TEST(test_circle) {
  const double angles[] = {0.1, 1, 2, 3};
  for (size_t k = 0; k < COUNT(angles); k++) {
    double angle = angles[k], root = sqrt(angle);
    struct ph_atph space = ph_atph_of(angle);
    const ph_cplx w[3] = {
        {root, 0},
        {root, root * angle / (2 * space.slope)},
        {root * cos(angle), root * sin(angle)},
    };
    struct unit_segments c;
    struct ph_samples s;
    planar_of(angle, w, angle, &c);
    s = samples_of(&c.curve, N);
    for (size_t i = 0; i <= N; i++) {
      double t = s.t[i];
      ck_abs(t, angle * ((double)i / N), 0);
      ck_abs(s.s[i], t, 4e-15);
      ck_vec3(vector(s.point, &s, i),
              ph_vec3_of(0.5 * sin(2 * t), 0.5 - 0.5 * cos(2 * t), 0), 4e-15);
      ck_vec3(vector(s.tangent, &s, i), ph_vec3_of(cos(2 * t), sin(2 * t), 0),
              4e-15);
      ck_abs(s.curvature[i], 2, 1e-13);
    }
    ck_abs(s.t[N], angle, 0);
  }
}

/* A = (cos t + sin t k) A0: r' is A0 i A0* turned about z by 2 t, a helix of
 * curvature 2 a and torsion 2 b where A0 i A0* = (a, 0, b), of length 1. */
PH_TEST(test_helix) {
  const double alpha = 1.7, a = cos(0.4), b = sin(0.4), root = sqrt(alpha);
  const struct ph_atph space = ph_atph_of(alpha);
  const ph_quat k = {0, 0, 0, 1}, turn = {cos(alpha), 0, 0, sin(alpha)};
  const ph_quat a0 = {root * cos(0.2), 0, -root * sin(0.2), 0};
  const ph_quat slope =
      ph_quat_scale(alpha / (2 * space.slope), ph_quat_mul(k, a0));
  const ph_quat pre[3] = {a0, ph_quat_add(a0, slope), ph_quat_mul(turn, a0)};
  struct unit_curve3 c;
  struct ph_samples s;
  unit_curve3_of(&c, 1, &alpha, pre, ph_vec3_of(0, 0, 0));
  s = samples_of(&c.curve, N);
  for (size_t i = 0; i <= N; i++) {
    double t = s.t[i];
    ck_abs(s.s[i], t, 4e-15);
    ck_vec3(vector(s.tangent, &s, i),
            ph_vec3_of(a * cos(2 * t), a * sin(2 * t), b), 4e-15);
    ck_vec3(vector(s.point, &s, i),
            ph_vec3_of(a * sin(2 * t) / 2, a * (1 - cos(2 * t)) / 2, b * t),
            4e-15);
    ck_abs(s.curvature[i], 2 * a, 1e-13);
    ck_abs(s.torsion[i], 2 * b, 1e-13);
  }
}

/* ---- what is not defined ------------------------------------------------ */

/* A line in space has curvature 0 and no torsion, a plane curve torsion 0. */
PH_TEST(test_torsion) {
  const ph_quat line[3] = {
      {1, 0.5, 0.25, 2}, {1, 0.5, 0.25, 2}, {1, 0.5, 0.25, 2}};
  const ph_quat plane[3] = {{1, 0, 0, 0}, {1, 0, 0, 0.5}, {0.5, 0, 0, 1}};
  struct unit_curve3 c;
  struct ph_samples s;
  unit_curve3_of(&c, 1, NULL, line, ph_vec3_of(0, 0, 0));
  s = samples_of(&c.curve, N);
  for (size_t i = 0; i <= N; i++) {
    ck_abs(s.curvature[i], 0, 1e-15);
    ck_assert(isnan(s.torsion[i]));
  }
  unit_curve3_of(&c, 1, NULL, plane, ph_vec3_of(0, 0, 0));
  s = samples_of(&c.curve, N);
  for (size_t i = 0; i <= N; i++) {
    ck_assert(s.curvature[i] > 0.1);
    ck_abs(s.torsion[i], 0, 1e-14);
  }
}

/* A cusp at `u`, w = (x - u) (1 + i x): the tangent goes on, as r' = w^2. */
static void ck_standstill(double u) {
  /* x^0, x^1, x^2: -u, 1 - i u, i */
  const ph_cplx w[3] = {{-u, 0}, {0.5 - u, -u / 2}, {1 - u, 1 - u}};
  double turn = 2 * atan(u);
  struct unit_segments c;
  struct ph_samples s;
  planar_of(0, w, 1, &c);
  s = samples_of(&c.curve, 4);
  for (size_t i = 0; i <= 4; i++) {
    if (unit_same(s.t[i], u)) {
      ck_vec3(vector(s.tangent, &s, i), ph_vec3_of(cos(turn), sin(turn), 0),
              1e-15);
      ck_assert(isnan(s.curvature[i]));
    } else {
      ck_assert(isfinite(s.curvature[i]));
    }
  }
}

PH_TEST(test_standstill) {
  ck_standstill(0);
  ck_standstill(0.5);
  ck_standstill(1);
}

/* More than are allowed are refused before there is memory for them. */
PH_TEST(test_too_many) {
  const size_t refused[] = {PH_SAMPLES_MAX, SIZE_MAX / 4, SIZE_MAX};
  const ph_cplx w[3] = {{2, 0}, {2, 0}, {2, 0}};
  struct unit_segments c;
  struct ph_samples s;
  planar_of(0, w, 4, &c);
  for (size_t i = 0; i < COUNT(refused); i++) {
    struct ph_sample_rules rules = {.how = PH_SAMPLE_PARAMETER,
                                    .n = refused[i]};
    ck_assert_int_eq(ph_sample_curve(&c.curve, &rules, &unit_arena, &s, &diag),
                     PH_E_LIMIT);
  }
}

/* ---- curves by chance --------------------------------------------------- */

/* Curvature and torsion from differences of tangents T at s -+ h, -+ 2h along
 * the curve: T' = kappa N, [T, T', T''] = kappa^2 tau. */
static void ck_bend(const struct ph_sampler *sampler, double u, double tol) {
  const double h = 1e-3;
  const struct ph_sample at = ph_sampler_at(sampler, u);
  const struct ph_seg3 seg = ph_seg3_of(sampler->curve, sampler->k);
  double speed = unit_seg3_bend(&seg, u).speed, speed1, length;
  ph_vec3 t[5], d1, d2;
  for (size_t i = 0; i < 5; i++) {
    t[i] = ph_sampler_at(sampler, u + ((double)i - 2) * h).tangent;
  }
  speed1 =
      (unit_seg3_bend(&seg, u + h).speed - unit_seg3_bend(&seg, u - h).speed) /
      (2 * h);
  d1 = ph_vec3_sub(ph_vec3_scale(8, ph_vec3_sub(t[3], t[1])),
                   ph_vec3_sub(t[4], t[0]));
  d1 = ph_vec3_scale(1 / (12 * h * speed), d1);
  d2 = ph_vec3_sub(
      ph_vec3_scale(16, ph_vec3_add(t[3], t[1])),
      ph_vec3_add(ph_vec3_add(t[4], t[0]), ph_vec3_scale(30, t[2])));
  d2 = ph_vec3_along(ph_vec3_scale(1 / (12 * h * h), d2), -speed1, d1);
  d2 = ph_vec3_scale(1 / (speed * speed), d2);
  length = ph_vec3_dot(d1, d1);
  ck_rel(at.curvature * at.curvature, length, tol);
  ck_abs(at.torsion * length, ph_vec3_triple(t[2], d1, d2),
         tol * (1 + fabs(at.torsion * length)));
}

static void ck_random(const struct ph_curve *curve, struct unit_random *r) {
  struct ph_samples s = samples_of(curve, N);
  double start = 0;
  for (size_t k = 0; k < curve->n; k++) {
    double range = curve->preimage.alpha ? curve->preimage.alpha[k] : 1;
    size_t first = (N + 1) * k, last = first + N;
    struct ph_sampler sampler = unit_sampler(curve, NULL, k);
    ck_bend(&sampler, unit_random_in(r, 0.01, 0.99), 1e-6);
    for (size_t i = first; i <= last; i++) {
      double v = (double)(i - first) / N;
      ph_vec3 e[3];
      unit_curve3_frame(curve, k, v, e);
      ck_assert_uint_eq(s.segment[i], k);
      ck_abs(s.t[i], v * range, 0);
      ck_vec3(vector(s.point, &s, i), unit_curve3_point(curve, k, v), 1e-13);
      ck_vec3(vector(s.tangent, &s, i), e[0], 1e-14);
      ck_assert(i == first || s.s[i] > s.s[i - 1]);
    }
    ck_abs(s.s[first], start, 1e-14 * curve->length);
    start += curve->lengths[k];
    ck_abs(s.s[last], start, 1e-14 * curve->length);
    ck_vec3(vector(s.point, &s, first),
            ph_vec3_get(curve->control_points + 18 * k, 3), 0);
    ck_vec3(vector(s.point, &s, last),
            ph_vec3_get(curve->control_points + 18 * k + 15, 3), 0);
  }
  ck_rel(s.s[s.n - 1], curve->length, 1e-15);
}

PH_TEST(test_random) {
  struct unit_random r = unit_random_of(1300);
  for (int i = 0; i < unit_count(100); i++) {
    struct unit_curve3 c;
    unit_curve3_random(&c, 3, i % 2, 0.5, &r);
    ck_random(&c.curve, &r);
    ph_arena_reset(&unit_arena);
  }
}

/* The length to u is the integral of the speed. */
PH_TEST(test_length) {
  struct unit_random r = unit_random_of(1301);
  struct ph_quad rule;
  ck_assert(ph_quad_gauss(&rule, 20));
  for (int i = 0; i < unit_count(200); i++) {
    double u = unit_random_in(&r, 0, 1), sum = 0;
    struct ph_sampler sampler;
    struct unit_curve3 c;
    unit_curve3_random(&c, 1, i % 2, 1, &r);
    sampler = unit_sampler(&c.curve, NULL, 0);
    for (size_t j = 0; j < rule.n; j++) {
      ph_quat a = unit_curve3_preimage(&c.curve, 0, u * rule.node[j]);
      sum += u * rule.weight[j] * ph_quat_dot(a, a);
    }
    ck_abs(unit_length(&sampler, u), sum, 4e-15 * c.curve.length);
  }
}

/* Powers of 2 scale every number without touching a digit. */
PH_TEST(test_scales) {
  struct unit_random r = unit_random_of(1302);
  const int exponents[] = {-498, -200, 200, 498};
  struct unit_curve3 c, big;
  struct ph_samples s, t;
  unit_curve3_random(&c, 3, false, 0.5, &r);
  s = samples_of(&c.curve, N);
  for (size_t k = 0; k < COUNT(exponents); k++) {
    double root = ldexp(1, exponents[k]), unit = root * root;
    big = c;
    for (size_t i = 0; i < 36; i++) {
      big.preimage[i] *= root;
    }
    for (size_t i = 0; i < 54; i++) {
      big.control_points[i] *= unit;
    }
    for (size_t i = 0; i < 3; i++) {
      big.lengths[i] *= unit;
    }
    big.curve.control_points = big.control_points;
    big.curve.preimage.v = big.preimage;
    big.curve.lengths = big.lengths;
    t = samples_of(&big.curve, N);
    for (size_t i = 0; i < s.n; i++) {
      ck_abs(t.s[i], unit * s.s[i], 0);
      ck_abs(t.curvature[i], s.curvature[i] / unit, 0);
      ck_abs(t.torsion[i], s.torsion[i] / unit, 0);
      ck_vec3(vector(t.point, &t, i),
              ph_vec3_scale(unit, vector(s.point, &s, i)), 0);
      ck_vec3(vector(t.tangent, &t, i), vector(s.tangent, &s, i), 0);
    }
  }
}

/* ---- Bezier curves ------------------------------------------------------ */

/* One Bezier segment with these points, of 2 or 3 coordinates. */
static struct ph_curve bezier_of(double *p, size_t degree, size_t dimension,
                                 double *length) {
  static double knots[2] = {0, 1};
  struct ph_curve c = {.kind = PH_CURVE_BEZIER,
                       .dimension = dimension,
                       .degree = degree,
                       .n = 1,
                       .knots = knots,
                       .control_points = p,
                       .lengths = length,
                       .length = *length};
  return c;
}

/* (u, u^2): known in closed form. */
PH_TEST(test_parabola) {
  const int exponents[] = {0, -1000, 1000};
  for (size_t k = 0; k < COUNT(exponents); k++) {
    double unit = ldexp(1, exponents[k]);
    double p[6] = {0, 0, unit / 2, 0, unit, unit};
    double length = (sqrt(5) / 2 + asinh(2) / 4) * unit;
    struct ph_curve c = bezier_of(p, 2, 2, &length);
    struct ph_samples s = samples_of(&c, N);
    for (size_t i = 0; i <= N; i++) {
      double u = s.t[i], q = sqrt(1 + 4 * u * u);
      ck_abs(s.point[2 * i] / unit, u, 1e-16);
      ck_abs(s.point[2 * i + 1] / unit, u * u, 1e-16);
      ck_abs(s.tangent[2 * i], 1 / q, 2e-16);
      ck_abs(s.tangent[2 * i + 1], 2 * u / q, 2e-16);
      ck_rel(s.curvature[i] * unit, 2 / (q * q * q), 1e-15);
      ck_abs(s.s[i] / unit, u * q / 2 + asinh(2 * u) / 4, 1e-13);
    }
    ck_abs(s.s[N], length, 0);
  }
}

/* (u, u^2, u^3): curvature and torsion of the twisted cubic. */
PH_TEST(test_twisted_cubic) {
  double p[12] = {0, 0, 0, 1.0 / 3, 0, 0, 2.0 / 3, 1.0 / 3, 0, 1, 1, 1};
  double length = 1.8633;
  struct ph_curve c = bezier_of(p, 3, 3, &length);
  struct ph_samples s = samples_of(&c, N);
  for (size_t i = 0; i <= N; i++) {
    double u2 = s.t[i] * s.t[i], q = 9 * u2 * u2 + 9 * u2 + 1;
    ck_rel(s.curvature[i], 2 * sqrt(q) / pow(1 + 4 * u2 + 9 * u2 * u2, 1.5),
           1e-14);
    ck_rel(s.torsion[i], 3 / q, 1e-14);
  }
}

/* Equal points at the ends: the curve starts and stops with speed 0. */
PH_TEST(test_bezier_rest) {
  double p[8] = {0, 0, 0, 0, 3, 4, 3, 4}, q[8] = {1, 1, 1, 1, 1, 1, 5, 4};
  double length = 5;
  struct ph_curve c = bezier_of(p, 3, 2, &length);
  struct ph_samples s = samples_of(&c, 4);
  for (size_t i = 0; i <= 4; i++) {
    ck_vec3(vector(s.tangent, &s, i), ph_vec3_of(0.6, 0.8, 0), 2e-16);
    ck_abs(s.s[i], 5 * s.t[i] * s.t[i] * (3 - 2 * s.t[i]), 1e-14);
    ck_assert(i % 4 ? fabs(s.curvature[i]) <= 1e-15 : isnan(s.curvature[i]));
  }
  c = bezier_of(q, 3, 2, &length);
  s = samples_of(&c, 4);
  ck_vec3(vector(s.tangent, &s, 0), ph_vec3_of(0.8, 0.6, 0), 2e-16);
  ck_assert(isnan(s.curvature[0]));
  ck_abs(s.s[1], 5.0 / 64, 1e-14);
}

/* The Bezier curve of an ATPH curve is sampled as that is. */
PH_TEST(test_bezier_curve) {
  struct unit_random r = unit_random_of(1303);
  const double tolerance = 1e-8;
  for (int i = 0; i < unit_count(20); i++) {
    struct unit_curve3 c;
    struct ph_curve bezier;
    struct ph_samples s;
    double error;
    unit_curve3_random(&c, 2, true, 0.3, &r);
    ck_assert_int_eq(ph_bezier_curve(&c.curve, tolerance, &unit_arena, &bezier,
                                     &error, &diag),
                     PH_OK);
    ck_assert_int_eq(bezier.kind, PH_CURVE_BEZIER);
    s = samples_of(&bezier, N);
    ck_rel(s.s[s.n - 1], c.curve.length, 1e-14);
    for (size_t k = 0, piece = 0; piece < bezier.n; piece++) {
      struct ph_sampler sampler;
      struct ph_sample at;
      double knot = bezier.knots[piece], u, before = 0;
      while (k + 1 < c.curve.n && knot >= c.curve.knots[k + 1]) {
        k++;
      }
      for (size_t j = 0; j < k; j++) {
        before += c.curve.lengths[j];
      }
      u = (knot - c.curve.knots[k]) / (c.curve.knots[k + 1] - c.curve.knots[k]);
      sampler = unit_sampler(&c.curve, NULL, k);
      at = ph_sampler_at(&sampler, u);
      ck_vec3(vector(s.point, &s, (N + 1) * piece), at.point, tolerance);
      ck_vec3(vector(s.tangent, &s, (N + 1) * piece), at.tangent, 1e-12);
      ck_abs(s.s[(N + 1) * piece], before + unit_length(&sampler, u), 1e-12);
    }
    ph_arena_reset(&unit_arena);
  }
}

/* Tschirnhausen cubics: s = A t + (R - A) t^2 + M t^3/3, and the curvature is
 * 2 K/|w|^4. */
PH_TEST(test_cubics) {
  const double scales[] = {1, 1e-9, 1e9, 1e-150, 1e150};
  struct unit_random r = unit_random_of(556);
  for (size_t n = 0; n < 50; n++) {
    const double scale = scales[n % 5], far = n % 2 ? 1e6 : 1;
    struct unit_cubics c;
    struct ph_samples s;
    double start = 0;
    unit_cubics_random(&c, &r, 3, scale, unit_random_cplx(&r, far * scale));
    s = samples_of(&c.curve, N);
    for (size_t i = 0; i < s.n; i++) {
      const size_t k = i / (N + 1);
      const double *w = c.preimage + 4 * k, t = s.t[i];
      ph_cplx at = unit_curve(&c.curve, k, 0, t);
      ph_cplx root = unit_preimage(&c.curve, k, 0, t);
      double a = w[0] * w[0] + w[1] * w[1], ra = w[0] * (w[2] - w[0]);
      double m = pow(w[2] - w[0], 2) + pow(w[3] - w[1], 2);
      double speed = ph_cplx_norm2(root), unit = 1 / speed;
      double bend = 2 * unit_cubic_bend(&c, k);
      ra += w[1] * (w[3] - w[1]);
      start += i % (N + 1) || i == 0 ? 0 : c.lengths[k - 1];
      ck_abs(s.s[i], start + a * t + ra * t * t + m * t * t * t / 3,
             1e-14 * scale);
      ck_vec3(vector(s.point, &s, i), ph_vec3_of(at.re, at.im, 0),
              (far > 1 ? 1e-9 : 1e-14) * scale);
      root = ph_cplx_scale(unit, ph_cplx_mul(root, root));
      ck_vec3(vector(s.tangent, &s, i), ph_vec3_of(root.re, root.im, 0),
              4e-15 * sqrt(scale / speed));
      ck_rel(s.curvature[i], bend * unit * unit,
             1e-14 * (1 + scale / speed + scale / fabs(bend)));
    }
    for (size_t k = 0; k < 3; k++) { /* the ends are control points */
      const size_t first = (N + 1) * k;
      ck_assert_mem_eq(s.point + 2 * first, c.control_points + 8 * k,
                       2 * sizeof(double));
      ck_assert_mem_eq(s.point + 2 * (first + N), c.control_points + 8 * k + 6,
                       2 * sizeof(double));
    }
    ck_rel(s.s[s.n - 1], c.curve.length, 4e-16);
  }
}
