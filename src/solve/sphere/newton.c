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
  return ph_block2_alloc(&work->system, arena, n) && work->step &&
         work->before && work->kept && work->tension && work->held;
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

/*
 * Newton's iteration after relaxation, from farther away.
 *
 * in    tau  what is added to the diagonal in the first step, where it is about
 *            1: small tau means long steps
 * inout s    x, which is anything afterwards if no solution was found
 */
static bool relax_from(struct ph_sphere_spline *s, struct ph_sphere_range range,
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

/* ---- from nothing -------------------------------------------------------- */

/*
 * Ways to a spherical nu-spline (see sphere.h).
 *
 * Continuation: at tensions nu + sigma (4/h_i + 4/h_{i+1}) the spline hugs its
 * data when sigma is large; sigma falls to 0 by factors that adapt to how the
 * iteration gets on.
 */

enum { DESCENTS_MAX = 200 /* values of sigma */ };

/* Continuation: the first sigma, the one from which 0 is tried, the first and
 * the smallest factor, and the one that is too near 1. */
static const double SIGMA_MAX = 64;
static const double SIGMA_MIN = 1e-2;
static const double FACTOR = 0.5;
static const double FACTOR_MIN = 0.25;
static const double FACTOR_MAX = 0.999;

/* Relaxation: what tau it begins with. */
static const double TAU[] = {4, 1, 0.25};

/* ---- continuation -------------------------------------------------------- */

/* Tensions at sigma, towards those aimed at. */
static void set_tensions(struct ph_sphere_spline *s, double sigma,
                         const double *aim) {
  const struct ph_sphere_data *d = s->data;
  struct ph_sphere_range all = ph_sphere_all(d);
  for (size_t j = 0; j < all.count; j++) {
    size_t i = ph_sphere_node(d, all, j);
    s->nu[i] = aim[i] + sigma * ph_sphere_stiffness(d, i);
  }
}

/* From sigma, where x is a solution, as far down as it goes: to 0 if true. */
static bool descend(struct ph_sphere_spline *s, struct ph_sphere_work *work) {
  struct ph_sphere_range all = ph_sphere_all(s->data);
  double sigma = SIGMA_MAX, factor = FACTOR;
  for (size_t i = 0; i < DESCENTS_MAX && !ph_arena_late(work->arena); i++) {
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

/* By continuation; the tensions are the same afterwards. */
static bool follow(struct ph_sphere_spline *s, struct ph_sphere_work *work) {
  size_t size = s->data->n * sizeof *s->nu;
  bool solved;
  memcpy(work->tension, s->nu, size);
  s->model->hug(s);
  set_tensions(s, SIGMA_MAX, work->tension);
  solved =
      ph_sphere_newton(s, ph_sphere_all(s->data), work) && descend(s, work);
  memcpy(s->nu, work->tension, size);
  return solved;
}

/* ---- other starts -------------------------------------------------------- */

static bool relax(struct ph_sphere_spline *s, struct ph_sphere_work *work) {
  for (size_t t = 0; t < sizeof TAU / sizeof TAU[0]; t++) {
    for (size_t which = 0;
         !ph_arena_late(work->arena) && s->model->start(s, which, work);
         which++) {
      if (relax_from(s, ph_sphere_all(s->data), TAU[t], work)) {
        return true;
      }
    }
  }
  return false;
}

bool ph_sphere_solve(struct ph_sphere_spline *s, struct ph_sphere_work *work) {
  struct ph_sphere_range all = ph_sphere_all(s->data);
  s->model->start(s, 0, work);
  return ph_sphere_newton(s, all, work) || follow(s, work) || relax(s, work) ||
         (s->model->last_resort && s->model->last_resort(s, work));
}

/* ---- more tension than was asked for ------------------------------------- */

/* Falls of sigma so near to 1 are a fold: the spline does not go on below it.
 */
static const double FACTOR_FOLD = 0.9;

/* Tensions at sigma, but at nodes that are held at their own. */
static void set_held(struct ph_sphere_spline *s, double sigma,
                     const double *aim, const double *held) {
  set_tensions(s, sigma, aim);
  for (size_t i = 0; i < s->data->n; i++) {
    if (held[i] > 0 && !ph_sphere_is_end(s->data, i)) {
      s->nu[i] = aim[i] + held[i] * ph_sphere_stiffness(s->data, i);
    }
  }
}

/* The node that a Newton step from x, which solved larger tensions, moves
 * most: beside a fold that is where it is. */
static size_t fold_at(struct ph_sphere_spline *s, struct ph_sphere_work *work) {
  struct ph_sphere_range all = ph_sphere_all(s->data);
  double most = -1;
  size_t at = all.first;
  evaluate(s, all, 0, work);
  step_of(s, all, work);
  for (size_t j = 0; j < all.count; j++) {
    size_t i = ph_sphere_node(s->data, all, j);
    double move =
        s->model->reach(s, i) * hypot(work->step[j][0], work->step[j][1]);
    if (move > most) {
      most = move;
      at = i;
    }
  }
  return at;
}

/* Holds the nodes about one at sigma, as many as it takes for one that was
 * not.  ret false: all are */
static bool hold(const struct ph_sphere_data *d, size_t at, double sigma,
                 double *held) {
  for (size_t by = 1; by <= d->n; by *= 2) {
    struct ph_sphere_range range = ph_sphere_widen(d, at, 1, by);
    bool some = false;
    for (size_t j = 0; j < range.count; j++) {
      size_t i = ph_sphere_node(d, range, j);
      some = some || !(held[i] > 0);
      held[i] = held[i] > 0 ? held[i] : sigma;
    }
    if (some) {
      return true;
    }
  }
  return false;
}

/* As descend; where it would end, the nodes that it ends at keep their sigma.
 */
static bool descend_held(struct ph_sphere_spline *s,
                         struct ph_sphere_work *work, double *held) {
  struct ph_sphere_range all = ph_sphere_all(s->data);
  double sigma = SIGMA_MAX, factor = FACTOR;
  for (size_t i = 0; i < DESCENTS_MAX && !ph_arena_late(work->arena); i++) {
    double next = sigma > SIGMA_MIN ? sigma * factor : 0;
    set_held(s, next, work->tension, held);
    if (ph_sphere_newton(s, all, work)) {
      sigma = next;
      factor = fmax(factor * sqrt(factor), FACTOR_MIN);
      if (!(sigma > 0)) {
        return true;
      }
      continue;
    }
    factor = sqrt(factor);
    if (factor > FACTOR_FOLD || !(sigma > SIGMA_MIN)) {
      if (!hold(s->data, fold_at(s, work), sigma, held)) {
        return false;
      }
      factor = FACTOR;
    }
  }
  return false;
}

bool ph_sphere_solve_tense(struct ph_sphere_spline *s,
                           struct ph_sphere_work *work) {
  size_t n = s->data->n;
  double *held = work->held;
  memset(held, 0, n * sizeof *held);
  memcpy(work->tension, s->nu, n * sizeof *s->nu);
  s->model->hug(s);
  set_held(s, SIGMA_MAX, work->tension, held);
  if (ph_sphere_newton(s, ph_sphere_all(s->data), work) &&
      descend_held(s, work, held)) {
    return true;
  }
  memcpy(s->nu, work->tension, n * sizeof *s->nu);
  return false;
}
