/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Bounds of the distance between cubics and a curve: never below what points of
 * both show, and hardly above it.
 */
#include "unit.h"

#include "check/tc_distance.h"

enum { DEGREE_MAX = 40, SAMPLES = 150 };

static struct ph_check_distance d;

static void begin(double allowed) {
  ck_assert(ph_check_distance_begin(&d, &unit_arena, DEGREE_MAX, allowed));
}

/* The bound for one cubic and the whole of a curve. */
static double bound_of(const ph_cplx *curve, size_t degree,
                       const ph_cplx cubic[4]) {
  begin(HUGE_VAL);
  ph_check_distance_curve(&d, curve, degree);
  ph_check_distance_add(&d, 0, 1, cubic);
  return d.bound;
}

static ph_cplx bezier(const ph_cplx *p, size_t degree, double t) {
  ph_cplx b[DEGREE_MAX + 1];
  memcpy(b, p, (degree + 1) * sizeof *b);
  for (size_t n = degree; n > 0; n--) {
    for (size_t k = 0; k < n; k++) {
      b[k] =
          ph_cplx_add(ph_cplx_scale(1 - t, b[k]), ph_cplx_scale(t, b[k + 1]));
    }
  }
  return b[0];
}

/* One degree more. */
static void raise(ph_cplx *p, size_t degree) {
  p[degree + 1] = p[degree];
  for (size_t k = degree; k > 0; k--) {
    double f = (double)k / ((double)degree + 1);
    p[k] = ph_cplx_add(ph_cplx_scale(f, p[k - 1]), ph_cplx_scale(1 - f, p[k]));
  }
}

static double to_segment(ph_cplx p, ph_cplx a, ph_cplx b) {
  ph_cplx along = ph_cplx_sub(b, a);
  double t = ph_cplx_dot(ph_cplx_sub(p, a), along) / ph_cplx_norm2(along);
  t = t > 0 ? t : 0;
  t = t < 1 ? t : 1;
  return unit_distance(p, ph_cplx_add(a, ph_cplx_scale(t, along)));
}

/* The largest distance of points of one curve from chords of the other. */
static double one_way(const ph_cplx *p, size_t n, const ph_cplx *q, size_t m) {
  ph_cplx chord[SAMPLES + 1];
  double largest = 0;
  for (int i = 0; i <= SAMPLES; i++) {
    chord[i] = bezier(q, m, (double)i / SAMPLES);
  }
  for (int i = 0; i <= SAMPLES; i++) {
    ph_cplx at = bezier(p, n, (double)i / SAMPLES);
    double nearest = HUGE_VAL;
    for (int k = 0; k < SAMPLES; k++) {
      double away = to_segment(at, chord[k], chord[k + 1]);
      nearest = away < nearest ? away : nearest;
    }
    largest = unit_larger(largest, nearest);
  }
  return largest;
}

static double seen(const ph_cplx *curve, size_t degree,
                   const ph_cplx cubic[4]) {
  return unit_larger(one_way(curve, degree, cubic, 3),
                     one_way(cubic, 3, curve, degree));
}

/* A cubic without a hairpin. */
static void gentle(struct unit_random *r, ph_cplx p[4]) {
  for (size_t k = 0; k < 4; k++) {
    p[k] = ph_cplx_of((double)k / 3 + unit_random_in(r, -.1, .1),
                      unit_random_in(r, -.2, .2));
  }
}

/* Curves of every degree that are the cubic: nothing but rounding. */
PH_TEST(test_same) {
  struct unit_random r = unit_random_of(401);
  for (int i = 0; i < unit_count(20); i++) {
    ph_cplx cubic[4], curve[DEGREE_MAX + 1];
    gentle(&r, cubic);
    memcpy(curve, cubic, sizeof cubic);
    for (size_t n = 3; n < DEGREE_MAX; n++) {
      ck_assert_double_le(bound_of(curve, n, cubic), 2e-13 * (double)(n + 1));
      raise(curve, n);
    }
  }
}

