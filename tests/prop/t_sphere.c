/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Properties of spherical nu-splines through random points, each solved and
 * certified: what must follow when the data are turned, mirrored, reversed,
 * brought to another sphere or begun elsewhere; that lengths, offsets and
 * shapes are right as samples see them; that no data have a wrong curve, and
 * nearly all have one.
 *
 * The seed is 1, or PH_SEED; PH_LONG=1 takes ten times as many data.
 */
#include "motion.h"
#include "sphere_data.h"
#include "spherical_unit.h"
#include "unit.h"

#include "curve/offset/offset.h"
#include "curve/sample/sample.h"
#include "kernel/s2.h"

static struct unit_solution one, other;
static struct sphere_data data, image;

static void finish(void) {
  unit_solution_free(&one);
  unit_solution_free(&other);
}

static void ck_share(size_t solved, size_t n, double share) {
  /* of few cases, one may fail */
  ck_assert_msg((double)solved >= share * (double)n - (n < 20),
                "PH_SEED=%lu: only %zu of %zu are solved", unit_seed(), solved,
                n);
}

/* ---- motions ------------------------------------------------------------- */

/* Where node i and segment k of the image are from. */
static size_t node_from(const struct motion *m, size_t i) {
  size_t n = data.n;
  if (m->reverse) {
    return data.closed ? (2 * n - i - m->first) % n : n - 1 - i;
  }
  return (i + m->first) % n;
}

static size_t segment_from(const struct motion *m, size_t k) {
  return m->reverse ? node_from(m, k + 1 < data.n ? k + 1 : 0)
                    : node_from(m, k);
}

/* image = data, moved. */
static void move_data(const struct motion *m) {
  image = data;
  for (size_t i = 0; i < data.n; i++) {
    image.point[i] = moved(m, data.point[node_from(m, i)]);
  }
  for (size_t e = 0; e < 2; e++) {
    ph_vec3 t = moved(m, data.end_tangent[m->reverse ? 1 - e : e]);
    image.end_tangent[e] = ph_vec3_scale(m->reverse ? -1 : 1, t);
  }
}

/* The largest angle between control points of `other` and those of `one`,
 * moved. */
static double away(const struct motion *m) {
  double worst = 0;
  for (size_t k = 0; k < 4 * other.result.curve.n; k++) {
    size_t i = m->reverse ? 3 - k % 4 : k % 4;
    ph_vec3 p = sphere_point(&one, segment_from(m, k / 4), i);
    double angle = ph_s2_angle(moved(m, p), sphere_point(&other, k / 4, k % 4));
    worst = unit_larger(worst, angle);
  }
  return worst;
}

static void reverse(struct unit_random *r, struct motion *m) {
  m->first = data.closed ? unit_random_below(r, data.n) : 0;
  m->reverse = true;
}

static void start(struct unit_random *r, struct motion *m) {
  m->first = 1 + unit_random_below(r, data.n - 1);
}

static void (*const changes[])(struct unit_random *, struct motion *) = {
    turn, mirror, reverse, start};
enum { CHANGES = 4 };
/* Data whose spline is well conditioned, with any options. */
static void invariant(struct unit_random *r, size_t change) {
  enum sphere_family family =
      (enum sphere_family)unit_random_below(r, SPHERE_FARTHEST);
  bool closed = change == CHANGES - 1 || unit_random_below(r, 4) == 0;
  sphere_of(r, closed ? SPHERE_RING : family, 5 + unit_random_below(r, 8),
            &data);
  sphere_options(r, &data);
}

/* Control points agree to rounding: at tensions that are given the equations
 * have one solution nearby, and Newton's iteration ends at rounding. */
PH_TEST_EACH(test_motion, CHANGES) {
  size_t change = (size_t)_i, solved = 0, n = unit_cases(100);
  struct unit_random r = unit_random_of(1 + change);
  for (size_t i = 0; i < n; i++) {
    struct motion m = REST;
    double worst;
    invariant(&r, change);
    changes[change](&r, &m);
    if (sphere_solve(&data, i, &one)) {
      move_data(&m);
      sphere_must(&image, i, &other);
      worst = away(&m);
      ck_that(worst <= 1e-12, "it is %.3g away", worst);
      solved++;
    }
  }
  ck_share(solved, n, 0.9);
}

