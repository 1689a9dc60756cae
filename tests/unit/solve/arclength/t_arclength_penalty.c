/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * What leads to solutions of arclength from afar: whitened rows against their
 * definition, steps within a radius against their conditions, and the searches
 * on curves of Huard et al. 2014 and on ones that are known to exist.
 */
#include "unit.h"

#include "kernel/band.h"
#include "solve/arclength/arclength.h"

enum { N_MAX = 64 };

/* Data, a system, and the same with whitened rows. */
struct setting {
  struct ph_arc_data data;
  double h[N_MAX], length[N_MAX], chord[N_MAX];
  ph_vec3 step[N_MAX], given[N_MAX + 1];
  struct ph_arc_system plain, white;
  struct ph_arc_work work;
  double *x, *y;
};

static void set_data(struct setting *t, enum ph_arc_mode mode, size_t n) {
  memset(t, 0, sizeof *t);
  t->data.mode = mode;
  t->data.n = n;
  t->data.h = t->h;
  t->data.length = t->length;
  if (mode == PH_ARC_POINTS) {
    t->data.step = t->step;
    t->data.chord = t->chord;
  } else {
    t->data.given = t->given;
  }
  for (size_t i = 0; i < n; i++) {
    t->h[i] = 1;
  }
}

/* The system, where iterations begin, and what they work in. */
static void set_system(struct setting *t, size_t refine, size_t dim) {
  for (size_t i = 0; t->data.step && i < t->data.n; i++) {
    t->chord[i] = ph_vec3_abs(t->step[i]);
  }
  ck_assert(
      ph_arc_system_of(&t->data, refine, dim, true, &unit_arena, &t->plain));
  t->x = ph_arena_array(&unit_arena, t->plain.x_n, sizeof *t->x);
  t->y = ph_arena_array(&unit_arena, t->plain.y_n, sizeof *t->y);
  ck_assert(t->x && t->y && ph_arc_start(&t->plain, &unit_arena, t->x));
  memset(t->y, 0, t->plain.y_n * sizeof *t->y);
  t->white = t->plain;
  ck_assert(ph_arc_whiten(&t->white, &unit_arena));
  ck_assert(ph_arc_work_alloc(&t->white, &unit_arena, &t->work));
}

/* Points of a helix, with its lengths, in the unit in which they are 1. */
static void set_helix(struct setting *t, size_t n) {
  double length = sqrt(4.09) / 2;
  set_data(t, PH_ARC_POINTS, n);
  for (size_t i = 0; i < n; i++) {
    double a = (double)i, b = a + 1;
    t->length[i] = 1;
    t->step[i] = ph_vec3_scale(
        1 / length, ph_vec3_of(cos(b) - cos(a), sin(b) - sin(a), 0.15));
  }
}

/* Points and lengths of a spline whose nodes are on a screw; *unit: that of
 * the data. */
static void set_screw(struct setting *t, size_t n, double *unit) {
  static const double gram[3][3] = {{6, 13, 1}, {13, 54, 13}, {1, 13, 6}};
  set_data(t, PH_ARC_POINTS, n);
  *unit = 0;
  for (size_t i = 0; i < n; i++) {
    double aa = 0, bb = 0, re = 0, im = 0;
    for (size_t j = 0; j < 9; j++) {
      double p = (double)(i + j / 3), q = (double)(i + j % 3);
      double g = gram[j / 3][j % 3];
      aa += g * 0.64 * cos(0.5 * (p - q));
      bb += g * 0.36 * cos(0.3 * (p - q));
      re += g * 0.48 * cos(0.5 * p + 0.3 * q);
      im += g * 0.48 * sin(0.5 * p + 0.3 * q);
    }
    t->length[i] = (aa + bb) / 120;
    t->step[i] = ph_vec3_of((aa - bb) / 120, re / 60, im / 60);
    *unit += t->length[i] / (double)n;
  }
  for (size_t i = 0; i < n; i++) {
    t->length[i] /= *unit;
    t->step[i] = ph_vec3_scale(1 / *unit, t->step[i]);
  }
}

static double largest(const double *v, size_t n) {
  double most = 0;
  for (size_t k = 0; k < n; k++) {
    most = fmax(most, fabs(v[k]));
  }
  return most;
}

/* ---- whitened rows ------------------------------------------------------ */

