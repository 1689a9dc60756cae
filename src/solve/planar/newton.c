/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Solves the C2 equations (planar.h): Newton from two starts, damped where
 * it fails plain, then continuation.
 *
 * Newton from the chord start has not failed on any of the data that the
 * method was measured on; the midpoint start and the continuation are there
 * for what was not.  The number of steps does not depend on n.
 *
 * Continuation.  Straighten the polygon of chords, keeping their lengths, and
 * bend it back: the turning angles are multiplied by s = 0 ... 1.  At s = 0
 * the solution is a straight line, and the solution is followed from there.
 */
#include "solve/planar/planar.h"

#include <float.h>
#include <math.h>
#include <string.h>

/* Relative closing error of a segment that counts as solved. */
static const double SOLVED = 1e-13;
/* In units of the terms of F: rounding can not be expected to do better. */
static const double ROUNDING = 1e3 * DBL_EPSILON;
/* Sufficient decrease, and the shortest step worth trying (Kelley 1995). */
static const double DECREASE = 1e-4, SHORTEST = 1e-6;

enum { PLAIN_CAP = 25, NEWTON_CAP = 60, FOLLOW_CAP = 12 };

/* First and smallest continuation step. */
static const double FOLLOW_FIRST = 0.25, FOLLOW_SMALLEST = 1e-4;
/* A corrector that moves the unknowns by more than this has changed branch. */
static const double FOLLOW_NEAR = 0.5;

struct work {
  const struct ph_arena *arena; /* knows how much time there is */
  struct ph_tri tri;
  ph_cplx *b;    /* the iterate */
  ph_cplx *step; /* Newton's step, then the next iterate; start values */
};

static bool is_solved(const struct ph_planar_measure *m) {
  return isfinite(m->sum2) && m->max2 <= SOLVED * SOLVED;
}

static bool is_rounding(const struct ph_planar_c2 *c2, const struct work *w) {
  return ph_planar_rounding(c2, w->b) <= ROUNDING;
}

bool ph_planar_is_solved(const struct ph_planar_c2 *c2, const ph_cplx *b,
                         const struct ph_planar_measure *m) {
  return is_solved(m) || ph_planar_rounding(c2, b) <= ROUNDING;
}

/* Turns the step into the iterate that it leads to. */
static struct ph_planar_measure move(const struct ph_planar_c2 *c2,
                                     const struct work *w, double lambda) {
  size_t n = ph_planar_unknowns(c2);
  for (size_t i = 0; i < n; i++) {
    w->step[i].re = w->b[i].re - lambda * w->step[i].re;
    w->step[i].im = w->b[i].im - lambda * w->step[i].im;
  }
  return ph_planar_residual(c2, w->step);
}

/* Whether a step of length lambda did enough. */
static bool is_enough(const struct ph_planar_measure *before,
                      const struct ph_planar_measure *after, double lambda) {
  double wanted = 1 - DECREASE * lambda;
  return after->sum2 <= wanted * wanted * before->sum2 || is_solved(after);
}

/*
 * Newton from w->b, damped if asked, at most `cap` steps.  On return w->b is
 * the last iterate and *m its measure.
 */
static bool newton(const struct ph_planar_c2 *c2, struct work *w, bool damped,
                   int cap, size_t *iterations, struct ph_planar_measure *m) {
  for (int i = 0; i < cap && !ph_arena_late(w->arena); i++) {
    struct ph_planar_measure next;
    double lambda = 1;
    ph_cplx *swap = w->b;
    *m = ph_planar_newton_step(c2, w->b, &w->tri, w->step);
    if (is_solved(m)) {
      return true;
    }
    next = move(c2, w, lambda);
    while (!is_enough(m, &next, lambda) && (damped || !isfinite(next.sum2))) {
      if (is_rounding(c2, w)) {
        return true; /* no step can improve on rounding */
      }
      lambda *= 0.5;
      if (!damped || !(lambda >= SHORTEST)) {
        return false;
      }
      ph_tri_finish(&w->tri, w->step);
      next = move(c2, w, lambda);
    }
    w->b = w->step;
    w->step = swap;
    *m = next;
    ++*iterations;
    if (is_solved(m)) {
      return true;
    }
  }
  return is_rounding(c2, w);
}

