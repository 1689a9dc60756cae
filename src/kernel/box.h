/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Local minimisation of a smooth function of n variables in a box.
 *
 * Projected limited-memory BFGS: variables at a bound that the gradient pushes
 * against are left out of the quasi-Newton step, which is then projected and
 * halved until the function decreases enough.  The first estimate of the second
 * derivatives may be given.  Deterministic.
 */
#ifndef PH_KERNEL_BOX_H
#define PH_KERNEL_BOX_H

#include "base/mem.h"
#include "base/status.h"

#include <stdbool.h>
#include <stddef.h>

struct ph_box {
  size_t n;
  const double *lower, *upper; /* [n], lower <= upper */
  double decrease;             /* steps that gain no more than this are few */
  size_t steps_max;
  size_t evaluations_max; /* no step begins after so many; 0: any does */
  void *context;
  /* value: of the function at x; not finite where there is none.  Another
   * status than PH_OK ends the search. */
  enum ph_status (*value)(void *context, const double *x, double *value);
  /* gradient: at the x of the last value. */
  void (*gradient)(void *context, double *gradient);
  /* accept: the x of the last value is the best one so far. */
  void (*accept)(void *context);
  /* condition: v <- an estimate of the inverse of the second derivatives at the
   * best x times v, symmetric and positive definite, and 0 in the variables
   * that are fixed; NULL where all variables are alike. */
  void (*condition)(void *context, const bool *fixed, double *v);
  bool to_scale; /* the estimate has the scale of the function, too */
};

struct ph_box_report {
  double value; /* at the best x; not finite if there was none at the start */
  size_t evaluations;
  double gain; /* of the last step */
  bool converged;
};

/*
 * ph_box_minimize: a local minimiser.
 *
 * Converged means: from there, neither quasi-Newton nor steepest descent
 * decreased the function by more than box->decrease a step.
 *
 * inout x[n]  start, in the box; the best found
 * ret   PH_OK | PH_E_NO_MEMORY | what `value` returned
 */
enum ph_status ph_box_minimize(const struct ph_box *box,
                               struct ph_arena *scratch, double *x,
                               struct ph_box_report *report);

#endif
