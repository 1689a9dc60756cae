/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Samples of parallels on the sphere: lengths, equal spacing, chords. */
#include "spherical_unit.h"
#include "unit.h"

#include "curve/offset/offset.h"
#include "kernel/degree.h"
#include "kernel/pi.h"
#include "kernel/quad.h"

enum { N = 10 };

static const double DEGREE = PH_PI / 180;

static struct ph_diag diag;
static const struct ph_sample_rules even = {.how = PH_SAMPLE_PARAMETER, .n = N};

static struct ph_offset offset_by(const struct ph_curve *curve, double distance,
                                  struct ph_sample_rules samples) {
  const struct ph_offset_rules by = {.tolerance = 1e-9, .samples = samples};
  struct ph_offset o;
  ck_assert_int_eq(ph_offset(curve, distance, &by, &unit_arena, &o, &diag),
                   PH_OK);
  ck_rel(o.samples.s[o.samples.n - 1], o.length, 0);
  return o;
}

/* |g|, with kappa from its definition. */
static double pace_of(const struct ph_curve *curve, size_t k, double u,
                      double d) {
  double speed, kappa = unit_kappa(curve, k, u, &speed);
  return fabs(cos(d) - sin(d) * kappa) * speed;
}

/* The length of an offset over part of a segment, without a cusp within. */
static double integral(const struct ph_quad *rule, const struct ph_curve *curve,
                       size_t k, double from, double to, double d) {
  enum { PARTS = 32 };
  double sum = 0, h = (to - from) / PARTS;
  for (size_t i = 0; i < PARTS; i++) {
    for (size_t j = 0; j < rule->n; j++) {
      double u = from + h * ((double)i + rule->node[j]);
      sum += h * rule->weight[j] * pace_of(curve, k, u, d);
    }
  }
  return sum;
}

PH_TEST(test_length) {
  struct unit_random r = unit_random_of(1323);
  struct ph_quad rule;
  ck_assert(ph_quad_gauss(&rule, 20));
  for (int i = 0; i < unit_count(30); i++) {
    struct unit_spherical c;
    struct ph_offset o;
    double d = unit_random_in(&r, -2, 2), sum = 0;
    size_t next = 0;
    unit_spherical_random(&c, 3, 0.2, &r);
    o = offset_by(&c.curve, d, even);
    for (size_t k = 0; k < c.curve.n; k++) {
      double from = 0;
      for (; next < o.cusps.n && o.cusps.at[next].segment == k; next++) {
        sum += integral(&rule, &c.curve, k, from, o.cusps.at[next].u, d);
        from = o.cusps.at[next].u;
      }
      sum += integral(&rule, &c.curve, k, from, 1, d);
      ck_abs(o.samples.s[(N + 1) * k + N], sum, 1e-13 * (c.curve.length + sum));
    }
    ph_arena_reset(&unit_arena);
  }
}

/* A sample is at the distance from its place on the curve. */
static void ck_beside(const struct ph_curve *curve, const struct ph_offset *o,
                      size_t i, double d) {
  struct ph_spherical segment = ph_spherical_of(curve, o->samples.segment[i]);
  ph_vec3 on[4];
  ph_spherical_jet(&segment, o->samples.t[i], on);
  ck_abs(ph_s2_angle(on[0], unit_vector(o->samples.point, i)), fabs(d), 1e-12);
}

/* Equally spaced along the offset, which is not longer than its chords say. */
PH_TEST(test_spacing) {
  struct unit_random r = unit_random_of(1324);
  for (int i = 0; i < unit_count(20); i++) {
    const double d = unit_random_in(&r, -2, 2);
    struct ph_sample_rules by = {.how = PH_SAMPLE_SPACING};
    struct unit_spherical c;
    struct ph_offset o;
    unit_spherical_random(&c, 3, 0.4, &r);
    by.spacing = offset_by(&c.curve, d, even).length / 100.5;
    o = offset_by(&c.curve, d, by);
    ck_assert_uint_eq(o.samples.n, 102);
    ck_abs(o.samples.s[101], o.length, 0);
    for (size_t j = 0; j < o.samples.n; j++) {
      ck_beside(&c.curve, &o, j, d);
      if (j < 101) {
        ck_abs(o.samples.s[j], (double)j * by.spacing, 1e-15 * o.length);
      }
      if (j > 0) {
        ck_assert(ph_s2_angle(unit_vector(o.samples.point, j - 1),
                              unit_vector(o.samples.point, j)) <=
                  by.spacing * (1 + 1e-12));
      }
    }
    ph_arena_reset(&unit_arena);
  }
}

/* Parallels of a great circle at one speed: equal spacing is that of longitude.
 */
PH_TEST(test_spacing_latitude) {
  const double d = 50 * DEGREE, length = 60 * DEGREE * cos(d);
  const struct ph_sample_rules by = {.how = PH_SAMPLE_SPACING,
                                     .spacing = length / 12};
  ph_vec3 p[4];
  struct unit_spherical c;
  struct ph_offset o;
  for (size_t i = 0; i < 4; i++) {
    p[i] = ph_degree_to_unit(20.0 * (double)i, 0);
  }
  unit_spherical_of(&c, 1, false, p);
  o = offset_by(&c.curve, d, by);
  ck_assert_uint_eq(o.samples.n, 13);
  for (size_t i = 0; i <= 12; i++) {
    ck_abs(o.samples.lonlat[2 * i], 5 * (double)i, 1e-12);
    ck_abs(o.samples.lonlat[2 * i + 1], 50, 1e-13);
    ck_abs(o.samples.curvature[i], tan(d), 1e-13);
  }
}

/* No place of the offset is farther from the chord over it than asked for, and
 * cusps are samples. */
PH_TEST(test_chords) {
  enum { LOOKS = 16 };
  struct unit_random r = unit_random_of(1325);
  for (int i = 0; i < unit_count(20); i++) {
    const double d = unit_random_in(&r, -2, 2), error = 1e-4;
    const struct ph_sample_rules by = {.how = PH_SAMPLE_CHORD,
                                       .chord_error = error};
    struct unit_spherical c;
    struct ph_offset o;
    size_t cusps = 0;
    unit_spherical_random(&c, 3, 0.4, &r);
    o = offset_by(&c.curve, d, by);
    for (size_t j = 0; j < o.samples.n; j++) {
      size_t k = o.samples.segment[j];
      double from =
          j > 0 && o.samples.segment[j - 1] == k ? o.samples.t[j - 1] : 0;
      double to = o.samples.t[j];
      const struct ph_spherical segment = ph_spherical_of(&c.curve, k);
      ck_beside(&c.curve, &o, j, d);
      for (size_t m = 0; j > 0 && m <= LOOKS; m++) {
        double u = from + (to - from) * (double)m / LOOKS;
        ck_assert(unit_chord_distance(unit_parallel(&segment, d, u),
                                      unit_vector(o.samples.point, j - 1),
                                      unit_vector(o.samples.point, j)) <=
                  error * (1 + 1e-9));
      }
      while (cusps < o.cusps.n && o.cusps.at[cusps].segment == k &&
             o.cusps.at[cusps].u <= to) {
        ck_assert(o.cusps.at[cusps].u >= to || o.cusps.at[cusps].u <= 0);
        cusps++;
      }
    }
    ck_assert_uint_eq(cusps, o.cusps.n);
    ph_arena_reset(&unit_arena);
  }
}
