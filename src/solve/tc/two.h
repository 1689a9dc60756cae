/* SPDX-License-Identifier: GPL-3.0-or-later */
/* G1 Hermite interpolation by two Tschirnhausen cubics, for all data. */
#ifndef PH_SOLVE_TC_TWO_H
#define PH_SOLVE_TC_TWO_H

#include "solve/tc/fit.h"

/*
 * ph_tc_two_free: the C1 pair (tc_pair.h) with |t0| = |t1| = lambda whose F =
 * energy * length is least over its four roots and lambda in [.15, 1.4], among
 * those that are simple.  Both tangents along the chord and forward give the
 * straight line with lambda = 1/2.
 *
 * in   h    unit tangents over the direction of the chord, snapped
 * out  fit  measured and tested
 * ret  false if no pair is simple
 */
bool ph_tc_two_free(const struct ph_tc_hermite *h, struct ph_tc_fit *fit);

/*
 * ph_tc_two_chord: two cubics whose joint is on the chord [BYR11, thm 14], with
 * the tangent there at an angle to it, each the best of ph_tc_g1.  What is NaN
 * is chosen: the angle for the best rank (simple, then with the fewest loops)
 * and of these the least F, the position for the least energy.  Both tangents
 * along the chord and forward give the straight line where no angle is given.
 *
 * in   angle     in (-pi, pi), not 0; or NaN
 * in   position  of the joint, in (0, 1); or NaN
 * out  fit       measured and tested; joint_angle and joint_position
 * ret  false if there is none at this angle: it must be in the ranges of
 *      ph_tc_g1_range of both angles
 */
bool ph_tc_two_chord(const struct ph_tc_hermite *h, double angle,
                     double position, struct ph_tc_fit *fit);

#endif
