/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Numbers that are >= 0 where criteria of shape hold (see sphere_measure.h). */
#include "solve/sphere_measure.h"

size_t ph_sphere_measure_node(const struct ph_sphere_shape *shape,
                              const struct ph_sphere_spline *s, size_t i,
                              double *g) {
  const struct ph_sphere_data *d = s->data;
  double q = shape->q[i], left, right, h = d->h[i];
  struct ph_spherical before, after;
  size_t n = 0;
  if (!shape->inorder[i] && shape->q[i] == 0) {
    return 0;
  }
  before = ph_sphere_segment(s, ph_sphere_before(d, i));
  after = ph_sphere_segment(s, i);
  if (!shape->inorder[i]) {
    g[n++] = q * ph_spherical_numerator_start(&after);
    if (!shape->legacy) {
      g[n++] = q * ph_spherical_numerator_end(&before);
    }
    return n;
  }
  if (shape->legacy) {
    right = ph_spherical_numerator_start(&after) / (h * h * h) * d->theta[0] *
            d->theta[0];
    left = right;
  } else {
    right = ph_spherical_curvature_start(&after);
    left = ph_spherical_curvature_end(&before);
  }
  g[n++] = shape->epsilon - left;
  g[n++] = shape->epsilon + left;
  g[n++] = shape->epsilon - right;
  g[n++] = shape->epsilon + right;
  return n;
}

size_t ph_sphere_measure_segment(const struct ph_sphere_shape *shape,
                                 const struct ph_sphere_spline *s, size_t k,
                                 double *g) {
  struct ph_spherical segment;
  if (shape->q[k] * shape->q[ph_sphere_next(s->data, k)] <= 0) {
    return 0;
  }
  segment = ph_sphere_segment(s, k);
  for (size_t j = 0; j < PH_SPHERE_SAMPLES; j++) {
    double numerator[2];
    ph_spherical_numerator(&segment, (double)j / (PH_SPHERE_SAMPLES - 1),
                           numerator);
    g[j] = shape->q[k] * numerator[0];
  }
  return PH_SPHERE_SAMPLES;
}
