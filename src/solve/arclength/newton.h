/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Newton's method for the method `arclength` (see arclength.h). */
#ifndef PH_SOLVE_ARCLENGTH_NEWTON_H
#define PH_SOLVE_ARCLENGTH_NEWTON_H

#include "base/mem.h"
#include "solve/arclength/system.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* ---- blocks of unknowns -------------------------------------------------- */

/*
 * Stretches of the unknowns, each with a shift of its own: with one for all,
 * the one place of a long curve where steps are short would shorten all others.
 *
 * A block has as large a shift as makes its matrix, with that of a neighbour,
 * positive definite on the null space of the rows, and as keeps the bend of its
 * rows small: |correction| / |step| of the block, where a second step corrects
 * for the curvature of the rows.  Shifts weigh no turn of phases: where all on
 * one side of a place wants to turn about it, the last blocks are held.
 */
struct ph_arc_blocks {
  size_t n;      /* 0: there are too few intervals for blocks */
  size_t width;  /* places in the order of matrices; the last has more, and the
                  * first where chi is */
  double *shift; /* [n] */
  double *hold;  /* [n] the same of the unit matrix */
  double *bend;  /* [n] after a step */
  double *more[2]; /* [n] what shift and hold want to be convex */
  double *stiff;   /* [n] |gradient| / |step|: a shift that would halve it */
  double *each;    /* [2][nodes] the shift and hold of each */
  double most;     /* no shift is larger, but to be convex */
  double *pair;    /* the matrix of two blocks */
  uint32_t *node;  /* [nodes] by their places */
};

/* ph_arc_blocks_alloc: those of a system; false: no memory. */
bool ph_arc_blocks_alloc(const struct ph_arc_system *system,
                         struct ph_arena *arena, struct ph_arc_blocks *blocks);

/* ph_arc_blocks_begin: no block has a shift. */
void ph_arc_blocks_begin(struct ph_arc_blocks *blocks);

/* ph_arc_blocks_weights: sets the shifts and holds of nodes if there are
 * blocks; they are overwritten by all that follows. */
void ph_arc_blocks_weights(const struct ph_arc_system *system,
                           struct ph_arc_blocks *blocks,
                           struct ph_arc_weights *weights);

/* ph_arc_blocks_change: by how much node j changes: |d|^2, and what it changes
 * of the phase from the node before it.  inout phase  of that node, then of j
 */
double ph_arc_blocks_change(const struct ph_arc_system *system, const double *x,
                            size_t j, const double *change, double *phase);

/* ph_arc_blocks_raised: whether the block of node j has a shift or hold. */
bool ph_arc_blocks_raised(const struct ph_arc_system *system,
                          const struct ph_arc_blocks *blocks, size_t j);

/* ph_arc_blocks_lower: it has none. */
void ph_arc_blocks_lower(const struct ph_arc_system *system,
                         struct ph_arc_blocks *blocks, size_t j);

enum ph_arc_shape { PH_ARC_CONVEX, PH_ARC_BENT, PH_ARC_UNKNOWN };

/*
 * ph_arc_blocks_convex: what the shifts of blocks want to be convex.
 *
 * The blocks are eliminated one after the other.  Where the next two are not
 * positive definite both are raised.
 *
 * inout matrix  of ph_arc_penalised, with the shifts as they are; undefined
 * ret   convex; or with what ph_arc_blocks_apply adds; or it cannot be said
 */
enum ph_arc_shape ph_arc_blocks_convex(const struct ph_arc_system *system,
                                       const double *x, double *matrix,
                                       struct ph_arc_blocks *blocks);

/* ph_arc_blocks_apply: raises the shifts by what ph_arc_blocks_convex found. */
void ph_arc_blocks_apply(struct ph_arc_blocks *blocks);

/* ph_arc_blocks_look: bends and stiffness of a step dx of this length from x,
 * and of dx2, the same corrected, as shifts weigh them.  gradient[x_n],
 * dx[x_n], dx2[x_n] */
void ph_arc_blocks_look(const struct ph_arc_system *system, const double *x,
                        const double *gradient, const double *dx, double step,
                        const double *dx2, struct ph_arc_blocks *blocks);

/* ph_arc_blocks_raise: raises the shifts of blocks that bend, after a step that
 * was refused.  ret whether one was raised */
bool ph_arc_blocks_raise(struct ph_arc_blocks *blocks);

/* ph_arc_blocks_settle: all shifts for the next step, after one that was taken.
 */
void ph_arc_blocks_settle(struct ph_arc_blocks *blocks);

/* ---- Newton's iteration -------------------------------------------------- */

