/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Offset curves of planar PH quintics: exact rational Bezier curves of
 * degree 9 [FAR90; GON18, sec. 2.2 with the left normal].
 *
 *   o(u) = r(u) + d i r'(u) / |r'(u)|
 *        = (sigma(u) r(u) + d i w(u)^2) / sigma(u)
 *
 * d is positive to the left of travel.  The weights are the Bernstein
 * coefficients of the parametric speed sigma, raised to degree 9.
 */
#ifndef PH_CURVE_OFFSET_H
#define PH_CURVE_OFFSET_H

#include "base/diag.h"
#include "base/mem.h"
#include "curve/result.h"

/*
 * ph_offset_planar: the offset of a planar PH spline at one distance.
 *
 * A segment whose speed has a coefficient that is not positive (it turns by
 * more than about a half turn) is halved until all weights are positive, so
 * that a renderer meets no pole and the convex hull property holds.
 *
 * in   curve     kind PH_CURVE_PH, dimension 2
 * out  offset    arrays from the arena
 * ret  PH_OK | PH_INFEASIBLE (the curve stands still somewhere: no normal
 *      there; names the segment) | PH_TOO_LARGE | PH_NO_MEMORY
 */
enum ph_status ph_offset_planar(const struct ph_curve *curve, double distance,
                                struct ph_arena *arena,
                                struct ph_offset *offset, struct ph_diag *diag);

#endif
