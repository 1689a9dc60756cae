/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The bound of the distance of one cubic, and the inflections of a curve. */
#include "unit.h"
#include "tc_curve_unit.h"

#include "solve/tc/approx.h"

enum { DEGREE_MAX = 24, FAR = 480 };

static double bound_of(const ph_cplx *q, size_t degree, const ph_cplx c[4]) {
  struct ph_tc_match m = {q, {c[0], c[1], c[2], c[3]}};
  ph_cplx *pool =
      ph_arena_array(&unit_arena, ph_tc_match_room(degree), sizeof *pool);
  double bound;
  ck_assert_ptr_nonnull(pool);
  bound = ph_tc_match_distance(&m, degree, 1e-15, (double)INFINITY, pool);
  return bound;
}

/* Of the whole curve. */
static double least_of(const struct ph_tc_bezier *curve, const ph_cplx c[4]) {
  ph_cplx *room = ph_arena_array(&unit_arena, ph_tc_target_room(curve->degree),
                                 sizeof *room);
  struct ph_tc_target target;
  ck_assert_ptr_nonnull(room);
  target = ph_tc_target_of(curve, room);
  return ph_tc_least_distance(&target, 0, 1, c);
}

/* A line is a line, at whatever speed it is travelled. */
PH_TEST(test_line) {
  struct unit_random r = unit_random_of(1);
  for (size_t n = 1; n <= DEGREE_MAX; n++) {
    ph_cplx q[DEGREE_MAX + 1], c[4], d = {.8, -.6};
    double at = 0;
    for (size_t k = 0; k <= n; k++) {
      q[k] = ph_cplx_scale(at, d);
      at += unit_random_in(&r, .01, 1);
    }
    c[0] = q[0];
    c[3] = q[n];
    c[1] = ph_cplx_scale(1.0 / 3, c[3]);
    c[2] = ph_cplx_scale(2.0 / 3, c[3]);
    ck_abs(bound_of(q, n, c), 0, 1e-13);
  }
}

/* Parallel lines, and one that goes further: the distance is known. */
PH_TEST(test_known) {
  const ph_cplx q[] = {{0, .01}, {1, .01}}, longer[] = {{-.02, 0}, {1.03, 0}};
  const ph_cplx c[4] = {{0, 0}, {1 / 3.0, 0}, {2 / 3.0, 0}, {1, 0}};
  ck_rel(bound_of(q, 1, c), .01, 1e-12);
  ck_rel(bound_of(longer, 1, c), .03, 1e-12);
}

/* A part of its own cubic, at another speed: y = x^2 as (x, x^2) with x a
 * quadratic of the parameter is of degree 4.  psi finds it exactly, and keeps
 * it in all halves. */
PH_TEST(test_speed) {
  const double e = .2; /* x = u + e u (1 - u) */
  const ph_cplx c[4] = {{0, 0}, {1 / 3.0, 0}, {2 / 3.0, 1 / 3.0}, {1, 1}};
  const ph_cplx q[5] = {{0, 0},
                        {(1 + e) / 4, 0},
                        {.5 + e / 3, (1 + e) * (1 + e) / 6},
                        {(3 + e) / 4, (1 + e) / 2},
                        {1, 1}};
  ck_abs(bound_of(q, 4, c), 0, 1e-14);
}

/* Not below the distance, and not far above where both run side by side. */
PH_TEST(test_random) {
  struct unit_random r = unit_random_of(2);
  for (int i = 0; i < unit_count(100); i++) {
    struct ph_tc tc = {{ph_cplx_polar(unit_random_in(&r, -.4, .4)),
                        ph_cplx_polar(unit_random_in(&r, -.4, .4))}};
    size_t n = 3 + unit_random_below(&r, DEGREE_MAX - 3);
    ph_cplx q[DEGREE_MAX + 1], c[4];
    struct ph_tc_bezier curve = {q, n, 0};
    struct ph_tc_arc arc = {0, 1, {0, 0}, ph_tc_leg(&tc), tc};
    struct ph_tc_arcs arcs = {.arc = &arc, .n = 1};
    double sampled, bound, away = pow(10, unit_random_in(&r, -6, -2));
    ph_tc_control_points(&tc, arc.start, arc.end, c);
    /* the cubic, raised, with something else between its ends */
    for (size_t k = 0; k <= n; k++) {
      double u = (double)k / (double)n;
      q[k] = k == 0 || k == n ? c[k == 0 ? 0 : 3] : unit_tc_at(&tc, u);
      q[k].im += k == 0 || k == n ? 0 : away * unit_random_in(&r, 0, 1);
    }
    bound = bound_of(q, n, c);
    sampled = unit_arcs_distance(&curve, &arcs);
    ck_assert_msg(sampled <= bound + 1e-14, "%g and %g", sampled, bound);
    ck_assert_msg(bound <= 1.15 * sampled + 1e-12, "%g and %g", sampled, bound);
    ck_assert(least_of(&curve, c) <= sampled);
    /* moved aside */
    for (size_t k = 0; k <= n; k++) {
      q[k].im += 1;
    }
    ck_assert(least_of(&curve, c) <= unit_arcs_distance(&curve, &arcs));
  }
}

