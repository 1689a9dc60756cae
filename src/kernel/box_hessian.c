/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Second derivatives by differences of gradients (see box_hessian.h). */
#include "kernel/box_hessian.h"

#include "kernel/band.h"

#include <float.h>
#include <math.h>
#include <string.h>

/* The change of a variable, or of all. */
static const double DIFFERENCE = 1e-5;

/* Pivots that differences can not tell from 0, by the diagonal. */
static const double PIVOT_MIN = 1e-6;

/* What is added first where a matrix is not positive definite; how often it is
 * more: up to 1e15 times the matrix. */
static const double SHIFT = 1e-3, MORE = 4;
enum { SHIFTS = 30 };

enum ph_status ph_box_hessian_alloc(struct ph_box_hessian *h,
                                    struct ph_arena *arena, size_t n,
                                    size_t k) {
  double *room = ph_arena_array(arena, n, (3 + 2 * (k + 1)) * sizeof *room);
  bool *fixed = ph_arena_array(arena, n, sizeof *fixed);
  if (!room || !fixed) {
    return PH_E_NO_MEMORY;
  }
  *h = (struct ph_box_hessian){.n = n,
                               .k = k,
                               .fixed = fixed,
                               .x = room,
                               .gradient = room + n,
                               .change = room + 2 * n,
                               .a = room + 3 * n,
                               .factor = room + 3 * n + ph_sym_size(n, k)};
  return PH_OK;
}

static enum ph_status evaluate(struct ph_box_hessian *h,
                               const struct ph_box *box, double *gradient) {
  double value;
  enum ph_status status = box->value(box->context, h->x, &value);
  h->found = status == PH_OK && isfinite(value);
  if (h->found) {
    box->gradient(box->context, gradient);
  }
  for (size_t i = 0; h->found && i < h->n; i++) {
    h->found = isfinite(gradient[i]);
  }
  return status;
}

/* h->change <- the second derivatives along h->x - x, but for a factor. */
static enum ph_status differentiate(struct ph_box_hessian *h,
                                    const struct ph_box *box, const double *x) {
  enum ph_status status = evaluate(h, box, h->change);
  for (size_t i = 0; h->found && i < h->n; i++) {
    h->change[i] -= h->gradient[i];
  }
  memcpy(h->x, x, h->n * sizeof *x);
  return status;
}

/* The element (i, j) of the lower or the upper triangle. */
static double *at(const struct ph_box_hessian *h, size_t i, size_t j) {
  return ph_sym_at(h->a, h->k, i > j ? i : j, i > j ? j : i);
}

/* Half of column i into each triangle: the rows that are near enough. */
static void put_column(struct ph_box_hessian *h, size_t i, double change) {
  size_t begin = i > h->k ? i - h->k : 0;
  for (size_t j = begin; j < h->n && j <= i + h->k; j++) {
    *at(h, i, j) += 0.5 * h->change[j] / change;
  }
}

static double into_box(const struct ph_box *box, const double *x, size_t i) {
  return x[i] + DIFFERENCE > box->upper[i] ? -DIFFERENCE : DIFFERENCE;
}

/* Columns number i of all groups; group g begins at g n / groups. */
static enum ph_status find_columns(struct ph_box_hessian *h,
                                   const struct ph_box *box, const double *x,
                                   size_t groups, size_t i) {
  enum ph_status status;
  for (size_t g = 0; g < groups; g++) {
    size_t v = g * h->n / groups + i;
    if (v < (g + 1) * h->n / groups) {
      h->x[v] = x[v] + into_box(box, x, v);
    }
  }
  status = differentiate(h, box, x);
  for (size_t g = 0; h->found && g < groups; g++) {
    size_t v = g * h->n / groups + i;
    if (v < (g + 1) * h->n / groups) {
      put_column(h, v, into_box(box, x, v));
    }
  }
  return status;
}