/* Targets become 1, 1, 0, 0: they are what the rows are relative to. */
PH_TEST(test_white_targets) {
  struct unit_random r;
  r = unit_random_of(1);
  for (int round = 0; round < 20; round++) {
    size_t dim = round % 2 ? 4 : 2;
    struct setting t;
    set_data(&t, PH_ARC_POINTS, 3);
    for (size_t i = 0; i < 3; i++) {
      t.step[i] = ph_vec3_of(unit_random_in(&r, -1, 1), 0.4,
                             dim == 4 ? unit_random_in(&r, -1, 1) : 0);
      t.length[i] = ph_vec3_abs(t.step[i]) * unit_random_in(&r, 1.001, 2);
    }
    set_system(&t, 1, dim);
    for (size_t i = 0; i < 3; i++) {
      size_t n = t.white.forms_n;
      ck_assert_uint_eq(n, dim == 4 ? 4 : 3);
      for (size_t k = 0; k < n; k++) {
        const double *row = t.white.white + (i * n + k) * n;
        double sum = 0;
        for (size_t l = 0; l < n; l++) {
          sum += row[l] * t.white.target[i * n + l];
        }
        ck_abs(sum, k < 2 ? 1 : 0, 1e-12);
      }
    }
  }
}

/* y . c is the same for whitened rows and as they are, and so is its
 * gradient. */
PH_TEST(test_plain) {
  struct unit_random r;
  struct setting t;
  struct ph_arc_linear white, plain;
  double y[4 * N_MAX], sum = 0;
  r = unit_random_of(2);
  set_helix(&t, 6);
  set_system(&t, 1, 4);
  ck_assert(ph_arc_linear_alloc(&t.white, &unit_arena, &white));
  ck_assert(ph_arc_linear_alloc(&t.plain, &unit_arena, &plain));
  for (size_t k = 0; k < t.white.y_n; k++) {
    t.y[k] = unit_random_in(&r, -1, 1);
  }
  ph_arc_linearise(&t.white, t.x, t.y, &white);
  ph_arc_plain(&t.white, t.y, y);
  ph_arc_linearise(&t.plain, t.x, y, &plain);
  for (size_t k = 0; k < t.white.y_n; k++) {
    sum += t.y[k] * white.c[k] - y[k] * plain.c[k];
  }
  ck_abs(sum, 0, 1e-12);
  for (size_t k = 0; k < t.white.x_n; k++) {
    ck_abs(white.l_x[k], plain.l_x[k], 1e-10);
  }
  ph_arc_whitened(&t.white, y, y); /* in place */
  for (size_t k = 0; k < t.white.y_n; k++) {
    ck_abs(y[k], t.y[k], 1e-12);
  }
}

/* Only exact lengths of points have what it takes. */
PH_TEST(test_not_whitened) {
  struct setting t;
  set_data(&t, PH_ARC_TANGENTS, 2);
  t.length[0] = t.length[1] = 1;
  for (size_t j = 0; j < 3; j++) {
    t.given[j] = ph_vec3_unit(ph_vec3_of(1, (double)j, 0.3));
  }
  set_system(&t, 1, 4);
  ck_assert_ptr_null(t.white.white);
  t.y[3] = 7;
  ph_arc_plain(&t.white, t.y, t.x);
  ck_abs(t.x[3], 7, 0);
}

/* ---- steps within a radius ---------------------------------------------- */

enum { ORDER = 12, BAND = 3 };

/* A symmetric band matrix times v. */
static void times(const double *a, const double *v, double *out) {
  for (size_t i = 0; i < ORDER; i++) {
    out[i] = 0;
    for (size_t j = 0; j < ORDER; j++) {
      size_t low = i > j ? i : j, high = i > j ? j : i;
      if (low - high <= BAND) {
        out[i] += a[high * (BAND + 1) + (low - high)] * v[j];
      }
    }
  }
}

static double product(const double *u, const double *v) {
  double sum = 0;
  for (size_t k = 0; k < ORDER; k++) {
    sum += u[k] * v[k];
  }
  return sum;
}

/* By how much the model falls along a step. */
static double fall_along(const struct ph_arc_region *r, const double *step) {
  double as[ORDER];
  times(r->matrix, step, as);
  return -product(r->g, step) - product(step, as) / 2;
}

