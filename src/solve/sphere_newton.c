/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Newton's iteration and continuation in the tensions (see sphere_newton.h).
 *
 * Continuation: at tensions nu + sigma (4/h_i + 4/h_{i+1}) the spline hugs its
 * data when sigma is large; sigma falls to 0 by factors that adapt to how the
 * iteration gets on.
 */
#include "solve/sphere_newton.h"

#include <string.h>

enum {
  STEPS_MAX = 50,    /* of one iteration */
  DESCENTS_MAX = 200 /* values of sigma */
};

/* Longest step of a control point, in radians. */
static const double MOVE_MAX = 0.7;
/* Shortest fraction of a step that is tried. */
static const double FRACTION_MIN = 1e-3;
/* Every equation to this: solved; the root mean square to that, where it does
 * not fall at once: solved as far as rounding lets it. */
static const double SOLVED = 1e-14;
static const double NEARLY = 1e-12;

/* Continuation: the first sigma, the one from which 0 is tried, the first and
 * the smallest factor, and the one that is too near 1. */
static const double SIGMA_MAX = 64;
static const double SIGMA_MIN = 1e-2;
static const double FACTOR = 0.5;
static const double FACTOR_MIN = 0.25;
static const double FACTOR_MAX = 0.999;

struct ph_sphere_range ph_sphere_all(const struct ph_sphere_data *data) {
  struct ph_sphere_range all = {!data->closed,
                                data->closed ? data->n : data->n - 2};
  return all;
}

bool ph_sphere_work_alloc(struct ph_sphere_work *work, struct ph_arena *arena,
                          size_t n) {
  work->iterations = 0;
  work->residual = 0;
  work->step = ph_arena_array(arena, n, sizeof *work->step);
  work->before = ph_arena_array(arena, n, sizeof *work->before);
  work->kept = ph_arena_array(arena, n, sizeof *work->kept);
  work->tension = ph_arena_array(arena, n, sizeof *work->tension);
  return ph_block2_alloc(&work->system, arena, n) && work->step &&
         work->before && work->kept && work->tension;
}

bool ph_sphere_spline_alloc(struct ph_sphere_spline *s,
                            const struct ph_sphere_data *data,
                            const struct ph_sphere_model *model,
                            struct ph_arena *arena) {
  s->data = data;
  s->model = model;
  s->nu = ph_arena_array(arena, data->n, sizeof *s->nu);
  s->x = ph_arena_array(arena, data->n, sizeof *s->x);
  s->r = ph_arena_array(arena, data->m, sizeof *s->r);
  s->l = ph_arena_array(arena, data->m, sizeof *s->l);
  if (!s->nu || !s->x || !s->r || !s->l) {
    return false;
  }
  memcpy(s->nu, data->nu, data->n * sizeof *s->nu);
  return true;
}

/* ---- one iteration ------------------------------------------------------- */

/* How far the equations of a range are from holding; NaN shows in rms. */
struct miss {
  double rms, largest;
};

static bool is_solved(struct miss miss) {
  return miss.rms <= NEARLY && miss.largest <= SOLVED;
}

static size_t node_at(const struct ph_sphere_data *d,
                      struct ph_sphere_range range, size_t j) {
  size_t i = range.first + j;
  return i < d->n ? i : i - d->n;
}

/* The parts of the two segments at node j of a range, and its equation. */
static struct ph_block2_row row_at(struct ph_sphere_spline *s,
                                   struct ph_sphere_range range, size_t j) {
  size_t i = node_at(s->data, range, j);
  struct ph_sphere_part left, right;
  struct ph_block2_row row;
  s->model->segment(s, ph_sphere_before(s->data, i), true, &left);
  s->model->segment(s, i, true, &right);
  s->model->node(s, i, &left, &right, true, &row);
  return row;
}

static void add_miss(struct miss *miss, const struct ph_block2_row *row) {
  for (int c = 0; c < 2; c++) {
    double f = fabs(row->f[c]);
    miss->rms += f * f;
    miss->largest = f > miss->largest ? f : miss->largest;
  }
}

/* The equations at x; pushed into the system. */
static struct miss evaluate(struct ph_sphere_spline *s,
                            struct ph_sphere_range range,
                            struct ph_sphere_work *work) {
  const struct ph_sphere_data *d = s->data;
  size_t n = range.count;
  bool cyclic = d->closed && n == d->n;
  struct miss miss = {0, 0};
  struct ph_sphere_part left, right;
  struct ph_block2_row row = row_at(s, range, 0),
                       last = row_at(s, range, n - 1);
  if (!cyclic) {
    memset(row.lo, 0, sizeof row.lo);
    memset(last.up, 0, sizeof last.up);
    if (n == 1) {
      memset(row.up, 0, sizeof row.up);
      memset(last.lo, 0, sizeof last.lo);
    }
  }
  ph_block2_begin(&work->system, n, &row, &last);
  add_miss(&miss, &row);
  if (n > 1) {
    add_miss(&miss, &last);
  }
  if (n > 2) {
    s->model->segment(s, node_at(d, range, 0), true, &left);
  }
  for (size_t j = 1; j + 1 < n; j++) {
    size_t i = node_at(d, range, j);
    s->model->segment(s, i, true, &right);
    s->model->node(s, i, &left, &right, true, &row);
    ph_block2_push(&work->system, &row);
    add_miss(&miss, &row);
    left = right;
  }
  miss.rms = sqrt(miss.rms / (double)n);
  return miss;
}

