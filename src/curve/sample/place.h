/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Places at given arc lengths of a segment, one after the other: each is
 * guessed from the two before, whose paces du/ds are known as well, by the
 * cubic through them, and is mostly found with one evaluation of the length.
 */
#ifndef PH_CURVE_SAMPLE_PLACE_H
#define PH_CURVE_SAMPLE_PLACE_H

#include "curve/sample/sample.h"

/* The last places on the segment that the sampler is in, the newest first.
 * Zeroed at the start of a segment. */
struct ph_trail {
  size_t n; /* <= 2 */
  double s[2], u[2], speed[2];
};

/*
 * ph_trail_next: the place at s, as ph_sampler_place.
 *
 * in   s      not less than the one before
 * out  steps  NULL, or how many evaluations it took
 */
double ph_trail_next(struct ph_trail *trail, const struct ph_sampler *sampler,
                     double s, size_t *steps);

#endif
