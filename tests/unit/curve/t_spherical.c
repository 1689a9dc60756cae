/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Spherical Bezier segments: numbers of 80 digits, symmetries, closed forms,
 * and lengths that are known.
 */
#include "unit.h"
#include "spatial_unit.h"
#include "curve_unit.h"
#include "spherical_unit.h"
#include "spherical_known_unit.h"

#include "curve/segment/spherical_net.h"
#include "kernel/pi.h"
#include "kernel/quad.h"
#include "kernel/s2.h"

static struct ph_spherical segment(const double p[4][3]) {
  struct ph_spherical s;
  for (size_t i = 0; i < 4; i++) {
    s.p[i] = ph_vec3_get(p[i], 3);
  }
  return s;
}

static struct ph_spherical reversed(const struct ph_spherical *s) {
  struct ph_spherical r = {{s->p[3], s->p[2], s->p[1], s->p[0]}};
  return r;
}

static struct ph_spherical mirrored(const struct ph_spherical *s) {
  struct ph_spherical m = *s;
  for (size_t i = 0; i < 4; i++) {
    m.p[i].z = -m.p[i].z;
  }
  return m;
}

/* A path of control points with this angle from one to the next, about, that
 * turns by up to bend at each. */
static struct ph_spherical random_segment(struct unit_random *r, double angle,
                                          double bend) {
  struct ph_spherical s;
  ph_vec3 d, side;
  s.p[0] = unit_random_direction(r);
  d = ph_vec3_unit(
      ph_vec3_normal(ph_vec3_cross(s.p[0], unit_random_direction(r)), s.p[0]));
  for (size_t i = 1; i < 4; i++) {
    double step = angle * unit_random_in(r, 0.7, 1.3);
    s.p[i] = ph_vec3_unit(ph_s2_exp(s.p[i - 1], ph_vec3_scale(step, d)));
    side = ph_vec3_cross(s.p[i], d);
    d = ph_vec3_unit(ph_vec3_normal(
        ph_vec3_along(d, unit_random_in(r, -bend, bend), side), s.p[i]));
  }
  return s;
}

/* ---- values --------------------------------------------------------- */

/* What rounding does: more where neighbours are nearly antipodal. */
static double rounding(const struct ph_spherical *s) {
  double least = 1;
  for (size_t i = 0; i < 3; i++) {
    least = fmin(least, ph_vec3_abs(ph_vec3_add(s->p[i], s->p[i + 1])) / 2);
  }
  return DBL_EPSILON / (least * least);
}

/* The control points are unit vectors to rounding, which shows along the normal
 * of the sphere as an absolute error. */
PH_TEST_EACH(test_known_jets, KNOWN) {
  struct ph_spherical s = segment(known[_i].p);
  double t = known[_i].t, scale = 1, eps = rounding(&s);
  ph_vec3 jet[4];
  unit_case("%s", known[_i].name);
  ph_spherical_jet(&s, t, jet);
  for (size_t n = 0; n < 4; n++) {
    ph_vec3 wanted = ph_vec3_get(known[_i].jet[n], 3);
    scale += ph_vec3_abs(wanted);
    ck_vec3(jet[n], wanted, 4 * eps * scale);
  }
}

/* The part of S' along the sphere, and K, are right relative to their size, or
 * to what they are a small difference of. */
PH_TEST_EACH(test_known_numerators, KNOWN) {
  struct ph_spherical s = segment(known[_i].p);
  double t = known[_i].t, eps = rounding(&s), k[2], size[4], speed3;
  ph_vec3 jet[4], wanted = ph_vec3_get(known[_i].jet[1], 3);
  ph_vec3 at = ph_vec3_get(known[_i].jet[0], 3);
  for (size_t n = 0; n < 4; n++) {
    size[n] = ph_vec3_abs(ph_vec3_get(known[_i].jet[n], 3));
  }
  speed3 = size[1] * size[1] * size[1];
  ph_spherical_jet(&s, t, jet);
  ck_abs(ph_vec3_abs(ph_vec3_normal(ph_vec3_sub(jet[1], wanted), at)), 0,
         4 * eps * (size[1] + size[2]));
  ph_spherical_numerator(&s, t, k);
  ck_abs(k[0], known[_i].k[0],
         8 * eps * (size[1] + size[2]) * (size[1] + size[2]));
  ck_abs(k[1], known[_i].k[1],
         8 * eps * (size[1] + size[2]) * (size[1] + size[3]));
  if (t > 0) {
    ck_abs(unit_curvature(&s, t) * speed3, k[0],
           16 * eps * (fabs(k[0]) + size[1] * (size[1] + size[2])));
  } else {
    ck_rel(ph_spherical_numerator_start(&s), known[_i].k[0], 8 * eps);
    ck_rel(ph_spherical_curvature_start(&s) * speed3, known[_i].k[0], 8 * eps);
  }
}

