/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Golden section: minima that are known. */
#include "unit.h"

#include "kernel/golden.h"

enum { STEPS = 40 };

static double bowl(const void *context, double x) {
  const double *at = context;
  return (x - *at) * (x - *at);
}

static double wall(const void *context, double x) {
  return x > *(const double *)context ? HUGE_VAL : -x;
}

/* A place within 1e-8 of the minimum, from any place between. */
PH_TEST(test_bowl) {
  struct unit_random r = unit_random_of(811);
  for (int i = 0; i < unit_count(200); i++) {
    double at = unit_random_in(&r, -1, 1), x = unit_random_in(&r, -1, 1);
    double reach = fmax(1, fabs(x - at));
    struct ph_bracket b = {at - reach, x, at + reach, bowl(&at, x)};
    ph_golden(bowl, &at, 2 * STEPS, &b);
    ck_abs(b.x, at, 1e-8);
    ck_abs(b.value, bowl(&at, b.x), 0);
    ck_assert(b.low <= b.x && b.x <= b.high);
  }
}

/* Where a function is infinite it is no minimum. */
PH_TEST(test_wall) {
  double at = 0.7;
  struct ph_bracket b = {0, 0.5, 1, -0.5};
  ph_golden(wall, &at, 2 * STEPS, &b);
  ck_abs(b.x, at, 1e-8);
  ck_assert(b.x <= at);
}

/* No steps change nothing; an equal value does not count. */
PH_TEST(test_none) {
  double at = 0;
  struct ph_bracket b = {-1, 0, 1, 0};
  ph_golden(bowl, &at, 0, &b);
  ck_abs(b.high - b.low, 2, 0);
  ph_golden(bowl, &at, 3, &b);
  ck_abs(b.x, 0, 0);
}

/* ---- peaks --------------------------------------------------------------- */

struct wave {
  double size[2], at[2], width; /* of two peaks */
  double none;                  /* a place where it is NaN; -1: there is none */
  size_t calls;
};

static double wave(const void *context, double x) {
  struct wave *w = (struct wave *)context;
  double sum = 0;
  w->calls++;
  for (size_t i = 0; i < 2; i++) {
    const double from = (x - w->at[i]) / w->width;
    sum += w->size[i] / (1 + from * from);
  }
  return fabs(x - w->none) > 0 ? sum : (double)NAN;
}

/* Between any places the greatest value is found, and at the first and last. */
PH_TEST(test_greatest) {
  struct unit_random r = unit_random_of(409);
  for (int i = 0; i < unit_count(200); i++) {
    struct wave w = {.size = {1, 0}, .width = 0.1, .none = -1};
    w.at[0] = unit_random_in(&r, 0, 1);
    ck_abs(ph_golden_greatest(wave, &w, 16, 0), 1, 1e-9);
    w.at[0] = i % 2 ? 0 : 1;
    ck_abs(ph_golden_greatest(wave, &w, 16, 0), 1, 0);
  }
}

/* Of two peaks the one that is the greater, though it looks lower at the
 * places; with what was seen elsewhere, which is never lost. */
PH_TEST(test_of_two) {
  struct wave w = {{1, 1.05}, {0.25, 0.72}, 0.1, -1, 0};
  const double both = wave(&w, 0.72);
  ck_assert(wave(&w, 0.25) > wave(&w, 0.75));
  ck_abs(ph_golden_greatest(wave, &w, 4, 0), both, 1e-3);
  ck_abs(ph_golden_greatest(wave, &w, 16, 2), 2, 0);
}

/* Peaks that are low beside what was seen are not looked for. */
PH_TEST(test_low) {
  struct wave w = {.size = {1, 0}, .at = {0.4}, .width = 0.1, .none = -1};
  ph_golden_greatest(wave, &w, 16, 2);
  ck_assert_uint_eq(w.calls, 17);
  ph_golden_greatest(wave, &w, 16, 1);
  ck_assert_uint_eq(w.calls, 17 + 17 + 24);
}

/* What is NaN at a place has no greatest value. */
PH_TEST(test_nan) {
  for (size_t i = 0; i <= 16; i++) {
    struct wave w = {.size = {1, 0}, .at = {0.4}, .width = 0.1};
    w.none = (double)i / 16;
    ck_assert(isnan(ph_golden_greatest(wave, &w, 16, 0.5)));
  }
}
