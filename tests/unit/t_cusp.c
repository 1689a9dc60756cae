/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Cusps of offsets: none is missed and none is counted twice.  This test
 * includes the source, for the form whose roots they are.
 */
#include "curve/cusp.c" /* NOLINT */

#include "kernel/bern.h"
#include "unit.h"
#include "seg2_unit.h"

enum { SEGMENTS = 200 };

/* The form is |w|^4 (1 - d kappa). */
START_TEST(test_form) {
  struct unit_random r = unit_random_of(510);
  for (size_t n = 0; n < SEGMENTS; n++) {
    struct ph_seg2 seg = unit_seg2_random(&r);
    double d = unit_random_in(&r, -2, 2);
    struct form form = form_of(&seg, d);
    for (size_t i = 0; i <= 20; i++) {
      double s[2], basis[DEGREE + 1], scale;
      double value = 0, u = (double)i / 20, size = 0;
      struct ph_bend bend = ph_seg2_bend(&seg, u);
      double speed2 = bend.speed * bend.speed;
      ph_atph_basis(&seg.space, u, s);
      scale = pow(s[0] + s[1], DEGREE);
      ph_bern_basis(DEGREE, s[1] / (s[0] + s[1]), basis);
      for (size_t k = 0; k <= DEGREE; k++) {
        double term = scale * basis[k] * form.b[k];
        value += term;
        size += fabs(term);
      }
      size += speed2 * (1 + fabs(d) * sqrt(bend.terms[0]));
      ck_abs(value, speed2 * (1 - d * bend.curvature), 1e-13 * size);
    }
  }
}
END_TEST

/* As many as 1 - d kappa has changes of sign at many points, where it is not
 * nearly zero without one. */
START_TEST(test_count) {
  enum { STEPS = 4000 };
  struct unit_random r = unit_random_of(511);
  size_t some = 0;
  for (size_t n = 0; n < SEGMENTS; n++) {
    struct ph_seg2 seg = unit_seg2_random(&r);
    double d = unit_random_in(&r, -2, 2), first = -1, before = 0;
    struct unit_segments s;
    struct ph_cusps cusps;
    size_t changes = 0;
    for (size_t i = 0; i <= STEPS; i++) {
      double at = 1 - d * ph_seg2_bend(&seg, (double)i / STEPS).curvature;
      if (i && (at > 0) != (before > 0)) {
        first = changes ? first : (double)i / STEPS;
        changes++;
      }
      before = at;
    }
    unit_seg2_curve(&seg, 1, &s);
    cusps = ph_cusps_planar(&s.curve, d);
    ck_assert_uint_eq(cusps.n, changes);
    if (changes) {
      ck_assert_uint_eq(cusps.segment, 0);
      ck_abs(cusps.u, first - 0.5 / STEPS, 0.51 / STEPS);
      ck_abs(d * ph_seg2_bend(&seg, cusps.u).curvature, 1, 1e-9);
    }
    some += changes > 0;
  }
  ck_assert_uint_ge(some, SEGMENTS / 5);
}
END_TEST

/* w = 1 + p t has kappa = 2 Im p / |w|^4 by t; that is 2 Im p at t = 0, and in
 * [-1,1] nowhere else.  All of these numbers are exact. */
static struct ph_seg2 linear(double from, double to) {
  const ph_cplx p = {0.25, 0.5}, one = {1, 0};
  ph_cplx w[3];
  w[0] = ph_cplx_add(one, ph_cplx_scale(from, p));
  w[1] = ph_cplx_add(one, ph_cplx_scale((from + to) / 2, p));
  w[2] = ph_cplx_add(one, ph_cplx_scale(to, p));
  return unit_seg2(0, w);
}

START_TEST(test_at_knot) {
  struct ph_seg2 seg[2] = {linear(-1, 0), linear(0, 1)};
  struct unit_segments s;
  struct ph_cusps cusps;
  unit_seg2_curve(seg, 2, &s);
  cusps = ph_cusps_planar(&s.curve, 1);
  ck_assert_uint_eq(cusps.n, 1);
  ck_abs((double)cusps.segment + cusps.u, 1, 1e-12);
  ck_assert_uint_eq(ph_cusps_planar(&s.curve, -1).n, 0);
  ck_assert_uint_eq(ph_cusps_planar(&s.curve, 0).n, 0);
}
END_TEST

START_TEST(test_at_half) {
  struct ph_seg2 seg = linear(-1, 1);
  struct unit_segments s;
  struct ph_cusps cusps;
  unit_seg2_curve(&seg, 1, &s);
  cusps = ph_cusps_planar(&s.curve, 0.5); /* u goes half as fast as t */
  ck_assert_uint_eq(cusps.n, 1);
  ck_abs(cusps.u, 0.5, 1e-12);
}
END_TEST

static Suite *suite(void) {
  Suite *s = suite_create("cusp");
  TCase *t = tcase_create("cusp");
  tcase_add_test(t, test_form);
  tcase_add_test(t, test_count);
  tcase_add_test(t, test_at_knot);
  tcase_add_test(t, test_at_half);
  suite_add_tcase(s, t);
  return s;
}

PH_TEST_MAIN(suite)
