/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Nodes, and the quadratic forms S_0, ..., S_3 of one: its squared length and
 * the components of its image H (see arclength_system.h). */
#ifndef PH_SOLVE_ARCLENGTH_FORM_H
#define PH_SOLVE_ARCLENGTH_FORM_H

#include "kernel/vec3.h"

#include <math.h>
#include <stddef.h>

/* ph_arc_form: out = S_k v, of dim components. */
static inline void ph_arc_form(size_t dim, int k, const double *v,
                               double *out) {
  if (dim == 4) {
    double v0 = v[0], v1 = v[1], v2 = v[2], v3 = v[3];
    out[0] = k < 2 ? v0 : k == 2 ? v2 : -v3;
    out[1] = k < 2 ? v1 : k == 2 ? v3 : v2;
    out[2] = k == 0 ? v2 : k == 1 ? -v2 : k == 2 ? v0 : v1;
    out[3] = k == 0 ? v3 : k == 1 ? -v3 : k == 2 ? v1 : -v0;
  } else if (dim == 2) {
    double v0 = v[0], v1 = v[1];
    out[0] = k < 2 ? v0 : v1;
    out[1] = k == 0 ? v1 : k == 1 ? -v1 : v0;
  } else {
    out[0] = v[0];
  }
}

/* ph_arc_dot: of two vectors. */
static inline double ph_arc_dot(size_t dim, const double *u, const double *v) {
  double sum = 0;
  for (size_t i = 0; i < dim; i++) {
    sum += u[i] * v[i];
  }
  return sum;
}

/* ph_arc_largest: the largest |v[i]|; NaN if one is. */
static inline double ph_arc_largest(size_t n, const double *v) {
  double most = 0;
  for (size_t i = 0; i < n && !isnan(most); i++) {
    double size = fabs(v[i]);
    most = size <= most ? most : size;
  }
  return most;
}

/* ph_arc_form_sum: out[dim][dim] = sum_k y_k S_k of the given forms. */
static inline void ph_arc_form_sum(size_t dim, size_t n, const int *form,
                                   const double *y, double *out) {
  double w[4] = {0, 0, 0, 0};
  for (size_t k = 0; k < n; k++) {
    w[form[k]] += y[k];
  }
  if (dim == 4) {
    const double sum[16] = {
        w[0] + w[1], 0, w[2],  -w[3], 0, w[0] + w[1], w[3], w[2], w[2], w[3],
        w[0] - w[1], 0, -w[3], w[2],  0, w[0] - w[1]};
    for (size_t i = 0; i < 16; i++) {
      out[i] = sum[i];
    }
  } else if (dim == 2) {
    out[0] = w[0] + w[1];
    out[1] = out[2] = w[2];
    out[3] = w[0] - w[1];
  } else {
    out[0] = w[0] + w[1];
  }
}

/* ph_arc_spinor: a unit node in space whose image H is the unit vector d, well
 * conditioned for each. */
static inline void ph_arc_spinor(ph_vec3 d, double w[4]) {
  if (d.x >= 0) {
    double a = sqrt((1 + d.x) / 2);
    w[0] = a;
    w[1] = 0;
    w[2] = d.y / (2 * a);
    w[3] = -d.z / (2 * a);
  } else {
    double b = sqrt((1 - d.x) / 2);
    w[0] = d.y / (2 * b);
    w[1] = d.z / (2 * b);
    w[2] = b;
    w[3] = 0;
  }
}

/* ph_arc_turned: i w of a node in space. */
static inline void ph_arc_turned(const double *w, double *out) {
  double w0 = w[0], w1 = w[1], w2 = w[2], w3 = w[3];
  out[0] = -w1;
  out[1] = w0;
  out[2] = -w3;
  out[3] = w2;
}

/* ph_arc_phase: e^(i angle) w of a node in space. */
static inline void ph_arc_phase(double cosine, double sine, const double *w,
                                double *out) {
  double iw[4];
  ph_arc_turned(w, iw);
  for (size_t i = 0; i < 4; i++) {
    out[i] = cosine * w[i] + sine * iw[i];
  }
}

#endif
