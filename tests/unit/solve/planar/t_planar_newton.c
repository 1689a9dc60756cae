/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The iteration that solves the C2 equations.  Newton from the chord start
 * solves practically everything, so that what comes after it is reached by
 * few data: this test includes the source for its static functions, and starts
 * each of the two by itself.
 */
#include "solve/planar/newton.c" /* NOLINT */

#include "segment_unit.h"
#include "unit.h"

enum { N_MAX = 60, SYSTEMS = 150 };

static const double PI = 3.14159265358979323846;

/* The equations with room of their own, chordal knots. */
struct system {
  struct ph_planar_c2 c2;
  ph_cplx direction[N_MAX];
  double ratio[N_MAX], y[N_MAX + 1], chord[N_MAX];
};

static struct ph_diag diag;

/* The equations of points at unit scale with spacings h, h NULL: chordal. */
static void set_points(struct system *s, const ph_cplx *point, size_t n,
                       bool closed, const double *h) {
  s->c2 = (struct ph_planar_c2){.n = n,
                                .closed = closed,
                                .direction = s->direction,
                                .space = &ph_quintic,
                                .ratio = s->ratio,
                                .y = s->y};
  for (size_t k = 0; k < n; k++) {
    const ph_cplx *to = &point[closed && k + 1 == n ? 0 : k + 1];
    ph_cplx c = ph_cplx_sub(*to, point[k]);
    s->chord[k] = ph_cplx_abs(c);
    s->direction[k] = ph_cplx_scale(1 / s->chord[k], c);
  }
  h = h ? h : s->chord;
  for (size_t k = 0; k < n; k++) {
    s->ratio[k] = h[k] / s->chord[k];
    s->y[k] = k ? h[k] / (h[k - 1] + h[k]) : 0.5;
  }
  s->y[n] = 0.5;
  if (closed) {
    s->y[0] = s->y[n] = h[0] / (h[n - 1] + h[0]);
  }
  for (int side = 0; side < 2; side++) {
    s->c2.end[side] = s->direction[side ? n - 1 : 0];
    s->c2.end_size[side] = 1;
  }
}

/* A polygon that turns by at most `sharp` at each point; if closed, around a
 * circle with noise. */
static void random_points(struct unit_random *r, bool closed, double sharp,
                          ph_cplx *point, size_t *n) {
  double heading = unit_random_in(r, -3, 3);
  *n = 3 + unit_random_below(r, N_MAX - 3);
  point[0] = ph_cplx_of(0, 0);
  for (size_t k = 0; k <= *n && !closed; k++) {
    ph_cplx step =
        ph_cplx_scale(unit_random_in(r, 0.3, 2), ph_cplx_polar(heading));
    if (k < *n) {
      point[k + 1] = ph_cplx_add(point[k], step);
    }
    heading += unit_random_in(r, -sharp, sharp);
  }
  for (size_t k = 0; k < *n && closed; k++) {
    double angle =
        2 * PI * ((double)k + unit_random_in(r, 0, 0.7)) / (double)*n;
    point[k] = ph_cplx_scale(unit_random_in(r, 1, 1.2) * (double)*n / 6,
                             ph_cplx_polar(angle));
  }
}

static struct work work_of(size_t n) {
  struct work w = {.arena = &unit_arena};
  w.b = ph_arena_array(&unit_arena, n, sizeof *w.b);
  w.step = ph_arena_array(&unit_arena, n + 1, sizeof *w.step);
  ck_assert(w.b && w.step);
  ck_assert(ph_tri_alloc(&w.tri, &unit_arena, n));
  return w;
}

/* Newton from the chord start or from the spline's midpoints, as the solver
 * goes about it. */
static bool from_start(struct system *s, struct work *w, bool spline,
                       size_t *iterations) {
  struct ph_planar_measure m;
  *iterations = 0;
  return solve_from(&s->c2, w, spline ? start_from_spline : start_from_chords,
                    iterations, &m);
}

/* Largest difference of two vectors of unknowns, up to their sign, relative
 * to the largest of them. */
static double apart(const ph_cplx *a, const ph_cplx *b, size_t n) {
  double minus = 0, plus = 0, size = 0;
  for (size_t i = 0; i < n; i++) {
    minus = unit_larger(minus, unit_distance(a[i], b[i]));
    plus = unit_larger(plus, ph_cplx_abs(ph_cplx_add(a[i], b[i])));
    size = fmax(size, ph_cplx_abs(a[i]));
  }
  return fmin(minus, plus) / size;
}

