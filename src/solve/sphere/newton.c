/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Newton's iteration, damped, and relaxation (see sphere.h).
 *
 * Relaxation follows dx/dtime = -residual by implicit Euler steps whose length
 * grows as the residual falls [KEL98]: the matrix of a Newton step has tau
 * added to its diagonal, on which it has about 1, and tau is multiplied by the
 * fall of the residual.
 */
#include "solve/sphere/sphere.h"

#include <string.h>

enum {
  STEPS_MAX = 50,  /* of one iteration */
  RELAX_MAX = 150, /* of relaxation */
};

/* Longest step of a control point, in radians. */
static const double MOVE_MAX = 0.7;
/* Shortest fraction of a step that is tried. */
static const double FRACTION_MIN = 1e-3;
/* Every equation to this: solved; the root mean square to that, and every
 * equation to 100 times it, where it does not fall at once: solved as far as
 * rounding lets it. */
static const double SOLVED = 1e-14;
static const double NEARLY = 1e-12;
/* Relaxation: the largest tau, below which it is 0, and the residual from which
 * Newton's iteration takes over. */
static const double TAU_MAX = 100;
static const double TAU_MIN = 1e-14;
static const double NEAR = 1e-6;

struct ph_sphere_range ph_sphere_all(const struct ph_sphere_data *data) {
  struct ph_sphere_range all = {!data->closed,
                                data->closed ? data->n : data->n - 2};
  return all;
}

struct ph_sphere_range ph_sphere_widen(const struct ph_sphere_data *d,
                                       size_t first, size_t count, size_t by) {
  struct ph_sphere_range all = ph_sphere_all(d), range;
  if (d->closed) {
    if (count + 2 * by >= d->n) {
      return all;
    }
    range.first = (first + d->n - by) % d->n;
    range.count = count + 2 * by;
    return range;
  }
  range.first = first > by + 1 ? first - by : 1;
  range.count = first + count + by - range.first;
  if (range.first + range.count > d->n - 1) {
    range.count = d->n - 1 - range.first;
  }
  return range;
}

