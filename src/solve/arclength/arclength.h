/* SPDX-License-Identifier: GPL-3.0-or-later */
/* How the equations of the method `arclength` (system.h) are solved. */
#ifndef PH_SOLVE_ARCLENGTH_ARCLENGTH_H
#define PH_SOLVE_ARCLENGTH_ARCLENGTH_H

#include "base/mem.h"
#include "curve/result.h"
#include "solve/arclength/newton.h"
#include "solve/arclength/system.h"

#include <stdbool.h>
#include <stddef.h>

/* ---- trust regions ------------------------------------------------------- */

/*
 * Steps within a trusted radius: the minimum of g . s + s . A s / 2 for
 * |s| <= radius, with a symmetric band matrix A that need not be positive
 * definite.  It solves (A + shift) s = -g with the least shift >= 0 that makes
 * A + shift positive definite and s short enough [MOR83, sec. 3].
 *
 * Where A is not positive definite the step goes along its lowest direction up
 * to the radius, even if g vanishes: nothing is lost near a saddle.
 */

struct ph_arc_region {
  size_t n, band;
  double *matrix; /* A, as in kernel/band.h: set by the caller */
  double *factor; /* of A + shift, after a step */
  double *g;      /* [n] set by the caller */
  double *step;   /* [n] s */
  double *other;  /* [n] */
  double shift;   /* of the last step */
  double hint;    /* the last that was not 0 */
  double length;  /* |s| */
  double fall;    /* by how much the model falls along s */
  size_t factors; /* tried so far */
};

/* ph_arc_region_alloc: false when memory is exhausted. */
bool ph_arc_region_alloc(size_t n, size_t band, struct ph_arena *arena,
                         struct ph_arc_region *region);

/*
 * ph_arc_region_step: the step.  Its length is within 0.5 to 1.6 of the radius,
 * or less if A is positive definite.
 *
 * in   above  a shift known to be too small, or 0
 * ret  false when none was found, as of a matrix that is not finite
 */
bool ph_arc_region_step(struct ph_arc_region *region, double radius,
                        double above);

/* ph_arc_region_solve: v = -(A + shift)^-1 v, after a step. */
void ph_arc_region_solve(const struct ph_arc_region *region, double *v);

/* ---- penalties ----------------------------------------------------------- */

/*
 * Solutions of the arc-length equations from afar: whitened rows, twisted
 * phases and an augmented Lagrangian.  They lead into the region
 * where Newton's method on the KKT system converges.
 *
 * With one segment in an interval the rows are nearly dependent wherever the
 * curve is smooth [HUA14, 4.5], so that a line search on a merit function
 * stalls.  What is here asks for no rank of the rows: every step is the minimum
 * of a model within a trusted radius, corrected for the curvature of the rows.
 */

/*
 * ph_arc_whiten: takes the rows of an interval to the entries of
 * M^-1/2 (integral of w w^H - M) M^-1/2, M = (length + step . sigma) / 2, the
 * Pauli matrices sigma.  With the unit vector u of the step, L = (length +
 * chord) / 2, e = (length - chord) / 2 and t across u, they are
 *
 *   (c_0 + u . c) / 2 L,  (c_0 - u . c) / 2 e,  t . c / sqrt(2 L e).
 *
 * They are relative, and the same wherever the data are turned.  Lengths near
 * their chords weigh more, as they leave less room.  Systems other than of
 * points with exact lengths stay as they are.
 *
 * ret  false when memory is exhausted
 */
bool ph_arc_whiten(struct ph_arc_system *system, struct ph_arena *arena);

/* ph_arc_plain: multipliers of the rows as they are, of those of the whitened
 * ones.  out plain[y_n], may be y */
void ph_arc_plain(const struct ph_arc_system *system, const double *y,
                  double *plain);

/* ph_arc_whitened: and back.  out white[y_n], may be y */
void ph_arc_whitened(const struct ph_arc_system *system, const double *y,
                     double *white);

