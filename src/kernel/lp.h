/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Small dense linear programs in a box:
 *
 *   minimise c . x   subject to   a[i] . x >= b[i],   lower <= x <= upper
 *
 * for some sixteen unknowns and some hundreds of rows.
 *
 * Method: the dual simplex method on the n unknowns.  It starts at the corner
 * of the box that minimises c . x.  At every step x is the minimum subject to
 * n constraints only: bounds, which fix their unknowns, and q rows, which
 * determine the q free ones.  The constraint that x violates most is added and
 * one of the n leaves such that all multipliers stay >= 0; c . x rises until
 * nothing is violated.  A step costs m n for finding that constraint and q^3/3
 * for fresh LU factors, so that errors do not grow with the number of steps.
 * After many steps, the rule of [BLA77], which cannot cycle, takes over.
 *
 * A constraint counts as violated above 1e-12 of the numbers in it; the caller
 * scales its rows to about unit norm.
 */
#ifndef PH_KERNEL_LP_H
#define PH_KERNEL_LP_H

#include "base/mem.h"

#include <stdbool.h>
#include <stddef.h>

/* A linear program; lower <= upper, both finite. */
struct ph_lp {
  size_t n, m;
  const double *c;     /* [n] */
  const double *lower; /* [n] */
  const double *upper; /* [n] */
  const double *a;     /* [m][n] */
  const double *b;     /* [m] */
};

enum ph_lp_outcome {
  PH_LP_OPTIMAL,
  PH_LP_INFEASIBLE, /* proved: some of the rows exclude the box */
  PH_LP_STALLED     /* too many steps, or numbers that are not finite */
};

/* Which bound an unknown is at. */
enum ph_lp_at { PH_LP_LOWER, PH_LP_UPPER, PH_LP_FREE };

/* Workspace, and what is known of the solution beside x. */
struct ph_lp_work {
  size_t steps;      /* out */
  size_t q;          /* out: active rows, as many as there are free unknowns */
  size_t *row;       /* out: [q] which rows */
  enum ph_lp_at *at; /* out: [n] */
  double *price;   /* out: [q + n] multipliers of these rows, and of the bounds
                      (of -x <= -upper above; 0 of free unknowns) */
  size_t violated; /* out: a row that x violates where there is no solution;
                      m if that is a bound, or none */
  double *share;   /* [q + n] what they have in the constraint to be added */
  double *normal;  /* [n] of which this is the normal */
  size_t *free;    /* [q] the free unknowns */
  size_t *order;   /* [q] rows in the order of the pivots */
  double *lu;      /* [q][q] */
  double *scratch; /* [q] */
  bool *active;    /* [m] */
};

/*
 * ph_lp_alloc: workspace for programs of up to n unknowns and m rows.
 *
 * ret  false when memory is exhausted
 */
bool ph_lp_alloc(struct ph_lp_work *w, struct ph_arena *arena, size_t n,
                 size_t m);

/*
 * ph_lp_solve
 *
 * out  x[n]  the minimum; where there is none, the point at which that showed:
 *            the minimum subject to some of the constraints, and often not far
 *            from satisfying the others
 */
enum ph_lp_outcome ph_lp_solve(const struct ph_lp *lp, struct ph_lp_work *w,
                               double *x);

#endif
