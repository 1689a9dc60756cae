/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The area inside of a closed curve in the plane, half the integral of r x r'.
 *
 * Of Bezier segments it is a sum over pairs of control points and legs, with
 * q = p - p0 of the curve:
 *
 *   sum_ij B(n,i) B(n-1,j) / B(2n-1,i+j) q_i x (p_(j+1) - p_j) / 4
 *
 * with binomials B, as products of Bernstein polynomials of degree n and n - 1
 * are those of degree 2n - 1, each of integral 1/(2n).  Of ATPH segments, whose
 * r x r' is analytic, it is a Gauss rule of 20 nodes.  Derived here;
 * tests/cli/sample.t evaluates both.
 */
#ifndef PH_CURVE_FAIR_ENCLOSED_H
#define PH_CURVE_FAIR_ENCLOSED_H

#include "base/diag.h"
#include "base/mem.h"
#include "curve/result.h"

/*
 * ph_enclosed_area: in the square of the unit, positive if the inside is to the
 * left of travel.
 *
 * out  area  NaN: the curve is open, or not in the plane
 * ret  PH_OK | PH_E_NO_MEMORY | what ph_sampler_enter returns
 */
enum ph_status ph_enclosed_area(const struct ph_curve *curve,
                                struct ph_arena *arena, double *area,
                                struct ph_diag *diag);

#endif
