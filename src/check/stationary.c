/* SPDX-License-Identifier: GPL-3.0-or-later */
/* First and second order of a curve under constraints (see stationary.h). */
#include "check/stationary.h"

#include "base/sum.h"
#include "check/error.h"
#include "kernel/inertia.h"
#include "check/kkt.h"

#include <float.h>
#include <math.h>
#include <string.h>

/* Rounding of the elimination, in units of the largest element of the Hessian;
 * and what a gradient that does not quite vanish makes of directions in which
 * nothing changes, in units of |gradient| / |w|. */
enum { ROUND_HESSIAN = 4096, ROUND_GRADIENT = 16 };

/* Columns of J^T that are this small, once those before are taken out of them,
 * depend on these: so do lengths and points along a straight line. */
static const double DEPENDENT = 1e-13;

/* A length that yields less than this to its multiplier, and does, has no
 * digits to tell it, and counts as exact for that. */
static const double STIFF = 1e-8;

/* The smallest F that lengths are weighed by, in the mean of what is given. */
static const double F_SMALLEST = 1e-12;

/* What a place is that has no column of J^T: an unknown, or a length that
 * yields, whose multiplier is known. */
#define UNKNOWN UINT32_MAX
#define YIELDS (UINT32_MAX - 1)

struct context {
  struct ph_kkt kkt;
  double *compliance; /* [places] c - compliance y = 0; else 0 */
  double *excess;     /* [places] c of lengths that yield; else 0 */
  uint32_t *column;   /* [places] of J^T, or UNKNOWN or YIELDS */
  size_t columns;
};

/* ---- lengths that yield ------------------------------------------------ */

static void set_compliance(struct context *c,
                           const struct ph_stationary_soft *soft) {
  const struct ph_spinor *s = &c->kkt.spline;
  double n = (double)s->rows.n, sum = 0, f;
  memset(c->compliance, 0, c->kkt.n * sizeof *c->compliance);
  for (size_t i = 0; soft->length && i < s->rows.n; i++) {
    sum += soft->length[i];
  }
  f = ph_check_larger(soft->f_relaxed, F_SMALLEST * sum / n) / s->unit;
  for (size_t i = 0; soft->length && i < s->rows.n; i++) {
    double deviation = soft->sigma * soft->length[i] / s->unit;
    c->compliance[c->kkt.row[i * ph_spinor_interval_rows(s)]] =
        4.5 * n / f * deviation * deviation;
  }
}

/* How much longer the intervals are than they should be, at their places. */
static void set_excess(struct context *c,
                       const struct ph_stationary_soft *soft) {
  const struct ph_spinor *s = &c->kkt.spline;
  memset(c->excess, 0, c->kkt.n * sizeof *c->excess);
  for (size_t k = 0; soft->length && k < s->segments; k++) {
    struct ph_spinor_element e = ph_spinor_element_of(s, k);
    double *excess = &c->excess[c->kkt.row[e.row]];
    if (k % s->rows.refine == 0) {
      *excess = -soft->length[k / s->rows.refine] / s->unit;
    }
    for (size_t a = 0; a < e.nodes; a++) {
      *excess += ph_quat_dot(s->w[k + a], ph_spinor_product(s, &e, a));
    }
  }
}

/* Directions that were measured: their form is a term of what is minimised, its
 * stiffness the multiplier, and nothing is prescribed. */
static void add_directions(struct context *c,
                           const struct ph_stationary_soft *soft) {
  struct ph_kkt *kkt = &c->kkt;
  const struct ph_spinor *s = &kkt->spline;
  size_t first = s->rows.n * ph_spinor_interval_rows(s);
  for (size_t j = 0; soft->stiffness && j <= s->rows.n; j++) {
    size_t i = kkt->row[first + j * s->rows.knot_rows];
    if (soft->stiffness[j] > 0) {
      kkt->y[i] = soft->stiffness[j] / s->unit;
      for (size_t p = ph_kkt_first(kkt, i); p < ph_kkt_end(kkt, i); p++) {
        if (c->column[p] == UNKNOWN) {
          kkt->g[p] += kkt->y[i] * *ph_kkt_at(kkt, i, p);
        }
        *ph_kkt_at(kkt, i, p) = 0;
      }
      c->column[i] = YIELDS;
      c->excess[i] = 0;
      c->compliance[i] = 1;
    }
  }
}

/* Their multipliers, and what these add to g. */
static void add_yielding(struct context *c) {
  struct ph_kkt *kkt = &c->kkt;
  for (size_t i = 0; i < kkt->n; i++) {
    if (c->column[i] == YIELDS) {
      kkt->y[i] = c->excess[i] / c->compliance[i];
      for (size_t p = ph_kkt_first(kkt, i); p < ph_kkt_end(kkt, i); p++) {
        if (c->column[p] == UNKNOWN) {
          kkt->g[p] += kkt->y[i] * *ph_kkt_at(kkt, i, p);
        }
      }
    }
  }
}

