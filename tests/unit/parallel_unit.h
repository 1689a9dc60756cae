/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Definitions of what parallels on the sphere are, for tests. */
#ifndef PH_TESTS_PARALLEL_UNIT_H
#define PH_TESTS_PARALLEL_UNIT_H

#include "unit.h"

#include "curve/segment/spherical.h"

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
