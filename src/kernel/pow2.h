/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Scaling by powers of two: exact, so that data are brought to unit scale and
 * back without touching a digit.
 *
 * The factor is kept as two, because the range of doubles (2^-1074 to 2^1024)
 * is wider than what one factor can span.
 */
#ifndef PH_KERNEL_POW2_H
#define PH_KERNEL_POW2_H

#include <float.h>
#include <math.h>

struct ph_pow2 {
  double first, second;
};

/* ph_pow2_of: the scaling by 2^exponent, |exponent| <= 2000. */
static inline struct ph_pow2 ph_pow2_of(int exponent) {
  struct ph_pow2 s = {ldexp(1, exponent / 2),
                      ldexp(1, exponent - exponent / 2)};
  return s;
}

static inline double ph_pow2_apply(struct ph_pow2 s, double x) {
  return x * s.first * s.second;
}

/* ph_pow2_positive: x 2^exponent for x >= 0, any exponent; NaN where that is
 * less than DBL_MIN and has lost digits, infinite where it is too large. */
static inline double ph_pow2_positive(double x, int exponent) {
  double scaled = ldexp(x, exponent);
  return x > 0 && scaled < DBL_MIN ? (double)NAN : scaled;
}

/* ph_pow2_exponent: e with 2^e <= x < 2^(e+1), for finite x > 0. */
static inline int ph_pow2_exponent(double x) {
  return ilogb(x);
}

#endif