/* ---- multipliers ------------------------------------------------------- */

/* The upper triangle R of J^T, and what becomes of -g. */
struct factor {
  size_t width; /* of a row of R */
  double *r;    /* [columns][width] from the diagonal on */
  double *d;    /* [columns] */
  double *size; /* [columns] squares of the columns of J^T */
  double *v;    /* [columns + width] the row that is taken in; else 0 */
};

/* Numbers the columns, and says how many there may be in 2 band + 1 places: R
 * has no more in a row. */
static size_t set_columns(struct context *c) {
  const struct ph_kkt *kkt = &c->kkt;
  size_t first = 0, inside = 0, width = 1;
  c->columns = 0;
  for (size_t i = 0; i < kkt->n; i++) {
    if (!kkt->is_row[i]) {
      c->column[i] = UNKNOWN;
    } else if (c->compliance[i] >= STIFF || fabs(c->excess[i]) >= STIFF) {
      c->column[i] = YIELDS;
    } else {
      c->column[i] = (uint32_t)c->columns++;
      inside++;
    }
    for (; first + 2 * kkt->band < i; first++) {
      inside -= c->column[first] < YIELDS;
    }
    width = inside > width ? inside : width;
  }
  return width;
}

/* Turns two rows so that the first element of v vanishes. */
static void rotate(double *r, double *d, double *v, double *rest,
                   size_t width) {
  double size = hypot(r[0], v[0]), cosine, sine, before = *d;
  if (!(size > 0)) {
    return;
  }
  cosine = r[0] / size;
  sine = v[0] / size;
  for (size_t i = 0; i < width; i++) {
    double x = r[i], y = v[i];
    r[i] = cosine * x + sine * y;
    v[i] = cosine * y - sine * x;
  }
  v[0] = 0;
  *d = cosine * before + sine * *rest;
  *rest = cosine * *rest - sine * before;
}

/* Takes the row of J^T at place p into R; columns up to *end occurred. */
static void take_in(const struct context *c, struct factor *f, size_t p,
                    size_t *end) {
  const struct ph_kkt *kkt = &c->kkt;
  double rest = -kkt->g[p];
  size_t begin = c->columns;
  for (size_t i = ph_kkt_first(kkt, p); i < ph_kkt_end(kkt, p); i++) {
    size_t column = c->column[i];
    double x = column < YIELDS ? *ph_kkt_at(kkt, i, p) : 0;
    if (x < 0 || x > 0) {
      f->v[column] = x;
      f->size[column] += x * x;
      begin = column < begin ? column : begin;
      *end = column < *end ? *end : column + 1;
    }
  }
  for (size_t i = begin; i < *end; i++) {
    if (f->v[i] < 0 || f->v[i] > 0) {
      rotate(f->r + i * f->width, &f->d[i], f->v + i, &rest, f->width);
    }
  }
}

/* y = R^-1 d, 0 for rows that depend on others: these are taken out of the
 * matrix. */
static void solve_back(struct context *c, struct factor *f) {
  struct ph_kkt *kkt = &c->kkt;
  for (size_t i = kkt->n; i-- > 0;) {
    size_t column = c->column[i];
    if (column < YIELDS) {
      const double *r = f->r + column * f->width;
      double sum = f->d[column];
      for (size_t j = 1; j < f->width && column + j < c->columns; j++) {
        sum -= r[j] * f->d[column + j];
      }
      if (fabs(r[0]) > DEPENDENT * sqrt(f->size[column])) {
        f->d[column] = sum / r[0];
      } else {
        f->d[column] = 0;
        for (size_t p = ph_kkt_first(kkt, i); p < ph_kkt_end(kkt, i); p++) {
          *ph_kkt_at(kkt, i, p) = 0;
        }
        c->compliance[i] = 1;
      }
      kkt->y[i] = f->d[column];
    }
  }
}

static double *zeros(struct ph_arena *arena, size_t n) {
  double *v = ph_arena_array(arena, n, sizeof *v);
  if (v) {
    memset(v, 0, n * sizeof *v);
  }
  return v;
}

static bool find_multipliers(struct context *c,
                             const struct ph_stationary_soft *soft,
                             struct ph_arena *arena) {
  struct factor f = {.width = set_columns(c)};
  size_t end = 0;
  f.r = zeros(arena, c->columns * f.width);
  f.d = zeros(arena, c->columns);
  f.size = zeros(arena, c->columns);
  f.v = zeros(arena, c->columns + f.width);
  if (!f.r || !f.d || !f.size || !f.v) {
    return false;
  }
  add_yielding(c);
  add_directions(c, soft);
  for (size_t p = 0; p < c->kkt.n; p++) {
    if (c->column[p] == UNKNOWN) {
      take_in(c, &f, p, &end);
    }
  }
  solve_back(c, &f);
  return true;
}

