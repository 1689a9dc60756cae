/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Band matrices: both factors are right-looking and spend their time in updates
 * of contiguous columns or rows.
 *
 * The innermost loops are unrolled, so that -O2 makes vectors of them.
 */
#include "kernel/band.h"

#include <float.h>
#include <math.h>

/* y -= c x */
static inline void subtract(double *restrict y, double c,
                            const double *restrict x, size_t n) {
  size_t i = 0;
  for (; i + 4 <= n; i += 4) {
    y[i] -= c * x[i];
    y[i + 1] -= c * x[i + 1];
    y[i + 2] -= c * x[i + 2];
    y[i + 3] -= c * x[i + 3];
  }
  for (; i < n; i++) {
    y[i] -= c * x[i];
  }
}

/* y -= c0 x0, then y -= c1 x1 */
static inline void subtract_both(double *restrict y, double c0,
                                 const double *restrict x0, double c1,
                                 const double *restrict x1, size_t n) {
  size_t i = 0;
  for (; i + 4 <= n; i += 4) {
    y[i] = y[i] - c0 * x0[i] - c1 * x1[i];
    y[i + 1] = y[i + 1] - c0 * x0[i + 1] - c1 * x1[i + 1];
    y[i + 2] = y[i + 2] - c0 * x0[i + 2] - c1 * x1[i + 2];
    y[i + 3] = y[i + 3] - c0 * x0[i + 3] - c1 * x1[i + 3];
  }
  for (; i < n; i++) {
    y[i] = y[i] - c0 * x0[i] - c1 * x1[i];
  }
}

/* The sum of x[i] y[i], beginning at the end: a solution that goes backwards
 * has waited for y[0] only. */
static inline double dot(const double *x, const double *y, size_t n) {
  double s[4] = {0};
  for (; n % 4 > 0; n--) {
    s[n % 4] += x[n - 1] * y[n - 1];
  }
  for (; n > 0; n -= 4) {
    s[0] += x[n - 4] * y[n - 4];
    s[1] += x[n - 3] * y[n - 3];
    s[2] += x[n - 2] * y[n - 2];
    s[3] += x[n - 1] * y[n - 1];
  }
  return (s[0] + s[2]) + (s[1] + s[3]);
}

static inline size_t least(size_t a, size_t b) {
  return a < b ? a : b;
}

/* Column l of L, with `rows' elements below the diagonal, from what is left of
 * A there. */
static bool root(double *l, size_t rows) {
  if (!(l[0] > 0 && l[0] <= DBL_MAX)) {
    return false;
  }
  l[0] = sqrt(l[0]);
  for (size_t i = 1; i <= rows; i++) {
    l[i] /= l[0];
  }
  return true;
}

/* Two columns at a time, as the others are then read and written once for
 * both; rounded as one at a time. */
bool ph_sym_reduce(double *a, size_t n, size_t k, size_t m) {
  const size_t next = k + 1;
  for (size_t j = 0; j < m; j += 2) {
    double *l = a + j * next, *l1 = l + next, *to = l1;
    const size_t rows = least(k, n - 1 - j);
    size_t rows1;
    if (!root(l, rows)) {
      return false;
    }
    if (j + 1 == m) { /* one column, of an odd number */
      for (size_t i = 1; i <= rows; i++, to += next) {
        subtract(to, l[i], l + i, rows + 1 - i);
      }
      break;
    }
    rows1 = least(k, n - 2 - j);
    if (rows > 0) {
      subtract(l1, l[1], l + 1, rows);
    }
    if (!root(l1, rows1)) {
      return false;
    }
    /* row j + i of both; the last row of l1 may be one further down */
    for (size_t i = 2; i <= rows; i++) {
      to += next;
      subtract_both(to, l[i], l + i, l1[i - 1], l1 + i - 1, rows + 1 - i);
      if (rows1 == rows) {
        to[rows + 1 - i] -= l1[i - 1] * l1[rows];
      }
    }
    if (rows1 == rows && rows > 0) {
      to[next] -= l1[rows] * l1[rows];
    }
  }
  return true;
}

