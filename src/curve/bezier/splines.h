/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Curves and offsets as B-splines, as plain arrays (nurbs.h makes them). */
#ifndef PH_CURVE_BEZIER_SPLINES_H
#define PH_CURVE_BEZIER_SPLINES_H

#include <stdbool.h>
#include <stddef.h>

/*
 * A connected part of a curve or offset as one B-spline, polynomial or
 * rational.  Its Bezier pieces meet at knots as often there as the degree says.
 *
 * knots[knots_n]               knots_n = n + degree + 1, not decreasing, at
 *                              both ends degree + 1 times: the global parameter
 *                              of the curve; of loops, their arc length
 * control_points[n][dimension]  as many coordinates as the curve has
 * weights[weights_n]           > 0; weights_n is n, or 0: all are 1
 */
struct ph_spline {
  bool closed; /* it ends where it begins */
  size_t degree;
  double *knots;
  size_t knots_n;
  double *control_points;
  size_t n;
  double *weights;
  size_t weights_n;
  double error; /* greatest distance from the exact curve that was found */
};

/* The chains of a curve, an offset or a loop. */
struct ph_splines {
  struct ph_spline *v;
  size_t n; /* 0: they were not asked for */
};

#endif
