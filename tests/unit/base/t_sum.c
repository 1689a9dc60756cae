/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Compensated summation: sums whose exact value is known. */
#include "unit.h"

#include "base/sum.h"

static double sum_of(const double *x, size_t n) {
  struct ph_sum sum = {0, 0};
  for (size_t i = 0; i < n; i++) {
    ph_sum_add(&sum, x[i]);
  }
  return ph_sum_value(&sum);
}

PH_TEST(test_nothing) {
  ck_abs(sum_of(NULL, 0), 0, 0);
}

/* Plain summation gives 0; so does Kahan's without Neumaier's comparison. */
PH_TEST(test_cancellation) {
  const double x[] = {1, 1e100, 1, -1e100};
  ck_abs(sum_of(x, 4), 2, 0);
}

/* A tenth, a million times: plain summation misses by 1.3e-6. */
PH_TEST(test_many) {
  struct ph_sum sum = {0, 0};
  for (int i = 0; i < 1000000; i++) {
    ph_sum_add(&sum, 0.1);
  }
  /* 1e6 times the double next to 0.1, correctly rounded */
  ck_rel(ph_sum_value(&sum), 1e5, DBL_EPSILON);
}

/* Numbers with their negatives in another order, and one left over. */
PH_TEST(test_pairs) {
  enum { PAIRS = 500 };
  struct unit_random r = unit_random_of(1);
  for (int trial = 0; trial < 100; trial++) {
    double x[2 * PAIRS + 1], extra = unit_random_in(&r, 1, 2);
    for (size_t i = 0; i < PAIRS; i++) {
      x[i] = ldexp(unit_random_in(&r, -1, 1), (int)(i % 40));
      x[PAIRS + 1 + i] = -x[i];
    }
    x[PAIRS] = extra;
    for (size_t i = 2 * PAIRS; i > 0; i--) {
      size_t j = unit_random_below(&r, i + 1);
      double keep = x[i];
      x[i] = x[j];
      x[j] = keep;
    }
    ck_assert_msg(unit_near_rel(sum_of(x, 2 * PAIRS + 1), extra, 1e-15),
                  "seed %lu: %.17g, not %.17g", unit_seed(),
                  sum_of(x, 2 * PAIRS + 1), extra);
  }
}
