/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Rows, functional and their first derivatives (see system.h). */
#include "solve/arclength/system.h"

#include <math.h>
#include <string.h>

/* ---- an interval --------------------------------------------------------- */

/* gw = G w: G vanishes at |a - b| > 2. */
static void set_gram_times(const struct ph_arc_system *s,
                           struct ph_arc_piece *p) {
  size_t span = s->span, dim = s->dim;
  const double *gram = s->gram + p->interval * span * span;
  for (size_t a = 0; a < span; a++) {
    size_t from = a > 2 ? a - 2 : 0, to = a + 2 < span ? a + 2 : span - 1;
    for (size_t k = 0; k < dim; k++) {
      double sum = 0;
      for (size_t b = from; b <= to; b++) {
        sum += gram[a * span + b] * p->w[b * dim + k];
      }
      p->gw[a * dim + k] = sum;
    }
  }
}

void ph_arc_piece_of(const struct ph_arc_system *s, const double *x, size_t i,
                     struct ph_arc_piece *p) {
  size_t dim = s->dim, first = i * s->refine;
  p->interval = i;
  p->inside = s->span;
  p->cosine = s->sign;
  p->sine = 0;
  if (ph_arc_wraps(s, i)) {
    p->inside = s->nodes - first;
    if (s->turn) {
      p->cosine = cos(x[s->x_n - 1]);
      p->sine = sin(x[s->x_n - 1]);
    }
  }
  memcpy(p->w, x + first * dim, p->inside * dim * sizeof *p->w);
  for (size_t a = p->inside; a < s->span; a++) {
    const double *w = x + (first + a - s->nodes) * dim;
    if (s->turn) {
      ph_arc_phase(p->cosine, p->sine, w, p->w + a * dim);
    } else {
      for (size_t k = 0; k < dim; k++) {
        p->w[a * dim + k] = p->cosine * w[k];
      }
    }
  }
  set_gram_times(s, p);
}

/* piece_row() of dim components, a constant to the compiler. */
static inline double row_of(size_t dim, size_t span,
                            const struct ph_arc_piece *p, int form,
                            double *gradient) {
  double sum = 0;
  for (size_t a = 0; a < span; a++) {
    double v[4];
    ph_arc_form(dim, form, p->gw + a * dim, v);
    sum += ph_arc_dot(dim, p->w + a * dim, v);
    for (size_t k = 0; gradient && k < dim; k++) {
      gradient[a * dim + k] = 2 * v[k];
    }
  }
  return sum;
}

/* w . S_k G w.
 * out gradient  [span][dim] its derivative by the nodes; or NULL */
static double piece_row(const struct ph_arc_system *s,
                        const struct ph_arc_piece *p, int form,
                        double *gradient) {
  if (s->dim != 4) {
    return row_of(s->dim, s->span, p, form, gradient);
  }
  return form == 0   ? row_of(4, s->span, p, 0, gradient)
         : form == 1 ? row_of(4, s->span, p, 1, gradient)
         : form == 2 ? row_of(4, s->span, p, 2, gradient)
                     : row_of(4, s->span, p, 3, gradient);
}

void ph_arc_piece_back(const struct ph_arc_system *s,
                       const struct ph_arc_piece *p, double *v) {
  size_t dim = s->dim;
  double chi = 0;
  for (size_t a = p->inside; a < s->span; a++) {
    double *at = v + a * dim, iw[4];
    if (s->turn) {
      ph_arc_turned(p->w + a * dim, iw);
      chi += ph_arc_dot(4, iw, at);
      ph_arc_phase(p->cosine, -p->sine, at, at);
    } else {
      for (size_t k = 0; k < dim; k++) {
        at[k] *= p->cosine;
      }
    }
  }
  if (s->turn && p->inside < s->span) {
    v[s->span * dim] = chi;
  }
}