bool ph_sym_factor(double *a, size_t n, size_t k) {
  return ph_sym_reduce(a, n, k, n);
}

/* Multiplications by inverses of the diagonal: the divisions wait for nothing,
 * and L, a square root, has an inverse. */
void ph_sym_solve(const double *a, size_t n, size_t k, double *x) {
  for (size_t j = 0; j < n; j++) {
    const double *l = a + j * (k + 1);
    x[j] *= 1 / l[0];
    subtract(x + j + 1, x[j], l + 1, least(k, n - 1 - j));
  }
  for (size_t j = n; j-- > 0;) {
    const double *l = a + j * (k + 1);
    x[j] = (x[j] - dot(l + 1, x + j + 1, least(k, n - 1 - j))) * (1 / l[0]);
  }
}

/* The row of the largest element of a column, of `rows' below the diagonal,
 * with `down' elements from one to the next; SIZE_MAX if one is not finite or
 * all are 0. */
static size_t pivot_of(const double *at, size_t rows, size_t down) {
  double largest = 0;
  size_t found = SIZE_MAX;
  bool finite = true;
  for (size_t i = 0; i <= rows; i++) {
    const double size = fabs(at[i * down]);
    finite &= size <= DBL_MAX;
    if (size > largest) {
      largest = size;
      found = i;
    }
  }
  return finite ? found : SIZE_MAX;
}

static inline void exchange(double *restrict x, double *restrict y, size_t n) {
  for (size_t i = 0; i < n; i++) {
    const double t = x[i];
    x[i] = y[i];
    y[i] = t;
  }
}

/* n without the zeros at the end of x[n]; SIZE_MAX if an element is not
 * finite. */
static size_t trim(const double *x, size_t n) {
  bool finite = true;
  while (n > 0 && fabs(x[n - 1]) <= 0) {
    n--;
  }
  for (size_t i = 0; i < n; i++) {
    finite &= fabs(x[i]) <= DBL_MAX;
  }
  return finite ? n : SIZE_MAX;
}

/*
 * Row j of the factors has U from the diagonal on, and to the left of it
 * column j of L, from below the diagonal down: there the row is 0 by then, and
 * both solutions go along rows.  L is not permuted by later exchanges.
 */
bool ph_band_reduce(double *a, uint32_t *pivot, size_t n, size_t k, size_t from,
                    size_t before, size_t *known) {
  const size_t down = 3 * k; /* to the element below */
  size_t end = *known;
  for (size_t j = from; j < before; j++) {
    double *at = a + j * (down + 1) + k, *l = at - k;
    const size_t rows = least(k, n - 1 - j), p = pivot_of(at, rows, down);
    size_t width;
    if (p == SIZE_MAX) {
      return false;
    }
    pivot[j] = (uint32_t)(j + p);
    end = least(end > j + p + k + 1 ? end : j + p + k + 1, n);
    if (p > 0) {
      exchange(at, at + p * down, end - j);
    }
    width = trim(at + 1, end - j - 1);
    if (width == SIZE_MAX) {
      return false;
    }
    for (size_t i = 0; i < rows; i++) {
      double *to = at + (i + 1) * down;
      l[i] = to[0] / at[0];
      if (fabs(l[i]) > 0) {
        subtract(to + 1, l[i], at + 1, width);
      }
    }
  }
  *known = end;
  return true;
}

bool ph_band_factor(double *a, uint32_t *pivot, size_t n, size_t k) {
  size_t end = 0;
  return ph_band_reduce(a, pivot, n, k, 0, n, &end);
}

void ph_band_solve(const double *a, const uint32_t *pivot, size_t n, size_t k,
                   double *x) {
  for (size_t j = 0; j < n; j++) {
    const double *l = a + j * (3 * k + 1), t = x[pivot[j]];
    x[pivot[j]] = x[j];
    x[j] = t;
    subtract(x + j + 1, t, l, least(k, n - 1 - j));
  }
  for (size_t j = n; j-- > 0;) {
    const double *u = a + j * (3 * k + 1) + k;
    x[j] = (x[j] - dot(u + 1, x + j + 1, least(2 * k, n - 1 - j))) / u[0];
  }
}