/* On data that turn gently both lead to the same curve. */
PH_TEST(test_starts_agree) {
  struct unit_random r = unit_random_of(1);
  for (int i = 0; i < SYSTEMS; i++) {
    ph_cplx point[N_MAX + 1];
    struct system s;
    struct work a, b;
    size_t n, unknowns, iterations;
    random_points(&r, i % 2, PI / 3, point, &n);
    set_points(&s, point, n, i % 2, NULL);
    unknowns = ph_planar_unknowns(&s.c2);
    a = work_of(unknowns);
    b = work_of(unknowns);
    ck_assert(from_start(&s, &a, false, &iterations));
    ck_assert_uint_le(iterations, 6);
    ck_assert(from_start(&s, &b, true, &iterations));
    ck_assert_uint_le(iterations, 6);
    ck_assert_msg(apart(a.b, b.b, unknowns) <= 1e-10,
                  "seed %lu, system %d of %zu: %.3g", unit_seed(), i, n,
                  apart(a.b, b.b, unknowns));
    ph_arena_reset(&unit_arena);
  }
}

/* The number of steps does not depend on the number of points. */
PH_TEST(test_long) {
  enum { N = 20000 };
  ph_cplx *direction = malloc(N * sizeof *direction);
  ph_cplx *b = malloc(N * sizeof *b);
  double *ratio = malloc(N * sizeof *ratio);
  double *y = malloc((N + 1) * sizeof *y);
  struct ph_planar_c2 c2 = {.n = N,
                            .closed = true,
                            .direction = direction,
                            .space = &ph_quintic,
                            .ratio = ratio,
                            .y = y};
  struct ph_planar_report report;
  struct unit_random r = unit_random_of(3);
  double heading = 0;
  ck_assert(direction && b && ratio && y);
  for (size_t k = 0; k < N; k++) {
    direction[k] = ph_cplx_polar(heading);
    heading += unit_random_in(&r, -1, 1);
    ratio[k] = 1;
    y[k] = 0.5;
  }
  y[N] = 0.5;
  ck_assert_int_eq(ph_planar_c2_solve(&c2, &unit_arena, b, &report, &diag),
                   PH_OK);
  ck_assert_uint_le(report.iterations, 6);
  ck_assert_double_le(report.residual, 1e-13);
  ck_assert_uint_lt(report.worst, N);
  free(direction);
  free(b);
  free(ratio);
  free(y);
}

/* Knots that have nothing to do with the points: Newton from the chord start
 * gives up, the midpoint start goes through. */
PH_TEST(test_midpoint_start) {
  const ph_cplx point[4] = {{4, -5}, {3, -4}, {-3, 2}, {-4, 3}};
  const double h[4] = {1e-5, 1e-3, 1e-5, 0.1};
  struct system s;
  struct work w;
  ph_cplx b[4];
  struct ph_planar_report report;
  size_t chord, spline;
  set_points(&s, point, 4, true, h);
  w = work_of(4);
  ck_assert(!from_start(&s, &w, false, &chord));
  ck_assert(from_start(&s, &w, true, &spline));
  ck_assert_int_eq(ph_planar_c2_solve(&s.c2, &unit_arena, b, &report, &diag),
                   PH_OK);
  ck_assert_uint_eq(report.iterations, chord + spline);
  ck_assert_double_le(report.residual, 1e-6);
}

/* No solution at all: a chord in an interval of length zero. */
PH_TEST(test_no_convergence) {
  const ph_cplx point[4] = {{0, 0}, {1, 0}, {2, 1}, {3, 0}};
  for (int closed = 0; closed < 2; closed++) {
    struct ph_planar_report report;
    struct system s;
    ph_cplx b[6];
    set_points(&s, point, 3, closed, NULL);
    s.ratio[1] = 0;
    ck_assert_int_eq(ph_planar_c2_solve(&s.c2, &unit_arena, b, &report, &diag),
                     PH_E_NO_CONVERGENCE);
    ck_assert_int_eq(diag.status, PH_E_NO_CONVERGENCE);
    ck_assert_str_eq(diag.message,
                     "the iteration leaves the range of a double");
    ck_assert_str_eq(diag.field, "");
  }
}