/*
 * ph_arc_twist: turns the phases of the nodes by angle and -angle in turn.
 *
 * With one segment in an interval, smooth curves are too short for the exact
 * lengths of a smooth curve; those that are long enough have such phases, of
 * about a tenth of the turning of an interval.  inout x of a system in space
 */
void ph_arc_twist(const struct ph_arc_system *system, double angle, double *x);

/*
 * Windows: stretches of the nodes, each with a trusted radius of its own, so
 * that one place where steps are short does not shorten those of all others.
 *
 * The nodes between two windows are held, and no interval has nodes in two of
 * them: what they gain adds up exactly.  Two sweeps, whose windows are shifted
 * by half of one, move all nodes; chi of a closed curve is held.
 */
struct ph_arc_window {
  size_t low, high;   /* places in the order of matrices: low to high - 1 */
  size_t first, last; /* of its intervals in `interval`: first to last - 1 */
  double radius, hint;
};

struct ph_arc_windows {
  size_t n;       /* 0: there are too few intervals for windows */
  size_t part[3]; /* those of sweep k: part[k] to part[k + 1] - 1 */
  struct ph_arc_window *window; /* [n] */
  size_t *interval;             /* intervals that each touches */
  uint32_t *node;               /* [nodes] by their places */
  struct ph_arc_region region;  /* of one window */
  double *y;                    /* [y_n] */
};

/* ph_arc_windows_alloc: those of a system.  ret false: no memory */
bool ph_arc_windows_alloc(const struct ph_arc_system *system,
                          struct ph_arena *arena,
                          struct ph_arc_windows *windows);

/* What the search works in, for systems of one size. */
struct ph_arc_work {
  const struct ph_arena *arena; /* of all this; knows how much time there is */
  struct ph_arc_linear linear;
  struct ph_arc_region region;
  struct ph_arc_windows windows;
  double *ordered;                 /* [x_n] in the order of matrices */
  double *step;                    /* [x_n] */
  double *to, *better;             /* [x_n] points tried */
  double *c, *c_to, *c_better, *y; /* [y_n] */
};

/* ph_arc_work_alloc: ret false when memory is exhausted. */
bool ph_arc_work_alloc(const struct ph_arc_system *system,
                       struct ph_arena *arena, struct ph_arc_work *work);

/*
 * What is minimised: F + y . c + rho / 2 |c|^2.  A row that yields,
 * c - compliance y = 0, has (c + y / rho)^2 / (compliance + 1 / rho) / 2 in the
 * place of y c + rho / 2 c^2, but for a constant.
 */
struct ph_arc_lagrangian {
  const struct ph_arc_system *s;
  struct ph_arc_work *w;
  double *x;
  double *y;
  double rho;
  double f;     /* F at x; the rows there are in w->c */
  double value; /* at x */
  double radius, least;
};

/* ph_arc_row_weight: the second derivative by row r. */
static inline double ph_arc_row_weight(const struct ph_arc_lagrangian *g,
                                       size_t r) {
  return g->rho / (1 + ph_arc_compliance(g->s, r) * g->rho);
}

/* ph_arc_multiplier: the first derivative by row r, and the next y_r. */
static inline double ph_arc_multiplier(const struct ph_arc_lagrangian *g,
                                       const double *c, size_t r) {
  return (g->y[r] + g->rho * c[r]) / (1 + ph_arc_compliance(g->s, r) * g->rho);
}

/* ph_arc_row_value: what row r adds to F. */
static inline double ph_arc_row_value(const struct ph_arc_lagrangian *g,
                                      const double *c, size_t r) {
  double soft = ph_arc_compliance(g->s, r), y = g->y[r];
  return soft > 0 ? (c[r] + y / g->rho) * ph_arc_multiplier(g, c, r) / 2 -
                        y * y / g->rho / 2
                  : c[r] * (y + g->rho / 2 * c[r]);
}

/* ph_arc_model: gradient and matrix of the region at x. */
void ph_arc_model(struct ph_arc_lagrangian *g);

/* ph_arc_windows_begin: all radii anew. */
void ph_arc_windows_begin(struct ph_arc_lagrangian *g);