/* Tensions are a local minimum that a sequence of linear programs comes to, and
 * it ends where a step gains next to nothing: rounding may end it a step
 * earlier.  So it is the sum, not each of them, that must agree, and not to the
 * last digit. */
PH_TEST_EACH(test_motion_of_shape, CHANGES) {
  size_t change = (size_t)_i, solved = 0, n = unit_cases(20);
  struct unit_random r = unit_random_of(11 + change);
  for (size_t i = 0; i < n; i++) {
    struct motion m = REST;
    double a, b;
    invariant(&r, change);
    data.shape = true;
    changes[change](&r, &m);
    if (sphere_solve(&data, i, &one)) {
      move_data(&m);
      sphere_must(&image, i, &other);
      a = one.result.diagnostics.value[PH_D_TENSION_SUM];
      b = other.result.diagnostics.value[PH_D_TENSION_SUM];
      ck_that(unit_near_rel(a, b, 0.01), "%.17g and %.17g", a, b);
      solved++;
    }
  }
  ck_share(solved, n, 0.6);
}

/* Raised in steps they are the same, to the last digit; of a tension that is
 * just enough rounding could make another, but none of these data has one. */
PH_TEST_EACH(test_motion_of_steps, CHANGES) {
  size_t change = (size_t)_i, solved = 0, n = unit_cases(20);
  struct unit_random r = unit_random_of(21 + change);
  for (size_t i = 0; i < n; i++) {
    struct motion m = REST;
    invariant(&r, change);
    data.shape = true;
    data.increase = i % 2 ? "plus" : "times";
    data.by = i % 2 ? 5 : 2;
    changes[change](&r, &m);
    if (sphere_solve(&data, i, &one)) {
      move_data(&m);
      sphere_must(&image, i, &other);
      for (size_t k = 0; k < data.n; k++) {
        double a = one.result.curve.sphere.tensions[node_from(&m, k)];
        double b = other.result.curve.sphere.tensions[k];
        ck_that(unit_near_rel(a, b, 1e-12), "tensions[%zu]: %.17g and %.17g", k,
                a, b);
      }
      ck_that(away(&m) <= 1e-9, "it is %.3g away", away(&m));
      solved++;
    }
  }
  ck_share(solved, n, 0.6);
}

/* Whatever was solved before, in the same memory: not a digit differs. */
PH_TEST(test_neighbours) {
  struct unit_random r = unit_random_of(31);
  for (size_t i = 0; i < unit_cases(20); i++) {
    bool a, b;
    sphere_any(&r, &image);
    sphere_any(&r, &data);
    a = sphere_solve(&data, i, &one);
    sphere_solve(&image, i, &other);
    b = sphere_solve(&data, i, &other);
    ck_that(a == b, "%s", b ? "once" : "not again");
    if (a) {
      const struct ph_curve *x = &one.result.curve, *y = &other.result.curve;
      ck_assert_mem_eq(x->control_points, y->control_points,
                       12 * x->n * sizeof *x->control_points);
      ck_assert_mem_eq(x->sphere.tensions, y->sphere.tensions,
                       data.n * sizeof *x->sphere.tensions);
    } else {
      ck_assert_str_eq(one.diag.message, other.diag.message);
    }
  }
}

/* ---- other spheres, other words ------------------------------------------ */

/* Another sphere: the same curve, as far as its coordinates have the digits. */
PH_TEST(test_sphere) {
  struct unit_random r = unit_random_of(32);
  for (size_t i = 0; i < unit_cases(100); i++) {
    double worst, far;
    sphere_of(&r, (enum sphere_family)unit_random_below(&r, SPHERE_FARTHEST),
              3 + unit_random_below(&r, 8), &data);
    sphere_options(&r, &data);
    if (!sphere_solve(&data, i, &one)) {
      continue;
    }
    image = data;
    image.radius = pow(10, unit_random_in(&r, -9, 9));
    far = i % 2 ? pow(10, unit_random_in(&r, 0, 3)) : 0;
    image.center = ph_vec3_scale(far * image.radius, unit_random_direction(&r));
    sphere_must(&image, i, &other);
    worst = away(&REST);
    ck_that(worst <= 1e-12 * (1 + far), "it is %.3g away", worst);
    ck_rel(one.result.curve.length * image.radius, other.result.curve.length,
           1e-11 * (1 + far));
  }
}

