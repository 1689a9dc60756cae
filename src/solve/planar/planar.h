/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Internal declarations of the method `planar`. */
#ifndef PH_SOLVE_PLANAR_PLANAR_H
#define PH_SOLVE_PLANAR_PLANAR_H

#include "base/diag.h"
#include "base/mem.h"
#include "curve/problem.h"
#include "curve/result.h"
#include "kernel/atph.h"
#include "kernel/cplx.h"
#include "kernel/quad.h"
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
 * -     work[n], inverse[n]
 * inout iterations
 * out   m           of b, unless there is none
 */
enum ph_planar_quick
ph_planar_c2_quick(struct ph_planar_c2 *c2, const struct ph_arena *clock,
                   double solved, ph_cplx *b, ph_cplx *work, double *inverse,
                   size_t *iterations, struct ph_planar_measure *m);

/* ---- the theorem of Kantorovich ------------------------------------------ */

/*
 * The theorem of Kantorovich for the C2 equations [GON18, theorem 2.2 and
 * lemma 2.3]: how far from a root an iterate can be.
 *
 * With the equations as in planar.h, J = F'(b), and maximum norms,
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

/* ---- data ---------------------------------------------------------------- */

/*
 * The data of a planar spline: points, knots, angles and end derivatives of a
 * problem, checked and brought to unit scale.
 *
 * Unit scale is a power of two for the points (coordinates below 1/2) and the
 * mean knot spacing for the parameter.  Both are undone exactly, or to one
 * rounding, where the solution is written.
 */

struct ph_planar_data {
  const double *points; /* [points_n][2], the user's */
  size_t n;             /* segments */
  bool closed;
  bool atph;             /* else all angles are 0 */
  bool own_knots;        /* atph: the knots are not the sums of the angles */
  const double *ends;    /* [2][2] end derivatives, the user's, or NULL */
  int exponent;          /* unit scale = data times 2^exponent; even */
  double *h;             /* [n] knot spacings, mean 1 */
  double h_mean;         /* in the user's parameter */
  double *knots;         /* [n + 1], the user's parameter */
  double *chord;         /* [n] |c| at unit scale */
  struct ph_atph *space; /* [n] atph, [1] ph */
  struct ph_planar_c2 c2;
};

/*
 * ph_planar_data_of: reads and checks a problem.
 *
 * ret  PH_OK | PH_E_TOO_FEW_POINTS | PH_E_COINCIDENT_POINTS | PH_E_BAD_SHAPE |
 *      PH_E_BAD_VALUE | PH_E_ZERO_TANGENT | PH_E_TOO_LARGE | PH_E_NO_MEMORY
 */
enum ph_status ph_planar_data_of(const struct ph_problem *problem,
                                 struct ph_arena *arena,
                                 struct ph_planar_data *data,
                                 struct ph_diag *diag);

/*
 * ph_planar_data_space: other angles (atph), or other knot spacings in the same
 * proportions (ph).
 *
 * The knots of atph data follow the angles unless the user gave them; those of
 * ph data keep their first and last, so that end derivatives, which are per
 * unit of the knots, keep their meaning.  Allocates nothing; the twist stays.
 *
 * in   spacing[n]  positive; atph: below pi
 * ret  as ph_planar_data_of; the data are then unusable until given others
 */
enum ph_status ph_planar_data_space(struct ph_planar_data *data,
                                    const double *spacing,
                                    struct ph_diag *diag);

/* ph_planar_data_chordal: spacings proportional to a power of the chords.
 * out  spacing[n]  the largest is `largest` */
void ph_planar_data_chordal(const struct ph_planar_data *data, double power,
                            double largest, double *spacing);

/* ph_planar_ends_change: how the default end derivative at an end of an open
 * curve changes with the spacings.
 *
 * in   side       0 or 1
 * out  change[2]  h d/dh for the segment at the end and for the next one
 */
void ph_planar_ends_change(const struct ph_planar_data *data, int side,
                           ph_cplx change[2]);

/* ph_planar_point: point k, 0 <= k <= n, of the user. */
static inline ph_cplx ph_planar_point(const struct ph_planar_data *d,
                                      size_t k) {
  size_t i = d->closed && k == d->n ? 0 : k;
  return ph_cplx_of(d->points[2 * i], d->points[2 * i + 1]);
}

/* ---- the curve, in the user's unit --------------------------------------- */

/* Segments that turn by more than half a turn, or stand still. */
struct ph_planar_loops {
  size_t n, first;
  double angle; /* of the first; NaN where it stands still */
};

/* ph_planar_curve_alloc: a curve for these data, without its numbers.
 * ret  PH_OK | PH_E_NO_MEMORY */
enum ph_status ph_planar_curve_alloc(const struct ph_planar_data *data,
                                     struct ph_arena *arena,
                                     struct ph_curve *curve,
                                     struct ph_diag *diag);

/*
 * ph_planar_curve_fill: the numbers of a curve, for the twist in data->c2.
 *
 * in   b[unknowns]  a solution of the C2 equations
 * in   arena        its threads share what is long
 */
void ph_planar_curve_fill(const struct ph_planar_data *data, const ph_cplx *b,
                          const struct ph_arena *arena, struct ph_curve *curve,
                          struct ph_planar_loops *loops);

