/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Spherical splines for tests (see cert_sphere_unit.h). */
#include "cert_sphere_unit.h"

#include "unit.h"

#include "curve/segment/spherical.h"
#include "kernel/pi.h"
#include "kernel/quad.h"
#include "kernel/s2.h"

void unit_sphere_put(const struct unit_ball *sphere, ph_vec3 p, double *v) {
  ph_vec3 at = ph_vec3_along(ph_vec3_get(sphere->center, 3), sphere->radius, p);
  ph_vec3_put(at, 3, v);
}

/* Points and an empty curve through them. */
static void begin(struct unit_sphere *u, const struct unit_ball *sphere,
                  bool closed, size_t n, const ph_vec3 *p) {
  size_t m = closed ? n : n - 1;
  memset(u, 0, sizeof *u);
  u->curve = (struct ph_curve){.kind = PH_CURVE_SPHERICAL_NU,
                               .closed = closed,
                               .dimension = 3,
                               .degree = 3,
                               .n = m,
                               .knots = u->knots,
                               .control_points = u->control_points,
                               .lengths = u->lengths,
                               .sphere.tensions = u->tensions,
                               .sphere.indicators = u->indicators,
                               .sphere.waived = u->waived,
                               .sphere.radius = sphere->radius};
  memcpy(u->curve.sphere.center, sphere->center, sizeof u->center);
  memcpy(u->center, sphere->center, sizeof u->center);
  for (size_t i = 0; i < n; i++) {
    unit_sphere_put(sphere, p[i], u->points + 3 * i);
  }
  for (size_t k = 0; k < m; k++) {
    u->waived[k] = k;
    u->knots[k + 1] = u->knots[k] + ph_s2_angle(p[k], p[(k + 1) % n]);
    unit_sphere_put(sphere, p[k], u->control_points + 12 * k);
    unit_sphere_put(sphere, p[(k + 1) % n], u->control_points + 12 * k + 9);
  }
  unit_set_array(&u->problem, PH_F_POINTS, u->points, n, 3);
  unit_set_flag(&u->problem, PH_F_CLOSED, closed);
  unit_set_word(&u->problem, PH_F_SHAPE, "warn");
  unit_set_array(&u->problem, PH_F_CENTER, u->center, 3, 1);
  unit_set_number(&u->problem, PH_F_RADIUS, sphere->radius);
}

static void set_length(struct unit_sphere *u, size_t k, double length) {
  u->lengths[k] = length;
  u->curve.length += length;
}

void unit_cert_sphere_of(struct unit_sphere *u, const struct unit_spline *s,
                         const struct unit_ball *sphere) {
  ph_vec3 p[7] = {{0, 0, 0}};
  for (size_t i = 0; i < s->n; i++) {
    p[i] = ph_vec3_get(s->points + 3 * i, 3);
  }
  begin(u, sphere, s->closed, s->n, p);
  u->curve.sphere.waived_n = s->shape ? 0 : u->curve.n;
  unit_set_word(&u->problem, PH_F_MODEL, s->nielson ? "nielson" : "exact");
  if (!s->closed) {
    unit_set_word(&u->problem, PH_F_ENDS, s->rest ? "rest" : "natural");
  }
  memcpy(u->tensions, s->tensions, sizeof s->tensions);
  memcpy(u->indicators, s->indicators, sizeof s->indicators);
  for (size_t k = 0; k < u->curve.n; k++) {
    for (size_t i = 0; i < 2; i++) {
      unit_sphere_put(sphere, ph_vec3_get(s->inner + 6 * k + 3 * i, 3),
                      u->control_points + 12 * k + 3 * (i + 1));
    }
    set_length(u, k, sphere->radius * s->lengths[k]);
  }
}

/* The length of a segment by Gauss quadrature, on parts that become as small as
 * the speed may be at the ends. */
static double length_of(const struct ph_spherical *s) {
  enum { FINEST = 40 };
  struct ph_quad rule;
  double length = 0;
  ck_assert(ph_quad_gauss(&rule, 12));
  for (int k = 1; k <= FINEST; k++) {
    double from = k == FINEST ? 0 : ldexp(1, -k - 1);
    double width = (ldexp(1, -k) - from) / 4;
    for (size_t i = 0; i < 4 * rule.n; i++) {
      double t = from + width * ((double)(i / rule.n) + rule.node[i % rule.n]);
      ph_vec3 jet[2][4];
      ph_spherical_jet(s, t, jet[0]);
      ph_spherical_jet(s, 1 - t, jet[1]);
      length += width * rule.weight[i % rule.n] *
                (ph_vec3_abs(jet[0][1]) + ph_vec3_abs(jet[1][1]));
    }
  }
  return length;
}

void unit_sphere_latitude(struct unit_sphere *u, size_t n, double lat,
                          double leg, const struct unit_ball *sphere) {
  ph_vec3 p[UNIT_SPHERE_MAX] = {{0, 0, 0}}, t[UNIT_SPHERE_MAX];
  double length = 0, nu = 0;
  for (size_t i = 0; i < n; i++) {
    double lon = 2 * PH_PI * (double)i / (double)n;
    p[i] = ph_vec3_of(cos(lat) * cos(lon), cos(lat) * sin(lon), sin(lat));
    t[i] = ph_vec3_of(-sin(lon), cos(lon), 0);
  }
  begin(u, sphere, true, n, p);
  for (size_t k = 0; k < n; k++) {
    struct ph_spherical s = {
        {p[k], ph_s2_exp(p[k], ph_vec3_scale(leg, t[k])),
         ph_s2_exp(p[(k + 1) % n], ph_vec3_scale(-leg, t[(k + 1) % n])),
         p[(k + 1) % n]}};
    if (k == 0) {
      ph_vec3 jet[4];
      ph_spherical_jet(&s, 0, jet);
      nu = 2 * ph_vec3_dot(jet[2], t[0]) / (3 * leg * u->knots[1]);
      length = length_of(&s);
    }
    unit_sphere_put(sphere, s.p[1], u->control_points + 12 * k + 3);
    unit_sphere_put(sphere, s.p[2], u->control_points + 12 * k + 6);
    set_length(u, k, sphere->radius * length);
    u->tensions[k] = nu;
    u->indicators[k] = lat > 0 ? 1 : lat < 0 ? -1 : 0;
  }
}

void unit_sphere_arc(struct unit_sphere *u, double angle, double turn_from,
                     double turn_to, const struct unit_ball *sphere) {
  ph_vec3 p[2] = {{1, 0, 0}, {cos(angle), sin(angle), 0}};
  ph_vec3 t[2] = {
      {0, cos(turn_from), sin(turn_from)},
      {-cos(turn_to) * sin(angle), cos(turn_to) * cos(angle), sin(turn_to)}};
  struct ph_spherical s = {
      {p[0], ph_s2_exp(p[0], ph_vec3_scale(angle / 3, t[0])),
       ph_s2_exp(p[1], ph_vec3_scale(-angle / 3, t[1])), p[1]}};
  begin(u, sphere, false, 2, p);
  unit_sphere_put(sphere, s.p[1], u->control_points + 3);
  unit_sphere_put(sphere, s.p[2], u->control_points + 6);
  set_length(u, 0, sphere->radius * length_of(&s));
  /* what is normal to the sphere does not count */
  ph_vec3_put(ph_vec3_along(ph_vec3_scale(7, t[0]), -2, p[0]), 3,
              u->end_tangents);
  ph_vec3_put(ph_vec3_along(ph_vec3_scale(1e-9, t[1]), 1e-9, p[1]), 3,
              u->end_tangents + 3);
}
