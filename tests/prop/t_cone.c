/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Properties of cone splines through random contact elements: that there is a
 * pair for any two, but for those that are known to have none; that frames are
 * met, as the certificate finds and as small steps along the strips do; what
 * must follow when the data are turned, moved, scaled or reversed; warnings of
 * what noise does to data of constant slope.
 *
 * The seed is 1, or PH_SEED; PH_LONG=1 takes ten times as many data.
 */
#include "motion.h"
#include "problem_unit.h"
#include "unit.h"

#include "curve/surface/locate.h"
#include "curve/surface/ruling.h"
#include "kernel/pi.h"
#include "solve/cone/cone.h"

enum { ELEMENTS = 6 };

/* Contact elements: points, rulings, tangents. */
struct data {
  size_t n;
  ph_vec3 p[ELEMENTS], e[ELEMENTS], d[ELEMENTS];
};

static struct unit_solution one, other;
static struct data data, image;

static void finish(void) {
  unit_solution_free(&one);
  unit_solution_free(&other);
}

PH_FIXTURE(NULL, finish)

/* ---- data ---------------------------------------------------------------- */

static ph_vec3 any(struct unit_random *r, double size) {
  const double x = unit_random_in(r, -size, size);
  const double y = unit_random_in(r, -size, size);
  return ph_vec3_of(x, y, unit_random_in(r, -size, size));
}

static void any_frame(struct unit_random *r, size_t i) {
  const ph_quat q = unit_random_turn(r);
  data.e[i] = ph_quat_i(q, q);
  data.d[i] = ph_quat_j(q, q);
}

/* Elements anywhere. */
static void scatter(struct unit_random *r, size_t n) {
  data.n = n;
  for (size_t i = 0; i < n; i++) {
    data.p[i] = any(r, 10);
    any_frame(r, i);
  }
}

/* Of a strip of one cone: the second is a place of it. */
static void on_cone(struct unit_random *r, double k, double kn) {
  const double s = unit_random_in(r, 0.1, 2);
  const double x = hypot(k, kn) * s;
  const double S = sin(x) / hypot(k, kn), Q = (1 - cos(x)) / (k * k + kn * kn);
  ph_vec3 n, bend, way;
  scatter(r, 1);
  data.n = 2;
  n = ph_vec3_cross(data.e[0], data.d[0]);
  bend = ph_vec3_along(ph_vec3_scale(k, data.e[0]), kn, n);
  way = ph_vec3_along(ph_vec3_scale(S, data.d[0]), Q, bend);
  data.e[1] = ph_vec3_along(data.e[0], -k, way);
  data.d[1] = ph_vec3_along(ph_vec3_scale(cos(x), data.d[0]), S, bend);
  data.p[1] = ph_vec3_along(ph_vec3_add(data.p[0], way),
                            unit_random_in(r, -1, 1), data.e[1]);
  data.p[0] = ph_vec3_along(data.p[0], unit_random_in(r, -1, 1), data.e[0]);
}

/* Of the tangents of a helix, whose elements have no common sphere. */
static void on_helix(struct unit_random *r, double step, double noise) {
  const double pitch = unit_random_in(r, 0.2, 2);
  const double start = unit_random_in(r, 0, 6), size = hypot(1, pitch);
  data.n = 2;
  for (size_t i = 0; i < 2; i++) {
    const double t = start + step * (double)i;
    const ph_vec3 e = ph_vec3_of(-sin(t) / size, cos(t) / size, pitch / size);
    const ph_vec3 p = ph_vec3_of(cos(t), sin(t), pitch * t);
    data.e[i] = ph_vec3_unit(ph_vec3_add(e, any(r, noise)));
    data.d[i] = ph_vec3_unit(ph_vec3_normal(
        ph_vec3_add(ph_vec3_of(-cos(t), -sin(t), 0), any(r, noise)),
        data.e[i]));
    data.p[i] = ph_vec3_add(ph_vec3_along(p, 2, e), any(r, noise));
  }
}

static void set(struct unit_solution *s, enum ph_field_id id, const ph_vec3 *v,
                size_t n) {
  double x[3 * ELEMENTS];
  for (size_t i = 0; i < n; i++) {
    ph_vec3_put(v[i], 3, x + 3 * i);
  }
  unit_set_copy(s, id, x, n, 3);
}

