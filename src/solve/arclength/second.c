/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Second derivatives of an interval (see second.h). */
#include "solve/arclength/second.h"

#include <math.h>
#include <string.h>

/* Multipliers of the rows as they are, not as whitened. */
static void plain_multipliers(const struct ph_arc_system *s, size_t i,
                              const double *y, double *out) {
  size_t n = s->forms_n;
  for (size_t k = 0; k < n; k++) {
    out[k] = s->white ? 0 : y[i * n + k];
    for (size_t l = 0; s->white && l < n; l++) {
      out[k] += s->white[i * n * n + l * n + k] * y[i * n + l];
    }
  }
}

void ph_arc_second_lambda(const struct ph_arc_system *s, size_t i,
                          const double *y, double lambda[16]) {
  double plain[4];
  memset(lambda, 0, 16 * sizeof *lambda);
  if (y) {
    plain_multipliers(s, i, y, plain);
    ph_arc_form_sum(s->dim, s->forms_n, s->form, plain, lambda);
  }
}

static void set_nodes(const struct ph_arc_system *s, size_t i, const double *y,
                      double functional, struct ph_arc_second *h) {
  size_t span = s->span, dim = s->dim;
  double lambda[16], square[16];
  ph_arc_second_lambda(s, i, y, lambda);
  memset(h->a, 0, sizeof h->a);
  for (size_t a = 0; a < span; a++) {
    for (size_t b = a > 2 ? a - 2 : 0; b < span && b <= a + 2; b++) {
      ph_arc_second_nodes(s, i, a, b, functional, lambda, dim, square);
      for (size_t k = 0; k < dim * dim; k++) {
        h->a[a * dim + k / dim][b * dim + k % dim] = square[k];
      }
    }
  }
}

/* The gradient of the Lagrangian of an interval by its nodes. */
static void node_gradient(const struct ph_arc_system *s,
                          const struct ph_arc_piece *p,
                          const struct ph_arc_second *h, double *out) {
  size_t n = s->span * s->dim; /* all is quadratic in the nodes */
  for (size_t a = 0; a < n; a++) {
    out[a] = ph_arc_dot(n, h->a[a], p->w);
  }
}

/* Second derivatives by unknowns: w_M+j = e^(i chi) w_j enters twice. */
static void unwrap(const struct ph_arc_system *s, const struct ph_arc_piece *p,
                   struct ph_arc_second *h) {
  size_t nodes = s->span * s->dim;
  double gradient[4 * PH_ARC_SPAN];
  node_gradient(s, p, h, gradient);
  for (size_t a = 0; a < nodes; a++) {
    ph_arc_piece_back(s, p, h->a[a]);
  }
  for (size_t b = 0; b < h->n; b++) {
    double column[PH_ARC_LOCAL];
    for (size_t a = 0; a < nodes; a++) {
      column[a] = h->a[a][b];
    }
    ph_arc_piece_back(s, p, column);
    for (size_t a = 0; a < h->n; a++) {
      h->a[a][b] = column[a];
    }
  }
  for (size_t a = p->inside; s->turn && a < s->span; a++) {
    double ig[4];
    h->a[nodes][nodes] -= ph_arc_dot(4, gradient + 4 * a, p->w + 4 * a);
    ph_arc_turned(gradient + 4 * a, ig);
    ph_arc_phase(p->cosine, -p->sine, ig, ig);
    for (size_t k = 0; k < 4; k++) {
      h->a[4 * a + k][nodes] -= ig[k];
      h->a[nodes][4 * a + k] -= ig[k];
    }
  }
}

void ph_arc_second_wrapped(const struct ph_arc_system *s, size_t i,
                           const double *x, const double *y, double functional,
                           struct ph_arc_second *h) {
  struct ph_arc_piece p;
  h->n = ph_arc_touched(s, i);
  ph_arc_piece_of(s, x, i, &p);
  set_nodes(s, i, y, functional, h);
  unwrap(s, &p, h);
}

size_t ph_arc_pins(const struct ph_arc_system *s, const double *x, size_t *node,
                   double out[2][4]) {
  bool two = s->data->line;
  const double *w;
  double iw[4], best = -1;
  if (s->dim != 4) {
    return 0;
  }
  *node = s->nodes / 2;
  for (size_t j = 0; two && j < s->nodes; j++) {
    const double *v = x + 4 * j;
    double a = v[0] * v[0] + v[1] * v[1], b = v[2] * v[2] + v[3] * v[3];
    double least = a < b ? a : b;
    if (least > best) {
      best = least;
      *node = j;
    }
  }
  w = x + 4 * *node;
  ph_arc_turned(w, iw);
  memset(out, 0, 8 * sizeof(double));
  if (!two || !(best > 0)) {
    double size = sqrt(ph_arc_dot(4, iw, iw));
    for (size_t k = 0; k < 4; k++) {
      out[0][k] = size > 0 ? iw[k] / size : k == 1;
    }
    return 1;
  }
  for (size_t half = 0; half < 2; half++) {
    double size = hypot(iw[2 * half], iw[2 * half + 1]);
    out[half][2 * half] = iw[2 * half] / size;
    out[half][2 * half + 1] = iw[2 * half + 1] / size;
  }
  return 2;
}
