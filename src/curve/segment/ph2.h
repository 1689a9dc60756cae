/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Planar PH quintic and ATPH segments: from the preimage w to everything else.
 *
 *   r'(u) = w(u)^2              the hodograph, u in [0,1]
 *   sigma(u) = |r'(u)| = |w(u)|^2             the parametric speed
 *
 * w(u) lies in the segment's space of preimages (kernel/atph.h), with
 * coefficients w0, w1, w2: for PH quintics, Bernstein coefficients of degree 2.
 * [GON18, ch. 2].  Coordinates are complex numbers x + i y.
 */
#ifndef PH_CURVE_SEGMENT_PH2_H
#define PH_CURVE_SEGMENT_PH2_H

#include "kernel/atph.h"
#include "kernel/cplx.h"

/* ph_ph2_length: the exact arc length, integral of |w|^2 over [0,1]. */
double ph_ph2_length(const struct ph_atph *space, const ph_cplx w[3]);

/*
 * ph_ph2_control_points: control points of the segment from `start` to `end`,
 * in the basis of its space: Bezier points of a PH quintic [GON18, (2.12)].
 *
 * The first three are summed up from the start and the last three from the
 * end: the end points are reproduced exactly, the construction is symmetric
 * under reversal, and what the integral of w^2 misses `end - start` by (the
 * solver's residual) shows up in the middle leg, where the certificate looks.
 *
 * in   w[3]         preimage, in the root of the unit of the points
 * out  p[6]
 */
void ph_ph2_control_points(const struct ph_atph *space, const ph_cplx w[3],
                           ph_cplx start, ph_cplx end, ph_cplx p[6]);

#endif
