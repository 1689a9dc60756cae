/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The certificate of spatial Hermite curves: it accepts what is right, and
 * whatever is changed in a curve that it has accepted, it notices, names and
 * measures.
 */
#include "unit.h"
#include "check_unit.h"
#include "spatial_unit.h"
#include "segment_unit.h"

enum { POINTS = 5 };

/* Its bounding box is 3 x 3 x 2. */
static const double SOME[3 * POINTS] = {0, 0, 0, 1,   1, 0.5, 3, 1,
                                        2, 2, 3, 1.5, 0, 2,   1};
static const double SIZE = 2.345207879911715;
static const double VECTORS[3 * POINTS] = {
    1, 0.5, 0.2, 0.9, 0.4, 1.1, 0.3, 1.2, 0.4, -1.2, -0.3, 0.4, -0.2, -1, -0.9};
/* Moved by this. */
static const double MOVED = 1e-9;
static const enum ph_diagnostic ERRORS[] = {
    PH_D_INTERPOLATION_ERROR, PH_D_TANGENT_ERROR, PH_D_PYTHAGOREAN_ERROR,
    PH_D_CONTINUITY_ERROR, PH_D_LENGTH_ERROR};
enum { ERRORS_N = COUNT(ERRORS) };
static struct unit_hermite3 u;
/* The variants of a problem: bit 0 closed, bit 1 derivatives, bit 2 ATPH. */
enum { CLOSED = 1, DERIVATIVES = 2, ATPH = 4, VARIANTS = 8 };
static void begin(int variant) {
  bool closed = variant & CLOSED;
  double alpha = variant & ATPH ? 1.2 : 0;
  unit_hermite3_of(&u, SOME,
                   variant & DERIVATIVES ? PH_F_DERIVATIVES : PH_F_TANGENTS,
                   VECTORS, POINTS, 3, closed, alpha);
}

/* ---- what is right -------------------------------------------------- */

PH_TEST_EACH(test_accepts, VARIANTS) {
  begin(_i);
  ck_accepted();
  ck_abs(value_of(PH_D_INTERPOLATION_ERROR), 0, 0);
  ck_assert_double_le(value_of(PH_D_TANGENT_ERROR), 4e-15);
  ck_assert_double_le(value_of(PH_D_PYTHAGOREAN_ERROR), 2e-15);
  ck_assert_double_le(value_of(PH_D_CONTINUITY_ERROR), 4e-15);
  ck_assert_double_le(value_of(PH_D_LENGTH_ERROR), 2e-15);
  ck_abs(value_of(PH_D_SHAPE_OK), 0, 0);
  u.curve.choice.shape_ok = NULL;
  u.curve.choice.tension = NULL;
  ck_accepted();
  ck_assert(!is_known(PH_D_SHAPE_OK));
}

/* Any tension, any member of the family, any angle, many data. */
PH_TEST(test_accepts_random) {
  struct unit_random r = unit_random_of(900);
  int n = unit_count(500);
  for (int i = 0; i < n; i++) {
    double points[3 * POINTS], vectors[3 * POINTS];
    double alpha = i & ATPH ? unit_random_in(&r, 1e-3, 3) : 0;
    for (size_t k = 0; k < 3 * POINTS; k++) {
      points[k] = unit_random_in(&r, -1, 1);
      vectors[k] = unit_random_in(&r, -1, 1);
    }
    unit_hermite3_of(&u, points,
                     i & DERIVATIVES ? PH_F_DERIVATIVES : PH_F_TANGENTS,
                     vectors, POINTS, 3, i & CLOSED, alpha);
    for (size_t k = 0; k < u.curve.n; k++) {
      u.tension[k] = unit_random_in(&r, 0.1, 3);
      u.alpha[k] *= unit_random_in(&r, 0.5, 1);
    }
    unit_hermite3_build(&u, unit_random_in(&r, -3, 3));
    ck_accepted();
    ck_assert_double_le(value_of(PH_D_PYTHAGOREAN_ERROR), 1e-14);
    ck_assert_double_le(value_of(PH_D_LENGTH_ERROR), 5e-15);
  }
}

