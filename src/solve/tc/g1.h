/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * G1 Hermite interpolation by one Tschirnhausen cubic [BYR11, ch. 4].
 *
 * With a = arg t0 and b = arg t1, phi = (a + b)/2 and delta = (b - a)/2, every
 * real root D != 0 of
 *
 *   D^2 sin b + D sin phi + sin a = 0                            [BYR11, (4.5)]
 *   with  G(D) = cos a + D cos phi + D^2 cos b > 0
 *
 * gives one: w0 = sqrt(3/G) e^(ia/2), w1 = D sqrt(3/G) e^(ib/2) for the
 * chord 1. |D| is the square root of the ratio of the outer legs; D has a sign.
 * The angle of a backward tangent is taken as pi or -pi such that D > 0, as in
 * the mirror image.
 */
#ifndef PH_SOLVE_TC_G1_H
#define PH_SOLVE_TC_G1_H

#include "solve/tc/fit.h"

/*
 * ph_tc_g1: all cubics with these unit tangents, best first: regular ones,
 * without a loop before those with one, then the one that bends less.  Roots
 * and G that are 0 to rounding are 0: a double root is one cubic, a closed one
 * is none.
 *
 * Both tangents along the chord and forward give the straight line (root
 * PH_ROOT_STRAIGHT, D = 1); along the chord otherwise there is none.
 *
 * in   h     unit tangents over the direction of the chord, snapped
 * out  fits  measured, but not tested: one cubic is simple if it is regular and
 *            has no loop, and simple says so
 * ret  how many: 0, 1 or 2
 */
size_t ph_tc_g1(const struct ph_tc_hermite *h, struct ph_tc_fit fits[2]);

/* How many cubics there are for two angles. */
struct ph_tc_count {
  unsigned without_loop, with_loop;
};

/*
 * ph_tc_g1_count: the same from the angles alone, in closed form: what borders
 * the regions of existence [BYR11, fig. 4.5, table 4.1].  It solves nothing,
 * and no curve is made with it: it is a check of ph_tc_g1.  Of angles on a
 * border to rounding either side may be answered.
 *
 * in   a, b  angles from the chord to the tangents, in [-pi, pi]
 */
struct ph_tc_count ph_tc_g1_count(double a, double b);

/*
 * ph_tc_g1_range: the open interval of angles at one end for which there is a
 * cubic, given the angle at the other; it holds 0, and is less than a turn
 * long, but an end of it may be beyond pi or -pi.  The angle 0 itself is not
 * among them if |a| >= 2 pi/3, or else a cubic with a loop; for a = 0 it is the
 * straight line.
 *
 * in   a         in [-pi, pi]
 * out  range[2]  in (-2 pi, 2 pi)
 */
void ph_tc_g1_range(double a, double range[2]);

#endif