static void start_from_chords(struct ph_planar_c2 *c2, struct work *w) {
  ph_planar_chord_middles(c2, ph_planar_middles(c2, w->step));
  ph_planar_start(c2, &w->tri, w->step, w->b);
}

/* Angles of the straightened polygon: chord k points to
 * exp(i (heading + s turned[k])); likewise the ends. */
struct homotopy {
  double heading;
  double *turned; /* [n] */
  double end[2];  /* open */
  double total;   /* closed: full turn of the chords */
  ph_cplx *data;  /* [n] the directions at s = 1 */
  ph_cplx data_end[2];
};

static double angle_between(ph_cplx a, ph_cplx b) {
  return atan2(ph_cplx_cross(a, b), ph_cplx_dot(a, b));
}

static void turn(struct ph_planar_c2 *c2, const struct homotopy *g, double s) {
  if (s >= 1) { /* the data themselves, to the last digit */
    for (size_t k = 0; k < c2->n; k++) {
      c2->direction[k] = g->data[k];
    }
    c2->end[0] = g->data_end[0];
    c2->end[1] = g->data_end[1];
    c2->twist = ph_cplx_of(cos(g->total / 2) >= 0 ? 1 : -1, 0);
    return;
  }
  for (size_t k = 0; k < c2->n; k++) {
    c2->direction[k] = ph_cplx_polar(g->heading + s * g->turned[k]);
  }
  c2->end[0] = ph_cplx_polar(g->heading + s * g->end[0]);
  c2->end[1] = ph_cplx_polar(g->heading + s * g->end[1]);
  c2->twist = ph_cplx_polar(s * g->total / 2);
}

static void homotopy_init(const struct ph_planar_c2 *c2, struct homotopy *g) {
  size_t n = c2->n;
  const ph_cplx *u = g->data;
  g->heading = atan2(u[0].im, u[0].re);
  g->turned[0] = 0;
  for (size_t k = 1; k < n; k++) {
    g->turned[k] = g->turned[k - 1] + angle_between(u[k - 1], u[k]);
  }
  g->total = g->turned[n - 1] + angle_between(u[n - 1], u[0]);
  g->data_end[0] = c2->end[0];
  g->data_end[1] = c2->end[1];
  g->end[0] = angle_between(u[0], c2->end[0]);
  g->end[1] = g->turned[n - 1] + angle_between(u[n - 1], c2->end[1]);
}

/* Predictor: the solution turns with the data, by half their angles. */
static void turn_solution(const struct ph_planar_c2 *c2,
                          const struct homotopy *g, double ds, ph_cplx *b) {
  size_t shift = c2->closed ? 0 : 1;
  for (size_t k = 0; k < c2->n; k++) {
    ph_cplx *z = &b[k + shift];
    *z = ph_cplx_mul(ph_cplx_polar(0.5 * ds * g->turned[k]), *z);
  }
  if (!c2->closed) {
    ph_cplx *z = &b[c2->n + 1];
    b[0] = ph_cplx_mul(ph_cplx_polar(0.5 * ds * g->end[0]), b[0]);
    *z = ph_cplx_mul(ph_cplx_polar(0.5 * ds * g->end[1]), *z);
  }
}

static double largest(const ph_cplx *a, const ph_cplx *b, size_t n) {
  double max2 = 0;
  for (size_t i = 0; i < n; i++) {
    double d2 = ph_cplx_norm2(b ? ph_cplx_sub(a[i], b[i]) : a[i]);
    max2 = d2 > max2 ? d2 : max2;
  }
  return sqrt(max2);
}

