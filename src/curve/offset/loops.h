/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Loops of offsets, as plain arrays (loop.h makes them). */
#ifndef PH_CURVE_OFFSET_LOOPS_H
#define PH_CURVE_OFFSET_LOOPS_H

#include "curve/bezier/splines.h"
#include "curve/sample/samples.h"

#include <stdbool.h>

/*
 * A piece of a loop: a rational Bezier curve, the offset of a part of a segment
 * or a join at a corner.
 *
 * segment         PH_NO_SEGMENT: it is a join
 * interval[2]     the part of the segment, in its local parameter [0,1], from
 *                 the start of the piece to its end; of joins NaN
 * join            the corner, before that segment of the curve; PH_NO_SEGMENT:
 *                 it is none
 * angle           by which a join turns, to the left; else NaN
 * control_points[degree + 1][2], weights[degree + 1] > 0
 */
struct ph_loop_piece {
  size_t segment;
  double interval[2];
  size_t join;
  double angle;
  double length;
  double *control_points;
  double *weights;
};

/* A connected part of an offset, in the direction of travel. */
struct ph_loop {
  bool closed;
  double length;
  double area;   /* signed, positive if the inside is to the left; NaN unless
                    it is closed */
  size_t parent; /* loop of the offset of the next smaller distance on the same
                    side, around it; PH_NO_SEGMENT: none */
  struct ph_loop_piece *pieces;
  size_t n;
  struct ph_samples samples; /* t as of segments, of joins at the corner */
  struct ph_splines nurbs;
};

/* What is known of an offset that was put together to loops. */
struct ph_trimming {
  size_t crossings;     /* where parts of it cross */
  size_t touches;       /* or touch */
  double removed;       /* length of what was trimmed */
  double approximation; /* of ATPH offsets, how far pieces may be from the exact
                           ones; else NaN */
  double distance_error, closure_error, area_error; /* NaN: not known */
  bool certified;
};

struct ph_offset;

/* The loops of an offset (curve/offset/loop.h). */
struct ph_loops {
  const char *mode, *join; /* their words; NULL: it is no such offset */
  struct ph_loop *v;
  size_t n;                      /* 0: nothing is left */
  double area;                   /* NaN: a loop is not closed */
  bool both;                     /* it is of both sides of the curve */
  const struct ph_offset *sides; /* [2] that pieces along the curve are of, and
                                    those against it: distances and cusps; no
                                    part of the record */
  struct ph_trimming trimming;
};

#endif
