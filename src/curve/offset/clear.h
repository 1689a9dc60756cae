/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Whether places are at a distance from all of a curve, by a tree of the boxes
 * of its control points and the ellipses (arc.h) of parts of its segments: a
 * place is no nearer to any point of a part than to its chord, less the shorter
 * semi-axis.  Parts are halved until that says enough, or an end of one is
 * nearer.
 */
#ifndef PH_CURVE_OFFSET_CLEAR_H
#define PH_CURVE_OFFSET_CLEAR_H

#include "curve/offset/strand.h"
#include "kernel/boxtree.h"

/* What is nearer by less, of the size, is not nearer. */
#define PH_CLEAR_TOLERANCE 1e-13

struct ph_clear {
  const struct ph_strands *strands;
  struct ph_boxtree boxes;
  struct ph_fast3 fast;
  size_t segment; /* that it is prepared for */
  double whole;
};

/* ph_clear_begin: the tree.  ret PH_OK | PH_E_NO_MEMORY */
enum ph_status ph_clear_begin(struct ph_clear *clear,
                              const struct ph_strands *strands,
                              struct ph_diag *diag);

/*
 * ph_clear_of: whether no point of the curve is nearer to a place than the
 * distance of the strands.
 *
 * in  near  segment to look at first, as the place is beside it
 */
bool ph_clear_of(struct ph_clear *clear, ph_cplx place, size_t near);

/*
 * ph_clear_around: how often a closed curve goes round a place that keeps the
 * distance, positive to the left.  A part whose ellipse the place is not in
 * turns round it as its chord does.
 */
int ph_clear_around(struct ph_clear *clear, ph_cplx place);

#endif
