/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * One segment of a Bezier curve, prepared for many places: Taylor coefficients
 * at both ends, of the points brought to unit scale by a power of two, so that
 * the ends are met exactly and |x| <= 1/2.
 */
#ifndef PH_CURVE_KIND_BEZIER_H
#define PH_CURVE_KIND_BEZIER_H

#include "curve/result.h"
#include "kernel/vec3.h"

enum { PH_BEZIER_DEGREE_MAX = 5, PH_BEZIER_ORDERS = 4 };

struct ph_bezier {
  size_t degree;
  int exponent; /* p is smaller by 2^exponent than the curve's */
  ph_vec3 p[PH_BEZIER_DEGREE_MAX + 1];
  ph_vec3 taylor[2][PH_BEZIER_DEGREE_MAX + 1];
  double polygon; /* length of the control polygon */
};

/* ph_bezier_of: segment k of a curve of degree <= PH_BEZIER_DEGREE_MAX. */
struct ph_bezier ph_bezier_of(const struct ph_curve *curve, size_t k);

/* ph_bezier_jet: r, r', r'' and r''' at u.  out  jet[PH_BEZIER_ORDERS] */
void ph_bezier_jet(const struct ph_bezier *b, double u, ph_vec3 *jet);

/* ph_bezier_tangent: the unit tangent at u, by higher derivatives where r' is
 * 0; NaN where the segment is a point. */
ph_vec3 ph_bezier_tangent(const struct ph_bezier *b, double u);

#endif
