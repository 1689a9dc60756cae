/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Where two pieces of planar PH or ATPH segments meet, or one meets itself.
 *
 * Two points of a curve meet if they are no further apart than a tolerance and
 * the curve between them turns by a half turn or more: neighbours are near each
 * other, but do not meet.  A turn of a half turn or more within the tolerance,
 * and a point where the curve stands still, is a meeting with itself.
 */
#ifndef PH_CURVE_CROSS_MEET_H
#define PH_CURVE_CROSS_MEET_H

#include "curve/cross/bound2.h"
#include "curve/segment/seg2.h"

/* A piece of a segment: what is known of where it is and where it goes. */
struct ph_piece {
  size_t segment;
  double from, to; /* the part of the segment */
  struct ph_seg2 seg;
  ph_cplx p[6]; /* control points: their convex hull holds the piece */
  struct ph_box2 box;
  struct ph_cone cone;
};

/* ph_piece_of: a whole segment. */
struct ph_piece ph_piece_of(const struct ph_seg2 *seg, size_t segment);

/* ph_piece_halves: the halves of a piece by its parameter. */
void ph_piece_halves(const struct ph_piece *piece, struct ph_piece half[2]);

/* ph_piece_cone: the cone of the directions w^2. */
struct ph_cone ph_piece_cone(const ph_cplx w[3]);

/*
 * ph_piece_curvature: bounds of the signed curvature of a monotone piece, which
 * come together as the piece shrinks.
 *
 * out  range[2]
 */
void ph_piece_curvature(const struct ph_piece *piece, double range[2]);

/* Cones of what lies between two pieces, travelling from the first to the
 * second and, on closed curves (else it is wide), from the second round to the
 * first. */
struct ph_between {
  struct ph_cone inner, outer;
};

/* ph_between_narrow: whether the curve from one piece through the other, one
 * way or the other, moves along an axis: then the two do not meet. */
bool ph_between_narrow(const struct ph_between *between,
                       const struct ph_cone *first,
                       const struct ph_cone *second);

/* A search for one meeting. */
struct ph_meet {
  const struct ph_quad *rule; /* 12 nodes; NULL: no matter where */
  double tolerance;           /* distance that counts as none */
  size_t steps;               /* that are left; without them all meet */
  bool found;
  size_t segment[2]; /* what was found, in order of travel */
  double u[2];
};

/* ph_meet_pair: looks for a meeting of two pieces, the first of which comes
 * earlier on the curve. */
void ph_meet_pair(struct ph_meet *meet, const struct ph_piece *a,
                  const struct ph_piece *b, const struct ph_between *between);

/* ph_meet_self: looks for a meeting of a piece with itself.
 * in   outer  cone of the rest of the curve, as for ph_between */
void ph_meet_self(struct ph_meet *meet, const struct ph_piece *piece,
                  const struct ph_cone *outer);

#endif
