/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A cubic spherical Bezier segment on the unit sphere: de Casteljau's algorithm
 * with great-circle interpolation [IOR15, sec. 2.4], on the value and two
 * derivatives:
 *
 *   Z = w(1 - t, X) u + w(t, X) v,  w(s, X) = sin(s th) / sin th,  X = th^2
 *
 * with th the angle between u and v, by the partial derivatives of w; for
 * moving u and v, D = |v - u|^2 gives X' = D' / f0(X), f0 of kernel/s2.h.
 * Certificates and verification share it; curve/ and solve/ have their own.
 */
#ifndef PH_CHECK_SPHERICAL_H
#define PH_CHECK_SPHERICAL_H

#include "check/local.h"

/* ph_check_great_angles: the squares of the angles between neighbours. */
void ph_check_great_angles(const ph_vec3 p[4], double x[3]);

/* ph_check_great_beyond: the point at t on the great circle of the inner legs,
 * t < 0 or t > 1.
 * io  factor  grows by what errors of the points are multiplied by */
ph_vec3 ph_check_great_beyond(const ph_vec3 p[4], const double x[3], double t,
                              double *factor);

/* ph_check_great: S, S' and S'' at t in [0,1].
 *
 * in   p[4]    unit vectors, no two neighbours antipodal
 * in   x[3]    of ph_check_great_angles
 * out  jet[3]
 * ret  how much errors grow, where points are nearly antipodal
 */
double ph_check_great(const ph_vec3 p[4], const double x[3], double t,
                      ph_vec3 jet[3]);

/* What a row of kind.c has of such segments (kind.h). */
void ph_check_great_load(const struct ph_check *v, struct ph_check_segment *s);
void ph_check_great_jet(const struct ph_check_segment *s, double u,
                        ph_vec3 *jet, size_t n);
ph_vec3 ph_check_great_point(const struct ph_check *v,
                             const struct ph_check_segment *s, double u);

#endif
