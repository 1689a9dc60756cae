/* SPDX-License-Identifier: GPL-3.0-or-later */
/* De Casteljau's recurrences (see bern.h). */
#include "kernel/bern.h"

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

void ph_bern_cut(const ph_cplx *c, size_t degree, double u, ph_cplx *left,
                 ph_cplx *right) {
  memcpy(right, c, (degree + 1) * sizeof *right);
  for (size_t n = degree; n > 0; n--) {
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
