/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Offsets in space: the definition o = r + d e, point by point. */
#include "unit.h"
#include "curve_unit.h"

#include "curve/offset/offset.h"

enum { ALL = PH_OFFSETS_SPATIAL };

static struct ph_diag diag;
static struct unit_curve3 c;
static const struct ph_offset_rules rules = {.tolerance = 1e-9};

/* The four offsets, with what they say of themselves. */
static void offsets_of(double distance, double tolerance,
                       struct ph_offset offsets[ALL]) {
  const struct ph_offset_rules within = {.tolerance = tolerance};
  enum ph_status status =
      ph_offset(&c.curve, distance, &within, &unit_arena, offsets, &diag);
  ck_assert_msg(status == PH_OK, "seed %lu: %s", unit_seed(), diag.message);
  for (size_t i = 0; i < ALL; i++) {
    ck_abs(offsets[i].distance, i % 2 ? -distance : distance, 0);
    ck_assert_str_eq(offsets[i].vector, i < 2 ? "e2" : "e3");
    ck_assert_uint_eq(offsets[i].dimension, 3);
  }
}

static enum ph_normal normal_of(const struct ph_offset *o) {
  return o->vector[1] == '2' ? PH_E2 : PH_E3;
}

/* Value of a rational Bezier piece. */
static ph_vec3 rational(const struct ph_offset *o, size_t piece, double t) {
  const double *p = o->control_points + 30 * piece;
  const double *weight = o->weights + 10 * piece;
  double lifted[30], flat[30] = {0}, unit = 0;
  for (size_t i = 0; i < 10; i++) {
    unit = fmax(unit, weight[i]);
  }
  for (size_t i = 0; i < 10; i++) {
    flat[3 * i] = weight[i] / unit;
    for (size_t j = 0; j < 3; j++) {
      lifted[3 * i + j] = flat[3 * i] * p[3 * i + j];
    }
  }
  return ph_vec3_scale(1 / unit_bezier3(flat, 9, 0, t).x,
                       unit_bezier3(lifted, 9, 0, t));
}

/* The pieces tile the segments in order, all weights are positive. */
static void ck_pieces(const struct ph_offset *o) {
  size_t piece = 0;
  ck_assert_uint_eq(o->degree, 9);
  ck_assert_ptr_null(o->numerator);
  for (size_t k = 0; k < c.curve.n; k++) {
    for (double at = 0; at < 1; at = o->interval[2 * piece++ + 1]) {
      ck_assert_uint_lt(piece, o->n);
      ck_assert_uint_eq(o->segment[piece], k);
      ck_abs(o->interval[2 * piece], at, 0);
      ck_assert(o->interval[2 * piece + 1] > at);
      ck_assert(o->interval[2 * piece + 1] <= 1);
      for (size_t i = 0; i < 10; i++) {
        ck_assert(o->weights[10 * piece + i] > 0);
      }
    }
  }
  ck_assert_uint_eq(piece, o->n);
}

/* The four offsets of a PH curve, at many points; the sum of their pieces. */
static size_t ck_rational(double distance, double tol) {
  struct ph_offset offsets[ALL];
  size_t n = 0;
  offsets_of(distance, 1e-9, offsets);
  for (size_t i = 0; i < ALL; i++) {
    const struct ph_offset *o = &offsets[i];
    ck_pieces(o);
    n += o->n;
    for (size_t piece = 0; piece < o->n; piece++) {
      const double *part = o->interval + 2 * piece;
      for (size_t j = 0; j <= 8; j++) {
        double t = (double)j / 8, u = part[0] + t * (part[1] - part[0]);
        ph_vec3 wanted = unit_curve3_moved(&c.curve, o->segment[piece], u,
                                           o->distance, normal_of(o));
        double apart = unit_apart(rational(o, piece, t), wanted);
        ck_assert_msg(
            apart <= tol, "seed %lu, %s at %g, piece %zu at %g: %.3g > %.3g",
            unit_seed(), o->vector, o->distance, piece, t, apart, tol);
      }
    }
  }
  return n;
}