/* ---- the fairest of the solutions of several starts ---------------------- */

/* Whether there may be several: the data turn by more than a right angle. */
bool ph_planar_turns_sharply(const struct ph_planar_c2 *c2);

struct ph_planar_choice {
  double ies; /* of the choice; NaN where there was none to make */
  /* Of the fairest other one, if it is about as fair; or NaN: */
  double other_ies;
  double other_length; /* at unit scale */
};

/*
 * ph_planar_choose: where the data turn by more than a right angle, looks for
 * fairer solutions: from the other start (ph_planar_c2_both), and with such
 * turns made the other way round, in all combinations up to 7 segments, in some
 * beyond, and from 151 segments on in none.  Of the two starts the solution of
 * less IES is taken, of all others one that is still less and does not cross
 * itself if that does not.
 *
 * Of curves that bend alike the shorter one is taken, of mirror images that
 * from either start, or else the one to the left (ph_planar_compare_sides).
 *
 * inout data    its twist
 * inout b[unknowns]  the solution from the first start
 * inout report  of that
 * in    second  of such data
 * ret   PH_OK | PH_E_NO_MEMORY
 */
enum ph_status ph_planar_choose(struct ph_planar_data *data,
                                struct ph_arena *scratch, ph_cplx *b,
                                struct ph_planar_report *report,
                                const struct ph_planar_second *second,
                                struct ph_planar_choice *choice,
                                struct ph_diag *diag);

/* ph_planar_compare_sides: which of two curves is farther to the left of its
 * chords where they part, or farther on along them: below 0 for x; 0 where they
 * are the same curve. */
int ph_planar_compare_sides(const struct ph_curve *x, const struct ph_curve *y);

/* ---- gradients of energies ----------------------------------------------- */

/* How the energies of a planar spline change with its angles and knots. */

struct ph_planar_gradient {
  struct ph_tri tri;
  struct ph_quad rule;
  ph_cplx *by_w;     /* [n][3] */
  ph_cplx *equation; /* [n] change of the equations with the angles */
  ph_cplx *by_b;     /* [unknowns] */
  ph_cplx *adjoint;  /* [unknowns] */
  double *by_y;      /* [n + 1] */
  double *by_angle;  /* [n] result: a d/da */
  double *by_h;      /* [n] result: h d/dh, the mean of all h aside */
};

/* ph_planar_gradient_alloc: workspace.  ret PH_OK | PH_E_NO_MEMORY */
enum ph_status ph_planar_gradient_alloc(struct ph_planar_gradient *g,
                                        const struct ph_planar_data *data,
                                        struct ph_arena *arena,
                                        struct ph_diag *diag);

/*
 * ph_planar_gradient_of: gradient of
 *   weight[0] E + weight[1] MV + weight[2] L  at unit scale.
 *
 * in   b[unknowns]  a solution of the C2 equations
 * in   parts[n]     intervals that its energies were integrated on
 * out  g->by_angle, g->by_h
 */
void ph_planar_gradient_of(struct ph_planar_gradient *g,
                           const struct ph_planar_data *data, const ph_cplx *b,
                           const double weight[3], const size_t *parts);

/* ---- least energy -------------------------------------------------------- */

/*
 * The fairest planar spline: angles of ATPH segments, or knot spacings of PH
 * quintics, that minimise a functional of its curvature [GON18, sec. 2.5].
 */

/* See curve/fair/energy.h. */
enum ph_planar_functional {
  PH_PLANAR_E,
  PH_PLANAR_MV,
  PH_PLANAR_IES,
  PH_PLANAR_IMV
};

struct ph_planar_min {
  double start;   /* for the data as given, in their unit; NaN: no solution */
  double minimum; /* the least that was found */
  size_t evaluations;
  size_t steps_max; /* that the last search may take */
  bool at_bound;    /* an angle or spacing is as small or large as is allowed */
  bool cut_short;   /* at the limit of steps, while one still gained 1e-8 */
};

/* Three times as many as any search took on random data. */
enum { PH_PLANAR_STEPS_MAX = 400 };

/*
 * ph_planar_minimize: searches from several starts, one of them the data as
 * given, for a minimum over
 *
 *   atph  every angle, in [1e-3, 2 pi/3]; or with `scale` one factor on all
 *         of them, in the proportions that the data have
 *   ph    every knot spacing, in [1/20, 20] times what chordal knots have;
 *         the first and last knot stay
 *
 * Given end derivatives keep their values, per unit of the knots.
 *
 * in    steps_max    of the last search, and of each before it; fewer of large
 *                    data
 * inout data         at the minimiser; as given where there is no solution
 * out   b[unknowns]  the solution there
 * ret   PH_OK | PH_E_BAD_VALUE (`scale` of ph) | PH_E_NO_MEMORY |
 *       PH_E_NO_CONVERGENCE: the data have no solution, and the minimum is NaN
 */
enum ph_status ph_planar_minimize(struct ph_planar_data *data,
                                  enum ph_planar_functional functional,
                                  bool scale, size_t steps_max,
                                  struct ph_arena *scratch, ph_cplx *b,
                                  struct ph_planar_min *report,
                                  struct ph_diag *diag);

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
