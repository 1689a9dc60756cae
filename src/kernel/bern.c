/* SPDX-License-Identifier: GPL-3.0-or-later */
/* De Casteljau's recurrences (see bern.h). */
#include "kernel/bern.h"

#include "base/inline.h"

#include <stdbool.h>
#include <string.h>

void ph_bern_basis(size_t degree, double u, double *basis) {
  basis[0] = 1;
  for (size_t n = 1; n <= degree; n++) {
    basis[n] = u * basis[n - 1];
    for (size_t k = n; k-- > 1;) {
      basis[k] = (1 - u) * basis[k] + u * basis[k - 1];
    }
    basis[0] *= 1 - u;
  }
}

/* binomial(n, k), exact up to n = 56. */
static double binomial(size_t n, size_t k) {
  double b = 1;
  for (size_t i = 1; i <= k; i++) {
    b = b * (double)(n - k + i) / (double)i;
  }
  return b;
}

void ph_bern_taylor(size_t degree, double u, size_t order, double *rows) {
  for (size_t j = 0; j <= order; j++) {
    double *row = rows + j * (degree + 1);
    const double factor = binomial(degree, j);
    ph_bern_basis(degree - j, u, row);
    for (size_t n = degree - j; n < degree; n++) { /* a difference each */
      row[n + 1] = row[n];
      for (size_t k = n; k > 0; k--) {
        row[k] = row[k - 1] - row[k];
      }
      row[0] = -row[0];
    }
    for (size_t k = 0; k <= degree; k++) {
      row[k] *= factor;
    }
  }
}

void ph_bern_contact(size_t degree, const double *a, size_t n, double *c,
                     ptrdiff_t stride) {
  for (size_t j = 0; j < n; j++, c += stride) {
    *c = 0;
    for (size_t i = 0; i <= j; i++) {
      *c += binomial(j, i) / binomial(degree, i) * a[i];
    }
  }
}

double ph_bern_elevate(size_t degree, size_t from, size_t higher, size_t to) {
  return to < from || to - from > higher - degree
             ? 0
             : binomial(degree, from) * binomial(higher - degree, to - from) /
                   binomial(higher, to);
}

/* The two parts of a complex number, at once where the compiler can. */
#if defined(__GNUC__)
typedef double both __attribute__((vector_size(2 * sizeof(double))));

PH_INLINE both between(both a, both b, double u) {
  return (1 - u) * a + u * b;
}

PH_INLINE both twice(both a, both b) {
  return a + b;
}

PH_INLINE both scale(double factor, both a) {
  return factor * a;
}
#else
typedef ph_cplx both;
#define between ph_cplx_between
#define twice ph_cplx_add
#define scale ph_cplx_scale
#endif

PH_INLINE both load(const ph_cplx *c) {
  both x;
  memcpy(&x, c, sizeof x);
  return x;
}

/* Steps that are taken at once: what is between them stays in registers. */
enum { AT_ONCE = 4 };

/* a and b at u; twice that in the middle, where powers of two wait. */
PH_INLINE both step_of(bool half, both a, both b, double u) {
  return half ? twice(a, b) : between(a, b, u);
}

/* c[0..n] to c[0..n-4] from the last values before each step, x[3] to x[0]. */
PH_INLINE void go_on(bool half, ph_cplx *c, size_t n, double u, const both *x) {
  both x0 = x[3], x1 = x[2], x2 = x[1], x3 = x[0];
  if (half) {
    x1 = scale(2, x1);
    x2 = scale(4, x2);
    x3 = scale(8, x3);
  }
  for (size_t k = AT_ONCE; k <= n; k++) {
    both y0 = load(c + k), y1 = step_of(half, x0, y0, u);
    both y2 = step_of(half, x1, y1, u), y3 = step_of(half, x2, y2, u);
    both y4 = step_of(half, x3, y3, u);
    y4 = half ? scale(0x1p-4, y4) : y4;
    memcpy(c + k - AT_ONCE, &y4, sizeof *c);
    x0 = y0;
    x1 = y1;
    x2 = y2;
    x3 = y3;
  }
}

/* Four steps of de Casteljau's algorithm, c[0..n] to c[0..n-4], n > 4.
 * out  first[4]  c[0] before each of them */
static void four_steps(ph_cplx *c, size_t n, double u, ph_cplx *first) {
  both x[AT_ONCE];
  for (size_t k = 0; k < AT_ONCE; k++) {
    x[k] = load(c + k);
  }
  for (size_t step = 0; step < AT_ONCE; step++) {
    memcpy(first + step, &x[0], sizeof *first);
    for (size_t k = 0; k + 1 + step < AT_ONCE; k++) {
      x[k] = between(x[k], x[k + 1], u);
    }
  }
  if (u < 0.5 || u > 0.5) {
    go_on(false, c, n, u, x);
  } else {
    go_on(true, c, n, u, x);
  }
}

void ph_bern_cut(const ph_cplx *c, size_t degree, double u, ph_cplx *left,
                 ph_cplx *right) {
  size_t n = degree;
  memcpy(right, c, (degree + 1) * sizeof *right);
  for (; n > 2 * AT_ONCE; n -= AT_ONCE) {
    ph_cplx tail[AT_ONCE];
    memcpy(tail, right + n - AT_ONCE + 1, sizeof tail);
    four_steps(right, n, u, left + degree - n);
    /* the last values before each step are those of the right part */
    for (size_t step = 0; step < AT_ONCE; step++) {
      ph_cplx last = tail[AT_ONCE - 1];
      for (size_t k = AT_ONCE - 1; k > step; k--) {
        tail[k] = ph_cplx_between(tail[k - 1], tail[k], u);
      }
      right[n - step] = last;
    }
  }
  for (; n > 0; n--) {
    left[degree - n] = right[0];
    for (size_t k = 0; k < n; k++) {
      right[k] = ph_cplx_between(right[k], right[k + 1], u);
    }
  }
  left[degree] = right[0];
}

void ph_bern_lift(const ph_cplx *c, size_t from, size_t to, ph_cplx *out) {
  size_t more = to - from;
  for (size_t k = 0; k <= to; k++) {
    size_t j = k > more ? k - more : 0, last = k < from ? k : from;
    double weight = 1, all = 1;
    ph_cplx sum = c[j];
    for (; j < last; j++) {
      weight *= (double)((from - j) * (k - j)) /
                (double)((j + 1) * (more + j + 1 - k));
      all += weight;
      sum = ph_cplx_add(sum, ph_cplx_scale(weight, c[j + 1]));
    }
    out[k] = ph_cplx_scale(1 / all, sum);
  }
}