bool ph_sphere_work_alloc(struct ph_sphere_work *work, struct ph_arena *arena,
                          size_t n) {
  work->arena = arena;
  work->iterations = 0;
  work->residual = 0;
  work->step = ph_arena_array(arena, n, sizeof *work->step);
  work->before = ph_arena_array(arena, n, sizeof *work->before);
  work->kept = ph_arena_array(arena, n, sizeof *work->kept);
  work->tension = ph_arena_array(arena, n, sizeof *work->tension);
  work->held = ph_arena_array(arena, n, sizeof *work->held);
  work->aim = ph_arena_array(arena, n, sizeof *work->aim);
  work->given = ph_arena_array(arena, n, sizeof *work->given);
  return ph_block2_alloc(&work->system, arena, n) && work->step &&
         work->before && work->kept && work->tension && work->held &&
         work->aim && work->given;
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

/* The parts of the two segments at node j of a range, and its equation. */
static struct ph_block2_row row_at(struct ph_sphere_spline *s,
                                   struct ph_sphere_range range, size_t j) {
  size_t i = ph_sphere_node(s->data, range, j);
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

static void add_tau(struct ph_block2_row *row, double tau) {
  row->di[0] += tau;
  row->di[3] += tau;
}

/* The equations at x; pushed into the system, with tau on the diagonal.  NaN
 * when time is over: the system is not complete. */
static struct miss evaluate(struct ph_sphere_spline *s,
                            struct ph_sphere_range range, double tau,
                            struct ph_sphere_work *work) {
  const struct ph_sphere_data *d = s->data;
  size_t n = range.count;
  bool cyclic = d->closed && n == d->n;
  struct miss miss = {0, 0};
  struct ph_sphere_part part[2]; /* of the segments before and after a node */
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
  add_tau(&row, tau);
  add_tau(&last, tau);
  ph_block2_begin(&work->system, n, &row, &last);
  add_miss(&miss, &row);
  if (n > 1) {
    add_miss(&miss, &last);
  }
  if (n > 2) {
    s->model->segment(s, ph_sphere_node(d, range, 0), true, &part[0]);
  }
  for (size_t j = 1; j + 1 < n; j++) {
    size_t i = ph_sphere_node(d, range, j);
    if (ph_arena_late(work->arena)) {
      return (struct miss){(double)NAN, (double)NAN};
    }
    s->model->segment(s, i, true, &part[j % 2]);
    s->model->node(s, i, &part[(j + 1) % 2], &part[j % 2], true, &row);
    add_tau(&row, tau);
    ph_block2_push(&work->system, &row);
    add_miss(&miss, &row);
  }
  miss.rms = sqrt(miss.rms / (double)n);
  return miss;
}

/* The step; the fraction of it that moves no control point too far, 0 if it is
 * none. */
static double step_of(const struct ph_sphere_spline *s,
                      struct ph_sphere_range range,
                      struct ph_sphere_work *work) {
  double largest = MOVE_MAX;
  ph_block2_finish(&work->system, work->step);
  for (size_t j = 0; j < range.count; j++) {
    size_t i = ph_sphere_node(s->data, range, j);
    double reach = s->model->reach(s, i);
    double move = reach * hypot(work->step[j][0], work->step[j][1]);
    if (isnan(move)) {
      return 0;
    }
    largest = move > largest ? move : largest;
  }
  return MOVE_MAX / largest;
}

static void keep(const struct ph_sphere_spline *s, struct ph_sphere_range range,
                 ph_vec3 *x) {
  for (size_t j = 0; j < range.count; j++) {
    x[j] = s->x[ph_sphere_node(s->data, range, j)];
  }
}

/* x is what was kept, moved by a fraction of the step. */
static void move(struct ph_sphere_spline *s, struct ph_sphere_range range,
                 const ph_vec3 *x, const double (*step)[2], double fraction) {
  for (size_t j = 0; j < range.count; j++) {
    size_t i = ph_sphere_node(s->data, range, j);
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
  miss = evaluate(s, range, 0, work);
  for (size_t step = 0;
       step < STEPS_MAX && !is_solved(miss) && !ph_arena_late(work->arena);
       step++) {
    struct miss next = miss;
    double fraction = step_of(s, range, work);
    keep(s, range, work->before);
    do {
      move(s, range, work->before, (const double(*)[2])work->step, fraction);
      next = evaluate(s, range, 0, work);
      fraction /= 2;
    } while (!(next.rms < (1 - 0.2 * fraction) * miss.rms) &&
             fraction > FRACTION_MIN && !(miss.rms <= NEARLY) &&
             !ph_arena_late(work->arena));
    if (!(next.rms < miss.rms)) {
      move(s, range, work->before, NULL, 0);
      miss = evaluate(s, range, 0, work);
      break;
    }
    work->iterations++;
    miss = next;
  }
  work->residual = miss.rms;
  if (miss.rms <= NEARLY && miss.largest <= 100 * NEARLY) {
    return true;
  }
  move(s, range, work->kept, NULL, 0);
  return false;
}

void ph_sphere_step(struct ph_sphere_spline *s, struct ph_sphere_range range,
                    struct ph_sphere_work *work) {
  double fraction;
  if (isnan(evaluate(s, range, 0, work).rms)) {
    return;
  }
  fraction = step_of(s, range, work);
  keep(s, range, work->before);
  move(s, range, work->before, (const double(*)[2])work->step, fraction);
  evaluate(s, range, 0, work);
}

bool ph_sphere_relax(struct ph_sphere_spline *s, struct ph_sphere_range range,
                     double tau, struct ph_sphere_work *work) {
  struct miss miss = evaluate(s, range, tau, work);
  for (size_t step = 0;
       step < RELAX_MAX && !(miss.rms <= NEAR) && !ph_arena_late(work->arena);
       step++) {
    double fraction = step_of(s, range, work), before = miss.rms;
    keep(s, range, work->before);
    move(s, range, work->before, (const double(*)[2])work->step, fraction);
    miss = evaluate(s, range, tau, work);
    tau *= miss.rms / before;
    tau = tau < TAU_MAX ? tau : TAU_MAX;
    tau = tau > TAU_MIN ? tau : 0;
    work->iterations++;
  }
  return ph_sphere_newton(s, range, work);
}

size_t ph_sphere_fold(struct ph_sphere_spline *s, struct ph_sphere_range range,
                      struct ph_sphere_work *work) {
  double most = -1;
  size_t at = range.first;
  evaluate(s, range, 0, work);
  step_of(s, range, work);
  for (size_t j = 0; j < range.count; j++) {
    size_t i = ph_sphere_node(s->data, range, j);
    double move =
        s->model->reach(s, i) * hypot(work->step[j][0], work->step[j][1]);
    if (move > most) {
      most = move;
      at = i;
    }
  }
  return at;
}