/* Follows the solution from the straight polygon (s = 0) to the data. */
static bool follow(struct ph_planar_c2 *c2, struct work *w,
                   const struct homotopy *g, ph_cplx *from, ph_cplx *guess,
                   size_t *iterations, struct ph_planar_measure *m) {
  size_t n = ph_planar_unknowns(c2);
  double s = 0, ds = FOLLOW_FIRST;
  turn(c2, g, 0);
  start_from_chords(c2, w);
  c2->twist = ph_cplx_of(1, 0);
  if (!newton(c2, w, true, NEWTON_CAP, iterations, m)) {
    return false;
  }
  while (s < 1 && !ph_arena_late(w->arena)) {
    size_t before = *iterations;
    double target = s + ds < 1 ? s + ds : 1;
    for (size_t i = 0; i < n; i++) {
      from[i] = w->b[i];
    }
    turn_solution(c2, g, target - s, w->b);
    for (size_t i = 0; i < n; i++) {
      guess[i] = w->b[i];
    }
    turn(c2, g, target);
    if (newton(c2, w, false, FOLLOW_CAP, iterations, m) &&
        largest(w->b, guess, n) < FOLLOW_NEAR * largest(guess, NULL, n)) {
      s = target;
      ds *= *iterations - before <= 5 ? 2 : 1;
    } else {
      for (size_t i = 0; i < n; i++) {
        w->b[i] = from[i];
      }
      ds *= 0.5;
      if (!(ds >= FOLLOW_SMALLEST)) {
        return false;
      }
    }
  }
  return !(s < 1);
}

static enum ph_status continuation(struct ph_planar_c2 *c2, struct work *w,
                                   struct ph_arena *scratch, bool *solved,
                                   size_t *iterations,
                                   struct ph_planar_measure *m,
                                   struct ph_diag *diag) {
  size_t n = ph_planar_unknowns(c2);
  struct homotopy g = {0};
  ph_cplx *from = ph_arena_array(scratch, n, sizeof *from);
  ph_cplx *guess = ph_arena_array(scratch, n, sizeof *guess);
  g.turned = ph_arena_array(scratch, c2->n, sizeof *g.turned);
  g.data = ph_arena_array(scratch, c2->n, sizeof *g.data);
  if (!from || !guess || !g.turned || !g.data) {
    return ph_fail_memory(diag);
  }
  for (size_t k = 0; k < c2->n; k++) {
    g.data[k] = c2->direction[k];
  }
  homotopy_init(c2, &g);
  *solved = follow(c2, w, &g, from, guess, iterations, m);
  turn(c2, &g, 1);
  return PH_OK;
}

/* Keeps the better of two measures for the report. */
static void keep_better(struct ph_planar_measure *m,
                        const struct ph_planar_measure *last, bool solved) {
  if (solved || (isfinite(last->sum2) && last->max2 < m->max2)) {
    *m = *last;
  }
}

static void start_from_spline(struct ph_planar_c2 *c2, struct work *w) {
  ph_planar_spline_middles(c2, &w->tri, ph_planar_middles(c2, w->step));
  ph_planar_start(c2, &w->tri, w->step, w->b);
}

typedef void start_fn(struct ph_planar_c2 *c2, struct work *w);

/* Plain Newton from a start; where that fails, damped from the same start. */
static bool solve_from(struct ph_planar_c2 *c2, struct work *w, start_fn *start,
                       size_t *iterations, struct ph_planar_measure *m) {
  start(c2, w);
  if (newton(c2, w, false, PLAIN_CAP, iterations, m)) {
    return true;
  }
  start(c2, w);
  return newton(c2, w, true, NEWTON_CAP, iterations, m);
}

static enum ph_status try_starts(struct ph_planar_c2 *c2, struct work *w,
                                 struct ph_arena *scratch, bool *solved,
                                 size_t *iterations,
                                 struct ph_planar_measure *m,
                                 struct ph_diag *diag) {
  struct ph_planar_measure last = {0, HUGE_VAL, 0};
  enum ph_status status;
  *solved = solve_from(c2, w, start_from_chords, iterations, &last);
  keep_better(m, &last, *solved);
  if (*solved) {
    return PH_OK;
  }
  *solved = solve_from(c2, w, start_from_spline, iterations, &last);
  keep_better(m, &last, *solved);
  if (*solved) {
    return PH_OK;
  }
  status = continuation(c2, w, scratch, solved, iterations, &last, diag);
  keep_better(m, &last, *solved);
  return status;
}