/* ph_arc_sweep: a step in each window of sweep 0 or 1.  It moves x, but w->c
 * and the value are left as they were. */
void ph_arc_sweep(struct ph_arc_lagrangian *g, size_t sweep);

struct ph_arc_penalty_options {
  double rho;        /* first weight of the squared rows */
  double rho_max;    /* and the last */
  double tolerance;  /* of the rows */
  double inner;      /* a step that gains less of F ends the inner iteration */
  size_t iterations; /* steps, at most */
  double creeps;     /* a step that gains less of the penalty ends it, too */
};

struct ph_arc_penalty_report {
  size_t iterations; /* steps made */
  size_t factors;    /* Cholesky factors tried */
  double rows;       /* the largest |c_k| */
};

/*
 * ph_arc_penalty: minimises F + y . c + rho / 2 |c|^2, then y += rho c, and so
 * on until the rows are met.
 *
 * inout x
 * inout y  multipliers of the rows of the system, whitened if they are
 * ret   whether the tolerance was reached
 */
bool ph_arc_penalty(const struct ph_arc_system *system,
                    const struct ph_arc_penalty_options *options,
                    struct ph_arc_work *work, double *x, double *y,
                    struct ph_arc_penalty_report *report);

/* ---- first iterates ------------------------------------------------------ */

/* Where the iterations of arclength begin [HUA14, sec. 4.4]. */

/*
 * ph_arc_start: spinors of the steps, or of the given vectors, with phases as
 * near to each other as they can be, between which the nodes are interpolated.
 *
 * inout system  the sign of a closed curve in the plane is set
 * out   x[x_n]
 * ret   false when memory is exhausted
 */
bool ph_arc_start(struct ph_arc_system *system, struct ph_arena *scratch,
                  double *x);

/*
 * ph_arc_perturb: adds a random curve of low frequencies to x.
 *
 * in    size   relative to the largest node
 * inout state  of the random numbers
 */
void ph_arc_perturb(const struct ph_arc_system *system, double size,
                    uint64_t *state, double *x);

/*
 * ph_arc_wiggle: nodes of a curve that is about as long as it is to be, from
 * those of the natural curve: where an interval is longer by the part e, its
 * nodes are tilted to one side and the other, as a wave of this length is, and
 * its speed is raised.
 *
 * in    natural  [n] lengths of the natural curve
 * inout x        of a system with lengths, two segments in an interval or more
 */
void ph_arc_wiggle(const struct ph_arc_system *system, const double *natural,
                   double *x);

/* ---- search -------------------------------------------------------------- */

/*
 * The search for minima of F under the rows: from several starts, in a fixed
 * order, until one leads to a minimum.  A minimum that was found is a local
 * one; of several the lowest is taken.
 */

/* The curve whose lengths are free. */
struct ph_arc_natural {
  bool known; /* false: all that follows is of what came nearest to it */
  double residual;
  double f;
  double *length; /* [n]; NULL: none was looked for */
  double *x;      /* [x_n] */
  size_t steps;   /* that the search took to find it */
};

/* ph_arc_natural_copy: in memory of its own; false: there is none. */
bool ph_arc_natural_copy(const struct ph_arc_natural *from, size_t n,
                         size_t x_n, struct ph_arena *arena,
                         struct ph_arc_natural *to);

/* What is asked for. */
struct ph_arc_request {
  const struct ph_arc_data *data;
  size_t refine;
  size_t dim;
  size_t random; /* extra starts */
  bool all;      /* try every start, keep every minimum */
  bool rescue;   /* augmented Lagrangians where Newton's method alone leads
                  * nowhere */
  bool waves;    /* and random waves */
  bool saddles;  /* whatever is stationary is looked for */
  bool stay;     /* no start is iterated: where the first begins is asked for */
  const struct ph_arc_natural *natural; /* of a search before, of the same data,
                                         * refine and dim; NULL: it is found */
};

/* A minimum. */
struct ph_arc_found {
  struct ph_arc_point point;
  size_t start;  /* that led to it */
  double weight; /* see ph_arc_fit; 0: of nothing */
};

