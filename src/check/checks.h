/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The checks that verify.c runs, each in a file of its own.  All note what they
 * find (note.h); a curve has the right shape before the others look at it.
 */
#ifndef PH_CHECK_CHECKS_H
#define PH_CHECK_CHECKS_H

#include "check/kind.h"
#include "kernel/quat.h"

/* ph_check_is_promised: whether there is a curve of a kind, dimension and
 * degree that the command makes; what is not is reported. */
bool ph_check_is_promised(struct ph_check *v);

/* ph_check_arrays: whether arrays, numbers and knots are such that there is a
 * curve to look at. */
bool ph_check_arrays(struct ph_check *v);

/*
 * ph_check_begin: what is known before segments are looked at: knots, rules,
 * and what the problem gives.
 *
 * out  data, space  what v->data and v->space are
 * ret  PH_OK | PH_E_NO_MEMORY
 */
enum ph_status ph_check_begin(struct ph_check *v, struct ph_check_data *data,
                              struct ph_check_space *space);

/* ph_check_segments: what is seen from segment to segment: the next three, and
 * what is given at the data (data.h). */
void ph_check_segments(struct ph_check *v);

/* ph_check_square: whether |r'| of a segment is a polynomial in its space, and
 * r' that of the claimed preimage; sets noise[k] and length[k], or checks the
 * length, where these are not kept. */
void ph_check_square(struct ph_check *v, struct ph_check_segment *s);

/* ph_check_preimage: the claimed preimage of segment k as quaternions, at unit
 * scale, of r' by u.
 * out  a[3] */
void ph_check_preimage(const struct ph_check *v, size_t k, ph_quat *a);

/* ph_check_joint: between two segments, the second being b. */
void ph_check_joint(struct ph_check *v, const struct ph_check_segment *a,
                    const struct ph_check_segment *b);

/*
 * ph_check_length: of segment k, which the whole has, too.
 *
 * in   found  by quadrature; noise  how uncertain r' is
 */
void ph_check_length(struct ph_check *v, size_t k, double found, double noise);

/* ph_check_lengths: of intervals and the whole; and of all segments whose
 * lengths are kept. */
void ph_check_lengths(struct ph_check *v);

/* ph_check_tensions: what joins segments on a sphere. */
void ph_check_tensions(struct ph_check *v);

/* ph_check_fairness: energies and turns that the diagnostics claim. */
void ph_check_fairness(struct ph_check *v);

/* ph_check_conversion: by how much a Bezier curve may be longer or shorter
 * than the curve that it stands for; 0 of other curves. */
double ph_check_conversion(const struct ph_check *v);

/*
 * ph_check_samples: samples of the curve.
 *
 * in   beside  NULL, or the offset that they are of
 * out  length  of what they are of
 * out  error   how uncertain that is
 */
void ph_check_samples(struct ph_check *v, const struct ph_samples *samples,
                      const struct ph_check_path *beside, double *length,
                      double *error);

/* ph_check_on_sphere: points of a curve on a sphere; with the problem, how it
 * ends. */
void ph_check_on_sphere(struct ph_check *v);

/* ph_check_blaschke: images on the Blaschke cylinder. */
void ph_check_blaschke(struct ph_check *v);

/*
 * ph_check_given_begin: what the problem gives, if there is one and its data
 * are those of a curve like this; v->data is NULL if not.
 *
 * ret  PH_OK | PH_E_NO_MEMORY
 */
enum ph_status ph_check_given_begin(struct ph_check *v,
                                    struct ph_check_data *data);

/* ph_check_given: what is given at both ends of a segment, each in its turn. */
void ph_check_given(struct ph_check *v, const struct ph_check_segment *s);

/* ph_check_given_lengths: lengths of intervals. */
void ph_check_given_lengths(struct ph_check *v);

/* ph_check_is_approximation: whether the curve approximates another one: as
 * the problem says, or, without one, as the result says it. */
bool ph_check_is_approximation(const struct ph_check *v);

/* ph_check_approximation: of cubics from the curve of the problem.
 * ret  PH_OK | PH_E_NO_MEMORY */
enum ph_status ph_check_approximation(struct ph_check *v);

/*
 * ph_check_gaps: where an offset jumps: the gaps that are listed, no others,
 * and of samples those at both ends of each.
 *
 * in   path  the offset; it goes from segment to segment by `segment`
 */
void ph_check_gaps(struct ph_check *v, const struct ph_offset *offset,
                   struct ph_check_path *path,
                   struct ph_check_segment *segment);

/*
 * ph_check_rational: sum b_j w_j p_j over sum b_j w_j; w NULL: all are 1.
 *
 * Weights may be far from 1, in products with the points out of range: they are
 * taken over the largest.  A short piece may be far from the origin: its points
 * are taken from the first of them, so that it is not lost in the rounding of
 * the sum.
 */
ph_vec3 ph_check_rational(const double *b, size_t n, size_t dimension,
                          const double *p, const double *w);

/* Both who claims the greatest distance of pieces and who checks it look for it
 * between places (kernel/golden.h): so many times as far they may be. */
#define PH_CHECK_CLOSELY 1.001

/*
 * ph_check_closely: a piece at equal places, and where its distance is greatest
 * between them, if it is an approximation.
 *
 * in   check  reports what is wrong at x in [0,1]; ret  the distance there
 * in   error  the greatest that is claimed, at unit scale
 */
void ph_check_closely(double (*check)(const void *piece, double x),
                      const void *piece, double error);

/* ph_check_nurbs: B-splines of the curve, or of the offset that they are of. */
void ph_check_nurbs(struct ph_check *v, const struct ph_splines *of,
                    const struct ph_check_path *beside);

/* ph_check_nurbs_loop: those of a loop, which is what they are compared with.
 */
void ph_check_nurbs_loop(struct ph_check *v, const struct ph_loop *loop,
                         size_t degree);

/* ph_check_range: the distances up to which offsets are regular. */
void ph_check_range(struct ph_check *v);

/* ph_check_offset: an offset curve. */
void ph_check_offset(struct ph_check *v, const struct ph_offset *offset);

#endif
