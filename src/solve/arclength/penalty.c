/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Globalisation of the arc-length problem (see arclength.h). */
#include "solve/arclength/arclength.h"

#include "kernel/band.h"
#include "kernel/vec3.h"
#include "solve/arclength/system.h"

#include <float.h>
#include <math.h>
#include <stdint.h>
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

/* The rows of a whitening matrix are orthogonal: its inverse is its transpose,
 * but for their squared lengths. */
static void multipliers(const struct ph_arc_system *s, const double *y,
                        bool back, double *out) {
  size_t n = s->forms_n;
  memmove(out, y, s->y_n * sizeof *out);
  for (size_t i = 0; s->white && i < s->data->n; i++) {
    const double *white = s->white + i * n * n;
    double old[4], sum[4] = {0};
    memcpy(old, out + i * n, n * sizeof *old);
    for (size_t k = 0; k < n; k++) {
      const double *row = white + k * n;
      for (size_t l = 0; l < n; l++) {
        sum[back ? k : l] += row[l] * old[back ? l : k];
      }
      sum[k] /= back ? ph_arc_dot(n, row, row) : 1;
    }
    memcpy(out + i * n, sum, n * sizeof *sum);
  }
}

void ph_arc_plain(const struct ph_arc_system *s, const double *y,
                  double *plain) {
  multipliers(s, y, false, plain);
}

void ph_arc_whitened(const struct ph_arc_system *s, const double *y,
                     double *white) {
  multipliers(s, y, true, white);
}

/* ---- a start ------------------------------------------------------------ */

void ph_arc_twist(const struct ph_arc_system *s, double angle, double *x) {
  double cosine = cos(angle), sine = sin(angle);
  for (size_t j = 0; s->dim == 4 && j < s->nodes; j++) {
    ph_arc_phase(cosine, j % 2 ? -sine : sine, x + 4 * j, x + 4 * j);
  }
}

/* ---- memory ------------------------------------------------------------- */

bool ph_arc_work_alloc(const struct ph_arc_system *s, struct ph_arena *arena,
                       struct ph_arc_work *work) {
  size_t n = s->x_n, m = s->y_n;
  double *x = ph_arena_array(arena, 4 * n, sizeof *x);
  double *y = ph_arena_array(arena, 4 * m, sizeof *y);
  if (!x || !y || !ph_arc_linear_alloc(s, arena, &work->linear) ||
      !ph_arc_region_alloc(n, s->order_band, arena, &work->region) ||
      !ph_arc_windows_alloc(s, arena, &work->windows)) {
    return false;
  }
  work->arena = arena;
  work->ordered = x;
  work->step = x + n;
  work->to = x + 2 * n;
  work->better = x + 3 * n;
  work->c = y;
  work->c_to = y + m;
  work->c_better = y + 2 * m;
  work->y = y + 3 * m;
  return true;
}

/* ---- one step ----------------------------------------------------------- */

/* The trusted radius at first, relative to |x|. */
static const double RADIUS = 0.3;
/* Beside windows it is never less than this. */
static const double LEAST_RADIUS = 1e-3;
/* A step is taken that gains at least this of what the model promised. */
static const double GAIN = 0.01;
/* One that gains less than POOR shortens the radius, one that gains more than
 * GOOD and is about as long as it lengthens it. */
static const double POOR = 0.25, GOOD = 0.75, ABOUT = 0.45;
static const double SHORTER = 0.5, REFUSED = 0.25, LONGER = 2.5;
enum { REFUSALS = 30 };

/* Rounding of the value. */
static const double NOISE = 1e-13;

/* Directions are turned, not kept, with the common phase: there is nothing to
 * pin, but the matrix may be singular. */
static const double SHIFT_SINGULAR = 1e-7;

static void swap(double **a, double **b) {
  double *t = *a;
  *a = *b;
  *b = t;
}

static double value_of(const struct ph_arc_lagrangian *g, double f,
                       const double *c) {
  size_t n = g->s->y_n;
  double sum = 0;
  if (!g->s->compliance) {
    return f + ph_arc_dot(n, g->y, c) + g->rho / 2 * ph_arc_dot(n, c, c);
  }
  for (size_t r = 0; r < n; r++) {
    sum += ph_arc_row_value(g, c, r);
  }
  return f + sum;
}

