/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * What every spatial Hermite interpolant keeps, on random data of all families:
 * it is certified, or refused for a reason that the data have; meets its points
 * and vectors; its frame goes on from segment to segment.
 *
 * The seed is 1, or PH_SEED; PH_LONG=1 takes ten times as many data.
 */
#include "spatial_data.h"
#include "spatial_unit.h"
#include "unit.h"

#include "kernel/atph.h"
#include "kernel/quat.h"

#include <string.h>

static struct spatial_solution one;
static struct spatial_data data;

static void finish(void) {
  spatial_free(&one);
}

static size_t cases(int n) {
  return (size_t)(unit_long() ? 10 * n : unit_count(n));
}

static ph_vec3 leg_of(const struct ph_curve *curve, size_t k, size_t i) {
  return ph_vec3_sub(spatial_point(curve, k, i + 1),
                     spatial_point(curve, k, i));
}

static double apart(ph_vec3 a, ph_vec3 b) {
  return ph_vec3_abs(ph_vec3_sub(a, b));
}

/* What unit tangents may differ by, and derivatives, relative. */
static const double TANGENT = 1e-12;

/* The tangent, or the derivative, at one side of segment k is the given one. */
static void ck_vector(const struct spatial_data *d, size_t which,
                      const struct ph_curve *curve, size_t k, size_t side) {
  ph_vec3 leg = leg_of(curve, k, 4 * side);
  ph_vec3 given = d->vector[(k + side) % d->n];
  double size = ph_vec3_abs(leg), error = 4 * spatial_rounding(curve, k) / size;
  double away = apart(ph_vec3_unit(leg), ph_vec3_unit(given));
  if (!(error < 1)) {
    return; /* a leg that vanishes beside its coordinates */
  }
  spatial_assert(away <= TANGENT + error, which, d,
                 "segment %zu, side %zu: tangent %.3g away", k, side, away);
  if (d->given == SPATIAL_DERIVATIVES) {
    double angle = d->atph ? curve->preimage.alpha[k] : 1;
    struct ph_atph space = ph_atph_of(d->atph ? angle : 0);
    double wanted = ph_vec3_abs(given) * angle * space.q[0];
    double s = curve->choice.tension[k];
    wanted *= s * s;
    spatial_assert(fabs(size - wanted) <= (TANGENT + error) * wanted, which, d,
                   "segment %zu, side %zu: derivative %.17g, wanted %.17g", k,
                   side, size, wanted);
  }
}

static ph_quat preimage_of(const struct ph_curve *curve, size_t k, size_t i) {
  const double *a = curve->preimage.v + 12 * k + 4 * i;
  ph_quat q = ph_quat_of(a[0], a[1], a[2], a[3]);
  return ph_quat_scale(1 / ph_quat_abs(q), q);
}

/* Tangent and Euler-Rodrigues frame go on from segment k - 1 to k. */
static void ck_joint(const struct spatial_data *d, size_t which,
                     const struct ph_curve *curve, size_t k) {
  ph_quat before = preimage_of(curve, k - 1, 2),
          after = preimage_of(curve, k, 0);
  double e1 = apart(ph_quat_i(before, before), ph_quat_i(after, after));
  double e3 = apart(ph_quat_k(before, before), ph_quat_k(after, after));
  spatial_assert(e1 <= TANGENT && e3 <= TANGENT, which, d,
                 "before segment %zu: e1 jumps by %.3g, e3 by %.3g", k, e1, e3);
}

/* What a record says of segment k is in its range. */
static void ck_numbers(const struct spatial_data *d, size_t which,
                       const struct ph_curve *curve, size_t k) {
  double first = d->has_tension ? d->tension[k] : 1;
  bool keep = d->shape ? strcmp(d->shape, "true") != 0
                       : d->given == SPATIAL_DERIVATIVES;
  double chord = ph_vec3_abs(spatial_chord(d, k));
  double least = keep ? first : first / 64;
  spatial_assert(
      curve->choice.tension[k] >= least && curve->choice.tension[k] <= first,
      which, d, "segment %zu: tension %.17g", k, curve->choice.tension[k]);
  spatial_assert(curve->choice.tension[k] >= first || curve->choice.shape_ok[k],
                 which, d, "segment %zu: tension reduced to %.17g for nothing",
                 k, curve->choice.tension[k]);
  spatial_assert(curve->lengths[k] >= chord * (1 - 1e-14), which, d,
                 "segment %zu: length %.17g, chord %.17g", k, curve->lengths[k],
                 chord);
}

