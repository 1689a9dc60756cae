/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * ATPH curves, and offsets of PH and ATPH curves, in the plane and in space, as
 * polynomial quintic Bezier pieces within a tolerance.
 *
 * A piece takes position, first and second derivative over from the exact
 * curve at both ends, so that the pieces join with C2 continuity where the
 * curve has it; a segment is halved until its pieces are near enough.  The
 * distance falls by about 2^6 with each halving.
 */
#ifndef PH_CURVE_BEZIER_HERMITE_H
#define PH_CURVE_BEZIER_HERMITE_H

#include "base/diag.h"
#include "base/mem.h"
#include "curve/result.h"
#include "curve/segment/seg3.h"

/*
 * ph_hermite_pieces: a curve (distance 0) or its offset as Bezier pieces.
 *
 * in   distance   signed, along the normal
 * in   normal     of the Euler-Rodrigues frame; of a planar curve E2, which is
 *                 to the left of travel
 * in   tolerance  greatest distance from the exact curve, in its unit
 * out  pieces     error is the greatest distance found between points of equal
 *                 parameter: at seven of each piece and of offsets where the
 *                 curve is slowest, and by search where that is near to the
 *                 greatest
 * ret  PH_OK | PH_E_NO_CONVERGENCE, PH_E_TOO_LARGE (name the segment) |
 *      PH_E_NO_MEMORY
 */
enum ph_status ph_hermite_pieces(const struct ph_curve *curve, double distance,
                                 enum ph_normal normal, double tolerance,
                                 struct ph_arena *arena,
                                 struct ph_pieces *pieces,
                                 struct ph_diag *diag);

/* ph_hermite_at: the point of a Bezier curve of degree n <= 5, by de
 * Casteljau's algorithm. */
static inline ph_vec3 ph_hermite_at(const ph_vec3 *p, size_t n, double x) {
  ph_vec3 q[6];
  for (size_t i = 0; i <= n; i++) {
    q[i] = p[i];
  }
  for (; n > 0; n--) {
    for (size_t i = 0; i < n; i++) {
      q[i] = ph_vec3_along(q[i], x, ph_vec3_sub(q[i + 1], q[i]));
    }
  }
  return q[0];
}

#endif
