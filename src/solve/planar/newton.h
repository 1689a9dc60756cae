/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * What the equations (planar_c2.c) offer to the iteration (planar_newton.c).
 * Internal to the planar solver.
 */
#ifndef PH_SOLVE_PLANAR_NEWTON_H
#define PH_SOLVE_PLANAR_NEWTON_H

#include "solve/planar/c2.h"

/* How large the residual is, in squares. */
struct ph_planar_measure {
  double sum2;  /* sum of |F|^2; NaN where any equation is NaN */
  double max2;  /* max |F|^2 */
  size_t worst; /* the segment of max2 */
};

/* ph_planar_residual: the measure of F at b. */
struct ph_planar_measure ph_planar_residual(const struct ph_planar_c2 *c2,
                                            const ph_cplx *b);

/*
 * ph_planar_newton_step: the measure of F at b, and the solution of
 * F'(b) step = F(b), in one pass.
 *
 * out  tri                ph_tri_finish gives the step again
 * out  step[unknowns]     not finite if F' is singular
 */
struct ph_planar_measure ph_planar_newton_step(const struct ph_planar_c2 *c2,
                                               const ph_cplx *b,
                                               struct ph_tri *tri,
                                               ph_cplx *step);

/*
 * ph_planar_rounding: the largest |F| in units of the terms that F is the
 * difference of, 1 + h/|c| (|w0|^2 + |w1|^2 + |w2|^2).
 */
double ph_planar_rounding(const struct ph_planar_c2 *c2, const ph_cplx *b);

/*
 * ph_planar_row: equation i, 0 <= i < unknowns, as a row of F'(b) x = F(b).
 * Those of an open curve's ends come first and last.
 */
struct ph_tri_row ph_planar_row(const struct ph_planar_c2 *c2, const ph_cplx *b,
                                size_t i);

/*
 * An equation as a quadratic form of an unknown m and those before and after
 * it, l and r (those over the ends of a closed curve with their twist):
 *
 *   F = ll l^2 + lm l m + mm m^2 + lr l r + mr m r + rr r^2 - wanted
 *
 * [GON18, (2.19)], divided by the chord.
 */
struct ph_planar_form {
  double ll, lm, mm, lr, mr, rr;
  ph_cplx wanted;
};

/* ph_planar_form: equation i in the order of ph_planar_row. */
struct ph_planar_form ph_planar_form(const struct ph_planar_c2 *c2, size_t i);

/* ph_planar_is_solved: whether an iterate b of measure m is a solution by the
 * tolerance of the solver, or as near to one as rounding lets it be. */
bool ph_planar_is_solved(const struct ph_planar_c2 *c2, const ph_cplx *b,
                         const struct ph_planar_measure *m);

/* ph_planar_chord_middles: c/h.  out middle[n] */
void ph_planar_chord_middles(const struct ph_planar_c2 *c2, ph_cplx *middle);

/*
 * ph_planar_spline_middles: derivatives of the C2 cubic spline at the middles
 * of the segments.
 *
 * out  middle[n + 1]  the last one is workspace
 */
void ph_planar_spline_middles(const struct ph_planar_c2 *c2, struct ph_tri *tri,
                              ph_cplx *middle);

/* ph_planar_middles: where the middles lie in the array given to
 * ph_planar_start: beside room for the ends of an open curve. */
static inline ph_cplx *ph_planar_middles(const struct ph_planar_c2 *c2,
                                         ph_cplx *root) {
  return c2->closed ? root : root + 1;
}

/*
 * ph_planar_start: unknowns whose w(1/2)^2 are given middle derivatives.
 *
 * inout c2              twist is set (closed)
 * inout root[unknowns]  has the middles at ph_planar_middles; destroyed
 * out   b[unknowns]
 */
void ph_planar_start(struct ph_planar_c2 *c2, struct ph_tri *tri, ph_cplx *root,
                     ph_cplx *b);

#endif
