/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Globalisation of the arc-length problem (see arclength_penalty.h). */
#include "solve/arclength_penalty.h"

#include "kernel/band.h"
#include "kernel/vec3.h"

#include <math.h>
#include <string.h>

/* ---- whitened rows ------------------------------------------------------ */

/* The least share of a length that is taken for its excess over the chord. */
static const double LEAST_EXCESS = 1e-9;

/* Row k of the forms 0 to 3, of which the last may be missing. */
static void set_row(double *row, size_t n, double length, ph_vec3 v,
                    double scale) {
  row[0] = length * scale;
  row[1] = v.x * scale;
  row[2] = v.y * scale;
  if (n == 4) {
    row[3] = v.z * scale;
  }
}

static void whiten(const struct ph_arc_data *d, size_t i, size_t n,
                   double *white) {
  double chord = d->chord[i], length = d->length[i];
  double sum = (length + chord) / 2;
  double excess = fmax((length - chord) / 2, LEAST_EXCESS * length);
  double scale = 1 / sqrt(2 * sum * excess);
  ph_vec3 u = ph_vec3_scale(1 / chord, d->step[i]);
  set_row(white, n, 1, u, 1 / (2 * sum));
  set_row(white + n, n, 1, ph_vec3_scale(-1, u), 1 / (2 * excess));
  if (n == 4) {
    ph_vec3 t1 = ph_vec3_any_normal(u), t2 = ph_vec3_cross(u, t1);
    set_row(white + 2 * n, n, 0, t1, scale);
    set_row(white + 3 * n, n, 0, t2, scale);
  } else {
    set_row(white + 2 * n, n, 0, ph_vec3_of(-u.y, u.x, 0), scale);
  }
}

bool ph_arc_whiten(struct ph_arc_system *s, struct ph_arena *arena) {
  size_t n = s->forms_n;
  if (s->data->mode != PH_ARC_POINTS || s->compliance || n < 3 ||
      s->form[0] != 0) {
    return true;
  }
  s->white = ph_arena_array(arena, s->data->n * n * n, sizeof(double));
  if (!s->white) {
    return false;
  }
  for (size_t i = 0; i < s->data->n; i++) {
    whiten(s->data, i, n, s->white + i * n * n);
  }
  return true;
}

void ph_arc_plain(const struct ph_arc_system *s, const double *y,
                  double *plain) {
  size_t n = s->forms_n;
  for (size_t i = 0; s->white && i < s->data->n; i++) {
    const double *white = s->white + i * n * n;
    double old[4];
    memcpy(old, y + i * n, n * sizeof *old);
    for (size_t k = 0; k < n; k++) {
      double sum = 0;
      for (size_t l = 0; l < n; l++) {
        sum += white[l * n + k] * old[l];
      }
      plain[i * n + k] = sum;
    }
  }
  if (!s->white && plain != y) {
    memcpy(plain, y, s->y_n * sizeof *plain);
  }
}

/* ---- common ------------------------------------------------------------- */

bool ph_arc_work_alloc(const struct ph_arc_system *s, struct ph_arena *arena,
                       struct ph_arc_work *work) {
  double *x, *y;
  size_t n = s->x_n, m = s->y_n;
  work->matrix = ph_arena_array(arena, ph_sym_size(n, s->order_band),
                                sizeof *work->matrix);
  x = ph_arena_array(arena, 5 * n, sizeof *x);
  y = ph_arena_array(arena, 4 * m, sizeof *y);
  if (!work->matrix || !x || !y ||
      !ph_arc_linear_alloc(s, arena, &work->linear)) {
    return false;
  }
  work->ordered = x;
  work->step = x + n;
  work->second = x + 2 * n;
  work->to = x + 3 * n;
  work->better = x + 4 * n;
  work->c = y;
  work->c_to = y + m;
  work->c_better = y + 2 * m;
  work->y = y + 3 * m;
  return true;
}

/* The largest |v_k|; NaN if one is. */
static double largest(const double *v, size_t n) {
  double most = 0;
  for (size_t k = 0; k < n && !isnan(most); k++) {
    double size = fabs(v[k]);
    most = size <= most ? most : size;
  }
  return most;
}

static double dot(const double *u, const double *v, size_t n) {
  double sum = 0;
  for (size_t k = 0; k < n; k++) {
    sum += u[k] * v[k];
  }
  return sum;
}

static void swap(double **a, double **b) {
  double *t = *a;
  *a = *b;
  *b = t;
}

/* out = - A^-1 v, with the factor in the work; v may be out. */
static void solve(const struct ph_arc_system *s, struct ph_arc_work *work,
                  const double *v, double *out) {
  for (size_t k = 0; k < s->x_n; k++) {
    work->ordered[s->order[k]] = -v[k];
  }
  ph_sym_solve(work->matrix, s->x_n, s->order_band, work->ordered);
  for (size_t k = 0; k < s->x_n; k++) {
    out[k] = work->ordered[s->order[k]];
  }
}

