/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * How a spline answers to other tensions (see sphere.h): to first order by one
 * step of Newton's iteration with the matrix at hand, of which a tension
 * changes one diagonal block.  The equations are nonlinear in x because the
 * sphere is curved: what is neglected is of the order of theta^2, and falls by
 * such a factor with each further step by the same matrix.
 */
#include "solve/sphere/sphere.h"

#include <string.h>

/* Further steps, by how much each must make the residual fall, and the residual
 * that needs one more: what that leaves is below 1e-6, far less than the
 * margins of the criteria. */
enum { STEPS_MAX = 4 };
static const double FALL = 0.1;
static const double NEAR = 1e-5;

bool ph_sphere_response_alloc(struct ph_sphere_response *r,
                              struct ph_arena *arena, size_t n) {
  r->row = ph_arena_array(arena, n, sizeof *r->row);
  r->nu = ph_arena_array(arena, n, sizeof *r->nu);
  r->x = ph_arena_array(arena, n, sizeof *r->x);
  return r->row && r->nu && r->x;
}

void ph_sphere_response_of(struct ph_sphere_spline *s,
                           struct ph_sphere_range range,
                           struct ph_sphere_response *r) {
  const struct ph_sphere_data *d = s->data;
  struct ph_sphere_part part[2]; /* of the segments before and after a node */
  r->range = range;
  s->model->segment(s, ph_sphere_before(d, ph_sphere_node(d, range, 0)), true,
                    &part[0]);
  for (size_t j = 0; j < range.count; j++) {
    size_t i = ph_sphere_node(d, range, j);
    s->model->segment(s, i, true, &part[(j + 1) % 2]);
    s->model->node(s, i, &part[j % 2], &part[(j + 1) % 2], true, &r->row[j]);
    r->nu[j] = s->nu[i];
    r->x[j] = s->x[i];
  }
}

/* Row j of those from `first` to `last`, between which x moves; f is what
 * stands there in place of its own, or NULL. */
static struct ph_block2_row row_at(const struct ph_sphere_spline *s,
                                   const struct ph_sphere_response *r, size_t j,
                                   size_t first, size_t last,
                                   const double (*f)[2]) {
  struct ph_block2_row row = r->row[j];
  size_t i = ph_sphere_node(s->data, r->range, j);
  bool cyclic = s->data->closed && last - first + 1 == s->data->n;
  if (s->nu[i] < r->nu[j] || s->nu[i] > r->nu[j]) {
    s->model->retension(s, i, r->x[j], r->nu[j], &row);
  }
  if (f) {
    memcpy(row.f, f[j - first], sizeof row.f);
  }
  if (j == first && !cyclic) {
    memset(row.lo, 0, sizeof row.lo);
  }
  if (j == last && !cyclic) {
    memset(row.up, 0, sizeof row.up);
  }
  return row;
}

/* The step of nodes first to last by the matrix, into work->step, where f may
 * be. */
static void find_step(const struct ph_sphere_spline *s,
                      const struct ph_sphere_response *r, size_t first,
                      size_t last, const double (*f)[2],
                      struct ph_sphere_work *work) {
  struct ph_block2_row row = row_at(s, r, first, first, last, f);
  struct ph_block2_row end = row_at(s, r, last, first, last, f);
  ph_block2_begin(&work->system, last - first + 1, &row, &end);
  for (size_t j = first + 1; j < last; j++) {
    row = row_at(s, r, j, first, last, f);
    ph_block2_push(&work->system, &row);
  }
  ph_block2_finish(&work->system, work->step);
}

/* Takes it from x[] of these nodes, NULL: from where they are. */
static void take_step(struct ph_sphere_spline *s,
                      const struct ph_sphere_response *r, size_t first,
                      size_t last, const ph_vec3 *x,
                      const struct ph_sphere_work *work) {
  for (size_t j = first; j <= last; j++) {
    size_t i = ph_sphere_node(s->data, r->range, j);
    s->x[i] = x ? x[j] : s->x[i];
    s->x[i] = s->model->move(s, i, work->step[j - first]);
  }
}

/* Legs at these nodes. */
static void set_legs(struct ph_sphere_spline *s,
                     const struct ph_sphere_response *r, size_t first,
                     size_t last) {
  const struct ph_sphere_data *d = s->data;
  size_t before = ph_sphere_before(d, ph_sphere_node(d, r->range, first));
  s->model->segment(s, before, false, NULL);
  for (size_t j = first; j <= last; j++) {
    s->model->segment(s, ph_sphere_node(d, r->range, j), false, NULL);
  }
}

void ph_sphere_respond(struct ph_sphere_spline *s,
                       const struct ph_sphere_response *r, size_t first,
                       size_t count, struct ph_sphere_work *work) {
  const size_t last = first + count - 1;
  find_step(s, r, first, last, NULL, work);
  take_step(s, r, first, last, r->x, work);
  set_legs(s, r, first, last);
}

/* f of the rows where the spline is, at its tensions but in the scale of the
 * rows, which is that of theirs.
 * out  f[range.count]
 * ret  the largest; NaN if one is */
static double residual(struct ph_sphere_spline *s,
                       const struct ph_sphere_response *r, double (*f)[2]) {
  const struct ph_sphere_data *d = s->data;
  struct ph_sphere_part part[2]; /* of the segments before and after a node */
  double largest = 0, sum = 0;
  s->model->segment(s, ph_sphere_before(d, ph_sphere_node(d, r->range, 0)),
                    false, &part[0]);
  for (size_t j = 0; j < r->range.count; j++) {
    struct ph_block2_row row = r->row[j];
    size_t i = ph_sphere_node(d, r->range, j);
    double nu = s->nu[i];
    s->model->segment(s, i, false, &part[(j + 1) % 2]);
    s->nu[i] = r->nu[j];
    s->model->node(s, i, &part[j % 2], &part[(j + 1) % 2], false, &row);
    s->nu[i] = nu;
    s->model->retension(s, i, s->x[i], r->nu[j], &row);
    for (int c = 0; c < 2; c++) {
      f[j][c] = row.f[c];
      largest = fmax(largest, fabs(row.f[c]));
      sum += row.f[c];
    }
  }
  return isnan(sum) ? sum : largest;
}

bool ph_sphere_respond_well(struct ph_sphere_spline *s,
                            const struct ph_sphere_response *r,
                            struct ph_sphere_work *work) {
  const size_t last = r->range.count - 1;
  double before = (double)INFINITY;
  find_step(s, r, 0, last, NULL, work);
  take_step(s, r, 0, last, r->x, work);
  for (size_t i = 0; i < STEPS_MAX && !ph_arena_late(work->arena); i++) {
    const double miss = residual(s, r, work->step);
    if (!(miss <= FALL * before)) {
      return false;
    }
    find_step(s, r, 0, last, (const double(*)[2])work->step, work);
    take_step(s, r, 0, last, NULL, work);
    if (miss <= NEAR) {
      set_legs(s, r, 0, last);
      return true;
    }
    before = miss;
  }
  return false;
}
