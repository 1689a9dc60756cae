/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Vectors in space.  Operands are expected near unit scale: nothing here
 * guards against overflow.
 */
#ifndef PH_KERNEL_VEC3_H
#define PH_KERNEL_VEC3_H

#include <math.h>
#include <stddef.h>

typedef struct {
  double x, y, z;
} ph_vec3;

static inline ph_vec3 ph_vec3_of(double x, double y, double z) {
  ph_vec3 v = {x, y, z};
  return v;
}

/* ph_vec3_get: from an array of 3 or, in the plane z = 0, 2 coordinates. */
static inline ph_vec3 ph_vec3_get(const double *v, size_t dimension) {
  return ph_vec3_of(v[0], v[1], dimension == 2 ? 0 : v[2]);
}

/* ph_vec3_put: the first 2 or all 3 coordinates, into an array. */
static inline void ph_vec3_put(ph_vec3 a, size_t dimension, double *v) {
  v[0] = a.x;
  v[1] = a.y;
  if (dimension == 3) {
    v[2] = a.z;
  }
}

static inline ph_vec3 ph_vec3_add(ph_vec3 a, ph_vec3 b) {
  return ph_vec3_of(a.x + b.x, a.y + b.y, a.z + b.z);
}

static inline ph_vec3 ph_vec3_sub(ph_vec3 a, ph_vec3 b) {
  return ph_vec3_of(a.x - b.x, a.y - b.y, a.z - b.z);
}

static inline ph_vec3 ph_vec3_scale(double s, ph_vec3 a) {
  return ph_vec3_of(s * a.x, s * a.y, s * a.z);
}

/* ph_vec3_along: a + s b. */
static inline ph_vec3 ph_vec3_along(ph_vec3 a, double s, ph_vec3 b) {
  return ph_vec3_of(a.x + s * b.x, a.y + s * b.y, a.z + s * b.z);
}

static inline double ph_vec3_dot(ph_vec3 a, ph_vec3 b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

static inline ph_vec3 ph_vec3_cross(ph_vec3 a, ph_vec3 b) {
  return ph_vec3_of(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z,
                    a.x * b.y - a.y * b.x);
}

/* ph_vec3_triple: the determinant [a, b, c]. */
static inline double ph_vec3_triple(ph_vec3 a, ph_vec3 b, ph_vec3 c) {
  return ph_vec3_dot(ph_vec3_cross(a, b), c);
}

static inline double ph_vec3_abs(ph_vec3 a) {
  return sqrt(ph_vec3_dot(a, a));
}

/* ph_vec3_unit: a / |a|; a = 0 gives non-finite components. */
static inline ph_vec3 ph_vec3_unit(ph_vec3 a) {
  return ph_vec3_scale(1 / ph_vec3_abs(a), a);
}

/* ph_vec3_normal: the part of a that is normal to the unit vector u. */
static inline ph_vec3 ph_vec3_normal(ph_vec3 a, ph_vec3 u) {
  return ph_vec3_along(a, -ph_vec3_dot(a, u), u);
}

/* ph_vec3_any_normal: a unit vector normal to the unit vector u, always the
 * same one, the opposite for -u: horizontal and to the left of u, unless u is
 * nearly vertical. */
static inline ph_vec3 ph_vec3_any_normal(ph_vec3 u) {
  return ph_vec3_unit(u.x * u.x + u.y * u.y > 0.01 ? ph_vec3_of(-u.y, u.x, 0)
                                                   : ph_vec3_of(0, u.z, -u.y));
}

/* ph_vec3_carried: v, normal to the unit vector a, by the shortest rotation
 * from a to the unit vector t: v - (t . v) / (1 + a . t) (a + t). */
static inline ph_vec3 ph_vec3_carried(ph_vec3 v, ph_vec3 a, ph_vec3 t) {
  const double factor = -ph_vec3_dot(v, t) / (1 + ph_vec3_dot(a, t));
  return ph_vec3_along(v, factor, ph_vec3_add(a, t));
}

#endif
