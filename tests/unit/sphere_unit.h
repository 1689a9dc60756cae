/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What tests of spherical splines share: nodes by chance, solutions, tensions
 * that are raised. */
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

/* ---- tensions that are raised -------------------------------------------- */

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
