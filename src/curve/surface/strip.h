/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * One strip (surface.h), in closed form that has no singular limit: with
 * K^2 = k^2 + kn^2, S = sin(K s)/K and Q = (1 - cos(K s))/K^2
 *
 *   c(s) = c + S d + Q (k e + kn n)
 *   d(s) = d + S (k e + kn n) - Q K^2 d
 *   e(s) = e - k (c(s) - c),  n(s) = n - kn (c(s) - c)
 *
 * and the same with K = k in the plane of the development.
 */
#ifndef PH_CURVE_SURFACE_STRIP_H
#define PH_CURVE_SURFACE_STRIP_H

#include "curve/result.h"
#include "kernel/vec3.h"

#include <math.h>

/* A place of the contact curve, and its frame. */
struct ph_strip_place {
  ph_vec3 c, e, d, n;
};

/* The same of the development: the angle is that of the tangent, the ruling is
 * a quarter turn to the left of it. */
struct ph_flat_place {
  double c[2];
  double angle;
};

/* ph_sinc: sin(x)/x. */
static inline double ph_sinc(double x) {
  return fabs(x) > 0 ? sin(x) / x : 1;
}

/* ph_strip_start: the frame of a strip. */
static inline struct ph_strip_place
ph_strip_start(const struct ph_strip *strip) {
  const struct ph_strip_frame *f = &strip->frame;
  struct ph_strip_place place = {
      ph_vec3_get(f->point, 3), ph_vec3_get(f->ruling, 3),
      ph_vec3_get(f->tangent, 3), ph_vec3_get(f->normal, 3)};
  return place;
}

/* ph_strip_at: the frame at arc length s, from that at the start. */
static inline struct ph_strip_place ph_strip_at(struct ph_strip_place start,
                                                double k, double kn, double s) {
  const double x = hypot(k, kn) * s, half = ph_sinc(x / 2);
  const double S = ph_sinc(x), Q = half * half / 2; /* over s and s^2, which may
                                                       be out of range */
  const ph_vec3 bend =
      ph_vec3_along(ph_vec3_scale(k * s, start.e), kn * s, start.n);
  const ph_vec3 way = ph_vec3_along(ph_vec3_scale(S, start.d), Q, bend);
  struct ph_strip_place at;
  at.c = ph_vec3_along(start.c, s, way);
  at.d = ph_vec3_along(ph_vec3_scale(1 - Q * x * x, start.d), S, bend);
  at.e = ph_vec3_along(start.e, -k * s, way);
  at.n = ph_vec3_along(start.n, -kn * s, way);
  return at;
}

/* ph_flat_at: the same of the development. */
static inline struct ph_flat_place ph_flat_at(const struct ph_flat_place *start,
                                              double k, double s) {
  const double x = cos(start->angle), y = sin(start->angle);
  const double half = ph_sinc(k * s / 2);
  const double S = s * ph_sinc(k * s), Q = k * s * s * half * half / 2;
  struct ph_flat_place at = {
      {start->c[0] + S * x - Q * y, start->c[1] + S * y + Q * x},
      start->angle + k * s};
  return at;
}

/* ph_flat_start: where the development of a strip begins. */
static inline struct ph_flat_place ph_flat_start(const struct ph_strip *strip) {
  const struct ph_arc2 *arc = &strip->development;
  struct ph_flat_place place = {
      {arc->control_points[0][0], arc->control_points[0][1]}, arc->angle};
  return place;
}

/* ph_strip_end: the frame where a strip ends. */
static inline struct ph_strip_place ph_strip_end(const struct ph_strip *strip) {
  return ph_strip_at(ph_strip_start(strip), strip->k, strip->kn, strip->length);
}

/* ph_surface_bare: whether no height is meant, but the contact curve. */
static inline bool ph_surface_bare(const double height[2]) {
  return !(fabs(height[0]) > 0) && !(fabs(height[1]) > 0);
}

/* ph_strip_height: a height from the given points as h of the strip at u in
 * [0,1] of its length; of the contact curve alone it is 0. */
static inline double ph_strip_height(const struct ph_surface *surface,
                                     const struct ph_strip *strip,
                                     double height, double u) {
  const double *shift = strip->shift;
  return ph_surface_bare(surface->height)
             ? 0
             : height - (shift[0] + u * (shift[1] - shift[0]));
}

/* ph_strip_corners: the heights of a surface as h at both ends of a strip. */
static inline void ph_strip_corners(const struct ph_surface *surface,
                                    const struct ph_strip *strip,
                                    double h[2][2]) {
  for (size_t i = 0; i < 4; i++) {
    h[i >> 1][i & 1] = ph_strip_height(surface, strip, surface->height[i >> 1],
                                       (double)(i & 1));
  }
}

/* ph_surface_folds: at the ends of how many strips the surface turns back on
 * the ruling to the next, and the first of them: somewhere within the height,
 * one of both strips is beyond its vertex. */
size_t ph_surface_folds(const struct ph_curve *curve, size_t *first);

/* ph_strip_describe: what follows from the frame, the curvatures and the
 * length, and for the contact curve from its end, its chord and its weight. */
void ph_strip_describe(struct ph_strip *strip, const double end[3],
                       double chord, double weight);

/* ph_develop: the developments of all strips, one after the other, from the
 * origin on, with the ruling along y.  Where a pair begins elsewhere on the
 * ruling than the one before ended, so it does in the plane. */
void ph_develop(struct ph_curve *curve);

/* ph_surface_measure: the lengths of the strips, their sum, and the area. */
void ph_surface_measure(struct ph_curve *curve);

#endif
