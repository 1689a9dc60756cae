/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Newton's method for stationary points of F under the rows: the system
 *
 *   A dx + J^T dy = -grad (F + y . c),   J dx - compliance dy = -c
 *
 * with A made positive definite on the null space of J by a shift, an l1 merit
 * function, a correction for the curvature of the rows and phases that turn
 * (ph_arc_retract).
 */
#ifndef PH_SOLVE_ARCLENGTH_NEWTON_H
#define PH_SOLVE_ARCLENGTH_NEWTON_H

#include "solve/arclength/system.h"

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
  const struct ph_arena *arena; /* of all this; knows how much time there is */
  struct ph_arc_linear linear;
  double *kkt; /* factors of the KKT matrix */
  uint32_t *pivot;
  double *penalised; /* factor of the penalised Hessian */
  double *step;      /* [kkt_n] in the order of the matrix */
  double *dx;        /* [x_n] */
  double *dx2;       /* [x_n] */
  double *y;         /* [y_n] multipliers after a full step */
  double *dy;        /* [y_n] */
  double *x[2];      /* [x_n] candidates */
  double *c;         /* [y_n] rows of a candidate */
};

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
 * ph_arc_is_minimum: proves that a stationary point is a strict minimum but for
 * what leaves the equations as they are: the Hessian of the Lagrangian plus
 * rho J^T J, pinned, has a Cholesky factor for some rho, at least with a shift
 * of the size of its rounding.  False: it is a saddle.
 *
 * in   x, y  of this system, which may be another than the one that was solved
 */
bool ph_arc_is_minimum(const struct ph_arc_system *system,
                       struct ph_arc_newton *work, const double *x,
                       const double *y);

#endif