static enum ph_status solve(struct unit_solution *s, const struct data *d) {
  enum ph_status status;
  unit_solution_free(s);
  set(s, PH_F_POINTS, d->p, d->n);
  set(s, PH_F_RULINGS, d->e, d->n);
  set(s, PH_F_TANGENTS, d->d, d->n);
  status = unit_solve(&ph_method_cone, s);
  return status == PH_OK ? unit_certify("cone", s) : status;
}

/* ---- frames -------------------------------------------------------------- */

/* Where a strip leads, by the rule of Runge and Kutta with so many steps. */
static void follow(const struct ph_strip *s, ph_vec3 at[4]) {
  enum { STEPS = 400 };
  const double h = s->length / STEPS;
  at[0] = ph_vec3_get(s->frame.point, 3);
  at[1] = ph_vec3_get(s->frame.ruling, 3);
  at[2] = ph_vec3_get(s->frame.tangent, 3);
  at[3] = ph_vec3_get(s->frame.normal, 3);
  for (size_t step = 0; step < STEPS; step++) {
    ph_vec3 sum[4], by[4], y[4];
    memcpy(y, at, sizeof y);
    for (size_t stage = 0; stage < 4; stage++) {
      const double weight = stage == 1 || stage == 2 ? 2 : 1;
      const double part = stage == 2 ? 1 : 0.5;
      by[0] = y[2];
      by[1] = ph_vec3_scale(-s->k, y[2]);
      by[2] = ph_vec3_along(ph_vec3_scale(s->k, y[1]), s->kn, y[3]);
      by[3] = ph_vec3_scale(-s->kn, y[2]);
      for (size_t i = 0; i < 4; i++) {
        sum[i] = stage == 0 ? by[i] : ph_vec3_along(sum[i], weight, by[i]);
        y[i] = ph_vec3_along(at[i], part * h, by[i]);
      }
    }
    for (size_t i = 0; i < 4; i++) {
      at[i] = ph_vec3_along(at[i], h / 6, sum[i]);
    }
  }
}

/* The second strip of each pair leads to the next element. */
static void ck_frames(const struct unit_solution *s, const struct data *d) {
  const struct ph_curve *c = &s->result.curve;
  for (size_t i = 1; i < c->n; i += 2) {
    const struct ph_strip *strip = &c->surface.strips[i];
    const size_t to = (i + 1) / 2;
    ph_vec3 at[4], p;
    follow(strip, at);
    p = ph_vec3_along(d->p[to], strip->shift[1], d->e[to]);
    /* the rule itself is exact to 1e-9 or so */
    ck_vec3(at[1], d->e[to], 1e-7);
    ck_vec3(at[2], d->d[to], 1e-7);
    ck_vec3(at[0], p, 1e-7 * (1 + fabs(strip->shift[1]) + strip->length));
  }
}

/* How long the coordinates of both contact points are, over the shorter strip:
 * so many times their rounding is in its frames. */
static double amplified(const struct unit_solution *s) {
  const struct ph_strip *strip = s->result.curve.surface.strips;
  double worst = 0;
  for (size_t i = 0; i < s->result.curve.n; i++) {
    const double far = 20 + fabs(strip[i].shift[0]) + fabs(strip[i].shift[1]);
    worst = unit_larger(worst, far / strip[i].length);
  }
  return worst;
}

/* What is not within 1e-10 is refused, which is when rounding is that large. */
PH_TEST(test_any_pair) {
  struct unit_random r = unit_random_of(1);
  const size_t n = unit_cases(100000);
  size_t refused = 0;
  for (size_t i = 0; i < n; i++) {
    enum ph_status status;
    double error;
    scatter(&r, 2);
    unit_case("pair %zu", i);
    status = solve(&one, &data);
    error = unit_diagnostic(&one.result.diagnostics, PH_D_FRAME_ERROR);
    if (status != PH_OK) {
      refused++;
      ck_assert_int_eq(status, PH_E_NO_CONVERGENCE);
    }
    ck_that((error <= 1e-10 && status == PH_OK) || amplified(&one) > 1e4,
            "seed %lu: frames miss by %.3g, rounding is amplified %.3g times",
            unit_seed(), error, amplified(&one));
    if (i % 100 == 0 && amplified(&one) < 1e4) {
      ck_frames(&one, &data);
    }
  }
  ck_that(refused <= 2 + n / 5000, "seed %lu: %zu of %zu are refused",
          unit_seed(), refused, n);
}