static void random_model(struct unit_random *random, double definite,
                         struct ph_arc_region *r) {
  memset(r->matrix, 0, ph_sym_size(ORDER, BAND) * sizeof *r->matrix);
  for (size_t j = 0; j < ORDER; j++) {
    for (size_t i = j; i < ORDER && i <= j + BAND; i++) {
      *ph_sym_at(r->matrix, BAND, i, j) =
          unit_random_in(random, -1, 1) + (i == j ? definite : 0);
    }
    r->g[j] = unit_random_in(random, -1, 1);
  }
}

/* No step of this length is better by more than a share: neither random ones,
 * nor ones nearby. */
static void check_best(struct unit_random *random,
                       const struct ph_arc_region *r, double share) {
  for (int k = 0; k < 100; k++) {
    double other[ORDER], size, near = k % 2 ? 1e-2 : 10;
    for (size_t i = 0; i < ORDER; i++) {
      other[i] = r->step[i] + near * r->length * unit_random_in(random, -1, 1);
    }
    size = sqrt(product(other, other));
    for (size_t i = 0; i < ORDER; i++) {
      other[i] *= r->length / size;
    }
    ck_assert(fall_along(r, other) <= fall_along(r, r->step) * (1 + share));
  }
}

PH_TEST(test_region) {
  struct unit_random random;
  struct ph_arc_region r;
  int shifted = 0, along = 0, free = 0;
  random = unit_random_of(3);
  ck_assert(ph_arc_region_alloc(ORDER, BAND, &unit_arena, &r));
  for (int round = 0; round < unit_count(200); round++) {
    double radius = pow(10, unit_random_in(&random, -3, 2));
    bool lowest;
    random_model(&random, round % 4 * 1.5, &r);
    ck_assert(ph_arc_region_step(&r, radius, 0));
    ck_rel(r.length, sqrt(product(r.step, r.step)), 1e-10);
    ck_assert(r.length <= 1.6 * radius);
    ck_assert(r.shift <= 0 || r.length >= 0.5 * radius);
    /* to the radius along the lowest direction, which is known roughly */
    lowest = r.shift > 0 && unit_near_rel(r.length, radius, 1e-12);
    ck_rel(r.fall, fall_along(&r, r.step), 1e-6);
    check_best(&random, &r, lowest ? 0.05 : 1e-9);
    shifted += r.shift > 0 && !lowest;
    along += lowest;
    free += !(r.shift > 0);
  }
  ck_assert(shifted > 0 && along > 0 && free > 0);
}

/* A shift that is known to be too small is not tried. */
PH_TEST(test_region_above) {
  struct unit_random random;
  struct ph_arc_region r;
  random = unit_random_of(4);
  ck_assert(ph_arc_region_alloc(ORDER, BAND, &unit_arena, &r));
  random_model(&random, 6, &r);
  ck_assert(ph_arc_region_step(&r, 1e3, 0));
  ck_abs(r.shift, 0, 0);
  ck_assert(ph_arc_region_step(&r, r.length / 4, 0.5));
  ck_assert(r.shift > 0.5);
}

/* From a saddle, where the gradient vanishes, the step leads down. */
PH_TEST(test_region_saddle) {
  struct ph_arc_region r;
  ck_assert(ph_arc_region_alloc(ORDER, BAND, &unit_arena, &r));
  memset(r.matrix, 0, ph_sym_size(ORDER, BAND) * sizeof *r.matrix);
  memset(r.g, 0, ORDER * sizeof *r.g);
  for (size_t k = 0; k < ORDER; k++) {
    *ph_sym_at(r.matrix, BAND, k, k) = k == 5 ? -1 : 2;
  }
  ck_assert(ph_arc_region_step(&r, 0.1, 0));
  ck_rel(r.length, 0.1, 1e-12);
  ck_rel(fabs(r.step[5]), 0.1, 1e-3);
  ck_assert(fall_along(&r, r.step) > 0.0049);
}

PH_TEST(test_region_not_finite) {
  struct ph_arc_region r;
  ck_assert(ph_arc_region_alloc(ORDER, BAND, &unit_arena, &r));
  memset(r.matrix, 0, ph_sym_size(ORDER, BAND) * sizeof *r.matrix);
  memset(r.g, 0, ORDER * sizeof *r.g);
  *ph_sym_at(r.matrix, BAND, 4, 4) = (double)NAN;
  ck_assert(!ph_arc_region_step(&r, 1, 0));
}

