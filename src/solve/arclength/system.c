/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Matrices of the intervals and the order of unknowns and rows (see
 * system.h). */
#include "solve/arclength/system.h"

#include <math.h>
#include <string.h>

/* Standard deviations that are a length's deviation of weight 1. */
static const double SIGMAS = 3;

/* Integrals over [0,1] of products of the Bernstein polynomials of degree 2. */
static const double BERNSTEIN[3][3] = {{1. / 5, 1. / 10, 1. / 30},
                                       {1. / 10, 2. / 15, 1. / 10},
                                       {1. / 30, 1. / 10, 1. / 5}};

/* ---- matrices ------------------------------------------------------------ */

/* The spacing of segment q, of those beyond the ends too. */
static double spacing(const struct ph_arc_system *s, size_t q, int beyond) {
  const struct ph_arc_data *d = s->data;
  size_t last = s->segments - 1, at = q;
  if (beyond < 0) {
    at = q > 0 ? q - 1 : d->closed ? last : 0;
  } else if (beyond > 0) {
    at = q < last ? q + 1 : d->closed ? 0 : last;
  }
  return d->h[at / s->refine] / (double)s->refine;
}

void ph_arc_coefficients(const struct ph_arc_system *s, size_t q,
                         double out[3][3]) {
  double before = spacing(s, q, -1), h = spacing(s, q, 0),
         after = spacing(s, q, 1);
  memset(out, 0, 9 * sizeof(double));
  out[0][0] = h / (before + h);
  out[0][1] = before / (before + h);
  out[1][1] = 1;
  out[2][1] = after / (h + after);
  out[2][2] = h / (h + after);
}

static void set_segment(struct ph_arc_system *s, size_t q) {
  double c[3][3], h = spacing(s, q, 0), *second = s->second + 3 * q;
  size_t i = q / s->refine, at = q % s->refine, span = s->span;
  double *gram = s->gram + i * span * span;
  ph_arc_coefficients(s, q, c);
  for (size_t a = 0; a < 3; a++) {
    second[a] = 2 * (c[0][a] - 2 * c[1][a] + c[2][a]) / (h * sqrt(h));
    for (size_t b = 0; b < 3; b++) {
      double sum = 0;
      for (size_t j = 0; j < 3; j++) {
        for (size_t k = 0; k < 3; k++) {
          sum += c[j][a] * BERNSTEIN[j][k] * c[k][b];
        }
      }
      gram[(at + a) * span + at + b] += h * sum;
    }
  }
}

/* The rows of an interval are the length and the components of its step. */
static void set_targets(struct ph_arc_system *s, size_t i) {
  const struct ph_arc_data *d = s->data;
  for (size_t k = 0; k < s->forms_n; k++) {
    s->target[i * s->forms_n + k] = s->form[k] == 0   ? d->length[i]
                                    : s->form[k] == 1 ? d->step[i].x
                                    : s->form[k] == 2 ? d->step[i].y
                                                      : d->step[i].z;
  }
}

static void set_knot(struct ph_arc_system *s, size_t j) {
  size_t q = j * s->refine; /* the segment after it */
  double before = q > 0 ? spacing(s, q - 1, 0) : spacing(s, 0, 0);
  double after = q < s->segments ? spacing(s, q, 0) : before;
  s->knot[2 * j] = after / (before + after);
  s->knot[2 * j + 1] = before / (before + after);
}

/* -s_b m_a + s_a m_b = 0 of a direction: its real and imaginary parts. */
static void set_direction(struct ph_arc_system *s, size_t j) {
  double *row = s->direction + j * s->knot_rows * s->dim, w[4];
  ph_arc_spinor(s->data->given[j], w);
  if (s->dim == 4) {
    const double rows[8] = {-w[2], w[3], w[0], -w[1], -w[3], -w[2], w[1], w[0]};
    memcpy(row, rows, sizeof rows);
  } else {
    row[0] = -w[2];
    row[1] = w[0];
  }
}

/* ---- the order ----------------------------------------------------------- */

/* Blocks of intervals in the order of the matrix: those of a closed curve
 * alternate between both sides of the seam, so that neighbours in the cycle are
 * near each other in the matrix. */
static size_t block_at(const struct ph_arc_system *s, size_t position) {
  size_t n = s->data->n;
  if (!s->data->closed) {
    return position;
  }
  return position % 2 == 0 ? position / 2 : n - 1 - position / 2;
}

struct placing {
  struct ph_arc_system *s;
  uint32_t kkt, order; /* next places */
};

static void place_node(struct placing *p, size_t node) {
  for (size_t k = 0; k < p->s->dim; k++) {
    p->s->place_x[node * p->s->dim + k] = p->kkt++;
    p->s->order[node * p->s->dim + k] = p->order++;
  }
}

static void place_rows(struct placing *p, size_t first, size_t n) {
  for (size_t k = 0; k < n; k++) {
    p->s->place_y[first + k] = p->kkt++;
  }
}