/* What is far is known to be. */
PH_TEST(test_least) {
  const ph_cplx q[] = {{0, .5}, {.5, .6}, {1, .5}};
  const ph_cplx c[4] = {{0, 0}, {1 / 3.0, 0}, {2 / 3.0, 0}, {1, 0}};
  const struct ph_tc_bezier curve = {q, 2, 0};
  ck_abs(least_of(&curve, c), .5, .05);
}

/* ---- inflections -------------------------------------------------------- */

static size_t inflections(const ph_cplx *p, size_t degree, double *u) {
  struct ph_tc_bezier curve = {p, degree, 0};
  struct ph_diag diag;
  size_t n;
  ck_assert_int_eq(ph_tc_inflections(&curve, &unit_arena, u, &n, &diag), PH_OK);
  return n;
}

PH_TEST(test_inflections) {
  const ph_cplx s[] = {{0, 0}, {.5, 0}, {.5, 1}, {1, 1}};
  const ph_cplx arch[] = {{0, 0}, {0, 1}, {1, 1}, {1, 0}};
  const ph_cplx line[] = {{0, 0}, {.1, .05}, {.7, .35}, {1, .5}};
  const ph_cplx parabola[] = {{0, 0}, {.5, 1}, {1, 0}};
  double u[8];
  ck_assert_uint_eq(inflections(s, 3, u), 1);
  ck_abs(u[0], .5, 0);
  ck_assert_uint_eq(inflections(arch, 3, u), 0);
  ck_assert_uint_eq(inflections(line, 3, u), 0);
  ck_assert_uint_eq(inflections(parabola, 2, u), 0);
}

/* The graph of a polynomial y with y'' = (u - 1/5) (u - 3/4) has two. */
PH_TEST(test_inflections_of_graph) {
  const double a = .2, b = .75;
  /* y = u^4/12 - (a + b) u^3/6 + a b u^2/2 */
  const double power[5] = {0, 0, a * b / 2, -(a + b) / 6, 1.0 / 12};
  const double binomial[5][5] = {{1, 0, 0, 0, 0},
                                 {1, 1 / 4., 0, 0, 0},
                                 {1, 2 / 4., 1 / 6., 0, 0},
                                 {1, 3 / 4., 3 / 6., 1 / 4., 0},
                                 {1, 1, 1, 1, 1}};
  ph_cplx p[5];
  double u[8];
  for (size_t k = 0; k < 5; k++) {
    p[k] = ph_cplx_of((double)k / 4, 0);
    for (size_t j = 0; j <= k; j++) {
      p[k].im += binomial[k][j] * power[j];
    }
  }
  ck_assert_uint_eq(inflections(p, 4, u), 2);
  ck_abs(u[0], a, 0x1p-31);
  ck_abs(u[1], b, 0x1p-31);
}

/* C' x C'' of a curve. */
static double bend_at(const ph_cplx *p, size_t degree, double u) {
  ph_cplx leg[FAR + 1], first, second;
  for (size_t k = 0; k < degree; k++) {
    leg[k] = ph_cplx_sub(p[k + 1], p[k]);
  }
  first = ph_bern_value(leg, degree - 1, u);
  second = ph_bern_slope(leg, degree - 1, u);
  return ph_cplx_cross(first, second);
}

/* Of high degrees, rough or smooth: between places where a curve bends to
 * different sides, and to different sides of each. */
PH_TEST(test_inflections_far) {
  struct unit_random r = unit_random_of(3);
  for (int trial = 0; trial < 4; trial++) {
    ph_cplx p[FAR + 1];
    double u[2 * FAR], before = 0;
    size_t n = FAR - unit_random_below(&r, 100), found, i = 0;
    for (size_t k = 0; k <= n; k++) {
      double t = (double)k / (double)n, rough = trial % 2 ? .1 : 0;
      p[k] = ph_cplx_of(t + rough * unit_random_in(&r, -1, 1),
                        .2 * sin(20 * t) + rough * unit_random_in(&r, -1, 1));
    }
    found = inflections(p, n, u);
    ck_assert(found >= 5);
    for (int at = 0; at <= 1000; at++) {
      double here = at / 1000.0, bend = bend_at(p, n, here);
      size_t between = 0;
      for (; i < found && u[i] <= here; i++) {
        ck_assert(bend_at(p, n, u[i] - 1e-6) * bend_at(p, n, u[i] + 1e-6) < 0);
        between++;
      }
      ck_that(between % 2 == (bend * before < 0), "%zu by %g", between, here);
      before = bend;
    }
  }
}
