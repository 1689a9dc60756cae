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

static struct unit_solution one;
static struct spatial_data data;

static void finish(void) {
  unit_solution_free(&one);
}

static ph_vec3 leg_of(const struct ph_curve *curve, size_t k, size_t i) {
  return ph_vec3_sub(spatial_point(curve, k, i + 1),
                     spatial_point(curve, k, i));
}

/* What unit tangents may differ by, and derivatives, relative. */
static const double TANGENT = 1e-12;

/* The tangent, or the derivative, at one side of segment k is the given one. */
static void ck_vector(const struct spatial_data *d,
                      const struct ph_curve *curve, size_t k, size_t side) {
  ph_vec3 leg = leg_of(curve, k, 4 * side);
  ph_vec3 given = d->vector[(k + side) % d->n];
  double size = ph_vec3_abs(leg), error = 4 * spatial_rounding(curve, k) / size;
  double away = unit_apart(ph_vec3_unit(leg), ph_vec3_unit(given));
  if (!(error < 1)) {
    return; /* a leg that vanishes beside its coordinates */
  }
  ck_that(away <= TANGENT + error, "segment %zu, side %zu: tangent %.3g away",
          k, side, away);
  if (d->given == SPATIAL_DERIVATIVES) {
    double angle = d->atph ? curve->preimage.alpha[k] : 1;
    struct ph_atph space = ph_atph_of(d->atph ? angle : 0);
    double wanted = ph_vec3_abs(given) * angle * space.q[0];
    double s = curve->choice.tension[k];
    wanted *= s * s;
    ck_that(fabs(size - wanted) <= (TANGENT + error) * wanted,
            "segment %zu, side %zu: derivative %.17g, wanted %.17g", k, side,
            size, wanted);
  }
}

static ph_quat preimage_of(const struct ph_curve *curve, size_t k, size_t i) {
  const double *a = curve->preimage.v + 12 * k + 4 * i;
  ph_quat q = ph_quat_of(a[0], a[1], a[2], a[3]);
  return ph_quat_scale(1 / ph_quat_abs(q), q);
}

/* Tangent and Euler-Rodrigues frame go on from segment k - 1 to k. */
static void ck_joint(const struct ph_curve *curve, size_t k) {
  ph_quat before = preimage_of(curve, k - 1, 2),
          after = preimage_of(curve, k, 0);
  double e1 = unit_apart(ph_quat_i(before, before), ph_quat_i(after, after));
  double e3 = unit_apart(ph_quat_k(before, before), ph_quat_k(after, after));
  ck_that(e1 <= TANGENT && e3 <= TANGENT,
          "before segment %zu: e1 jumps by %.3g, e3 by %.3g", k, e1, e3);
}

/* What a record says of segment k is in its range. */
static void ck_numbers(const struct spatial_data *d,
                       const struct ph_curve *curve, size_t k) {
  double first = d->has_tension ? d->tension[k] : 1;
  bool keep = d->shape ? strcmp(d->shape, "true") != 0
                       : d->given == SPATIAL_DERIVATIVES;
  double chord = ph_vec3_abs(spatial_chord(d, k));
  double least = keep ? first : first / 64;
  ck_that(curve->choice.tension[k] >= least &&
              curve->choice.tension[k] <= first,
          "segment %zu: tension %.17g", k, curve->choice.tension[k]);
  ck_that(curve->choice.tension[k] >= first || curve->choice.shape_ok[k],
          "segment %zu: tension reduced to %.17g for nothing", k,
          curve->choice.tension[k]);
  ck_that(curve->lengths[k] >= chord * (1 - 1e-14),
          "segment %zu: length %.17g, chord %.17g", k, curve->lengths[k],
          chord);
}

static void ck_curve(const struct spatial_data *d,
                     const struct ph_curve *curve) {
  ck_assert_uint_eq(curve->n, spatial_segments(d));
  for (size_t k = 0; k < curve->n; k++) {
    ph_vec3 from = spatial_point(curve, k, 0), to = spatial_point(curve, k, 5);
    double away = unit_larger(unit_apart(from, d->point[k]),
                              unit_apart(to, d->point[(k + 1) % d->n]));
    ck_that(away <= 0, "segment %zu: %.3g from its points", k, away);
    ck_numbers(d, curve, k);
    for (size_t side = 0; side < 2 && d->given != SPATIAL_POINTS; side++) {
      ck_vector(d, curve, k, side);
    }
    if (k > 0) {
      ck_joint(curve, k);
    }
  }
}

/* All fields, all families. */
PH_TEST(test_answers) {
  struct unit_random r = unit_random_of(1);
  size_t n = unit_cases(200);
  for (size_t i = 0; i < SPATIAL_FAMILY_N * n; i++) {
    spatial_of(&r, (enum spatial_family)(i / n),
               i % 16 ? 6 : SPATIAL_POINTS_MAX, &data);
    if (spatial_answer(&data, i, &one)) {
      ck_curve(&data, &one.result.curve);
    }
  }
}

/* Tensions so small that legs of the control polygon vanish beside their
 * coordinates. */
PH_TEST(test_tight) {
  struct unit_random r = unit_random_of(16);
  for (size_t i = 0; i < unit_cases(200); i++) {
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

/* The functionals, which take a thousand times as long. */
PH_TEST(test_functionals) {
  static const char *const names[] = {"F1", "F2", "F3"};
  struct unit_random r = unit_random_of(2);
  for (size_t i = 0; i < unit_cases(42); i++) {
    spatial_of(&r, (enum spatial_family)(i % SPATIAL_FAMILY_N), 3, &data);
    data.has_angles = false;
    data.criterion = names[i % 3];
    data.shape = "false";
    if (spatial_answer(&data, i, &one)) {
      ck_curve(&data, &one.result.curve);
    }
  }
}

/* Plane data have a plane curve; what is zero stays so. */
PH_TEST(test_flat) {
  struct unit_random r = unit_random_of(15);
  for (size_t i = 0; i < unit_cases(600); i++) {
    spatial_of(&r, SPATIAL_FLAT, 6, &data);
    data.has_angles = false;
    data.criterion = i % 2 ? "cc" : "hc";
    spatial_answer(&data, i, &one);
    for (size_t k = 0; k < 6 * one.result.curve.n; k++) {
      double z = spatial_point(&one.result.curve, 0, k).z;
      ck_that(unit_same(z, 0), "z = %.3g", z);
    }
  }
}

PH_FIXTURE(NULL, finish)
