/* SPDX-License-Identifier: GPL-3.0-or-later */
/* ATPH curves as polynomial Bezier curves. */
#ifndef PH_CURVE_BEZIER_CONVERT_H
#define PH_CURVE_BEZIER_CONVERT_H

#include "base/diag.h"
#include "base/mem.h"
#include "curve/result.h"

typedef enum ph_status ph_bezier_fn(const struct ph_curve *curve,
                                    double tolerance, struct ph_arena *arena,
                                    struct ph_curve *bezier, double *error,
                                    struct ph_diag *diag);

/*
 * ph_bezier_curve: a curve as Bezier segments within a tolerance.  A PH curve
 * is its own Bezier curve, and so is one of Tschirnhausen cubics; of an ATPH
 * curve these are quintic (see hermite.h), with the knots and the exact lengths
 * of the parts of the curve that they stand for.
 *
 * in   curve   of a kind that has Bezier curves (curve/kind/kind.h)
 * out  bezier  the curve itself; or of the kind PH_CURVE_BEZIER, without
 *              preimage and whatever else is said of each segment
 * out  error   greatest distance found, 0 for such a curve
 * ret  PH_OK | PH_E_NO_CONVERGENCE | PH_E_TOO_LARGE | PH_E_NO_MEMORY
 */
ph_bezier_fn ph_bezier_curve;

/* ph_knots_increase: whether the n + 1 knots of pieces of these segments do.
 * ret  PH_OK | PH_E_NO_CONVERGENCE (names the segment) */
enum ph_status ph_knots_increase(const double *knots, size_t n,
                                 const size_t *segment, struct ph_diag *diag);

/* The same of curves that are their own, and of ATPH curves. */
ph_bezier_fn ph_bezier_itself;
ph_bezier_fn ph_bezier_quintics;

#endif
