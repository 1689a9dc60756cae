/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Matrices of second derivatives (see arclength_system.h). */
#include "solve/arclength_form.h"
#include "solve/arclength_piece.h"
#include "solve/arclength_system.h"

#include "kernel/band.h"

#include <math.h>
#include <string.h>

/* Second derivatives of one interval by its unknowns. */
struct block {
  size_t n;
  double a[PH_ARC_LOCAL][PH_ARC_LOCAL];
};

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

/* 2 G (x) sum_k y_k S_k + 2 w sum_q e_q e_q^T (x) 1, by the nodes. */
static void set_nodes(const struct ph_arc_system *s, size_t i, const double *y,
                      double functional, struct block *h) {
  size_t span = s->span, dim = s->dim;
  const double *gram = s->gram + i * span * span;
  const double *bend = s->bend + 3 * i * s->refine;
  double lambda[16] = {0}, plain[4];
  if (y) {
    plain_multipliers(s, i, y, plain);
    ph_arc_form_sum(dim, s->forms_n, s->form, plain, lambda);
  }
  memset(h->a, 0, sizeof h->a);
  for (size_t a = 0; a < span; a++) {
    for (size_t b = a > 2 ? a - 2 : 0; b < span && b <= a + 2; b++) {
      double f = 0, g = 2 * gram[a * span + b];
      for (size_t q = 0; q < s->refine; q++) {
        bool has = q <= a && a <= q + 2 && q <= b && b <= q + 2;
        f += has ? bend[3 * q + a - q] * bend[3 * q + b - q] : 0;
      }
      for (size_t d = 0; d < dim; d++) {
        for (size_t e = 0; e < dim; e++) {
          h->a[a * dim + d][b * dim + e] = g * lambda[d * dim + e];
        }
        h->a[a * dim + d][b * dim + d] += 2 * functional * f;
      }
    }
  }
}

/* The gradient of the Lagrangian of an interval by its nodes. */
static void node_gradient(const struct ph_arc_system *s,
                          const struct ph_arc_piece *p, const struct block *h,
                          double *out) {
  size_t n = s->span * s->dim; /* all is quadratic in the nodes */
  for (size_t a = 0; a < n; a++) {
    out[a] = ph_arc_dot(n, h->a[a], p->w);
  }
}

