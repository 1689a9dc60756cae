/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * How far cubics are from a Bezier curve that they stand for: an upper bound of
 * the Hausdorff distance.
 *
 * A cubic r stands for the part C of the curve.  Both run on [0,1]; any
 * continuous psi with psi(0) = 0, psi(1) = 1 matches every point of one with
 * one of the other, so that
 *
 *   distance <= max |d(t)| <= max |d_k|,  d(t) = r(psi(t)) - C(t)         (1)
 *
 * with d_k the Bernstein coefficients of the polynomial d.  psi is a cubic with
 * the slopes of the projection onto r at its ends, or those of the speeds. What
 * is left along the curve counts less where both are graphs over the chord of
 * r, with slopes of at most s: the point of one above a point of the other is
 * no further than
 *
 *   max |d across| + s max |d along| + max |d along at the ends|          (2)
 *
 * the last for points beyond the other's end.  Where the bound is not good
 * enough, C is cut, r is cut at a point that is near to where, and both parts
 * are bounded by themselves.
 *
 * Derived here; tested by t_cert_tc_distance.c: test_known, test_random.
 */
#ifndef PH_CHECK_TC_DISTANCE_H
#define PH_CHECK_TC_DISTANCE_H

#include "base/mem.h"
#include "kernel/bern_low.h"

#include <stdbool.h>
#include <stddef.h>

struct ph_check_distance {
  const struct ph_arena *arena; /* knows how much time there is */
  ph_cplx *room;
  size_t size;    /* coefficients in each part of the room */
  double allowed; /* more than that need not be told apart */
  double bound;   /* of all so far, with rounding */
  double sampled; /* the largest distance of points that were matched */
  double noise;   /* what rounding may add to a bound, at most so far */
  size_t parts;   /* of the last cubic */
  struct ph_bern_low low;
};

/*
 * ph_check_distance_begin: nothing yet.
 *
 * in   degree   of the curves to come, at most
 * in   allowed  what the bound is hoped to be within; infinite: nothing is
 * ret  false when memory is exhausted
 */
bool ph_check_distance_begin(struct ph_check_distance *d,
                             struct ph_arena *arena, size_t degree,
                             double allowed);

/*
 * ph_check_distance_curve: the curve that the next cubics stand for.
 *
 * in   curve[degree + 1]  at unit scale; not copied
 */
void ph_check_distance_curve(struct ph_check_distance *d, const ph_cplx *curve,
                             size_t degree);

/*
 * ph_check_distance_add: one more cubic, for the part [from,to] of the curve.
 * The bound is within some percent of the largest distance of points that were
 * matched, and within `allowed` if that is possible with a few hundred parts.
 *
 * in   from, to  0 <= from <= to <= 1
 */
void ph_check_distance_add(struct ph_check_distance *d, double from, double to,
                           const ph_cplx cubic[4]);

#endif