static void place_all(struct ph_arc_system *s) {
  size_t n = s->data->n, r = s->refine, knots = n * s->forms_n;
  struct placing p = {s, 0, 0};
  if (s->turn) {
    s->place_x[s->x_n - 1] = p.kkt++;
    s->order[s->x_n - 1] = p.order++;
  }
  for (size_t position = 0; position < n; position++) {
    size_t i = block_at(s, position);
    place_node(&p, i * r);
    place_rows(&p, knots + i * s->knot_rows, s->knot_rows);
    for (size_t k = 1; k < r; k++) {
      place_node(&p, i * r + k);
    }
    place_rows(&p, i * s->forms_n, s->forms_n);
  }
  if (!s->data->closed) {
    place_node(&p, s->segments);
    place_rows(&p, knots + n * s->knot_rows, s->knot_rows);
    place_node(&p, s->segments + 1);
  }
}

static void widen(size_t *band, uint32_t a, uint32_t b) {
  size_t apart = a > b ? a - b : b - a;
  *band = apart > *band ? apart : *band;
}

/* Nodes of a segment meet in the Hessian, and all of an interval and its rows
 * in both matrices; of a knot the two beside it. */
static void widen_interval(struct ph_arc_system *s, size_t i) {
  size_t index[PH_ARC_LOCAL], local = ph_arc_touched(s, i), dim = s->dim;
  size_t nodes = s->span * dim;
  ph_arc_index(s, i, index);
  for (size_t a = 0; a < local; a++) {
    for (size_t b = 0; b <= a; b++) {
      bool meet = a == nodes || a / dim - b / dim <= 2;
      widen(&s->order_band, s->order[index[a]], s->order[index[b]]);
      if (meet) {
        widen(&s->kkt_band, s->place_x[index[a]], s->place_x[index[b]]);
      }
    }
    for (size_t k = 0; k < s->forms_n; k++) {
      widen(&s->kkt_band, s->place_x[index[a]], s->place_y[i * s->forms_n + k]);
    }
  }
}

static void set_bands(struct ph_arc_system *s) {
  size_t n = s->data->n, first = n * s->forms_n;
  for (size_t i = 0; i < n; i++) {
    widen_interval(s, i);
  }
  for (size_t j = 0; s->knot_rows > 0 && j <= n; j++) {
    size_t at = j * s->refine * s->dim;
    for (size_t k = 0; k < s->knot_rows; k++) {
      for (size_t a = 0; a < 2 * s->dim; a++) {
        widen(&s->kkt_band, s->place_x[at + a],
              s->place_y[first + j * s->knot_rows + k]);
      }
    }
  }
}

/* ---- the whole ----------------------------------------------------------- */

/* Which rows there are. */
static void set_rows(struct ph_arc_system *s, bool exact) {
  const struct ph_arc_data *d = s->data;
  size_t dim = s->dim;
  s->forms_n = 0;
  s->knot_rows = 0;
  if (exact) {
    s->form[s->forms_n++] = 0;
  }
  if (d->mode == PH_ARC_POINTS) {
    /* on a line the length is the step */
    for (int k = 1; k <= 3 && (dim > 1 || s->forms_n == 0); k++) {
      if (k < 3 || dim == 4) {
        s->form[s->forms_n++] = k;
      }
    }
  } else if (d->mode == PH_ARC_DERIVATIVES) {
    s->knot_rows = dim == 4 ? 3 : dim;
  } else {
    s->knot_rows = dim == 4 ? 2 : dim - 1;
  }
  s->y_n = d->n * s->forms_n + (d->n + 1) * s->knot_rows;
}

static bool allocate(struct ph_arc_system *s, struct ph_arena *arena) {
  size_t n = s->data->n, span = s->span;
  bool directed = s->data->mode == PH_ARC_TANGENTS;
  s->gram = ph_arena_array(arena, n * span * span, sizeof(double));
  s->second = ph_arena_array(arena, 3 * s->segments, sizeof(double));
  s->knot = ph_arena_array(arena, 2 * (n + 1), sizeof(double));
  s->target = ph_arena_array(arena, n * s->forms_n, sizeof(double));
  s->direction = directed
                     ? ph_arena_array(arena, (n + 1) * s->knot_rows * s->dim,
                                      sizeof(double))
                     : NULL;
  s->place_x = ph_arena_array(arena, s->x_n, sizeof(uint32_t));
  s->order = ph_arena_array(arena, s->x_n, sizeof(uint32_t));
  s->place_y = ph_arena_array(arena, s->y_n, sizeof(uint32_t));
  return s->gram && s->second && s->knot && s->target &&
         (s->direction || !directed) && s->place_x && s->order && s->place_y;
}