/*
 * Newton's method for stationary points of F under the rows: the system
 *
 *   A dx + J^T dy = -grad (F + y . c),   J dx - compliance dy = -c
 *
 * with A made positive definite on the null space of J by a shift, of many
 * intervals by shifts of blocks, an l1 merit function, a correction for the
 * curvature of the rows and phases that turn (ph_arc_retract,
 * ph_arc_retract_rows).
 */

/* An iterate, and what is known of it. */
struct ph_arc_point {
  double *x;         /* [x_n] */
  double *y;         /* [y_n] multipliers */
  double f;          /* F at x, in our unit */
  double residual;   /* largest residual of a row */
  double kkt;        /* largest |gradient of the Lagrangian| / (1 + |y|) */
  size_t iterations; /* so far */
  bool converged;
  bool minimiser; /* and proved to be one, see ph_arc_is_minimum */
};

struct ph_arc_newton {
  struct ph_arena *arena; /* of all this; knows how much time there is */
  struct ph_arc_linear linear;
  double *gradient; /* [x_n] of the Lagrangian, but for what is held */
  double *kkt;      /* factors of the KKT matrix */
  uint32_t *pivot;
  double *penalised; /* factor of the penalised Hessian */
  double *minors;    /* of the KKT matrix, see kernel/inertia.h */
  double *step;      /* [kkt_n] in the order of the matrix */
  double *dx;        /* [x_n] */
  double *dx2;       /* [x_n] */
  double *y;         /* [y_n] multipliers after a full step */
  double *dy;        /* [y_n] */
  double *x[2];      /* [x_n] candidates */
  double *c;         /* [y_n] rows of a candidate */
  double *nu;        /* [y_n] weights of |c| in the merit function */
  struct ph_arc_blocks blocks;
  size_t times;  /* that places were solved, of this start */
  bool starved;  /* there was no memory for places */
  size_t convex; /* the weight that did last: tried first */
};

/* Weight of what fixes the common phase. */
#define PH_ARC_PIN 1e3

/* ph_arc_newton_alloc: the memory that a system needs; false: there is none. */
bool ph_arc_newton_alloc(const struct ph_arc_system *system,
                         struct ph_arena *arena, struct ph_arc_newton *work);

/* ph_arc_point_alloc: an iterate of a system, y = 0; false: no memory. */
bool ph_arc_point_alloc(const struct ph_arc_system *system,
                        struct ph_arena *arena, struct ph_arc_point *point);

/* ph_arc_point_copy: to = from, of one system. */
void ph_arc_point_copy(const struct ph_arc_system *system,
                       const struct ph_arc_point *from,
                       struct ph_arc_point *to);

/*
 * ph_arc_newton_solve: iterates until the residuals are below 1e-12 and the
 * Newton decrement is below 1e-9 F or is rounding.
 *
 * inout point  x and y; all the rest is set; iterations are added
 * ret   point->converged
 */
bool ph_arc_newton_solve(const struct ph_arc_system *system,
                         struct ph_arc_newton *work, size_t limit,
                         struct ph_arc_point *point);

/*
 * ph_arc_newton_plain: the same by whole steps alone, to whatever is stationary
 * near p; where the search would creep they may lead there.
 */
bool ph_arc_newton_plain(const struct ph_arc_system *system,
                         struct ph_arc_newton *work, size_t limit,
                         struct ph_arc_point *p);

/*
 * ph_arc_is_minimum: proves that a stationary point is a strict minimum but for
 * what leaves the equations as they are: the KKT matrix, with a Hessian that is
 * pinned and shifted by the size of its rounding, has as many negative
 * eigenvalues as rows.  False: it is a saddle.
 *
 * in   x, y  of this system, which may be another than the one that was solved
 */
bool ph_arc_is_minimum(const struct ph_arc_system *system,
                       struct ph_arc_newton *work, const double *x,
                       const double *y);

/*
 * Places: stretches of a curve of many intervals where a step was not small.
 * Each is solved alone, with all beside it held (ph_arc_part_of): it takes as
 * many steps as it needs, which cost no more where the curve is longer.
 */

/*
 * ph_arc_places: solves them, after the first steps and not forever.
 *
 * in    work   dx of the last step, blocks, times, arena
 * in    step   the length of that step
 * in    steps  made so far, of the whole
 * inout point  x, y, iterations: those of a place count as its part of the
 *              curve
 * ret   false when memory is exhausted
 */
bool ph_arc_places(const struct ph_arc_system *system,
                   struct ph_arc_newton *work, double step, size_t steps,
                   struct ph_arc_point *point);

#endif