/* The length up to t, as a sampler knows it. */
static double length_to(const struct ph_spherical *s, double t) {
  struct unit_spherical c;
  struct ph_sampler sampler;
  unit_spherical_of(&c, 1, false, s->p);
  sampler = unit_sampler(&c.curve, NULL, 0);
  return unit_length(&sampler, t);
}

PH_TEST_EACH(test_known_lengths, KNOWN) {
  struct ph_spherical s = segment(known[_i].p);
  double t = known[_i].t > 0 ? known[_i].t : 1;
  ck_abs(length_to(&s, t), known[_i].length, 1e-13 * unit_spherical_length(&s));
}

/* ---- what derivatives are ------------------------------------------- */

/* |S| = 1, hence S.S' = 0, and S.S'' + |S'|^2 = 0, and S.S''' + 3 S'.S'' = 0.
 */
PH_TEST(test_on_sphere) {
  struct unit_random r = unit_random_of(611);
  for (int i = 0; i < unit_count(500); i++) {
    double angle = pow(10, unit_random_in(&r, -6, 0)), t, tol;
    struct ph_spherical s = random_segment(&r, angle, 1);
    ph_vec3 j[4];
    t = unit_random_in(&r, 0, 1);
    tol = 64 * DBL_EPSILON * (1 + 10 * angle);
    ph_spherical_jet(&s, t, j);
    ck_abs(ph_vec3_abs(j[0]), 1, 8 * DBL_EPSILON);
    ck_abs(ph_vec3_dot(j[0], j[1]), 0, tol);
    ck_abs(ph_vec3_dot(j[0], j[2]), -ph_vec3_dot(j[1], j[1]), 4 * tol);
    ck_abs(ph_vec3_dot(j[0], j[3]), -3 * ph_vec3_dot(j[1], j[2]), 16 * tol);
  }
}

/* Each derivative against differences of the one before, of K as well; what
 * differences leave falls with the square of their step. */
PH_TEST(test_differences) {
  struct unit_random r = unit_random_of(612);
  const double h = 1e-4;
  for (int i = 0; i < unit_count(200); i++) {
    double angle = pow(10, unit_random_in(&r, -4, -0.2)), t, a[2], b[2], k[2];
    struct ph_spherical s = random_segment(&r, angle, 1);
    ph_vec3 u[4], w[4], j[4];
    t = unit_random_in(&r, 0.01, 0.99);
    ph_spherical_jet(&s, t - h, u);
    ph_spherical_jet(&s, t + h, w);
    ph_spherical_jet(&s, t, j);
    for (size_t n = 0; n < 3; n++) {
      ph_vec3 difference = ph_vec3_scale(0.5 / h, ph_vec3_sub(w[n], u[n]));
      ck_vec3(difference, j[n + 1], 1e-5 * angle + 1e-11);
    }
    ph_spherical_numerator(&s, t - h, a);
    ph_spherical_numerator(&s, t + h, b);
    ph_spherical_numerator(&s, t, k);
    ck_abs((b[0] - a[0]) / (2 * h), k[1],
           angle * angle * (1e-4 * angle + 1e-10));
  }
}

/* ---- symmetries ----------------------------------------------------- */

