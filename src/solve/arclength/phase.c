/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What phases of nodes do to matrices of second derivatives (see system.h). */
#include "solve/arclength/system.h"

#include <math.h>
#include <string.h>

/* i w / |w|, or 0. */
static void turning(const double *w, double size, double out[4]) {
  ph_arc_turned(w, out);
  for (size_t k = 0; k < 4; k++) {
    out[k] = size > 0 ? out[k] / size : 0;
  }
}

void ph_arc_retract_square(const double *w, const double *g, double out[16]) {
  double t[4], ig[4], size = sqrt(ph_arc_dot(4, w, w)), along;
  turning(w, size, t);
  ph_arc_turned(g, ig);
  along = size > 0 ? ph_arc_dot(4, w, g) / (size * size) : 0;
  for (size_t k = 0; k < 16; k++) {
    size_t d = k / 4, e = k % 4;
    out[k] = along * t[d] * t[e];
    out[k] -= size > 0 ? (t[d] * ig[e] + ig[d] * t[e]) / size : 0;
  }
}

void ph_arc_change_square(const struct ph_arc_system *s, const double *w,
                          double shift, double *out) {
  double t[4] = {0};
  size_t dim = s->dim;
  if (s->phases) {
    turning(w, sqrt(ph_arc_dot(4, w, w)), t);
  }
  for (size_t k = 0; k < dim * dim; k++) {
    size_t d = k / dim, e = k % dim;
    out[k] = shift * ((d == e ? 1 : 0) - t[d] * t[e]);
  }
}

void ph_arc_link_square(const double *w, const double *v, double shift,
                        double own[16], double cross[16]) {
  double t[4], u[4], w_size = sqrt(ph_arc_dot(4, w, w)),
                     v_size = sqrt(ph_arc_dot(4, v, v));
  double least = fmin(w_size, v_size);
  double a = least > 0 ? least / w_size : 0, b = least > 0 ? least / v_size : 0;
  turning(w, w_size, t);
  turning(v, v_size, u);
  for (size_t k = 0; k < 16; k++) {
    own[k] = shift * a * a * t[k / 4] * t[k % 4];
    cross[k] = -shift * a * b * u[k / 4] * t[k % 4];
  }
}

double ph_arc_split(const struct ph_arc_system *s, const double *w,
                    const double *v, double *rest) {
  double iw[4], size, p;
  memcpy(rest, v, s->dim * sizeof *v);
  if (!s->phases) {
    return 0;
  }
  size = ph_arc_dot(4, w, w);
  ph_arc_turned(w, iw);
  p = size > 0 ? ph_arc_dot(4, iw, v) / size : 0;
  for (size_t k = 0; k < 4; k++) {
    rest[k] -= p * iw[k];
  }
  return p;
}

void ph_arc_ends_gradient(const struct ph_arc_system *s, const double *x,
                          double *gradient) {
  size_t dim = s->dim;
  for (size_t end = 0; end < 2; end++) {
    size_t first = end > 0 ? (s->nodes - 2) * dim : 0;
    const double *w = x + first;
    double *g = gradient + first, iw[8] = {0}, along = 0;
    if (!s->held[end]) {
      continue;
    }
    if (s->phases) {
      ph_arc_turned(w, iw);
      ph_arc_turned(w + 4, iw + 4);
      along = ph_arc_dot(8, iw, g) / ph_arc_dot(8, iw, iw);
    }
    for (size_t k = 0; k < 2 * dim; k++) {
      g[k] = s->phases ? along * iw[k] : 0;
    }
  }
}
