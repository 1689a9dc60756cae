/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The scale of what is checked (see scale.h). */
#include "check/scale.h"

#include <float.h>

/* The spacing of subnormal numbers. */
static const double SMALLEST = 4.9406564584124654e-324;

/* No more rounding is allowed for: the hodograph would be a claim of no
 * digit. */
static const double ROUNDING_OF_SIZE = 1e-3 / PH_CHECK_ROUND_FIRST;

void ph_check_scale_round(struct ph_check_scale *scale, double largest) {
  scale->rounding = ph_check_smaller(DBL_EPSILON * largest + scale->spacing,
                                     ROUNDING_OF_SIZE * scale->size);
}

bool ph_check_scale_of(const double *points, size_t n, size_t dimension,
                       struct ph_check_scale *scale) {
  double low[3] = {0, 0, 0}, high[3] = {0, 0, 0}, extent[3], largest = 0;
  int exponent;
  for (size_t i = 0; i < dimension; i++) {
    low[i] = high[i] = points[i];
    for (size_t k = 1; k < n; k++) {
      low[i] = ph_check_smaller(low[i], points[dimension * k + i]);
      high[i] = ph_check_larger(high[i], points[dimension * k + i]);
    }
    largest = ph_check_larger(largest, ph_check_larger(-low[i], high[i]));
  }
  if (!(largest > 0)) {
    return false;
  }
  exponent = -ph_pow2_exponent(largest) - 2;
  exponent -= exponent & 1;
  scale->to_unit = ph_pow2_of(exponent);
  scale->from_unit = ph_pow2_of(-exponent);
  scale->root = ldexp(1, exponent / 2);
  for (size_t i = 0; i < 3; i++) {
    extent[i] = ph_pow2_apply(scale->to_unit, high[i]) -
                ph_pow2_apply(scale->to_unit, low[i]);
  }
  scale->size = 0.5 * hypot(hypot(extent[0], extent[1]), extent[2]);
  scale->spacing = ph_pow2_apply(scale->to_unit, SMALLEST);
  ph_check_scale_round(scale, ph_pow2_apply(scale->to_unit, largest));
  return scale->size > 0;
}