/* Neighbours on a smooth surface, down to steps of 1e-4. */
PH_TEST(test_near_pairs) {
  struct unit_random r = unit_random_of(2);
  const size_t n = unit_cases(5000);
  for (size_t i = 0; i < n; i++) {
    const double step = pow(10, unit_random_in(&r, -4, -0.5));
    const ph_vec3 w = any(&r, step);
    scatter(&r, 1);
    data.n = 2;
    unit_case("pair %zu, step %g", i, step);
    data.e[1] =
        ph_vec3_unit(ph_vec3_add(data.e[0], ph_vec3_cross(w, data.e[0])));
    data.d[1] = ph_vec3_unit(ph_vec3_normal(
        ph_vec3_add(data.d[0], ph_vec3_cross(w, data.d[0])), data.e[1]));
    data.p[1] = ph_vec3_add(ph_vec3_along(data.p[0], 10 * step, data.d[0]),
                            any(&r, step));
    ck_assert_int_eq(solve(&one, &data), PH_OK);
  }
}

/* ---- what has no sphere, or many ----------------------------------------- */

static enum ph_pair_case which(void) {
  return one.result.curve.surface.pairs[0].which;
}

/* Of one cone, both strips are that cone. */
PH_TEST(test_one_cone) {
  struct unit_random r = unit_random_of(3);
  const size_t n = unit_cases(2000);
  for (size_t i = 0; i < n; i++) {
    const double k = unit_random_in(&r, -1.5, 1.5);
    const double kn = unit_random_in(&r, -1.5, 1.5);
    const struct ph_strip *s;
    unit_case("pair %zu, k %g, kn %g", i, k, kn);
    on_cone(&r, k, kn);
    ck_assert_int_eq(solve(&one, &data), PH_OK);
    ck_assert_int_eq(which(), PH_PAIR_PENCIL);
    s = one.result.curve.surface.strips;
    ck_rel(s[0].half_angle, atan2(fabs(k), fabs(kn)), 1e-7);
    ck_rel(s[1].half_angle, s[0].half_angle, 1e-7);
    for (size_t j = 0; j < 3; j++) {
      ck_abs(s[0].vertex[j], s[1].vertex[j], 1e-6 * (1 + fabs(1 / k)));
    }
  }
}

PH_TEST(test_helix) {
  struct unit_random r = unit_random_of(4);
  const size_t n = unit_cases(2000);
  for (size_t i = 0; i < n; i++) {
    unit_case("pair %zu", i);
    on_helix(&r, unit_random_in(&r, 0.01, 1), 0);
    ck_assert_int_eq(solve(&one, &data), PH_OK);
    ck_assert_int_eq(which(), PH_PAIR_PARALLEL);
    ck_assert_uint_eq(one.result.warnings_n, 0);
  }
}

/* The sphere of such data with noise is far away, and useless. */
PH_TEST(test_noise) {
  struct unit_random r = unit_random_of(5);
  const size_t n = unit_cases(500);
  size_t warned = 0, better = 0;
  for (size_t i = 0; i < n; i++) {
    double far;
    unit_case("pair %zu", i);
    on_helix(&r, 0.3, 1e-4);
    ck_assert_int_eq(solve(&one, &data), PH_OK);
    far = unit_diagnostic(&one.result.diagnostics, PH_D_SHIFT);
    for (size_t w = 0; w < one.result.warnings_n; w++) {
      warned += one.result.warnings[w].diag.status == PH_W_FAR_CONTACT;
    }
    unit_set_number(&one.problem, PH_F_DEGENERATE, 1e-2);
    ck_assert_int_eq(unit_solve(&ph_method_cone, &one), PH_OK);
    better += unit_certify("cone", &one) == PH_OK &&
              unit_diagnostic(&one.result.diagnostics, PH_D_SHIFT) < 2 &&
              far > 2;
  }
  ck_that(warned > n * 9 / 10, "only %zu of %zu are warned of", warned, n);
  ck_that(better > n * 9 / 10, "only %zu of %zu are taken as meant", better, n);
}

