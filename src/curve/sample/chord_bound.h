/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * How far chords are from a curve: bounds that hold for every chord.
 *
 * M is a chord bound of a curve r over [u0,u1] if every chord between places
 * v and v + h of it leaves the curve between them by no more than M h^2 / 8,
 * and the curve the chord.  Such are
 *   max |r''|, as |r(u) - chord(u)| is at most max|r''| h^2 / 8,           (1)
 *   max |kappa| (max |r'|)^2, the same by arc length,                      (2)
 *   max |kappa| |r'|^2, increased by a part that is of the order of the
 *     interval, where the curve turns by less than a quarter,              (3)
 *   the same with max ||r'|'| times that turn, also from a cusp on.        (4)
 * They are found from the hull of the coefficients of the preimage, or of the
 * control points, over [u0,u1], hold up to rounding, which they are increased
 * by, and the least of the four is taken.  (1) is finite wherever the curve
 * has a second derivative; (3) is exact in the limit of short intervals.
 *
 * Derived in chord_bound.c; tested by t_chord_bound.c against dense samples.
 */
#ifndef PH_CURVE_SAMPLE_CHORD_BOUND_H
#define PH_CURVE_SAMPLE_CHORD_BOUND_H

#include "curve/segment/seg3.h"
#include "curve/segment/spherical.h"

/* ph_chord_bound_ph: M of a PH or ATPH segment, or a cubic, by u in [0,1], in
 * the unit of the segment; infinite where no bound was found. */
double ph_chord_bound_ph(const struct ph_seg3 *seg, double u0, double u1);

/* ph_chord_bound_offset: M of its offset at a signed distance along a normal;
 * infinite unless it is seen that the segment stands still nowhere in [u0,u1].
 */
double ph_chord_bound_offset(const struct ph_seg3 *seg, enum ph_normal normal,
                             double distance, double u0, double u1);

/* ph_chord_bound_bezier: M of a Bezier curve; in  p[degree + 1], degree <= 5.
 */
double ph_chord_bound_bezier(const ph_vec3 *p, size_t degree, double u0,
                             double u1);

/* ph_chord_bound_spherical: M of the parallel at a signed geodesic distance of
 * a spherical segment, on the unit sphere; distance 0: the segment itself.
 * Chords are straight, through the inside of the sphere.  (1) and (2) alone,
 * derived in chord_bound_spherical.c; infinite over wide blocks of wild
 * segments, and, of a parallel, where the segment stands still but for its
 * ends. */
double ph_chord_bound_spherical(const struct ph_spherical *segment,
                                double distance, double u0, double u1);

#endif