/* The rows as whitened: `stride' columns of n, of which there are 3 or 4. */
static void whiten(const struct ph_arc_system *s, size_t i, double *restrict c,
                   size_t stride) {
  size_t n = s->forms_n;
  const double *restrict white = s->white + i * n * n;
  double *restrict c1 = c + stride, *restrict c2 = c1 + stride;
  for (size_t at = 0; n == 3 && at < stride; at++) {
    double v0 = c[at], v1 = c1[at], v2 = c2[at];
    c[at] = white[0] * v0 + white[1] * v1 + white[2] * v2;
    c1[at] = white[3] * v0 + white[4] * v1 + white[5] * v2;
    c2[at] = white[6] * v0 + white[7] * v1 + white[8] * v2;
  }
  if (n == 4) {
    double *restrict c3 = c2 + stride;
    for (size_t at = 0; at < stride; at++) {
      double v0 = c[at], v1 = c1[at], v2 = c2[at], v3 = c3[at];
      c[at] = white[0] * v0 + white[1] * v1 + white[2] * v2 + white[3] * v3;
      c1[at] = white[4] * v0 + white[5] * v1 + white[6] * v2 + white[7] * v3;
      c2[at] = white[8] * v0 + white[9] * v1 + white[10] * v2 + white[11] * v3;
      c3[at] =
          white[12] * v0 + white[13] * v1 + white[14] * v2 + white[15] * v3;
    }
  }
}

/* Residuals of the rows of an interval, and their gradients unless NULL. */
static void interval_rows(const struct ph_arc_system *s,
                          const struct ph_arc_piece *p, double *c,
                          double *rows) {
  size_t n = s->forms_n, local = ph_arc_local(s), i = p->interval;
  for (size_t k = 0; k < n; k++) {
    double *row = rows ? rows + k * local : NULL;
    c[k] = piece_row(s, p, s->form[k], row) - s->target[i * n + k];
    if (row) {
      row[local - 1] = s->turn ? 0 : row[local - 1];
      ph_arc_piece_back(s, p, row);
    }
  }
  if (s->white) {
    whiten(s, i, c, 1);
    if (rows) {
      whiten(s, i, rows, local);
    }
  }
}

/* ---- a knot -------------------------------------------------------------- */

static void knot_value(const struct ph_arc_system *s, const double *x, size_t j,
                       double *m) {
  const double *w = x + j * s->refine * s->dim;
  for (size_t k = 0; k < s->dim; k++) {
    m[k] = s->knot[2 * j] * w[k] + s->knot[2 * j + 1] * w[s->dim + k];
  }
}

/* Residuals of the rows of a knot, and their gradients unless NULL. */
static void knot_rows(const struct ph_arc_system *s, const double *x, size_t j,
                      double *c, double *rows) {
  size_t dim = s->dim;
  double m[4];
  knot_value(s, x, j, m);
  for (size_t k = 0; k < s->knot_rows; k++) {
    double v[4];
    if (s->direction) {
      memcpy(v, s->direction + (j * s->knot_rows + k) * dim, dim * sizeof *v);
      c[k] = ph_arc_dot(dim, v, m);
    } else {
      ph_vec3 d = s->data->given[j];
      ph_arc_form(dim, (int)k + 1, m, v);
      c[k] = ph_arc_dot(dim, v, m) - (k == 0 ? d.x : k == 1 ? d.y : d.z);
      for (size_t a = 0; a < dim; a++) {
        v[a] *= 2;
      }
    }
    for (size_t a = 0; rows && a < dim; a++) {
      rows[k * 2 * dim + a] = s->knot[2 * j] * v[a];
      rows[k * 2 * dim + dim + a] = s->knot[2 * j + 1] * v[a];
    }
  }
}

