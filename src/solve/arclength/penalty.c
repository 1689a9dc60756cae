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
      !ph_arc_region_alloc(n, s->order_band, arena, &work->region)) {
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
/* A step is taken that gains at least this of what the model promised. */
static const double GAIN = 0.01;
/* One that gains less than POOR shortens the radius, one that gains more than
 * GOOD and is about as long as it lengthens it. */
static const double POOR = 0.25, GOOD = 0.75, ABOUT = 0.6;
static const double SHORTER = 0.5, REFUSED = 0.25, LONGER = 2.5;
enum { REFUSALS = 30 };

/* Rounding of the value. */
static const double NOISE = 1e-13;

/* The pin of the common phase: as much as rho, or steps are bent. */
static const double PIN = 1e3;

/* Directions are turned, not kept, with the common phase: there is nothing to
 * pin, but the matrix may be singular. */
static const double SHIFT_SINGULAR = 1e-7;

/* What is minimised: F + y . c + rho / 2 |c|^2. */
struct search {
  const struct ph_arc_system *s;
  struct ph_arc_work *w;
  double *x;
  double *y;
  double rho;
  double f;     /* F at x; the rows there are in w->c */
  double value; /* at x */
  double radius;
};

static void swap(double **a, double **b) {
  double *t = *a;
  *a = *b;
  *b = t;
}

static double value_of(const struct search *g, double f, const double *c) {
  size_t n = g->s->y_n;
  return f + ph_arc_dot(n, g->y, c) + g->rho / 2 * ph_arc_dot(n, c, c);
}

static double value_at(const struct search *g, const double *x, double *c,
                       double *f) {
  ph_arc_residual(g->s, x, c);
  *f = ph_arc_functional(g->s, x);
  return value_of(g, *f, c);
}

static void begin(struct search *g) {
  g->value = value_at(g, g->x, g->w->c, &g->f);
  g->radius = RADIUS * sqrt(ph_arc_dot(g->s->x_n, g->x, g->x));
  g->w->region.hint = 0;
  g->w->region.factors = 0;
}

/* The model at x: gradient and matrix. */
static void set_model(struct search *g) {
  const struct ph_arc_system *s = g->s;
  struct ph_arc_work *w = g->w;
  struct ph_arc_weights weights = {1, s->direction ? SHIFT_SINGULAR : 0,
                                   s->direction ? 0 : fmax(PIN, g->rho)};
  for (size_t r = 0; r < s->y_n; r++) {
    w->y[r] = g->y[r] + g->rho * w->c[r];
  }
  ph_arc_linearise(s, g->x, w->y, &w->linear);
  for (size_t k = 0; k < s->x_n; k++) {
    w->region.g[s->order[k]] = w->linear.l_x[k];
  }
  ph_arc_penalised(s, g->x, w->y, &w->linear, &weights, g->rho,
                   w->region.matrix);
}

/* v = -(A + shift)^-1 v, after a step. */
static void solve_region(const struct ph_arc_region *r, double *v) {
  for (size_t k = 0; k < r->n; k++) {
    v[k] = -v[k];
  }
  ph_sym_solve(r->factor, r->n, r->band, v);
}

/*
 * The rows at `to' = x + step differ from c + J step by their curvature, which
 * the same matrix takes back: better = x + step + second step.
 */
static void correct(const struct search *g) {
  const struct ph_arc_system *s = g->s;
  struct ph_arc_work *w = g->w;
  double *q = w->c_better, *second = w->better;
  ph_arc_rows_times(s, &w->linear, w->step, q);
  for (size_t r = 0; r < s->y_n; r++) {
    q[r] = g->rho * (w->c_to[r] - w->c[r] - q[r]);
  }
  memset(second, 0, s->x_n * sizeof *second);
  ph_arc_add_rows(s, &w->linear, q, second);
  for (size_t k = 0; k < s->x_n; k++) {
    w->ordered[s->order[k]] = second[k];
  }
  solve_region(&w->region, w->ordered);
  for (size_t k = 0; k < s->x_n; k++) {
    w->step[k] += w->ordered[s->order[k]];
  }
  ph_arc_retract(s, g->x, w->step, 1, w->better);
}

/* Tries the step of the region, with and without the correction, and takes the
 * better point.  ret what it gained of what the model promised */
static double try_step(struct search *g) {
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
static bool advance(struct search *g) {
  struct ph_arc_region *region = &g->w->region;
  double above = 0;
  set_model(g);
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

/* The multipliers may be set anew when a step promises no more than this of
 * the penalty, or of F, and the matrix needs no shift. */
static const double INNER = 0.1, INNER_F = 1e-6, INNER_SHIFT = 0.01;

/* Rows that fall by less than this from one setting to the next ask for a
 * larger rho. */
static const double ROWS_FALL = 0.1, RHO_GROWS = 10;

static bool is_inner(const struct search *g) {
  const struct ph_arc_region *region = &g->w->region;
  double penalty = g->rho / 2 * ph_arc_dot(g->s->y_n, g->w->c, g->w->c);
  return region->fall <= INNER * penalty + INNER_F * g->f &&
         region->shift <= INNER_SHIFT;
}

/* Sets the multipliers; false: rho is at its end, and the rows do not fall. */
static bool set_multipliers(struct search *g, double rho_max, double before,
                            double rows) {
  for (size_t r = 0; r < g->s->y_n; r++) {
    g->y[r] += g->rho * g->w->c[r];
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

bool ph_arc_penalty(const struct ph_arc_system *s,
                    const struct ph_arc_penalty_options *options,
                    struct ph_arc_work *work, double *x, double *y,
                    struct ph_arc_penalty_report *report) {
  struct search g = {.s = s, .w = work, .x = x, .y = y, .rho = options->rho};
  double before = (double)INFINITY;
  bool more = true;
  *report = (struct ph_arc_penalty_report){0};
  begin(&g);
  report->rows = ph_arc_largest(s->y_n, work->c);
  while (more && report->iterations < options->iterations &&
         !ph_arena_late(work->arena) && advance(&g)) {
    report->iterations++;
    report->rows = ph_arc_largest(s->y_n, work->c);
    if (is_inner(&g)) {
      more = set_multipliers(&g, options->rho_max, before, report->rows) &&
             !(report->rows <= options->tolerance);
      before = report->rows;
    }
  }
  report->factors = work->region.factors;
  return report->rows <= options->tolerance;
}

/* ---- trust regions ------------------------------------------------------- */

/* How exactly the radius is kept: a factor costs more than it gains. */
static const double SHORT = 0.5, LONG = 1.6;

/* The first shift of a matrix that is not positive definite, and how shifts
 * grow. */
static const double SHIFT_FIRST = 1e-2, SHIFT_GROWS = 4;

/* Factors for one step: 2 or 3 are the rule.  After some, a step that is short
 * is taken. */
enum { FACTORS = 40, FACTORS_MANY = 8 };

/* Bounds of the shift this near to each other leave nothing to choose. */
static const double NARROW = 1.05;

/* Inverse iterations for the lowest direction. */
enum { INVERSE = 3 };

bool ph_arc_region_alloc(size_t n, size_t band, struct ph_arena *arena,
                         struct ph_arc_region *r) {
  size_t size = ph_sym_size(n, band);
  *r = (struct ph_arc_region){
      .n = n,
      .band = band,
      .matrix = ph_arena_array(arena, size, sizeof(double)),
      .factor = ph_arena_array(arena, size, sizeof(double)),
      .g = ph_arena_array(arena, n, sizeof(double)),
      .step = ph_arena_array(arena, n, sizeof(double)),
      .other = ph_arena_array(arena, n, sizeof(double))};
  return r->matrix && r->factor && r->g && r->step && r->other;
}

static bool factor(struct ph_arc_region *r, double shift) {
  memcpy(r->factor, r->matrix, ph_sym_size(r->n, r->band) * sizeof *r->factor);
  for (size_t k = 0; k < r->n; k++) {
    *ph_sym_at(r->factor, r->band, k, k) += shift;
  }
  r->factors++;
  return ph_sym_factor(r->factor, r->n, r->band);
}

static double norm(const struct ph_arc_region *r, const double *v) {
  return sqrt(ph_arc_dot(r->n, v, v));
}

/* The step of this factor. */
static void set_step(struct ph_arc_region *r, double shift) {
  memcpy(r->step, r->g, r->n * sizeof *r->g);
  solve_region(r, r->step);
  r->shift = shift;
  r->length = norm(r, r->step);
}

/* Between these bounds is the shift. */
struct bounds {
  double low, high;
};

/* The next shift to try, between the bounds. */
static double between(const struct bounds *b) {
  return isfinite(b->high)
             ? fmax(sqrt(b->low * b->high), 0.95 * b->low + 0.05 * b->high)
             : fmax(SHIFT_GROWS * b->low, SHIFT_FIRST);
}

/* Newton's method for 1 / |s| = 1 / radius, which is nearly linear in the
 * shift; narrows the bounds. */
static double next_shift(struct ph_arc_region *r, double radius,
                         struct bounds *b) {
  double slope, next;
  memcpy(r->other, r->step, r->n * sizeof *r->step);
  ph_sym_solve(r->factor, r->n, r->band, r->other);
  slope = ph_arc_dot(r->n, r->step, r->other);
  next =
      r->shift + r->length * r->length / slope * (r->length - radius) / radius;
  if (r->length > radius) {
    b->low = r->shift;
  } else {
    b->high = r->shift;
  }
  if (!(next > 0) && !(b->low > 0)) {
    return 0;
  }
  return next > b->low && next < b->high ? next : between(b);
}

/* A factor and step near the radius; false: none. */
static bool search(struct ph_arc_region *r, double radius, double above) {
  struct bounds b = {above, (double)INFINITY};
  double shift = above > 0      ? fmax(SHIFT_GROWS / 2 * above, r->hint)
                 : r->shift > 0 ? r->hint
                                : 0;
  for (size_t k = 0; k < FACTORS; k++) {
    if (!factor(r, shift)) {
      b.low = fmax(fmax(b.low, shift), DBL_MIN); /* tried, if 0 */
      shift = k == 0 && r->hint > b.low ? r->hint : between(&b);
      continue;
    }
    set_step(r, shift);
    if (!(r->length > radius) &&
        (!(shift > 0) || r->length >= SHORT * radius ||
         b.high <= NARROW * b.low || k > FACTORS_MANY)) {
      return true;
    }
    if (r->length > radius && r->length <= LONG * radius) {
      return true;
    }
    shift = next_shift(r, radius, &b);
  }
  return false;
}

/* z . A z, where A + shift = L L^T. */
static double curvature(const struct ph_arc_region *r, const double *z) {
  double sum = 0;
  for (size_t j = 0; j < r->n; j++) {
    size_t rest = r->n - j, rows = rest < r->band + 1 ? rest : r->band + 1;
    double v = ph_arc_dot(rows, ph_sym_at(r->factor, r->band, j, j), z + j);
    sum += v * v;
  }
  return sum - r->shift * ph_arc_dot(r->n, z, z);
}

/* A unit vector along which A has nearly its least curvature, in r->other. */
static void set_lowest(struct ph_arc_region *r) {
  uint64_t state = 1;
  double *z = r->other;
  for (size_t k = 0; k < r->n; k++) { /* any vector */
    state = state * 6364136223846793005u + 1442695040888963407u;
    z[k] = (double)(state >> 11) / 9007199254740992.0 - 0.5;
  }
  for (size_t i = 0; i < INVERSE; i++) {
    double size;
    ph_sym_solve(r->factor, r->n, r->band, z);
    size = norm(r, z);
    for (size_t k = 0; k < r->n; k++) {
      z[k] /= size;
    }
  }
}

/* The step is too short although the shift is nearly the least: the rest is
 * along the lowest direction. */
static void go_lowest(struct ph_arc_region *r, double radius) {
  double along, rest, more;
  set_lowest(r);
  along = ph_arc_dot(r->n, r->step, r->other);
  rest = sqrt(along * along + radius * radius - r->length * r->length) -
         fabs(along);
  rest = along < 0 ? -rest : rest;
  more = rest * (r->shift * along - rest / 2 * curvature(r, r->other));
  if (more > 0) {
    for (size_t k = 0; k < r->n; k++) {
      r->step[k] += rest * r->other[k];
    }
    r->fall += more;
    r->length = radius;
  }
}

bool ph_arc_region_step(struct ph_arc_region *r, double radius, double above) {
  if (!search(r, radius, above)) {
    return false;
  }
  r->hint = r->shift > 0 ? r->shift : r->hint;
  r->fall =
      (r->shift * r->length * r->length - ph_arc_dot(r->n, r->g, r->step)) / 2;
  if (r->shift > 0 && r->length < SHORT * radius) {
    go_lowest(r, radius);
  }
  return r->length <= DBL_MAX;
}
