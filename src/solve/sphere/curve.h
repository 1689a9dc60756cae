/* SPDX-License-Identifier: GPL-3.0-or-later */
/* From a solved spherical nu-spline to the curve of a result. */
#ifndef PH_SOLVE_SPHERE_CURVE_H
#define PH_SOLVE_SPHERE_CURVE_H

#include "curve/result.h"
#include "solve/sphere/criteria.h"

/*
 * ph_sphere_curve: control points on the user's sphere, lengths in his unit.
 *
 * ret  PH_OK | PH_NO_CONVERGENCE (a length; names the segment) | PH_NO_MEMORY
 */
enum ph_status ph_sphere_curve(const struct ph_sphere_spline *s,
                               const struct ph_sphere_shape *shape,
                               struct ph_arena *arena, struct ph_curve *curve,
                               struct ph_diag *diag);

#endif