/* A line, travelled at all speeds. */
PH_TEST(test_line) {
  struct unit_random r = unit_random_of(402);
  const ph_cplx cubic[4] = {{0, 0}, {1, .5}, {2, 1}, {3, 1.5}};
  for (size_t n = 1; n <= 12; n++) {
    ph_cplx curve[13] = {{0, 0}};
    double x = 0;
    for (size_t k = 1; k <= n; k++) {
      x += unit_random_below(&r, 3) ? unit_random_in(&r, 0, 1) : 0;
      x = k == n && x <= 0 ? 1 : x;
      curve[k] = ph_cplx_of(x, 0);
    }
    for (size_t k = 1; k <= n; k++) {
      curve[k] = ph_cplx_of(3 * curve[k].re / x, 1.5 * curve[k].re / x);
    }
    ck_assert_double_le(bound_of(curve, n, cubic), 1e-12);
  }
}

/* The graph of a polynomial over its parameter, against the axis: the distance
 * is the largest value. */
PH_TEST(test_known) {
  const ph_cplx cubic[4] = {{0, 0}, {1.0 / 3, 0}, {2.0 / 3, 0}, {1, 0}};
  static const double heights[] = {1e-12, 1e-6, 1e-3, .1};
  for (size_t i = 0; i < 4; i++) {
    double found, height = 0.3456 * heights[i]; /* 10 .4^2 .6^3 */
    ph_cplx curve[6];
    for (size_t k = 0; k < 6; k++) {
      curve[k] = ph_cplx_of((double)k / 5, k == 2 ? heights[i] : 0);
    }
    found = bound_of(curve, 5, cubic);
    ck_assert_double_ge(found, height);
    ck_assert_double_le(found, 1.06 * height + 1e-13);
    /* a part of it, where the largest value is not */
    begin(HUGE_VAL);
    ph_check_distance_curve(&d, curve, 5);
    ph_check_distance_add(&d, 0, 1, cubic);
    ck_rel(d.bound, found, 0);
  }
}

/* Random curves near a cubic, and cubics anywhere. */
PH_TEST(test_random) {
  struct unit_random r = unit_random_of(403);
  for (int i = 0; i < unit_count(60); i++) {
    size_t n = 3 + unit_random_below(&r, 9);
    double height = pow(10, unit_random_in(&r, -6, -1.5)), found, least;
    ph_cplx cubic[4], curve[DEGREE_MAX + 1];
    gentle(&r, cubic);
    memcpy(curve, cubic, sizeof cubic);
    for (size_t m = 3; m < n; m++) {
      raise(curve, m);
    }
    for (size_t k = 1; k < n; k++) {
      curve[k] = ph_cplx_add(curve[k], unit_random_cplx(&r, height));
    }
    least = seen(curve, n, cubic);
    found = bound_of(curve, n, cubic);
    ck_assert_double_ge(found, least * (1 - 1e-3));
    ck_assert_double_le(found, 1.08 * least);
    for (size_t k = 0; k < 4; k++) {
      cubic[k] = unit_random_cplx(&r, 2);
    }
    ck_assert_double_ge(bound_of(curve, n, cubic),
                        seen(curve, n, cubic) * (1 - 1e-3));
  }
}

/* A curve that stands still at an end: r(t^2), r((t^2 (3 - t)/2). */
PH_TEST(test_standing_still) {
  const ph_cplx cubic[4] = {{0, 0}, {.3, .1}, {.7, .2}, {1, -.1}};
  /* 1, s, s^2, s^3 of r, then t^0, t^2, t^4, t^6 in Bernstein form */
  const ph_cplx power[4] = {
      cubic[0], ph_cplx_scale(3, ph_cplx_sub(cubic[1], cubic[0])),
      ph_cplx_scale(3, ph_cplx_add(ph_cplx_sub(cubic[0], cubic[1]),
                                   ph_cplx_sub(cubic[2], cubic[1]))),
      ph_cplx_sub(ph_cplx_sub(cubic[3], cubic[0]),
                  ph_cplx_scale(3, ph_cplx_sub(cubic[2], cubic[1])))};
  static const double binomial[7] = {1, 6, 15, 20, 15, 6, 1};
  ph_cplx curve[7];
  for (size_t k = 0; k < 7; k++) {
    double choose = 1; /* k over i */
    curve[k] = power[0];
    for (size_t i = 1; i <= k; i++) {
      choose *= (double)(k - i + 1) / (double)i;
      if (i % 2 == 0) {
        curve[k] = ph_cplx_add(
            curve[k], ph_cplx_scale(choose / binomial[i], power[i / 2]));
      }
    }
  }
  ck_abs(unit_distance(curve[0], curve[1]), 0, 0);
  ck_assert_double_le(bound_of(curve, 6, cubic), 1e-11);
}

