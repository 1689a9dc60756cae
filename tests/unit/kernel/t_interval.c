/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Interval arithmetic: nothing that may occur is left out, and no more than a
 * few roundings are put in. */
#include "kernel/interval.h"

#include "unit.h"

enum { CASES = 20000 };

/* By chance of any sign, or a single number, or from or to 0. */
static struct ph_range range_random(struct unit_random *r) {
  double x = unit_random_in(r, -2, 2), y = unit_random_in(r, -2, 2);
  double low = fmin(x, y), high = fmax(x, y);
  struct ph_range range = {low, high};
  switch (unit_random_below(r, 6)) {
  case 0:
    range.high = low;
    break;
  case 1:
    range.low = 0;
    range.high = fabs(high);
    break;
  case 2:
    range.low = -fabs(low);
    range.high = 0;
    break;
  default:
    break;
  }
  return range;
}

static double number_in(struct unit_random *r, struct ph_range range) {
  switch (unit_random_below(r, 4)) {
  case 0:
    return range.low;
  case 1:
    return range.high;
  default:
    return fmin(range.high, unit_random_in(r, range.low, range.high));
  }
}

static bool has(struct ph_range range, long double x) {
  return (long double)range.low <= x && x <= (long double)range.high;
}

/* No end is further out than the values at the ends of the operands, by more
 * than some roundings of the largest. */
static void check_width(struct ph_range range, const double *ends, size_t n) {
  double low = ends[0], high = ends[0], size;
  for (size_t i = 1; i < n; i++) {
    low = fmin(low, ends[i]);
    high = fmax(high, ends[i]);
  }
  size = 8 * DBL_EPSILON * fmax(fabs(low), fabs(high));
  ck_assert_double_ge(range.low, low - size);
  ck_assert_double_le(range.high, high + size);
}

PH_TEST(test_sums) {
  struct unit_random r = unit_random_of(1);
  for (int i = 0; i < unit_count(CASES); i++) {
    struct ph_range a = range_random(&r), b = range_random(&r);
    long double x = (long double)number_in(&r, a);
    long double y = (long double)number_in(&r, b);
    double s = unit_random_in(&r, -3, 3);
    const double sum[2] = {a.low + b.low, a.high + b.high};
    const double difference[2] = {a.low - b.high, a.high - b.low};
    const double scaled[2] = {s * a.low, s * a.high};
    ck_assert(has(ph_range_add(a, b), x + y));
    ck_assert(has(ph_range_sub(a, b), x - y));
    ck_assert(has(ph_range_scale(s, a), (long double)s * x));
    check_width(ph_range_add(a, b), sum, 2);
    check_width(ph_range_sub(a, b), difference, 2);
    check_width(ph_range_scale(s, a), scaled, 2);
  }
}

PH_TEST(test_products) {
  struct unit_random r = unit_random_of(2);
  for (int i = 0; i < unit_count(CASES); i++) {
    struct ph_range a = range_random(&r), b = range_random(&r);
    long double x = (long double)number_in(&r, a);
    long double y = (long double)number_in(&r, b);
    const double product[4] = {a.low * b.low, a.low * b.high, a.high * b.low,
                               a.high * b.high};
    double square[3] = {a.low * a.low, a.high * a.high, 0};
    ck_assert(has(ph_range_mul(a, b), x * y));
    ck_assert(has(ph_range_square(a), x * x));
    check_width(ph_range_mul(a, b), product, 4);
    check_width(ph_range_square(a), square, has(a, 0) ? 3 : 2);
    ck_assert_double_ge(ph_range_square(a).low, 0);
  }
}

PH_TEST(test_quotients) {
  struct unit_random r = unit_random_of(3);
  for (int i = 0; i < unit_count(CASES); i++) {
    struct ph_range a = range_random(&r), b = range_random(&r);
    struct ph_range c = ph_range_div(a, b);
    long double x = (long double)number_in(&r, a);
    long double y = (long double)number_in(&r, b);
    const double quotient[4] = {a.low / b.low, a.low / b.high, a.high / b.low,
                                a.high / b.high};
    if (has(b, 0)) {
      ck_abs(c.low, -(double)INFINITY, 0);
      ck_abs(c.high, (double)INFINITY, 0);
    } else {
      ck_assert(has(c, x / y));
      check_width(c, quotient, 4);
    }
  }
}

PH_TEST(test_roots) {
  struct unit_random r = unit_random_of(4);
  struct ph_range below = {-1e-17, 4};
  for (int i = 0; i < unit_count(CASES); i++) {
    struct ph_range a = ph_range_square(range_random(&r));
    long double x = (long double)number_in(&r, a);
    const double root[2] = {sqrt(a.low), sqrt(a.high)};
    ck_assert(has(ph_range_root(a), sqrtl(x)));
    check_width(ph_range_root(a), root, 2);
  }
  ck_abs(ph_range_root(below).low, 0, 0);
  ck_rel(ph_range_root(below).high, 2, 1e-15);
}

PH_TEST(test_distances) {
  struct unit_random r = unit_random_of(5);
  for (int i = 0; i < unit_count(CASES); i++) {
    struct ph_range a = range_random(&r);
    double x = number_in(&r, a), near = fmin(fabs(a.low), fabs(a.high));
    ck_assert_double_le(fabs(x), ph_range_farthest(a));
    ck_assert_double_ge(fabs(x), ph_range_nearest(a));
    ck_abs(ph_range_farthest(a), fmax(fabs(a.low), fabs(a.high)), 0);
    ck_abs(ph_range_nearest(a), has(a, 0) ? 0 : near, 0);
  }
}

PH_TEST(test_of) {
  const double x[3] = {1, -2, 0.5};
  struct ph_range a = ph_range_of(x, 3, 0.25);
  ck_assert(has(a, -2.25L) && has(a, 1.25L));
  ck_rel(a.low, -2.25, 1e-15);
  ck_rel(a.high, 1.25, 1e-15);
}

/* What is not a number is never taken for one. */
PH_TEST(test_not_a_number) {
  const double x[3] = {1, (double)NAN, 2};
  struct ph_range nan = ph_range_of(x, 3, 0), one = {1, 2};
  const struct ph_range results[] = {nan,
                                     ph_range_add(nan, one),
                                     ph_range_sub(one, nan),
                                     ph_range_mul(nan, one),
                                     ph_range_mul(one, nan),
                                     ph_range_square(nan),
                                     ph_range_div(nan, one),
                                     ph_range_scale(2, nan),
                                     ph_range_root(nan)};
  for (size_t i = 0; i < COUNT(results); i++) {
    ck_assert(isnan(results[i].low) && isnan(results[i].high));
  }
  ck_assert(isnan(ph_range_farthest(nan)));
  ck_assert(isinf(ph_range_div(one, nan).low));
}
