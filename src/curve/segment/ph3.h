/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Spatial PH quintic and ATPH segments: from the preimage A to everything else.
 *
 *   r'(u) = A(u) i A(u)*            the hodograph, u in [0,1]
 *   sigma(u) = |r'(u)| = |A(u)|^2   the parametric speed
 *
 * A(u) lies in the segment's space of preimages (kernel/atph.h), with
 * quaternion coefficients a0, a1, a2: for PH quintics, Bernstein coefficients
 * of degree 2.  [FAR15, sec. 3; GON18, ch. 3]
 */
#ifndef PH_CURVE_SEGMENT_PH3_H
#define PH_CURVE_SEGMENT_PH3_H

#include "kernel/atph.h"
#include "kernel/quat.h"

/* ph_ph3_speed: of a PH quintic, the Bernstein coefficients of |A|^2.
 * out speed[5] */
void ph_ph3_speed(const ph_quat a[3], double speed[5]);

/* ph_ph3_length: the exact arc length, integral of |A|^2 over [0,1]. */
double ph_ph3_length(const struct ph_atph *space, const ph_quat a[3]);

/*
 * ph_ph3_control_points: control points of the segment from `start` to `end`,
 * in the basis of its space [FAR15, (6)].
 *
 * As in the plane (ph2.h), the first three are summed up from the start and the
 * last three from the end: what the preimage misses `end - start` by shows up
 * in the middle leg, where the certificate looks.
 *
 * in   a[3]  preimage, in the root of the unit of the points
 * out  p[6]
 */
void ph_ph3_control_points(const struct ph_atph *space, const ph_quat a[3],
                           ph_vec3 start, ph_vec3 end, ph_vec3 p[6]);

#endif
