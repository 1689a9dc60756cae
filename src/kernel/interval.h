/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Interval arithmetic, for bounds that hold: the result of an operation has in
 * it whatever the operands may stand for, and rounding.
 *
 * Every operation widens by an ulp or two instead of setting the rounding mode.
 * Underflow is not looked after: operands are expected near unit scale.  What
 * has no bound is infinite, what is not a number stays so at both ends.
 */
#ifndef PH_KERNEL_INTERVAL_H
#define PH_KERNEL_INTERVAL_H

#include <float.h>
#include <math.h>
#include <stddef.h>

struct ph_range {
  double low, high;
};

/* ph_range_least, ph_range_greatest: of two numbers; NaN if one of them is,
 * where fmin and fmax would take the other. */
static inline double ph_range_least(double a, double b) {
  return a <= b || isnan(a) ? a : b;
}

static inline double ph_range_greatest(double a, double b) {
  return a >= b || isnan(a) ? a : b;
}

/* ph_range_wider: wider by one rounding of either end. */
static inline struct ph_range ph_range_wider(double low, double high) {
  struct ph_range r = {low - DBL_EPSILON * fabs(low),
                       high + DBL_EPSILON * fabs(high)};
  return r;
}

/* ph_range_of: the least one that has n >= 1 numbers in it, each known up to
 * an error. */
static inline struct ph_range ph_range_of(const double *x, size_t n,
                                          double error) {
  double low = x[0], high = x[0];
  for (size_t i = 1; i < n; i++) {
    low = ph_range_least(low, x[i]);
    high = ph_range_greatest(high, x[i]);
  }
  return ph_range_wider(low - error, high + error);
}

static inline struct ph_range ph_range_add(struct ph_range a,
                                           struct ph_range b) {
  return ph_range_wider(a.low + b.low, a.high + b.high);
}

static inline struct ph_range ph_range_sub(struct ph_range a,
                                           struct ph_range b) {
  return ph_range_wider(a.low - b.high, a.high - b.low);
}

static inline struct ph_range ph_range_scale(double s, struct ph_range a) {
  return s < 0 ? ph_range_wider(s * a.high, s * a.low)
               : ph_range_wider(s * a.low, s * a.high);
}

static inline struct ph_range ph_range_mul(struct ph_range a,
                                           struct ph_range b) {
  double x = a.low * b.low, y = a.low * b.high;
  double z = a.high * b.low, w = a.high * b.high;
  return ph_range_wider(
      ph_range_least(ph_range_least(x, y), ph_range_least(z, w)),
      ph_range_greatest(ph_range_greatest(x, y), ph_range_greatest(z, w)));
}

/* ph_range_square: of the same number twice. */
static inline struct ph_range ph_range_square(struct ph_range a) {
  double x = a.low * a.low, y = a.high * a.high;
  double least = a.low <= 0 && a.high >= 0 ? 0 : ph_range_least(x, y);
  return ph_range_wider(least, ph_range_greatest(x, y));
}

/* ph_range_div: everything, if the divisor may be 0. */
static inline struct ph_range ph_range_div(struct ph_range a,
                                           struct ph_range b) {
  const struct ph_range all = {-(double)INFINITY, (double)INFINITY};
  struct ph_range inverse;
  if (!(b.low > 0 || b.high < 0)) {
    return all;
  }
  inverse = ph_range_wider(1 / b.high, 1 / b.low);
  return ph_range_mul(a, inverse);
}

/* ph_range_root: of what is not negative; rounding may have made it so. */
static inline struct ph_range ph_range_root(struct ph_range a) {
  return ph_range_wider(a.low <= 0 ? 0 : sqrt(a.low), sqrt(a.high));
}

/* ph_range_farthest, ph_range_nearest: the greatest and the least distance
 * from 0. */
static inline double ph_range_farthest(struct ph_range a) {
  return ph_range_greatest(fabs(a.low), fabs(a.high));
}

static inline double ph_range_nearest(struct ph_range a) {
  return a.low > 0 ? a.low : a.high < 0 ? -a.high : 0;
}

#endif
