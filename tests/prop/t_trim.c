/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * What every trimmed offset of a closed curve promises, on random ones: by
 * brute force from control points, no place of it is nearer to the curve than
 * the distance; pieces meet; its area changes by its length; and it is the same
 * however the curve is moved, turned, scaled, reversed or begun.
 *
 * The seed is 1, or PH_SEED; PH_LONG=1 takes ten times as many curves.
 * tests/cli/trim_many.py compares more of them with buffers of GEOS.
 */
#include "planar_unit.h"
#include "segment_unit.h"
#include "unit.h"

#include "check/loop.h"
#include "curve/offset/offset.h"
#include "kernel/pi.h"

#include <string.h>

enum { CURVES = 60, POINTS_MAX = 25, EACH = 32, PLACES = 5, STEPS = 8 };

static const struct ph_offset_rules trimmed = {.mode = PH_OFFSET_TRIMMED,
                                               .tolerance = 1e-9};

static struct unit_solution u;
static struct ph_offset offset;
static size_t curves;

struct points {
  ph_cplx p[POINTS_MAX];
  size_t n;
};

static size_t trials(void) {
  return unit_long() ? 10 * CURVES : (size_t)unit_count(CURVES);
}

static void finish(void) {
  unit_solution_free(&u);
}

/* A curve around the origin with bays and necks. */
static struct points any_points(struct unit_random *r) {
  struct points points = {.n = 6 + unit_random_below(r, POINTS_MAX - 5)};
  for (size_t i = 0; i < points.n; i++) {
    const double at = (double)i + unit_random_in(r, -0.4, 0.4);
    points.p[i] =
        ph_cplx_scale(unit_random_in(r, 3, 12),
                      ph_cplx_polar(2 * PH_PI * at / (double)points.n));
  }
  return points;
}

static void solve(const struct points *points) {
  unit_solution_free(&u);
  u = unit_planar_of(&points->p[0].re, points->n, true);
  ck_that(unit_planar_solve(&u) == PH_OK, "curve %zu: %s", curves,
          u.diag.message);
}

/* One that does not cross itself, solved. */
static struct points random_points(struct unit_random *r) {
  struct points points;
  int tries = 0;
  do {
    ck_assert(++tries < 100);
    points = any_points(r);
    solve(&points);
  } while (!(u.result.diagnostics.value[PH_D_SIMPLE] > 0));
  return points;
}

/* The offset of the curve, certified. */
static const struct ph_loops *offset_at(double distance) {
  enum ph_status status = ph_offset(&u.result.curve, distance, &trimmed,
                                    &u.arena, &offset, &u.diag);
  if (status == PH_OK) {
    struct ph_arena scratch = {.chunks = NULL};
    status = ph_certify_loops(&u.result.curve, &offset, 1, &scratch, &u.diag);
    ph_arena_free(&scratch);
  }
  ck_that(status == PH_OK, "curve %zu at %.17g: %s", curves, distance,
          u.diag.message);
  ck_assert(offset.loops.trimming.certified);
  return &offset.loops;
}

static double random_distance(struct unit_random *r) {
  const double d = pow(10, unit_random_in(r, -1.5, 1));
  return unit_random_below(r, 2) ? d : -d;
}

/* ---- distances by brute force ---------------------------------------------
 */

/* From a place to segment k, beginning at t. */
static double distance_to(const struct ph_curve *c, size_t k, double t,
                          ph_cplx place) {
  const double *p = c->control_points + 2 * (c->degree + 1) * k;
  double best = HUGE_VAL;
  for (int i = 0; i < STEPS; i++) {
    const ph_cplx r = ph_cplx_sub(unit_bezier(p, c->degree, 0, t), place);
    const ph_cplx d = unit_bezier(p, c->degree, 1, t);
    const double bend =
        ph_cplx_norm2(d) + ph_cplx_dot(r, unit_bezier(p, c->degree, 2, t));
    best = fmin(best, ph_cplx_abs(r));
    t -= ph_cplx_dot(r, d) / (bend > 0 ? bend : ph_cplx_norm2(d));
    t = fmin(fmax(t, 0), 1);
  }
  return best;
}

/* From a place to the curve: from every sample that is nearer than those beside
 * it. */