/* ---- first order ------------------------------------------------------- */

/* The functional, and what rounding of the nodes can make of it. */
static void measure_f(const struct ph_spinor *s, struct ph_stationary *out) {
  struct ph_sum sum = {0, 0};
  double rounding = 0, f;
  for (size_t k = 0; k < s->segments; k++) {
    struct ph_spinor_element e = ph_spinor_element_of(s, k);
    ph_quat second = ph_spinor_second(s, &e);
    double size = 0;
    for (size_t a = 0; a < 3; a++) {
      size += 4 * DBL_EPSILON * fabs(e.second[a]) * ph_quat_abs(s->w[k + a]);
    }
    ph_sum_add(&sum, ph_quat_dot(second, second));
    rounding += size * size;
  }
  f = ph_sum_value(&sum);
  out->f = f * s->unit;
  out->f_rounding = (2 * sqrt(f * rounding) + rounding) * s->unit;
}

/* Whether an element is a direction that was measured. */
static bool is_measured(const struct ph_spinor_element *e) {
  return e->nodes == 2 && e->form[0].s > 0;
}

/* The size of the gradient by node a of what it adds: most of its form cancels.
 */
static double pull_of(const struct context *c,
                      const struct ph_spinor_element *e, size_t a) {
  ph_quat product = ph_spinor_product(&c->kkt.spline, e, a);
  return is_measured(e)
             ? c->kkt.y[c->kkt.row[e->row]] *
                   ph_quat_abs(ph_spinor_gradient(e->form[0], product))
             : 0;
}

/* The multipliers of an element's rows, by what their terms are of: of lengths
 * that yield, that is of what is minimised, and of others. */
static void sizes_of(const struct context *c, const struct ph_spinor_element *e,
                     double *soft, double *hard) {
  *soft = *hard = 0;
  for (size_t i = 0; i < e->rows; i++) {
    size_t row = c->kkt.row[e->row + i];
    double size = fabs(c->kkt.y[row]);
    *(c->compliance[row] > 0 && !is_measured(e) ? soft : hard) += size;
  }
}

/* Adds the largest terms of an element at its nodes: those of the gradient of
 * what is minimised, and the root of epsilon times those in which rounding
 * occurs. */
static void add_terms(const struct context *c,
                      const struct ph_spinor_element *e, double *terms) {
  const struct ph_spinor *s = &c->kkt.spline;
  double second = ph_quat_abs(ph_spinor_second(s, e)),
         small = sqrt(DBL_EPSILON);
  double size = 0, soft, hard;
  sizes_of(c, e, &soft, &hard);
  for (size_t a = 0; a < e->nodes; a++) {
    size += fabs(e->second[a]) * ph_quat_abs(s->w[e->first + a]);
  }
  for (size_t a = 0; a < e->nodes; a++) {
    double sum =
        fabs(e->second[a]) * (second + small * size) + pull_of(c, e, a);
    for (size_t b = 0; b < e->nodes; b++) {
      sum += (soft + small * hard) * fabs(e->gram[a][b]) *
             ph_quat_abs(s->w[e->first + b]);
    }
    terms[ph_kkt_stored(&c->kkt, e->first + a)] += 2 * sum;
  }
}

/* g becomes g + J^T y; what is left of it, also relative to the largest terms.
 */
static double rest_of(struct context *c, double *terms, double *left) {
  struct ph_kkt *kkt = &c->kkt;
  const struct ph_spinor *s = &kkt->spline;
  double rest = 0, largest = 0;
  for (size_t k = 0; k < ph_spinor_elements(s); k++) {
    struct ph_spinor_element e = ph_spinor_element_of(s, k);
    add_terms(c, &e, terms);
  }
  for (size_t i = 0; i < kkt->n; i++) {
    for (size_t p = ph_kkt_first(kkt, i);
         c->column[i] < YIELDS && p < ph_kkt_end(kkt, i); p++) {
      if (c->column[p] == UNKNOWN) {
        kkt->g[p] += kkt->y[i] * *ph_kkt_at(kkt, i, p);
      }
    }
  }
  for (size_t j = 0; j < s->stored; j++) {
    const double *g = kkt->g + kkt->node[j];
    double size = ph_quat_abs(ph_quat_of(g[0], g[1], g[2], g[3]));
    rest = ph_check_is_larger(size, rest) ? size : rest;
    largest = ph_check_larger(largest, terms[j]);
  }
  if (ph_kkt_has_chi(kkt)) {
    double chi = fabs(kkt->g[0]) / sqrt(s->largest);
    rest = ph_check_is_larger(chi, rest) ? chi : rest;
  }
  *left = rest;
  return rest / largest;
}