struct ph_arc_search {
  struct ph_arc_system system; /* of the request */
  bool all;                    /* of the request */
  struct ph_arc_natural natural;
  struct ph_start *starts; /* as tried; f in our unit */
  size_t starts_n;
  struct ph_arc_found *found; /* different ones, lowest first */
  size_t found_n;
  bool stood_still;            /* a curve was found and refused: it has speed
                                * 0 where it is to have a direction, or all but
                                * that where this is missed */
  struct ph_arc_point nearest; /* if none was found: the iterate whose rows
                                * hold best */
  struct ph_arc_found saddle;  /* and the first that is stationary, or, before
                                * these, proved to be a steep minimum */
  bool has_saddle;
};

/* ph_arc_is_same: whether two values of F, of ours, are of one minimum. */
bool ph_arc_is_same(double f, double g);

/*
 * ph_arc_search_run: carries out a request.
 *
 * inout arena   of the search, and of what it works in: the caller gives both
 *               back
 * out   search  found_n is 0 when every start failed
 * ret   false when memory is exhausted
 */
bool ph_arc_search_run(const struct ph_arc_request *request,
                       struct ph_arena *arena, struct ph_arc_search *search);

/* ---- measured directions ---------------------------------------------------
 */

/*
 * ph_arc_fit: of curves with exact directions, those with the least F whose
 * directions and lengths miss the given ones by their standard deviations, root
 * mean square, or less.
 *
 * With the weight L these minimise F + L sum e_k^2, e_k of a direction
 * 2 sin(angle / 2) / sigma times the root of |r'| over what the lengths say
 * it is, of a length the difference in standard deviations; L is such that
 * the mean of e_k^2 is 1 [REI67].
 *
 * in    data    as read; the search was of the same with exact lengths
 * inout search  found, with weights L, starts, system
 * ret   false when memory is exhausted
 */
bool ph_arc_fit(const struct ph_arc_data *data, struct ph_arena *arena,
                struct ph_arc_search *search);

/* ph_arc_weigh: the compliances of a system that was fitted, for a weight. */
void ph_arc_weigh(struct ph_arc_system *system, double weight);

/* ---- the curve ----------------------------------------------------------- */

/* From the nodes of an arc-length spline to the curve of a record. */

/*
 * ph_arc_curve: the curve in the user's frame, unit and sense.
 *
 * The Euler-Rodrigues frame is upright in the first point
 * (solve/common/frame.h). Joints that are data are exactly the data.
 *
 * in   x      nodes of the system
 * out  curve  PH quintic segments; arrays in the arena
 * out  turn   closed: by how much the frame comes back turned; else 0
 * ret  PH_OK | PH_E_NO_MEMORY
 */
enum ph_status ph_arc_curve(const struct ph_arc_system *system, const double *x,
                            struct ph_arena *arena, struct ph_curve *curve,
                            double *turn, struct ph_diag *diag);

/* ph_arc_is_flat: whether the curve of nodes in space is in the plane z = 0. */
bool ph_arc_is_flat(const struct ph_arc_system *system, const double *x);

/* ---- the result ---------------------------------------------------------- */

/* What is told of a search for arc-length splines: curves, lengths, diagnostics
 * and warnings, or why there is none. */

/*
 * ph_arc_report: the result of a search that found something.
 *
 * in   left_plane  data in a plane whose curve is not
 * out  result      curve, intervals, starts, solutions if all were asked for,
 *                  diagnostics and warnings
 * ret  PH_OK | PH_E_NO_MEMORY
 */
enum ph_status ph_arc_report(const struct ph_arc_search *search,
                             bool left_plane, struct ph_arena *scratch,
                             struct ph_arena *out, struct ph_result *result,
                             struct ph_diag *diag);

/* ph_arc_report_failure: why nothing was found: the interval that is missed
 * most, with its lengths.  ret PH_E_NO_CONVERGENCE | PH_E_NO_MEMORY */
enum ph_status ph_arc_report_failure(const struct ph_arc_search *search,
                                     struct ph_arena *scratch,
                                     struct ph_diag *diag);

#endif