static double nearest(const struct ph_curve *c, const ph_cplx *samples,
                      ph_cplx place) {
  const size_t n = EACH * c->n;
  double best = HUGE_VAL;
  for (size_t i = 0; i < n; i++) {
    const double at = unit_distance(samples[i], place);
    if (at <= unit_distance(samples[(i + 1) % n], place) &&
        at <= unit_distance(samples[(i + n - 1) % n], place)) {
      const size_t before = (i / EACH + c->n - 1) % c->n;
      best = fmin(best,
                  distance_to(c, i / EACH, (double)(i % EACH) / EACH, place));
      best = i % EACH ? best : fmin(best, distance_to(c, before, 1, place));
    }
  }
  return best;
}

static void sample(ph_cplx *samples) {
  const struct ph_curve *c = &u.result.curve;
  for (size_t i = 0; i < EACH * c->n; i++) {
    const double *p = c->control_points + 2 * (c->degree + 1) * (i / EACH);
    samples[i] = unit_bezier(p, c->degree, 0, (double)(i % EACH) / EACH);
  }
}

static ph_cplx place_of(const struct ph_loop_piece *piece, size_t degree,
                        double t) {
  double top[3 * 20];
  ph_cplx at;
  for (size_t i = 0; i <= degree; i++) {
    const double w = piece->weights[i];
    top[2 * i] = w * piece->control_points[2 * i];
    top[2 * i + 1] = w * piece->control_points[2 * i + 1];
  }
  at = unit_bezier(top, degree, 0, t);
  for (size_t i = 0; i <= degree; i++) {
    top[2 * i] = piece->weights[i];
    top[2 * i + 1] = 0;
  }
  return ph_cplx_scale(1 / unit_bezier(top, degree, 0, t).re, at);
}

static void ck_loop(const struct ph_loop *loop, const ph_cplx *samples) {
  const struct ph_curve *c = &u.result.curve;
  const double d = fabs(offset.distance);
  ck_assert(loop->closed);
  for (size_t i = 0; i < loop->n; i++) {
    const struct ph_loop_piece *piece = &loop->pieces[i];
    const double *end = piece->control_points + 2 * offset.degree;
    const double *next = loop->pieces[(i + 1) % loop->n].control_points;
    ck_abs(end[0], next[0], 0);
    ck_abs(end[1], next[1], 0);
    for (size_t k = 0; k < PLACES; k++) {
      const double t = ((double)k + 0.5) / PLACES;
      const double found =
          nearest(c, samples, place_of(piece, offset.degree, t));
      ck_that(found >= d * (1 - 1e-9), "curve %zu at %.17g: 1 - %g", curves,
              offset.distance, 1 - found / d);
    }
  }
}

PH_TEST(test_distance) {
  struct unit_random r = unit_random_of(40);
  static ph_cplx samples[EACH * POINTS_MAX];
  for (curves = 0; curves < trials(); curves++) {
    const struct points points = random_points(&r);
    const struct ph_curve *c = &u.result.curve;
    const struct ph_loops *loops;
    ck_assert_uint_eq(c->n, points.n);
    sample(samples);
    loops = offset_at(random_distance(&r));
    for (size_t i = 0; i < loops->n; i++) {
      ck_loop(&loops->v[i], samples);
    }
  }
}

/* Joined offsets are no trimmed ones: where a place that is looked at is nearer
 * than the distance, the certificate says so. */
PH_TEST(test_gouged) {
  struct unit_random r = unit_random_of(44);
  static ph_cplx samples[EACH * POINTS_MAX];
  static const struct ph_offset_rules joined = {.mode = PH_OFFSET_JOINED,
                                                .tolerance = 1e-9};
  size_t gouged = 0;
  for (curves = 0; curves < trials(); curves++) {
    const double d = random_distance(&r);
    struct ph_arena scratch = {.chunks = NULL};
    double least = HUGE_VAL;
    enum ph_status status;
    random_points(&r);
    sample(samples);
    ck_that(ph_offset(&u.result.curve, d, &joined, &u.arena, &offset,
                      &u.diag) == PH_OK,
            "curve %zu: %s", curves, u.diag.message);
    for (size_t i = 0; i < offset.loops.v[0].n; i++) {
      for (size_t k = 1; k < 4; k++) {
        const ph_cplx at = place_of(&offset.loops.v[0].pieces[i], offset.degree,
                                    0.25 * (double)k);
        least = fmin(least, nearest(&u.result.curve, samples, at));
      }
    }
    offset.loops.mode = "trimmed";
    status = ph_certify_loops(&u.result.curve, &offset, 1, &scratch, &u.diag);
    if (least < fabs(d) * (1 - 1e-6)) {
      ck_that(status == PH_E_NO_CONVERGENCE &&
                  strstr(u.diag.message, "error of distance"),
              "curve %zu at %.17g, nearest %.17g: %s", curves, d, least,
              status == PH_OK ? "certified" : u.diag.message);
      gouged++;
    }
    ph_arena_free(&scratch);
  }
  ck_assert(4 * gouged > curves);
}

