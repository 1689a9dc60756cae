/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * What the certificates of curves in space share: the vectors of a problem, and
 * a segment at unit scale, whose preimage is a claim: r' from the control
 * points must be A i A* at the nodes of a Gauss rule, which integrates |r'| at
 * the same time.
 */
#ifndef PH_CHECK_SEGMENT3_H
#define PH_CHECK_SEGMENT3_H

#include "check/error.h"
#include "curve/problem.h"
#include "kernel/quat.h"

/* Vectors of two or three coordinates each, of a field. */
struct ph_check3_data {
  const double *v;
  size_t n, dimension; /* n is 0 where the problem has none */
};

/* ph_check3_data_of: those of a problem. */
struct ph_check3_data ph_check3_data_of(const struct ph_problem *problem,
                                        enum ph_field_id id);

/* A curve and how it is measured. */
struct ph_check3 {
  const struct ph_curve *curve;
  struct ph_check_scale scale;
  struct ph_quad rule;
  struct ph_check_space space; /* of the last segment */
};

/*
 * ph_check3_begin: a finite curve, by the scale of these points.
 *
 * in   points[n][dimension]
 * ret  PH_OK | PH_TOO_LARGE | PH_INTERNAL (they have no extent) | PH_NO_MEMORY
 */
enum ph_status ph_check3_begin(struct ph_check3 *c,
                               const struct ph_curve *curve,
                               const double *points, size_t n, size_t dimension,
                               struct ph_diag *diag);

/* ph_check3_scaled: a vector at unit scale. */
static inline ph_vec3 ph_check3_scaled(const struct ph_check3 *c, ph_vec3 v) {
  return ph_vec3_of(ph_pow2_apply(c->scale.to_unit, v.x),
                    ph_pow2_apply(c->scale.to_unit, v.y),
                    ph_pow2_apply(c->scale.to_unit, v.z));
}

/* ph_check3_direction: the unit vector of a given one, of any length. */
ph_vec3 ph_check3_direction(ph_vec3 v);

/* A segment at unit scale, with respect to u in [0,1]. */
struct ph_check3_segment {
  ph_vec3 start, end;
  ph_vec3 leg[5]; /* differences of control points */
  ph_quat a[3];
  ph_vec3 first[2];   /* r' at both ends */
  ph_vec3 tangent[2]; /* their directions */
  double error[2];    /* of the directions, by rounding of control points */
  double speed;       /* largest |coefficient| of r' */
  double rounding;    /* of its coordinates */
  double allowance;   /* for that, in r' */
  double unit;        /* u to the local parameter of the curve */
  double tension;     /* 1 where the curve has none */
};

/* ph_check3_segment_of: segment k of the curve, whose space becomes c's. */
struct ph_check3_segment ph_check3_segment_of(struct ph_check3 *c, size_t k);

/*
 * ph_check3_hodograph: how far r' is from A i A*.
 *
 * out  miss  the largest |r' - A i A*| at the nodes
 * ret  the integral of |r'|
 */
double ph_check3_hodograph(const struct ph_check3 *c,
                           const struct ph_check3_segment *s, double *miss);

#endif
