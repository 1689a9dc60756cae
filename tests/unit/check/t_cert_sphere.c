/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The certificate of spherical splines: it accepts what is right, and whatever
 * is changed in a curve that it has accepted, it notices and names.
 *
 * Four splines were solved by another program (sphere_table.h); circles of
 * latitude are splines for some tension, whatever their speed is.
 */
#include "cert_sphere_unit.h"
#include "check_unit.h"
#include "unit.h"

#include "check/sphere_segment.h"
#include "kernel/pi.h"

/* Moved by this. */
static const double MOVED = 1e-9;

enum { THESIS = 2 /* the spline with the tensions of the thesis */ };

/* Of that spline: the largest jump of its curvature, relative to 1, and the
 * thesis's measure of co-circularity. */
static const double THESIS_JUMP = 1.526675e-2, THESIS_MEASURE = 7.3202e-4;

static struct unit_sphere u;

static const struct unit_ball UNIT = {{0, 0, 0}, 1};
static const struct unit_ball SPHERES[] = {
    {{0, 0, 0}, 1},           {{1, -2, 0.5}, 3},
    {{1e5, -1e6, 0}, 2},      {{0, 0, 6378137}, 6378137},
    {{0, 1e-301, 0}, 1e-300}, {{-1e300, 0, 0}, 1e300}};
enum { SPHERES_N = COUNT(SPHERES) };
/* ---- verdicts -------------------------------------------------------- */
/* Refused at field[at], in words that begin so. */
static void ck_refused_as(const char *field, size_t at, const char *words) {
  char name[64];
  snprintf(name, sizeof name, "%s[%zu]", field, at);
  ck_assert_int_eq(certify(), PH_E_NO_CONVERGENCE);
  ck_assert_msg(strcmp(checked.diag.field, name) == 0 &&
                    strncmp(checked.diag.message, words, strlen(words)) == 0,
                "%s %s", checked.diag.field, checked.diag.message);
}

/* ---- what is right --------------------------------------------------- */

PH_TEST_EACH(test_accepts, UNIT_SPLINES_N) {
  for (size_t i = 0; i < SPHERES_N; i++) {
    const struct unit_spline *s = &UNIT_SPLINES[_i];
    const double *center = SPHERES[i].center;
    double digits = 2e-13, sum = 0;
    unit_cert_sphere_of(&u, s, &SPHERES[i]);
    ck_accepted();
    if (fabs(center[1]) > 100 * SPHERES[i].radius) {
      digits = 1e-7;
    }
    ck_assert_double_le(value_of(PH_D_SPHERE_ERROR), digits);
    ck_assert_double_le(value_of(PH_D_INTERPOLATION_ERROR), digits);
    ck_assert_double_le(value_of(PH_D_CONTINUITY_ERROR), digits);
    ck_assert_double_le(value_of(PH_D_LENGTH_ERROR), 1e-12 + digits);
    ck_assert(is_known(PH_D_END_DERIVATIVE_ERROR) == !s->closed);
    if (s->nielson) {
      ck_abs(value_of(PH_D_CURVATURE_JUMP), THESIS_JUMP, 1e-6);
    } else {
      ck_assert_double_le(value_of(PH_D_CURVATURE_JUMP), 1000 * digits);
    }
    for (size_t k = 0; k < s->n; k++) {
      sum += s->closed || (k > 0 && k + 1 < s->n) ? s->tensions[k] : 0;
    }
    ck_abs(value_of(PH_D_TENSION_SUM), sum, 0);
    ck_abs(value_of(PH_D_SHAPE_OK), s->shape, 0);
  }
}

enum { LATITUDES = 4 * 4 * 5 };

/* The factor and LATITUDES have no common divisor: all are taken, in an order
 * in which a tenth has each latitude, each number of points, each speed. */
PH_TEST_EACH(test_latitude, LATITUDES) {
  int which = 11 * _i % LATITUDES;
  static const double lat[] = {0.3, -1.2, 0.01, 0};
  static const size_t n[] = {3, 4, 20, UNIT_SPHERE_MAX};
  static const double speed[] = {1, 0.7, 0.1, 1e-3, 1e-6};
  double at = lat[which % 4];
  size_t points = n[which / 4 % 4];
  double leg = cos(at) * 2 / 3 * PH_PI / (double)points;
  if (_i >= unit_count(LATITUDES)) {
    return;
  }
  if (points == 3 && !(at < -1)) {
    leg *= 0.9;
  }
  unit_sphere_latitude(&u, points, at, leg * speed[which / 16], &UNIT);
  unit_set_flag(&u.problem, PH_F_SHAPE, true);
  ck_accepted();
  ck_assert_double_le(value_of(PH_D_LENGTH_ERROR), 1e-12);
  ck_abs(value_of(PH_D_SHAPE_OK), 1, 0);
  ck_rel(value_of(PH_D_TENSION_SUM), (double)u.curve.n * u.tensions[0], 1e-12);
}

