/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Curves of all kinds, and their offsets, as cubic Bezier curves in the plane,
 * for drawings.  Curves in space are seen along z.
 *
 * A piece of the curve is replaced by the cubic with its end points and end
 * tangents that is best found; pieces are halved until each is within the
 * tolerance.  Cubics are given as they are.
 */
#ifndef PH_CURVE_CUBICS_H
#define PH_CURVE_CUBICS_H

#include "base/diag.h"
#include "base/mem.h"
#include "curve/result.h"

/*
 * ph_cubics_of: a curve, or its offset, as cubics.
 *
 * in   offset     NULL: the curve itself; else distance, vector, cusps count
 * in   tolerance  greatest distance, in the unit of the curve
 * out  cubics     degree 3, dimension 2, from the arena; where pieces meet,
 *                 they have the same control point.  error is a bound or the
 *                 greatest distance found, as the .c says for each kind
 * ret  PH_OK | PH_NO_CONVERGENCE (names the segment) | PH_TOO_LARGE |
 *      PH_NO_MEMORY
 */
enum ph_status ph_cubics_of(const struct ph_curve *curve,
                            const struct ph_offset *offset, double tolerance,
                            struct ph_arena *arena, struct ph_pieces *cubics,
                            struct ph_diag *diag);

#endif