/* A A exp(x i) gives the same curve, also with another x for each segment. */
PH_TEST_EACH(test_accepts_other_phase, VARIANTS) {
  begin(_i);
  for (size_t k = 0; k < u.curve.n; k++) {
    ph_cplx e = ph_cplx_polar((double)k + 1);
    for (size_t i = 0; i < 3; i++) {
      double *a = u.preimage + 12 * k + 4 * i;
      ph_quat turned = ph_quat_turn(ph_quat_of(a[0], a[1], a[2], a[3]), e);
      memcpy(a, &turned, sizeof turned);
    }
  }
  ck_accepted();
}

/* Points and vectors in the plane z = 0. */
PH_TEST_EACH(test_accepts_plane, 2) {
  const double points[] = {0, 0, 2, 1, 3, 0, 5, 2};
  const double vectors[] = {1, 1, 2, -0.5, 1, 0.3, 0.2, 1};
  unit_hermite3_of(&u, points, PH_F_DERIVATIVES, vectors, 4, 2, _i, 0);
  u.points[2 * 4] = 1e9; /* what is after them has no say in the scale */
  ck_accepted();
  ck_assert_double_le(value_of(PH_D_TANGENT_ERROR), 2e-15);
  u.points[3] += MOVED;
  ck_refused(PH_D_INTERPOLATION_ERROR, 0);
  u.points[3] -= MOVED;
  u.vectors[3] += 1e-6;
  ck_refused_in(PH_D_TANGENT_ERROR, 0, 1);
  u.vectors[3] -= 1e-6;
  u.control_points[18 + 3 * 2 + 2] += MOVED;
  ck_refused(PH_D_PYTHAGOREAN_ERROR, 1);
}

/* Without vectors only the joints are looked at. */
PH_TEST_EACH(test_without_vectors, VARIANTS) {
  begin(_i);
  u.problem.field[PH_F_TANGENTS].kind = PH_ABSENT;
  u.problem.field[PH_F_DERIVATIVES].kind = PH_ABSENT;
  ck_accepted();
  ck_assert(!is_known(PH_D_TANGENT_ERROR));
  ck_assert_double_le(value_of(PH_D_CONTINUITY_ERROR), 4e-15);
}

/* The method drops a repeated last point of closed data, not the problem. */
PH_TEST(test_repeated_point) {
  begin(CLOSED);
  memcpy(u.points + 3 * POINTS, u.points, 3 * sizeof *u.points);
  memcpy(u.vectors + 3 * POINTS, u.vectors, 3 * sizeof *u.vectors);
  u.problem.field[PH_F_POINTS].n++;
  u.problem.field[PH_F_TANGENTS].n++;
  ck_accepted();
}

/* Tangents count by their direction alone, whatever their length. */
PH_TEST(test_tangents_of_any_length) {
  const double factor[] = {1e-300, 1e300, 1e-320, 3, 1e-5};
  begin(CLOSED);
  for (size_t i = 0; i < 3 * POINTS; i++) {
    u.vectors[i] *= factor[i / 3];
  }
  ck_assert_int_eq(certify(), PH_E_NO_CONVERGENCE); /* 1e-320: digits lost */
  ck_assert_str_eq(checked.diag.field, "segments[1]");
  for (size_t i = 6; i < 9; i++) {
    u.vectors[i] = VECTORS[i];
  }
  ck_accepted();
  ck_assert_double_le(value_of(PH_D_TANGENT_ERROR), 4e-15);
}

/* Everything is relative: by powers of four not a digit changes. */
PH_TEST_EACH(test_scales, VARIANTS) {
  struct ph_diagnostics unit;
  begin(_i);
  ck_accepted();
  unit = checked.diagnostics;
  for (int e = -1000; e <= 1000; e += 250) {
    for (size_t i = 0; i < 3 * POINTS; i++) {
      u.points[i] = ldexp(SOME[i], e);
      u.vectors[i] = ldexp(VECTORS[i], _i & DERIVATIVES ? e : 0);
    }
    unit_hermite3_build(&u, 0);
    ck_accepted();
    for (size_t i = 0; i < ERRORS_N; i++) {
      ck_abs(value_of(ERRORS[i]), unit.value[ERRORS[i]], 0);
    }
    u.control_points[18 + 3 * 2] += ldexp(MOVED, e);
    ck_refused(PH_D_PYTHAGOREAN_ERROR, 1);
    u.control_points[18 + 3 * 2] -= ldexp(MOVED, e);
    u.lengths[2] *= 1 + MOVED;
    ck_refused(PH_D_LENGTH_ERROR, 2);
  }
}