/* Segments whose frames join, both sides of both normals; no distance. */
PH_TEST(test_spline) {
  const double distances[] = {0.25, -1, 100, 1e-6, 0};
  struct unit_random r = unit_random_of(550);
  for (int i = 0; i < unit_count(20); i++) {
    double d = distances[i % 5];
    unit_curve3_random(&c, 3, false, 0.5, &r);
    ck_assert_uint_ge(ck_rational(d, 1e-14 * (20 + fabs(d))), 12);
    ph_arena_reset(&unit_arena);
  }
}

/* Segments that turn by any angle: the normals are as uncertain as A over |A|.
 */
PH_TEST(test_wild) {
  struct unit_random r = unit_random_of(551);
  for (int i = 0; i < unit_count(100); i++) {
    double d = unit_random_in(&r, 0.1, 2), slow = HUGE_VAL;
    unit_curve3_random(&c, 1, false, 9, &r);
    for (int k = 0; k <= 100; k++) {
      ph_quat a = unit_curve3_preimage(&c.curve, 0, 0.01 * k);
      slow = fmin(slow, ph_quat_dot(a, a));
    }
    ck_rational(d, 1e-14 * (200 + 200 * fabs(d) / slow));
    ph_arena_reset(&unit_arena);
  }
}

/* The slower a segment is somewhere, the more it is halved. */
PH_TEST(test_halved) {
  size_t before = 4;
  for (int e = 0; e <= 16; e++) {
    double near = ldexp(1, -e); /* A = u - 0.3 + near (j + k) */
    const ph_quat a[3] = {
        {-0.3, 0, near, near}, {0.2, 0, near, near}, {0.7, 0, near, near}};
    size_t n;
    unit_curve3_of(&c, 1, NULL, a, ph_vec3_of(0, 0, 0));
    n = ck_rational(0.5, 1e-14 * ldexp(1, e));
    ck_assert_uint_ge(n, before);
    ck_assert_uint_le(n, 4 * (size_t)(8 + 4 * e));
    before = n;
    ph_arena_reset(&unit_arena);
  }
  ck_assert_uint_ge(before, 32);
}

/* The weights are the speed, in the unit of the data. */
PH_TEST(test_weights) {
  struct unit_random r = unit_random_of(552);
  struct ph_offset offsets[ALL];
  unit_curve3_random(&c, 1, false, 0.5, &r);
  offsets_of(0.3, 1e-9, offsets);
  for (size_t i = 0; i < ALL; i++) {
    double sum = 0;
    for (size_t j = 0; j < 10; j++) {
      sum += offsets[i].weights[j] / 10;
    }
    ck_rel(sum, c.lengths[0], 1e-14);
  }
}

/* Where pieces and segments meet, the offset does not jump. */
PH_TEST(test_joints) {
  struct unit_random r = unit_random_of(553);
  for (int i = 0; i < unit_count(20); i++) {
    struct ph_offset offsets[ALL];
    unit_curve3_random(&c, 3, false, 1, &r);
    offsets_of(0.5, 1e-9, offsets);
    for (size_t j = 0; j < ALL; j++) {
      const double *p = offsets[j].control_points;
      for (size_t piece = 0; piece + 1 < offsets[j].n; piece++) {
        ck_assert_double_le(unit_apart(ph_vec3_get(p + 30 * piece + 27, 3),
                                       ph_vec3_get(p + 30 * piece + 30, 3)),
                            1e-13);
      }
    }
    ph_arena_reset(&unit_arena);
  }
}

/* A curve in the plane z = 0 is offset there along e2 as ph_offset does
 * it, and straight up along e3. */