static enum ph_status work_init(struct work *w, const struct ph_planar_c2 *c2,
                                struct ph_arena *scratch, ph_cplx *b,
                                struct ph_diag *diag) {
  size_t n = ph_planar_unknowns(c2);
  w->b = b;
  w->arena = scratch;
  /* One more: the knot derivatives of a closed cubic spline. */
  w->step = ph_arena_array(scratch, n + 1, sizeof *w->step);
  return w->step && ph_tri_alloc(&w->tri, scratch, n) ? PH_OK
                                                      : ph_fail_memory(diag);
}

/* Reports, and puts the solution where the caller wants it. */
static enum ph_status conclude(const struct ph_planar_c2 *c2,
                               const struct work *w, bool solved,
                               const struct ph_planar_measure *m, ph_cplx *b,
                               struct ph_planar_report *report,
                               struct ph_diag *diag) {
  report->residual = sqrt(m->max2);
  report->worst = m->worst;
  if (!solved) {
    return isfinite(report->residual)
               ? ph_fail_at(diag, PH_NO_CONVERGENCE, "segments", m->worst,
                            "does not close: the best relative residual "
                            "reached is %.3g",
                            report->residual)
               : ph_fail(diag, PH_NO_CONVERGENCE, NULL,
                         "the iteration leaves the range of a double");
  }
  for (size_t i = 0; w->b != b && i < ph_planar_unknowns(c2); i++) {
    b[i] = w->b[i];
  }
  return PH_OK;
}

enum ph_status ph_planar_c2_solve(struct ph_planar_c2 *c2,
                                  struct ph_arena *scratch, ph_cplx *b,
                                  struct ph_planar_report *report,
                                  struct ph_diag *diag) {
  struct ph_planar_measure m = {0, HUGE_VAL, 0};
  struct work w;
  bool solved = false;
  enum ph_status status = work_init(&w, c2, scratch, b, diag);
  report->iterations = 0;
  if (status == PH_OK) {
    status =
        try_starts(c2, &w, scratch, &solved, &report->iterations, &m, diag);
  }
  return status == PH_OK ? conclude(c2, &w, solved, &m, b, report, diag)
                         : status;
}

enum ph_status ph_planar_c2_second(struct ph_planar_c2 *c2,
                                   struct ph_arena *scratch, ph_cplx *b,
                                   struct ph_planar_report *report,
                                   struct ph_diag *diag) {
  struct ph_planar_measure m = {0, HUGE_VAL, 0};
  struct work w;
  enum ph_status status = work_init(&w, c2, scratch, b, diag);
  bool solved;
  if (status != PH_OK) {
    return status;
  }
  report->iterations = 0;
  solved = solve_from(c2, &w, start_from_spline, &report->iterations, &m);
  return conclude(c2, &w, solved, &m, b, report, diag);
}

enum ph_status ph_planar_c2_near(const struct ph_planar_c2 *c2,
                                 struct ph_arena *scratch, const ph_cplx *guess,
                                 ph_cplx *b, bool *near, struct ph_diag *diag) {
  size_t n = ph_planar_unknowns(c2), iterations = 0;
  struct ph_mark mark = ph_arena_mark(scratch);
  struct ph_planar_measure m;
  struct work w;
  enum ph_status status = work_init(&w, c2, scratch, b, diag);
  *near = false;
  if (status == PH_OK) {
    memcpy(b, guess, n * sizeof *b);
    *near = newton(c2, &w, false, FOLLOW_CAP, &iterations, &m) &&
            largest(w.b, guess, n) < FOLLOW_NEAR * largest(guess, NULL, n);
    if (w.b != b) {
      memcpy(b, w.b, n * sizeof *b);
    }
  }
  ph_arena_release(scratch, mark);
  return status;
}
