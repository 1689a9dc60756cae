/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The certificate of curves with prescribed arc lengths: it accepts what is
 * right, and whatever is changed in a curve that it has accepted, it notices,
 * names and measures.
 *
 * A spline is built from its preimage A(t) = a + t b, whose functional F is 0:
 * all its data are those of a solution, whatever the mode, the spacing and the
 * segments for each interval are.
 */
#include "unit.h"
#include "check_unit.h"
#include "problem_unit.h"

#include "curve/segment/seg3.h"

enum { INTERVALS = 4, REFINE_MAX = 3, SEGMENTS = INTERVALS * REFINE_MAX };

static const double KNOTS[INTERVALS + 1] = {0, 0.75, 2.25, 3, 4};
static const ph_quat A = {1, 0.25, -0.5, 0.125}, B = {-0.25, 0.125, 0.5, 0.25};
static const double START[3] = {1, -2, 0.5};

/* Moved by this. */
static const double MOVED = 1e-9;

static const enum ph_diagnostic ERRORS[] = {
    PH_D_INTERPOLATION_ERROR, PH_D_PYTHAGOREAN_ERROR, PH_D_CONTINUITY_ERROR,
    PH_D_LENGTH_ERROR, PH_D_MIN_SPEED};
enum { ERRORS_N = COUNT(ERRORS) };
enum mode { POINTS, RELAXED, DERIVATIVES, TANGENTS, MODES };
/* A problem and its curve. */
static struct {
  struct ph_problem problem;
  struct ph_curve curve;
  double data[3 * (INTERVALS + 1)], lengths[INTERVALS], start[3];
  double knots[SEGMENTS + 1], control_points[18 * SEGMENTS];
  double preimage[12 * SEGMENTS], segment_lengths[SEGMENTS];
} u;

/* ---- curves ---------------------------------------------------------- */

static ph_quat preimage_at(ph_quat a, ph_quat b, double t) {
  return ph_quat_add(a, ph_quat_scale(t, b));
}

static void put(ph_vec3 x, double *v) {
  ph_vec3_put(x, 3, v);
}

/* Segment k, from t0 to t1; returns its end. */
static ph_vec3 build_segment(size_t k, ph_quat a, ph_quat b, double t0,
                             double t1, ph_vec3 start) {
  struct ph_atph space = ph_atph_of(0);
  ph_quat w[3];
  ph_vec3 p[6], end = start;
  for (size_t i = 0; i < 3; i++) {
    w[i] = ph_quat_scale(sqrt(t1 - t0),
                         preimage_at(a, b, t0 + (double)i * (t1 - t0) / 2));
    memcpy(u.preimage + 12 * k + 4 * i, &w[i], sizeof w[i]);
  }
  ph_seg3_control_points(&space, w, start, start, p);
  end = ph_vec3_add(p[2], ph_vec3_sub(start, p[3]));
  end = ph_vec3_along(end, 1.0 / 15, ph_quat_i(w[0], w[2]));
  end = ph_vec3_along(end, 2.0 / 15, ph_quat_i(w[1], w[1]));
  ph_seg3_control_points(&space, w, start, end, p);
  for (size_t i = 0; i < 6; i++) {
    put(p[i], u.control_points + 18 * k + 3 * i);
  }
  u.segment_lengths[k] = ph_seg3_length(&space, w);
  u.knots[k] = t0;
  u.knots[k + 1] = t1;
  return end;
}

/* The datum j of a curve that has been built that far. */
static void set_datum(enum mode mode, size_t j, ph_vec3 point, ph_quat a) {
  ph_vec3 derivative = ph_quat_i(a, a);
  ph_quat unit = ph_quat_scale(1 / ph_quat_abs(a), a);
  put(mode == DERIVATIVES ? derivative
      : mode == TANGENTS  ? ph_quat_i(unit, unit)
                          : point,
      u.data + 3 * j);
}