static double value_at(const struct ph_arc_lagrangian *g, const double *x,
                       double *c, double *f) {
  ph_arc_residual(g->s, x, c);
  *f = ph_arc_functional(g->s, x);
  return value_of(g, *f, c);
}

/* The value at x, whose rows are in work->c. */
static void set_value(struct ph_arc_lagrangian *g) {
  g->value = value_at(g, g->x, g->w->c, &g->f);
}

static void begin(struct ph_arc_lagrangian *g) {
  set_value(g);
  g->least = LEAST_RADIUS * sqrt(ph_arc_dot(g->s->x_n, g->x, g->x));
  g->radius = RADIUS / LEAST_RADIUS * g->least;
  g->w->region.hint = 0;
  g->w->region.factors = 0;
}

/* The model at x: gradient and matrix. */
void ph_arc_model(struct ph_arc_lagrangian *g) {
  const struct ph_arc_system *s = g->s;
  struct ph_arc_work *w = g->w;
  struct ph_arc_weights weights = {
      .functional = 1,
      .shift = s->direction ? SHIFT_SINGULAR : 0,
      .pin = s->direction ? 0 : fmax(PH_ARC_PIN, g->rho),
      .retracted = true};
  for (size_t r = 0; r < s->y_n; r++) {
    w->y[r] = ph_arc_multiplier(g, w->c, r);
  }
  ph_arc_linearise(s, g->x, w->y, &w->linear);
  for (size_t k = 0; k < s->x_n; k++) {
    w->region.g[s->order[k]] = w->linear.l_x[k];
  }
  ph_arc_penalised(s, g->x, w->y, &w->linear, &weights, g->rho,
                   w->region.matrix);
}

/*
 * The rows at `to' = x + step differ from c + J step by their curvature, which
 * the same matrix takes back: better = x + step + second step.
 */
static void correct(const struct ph_arc_lagrangian *g) {
  const struct ph_arc_system *s = g->s;
  struct ph_arc_work *w = g->w;
  double *q = w->c_better, *second = w->better;
  ph_arc_rows_times(s, &w->linear, w->step, q);
  for (size_t r = 0; r < s->y_n; r++) {
    q[r] = ph_arc_row_weight(g, r) * (w->c_to[r] - w->c[r] - q[r]);
  }
  memset(second, 0, s->x_n * sizeof *second);
  ph_arc_add_rows(s, &w->linear, q, second);
  for (size_t k = 0; k < s->x_n; k++) {
    w->ordered[s->order[k]] = second[k];
  }
  ph_arc_region_solve(&w->region, w->ordered);
  for (size_t k = 0; k < s->x_n; k++) {
    w->step[k] += w->ordered[s->order[k]];
  }
  ph_arc_retract(s, g->x, w->step, 1, w->better);
}

/* Tries the step of the region, with and without the correction, and takes the
 * better point.  ret what it gained of what the model promised */
static double try_step(struct ph_arc_lagrangian *g) {
  const struct ph_arc_system *s = g->s;
  struct ph_arc_work *w = g->w;
  double to, better, f_to, f_better, gain;
  for (size_t k = 0; k < s->x_n; k++) {
    w->step[k] = w->region.step[s->order[k]];
  }
  ph_arc_retract(s, g->x, w->step, 1, w->to);
  to = value_at(g, w->to, w->c_to, &f_to);
  correct(g);
  better = value_at(g, w->better, w->c_better, &f_better);
  if (better < to || isnan(to)) {
    swap(&w->to, &w->better);
    swap(&w->c_to, &w->c_better);
    to = better;
    f_to = f_better;
  }
  gain = (g->value - to) / w->region.fall;
  if (to <=
      g->value - GAIN * w->region.fall + NOISE * fmax(1, fabs(g->value))) {
    memcpy(g->x, w->to, s->x_n * sizeof *g->x);
    swap(&w->c, &w->c_to);
    g->value = to;
    g->f = f_to;
    return fmax(gain, GAIN);
  }
  return 0;
}

