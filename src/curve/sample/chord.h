/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Places on a segment such that no chord leaves it by more than an error E.
 *
 * The segment is halved while its chord bound M differs much over it.
 * A block of length h in u takes x = h sqrt(M / 8E) chords of equal steps (see
 * ph_sampler_chord_bound); x need not be whole, as the steps go on through the
 * next block with its own length: the places are equally spaced by the sum of
 * x.  A chord across a joint of blocks is checked by itself, and ends there if
 * it must.
 *
 * A block or chord of length 2E or less needs no bound: no place of it is
 * farther than E from one of its ends, and so is none of its chord.
 */
#ifndef PH_CURVE_SAMPLE_CHORD_H
#define PH_CURVE_SAMPLE_CHORD_H

#include "curve/sample/sample.h"

struct ph_chord_block;

/* Zeroed at first but for the arena; its memory is used again. */
struct ph_chords {
  struct ph_arena *arena;
  double *u; /* [n], increasing, the last one is 1; 0 is not among them */
  size_t n, room;
  struct ph_chord_block *blocks;
  size_t blocks_n, blocks_room;
};

/*
 * ph_chords_plan: plans the places on the segment that the sampler is in.
 *
 * in   error  E > 0, in the unit of the data
 * in   stops[stops_n]  by u, not decreasing: places in any case
 * in   most   places allowed
 * ret  PH_OK | PH_E_LIMIT | PH_E_NO_CONVERGENCE (no bound was found) |
 *      PH_E_NO_MEMORY
 */
enum ph_status ph_chords_plan(struct ph_chords *chords,
                              const struct ph_sampler *sampler, double error,
                              const struct ph_place *stops, size_t stops_n,
                              size_t most, struct ph_diag *diag);

#endif