PH_TEST(test_lonlat) {
  struct unit_random r = unit_random_of(33);
  for (size_t i = 0; i < unit_cases(50); i++) {
    double worst;
    sphere_of(&r, i % 2 ? SPHERE_WALK : SPHERE_RING, 8, &data);
    sphere_must(&data, i, &one);
    image = data;
    image.lonlat = true;
    sphere_must(&image, i, &other);
    worst = away(&REST);
    ck_that(worst <= 1e-12, "it is %.3g away", worst);
  }
}

/* Tensions that grow: the curve comes nearer to the great circles between the
 * points, as 1 / tension. */
PH_TEST(test_large_tension) {
  struct unit_random r = unit_random_of(34);
  for (size_t i = 0; i < unit_cases(20); i++) {
    double step[SPHERE_MAX], sum = 0, before = HUGE_VAL;
    sphere_of(&r, (enum sphere_family)(i % SPHERE_CIRCLE), 8, &data);
    data.model = i % 2 ? "nielson" : "exact";
    for (size_t k = sphere_steps(&data, step); k-- > 0;) {
      sum += step[k];
    }
    for (int e = 3; e <= 6; e++) {
      double more;
      data.tension = pow(10, e);
      sphere_must(&data, i, &one);
      more = one.result.curve.length / sum - 1;
      ck_that(more <= 0.2 * before, "%.3g longer, before %.3g", more, before);
      before = more;
    }
  }
}

/* ---- great circles ------------------------------------------------------- */

/* Points on a great circle, one after the other: the great circle. */
PH_TEST(test_circle) {
  struct unit_random r = unit_random_of(35);
  for (size_t i = 0; i < unit_cases(50); i++) {
    double step[SPHERE_MAX], sum = 0;
    ph_vec3 pole;
    sphere_of(&r, SPHERE_CIRCLE, 2 + unit_random_below(&r, 10), &data);
    sphere_options(&r, &data);
    data.ends = i % 2 ? "natural" : "rest";
    data.knots = "geodesic";
    data.shape = i % 3 != 0;
    pole = ph_vec3_unit(ph_vec3_cross(data.point[0], data.point[1]));
    for (size_t k = sphere_steps(&data, step); k-- > 0;) {
      sum += step[k];
    }
    sphere_must(&data, i, &one);
    for (size_t k = 0; k < 4 * one.result.curve.n; k++) {
      double off = ph_vec3_dot(pole, sphere_point(&one, k / 4, k % 4));
      ck_that(fabs(off) <= 1e-12, "%.3g off", off);
    }
    for (size_t k = 1; k + 1 < data.n; k++) {
      ck_assert_int_eq(one.result.curve.sphere.indicators[k], 0);
      ck_that(unit_same(one.result.curve.sphere.tensions[k], data.tension),
              "tensions[%zu] is raised", k);
    }
    ck_that(unit_near_rel(one.result.curve.length, sum, 1e-12),
            "length %.17g, not %.17g", one.result.curve.length, sum);
  }
}

/* ---- shape --------------------------------------------------------------- */

enum { PLACES = 400 };

/* The sign of the turn at a node, by this file; 0 where it is too near to 0 to
 * tell. */
static int bend_at(size_t i) {
  size_t n = data.n;
  ph_vec3 a = data.point[i > 0 ? i - 1 : n - 1], b = data.point[i];
  ph_vec3 c = data.point[i + 1 < n ? i + 1 : 0];
  ph_vec3 in = ph_vec3_cross(a, b), out = ph_vec3_cross(b, c);
  double sine = ph_vec3_triple(in, out, b) / ph_vec3_abs(in) / ph_vec3_abs(out);
  bool end = !data.closed && (i == 0 || i + 1 == n);
  return end || fabs(sine) < 1e-3 ? 0 : sine > 0 ? 1 : -1;
}

/* The least of curvature times q at places from one end of a segment to the
 * other, over the largest. */