/* Data so small that they are flat. */
PH_TEST(test_small) {
  const struct unit_ball large = {{0, 0, 0}, 1e6};
  double away = 1e-5;
  for (size_t i = 0; i < 3; i++) {
    unit_sphere_arc(&u, away, 0.4, -0.3, &large);
    unit_set_word(&u.problem, PH_F_ENDS, "clamped");
    unit_set_array(&u.problem, PH_F_END_TANGENTS, u.end_tangents, 2, 3);
    ck_accepted();
    u.points[1] += 1e-4 * away * large.radius;
    ck_refused(PH_D_INTERPOLATION_ERROR, 0);
    ck_rel(value_of(PH_D_INTERPOLATION_ERROR), 2e-4, 0.1);
    away /= 10;
  }
}

PH_TEST(test_ends) {
  for (size_t i = 0; i < SPHERES_N; i++) {
    unit_sphere_arc(&u, 1.3, 0, 0, &SPHERES[i]);
    ck_accepted();
    unit_set_word(&u.problem, PH_F_ENDS, "rest");
    ck_refused(PH_D_END_DERIVATIVE_ERROR, 0);
    unit_set_word(&u.problem, PH_F_ENDS, "clamped");
    unit_set_array(&u.problem, PH_F_END_TANGENTS, u.end_tangents, 2, 3);
    ck_accepted();
    unit_sphere_arc(&u, 2.9, 0.7, -0.2, &SPHERES[i]);
    unit_set_word(&u.problem, PH_F_ENDS, "clamped");
    unit_set_array(&u.problem, PH_F_END_TANGENTS, u.end_tangents, 2, 3);
    ck_accepted();
    u.end_tangents[2] *= 1.001;
    ck_refused(PH_D_END_DERIVATIVE_ERROR, 0);
    u.end_tangents[2] /= 1.001;
    u.end_tangents[5] *= 1.001;
    ck_refused(PH_D_END_DERIVATIVE_ERROR, 0);
    unit_set_word(&u.problem, PH_F_ENDS, "natural");
    ck_refused(PH_D_END_DERIVATIVE_ERROR, 0);
  }
}

PH_TEST(test_lonlat) {
  size_t n = 12;
  unit_sphere_latitude(&u, n, PH_PI / 6, 0.12, &SPHERES[1]);
  for (size_t i = 0; i <= n; i++) {
    u.lonlat[2 * i] = 30 * (double)i;
    u.lonlat[2 * i + 1] = 30;
  }
  u.problem.field[PH_F_POINTS].kind = PH_ABSENT;
  unit_set_array(&u.problem, PH_F_LONLAT, u.lonlat, n, 2);
  ck_accepted();
  /* a repeated last point */
  u.problem.field[PH_F_LONLAT].n = n + 1;
  ck_accepted();
  u.lonlat[2 * 5] += 1e-6;
  ck_assert_int_eq(certify(), PH_E_NO_CONVERGENCE);
  ck_assert_ptr_nonnull(strstr(checked.diag.message, "interpolation_error"));
}

/* Equal angles are uniform knots; in another unit of the parameter tensions
 * have another unit. */
PH_TEST(test_knots) {
  size_t n = 9;
  unit_sphere_latitude(&u, n, 0.5, 0.15, &UNIT);
  unit_set_word(&u.problem, PH_F_KNOTS, "uniform");
  ck_accepted();
  for (size_t k = 0; k <= n; k++) {
    u.given_knots[k] = u.knots[k] = 4 * u.knots[k] - 3;
  }
  ck_refused_as("segments", 0, "is refused by its certificate: its knots are");
  unit_set_array(&u.problem, PH_F_KNOTS, u.given_knots, n + 1, 1);
  ck_refused_as("tensions", 0, "is refused by its certificate: the curve is");
  for (size_t i = 0; i < n; i++) {
    u.tensions[i] /= 4;
  }
  ck_accepted();
  u.given_knots[4] += MOVED;
  ck_refused_as("segments", 3, "is refused by its certificate: its knots are");
  u.knots[4] += MOVED;
  ck_refused(PH_D_CONTINUITY_ERROR, 4);
}

