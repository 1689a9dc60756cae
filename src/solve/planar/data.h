/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The data of a planar spline: points, knots, angles and end derivatives of a
 * problem, checked and brought to unit scale.
 *
 * Unit scale is a power of two for the points (coordinates below 1/2) and the
 * mean knot spacing for the parameter.  Both are undone exactly, or to one
 * rounding, where the solution is written.
 */
#ifndef PH_SOLVE_PLANAR_DATA_H
#define PH_SOLVE_PLANAR_DATA_H

#include "curve/problem.h"
#include "solve/planar/c2.h"

struct ph_planar_data {
  const double *points; /* [points_n][2], the user's */
  size_t n;             /* segments */
  bool closed;
  bool atph;             /* else all angles are 0 */
  bool own_knots;        /* atph: the knots are not the sums of the angles */
  const double *ends;    /* [2][2] end derivatives, the user's, or NULL */
  int exponent;          /* unit scale = data times 2^exponent; even */
  double *h;             /* [n] knot spacings, mean 1 */
  double h_mean;         /* in the user's parameter */
  double *knots;         /* [n + 1], the user's parameter */
  double *chord;         /* [n] |c| at unit scale */
  struct ph_atph *space; /* [n] atph, [1] ph */
  struct ph_planar_c2 c2;
};

/*
 * ph_planar_data_of: reads and checks a problem.
 *
 * ret  PH_OK | PH_TOO_FEW_POINTS | PH_COINCIDENT_POINTS | PH_BAD_SHAPE |
 *      PH_BAD_VALUE | PH_ZERO_TANGENT | PH_TOO_LARGE | PH_NO_MEMORY
 */
enum ph_status ph_planar_data_of(const struct ph_problem *problem,
                                 struct ph_arena *arena,
                                 struct ph_planar_data *data,
                                 struct ph_diag *diag);

/*
 * ph_planar_data_space: other angles (atph), or other knot spacings in the same
 * proportions (ph).
 *
 * The knots of atph data follow the angles unless the user gave them; those of
 * ph data keep their first and last, so that end derivatives, which are per
 * unit of the knots, keep their meaning.  Allocates nothing; the twist stays.
 *
 * in   spacing[n]  positive; atph: below pi
 * ret  as ph_planar_data_of; the data are then unusable until given others
 */
enum ph_status ph_planar_data_space(struct ph_planar_data *data,
                                    const double *spacing,
                                    struct ph_diag *diag);

/* ph_planar_data_chordal: spacings proportional to a power of the chords.
 * out  spacing[n]  the largest is `largest` */
void ph_planar_data_chordal(const struct ph_planar_data *data, double power,
                            double largest, double *spacing);

/* ph_planar_ends_change: how the default end derivative at an end of an open
 * curve changes with the spacings.
 *
 * in   side       0 or 1
 * out  change[2]  h d/dh for the segment at the end and for the next one
 */
void ph_planar_ends_change(const struct ph_planar_data *data, int side,
                           ph_cplx change[2]);

/* ph_planar_point: point k, 0 <= k <= n, of the user. */
static inline ph_cplx ph_planar_point(const struct ph_planar_data *d,
                                      size_t k) {
  size_t i = d->closed && k == d->n ? 0 : k;
  return ph_cplx_of(d->points[2 * i], d->points[2 * i + 1]);
}

#endif
