/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Matrices of second derivatives (see system.h). */
#include "solve/arclength/system.h"

#include "kernel/band.h"

#include <math.h>
#include <string.h>

/* Weight of what holds ends. */
static const double HELD = 1e10;

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

/* sum_k y_k S_k of an interval; y NULL: 0. */
static void lambda_of(const struct ph_arc_system *s, size_t i, const double *y,
                      double lambda[16]) {
  double plain[4];
  memset(lambda, 0, 16 * sizeof *lambda);
  if (y) {
    plain_multipliers(s, i, y, plain);
    ph_arc_form_sum(s->dim, s->forms_n, s->form, plain, lambda);
  }
}

/* Second derivatives by nodes a and b of interval i:
 * 2 G_ab lambda + 2 functional sum_q e_qa e_qb. */
static inline void node_square(const struct ph_arc_system *s, size_t i,
                               size_t a, size_t b, double functional,
                               const double *lambda, size_t dim,
                               double *square) {
  const double *second = s->second + 3 * i * s->refine;
  double f = 0, g = 2 * s->gram[(i * s->span + a) * s->span + b];
  for (size_t q = 0; q < s->refine; q++) {
    bool has = q <= a && a <= q + 2 && q <= b && b <= q + 2;
    f += has ? second[3 * q + a - q] * second[3 * q + b - q] : 0;
  }
  for (size_t d = 0; d < dim; d++) {
    for (size_t e = 0; e < dim; e++) {
      square[d * dim + e] = g * lambda[d * dim + e];
    }
    square[d * dim + d] += 2 * functional * f;
  }
}

