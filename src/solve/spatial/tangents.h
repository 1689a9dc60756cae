/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Unit tangents at points in space, from the points alone.
 *
 * At p[j] the tangent of the circle through p[j-1], p[j], p[j+1] is taken: with
 * d[j] = p[j+1] - p[j] and h[j] = |d[j]|, the direction of
 *
 *   (h[j] / h[j-1]) d[j-1] + (h[j-1] / h[j]) d[j]                         (1)
 *
 * Sums of d[j-1] and d[j] with positive factors have the shape of the polygon,
 * whatever the factors: [FAR15, (63)] holds identically.  An open polygon is
 * continued at its ends by the mirror image of the third point in the plane
 * that bisects the first chord, so that t[0] is the mirror image of t[1] and
 * the ends are those of plane arcs.  Two points have the tangents of the chord.
 *
 * (1) vanishes where the polygon turns back on itself with equal chords.  The
 * tangent is normal to them there, to the side from which the polygon comes and
 * to which it goes on; to the former if these are opposite, and on a straight
 * line to some side.
 */
#ifndef PH_SOLVE_SPATIAL_TANGENTS_H
#define PH_SOLVE_SPATIAL_TANGENTS_H

#include "kernel/vec3.h"

#include <stdbool.h>
#include <stddef.h>

/*
 * ph_spatial_tangents: unit tangents at n >= 2 points.
 *
 * The tangents turn with the points, change their signs when the points are
 * reversed, and do not depend on the scale; scaling by powers of two keeps
 * every digit.  Where a polygon turns back and no side is distinguished, the
 * choice depends on the axes.  Points of a plane have tangents in that plane,
 * exactly so where z = 0.  O(n).
 *
 * in   points[3 n]  finite; neighbours (if closed, also the last and the
 *                   first) differ by more than rounding of the largest one
 * out  tangents[n]
 */
void ph_spatial_tangents(const double *points, size_t n, bool closed,
                         ph_vec3 *tangents);

#endif
