/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The C2 equations of planar PH and ATPH splines, and their solution.
 *
 * [GON18, ch. 2] in normalised form; FAR01 for PH quintics and uniform knots.
 * Segment k has its own space of preimages (kernel/atph.h), that of a PH
 * quintic if its angle is 0.  The unknowns are the middle preimage coefficients
 * b[k] = w[k][1] of the n segments, and for open curves one more at either end.
 * C2 continuity at the knot between segments k and k+1 is built in:
 *
 *   w[k][2] = w[k+1][0] = y b[k] + (1 - y) b[k+1],
 *   y = s[k] h[k+1] / (s[k] h[k+1] + s[k+1] h[k])            (1)
 *
 * with s the slope of the space (1 for PH quintics).  What remains is one
 * equation a segment: its chord is the data's,
 *
 *   F[k] = h[k]/|c[k]| (q0 (w0^2 + w2^2) + q1 w1 (w0 + w2) + q2 w1^2
 *                       + q3 w0 w2) - c[k]/|c[k]| = 0        (2)
 *
 * with the q of the space, and w0, w1, w2 from (1): a complex tridiagonal
 * system, cyclic for closed curves with b[0] = b[n] / twist, b[n+1] = b[1]
 * twist.  The twist is 1 or -1 (the preimage of a closed curve closes up to its
 * sign); continuation uses other unit numbers.  Open curves have y = 1/2 at
 * both ends and two more equations,  (w^2 - d)/|d| = 0  for the end derivatives
 * d.
 *
 * F is dimensionless; max |F| is the largest closing error of a segment,
 * relative to its chord.  Everything is expected at unit scale: mean h 1,
 * chords of order 1.
 */
#ifndef PH_SOLVE_PLANAR_C2_H
#define PH_SOLVE_PLANAR_C2_H

#include "base/diag.h"
#include "base/mem.h"
#include "kernel/atph.h"
#include "kernel/cplx.h"
#include "kernel/tri.h"

#include <stdbool.h>
#include <stddef.h>

struct ph_planar_c2 {
  size_t n; /* segments; >= 1 open, >= 3 closed */
  bool closed;
  ph_cplx twist;      /* closed */
  ph_cplx *direction; /* [n] c/|c| */
  double *ratio;      /* [n] h/|c| */
  double *y;          /* [n + 1] weights at the knots; closed: y[0] = y[n] */
  const struct ph_atph *space; /* [n], or one for all */
  size_t space_stride;         /* 1, or 0 */
  ph_cplx end[2];              /* open: end derivatives d/|d| */
  double end_size[2];          /* open: |d| */
};

/* What a solution took. */
struct ph_planar_report {
  size_t iterations; /* Newton steps, over all starts */
  double residual;   /* max |F| */
  size_t worst;      /* the segment where it occurs */
};

/* ph_planar_space: the space of segment k. */
static inline const struct ph_atph *
ph_planar_space(const struct ph_planar_c2 *c2, size_t k) {
  return c2->space + k * c2->space_stride;
}

/* ph_planar_unknowns: the number of unknowns, n or n + 2. */
size_t ph_planar_unknowns(const struct ph_planar_c2 *c2);

/* ph_planar_preimage: w0, w1, w2 of segment k from the unknowns b. */
void ph_planar_preimage(const struct ph_planar_c2 *c2, const ph_cplx *b,
                        size_t k, ph_cplx w[3]);

/*
 * ph_planar_c2_solve: the "good" solution: damped Newton from the chord start,
 * then from the cubic-spline midpoint start, then by continuation in the
 * turning angles.
 *
 * inout c2      twist is set (closed)
 * out   b[ph_planar_unknowns(c2)]
 * ret   PH_OK | PH_NO_CONVERGENCE (names the worst segment) | PH_NO_MEMORY
 */
enum ph_status ph_planar_c2_solve(struct ph_planar_c2 *c2,
                                  struct ph_arena *scratch, ph_cplx *b,
                                  struct ph_planar_report *report,
                                  struct ph_diag *diag);

/*
 * ph_planar_c2_second: the solution from the cubic-spline midpoint start alone.
 * It differs from that of ph_planar_c2_solve only where the data turn sharply.
 */
enum ph_status ph_planar_c2_second(struct ph_planar_c2 *c2,
                                   struct ph_arena *scratch, ph_cplx *b,
                                   struct ph_planar_report *report,
                                   struct ph_diag *diag);

/*
 * ph_planar_c2_near: the solution next to a guess, such as the solution of
 * nearby data: Newton alone, a few steps.
 *
 * in   guess[unknowns]
 * out  b[unknowns]  other memory than guess
 * out  near         false: none was found; PH_OK all the same
 * ret  PH_OK | PH_NO_MEMORY
 */
enum ph_status ph_planar_c2_near(const struct ph_planar_c2 *c2,
                                 struct ph_arena *scratch, const ph_cplx *guess,
                                 ph_cplx *b, bool *near, struct ph_diag *diag);

/*
 * ph_planar_c2_adjoint: solves F'(b)^T x = r, without conjugation.
 *
 * in   r[unknowns]
 * out  x[unknowns]  not finite if F' is singular
 */
void ph_planar_c2_adjoint(const struct ph_planar_c2 *c2, const ph_cplx *b,
                          const ph_cplx *r, struct ph_tri *tri, ph_cplx *x);

/* ph_planar_c2_gradient: derivatives of F[k] with respect to w0, w1, w2. */
void ph_planar_c2_gradient(const struct ph_planar_c2 *c2, size_t k,
                           const ph_cplx w[3], ph_cplx g[3]);

#endif
