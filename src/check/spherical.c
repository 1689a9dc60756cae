/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Spherical Bezier segments (see spherical.h). */
#include "check/spherical.h"

#include "kernel/s2.h"

#include <string.h>

/* A value and two derivatives. */
struct jet {
  ph_vec3 v[3];
};

/* w(s,X) with its derivative and second derivative by t, s' = first, 1 or -1;
 * f are f_0, f_1, f_2 of X, x its value and derivatives. */
static void weight_jet(double s, double first, const double f[4],
                       const double x[3], double w[3]) {
  double g[4], y = s * s * x[0], d = f[0], dx = -f[1] / 2, dxx = f[2] / 4;
  double by_s, by_x, by_sx, by_xx;
  ph_s2_bessel(y, g);
  w[0] = s * g[0] / d;
  by_s = (g[0] - y * g[1]) / d;
  by_x = (-s * s * s * g[1] / 2 - w[0] * dx) / d;
  by_sx = (-s * s * g[0] / 2 - by_s * dx) / d;
  by_xx = (s * s * s * s * s * g[2] / 4 - 2 * by_x * dx - w[0] * dxx) / d;
  w[1] = first * by_s + by_x * x[1];
  w[2] = -x[0] * w[0] + 2 * first * by_sx * x[1] + by_xx * x[1] * x[1] +
         by_x * x[2];
}

/* The first step: t on the great circle of a leg. */
static struct jet leg_jet(ph_vec3 p, ph_vec3 q, double x, double t) {
  struct jet z;
  double f = ph_s2_f0(x), angle = sqrt(x), s = 1 - t;
  z.v[0] = ph_vec3_along(ph_vec3_scale(s * ph_s2_f0(s * s * x) / f, p),
                         t * ph_s2_f0(t * t * x) / f, q);
  z.v[1] = ph_vec3_along(ph_vec3_scale(-cos(s * angle) / f, p),
                         cos(t * angle) / f, q);
  z.v[2] = ph_vec3_scale(-x, z.v[0]);
  return z;
}

/* A step between two moving points. */
static struct jet step_jet(const struct jet *a, const struct jet *b, double t,
                           double *growth) {
  struct jet z;
  ph_vec3 d[3];
  double f[4], x[3], e[2], u[3], v[3];
  for (size_t i = 0; i < 3; i++) {
    d[i] = ph_vec3_sub(a->v[i], b->v[i]);
  }
  x[0] = ph_s2_square(a->v[0], b->v[0]);
  ph_s2_bessel(x[0], f);
  *growth /= f[0];
  /* |d|^2 = 2 - 2 cos th, so that its derivative by X is f_0 */
  e[0] = 2 * ph_vec3_dot(d[0], d[1]);
  e[1] = 2 * (ph_vec3_dot(d[0], d[2]) + ph_vec3_dot(d[1], d[1]));
  x[1] = e[0] / f[0];
  x[2] = (e[1] + f[1] / 2 * x[1] * x[1]) / f[0];
  weight_jet(1 - t, -1, f, x, u);
  weight_jet(t, 1, f, x, v);
  z.v[0] = ph_vec3_along(ph_vec3_scale(u[0], a->v[0]), v[0], b->v[0]);
  z.v[1] = ph_vec3_along(ph_vec3_scale(u[1], a->v[0]), v[1], b->v[0]);
  z.v[1] = ph_vec3_along(z.v[1], u[0], a->v[1]);
  z.v[1] = ph_vec3_along(z.v[1], v[0], b->v[1]);
  z.v[2] = ph_vec3_along(ph_vec3_scale(u[2], a->v[0]), v[2], b->v[0]);
  z.v[2] = ph_vec3_along(z.v[2], 2 * u[1], a->v[1]);
  z.v[2] = ph_vec3_along(z.v[2], 2 * v[1], b->v[1]);
  z.v[2] = ph_vec3_along(z.v[2], u[0], a->v[2]);
  z.v[2] = ph_vec3_along(z.v[2], v[0], b->v[2]);
  return z;
}

void ph_check_great_angles(const ph_vec3 p[4], double x[3]) {
  for (size_t i = 0; i < 3; i++) {
    x[i] = ph_s2_square(p[i], p[i + 1]);
  }
}

ph_vec3 ph_check_great_beyond(const ph_vec3 p[4], const double x[3], double t,
                              double *factor) {
  double from = ph_s2_weight(1 - t, x[1]), to = ph_s2_weight(t, x[1]);
  *factor += fabs(from) + fabs(to);
  return ph_vec3_along(ph_vec3_scale(from, p[1]), to, p[2]);
}

double ph_check_great(const ph_vec3 p[4], const double x[3], double t,
                      ph_vec3 jet[3]) {
  struct jet z[3];
  double growth = 1;
  for (size_t i = 0; i < 3; i++) {
    z[i] = leg_jet(p[i], p[i + 1], x[i], t);
  }
  z[0] = step_jet(&z[0], &z[1], t, &growth);
  z[1] = step_jet(&z[1], &z[2], t, &growth);
  z[0] = step_jet(&z[0], &z[1], t, &growth);
  memcpy(jet, z[0].v, sizeof z[0].v);
  return growth;
}

/* ---- a segment ----------------------------------------------------------- */

void ph_check_great_load(const struct ph_check *v, struct ph_check_segment *s) {
  s->m = 0;
  s->center = ph_check_vector(v, v->curve->sphere.center, 3);
  s->radius = ph_check_scaled(v, v->curve->sphere.radius);
  s->reach = ph_check_reach(v, s->center) + DBL_EPSILON * s->radius;
  for (size_t i = 0; i < 4; i++) {
    s->p[i] = ph_check_vector(v, ph_curve_points(v->curve, s->k) + 3 * i, 3);
  }
  s->end[0] = s->p[0];
  s->end[1] = s->p[3];
  for (size_t i = 0; i < 4; i++) {
    s->p[i] = ph_vec3_unit(ph_vec3_sub(s->p[i], s->center));
  }
  ph_check_great_angles(s->p, s->x);
  for (size_t i = 0; i < 2; i++) {
    ph_vec3 jet[2];
    ph_check_great_jet(s, (double)i, jet, 2);
    s->first[i] = jet[0];
    s->second[i] = jet[1];
  }
  for (size_t i = 0; i < 3; i++) {
    s->speed = ph_check_larger(
        s->speed, 3 * s->radius * ph_check_apart(s->p[i + 1], s->p[i]));
  }
}

void ph_check_great_jet(const struct ph_check_segment *s, double u,
                        ph_vec3 *jet, size_t n) {
  ph_vec3 all[3];
  ph_check_great(s->p, s->x, u, all);
  for (size_t i = 0; i < n; i++) {
    jet[i] = ph_vec3_scale(s->radius, all[i + 1]);
  }
}

ph_vec3 ph_check_great_point(const struct ph_check *v,
                             const struct ph_check_segment *s, double u) {
  ph_vec3 all[3];
  (void)v;
  ph_check_great(s->p, s->x, u, all);
  return ph_vec3_along(s->center, s->radius, all[0]);
}