/* On a great circle the angle is a cubic polynomial, which may turn back
 * anywhere: b_i are the differences of control points. */
static double angle_at(const double b[3], double t) {
  double two = t * t * (3 - 2 * t);
  return b[0] * t * (3 - 3 * t + t * t) + b[1] * two + b[2] * t * t * t;
}

static double length_on_circle(const double b[3]) {
  double c2 = b[0] - 2 * b[1] + b[2], c1 = b[1] - b[0], c0 = b[0];
  double root = c1 * c1 - c2 * c0, from = 0, length = 0;
  double turn[3] = {1, 1, 1};
  if (root > 0) {
    double q = -(c1 + copysign(sqrt(root), c1)), x = q / c2, y = c0 / q;
    turn[0] = x > 0 && x < 1 ? x : 1;
    turn[1] = y > 0 && y < 1 ? y : 1;
    if (turn[1] < turn[0]) {
      double swap = turn[0];
      turn[0] = turn[1];
      turn[1] = swap;
    }
  }
  for (size_t i = 0; i < 3; i++) {
    length += fabs(angle_at(b, turn[i]) - angle_at(b, from));
    from = turn[i];
  }
  return length;
}

PH_TEST_EACH(test_turning_back, 3) {
  static const double scale[] = {1, 1e-2, 1e-6};
  for (int i = -20; i <= unit_count(40) - 20; i++) {
    for (int j = -8; j <= 8; j++) {
      double tail = j == 0 ? 0 : copysign(pow(10, -fabs((double)j)), j);
      double b[3] = {0.9 + 0.0137 * i, 0.7, tail}, at = 0, length, found;
      struct ph_check_nu_segment s;
      ph_vec3 p[4];
      for (size_t k = 0; k < 4; k++) {
        p[k] = ph_vec3_of(cos(at), 0.6 * sin(at), 0.8 * sin(at));
        at += k < 3 ? b[k] *= scale[_i] : 0;
      }
      length = length_on_circle(b);
      ph_check_nu_segment_of(p, 4.4e-16, &s);
      found = ph_check_nu_length(&s, length, 0);
      ck_abs(found, length, 1e-11 * length + 1.4e-14);
    }
  }
}

/* Forth, back for a short way, and forth, at the speed (t - t0)^2 - r^2 times
 * 3 c: 8 c r^3 longer than the angle of its ends.  A claim that does not know
 * it is refused, also where it turns at a part of a power of two, by what the
 * certificate allows of lengths. */
PH_TEST(test_running_back) {
  struct unit_random r = unit_random_of(612908);
  for (int i = 0; i < unit_count(2000); i++) {
    double scale = pow(10, unit_random_in(&r, -5, -0.5));
    double t = unit_random_in(&r, 0.1, 0.9), at = 0, length, found;
    double back = pow(10, unit_random_in(&r, -2.5, -1.1));
    const double b[3] = {t * t - back * back, t * t - back * back - t,
                         t * t - back * back - 2 * t + 1};
    struct ph_check_nu_segment s;
    ph_vec3 p[4];
    for (size_t k = 0; k < 4; k++) {
      p[k] = ph_vec3_of(cos(at), 0.6 * sin(at), 0.8 * sin(at));
      at += k < 3 ? scale * b[k] : 0;
    }
    length = at + 8 * scale * back * back * back;
    ph_check_nu_segment_of(p, 4.4e-16, &s);
    for (int wrong = 0; wrong < 2; wrong++) {
      double claimed = wrong ? at : length;
      double allowed = 1e-11 * claimed + 96 * 4.4e-16;
      found = ph_check_nu_length(&s, claimed, allowed);
      ck_abs(found, length, 1e-11 * length + 96 * 4.4e-16);
    }
  }
}

/* ---- what is not ----------------------------------------------------- */

/* Each coordinate of each control point, one after the other; on the sphere
 * and away from it. */
