/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The theorem of Kantorovich for the C2 equations [GON18, theorem 2.2 and
 * lemma 2.3]: how far from a root an iterate can be.
 *
 * With the equations as in planar_c2.h, J = F'(b), and maximum norms,
 *
 *   B = ||J^-1||,  C = ||J^-1 F(b)||,  ||F'(x) - F'(y)|| <= K ||x - y||,
 *   h = B C K,     radius = (1 - sqrt(1 - 2 h)) / h  C.
 *
 * If h <= 1/2, Newton from b converges to a root, and a root lies within the
 * radius of b.  B and K change when the equations are scaled, and so do the h
 * that [GON18] prints for equations of another scale; C does not.
 *
 * The numbers are those of double arithmetic: what is proved is proved up to
 * rounding.
 */
#ifndef PH_SOLVE_PLANAR_KANTOROVICH_H
#define PH_SOLVE_PLANAR_KANTOROVICH_H

#include "curve/result.h"
#include "solve/planar/c2.h"

/*
 * ph_planar_kantorovich: the theorem at b.
 *
 * B is exact up to 64 unknowns, O(n^2), and of open curves of any size, O(n).
 * Of closed curves with more unknowns it is an upper bound, O(n), and so is h.
 * It is infinite where J is singular or the O(n) formulas would divide by next
 * to nothing: nothing is certified then.
 *
 * ret  false when memory is exhausted
 */
bool ph_planar_kantorovich(const struct ph_planar_c2 *c2, const ph_cplx *b,
                           struct ph_arena *scratch,
                           struct ph_kantorovich *kantorovich);

#endif