/* Rulings of a helicoid, across its axis. */
PH_TEST(test_saddle) {
  struct unit_random r = unit_random_of(6);
  const size_t n = unit_cases(200);
  for (size_t i = 0; i < n; i++) {
    const double turn = unit_random_in(&r, 0.1, 3);
    const double pitch = unit_random_in(&r, 0.1, 3);
    data.n = 2;
    for (size_t j = 0; j < 2; j++) {
      const double t = turn * (double)j;
      data.e[j] = ph_vec3_of(cos(t), sin(t), 0);
      data.p[j] = ph_vec3_along(ph_vec3_of(0, 0, pitch * t), 1, data.e[j]);
      data.d[j] = ph_vec3_unit(ph_vec3_of(-sin(t), cos(t), pitch));
    }
    unit_case("turn %g, pitch %g", turn, pitch);
    ck_assert_int_eq(solve(&one, &data), PH_E_INFEASIBLE);
    ck_assert_ptr_nonnull(strstr(one.diag.message, "of a saddle"));
  }
}

/* Of general cones, down to steps of 1e-4: both cones have the vertex. */
PH_TEST(test_apex) {
  struct unit_random r = unit_random_of(7);
  const size_t n = unit_cases(2000);
  for (size_t i = 0; i < n; i++) {
    const ph_vec3 apex = any(&r, 10);
    const double step = pow(10, unit_random_in(&r, -4, -0.5));
    ph_vec3 w;
    scatter(&r, 1);
    data.n = 2;
    w = any(&r, step);
    unit_case("pair %zu, step %g", i, step);
    data.e[1] = ph_vec3_unit(
        ph_vec3_along(ph_vec3_add(data.e[0], w), 2 * step, data.d[0]));
    data.d[1] =
        ph_vec3_unit(ph_vec3_normal(ph_vec3_add(data.d[0], w), data.e[1]));
    for (size_t j = 0; j < 2; j++) {
      data.p[j] =
          ph_vec3_along(apex, -unit_random_in(&r, 1, 1 + step), data.e[j]);
    }
    data.p[0] = ph_vec3_along(data.p[0], -1, data.e[0]);
    data.p[1] = ph_vec3_along(data.p[1], -1, data.e[1]);
    ck_assert_int_eq(solve(&one, &data), PH_OK);
    ck_assert_int_eq(which(), PH_PAIR_APEX);
    for (size_t j = 0; j < 2; j++) {
      const struct ph_strip *s = &one.result.curve.surface.strips[j];
      ck_vec3(ph_vec3_get(s->vertex, 3), apex, 1e-12 / step);
    }
    ck_frames(&one, &data);
  }
}

/* ---- the development ------------------------------------------------------
 */

/* Points of strips of any curvature, on both sides of their vertex, are found
 * again; what is beside them is not. */
