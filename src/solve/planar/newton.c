/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Solves the C2 equations (c2.h): Newton from two starts, damped where
 * it fails plain.
 *
 * Newton from the chord start has not failed on any of the data that the
 * method was measured on; the midpoint start is there for what was not.  The
 * number of steps does not depend on n.
 */
#include "solve/planar/c2.h"

#include "base/team.h"

#include <float.h>
#include <math.h>
#include <string.h>

/* Relative closing error of a segment that counts as solved. */
static const double SOLVED = 1e-13;
/* In units of the terms of F: rounding can not be expected to do better. */
static const double ROUNDING = 1e3 * DBL_EPSILON;
/* Sufficient decrease, and the shortest step worth trying (Kelley 1995). */
static const double DECREASE = 1e-4, SHORTEST = 1e-6;

/* From so many segments on, a millisecond, two threads look for two solutions.
 */
enum { LONG = 2048 };

enum { PLAIN_CAP = 25, NEWTON_CAP = 60, FOLLOW_CAP = 12 };

/* A corrector that moves the unknowns by more than this has changed branch. */
static const double FOLLOW_NEAR = 0.5;

struct work {
  const struct ph_arena *arena; /* knows how much time there is */
  struct ph_tri tri;
  double *inverse; /* [n] of the quick way, or NULL: not that */
  ph_cplx *b;      /* the iterate */
  ph_cplx *step;   /* Newton's step, then the next iterate; start values */
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

static double largest(const ph_cplx *a, const ph_cplx *b, size_t n) {
  double max2 = 0;
  for (size_t i = 0; i < n; i++) {
    double d2 = ph_cplx_norm2(b ? ph_cplx_sub(a[i], b[i]) : a[i]);
    max2 = d2 > max2 ? d2 : max2;
  }
  return sqrt(max2);
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

/* The quick way, and Newton from where it ends. */
static bool try_quick(struct ph_planar_c2 *c2, struct work *w,
                      size_t *iterations, struct ph_planar_measure *m) {
  const struct ph_planar_measure none = {0, HUGE_VAL, 0};
  enum ph_planar_quick found = PH_PLANAR_QUICK_NONE;
  if (w->inverse) {
    found = ph_planar_c2_quick(c2, w->arena, SOLVED, w->b, w->step, w->inverse,
                               w->tri.far, iterations, m);
  }
  if (found == PH_PLANAR_QUICK_SOLVED ||
      (found == PH_PLANAR_QUICK_NEAR &&
       newton(c2, w, false, PLAIN_CAP, iterations, m))) {
    return true;
  }
  *m = none;
  return false;
}

static bool try_starts(struct ph_planar_c2 *c2, struct work *w,
                       size_t *iterations, struct ph_planar_measure *m) {
  static start_fn *const starts[] = {start_from_chords, start_from_spline};
  bool solved = try_quick(c2, w, iterations, m);
  for (size_t i = 0; i < sizeof starts / sizeof starts[0] && !solved; i++) {
    struct ph_planar_measure last = {0, HUGE_VAL, 0};
    solved = solve_from(c2, w, starts[i], iterations, &last);
    if (solved || (isfinite(last.sum2) && last.max2 < m->max2)) {
      *m = last; /* the better of the two, for the report */
    }
  }
  return solved;
}

static enum ph_status work_init(struct work *w, const struct ph_planar_c2 *c2,
                                struct ph_arena *scratch, ph_cplx *b,
                                struct ph_diag *diag) {
  size_t n = ph_planar_unknowns(c2);
  w->b = b;
  w->arena = scratch;
  /* One more: the knot derivatives of a closed cubic spline. */
  w->step = ph_arena_array(scratch, n + 1, sizeof *w->step);
  w->inverse = NULL;
  if (!w->step || !ph_tri_alloc(&w->tri, scratch, n)) {
    return ph_fail_memory(diag);
  }
  if (c2->n >= PH_PLANAR_QUICK_LEAST && c2->space_stride == 0 &&
      !(fabs(c2->space->angle) > 0) && !c2->turned) {
    w->inverse = ph_arena_array(scratch, n, sizeof *w->inverse);
    return w->inverse ? PH_OK : ph_fail_memory(diag);
  }
  return PH_OK;
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
               ? ph_fail_at(diag, PH_E_NO_CONVERGENCE, "segments", m->worst,
                            "does not close: the best relative residual "
                            "reached is %.3g",
                            report->residual)
               : ph_fail(diag, PH_E_NO_CONVERGENCE, NULL,
                         "the iteration leaves the range of a double");
  }
  for (size_t i = 0; w->b != b && i < ph_planar_unknowns(c2); i++) {
    b[i] = w->b[i];
  }
  return PH_OK;
}

/* A way to find a solution, from whatever starts it takes. */
typedef bool search(struct ph_planar_c2 *c2, struct work *w, size_t *iterations,
                    struct ph_planar_measure *m);

static bool from_spline(struct ph_planar_c2 *c2, struct work *w,
                        size_t *iterations, struct ph_planar_measure *m) {
  return solve_from(c2, w, start_from_spline, iterations, m);
}

static bool from_chords(struct ph_planar_c2 *c2, struct work *w,
                        size_t *iterations, struct ph_planar_measure *m) {
  start_from_chords(c2, w);
  return newton(c2, w, false, PLAIN_CAP, iterations, m);
}

static enum ph_status solve_with(struct ph_planar_c2 *c2, search *find,
                                 struct work *w, ph_cplx *b,
                                 struct ph_planar_report *report,
                                 struct ph_diag *diag) {
  struct ph_planar_measure m = {0, HUGE_VAL, 0};
  bool solved;
  report->iterations = 0;
  solved = find(c2, w, &report->iterations, &m);
  return conclude(c2, w, solved, &m, b, report, diag);
}

static enum ph_status solve_by(struct ph_planar_c2 *c2, search *find,
                               struct ph_arena *scratch, ph_cplx *b,
                               struct ph_planar_report *report,
                               struct ph_diag *diag) {
  const struct ph_mark mark = ph_arena_mark(scratch);
  struct work w;
  enum ph_status status = work_init(&w, c2, scratch, b, diag);
  if (status == PH_OK) {
    status = solve_with(c2, find, &w, b, report, diag);
  }
  ph_arena_release(scratch, mark);
  return status;
}

enum ph_status ph_planar_c2_solve(struct ph_planar_c2 *c2,
                                  struct ph_arena *scratch, ph_cplx *b,
                                  struct ph_planar_report *report,
                                  struct ph_diag *diag) {
  return solve_by(c2, try_starts, scratch, b, report, diag);
}

/* A solution from the first starts, and one from the second. */
struct both {
  struct ph_planar_c2 c2[2];
  struct work w[2];
  ph_cplx *b[2];
  struct ph_planar_report *report[2];
  struct ph_diag *diag[2];
  enum ph_status status[2];
};

static bool solve_one(void *context, size_t thread, size_t first, size_t end) {
  static search *const find[2] = {try_starts, from_spline};
  struct both *s = context;
  (void)thread;
  for (size_t i = first; i < end; i++) {
    s->status[i] = solve_with(&s->c2[i], find[i], &s->w[i], s->b[i],
                              s->report[i], s->diag[i]);
  }
  return true;
}

enum ph_status ph_planar_c2_both(struct ph_planar_c2 *c2,
                                 struct ph_arena *scratch, ph_cplx *b,
                                 struct ph_planar_report *report,
                                 struct ph_planar_second *second,
                                 struct ph_diag *diag) {
  const size_t worth = c2->n < LONG ? 2 : 1;
  struct ph_mark mark;
  struct both s = {.c2 = {*c2, *c2},
                   .report = {report, &second->report},
                   .diag = {diag, &second->why}};
  bool good;
  second->b = ph_arena_array(scratch, ph_planar_unknowns(c2), sizeof *b);
  s.b[0] = b;
  s.b[1] = second->b;
  mark = ph_arena_mark(scratch);
  good = second->b != NULL;
  for (size_t i = 0; good && i < 2; i++) {
    good = work_init(&s.w[i], c2, scratch, s.b[i], diag) == PH_OK;
  }
  if (good) {
    ph_team_share(scratch, 2, worth, 1, solve_one, &s);
  }
  ph_arena_release(scratch, mark);
  c2->twist = s.c2[0].twist;
  second->twist = s.c2[1].twist;
  second->status = s.status[1];
  return good ? s.status[0] : ph_fail_memory(diag);
}

enum ph_status ph_planar_c2_turned(struct ph_planar_c2 *c2, const bool *turned,
                                   struct ph_arena *scratch, ph_cplx *b,
                                   struct ph_planar_report *report,
                                   struct ph_diag *diag) {
  enum ph_status status;
  c2->turned = turned;
  status = solve_by(c2, from_chords, scratch, b, report, diag);
  c2->turned = NULL;
  return status;
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
