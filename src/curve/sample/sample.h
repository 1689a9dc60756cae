/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Samples of a curve of any kind, or of an offset of it: point, tangent, arc
 * length, curvature, torsion.  What a sample is (a place on a segment), how
 * long the curve is up to there, and where samples are taken are kept apart:
 * a sampler answers the first two for every kind of curve (curve/kind/kind.h),
 * and ph_sample_curve and ph_sample_offset choose places by what it says.
 *
 * What is not defined is NaN:
 *   the curvature and torsion where the curve stands still, as at the rest ends
 *     of a spherical curve and at cusps of offsets (the tangent there is the
 *     limit, of what follows or, at the end of a segment, of what comes
 *     before);
 *   the torsion where the curvature vanishes, to rounding: everywhere on a
 *     straight line;
 *   the tangent of a segment that is a point;
 *   normal and binormal of Frenet frames where there is no torsion.
 */
#ifndef PH_CURVE_SAMPLE_SAMPLE_H
#define PH_CURVE_SAMPLE_SAMPLE_H

#include "base/diag.h"
#include "base/mem.h"
#include "curve/result.h"
#include "kernel/vec3.h"

#include <stdbool.h>

/* ---- one place ----------------------------------------------------------- */

struct ph_sampler_ops;

/*
 * A curve, or an offset of it, prepared for samples of one segment after the
 * other.  Only begin and enter change it.
 */
struct ph_sampler {
  const struct ph_curve *curve;
  const struct ph_offset *offset; /* NULL: the curve itself */
  const struct ph_loop *loop;     /* of the offset, or NULL */
  struct ph_arena *arena;
  const struct ph_sampler_ops *ops; /* of the kind (curve/kind/kind.h) */
  bool framed;                      /* frames are asked for, too */
  void *state;                      /* of the kind, about the segment */
  size_t n;                         /* segments, or pieces of the loop */
  size_t k;                         /* the one that is entered */
  double length; /* of it, in the unit of the data; NaN if it was not found */
};

/* A place, in the unit of the data; z = 0 in the plane. */
struct ph_sample {
  ph_vec3 point;
  ph_vec3 tangent;  /* unit, in the direction of travel */
  double curvature; /* signed in the plane, geodesic on the sphere */
  double torsion;   /* in space */
  double lonlat[2]; /* on the sphere: degrees */
};

/*
 * ph_sampler_begin: prepares for a curve, or for the offset of it.
 *
 * in   offset  distance, vector and cusps of it count; NULL: the curve itself
 * in   arena   holds the sampler's memory, little of it however many segments
 *              there are
 * ret  PH_OK | PH_E_NO_MEMORY
 */
enum ph_status ph_sampler_begin(struct ph_sampler *sampler,
                                const struct ph_curve *curve,
                                const struct ph_offset *offset,
                                struct ph_arena *arena, struct ph_diag *diag);

/* ph_sampler_begin_loop: prepares for a loop of an offset, whose pieces are the
 * segments.  ret as ph_sampler_begin */
enum ph_status ph_sampler_begin_loop(struct ph_sampler *sampler,
                                     const struct ph_curve *curve,
                                     const struct ph_offset *offset,
                                     const struct ph_loop *loop,
                                     struct ph_arena *arena,
                                     struct ph_diag *diag);

/* ph_sampler_enter: goes to segment k. */
enum ph_status ph_sampler_enter(struct ph_sampler *sampler, size_t k,
                                struct ph_diag *diag);

/* ph_sample_principal: the unit vector along a normal, NaN where the sample has
 * no torsion. */
ph_vec3 ph_sample_principal(const struct ph_sample *sample, ph_vec3 normal);

/* ph_sampler_at: the place at u in [0,1] of the segment.  Of curves, points at
 * u = 0 and u = 1 are control points, to the last bit. */
struct ph_sample ph_sampler_at(const struct ph_sampler *sampler, double u);

/*
 * ph_sampler_length: the arc length from the start of the segment to u in
 * [0,1], increasing, from 0 to sampler->length, to 1e-13 of that; on
 * a sphere to 1e-9 beside near-cusps of an offset, where its speed is rounding.
 *
 * Of PH and ATPH curves, of cubics, and of offsets of these in the plane it is
 * in closed form; else the integral of an interpolant of the speed.  Of Bezier
 * curves it is the length of the curve they stand for, as curve->lengths, as
 * their own length is distributed within the segment.
 *
 * out  speed  its derivative
 */
double ph_sampler_length(const struct ph_sampler *sampler, double u,
                         double *speed);

