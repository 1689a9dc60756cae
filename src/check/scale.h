/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The scale of what is checked, and what rounding of coordinates can do to it:
 * all checks are at unit scale, where the largest coordinate is near 1/2.
 */
#ifndef PH_CHECK_SCALE_H
#define PH_CHECK_SCALE_H

#include "base/inline.h"
#include "kernel/pow2.h"

#include <math.h>
#include <stdbool.h>
#include <stddef.h>

/* Allowance for a first difference of control points times 5, in units of the
 * rounding of a coordinate, with a margin of 3. */
enum { PH_CHECK_ROUND_FIRST = 32 };

/* Not fmax and fmin, which are calls of the library. */
static inline double ph_check_larger(double a, double b) {
  return a > b ? a : b;
}

static inline double ph_check_smaller(double a, double b) {
  return a < b ? a : b;
}

/* Whether x is larger than the largest so far; NaN is, and stays. */
static inline bool ph_check_is_larger(double x, double largest) {
  return !(x <= largest) && !isnan(largest);
}

/* The scale of the data, and what depends on it. */
struct ph_check_scale {
  struct ph_pow2 to_unit, from_unit;
  double root;     /* the same for the preimage */
  double size;     /* half the diagonal, at unit scale */
  double rounding; /* of the largest coordinate, and */
  double spacing;  /* of the smallest, at unit scale */
};

/* ph_check_scale_round: rounding is that of numbers as large as this, at unit
 * scale, but no more than leaves a size. */
void ph_check_scale_round(struct ph_check_scale *scale, double largest);

/* ph_check_scale_of: of points[n][dimension], all finite; false when they have
 * no extent. */
bool ph_check_scale_of(const double *points, size_t n, size_t dimension,
                       struct ph_check_scale *scale);

#endif
