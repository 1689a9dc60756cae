/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * How many eigenvalues of a symmetric band matrix are negative: as many as
 * there are changes of sign in the sequence 1, D_1, ..., D_n of its leading
 * principal minors.  They come out of an elimination that interchanges rows as
 * they are taken in, for which the matrix may be indefinite [MAR67].
 */
#ifndef PH_KERNEL_INERTIA_H
#define PH_KERNEL_INERTIA_H

#include <stddef.h>

/* ph_inertia_size: how many doubles of work a half bandwidth k needs. */
static inline size_t ph_inertia_size(size_t k) {
  return (k + 2) * (3 * k + 1);
}

/*
 * ph_inertia_negative: the number of negative eigenvalues.
 *
 * in   a     symmetric band matrix of n rows (kernel/band.h), unchanged
 * in   work  [ph_inertia_size(k)]
 * ret  rounding counts as a change of the matrix by some units in the last
 *      place of its largest element; SIZE_MAX when something is not finite
 */
size_t ph_inertia_negative(const double *a, size_t n, size_t k, double *work);

#endif