/* ---- how areas change -----------------------------------------------------
 */

PH_TEST(test_derivative) {
  struct unit_random r = unit_random_of(41);
  static const double h = 1e-5;
  size_t same = 0;
  for (curves = 0; curves < trials(); curves++) {
    double area[2], d, step, length;
    size_t n[2];
    random_points(&r);
    d = random_distance(&r);
    for (size_t i = 0; i < 2; i++) {
      n[i] = offset_at(d * (i ? 1 + h : 1 - h))->n;
      area[i] = offset.loops.area;
    }
    step = 2 * h * d;
    if (offset_at(d)->n == n[0] && n[0] == n[1]) {
      length = offset.length;
      ck_abs((area[1] - area[0]) / step, -length, 1e-5 * (length + fabs(d)));
      same++;
    }
  }
  ck_assert(4 * same > 3 * curves);
}

/* Convex curves: outside, areas are those of [Steiner]; far inside, nothing. */
PH_TEST(test_convex) {
  struct unit_random r = unit_random_of(42);
  for (curves = 0; curves < trials() / 4; curves++) {
    struct points points = {.n = 12};
    const double a = unit_random_in(&r, 1, 2);
    double length, area;
    for (size_t i = 0; i < points.n; i++) {
      const ph_cplx at = ph_cplx_polar(2 * PH_PI * (double)i / 12);
      points.p[i] = ph_cplx_of(a * at.re, at.im);
    }
    solve(&points);
    ck_assert_uint_eq(offset_at(-1e-7)->n, 1);
    length = offset.length - 2 * PH_PI * 1e-7;
    area = offset.loops.area - 1e-7 * length;
    for (size_t i = 0; i < 5; i++) {
      const double d = -pow(100, (double)i - 2);
      ck_assert_uint_eq(offset_at(d)->n, 1);
      ck_rel(offset.length, length - 2 * PH_PI * d, 1e-10);
      ck_rel(offset.loops.area, area - d * length + PH_PI * d * d, 1e-10);
    }
    ck_assert_uint_eq(offset_at(1.01)->n, 0);
    ck_assert_uint_eq(offset_at(1e6)->n, 0);
  }
}

/* ---- the same curve in another way ----------------------------------------
 */

struct change {
  const char *name;
  double scale, angle, far;
  size_t begin;
  bool back;
};

static const struct change changes[] = {
    {"moved", 1, 0, 1000, 0, false},    {"turned", 1, 1, 0, 0, false},
    {"small", 1e-9, 0, 0, 0, false},    {"large", 1e9, 0, 0, 0, false},
    {"reversed", 1, 0, 0, 0, true},     {"begun elsewhere", 1, 0, 0, 4, false},
    {"all of it", 1e-3, 2, 50, 3, true}};

PH_TEST(test_changed) {
  struct unit_random r = unit_random_of(43);
  for (curves = 0; curves < trials() / 2; curves++) {
    const struct points points = random_points(&r);
    const double d = random_distance(&r);
    double length, area;
    size_t n;
    n = offset_at(d)->n;
    length = offset.length;
    area = offset.loops.area;
    for (size_t i = 0; i < sizeof changes / sizeof changes[0]; i++) {
      const struct change *of = &changes[i];
      const double side = of->back ? -1 : 1;
      const ph_cplx turn = ph_cplx_scale(of->scale, ph_cplx_polar(of->angle));
      struct points other = {.n = points.n};
      for (size_t k = 0; k < points.n; k++) {
        const size_t at = (k + of->begin) % points.n;
        other.p[of->back ? points.n - 1 - k : k] = ph_cplx_mul(
            turn, ph_cplx_add(points.p[at], ph_cplx_of(of->far, -of->far)));
      }
      solve(&other);
      ck_that(offset_at(side * of->scale * d)->n == n, "curve %zu, %s", curves,
              of->name);
      ck_abs(offset.length / of->scale, length, 1e-9 * (length + fabs(d)));
      ck_abs(side * offset.loops.area / (of->scale * of->scale), area,
             1e-9 * (length + fabs(d)) * (length + fabs(d)));
    }
  }
}

PH_FIXTURE(NULL, finish)
