/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Every solution of the C2 equations, by a homotopy [GON18, sec. 2.4.1].
 *
 * N + 2 quadratic equations (closed: N) have 2^(N+2) roots (2^N) by Bezout's
 * theorem, counted with their multiplicity, which are half as many curves, as
 * b and -b are the same.  A closed curve may close with either twist: 2^(N+1)
 * curves open, 2^N closed.
 */
#ifndef PH_SOLVE_PLANAR_ALL_H
#define PH_SOLVE_PLANAR_ALL_H

#include "solve/planar/c2.h"

enum { PH_PLANAR_ALL_MAX = 12 }; /* segments */

/*
 * All curves, each once, of a closed curve first those of twist 1.
 *
 * Of special data two curves or more can be one; where they are nearer than
 * rounding can tell, it is the multiplicity that says how many.  The sum of
 * the multiplicities is always the number by Bezout.
 */
struct ph_planar_all {
  size_t n;             /* 0 unless all were found */
  ph_cplx *b;           /* [n][ph_planar_unknowns] */
  double *twist;        /* [n] 1 or -1; open: 1 */
  size_t *multiplicity; /* [n] nearly always 1 */
  size_t paths;         /* followed, with those that were followed again */
  size_t lost;          /* of these, without a use for their ends */
};

/*
 * ph_planar_all: every solution, in an order that depends on the data alone.
 *
 * inout c2       its twist is put back
 * out   all      its arrays in the arena `out`
 * ret   PH_OK | PH_BAD_VALUE (more than PH_PLANAR_ALL_MAX segments) |
 *       PH_NO_CONVERGENCE (says how many were found) | PH_NO_MEMORY
 */
enum ph_status ph_planar_all(struct ph_planar_c2 *c2, struct ph_arena *out,
                             struct ph_arena *scratch,
                             struct ph_planar_all *all, struct ph_diag *diag);

#endif
