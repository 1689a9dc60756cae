/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Forms of high degree beside de Casteljau's algorithm. */
#include "unit.h"

#include "kernel/bern.h"
#include "kernel/bern_low.h"

enum { DEGREE_MAX = 500, PLACES = 9 };

static const size_t degrees[] = {1, 2, 5, 33, 60, 240, 500};
enum { DEGREES = sizeof degrees / sizeof degrees[0] };

/* Points of a wave; or, where it is rough, anywhere. */
static void make(struct unit_random *r, size_t degree, bool rough, ph_cplx *c) {
  double phase = unit_random_in(r, 0, 6);
  for (size_t k = 0; k <= degree; k++) {
    double t = (double)k / (double)degree;
    c[k] = rough
               ? ph_cplx_of(unit_random_in(r, -1, 1), unit_random_in(r, -1, 1))
               : ph_cplx_of(t, .2 * sin(20 * t + phase));
  }
}

PH_TEST(test_value) {
  struct unit_random r = unit_random_of(1);
  ph_cplx c[DEGREE_MAX + 1], left[DEGREE_MAX + 1], right[DEGREE_MAX + 1];
  for (size_t i = 0; i < DEGREES; i++) {
    size_t n = degrees[i];
    double noise = 8 * (double)n * DBL_EPSILON;
    for (int at = 0; at <= PLACES; at++) {
      double u = at == 1 ? 1e-300 : at == 8 ? 1 - 1e-16 : at / (double)PLACES;
      make(&r, n, at % 2 == 1, c);
      ph_bern_cut(c, n, u, left, right);
      ck_abs(ph_cplx_abs(ph_cplx_sub(ph_bern_value(c, n, u), right[0])), 0,
             noise);
    }
  }
}

/* Against the derivative's own form. */
PH_TEST(test_slope) {
  struct unit_random r = unit_random_of(2);
  ph_cplx c[DEGREE_MAX + 1], leg[DEGREE_MAX + 1];
  for (size_t i = 0; i < DEGREES; i++) {
    size_t n = degrees[i];
    for (int at = 0; at <= PLACES; at++) {
      double u = at / (double)PLACES;
      ph_cplx away;
      make(&r, n, at % 2 == 1, c);
      for (size_t k = 0; k < n; k++) {
        leg[k] = ph_cplx_scale((double)n, ph_cplx_sub(c[k + 1], c[k]));
      }
      away = ph_cplx_sub(ph_bern_slope(c, n, u), ph_bern_value(leg, n - 1, u));
      ck_abs(ph_cplx_abs(away), 0, 8 * (double)(n * n) * DBL_EPSILON);
    }
  }
}

/* Nowhere does a part lose more than is said. */
static void ck_part(const ph_cplx *c, size_t n, double from, double h,
                    const ph_cplx *part, size_t degree, double lost) {
  for (int at = 0; at <= 20; at++) {
    ph_cplx p = ph_bern_value(c, n, from + h * (at / 20.0));
    ph_cplx q = ph_bern_value(part, degree, at / 20.0);
    ck_abs(ph_cplx_abs(ph_cplx_sub(p, q)), 0, lost + 1e-16);
  }
}

/* A part beside the curve: nowhere is more lost than is said, and on a small
 * part nothing much. */
PH_TEST(test_part) {
  struct unit_random r = unit_random_of(3);
  ph_cplx c[DEGREE_MAX + 1], room[DEGREE_MAX + 1], part[DEGREE_MAX + 1];
  struct ph_bern_low low;
  int kept = 0, refused = 0;
  for (size_t i = 0; i < DEGREES; i++) {
    size_t n = degrees[i];
    for (int trial = 0; trial < 60; trial++) {
      double h = pow(10, unit_random_in(&r, -5, 0)), lost = 0;
      double from = unit_random_in(&r, 0, 1 - h);
      double allowed = pow(10, unit_random_in(&r, -13, -2));
      size_t degree;
      make(&r, n, trial % 2 == 1, c);
      ph_bern_low_of(&low, c, n, room);
      degree = ph_bern_low_part(&low, from, from + h, allowed, part, &lost);
      if (degree == 0) {
        refused++;
        continue;
      }
      kept++;
      ck_assert(n >= PH_BERN_HIGH && lost <= allowed);
      ck_part(c, n, from, h, part, degree, lost);
    }
  }
  ck_assert(kept > 60 && refused > 60);
}

/* A wave of a high degree needs no cut of its own, whatever part is asked for:
 * what is rounding in its differences is none in what stands for it. */
PH_TEST(test_part_wide) {
  struct unit_random r = unit_random_of(5);
  ph_cplx c[DEGREE_MAX + 1], room[DEGREE_MAX + 1], part[DEGREE_MAX + 1];
  int middle = 0;
  for (int trial = 0; trial < 60; trial++) {
    struct ph_bern_low low;
    size_t n = 240 + unit_random_below(&r, 261);
    double h = unit_random_in(&r, .1, 1), from = unit_random_in(&r, 0, 1 - h);
    double lost;
    size_t degree;
    make(&r, n, false, c);
    ph_bern_low_of(&low, c, n, room);
    degree = ph_bern_low_part(&low, from, from + h, 1e-10, part, &lost);
    ck_that(degree > 0, "degree %zu, %g from %g", n, h, from);
    ck_part(c, n, from, h, part, degree, lost);
    middle += degree > PH_BERN_LOW;
  }
  ck_assert(middle > 10);
}

/* Nor does a rough one, on a part of about its waves away from its ends. */
PH_TEST(test_part_rough) {
  struct unit_random r = unit_random_of(6);
  ph_cplx c[DEGREE_MAX + 1], room[DEGREE_MAX + 1], part[DEGREE_MAX + 1];
  for (int trial = 0; trial < 60; trial++) {
    struct ph_bern_low low;
    size_t n = 100 + unit_random_below(&r, 401);
    double h = .5 / sqrt((double)n), from = unit_random_in(&r, .1, .9 - h);
    double lost;
    size_t degree;
    make(&r, n, true, c);
    ph_bern_low_of(&low, c, n, room);
    degree = ph_bern_low_part(&low, from, from + h, 1e-9, part, &lost);
    ck_that(degree == PH_BERN_LOW, "%zu: %zu, %g from %g", n, degree, h, from);
    ck_part(c, n, from, h, part, degree, lost);
  }
}

PH_TEST(test_part_ends) {
  struct unit_random r = unit_random_of(4);
  ph_cplx c[DEGREE_MAX + 1], room[DEGREE_MAX + 1], part[DEGREE_MAX + 1];
  struct ph_bern_low low;
  double lost;
  make(&r, 240, false, c);
  ph_bern_low_of(&low, c, 240, room);
  ck_assert(ph_bern_low_part(&low, .5, .51, 2e-13, part, &lost));
  c[100].re = (double)NAN;
  ph_bern_low_of(&low, c, 240, room);
  ck_assert(!ph_bern_low_part(&low, .5, .51, 1, part, &lost));
}
