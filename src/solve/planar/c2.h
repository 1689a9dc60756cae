/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The C2 equations of the method `planar` and their solutions. */
#ifndef PH_SOLVE_PLANAR_C2_H
#define PH_SOLVE_PLANAR_C2_H

#include "base/diag.h"
#include "base/mem.h"
#include "curve/result.h"
#include "kernel/atph.h"
#include "kernel/cplx.h"
#include "kernel/tri.h"

#include <stdbool.h>
#include <stddef.h>

/* ---- C2 equations -------------------------------------------------------- */

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
 * sign).  Open curves have y = 1/2 at both ends and two more equations,
 * (w^2 - d)/|d| = 0  for the end derivatives d.
 *
 * F is dimensionless; max |F| is the largest closing error of a segment,
 * relative to its chord.  Everything is expected at unit scale: mean h 1,
 * chords of order 1.
 */

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
  const bool *turned;          /* [unknowns] or NULL: see ph_planar_c2_turned */
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

/* ph_planar_at_knot: (1), the mean of two unknowns that is w at their common
 * knot. */
static inline ph_cplx ph_planar_at_knot(double y, ph_cplx left, ph_cplx right) {
  return ph_cplx_of(right.re + y * (left.re - right.re),
                    right.im + y * (left.im - right.im));
}

/* ph_planar_unknowns: the number of unknowns, n or n + 2. */
size_t ph_planar_unknowns(const struct ph_planar_c2 *c2);

/* ph_planar_preimage: w0, w1, w2 of segment k from the unknowns b. */
void ph_planar_preimage(const struct ph_planar_c2 *c2, const ph_cplx *b,
                        size_t k, ph_cplx w[3]);

/* ph_planar_closing: F[k], from w0, w1, w2. */
static inline ph_cplx ph_planar_closing(const struct ph_planar_c2 *c2, size_t k,
                                        const ph_cplx w[3]) {
  const double *q = ph_planar_space(c2, k)->q;
  const ph_cplx u = {q[0] * w[0].re + q[1] * w[1].re + q[3] * w[2].re,
                     q[0] * w[0].im + q[1] * w[1].im + q[3] * w[2].im};
  const ph_cplx v = {q[0] * w[2].re + q[1] * w[1].re,
                     q[0] * w[2].im + q[1] * w[1].im};
  ph_cplx sum = ph_cplx_add(ph_cplx_mul(u, w[0]), ph_cplx_mul(v, w[2]));
  sum = ph_cplx_add(sum, ph_cplx_mul(ph_cplx_scale(q[2], w[1]), w[1]));
  return ph_cplx_sub(ph_cplx_scale(c2->ratio[k], sum), c2->direction[k]);
}

/*
 * ph_planar_c2_solve: the "good" solution: damped Newton from the chord start,
 * then from the cubic-spline midpoint start.
 *
 * inout c2      twist is set (closed)
 * out   b[ph_planar_unknowns(c2)]
 * ret   PH_OK | PH_E_NO_CONVERGENCE (names the worst segment) | PH_E_NO_MEMORY
 */
enum ph_status ph_planar_c2_solve(struct ph_planar_c2 *c2,
                                  struct ph_arena *scratch, ph_cplx *b,
                                  struct ph_planar_report *report,
                                  struct ph_diag *diag);

/* The solution from the cubic-spline midpoint start alone. */
struct ph_planar_second {
  ph_cplx *b; /* [unknowns] */
  ph_cplx twist;
  struct ph_planar_report report;
  enum ph_status status; /* PH_OK | PH_E_NO_CONVERGENCE, for which why says: */
  struct ph_diag why;
};

/*
 * ph_planar_c2_both: ph_planar_c2_solve, and that from the cubic-spline
 * midpoint start, at the same time where the curve is long and there is a
 * thread for it.  They differ only where the data turn sharply.
 * out   second  its b in the arena
 * ret   of ph_planar_c2_solve
 */
enum ph_status ph_planar_c2_both(struct ph_planar_c2 *c2,
                                 struct ph_arena *scratch, ph_cplx *b,
                                 struct ph_planar_report *report,
                                 struct ph_planar_second *second,
                                 struct ph_diag *diag);

