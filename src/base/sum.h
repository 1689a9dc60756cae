/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Compensated summation (Neumaier 1974): the sum of any number of terms is as
 * accurate as if it were formed with twice the digits. */
#ifndef PH_BASE_SUM_H
#define PH_BASE_SUM_H

#include <math.h>

struct ph_sum {
  double high, low;
};

static inline void ph_sum_add(struct ph_sum *sum, double x) {
  double t = sum->high + x;
  sum->low +=
      fabs(sum->high) >= fabs(x) ? (sum->high - t) + x : (x - t) + sum->high;
  sum->high = t;
}

/* ph_sum_join: adds the sum of other numbers. */
static inline void ph_sum_join(struct ph_sum *sum, const struct ph_sum *more) {
  ph_sum_add(sum, more->high);
  ph_sum_add(sum, more->low);
}

static inline double ph_sum_value(const struct ph_sum *sum) {
  return sum->high + sum->low;
}

#endif