/*
 * The step to the second order: the rows at `to` = x + step differ from c + J
 * step by their curvature, which the same matrix takes back.
 *
 * in   weight  of the squared rows in the matrix
 * out  better  = x + step + second
 */
static void correct(const struct ph_arc_system *s, struct ph_arc_work *work,
                    const double *x, double weight) {
  double *q = work->c_better;
  ph_arc_rows_times(s, &work->linear, work->step, q);
  for (size_t k = 0; k < s->y_n; k++) {
    q[k] = weight * (work->c_to[k] - work->c[k] - q[k]);
  }
  memset(work->second, 0, s->x_n * sizeof *work->second);
  ph_arc_add_rows(s, &work->linear, q, work->second);
  solve(s, work, work->second, work->second);
  for (size_t k = 0; k < s->x_n; k++) {
    work->second[k] += work->step[k];
  }
  ph_arc_retract(s, x, work->second, 1, work->better);
}

/* ---- feasibility -------------------------------------------------------- */

static const double FEASIBLE_SHIFT = 1e-2, FEASIBLE_SHIFT_LEAST = 1e-14,
                    FEASIBLE_SHIFT_MOST = 1e12, FEASIBLE_SHIFT_FALLS = 0.2,
                    FEASIBLE_SHIFT_GROWS = 5;

/* A step with this shift; *value is |c|^2, before and after. */
static bool feasible_step(const struct ph_arc_system *s, double shift,
                          struct ph_arc_work *work, double *x, double *value) {
  const struct ph_arc_weights weights = {0, shift, 1};
  double to, better;
  ph_arc_penalised(s, x, NULL, &work->linear, &weights, 1, work->matrix);
  if (!ph_sym_factor(work->matrix, s->x_n, s->order_band)) {
    return false;
  }
  memset(work->step, 0, s->x_n * sizeof *work->step);
  ph_arc_add_rows(s, &work->linear, work->c, work->step);
  solve(s, work, work->step, work->step);
  ph_arc_retract(s, x, work->step, 1, work->to);
  ph_arc_residual(s, work->to, work->c_to);
  to = dot(work->c_to, work->c_to, s->y_n);
  correct(s, work, x, 1);
  ph_arc_residual(s, work->better, work->c_better);
  better = dot(work->c_better, work->c_better, s->y_n);
  if (better < to || !(to < *value)) {
    swap(&work->to, &work->better);
    swap(&work->c_to, &work->c_better);
    to = better;
  }
  if (!(to < *value * (1 - 1e-12))) {
    return false;
  }
  *value = to;
  memcpy(x, work->to, s->x_n * sizeof *x);
  swap(&work->c, &work->c_to);
  return true;
}

bool ph_arc_feasible(const struct ph_arc_system *s, double tolerance,
                     size_t iterations, struct ph_arc_work *work, double *x,
                     struct ph_arc_penalty_report *report) {
  double shift = FEASIBLE_SHIFT, value;
  *report = (struct ph_arc_penalty_report){0};
  ph_arc_residual(s, x, work->c);
  value = dot(work->c, work->c, s->y_n);
  while (!((report->rows = largest(work->c, s->y_n)) <= tolerance) &&
         report->iterations < iterations) {
    bool moved = false;
    ph_arc_linearise(s, x, work->c, &work->linear);
    while (!moved && shift < FEASIBLE_SHIFT_MOST) {
      moved = feasible_step(s, shift, work, x, &value);
      shift =
          fmax(shift * (moved ? FEASIBLE_SHIFT_FALLS : FEASIBLE_SHIFT_GROWS),
               FEASIBLE_SHIFT_LEAST);
      report->factors++;
    }
    if (!moved) {
      return false;
    }
    report->iterations++;
  }
  return report->rows <= tolerance;
}

/* ---- augmented Lagrangian ----------------------------------------------- */

/* Shifts of the matrix: none below the least. */
static const double SHIFT_LEAST = 1e-6, SHIFT_FIRST = 1e-3, SHIFT_MOST = 1e12,
                    SHIFT_GROWS = 4;

/* The pin of the common phase: as much as rho, or steps are bent. */
static const double PIN = 1e3;

/* Directions are turned, not kept, with the common phase: there is nothing to
 * pin, but the matrix may be singular. */
static const double SHIFT_OF_TURNED = 1e-7;

/* The gradient that ends the search for a minimum between two updates of the
 * multipliers: the first, how it falls, the last. */
static const double GRADIENT = 1e-3, GRADIENT_FALLS = 0.3,
                    GRADIENT_LEAST = 1e-4;

/* Rows that fall by less ask for a larger weight. */
static const double ROWS_FALL = 0.25, RHO_GROWS = 10;