/*
 * ph_planar_c2_turned: a solution from the chord start with some of the turns
 * between one chord and the next made the other way round, by a full turn less.
 * Turn i is that before chord i of a closed curve; of an open one that from the
 * end derivative to the first chord is 1, and 0 none.
 *
 * in   turned[unknowns]
 * ret  PH_OK | PH_E_NO_CONVERGENCE | PH_E_NO_MEMORY
 */
enum ph_status ph_planar_c2_turned(struct ph_planar_c2 *c2, const bool *turned,
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
 * ret  PH_OK | PH_E_NO_MEMORY
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

/* ---- Newton's iteration -------------------------------------------------- */

/*
 * What the equations (c2.c) offer to the iteration (newton.c).
 * Internal to the planar solver.
 */

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

/* ---- smooth data --------------------------------------------------------- */

/* Segments from which on ph_planar_c2_quick is of use: more than 64, and than
 * those for which a problem's theorem of Kantorovich is told. */
enum { PH_PLANAR_QUICK_LEAST = 101 };

enum ph_planar_quick {
  PH_PLANAR_QUICK_NONE,  /* another start is needed */
  PH_PLANAR_QUICK_NEAR,  /* b is a start for Newton's method */
  PH_PLANAR_QUICK_SOLVED /* b is a solution */
};

/*
 * ph_planar_c2_quick: a solution, or a start, of many PH quintics through
 * smooth data (quick.c); PH_PLANAR_QUICK_LEAST segments or more, none turned.
 *
 * inout c2          twist is set (closed)
 * in    clock       knows how much time there is
 * in    solved      max |F| that is a solution
 * out   b[unknowns]
 * -     work[n], inverse[n], up[n]
 * inout iterations
 * out   m           of b, unless there is none
 */
enum ph_planar_quick ph_planar_c2_quick(struct ph_planar_c2 *c2,
                                        const struct ph_arena *clock,
                                        double solved, ph_cplx *b,
                                        ph_cplx *work, double *inverse,
                                        ph_cplx *up, size_t *iterations,
                                        struct ph_planar_measure *m);

/* ---- the theorem of Kantorovich ------------------------------------------ */

/*
 * The theorem of Kantorovich for the C2 equations [GON18, theorem 2.2 and
 * lemma 2.3]: how far from a root an iterate can be.
 *
 * With the equations as above, J = F'(b), and maximum norms,
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

/* ---- every solution ------------------------------------------------------ */

/*
 * Every solution of the C2 equations, by a homotopy [GON18, sec. 2.4.1].
 *
 * N + 2 quadratic equations (closed: N) have 2^(N+2) roots (2^N) by Bezout's
 * theorem, counted with their multiplicity, which are half as many curves, as
 * b and -b are the same.  A closed curve may close with either twist: 2^(N+1)
 * curves open, 2^N closed.
 */

enum { PH_PLANAR_ALL_MAX = 12 }; /* segments */

/*
 * All curves, each once, of a closed curve first those of twist 1.
 *
 * Of special data two curves or more can be one; where they are nearer than
 * rounding can tell, it is the multiplicity that says how many.  The sum of
 * the multiplicities is always the number by Bezout.
 */
struct ph_planar_all {
  size_t n;             /* 0 unless all were found */
  ph_cplx *b;           /* [n][ph_planar_unknowns] */
  double *twist;        /* [n] 1 or -1; open: 1 */
  size_t *multiplicity; /* [n] nearly always 1 */
  size_t paths;         /* followed, with those that were followed again */
  size_t lost;          /* of these, without a use for their ends */
};

/*
 * ph_planar_all: every solution, in an order that depends on the data alone.
 *
 * inout c2       its twist is put back
 * out   all      its arrays in the arena `out`
 * ret   PH_OK | PH_E_BAD_VALUE (more than PH_PLANAR_ALL_MAX segments) |
 *       PH_E_NO_CONVERGENCE (says how many were found) | PH_E_NO_MEMORY
 */
enum ph_status ph_planar_all(struct ph_planar_c2 *c2, struct ph_arena *out,
                             struct ph_arena *scratch,
                             struct ph_planar_all *all, struct ph_diag *diag);

#endif
