/* SPDX-License-Identifier: GPL-3.0-or-later */
/* One cubic Bezier curve for an arc of a plane curve. */
#ifndef PH_CURVE_BEZIER_FIT_H
#define PH_CURVE_BEZIER_FIT_H

#include "kernel/cplx.h"

/* An arc, by places in the order of its parameter; near unit scale. */
enum { PH_ARC_STEPS = 12 };

struct ph_arc {
  ph_cplx point[PH_ARC_STEPS + 1];
  ph_cplx tangent[PH_ARC_STEPS + 1]; /* unit, or NaN */
};

/*
 * ph_cubics_fit: the cubic with the end points and end tangents of an arc that
 * meets it at a third and two thirds, as the error is then least; the distance
 * is of the sixth order in the length of a regular arc.
 *
 * in   enough  any cubic with at most this distance will do
 * out  c[4]    control points; first and last always
 * ret  the greatest distance at the places of the arc, along its normals, and a
 *      tenth more for what is between them; infinite if the arc turns so much,
 *      or is so uneven, that arc and cubic do not both go forward along the
 *      chord
 */
double ph_cubics_fit(const struct ph_arc *arc, double enough, ph_cplx c[4]);

/* ph_cubics_distance: the same distance, of a given cubic with the end points
 * of the arc. */
double ph_cubics_distance(const struct ph_arc *arc, const ph_cplx c[4]);

/*
 * ph_cubics_respace: parameters that are equally spaced in the length of an
 * arc, as far as its places tell.
 *
 * in   u[PH_ARC_STEPS + 1]       the parameters of its places
 * out  spaced[PH_ARC_STEPS + 1]  the same first and last; increasing
 */
void ph_cubics_respace(const struct ph_arc *arc, const double *u,
                       double *spaced);

#endif
