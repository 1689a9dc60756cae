/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The checks that verify.c runs, each in a file of its own.  All note what they
 * find (note.h); a curve has the right shape before the others look at it.
 */
#ifndef PH_VERIFY_CHECK_H
#define PH_VERIFY_CHECK_H

#include "verify/place.h"

/* ph_verify_shape: whether arrays, numbers and knots are such that there is a
 * curve to look at. */
bool ph_verify_shape(struct ph_verify *v);

/* ph_verify_square: whether |r'| of a segment is a polynomial in its space, and
 * r' that of the claimed preimage; sets noise[k]. */
void ph_verify_square(struct ph_verify *v, struct ph_verify_segment *s);

/* ph_verify_joint: between two segments, the second being b. */
void ph_verify_joint(struct ph_verify *v, const struct ph_verify_segment *a,
                     const struct ph_verify_segment *b);

/* ph_verify_lengths: of all segments, intervals and the whole. */
void ph_verify_lengths(struct ph_verify *v);

/* ph_verify_tensions: what joins segments on a sphere. */
void ph_verify_tensions(struct ph_verify *v);

/* ph_verify_fairness: energies and turns that the diagnostics claim. */
void ph_verify_fairness(struct ph_verify *v);

/* ph_verify_conversion: by how much a Bezier curve may be longer or shorter
 * than the curve that it stands for; 0 of other curves. */
double ph_verify_conversion(const struct ph_verify *v);

/*
 * ph_verify_samples: samples of the curve.
 *
 * in   beside  NULL, or the offset that they are of
 * out  length  of what they are of
 * out  error   how uncertain that is
 */
void ph_verify_samples(struct ph_verify *v, const struct ph_samples *samples,
                       const struct ph_verify_path *beside, double *length,
                       double *error);

/* ph_verify_sphere: points of a curve on a sphere; with the problem, how it
 * ends. */
void ph_verify_sphere(struct ph_verify *v);

/* ph_verify_blaschke: images on the Blaschke cylinder. */
void ph_verify_blaschke(struct ph_verify *v);

/* ph_verify_solves: the problem, if there is one.
 * ret  PH_OK | PH_NO_MEMORY */
enum ph_status ph_verify_solves(struct ph_verify *v);

/* ph_verify_is_approximation: whether the curve approximates another one: as
 * the problem says, or, without one, as the result says it. */
bool ph_verify_is_approximation(const struct ph_verify *v);

/* ph_verify_distance: of cubics from the curve of the problem.
 * ret  PH_OK | PH_NO_MEMORY */
enum ph_status ph_verify_distance(struct ph_verify *v);

/*
 * ph_verify_gaps: where an offset jumps: the gaps that are listed, no others,
 * and of samples those at both ends of each.
 *
 * in   path  the offset; it goes from segment to segment by `segment`
 */
void ph_verify_gaps(struct ph_verify *v, const struct ph_offset *offset,
                    struct ph_verify_path *path,
                    struct ph_verify_segment *segment);

/* ph_verify_offset: an offset curve. */
void ph_verify_offset(struct ph_verify *v, const struct ph_offset *offset);

#endif