PH_TEST(test_plane) {
  struct unit_random r = unit_random_of(554);
  ph_quat a[5];
  double preimage[12], control_points[24];
  struct ph_curve flat;
  struct ph_offset offsets[ALL], planar;
  for (size_t i = 0; i < 5; i++) {
    ph_cplx w = unit_random_cplx(&r, 0.5);
    a[i] = ph_quat_of(1 + w.re, 0, 0, w.im);
  }
  unit_curve3_of(&c, 2, NULL, a, ph_vec3_of(1, 2, 0));
  flat = c.curve;
  flat.dimension = 2;
  flat.preimage.v = preimage;
  flat.preimage.dimension = 2;
  flat.control_points = control_points;
  for (size_t i = 0; i < 6; i++) {
    preimage[2 * i] = c.preimage[4 * i];
    preimage[2 * i + 1] = c.preimage[4 * i + 3];
  }
  for (size_t i = 0; i < 12; i++) {
    memcpy(control_points + 2 * i, c.control_points + 3 * i,
           2 * sizeof(double));
  }
  offsets_of(0.4, 1e-9, offsets);
  ck_assert_int_eq(ph_offset(&flat, 0.4, &rules, &unit_arena, &planar, &diag),
                   PH_OK);
  ck_assert_ptr_null(planar.vector);
  ck_assert_uint_eq(planar.n, offsets[0].n);
  for (size_t i = 0; i < 10 * planar.n; i++) {
    ck_rel(offsets[0].control_points[3 * i], planar.control_points[2 * i],
           1e-15);
    ck_rel(offsets[0].control_points[3 * i + 1],
           planar.control_points[2 * i + 1], 1e-15);
    ck_abs(offsets[0].control_points[3 * i + 2], 0, 0);
    ck_abs(offsets[2].control_points[3 * i + 2], 0.4, 1e-15);
  }
}

/* ---- ATPH ---- */

/* The displacement: coefficients in the B-basis of the space, over those of the
 * speed. */
static ph_vec3 quotient(const struct ph_offset *o, size_t k, double u) {
  const double half = c.alpha[k] / 2, cosine = cos(half);
  const double s0 = sin(half * (1 - u)) / sin(half);
  const double s1 = sin(half * u) / sin(half);
  const double basis[5] = {pow(s0, 4), 4 * cosine * pow(s0, 3) * s1,
                           (4 * cosine * cosine + 2) * s0 * s0 * s1 * s1,
                           4 * cosine * s0 * pow(s1, 3), pow(s1, 4)};
  ph_vec3 sum = {0, 0, 0};
  double below = 0;
  for (size_t j = 0; j < 5; j++) {
    sum = ph_vec3_along(sum, basis[j],
                        ph_vec3_get(o->numerator + 15 * k + 3 * j, 3));
    below += basis[j] * o->denominator[5 * k + j];
  }
  return ph_vec3_scale(1 / below, sum);
}

static void ck_beziers(const struct ph_offset *o, double tolerance) {
  const struct ph_pieces *pieces = &o->pieces;
  ck_assert_double_le(pieces->error, tolerance);
  for (size_t i = 0; i < pieces->n; i++) {
    const double *part = pieces->interval + 2 * i;
    for (size_t j = 0; j <= 8; j++) {
      double t = (double)j / 8;
      ph_vec3 p = unit_bezier3(pieces->control_points + 18 * i, 5, 0, t);
      ph_vec3 wanted = unit_curve3_moved(&c.curve, pieces->segment[i],
                                         part[0] + t * (part[1] - part[0]),
                                         o->distance, normal_of(o));
      ck_assert_double_le(unit_apart(p, wanted), tolerance + 1e-13);
    }
  }
}

