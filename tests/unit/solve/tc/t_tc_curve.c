/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Curves put together from fits of intervals: ends, joints, lengths, intervals
 * and diagnostics, by fits whose legs are known by hand.
 */
#include "tc_unit.h"

#include "solve/tc/tc.h"

/* The chords are 3 + 4i and 12i, and of the lengths 5 and 12. */
enum { POINTS_MAX = 3 };

struct built {
  struct ph_tc_data data;
  struct ph_curve curve;
  struct ph_tc_builder builder;
  struct ph_diagnostics diagnostics;
  double points[2 * POINTS_MAX];
};

static void begin(struct built *b, const char *mode, size_t n, double scale) {
  static const double POINT[] = {0.1, 0.7, 3.1, 4.7, 3.1, 16.7};
  double vectors[] = {1, 0, 1, 0, 1, 0};
  const struct given given[GIVEN_MAX] = {
      {PH_F_MODE, WORD(mode)},
      {PH_F_POINTS,
       {.kind = PH_VECTORS, .v = b->points, .n = n, .dimension = 2}},
      {PH_F_TANGENTS,
       {.kind = strcmp(mode, "spline") == 0 ? PH_ABSENT : PH_VECTORS,
        .v = vectors,
        .n = n,
        .dimension = 2}}};
  struct ph_diag diag;
  memset(b, 0, sizeof *b);
  for (size_t i = 0; i < 2 * n; i++) {
    b->points[i] = scale * POINT[i];
  }
  b->data = unit_tc_given(given);
  ck_assert_int_eq(
      ph_tc_build_begin(&b->builder, &b->data, &unit_arena, &b->curve, &diag),
      PH_OK);
}

static void end(struct built *b) {
  ph_tc_build_end(&b->builder, &b->diagnostics);
}

static struct ph_tc_fit fit_of(size_t n, ph_cplx w0, ph_cplx z, ph_cplx w2) {
  struct ph_tc_fit fit =
      ph_tc_fit_of(n, n == 1 ? PH_ROOT_MINUS : PH_ROOT_PLUS_MINUS);
  fit.tc[0] = (struct ph_tc){{w0, z}};
  fit.tc[1] = (struct ph_tc){{z, w2}};
  return fit;
}

/* w = 1: the straight line. */
static struct ph_tc_fit line(void) {
  const ph_cplx one = {1, 0};
  struct ph_tc_fit fit = fit_of(1, one, one, one);
  fit.ratio = -0.5;
  return fit;
}

/* w goes from 1 to 1 + i to 2: the legs are (1 + (1 + i) + 2i)/3 = 2/3 + i and
 * (2i + 2 + 2i + 4)/3 = 2 + 4i/3, the lengths (1 + 1 + 2)/3 = 4/3 and (2 + 2 +
 * 4)/3 = 8/3: together 8/3 + 7i/3, which misses 1 by 5/3 + 7i/3, and 4. */
static struct ph_tc_fit bent(void) {
  struct ph_tc_fit fit =
      fit_of(2, ph_cplx_of(1, 0), ph_cplx_of(1, 1), ph_cplx_of(2, 0));
  fit.lambda = 0.75;
  return fit;
}

/* The joint is at 2/3 + i - (5/3 + 7i/3)/3 = 1/9 + 2i/9, times 3 + 4i. */
static const ph_cplx BENT_JOINT = {-5.0 / 9, 10.0 / 9};
static const double BENT_MISS = 0.7168604389202189; /* sqrt(74)/12 */

static void ck_point(const double *p, double x, double y, double scale) {
  ck_abs(p[0] / scale, x, 16 * DBL_EPSILON);
  ck_abs(p[1] / scale, y, 16 * DBL_EPSILON);
}

/* w w of the preimage, in the unit of the data. */
static void ck_hodograph(const double *w, double x, double y, double scale) {
  double a = w[0] / sqrt(scale), b = w[1] / sqrt(scale);
  ck_abs(a * a - b * b, x, 64 * DBL_EPSILON);
  ck_abs(2 * a * b, y, 64 * DBL_EPSILON);
}

/* ---- one interval -------------------------------------------------------- */

static const double SCALES[] = {1e-300, 1, 1e300};

