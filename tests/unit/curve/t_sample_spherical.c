/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Samples of spherical curves. */
#include "curve_unit.h"
#include "spherical_unit.h"
#include "unit.h"

#include "kernel/degree.h"
#include "kernel/pi.h"
#include "kernel/quad.h"

enum { N = 8 };

static struct ph_samples samples_of(const struct ph_curve *curve, size_t n) {
  struct ph_samples s = unit_samples_even(curve, n);
  ck_assert_ptr_null(s.torsion);
  ck_assert_ptr_nonnull(s.lonlat);
  return s;
}

/* Evenly spaced control points on a great circle are run through evenly. */
PH_TEST(test_great_circle) {
  const ph_vec3 center = {10, -20, 30};
  const double radius = 4;
  struct unit_spherical c;
  struct ph_samples s;
  ph_vec3 p[8];
  for (size_t i = 0; i < 8; i++) {
    p[i] = ph_degree_to_unit(10.0 * (double)(i < 4 ? i : i - 1), 0);
  }
  unit_spherical_of(&c, 2, false, p);
  unit_spherical_place(&c, center, radius);
  s = samples_of(&c.curve, N);
  for (size_t i = 0; i < s.n; i++) {
    double lon = 30 * (s.t[i] + (double)s.segment[i]);
    ph_vec3 at = ph_degree_to_unit(lon, 0);
    ck_assert_uint_eq(s.segment[i], i / (N + 1));
    ck_abs(s.t[i], (double)(i % (N + 1)) / N, 0);
    ck_abs(s.s[i], radius * lon * (PH_PI / 180), 1e-14);
    ck_vec3(ph_vec3_get(s.point + 3 * i, 3), ph_vec3_along(center, radius, at),
            1e-14);
    ck_vec3(ph_vec3_get(s.tangent + 3 * i, 3), ph_vec3_of(-at.y, at.x, 0),
            1e-15);
    ck_abs(s.curvature[i], 0, 1e-15);
    ck_abs(s.lonlat[2 * i], lon, 2e-14);
    ck_abs(s.lonlat[2 * i + 1], 0, 1e-14);
  }
}

/* Bending by definition: from differences of the tangents along the curve. */
static void ck_curvature(const struct ph_sampler *sampler, double u) {
  const double h = 1e-3, size = sampler->curve->sphere.radius;
  struct ph_sample at = ph_sampler_at(sampler, u), near[4];
  ph_vec3 left, turn, center = ph_vec3_get(sampler->curve->sphere.center, 3);
  double length, s[4];
  for (size_t i = 0; i < 4; i++) {
    static const double steps[4] = {-2, -1, 1, 2};
    near[i] = ph_sampler_at(sampler, u + steps[i] * h);
    s[i] = unit_length(sampler, u + steps[i] * h);
  }
  turn = ph_vec3_sub(
      ph_vec3_scale(8, ph_vec3_sub(near[2].tangent, near[1].tangent)),
      ph_vec3_sub(near[3].tangent, near[0].tangent));
  length = 8 * (s[2] - s[1]) - (s[3] - s[0]);
  left = ph_vec3_cross(ph_vec3_sub(at.point, center), at.tangent);
  ck_abs(at.curvature * size, ph_vec3_dot(turn, left) / length, 1e-6);
}

PH_TEST(test_random) {
  struct unit_random r = unit_random_of(1310);
  for (int i = 0; i < unit_count(60); i++) {
    const double radius = exp(unit_random_in(&r, -5, 5));
    const ph_vec3 center = {radius, -2 * radius, 0};
    struct ph_samples s;
    struct unit_spherical c;
    double start = 0;
    unit_spherical_random(&c, 3, 0.5, &r);
    unit_spherical_place(&c, center, radius);
    s = samples_of(&c.curve, N);
    for (size_t k = 0; k < 3; k++) {
      struct ph_sampler sampler = unit_sampler(&c.curve, NULL, k);
      struct ph_spherical segment = ph_spherical_of(&c.curve, k);
      size_t first = (N + 1) * k, last = first + N;
      for (size_t j = first; j <= last; j++) {
        ph_vec3 p = ph_vec3_sub(ph_vec3_get(s.point + 3 * j, 3), center);
        ph_vec3 t = ph_vec3_get(s.tangent + 3 * j, 3), u;
        ck_rel(ph_vec3_abs(p), radius, 2e-15);
        ck_abs(ph_vec3_dot(p, t) / radius, 0, 2e-15);
        ck_abs(ph_vec3_abs(t), 1, 1e-15);
        ck_abs(s.curvature[j] * radius, unit_curvature(&segment, s.t[j]),
               1e-13 * (1 + fabs(s.curvature[j] * radius)));
        u = ph_degree_to_unit(s.lonlat[2 * j], s.lonlat[2 * j + 1]);
        ck_abs(ph_s2_angle(u, ph_vec3_unit(p)), 0, 4e-15);
        ck_assert(j == first || s.s[j] > s.s[j - 1]);
      }
      /* the ends are the data, to the last bit */
      ck_vec3(ph_vec3_get(s.point + 3 * first, 3),
              ph_vec3_get(c.control_points + 12 * k, 3), 0);
      ck_vec3(ph_vec3_get(s.point + 3 * last, 3),
              ph_vec3_get(c.control_points + 12 * k + 9, 3), 0);
      ck_abs(s.s[first], start, 1e-15 * c.curve.length);
      start += c.lengths[k];
      ck_abs(s.s[last], start, 1e-15 * c.curve.length);
      ck_curvature(&sampler, unit_random_in(&r, 0.01, 0.99));
    }
    ph_arena_reset(&unit_arena);
  }
}