/* ---- searches ----------------------------------------------------------- */

/* Lengths far below what the points ask for. */
PH_TEST(test_not_feasible) {
  struct setting t;
  struct ph_arc_penalty_report report;
  const struct ph_arc_penalty_options options = {1e3,  1e8, 1e-6,
                                                 1e-6, 60,  1e-3};
  set_helix(&t, 5);
  for (size_t i = 0; i < 5; i++) {
    t.length[i] = 0.8;
  }
  set_system(&t, 1, 4);
  ck_assert(!ph_arc_penalty(&t.plain, &options, &t.work, t.x, t.y, &report));
  ck_assert(report.rows > 1e-2);
  ck_assert_uint_le(report.iterations, 60);
}

/* The rows hold, F is a known one, in the user's unit, and the multipliers
 * make the gradient vanish. */
static void check_penalty(struct setting *t, double rho, double unit,
                          double f) {
  const struct ph_arc_penalty_options options = {rho,  1e8, 1e-9,
                                                 1e-6, 200, 1e-3};
  struct ph_arc_penalty_report report;
  ck_assert(ph_arc_penalty(&t->white, &options, &t->work, t->x, t->y, &report));
  ck_assert(report.rows <= 1e-9);
  ck_assert_uint_le(report.iterations, 100);
  ck_assert_uint_ge(report.factors, report.iterations);
  ph_arc_plain(&t->white, t->y, t->y);
  ph_arc_linearise(&t->plain, t->x, t->y, &t->work.linear);
  ck_assert(largest(t->work.linear.c, t->plain.y_n) <= 1e-8);
  ck_assert(largest(t->work.linear.l_x, t->plain.x_n) <=
            1e-4 * (1 + largest(t->y, t->plain.y_n)));
  ck_rel(t->work.linear.f * unit, f, 1e-5);
}

PH_TEST(test_penalty_helix) {
  static const struct {
    size_t n;
    double rho, f;
  } cases[] = {{5, 100, 0.523280},
               {5, 1e4, 0.523280},
               {6, 100, 0.704614497},
               {20, 100, 4.17148826}};
  for (size_t k = 0; k < 4; k++) {
    struct setting t;
    set_helix(&t, cases[k].n);
    set_system(&t, 1, 4);
    check_penalty(&t, cases[k].rho, sqrt(4.09) / 2, cases[k].f);
  }
}

PH_TEST(test_penalty_screw) {
  static const struct {
    size_t n;
    double f;
  } cases[] = {{5, 0.120789915}, {6, 0.145252923}, {20, 0.530699943}};
  for (size_t k = 0; k < 3; k++) {
    struct setting t;
    double unit;
    set_screw(&t, cases[k].n, &unit);
    set_system(&t, 1, 4);
    check_penalty(&t, 1e4, unit, cases[k].f);
  }
}

/* Derivatives of the paper's fig. 14, and directions of a helix. */
PH_TEST(test_penalty_given) {
  struct setting t;
  set_data(&t, PH_ARC_DERIVATIVES, 3);
  t.given[0] = t.given[3] = ph_vec3_of(1, 0, 0);
  t.given[1] = ph_vec3_of(0, 1, 0);
  t.given[2] = ph_vec3_of(0, 0, 1);
  t.length[0] = t.length[1] = t.length[2] = 1;
  set_system(&t, 1, 4);
  check_penalty(&t, 100, 1, 3.0767995711);
  set_data(&t, PH_ARC_TANGENTS, 5);
  for (size_t j = 0; j <= 5; j++) {
    double a = (double)j;
    t.given[j] = ph_vec3_unit(ph_vec3_of(-2 * sin(a), 2 * cos(a), 0.3));
    t.length[j < 5 ? j : 4] = 1;
  }
  set_system(&t, 1, 4);
  check_penalty(&t, 100, sqrt(4.09) / 2, 0.252645188);
}

/* Data of the sine, in their plane: the curve there is the paper's fig. 3. */
PH_TEST(test_penalty_plane) {
  static const double length[] = {1.364647438430407, 1.0909029121668972,
                                  1.3646474384304073};
  struct setting t;
  double unit = (length[0] + length[1] + length[2]) / 3, pi = acos(-1);
  set_data(&t, PH_ARC_POINTS, 3);
  for (size_t i = 0; i < 3; i++) {
    double a = pi / 3 * (double)i, b = a + pi / 3;
    t.length[i] = length[i] / unit;
    t.step[i] = ph_vec3_scale(1 / unit, ph_vec3_of(b - a, sin(b) - sin(a), 0));
  }
  set_system(&t, 1, 2);
  check_penalty(&t, 100, unit, 2.2463116060159027);
}

