/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * What the equations (planar_c2.c) offer to the iteration (planar_newton.c).
 * Internal to the planar solver.
 */
#ifndef PH_SOLVE_PLANAR_NEWTON_H
#define PH_SOLVE_PLANAR_NEWTON_H

#include "solve/planar_c2.h"

/* How large the residual is; squares, NaN where any equation is NaN. */
struct ph_planar_measure {
  double sum2;    /* sum of |F|^2 */
  double max2;    /* max |F|^2 */
  double scaled2; /* max of |F|^2 / (1 + h/|c| (|w0|^2+|w1|^2+|w2|^2))^2: in
                     units of the terms that F is the difference of */
  size_t worst;   /* the segment of max2 */
};

/* ph_planar_residual: the measure of F at b. */
struct ph_planar_measure ph_planar_residual(const struct ph_planar_c2 *c2,
                                            const ph_cplx *b);

/*
 * ph_planar_newton_step: the measure of F at b, and the solution of
 * F'(b) step = F(b), in one pass.
 *
 * out  step[unknowns]   not finite if F' is singular
 */
struct ph_planar_measure ph_planar_newton_step(const struct ph_planar_c2 *c2,
                                               const ph_cplx *b,
                                               struct ph_tri *tri,
                                               ph_cplx *step);

/* ph_planar_chord_middles: c/h.  out middle[n] */
void ph_planar_chord_middles(const struct ph_planar_c2 *c2, ph_cplx *middle);

/*
 * ph_planar_spline_middles: derivatives of the C2 cubic spline at the middles
 * of the segments.
 *
 * ws   derivative[n + 1]
 * out  middle[n]
 */
void ph_planar_spline_middles(const struct ph_planar_c2 *c2, struct ph_tri *tri,
                              ph_cplx *derivative, ph_cplx *middle);

/*
 * ph_planar_start: unknowns whose w(1/2)^2 are the given middle derivatives.
 *
 * inout c2            twist is set (closed)
 * ws    root[unknowns]
 * out   b[unknowns]
 */
void ph_planar_start(struct ph_planar_c2 *c2, const ph_cplx *middle,
                     struct ph_tri *tri, ph_cplx *root, ph_cplx *b);

#endif