/* s is the integral of the speed. */
PH_TEST(test_length) {
  struct unit_random r = unit_random_of(1311);
  struct ph_quad rule;
  ck_assert(ph_quad_gauss(&rule, 20));
  for (int i = 0; i < unit_count(50); i++) {
    struct unit_spherical c;
    struct ph_samples s;
    struct ph_spherical segment;
    double sum = 0;
    unit_spherical_random(&c, 1, 0.3, &r);
    s = samples_of(&c.curve, N);
    segment = ph_spherical_of(&c.curve, 0);
    for (size_t j = 1; j <= N; j++) {
      for (size_t n = 0; n < rule.n; n++) {
        ph_vec3 jet[4];
        ph_spherical_jet(&segment, s.t[j - 1] + rule.node[n] / N, jet);
        sum += rule.weight[n] / N * ph_vec3_abs(jet[1]);
      }
      ck_rel(s.s[j], sum, 1e-13);
    }
    ph_arena_reset(&unit_arena);
  }
}

/* At rest ends the tangent is the limit, and there is no curvature. */
PH_TEST(test_rest) {
  const ph_vec3 a = ph_degree_to_unit(0, 0), b = ph_degree_to_unit(50, 30);
  const ph_vec3 half[4] = {a, a, ph_degree_to_unit(40, -10), b};
  const ph_vec3 both[4] = {a, a, b, b};
  struct unit_spherical c;
  struct ph_samples s;
  struct ph_sampler sampler;
  ph_vec3 limit;
  unit_spherical_of(&c, 1, false, half);
  s = samples_of(&c.curve, N);
  sampler = unit_sampler(&c.curve, NULL, 0);
  limit = ph_vec3_unit(ph_s2_log(a, half[2]));
  ck_vec3(ph_vec3_get(s.tangent, 3), limit, 1e-14);
  ck_assert(isnan(s.curvature[0]));
  limit = ph_sampler_at(&sampler, 1e-9).tangent;
  ck_vec3(ph_vec3_get(s.tangent, 3), limit, 1e-8);
  ck_assert(isfinite(s.curvature[1]) && isfinite(s.curvature[N]));
  /* on the great circle from one to the other, which it does not leave */
  unit_spherical_of(&c, 1, false, both);
  s = samples_of(&c.curve, N);
  ck_vec3(ph_vec3_get(s.tangent, 3), ph_vec3_unit(ph_s2_log(a, b)), 1e-15);
  limit = ph_vec3_scale(-1, ph_vec3_unit(ph_s2_log(b, a)));
  ck_vec3(ph_vec3_get(s.tangent + 3 * N, 3), limit, 1e-15);
  for (size_t i = 0; i <= N; i++) {
    ck_assert(i % N ? fabs(s.curvature[i]) <= 1e-13 : isnan(s.curvature[i]));
  }
}

/* ---- lengths and places -------------------------------------------------- */

/* |the integral of the speed|. */
static double integral(const struct ph_spherical *segment, double from,
                       double to) {
  struct ph_quad rule;
  double sum = 0;
  ck_assert(ph_quad_gauss(&rule, 20));
  for (size_t n = 0; n < rule.n; n++) {
    ph_vec3 jet[4];
    ph_spherical_jet(segment, from + (to - from) * rule.node[n], jet);
    sum += rule.weight[n] * fabs(to - from) * ph_vec3_abs(jet[1]);
  }
  return sum;
}

/* The same, from an end where the curve may be nearly at rest. */
static double integral_from(const struct ph_spherical *segment, double end,
                            double to) {
  double sum = 0;
  for (double part = to - end; fabs(part) > 1e-15; part /= 2) {
    sum += integral(segment, end + part / 2, end + part);
  }
  return sum;
}

/* Lengths grow from 0 to what the curve says, their derivative is the speed,
 * and they are its integral. */
