/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Curves of all kinds, and their offsets, as polynomial cubic Bezier pieces in
 * space, by what a sampler says of them: a piece has the points and derivatives
 * of the curve at both ends.  Pieces are cut at cusps of offsets and halved
 * until they are within the tolerance at seven places; the distance falls by
 * 2^4 with each halving.
 */
#ifndef PH_CURVE_BEZIER_CUBICS3_H
#define PH_CURVE_BEZIER_CUBICS3_H

#include "base/diag.h"
#include "base/mem.h"
#include "curve/result.h"

/*
 * ph_cubics3_of: a curve, or a raw offset of it, as cubics.
 *
 * in   offset     NULL: the curve itself; else distance, vector and cusps count
 * in   tolerance  greatest distance, in the unit of the curve
 * out  cubics     degree 3, dimension 3, from the arena; error is the greatest
 *                 distance found, between points of equal parameter
 * ret  PH_OK | PH_E_NO_CONVERGENCE (names the segment: 2^16 pieces of it do not
 *      suffice) | PH_E_NO_MEMORY | what ph_sampler_enter returns
 */
enum ph_status ph_cubics3_of(const struct ph_curve *curve,
                             const struct ph_offset *offset, double tolerance,
                             struct ph_arena *arena, struct ph_pieces *cubics,
                             struct ph_diag *diag);

#endif
