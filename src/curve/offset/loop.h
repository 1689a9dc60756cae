/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Offsets of plane curves as loops, joined or trimmed: exact rational pieces of
 * the degree of other offsets (offset.h), with length and area in closed form
 * [derived here].  With the increments of s, of theta = 2 arg w, and of the
 * products with the unit tangent T from end to end,
 *
 *   length   s - d theta
 *   area     A0 - d s + d^2 theta / 2 + (d / 2) [<r, T>],                  (1)
 *            A0 = 1/2 integral of Im(conj(r) r') du,
 *
 * the latter 1/2 integral of Im(conj(O) O') du; a join has A0 = s = 0.
 */
#ifndef PH_CURVE_OFFSET_LOOP_H
#define PH_CURVE_OFFSET_LOOP_H

#include "curve/kind/kind.h"
#include "curve/offset/outline.h"

/*
 * ph_loops_of: the loops of an offset, with samples if they are asked for.
 *
 * inout offset  distance and dimension are given; takes degree, length, loops
 * ret   PH_OK | what ph_strands_of and ph_outline_of return | PH_E_TOO_LARGE |
 *       PH_E_LIMIT (too many samples) | PH_E_NO_MEMORY
 */
enum ph_status ph_loops_of(const struct ph_curve *curve,
                           const struct ph_offset_rules *rules,
                           struct ph_arena *arena, struct ph_offset *offset,
                           struct ph_diag *diag);

/*
 * ph_loops_depth: to the side of a distance at which nothing is left of the
 * trimmed offset of a closed curve, the largest one that leaves something, by
 * halving; one that does, within 1e-7.
 *
 * ret  NaN: not known, as the curve is open or crosses itself, or it takes
 *      more than a few tenths of a second, as where all of the curve is near
 * the depth
 */
double ph_loops_depth(const struct ph_curve *curve,
                      const struct ph_offset_rules *rules, double distance,
                      struct ph_arena *arena);

/* ph_loops_nest: the parents of all loops of n offsets of a curve. */
void ph_loops_nest(struct ph_offset *offsets, size_t n);

/*
 * The sampler of a loop (sample.h): its segments are the pieces, each with u in
 * [0,1] along it.
 */
extern const struct ph_sampler_ops ph_loop_ops;

#endif
