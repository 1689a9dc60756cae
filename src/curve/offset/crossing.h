/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Where arcs of an offset meet: every pair of them is excluded by a bound, or
 * decided by one.
 *
 *   apart      their ellipses (arc.h) are, along one of six directions
 *   following  smooth chains that turn by less than a half turn are graphs over
 *              a direction
 *   crossing   no tangent of the one is parallel to one of the other: there is
 *              at most one common point, and Newton's method has found it
 *   else       both are halved
 *
 * That is complete, as a root outside an arc, or none, concludes nothing.  What
 * is still there when it is a point, or a line within rounding, touches.  Arcs
 * that run on each other would be halved until they are points: they are marked
 * where both are, from the end of the one to that of the other.
 */
#ifndef PH_CURVE_OFFSET_CROSSING_H
#define PH_CURVE_OFFSET_CROSSING_H

#include "curve/offset/arc.h"

/* Places where arcs end for others. */
struct ph_break {
  size_t arc;
  double u;
};

/* A part of an arc that another one runs on; that one too has a row. */
struct ph_overlap {
  size_t arc;
  double u[2];
  size_t other;
  double on[2];  /* which part of it */
  bool opposite; /* against its direction: between them there is nothing */
};

struct ph_crossings {
  struct ph_break *breaks; /* in order of arcs and places */
  size_t breaks_n;
  struct ph_overlap *overlaps;
  size_t overlaps_n;
  size_t points, touches; /* where two arcs cross, or come to rest */
};

/*
 * ph_crossings_of: all meetings of arcs, but those of passive strands with each
 * other.  O(n log n) where each arc is near a bounded number of others.
 *
 * ret  PH_OK | PH_E_NO_CONVERGENCE (there are too many pairs; names a segment)
 *      | PH_E_NO_MEMORY
 */
enum ph_status ph_crossings_of(const struct ph_strands *strands,
                               const struct ph_arcs *arcs,
                               struct ph_crossings *crossings,
                               struct ph_diag *diag);

/*
 * What follows is between the search for pairs (crossing.c) and the decision on
 * one (crossing_pair.c).
 */
struct ph_bits {
  struct ph_bit v[2];
};

enum { PH_BITS_MAX = 512 };

struct ph_pairing {
  const struct ph_strands *strands;
  const struct ph_arcs *arcs;
  struct ph_strand_eval eval[2];
  struct ph_bits *stack; /* [PH_BITS_MAX] pairs that are not decided yet */
  struct ph_crossings *out;
  size_t breaks_room, overlaps_room;
  size_t tests, tests_most;
  struct ph_diag *diag;
};

/* ph_pair_decide: all meetings of arcs i < j.  ret as ph_crossings_of */
enum ph_status ph_pair_decide(struct ph_pairing *pairing, size_t i, size_t j);

#endif