PH_TEST_EACH(test_control_points, UNIT_SPLINES_N) {
  size_t step = unit_count(10) < 10 ? 11 : 1;
  for (size_t j = 0; j < 2; j++) {
    unit_cert_sphere_of(&u, &UNIT_SPLINES[_i], &SPHERES[j]);
    for (size_t i = 0; i < 12 * u.curve.n; i += step) {
      double *x = u.control_points + i, *p = x - i % 3, keep[3];
      ph_vec3 v, center = ph_vec3_get(SPHERES[j].center, 3);
      memcpy(keep, p, sizeof keep);
      *x += MOVED;
      ck_assert_int_eq(certify(), PH_E_NO_CONVERGENCE);
      v = ph_vec3_sub(ph_vec3_get(p, 3), center);
      unit_sphere_put(&SPHERES[j], ph_vec3_unit(v), p);
      v = ph_vec3_sub(ph_vec3_get(p, 3), ph_vec3_get(keep, 3));
      if (ph_vec3_abs(v) > MOVED / 10) {
        ck_assert_int_eq(certify(), PH_E_NO_CONVERGENCE);
      }
      memcpy(p, keep, sizeof keep);
    }
    ck_accepted();
  }
}

PH_TEST_EACH(test_off_sphere, UNIT_SPLINES_N) {
  unit_cert_sphere_of(&u, &UNIT_SPLINES[_i], &UNIT);
  for (size_t i = 0; i < 3; i++) {
    u.control_points[12 + 3 + i] *= 1 + 1e-13;
  }
  ck_refused(PH_D_SPHERE_ERROR, 1);
  ck_rel(value_of(PH_D_SPHERE_ERROR), 1e-13, 0.01);
}

PH_TEST_EACH(test_tensions, UNIT_SPLINES_N) {
  const struct unit_spline *s = &UNIT_SPLINES[_i];
  unit_cert_sphere_of(&u, s, &UNIT);
  for (size_t i = 0; i < s->n; i++) {
    double keep = u.tensions[i];
    u.tensions[i] += 1e-6;
    if (!s->closed && (i == 0 || i + 1 == s->n)) {
      ck_accepted();
    } else {
      ck_refused_as("tensions", i, "is refused by its certificate: the curve");
      ck_assert_int_eq(strstr(checked.diag.message, "--model=exact finds") !=
                           NULL,
                       s->nielson);
    }
    u.tensions[i] = keep;
  }
  ck_accepted();
}

/* Without shape, tensions are those that were given. */
PH_TEST_EACH(test_given_tensions, UNIT_SPLINES_N) {
  const struct unit_spline *s = &UNIT_SPLINES[_i];
  size_t inner = 0;
  unit_cert_sphere_of(&u, s, &UNIT);
  memcpy(u.given_tensions, u.tensions, sizeof u.tensions);
  unit_set_flag(&u.problem, PH_F_SHAPE, false);
  unit_set_array(&u.problem, PH_F_TENSION, u.given_tensions, s->n, 1);
  ck_accepted();
  ck_abs(value_of(PH_D_SHAPE_OK), s->shape, 0);
  u.given_tensions[2] += 1;
  ck_refused_as("tensions", 2, "is refused by its certificate: ");
  u.problem.field[PH_F_TENSION].kind = PH_ABSENT;
  for (size_t i = s->closed ? 0 : 1; i < s->n - (s->closed ? 0 : 1); i++) {
    inner += s->tensions[i] > 0;
  }
  ck_assert_int_eq(certify(), inner > 0 ? PH_E_NO_CONVERGENCE : PH_OK);
  unit_set_word(&u.problem, PH_F_SHAPE, "warn");
  ck_accepted();
}

PH_TEST_EACH(test_lengths, UNIT_SPLINES_N) {
  unit_cert_sphere_of(&u, &UNIT_SPLINES[_i], &SPHERES[1]);
  for (size_t k = 0; k < u.curve.n; k++) {
    u.lengths[k] += MOVED;
    ck_assert_int_eq(certify(), PH_E_NO_CONVERGENCE);
    u.curve.length += MOVED;
    ck_refused(PH_D_LENGTH_ERROR, k);
    ck_rel(value_of(PH_D_LENGTH_ERROR), MOVED / u.curve.length, 1e-4);
    u.lengths[k] -= MOVED;
    u.curve.length -= MOVED;
  }
  u.curve.length += MOVED;
  ck_refused(PH_D_LENGTH_ERROR, u.curve.n - 1);
}

PH_TEST_EACH(test_indicators, UNIT_SPLINES_N) {
  const struct unit_spline *s = &UNIT_SPLINES[_i];
  unit_cert_sphere_of(&u, s, &UNIT);
  for (size_t i = s->closed ? 0 : 1; i < s->n - (s->closed ? 0 : 1); i++) {
    for (int q = -1; q <= 1; q++) {
      u.indicators[i] = (signed char)q;
      if (q == s->indicators[i]) {
        ck_accepted();
      } else {
        ck_refused_as("indicators", i, "is refused by its certificate: ");
      }
    }
    u.indicators[i] = s->indicators[i];
  }
}

