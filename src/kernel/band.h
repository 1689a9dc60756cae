/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Band matrices: Cholesky factors of symmetric ones, LU factors with row
 * pivoting of general ones, both in the memory of the matrix.
 *
 * A matrix of n rows has half bandwidth k when it vanishes at |i - j| > k.
 * Factors cost O(n k^2), solutions O(n k); nothing is allocated.
 */
#ifndef PH_KERNEL_BAND_H
#define PH_KERNEL_BAND_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* A symmetric matrix: column j of its lower triangle, rows j to j + k, is
 * a[j][k + 1]; what lies below the last row is 0. */
static inline size_t ph_sym_size(size_t n, size_t k) {
  return n * (k + 1);
}

/* ph_sym_at: the element (i, j), j <= i <= j + k. */
static inline double *ph_sym_at(double *a, size_t k, size_t i, size_t j) {
  return a + j * (k + 1) + (i - j);
}

/*
 * ph_sym_factor: A = L L^T.
 *
 * inout a  A; L
 * ret   whether A is positive definite as rounded; if not, a is undefined
 */
bool ph_sym_factor(double *a, size_t n, size_t k);

/*
 * ph_sym_reduce: the same of the first m columns.
 *
 * inout a  A; the first m columns of L, and what is left of A without them
 * ret   whether the first m rows and columns are positive definite
 */
bool ph_sym_reduce(double *a, size_t n, size_t k, size_t m);

/* ph_sym_solve: x = A^-1 x, after ph_sym_factor. */
void ph_sym_solve(const double *a, size_t n, size_t k, double *x);

/* A general matrix: row i, columns i - k to i + 2 k, is a[i][3 k + 1]; the k
 * last columns are for the pivoting, 0 before. */
static inline size_t ph_band_size(size_t n, size_t k) {
  return n * (3 * k + 1);
}

/* ph_band_at: the element (i, j), |i - j| <= k. */
static inline double *ph_band_at(double *a, size_t k, size_t i, size_t j) {
  return a + i * (3 * k + 1) + (k + j - i);
}

/*
 * ph_band_factor: P A = L U, row pivoting.
 *
 * inout a      A; L and U
 * out   pivot  [n] which row was exchanged with each
 * ret   false when a pivot is 0 or not finite; a is then undefined
 */
bool ph_band_factor(double *a, uint32_t *pivot, size_t n, size_t k);

/*
 * ph_band_reduce: the same of columns from one on to before another, where
 * those before it have been.  Rows k below these are needed only.
 *
 * inout end  0 before the first; no row so far has elements from it on
 */
bool ph_band_reduce(double *a, uint32_t *pivot, size_t n, size_t k, size_t from,
                    size_t before, size_t *end);

/* ph_band_solve: x = A^-1 x, after ph_band_factor. */
void ph_band_solve(const double *a, const uint32_t *pivot, size_t n, size_t k,
                   double *x);

#endif
