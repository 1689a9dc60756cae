/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The free phase of preimages in space: A exp(x i) has the same curve, and an
 * Euler-Rodrigues frame that is turned about the tangent by 2 x.
 */
#ifndef PH_SOLVE_COMMON_FRAME_H
#define PH_SOLVE_COMMON_FRAME_H

#include "curve/result.h"
#include "kernel/quat.h"

/* ph_frame_upright: the factor exp(x i) for A that makes e3 as near to the axis
 * z as the tangent allows (x where the tangent is vertical), so that e2 points
 * to the left seen from above. */
ph_cplx ph_frame_upright(ph_quat preimage);

/* ph_frame_follow: the factor for A that makes its frame the one of `before`,
 * which turns i to the same tangent. */
ph_cplx ph_frame_follow(ph_quat a, ph_quat before);

/*
 * ph_frame_turn: the angle, in (-pi, pi], by which the Euler-Rodrigues frame of
 * a closed curve has turned about the tangent when it comes back.
 *
 * in   end  A at the end of the last segment
 */
double ph_frame_turn(const struct ph_curve *curve, ph_quat end);

#endif