static void ck_curve(const struct spatial_data *d, size_t which,
                     const struct ph_curve *curve) {
  ck_assert_uint_eq(curve->n, spatial_segments(d));
  for (size_t k = 0; k < curve->n; k++) {
    ph_vec3 from = spatial_point(curve, k, 0), to = spatial_point(curve, k, 5);
    double away = unit_larger(apart(from, d->point[k]),
                              apart(to, d->point[(k + 1) % d->n]));
    spatial_assert(away <= 0, which, d, "segment %zu: %.3g from its points", k,
                   away);
    ck_numbers(d, which, curve, k);
    for (size_t side = 0; side < 2 && d->given != SPATIAL_POINTS; side++) {
      ck_vector(d, which, curve, k, side);
    }
    if (k > 0) {
      ck_joint(d, which, curve, k);
    }
  }
}

/* All fields, all families. */
START_TEST(test_answers) {
  struct unit_random r = unit_random_of(1);
  size_t n = cases(200);
  for (size_t i = 0; i < SPATIAL_FAMILY_N * n; i++) {
    spatial_of(&r, (enum spatial_family)(i / n),
               i % 16 ? 6 : SPATIAL_POINTS_MAX, &data);
    if (spatial_answer(&data, i, &one)) {
      ck_curve(&data, i, &one.result.curve);
    }
  }
}
END_TEST

/* Tensions so small that legs of the control polygon vanish beside their
 * coordinates. */
START_TEST(test_tight) {
  struct unit_random r = unit_random_of(16);
  for (size_t i = 0; i < cases(200); i++) {
    spatial_of(&r, SPATIAL_NEAR, 6, &data);
    data.given = SPATIAL_TANGENTS;
    data.has_tension = true;
    for (size_t k = 0; k < spatial_segments(&data); k++) {
      data.tension[k] = pow(10, unit_random_in(&r, -5, 0));
    }
    if (spatial_answer(&data, i, &one)) {
      ck_assert_uint_eq(one.result.curve.n, spatial_segments(&data));
    }
  }
}
END_TEST

/* The functionals, which take a thousand times as long. */
START_TEST(test_functionals) {
  static const char *const names[] = {"F1", "F2", "F3"};
  struct unit_random r = unit_random_of(2);
  for (size_t i = 0; i < cases(42); i++) {
    spatial_of(&r, (enum spatial_family)(i % SPATIAL_FAMILY_N), 3, &data);
    data.has_angles = false;
    data.criterion = names[i % 3];
    data.shape = "false";
    if (spatial_answer(&data, i, &one)) {
      ck_curve(&data, i, &one.result.curve);
    }
  }
}
END_TEST

/* Plane data have a plane curve; what is zero stays so. */
START_TEST(test_flat) {
  struct unit_random r = unit_random_of(15);
  for (size_t i = 0; i < cases(600); i++) {
    spatial_of(&r, SPATIAL_FLAT, 6, &data);
    data.has_angles = false;
    data.criterion = i % 2 ? "cc" : "hc";
    spatial_answer(&data, i, &one);
    for (size_t k = 0; k < 6 * one.result.curve.n; k++) {
      double z = spatial_point(&one.result.curve, 0, k).z;
      spatial_assert(unit_same(z, 0), i, &data, "z = %.3g", z);
    }
  }
}
END_TEST

/* ---- plane data in digits ------------------------------------------------ */

enum { CROOKED_N = 8 };

/* Plane data with what makes frames uncertain: steps of a grid, zigzags, given
 * tangents that are parallel or opposite, or any. */
static void crooked(struct unit_random *r, struct spatial_data *d) {
  bool zigzag = unit_random_below(r, 2), grid = unit_random_below(r, 2);
  double x = 0, y = 0;
  spatial_points(r, SPATIAL_FLAT, CROOKED_N, false, d);
  d->given = unit_random_below(r, 2) ? SPATIAL_TANGENTS : SPATIAL_POINTS;
  for (size_t k = 0; k < d->n && (zigzag || grid); k++) {
    d->point[k] = ph_vec3_of(x, zigzag ? (double)(k % 2) : y, 0);
    x += zigzag ? 1 : (double)(1 + unit_random_below(r, 3));
    y += (double)unit_random_below(r, 3) - 1;
  }
  for (size_t k = 0; k < d->n && grid; k++) {
    double angle = 0.3 + 1.5707963267948966 * (double)unit_random_below(r, 4);
    d->vector[k] = ph_vec3_of(cos(angle), sin(angle), 0);
  }
}

