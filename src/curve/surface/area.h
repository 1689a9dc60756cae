/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The area of a strip between two heights, whose metric is
 * (1 - k h)^2 ds^2 + dh^2, and whether its vertex is between them.
 */
#ifndef PH_CURVE_SURFACE_AREA_H
#define PH_CURVE_SURFACE_AREA_H

#include <math.h>
#include <stdbool.h>

/* The corners of a strip are given as h: [of both heights][at both ends].
 *
 * ph_area_folds: whether 1 - k h is not positive somewhere within the heights,
 * or not negative, of which there are some. */
static inline bool ph_area_folds(double k, double h[2][2]) {
  double low = HUGE_VAL, high = -HUGE_VAL;
  for (int i = 0; i < 4; i++) {
    const double q = 1 - k * h[i >> 1][i & 1];
    low = fmin(low, q);
    high = fmax(high, q);
  }
  return low <= 0 && high >= 0;
}

/* The integral of q|q| over a unit interval, q linear from a to b. */
static inline double ph_area_square(double a, double b) {
  const double cubes = fabs(b) * b * b - fabs(a) * a * a;
  return a * b >= 0 ? (a > 0 || b > 0 ? 1 : -1) * (a * a + a * b + b * b) / 3
                    : cubes / (b - a) / 3;
}

/* ph_area_of: the integral of |1 - k h| by both; on the two sides of the vertex
 * both count. */
static inline double ph_area_of(double k, double length, double h[2][2]) {
  const double high = (h[1][0] + h[1][1]) / 2 - (h[0][0] + h[0][1]) / 2;
  const double middle = (h[0][0] + h[0][1] + h[1][0] + h[1][1]) / 4;
  if (!ph_area_folds(k, h)) {
    return fabs(1 - k * middle) * high * length;
  }
  return length / 2 / k *
         (ph_area_square(1 - k * h[0][0], 1 - k * h[0][1]) -
          ph_area_square(1 - k * h[1][0], 1 - k * h[1][1]));
}

#endif