/* A circle with two segments in each interval. */
PH_TEST(test_penalty_closed) {
  const struct ph_arc_penalty_options options = {10,   1e8, 1e-9,
                                                 1e-6, 200, 1e-3};
  struct ph_arc_penalty_report report;
  struct setting t;
  double angle = acos(-1) / 4;
  set_data(&t, PH_ARC_POINTS, 8);
  t.data.closed = true;
  for (size_t i = 0; i < 8; i++) {
    double a = angle * (double)i;
    t.length[i] = 1;
    t.step[i] =
        ph_vec3_scale(1 / angle, ph_vec3_of(cos(a + angle) - cos(a),
                                            sin(a + angle) - sin(a), 0));
  }
  set_system(&t, 2, 4);
  ck_assert(ph_arc_penalty(&t.white, &options, &t.work, t.x, t.y, &report));
  ph_arc_residual(&t.plain, t.x, t.work.c);
  ck_assert(largest(t.work.c, t.plain.y_n) <= 1e-8);
}

/* Nodes keep their lengths and directions; a turn back undoes it. */
PH_TEST(test_twist) {
  struct setting t;
  double x[4 * (N_MAX + 2)];
  set_helix(&t, 5);
  set_system(&t, 1, 4);
  memcpy(x, t.x, t.plain.x_n * sizeof *x);
  ph_arc_twist(&t.plain, 0.2, t.x);
  for (size_t j = 0; j < 7; j++) {
    const double *u = x + 4 * j, *v = t.x + 4 * j;
    ck_rel(v[0] * v[0] + v[1] * v[1], u[0] * u[0] + u[1] * u[1], 1e-14);
    ck_rel(v[2] * v[2] + v[3] * v[3], u[2] * u[2] + u[3] * u[3], 1e-14);
    ck_abs(u[0] * v[1] - u[1] * v[0] + u[2] * v[3] - u[3] * v[2],
           (j % 2 ? -1 : 1) * sin(0.2) *
               (u[0] * u[0] + u[1] * u[1] + u[2] * u[2] + u[3] * u[3]),
           1e-14);
  }
  ph_arc_twist(&t.plain, -0.2, t.x);
  for (size_t k = 0; k < t.plain.x_n; k++) {
    ck_abs(t.x[k], x[k], 1e-15);
  }
}

/* What the search finds is where Newton's method begins: few steps are left. */
PH_TEST(test_penalty_newton) {
  const struct ph_arc_penalty_options options = {100,  1e8, 1e-4,
                                                 1e-6, 200, 1e-3};
  struct ph_arc_penalty_report report;
  struct ph_arc_newton newton;
  struct ph_arc_point point;
  struct setting t;
  set_helix(&t, 6);
  set_system(&t, 1, 4);
  ck_assert(ph_arc_newton_alloc(&t.plain, &unit_arena, &newton));
  ck_assert(ph_arc_point_alloc(&t.plain, &unit_arena, &point));
  ck_assert(ph_arc_penalty(&t.white, &options, &t.work, t.x, t.y, &report));
  memcpy(point.x, t.x, t.plain.x_n * sizeof *t.x);
  ph_arc_plain(&t.white, t.y, point.y);
  ck_assert(ph_arc_newton_solve(&t.plain, &newton, 20, &point));
  ck_assert(point.minimiser);
  ck_assert_uint_le(point.iterations, 4);
  ck_rel(point.f * sqrt(4.09) / 2, 0.704614496874, 1e-9);
}

/* ---- windows ------------------------------------------------------------ */

