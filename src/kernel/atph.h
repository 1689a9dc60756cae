/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The space of preimages of PH and ATPH segments, one family in the
 * angle a in [0, pi): polynomials of degree 2 for a = 0, <1, cos, sin> on an
 * interval of length a otherwise.
 *
 *   S0(u) = sin(a (1-u)/2) / sin(a/2),  S1(u) = sin(a u/2) / sin(a/2)   (1)
 *   w(u)  = w0 S0^2 + 2 c w1 S0 S1 + w2 S1^2,  c = cos(a/2),  u in [0,1] (2)
 *   mu_j  = integral of S0^(4-j) S1^j over [0,1], mu_(4-j) = mu_j        (3)
 *
 * [GON18, (2.1) and (2.5)], with (2.1) factored so that nothing cancels.  The
 * limit a = 0 is S0 = 1 - u, S1 = u, and w a Bernstein polynomial: formulas in
 * S0, S1, c and mu hold for PH and ATPH segments alike.
 */
#ifndef PH_KERNEL_ATPH_H
#define PH_KERNEL_ATPH_H

#include "kernel/cplx.h"

#include <stddef.h>

struct ph_atph {
  double angle;
  double c;     /* cos(a/2) > 0 */
  double sinc;  /* sin(a/2) / (a/2) */
  double slope; /* (a/2) cot(a/2): w'(0) = 2 slope (w1 - w0) */
  double q[4];  /* mu0, 4 c mu1, 4 c^2 mu2, 2 mu2: the integral of w^2 is
                   q0 (w0^2 + w2^2) + q1 w1 (w0 + w2) + q2 w1^2 + q3 w0 w2 */
};

/* ph_atph_of: the space of angle a, 0 <= a < pi; all to rounding. */
struct ph_atph ph_atph_of(double angle);

/* ph_atph_basis: S0 and S1 at u in [0,1]. */
void ph_atph_basis(const struct ph_atph *space, double u, double s[2]);

/* ph_atph_jet_by_basis: ph_atph_jet for every angle but 0. */
void ph_atph_jet_by_basis(const struct ph_atph *space, const ph_cplx *w,
                          double u, ph_cplx *jet, size_t n);

/*
 * ph_atph_jet: w and its derivatives with respect to u.  Inline: fairness is
 * integrals of it.
 *
 * out  jet[n]  w, w', ..., n <= 4
 */
static inline void ph_atph_jet(const struct ph_atph *space, const ph_cplx w[3],
                               double u, ph_cplx *jet, size_t n) {
  ph_cplx left = ph_cplx_sub(w[1], w[0]), right = ph_cplx_sub(w[2], w[1]);
  if (space->angle > 0) {
    ph_atph_jet_by_basis(space, w, u, jet, n);
    return;
  }
  jet[0] = ph_cplx_between(ph_cplx_between(w[0], w[1], u),
                           ph_cplx_between(w[1], w[2], u), u);
  if (n > 1) {
    jet[1] = ph_cplx_scale(2, ph_cplx_between(left, right, u));
  }
  if (n > 2) {
    jet[2] = ph_cplx_scale(2, ph_cplx_sub(right, left));
  }
  if (n > 3) {
    jet[3] = ph_cplx_of(0, 0);
  }
}

/*
 * The functions that w0, w1, w2 multiply in (2), with two derivatives by u, and
 * how they change with the angle.
 */
struct ph_atph_table {
  double b[3][3];      /* [order][i] */
  double change[3][3]; /* a d/da of that; 0 for a = 0 */
};

/* ph_atph_table_of: the table at u in [0,1]. */
struct ph_atph_table ph_atph_table_of(const struct ph_atph *space, double u);

/* ph_atph_slope_change: a d(log slope)/da. */
double ph_atph_slope_change(const struct ph_atph *space);

/* ph_atph_q_change: a dq/da.
 * out  change[4] */
void ph_atph_q_change(const struct ph_atph *space, double change[4]);

/*
 * ph_atph_part: the preimage of the part [u0,u1] of a segment, on [0,1] again.
 *
 * out  part     angle a (u1 - u0)
 * out  v[3]     v(x) = w(u0 + x (u1 - u0)): its hodograph must still be
 *               multiplied by u1 - u0
 */
void ph_atph_part(const struct ph_atph *space, const ph_cplx w[3], double u0,
                  double u1, struct ph_atph *part, ph_cplx v[3]);

#endif
