/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Curves and offsets of all kinds as B-splines, rational where they must be:
 * NURBS, as programs for design read them.
 *
 * PH curves and Tschirnhausen cubics are polynomial B-splines, their offsets
 * and loops rational ones, exactly.  ATPH curves, and offsets of these, are
 * quintic within the tolerance (hermite.h); what lies on a sphere is cubic:
 * Hermite pieces with the points and derivatives of the curve, halved until
 * they are within the tolerance at seven places, at equal parameters.
 *
 * Weights of a piece may be multiplied by any number: each piece has the one
 * that makes its first weight the last one of the piece before.
 */
#ifndef PH_CURVE_BEZIER_NURBS_H
#define PH_CURVE_BEZIER_NURBS_H

#include "base/diag.h"
#include "base/mem.h"
#include "curve/result.h"

/*
 * ph_nurbs_of: the chains of a curve, or of a raw offset of it.
 *
 * in   offset     NULL: the curve itself; its chains end at gaps
 * in   tolerance  greatest distance, in the unit of the curve
 * out  chains     from the arena; of a closed curve without gaps one, closed
 * ret  PH_OK | PH_E_NO_CONVERGENCE (names the segment) | PH_E_TOO_LARGE |
 *      PH_E_NO_MEMORY | what ph_sampler_enter returns
 */
enum ph_status ph_nurbs_of(const struct ph_curve *curve,
                           const struct ph_offset *offset, double tolerance,
                           struct ph_arena *arena, struct ph_splines *chains,
                           struct ph_diag *diag);

/* ph_nurbs_loops: those of all loops of an offset, in each of them.
 * ret PH_OK | PH_E_NO_MEMORY */
enum ph_status ph_nurbs_loops(struct ph_offset *offset, struct ph_arena *arena,
                              struct ph_diag *diag);

#endif