/* Helices, open, by directions, and a closed curve. */
static void set_long(struct setting *t, int sort) {
  double angle = acos(-1) / 30;
  if (sort < 3) {
    set_helix(t, 60);
    for (size_t i = 0; i < 60; i++) {
      t->length[i] *= i % 7 == 0 ? 1.3 : 1.1;
    }
  } else if (sort == 3) {
    set_data(t, PH_ARC_TANGENTS, 60);
    for (size_t i = 0; i <= 60; i++) {
      double a = 0.3 * (double)i;
      t->given[i] = ph_vec3_unit(ph_vec3_of(-sin(a), cos(a), 0.3));
      t->length[i % 60] = i % 2 ? 1.1 : 1;
    }
  } else {
    set_data(t, PH_ARC_POINTS, 60);
    t->data.closed = true;
    for (size_t i = 0; i < 60; i++) {
      double a = angle * (double)i, b = a + angle, up = i % 2 ? 0.2 : -0.2;
      t->length[i] = 1.1;
      t->step[i] =
          ph_vec3_of((cos(b) - cos(a)) / angle, (sin(b) - sin(a)) / angle, up);
    }
  }
  set_system(t, sort < 3 ? (size_t)sort + 1 : 2, 4);
}

/* What is minimised. */
static double value_of(struct setting *t, double rho) {
  double sum = 0;
  ph_arc_residual(&t->white, t->x, t->work.c);
  for (size_t r = 0; r < t->white.y_n; r++) {
    sum += t->work.c[r] * (t->y[r] + rho / 2 * t->work.c[r]);
  }
  return ph_arc_functional(&t->white, t->x) + sum;
}

/* No interval is in two windows of a sweep, every node is in one of either. */
PH_TEST_EACH(test_windows, 5) {
  struct setting t;
  const struct ph_arc_windows *w = &t.work.windows;
  int seen[4 * (3 * N_MAX + 2) + 1] = {0};
  set_long(&t, _i);
  ck_assert(w->n >= 4);
  for (size_t sweep = 0; sweep < 2; sweep++) {
    int touched[N_MAX] = {0};
    for (size_t k = w->part[sweep]; k < w->part[sweep + 1]; k++) {
      for (size_t p = w->window[k].low; p < w->window[k].high; p++) {
        seen[p]++;
      }
      for (size_t p = w->window[k].first; p < w->window[k].last; p++) {
        ck_assert_int_eq(touched[w->interval[p]]++, 0);
      }
    }
  }
  for (size_t p = t.white.turn ? 1 : 0; p < t.white.x_n; p++) {
    ck_assert_int_ge(seen[p], 1);
  }
}

/* Sweeps lower what is minimised, and their falls are those of the windows. */
PH_TEST_EACH(test_sweeps, 5) {
  struct setting t;
  struct ph_arc_lagrangian g;
  double first, before, after = 0;
  set_long(&t, _i);
  g = (struct ph_arc_lagrangian){
      .s = &t.white, .w = &t.work, .x = t.x, .y = t.y, .rho = 100};
  first = before = value_of(&t, g.rho);
  ph_arc_windows_begin(&g);
  for (size_t k = 0; k < 6; k++) {
    ph_arc_sweep(&g, k % 2);
    after = value_of(&t, g.rho);
    ck_assert_double_le(after, before * (1 + 1e-14));
    before = after;
  }
  ck_assert_double_lt(after, 0.9 * first);
}

/* Lengths that yield: what Newton's method finds. */
PH_TEST(test_penalty_soft) {
  const struct ph_arc_penalty_options options = {100,  1e8, 1e-9,
                                                 1e-9, 200, 1e-3};
  struct ph_arc_penalty_report report;
  struct ph_arc_newton newton;
  struct ph_arc_point point;
  struct setting t;
  set_helix(&t, 30);
  for (size_t i = 0; i < 30; i++) {
    t.length[i] += i % 3 ? 0.01 : -0.01;
  }
  t.data.sigma = 0.01;
  set_system(&t, 2, 4);
  ck_assert(ph_arc_soften(&t.plain, 1, &unit_arena));
  t.white = t.plain;
  ck_assert(ph_arc_newton_alloc(&t.plain, &unit_arena, &newton));
  ck_assert(ph_arc_point_alloc(&t.plain, &unit_arena, &point));
  memcpy(point.x, t.x, t.plain.x_n * sizeof *t.x);
  ck_assert(ph_arc_newton_solve(&t.plain, &newton, 50, &point));
  ck_assert(ph_arc_penalty(&t.white, &options, &t.work, t.x, t.y, &report));
  ck_rel(ph_arc_functional(&t.plain, t.x), point.f, 1e-6);
  for (size_t r = 0; r < t.plain.y_n; r++) {
    ck_abs(t.y[r], point.y[r], 1e-4 * largest(point.y, t.plain.y_n));
  }
}