static void build(enum mode mode, size_t refine, ph_quat a, ph_quat b,
                  ph_vec3 start) {
  static const enum ph_field_id field[MODES] = {
      PH_F_POINTS, PH_F_POINTS, PH_F_DERIVATIVES, PH_F_TANGENTS};
  memset(&u, 0, sizeof u);
  u.curve = (struct ph_curve){.kind = PH_CURVE_PH,
                              .dimension = 3,
                              .degree = 5,
                              .n = INTERVALS * refine,
                              .knots = u.knots,
                              .control_points = u.control_points,
                              .preimage.n = 3,
                              .preimage.dimension = 4,
                              .preimage.v = u.preimage,
                              .lengths = u.segment_lengths};
  put(start, u.start);
  for (size_t j = 0; j < INTERVALS; j++) {
    double h = (KNOTS[j + 1] - KNOTS[j]) / (double)refine;
    set_datum(mode, j, start, preimage_at(a, b, KNOTS[j]));
    for (size_t k = j * refine; k < (j + 1) * refine; k++) {
      double t = KNOTS[j] + h * (double)(k - j * refine);
      start = build_segment(
          k, a, b, t, k + 1 < (j + 1) * refine ? t + h : KNOTS[j + 1], start);
      u.lengths[j] += u.segment_lengths[k];
    }
    u.curve.length += u.lengths[j];
  }
  set_datum(mode, INTERVALS, start, preimage_at(a, b, KNOTS[INTERVALS]));
  unit_set_array(&u.problem, field[mode], u.data, INTERVALS + 1, 3);
  if (mode != RELAXED) {
    unit_set_array(&u.problem, PH_F_LENGTHS, u.lengths, INTERVALS, 1);
  }
  if (mode == DERIVATIVES || mode == TANGENTS) {
    unit_set_array(&u.problem, PH_F_START, u.start, 3, 1);
  }
}

/* ---- verdicts --------------------------------------------------------- */

static void begin(enum mode mode, size_t refine) {
  build(mode, refine, A, B, ph_vec3_get(START, 3));
}

/* A loop test's mode and segments for each interval. */
enum { VARIANTS = MODES * REFINE_MAX };

static enum mode mode_of(int i) {
  return (enum mode)(i % MODES);
}

static size_t refine_of(int i) {
  return (size_t)(i / MODES) + 1;
}

static void begin_variant(int i) {
  begin(mode_of(i), refine_of(i));
}

/* ---- what is right ---------------------------------------------------- */

PH_TEST_EACH(test_accepts, VARIANTS) {
  begin_variant(_i);
  ck_accepted();
  ck_abs(value_of(PH_D_INTERPOLATION_ERROR), 0, 0);
  ck_assert_double_le(value_of(PH_D_PYTHAGOREAN_ERROR), 1e-14);
  ck_assert_double_le(value_of(PH_D_CONTINUITY_ERROR), 2e-13);
  ck_assert_double_le(value_of(PH_D_LENGTH_ERROR), 1e-14);
  if (mode_of(_i) == DERIVATIVES || mode_of(_i) == TANGENTS) {
    ck_assert_double_le(value_of(PH_D_TANGENT_ERROR), 1e-14);
  } else {
    ck_assert(!is_known(PH_D_TANGENT_ERROR));
  }
}

/* |a + t b|^2 is smallest where its derivative vanishes. */
PH_TEST_EACH(test_min_speed, VARIANTS) {
  double t = -ph_quat_dot(A, B) / ph_quat_dot(B, B);
  ph_quat a = preimage_at(A, B, t);
  begin_variant(_i);
  ck_accepted();
  ck_assert(t > 0.5 && t < 3.5);
  ck_abs(value_of(PH_D_MIN_SPEED), ph_quat_dot(a, a) * 4 / u.curve.length,
         2e-13);
}

/* A curve that stands still at t = 1.1. */
PH_TEST_EACH(test_min_speed_of_cusp, VARIANTS) {
  build(_i % 2 ? RELAXED : POINTS, refine_of(_i), ph_quat_scale(-1.1, B), B,
        ph_vec3_get(START, 3));
  ck_accepted();
  ck_abs(value_of(PH_D_MIN_SPEED), 0, 2e-13);
}

