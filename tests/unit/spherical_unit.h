/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What tests of spherical curves and their parallels share. */
#ifndef PH_TESTS_SPHERICAL_UNIT_H
#define PH_TESTS_SPHERICAL_UNIT_H

#include "unit.h"

#include "curve/result.h"
#include "curve/segment/spherical.h"
#include "kernel/s2.h"

enum { UNIT_SPHERICAL_MAX = 64 };

/* A curve with room for some segments. */
struct unit_spherical {
  struct ph_curve curve;
  double knots[UNIT_SPHERICAL_MAX + 1];
  double control_points[12 * UNIT_SPHERICAL_MAX];
  double lengths[UNIT_SPHERICAL_MAX];
};

/* The geodesic curvature at t; not finite where S' = 0. */
static inline double unit_curvature(const struct ph_spherical *s, double t) {
  ph_vec3 jet[4];
  double speed;
  ph_spherical_jet(s, t, jet);
  speed = ph_vec3_abs(jet[1]);
  return ph_vec3_triple(jet[0], jet[1], jet[2]) / (speed * speed * speed);
}

/* The length of a segment. */
static inline double unit_spherical_length(const struct ph_spherical *s) {
  struct ph_primitive table = {.n = 0};
  double length;
  ck_assert_int_eq(ph_spherical_length(s, &table, &unit_arena, &length), PH_OK);
  return length;
}

/* unit_spherical_of: n segments of the unit sphere with p[4 n]; lengths by
 * unit_spherical_length. */
static inline void unit_spherical_of(struct unit_spherical *c, size_t n,
                                     bool closed, const ph_vec3 *p) {
  c->curve = (struct ph_curve){.kind = PH_CURVE_SPHERICAL_NU,
                               .closed = closed,
                               .dimension = 3,
                               .degree = 3,
                               .n = n,
                               .knots = c->knots,
                               .control_points = c->control_points,
                               .lengths = c->lengths,
                               .sphere.radius = 1};
  c->knots[0] = 0;
  for (size_t i = 0; i < 4 * n; i++) {
    ph_vec3_put(p[i], 3, c->control_points + 3 * i);
  }
  for (size_t k = 0; k < n; k++) {
    struct ph_spherical segment = {
        {p[4 * k], p[4 * k + 1], p[4 * k + 2], p[4 * k + 3]}};
    c->knots[k + 1] = (double)k + 1;
    c->lengths[k] = unit_spherical_length(&segment);
    c->curve.length += c->lengths[k];
  }
}

/* unit_spherical_through: n segments through points[n + 1] (closed: the first
 * one again) with these velocities, by the parameter of a segment. */
static inline void unit_spherical_through(struct unit_spherical *c, size_t n,
                                          bool closed, const ph_vec3 *points,
                                          const ph_vec3 *velocities) {
  ph_vec3 p[4 * UNIT_SPHERICAL_MAX];
  for (size_t k = 0; k < n; k++) {
    p[4 * k] = points[k];
    p[4 * k + 1] = ph_s2_exp(points[k], ph_vec3_scale(1.0 / 3, velocities[k]));
    p[4 * k + 2] =
        ph_s2_exp(points[k + 1], ph_vec3_scale(-1.0 / 3, velocities[k + 1]));
    p[4 * k + 3] = points[k + 1];
  }
  unit_spherical_of(c, n, closed, p);
}

/* unit_spherical_random: n < 8 segments that join with their tangents; the
 * larger `wild`, the more they turn. */
static inline void unit_spherical_random(struct unit_spherical *c, size_t n,
                                         double wild, struct unit_random *r) {
  ph_vec3 points[9], velocities[9], at = {0, 0, 1}, v = {0.7, 0, 0};
  for (size_t i = 0; i <= n; i++) {
    ph_vec3 left = ph_vec3_cross(at, v), next;
    points[i] = at;
    velocities[i] = v;
    v = ph_vec3_along(v, unit_random_in(r, -wild, wild), left);
    next = ph_vec3_unit(ph_s2_exp(at, v));
    /* carried along, of the same length */
    v = ph_vec3_scale(-ph_vec3_abs(v), ph_vec3_unit(ph_s2_log(next, at)));
    v = ph_vec3_along(v, unit_random_in(r, -wild, wild),
                      ph_vec3_cross(next, v));
    v = ph_vec3_scale(unit_random_in(r, 0.5, 0.9), ph_vec3_unit(v));
    at = next;
  }
  unit_spherical_through(c, n, false, points, velocities);
}

/* unit_spherical_place: brings a curve of the unit sphere to another. */
static inline void unit_spherical_place(struct unit_spherical *c,
                                        ph_vec3 center, double radius) {
  ph_vec3_put(center, 3, c->curve.sphere.center);
  c->curve.sphere.radius = radius;
  c->curve.length *= radius;
  for (size_t i = 0; i < 4 * c->curve.n; i++) {
    double *p = c->control_points + 3 * i;
    ph_vec3_put(ph_vec3_along(center, radius, ph_vec3_get(p, 3)), 3, p);
  }
  for (size_t k = 0; k < c->curve.n; k++) {
    c->lengths[k] *= radius;
  }
}

/* ---- parallels ----------------------------------------------------------- */

/* Vector i of an array. */
static inline ph_vec3 unit_vector(const double *v, size_t i) {
  return ph_vec3_get(v + 3 * i, 3);
}

/* kappa_g straight from the jet of a segment, and its speed. */
static inline double unit_kappa(const struct ph_curve *curve, size_t k,
                                double u, double *speed) {
  struct ph_spherical segment = ph_spherical_of(curve, k);
  ph_vec3 jet[4];
  ph_spherical_jet(&segment, u, jet);
  *speed = ph_vec3_abs(jet[1]);
  return ph_vec3_triple(jet[0], jet[1], jet[2]) / (*speed * *speed * *speed);
}

/* The place of the parallel on the unit sphere; at rest, the tangent is the
 * limit. */
static inline ph_vec3 unit_parallel(const struct ph_spherical *segment,
                                    double d, double u) {
  ph_vec3 jet[4], tangent;
  ph_spherical_jet(segment, u, jet);
  tangent = ph_vec3_abs(jet[1]) > 1e-13 * ph_vec3_abs(jet[2])
                ? jet[1]
                : ph_vec3_scale(u < 0.5 ? 1 : -1, jet[2]);
  tangent = ph_vec3_unit(ph_vec3_normal(tangent, jet[0]));
  return ph_vec3_along(ph_vec3_scale(cos(d), jet[0]), sin(d),
                       ph_vec3_cross(jet[0], tangent));
}

/* The distance of p from the line from a to b. */
static inline double unit_chord_distance(ph_vec3 p, ph_vec3 a, ph_vec3 b) {
  ph_vec3 ap = ph_vec3_sub(p, a), ab = ph_vec3_sub(b, a);
  double part = ph_vec3_dot(ap, ab) / ph_vec3_dot(ab, ab);
  part = part > 0 ? part < 1 ? part : 1 : 0;
  return ph_vec3_abs(ph_vec3_along(ap, -part, ab));
}

#endif
