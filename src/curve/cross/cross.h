/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Whether a planar PH or ATPH spline, or one of Tschirnhausen cubics, crosses
 * itself.
 *
 * Two points of a curve meet if they are no further apart than PH_CROSS_NEAR of
 * the curve's size (half the diagonal of its bounding box) and the curve
 * between them, on a closed curve either way round, turns by a half turn or
 * more.  A curve is simple if no two of its points meet.  So
 *
 *   - touching counts as crossing, also at the ends: an open curve that ends
 *     where it began is not simple, a closed one may be;
 *   - two passes that keep apart by a few times PH_CROSS_NEAR do not meet,
 *     unless very many pairs of segments run side by side at less than 1e-8 of
 *     their lengths;
 *   - a loop counts however small it is, and so does a cusp or a point where
 *     the curve stands still, the limits of small loops.
 *
 * The answer is the same for every scale, rotation, translation and direction
 * of travel, but for passes whose distance is PH_CROSS_NEAR to rounding.
 */
#ifndef PH_CURVE_CROSS_CROSS_H
#define PH_CURVE_CROSS_CROSS_H

#include "base/diag.h"
#include "base/mem.h"
#include "curve/result.h"
#include "kernel/cplx.h"

#include <stdbool.h>
#include <stddef.h>

#define PH_CROSS_NEAR 1e-12

struct ph_cross {
  size_t loops; /* segments that meet themselves */
  bool simple;
  /* The first meeting found, where not simple: */
  size_t segment[2]; /* in order of travel */
  double u[2];       /* local parameters in [0,1] */
  ph_cplx point;
};

/*
 * ph_cross_planar: looks for a meeting of a curve with itself.
 *
 * O(n log n) time for n segments where each is near a bounded number of others,
 * and 20 bytes a segment of memory.
 *
 * in   scratch  memory given back before the return
 * ret  PH_OK | PH_E_NOT_FINITE | PH_E_NO_MEMORY
 */
enum ph_status ph_cross_planar(const struct ph_curve *curve,
                               struct ph_arena *scratch, struct ph_cross *cross,
                               struct ph_diag *diag);

#endif
