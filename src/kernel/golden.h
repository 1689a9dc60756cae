/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The least value of a function of one variable between two places. */
#ifndef PH_KERNEL_GOLDEN_H
#define PH_KERNEL_GOLDEN_H

/* x within [low, high], where f is value and no more than at either end. */
struct ph_bracket {
  double low, x, high, value;
};

/*
 * ph_golden: narrows a bracket by golden section: to 0.62 of it in each step
 * but the first few.  Comparing values finds a minimum to the square root of
 * their precision, in 40 steps.  GSL's minimisers end where f is infinite, as
 * it may be here.
 */
void ph_golden(double (*f)(const void *context, double x), const void *context,
               int steps, struct ph_bracket *bracket);

#endif