PH_TEST(test_symmetries) {
  struct unit_random r = unit_random_of(613);
  for (int i = 0; i < unit_count(500); i++) {
    double angle = pow(10, unit_random_in(&r, -6, 0)), t, k[2], other[2];
    struct ph_spherical s = random_segment(&r, angle, 1);
    struct ph_spherical back = reversed(&s), m = mirrored(&s);
    ph_vec3 jet[4], jet_back[4];
    double tol = 1e-13 * angle * angle;
    t = unit_random_in(&r, 0, 1);
    ph_spherical_jet(&s, t, jet);
    ph_spherical_jet(&back, 1 - t, jet_back);
    ck_vec3(jet_back[0], jet[0], 8 * DBL_EPSILON);
    ph_spherical_numerator(&s, t, k);
    ph_spherical_numerator(&back, 1 - t, other);
    ck_abs(other[0], -k[0], tol);
    ck_abs(other[1], k[1], 16 * tol);
    ph_spherical_numerator(&m, t, other);
    ck_abs(other[0], -k[0], 0);
    ck_abs(other[1], -k[1], 0);
    ck_rel(unit_spherical_length(&back), unit_spherical_length(&s), 1e-13);
    ck_rel(unit_spherical_length(&m), unit_spherical_length(&s), 0);
    ck_rel(ph_spherical_curvature_end(&s), -ph_spherical_curvature_start(&back),
           0);
  }
}

/* ---- the ends ------------------------------------------------------- */

PH_TEST(test_ends) {
  struct unit_random r = unit_random_of(614);
  for (int i = 0; i < unit_count(500); i++) {
    double angle = pow(10, unit_random_in(&r, -6, 0)), k[2], speed;
    double tol = 1e-13 * angle * angle;
    struct ph_spherical s = random_segment(&r, angle, 1);
    ph_vec3 j[4];
    ph_spherical_numerator(&s, 0, k);
    ck_abs(ph_spherical_numerator_start(&s), k[0], tol);
    ph_spherical_jet(&s, 0, j);
    speed = ph_vec3_abs(j[1]);
    ck_rel(speed, 3 * ph_s2_angle(s.p[0], s.p[1]), 16 * DBL_EPSILON);
    ck_vec3(j[0], s.p[0], 8 * DBL_EPSILON);
    ck_rel(ph_spherical_curvature_start(&s),
           ph_spherical_numerator_start(&s) / (speed * speed * speed),
           64 * DBL_EPSILON);
    ph_spherical_jet(&s, 1, j);
    ck_rel(ph_vec3_abs(j[1]), 3 * ph_s2_angle(s.p[2], s.p[3]),
           16 * DBL_EPSILON);
    ck_vec3(j[0], s.p[3], 8 * DBL_EPSILON);
  }
}

/* Prepared by its legs: K alone is that of K and K', to the last digit, and at
 * the ends that in closed form. */
PH_TEST(test_legs) {
  struct unit_random r = unit_random_of(617);
  for (int i = 0; i < unit_count(500); i++) {
    double angle = pow(10, unit_random_in(&r, -6, 0)), k[2], t;
    double tol = 1e-13 * angle * angle;
    struct ph_spherical s = random_segment(&r, angle, 1);
    struct ph_spherical_legs legs = ph_spherical_legs_of(&s);
    struct ph_spherical_net net;
    ph_spherical_net_of_legs(&legs, &net);
    t = unit_random_in(&r, 0, 1);
    ph_spherical_net_numerators(&net, t, k);
    ck_abs(ph_spherical_net_numerator(&net, t), k[0], 0);
    ck_abs(ph_spherical_net_numerator(&net, 0),
           ph_spherical_legs_numerator_start(&legs), tol);
    ck_abs(ph_spherical_net_numerator(&net, 1),
           ph_spherical_legs_numerator_end(&legs), tol);
  }
}

/* At rest there is no curvature.  All control points are on a great circle: the
 * angle is 3 t^2 - 2 t^3 of the whole. */
PH_TEST(test_rest) {
  struct unit_random r = unit_random_of(615);
  for (int i = 0; i < unit_count(100); i++) {
    struct ph_spherical s = random_segment(&r, 0.4, 1);
    double angle = ph_s2_angle(s.p[0], s.p[3]);
    ph_vec3 j[4];
    s.p[1] = s.p[0];
    s.p[2] = s.p[3];
    ck_abs(ph_spherical_numerator_start(&s), 0, 0);
    ck_assert(!isfinite(ph_spherical_curvature_start(&s)));
    ck_assert(!isfinite(ph_spherical_curvature_end(&s)));
    ph_spherical_jet(&s, 0, j);
    ck_abs(ph_vec3_abs(j[1]), 0, 16 * DBL_EPSILON);
    ck_rel(ph_vec3_abs(ph_vec3_normal(j[2], j[0])), 6 * angle, 1e-14);
    ck_rel(unit_spherical_length(&s), angle, 1e-14);
    ck_rel(length_to(&s, 0.25), 0.15625 * angle, 1e-13);
  }
}