static void set_nodes(const struct ph_arc_system *s, size_t i, const double *y,
                      double functional, struct block *h) {
  size_t span = s->span, dim = s->dim;
  double lambda[16], square[16];
  lambda_of(s, i, y, lambda);
  memset(h->a, 0, sizeof h->a);
  for (size_t a = 0; a < span; a++) {
    for (size_t b = a > 2 ? a - 2 : 0; b < span && b <= a + 2; b++) {
      node_square(s, i, a, b, functional, lambda, dim, square);
      for (size_t k = 0; k < dim * dim; k++) {
        h->a[a * dim + k / dim][b * dim + k % dim] = square[k];
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

/* The same of an interval beyond the seam. */
static void set_wrapped(const struct ph_arc_system *s, size_t i,
                        const double *x, const double *y, double functional,
                        struct block *h) {
  struct ph_arc_piece p;
  h->n = ph_arc_touched(s, i);
  ph_arc_piece_of(s, x, i, &p);
  set_nodes(s, i, y, functional, h);
  unwrap(s, &p, h);
}

/* Whether unknowns a and b of an interval have second derivatives: nodes that
 * are in one segment, and all with chi. */
static bool meet(const struct ph_arc_system *s, size_t a, size_t b) {
  size_t i = a / s->dim, j = b / s->dim;
  return i == s->span || j == s->span || (i <= j + 2 && j <= i + 2);
}

/* ---- the pin ------------------------------------------------------------- */

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

/* Adds v[dim][dim] at rows i, i + 1, ... and columns j, j + 1, ...: components
 * of a node are next to each other in the matrix. */
static inline void add_square(const struct target *t, uint32_t i, uint32_t j,
                              size_t dim, const double *v) {
  size_t k = t->band;
  if (!t->symmetric) {
    double *at = ph_band_at(t->a, k, i, j);
    for (size_t d = 0; d < dim; d++) {
      for (size_t e = 0; e < dim; e++) {
        at[d * 3 * k + e] += v[d * dim + e];
      }
    }
  } else if (i >= j) {
    double *at = ph_sym_at(t->a, k, i, j);
    for (size_t e = 0; e < dim; e++) {
      for (size_t d = i == j ? e : 0; d < dim; d++) {
        at[e * k + d] += v[d * dim + e];
      }
    }
  }
}

static void add_pins(const struct ph_arc_system *s, const double *x, double pin,
                     const struct target *t) {
  double v[2][4], square[16];
  size_t node = 0, n = pins(s, x, &node, v);
  uint32_t place = t->place[4 * node];
  for (size_t i = 0; i < n; i++) {
    for (size_t a = 0; a < 16; a++) {
      square[a] = pin * v[i][a / 4] * v[i][a % 4];
    }
    add_square(t, place, place, 4, square);
  }
}

/* Second derivatives of the rows of a knot: 2 (mu, nu)(mu, nu)^T (x) sum y S.
 */
static void add_knot(const struct ph_arc_system *s, size_t j, const double *y,
                     const struct target *t) {
  static const int form[3] = {1, 2, 3};
  const uint32_t *place = t->place + j * s->refine * s->dim;
  size_t dim = s->dim;
  double lambda[16], square[16];
  ph_arc_form_sum(dim, s->knot_rows, form,
                  y + s->data->n * s->forms_n + j * s->knot_rows, lambda);
  for (size_t a = 0; a < 2; a++) {
    for (size_t b = 0; b < 2; b++) {
      double m = 2 * s->knot[2 * j + a] * s->knot[2 * j + b];
      for (size_t k = 0; k < dim * dim; k++) {
        square[k] = m * lambda[k];
      }
      add_square(t, place[a * dim], place[b * dim], dim, square);
    }
  }
}

/* Intervals beyond the seam. */
static void add_wrapped(const struct ph_arc_system *s, size_t i,
                        const double *x, const double *y, double functional,
                        const struct target *t) {
  size_t index[PH_ARC_LOCAL];
  struct block h;
  ph_arc_index(s, i, index);
  set_wrapped(s, i, x, y, functional, &h);
  for (size_t a = 0; a < h.n; a++) {
    for (size_t b = 0; b < h.n; b++) {
      if (meet(s, a, b)) {
        add(t, t->place[index[a]], t->place[index[b]], h.a[a][b]);
      }
    }
  }
}

static inline void add_interval(const struct ph_arc_system *s, size_t i,
                                const double *y, double functional, size_t dim,
                                const struct target *t) {
  const uint32_t *place = t->place + i * s->refine * dim;
  double lambda[16];
  lambda_of(s, i, y, lambda);
  for (size_t a = 0; a < s->span; a++) {
    for (size_t b = a > 2 ? a - 2 : 0; b < s->span && b <= a + 2; b++) {
      double square[16];
      if (t->symmetric && place[a * dim] < place[b * dim]) {
        continue;
      }
      node_square(s, i, a, b, functional, lambda, dim, square);
      add_square(t, place[a * dim], place[b * dim], dim, square);
    }
  }
}

static double shift_of(const struct ph_arc_weights *weights, size_t j) {
  return weights->shift + (weights->shifts ? weights->shifts[j] : 0);
}

/* What holds the phases of nodes j and j + 1 to each other. */
static void add_link(const struct ph_arc_system *s, const double *x, size_t j,
                     double shift, const struct target *t) {
  const double *w = x + 4 * j, *v = w + 4;
  uint32_t here = t->place[4 * j], next = t->place[4 * j + 4];
  double own[16], cross[16];
  ph_arc_link_square(w, v, shift, own, cross);
  add_square(t, here, here, s->dim, own);
  add_square(t, next, here, s->dim, cross);
  ph_arc_link_square(v, w, shift, own, cross);
  add_square(t, next, next, s->dim, own);
  add_square(t, here, next, s->dim, cross);
}

/* Shifts of the changes of nodes; chi, a phase as well, has those of the first.
 */
static void add_shifts(const struct ph_arc_system *s, const double *x,
                       const struct ph_arc_weights *weights,
                       const struct target *t) {
  for (size_t j = 0; j < s->nodes; j++) {
    double shift = shift_of(weights, j), square[16];
    double next = j + 1 < s->nodes ? shift_of(weights, j + 1) : 0;
    uint32_t place = t->place[j * s->dim];
    if (shift > 0) {
      ph_arc_change_square(s, x + j * s->dim, shift, square);
      add_square(t, place, place, s->dim, square);
    }
    if (s->phases && j + 1 < s->nodes && shift + next > 0) {
      add_link(s, x, j, (shift + next) / 2, t);
    }
    for (size_t k = 0; weights->holds && k < s->dim; k++) {
      add(t, place + (uint32_t)k, place + (uint32_t)k, weights->holds[j]);
    }
  }
  if (s->turn) {
    uint32_t place = t->place[s->x_n - 1];
    add(t, place, place,
        shift_of(weights, 0) + (weights->holds ? weights->holds[0] : 0));
  }
}

/* Holds the ends of a part but for a common phase of each. */
static void add_ends(const struct ph_arc_system *s, const double *x,
                     const struct target *t) {
  for (size_t k = 0; k < 4; k++) {
    size_t j = k < 2 ? k : s->nodes - 4 + k;
    uint32_t place = t->place[j * s->dim];
    double square[16];
    if (!s->held[k / 2]) {
      continue;
    }
    ph_arc_change_square(s, x + j * s->dim, HELD, square);
    add_square(t, place, place, s->dim, square);
    if (s->phases && k % 2 == 0) {
      add_link(s, x, j, HELD, t);
    }
  }
}

/* What ph_arc_retract adds to the second derivatives of the Lagrangian. */
static void add_retraction(const struct ph_arc_system *s, const double *x,
                           const struct ph_arc_linear *linear,
                           const struct target *t) {
  for (size_t j = 0; s->phases && j < s->nodes; j++) {
    uint32_t place = t->place[4 * j];
    double square[16];
    ph_arc_retract_square(x + 4 * j, linear->l_x + 4 * j, square);
    add_square(t, place, place, 4, square);
  }
}

/* The Hessian of the functional and the rows of intervals, of knots, and shift.
 * This and what follows is not complete when time is over. */
static void add_hessian(const struct ph_arc_system *s, const double *x,
                        const double *y, const struct ph_arc_linear *linear,
                        const struct ph_arc_weights *weights,
                        const struct target *t) {
  size_t n = s->data->n, dim = s->dim;
  bool knots = y && s->knot_rows > 0 && !s->direction;
  double f = weights->functional;
  for (size_t i = 0; i < n && !ph_arena_late(s->arena); i++) {
    if (ph_arc_wraps(s, i)) {
      add_wrapped(s, i, x, y, f, t);
    } else if (dim == 4) { /* a constant for the compiler */
      add_interval(s, i, y, f, 4, t);
    } else {
      add_interval(s, i, y, f, dim, t);
    }
  }
  for (size_t j = 0; knots && j <= n; j++) {
    add_knot(s, j, y, t);
  }
  if (weights->retracted) {
    add_retraction(s, x, linear, t);
  }
  add_shifts(s, x, weights, t);
}

/* A row of the equations and its column, over n nodes. */
static inline void add_row(const struct ph_arc_system *s,
                           const struct target *t, uint32_t at,
                           const uint32_t *place, size_t n, const double *row) {
  size_t dim = s->dim;
  for (size_t a = 0; a < n; a++) {
    double *across = ph_band_at(t->a, t->band, at, place[a * dim]);
    double *down = ph_band_at(t->a, t->band, place[a * dim], at);
    for (size_t d = 0; d < dim; d++) {
      across[d] += row[a * dim + d];
      down[d * 3 * t->band] += row[a * dim + d];
    }
  }
}

/* The places of the nodes of an interval, also beyond the seam. */
static const uint32_t *node_places(const struct ph_arc_system *s, size_t i,
                                   const struct target *t,
                                   uint32_t places[PH_ARC_LOCAL]) {
  size_t index[PH_ARC_LOCAL], touched = ph_arc_touched(s, i);
  if (!ph_arc_wraps(s, i)) {
    return t->place + i * s->refine * s->dim;
  }
  ph_arc_index(s, i, index);
  for (size_t a = 0; a < touched; a++) {
    places[a] = t->place[index[a]];
  }
  return places;
}

static void add_rows(const struct ph_arc_system *s,
                     const struct ph_arc_linear *linear,
                     const struct target *t) {
  size_t n = s->data->n, local = ph_arc_local(s), dim = s->dim;
  for (size_t i = 0; s->forms_n > 0 && i < n && !ph_arena_late(s->arena); i++) {
    uint32_t places[PH_ARC_LOCAL];
    const uint32_t *place = node_places(s, i, t, places);
    for (size_t k = 0; k < s->forms_n; k++) {
      const double *row = linear->rows + (i * s->forms_n + k) * local;
      uint32_t at = s->place_y[i * s->forms_n + k];
      add_row(s, t, at, place, s->span, row);
      if (ph_arc_touched(s, i) > s->span * dim) {
        add(t, at, place[s->span * dim], row[local - 1]);
        add(t, place[s->span * dim], at, row[local - 1]);
      }
    }
    if (s->compliance) {
      uint32_t at = s->place_y[i * s->forms_n];
      add(t, at, at, -s->compliance[i]);
    }
  }
  for (size_t r = 0; r < (n + 1) * s->knot_rows; r++) {
    uint32_t at = s->place_y[n * s->forms_n + r];
    if (s->knot_compliance) {
      add(t, at, at, -s->knot_compliance[r / s->knot_rows]);
    }
    add_row(s, t, at, t->place + r / s->knot_rows * s->refine * dim, 2,
            linear->knot_rows + r * 2 * dim);
  }
}

/* sum_k weight_k row_k row_k^T over n nodes, rows a stride apart. */
static inline void add_products(const struct target *t, const uint32_t *place,
                                size_t n, size_t dim, size_t rows,
                                const double *row, size_t stride,
                                const double *weight) {
  for (size_t a = 0; a < n; a++) {
    for (size_t b = 0; b < n; b++) {
      double square[16] = {0};
      if (place[a * dim] < place[b * dim]) {
        continue;
      }
      for (size_t k = 0; k < rows; k++) {
        const double *v = row + k * stride;
        for (size_t d = 0; d < dim; d++) {
          double scaled = weight[k] * v[a * dim + d];
          for (size_t e = 0; e < dim; e++) {
            square[d * dim + e] += scaled * v[b * dim + e];
          }
        }
      }
      add_square(t, place[a * dim], place[b * dim], dim, square);
    }
  }
}

/* The same with chi, which is alone. */
static void add_chi_products(const struct ph_arc_system *s,
                             const struct target *t, const uint32_t *place,
                             const double *row, const double *weight) {
  size_t nodes = s->span * s->dim, local = ph_arc_local(s);
  for (size_t k = 0; k < s->forms_n; k++) {
    const double *v = row + k * local;
    for (size_t a = 0; a < nodes; a++) {
      double product = weight[k] * v[a] * v[nodes];
      add(t, place[a], place[nodes], product);
      add(t, place[nodes], place[a], product);
    }
    add(t, place[nodes], place[nodes], weight[k] * v[nodes] * v[nodes]);
  }
}

static void add_penalty(const struct ph_arc_system *s,
                        const struct ph_arc_linear *linear, double rho,
                        const struct target *t) {
  size_t n = s->data->n, local = ph_arc_local(s), dim = s->dim;
  double weight[4] = {rho, rho, rho, rho};
  for (size_t i = 0; s->forms_n > 0 && i < n && !ph_arena_late(s->arena); i++) {
    uint32_t places[PH_ARC_LOCAL];
    const uint32_t *place = node_places(s, i, t, places);
    const double *row = linear->rows + i * s->forms_n * local;
    if (s->compliance) {
      weight[0] = 1 / (s->compliance[i] + 1 / rho);
    }
    if (dim == 4) { /* a constant for the compiler */
      add_products(t, place, s->span, 4, s->forms_n, row, local, weight);
    } else {
      add_products(t, place, s->span, dim, s->forms_n, row, local, weight);
    }
    if (ph_arc_touched(s, i) > s->span * dim) {
      add_chi_products(s, t, place, row, weight);
    }
  }
  weight[0] = rho;
  for (size_t j = 0; s->knot_rows > 0 && j <= n; j++) {
    for (size_t k = 0; s->knot_compliance && k < s->knot_rows; k++) {
      weight[k] = 1 / (s->knot_compliance[j] + 1 / rho);
    }
    add_products(t, t->place + j * s->refine * dim, 2, dim, s->knot_rows,
                 linear->knot_rows + j * s->knot_rows * 2 * dim, 2 * dim,
                 weight);
  }
}

void ph_arc_kkt(const struct ph_arc_system *s, const double *x, const double *y,
                const struct ph_arc_linear *linear,
                const struct ph_arc_weights *weights, double *matrix) {
  struct target t = {matrix, s->kkt_band, s->place_x, false};
  memset(matrix, 0, ph_band_size(s->kkt_n, s->kkt_band) * sizeof *matrix);
  add_hessian(s, x, y, linear, weights, &t);
  add_pins(s, x, weights->pin, &t);
  add_ends(s, x, &t);
  add_rows(s, linear, &t);
}

void ph_arc_penalised(const struct ph_arc_system *s, const double *x,
                      const double *y, const struct ph_arc_linear *linear,
                      const struct ph_arc_weights *weights, double rho,
                      double *matrix) {
  struct target t = {matrix, s->order_band, s->order, true};
  double most = 0;
  memset(matrix, 0, ph_sym_size(s->x_n, s->order_band) * sizeof *matrix);
  add_hessian(s, x, y, linear, weights, &t);
  for (size_t k = 0; weights->rounding > 0 && k < s->x_n; k++) {
    double size = *ph_sym_at(matrix, s->order_band, k, k);
    most = size > most ? size : most;
  }
  for (size_t k = 0; most > 0 && k < s->x_n; k++) {
    *ph_sym_at(matrix, s->order_band, k, k) += weights->rounding * most;
  }
  add_pins(s, x, weights->pin, &t);
  add_ends(s, x, &t);
  add_penalty(s, linear, rho, &t);
}