/* Far from the origin control points have fewer digits: what that makes of a
 * curve is allowed for, and no more. */
PH_TEST_EACH(test_far_away, VARIANTS) {
  static const double away[] = {1e3, 1e6, 1e9};
  begin(_i);
  for (size_t k = 0; k < 3; k++) {
    double step = 1000 * away[k] * 2.2e-16;
    for (size_t i = 0; i < 3 * POINTS; i++) {
      u.points[i] = SOME[i] + away[k];
    }
    unit_hermite3_build(&u, 0);
    ck_accepted();
    u.control_points[18 + 3 * 2] += step;
    ck_refused(PH_D_PYTHAGOREAN_ERROR, 1);
    u.control_points[18 + 3 * 2] -= step;
    u.control_points[36 + 3 * 1] += step;
    ck_refused(PH_D_TANGENT_ERROR, 2);
    u.control_points[36 + 3 * 1] -= step;
    u.lengths[3] += step;
    ck_refused(PH_D_LENGTH_ERROR, 3);
  }
}

/* A segment a million times smaller than the rest has to be as right by its
 * own size, where its coordinates have the digits for that. */
PH_TEST(test_small_segment) {
  const double points[] = {1, 2, 3, 0, 0, 0, 1e-6, 2e-6, -1e-6, -2, 1, 2};
  unit_hermite3_of(&u, points, PH_F_TANGENTS, VECTORS, 4, 3, false, 0);
  ck_accepted();
  ck_assert_double_le(value_of(PH_D_PYTHAGOREAN_ERROR), 2e-15);
  u.control_points[18 + 3 * 2] += 1e-6 * 1e-11;
  ck_refused(PH_D_PYTHAGOREAN_ERROR, 1);
}

/* ---- what is not ---------------------------------------------------- */

/* Each coordinate of each control point, one after the other. */
PH_TEST_EACH(test_control_points, VARIANTS) {
  static const enum ph_diagnostic what[] = {
      PH_D_INTERPOLATION_ERROR, PH_D_TANGENT_ERROR, PH_D_PYTHAGOREAN_ERROR,
      PH_D_PYTHAGOREAN_ERROR,   PH_D_TANGENT_ERROR, PH_D_INTERPOLATION_ERROR};
  begin(_i);
  for (size_t i = 0; i < 18 * u.curve.n; i++) {
    double *x = &u.control_points[i], keep = *x;
    *x += MOVED;
    ck_refused(what[i / 3 % 6], i / 18);
    if (what[i / 3 % 6] == PH_D_INTERPOLATION_ERROR) {
      ck_rel(value_of(PH_D_INTERPOLATION_ERROR), MOVED / SIZE, 1e-5);
    }
    *x = keep;
  }
  ck_accepted();
}

PH_TEST_EACH(test_preimage, VARIANTS) {
  begin(_i);
  ck_each_moved(u.preimage, 12 * u.curve.n, 12, MOVED, PH_D_PYTHAGOREAN_ERROR);
}

/* Preimage and control points of two segments that changed places. */
PH_TEST_EACH(test_swapped, VARIANTS) {
  double *p = u.control_points, *a = u.preimage;
  begin(_i);
  for (size_t i = 0; i < 18; i++) {
    double keep = p[i];
    p[i] = p[18 + i];
    p[18 + i] = keep;
  }
  ck_assert_int_eq(certify(), PH_E_NO_CONVERGENCE);
  ck_assert_ptr_nonnull(strstr(checked.diag.message, "interpolation_error"));
  begin(_i);
  for (size_t i = 0; i < 12; i++) {
    double keep = a[i];
    a[i] = a[12 + i];
    a[12 + i] = keep;
  }
  ck_assert_int_eq(certify(), PH_E_NO_CONVERGENCE);
  ck_assert_ptr_nonnull(strstr(checked.diag.message, "pythagorean_error"));
}

PH_TEST(test_points) {
  begin(0);
  for (size_t i = 0; i < 3 * POINTS; i++) {
    double *x = &u.points[i], keep = *x;
    *x += MOVED;
    ck_refused(PH_D_INTERPOLATION_ERROR, i < 3 ? 0 : i / 3 - 1);
    *x = keep;
  }
  ck_accepted();
}