/* Everything is relative: by powers of four not a digit changes. */
PH_TEST_EACH(test_scales, VARIANTS) {
  struct ph_diagnostics unit;
  begin_variant(_i);
  ck_accepted();
  unit = checked.diagnostics;
  for (int e = -1000; e <= 1000; e += 250) {
    ph_vec3 start = ph_vec3_scale(ldexp(1, e), ph_vec3_get(START, 3));
    double root = ldexp(1, e / 2);
    build(mode_of(_i), refine_of(_i), ph_quat_scale(root, A),
          ph_quat_scale(root, B), start);
    ck_accepted();
    for (size_t i = 0; i < ERRORS_N; i++) {
      ck_abs(value_of(ERRORS[i]), unit.value[ERRORS[i]], 0);
    }
    u.segment_lengths[1] *= 1 + MOVED;
    ck_refused(PH_D_LENGTH_ERROR, 1);
  }
}

/* Far from the origin control points have fewer digits: what that makes of a
 * curve is allowed for, and no more. */
PH_TEST_EACH(test_far_away, VARIANTS) {
  static const double away[] = {1e3, 1e6, 1e9};
  for (size_t i = 0; i < 3; i++) {
    double step = 1000 * away[i] * 2.2e-16;
    build(mode_of(_i), refine_of(_i), A, B, ph_vec3_of(0, away[i], 0));
    ck_accepted();
    u.control_points[18 + 3 * 2 + 1] += step;
    ck_assert_int_eq(certify(), PH_E_NO_CONVERGENCE);
    u.control_points[18 + 3 * 2 + 1] -= step;
    u.segment_lengths[2] += step;
    ck_refused(PH_D_LENGTH_ERROR, 2);
  }
}

/* Lengths with a deviation are not met, and `auto' is any number. */
PH_TEST_EACH(test_soft_lengths, VARIANTS) {
  begin(_i % MODES == RELAXED ? POINTS : mode_of(_i), refine_of(_i));
  u.lengths[1] *= 1.01;
  ck_refused(PH_D_LENGTH_ERROR, 2 * refine_of(_i) - 1);
  unit_set_number(&u.problem, PH_F_LENGTH_SIGMA, 0.01);
  unit_set_word(&u.problem, PH_F_REFINE, "auto");
  certify();
  ck_assert(is_known(PH_D_LENGTH_ERROR));
  ck_assert_double_le(value_of(PH_D_LENGTH_ERROR), 1e-14);
}

/* Plane data are data in the plane z = 0. */
PH_TEST_EACH(test_plane, VARIANTS) {
  const ph_quat a = {1, 0, 0, 0.5}, b = {-0.25, 0, 0, 0.25};
  double two[2 * (INTERVALS + 1)];
  build(mode_of(_i), refine_of(_i), a, b, ph_vec3_of(3, 4, 0));
  for (size_t j = 0; j <= INTERVALS; j++) {
    two[2 * j] = u.data[3 * j];
    two[2 * j + 1] = u.data[3 * j + 1];
  }
  memcpy(u.data, two, sizeof two);
  for (size_t i = 0; i < PH_FIELD_N; i++) {
    if (u.problem.field[i].kind == PH_VECTORS) {
      u.problem.field[i].dimension = 2;
    }
  }
  if (u.problem.field[PH_F_START].kind != PH_ABSENT) {
    u.problem.field[PH_F_START].n = 2;
  }
  ck_accepted();
}

/* ---- what is not ------------------------------------------------------ */

/* Each coordinate of each control point, one after the other. */
PH_TEST_EACH(test_control_points, VARIANTS) {
  begin_variant(_i);
  for (size_t i = 0; i < 18 * u.curve.n; i++) {
    double *x = &u.control_points[i], keep = *x;
    *x += MOVED;
    ck_assert_int_eq(certify(), PH_E_NO_CONVERGENCE);
    *x = keep;
  }
  ck_accepted();
}

PH_TEST_EACH(test_preimage, VARIANTS) {
  begin_variant(_i);
  ck_each_moved(u.preimage, 12 * u.curve.n, 12, MOVED, PH_D_PYTHAGOREAN_ERROR);
}

PH_TEST_EACH(test_data, VARIANTS) {
  static const enum ph_diagnostic what[MODES] = {
      PH_D_INTERPOLATION_ERROR, PH_D_INTERPOLATION_ERROR, PH_D_TANGENT_ERROR,
      PH_D_TANGENT_ERROR};
  size_t refine = refine_of(_i);
  begin_variant(_i);
  for (size_t j = 0; j <= INTERVALS; j++) {
    double *v = u.data + 3 * j;
    ph_vec3 given = ph_vec3_get(v, 3), t = ph_vec3_unit(given);
    put(ph_vec3_along(given, MOVED, ph_vec3_any_normal(t)), v);
    ck_refused_in(what[mode_of(_i)], j * refine, j > 0 ? j * refine - 1 : 0);
    put(given, v);
  }
  ck_accepted();
}

