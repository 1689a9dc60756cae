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

/* A part beside the curve: nowhere is more lost than is said, and on a small
 * part nothing much. */
PH_TEST(test_part) {
  struct unit_random r = unit_random_of(3);
  ph_cplx c[DEGREE_MAX + 1], room[DEGREE_MAX + 1], part[PH_BERN_LOW + 1];
  struct ph_bern_low low;
  int kept = 0, refused = 0;
  for (size_t i = 0; i < DEGREES; i++) {
    size_t n = degrees[i];
    for (int trial = 0; trial < 60; trial++) {
      double h = pow(10, unit_random_in(&r, -5, 0)), lost = 0;
      double from = unit_random_in(&r, 0, 1 - h);
      double allowed = pow(10, unit_random_in(&r, -13, -2));
      make(&r, n, trial % 2 == 1, c);
      ph_bern_low_of(&low, c, n, room);
      if (!ph_bern_low_part(&low, from, from + h, allowed, part, &lost)) {
        refused++;
        continue;
      }
      kept++;
      ck_assert(n >= PH_BERN_HIGH && lost <= allowed);
      for (int at = 0; at <= 20; at++) {
        ph_cplx p = ph_bern_value(c, n, from + h * (at / 20.0));
        ph_cplx q = ph_bern_value(part, PH_BERN_LOW, at / 20.0);
        ck_abs(ph_cplx_abs(ph_cplx_sub(p, q)), 0, lost + 1e-16);
      }
    }
  }
  ck_assert(kept > 60 && refused > 60);
}

PH_TEST(test_part_ends) {
  struct unit_random r = unit_random_of(4);
  ph_cplx c[DEGREE_MAX + 1], room[DEGREE_MAX + 1], part[PH_BERN_LOW + 1];
  struct ph_bern_low low;
  double lost;
  make(&r, 240, false, c);
  ph_bern_low_of(&low, c, 240, room);
  ck_assert(ph_bern_low_part(&low, .5, .51, 2e-13, part, &lost));
  c[100].re = (double)NAN;
  ph_bern_low_of(&low, c, 240, room);
  ck_assert(!ph_bern_low_part(&low, .5, .51, 1, part, &lost));
}
