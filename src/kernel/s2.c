/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * sin(theta) / theta and its kin (see s2.h).
 *
 * Below X = 4 by the power series of the spherical Bessel functions
 *   f_n(X) = sum_k (-X/2)^k / (k! (2 n + 2 k + 1)!!),                  (2)
 * above by upward recurrence
 *   f_1 = (f_0 - cos theta) / X,   f_{n+1} = ((2 n + 1) f_n - f_{n-1}) / X,
 * which loses a digit at most there.  Tested by t_s2.c.
 */
#include "kernel/s2.h"

#include <stddef.h>

/* Terms of (2) that reach rounding below NEAR = 1/16 and below FAR = 4: the
 * first one left out is 1e-17 and 1e-19 of the sum. */
enum { TERMS_NEAR = 6, TERMS = 13 };
static const double NEAR = 0.0625;
static const double FAR = 4;

/* Coefficients of (2), by n and k. */
static const double series[4][TERMS] = {
    {1.0 / 1.0, -1.0 / 6.0, 1.0 / 120.0, -1.0 / 5040.0, 1.0 / 362880.0,
     -1.0 / 39916800.0, 1.0 / 6227020800.0, -1.0 / 1307674368000.0,
     1.0 / 355687428096000.0, -1.0 / 121645100408832000.0,
     1.0 / 51090942171709440000.0, -1.0 / 25852016738884976640000.0,
     1.0 / 15511210043330985984000000.0},
    {1.0 / 3.0, -1.0 / 30.0, 1.0 / 840.0, -1.0 / 45360.0, 1.0 / 3991680.0,
     -1.0 / 518918400.0, 1.0 / 93405312000.0, -1.0 / 22230464256000.0,
     1.0 / 6758061133824000.0, -1.0 / 2554547108585472000.0,
     1.0 / 1175091669949317120000.0, -1.0 / 646300418472124416000000.0,
     1.0 / 418802671169936621568000000.0},
    {1.0 / 15.0, -1.0 / 210.0, 1.0 / 7560.0, -1.0 / 498960.0, 1.0 / 51891840.0,
     -1.0 / 7783776000.0, 1.0 / 1587890304000.0, -1.0 / 422378820864000.0,
     1.0 / 141919283810304000.0, -1.0 / 58754583497465856000.0,
     1.0 / 29377291748732928000000.0, -1.0 / 17450111298747359232000000.0,
     1.0 / 12145277463928162025472000000.0},
    {1.0 / 105.0, -1.0 / 1890.0, 1.0 / 83160.0, -1.0 / 6486480.0,
     1.0 / 778377600.0, -1.0 / 132324192000.0, 1.0 / 30169915776000.0,
     -1.0 / 8869955238144000.0, 1.0 / 3264143527636992000.0,
     -1.0 / 1468864587436646400000.0, 1.0 / 793186877215789056000000.0,
     -1.0 / 506053227663673417728000000.0,
     1.0 / 376503601381773022789632000000.0}};

static inline double sum(const double *c, size_t terms, double x) {
  double f = c[terms - 1];
  for (size_t k = terms - 1; k-- > 0;) {
    f = c[k] + x * f;
  }
  return f;
}

double ph_s2_f0(double x) {
  double theta;
  if (x < NEAR) {
    return sum(series[0], TERMS_NEAR, x);
  }
  theta = sqrt(x);
  return sin(theta) / theta;
}

void ph_s2_bessel(double x, double f[4]) {
  if (x < FAR) {
    size_t terms = x < NEAR ? TERMS_NEAR : TERMS;
    for (size_t n = 0; n < 4; n++) {
      f[n] = sum(series[n], terms, x);
    }
  } else {
    double theta = sqrt(x);
    f[0] = sin(theta) / theta;
    f[1] = (f[0] - cos(theta)) / x;
    f[2] = (3 * f[1] - f[0]) / x;
    f[3] = (5 * f[2] - f[1]) / x;
  }
}