PH_TEST(test_located) {
  struct unit_random r = unit_random_of(8);
  const size_t n = unit_cases(20000);
  size_t beside = 0;
  for (size_t i = 0; i < n; i++) {
    const double k = unit_random_in(&r, -1, 1) * pow(10, -(double)(i % 16));
    const double most = fmin(5, 2 * PH_PI / fabs(k));
    struct ph_strip strip = {
        .k = k,
        .frame = {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, -1}},
        .length = unit_random_in(&r, 0.1, most)};
    struct ph_curve curve = {.n = 1, .surface = {.strips = &strip}};
    double *height = curve.surface.height;
    const double u = unit_random_in(&r, 0, 1);
    const double out = unit_random_in(&r, 1.0001, 2);
    struct ph_surface_sample at;
    struct ph_ruling ruling;
    double flat[2], found[2], h;
    unit_case("point %zu, k %g", i, k);
    height[0] = unit_random_in(&r, -3, 3);
    height[1] = height[0] + unit_random_in(&r, 0, 3);
    strip.development.control_points[0][0] = unit_random_in(&r, -9, 9);
    strip.development.angle = unit_random_in(&r, -9, 9);
    h = unit_random_in(&r, height[0], height[1]);
    ruling = ph_ruling_at(&strip, u);
    ph_ruling_flat(&ruling, h, flat);
    ck_that(ph_strip_locate(&curve, 0, flat, 1e-12, &at), "%.17g %.17g", u, h);
    ruling = ph_ruling_at(&strip, at.s / strip.length);
    ph_ruling_flat(&ruling, at.h, found);
    ck_abs(found[0], flat[0], 1e-13);
    ck_abs(found[1], flat[1], 1e-13);
    ck_that(at.h >= height[0] - 1e-12 && at.h <= height[1] + 1e-12, "%g", at.h);
    if (fabs(k) * strip.length < 1 && fabs(k) < 0.1) {
      beside++;
      ruling = ph_ruling_at(&strip, i % 2 ? out : 1 - out);
      ph_ruling_flat(&ruling, h, flat);
      ck_that(!ph_strip_locate(&curve, 0, flat, 1e-12, &at), "%g", out);
    }
  }
  ck_that(beside > n / 2, "%zu", beside);
}

/* ---- motions ------------------------------------------------------------- */

static void move_data(const struct motion *m) {
  image.n = data.n;
  for (size_t i = 0; i < data.n; i++) {
    const size_t from = m->reverse ? data.n - 1 - i : i;
    const double sign = m->reverse ? -1 : 1;
    struct motion turns = *m;
    turns.scale = 1;
    image.p[i] = moved(m, data.p[from]);
    image.e[i] = turned(&turns, data.e[from]);
    image.d[i] = ph_vec3_scale(sign, turned(&turns, data.d[from]));
  }
}

/* Strips of the image are those of the data, moved. */
static void ck_moved(const struct motion *m) {
  const size_t n = one.result.curve.n;
  ck_assert_uint_eq(other.result.curve.n, n);
  for (size_t i = 0; i < n; i++) {
    const struct ph_strip *a =
        &one.result.curve.surface.strips[m->reverse ? n - 1 - i : i];
    const struct ph_strip *b = &other.result.curve.surface.strips[i];
    const double length = a->length * m->scale;
    ck_rel(b->length, length, 1e-8);
    ck_abs(b->k * b->length, a->k * a->length, 1e-8);
    ck_abs(fabs(b->kn * b->length), fabs(a->kn * a->length), 1e-8);
    ck_abs(b->shift[0], a->shift[m->reverse] * m->scale,
           1e-8 * (fabs(b->shift[0]) + length));
    ck_vec3(
        ph_vec3_get(b->frame.point, 3),
        moved(m, ph_vec3_get(a->contact.control_points[m->reverse ? 2 : 0], 3)),
        1e-8 * (m->scale * 20 + fabs(b->shift[0]) + length));
  }
}

static void any_turn(struct unit_random *r, struct motion *m) {
  turn(r, m);
}

static void any_shift(struct unit_random *r, struct motion *m) {
  m->shift = any(r, 1e3);
}

static void any_scale(struct unit_random *r, struct motion *m) {
  m->scale = pow(10, unit_random_in(r, -9, 9));
}

static void backward(struct unit_random *r, struct motion *m) {
  (void)r;
  m->reverse = true;
}

static void (*const motions[])(struct unit_random *, struct motion *) = {
    any_turn, any_shift, any_scale, backward};

PH_TEST_EACH(test_moved, COUNT(motions)) {
  struct unit_random r = unit_random_of(10 + (uint64_t)_i);
  const size_t n = unit_cases(1000);
  size_t compared = 0;
  for (size_t i = 0; i < n; i++) {
    struct motion m = REST;
    unit_case("motion %d, data %zu", _i, i);
    scatter(&r, ELEMENTS);
    motions[_i](&r, &m);
    move_data(&m);
    if (solve(&one, &data) == PH_OK && amplified(&one) < 1e3) {
      compared++;
      ck_assert_int_eq(solve(&other, &image), PH_OK);
      ck_moved(&m);
    }
  }
  ck_that(compared > n / 2, "only %zu of %zu are compared", compared, n);
}
