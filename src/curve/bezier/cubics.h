/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Curves of all kinds, and their offsets, as cubic Bezier curves in the plane,
 * for drawings.  Curves in space are seen along z.
 *
 * Cubics are given as they are.  A piece of any other curve is replaced by the
 * cubic with its end points and end tangents that meets it at a third and two
 * thirds; pieces are cut at cusps of offsets, and until
 * each is within the tolerance.  About other cusps, of the curve or of the view
 * of it, they are straight.
 *
 * Of straight pieces the distance is bounded (ph_sampler_chord_bound).  Of
 * others it is the greatest found at 22 places, and a tenth more: differences
 * have three extrema where the curve is regular.  That is not proven.
 */
#ifndef PH_CURVE_BEZIER_CUBICS_H
#define PH_CURVE_BEZIER_CUBICS_H

#include "base/diag.h"
#include "base/mem.h"
#include "curve/result.h"

/*
 * ph_cubics_of: a curve, or its offset, as cubics.
 *
 * in   offset     NULL: the curve itself; else distance, vector, cusps and
 *                 gaps count, or its loops, one after the other
 * in   tolerance  greatest distance, in the unit of the curve
 * out  cubics     degree 3, dimension 2, from the arena; where pieces meet,
 *                 also of two segments or at the ends of a closed curve, they
 *                 have the same control point, but not across a gap; error is
 *                 the greatest distance, as said above
 * ret  PH_OK | PH_E_NO_CONVERGENCE (names the segment: 2^16 pieces of it do not
 *      suffice) | PH_E_NO_MEMORY | what ph_sampler_enter returns
 */
enum ph_status ph_cubics_of(const struct ph_curve *curve,
                            const struct ph_offset *offset, double tolerance,
                            struct ph_arena *arena, struct ph_pieces *cubics,
                            struct ph_diag *diag);

#endif