void ph_arc_retract_rows(const struct ph_arc_system *s, const double *x,
                         const double *dx, double step, const double *y,
                         const double *dy, double *to) {
  size_t knots = s->data->n * s->forms_n;
  size_t rows = s->phases && s->direction ? knots : s->y_n;
  for (size_t r = 0; r < rows; r++) {
    to[r] = y[r] + step * dy[r];
  }
  for (size_t r = rows; r < s->y_n; r += 2) {
    double m[4], dm[4], im[4], size, p, u, v;
    knot_value(s, x, (r - knots) / 2, m);
    knot_value(s, dx, (r - knots) / 2, dm);
    size = ph_arc_dot(4, m, m);
    ph_arc_turned(m, im);
    p = size > 0 ? ph_arc_dot(4, im, dm) / size : 0;
    u = y[r] + step * (dy[r] + p * y[r + 1]);
    v = y[r + 1] + step * (dy[r + 1] - p * y[r]);
    to[r] = cos(step * p) * u - sin(step * p) * v;
    to[r + 1] = sin(step * p) * u + cos(step * p) * v;
  }
}

void ph_arc_yield(const struct ph_arc_system *s, const double *x, double *y) {
  for (size_t j = 0; s->knot_compliance && j <= s->data->n; j++) {
    double soft = s->knot_compliance[j], c[3];
    knot_rows(s, x, j, c, NULL);
    for (size_t k = 0; soft > 0 && k < s->knot_rows; k++) {
      y[s->data->n * s->forms_n + j * s->knot_rows + k] = c[k] / soft;
    }
  }
}

double ph_arc_deviation(const struct ph_arc_system *s, const double *x,
                        size_t j) {
  double m[4], off = 0, size;
  knot_value(s, x, j, m);
  size = ph_arc_dot(s->dim, m, m);
  for (size_t k = 0; s->direction && k < s->knot_rows; k++) {
    double c =
        ph_arc_dot(s->dim, s->direction + (j * s->knot_rows + k) * s->dim, m);
    off += c * c;
  }
  return size > PH_ARC_STANDSTILL
             ? 2 * atan2(sqrt(off), sqrt(fmax(size - off, 0)))
             : (double)NAN;
}

/* ---- the functional ------------------------------------------------------ */

/* F of an interval, and its gradient by the nodes unless NULL. */
static double interval_functional(const struct ph_arc_system *s,
                                  const struct ph_arc_piece *p,
                                  double *gradient) {
  size_t dim = s->dim;
  double sum = 0;
  if (gradient) {
    memset(gradient, 0, ph_arc_local(s) * sizeof *gradient);
  }
  for (size_t q = 0; q < s->refine; q++) {
    const double *e = s->second + 3 * (p->interval * s->refine + q);
    const double *w = p->w + q * dim;
    for (size_t k = 0; k < dim; k++) {
      double z = e[0] * w[k] + e[1] * w[dim + k] + e[2] * w[2 * dim + k];
      sum += z * z;
      for (size_t a = 0; gradient && a < 3; a++) {
        gradient[(q + a) * dim + k] += 2 * e[a] * z;
      }
    }
  }
  return sum;
}

double ph_arc_functional(const struct ph_arc_system *s, const double *x) {
  double sum = 0;
  for (size_t i = 0; i < s->data->n; i++) {
    struct ph_arc_piece p;
    ph_arc_piece_of(s, x, i, &p);
    sum += interval_functional(s, &p, NULL);
  }
  return sum;
}

/* ---- all ----------------------------------------------------------------- */

void ph_arc_residual(const struct ph_arc_system *s, const double *x,
                     double *c) {
  size_t n = s->data->n;
  for (size_t i = 0; s->forms_n > 0 && i < n; i++) {
    struct ph_arc_piece p;
    ph_arc_piece_of(s, x, i, &p);
    interval_rows(s, &p, c + i * s->forms_n, NULL);
  }
  for (size_t j = 0; s->knot_rows > 0 && j <= n; j++) {
    knot_rows(s, x, j, c + n * s->forms_n + j * s->knot_rows, NULL);
  }
}