/* Moves x; false: nowhere is it better. */
static bool advance(struct ph_arc_lagrangian *g) {
  struct ph_arc_region *region = &g->w->region;
  double above = 0;
  ph_arc_model(g);
  for (size_t k = 0; k < REFUSALS && !ph_arena_late(g->w->arena); k++) {
    double gain;
    if (!ph_arc_region_step(region, g->radius, above)) {
      return false;
    }
    gain = try_step(g);
    if (gain > 0) {
      if (gain <= POOR) {
        g->radius = SHORTER * region->length;
      } else if (gain > GOOD && region->length > ABOUT * g->radius) {
        g->radius *= LONGER;
      }
      return true;
    }
    g->radius = REFUSED * region->length;
    above = region->shift;
  }
  return false;
}

/* ---- the search --------------------------------------------------------- */

/* The multipliers may be set anew when a step promises no more than INNER of
 * the penalty, or of F, and the matrix needs no shift; or when it gains too
 * little: along curved valleys it may for hundreds of steps. */
static const double INNER = 0.1, INNER_SHIFT = 0.01;

/* Rows that fall by less than this from one setting to the next ask for a
 * larger rho. */
static const double ROWS_FALL = 0.1, RHO_GROWS = 10;

/* Sweeps that gain less than this of the value do not help. */
static const double SWEEPS = 1e-9;

/* The largest residual of a row, and rho / 2 times the sum of the squares. */
static double rows_of(const struct ph_arc_lagrangian *g, double *penalty) {
  double most = 0, sum = 0;
  for (size_t r = 0; r < g->s->y_n; r++) {
    double c = (ph_arc_multiplier(g, g->w->c, r) - g->y[r]) / g->rho;
    double size = fabs(c) / (1 + ph_arc_compliance(g->s, r));
    sum += c * c;
    most = size <= most || isnan(most) ? most : size;
  }
  *penalty = g->rho / 2 * sum;
  return most;
}

/* Whether the inner iteration is at its end, after a step from where the value
 * was `last'. */
static bool is_inner(const struct ph_arc_lagrangian *g, double penalty,
                     const struct ph_arc_penalty_options *options,
                     double last) {
  const struct ph_arc_region *region = &g->w->region;
  return region->fall <= INNER * penalty + options->inner * g->f &&
         (region->shift <= INNER_SHIFT ||
          last - g->value <= options->creeps * penalty);
}

/* Sets the multipliers; false: rho is at its end, and the rows do not fall. */
static bool set_multipliers(struct ph_arc_lagrangian *g, double rho_max,
                            double before, double rows) {
  for (size_t r = 0; r < g->s->y_n; r++) {
    g->y[r] = ph_arc_multiplier(g, g->w->c, r);
  }
  if (!(rows <= ROWS_FALL * before)) {
    if (g->rho >= rho_max) {
      return false;
    }
    g->rho = fmin(RHO_GROWS * g->rho, rho_max);
  }
  g->value = value_of(g, g->f, g->w->c);
  return true;
}

/* One step of the whole, after sweeps of the windows if there are any; false:
 * there is no way on. */
static bool step(struct ph_arc_lagrangian *g) {
  struct ph_arc_windows *windows = &g->w->windows;
  double before = g->value;
  if (windows->n == 0) {
    return advance(g);
  }
  for (size_t k = 0; k < 2 && !ph_arena_late(g->w->arena); k++) {
    ph_arc_sweep(g, k);
    set_value(g);
  }
  g->radius = fmax(g->radius, g->least);
  return advance(g) || before - g->value > SWEEPS * fabs(g->value);
}

bool ph_arc_penalty(const struct ph_arc_system *s,
                    const struct ph_arc_penalty_options *options,
                    struct ph_arc_work *work, double *x, double *y,
                    struct ph_arc_penalty_report *report) {
  struct ph_arc_lagrangian g = {
      .s = s, .w = work, .x = x, .y = y, .rho = options->rho};
  double before = (double)INFINITY, last, penalty;
  bool more = true;
  *report = (struct ph_arc_penalty_report){0};
  begin(&g);
  ph_arc_windows_begin(&g);
  last = g.value;
  report->rows = rows_of(&g, &penalty);
  while (more && report->iterations < options->iterations &&
         !ph_arena_late(work->arena) && step(&g)) {
    report->iterations++;
    report->rows = rows_of(&g, &penalty);
    if (is_inner(&g, penalty, options, last)) {
      more = set_multipliers(&g, options->rho_max, before, report->rows) &&
             !(report->rows <= options->tolerance);
      before = report->rows;
    }
    last = g.value;
  }
  report->factors = work->region.factors;
  return report->rows <= options->tolerance;
}
