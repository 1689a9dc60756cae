/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Offsets on the sphere: parallel curves at a geodesic distance.
 *
 * On the unit sphere, with d the distance over the radius, T the unit tangent
 * and kappa the geodesic curvature of the curve S, and primes by its parameter,
 *
 *   O = cos d S + sin d (S x T)                                         (1)
 *   O' = g T,  g = cos d |S'| - sin d kappa |S'|                        (2)
 *   kappa of O = (cos d kappa + sin d) / |cos d - kappa sin d|          (3)
 *
 * O moves against T where g < 0; its tangent is -T there, and (3) is its
 * curvature to the left of its own travel.  Where g changes its sign, at
 * cot d = kappa, O has a cusp and no curvature.
 *
 * Where the curve rests (S' = 0, as at rest ends) kappa is not finite, but
 * kappa |S'| is: O goes round the point at rest as a circle of radius d, until
 * it meets the curve's parallel at a cusp, or without one.  Nothing of this
 * needs an exception in (2) and (3).
 */
#ifndef PH_CURVE_OFFSET_PARALLEL_H
#define PH_CURVE_OFFSET_PARALLEL_H

#include "base/diag.h"
#include "base/mem.h"
#include "curve/offset/offset.h"
#include "curve/result.h"

/*
 * ph_offset_spherical: the offset of a PH_CURVE_SPHERICAL_NU curve.
 *
 * Samples and length are those of ph_sample_offset (curve/sample/sample.h).  At
 * a cusp that is hit exactly the tangent is that of the curve, and the
 * curvature NaN.
 *
 * Cusps are looked for between 64 places of each segment, which are denser
 * towards its ends, and at the joints (where a curve that is no more than G1
 * may have one); a dip of |g| among these places is searched for two.  Two that
 * are nearer to each other than these places, without such a dip, are missed.
 * Each is found to rounding.  The length is the integral of |g|, split at the
 * cusps, as well as |g| is known to rounding.
 *
 * in   distance  geodesic, in the unit of the data, positive to the left
 * in   rules     samples.how is not PH_SAMPLE_NONE
 *
 * out  offset    samples, cusps, length; arrays from the arena
 *
 * ret  PH_OK | PH_BAD_VALUE (the distance is not less than half the
 *      circumference) | PH_NO_CONVERGENCE (of the length) | PH_TOO_LARGE |
 *      PH_NO_MEMORY
 */
enum ph_status
ph_offset_spherical(const struct ph_curve *curve, double distance,
                    const struct ph_offset_rules *rules, struct ph_arena *arena,
                    struct ph_offset *offset, struct ph_diag *diag);

#endif
