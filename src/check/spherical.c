/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Spherical Bezier segments (see spherical.h). */
#include "check/spherical.h"

#include "kernel/s2.h"

/* A power series: x0 + x1 h + x2 h^2. */
struct series {
  double x[3];
};

static struct series multiply(struct series a, struct series b) {
  struct series c = {{a.x[0] * b.x[0], a.x[0] * b.x[1] + a.x[1] * b.x[0],
                      a.x[0] * b.x[2] + a.x[1] * b.x[1] + a.x[2] * b.x[0]}};
  return c;
}

static struct series divide(struct series a, struct series b) {
  struct series c;
  c.x[0] = a.x[0] / b.x[0];
  c.x[1] = (a.x[1] - c.x[0] * b.x[1]) / b.x[0];
  c.x[2] = (a.x[2] - c.x[0] * b.x[2] - c.x[1] * b.x[1]) / b.x[0];
  return c;
}

/* f0 of a series, with f0' = -f1/2 and f0'' = f2/4. */
static struct series f0_of(struct series x) {
  double f[4];
  struct series y;
  ph_s2_bessel(x.x[0], f);
  y.x[0] = f[0];
  y.x[1] = -f[1] / 2 * x.x[1];
  y.x[2] = -f[1] / 2 * x.x[2] + f[2] / 8 * x.x[1] * x.x[1];
  return y;
}

/* The square of the angle between two moving points. */
static struct series square_of(const ph_vec3 p[3], const ph_vec3 q[3]) {
  struct series x;
  ph_vec3 d[3];
  double angle = ph_s2_angle(p[0], q[0]), f[4], first, second;
  for (size_t i = 0; i < 3; i++) {
    d[i] = ph_vec3_sub(q[i], p[i]);
  }
  first = 2 * ph_vec3_dot(d[0], d[1]);
  second = 2 * ph_vec3_dot(d[0], d[2]) + ph_vec3_dot(d[1], d[1]);
  x.x[0] = angle * angle;
  ph_s2_bessel(x.x[0], f);
  x.x[1] = first / f[0];
  /* X'' = D'' / f0 + D' (f1 / (2 f0^2)) X' */
  x.x[2] = (second + first * f[1] / (4 * f[0]) * x.x[1]) / f[0];
  return x;
}

/* W of (1). */
static struct series weight(struct series t, struct series x,
                            struct series bottom) {
  struct series top = f0_of(multiply(multiply(t, t), x));
  return divide(multiply(t, top), bottom);
}

/* G of (1); q is replaced. */
static void between(const ph_vec3 p[3], ph_vec3 q[3], double t) {
  const struct series from = {{1 - t, -1, 0}}, to = {{t, 1, 0}};
  struct series x = square_of(p, q), bottom = f0_of(x);
  struct series a = weight(from, x, bottom), b = weight(to, x, bottom);
  for (size_t i = 3; i-- > 0;) {
    ph_vec3 sum = {0, 0, 0};
    for (size_t j = 0; j <= i; j++) {
      sum = ph_vec3_along(sum, a.x[j], p[i - j]);
      sum = ph_vec3_along(sum, b.x[j], q[i - j]);
    }
    q[i] = sum;
  }
}

void ph_check_great(const ph_vec3 p[4], double t, ph_vec3 jet[3]) {
  ph_vec3 s[4][3];
  for (size_t i = 0; i < 4; i++) {
    s[i][0] = p[i];
    s[i][1] = s[i][2] = ph_vec3_of(0, 0, 0);
  }
  for (size_t level = 1; level < 4; level++) {
    for (size_t i = 3; i >= level; i--) {
      between(s[i - 1], s[i], t);
    }
  }
  jet[0] = s[3][0];
  jet[1] = s[3][1];
  jet[2] = ph_vec3_scale(2, s[3][2]);
}

/* ---- a segment ----------------------------------------------------------- */

void ph_check_great_load(const struct ph_check *v, struct ph_check_segment *s) {
  s->m = 0;
  s->center = ph_check_vector(v, v->curve->sphere.center, 3);
  s->radius = ph_check_scaled(v, v->curve->sphere.radius);
  for (size_t i = 0; i < 4; i++) {
    s->p[i] = ph_vec3_unit(ph_vec3_sub(s->p[i], s->center));
  }
  for (size_t i = 0; i < 3; i++) {
    s->speed = ph_check_larger(
        s->speed, 3 * s->radius * ph_check_apart(s->p[i + 1], s->p[i]));
  }
}

void ph_check_great_jet(const struct ph_check_segment *s, double u,
                        ph_vec3 *jet, size_t n) {
  ph_vec3 all[3];
  ph_check_great(s->p, u, all);
  for (size_t i = 0; i < n; i++) {
    jet[i] = ph_vec3_scale(s->radius, all[i + 1]);
  }
}

ph_vec3 ph_check_great_point(const struct ph_check *v,
                             const struct ph_check_segment *s, double u) {
  ph_vec3 all[3];
  (void)v;
  ph_check_great(s->p, u, all);
  return ph_vec3_along(s->center, s->radius, all[0]);
}

double ph_check_great_reach(const struct ph_check *v,
                            const struct ph_check_segment *s) {
  return ph_check_reach(v, s->center) + DBL_EPSILON * s->radius;
}
