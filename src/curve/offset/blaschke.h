/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The image of a plane curve on the Blaschke cylinder [BYR11, ch. 5]: every
 * tangent line of the curve as a point
 *
 *   c(t) = (n_x, n_y, -<n, r>),  n = i r' / |r'| the left normal.
 *
 * Of a Tschirnhausen cubic it is rational of degree 5, with the weights of its
 * offsets; its first two coordinates are of degree 2.
 */
#ifndef PH_CURVE_OFFSET_BLASCHKE_H
#define PH_CURVE_OFFSET_BLASCHKE_H

#include "base/diag.h"
#include "base/mem.h"
#include "curve/result.h"

/*
 * ph_blaschke_curve: the images of all segments of a curve of Tschirnhausen
 * cubics.  A segment whose weights are not all positive (it turns by more than
 * about a half turn) is cut at its vertex: then they are.
 *
 * inout curve  takes blaschke and blaschke_n, from the arena
 *
 * ret  PH_OK | PH_E_INFEASIBLE (the curve stands still somewhere: no normal
 *      there; names the segment) | PH_E_TOO_LARGE | PH_E_NO_MEMORY
 */
enum ph_status ph_blaschke_curve(struct ph_curve *curve, struct ph_arena *arena,
                                 struct ph_diag *diag);

#endif