/* A tangent turned by an angle, in its plane with the next axis. */
PH_TEST_EACH(test_tangent_turned, 2) {
  begin(_i);
  for (size_t k = 0; k < POINTS; k++) {
    double *v = &u.vectors[3 * k];
    ph_vec3 t = ph_vec3_unit(ph_vec3_of(v[0], v[1], v[2]));
    ph_vec3 turned = ph_vec3_along(t, 1e-6, ph_vec3_any_normal(t));
    memcpy(v, &turned, sizeof turned);
    ck_refused_in(PH_D_TANGENT_ERROR, k % u.curve.n, (k + POINTS - 1) % POINTS);
    ck_rel(value_of(PH_D_TANGENT_ERROR), 1e-6, 1e-8);
    memcpy(v, VECTORS + 3 * k, sizeof turned);
  }
  ck_accepted();
}

/* A derivative of another length, and tangents against the way. */
PH_TEST_EACH(test_vectors, 2) {
  begin(DERIVATIVES | _i);
  for (size_t i = 0; i < 3; i++) {
    u.vectors[6 + i] *= 1 + 1e-6;
  }
  ck_refused_in(PH_D_TANGENT_ERROR, 1, 2);
  ck_rel(value_of(PH_D_TANGENT_ERROR), 1e-6, 1e-5);
  begin(_i);
  for (size_t i = 0; i < 3; i++) {
    u.vectors[6 + i] *= -1;
  }
  ck_refused_in(PH_D_TANGENT_ERROR, 1, 2);
  ck_rel(value_of(PH_D_TANGENT_ERROR), 2, 1e-12);
  for (size_t i = 0; i < 3; i++) {
    u.vectors[6 + i] = 0;
  }
  ck_assert_int_eq(certify(), PH_E_NO_CONVERGENCE);
  ck_assert_ptr_nonnull(strstr(checked.diag.message, "tangent_error"));
}

/* The tension says what became of derivatives. */
PH_TEST_EACH(test_tension, 2) {
  begin(DERIVATIVES | _i);
  u.tension[1] = 0.7;
  u.tension[2] = 1.5;
  unit_hermite3_build(&u, 0);
  ck_accepted();
  for (size_t k = 0; k < u.curve.n; k++) {
    double keep = u.tension[k];
    u.tension[k] *= 1 + MOVED;
    ck_refused(PH_D_TANGENT_ERROR, k);
    ck_rel(value_of(PH_D_TANGENT_ERROR), 2 * MOVED, 1e-4);
    u.tension[k] = nan("");
    ck_assert_int_eq(certify(), PH_E_TOO_LARGE);
    u.tension[k] = keep;
  }
  u.curve.choice.tension = NULL;
  ck_refused(PH_D_TANGENT_ERROR, 2);
}

PH_TEST_EACH(test_lengths, VARIANTS) {
  begin(_i);
  for (size_t k = 0; k < u.curve.n; k++) {
    double *length = &u.lengths[k], keep = *length;
    *length *= 1 + MOVED;
    ck_refused(PH_D_LENGTH_ERROR, k);
    ck_rel(value_of(PH_D_LENGTH_ERROR), MOVED, 1e-5);
    *length = keep;
  }
  u.curve.length *= 1 + MOVED;
  ck_refused(PH_D_LENGTH_ERROR, u.curve.n - 1);
  ck_rel(value_of(PH_D_LENGTH_ERROR), MOVED, 1e-5);
  u.curve.length = 0;
  ck_assert_int_eq(certify(), PH_E_NO_CONVERGENCE);
}

/* Another angle is another space; and angles that no segment can have. */
PH_TEST_EACH(test_alpha, ATPH) {
  static const double none[] = {0, -1, 3.1415926535897931, 4};
  begin(ATPH | _i);
  for (size_t k = 0; k < u.curve.n; k++) {
    double *alpha = &u.alpha[k], keep = *alpha;
    *alpha = keep * (1 + 10 * MOVED);
    ck_assert_int_eq(certify(), PH_E_NO_CONVERGENCE);
    for (size_t i = 0; i < COUNT(none); i++) {
      *alpha = none[i];
      ck_assert_int_eq(certify(), PH_E_NO_CONVERGENCE);
    }
    *alpha = keep;
  }
  ck_accepted();
}

/* A quintic with the right ends and tangents that is not PH: its middle is
 * another one. */
