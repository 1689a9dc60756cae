/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Spatial Hermite problems for tests, and curves that solve them, built segment
 * by segment from the family of interpolants.
 */
#ifndef PH_TESTS_HERMITE3_UNIT_H
#define PH_TESTS_HERMITE3_UNIT_H

#include "base/mem.h"
#include "curve/problem.h"
#include "curve/result.h"

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
