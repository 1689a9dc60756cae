/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Real forms in the functions S0 and S1 of kernel/atph.h, as which the
 * invariants of PH and ATPH segments can be written:
 *
 *   f(u) = sum_k f[k] S0^(n-k) S1^k                                       (1)
 *
 * With v = S1 / (S0 + S1), which grows from 0 to 1 with u, f is (S0 + S1)^n > 0
 * times a polynomial in v whose Bernstein coefficients are
 *
 *   b[k] = f[k] / binomial(n, k)                                          (2)
 *
 * Their signs say where f can change its own; halving the interval of v as
 * often as needed makes that exact.
 */
#ifndef PH_KERNEL_FORM_H
#define PH_KERNEL_FORM_H

#include <stdbool.h>
#include <stddef.h>

/* The largest degree for ph_form_sign. */
enum { PH_FORM_DEGREE_MAX = 8 };

/*
 * ph_form_multiply: the product of two forms.
 *
 * in   f[f_degree + 1], g[g_degree + 1]
 * out  product[f_degree + g_degree + 1]
 */
void ph_form_multiply(const double *f, size_t f_degree, const double *g,
                      size_t g_degree, double *product);

/* ph_form_bernstein: the coefficients (2); b may be f. */
void ph_form_bernstein(const double *f, size_t degree, double *b);

/*
 * ph_form_halve: the Bernstein coefficients on both halves of the interval of
 * v, exact but for rounding.
 *
 * in   b[degree + 1]
 * out  left[degree + 1], right[degree + 1]  b may be one of them
 */
void ph_form_halve(const double *b, size_t degree, double *left, double *right);

/* ph_form_is_mixed: whether coefficients of both signs occur; where they do
 * not, the form has one sign. */
bool ph_form_is_mixed(const double *b, size_t degree);

/*
 * ph_form_root: the only root in (0,1), where the signs of coefficients say
 * that there is one, and the form is 0 at neither end; by Newton's method, kept
 * between places of both signs.
 *
 * in   b[degree + 1]  Bernstein coefficients; degree <= PH_FORM_DEGREE_MAX
 * ret  false: they do not say so, or one is not finite
 */
bool ph_form_root(const double *b, size_t degree, double *root);

/*
 * ph_form_sign: the sign of a form on [0,1].
 *
 * in   f[degree + 1]  degree <= PH_FORM_DEGREE_MAX
 * in   tolerance      of zero, relative to the largest |b[k]|
 * ret  +1, -1, or 0: it changes sign, or comes within the tolerance of zero,
 *      or is not finite
 */
int ph_form_sign(const double *f, size_t degree, double tolerance);

#endif
