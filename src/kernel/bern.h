/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Polynomials in Bernstein form with complex coefficients, on [0,1]:
 * p(u) = sum_k c[k] binomial(n, k) (1-u)^(n-k) u^k.
 *
 * De Casteljau's recurrences throughout: convex combinations only, so that no
 * digit is lost anywhere in [0,1].
 */
#ifndef PH_KERNEL_BERN_H
#define PH_KERNEL_BERN_H

#include "kernel/cplx.h"

#include <stddef.h>

/* ph_bern_basis: the values binomial(n, k) (1-u)^(n-k) u^k of the basis.
 * out  basis[degree + 1] */
void ph_bern_basis(size_t degree, double u, double *basis);

/*
 * ph_bern_cut: the two parts of a polynomial beside u, each on [0,1] again.
 *
 * in   c[degree + 1]
 * out  left[degree + 1], right[degree + 1]
 */
void ph_bern_cut(const ph_cplx *c, size_t degree, double u, ph_cplx *left,
                 ph_cplx *right);

/*
 * ph_bern_lift: the same polynomial with a higher degree, at O(from to).
 *
 *   out[k] = sum_j c[j] C(from, j) C(to - from, k - j) / C(to, k)
 *
 * in   c[from + 1]  from <= 9, or to; more would leave the range of a double
 * out  out[to + 1]  to <= 500; not c
 */
void ph_bern_lift(const ph_cplx *c, size_t from, size_t to, ph_cplx *out);

#endif
