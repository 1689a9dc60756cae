/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The outline of an offset: its strands put together to loops and open chains;
 * of a trimmed one only what keeps its distance from the whole curve.
 *
 * Along arcs whether it does changes only where they end or meet others: from
 * one such place to the next, a run, one place decides.  Three are looked at.
 * A run that ends at a cusp or an inner corner, where nothing goes on, is never
 * kept, however short.  Nor is a run of lines of a miter that is beyond another
 * part of a closed curve: it keeps the distance on the other side.
 */
#ifndef PH_CURVE_OFFSET_OUTLINE_H
#define PH_CURVE_OFFSET_OUTLINE_H

#include "curve/offset/strand.h"

/* A part of a strand; u increases, and it turns by less than PH_SPAN_TURN. */
#define PH_SPAN_TURN 3

struct ph_span {
  size_t strand;
  double u[2];
  struct ph_spot end[2];
  double length; /* < 0: it goes back along the curve */
  double turn;   /* of the tangent, signed */
};

struct ph_chain {
  size_t first, n; /* spans */
  double begin;    /* the segment that it begins beside, and the place there */
  bool closed;
};

struct ph_outline {
  struct ph_span *spans;
  size_t spans_n;
  struct ph_chain *chains; /* in the order of the places of the curve that they
                              begin beside */
  size_t chains_n;
  size_t crossings, touches;
  double length, removed; /* of all, and of what was trimmed */
  double gap; /* the largest between parts that follow one another */
};

/*
 * ph_outline_of: the outline.
 *
 * in   open  of a trimmed offset, whether chains may be open
 * ret  PH_OK | PH_E_INFEASIBLE (as ph_arcs_of) | PH_E_NO_CONVERGENCE (what is
 *      kept could not be told, or does not close; says where) | PH_E_NO_MEMORY
 */
enum ph_status ph_outline_of(const struct ph_strands *strands,
                             const struct ph_offset_rules *rules, bool open,
                             struct ph_outline *outline, struct ph_diag *diag);

#endif
