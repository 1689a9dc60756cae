/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Signs of leading principal minors (see inertia.h). */
#include "kernel/inertia.h"

#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <string.h>

/* Row i of the matrix, columns i - k to i + k, as far as there are such, and
 * after them 0. */
static void take_row(const double *a, size_t n, size_t k, size_t i,
                     double *row) {
  memset(row, 0, (3 * k + 1) * sizeof *row);
  for (size_t j = i > k ? i - k : 0; j <= i; j++) {
    row[k + j - i] = a[j * (k + 1) + (i - j)];
  }
  for (size_t j = i + 1; j < n && j <= i + k; j++) {
    row[k + j - i] = a[i * (k + 1) + (j - i)];
  }
}

/* Takes column j out of a row: u[0] and v[0] are both in that column, and u is
 * the pivot row.  Whether the minor changes its sign by an interchange. */
static bool eliminate(double *restrict u, double *restrict v, size_t width) {
  bool changes = false;
  double factor;
  if (fabs(v[0]) > fabs(u[0])) {
    changes = (v[0] < 0) == (u[0] < 0);
    for (size_t i = 0; i < width; i++) {
      double keep = u[i];
      u[i] = v[i];
      v[i] = keep;
    }
  }
  if (!(fabs(v[0]) <= 0)) { /* NaN goes on */
    factor = v[0] / u[0];
    for (size_t i = 1; i < width; i++) {
      v[i] -= factor * u[i];
    }
  }
  return changes;
}

size_t ph_inertia_negative(const double *a, size_t n, size_t k, double *work) {
  size_t stride = 3 * k + 1, width = 2 * k + 1, negative = 0;
  double *row = work + (k + 1) * stride;
  bool minor = false; /* whether the last one is negative */
  for (size_t i = 0; i < n; i++) {
    size_t first = i > k ? i - k : 0;
    bool before = minor;
    take_row(a, n, k, i, row);
    for (size_t j = first; j < i; j++) {
      minor ^= eliminate(work + j % (k + 1) * stride, row + (k + j - i), width);
    }
    if (!isfinite(row[k])) {
      return SIZE_MAX;
    }
    minor ^= row[k] < 0;
    negative += minor != before;
    memcpy(work + i % (k + 1) * stride, row + k, width * sizeof *row);
  }
  return negative;
}
