/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Offset curves of planar PH splines: exact rational Bezier curves of
 * degree 9 [FAR90; GON18, sec. 2.2 with the left normal]; of ATPH splines, the
 * exact displacement as a quotient, and Bezier pieces within a tolerance.
 *
 *   o(u) = r(u) + d i r'(u) / |r'(u)|
 *        = (sigma(u) r(u) + d i w(u)^2) / sigma(u)
 *
 * d is positive to the left of travel.  The weights are the Bernstein
 * coefficients of the parametric speed sigma, raised to degree 9.
 *
 * An ATPH segment holds t beside sin t and cos t, so that its offset is no
 * NURBS.  o - r is a quotient in <1, sin t, cos t, sin 2t, cos 2t>, given by
 * coefficients in the normalised B-basis of that space,
 *   (1, 4c, 4c^2 + 2, 4c, 1) S0^(4-j) S1^j,  j = 0..4,
 * with c, S0 and S1 of kernel/atph.h.
 */
#ifndef PH_CURVE_OFFSET_H
#define PH_CURVE_OFFSET_H

#include "base/diag.h"
#include "base/mem.h"
#include "curve/result.h"

/*
 * ph_offset_planar: the offset of a planar spline at one distance.
 *
 * A segment whose speed has a coefficient that is not positive (it turns by
 * more than about a half turn) is halved until all weights are positive, so
 * that a renderer meets no pole and the convex hull property holds.
 *
 * in   curve      PH_CURVE_PH or PH_CURVE_ATPH
 * in   tolerance  of the Bezier pieces of ATPH offsets, in the curve's unit
 *
 * out  offset     arrays from the arena
 *
 * ret  PH_OK | PH_INFEASIBLE (the curve stands still somewhere: no normal
 *      there; names the segment) | PH_TOO_LARGE | PH_NO_CONVERGENCE (no Bezier
 *      piece is near enough) | PH_NO_MEMORY
 */
enum ph_status ph_offset_planar(const struct ph_curve *curve, double distance,
                                double tolerance, struct ph_arena *arena,
                                struct ph_offset *offset, struct ph_diag *diag);

#endif