PH_TEST(test_point) {
  ph_vec3 p = {0.6, 0, 0.8};
  struct ph_spherical s = {{p, p, p, p}};
  ph_vec3 j[4];
  double k[2];
  for (int i = 0; i <= 4; i++) {
    ph_spherical_jet(&s, 0.25 * i, j);
    ck_vec3(j[0], p, 0);
    for (size_t n = 1; n < 4; n++) {
      ck_abs(ph_vec3_abs(j[n]), 0, 0);
    }
    ph_spherical_numerator(&s, 0.25 * i, k);
    ck_abs(k[0], 0, 0);
    ck_abs(k[1], 0, 0);
  }
  ck_abs(unit_spherical_length(&s), 0, 0);
}

PH_TEST(test_not_a_segment) {
  ph_vec3 p = {1, 0, 0}, q = {0, 1, 0}, bad = {0, (double)NAN, 1};
  struct ph_spherical s = {{p, bad, q, q}};
  struct ph_primitive table = {.n = 0};
  double length;
  ck_assert_int_eq(ph_spherical_length(&s, &table, &unit_arena, &length),
                   PH_E_NO_CONVERGENCE);
}

/* ---- curves that are known ------------------------------------------ */

/* On a great circle angles are those of a Bezier polynomial. */
PH_TEST(test_great_circle) {
  struct unit_random r = unit_random_of(616);
  for (int i = 0; i < unit_count(300); i++) {
    double size = pow(10, unit_random_in(&r, -6, 0)), a[4] = {0}, t, b;
    ph_vec3 e = unit_random_direction(&r), f = ph_vec3_any_normal(e), j[4];
    struct ph_spherical s;
    for (size_t n = 0; n < 4; n++) {
      a[n] = n > 0 ? a[n - 1] + size * unit_random_in(&r, 0.2, 1) : 0;
      s.p[n] = ph_s2_exp(e, ph_vec3_scale(a[n], f));
    }
    t = unit_random_in(&r, 0.1, 1);
    b = 3 * t * (1 - t) * ((1 - t) * a[1] + t * a[2]) + t * t * t * a[3];
    ck_rel(length_to(&s, t), b, 1e-14 + 4e-15 / size);
    ck_rel(unit_spherical_length(&s), a[3], 1e-14 + 4e-15 / size);
    ph_spherical_jet(&s, t, j);
    ck_vec3(j[0], ph_s2_exp(e, ph_vec3_scale(b, f)), 8 * DBL_EPSILON);
    ck_abs(ph_vec3_triple(j[0], j[1], j[2]), 0, 64 * DBL_EPSILON * size);
  }
}

/* Forth, back for a short way, and forth: a speed with two corners that nodes
 * of a rule step over.  The angle is 3 c (t^3/3 - t0 t^2 + (t0^2 - r^2) t). */
PH_TEST(test_runs_back) {
  struct unit_random r = unit_random_of(612908);
  for (int i = 0; i < unit_count(100); i++) {
    double size = pow(10, unit_random_in(&r, -5, -0.5));
    double t = unit_random_in(&r, 0.1, 0.9), a[4] = {0}, leg[3];
    double back = pow(10, unit_random_in(&r, -3, -1.1)), value = t * t;
    ph_vec3 e = unit_random_direction(&r), f = ph_vec3_any_normal(e);
    struct ph_spherical s;
    value -= back * back;
    leg[0] = value;
    leg[1] = value - t;
    leg[2] = value - 2 * t + 1;
    for (size_t n = 0; n < 4; n++) {
      a[n] = n > 0 ? a[n - 1] + size * leg[n - 1] : 0;
      s.p[n] = ph_s2_exp(e, ph_vec3_scale(a[n], f));
    }
    ck_rel(unit_spherical_length(&s), a[3] + 8 * size * back * back * back,
           1e-12 + 1e-14 / size);
  }
}

