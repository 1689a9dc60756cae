/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Minimisation in a box (see box.h). */
#include "kernel/box.h"

#include <float.h>
#include <math.h>
#include <string.h>

/* Pairs of steps that are remembered; halvings of one step; small gains in
 * turn that end a search. */
enum { PAIRS = 20, HALVINGS = 30, SMALL_MAX = 3 };

/* Sufficient decrease (Armijo), a first step of steepest descent, the largest
 * step of one variable, curvature that is worth remembering. */
static const double ENOUGH = 1e-4, FIRST = 0.1, LONGEST = 1, CURVED = 1e-10;
/* How much more a step is tried after one that found no positive curvature. */
static const double STRETCH = 4;

struct pair {
  double *s, *y; /* differences of x and of the gradient */
};

struct search {
  const struct ph_box *box;
  struct ph_box_report *report;
  double *x, *next, *gradient, *next_gradient, *step, *spare;
  bool *fixed; /* at a bound, and pushed against it */
  struct pair pair[PAIRS];
  size_t pairs_n, newest;
  double stretch; /* of the next step: more where curvature is negative */
};

static enum ph_status allocate(struct search *s, struct ph_arena *arena,
                               size_t n) {
  double *room = ph_arena_array(arena, n, (5 + 2 * PAIRS) * sizeof *room);
  s->fixed = ph_arena_array(arena, n, sizeof *s->fixed);
  if (!room || !s->fixed) {
    return PH_E_NO_MEMORY;
  }
  s->next = room;
  s->gradient = room + n;
  s->next_gradient = room + 2 * n;
  s->step = room + 3 * n;
  s->spare = room + 4 * n;
  for (size_t i = 0; i < PAIRS; i++) {
    s->pair[i].s = room + (5 + 2 * i) * n;
    s->pair[i].y = room + (6 + 2 * i) * n;
  }
  return PH_OK;
}

/* The product over the variables that are free. */
static double dot(const struct search *s, const double *a, const double *b) {
  double sum = 0;
  for (size_t i = 0; i < s->box->n; i++) {
    sum += s->fixed[i] ? 0 : a[i] * b[i];
  }
  return sum;
}

static void fix(struct search *s) {
  const struct ph_box *box = s->box;
  for (size_t i = 0; i < box->n; i++) {
    s->fixed[i] = (s->x[i] <= box->lower[i] && s->gradient[i] > 0) ||
                  (s->x[i] >= box->upper[i] && s->gradient[i] < 0);
  }
}

static double largest(const struct search *s, const double *v) {
  double most = 0;
  for (size_t i = 0; i < s->box->n; i++) {
    double size = s->fixed[i] ? 0 : fabs(v[i]);
    most = size <= most ? most : size;
  }
  return most;
}

static void shorten(struct search *s, double most) {
  double size = largest(s, s->step);
  for (size_t i = 0; size > most && i < s->box->n; i++) {
    s->step[i] *= most / size;
  }
}

/* step += factor v */
static void add(struct search *s, double factor, const double *v) {
  for (size_t i = 0; i < s->box->n; i++) {
    s->step[i] += factor * v[i];
  }
}

static void condition(const struct search *s, double *v) {
  if (s->box->condition) {
    s->box->condition(s->box->context, s->fixed, v);
  }
}

/* The product of v and v as it is conditioned. */
static double conditioned(const struct search *s, const double *v) {
  memcpy(s->spare, v, s->box->n * sizeof *v);
  condition(s, s->spare);
  return dot(s, s->spare, v);
}

/* The two loops of L-BFGS, over the free variables. */
static void quasi_newton(struct search *s) {
  double alpha[PAIRS] = {0}, size = 0;
  for (size_t i = 0; i < s->box->n; i++) {
    s->step[i] = s->fixed[i] ? 0 : -s->gradient[i];
  }
  for (size_t i = 0; i < s->pairs_n; i++) { /* newest first */
    const struct pair *p = &s->pair[(s->newest + PAIRS - i) % PAIRS];
    double sy = dot(s, p->s, p->y), yy = dot(s, p->y, p->y);
    if (sy > CURVED * yy) {
      alpha[i] = dot(s, p->s, s->step) / sy;
      add(s, -alpha[i], p->y);
      size = size > 0 ? size : sy / conditioned(s, p->y);
    }
  }
  condition(s, s->step);
  for (size_t i = 0; size > 0 && i < s->box->n; i++) {
    s->step[i] *= size;
  }
  for (size_t i = s->pairs_n; i-- > 0;) {
    const struct pair *p = &s->pair[(s->newest + PAIRS - i) % PAIRS];
    double sy = dot(s, p->s, p->y), yy = dot(s, p->y, p->y);
    if (sy > CURVED * yy) {
      add(s, alpha[i] - dot(s, p->y, s->step) / sy, p->s);
    }
  }
  size = size > 0 || s->box->to_scale
             ? s->stretch
             : s->stretch * FIRST / largest(s, s->step);
  for (size_t i = 0; i < s->box->n; i++) {
    s->step[i] = s->fixed[i] ? 0 : size * s->step[i];
  }
  shorten(s, LONGEST);
}