bool ph_arc_system_of(const struct ph_arc_data *data, size_t refine, size_t dim,
                      bool exact, struct ph_arena *arena,
                      struct ph_arc_system *s) {
  size_t n = data->n;
  *s = (struct ph_arc_system){.arena = arena,
                              .data = data,
                              .refine = refine,
                              .dim = dim,
                              .segments = n * refine,
                              .span = refine + 2,
                              .turn = data->closed && dim == 4,
                              .sign = 1};
  s->nodes = data->closed ? s->segments : s->segments + 2;
  s->x_n = s->nodes * dim + (s->turn ? 1 : 0);
  s->phases = dim == 4 && data->mode != PH_ARC_DERIVATIVES &&
              s->nodes >= PH_ARC_MANY * refine;
  set_rows(s, exact && data->length != NULL);
  s->kkt_n = s->x_n + s->y_n;
  if (s->kkt_n > UINT32_MAX) { /* its matrix would fill 2^40 bytes */
    return false;
  }
  if (!allocate(s, arena)) {
    return false;
  }
  memset(s->gram, 0, n * s->span * s->span * sizeof *s->gram);
  for (size_t q = 0; q < s->segments; q++) {
    set_segment(s, q);
  }
  for (size_t i = 0; i < n; i++) {
    set_targets(s, i);
  }
  for (size_t j = 0; j <= n; j++) {
    set_knot(s, j);
    if (s->direction && s->knot_rows) {
      set_direction(s, j);
    }
  }
  place_all(s);
  set_bands(s);
  return true;
}

/* `each' numbers of every interval of n, from one on and beyond the seam. */
static double *slice(const struct ph_arc_system *s, const double *from,
                     size_t first, size_t n, size_t each,
                     struct ph_arena *arena) {
  double *out = ph_arena_array(arena, n * each, sizeof *out);
  for (size_t i = 0; out && i < n; i++) {
    size_t at = (first + i) % s->data->n;
    memcpy(out + i * each, from + at * each, each * sizeof *out);
  }
  return out;
}

bool ph_arc_part_of(const struct ph_arc_system *s, size_t first, size_t n,
                    struct ph_arena *arena, struct ph_arc_data *data,
                    struct ph_arc_system *part) {
  const struct ph_arc_data *d = s->data;
  *data = (struct ph_arc_data){.mode = d->mode, .n = n, .line = d->line};
  *part = *s;
  part->data = data;
  part->segments = n * s->refine;
  part->nodes = part->segments + 2;
  part->turn = false;
  part->part = true;
  part->held[0] = d->closed || first > 0;
  part->held[1] = d->closed || first + n < d->n;
  part->x_n = part->nodes * s->dim;
  part->y_n = n * s->forms_n;
  part->kkt_n = part->x_n + part->y_n;
  part->kkt_band = part->order_band = 0;
  part->gram = slice(s, s->gram, first, n, s->span * s->span, arena);
  part->second = slice(s, s->second, first, n, 3 * s->refine, arena);
  part->target = slice(s, s->target, first, n, s->forms_n, arena);
  if (s->compliance) {
    part->compliance = slice(s, s->compliance, first, n, 1, arena);
  }
  part->place_x = ph_arena_array(arena, part->x_n, sizeof(uint32_t));
  part->order = ph_arena_array(arena, part->x_n, sizeof(uint32_t));
  part->place_y = ph_arena_array(arena, part->y_n, sizeof(uint32_t));
  if (!part->gram || !part->second || !part->target ||
      (s->compliance && !part->compliance) || !part->place_x || !part->order ||
      !part->place_y) {
    return false;
  }
  place_all(part);
  set_bands(part);
  return true;
}

bool ph_arc_soften(struct ph_arc_system *s, double f_relaxed,
                   struct ph_arena *arena) {
  const struct ph_arc_data *d = s->data;
  double n = (double)d->n;
  s->compliance = ph_arena_array(arena, d->n, sizeof(double));
  if (!s->compliance) {
    return false;
  }
  for (size_t i = 0; i < d->n; i++) {
    double deviation = SIGMAS * d->sigma * d->length[i];
    s->compliance[i] = deviation * deviation * n / (2 * f_relaxed);
  }
  return true;
}

bool ph_arc_linear_alloc(const struct ph_arc_system *s, struct ph_arena *arena,
                         struct ph_arc_linear *linear) {
  size_t n = s->data->n;
  linear->c = ph_arena_array(arena, s->y_n, sizeof(double));
  linear->f_x = ph_arena_array(arena, s->x_n, sizeof(double));
  linear->l_x = ph_arena_array(arena, s->x_n, sizeof(double));
  linear->rows =
      ph_arena_array(arena, n * s->forms_n * ph_arc_local(s), sizeof(double));
  linear->knot_rows = ph_arena_array(arena, (n + 1) * s->knot_rows * 2 * s->dim,
                                     sizeof(double));
  return linear->c && linear->f_x && linear->l_x && linear->rows &&
         linear->knot_rows;
}

void ph_arc_index(const struct ph_arc_system *s, size_t interval,
                  size_t *index) {
  for (size_t a = 0; a < s->span; a++) {
    size_t node = interval * s->refine + a;
    node = node < s->nodes ? node : node - s->nodes;
    for (size_t k = 0; k < s->dim; k++) {
      index[a * s->dim + k] = node * s->dim + k;
    }
  }
  if (s->turn) {
    index[s->span * s->dim] = s->x_n - 1;
  }
}
