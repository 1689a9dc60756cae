/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The certificate: it accepts what is right, and whatever is changed in a
 * curve that it has accepted, it notices, names and measures.
 */
#include "unit.h"
#include "check_unit.h"
#include "planar_unit.h"

/* Half the diagonal is 2.7. */
static const double SOME[] = {0, 0, 2, 1, 3, 0, 5, 2};
static const double SIZE = 2.692582403567252;

/* Moved by this part of the size. */
static const double MOVED = 1e-9;

static struct unit_solution u;

static void finish(void) {
  unit_solution_free(&u);
}

static void solve(bool closed) {
  enum ph_status status;
  u = unit_planar_of(SOME, 4, closed);
  status = unit_planar_solve(&u);
  ck_assert_msg(status == PH_OK, "%s %s", u.diag.field, u.diag.message);
}

/* Everything is checked, and everything but rounding is zero. */
PH_TEST(test_accepts) {
  for (int closed = 0; closed < 2; closed++) {
    solve(closed);
    ck_assert_int_eq(certify(), PH_OK);
    ck_abs(value_of(PH_D_INTERPOLATION_ERROR), 0, 0);
    ck_assert_double_le(value_of(PH_D_PYTHAGOREAN_ERROR), 1e-12);
    ck_assert_double_le(value_of(PH_D_CONTINUITY_ERROR), 1e-13);
    ck_assert_double_le(value_of(PH_D_LENGTH_ERROR), 1e-15);
    ck_assert(!(checked.diagnostics.known >> PH_D_END_DERIVATIVE_ERROR & 1));
    ck_assert(!(checked.diagnostics.known >> PH_D_RESIDUAL & 1));
    unit_solution_free(&u);
  }
}

/* The sign of a preimage has no meaning. */
PH_TEST(test_accepts_other_sign) {
  solve(false);
  for (size_t i = 6; i < 12; i++) {
    u.result.curve.preimage.v[i] *= -1;
  }
  ck_assert_int_eq(certify(), PH_OK);
}

/* Each coordinate of each control point, one after the other. */
PH_TEST(test_control_points) {
  for (int closed = 0; closed < 2; closed++) {
    solve(closed);
    for (size_t i = 0; i < 12 * u.result.curve.n; i++) {
      double *x = &u.result.curve.control_points[i], keep = *x;
      bool end = i % 12 < 2 || i % 12 >= 10;
      *x += MOVED * SIZE;
      ck_refused(end ? PH_D_INTERPOLATION_ERROR : PH_D_PYTHAGOREAN_ERROR,
                 i / 12);
      if (end) {
        ck_rel(value_of(PH_D_INTERPOLATION_ERROR), MOVED, 1e-5);
      } else {
        ck_assert_double_ge(value_of(PH_D_PYTHAGOREAN_ERROR), MOVED);
        ck_assert_double_le(value_of(PH_D_PYTHAGOREAN_ERROR), 5 * MOVED);
      }
      *x = keep;
    }
    ck_assert_int_eq(certify(), PH_OK);
    unit_solution_free(&u);
  }
}

PH_TEST(test_preimage) {
  solve(true);
  ck_each_moved(u.result.curve.preimage.v, 6 * u.result.curve.n, 6, MOVED,
                PH_D_PYTHAGOREAN_ERROR);
}

PH_TEST(test_points) {
  solve(false);
  for (size_t i = 0; i < 8; i++) {
    double *x = &u.problem.field[PH_F_POINTS].v[i], keep = *x;
    *x += MOVED * SIZE;
    ck_refused(PH_D_INTERPOLATION_ERROR, i < 2 ? 0 : i / 2 - 1);
    *x = keep;
  }
  ck_assert_int_eq(certify(), PH_OK);
}

PH_TEST(test_lengths) {
  solve(true);
  ck_each_scaled(u.result.curve.lengths, u.result.curve.n, MOVED,
                 PH_D_LENGTH_ERROR);
}

PH_TEST(test_total_length) {
  solve(false);
  u.result.curve.length *= 1 + MOVED;
  ck_refused(PH_D_LENGTH_ERROR, 2);
  ck_rel(value_of(PH_D_LENGTH_ERROR), MOVED, 1e-5);
  u.result.curve.length = 0;
  ck_assert_int_eq(certify(), PH_E_NO_CONVERGENCE);
}