static void ck_lengths(const struct ph_curve *curve, size_t k) {
  enum { LOOKS = 200 };
  const struct ph_spherical segment = ph_spherical_of(curve, k);
  const struct ph_sampler sampler = unit_sampler(curve, NULL, k);
  const double whole = curve->lengths[k];
  double before = 0, sum = 0;
  ck_abs(sampler.length, whole, 0);
  ck_abs(unit_length(&sampler, 0), 0, 0);
  ck_abs(unit_length(&sampler, 1), whole, 0);
  for (size_t i = 1; i <= LOOKS; i++) {
    double u = (double)i / LOOKS, speed;
    double s = ph_sampler_length(&sampler, u, &speed);
    ph_vec3 jet[4];
    ck_assert(s > before);
    sum += i == 1       ? integral_from(&segment, 0, u)
           : i == LOOKS ? integral_from(&segment, 1, 1 - 1.0 / LOOKS)
                        : integral(&segment, u - 1.0 / LOOKS, u);
    ck_abs(s, curve->sphere.radius * sum, 1e-13 * whole);
    ph_spherical_jet(&segment, u, jet);
    ck_abs(speed, curve->sphere.radius * ph_vec3_abs(jet[1]), 1e-11 * whole);
    before = s;
  }
}

/* The place of a length, from the ends on, where the curve may be at rest. */
static void ck_places(const struct ph_curve *curve, size_t k) {
  const struct ph_sampler sampler = unit_sampler(curve, NULL, k);
  const double whole = sampler.length;
  for (int i = 0; i <= 60; i++) {
    double part = ldexp(1, -i / 2), s = (i % 2 ? part : 1 - part) * whole;
    double u = unit_parameter(&sampler, s);
    ck_assert(u >= 0 && u <= 1);
    ck_abs(unit_length(&sampler, u), s, 1e-14 * whole);
  }
}

PH_TEST(test_places) {
  struct unit_random r = unit_random_of(1312);
  for (int i = 0; i < unit_count(40); i++) {
    struct unit_spherical c;
    unit_spherical_random(&c, 2, 0.5, &r);
    unit_spherical_place(&c, ph_vec3_of(1, 2, 3), 1 + i);
    for (size_t k = 0; k < 2; k++) {
      ck_lengths(&c.curve, k);
      ck_places(&c.curve, k);
    }
    ph_arena_reset(&unit_arena);
  }
}

/* At rest at both ends, at one, and nearly. */
PH_TEST(test_places_rest) {
  const ph_vec3 a = ph_degree_to_unit(0, 0), b = ph_degree_to_unit(40, -10);
  const ph_vec3 e = ph_degree_to_unit(50, 30);
  const ph_vec3 p[][4] = {{a, a, b, e},
                          {a, b, e, e},
                          {a, a, e, e},
                          {a, ph_degree_to_unit(1e-7, 1e-7), b, e},
                          {a, ph_degree_to_unit(0.01, -0.02), e, e}};
  for (size_t i = 0; i < COUNT(p); i++) {
    struct unit_spherical c;
    unit_spherical_of(&c, 1, false, p[i]);
    ck_lengths(&c.curve, 0);
    ck_places(&c.curve, 0);
  }
}

/* The same with three points in one place, where s goes with u^3. */
PH_TEST(test_places_thrice) {
  const ph_vec3 a = ph_degree_to_unit(0, 0), e = ph_degree_to_unit(50, 30);
  const ph_vec3 p[4] = {a, a, a, e};
  struct unit_spherical c;
  struct ph_sampler sampler;
  unit_spherical_of(&c, 1, false, p);
  c.lengths[0] = ph_s2_angle(a, e);
  ck_places(&c.curve, 0);
  sampler = unit_sampler(&c.curve, NULL, 0);
  for (size_t i = 0; i <= 100; i++) {
    double u = (double)i / 100;
    ck_abs(unit_length(&sampler, u), c.lengths[0] * u * u * u, 1e-14);
  }
}

/* From rest, s = |S''(0)| u^2 / 2 to first order. */
PH_TEST(test_start) {
  const ph_vec3 a = ph_degree_to_unit(0, 0);
  const ph_vec3 p[4] = {a, a, ph_degree_to_unit(40, -10),
                        ph_degree_to_unit(50, 30)};
  const struct ph_spherical segment = {{p[0], p[1], p[2], p[3]}};
  struct unit_spherical c;
  struct ph_sampler sampler;
  ph_vec3 jet[4];
  unit_spherical_of(&c, 1, false, p);
  sampler = unit_sampler(&c.curve, NULL, 0);
  ph_spherical_jet(&segment, 0, jet);
  for (double u = 1e-2; u > 1e-6; u /= 10) {
    double s = ph_vec3_abs(jet[2]) * u * u / 2;
    ck_rel(unit_parameter(&sampler, s), u, 3 * u + 1e-14 / (u * u));
  }
}
