/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Second derivatives of a function of many variables that act on their
 * neighbours only, by differences of its gradient: they condition a search in a
 * box (box.h).
 *
 * Variables are changed together that are farther apart than 2 k, so that 2 k +
 * 3 gradients are enough, or up to twice as many where there are few variables.
 * What is farther than k from the diagonal is not seen, but their sum in
 * each row is: the diagonal is such that a change of all variables by the same
 * amount changes the gradient as it does.  The matrix of a function of the
 * proportions of its variables stays positive definite by that, which
 * without it has eigenvalues below 0 as large as what is left out.
 *
 * Where it is not positive definite, or not by more than the differences are
 * off, as a function of proportions is along a change of all its variables, a
 * multiple of its diagonal and of the sum of |a[i][j]| (x[i] - x[j])^2 is
 * added, the fewest that are enough of powers of 4.
 */
#ifndef PH_KERNEL_BOX_HESSIAN_H
#define PH_KERNEL_BOX_HESSIAN_H

#include "kernel/box.h"

struct ph_box_hessian {
  size_t n, k;
  double *a, *factor;            /* as in band.h */
  double *x, *gradient, *change; /* [n] */
  bool *fixed;                   /* [n] what `factor' leaves out */
  bool found;    /* it had a value, and a gradient, wherever it was asked for */
  bool tried;    /* to factor it without the variables that are fixed */
  bool factored; /* and that could be done */
};

/* ph_box_hessian_alloc: room for n variables and half bandwidth k.
 * ret PH_OK | PH_E_NO_MEMORY */
enum ph_status ph_box_hessian_alloc(struct ph_box_hessian *h,
                                    struct ph_arena *arena, size_t n, size_t k);

/*
 * ph_box_hessian_find: at x, in the box; values are asked for within 1e-5 of
 * it, also outside the box.  box->gradient must not ask for box->accept before.
 *
 * out  h->found  whether ph_box_hessian_solve may be called
 * ret  PH_OK | what box->value returned
 */
enum ph_status ph_box_hessian_find(struct ph_box_hessian *h,
                                   const struct ph_box *box, const double *x);

/* ph_box_hessian_solve: v <- the inverse times v, as box->condition does. */
void ph_box_hessian_solve(struct ph_box_hessian *h, const bool *fixed,
                          double *v);

#endif
