/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Numbers that are >= 0 where criteria of shape hold with a margin (see
 * sphere_measure.h).
 *
 * The margin leaves room for what a linear program misses, and keeps curves
 * away from where a criterion just holds: there they may have a cusp.
 */
#include "solve/sphere/measure.h"

#include <math.h>

/* Margins, relative to epsilon, to the turn of the data, and to the largest
 * sample of a segment. */
static const double MARGIN_EPSILON = 2e-3;
static const double MARGIN_TURN = 1e-4;
static const double MARGIN_SEGMENT = 1e-5;

/* The sine of the turn from one vector to another at p; |.|: its size. */
static double turn_of(ph_vec3 p, ph_vec3 a, ph_vec3 b) {
  return ph_vec3_triple(p, a, b) / (ph_vec3_abs(a) * ph_vec3_abs(b));
}

/* The turn of the control polygon beside node i, of the sign of K there,
 * against that of the data. */
static size_t measure_convexity(const struct ph_sphere_shape *shape,
                                const struct ph_sphere_spline *s, size_t i,
                                double *g) {
  const struct ph_sphere_data *d = s->data;
  size_t k = ph_sphere_before(d, i), n = 0;
  ph_vec3 p = d->p[i], before = ph_vec3_sub(p, d->p[k]);
  ph_vec3 after = ph_vec3_sub(d->p[ph_sphere_next(d, i)], p);
  double least = MARGIN_TURN * fabs(turn_of(p, before, after)), q = shape->q[i];
  g[n++] =
      q * turn_of(p, ph_vec3_sub(s->r[i], p), ph_vec3_sub(s->l[i], s->r[i])) -
      least;
  if (!shape->legacy) {
    g[n++] =
        q * turn_of(p, ph_vec3_sub(s->l[k], s->r[k]), ph_vec3_sub(p, s->l[k])) -
        least;
  }
  return n;
}

size_t ph_sphere_measure_node(const struct ph_sphere_shape *shape,
                              const struct ph_sphere_spline *s, size_t i,
                              double *g) {
  const struct ph_sphere_data *d = s->data;
  double left, right, h = d->h[i],
                      bound = (1 - MARGIN_EPSILON) * shape->epsilon;
  struct ph_spherical before, after;
  size_t n = 0;
  if (!shape->inorder[i]) {
    return shape->q[i] == 0 ? 0 : measure_convexity(shape, s, i, g);
  }
  before = ph_sphere_segment(s, ph_sphere_before(d, i));
  after = ph_sphere_segment(s, i);
  if (shape->legacy) {
    right = ph_spherical_numerator_start(&after) / (h * h * h) * d->theta[0] *
            d->theta[0];
    left = right;
  } else {
    right = ph_spherical_curvature_start(&after);
    left = ph_spherical_curvature_end(&before);
  }
  g[n++] = bound - left;
  g[n++] = bound + left;
  g[n++] = bound - right;
  g[n++] = bound + right;
  return n;
}

size_t ph_sphere_measure_segment(const struct ph_sphere_shape *shape,
                                 const struct ph_sphere_spline *s, size_t k,
                                 double *g) {
  struct ph_spherical segment;
  double most = 0;
  if (shape->q[k] * shape->q[ph_sphere_next(s->data, k)] <= 0) {
    return 0;
  }
  segment = ph_sphere_segment(s, k);
  for (size_t j = 0; j < PH_SPHERE_SAMPLES; j++) {
    double numerator[2];
    ph_spherical_numerator(&segment, (double)j / (PH_SPHERE_SAMPLES - 1),
                           numerator);
    g[j] = shape->q[k] * numerator[0];
    most = fmax(most, g[j]);
  }
  for (size_t j = 0; j < PH_SPHERE_SAMPLES; j++) {
    g[j] -= MARGIN_SEGMENT * most;
  }
  return PH_SPHERE_SAMPLES;
}