static double least_bend(size_t k, int q) {
  struct ph_spherical s = ph_spherical_of(&one.result.curve, k);
  double least = HUGE_VAL, most = 0;
  for (int j = 0; j <= PLACES; j++) {
    double kappa = q * unit_curvature(&s, (double)j / PLACES);
    least = kappa < least || isnan(kappa) ? kappa : least;
    most = unit_larger(most, fabs(kappa));
  }
  return least / most;
}

static void ck_shape(void) {
  const struct ph_curve *c = &one.result.curve;
  for (size_t k = 0; k < c->n; k++) {
    size_t next = k + 1 < data.n ? k + 1 : 0;
    int from = bend_at(k), to = bend_at(next);
    struct ph_spherical s = ph_spherical_of(c, k);
    double ends[2] = {unit_curvature(&s, 0), unit_curvature(&s, 1)};
    ck_that(from == 0 || from == c->sphere.indicators[k],
            "indicators[%zu] is %d", k, c->sphere.indicators[k]);
    if (from * to > 0) {
      double least = least_bend(k, from);
      ck_that(least >= -1e-9, "segment %zu bends by %.3g of its curvature", k,
              least);
    }
    ck_that(from == 0 || from * ends[0] >= -1e-9, "node %zu bends by %.3g", k,
            ends[0]);
    ck_that(to == 0 || to * ends[1] >= -1e-9, "node %zu bends by %.3g", next,
            ends[1]);
  }
}

/* With shape the criteria hold wherever the curve is looked at.  Only clamped
 * ends, not among these, can ask for what no tension gives. */
PH_TEST(test_shape) {
  struct unit_random r = unit_random_of(36);
  size_t n = unit_cases(60), solved = 0;
  for (size_t i = 0; i < n; i++) {
    sphere_of(&r, (enum sphere_family)(i % SPHERE_FAMILY_N),
              4 + unit_random_below(&r, 9), &data);
    sphere_options(&r, &data);
    data.ends = i % 2 && !data.closed ? "rest" : NULL;
    data.shape = true;
    if (sphere_solve(&data, i, &one)) {
      solved++;
      ck_shape();
    }
  }
  ck_share(solved, n, 0.9);
}

/* Nodes amid a great circle: it is not left by more than epsilon allows. */
PH_TEST(test_runs) {
  struct unit_random r = unit_random_of(37);
  for (size_t i = 0; i < unit_cases(20); i++) {
    sphere_of(&r, SPHERE_RUNS, 10, &data);
    data.shape = true;
    sphere_must(&data, i, &one);
    for (size_t k = 1; k < one.result.curve.n; k++) {
      struct ph_spherical s = ph_spherical_of(&one.result.curve, k);
      double kappa = unit_curvature(&s, 0);
      ph_vec3 way = ph_vec3_cross(data.point[k - 1], data.point[k]);
      double turned = ph_vec3_dot(way, data.point[k + 1]);
      ck_that(fabs(turned) > 1e-12 || fabs(kappa) <= 0.01,
              "curvature %.3g at node %zu", kappa, k);
    }
  }
}

/* ---- lengths, offsets ---------------------------------------------------- */

/* Samples: arc length grows, and is that of the distances between them. */
PH_TEST(test_samples) {
  static const struct ph_sample_rules rules = {.how = PH_SAMPLE_PARAMETER,
                                               .n = 50};
  struct unit_random r = unit_random_of(38);
  for (size_t i = 0; i < unit_cases(20); i++) {
    struct ph_samples s = {0};
    struct ph_diag diag;
    sphere_any(&r, &data);
    if (!sphere_solve(&data, i, &one)) {
      continue;
    }
    ck_assert_int_eq(
        ph_sample_curve(&one.result.curve, &rules, &one.arena, &s, &diag),
        PH_OK);
    for (size_t k = 1; k < s.n; k++) {
      ph_vec3 a = ph_vec3_get(s.point + 3 * k - 3, 3);
      ph_vec3 b = ph_vec3_get(s.point + 3 * k, 3);
      double ds = s.s[k] - s.s[k - 1], chord = ph_vec3_abs(ph_vec3_sub(b, a));
      double noise = 16 * DBL_EPSILON *
                     (ph_vec3_abs(a) + ph_vec3_abs(data.center) + s.s[k]);
      ck_that(ds >= -noise && ds >= chord - noise - 1e-11 * s.s[k],
              "s grows by %.17g along a chord of %.17g", ds, chord);
    }
    ck_that(unit_same(s.s[s.n - 1], one.result.curve.length),
            "s ends at %.17g, not %.17g", s.s[s.n - 1],
            one.result.curve.length);
  }
}

