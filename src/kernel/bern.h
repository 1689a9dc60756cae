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
 * ph_bern_taylor: what the coefficients of a polynomial are multiplied by and
 * added to give its Taylor coefficients at u, p^(j)(u) / j!.
 *
 * out  rows[order + 1][degree + 1]  of j = 0 to order, at most degree
 */
void ph_bern_taylor(size_t degree, double u, size_t order, double *rows);

/*
 * ph_bern_contact: the first coefficients of a polynomial from its Taylor
 * coefficients at 0, and by symmetry the last ones from those at 1 in 1 - u.
 *
 * in   a[n]          Taylor coefficients, n <= degree + 1
 * out  c[n * stride] the first n; the last ones with a negative stride
 */
void ph_bern_contact(size_t degree, const double *a, size_t n, double *c,
                     ptrdiff_t stride);

/* ph_bern_elevate: the weight of coefficient `from' of a polynomial in
 * coefficient `to' of the same with the degree `higher'. */
double ph_bern_elevate(size_t degree, size_t from, size_t higher, size_t to);

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
 * in   c[from + 1]  from <= 48, or to; more would leave the range of a double
 * out  out[to + 1]  to <= 500; not c
 */
void ph_bern_lift(const ph_cplx *c, size_t from, size_t to, ph_cplx *out);

#endif
