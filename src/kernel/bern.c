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