double ph_arc_interval(const struct ph_arc_system *s, const double *x, size_t i,
                       double *c) {
  size_t first = s->data->n * s->forms_n;
  struct ph_arc_piece p;
  ph_arc_piece_of(s, x, i, &p);
  if (s->forms_n > 0) {
    interval_rows(s, &p, c + i * s->forms_n, NULL);
  }
  for (size_t j = i; s->knot_rows > 0 && j < ph_arc_knots_end(s, i); j++) {
    knot_rows(s, x, j, c + first + j * s->knot_rows, NULL);
  }
  return interval_functional(s, &p, NULL);
}

void ph_arc_lengths(const struct ph_arc_system *s, const double *x,
                    double *length) {
  for (size_t i = 0; i < s->data->n; i++) {
    struct ph_arc_piece p;
    ph_arc_piece_of(s, x, i, &p);
    length[i] = piece_row(s, &p, 0, NULL);
  }
}

static void scatter(const struct ph_arc_system *s, size_t i, const double *v,
                    double *out) {
  size_t index[PH_ARC_LOCAL], touched = ph_arc_touched(s, i);
  ph_arc_index(s, i, index);
  for (size_t a = 0; a < touched; a++) {
    out[index[a]] += v[a];
  }
}

/* out += sum_k v_k (gradient of row k), of the rows of interval i. */
static void add_interval_rows(const struct ph_arc_system *s,
                              const struct ph_arc_linear *linear, size_t i,
                              const double *v, double *out) {
  size_t local = ph_arc_local(s);
  const double *row = linear->rows + i * s->forms_n * local;
  double sum[PH_ARC_LOCAL] = {0};
  for (size_t k = 0; k < s->forms_n; k++) {
    for (size_t a = 0; a < local; a++) {
      sum[a] += v[i * s->forms_n + k] * row[k * local + a];
    }
  }
  scatter(s, i, sum, out);
}

/* The same of knot j. */
static void add_knot_rows(const struct ph_arc_system *s,
                          const struct ph_arc_linear *linear, size_t j,
                          const double *v, double *out) {
  size_t dim = s->dim, first = s->data->n * s->forms_n;
  double *at = out + j * s->refine * dim;
  for (size_t k = 0; k < s->knot_rows; k++) {
    size_t r = j * s->knot_rows + k;
    for (size_t a = 0; a < 2 * dim; a++) {
      at[a] += v[first + r] * linear->knot_rows[r * 2 * dim + a];
    }
  }
}

void ph_arc_add_rows(const struct ph_arc_system *s,
                     const struct ph_arc_linear *linear, const double *v,
                     double *out) {
  size_t n = s->data->n;
  for (size_t i = 0; s->forms_n > 0 && i < n; i++) {
    add_interval_rows(s, linear, i, v, out);
  }
  for (size_t j = 0; s->knot_rows > 0 && j <= n; j++) {
    add_knot_rows(s, linear, j, v, out);
  }
}

void ph_arc_add_rows_of(const struct ph_arc_system *s,
                        const struct ph_arc_linear *linear, size_t i,
                        const double *v, double *out) {
  add_interval_rows(s, linear, i, v, out);
  for (size_t j = i; j < ph_arc_knots_end(s, i); j++) {
    add_knot_rows(s, linear, j, v, out);
  }
}

/* out = J v, of the rows of interval i. */
static void interval_times(const struct ph_arc_system *s,
                           const struct ph_arc_linear *linear, size_t i,
                           const double *v, double *out) {
  size_t index[PH_ARC_LOCAL], touched = ph_arc_touched(s, i);
  size_t local = ph_arc_local(s);
  ph_arc_index(s, i, index);
  for (size_t k = 0; k < s->forms_n; k++) {
    const double *row = linear->rows + (i * s->forms_n + k) * local;
    double sum = 0;
    for (size_t a = 0; a < touched; a++) {
      sum += row[a] * v[index[a]];
    }
    out[i * s->forms_n + k] = sum;
  }
}