/* Second derivatives by unknowns: w_M+j = e^(i chi) w_j enters twice. */
static void unwrap(const struct ph_arc_system *s, const struct ph_arc_piece *p,
                   struct block *h) {
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

static void set_block(const struct ph_arc_system *s, size_t i, const double *x,
                      const double *y, double functional, struct block *h) {
  h->n = ph_arc_touched(s, i);
  set_nodes(s, i, y, functional, h);
  if (ph_arc_wraps(s, i)) {
    struct ph_arc_piece p;
    ph_arc_piece_of(s, x, i, &p);
    unwrap(s, &p, h);
  }
}

/* Second derivatives of the rows of a knot: 2 (mu, nu)(mu, nu)^T (x) sum y S.
 */
static void set_knot(const struct ph_arc_system *s, size_t j, const double *y,
                     double out[8][8]) {
  static const int form[3] = {1, 2, 3};
  size_t dim = s->dim;
  double lambda[16];
  ph_arc_form_sum(dim, s->knot_rows, form,
                  y + s->data->n * s->forms_n + j * s->knot_rows, lambda);
  for (size_t a = 0; a < 2; a++) {
    for (size_t b = 0; b < 2; b++) {
      double m = 2 * s->knot[2 * j + a] * s->knot[2 * j + b];
      for (size_t d = 0; d < dim; d++) {
        for (size_t e = 0; e < dim; e++) {
          out[a * dim + d][b * dim + e] = m * lambda[d * dim + e];
        }
      }
    }
  }
}

/* ---- the pin ------------------------------------------------------------ */

/* What leaves all equations as they are: the common phase; of data on a line
 * also a turn about it, so that a and b have a phase each.  One node is held.
 */
static size_t pins(const struct ph_arc_system *s, const double *x, size_t *node,
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

/* ---- assembly ------------------------------------------------------------ */

/* A matrix under assembly: its band and where unknowns are in it. */
struct target {
  double *a;
  size_t band;
  const uint32_t *place;
  bool symmetric; /* only the lower triangle */
};

static inline void add(const struct target *t, uint32_t i, uint32_t j,
                       double v) {
  if (!t->symmetric) {
    *ph_band_at(t->a, t->band, i, j) += v;
  } else if (i >= j) {
    *ph_sym_at(t->a, t->band, i, j) += v;
  }
}

static void add_pins(const struct ph_arc_system *s, const double *x, double pin,
                     const struct target *t) {
  double v[2][4];
  size_t node = 0, n = pins(s, x, &node, v);
  const uint32_t *place = t->place + 4 * node;
  for (size_t i = 0; i < n; i++) {
    for (size_t a = 0; a < 4; a++) {
      for (size_t b = 0; b < 4; b++) {
        add(t, place[a], place[b], pin * v[i][a] * v[i][b]);
      }
    }
  }
}

/* Whether unknowns a and b of an interval have second derivatives: nodes that
 * are in one segment, and all with chi. */
static bool meet(const struct ph_arc_system *s, size_t a, size_t b) {
  size_t i = a / s->dim, j = b / s->dim;
  return i == s->span || j == s->span || (i <= j + 2 && j <= i + 2);
}

/* The Hessian of the functional and the rows of intervals, of knots, shift and
 * pin. */
static void add_hessian(const struct ph_arc_system *s, const double *x,
                        const double *y, const struct ph_arc_weights *weights,
                        const struct target *t) {
  size_t n = s->data->n, dim = s->dim;
  bool knots = y && s->knot_rows > 0 && !s->direction;
  for (size_t i = 0; i < n; i++) {
    size_t index[PH_ARC_LOCAL];
    struct block h;
    ph_arc_index(s, i, index);
    set_block(s, i, x, y, weights->functional, &h);
    for (size_t a = 0; a < h.n; a++) {
      for (size_t b = 0; b < h.n; b++) {
        if (meet(s, a, b)) {
          add(t, t->place[index[a]], t->place[index[b]], h.a[a][b]);
        }
      }
    }
  }
  for (size_t j = 0; knots && j <= n; j++) {
    const uint32_t *place = t->place + j * s->refine * dim;
    double h[8][8];
    set_knot(s, j, y, h);
    for (size_t a = 0; a < 2 * dim; a++) {
      for (size_t b = 0; b < 2 * dim; b++) {
        add(t, place[a], place[b], h[a][b]);
      }
    }
  }
  for (size_t k = 0; k < s->x_n; k++) {
    add(t, t->place[k], t->place[k], weights->shift);
  }
  add_pins(s, x, weights->pin, t);
}

static void add_rows(const struct ph_arc_system *s,
                     const struct ph_arc_linear *linear,
                     const struct target *t) {
  size_t n = s->data->n, local = ph_arc_local(s), dim = s->dim;
  for (size_t i = 0; s->forms_n > 0 && i < n; i++) {
    size_t index[PH_ARC_LOCAL], touched = ph_arc_touched(s, i);
    ph_arc_index(s, i, index);
    for (size_t k = 0; k < s->forms_n; k++) {
      const double *row = linear->rows + (i * s->forms_n + k) * local;
      uint32_t at = s->place_y[i * s->forms_n + k];
      for (size_t a = 0; a < touched; a++) {
        add(t, at, t->place[index[a]], row[a]);
        add(t, t->place[index[a]], at, row[a]);
      }
    }
    if (s->compliance) {
      uint32_t at = s->place_y[i * s->forms_n];
      add(t, at, at, -s->compliance[i]);
    }
  }
  for (size_t r = 0; r < (n + 1) * s->knot_rows; r++) {
    const uint32_t *place = t->place + r / s->knot_rows * s->refine * dim;
    uint32_t at = s->place_y[n * s->forms_n + r];
    for (size_t a = 0; a < 2 * dim; a++) {
      double v = linear->knot_rows[r * 2 * dim + a];
      add(t, at, place[a], v);
      add(t, place[a], at, v);
    }
  }
}

void ph_arc_kkt(const struct ph_arc_system *s, const double *x, const double *y,
                const struct ph_arc_linear *linear,
                const struct ph_arc_weights *weights, double *matrix) {
  struct target t = {matrix, s->kkt_band, s->place_x, false};
  memset(matrix, 0, ph_band_size(s->kkt_n, s->kkt_band) * sizeof *matrix);
  add_hessian(s, x, y, weights, &t);
  add_rows(s, linear, &t);
}

void ph_arc_penalised(const struct ph_arc_system *s, const double *x,
                      const double *y, const struct ph_arc_linear *linear,
                      const struct ph_arc_weights *weights, double rho,
                      double *matrix) {
  struct target t = {matrix, s->order_band, s->order, true};
  size_t n = s->data->n, local = ph_arc_local(s), dim = s->dim;
  memset(matrix, 0, ph_sym_size(s->x_n, s->order_band) * sizeof *matrix);
  add_hessian(s, x, y, weights, &t);
  for (size_t i = 0; s->forms_n > 0 && i < n; i++) {
    size_t index[PH_ARC_LOCAL], touched = ph_arc_touched(s, i);
    ph_arc_index(s, i, index);
    for (size_t k = 0; k < s->forms_n; k++) {
      const double *row = linear->rows + (i * s->forms_n + k) * local;
      double soft = s->compliance && k == 0 ? s->compliance[i] : 0;
      double weight = 1 / (soft > 1 / rho ? soft : 1 / rho);
      for (size_t a = 0; a < touched; a++) {
        for (size_t b = 0; b < touched; b++) {
          add(&t, t.place[index[a]], t.place[index[b]],
              weight * row[a] * row[b]);
        }
      }
    }
  }
  for (size_t r = 0; r < (n + 1) * s->knot_rows; r++) {
    const uint32_t *place = t.place + r / s->knot_rows * s->refine * dim;
    const double *row = linear->knot_rows + r * 2 * dim;
    for (size_t a = 0; a < 2 * dim; a++) {
      for (size_t b = 0; b < 2 * dim; b++) {
        add(&t, place[a], place[b], rho * row[a] * row[b]);
      }
    }
  }
}