/* A curve that is gone through in parts: nothing is missed where they meet. */
PH_TEST(test_long) {
  enum { N = 3000 };
  static const size_t at[] = {0, 1, 1022, 1023, 1024, 1025, 2047, 2048, 2998};
  static double points[2 * N];
  for (size_t i = 0; i < N; i++) {
    points[2 * i] = (double)i;
    points[2 * i + 1] = 9 * sin(0.1 * (double)i);
  }
  for (int closed = 0; closed < 2; closed++) {
    u = unit_planar_of(points, N, closed);
    ck_assert_int_eq(unit_planar_solve(&u), PH_OK);
    ck_assert_int_eq(certify(), PH_OK);
    for (size_t i = 0; i < sizeof at / sizeof at[0]; i++) {
      const size_t k = at[i], next = k + 1 < u.result.curve.n ? k + 1 : k;
      double *x = &u.result.curve.control_points[12 * k + 4], keep = *x;
      *x += MOVED * N;
      ck_refused(PH_D_PYTHAGOREAN_ERROR, k);
      *x = keep;
      x = &u.problem.field[PH_F_POINTS].v[2 * k];
      keep = *x;
      *x += MOVED * N;
      ck_refused_in(PH_D_INTERPOLATION_ERROR, k > 0 ? k - 1 : 0,
                    k > 0 || !closed ? k : N - 1);
      *x = keep;
      x = &u.result.curve.knots[next];
      keep = *x;
      *x += 1e-4;
      ck_refused_in(PH_D_CONTINUITY_ERROR, next, k);
      *x = keep;
    }
    ck_assert_int_eq(certify(), PH_OK);
    unit_solution_free(&u);
  }
}

/* Other knots: the same arcs, but not C1 with respect to them. */
PH_TEST(test_knots) {
  for (int closed = 0; closed < 2; closed++) {
    solve(closed);
    for (size_t k = 0; k <= u.result.curve.n; k++) {
      double *t = &u.result.curve.knots[k], keep = *t;
      *t += 1e-8;
      ck_assert_int_eq(certify(), PH_E_NO_CONVERGENCE);
      ck_assert_ptr_nonnull(strstr(checked.diag.message, "continuity_error"));
      *t = keep;
    }
    ck_assert_int_eq(certify(), PH_OK);
    unit_solution_free(&u);
  }
}

/* An interval without length, whose jump is not a number, and one of negative
 * length: seen although all that follows is right. */
PH_TEST(test_knots_not_increasing) {
  double *t;
  solve(false);
  t = u.result.curve.knots;
  t[0] = t[1];
  ck_refused(PH_D_CONTINUITY_ERROR, 1);
  t[0] = t[1] + 1;
  ck_refused(PH_D_CONTINUITY_ERROR, 1);
}

/* Two arcs, solved apart, in one curve through three points: they meet with
 * the derivatives left and right. */
static void join(const double left[2], const double right[2]) {
  const double points[] = {0, 0, 1, 0, 2, 1};
  const double ends[2][4] = {{1, -0.5, left[0], left[1]},
                             {right[0], right[1], 0.5, 1}};
  const double knots[] = {0, 1};
  struct unit_solution part[2];
  struct ph_curve *curve = &u.result.curve;
  u = unit_planar_of(points, 3, false);
  unit_planar_rule(&u, "uniform");
  ck_assert_int_eq(unit_planar_solve(&u), PH_OK);
  for (int i = 0; i < 2; i++) {
    const struct ph_curve *arc = &part[i].result.curve;
    part[i] = unit_planar_of(points + 2 * i, 2, false);
    unit_planar_knots(&part[i], knots, 2);
    unit_planar_ends(&part[i], ends[i]);
    ck_assert_int_eq(unit_planar_solve(&part[i]), PH_OK);
    memcpy(curve->control_points + 12 * i, arc->control_points,
           12 * sizeof(double));
    memcpy(curve->preimage.v + 6 * i, arc->preimage.v, 6 * sizeof(double));
    curve->lengths[i] = arc->length;
    unit_solution_free(&part[i]);
  }
  curve->length = curve->lengths[0] + curve->lengths[1];
}

