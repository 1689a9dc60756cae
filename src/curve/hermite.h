/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Planar ATPH curves, and offsets of planar PH and ATPH curves, as polynomial
 * quintic Bezier pieces within a tolerance.
 *
 * A piece takes position, first and second derivative over from the exact
 * curve at both ends, so that the pieces join with C2 continuity where the
 * curve has it; a segment is halved until its pieces are near enough.  The
 * distance falls by about 2^6 with each halving.
 */
#ifndef PH_CURVE_HERMITE_H
#define PH_CURVE_HERMITE_H

#include "base/diag.h"
#include "base/mem.h"
#include "curve/result.h"

/*
 * ph_hermite_pieces: the curve (distance 0) or its offset as Bezier pieces.
 *
 * in   distance   signed, positive to the left of travel
 * in   tolerance  greatest distance from the exact curve, in its unit
 * out  pieces     error is the greatest distance found, at seven points of each
 *                 piece, between points of equal parameter
 * ret  PH_OK | PH_NO_CONVERGENCE (names the segment) | PH_NO_MEMORY
 */
enum ph_status ph_hermite_pieces(const struct ph_curve *curve, double distance,
                                 double tolerance, struct ph_arena *arena,
                                 struct ph_pieces *pieces,
                                 struct ph_diag *diag);

#endif