/* ---- second order ------------------------------------------------------ */

/* Rows that yield, or that depend on others: [J; -compliance], scaled. */
static void set_yielding(struct context *c) {
  struct ph_kkt *kkt = &c->kkt;
  for (size_t i = 0; i < kkt->n; i++) {
    double yields = c->compliance[i], scale = 1 / sqrt(1 + yields);
    if (yields > 0) {
      for (size_t p = ph_kkt_first(kkt, i); p < ph_kkt_end(kkt, i); p++) {
        *ph_kkt_at(kkt, i, p) *= scale;
      }
      *ph_kkt_at(kkt, i, i) = -yields * scale * scale;
    }
  }
}

/* Fixes the common phase where the elimination begins, by weight n n^T with
 * n = w i / |w| at the largest node there: not later, or all leading minors
 * before that would be those of singular matrices. */
static void pin(struct ph_kkt *kkt, double weight) {
  size_t node = 0, at;
  double size = 0, n[4];
  ph_quat w;
  for (size_t j = 0; j < 3 && j < kkt->spline.stored; j++) {
    w = kkt->spline.w[j];
    if (ph_quat_dot(w, w) > size) {
      size = ph_quat_dot(w, w);
      node = j;
    }
  }
  w = kkt->spline.w[node];
  at = kkt->node[node];
  n[0] = -w.v;
  n[1] = w.u;
  n[2] = w.q;
  n[3] = -w.p;
  for (size_t i = 0; size > 0 && i < 4; i++) {
    for (size_t j = 0; j <= i; j++) {
      *ph_kkt_at(kkt, at + i, at + j) += weight / size * n[i] * n[j];
    }
  }
}

/* Whether the matrix has as many negative eigenvalues as rows.
 * in left  |g + J^T y| */
static bool is_minimum(struct context *c, double left, double *work) {
  struct ph_kkt *kkt = &c->kkt;
  double largest = 0, shift;
  set_yielding(c);
  ph_kkt_add_hessian(kkt);
  for (size_t i = 0; i < kkt->n; i++) {
    if (!kkt->is_row[i]) {
      largest = ph_check_larger(largest, fabs(*ph_kkt_at(kkt, i, i)));
    }
  }
  shift = ROUND_HESSIAN * DBL_EPSILON * largest +
          ROUND_GRADIENT * left / sqrt(kkt->spline.largest);
  for (size_t i = 0; i < kkt->n; i++) {
    *ph_kkt_at(kkt, i, i) += kkt->is_row[i] ? 0 : shift;
  }
  pin(kkt, largest);
  return ph_inertia_negative(kkt->matrix, kkt->n, kkt->band, work) == kkt->rows;
}

/* Both, in memory that the caller gives back. */
static enum ph_status find(const struct ph_curve *curve,
                           const struct ph_spinor_rows *rows,
                           const struct ph_stationary_soft *soft,
                           struct ph_arena *arena, struct ph_stationary *out,
                           struct ph_diag *diag) {
  struct context c;
  double *terms, *work, left;
  enum ph_status status = ph_spinor_of(curve, rows, arena, &c.kkt.spline, diag);
  if (status != PH_OK) {
    return status;
  }
  measure_f(&c.kkt.spline, out);
  terms = zeros(arena, c.kkt.spline.stored);
  if (!terms || !ph_kkt_of(&c.kkt, arena)) {
    return ph_fail_memory(diag);
  }
  c.compliance = ph_arena_array(arena, c.kkt.n, sizeof *c.compliance);
  c.column = ph_arena_array(arena, c.kkt.n, sizeof *c.column);
  work = zeros(arena, ph_inertia_size(c.kkt.band));
  c.excess = ph_arena_array(arena, c.kkt.n, sizeof *c.excess);
  if (!c.compliance || !c.column || !c.excess || !work) {
    return ph_fail_memory(diag);
  }
  set_compliance(&c, soft);
  set_excess(&c, soft);
  if (!find_multipliers(&c, soft, arena)) {
    return ph_fail_memory(diag);
  }
  out->kkt_error = rest_of(&c, terms, &left);
  if (ph_check_is_larger(c.kkt.spline.defect, out->kkt_error)) {
    out->kkt_error = c.kkt.spline.defect;
  }
  out->minimiser = is_minimum(&c, left, work);
  return PH_OK;
}

enum ph_status ph_stationary_of(const struct ph_curve *curve,
                                const struct ph_spinor_rows *rows,
                                const struct ph_stationary_soft *soft,
                                struct ph_arena *arena,
                                struct ph_stationary *out,
                                struct ph_diag *diag) {
  struct ph_mark mark = ph_arena_mark(arena);
  enum ph_status status = find(curve, rows, soft, arena, out, diag);
  ph_arena_release(arena, mark);
  return status;
}
