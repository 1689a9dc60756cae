/* SPDX-License-Identifier: GPL-3.0-or-later */
/* ATPH curves as polynomial Bezier curves. */
#ifndef PH_CURVE_BEZIER_CONVERT_H
#define PH_CURVE_BEZIER_CONVERT_H

#include "base/diag.h"
#include "base/mem.h"
#include "curve/result.h"

/*
 * ph_bezier_curve: quintic Bezier segments within a tolerance of an ATPH curve,
 * in the plane or in space (see hermite.h), with the knots and the exact
 * lengths of the parts of the curve that they stand for.  A PH curve is its own
 * Bezier curve, and so is one of Tschirnhausen cubics.
 *
 * out  bezier  kind PH_CURVE_BEZIER, without preimage and whatever else is said
 *              of each segment; or the curve itself
 * out  error   greatest distance found, 0 for such a curve
 * ret  PH_OK | PH_NO_CONVERGENCE | PH_NO_MEMORY
 */
enum ph_status ph_bezier_curve(const struct ph_curve *curve, double tolerance,
                               struct ph_arena *arena, struct ph_curve *bezier,
                               double *error, struct ph_diag *diag);

#endif
