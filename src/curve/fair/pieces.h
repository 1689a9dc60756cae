/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Intervals of a planar PH or ATPH segment on which its curvature is integrated
 * by one Gauss rule each.
 *
 * What is integrated has its poles at the zeros of the preimage w and at the
 * conjugates of these.  In S0 and S1 (kernel/atph.h) w has two zeros, in u as
 * many for each period of an ATPH segment, 2 pi over its angle.  How far the
 * nearest one is, as an ellipse around the interval, says how many nodes are
 * enough; nothing is compared.  Where the most are not, the interval is cut in
 * half.
 */
#ifndef PH_CURVE_FAIR_PIECES_H
#define PH_CURVE_FAIR_PIECES_H

#include "curve/segment/seg2.h"
#include "kernel/quad.h"

#include <stdbool.h>
#include <stddef.h>

/* Rules of 4 to 20 nodes, and which has 16; cuts in half, to 1/256 of a
 * segment; pieces: of each size no more than 3 for either zero are cut, into
 * one more each. */
enum {
  PH_PIECE_RULES = 6,
  PH_PIECE_SIXTEEN = 4,
  PH_PIECE_CUTS = 8,
  PH_PIECES_MAX = 64
};

struct ph_piece {
  double from, to; /* in [0,1] */
  size_t rule;     /* the last one, where none is enough */
  bool enough;     /* for energies to 3e-13 relative */
};

/* ph_pieces_rules: the rules; false when memory is exhausted.
 * out  rule[PH_PIECE_RULES] */
bool ph_pieces_rules(struct ph_quad *rule);

/*
 * ph_pieces_of: the pieces of a segment, from 0 to 1.
 *
 * in   seg    at unit scale, or near it
 * out  piece  [PH_PIECES_MAX]
 * ret  how many; the pieces near a zero on the segment are not enough
 */
size_t ph_pieces_of(const struct ph_seg2 *seg, struct ph_piece *piece);

#endif
