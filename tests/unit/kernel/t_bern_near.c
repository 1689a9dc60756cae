/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A polynomial of a middle degree in the place of one of a high degree. */
#include "unit.h"

#include "kernel/bern.h"
#include "kernel/bern_low.h"

enum { DEGREE_MAX = 500, PLACES = 64 };

static ph_cplx c[DEGREE_MAX + 1], room[DEGREE_MAX + 1];
static ph_cplx near_it[PH_BERN_NEAR + 1];

/* A wave, and what is rough of it. */
static void make(struct unit_random *r, size_t degree, double waves,
                 double rough) {
  double phase = unit_random_in(r, 0, 6);
  for (size_t k = 0; k <= degree; k++) {
    double t = (double)k / (double)degree;
    c[k] = ph_cplx_of(t, .2 * sin(waves * t + phase));
    c[k] = ph_cplx_add(c[k], unit_random_cplx(r, rough));
  }
}

/* The largest distance of values. */
static double apart(size_t degree, size_t middle) {
  double away = 0;
  for (size_t i = 0; i <= PLACES; i++) {
    double u = (double)i / PLACES;
    ph_cplx there = ph_bern_value(near_it, middle, u);
    away = unit_larger(
        away, ph_cplx_abs(ph_cplx_sub(there, ph_bern_value(c, degree, u))));
  }
  return away;
}

/* Waves have one that is as near as rounding; nowhere is any further away than
 * is said, also of what is rough by little. */
PH_TEST(test_away) {
  struct unit_random r = unit_random_of(1);
  size_t smooth = 0, rough = 0;
  for (int trial = 0; trial < 300; trial++) {
    size_t n =
        PH_BERN_FAR + unit_random_below(&r, DEGREE_MAX - PH_BERN_FAR + 1);
    double by = trial % 3 ? 0 : pow(10, unit_random_in(&r, -16, -13)), away;
    size_t middle;
    make(&r, n, unit_random_in(&r, 0, 20), by);
    middle = ph_bern_near(c, n, room, near_it, &away);
    if (middle == 0) {
      ck_assert(by > 0);
      continue;
    }
    ck_assert(middle <= PH_BERN_NEAR && (by > 0 || away < 1e-11));
    ck_abs(apart(n, middle), 0, away + 1e-15 * sqrt((double)n));
    *(by > 0 ? &rough : &smooth) += 1;
  }
  ck_assert(smooth == 200 && rough > 10);
}

/* A polynomial of a low degree that was raised is itself. */
PH_TEST(test_raised) {
  struct unit_random r = unit_random_of(2);
  for (size_t degree = 1; degree <= 20; degree++) {
    ph_cplx low[21];
    double away;
    size_t middle;
    for (size_t k = 0; k <= degree; k++) {
      low[k] = unit_random_cplx(&r, 1);
    }
    ph_bern_lift(low, degree, 400, c);
    middle = ph_bern_near(c, 400, room, near_it, &away);
    ck_assert(middle == degree && away < 1e-13 * (double)(1u << degree));
    for (size_t k = 0; k <= degree; k++) {
      ck_abs(ph_cplx_abs(ph_cplx_sub(near_it[k], low[k])), 0,
             1e-14 * pow(4, (double)degree));
    }
  }
}

/* Raised from as high as the middle degree: the same values. */
PH_TEST(test_lift) {
  struct unit_random r = unit_random_of(4);
  for (size_t degree = 10; degree <= PH_BERN_NEAR; degree++) {
    for (size_t k = 0; k <= degree; k++) {
      near_it[k] = unit_random_cplx(&r, 1);
    }
    ph_bern_lift(near_it, degree, DEGREE_MAX, c);
    ck_abs(apart(DEGREE_MAX, degree), 0, 1e-14);
  }
}

/* What is not smooth, of a low degree, or no number has none. */
PH_TEST(test_none) {
  struct unit_random r = unit_random_of(3);
  double away;
  make(&r, 480, 20, 1);
  ck_assert(ph_bern_near(c, 480, room, near_it, &away) == 0);
  make(&r, 480, 200, 0);
  ck_assert(ph_bern_near(c, 480, room, near_it, &away) == 0);
  make(&r, PH_BERN_FAR - 1, 2, 0);
  ck_assert(ph_bern_near(c, PH_BERN_FAR - 1, room, near_it, &away) == 0);
  make(&r, 480, 20, 0);
  ck_assert(ph_bern_near(c, 480, room, near_it, &away) > 0);
  c[100].im = (double)NAN;
  ck_assert(ph_bern_near(c, 480, room, near_it, &away) == 0);
}
