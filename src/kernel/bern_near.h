/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * One polynomial of a middle degree in the place of one of a high degree, where
 * the whole is so smooth.
 *
 * Its series in Chebyshev polynomials T_k(2u - 1), from values at their nodes,
 * ends where terms are rounding [DAV75, sec. 3.3]; T_k has the coefficients
 *
 *   (-1)^(k-i) C(2k, 2i) / C(k, i)                                        (1)
 *
 * in Bernstein form (t_bern_near.c).  Raised to the high degree again, no
 * coefficient is further from that of the polynomial than is said, and so
 * nowhere are they.
 */
#ifndef PH_KERNEL_BERN_NEAR_H
#define PH_KERNEL_BERN_NEAR_H

#include "kernel/cplx.h"

#include <stddef.h>

/* The largest middle degree, and the least that it is worth while for. */
enum { PH_BERN_NEAR = 48, PH_BERN_FAR = 128 };

/*
 * ph_bern_near: what stands for a polynomial.
 *
 * in   c[degree + 1]
 * ws   room[degree + 1]
 * out  near[PH_BERN_NEAR + 1], as many coefficients as its degree needs
 * out  away  by how much it is away, at most
 * ret  its degree, or 0 where there is none
 */
size_t ph_bern_near(const ph_cplx *c, size_t degree, ph_cplx *room,
                    ph_cplx *near, double *away);

#endif
