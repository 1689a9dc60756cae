/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Points that are too near (see near.h). */
#include "cli/near.h"

#include <float.h>
#include <math.h>
#include <stdbool.h>

/* Roundings of the largest coordinate between two points, at least: of a curve
 * r' and r'' are differences of control points that are as near, 5 and 20 times
 * as uncertain. */
static const double APART = 4096;

/* Data that are so far from the origin, in their own size, are rounded less
 * nearer to it. */
static const double FAR = 4;

/* A last point of closed data that repeats the first one is as near. */
static const double REPEATED = 4;

static double away(const struct ph_value *points, size_t i, size_t j) {
  const size_t d = points->dimension;
  double sum = 0;
  for (size_t k = 0; k < d; k++) {
    sum = hypot(sum, points->v[d * i + k] - points->v[d * j + k]);
  }
  return sum;
}

/* The largest coordinate; size: of the bounding box. */
static double largest_of(const struct ph_value *points, double *size) {
  const size_t d = points->dimension;
  double largest = 0;
  *size = 0;
  for (size_t k = 0; k < d; k++) {
    double low = points->v[k], high = low;
    for (size_t i = 0; i < points->n; i++) {
      low = fmin(low, points->v[d * i + k]);
      high = fmax(high, points->v[d * i + k]);
    }
    largest = fmax(largest, fmax(fabs(low), fabs(high)));
    *size = fmax(*size, high - low);
  }
  return largest;
}

enum ph_status ph_near_points(const struct ph_problem *problem,
                              struct ph_diag *diag) {
  const struct ph_value *points = &problem->field[PH_F_POINTS];
  const bool closed = problem->field[PH_F_CLOSED].flag;
  const size_t n = points->n;
  double least = HUGE_VAL, size, rounding;
  size_t at = 0;
  if (points->kind != PH_VECTORS || n < 2) {
    return diag->status;
  }
  rounding = DBL_EPSILON * largest_of(points, &size);
  for (size_t i = closed ? 0 : 1; i < n; i++) {
    double distance = away(points, i, (i + n - 1) % n);
    if (distance < least && (i > 0 || distance > REPEATED * rounding)) {
      least = distance;
      at = i;
    }
  }
  if (!(least < APART * rounding)) {
    return diag->status;
  }
  return ph_fail_at(
      diag, PH_E_COINCIDENT_POINTS, "points", at,
      "is too near to points[%zu]: %.3g apart, where coordinates are rounded "
      "by %.3g; --merge=D joins points nearer than D%s",
      (at + n - 1) % n, least, rounding,
      rounding > FAR * DBL_EPSILON * size
          ? ", and data moved to the origin are rounded less"
          : "");
}
