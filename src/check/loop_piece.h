/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A piece of a loop, at unit scale: places on it, and on the part of a segment
 * that it is said to be beside, at fixed parameters that all pieces share.
 */
#ifndef PH_CHECK_LOOP_PIECE_H
#define PH_CHECK_LOOP_PIECE_H

#include "check/segment.h"
#include "kernel/boxtree.h"

enum { PH_CHECK_POINTS_MAX = 16, PH_CHECK_SPOTS = 8, PH_CHECK_MANY = 4 };

/* The parameters are nodes of a rule on [0,1]; the basis there and its
 * derivative. */
struct ph_check_nodes {
  double node[PH_CHECK_SPOTS], weight[PH_CHECK_SPOTS];
  double basis[PH_CHECK_POINTS_MAX][PH_CHECK_SPOTS];
  double slope[PH_CHECK_POINTS_MAX][PH_CHECK_SPOTS];
};

/*
 * ph_check_nodes_of: of pieces of a degree.
 *
 * out  few   a rule with both ends, exact to degree 13
 * out  many  [PH_CHECK_MANY] together a rule of Gauss on each half of [0,1],
 *            exact to degree 31
 * ret  false where memory is exhausted
 */
bool ph_check_nodes_of(size_t degree, struct ph_check_nodes *few,
                       struct ph_check_nodes *many);

/* Control points from the first one on, times weights; weights over the first
 * one. */
struct ph_check_piece {
  const struct ph_loop_piece *of;
  size_t degree;
  ph_vec3 first, last;
  ph_vec3 end[2]; /* derivatives at both ends */
  double x[PH_CHECK_POINTS_MAX], y[PH_CHECK_POINTS_MAX];
  double w[PH_CHECK_POINTS_MAX];
  struct ph_boxtree_node box; /* of the control points */
};

/* ph_check_piece_of: of degree <= PH_CHECK_POINTS_MAX - 1, positive weights. */
void ph_check_piece_of(const struct ph_check *v,
                       const struct ph_loop_piece *piece, size_t degree,
                       struct ph_check_piece *out);

/* A place of a piece, and the derivative there. */
struct ph_check_spot {
  ph_vec3 o, d;
};

/* ph_check_piece_at: the place at any parameter. */
struct ph_check_spot ph_check_piece_at(const struct ph_check_piece *piece,
                                       double x);

/* ph_check_piece_halve: both halves of a piece, with its box, for
 * ph_check_piece_spots: these are from the first point of the whole piece on.
 */
void ph_check_piece_halve(const struct ph_check_piece *piece,
                          struct ph_check_piece half[2]);

/* Points and derivatives at the nodes. */
struct ph_check_spots {
  double x[PH_CHECK_SPOTS], y[PH_CHECK_SPOTS];
  double dx[PH_CHECK_SPOTS], dy[PH_CHECK_SPOTS];
};

/* ph_check_piece_spots: of a piece, from its first point on. */
void ph_check_piece_spots(const struct ph_check_nodes *nodes,
                          const struct ph_check_piece *piece,
                          struct ph_check_spots *spots);

/* ph_check_segment_spots: of the part [in[0],in[1]] of a polynomial segment,
 * from an origin on; the derivatives are those by its own parameter. */
void ph_check_segment_spots(const struct ph_check *v,
                            const struct ph_check_nodes *nodes, size_t k,
                            const double in[2], ph_vec3 origin,
                            struct ph_check_spots *spots);

#endif