static void project(struct search *s, double lambda) {
  const struct ph_box *box = s->box;
  for (size_t i = 0; i < box->n; i++) {
    double x = s->x[i] + lambda * s->step[i];
    x = x < box->lower[i] ? box->lower[i] : x;
    s->next[i] = x > box->upper[i] ? box->upper[i] : x;
  }
}

/* Goes along the step as far as pays; *gain is 0 where nothing does. */
static enum ph_status line(struct search *s, double *gain) {
  double lambda = 1;
  *gain = 0;
  for (int i = 0; i < HALVINGS; i++, lambda *= 0.5) {
    double value, slope = 0;
    enum ph_status status;
    project(s, lambda);
    for (size_t k = 0; k < s->box->n; k++) {
      slope += s->gradient[k] * (s->next[k] - s->x[k]);
    }
    if (!(-slope > s->box->decrease)) {
      return PH_OK; /* there is nothing to gain at this length */
    }
    status = s->box->value(s->box->context, s->next, &value);
    s->report->evaluations++;
    if (status != PH_OK) {
      return status;
    }
    if (value <= s->report->value + ENOUGH * slope &&
        value < s->report->value) {
      *gain = s->report->value - value;
      s->report->value = value;
      return PH_OK;
    }
  }
  return PH_OK;
}

/* Moves to s->next, and remembers the step. */
static void move(struct search *s) {
  size_t newest = s->pairs_n ? (s->newest + 1) % PAIRS : 0;
  struct pair *p = &s->pair[newest];
  double *swap = s->gradient;
  double sy = 0, yy = 0, ss = 0;
  s->box->accept(s->box->context);
  s->box->gradient(s->box->context, s->next_gradient);
  for (size_t i = 0; i < s->box->n; i++) {
    p->s[i] = s->next[i] - s->x[i];
    p->y[i] = s->next_gradient[i] - s->gradient[i];
    s->x[i] = s->next[i];
    sy += p->s[i] * p->y[i];
    ss += p->s[i] * p->s[i];
    yy += p->y[i] * p->y[i];
  }
  s->gradient = s->next_gradient;
  s->next_gradient = swap;
  if (sy > DBL_EPSILON * sqrt(ss * yy)) {
    s->newest = newest;
    s->pairs_n += s->pairs_n < PAIRS ? 1 : 0;
    s->stretch = 1;
  } else {
    s->stretch *= STRETCH;
  }
}

static bool is_spent(const struct search *s) {
  size_t most = s->box->evaluations_max;
  return most > 0 && s->report->evaluations >= most;
}

static enum ph_status run(struct search *s) {
  int small = 0;
  bool polishing = false; /* small gains after the memory was emptied */
  for (size_t i = 0; i < s->box->steps_max && !is_spent(s); i++) {
    double gain;
    enum ph_status status;
    fix(s);
    quasi_newton(s);
    status = line(s, &gain);
    s->report->gain = gain;
    if (status != PH_OK) {
      return status;
    }
    if (gain > 0) {
      move(s);
    }
    small = gain > s->box->decrease ? 0 : small + 1;
    polishing = polishing && small > 0;
    if (small >= SMALL_MAX || !(gain > 0)) {
      if (polishing || s->pairs_n == 0) {
        s->report->converged = true;
        return PH_OK;
      }
      polishing = true;
      s->pairs_n = 0;
      s->stretch = 1;
      small = 1;
    }
  }
  return PH_OK;
}

enum ph_status ph_box_minimize(const struct ph_box *box,
                               struct ph_arena *scratch, double *x,
                               struct ph_box_report *report) {
  struct ph_mark mark = ph_arena_mark(scratch);
  struct search s = {.box = box, .report = report, .x = x, .stretch = 1};
  enum ph_status status = allocate(&s, scratch, box->n);
  *report = (struct ph_box_report){(double)NAN, 1, 0, false};
  if (status == PH_OK) {
    status = box->value(box->context, x, &report->value);
  }
  if (status == PH_OK && isfinite(report->value)) {
    box->accept(box->context);
    box->gradient(box->context, s.gradient);
    status = run(&s);
  }
  ph_arena_release(scratch, mark);
  return status;
}