PH_TEST_EACH(test_swapped, UNIT_SPLINES_N) {
  double keep[6], *p = u.control_points;
  unit_cert_sphere_of(&u, &UNIT_SPLINES[_i], &UNIT);
  memcpy(keep, p + 3, sizeof keep);
  memcpy(p + 3, p + 12 + 3, sizeof keep);
  memcpy(p + 12 + 3, keep, sizeof keep);
  ck_assert_int_eq(certify(), PH_E_NO_CONVERGENCE);
  unit_cert_sphere_of(&u, &UNIT_SPLINES[_i], &UNIT);
  for (size_t i = 0; i < 12; i++) {
    double x = p[i];
    p[i] = p[12 + i];
    p[12 + i] = x;
  }
  ck_assert_int_eq(certify(), PH_E_NO_CONVERGENCE);
}

PH_TEST_EACH(test_radius, UNIT_SPLINES_N) {
  unit_cert_sphere_of(&u, &UNIT_SPLINES[_i], &SPHERES[1]);
  u.curve.sphere.radius *= 1 + MOVED;
  ck_assert_int_eq(certify(), PH_E_INTERNAL);
  unit_set_number(&u.problem, PH_F_RADIUS, u.curve.sphere.radius);
  ck_assert_int_eq(certify(), PH_E_NO_CONVERGENCE);
  ck_assert_ptr_nonnull(strstr(checked.diag.message, "sphere_error"));
  unit_cert_sphere_of(&u, &UNIT_SPLINES[_i], &SPHERES[1]);
  u.center[2] += MOVED;
  ck_assert_int_eq(certify(), PH_E_INTERNAL);
}

/* Data off the sphere are compared with their projection; how far off they may
 * be is said. */
PH_TEST_EACH(test_moved, UNIT_SPLINES_N) {
  unit_cert_sphere_of(&u, &UNIT_SPLINES[_i], &UNIT);
  for (size_t i = 0; i < 3; i++) {
    u.points[6 + i] *= 1.0009;
  }
  ck_accepted();
  unit_set_number(&u.problem, PH_F_RADIUS_TOLERANCE, 1e-4);
  ck_refused_as("points", 2, "is not on the sphere");
  unit_cert_sphere_of(&u, &UNIT_SPLINES[_i], &UNIT);
  u.points[6] += MOVED;
  ck_refused(PH_D_INTERPOLATION_ERROR, 1);
}

PH_TEST_EACH(test_model, UNIT_SPLINES_N) {
  unit_cert_sphere_of(&u, &UNIT_SPLINES[_i], &UNIT);
  unit_set_word(&u.problem, PH_F_MODEL,
                UNIT_SPLINES[_i].nielson ? "exact" : "nielson");
  ck_assert_int_eq(certify(), PH_E_NO_CONVERGENCE);
  if (UNIT_SPLINES[_i].nielson) {
    ck_assert_ptr_nonnull(strstr(checked.diag.message, "curvature_jump"));
  }
  unit_cert_sphere_of(&u, &UNIT_SPLINES[_i], &UNIT);
  unit_set_word(&u.problem, PH_F_ENDS,
                UNIT_SPLINES[_i].rest ? "natural" : "rest");
  ck_assert_int_eq(certify(),
                   UNIT_SPLINES[_i].closed ? PH_OK : PH_E_NO_CONVERGENCE);
}

PH_TEST_EACH(test_fits, UNIT_SPLINES_N) {
  unit_cert_sphere_of(&u, &UNIT_SPLINES[_i], &UNIT);
  u.curve.n -= 2;
  ck_assert_int_eq(certify(), PH_E_INTERNAL);
  unit_cert_sphere_of(&u, &UNIT_SPLINES[_i], &UNIT);
  u.curve.sphere.tensions = NULL;
  ck_assert_int_eq(certify(), PH_E_INTERNAL);
  unit_cert_sphere_of(&u, &UNIT_SPLINES[_i], &UNIT);
  u.control_points[20] = (double)NAN;
  ck_assert_int_eq(certify(), PH_E_TOO_LARGE);
  unit_cert_sphere_of(&u, &UNIT_SPLINES[_i], &UNIT);
  u.tensions[1] = (double)INFINITY;
  ck_assert_int_eq(certify(), PH_E_TOO_LARGE);
}

/* ---- shape ----------------------------------------------------------- */

