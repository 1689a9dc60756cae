/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * sin(theta) / theta and its kin (see s2.h).
 *
 * By the power series of the spherical Bessel functions
 *   f_n(X) = sum_k (-X/2)^k / (k! (2 n + 2 k + 1)!!),                  (2)
 * of n = 2 and 3 below X = 4, and downward by the recurrence
 *   f_{n-1} = (2 n + 1) f_n - X f_{n+1},                               (3)
 * which is stable there; above upward, from f_0 and f_{-1} = cos theta, which
 * loses a digit at most.  Tested by t_s2.c.
 */
#include "kernel/s2.h"

#include <stddef.h>

/* Terms of (2) that reach rounding below NEAR = 1/16 and below FAR = 4: the
 * first one left out is 1e-17 and less of the sum. */
enum { TERMS_NEAR = 6, TERMS = 13 };
static const double NEAR = 0.0625;
static const double FAR = 4;

/* Coefficients of (2), of f_0, f_2 and f_3. */
static const double f0_series[TERMS_NEAR] = {1.0 / 1.0,      -1.0 / 6.0,
                                             1.0 / 120.0,    -1.0 / 5040.0,
                                             1.0 / 362880.0, -1.0 / 39916800.0};
static const double f2_series[TERMS] = {1.0 / 15.0,
                                        -1.0 / 210.0,
                                        1.0 / 7560.0,
                                        -1.0 / 498960.0,
                                        1.0 / 51891840.0,
                                        -1.0 / 7783776000.0,
                                        1.0 / 1587890304000.0,
                                        -1.0 / 422378820864000.0,
                                        1.0 / 141919283810304000.0,
                                        -1.0 / 58754583497465856000.0,
                                        1.0 / 29377291748732928000000.0,
                                        -1.0 / 17450111298747359232000000.0,
                                        1.0 / 12145277463928162025472000000.0};
static const double f3_series[TERMS] = {1.0 / 105.0,
                                        -1.0 / 1890.0,
                                        1.0 / 83160.0,
                                        -1.0 / 6486480.0,
                                        1.0 / 778377600.0,
                                        -1.0 / 132324192000.0,
                                        1.0 / 30169915776000.0,
                                        -1.0 / 8869955238144000.0,
                                        1.0 / 3264143527636992000.0,
                                        -1.0 / 1468864587436646400000.0,
                                        1.0 / 793186877215789056000000.0,
                                        -1.0 / 506053227663673417728000000.0,
                                        1.0 / 376503601381773022789632000000.0};

/* sum: a polynomial in x. */
static inline double sum(const double *c, size_t terms, double x) {
  double f = c[terms - 1];
  for (size_t k = terms - 1; k-- > 0;) {
    f = c[k] + x * f;
  }
  return f;
}

double ph_s2_f0_far(double x) {
  double theta;
  if (x < NEAR) {
    return sum(f0_series, TERMS_NEAR, x);
  }
  theta = sqrt(x);
  return sin(theta) / theta;
}

void ph_s2_bessel(double x, double f[4]) {
  if (x < FAR) {
    size_t terms = x < NEAR ? TERMS_NEAR : TERMS;
    double f2 = f2_series[terms - 1], f3 = f3_series[terms - 1];
    for (size_t k = terms - 1; k-- > 0;) {
      f2 = f2_series[k] + x * f2;
      f3 = f3_series[k] + x * f3;
    }
    f[3] = f3;
    f[2] = f2;
    f[1] = 5 * f2 - x * f3;
    f[0] = 3 * f[1] - x * f2;
  } else {
    double theta = sqrt(x);
    f[0] = sin(theta) / theta;
    f[1] = (f[0] - cos(theta)) / x;
    f[2] = (3 * f[1] - f[0]) / x;
    f[3] = (5 * f[2] - f[1]) / x;
  }
}