/* Legs of 1/3 of the first and the last derivative; the rest is between. */
PH_TEST_EACH(test_one, 3) {
  const double scale = SCALES[_i];
  const struct ph_tc_fit fit = line();
  struct built b;
  begin(&b, "g1", 2, scale);
  ck_assert_uint_eq(b.curve.n, 0);
  ph_tc_build_add(&b.builder, &fit);
  end(&b);
  ck_assert_int_eq(b.curve.kind, PH_CURVE_TC);
  ck_assert_uint_eq(b.curve.dimension, 2);
  ck_assert_uint_eq(b.curve.degree, 3);
  ck_assert_uint_eq(b.curve.n, 1);
  ck_assert_uint_eq(b.curve.preimage.n, 2);
  ck_assert_uint_eq(b.curve.preimage.dimension, 2);
  ck_assert(!b.curve.closed);
  for (size_t j = 0; j < 2; j++) {
    ck_rel(b.curve.control_points[j], b.points[j], 0);
    ck_rel(b.curve.control_points[6 + j], b.points[2 + j], 0);
  }
  ck_point(b.curve.control_points + 2, 1.1, 0.7 + 4.0 / 3, scale);
  ck_point(b.curve.control_points + 4, 2.1, 4.7 - 4.0 / 3, scale);
  ck_hodograph(b.curve.preimage.v, 3, 4, scale);
  ck_hodograph(b.curve.preimage.v + 2, 3, 4, scale);
  ck_rel(b.curve.knots[0], 0, 0);
  ck_rel(b.curve.knots[1], 1, 0);
  ck_rel(b.curve.lengths[0] / scale, 5, 4 * DBL_EPSILON);
  ck_rel(b.curve.length, b.curve.lengths[0], 0);
}

PH_TEST_EACH(test_two, 3) {
  const double scale = SCALES[_i];
  const struct ph_tc_fit fit = bent();
  struct built b;
  const double *p, *w;
  begin(&b, "g1-pair", 2, scale);
  ph_tc_build_add(&b.builder, &fit);
  end(&b);
  p = b.curve.control_points;
  w = b.curve.preimage.v;
  ck_assert_uint_eq(b.curve.n, 2);
  for (size_t j = 0; j < 2; j++) {
    ck_rel(p[j], b.points[j], 0);
    ck_rel(p[12 + j], b.points[2 + j], 0);
    ck_rel(w[2 + j], w[4 + j], 0);
  }
  ck_point(p + 6, 0.1 + BENT_JOINT.re, 0.7 + BENT_JOINT.im, scale);
  /* derivatives (3 + 4i) {1, 2i, 4}, a third of them before and after */
  ck_point(p + 2, 1.1, 0.7 + 4.0 / 3, scale);
  ck_point(p + 4, 0.1 + BENT_JOINT.re + 8.0 / 3, 0.7 + BENT_JOINT.im - 2,
           scale);
  ck_point(p + 8, 0.1 + BENT_JOINT.re - 8.0 / 3, 0.7 + BENT_JOINT.im + 2,
           scale);
  ck_point(p + 10, 3.1 - 4, 4.7 - 16.0 / 3, scale);
  ck_hodograph(w, 3, 4, scale);
  ck_hodograph(w + 2, -8, 6, scale);
  ck_hodograph(w + 6, 12, 16, scale);
  ck_rel(b.curve.lengths[0] / scale, 20.0 / 3, 4 * DBL_EPSILON);
  ck_rel(b.curve.lengths[1] / scale, 40.0 / 3, 4 * DBL_EPSILON);
  ck_rel(b.curve.length / scale, 20, 4 * DBL_EPSILON);
  ck_rel(b.builder.intervals[0].length, b.curve.length, 0);
  ck_rel(b.builder.residual, BENT_MISS, 4 * DBL_EPSILON);
}

/* ---- diagnostics --------------------------------------------------------- */

static uint64_t bit(enum ph_diagnostic which) {
  return (uint64_t)1 << which;
}

static const uint64_t ALWAYS =
    (uint64_t)1 << PH_D_ITERATIONS | (uint64_t)1 << PH_D_RESIDUAL;

/* One interval tells what is known of its fit, and nothing else. */
PH_TEST_EACH(test_diagnostics_one, 3) {
  struct ph_tc_fit fits[] = {line(), bent(), bent()};
  const double *value;
  struct built b;
  fits[2].lambda = (double)NAN;
  begin(&b, _i == 0 ? "g1" : "g1-pair", 2, 1);
  ph_tc_build_add(&b.builder, &fits[_i]);
  end(&b);
  value = b.diagnostics.value;
  ck_assert(b.diagnostics.known == (ALWAYS | bit(PH_D_ROOT) |
                                    (_i == 0   ? bit(PH_D_RATIO)
                                     : _i == 1 ? bit(PH_D_LAMBDA)
                                               : 0)));
  ck_rel(value[PH_D_ITERATIONS], 0, 0);
  ck_rel(value[PH_D_RESIDUAL], _i == 0 ? 0 : BENT_MISS, 4 * DBL_EPSILON);
  ck_rel(value[PH_D_ROOT], _i == 0 ? PH_ROOT_MINUS : PH_ROOT_PLUS_MINUS, 0);
  ck_rel(value[PH_D_RATIO], _i == 0 ? -0.5 : 0, 0);
  ck_rel(value[PH_D_LAMBDA], _i == 1 ? 0.75 : 0, 0);
}

