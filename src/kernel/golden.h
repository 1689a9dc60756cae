/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Least and greatest values of functions of one variable between places. */
#ifndef PH_KERNEL_GOLDEN_H
#define PH_KERNEL_GOLDEN_H

#include <stddef.h>

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

/*
 * ph_golden_greatest: the greatest value of f on [0,1]: of n + 1 equal places,
 * and, to 1e-8 of what lies between them, of the peaks between: where f is no
 * less than at the places on both sides, and more than 0.8 of the greatest that
 * was seen.
 *
 * in   seen  what was seen elsewhere, or is expected
 * ret  no less than `seen'; NaN: f is that at a place
 */
double ph_golden_greatest(double (*f)(const void *context, double x),
                          const void *context, size_t n, double seen);

#endif
