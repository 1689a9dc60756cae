/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Whether a spatial segment keeps the shape of its data, from its control
 * points: the constraints of [FAR15, (21)], the torsion in its exact form.
 *
 * Rounding is counted as it goes, term by term, so that what no digit of the
 * control points can tell is not held against a curve.
 */
#ifndef PH_CHECK_SHAPE_SPATIAL_H
#define PH_CHECK_SHAPE_SPATIAL_H

#include "kernel/vec3.h"

enum ph_check_shape {
  PH_CHECK_SHAPE_KEPT,
  PH_CHECK_SHAPE_START,  /* it bends away from the chord at its start */
  PH_CHECK_SHAPE_END,    /* or at its end */
  PH_CHECK_SHAPE_TORSION /* somewhere it winds the other way than its data */
};

/*
 * ph_check_shape_of: what is wrong with a segment.
 *
 * in   leg[5]    differences of its control points
 * in   mu[5]     integrals of S0^(4-j) S1^j (kernel/atph.h)
 * in   relative  error of r' relative to its largest coefficient
 * in   rounding  error of a coordinate of a control point
 * in   planarity  half of the determinant of the unit tangents and the
 * direction of the chord, up to which the torsion has no sign to keep
 */
enum ph_check_shape ph_check_shape_of(const ph_vec3 leg[5], const double mu[5],
                                      double relative, double rounding,
                                      double planarity);

#endif
