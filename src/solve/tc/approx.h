/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Approximation of a Bezier curve by Tschirnhausen cubics: C1 pairs with the
 * derivatives of the curve, third order [BYR11, sec. 5.4], and single cubics
 * with its tangents where these are nearer.
 */
#ifndef PH_SOLVE_TC_APPROX_H
#define PH_SOLVE_TC_APPROX_H

#include "base/diag.h"
#include "base/mem.h"
#include "curve/tc.h"

#include <stddef.h>

/* A Bezier curve of any degree >= 1, at unit scale. */
struct ph_tc_bezier {
  const ph_cplx *p; /* [degree + 1] */
  size_t degree;
  double shortest; /* chords of its cubics are longer; 0: than rounding */
};

/* Curves of higher degree are refused: binomial coefficients of twice the
 * degree must be finite. */
enum { PH_TC_DEGREE_MAX = 500 };

/* One cubic of an approximation. */
struct ph_tc_arc {
  double from, to; /* the part of the curve it stands for, in [0,1] */
  ph_cplx start, end;
  struct ph_tc tc;
};

/* Cubics that are collected; room grows by doubling, in an arena. */
struct ph_tc_arcs {
  struct ph_arena *arena;
  struct ph_tc_arc *arc;
  size_t n, room;
  double distance; /* an upper bound of the Hausdorff distance, proved */
};

/*
 * ph_tc_approximate: cubics within a Hausdorff distance of a Bezier curve, as
 * few as are found.  They begin and end on the curve, with its tangents; the
 * same curve backward gives the same cubics backward.
 *
 * in     tolerance  > 0
 * inout  arcs       appended to; distance is raised to that of these
 * ret  PH_OK | PH_NO_CONVERGENCE (says where) | PH_NO_MEMORY
 */
enum ph_status ph_tc_approximate(const struct ph_tc_bezier *curve,
                                 double tolerance, struct ph_tc_arcs *arcs,
                                 struct ph_diag *diag);

/*
 * ph_tc_approximate_pieces: the same with a number of cubics for a chain of
 * Bezier curves, all of them together: at a distance as small as is found with
 * at most `pieces` of them.
 *
 * in   curves[n]
 * in   pieces  >= n
 * in   least   no smaller distance is looked for
 * out  arcs    first[k] is the first one of curve k, first[n] = arcs->n
 * ret  as above; PH_BAD_VALUE if all that is found takes more than `pieces`
 */
enum ph_status ph_tc_approximate_pieces(const struct ph_tc_bezier *curves,
                                        size_t n, size_t pieces, double least,
                                        struct ph_tc_arcs *arcs, size_t *first,
                                        struct ph_diag *diag);

#endif