/* A quarter of the parallel of latitude pi/4, in short segments: its geodesic
 * curvature is tan(pi/4) = 1, to the left going east. */
PH_TEST(test_parallel) {
  enum { PIECES = 256 };
  const double step = PH_PI / 2 / PIECES, c = sqrt(0.5);
  double length = 0;
  for (size_t k = 0; k < PIECES; k++) {
    struct ph_spherical s;
    double a = step * (double)k, b = a + step;
    ph_vec3 east = {-sin(a), cos(a), 0}, later = {-sin(b), cos(b), 0};
    s.p[0] = ph_vec3_of(c * cos(a), c * sin(a), c);
    s.p[3] = ph_vec3_of(c * cos(b), c * sin(b), c);
    s.p[1] = ph_s2_exp(s.p[0], ph_vec3_scale(c * step / 3, east));
    s.p[2] = ph_s2_exp(s.p[3], ph_vec3_scale(-c * step / 3, later));
    length += unit_spherical_length(&s);
    ck_rel(unit_curvature(&s, 0.5), 1, 1e-4);
    ck_rel(ph_spherical_curvature_start(&s), 1, 1e-4);
    ck_rel(ph_spherical_curvature_end(&s), 1, 1e-4);
  }
  ck_rel(length, c * PH_PI / 2, 1e-10);
}

/* The length by 20 nodes on each of 32 parts of u, t = u^3 (10 - 15 u + 6 u^2),
 * which grades both ends. */
static double graded_length(const struct ph_spherical *s,
                            const struct ph_quad *rule) {
  enum { PARTS = 32 };
  double sum = 0;
  for (int k = 0; k < PARTS; k++) {
    for (size_t i = 0; i < rule->n; i++) {
      double u = (k + rule->node[i]) / PARTS, v = u * (1 - u);
      ph_vec3 j[4];
      ph_spherical_jet(s, u * u * u * (10 - 15 * u + 6 * u * u), j);
      sum += rule->weight[i] / PARTS * 30 * v * v * ph_vec3_abs(j[1]);
    }
  }
  return sum;
}

PH_TEST(test_length) {
  struct unit_random r = unit_random_of(617);
  struct ph_quad rule;
  ck_assert(ph_quad_gauss(&rule, PH_QUAD_MAX));
  for (int i = 0; i < unit_count(200); i++) {
    double angle = pow(10, unit_random_in(&r, -5, -0.3)), length;
    struct ph_spherical s = random_segment(&r, angle, i % 2 == 0 ? 1 : 0.01);
    if (i % 3 == 0) { /* strong tension */
      s.p[1] = ph_s2_slerp(s.p[0], s.p[1], pow(10, unit_random_in(&r, -9, -1)));
      s.p[2] = ph_s2_slerp(s.p[3], s.p[2], pow(10, unit_random_in(&r, -9, -1)));
    }
    length = unit_spherical_length(&s);
    ck_rel(length, graded_length(&s, &rule), 1e-13);
    ck_assert(length >= ph_s2_angle(s.p[0], s.p[3]) * (1 - 1e-13));
  }
}

/* ---- from curves ---------------------------------------------------- */

PH_TEST(test_of_curve) {
  struct unit_random r = unit_random_of(618);
  double points[24];
  struct ph_curve curve = {.kind = PH_CURVE_SPHERICAL_NU,
                           .n = 2,
                           .dimension = 3,
                           .degree = 3,
                           .control_points = points,
                           .sphere.center = {10, -3, 0.5},
                           .sphere.radius = 6371};
  ph_vec3 p[8];
  for (size_t i = 0; i < 8; i++) {
    p[i] = unit_random_direction(&r);
    ph_vec3_put(ph_vec3_along(ph_vec3_get(curve.sphere.center, 3),
                              curve.sphere.radius * (1 + 1e-9), p[i]),
                3, points + 3 * i);
  }
  for (size_t i = 0; i < 8; i++) {
    struct ph_spherical s = ph_spherical_of(&curve, i / 4);
    ck_vec3(s.p[i % 4], p[i], 4 * DBL_EPSILON);
    ck_abs(ph_vec3_abs(s.p[i % 4]), 1, DBL_EPSILON);
  }
}
