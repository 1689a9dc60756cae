/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Internal declarations of the method `planar`: data, curves, choices. */
#ifndef PH_SOLVE_PLANAR_PLANAR_H
#define PH_SOLVE_PLANAR_PLANAR_H

#include "base/diag.h"
#include "base/mem.h"
#include "curve/fair/pieces.h"
#include "curve/problem.h"
#include "curve/result.h"
#include "kernel/atph.h"
#include "kernel/cplx.h"
#include "kernel/tri.h"
#include "solve/planar/c2.h"

#include <stdbool.h>
#include <stddef.h>

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
 * in   arena      memory of the data, but for what
 * in   roots      has: knots, spacings, and the weights y of data->c2, which
 *                 preimages are found from, and no control points; and for what
 * in   equations  has: chords, and the directions and ratios of data->c2, which
 *                 a curve is not filled from
 * ret  PH_OK | PH_E_TOO_FEW_POINTS | PH_E_COINCIDENT_POINTS | PH_E_BAD_SHAPE |
 *      PH_E_BAD_VALUE | PH_E_ZERO_TANGENT | PH_E_TOO_LARGE | PH_E_NO_MEMORY
 */
enum ph_status ph_planar_data_of(const struct ph_problem *problem,
                                 struct ph_arena *arena, struct ph_arena *roots,
                                 struct ph_arena *equations,
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
 * ph_planar_curve_roots: the preimages of a curve, for the twist in data->c2,
 * of atph curves by u in [0,1]; and lengths and knots.
 *
 * in   b[unknowns]  a solution of the C2 equations
 * in   arena        its threads share what is long
 */
void ph_planar_curve_roots(const struct ph_planar_data *data, const ph_cplx *b,
                           const struct ph_arena *arena, struct ph_curve *curve,
                           struct ph_planar_loops *loops);

/* ph_planar_curve_points: the control points of a curve from its preimages,
 * which are by t from then on. */
void ph_planar_curve_points(const struct ph_planar_data *data,
                            const struct ph_arena *arena,
                            struct ph_curve *curve);

/* ph_planar_curve_fill: both. */
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
  struct ph_quad rule[PH_PIECE_RULES];
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
 * out  g->by_angle, g->by_h
 */
void ph_planar_gradient_of(struct ph_planar_gradient *g,
                           const struct ph_planar_data *data, const ph_cplx *b,
                           const double weight[3]);

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

#endif
