/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Places at given arc lengths of a segment, one after the other: each is
 * guessed from the two before, where du/ds is known as well, by the
 * cubic through them, and is mostly found with one evaluation of the length.
 */
#ifndef PH_CURVE_SAMPLE_INVERSION_H
#define PH_CURVE_SAMPLE_INVERSION_H

#include "curve/sample/sample.h"

/* The last places on the segment that the sampler is in, the newest first.
 * Zeroed at the start of a segment. */
struct ph_inversion {
  size_t n; /* <= 2 */
  double s[2], u[2], speed[2];
};

/*
 * ph_inversion_next: where on the segment its arc length from the start is s.
 *
 * Newton's method, kept in a bracket, to 1e-14 of the length of the segment, or
 * to the last digit of u where the speed is great.
 *
 * in   s      not less than the one before
 * out  steps  NULL, or how many evaluations it took
 */
double ph_inversion_next(struct ph_inversion *past,
                         const struct ph_sampler *sampler, double s,
                         size_t *steps);

#endif