/* The diagonal, by the sums of the rows. */
static enum ph_status find_diagonal(struct ph_box_hessian *h,
                                    const struct ph_box *box, const double *x) {
  enum ph_status status;
  for (size_t i = 0; i < h->n; i++) {
    h->x[i] = x[i] - DIFFERENCE;
  }
  status = differentiate(h, box, x);
  for (size_t i = 0; h->found && i < h->n; i++) {
    size_t begin = i > h->k ? i - h->k : 0;
    double sum = -h->change[i] / DIFFERENCE;
    for (size_t j = begin; j < h->n && j <= i + h->k; j++) {
      sum -= i == j ? 0 : *at(h, i, j);
    }
    *at(h, i, i) = sum;
  }
  return status;
}

enum ph_status ph_box_hessian_find(struct ph_box_hessian *h,
                                   const struct ph_box *box, const double *x) {
  size_t fit = h->n / (2 * h->k + 1), groups = fit > 0 ? fit : 1;
  size_t columns = (h->n + groups - 1) / groups;
  enum ph_status status;
  h->tried = false;
  memcpy(h->x, x, h->n * sizeof *x);
  memset(h->a, 0, ph_sym_size(h->n, h->k) * sizeof *h->a);
  status = evaluate(h, box, h->gradient);
  for (size_t i = 0; h->found && i < columns; i++) {
    status = find_columns(h, box, x, groups, i);
  }
  return h->found ? find_diagonal(h, box, x) : status;
}

/* factor += shift (|diagonal| + the sum of |a[i][j]| (x[i] - x[j])^2) */
static void add_shift(struct ph_box_hessian *h, double shift) {
  for (size_t j = 0; j < h->n; j++) {
    double *diagonal = ph_sym_at(h->factor, h->k, j, j);
    *diagonal += shift * (fabs(*at(h, j, j)) + DBL_MIN);
    for (size_t i = j + 1; i < h->n && i <= j + h->k; i++) {
      double part = shift * fabs(*at(h, i, j));
      *diagonal += part;
      *ph_sym_at(h->factor, h->k, i, j) -= part;
      *ph_sym_at(h->factor, h->k, i, i) += part;
    }
  }
}

/* Fixed variables: a row and a column of the identity. */
static void leave_out(struct ph_box_hessian *h) {
  const bool *fixed = h->fixed;
  for (size_t j = 0; j < h->n; j++) {
    for (size_t i = j; i < h->n && i <= j + h->k; i++) {
      if (fixed[i] || fixed[j]) {
        *ph_sym_at(h->factor, h->k, i, j) = i == j;
      }
    }
  }
}

/* Whether it is positive definite, by more than differences can tell. */
static bool factor(struct ph_box_hessian *h) {
  if (!ph_sym_factor(h->factor, h->n, h->k)) {
    return false;
  }
  for (size_t j = 0; j < h->n; j++) {
    double root = *ph_sym_at(h->factor, h->k, j, j);
    if (!h->fixed[j] && !(root * root > PIVOT_MIN * fabs(*at(h, j, j)))) {
      return false;
    }
  }
  return true;
}

/* Factors what is as near to it as can be factored. */
static void factor_near(struct ph_box_hessian *h) {
  double shift = 0;
  h->tried = true;
  h->factored = false;
  for (int i = 0; i < SHIFTS && !h->factored; i++) {
    memcpy(h->factor, h->a, ph_sym_size(h->n, h->k) * sizeof *h->a);
    add_shift(h, shift);
    leave_out(h);
    h->factored = factor(h);
    shift = shift > 0 ? MORE * shift : SHIFT;
  }
}

void ph_box_hessian_solve(struct ph_box_hessian *h, const bool *fixed,
                          double *v) {
  if (!h->tried || memcmp(h->fixed, fixed, h->n * sizeof *fixed) != 0) {
    memcpy(h->fixed, fixed, h->n * sizeof *fixed);
    factor_near(h);
  }
  for (size_t i = 0; i < h->n; i++) {
    v[i] = fixed[i] ? 0 : v[i];
  }
  if (h->factored) {
    ph_sym_solve(h->factor, h->n, h->k, v);
  }
}