PH_TEST_EACH(test_start, VARIANTS) {
  begin(_i % 2 ? TANGENTS : DERIVATIVES, refine_of(_i));
  u.start[1] += MOVED;
  ck_refused(PH_D_INTERPOLATION_ERROR, 0);
  u.problem.field[PH_F_START].kind = PH_ABSENT;
  ck_refused(PH_D_INTERPOLATION_ERROR, 0);
  build(_i % 2 ? TANGENTS : DERIVATIVES, refine_of(_i), A, B,
        ph_vec3_of(0, 0, 0));
  u.problem.field[PH_F_START].kind = PH_ABSENT;
  ck_accepted();
}

PH_TEST_EACH(test_lengths, VARIANTS) {
  size_t refine = refine_of(_i);
  begin_variant(_i);
  for (size_t k = 0; k < u.curve.n; k++) {
    double keep = u.segment_lengths[k];
    u.segment_lengths[k] += MOVED;
    ck_refused(PH_D_LENGTH_ERROR, k);
    u.segment_lengths[k] = keep;
  }
  u.curve.length += MOVED;
  ck_refused(PH_D_LENGTH_ERROR, u.curve.n - 1);
  u.curve.length -= MOVED;
  for (size_t j = 0; j < INTERVALS && mode_of(_i) != RELAXED; j++) {
    double keep = u.lengths[j];
    u.lengths[j] += MOVED;
    ck_refused(PH_D_LENGTH_ERROR, (j + 1) * refine - 1);
    ck_rel(value_of(PH_D_LENGTH_ERROR), MOVED * INTERVALS / u.curve.length,
           1e-4);
    u.lengths[j] = keep;
  }
}

/* Derivatives are by the knots, and so is their continuity. */
PH_TEST_EACH(test_knots, VARIANTS) {
  begin_variant(_i);
  for (size_t k = 1; k < u.curve.n; k++) {
    double keep = u.knots[k];
    u.knots[k] += MOVED;
    ck_assert_int_eq(certify(), PH_E_NO_CONVERGENCE);
    u.knots[k] = keep;
  }
}

/* Magnitudes by the rule of the mean are lengths by knots. */
PH_TEST_EACH(test_magnitudes, VARIANTS) {
  ph_quat still = {0, 0, 0, 0};
  build(TANGENTS, refine_of(_i), A, still, ph_vec3_of(0, 0, 0));
  unit_set_word(&u.problem, PH_F_MAGNITUDES, "mean");
  ck_accepted();
  ck_assert_double_le(value_of(PH_D_TANGENT_ERROR), 1e-14);
  begin(TANGENTS, refine_of(_i));
  unit_set_word(&u.problem, PH_F_MAGNITUDES, "mean");
  ck_assert_int_eq(certify(), PH_E_NO_CONVERGENCE);
  ck_assert_ptr_nonnull(strstr(checked.diag.message, "tangent_error"));
  unit_set_word(&u.problem, PH_F_MAGNITUDES, "free");
  ck_accepted();
}

/* As many segments as there must be. */
PH_TEST_EACH(test_refine, VARIANTS) {
  struct ph_value *refine = &u.problem.field[PH_F_REFINE];
  begin_variant(_i);
  *refine = (struct ph_value){.kind = PH_NUMBER, .number = 1};
  for (; refine->number < 4; refine->number++) {
    bool right = unit_same(refine->number, (double)refine_of(_i));
    ck_assert_int_eq(certify(), right ? PH_OK : PH_E_INTERNAL);
  }
  refine->kind = PH_ABSENT;
  u.curve.n--;
  ck_assert_int_ne(certify(), PH_OK);
}

PH_TEST_EACH(test_not_finite, VARIANTS) {
  begin_variant(_i);
  u.control_points[20] = (double)NAN;
  ck_assert_int_eq(certify(), PH_E_TOO_LARGE);
}

static void start(void) {
  checked.command = "arclength";
  checked.problem = &u.problem;
  checked.curve = &u.curve;
}

PH_FIXTURE(start, NULL)
