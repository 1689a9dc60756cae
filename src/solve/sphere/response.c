/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * How a spline answers to other tensions, to first order (see sphere.h): one
 * step of Newton's iteration with the matrix at hand, of which a tension
 * changes one diagonal block.  The equations are nonlinear in x because the
 * sphere is curved: what is neglected is of the order of theta^2.
 */
#include "solve/sphere/sphere.h"

#include <string.h>

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

/* Row j of those from `first` to `last`, between which x moves. */
static struct ph_block2_row row_at(const struct ph_sphere_spline *s,
                                   const struct ph_sphere_response *r, size_t j,
                                   size_t first, size_t last) {
  struct ph_block2_row row = r->row[j];
  size_t i = ph_sphere_node(s->data, r->range, j);
  bool cyclic = s->data->closed && last - first + 1 == s->data->n;
  if (s->nu[i] < r->nu[j] || s->nu[i] > r->nu[j]) {
    s->model->retension(s, i, r->x[j], r->nu[j], &row);
  }
  if (j == first && !cyclic) {
    memset(row.lo, 0, sizeof row.lo);
  }
  if (j == last && !cyclic) {
    memset(row.up, 0, sizeof row.up);
  }
  return row;
}

void ph_sphere_respond(struct ph_sphere_spline *s,
                       const struct ph_sphere_response *r, size_t first,
                       size_t count, struct ph_sphere_work *work) {
  const struct ph_sphere_data *d = s->data;
  size_t last = first + count - 1;
  struct ph_block2_row row = row_at(s, r, first, first, last);
  struct ph_block2_row end = row_at(s, r, last, first, last);
  ph_block2_begin(&work->system, count, &row, &end);
  for (size_t j = first + 1; j < last; j++) {
    row = row_at(s, r, j, first, last);
    ph_block2_push(&work->system, &row);
  }
  ph_block2_finish(&work->system, work->step);
  for (size_t j = first; j <= last; j++) {
    size_t i = ph_sphere_node(d, r->range, j);
    s->x[i] = r->x[j];
    s->x[i] = s->model->move(s, i, work->step[j - first]);
    s->model->segment(s, ph_sphere_before(d, i), false, NULL);
  }
  s->model->segment(s, ph_sphere_node(d, r->range, last), false, NULL);
}