/* Parts of a curve, and the largest of several bounds. */
PH_TEST(test_parts) {
  struct unit_random r = unit_random_of(404);
  ph_cplx curve[8], cubic[4], moved[4];
  for (size_t k = 0; k < 8; k++) {
    curve[k] = ph_cplx_of((double)k, unit_random_in(&r, -1, 1));
  }
  /* the part [.5,.6], a tenth of it as derivatives */
  cubic[0] = bezier(curve, 7, .5);
  cubic[3] = bezier(curve, 7, .6);
  cubic[1] = bezier(curve, 7, .5 + .1 / 3);
  cubic[2] = bezier(curve, 7, .6 - .1 / 3);
  begin(HUGE_VAL);
  ph_check_distance_curve(&d, curve, 7);
  ph_check_distance_add(&d, .5, .6, cubic);
  ck_assert_double_le(d.bound, .01);
  memcpy(moved, cubic, sizeof moved);
  for (size_t k = 0; k < 4; k++) {
    moved[k].im += .1;
  }
  ph_check_distance_curve(&d, curve, 7);
  ph_check_distance_add(&d, .5, .6, moved);
  ck_assert_double_ge(d.bound, .09);
  ph_check_distance_curve(&d, curve, 7);
  ph_check_distance_add(&d, .5, .6, cubic);
  ck_assert_double_ge(d.bound, .09);
  begin(HUGE_VAL);
  ph_check_distance_curve(&d, curve, 7);
  ph_check_distance_add(&d, .4, .5, cubic);
  ck_assert_double_ge(d.bound, .5);
  begin(HUGE_VAL);
  ph_check_distance_curve(&d, curve, 7);
  ph_check_distance_add(&d, .5, .5, cubic); /* a point */
  ck_assert_double_ge(d.bound, unit_distance(cubic[0], cubic[3]));
  ck_assert_double_le(d.bound, 1.1 * unit_distance(cubic[0], cubic[3]));
}

/* The same line the other way. */
PH_TEST(test_backward) {
  const ph_cplx cubic[4] = {{0, 0}, {1, 0}, {2, 0}, {3, 0}};
  const ph_cplx back[4] = {{3, 0}, {2, 0}, {1, 0}, {0, 0}};
  ck_assert_double_ge(bound_of(back, 3, cubic), 3 * (1 - 1e-12));
}

/* What is claimed is come near to, where there is a difference. */
PH_TEST(test_allowed) {
  const ph_cplx cubic[4] = {{0, 0}, {1.0 / 3, 0}, {2.0 / 3, 0}, {1, 0}};
  ph_cplx curve[6];
  for (size_t k = 0; k < 6; k++) {
    curve[k] = ph_cplx_of((double)k / 5, k == 2 ? 1e-3 : 0);
  }
  begin(1.0005 * 0.3456e-3);
  ph_check_distance_curve(&d, curve, 5);
  ph_check_distance_add(&d, 0, 1, cubic);
  ck_assert_double_le(d.bound, d.allowed + d.noise);
  begin(0.9 * 0.3456e-3);
  ph_check_distance_curve(&d, curve, 5);
  ph_check_distance_add(&d, 0, 1, cubic);
  ck_assert_double_ge(d.bound, 0.3456e-3);
}
