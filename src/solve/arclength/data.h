/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Data of the arc-length problem, from the fields of a problem to unit scale
 * and to a pose that does not depend on where the data lie.
 *
 * N intervals; in each the curve is given at both ends by a point, a derivative
 * or a direction.  Ours is the unit in which the mean length (of chords, where
 * lengths are free) is 1, and the frame in which the first vector is along x,
 * the next that is not is in the plane of x and y, the data turn in the sense
 * of a right-handed screw, and the sequence read backwards is not the smaller
 * one; closed data begin with their longest interval.  Data that were moved,
 * turned, mirrored or reversed give the same, and closed ones wherever they
 * begin.
 */
#ifndef PH_SOLVE_ARCLENGTH_DATA_H
#define PH_SOLVE_ARCLENGTH_DATA_H

#include "base/diag.h"
#include "base/mem.h"
#include "curve/problem.h"
#include "kernel/quat.h"

enum ph_arc_mode { PH_ARC_POINTS, PH_ARC_DERIVATIVES, PH_ARC_TANGENTS };

struct ph_arc_data {
  enum ph_arc_mode mode;
  bool closed;
  size_t n; /* intervals */

  double *h;      /* [n] spacings of the knots, mean 1 */
  double *length; /* [n]; NULL: they are free */
  double sigma;   /* their relative standard deviation; 0: they are exact */
  double *chord;  /* [n] of points: |step|; else NULL */
  ph_vec3 *step;  /* [n] of points: to the next one; else NULL */
  ph_vec3 *given; /* [n + 1] derivatives, or unit tangents; else NULL */

  bool plane;      /* all vectors are in the plane z = 0 */
  bool line;       /* all are along x */
  bool straight;   /* all are along x, in its sense; of points, lengths are
                    * chords */
  double rounding; /* of the vectors: below this they are zero */

  ph_quat turn;  /* takes the axes of our frame to those of the user's */
  bool mirrored; /* z is reversed, before that */
  size_t first;  /* the user's interval that the sequence begins with: of closed
                  * data; else 0 */
  bool reversed; /* it is reversed, after that */
  double root;   /* a number of ours times its square is one of the user's */

  double *knots;        /* [n + 1] of the record */
  const double *points; /* of the user: of points the n or n + 1 of them */
  size_t dimension;     /* of these: 2 or 3 */
  double start[3];      /* the first point */
};

/*
 * ph_arc_data_read: the data of a problem.
 *
 * out  data  arrays in the arena
 * ret  PH_OK | PH_MISSING_FIELD | PH_BAD_VALUE | PH_BAD_SHAPE |
 *      PH_TOO_FEW_POINTS | PH_COINCIDENT_POINTS | PH_ZERO_TANGENT |
 *      PH_INFEASIBLE (a length is below its chord) | PH_TOO_LARGE |
 *      PH_NO_MEMORY
 */
enum ph_status ph_arc_data_read(const struct ph_problem *problem,
                                struct ph_arena *arena,
                                struct ph_arc_data *data, struct ph_diag *diag);

/* ph_arc_data_speed: the mean of length / spacing of the intervals beside datum
 * j: derivatives of that size belong to the lengths [HUA14, sec. 5.3]. */
double ph_arc_data_speed(const struct ph_arc_data *data, size_t j);

/* ph_arc_data_user: the user's number of our interval i. */
static inline size_t ph_arc_data_user(const struct ph_arc_data *data,
                                      size_t i) {
  size_t at = data->reversed ? data->n - 1 - i : i;
  return (at + data->first) % data->n;
}

/* ph_arc_data_ours: our number of the user's interval i. */
static inline size_t ph_arc_data_ours(const struct ph_arc_data *data,
                                      size_t i) {
  size_t at = (i + data->n - data->first) % data->n;
  return data->reversed ? data->n - 1 - at : at;
}

/* ph_arc_data_pose: turns, mirrors and reverses what ph_arc_data_read found in
 * the user's frame to the pose that all such data have. */
void ph_arc_data_pose(struct ph_arc_data *data);

#endif
