/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A cubic spherical Bezier segment on the unit sphere: de Casteljau's algorithm
 * with great-circle interpolation [IOR15, sec. 2.4], by power series.
 *
 *   G(p, q, t) = W(1 - t) p + W(t) q,  W(x) = x f0(x^2 X) / f0(X)         (1)
 *
 * with X the square of the angle between p and q and f0 of kernel/s2.h; for
 * moving p and q, D = |q - p|^2 gives X' = D' / f0(X).
 */
#ifndef PH_CHECK_SPHERICAL_H
#define PH_CHECK_SPHERICAL_H

#include "check/place.h"

/* ph_check_great: S, S' and S'' at t in [0,1].
 *
 * in   p[4]    unit vectors, no two neighbours antipodal
 * out  jet[3]
 */
void ph_check_great(const ph_vec3 p[4], double t, ph_vec3 jet[3]);

/* What a row of kind.c has of such segments (kind.h). */
void ph_check_great_load(const struct ph_check *v, struct ph_check_segment *s);
void ph_check_great_jet(const struct ph_check_segment *s, double u,
                        ph_vec3 *jet, size_t n);
ph_vec3 ph_check_great_point(const struct ph_check *v,
                             const struct ph_check_segment *s, double u);
double ph_check_great_reach(const struct ph_check *v,
                            const struct ph_check_segment *s);

#endif