/* A lambda of the whole problem is told of any number of intervals. */
PH_TEST_EACH(test_diagnostics_spline, 2) {
  struct ph_tc_fit fit = bent();
  struct built b;
  fit.lambda = (double)NAN;
  begin(&b, "spline", _i == 0 ? 2 : 3, 1);
  for (size_t k = 0; k < b.data.n; k++) {
    ph_tc_build_add(&b.builder, &fit);
  }
  end(&b);
  ck_assert(b.diagnostics.known ==
            (ALWAYS | bit(PH_D_LAMBDA) | (_i == 0 ? bit(PH_D_ROOT) : 0)));
  ck_rel(b.diagnostics.value[PH_D_LAMBDA], 0.5, 0);
}

/* ---- several intervals --------------------------------------------------- */

/* One cubic and two, in either order: where they are, what they are, and that
 * the largest misfit is kept. */
PH_TEST_EACH(test_several, 2) {
  struct ph_tc_fit one = line(), two = bent();
  const struct ph_interval *interval;
  struct built b;
  two.root = PH_ROOT_ON_CHORD;
  two.lambda = (double)NAN;
  two.joint_angle = 1.25;
  two.joint_position = 0.375;
  begin(&b, "g1-auto", 3, 1);
  ph_tc_build_add(&b.builder, _i == 0 ? &one : &two);
  ph_tc_build_add(&b.builder, _i == 0 ? &two : &one);
  end(&b);
  ck_assert_uint_eq(b.builder.done, 2);
  ck_assert_uint_eq(b.curve.n, 3);
  for (size_t k = 0; k < 4; k++) {
    ck_rel(b.curve.knots[k], (double)k, 0);
  }
  for (size_t k = 0; k < 2; k++) { /* ends of intervals to the last bit */
    const struct ph_interval *at = &b.builder.intervals[k];
    const double *p = ph_curve_points(&b.curve, at->first);
    const double *q = ph_curve_points(&b.curve, at->last);
    for (size_t j = 0; j < 2; j++) {
      ck_rel(p[j], b.points[2 * k + j], 0);
      ck_rel(q[6 + j], b.points[2 * k + 2 + j], 0);
    }
  }
  interval = &b.builder.intervals[_i];
  ck_assert_uint_eq(interval->first, _i == 0 ? 0 : 2);
  ck_assert_uint_eq(interval->last, interval->first);
  ck_rel(interval->length, _i == 0 ? 5 : 12, 4 * DBL_EPSILON);
  ck_assert_int_eq(interval->root, PH_ROOT_MINUS);
  ck_rel(interval->ratio, -0.5, 0);
  ck_assert(isnan(interval->joint_angle) && isnan(interval->joint_position));
  ck_assert(isnan(interval->lambda) && isnan(interval->natural_length));
  interval = &b.builder.intervals[1 - _i];
  ck_assert_uint_eq(interval->first, _i == 0 ? 1 : 0);
  ck_assert_uint_eq(interval->last, interval->first + 1);
  ck_rel(interval->length, 4 * (_i == 0 ? 12 : 5), 4 * DBL_EPSILON);
  ck_assert_int_eq(interval->root, PH_ROOT_ON_CHORD);
  ck_rel(interval->joint_angle, 1.25, 0);
  ck_rel(interval->joint_position, 0.375, 0);
  ck_assert(isnan(interval->ratio) && isnan(interval->lambda));
  ck_rel(b.curve.length, _i == 0 ? 53 : 32, 4 * DBL_EPSILON);
  ck_rel(b.diagnostics.value[PH_D_RESIDUAL], BENT_MISS, 4 * DBL_EPSILON);
  ck_assert(b.diagnostics.known == ALWAYS);
}

/* The last interval of closed data ends in the first point, to the last bit,
 * though the repeated last point is another one. */
PH_TEST(test_closed) {
  const struct given given[GIVEN_MAX] = {
      {PH_F_POINTS, VECTORS(2, 0.1, 0.7, 3, 4, 1, 5, 0.1, 0.7 + DBL_EPSILON)},
      CLOSED};
  struct ph_tc_fit fit = bent();
  struct built b = {0};
  struct ph_diag diag;
  b.data = unit_tc_given(given);
  ck_assert_int_eq(
      ph_tc_build_begin(&b.builder, &b.data, &unit_arena, &b.curve, &diag),
      PH_OK);
  for (size_t k = 0; k < 3; k++) {
    ph_tc_build_add(&b.builder, &fit);
  }
  ck_assert(b.curve.closed);
  ck_assert_uint_eq(b.curve.n, 6);
  ck_rel(b.curve.control_points[36], 0.1, 0);
  ck_rel(b.curve.control_points[37], 0.7, 0);
}
