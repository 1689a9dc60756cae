/* SPDX-License-Identifier: GPL-3.0-or-later */
/* From members of families to the curve of a result, segment by segment. */
#ifndef PH_SOLVE_SPATIAL_CURVE_H
#define PH_SOLVE_SPATIAL_CURVE_H

#include "curve/result.h"
#include "solve/spatial/data.h"
#include "solve/spatial/shape.h"

/* What was chosen for a segment. */
struct ph_spatial_chosen {
  const struct ph_spatial_fit *fit;
  double root; /* unit scale = the user's times its square */
  double tension;
  double angles[2]; /* as the record has them, NaN: there are none */
};

/* ph_spatial_curve_alloc: the arrays of a curve, except the segments'. */
enum ph_status ph_spatial_curve_alloc(const struct ph_spatial_points *points,
                                      struct ph_arena *arena,
                                      struct ph_curve *curve,
                                      struct ph_diag *diag);

/*
 * ph_spatial_curve_put: segment k, after segments 0..k-1.
 *
 * The Euler-Rodrigues frame goes on where the segment before left it: the
 * preimage is turned by the free factor exp(x i) at the right.  In the first
 * point it is upright (solve/common/frame.h).
 *
 * inout end  A at the end of the segment before, and of this one, of any size
 * ret   by how much the segment misses its last point, relative to its size
 */
double ph_spatial_curve_put(const struct ph_spatial_points *points, size_t k,
                            const struct ph_spatial_chosen *chosen,
                            ph_quat *end, struct ph_curve *curve);

#endif
