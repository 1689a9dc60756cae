/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The function that a planar spline is the least of: of the file min.c. */
#ifndef PH_SOLVE_PLANAR_MIN_H
#define PH_SOLVE_PLANAR_MIN_H

#include "curve/fair/energy.h"
#include "kernel/box_hessian.h"
#include "solve/planar/planar.h"

struct ph_planar_candidate {
  double *spacing;  /* [n] */
  ph_cplx *b;       /* [unknowns] */
  double *h;        /* [n] as in the data */
  ph_cplx twist;    /* closed */
  double *part;     /* [n] of E or MV that the segments have */
  double *length;   /* [n] of the segments */
  double energy[3]; /* E, MV, L at unit scale */
  double value;     /* of the functional, at unit scale; or NaN */
};

struct ph_planar_work {
  struct ph_planar_data *data;
  enum ph_planar_functional functional;
  bool scale;
  size_t variables; /* n, or 1 where one factor varies */
  size_t unknowns;
  const double *shape; /* [n] spacings = shape, or 1, times exp(variable) */
  struct ph_arena *scratch;
  struct ph_diag *diag;
  struct ph_energy_sum sum;
  struct ph_planar_gradient gradient;
  ph_cplx *guess;
  double *pivot, *beside; /* [n] of the matrix (1) */
  struct ph_box_hessian hessian;
  struct ph_planar_candidate now, trial, best;
  struct ph_planar_candidate chosen;      /* for the data as given; or NaN */
  const struct ph_planar_candidate *last; /* what the last value was of */
  double weight[3];                       /* of E, MV, L where `weighted` */
  bool weighted;
  bool warm; /* `now` holds a solution */
  size_t evaluations;
};

/* ph_planar_min_in_user_unit: a value from unit scale to the unit of the data;
 * not finite out of range. */
double ph_planar_min_in_user_unit(const struct ph_planar_work *w, double value);

/* ph_planar_min_solve_trial: the solution for the data as they are, and its
 * energies, into the trial.  No solution: a value that is NaN, and PH_OK. */
enum ph_status ph_planar_min_solve_trial(struct ph_planar_work *w);

/* ph_planar_min_solve_default: likewise what ph_planar_choose takes, of data
 * that turn sharply. */
enum ph_status ph_planar_min_solve_default(struct ph_planar_work *w);

void ph_planar_min_copy(struct ph_planar_candidate *to,
                        const struct ph_planar_candidate *from,
                        const struct ph_planar_work *w);

/* ph_planar_min_weigh: the weights of the derivatives of the logarithm. */
void ph_planar_min_weigh(struct ph_planar_work *w,
                         const struct ph_planar_candidate *at);

/* What a search calls (kernel/box.h), with a struct ph_planar_work.  The
 * gradient of `weighted' work is that of the sum with the weights it has. */
enum ph_status ph_planar_min_value(void *context, const double *x,
                                   double *result);
void ph_planar_min_gradient(void *context, double *result);
void ph_planar_min_accept(void *context);
void ph_planar_min_condition(void *context, const bool *fixed, double *v);

/*
 * ph_planar_min_cross: the best search's curve and that of `now', of each
 * stretch the fairer one, becomes `now' if it is fairer than both.
 *
 * in    best[variables]     of the best
 * inout x[variables]        of `now'
 * out   crossed[variables]  workspace
 * ret   as ph_planar_min_value
 */
enum ph_status ph_planar_min_cross(struct ph_planar_work *w,
                                   const struct ph_box *box, const double *best,
                                   double *x, double *crossed);

#endif
