/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What tests of spatial Hermite curves share: data by chance, members of the
 * family of a segment, curves that are built from their preimage. */
#ifndef PH_TESTS_SPATIAL_UNIT_H
#define PH_TESTS_SPATIAL_UNIT_H

#include "unit.h"

#include "base/mem.h"
#include "curve/problem.h"
#include "curve/result.h"
#include "curve/segment/seg3.h"
#include "solve/spatial/spatial.h"

/* A random unit vector. */
static inline ph_vec3 unit_random_direction(struct unit_random *r) {
  ph_vec3 v;
  double n2;
  do {
    double x = unit_random_in(r, -1, 1), y = unit_random_in(r, -1, 1);
    v = ph_vec3_of(x, y, unit_random_in(r, -1, 1));
    n2 = ph_vec3_dot(v, v);
  } while (n2 > 1 || n2 < 0.01);
  return ph_vec3_unit(v);
}

/* A random unit quaternion. */
static inline ph_quat unit_random_turn(struct unit_random *r) {
  ph_vec3 v = unit_random_direction(r);
  ph_cplx e = ph_cplx_polar(unit_random_in(r, -3.2, 3.2));
  return ph_quat_of(e.re, e.im * v.x, e.im * v.y, e.im * v.z);
}

/* exp(i x) of a random x. */
static inline ph_cplx unit_random_phase(struct unit_random *r) {
  return ph_cplx_polar(unit_random_in(r, -3.2, 3.2));
}

/* Random data: a chord of length 1, derivatives between 1/3 and 3. */
static inline struct ph_spatial_data
unit_random_spatial(struct unit_random *r) {
  struct ph_spatial_data data;

  data.dp = unit_random_direction(r);
  data.ti = unit_random_direction(r);
  data.tf = unit_random_direction(r);
  data.ni = exp(unit_random_in(r, -1.1, 1.1));
  data.nf = exp(unit_random_in(r, -1.1, 1.1));
  data.noise = 0;
  data.planarity = 0;
  data.normal = ph_vec3_of(0, 0, 0);
  return data;
}

/* A random space: that of PH quintics, or an angle of ATPH curves. */
static inline struct ph_atph unit_random_space(struct unit_random *r) {
  return ph_atph_of(unit_random_below(r, 2) ? exp(unit_random_in(r, -9, 0.7))
                                            : 0);
}

/* From the frame of the data to that of the world. */
static inline ph_quat unit_spatial_turn(const struct ph_spatial_family *f) {
  return ph_quat_of_frame(f->axis[0], f->axis[1], f->axis[2]);
}

static inline ph_vec3 unit_spatial_world(const struct ph_spatial_family *f,
                                         ph_vec3 v) {
  ph_vec3 sum = ph_vec3_scale(v.x, f->axis[0]);
  sum = ph_vec3_along(sum, v.y, f->axis[1]);
  return ph_vec3_along(sum, v.z, f->axis[2]);
}

/* The preimage of a member, in the frame of the world. */
static inline void unit_spatial_preimage(const struct ph_spatial_family *f,
                                         struct ph_spatial_member member,
                                         ph_quat a[3]) {
  ph_quat turn = unit_spatial_turn(f);
  ph_spatial_preimage(f, member, a);
  for (size_t i = 0; i < 3; i++) {
    a[i] = ph_quat_mul(turn, a[i]);
  }
}

/* The legs of the control polygon, none from the others [FAR15, (6)]. */
static inline void unit_spatial_legs(const struct ph_atph *space,
                                     const ph_quat a[3], ph_vec3 leg[5]) {
  const double *q = space->q;
  leg[0] = ph_vec3_scale(q[0], ph_quat_i(a[0], a[0]));
  leg[1] = ph_vec3_scale(q[1], ph_quat_i(a[0], a[1]));
  leg[2] = ph_vec3_along(ph_vec3_scale(q[2], ph_quat_i(a[1], a[1])), q[3],
                         ph_quat_i(a[0], a[2]));
  leg[3] = ph_vec3_scale(q[1], ph_quat_i(a[1], a[2]));
  leg[4] = ph_vec3_scale(q[0], ph_quat_i(a[2], a[2]));
}

/* The control points of a member that begins in 0. */
static inline void unit_spatial_points(const struct ph_spatial_family *f,
                                       struct ph_spatial_member member,
                                       ph_vec3 p[6]) {
  const ph_vec3 start = {0, 0, 0};
  ph_quat a[3];
  unit_spatial_preimage(f, member, a);
  ph_seg3_control_points(&f->space, a, start, unit_spatial_world(f, f->dp), p);
}

/* The largest distance of two of the points. */
static inline double unit_spatial_size(const ph_vec3 p[6]) {
  double size = 0;
  for (size_t i = 0; i < 6; i++) {
    for (size_t j = 0; j < i; j++) {
      size = unit_larger(size, ph_vec3_abs(ph_vec3_sub(p[i], p[j])));
    }
  }
  return size;
}

/* How far the points are from others, relative to the size of these. */
static inline double unit_spatial_error(const ph_vec3 found[6],
                                        const ph_vec3 wanted[6]) {
  double error = 0;
  for (size_t i = 0; i < 6; i++) {
    error = unit_larger(error, ph_vec3_abs(ph_vec3_sub(found[i], wanted[i])));
  }
  return error / unit_spatial_size(wanted);
}

/* ---- curves -------------------------------------------------------------- */

enum { UNIT_HERMITE3_MAX = 12 };

/* A problem of at most UNIT_HERMITE3_MAX points, and its curve. */
struct unit_hermite3 {
  struct ph_problem problem;
  struct ph_curve curve;
  double points[3 * UNIT_HERMITE3_MAX];
  double vectors[3 * UNIT_HERMITE3_MAX]; /* tangents or derivatives */
  double knots[UNIT_HERMITE3_MAX + 1];
  double control_points[18 * UNIT_HERMITE3_MAX];
  double preimage[12 * UNIT_HERMITE3_MAX];
  double alpha[UNIT_HERMITE3_MAX];
  double lengths[UNIT_HERMITE3_MAX];
  double tension[UNIT_HERMITE3_MAX];
  bool shape_ok[UNIT_HERMITE3_MAX];
};

/*
 * unit_hermite3_of: a problem through n points with n tangents (or derivatives,
 * PH_F_DERIVATIVES), of `dimension` each, and the curve of it in the place of
 * *s, with tensions of 1 and no claimed shape.
 *
 * in   alpha  the angle of every segment, 0: a PH curve
 */
void unit_hermite3_of(struct unit_hermite3 *s, const double *points,
                      enum ph_field_id which, const double *vectors, size_t n,
                      size_t dimension, bool closed, double alpha);

/*
 * unit_hermite3_build: the curve again, from what is now in *s.
 *
 * Derivatives are those of the problem times tension^2, or its tangents times
 * the chord times that.  The segments are those of the criterion CC, but for
 * phi.
 */
void unit_hermite3_build(struct unit_hermite3 *s, double phi);

#endif