PH_TEST(test_atph) {
  struct unit_random r = unit_random_of(560);
  for (int i = 0; i < unit_count(10); i++) {
    struct ph_offset offsets[ALL];
    double d = unit_random_in(&r, 0.1, 1), tolerance = pow(10, -4 - i % 5);
    unit_curve3_random(&c, 3, true, 0.5, &r);
    offsets_of(d, tolerance, offsets);
    for (size_t j = 0; j < ALL; j++) {
      const struct ph_offset *o = &offsets[j];
      ck_assert_uint_eq(o->degree, 4);
      ck_assert_uint_eq(o->n, 3);
      ck_assert_ptr_null(o->weights);
      for (size_t k = 0; k < 3; k++) {
        ck_assert_uint_eq(o->segment[k], k);
        for (size_t m = 0; m <= 20; m++) {
          double u = (double)m / 20;
          ph_vec3 e[3];
          unit_curve3_frame(&c.curve, k, u, e);
          ck_assert_double_le(
              unit_apart(quotient(o, k, u),
                         ph_vec3_scale(o->distance,
                                       normal_of(o) == PH_E2 ? e[1] : e[2])),
              1e-14);
        }
      }
      ck_beziers(o, tolerance);
    }
    ph_arena_reset(&unit_arena);
  }
}

/* The quotient of a curve and of a distance of any size: both have terms that
 * alone are out of range. */
PH_TEST_EACH(test_atph_range, 5) {
  static const struct {
    int size, distance;
  } by[] = {
      {-1000, -1000}, {-900, -300}, {1000, 1000}, {-900, 900}, {-200, -900}};
  struct unit_random r = unit_random_of(561 + (unsigned long)_i);
  struct ph_offset offsets[ALL];
  ph_vec3 e[3];
  double d;
  unit_curve3_random(&c, 1, true, 0.3, &r);
  for (size_t i = 0; i < 12; i++) {
    c.preimage[i] = ldexp(c.preimage[i], by[_i].size / 2);
  }
  for (size_t i = 0; i < 18; i++) {
    c.control_points[i] = ldexp(c.control_points[i], by[_i].size);
  }
  d = ldexp(1, by[_i].distance);
  offsets_of(d, fmax(d, ldexp(1, by[_i].size)), offsets);
  for (size_t j = 0; j < ALL; j++) {
    const struct ph_offset *o = &offsets[j];
    for (size_t m = 0; m <= 20; m++) {
      double u = (double)m / 20;
      unit_curve3_frame(&c.curve, 0, u, e);
      ck_assert_double_le(
          unit_apart(ph_vec3_scale(1 / o->distance, quotient(o, 0, u)),
                     normal_of(o) == PH_E2 ? e[1] : e[2]),
          1e-14);
    }
  }
}

/* ---- what has no offset ---- */

PH_TEST_EACH(test_standstill, 3) {
  static const ph_quat a[][3] = {
      {{1, 0, 2, 0}, {0, 0, 0, 0}, {-1, 0, -2, 0}}, /* in the middle */
      {{0, 0, 0, 0}, {1, 0, 0, 1}, {1, 1, 0, 0}},   /* at an end */
      {{0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}}};
  struct ph_offset offsets[ALL];
  unit_curve3_of(&c, 1, NULL, a[_i], ph_vec3_of(0, 0, 0));
  ck_assert_int_eq(ph_offset(&c.curve, 1, &rules, &unit_arena, offsets, &diag),
                   PH_E_INFEASIBLE);
  ck_assert_str_eq(diag.field, "segments[0]");
}

PH_TEST(test_too_large) {
  const ph_quat a[3] = {{1, 0, 0, 0}, {1, 0, 0, 0}, {1, 0, 0, 0}};
  struct ph_offset offsets[ALL];
  unit_curve3_of(&c, 1, NULL, a, ph_vec3_of(0, 1.5e308, 0));
  ck_assert_int_eq(
      ph_offset(&c.curve, 1e308, &rules, &unit_arena, offsets, &diag),
      PH_E_TOO_LARGE);
  ck_assert_str_eq(diag.message, "the offset at distance 1e+308 exceeds the "
                                 "range of a double");
}