/* What the search is about. */
struct search {
  const struct ph_arc_system *system;
  struct ph_arc_work *work;
  double *x;
  const double *y;
  double rho, shift;
  double value;    /* F + y . c + rho / 2 |c|^2 at x; c is in work->c */
  double gradient; /* the largest of it */
};

static double value_at(const struct search *g, const double *x, double *c) {
  size_t n = g->system->y_n;
  ph_arc_residual(g->system, x, c);
  return ph_arc_functional(g->system, x) + dot(g->y, c, n) +
         g->rho / 2 * dot(c, c, n);
}

/* The least by which the shift is. */
static double shift_of(const struct search *g) {
  return g->system->direction ? fmax(g->shift, SHIFT_OF_TURNED) : g->shift;
}

/* A step with the shift that there is.  out *gain: what it gained of what was
 * to be expected */
static bool penalty_step(struct search *g, double *gain) {
  const struct ph_arc_system *s = g->system;
  struct ph_arc_work *work = g->work;
  const struct ph_arc_weights weights = {1, shift_of(g),
                                         s->direction ? 0 : fmax(PIN, g->rho)};
  double expected, to, better;
  ph_arc_penalised(s, g->x, work->y, &work->linear, &weights, g->rho,
                   work->matrix);
  if (!ph_sym_factor(work->matrix, s->x_n, s->order_band)) {
    return false;
  }
  solve(s, work, work->linear.l_x, work->step);
  expected = -dot(work->linear.l_x, work->step, s->x_n) / 2;
  ph_arc_retract(s, g->x, work->step, 1, work->to);
  to = value_at(g, work->to, work->c_to);
  correct(s, work, g->x, g->rho);
  better = value_at(g, work->better, work->c_better);
  if (better < to || !(to <= g->value)) {
    swap(&work->to, &work->better);
    swap(&work->c_to, &work->c_better);
    to = better;
  }
  if (!(to <= g->value - 1e-4 * expected)) {
    return false;
  }
  *gain = (g->value - to) / expected;
  g->value = to;
  memcpy(g->x, work->to, s->x_n * sizeof *g->x);
  swap(&work->c, &work->c_to);
  return true;
}

/* The gradient at x, with the multipliers that the rows make of y. */
static void set_gradient(struct search *g) {
  struct ph_arc_work *work = g->work;
  for (size_t k = 0; k < g->system->y_n; k++) {
    work->y[k] = g->y[k] + g->rho * work->c[k];
  }
  ph_arc_linearise(g->system, g->x, work->y, &work->linear);
  g->gradient = largest(work->linear.l_x, g->system->x_n);
}

/* Steps until the gradient is small or nothing is gained any more. */
static bool minimise(struct search *g, double gradient, size_t iterations,
                     struct ph_arc_penalty_report *report) {
  while (report->iterations < iterations) {
    bool moved = false;
    double gain = 0;
    set_gradient(g);
    if (g->gradient <= gradient * (1 + 1e-3 * largest(g->y, g->system->y_n))) {
      return true;
    }
    while (!moved && g->shift < SHIFT_MOST) {
      moved = penalty_step(g, &gain);
      report->factors++;
      if (!moved) {
        g->shift = fmax(SHIFT_GROWS * g->shift, SHIFT_FIRST);
      }
    }
    if (!moved) {
      return false;
    }
    report->iterations++;
    g->shift *= gain > 0.75 ? 0.1 : gain > 0.25 ? 0.4 : 1;
    g->shift = g->shift < SHIFT_LEAST ? 0 : g->shift;
  }
  set_gradient(g);
  return false;
}

bool ph_arc_penalty(const struct ph_arc_system *s,
                    const struct ph_arc_penalty_options *options,
                    struct ph_arc_work *work, double *x, double *y,
                    struct ph_arc_penalty_report *report) {
  struct search g = {s, work, x, y, options->rho, 0, 0, 0};
  double gradient = GRADIENT, before = INFINITY;
  *report = (struct ph_arc_penalty_report){0};
  for (;;) {
    bool found;
    g.value = value_at(&g, x, work->c);
    found = minimise(&g, gradient, options->iterations, report);
    report->rows = largest(work->c, s->y_n);
    for (size_t k = 0; k < s->y_n; k++) {
      y[k] += g.rho * work->c[k];
    }
    if (report->rows <= options->tolerance) {
      return true;
    }
    if (report->iterations >= options->iterations ||
        (!found && g.shift >= SHIFT_MOST)) {
      return false;
    }
    if (!(report->rows <= ROWS_FALL * before)) {
      if (g.rho >= options->rho_max) {
        return false;
      }
      g.rho = fmin(RHO_GROWS * g.rho, options->rho_max);
    }
    before = report->rows;
    gradient = fmax(GRADIENT_LEAST, GRADIENT_FALLS * gradient);
  }
}