PH_TEST(test_not_c1) {
  const double left[] = {1, 0.5}, right[] = {1, 0.5 + 1e-8};
  join(left, right);
  ck_refused(PH_D_CONTINUITY_ERROR, 1);
}

PH_TEST(test_not_c2) {
  const double slope[] = {1, 0.5};
  join(slope, slope);
  ck_refused(PH_D_CONTINUITY_ERROR, 1);
  ck_assert_double_ge(value_of(PH_D_CONTINUITY_ERROR), 0.1);
}

/* An open curve that comes back to its start is not closed for that. */
PH_TEST(test_not_closed) {
  const double points[] = {0, 0, 2, 1, 3, 0, 5, 2, 0, 0};
  u = unit_planar_of(points, 5, false);
  ck_assert_int_eq(unit_planar_solve(&u), PH_OK);
  u.result.curve.closed = true;
  u.problem.field[PH_F_CLOSED].flag = true;
  ck_refused(PH_D_CONTINUITY_ERROR, 0);
}

PH_TEST(test_end_derivatives) {
  const double ends[] = {1, 0.5, 0.25, -2};
  u = unit_planar_of(SOME, 4, false);
  unit_planar_ends(&u, ends);
  ck_assert_int_eq(unit_planar_solve(&u), PH_OK);
  ck_assert_int_eq(certify(), PH_OK);
  ck_assert_double_le(value_of(PH_D_END_DERIVATIVE_ERROR), 1e-13);
  for (size_t i = 0; i < 4; i++) {
    double *d = &u.problem.field[PH_F_END_DERIVATIVES].v[i], keep = *d;
    *d += 1e-7;
    ck_refused(PH_D_END_DERIVATIVE_ERROR, i < 2 ? 0 : 2);
    ck_rel(value_of(PH_D_END_DERIVATIVE_ERROR),
           1e-7 / hypot(ends[i / 2 * 2], ends[i / 2 * 2 + 1]), 1e-5);
    *d = keep;
  }
  ck_assert_int_eq(certify(), PH_OK);
}

PH_TEST(test_not_finite) {
  solve(false);
  ck_not_finite(u.result.curve.control_points, 12 * u.result.curve.n);
  ck_not_finite(u.result.curve.preimage.v, 6 * u.result.curve.n);
  ck_not_finite(u.result.curve.lengths, u.result.curve.n);
  ck_not_finite(u.result.curve.knots, u.result.curve.n + 1);
  ck_not_finite(&u.result.curve.length, 1);
  ck_assert_int_eq(certify(), PH_OK);
}

PH_TEST(test_no_extent) {
  double *v;
  solve(false);
  v = u.problem.field[PH_F_POINTS].v;
  for (size_t i = 0; i < 8; i++) {
    v[i] = 0;
  }
  ck_assert_int_eq(certify(), PH_E_INTERNAL);
  ck_assert_str_eq(checked.diag.field, "points");
  for (size_t i = 0; i < 8; i++) {
    v[i] = 7;
  }
  ck_assert_int_eq(certify(), PH_E_INTERNAL);
}

/* Everything is relative: by powers of four not a digit changes. */
PH_TEST(test_scales) {
  struct ph_diagnostics unit;
  solve(true);
  ck_assert_int_eq(certify(), PH_OK);
  unit = checked.diagnostics;
  for (int e = -900; e <= 900; e += 300) {
    struct ph_curve *curve = &u.result.curve;
    double v[8];
    for (size_t i = 0; i < 8; i++) {
      v[i] = ldexp(SOME[i], e);
    }
    unit_solution_free(&u);
    u = unit_planar_of(v, 4, true);
    ck_assert_int_eq(unit_planar_solve(&u), PH_OK);
    ck_assert_int_eq(certify(), PH_OK);
    for (int i = PH_D_INTERPOLATION_ERROR; i <= PH_D_LENGTH_ERROR; i++) {
      ck_abs(checked.diagnostics.value[i], unit.value[i], 0);
    }
    curve->control_points[14] += ldexp(MOVED * SIZE, e);
    ck_refused(PH_D_PYTHAGOREAN_ERROR, 1);
    curve->control_points[14] -= ldexp(MOVED * SIZE, e);
    curve->lengths[2] *= 1 + MOVED;
    ck_refused(PH_D_LENGTH_ERROR, 2);
  }
}