static double in_digits(double x, double unit) {
  return nearbyint(x / unit) * unit;
}

static ph_vec3 vector_in_digits(ph_vec3 v, double unit) {
  return ph_vec3_of(in_digits(v.x, unit), in_digits(v.y, unit),
                    in_digits(v.z, unit));
}

/* Turns data, writes them in digits, and scales them; tangents may be of any
 * length, so that opposite ones are not rounded alike. */
static ph_vec3 turn_in_digits(struct unit_random *r, double unit, double scale,
                              struct spatial_data *d) {
  ph_quat q = unit_random_turn(r);
  for (size_t k = 0; k < d->n; k++) {
    ph_vec3 p = d->point[k], t = d->vector[k];
    double size = unit_random_in(r, 1, 2);
    p = ph_vec3_along(ph_vec3_scale(p.x, ph_quat_i(q, q)), p.y,
                      ph_quat_j(q, q));
    t = ph_vec3_along(ph_vec3_scale(t.x, ph_quat_i(q, q)), t.y,
                      ph_quat_j(q, q));
    d->point[k] = ph_vec3_scale(scale, vector_in_digits(p, unit));
    d->vector[k] = vector_in_digits(ph_vec3_scale(size, t), unit);
  }
  return ph_quat_k(q, q);
}

/* How far the curve leaves the plane through its first point, in units of the
 * last digit of the data, and of the size of its segments where that is more.
 */
static double digits_away(const struct ph_curve *curve, ph_vec3 normal,
                          double unit, double scale) {
  double most = 0;
  for (size_t k = 0; k < curve->n; k++) {
    double size = unit_larger(spatial_segment_size(curve, k), scale);
    for (size_t i = 1; i < 5; i++) {
      ph_vec3 v =
          ph_vec3_sub(spatial_point(curve, k, i), spatial_point(curve, k, 0));
      double away = fabs(ph_vec3_dot(v, normal));
      most = unit_larger(most, away / (unit * size));
    }
  }
  return most;
}

/* Plane data that were written with 6 to 12 digits have curves in their plane:
 * where two directions differ by rounding alone, their cross product has none.
 */
static void ck_digits(struct unit_random *r, size_t which,
                      const char *criterion) {
  double unit = pow(10, -6 - (double)unit_random_below(r, 7));
  double scale = pow(10, 3 * (double)unit_random_below(r, 7) - 9), away;
  ph_vec3 normal;
  crooked(r, &data);
  data.criterion = criterion;
  data.atph = unit_random_below(r, 2);
  for (size_t k = 0; k < data.n; k++) {
    data.alpha[k] = 1.2;
  }
  data.n = criterion[0] == 'F' ? 3 : data.n;
  normal = turn_in_digits(r, unit, scale, &data);
  if (spatial_answer(&data, which, &one)) {
    away = digits_away(&one.result.curve, normal, unit, scale);
    spatial_assert(away <= 50, which, &data, "%s: %.3g units of %.0e away",
                   criterion, away, unit);
  }
}

START_TEST(test_digits) {
  static const char *const names[] = {"cc", "hc", "bv", "F1", "F2", "F3"};
  struct unit_random r = unit_random_of(17);
  for (size_t i = 0; i < cases(2000); i++) {
    ck_digits(&r, i, names[i % 3]);
  }
  for (size_t i = 0; i < cases(60); i++) {
    ck_digits(&r, i, names[3 + i % 3]);
  }
}
END_TEST

static Suite *suite(void) {
  Suite *s = suite_create("spatial curves");
  TCase *tc = tcase_create("spatial curves");
  tcase_add_checked_fixture(tc, NULL, finish);
  tcase_set_timeout(tc, 600);
  tcase_add_test(tc, test_answers);
  tcase_add_test(tc, test_tight);
  tcase_add_test(tc, test_functionals);
  tcase_add_test(tc, test_flat);
  tcase_add_test(tc, test_digits);
  suite_add_tcase(s, tc);
  return s;
}

PH_TEST_MAIN(suite)
