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

/* ph_area_band: the integral of |1 - k h| over heights that differ by `high',
 * from where it is 1 - k h = a. */
static inline double ph_area_band(double k, double a, double high) {
  const double b = a - k * high;
  return a * b >= 0 ? fabs(a + b) / 2 * high : (a * a + b * b) / 2 / fabs(k);
}

/* ph_area_of: the integral of |1 - k h| by both, where the heights differ by
 * `high'; on the two sides of the vertex both count.  Between the places where
 * the vertex passes a height it is a parabola. */
static inline double ph_area_of(double k, double length, double h[2][2],
                                double high) {
  const double a = 1 - k * h[0][0], step = k * (h[0][0] - h[0][1]);
  const double cross[] = {-a / step, (k * high - a) / step};
  const int first = cross[1] < cross[0];
  double at[4] = {0, 0, 1, 1}, sum = 0;
  if (!ph_area_folds(k, h)) {
    return fabs(a + step / 2 - k * high / 2) * high * length;
  }
  at[1] = cross[first] > 0 && cross[first] < 1 ? cross[first] : 0;
  at[2] = cross[!first] > 0 && cross[!first] < 1 ? cross[!first] : 1;
  for (int i = 0; i < 3; i++) {
    const double middle = (at[i] + at[i + 1]) / 2;
    sum += (at[i + 1] - at[i]) / 6 *
           (ph_area_band(k, a + step * at[i], high) +
            4 * ph_area_band(k, a + step * middle, high) +
            ph_area_band(k, a + step * at[i + 1], high));
  }
  return sum * length;
}

#endif