/* Points so far from the origin that their rounding is felt: a length may be
 * off by what that makes of it, and no more. */
PH_TEST(test_far_away) {
  double v[8];
  for (size_t i = 0; i < 8; i++) {
    v[i] = SOME[i] + 1e4;
  }
  u = unit_planar_of(v, 4, false);
  ck_assert_int_eq(unit_planar_solve(&u), PH_OK);
  for (size_t k = 0; k < 3; k++) {
    u.result.curve.lengths[k] += 1e-8;
    ck_refused(PH_D_LENGTH_ERROR, k);
    u.result.curve.lengths[k] -= 1e-8;
  }
  u.result.curve.length += 1e-8;
  ck_refused(PH_D_LENGTH_ERROR, 2);
}

/* Of several errors the worst is reported, with its place. */
PH_TEST(test_worst) {
  solve(false);
  u.result.curve.control_points[12 + 4] += 10 * MOVED * SIZE;
  u.result.curve.control_points[24 + 4] += 100 * MOVED * SIZE;
  u.result.curve.control_points[4] += MOVED * SIZE;
  ck_refused(PH_D_PYTHAGOREAN_ERROR, 2);
}

static void solve_atph(bool closed) {
  static const double alpha[] = {0.3, 1, 2.5, 1.2};
  enum ph_status status;
  u = unit_planar_of(SOME, 4, closed);
  unit_planar_atph(&u, alpha, closed ? 4 : 3);
  status = unit_planar_solve(&u);
  ck_assert_msg(status == PH_OK, "%s %s", u.diag.field, u.diag.message);
}

/* The same for ATPH curves. */
PH_TEST_EACH(test_atph, 2) {
  solve_atph(_i);
  ck_assert_int_eq(certify(), PH_OK);
  ck_abs(value_of(PH_D_INTERPOLATION_ERROR), 0, 0);
  ck_assert_double_le(value_of(PH_D_PYTHAGOREAN_ERROR), 1e-12);
  ck_assert_double_le(value_of(PH_D_CONTINUITY_ERROR), 1e-13);
  ck_assert_double_le(value_of(PH_D_LENGTH_ERROR), 2e-14);
  ck_each_moved(u.result.curve.preimage.v, 6 * u.result.curve.n, 6, MOVED,
                PH_D_PYTHAGOREAN_ERROR);
  for (size_t i = 0; i < 12 * u.result.curve.n; i++) {
    double *x = &u.result.curve.control_points[i], keep = *x;
    bool end = i % 12 < 2 || i % 12 >= 10;
    *x += MOVED * SIZE;
    ck_refused(end ? PH_D_INTERPOLATION_ERROR : PH_D_PYTHAGOREAN_ERROR, i / 12);
    *x = keep;
  }
  ck_each_scaled(u.result.curve.lengths, u.result.curve.n, MOVED,
                 PH_D_LENGTH_ERROR);
}

/* Another angle: the hodograph is that of another space.  Also angles that no
 * segment can have. */
PH_TEST_EACH(test_alpha, 2) {
  static const double none[] = {0, -1,          3.1415926535897931,
                                4, (double)NAN, HUGE_VAL};
  solve_atph(_i);
  for (size_t k = 0; k < u.result.curve.n; k++) {
    double *alpha = &u.result.curve.preimage.alpha[k], keep = *alpha;
    *alpha = keep * (1 + 10 * MOVED);
    ck_refused(PH_D_PYTHAGOREAN_ERROR, k);
    for (size_t i = 0; i < COUNT(none); i++) {
      *alpha = none[i];
      ck_assert_int_ne(certify(), PH_OK);
    }
    *alpha = keep;
  }
  ck_assert_int_eq(certify(), PH_OK);
}

static void start(void) {
  checked.command = "planar";
  checked.problem = &u.problem;
  checked.curve = &u.result.curve;
}

PH_FIXTURE(start, finish)
