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

void ph_bern_raise(ph_cplx *c, size_t degree) {
  double n = (double)degree + 1;
  c[degree + 1] = c[degree];
  for (size_t k = degree; k > 0; k--) {
    c[k] = ph_cplx_between(c[k], c[k - 1], (double)k / n);
  }
}
