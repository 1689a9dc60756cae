/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Splines on the sphere whose tensions are raised until they keep the shape of
 * their data. */
#ifndef PH_TESTS_RAISE_UNIT_H
#define PH_TESTS_RAISE_UNIT_H

#include "sphere_unit.h"

#include "solve/sphere/sphere.h"

struct unit_raise {
  struct unit_sphere u;
  struct ph_sphere_shape shape;
  struct ph_sphere_raise raise; /* MINIMAL until changed */
};

/* What to make of points. */
struct unit_raise_kind {
  bool closed;
  enum ph_sphere_ends ends;
  const struct ph_sphere_model *model;
  double epsilon;
  bool legacy;
};

/* unit_raise_of: the spline of n points at no tension, solved. */
void unit_raise_of(struct unit_raise *t, size_t n, const ph_vec3 *p,
                   const struct unit_raise_kind *kind);

void unit_raise_free(struct unit_raise *t);

/* unit_raise_go: ph_sphere_keep_shape. */
enum ph_status unit_raise_go(struct unit_raise *t);

/* unit_raise_holds: whether the spline as it is has the shape of its data,
 * nothing waived. */
bool unit_raise_holds(const struct unit_raise *t);

double unit_raise_sum(const struct unit_raise *t);

/* unit_raise_missing: what the equations miss at most, scaled. */
double unit_raise_missing(struct unit_sphere *u);

/* unit_raise_corners: n points on great circles, from corner to corner. */
void unit_raise_corners(struct unit_random *r, size_t n, ph_vec3 *p);

/* unit_raise_ring: n points around the equator, or most of it, off it by noise
 * up to the size. */
void unit_raise_ring(struct unit_random *r, size_t n, double size, bool closed,
                     ph_vec3 *p);

#endif