/* From an offset by its own samples back to the curve. */
PH_TEST(test_offset_and_back) {
  static const struct ph_offset_rules rules = {
      .samples = {.how = PH_SAMPLE_PARAMETER, .n = 20}};
  struct unit_random r = unit_random_of(39);
  for (size_t i = 0; i < unit_cases(20); i++) {
    double d = unit_random_in(&r, -1.5, 1.5), c = cos(d), s = sin(d);
    struct ph_samples on = {0};
    struct ph_offset offset = {0};
    sphere_of(&r, (enum sphere_family)unit_random_below(&r, SPHERE_FARTHEST), 8,
              &data);
    data.shape = i % 2;
    sphere_must(&data, i, &one);
    ck_assert_int_eq(
        ph_offset(&one.result.curve, d, &rules, &one.arena, &offset, &one.diag),
        PH_OK);
    ck_assert_int_eq(ph_sample_curve(&one.result.curve, &rules.samples,
                                     &one.arena, &on, &one.diag),
                     PH_OK);
    ck_assert_uint_eq(on.n, offset.samples.n);
    for (size_t k = 0; k < on.n; k++) {
      ph_vec3 p = ph_vec3_get(on.point + 3 * k, 3);
      ph_vec3 t = ph_vec3_get(on.tangent + 3 * k, 3);
      ph_vec3 o = ph_vec3_get(offset.samples.point + 3 * k, 3);
      ph_vec3 v = ph_vec3_get(offset.samples.tangent + 3 * k, 3);
      double kappa = on.curvature[k], turned = offset.samples.curvature[k];
      double forward = ph_vec3_dot(t, v) > 0 ? 1 : -1, apart;
      ph_vec3 back =
          ph_vec3_along(ph_vec3_scale(c, o), -forward * s, ph_vec3_cross(o, v));
      apart = ph_vec3_abs(ph_vec3_sub(back, p));
      ck_that(apart <= 1e-13, "%.3g away", apart);
      ck_that(unit_near(fabs(d), ph_s2_angle(p, o), 1e-14),
              "distance %.17g, not %.17g", ph_s2_angle(p, o), d);
      /* kappa is cot of the angle to the center of curvature */
      turned = atan2(1, forward * turned) + d;
      ck_that(fabs(sin(turned - atan2(1, kappa))) <= 1e-9,
              "curvatures %.17g and %.17g", kappa, offset.samples.curvature[k]);
    }
  }
}

/* ---- anything ------------------------------------------------------------ */

/* Random paths of 8 points without tension: the exact model has a spline
 * through all of them up to 2.2, and through nearly all up to 3. */
PH_TEST_EACH(test_paths, 3) {
  static const enum sphere_family families[] = {SPHERE_WALK, SPHERE_FAR,
                                                SPHERE_FARTHEST};
  struct unit_random r = unit_random_of(40 + (uint64_t)_i);
  bool few = unit_count(10) < 10;
  size_t solved = 0, n = unit_cases(_i == 1 && !few ? 1000 : 200);
  for (size_t i = 0; i < n; i++) {
    sphere_of(&r, families[_i], 8, &data);
    solved += sphere_solve(&data, i, &one);
  }
  ck_share(solved, n, _i < 2 ? 1 : 0.95);
}

/* A curve that is right, or none: sphere_solve looks.  Most have one. */
PH_TEST(test_any) {
  struct unit_random r = unit_random_of(50);
  size_t solved = 0, refused = 0, n = unit_cases(300);
  for (size_t i = 0; i < n; i++) {
    sphere_any(&r, &data);
    solved += sphere_solve(&data, i, &one);
    refused += one.refused;
  }
  ck_share(solved, n, 0.75);
  ck_share(n - refused, n, 0.98);
}

PH_FIXTURE(NULL, finish)
