/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Data on the sphere, made by hand or at random, and splines of them. */
#ifndef PH_TESTS_SPHERE_UNIT_H
#define PH_TESTS_SPHERE_UNIT_H

#include "unit.h"
#include "vectors_unit.h"

#include "curve/segment/spherical.h"
#include "solve/sphere/sphere.h"

enum { UNIT_SPHERE_MAX = 32 }; /* nodes */

struct unit_sphere {
  struct ph_arena arena;
  struct ph_sphere_data data;
  struct ph_sphere_spline spline;
  struct ph_sphere_work work;
};

/* unit_sphere_of: data of n points, their knots geodesic, no tension, some
 * velocities of size 1 at the ends, and a spline of a model; all of it may be
 * changed before it is solved. */
void unit_sphere_of(struct unit_sphere *u, size_t n, const ph_vec3 *p,
                    bool closed, enum ph_sphere_ends ends,
                    const struct ph_sphere_model *model);

void unit_sphere_free(struct unit_sphere *u);

/* unit_sphere_segment: segment k of a spline that is solved. */
struct ph_spherical unit_sphere_segment(const struct unit_sphere *u, size_t k);

/* unit_sphere_apart: the largest distance between control points of two splines
 * of as many nodes. */
double unit_sphere_apart(const struct unit_sphere *a,
                         const struct unit_sphere *b);

/* unit_sphere_path: n points, from each to the next an angle between low and
 * high in a random direction. */
void unit_sphere_path(struct unit_random *r, size_t n, double low, double high,
                      ph_vec3 *p);

/* One of the ends that data can have: closed, or open with given ends. */
struct unit_sphere_kind {
  bool closed;
  enum ph_sphere_ends ends;
};

enum { UNIT_SPHERE_KINDS = 4 };
extern const struct unit_sphere_kind unit_sphere_kinds[UNIT_SPHERE_KINDS];

/* unit_sphere_any: data of UNIT_SPHERE_ANY nodes with random tensions and
 * knots, not so wild that there would seldom be a spline. */
enum { UNIT_SPHERE_ANY = 7 };
void unit_sphere_any(struct unit_random *r, struct unit_sphere_kind kind,
                     const struct ph_sphere_model *model,
                     struct unit_sphere *u);

/* unit_sphere_reference: asserts that the splines of a model in
 * tests/vectors/sphere-iordanov.phv are found again.
 *
 * ret  how many there were */
size_t unit_sphere_reference(const struct ph_sphere_model *model);

#endif
