/* SPDX-License-Identifier: GPL-3.0-or-later */
/* From the nodes of an arc-length spline to the curve of a record. */
#ifndef PH_SOLVE_ARCLENGTH_CURVE_H
#define PH_SOLVE_ARCLENGTH_CURVE_H

#include "curve/result.h"
#include "solve/arclength/system.h"

/*
 * ph_arc_curve: the curve in the user's frame, unit and sense.
 *
 * The Euler-Rodrigues frame is upright in the first point
 * (solve/common/frame.h). Joints that are data are exactly the data.
 *
 * in   x      nodes of the system
 * out  curve  PH quintic segments; arrays in the arena
 * out  turn   closed: by how much the frame comes back turned; else 0
 * ret  PH_OK | PH_NO_MEMORY
 */
enum ph_status ph_arc_curve(const struct ph_arc_system *system, const double *x,
                            struct ph_arena *arena, struct ph_curve *curve,
                            double *turn, struct ph_diag *diag);

/* ph_arc_is_flat: whether the curve of nodes in space is in the plane z = 0. */
bool ph_arc_is_flat(const struct ph_arc_system *system, const double *x);

#endif