/* The largest move of a control point by the step, in radians. */
static double largest_move(const struct ph_sphere_spline *s,
                           struct ph_sphere_range range,
                           const struct ph_sphere_work *work) {
  double largest = 0;
  for (size_t j = 0; j < range.count; j++) {
    size_t i = node_at(s->data, range, j);
    double reach = s->model->reach(s, i);
    double move = reach * hypot(work->step[j][0], work->step[j][1]);
    largest = move <= largest ? largest : move;
  }
  return largest;
}

static void keep(const struct ph_sphere_spline *s, struct ph_sphere_range range,
                 ph_vec3 *x) {
  for (size_t j = 0; j < range.count; j++) {
    x[j] = s->x[node_at(s->data, range, j)];
  }
}

/* x is what was kept, moved by a fraction of the step. */
static void move(struct ph_sphere_spline *s, struct ph_sphere_range range,
                 const ph_vec3 *x, const double (*step)[2], double fraction) {
  for (size_t j = 0; j < range.count; j++) {
    size_t i = node_at(s->data, range, j);
    s->x[i] = x[j];
    if (fraction > 0) {
      double by[2] = {fraction * step[j][0], fraction * step[j][1]};
      s->x[i] = s->model->move(s, i, by);
    }
  }
}

bool ph_sphere_newton(struct ph_sphere_spline *s, struct ph_sphere_range range,
                      struct ph_sphere_work *work) {
  struct miss miss;
  if (range.count == 0) {
    struct ph_sphere_part part;
    s->model->segment(s, 0, false, &part);
    return true;
  }
  keep(s, range, work->kept);
  miss = evaluate(s, range, work);
  for (size_t step = 0; step < STEPS_MAX && !is_solved(miss); step++) {
    struct miss next = miss;
    double fraction, largest;
    ph_block2_finish(&work->system, work->step);
    largest = largest_move(s, range, work);
    fraction = largest <= MOVE_MAX ? 1 : MOVE_MAX / largest;
    keep(s, range, work->before);
    do {
      move(s, range, work->before, (const double(*)[2])work->step, fraction);
      next = evaluate(s, range, work);
      fraction /= 2;
    } while (!(next.rms < (1 - 0.2 * fraction) * miss.rms) &&
             fraction > FRACTION_MIN && !(miss.rms <= NEARLY));
    if (!(next.rms < miss.rms)) {
      move(s, range, work->before, NULL, 0);
      miss = evaluate(s, range, work);
      break;
    }
    work->iterations++;
    miss = next;
  }
  work->residual = miss.rms;
  if (miss.rms <= NEARLY) {
    return true;
  }
  move(s, range, work->kept, NULL, 0);
  return false;
}

/* ---- continuation -------------------------------------------------------- */

/* Tensions at sigma, towards those aimed at. */
static void set_tensions(struct ph_sphere_spline *s, double sigma,
                         const double *aim) {
  const struct ph_sphere_data *d = s->data;
  struct ph_sphere_range all = ph_sphere_all(d);
  for (size_t j = 0; j < all.count; j++) {
    size_t i = node_at(d, all, j);
    s->nu[i] =
        aim[i] + sigma * (4 / d->h[ph_sphere_before(d, i)] + 4 / d->h[i]);
  }
}

/* From sigma, where x is a solution, as far down as it goes: to 0 if true. */
static bool descend(struct ph_sphere_spline *s, struct ph_sphere_work *work) {
  struct ph_sphere_range all = ph_sphere_all(s->data);
  double sigma = SIGMA_MAX, factor = FACTOR;
  for (size_t i = 0; i < DESCENTS_MAX; i++) {
    double next = sigma > SIGMA_MIN ? sigma * factor : 0;
    set_tensions(s, next, work->tension);
    if (ph_sphere_newton(s, all, work)) {
      sigma = next;
      factor = factor * sqrt(factor);
      factor = factor > FACTOR_MIN ? factor : FACTOR_MIN;
      if (!(sigma > 0)) {
        return true;
      }
    } else {
      factor = sqrt(factor);
      if (factor > FACTOR_MAX || !(sigma > SIGMA_MIN)) {
        return false;
      }
    }
  }
  return false;
}

bool ph_sphere_solve(struct ph_sphere_spline *s, struct ph_sphere_work *work) {
  struct ph_sphere_range all = ph_sphere_all(s->data);
  size_t size = s->data->n * sizeof *s->nu;
  bool solved;
  s->model->start(s, work);
  if (ph_sphere_newton(s, all, work)) {
    return true;
  }
  memcpy(work->tension, s->nu, size);
  s->model->hug(s);
  set_tensions(s, SIGMA_MAX, work->tension);
  solved = ph_sphere_newton(s, all, work) && descend(s, work);
  memcpy(s->nu, work->tension, size);
  return solved || (s->model->last_resort && s->model->last_resort(s, work));
}
