/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Planar splines that are known in closed form. */
#include "unit.h"
#include "segment_unit.h"
#include "planar_unit.h"

static struct unit_solution u;

static void finish(void) {
  unit_solution_free(&u);
}

static void begin(const double *v, size_t n) {
  unit_solution_free(&u);
  u = unit_planar_of(v, n, false);
}

static void ck_solved(void) {
  enum ph_status status = unit_planar_solve(&u);
  ck_assert_msg(status == PH_OK, "seed %lu: %s %s", unit_seed(), u.diag.field,
                u.diag.message);
}

/* Two points without end derivatives: their chord. */
PH_TEST(test_line_segment) {
  const double points[] = {1, 1, 4, 5};
  begin(points, 2);
  ck_solved();
  ck_rel(u.result.curve.length, 5, 1e-15);
  for (int i = 0; i < 6; i++) {
    ck_abs(u.result.curve.control_points[2 * i], 1 + 0.6 * i, 1e-15);
    ck_abs(u.result.curve.control_points[2 * i + 1], 1 + 0.8 * i, 2e-15);
  }
}

/* Points on a line, at any spacing: the line, with unit speed. */
PH_TEST(test_collinear) {
  struct unit_random r = unit_random_of(2);
  for (int i = 0; i < 100; i++) {
    ph_cplx direction = ph_cplx_polar(unit_random_in(&r, -3, 3));
    double v[40], t[20] = {0};
    size_t n = 2 + unit_random_below(&r, 19);
    for (size_t k = 0; k < n; k++) {
      t[k] = k ? t[k - 1] + pow(10, unit_random_in(&r, -3, 1)) : 0;
      v[2 * k] = t[k] * direction.re;
      v[2 * k + 1] = t[k] * direction.im;
    }
    begin(v, n);
    ck_solved();
    ck_rel(u.result.curve.length, t[n - 1], 1e-13);
    ck_assert_uint_eq(u.result.warnings_n, 0);
    for (size_t k = 0; k + 1 < n; k++) {
      double at = unit_random_in(&r, 0, 1);
      double s = t[k] + at * (t[k + 1] - t[k]);
      ck_assert_double_le(unit_distance(unit_curve(&u.result.curve, k, 0, at),
                                        ph_cplx_scale(s, direction)),
                          1e-13 * t[n - 1]);
    }
  }
}

/*
 * One segment with end derivatives: the first-order Hermite interpolant of
 * Farouki and Neff (1995), whose middle coefficient solves a quadratic:
 *   w1 = (-3 (w0 + w2) +- sqrt(120 c - 15 (w0^2 + w2^2) + 10 w0 w2)) / 4,
 * c the chord.  With the chord to the right and ends that point there as well,
 * the one without loops has the principal roots throughout.
 */
static void hermite(const double d[4], ph_cplx w[3]) {
  ph_cplx squares, sum, root;
  w[0] = ph_cplx_sqrt(ph_cplx_of(d[0], d[1]));
  w[2] = ph_cplx_sqrt(ph_cplx_of(d[2], d[3]));
  squares = ph_cplx_add(ph_cplx_mul(w[0], w[0]), ph_cplx_mul(w[2], w[2]));
  sum = ph_cplx_sub(ph_cplx_of(120, 0), ph_cplx_scale(15, squares));
  sum = ph_cplx_add(sum, ph_cplx_scale(10, ph_cplx_mul(w[0], w[2])));
  root = ph_cplx_sqrt(sum);
  sum = ph_cplx_scale(-3, ph_cplx_add(w[0], w[2]));
  w[1] = ph_cplx_scale(0.25, ph_cplx_add(sum, root));
}

PH_TEST(test_hermite) {
  const double points[] = {0, 0, 1, 0};
  struct unit_random r = unit_random_of(3);
  for (int i = 0; i < 300; i++) {
    double d[4];
    ph_cplx w[3], p[6];
    begin(points, 2);
    for (int side = 0; side < 2; side++) {
      ph_cplx end = ph_cplx_scale(unit_random_in(&r, 0.5, 2),
                                  ph_cplx_polar(unit_random_in(&r, -1, 1)));
      d[2 * side] = end.re;
      d[2 * side + 1] = end.im;
    }
    unit_planar_ends(&u, d);
    ck_solved();
    hermite(d, w);
    ph_control_points(w, ph_cplx_of(0, 0), ph_cplx_of(1, 0), p);
    ck_rel(u.result.curve.length, ph_length(w), 1e-13);
    for (int k = 0; k < 6; k++) {
      const double *q = u.result.curve.control_points + 2 * k;
      ck_assert_double_le(unit_distance(p[k], ph_cplx_of(q[0], q[1])), 1e-13);
    }
  }
}

/* A PH quintic cut into pieces, given its derivatives at the ends, is found
 * again: it is C2 and PH, and turns too little for another solution. */
PH_TEST(test_reproduction) {
  const double knots[] = {0, 0.15, 0.4, 0.5, 0.8, 1};
  struct unit_random r = unit_random_of(4);
  for (int i = 0; i < 200; i++) {
    ph_cplx w[3], p[6], end = {0, 0}, hodograph[5];
    double flat[12], v[12], ends[4];
    for (int k = 0; k < 3; k++) {
      w[k] = ph_cplx_add(ph_cplx_of(1.5, 0), unit_random_cplx(&r, 0.7));
    }
    ph_hodograph(w, hodograph);
    for (int k = 0; k < 5; k++) {
      end = ph_cplx_add(end, ph_cplx_scale(0.2, hodograph[k]));
    }
    ph_control_points(w, ph_cplx_of(0, 0), end, p);
    memcpy(flat, p, sizeof flat);
    for (int k = 0; k < 6; k++) {
      ph_cplx q = unit_bezier(flat, 5, 0, knots[k]);
      v[2 * k] = q.re;
      v[2 * k + 1] = q.im;
    }
    begin(v, 6);
    unit_planar_knots(&u, knots, 6);
    ends[0] = hodograph[0].re;
    ends[1] = hodograph[0].im;
    ends[2] = hodograph[4].re;
    ends[3] = hodograph[4].im;
    unit_planar_ends(&u, ends);
    ck_solved();
    ck_rel(u.result.curve.length, ph_length(w), 1e-12);
    for (size_t k = 0; k < 5; k++) {
      double at = unit_random_in(&r, 0, 1);
      ph_cplx wanted =
          unit_bezier(flat, 5, 0, knots[k] + at * (knots[k + 1] - knots[k]));
      ck_assert_msg(
          unit_distance(unit_curve(&u.result.curve, k, 0, at), wanted) <= 1e-12,
          "seed %lu, curve %d, segment %zu: %.3g", unit_seed(), i, k,
          unit_distance(unit_curve(&u.result.curve, k, 0, at), wanted));
    }
  }
}

PH_FIXTURE(NULL, finish)