PH_TEST_EACH(test_shape, UNIT_SPLINES_N) {
  static const char *const field[] = {"", "segments", "points", "points"};
  static const size_t at[] = {0, 2, 1, 5};
  static const char *const words[] = {"", "segment convexity", "co-circularity",
                                      "nodal convexity"};
  for (size_t i = 0; i < 2; i++) {
    unit_cert_sphere_of(&u, &UNIT_SPLINES[_i], &SPHERES[i]);
    if (i == 0) {
      unit_set_flag(&u.problem, PH_F_SHAPE, true);
    } else {
      u.problem.field[PH_F_SHAPE].kind = PH_ABSENT;
    }
    u.curve.sphere.waived_n = 0;
    if (UNIT_SPLINES[_i].shape) {
      ck_accepted();
    } else {
      ck_refused_as(field[_i], at[_i], "is refused by its certificate: shape");
      ck_assert_ptr_nonnull(strstr(checked.diag.message, words[_i]));
    }
  }
}

/* What was waived is not asked, unless it was asked for strictly, but is told;
 * what was not waived is asked. */
PH_TEST_EACH(test_waived, UNIT_SPLINES_N) {
  bool shape = UNIT_SPLINES[_i].shape;
  size_t n;
  unit_cert_sphere_of(&u, &UNIT_SPLINES[_i], &UNIT);
  n = u.curve.n;
  ck_accepted();
  u.curve.sphere.waived_n = n;
  ck_accepted();
  ck_abs(value_of(PH_D_SHAPE_OK), 0, 0);
  unit_set_flag(&u.problem, PH_F_SHAPE, true);
  ck_assert_int_eq(certify(), shape ? PH_OK : PH_E_NO_CONVERGENCE);
  unit_set_word(&u.problem, PH_F_SHAPE, "warn");
  u.curve.sphere.waived_n = 1; /* where none of these has a fault */
  ck_assert_int_eq(certify(), shape ? PH_OK : PH_E_NO_CONVERGENCE);
  u.curve.sphere.waived_n = 2;
  u.waived[1] = 0;
  ck_assert_int_eq(certify(), PH_E_INTERNAL);
  u.waived[1] = n;
  ck_assert_int_eq(certify(), PH_E_INTERNAL);
}

/* The tensions are those of [IOR15, sec. 5.4]. */
PH_TEST_EACH(test_legacy, 2) {
  unit_cert_sphere_of(&u, &UNIT_SPLINES[THESIS], &SPHERES[_i]);
  unit_set_flag(&u.problem, PH_F_SHAPE, true);
  u.curve.sphere.waived_n = 0;
  unit_set_word(&u.problem, PH_F_CRITERION, "legacy");
  unit_set_number(&u.problem, PH_F_EPSILON, 1e-3);
  ck_accepted();
  unit_set_number(&u.problem, PH_F_EPSILON, THESIS_MEASURE * 1.0001);
  ck_accepted();
  unit_set_number(&u.problem, PH_F_EPSILON, THESIS_MEASURE * 0.9999);
  ck_refused_as("points", 1, "is refused by its certificate: shape");
}

/* The same curve, seen as convex where it is not: a segment that bends to both
 * sides between nodes where it bends to one. */
PH_TEST(test_segment) {
  unit_sphere_arc(&u, 1, 0.5, 0.5, &UNIT);
  u.indicators[0] = u.indicators[1] = 1;
  unit_set_word(&u.problem, PH_F_ENDS, "clamped");
  unit_set_array(&u.problem, PH_F_END_TANGENTS, u.end_tangents, 2, 3);
  ck_refused_as("segments", 0, "is refused by its certificate: shape");
  u.curve.sphere.waived_n = 1;
  ck_accepted();
  ck_abs(value_of(PH_D_SHAPE_OK), 0, 0);
  unit_sphere_arc(&u, 1, -0.5, 0.5, &UNIT);
  u.indicators[0] = u.indicators[1] = 1;
  unit_set_word(&u.problem, PH_F_ENDS, "clamped");
  unit_set_array(&u.problem, PH_F_END_TANGENTS, u.end_tangents, 2, 3);
  ck_accepted();
  ck_abs(value_of(PH_D_SHAPE_OK), 1, 0);
  u.indicators[0] = u.indicators[1] = -1;
  u.curve.sphere.waived_n = 1;
  ck_accepted();
  ck_abs(value_of(PH_D_SHAPE_OK), 0, 0);
}

static void start(void) {
  checked.command = "sphere";
  checked.problem = &u.problem;
  checked.curve = &u.curve;
}

PH_FIXTURE(start, NULL)
