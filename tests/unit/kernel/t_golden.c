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
