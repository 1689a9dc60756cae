/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Bernstein forms of high degree n without de Casteljau's n^2 steps: values in
 * O(sqrt n), and parts of the curve as polynomials of a low degree m, with a
 * bound of what is lost.
 *
 * Of p on a part of width h, interpolated in m + 1 Chebyshev nodes, at most
 *
 *   2 (h/4)^(m+1) |p^(m+1)| / (m+1)!,
 *   |p^(m+1)| / (m+1)! <= binomial(n, m+1) max_k |Delta^(m+1) c_k|
 *
 * is lost, by the remainder of interpolation [DAV75, sec. 3.1, 3.3] and as a
 * derivative in Bernstein form is a convex combination of its coefficients; nor
 * more than, with any rho > 1,
 *
 *   4 M rho^-m / (rho - 1),  M = max_k |c_k - c_0| max_E (|z| + |1 - z|)^n  (1)
 *
 * on the ellipse E whose foci are the ends of the part, and whose half axes are
 * h (rho +- 1/rho)/4.  Derived here: there |p - c_0| <= M, as the values of the
 * basis are those of (|z| + |1 - z|)^n by the binomial theorem at most; so
 * coefficients of its series in Chebyshev polynomials are at most 2 M rho^-k,
 * and in the nodes each of these beyond m is one below, or 0.  That is much
 * less where control points are rough; the largest differences count
 * everywhere.
 *
 * Where n is so high that the differences are rounding, p is one of a middle
 * degree (bern_near.h), if there is one.
 */
#ifndef PH_KERNEL_BERN_LOW_H
#define PH_KERNEL_BERN_LOW_H

#include "kernel/bern_near.h"
#include "kernel/cplx.h"

#include <stddef.h>

/* The low degree; and the least that it is worth while for. */
enum { PH_BERN_LOW = 15, PH_BERN_HIGH = 2 * PH_BERN_LOW + 3 };

struct ph_bern_low {
  const ph_cplx *c; /* [degree + 1], not copied */
  size_t degree;
  ph_cplx near[PH_BERN_NEAR + 1]; /* what stands for it, */
  size_t near_degree;             /* 0: nothing does, */
  double away;                    /* and how far it is from there */
  double cutting;                 /* what rounding adds to a part of that */
  double reach;    /* how far its coefficients are from the first */
  double rest;     /* what is lost, over h^(LOW + 1); infinite below HIGH */
  double rounding; /* and what rounding adds to it */
  double node[PH_BERN_LOW + 1];                /* in [0,1] */
  double lu[PH_BERN_LOW + 1][PH_BERN_LOW + 1]; /* values at them, factored */
};

/*
 * ph_bern_value: p(u), by the terms that matter, outward from the largest.  In
 * error by at most 4 sqrt(n) eps times the largest |c[k]|.
 */
ph_cplx ph_bern_value(const ph_cplx *c, size_t degree, double u);

/* ph_bern_slope: p'(u), the same by differences of c. */
ph_cplx ph_bern_slope(const ph_cplx *c, size_t degree, double u);

/*
 * ph_bern_low_of: a polynomial whose parts are asked for.
 *
 * ws  room[degree + 1]
 */
void ph_bern_low_of(struct ph_bern_low *low, const ph_cplx *c, size_t degree,
                    ph_cplx *room);

/*
 * ph_bern_low_part: the part [from, to] as a polynomial of degree LOW, or of
 * the middle degree.
 *
 * in   allowed  that may be lost
 * out  part[degree + 1], lost
 * ret  its degree; 0 where more might be lost: part is of no use then
 */
size_t ph_bern_low_part(const struct ph_bern_low *low, double from, double to,
                        double allowed, ph_cplx *part, double *lost);

#endif
