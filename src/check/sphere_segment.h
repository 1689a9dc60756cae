/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A segment of a spherical spline as its certificate sees it: from four control
 * points, by formulas other than those of curve/segment/spherical.c.
 */
#ifndef PH_CHECK_SPHERE_SEGMENT_H
#define PH_CHECK_SPHERE_SEGMENT_H

#include "kernel/s2.h"

/*
 * One end P of a segment, with the local parameter t running away from it: P,
 * B, C are the control points in that order.  An error is what control points
 * that are off by `rounding' each can make of a number, with a margin.
 */
struct ph_check_nu_end {
  ph_vec3 at;           /* P */
  ph_vec3 leg;          /* Log_P B: a third of the velocity */
  ph_vec3 acceleration; /* covariant */
  double angle;         /* |leg| */
  double leg_error;
  double acceleration_error;
  double curvature; /* geodesic, positive to the left when going away from P;
                     * not finite where the leg is 0 */
  double curvature_error;
};

struct ph_check_nu_segment {
  ph_vec3 p[4]; /* unit vectors */
  double angle; /* between its ends */
  double x[3];  /* squares of the angles of the three legs */
  struct ph_check_nu_end end[2];
  double rounding; /* of a control point */
};

/* ph_check_nu_segment_of: the segment of these unit vectors. */
void ph_check_nu_segment_of(const ph_vec3 p[4], double rounding,
                            struct ph_check_nu_segment *s);

/* ph_check_nu_numerator_end: K = S . (S' x S'') at t = 0 or, end = 1, t = 1, in
 * closed form.
 * out  error  what rounding can make of it */
double ph_check_nu_numerator_end(const struct ph_check_nu_segment *s,
                                 size_t end, double *error);

/*
 * ph_check_nu_turns: whether K has the sign q, 1 or -1, wherever it is looked
 * at: at 3 to 257 places, more where it comes near 0.
 */
int ph_check_nu_turns(const struct ph_check_nu_segment *s, int q);

/*
 * ph_check_nu_length: the length of a segment on the unit sphere, to 1e-11 and
 * rounding, or less where it agrees with `claimed' to `allowed'.  Sums of
 * distances of points on the curve are extrapolated, on halves of intervals
 * where need be.
 */
double ph_check_nu_length(const struct ph_check_nu_segment *s, double claimed,
                          double allowed);

/* ph_check_nu_allowed: how far a length that is claimed may be off: by 1e-11 of
 * it and the rounding of points. */
double ph_check_nu_allowed(const struct ph_check_nu_segment *s, double claimed);

#endif