/* The same of knot j. */
static void knot_times(const struct ph_arc_system *s,
                       const struct ph_arc_linear *linear, size_t j,
                       const double *v, double *out) {
  size_t dim = s->dim, first = s->data->n * s->forms_n;
  for (size_t k = 0; k < s->knot_rows; k++) {
    size_t r = j * s->knot_rows + k;
    out[first + r] = ph_arc_dot(2 * dim, linear->knot_rows + r * 2 * dim,
                                v + j * s->refine * dim);
  }
}

void ph_arc_rows_times(const struct ph_arc_system *s,
                       const struct ph_arc_linear *linear, const double *v,
                       double *out) {
  size_t n = s->data->n;
  for (size_t i = 0; s->forms_n > 0 && i < n; i++) {
    interval_times(s, linear, i, v, out);
  }
  for (size_t j = 0; s->knot_rows > 0 && j <= n; j++) {
    knot_times(s, linear, j, v, out);
  }
}

void ph_arc_rows_times_of(const struct ph_arc_system *s,
                          const struct ph_arc_linear *linear, size_t i,
                          const double *v, double *out) {
  interval_times(s, linear, i, v, out);
  for (size_t j = i; j < ph_arc_knots_end(s, i); j++) {
    knot_times(s, linear, j, v, out);
  }
}

void ph_arc_linearise(const struct ph_arc_system *s, const double *x,
                      const double *y, struct ph_arc_linear *linear) {
  size_t n = s->data->n, local = ph_arc_local(s), dim = s->dim;
  linear->f = 0;
  memset(linear->f_x, 0, s->x_n * sizeof *linear->f_x);
  for (size_t i = 0; i < n; i++) {
    struct ph_arc_piece p;
    double gradient[PH_ARC_LOCAL];
    ph_arc_piece_of(s, x, i, &p);
    linear->f += interval_functional(s, &p, gradient);
    ph_arc_piece_back(s, &p, gradient);
    scatter(s, i, gradient, linear->f_x);
    interval_rows(s, &p, linear->c + i * s->forms_n,
                  linear->rows + i * s->forms_n * local);
  }
  for (size_t j = 0; s->knot_rows > 0 && j <= n; j++) {
    knot_rows(s, x, j, linear->c + n * s->forms_n + j * s->knot_rows,
              linear->knot_rows + j * s->knot_rows * 2 * dim);
  }
  memcpy(linear->l_x, linear->f_x, s->x_n * sizeof *linear->l_x);
  ph_arc_add_rows(s, linear, y, linear->l_x);
}

void ph_arc_retract_node(const struct ph_arc_system *s, const double *x,
                         const double *dx, double step, size_t j, double *to) {
  const double *w = x + j * s->dim, *d = dx + j * s->dim;
  double iw[4], v[4], p, size;
  if (s->dim != 4) {
    for (size_t k = 0; k < s->dim; k++) {
      to[j * s->dim + k] = w[k] + step * d[k];
    }
    return;
  }
  size = ph_arc_dot(4, w, w);
  ph_arc_turned(w, iw);
  p = size > 0 ? step * ph_arc_dot(4, iw, d) / size : 0;
  for (size_t k = 0; k < 4; k++) {
    v[k] = w[k] + step * d[k] - p * iw[k];
  }
  ph_arc_phase(cos(p), sin(p), v, to + 4 * j);
}

void ph_arc_retract(const struct ph_arc_system *s, const double *x,
                    const double *dx, double step, double *to) {
  for (size_t j = 0; j < s->nodes; j++) {
    ph_arc_retract_node(s, x, dx, step, j, to);
  }
  if (s->turn) {
    to[s->x_n - 1] = x[s->x_n - 1] + step * dx[s->x_n - 1];
  }
}