PH_TEST_EACH(test_not_ph, VARIANTS) {
  begin(_i);
  u.control_points[3 * 2] += 0.3;
  u.control_points[3 * 3 + 1] -= 0.2;
  ck_refused(PH_D_PYTHAGOREAN_ERROR, 0);
  ck_assert_double_ge(value_of(PH_D_PYTHAGOREAN_ERROR), 0.01);
}

/* Segment 2 with another tangent at its start. */
PH_TEST_EACH(test_joint, VARIANTS) {
  double control_points[18], preimage[12], length;
  begin(_i);
  u.vectors[6] += 1e-6;
  unit_hermite3_build(&u, 0);
  memcpy(control_points, u.control_points + 36, sizeof control_points);
  memcpy(preimage, u.preimage + 24, sizeof preimage);
  length = u.lengths[2];
  begin(_i);
  memcpy(u.control_points + 36, control_points, sizeof control_points);
  memcpy(u.preimage + 24, preimage, sizeof preimage);
  u.curve.length += length - u.lengths[2];
  u.lengths[2] = length;
  ck_refused(PH_D_TANGENT_ERROR, 2);
  u.problem.field[PH_F_TANGENTS].kind = PH_ABSENT;
  u.problem.field[PH_F_DERIVATIVES].kind = PH_ABSENT;
  ck_refused(PH_D_CONTINUITY_ERROR, 2);
  ck_assert_double_ge(value_of(PH_D_CONTINUITY_ERROR), 1e-7);
}

/* An open curve that comes back to its start is not closed for that. */
PH_TEST_EACH(test_not_closed, VARIANTS / 2) {
  begin(_i * DERIVATIVES);
  memcpy(u.points + 3 * (POINTS - 1), u.points, 3 * sizeof *u.points);
  unit_hermite3_build(&u, 0);
  ck_accepted();
  u.curve.closed = true;
  ck_refused(PH_D_TANGENT_ERROR, 3);
  u.problem.field[PH_F_TANGENTS].kind = PH_ABSENT;
  u.problem.field[PH_F_DERIVATIVES].kind = PH_ABSENT;
  ck_refused(PH_D_CONTINUITY_ERROR, 0);
}

/* As many segments as the points need, no fewer and no more. */
PH_TEST(test_count) {
  for (int closed = 0; closed < 2; closed++) {
    begin(closed);
    u.curve.n--;
    ck_assert_int_eq(certify(), closed ? PH_E_NO_CONVERGENCE : PH_E_INTERNAL);
    u.curve.n--;
    ck_assert_int_eq(certify(), PH_E_INTERNAL);
    ck_assert_str_eq(checked.diag.field, "segments");
    u.curve.n = 0;
    ck_assert_int_eq(certify(), PH_E_INTERNAL);
  }
}

PH_TEST_EACH(test_not_finite, VARIANTS) {
  begin(_i);
  ck_not_finite(u.control_points, 18 * u.curve.n);
  ck_not_finite(u.preimage, 12 * u.curve.n);
  ck_not_finite(u.lengths, u.curve.n);
  ck_not_finite(u.knots, u.curve.n + 1);
  ck_not_finite(u.alpha, _i & ATPH ? u.curve.n : 0);
  ck_not_finite(&u.curve.length, 1);
  ck_accepted();
}

PH_TEST(test_no_extent) {
  begin(0);
  for (size_t i = 0; i < 3 * POINTS; i++) {
    u.points[i] = 0;
  }
  ck_assert_int_eq(certify(), PH_E_INTERNAL);
  ck_assert_str_eq(checked.diag.field, "points");
  for (size_t i = 0; i < 3 * POINTS; i++) {
    u.points[i] = 7;
  }
  ck_assert_int_eq(certify(), PH_E_INTERNAL);
}

/* Of several errors the worst is reported, with its place. */
PH_TEST(test_worst) {
  begin(CLOSED);
  u.control_points[3 * 2] += MOVED;
  u.control_points[36 + 3 * 2] += 100 * MOVED;
  u.control_points[54 + 3 * 2] += 10 * MOVED;
  ck_refused(PH_D_PYTHAGOREAN_ERROR, 2);
}

static void start(void) {
  checked.command = "spatial-hermite";
  checked.problem = &u.problem;
  checked.curve = &u.curve;
}

PH_FIXTURE(start, NULL)