/*
 * ph_sampler_chord_bound: M, such that every chord between places v and v + h
 * of [u0,u1] leaves the curve between them by no more than M h^2 / 8, and the
 * curve the chord.  A bound that holds, not an estimate
 * (curve/sample/chord_bound.h).
 */
double ph_sampler_chord_bound(const struct ph_sampler *sampler, double u0,
                              double u1);

/* ---- choice of places ---------------------------------------------------- */

enum ph_sampling {
  PH_SAMPLE_NONE,
  PH_SAMPLE_PARAMETER, /* n + 1 a segment, equally spaced in its parameter */
  PH_SAMPLE_SPACING,   /* equally spaced by arc length along the curve */
  PH_SAMPLE_CHORD,     /* so that chords are near the curve */
  PH_SAMPLE_LENGTHS,   /* at given arc lengths */
  PH_SAMPLE_PLACES     /* at given places of the curve */
};

/* Where samples are taken, and with which frame. */
struct ph_sample_rules {
  enum ph_sampling how;
  size_t n;              /* PH_SAMPLE_PARAMETER: > 0; of the arrays below */
  double spacing;        /* PH_SAMPLE_SPACING: > 0, in the unit of the data */
  double chord_error;    /* PH_SAMPLE_CHORD: > 0, in the unit of the data */
  const double *lengths; /* PH_SAMPLE_LENGTHS: [n] increasing, within
                            those of the curve but for rounding */
  const struct ph_place *places; /* PH_SAMPLE_PLACES: [n] in order */
  enum ph_frame frame; /* of curves in space and, but for erf, on a sphere */
  size_t most;         /* of one curve; 0: PH_SAMPLES_MAX */
};

/* More samples of one curve than this are refused, if nothing else is said. */
#define PH_SAMPLES_MAX 10000000

/*
 * ph_sample_curve: samples of a whole curve.
 *
 * PH_SAMPLE_PARAMETER: a segment's places are equally spaced in its local
 *   parameter ([0,1]; atph: [0, alpha]) and at both of its ends: a joint is
 *   there twice, with the curvatures on either side.
 * PH_SAMPLE_SPACING: at arc lengths 0, spacing, 2 spacing, ... from the start
 *   of the curve, and at its end; places that are nearer to an end than 1e-9
 *   spacing are left out.
 * PH_SAMPLE_CHORD: at both ends of every segment and so many between that no
 *   chord leaves the curve by more than chord_error; a joint is there once, as
 *   the end of the first segment.
 * PH_SAMPLE_LENGTHS, PH_SAMPLE_PLACES: there, and nowhere else.
 *
 * Frames: normal and binormal make a right-handed frame with the tangent.
 *   frenet  the principal normal
 *   erf     e2 and e3 of the Euler-Rodrigues frame (curve/segment/seg3.h)
 *   rmf     the rotation-minimising frame that begins as e2 and e3 (of Bezier
 *           curves, with a horizontal normal) and goes on through joints as the
 *           tangent does; on a sphere, the normal is to the left and the
 *           binormal points outward
 *
 * out  samples  arrays from the arena
 * ret  PH_OK | PH_E_LIMIT (there would be more than rules->most) |
 *      PH_E_TOO_LARGE (a point or the length is beyond all numbers) |
 *      PH_E_INFEASIBLE (there is no such frame) | PH_E_NO_CONVERGENCE (a
 *      length, a bound of chords or a rotation-minimising frame was not found)
 *      | PH_E_NO_MEMORY
 */
enum ph_status ph_sample_curve(const struct ph_curve *curve,
                               const struct ph_sample_rules *rules,
                               struct ph_arena *arena,
                               struct ph_samples *samples,
                               struct ph_diag *diag);

/*
 * ph_sample_offset: the same of an offset, whose s, spacing and chords are its
 * own; without frames.  Its segments are those of the curve, t is of the
 * curve; PH_SAMPLE_CHORD has its cusps among the places.  From gap to gap it is
 * a curve of its own, with samples at both ends; s goes on through gaps, and
 * so do the multiples of the spacing.
 *
 * inout offset  distance, vector, cusps, gaps; samples and length are filled
 */
enum ph_status ph_sample_offset(const struct ph_curve *curve,
                                const struct ph_sample_rules *rules,
                                struct ph_arena *arena,
                                struct ph_offset *offset, struct ph_diag *diag);

/* ph_sample_loop: the same of a loop of an offset, of which samples are filled;
 * s is from its start.  t is of the segments, of joins at the corner. */
enum ph_status ph_sample_loop(const struct ph_curve *curve,
                              const struct ph_sample_rules *rules,
                              const struct ph_offset *offset,
                              struct ph_loop *loop, struct ph_arena *arena,
                              struct ph_diag *diag);

#endif
