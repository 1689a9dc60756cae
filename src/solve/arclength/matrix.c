/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Matrices of second derivatives (see system.h). */
#include "solve/arclength/system.h"

#include "kernel/band.h"
#include "kernel/inertia.h"
#include "solve/arclength/second.h"

#include <math.h>
#include <string.h>

/* Weight of what holds ends. */
static const double HELD = 1e10;

/* ---- elements ------------------------------------------------------------ */

/* A matrix under assembly: its band and where unknowns are in it. */
struct target {
  double *a;
  size_t band;
  const uint32_t *place;
  bool symmetric;   /* only the lower triangle */
  size_t rows, row; /* how many there are, and elements of one in memory */
};

/* All that goes into one. */
struct assembly {
  const struct ph_arc_system *s;
  const double *x, *y; /* y NULL: nothing of the rows */
  const struct ph_arc_linear *linear;
  const struct ph_arc_weights *weights;
  double rho; /* of penalised matrices */
  size_t pins, pinned;
  double pin[2][4]; /* [pins] directions in which that node is held */
  struct target t;
  uint32_t *pivot; /* of the factors of one that is not symmetric */
  size_t factored; /* rows that are, or columns */
  size_t end;      /* see ph_band_reduce */
  bool regular;    /* so far */
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
  struct ph_arc_second h;
  ph_arc_index(s, i, index);
  ph_arc_second_wrapped(s, i, x, y, functional, &h);
  for (size_t a = 0; a < h.n; a++) {
    for (size_t b = 0; b < h.n; b++) {
      if (ph_arc_second_meet(s, a, b)) {
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
  ph_arc_second_lambda(s, i, y, lambda);
  for (size_t a = 0; a < s->span; a++) {
    for (size_t b = a > 2 ? a - 2 : 0; b < s->span && b <= a + 2; b++) {
      double square[16];
      if (t->symmetric && place[a * dim] < place[b * dim]) {
        continue;
      }
      ph_arc_second_nodes(s, i, a, b, functional, lambda, dim, square);
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

/* ---- parts of a matrix --------------------------------------------------- */

/* Each part is added for intervals from one on to before another, for their
 * nodes and first knots; with the last also for what follows it.  None touches
 * nodes of more than two further intervals but beyond a seam. */

static size_t nodes_end(const struct ph_arc_system *s, size_t to) {
  return to < s->data->n ? to * s->refine : s->nodes;
}

/* The first row of the nodes and rows of intervals from one on; those of a
 * closed curve alternate between both sides of its seam, and are known at its
 * end. */
static size_t row_of(const struct assembly *m, size_t i) {
  const struct ph_arc_system *s = m->s;
  if (i >= s->data->n) {
    return m->t.rows;
  }
  return s->data->closed ? 0 : m->t.place[i * s->refine * s->dim];
}

static size_t knots_end(const struct ph_arc_system *s, size_t to) {
  return to < s->data->n ? to : s->data->n + 1;
}

/* Clears rows, before anything is added to them. */
static void clear(struct assembly *m, size_t from, size_t to) {
  bool all = m->s->data->closed;
  size_t low = all && from > 0 ? m->t.rows : row_of(m, from);
  size_t n = (all ? m->t.rows : row_of(m, to)) - low;
  memset(m->t.a + low * m->t.row, 0, n * m->t.row * sizeof(double));
}

/* The Hessian of the functional and the rows of intervals. */
static void intervals(struct assembly *m, size_t from, size_t to) {
  const struct ph_arc_system *s = m->s;
  double f = m->weights->functional;
  for (size_t i = from; i < to; i++) {
    if (ph_arc_wraps(s, i)) {
      add_wrapped(s, i, m->x, m->y, f, &m->t);
    } else if (s->dim == 4) { /* a constant for the compiler */
      add_interval(s, i, m->y, f, 4, &m->t);
    } else {
      add_interval(s, i, m->y, f, s->dim, &m->t);
    }
  }
}

/* That of the rows of knots. */
static void knots(struct assembly *m, size_t from, size_t to) {
  const struct ph_arc_system *s = m->s;
  bool bent = m->y && s->knot_rows > 0 && !s->direction;
  for (size_t j = from; bent && j < knots_end(s, to); j++) {
    add_knot(s, j, m->y, &m->t);
  }
}

/* What ph_arc_retract adds to the second derivatives of the Lagrangian. */
static void retraction(struct assembly *m, size_t from, size_t to) {
  const struct ph_arc_system *s = m->s;
  bool turned = m->weights->retracted && s->phases;
  for (size_t j = from * s->refine; turned && j < nodes_end(s, to); j++) {
    uint32_t place = m->t.place[4 * j];
    double square[16];
    ph_arc_retract_square(m->x + 4 * j, m->linear->l_x + 4 * j, square);
    add_square(&m->t, place, place, 4, square);
  }
}

/* Shifts of the changes of nodes; chi, a phase as well, has those of the first.
 */
static void shifts(struct assembly *m, size_t from, size_t to) {
  const struct ph_arc_system *s = m->s;
  const struct ph_arc_weights *weights = m->weights;
  for (size_t j = from * s->refine; j < nodes_end(s, to); j++) {
    double shift = shift_of(weights, j), square[16];
    double next = j + 1 < s->nodes ? shift_of(weights, j + 1) : 0;
    uint32_t place = m->t.place[j * s->dim];
    if (shift > 0) {
      ph_arc_change_square(s, m->x + j * s->dim, shift, square);
      add_square(&m->t, place, place, s->dim, square);
    }
    if (s->phases && j + 1 < s->nodes && shift + next > 0) {
      add_link(s, m->x, j, (shift + next) / 2, &m->t);
    }
    for (size_t k = 0; weights->holds && k < s->dim; k++) {
      add(&m->t, place + (uint32_t)k, place + (uint32_t)k, weights->holds[j]);
    }
  }
  if (s->turn && from == 0) {
    uint32_t place = m->t.place[s->x_n - 1];
    add(&m->t, place, place,
        shift_of(weights, 0) + (weights->holds ? weights->holds[0] : 0));
  }
}

/* Holds the pinned node, and the ends of a part but for a common phase of each.
 */
static void holds(struct assembly *m, size_t from, size_t to) {
  const struct ph_arc_system *s = m->s;
  size_t low = from * s->refine, high = nodes_end(s, to);
  double square[16];
  for (size_t i = 0; i < m->pins && low <= m->pinned && m->pinned < high; i++) {
    uint32_t place = m->t.place[4 * m->pinned];
    for (size_t a = 0; a < 16; a++) {
      square[a] = m->weights->pin * m->pin[i][a / 4] * m->pin[i][a % 4];
    }
    add_square(&m->t, place, place, 4, square);
  }
  for (size_t k = 0; k < 4; k++) {
    size_t j = k < 2 ? k : s->nodes - 4 + k;
    uint32_t place = m->t.place[j * s->dim];
    if (!s->held[k / 2] || j < low || j >= high) {
      continue;
    }
    ph_arc_change_square(s, m->x + j * s->dim, HELD, square);
    add_square(&m->t, place, place, s->dim, square);
    if (s->phases && k % 2 == 0) {
      add_link(s, m->x, j, HELD, &m->t);
    }
  }
}

/* A row of the equations and its column, over n nodes. */
static inline void add_row(const struct ph_arc_system *s,
                           const struct target *t, uint32_t at,
                           const uint32_t *place, size_t n, const double *row) {
  size_t dim = s->dim;
  for (size_t a = 0; t->symmetric && a < n * dim; a++) {
    uint32_t node = place[a / dim * dim] + (uint32_t)(a % dim);
    add(t, at, node, row[a]);
    add(t, node, at, row[a]);
  }
  for (size_t a = 0; !t->symmetric && a < n; a++) {
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

/* The rows themselves, and their columns. */
static void rows(struct assembly *m, size_t from, size_t to) {
  const struct ph_arc_system *s = m->s;
  const struct target *t = &m->t;
  size_t local = ph_arc_local(s), dim = s->dim, knot = s->knot_rows;
  for (size_t i = from; s->forms_n > 0 && i < to; i++) {
    uint32_t places[PH_ARC_LOCAL];
    const uint32_t *place = node_places(s, i, t, places);
    for (size_t k = 0; k < s->forms_n; k++) {
      const double *row = m->linear->rows + (i * s->forms_n + k) * local;
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
  for (size_t r = from * knot; r < knots_end(s, to) * knot; r++) {
    uint32_t at = s->place_y[s->data->n * s->forms_n + r];
    if (s->knot_compliance) {
      add(t, at, at, -s->knot_compliance[r / knot]);
    }
    add_row(s, t, at, t->place + r / knot * s->refine * dim, 2,
            m->linear->knot_rows + r * 2 * dim);
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

/* The squares of the rows of intervals, and of knots. */
static void interval_squares(struct assembly *m, size_t from, size_t to) {
  const struct ph_arc_system *s = m->s;
  size_t local = ph_arc_local(s), dim = s->dim;
  double weight[4] = {m->rho, m->rho, m->rho, m->rho};
  for (size_t i = from; s->forms_n > 0 && i < to; i++) {
    uint32_t places[PH_ARC_LOCAL];
    const uint32_t *place = node_places(s, i, &m->t, places);
    const double *row = m->linear->rows + i * s->forms_n * local;
    if (s->compliance) {
      weight[0] = 1 / (s->compliance[i] + 1 / m->rho);
    }
    if (dim == 4) { /* a constant for the compiler */
      add_products(&m->t, place, s->span, 4, s->forms_n, row, local, weight);
    } else {
      add_products(&m->t, place, s->span, dim, s->forms_n, row, local, weight);
    }
    if (ph_arc_touched(s, i) > s->span * dim) {
      add_chi_products(s, &m->t, place, row, weight);
    }
  }
}

static void knot_squares(struct assembly *m, size_t from, size_t to) {
  const struct ph_arc_system *s = m->s;
  size_t dim = s->dim, n = s->knot_rows;
  double weight[4] = {m->rho, m->rho, m->rho, m->rho};
  for (size_t j = from; n > 0 && j < knots_end(s, to); j++) {
    for (size_t k = 0; s->knot_compliance && k < n; k++) {
      weight[k] = 1 / (s->knot_compliance[j] + 1 / m->rho);
    }
    add_products(&m->t, m->t.place + j * s->refine * dim, 2, dim, n,
                 m->linear->knot_rows + j * n * 2 * dim, 2 * dim, weight);
  }
}

/* Factors what has all its elements: the rows, or columns, that are further
 * from those to come than the band. */
static void factor(struct assembly *m, size_t from, size_t to) {
  size_t high = row_of(m, to), low = m->factored, k = m->t.band;
  if (high < m->t.rows) {
    high = high > k ? high - k : 0;
  }
  if (m->regular && from < to && low < high) {
    double *at = m->t.a + low * m->t.row;
    m->regular = m->t.symmetric
                     ? ph_sym_reduce(at, m->t.rows - low, k, high - low)
                     : ph_band_reduce(m->t.a, m->pivot, m->t.rows, k, low, high,
                                      &m->end);
    m->factored = high;
  }
}

/* ---- assembly ------------------------------------------------------------ */

typedef void part(struct assembly *m, size_t from, size_t to);

/* Intervals at a time: what is beside them in the matrix stays in the cache
 * from one part to the next. */
enum { STRETCH = 16, BEHIND = 2 };

/* Adds parts, each some intervals behind the one before, so that elements are
 * the same sums as of one part after the other.  Not complete when time is
 * over.
 */
static void assemble(struct assembly *m, part *const *parts, size_t n) {
  size_t end = m->s->data->n, last = end + (n - 1) * BEHIND;
  for (size_t at = 0; at < last && !ph_arena_late(m->s->arena); at += STRETCH) {
    for (size_t k = 0; k < n; k++) {
      size_t behind = k * BEHIND, to = at + STRETCH;
      size_t from = at > behind ? at - behind : 0;
      to = to > behind ? to - behind : 0;
      to = to < end ? to : end;
      if (from < to) {
        parts[k](m, from, to);
      }
    }
  }
}

/* All that matrices have in common, and what a node is held by. */
static struct assembly assembly_of(const struct ph_arc_system *s,
                                   const double *x, const double *y,
                                   const struct ph_arc_linear *linear,
                                   const struct ph_arc_weights *weights) {
  struct assembly m = {.s = s,
                       .x = x,
                       .y = y,
                       .linear = linear,
                       .weights = weights,
                       .regular = true};
  m.pins = ph_arc_pins(s, x, &m.pinned, m.pin);
  return m;
}

/* ret whether it is complete and, if it is to be factored, regular */
static bool set_kkt(struct assembly *m, double *matrix, uint32_t *pivot) {
  static part *const parts[] = {clear,  intervals, knots, retraction,
                                shifts, holds,     rows,  factor};
  const struct ph_arc_system *s = m->s;
  size_t n = sizeof parts / sizeof *parts;
  m->t = (struct target){.a = matrix,
                         .band = s->kkt_band,
                         .place = s->place_x,
                         .rows = s->kkt_n,
                         .row = ph_band_size(1, s->kkt_band)};
  m->pivot = pivot;
  assemble(m, parts, pivot ? n : n - 1);
  return m->regular && !ph_arena_late(s->arena);
}

void ph_arc_kkt(const struct ph_arc_system *s, const double *x, const double *y,
                const struct ph_arc_linear *linear,
                const struct ph_arc_weights *weights, double *matrix) {
  struct assembly m = assembly_of(s, x, y, linear, weights);
  set_kkt(&m, matrix, NULL);
}

bool ph_arc_kkt_factor(const struct ph_arc_system *s, const double *x,
                       const double *y, const struct ph_arc_linear *linear,
                       const struct ph_arc_weights *weights, double *matrix,
                       uint32_t *pivot) {
  struct assembly m = assembly_of(s, x, y, linear, weights);
  return set_kkt(&m, matrix, pivot);
}

/* Raises the diagonal of the Hessian by so many times its largest element, and
 * lets rows yield. */
static void raise(const struct assembly *m, double by) {
  const struct ph_arc_system *s = m->s;
  double most = 0;
  for (size_t k = 0; k < s->x_n; k++) {
    size_t at = m->t.place[k];
    double size = *ph_sym_at(m->t.a, m->t.band, at, at);
    most = size > most ? size : most;
  }
  for (size_t k = 0; k < s->x_n; k++) {
    size_t at = m->t.place[k];
    *ph_sym_at(m->t.a, m->t.band, at, at) += by * most;
  }
  for (size_t r = 0; m->t.rows > s->x_n && r < s->y_n; r++) {
    size_t at = s->place_y[r];
    *ph_sym_at(m->t.a, m->t.band, at, at) -= m->weights->yield;
  }
}

/* Adds parts, of which the first `hessian' make the Hessian, raised. */
static void assemble_raised(struct assembly *m, part *const *parts, size_t n,
                            size_t hessian) {
  assemble(m, parts, hessian);
  raise(m, m->weights->rounding);
  assemble(m, parts + hessian, n - hessian);
}

size_t ph_arc_kkt_negative(const struct ph_arc_system *s, const double *x,
                           const double *y, const struct ph_arc_linear *linear,
                           const struct ph_arc_weights *weights, double *matrix,
                           double *work) {
  static part *const parts[] = {clear,  intervals, knots, retraction,
                                shifts, holds,     rows};
  struct assembly m = assembly_of(s, x, y, linear, weights);
  m.t = (struct target){.a = matrix,
                        .band = s->kkt_band,
                        .place = s->place_x,
                        .symmetric = true,
                        .rows = s->kkt_n,
                        .row = ph_sym_size(1, s->kkt_band)};
  assemble_raised(&m, parts, sizeof parts / sizeof *parts, 5);
  return ph_arena_late(s->arena)
             ? SIZE_MAX
             : ph_inertia_negative(matrix, s->kkt_n, s->kkt_band, work);
}

/* The same of a penalised one. */
static bool set_penalised(struct assembly *m, double rho, double *matrix,
                          bool factored) {
  static part *const parts[] = {
      clear, intervals,        knots,        retraction, shifts,
      holds, interval_squares, knot_squares, factor};
  const struct ph_arc_system *s = m->s;
  size_t n = sizeof parts / sizeof *parts;
  m->rho = rho;
  m->t = (struct target){.a = matrix,
                         .band = s->order_band,
                         .place = s->order,
                         .symmetric = true,
                         .rows = s->x_n,
                         .row = ph_sym_size(1, s->order_band)};
  n = factored ? n : n - 1;
  if (m->weights->rounding > 0) { /* all of the diagonal is needed first */
    assemble_raised(m, parts, n, 5);
  } else {
    assemble(m, parts, n);
  }
  return m->regular && !ph_arena_late(s->arena);
}

void ph_arc_penalised(const struct ph_arc_system *s, const double *x,
                      const double *y, const struct ph_arc_linear *linear,
                      const struct ph_arc_weights *weights, double rho,
                      double *matrix) {
  struct assembly m = assembly_of(s, x, y, linear, weights);
  set_penalised(&m, rho, matrix, false);
}

bool ph_arc_penalised_factor(const struct ph_arc_system *s, const double *x,
                             const double *y,
                             const struct ph_arc_linear *linear,
                             const struct ph_arc_weights *weights, double rho,
                             double *matrix) {
  struct assembly m = assembly_of(s, x, y, linear, weights);
  return set_penalised(&m, rho, matrix, true);
}
