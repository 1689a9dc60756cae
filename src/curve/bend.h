/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * How far chords are from a curve: bounds that hold for every chord.
 *
 * M bounds the bending of a curve r over [u0,u1] if every chord between places
 * v and v + h of it leaves the curve between them by no more than M h^2 / 8,
 * and the curve the chord.  Such are
 *   max |r''|, as |r(u) - chord(u)| is at most max|r''| h^2 / 8,           (1)
 *   max |kappa| (max |r'|)^2, the same by arc length.                      (2)
 * Both are found in interval arithmetic from the range of the preimage, or of
 * the control points, over [u0,u1] (the convex hull of the coefficients of that
 * part): they hold up to rounding, are the smaller of the two, and are exact in
 * the limit of short intervals, but for (1) where the speed changes.
 *
 * Derived here; tested by t_bend.c against dense samples.
 */
#ifndef PH_CURVE_BEND_H
#define PH_CURVE_BEND_H

#include "curve/seg3.h"
#include "curve/spherical.h"

/* ph_bend_ph: M of a PH or ATPH segment, or a cubic, by u in [0,1], in the unit
 * of the segment; infinite where no bound was found. */
double ph_bend_ph(const struct ph_seg3 *seg, double u0, double u1);

/* ph_bend_offset: M of its offset at a signed distance along a normal. */
double ph_bend_offset(const struct ph_seg3 *seg, enum ph_normal normal,
                      double distance, double u0, double u1);

/* ph_bend_bezier: M of a Bezier curve; in  p[degree + 1], degree <= 5. */
double ph_bend_bezier(const ph_vec3 *p, size_t degree, double u0, double u1);

/* ph_bend_spherical: M of the parallel at a signed geodesic distance of a
 * spherical segment, on the unit sphere; distance 0: the segment itself.
 * Chords are straight, through the inside of the sphere. */
double ph_bend_spherical(const struct ph_spherical *segment, double distance,
                         double u0, double u1);

#endif
