/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Data of the sphere problem: unit vectors and spacings, from the fields of a
 * problem.
 */
#ifndef PH_SOLVE_SPHERE_DATA_H
#define PH_SOLVE_SPHERE_DATA_H

#include "base/diag.h"
#include "base/mem.h"
#include "curve/problem.h"
#include "kernel/vec3.h"

#include <stdbool.h>

/* What the curve does at the ends of open data. */
enum ph_sphere_ends {
  PH_SPHERE_NATURAL, /* no covariant acceleration */
  PH_SPHERE_REST,    /* no velocity */
  PH_SPHERE_CLAMPED  /* given velocities */
};

struct ph_sphere_data {
  bool closed;
  enum ph_sphere_ends ends;
  size_t n;      /* nodes */
  size_t m;      /* segments: n - 1, or n if closed */
  ph_vec3 *p;    /* [n] unit vectors */
  ph_vec3 *e;    /* [n] unit tangents: with p x e, the frame at a node */
  double *theta; /* [m] angle from node k to the next, in (0, pi) */
  double *h;     /* [m] spacings of the knots; mean that of theta, for knots
                  * given by a word */
  double *nu;    /* [n] initial tensions; 0 at the ends of open data, which have
                  * no effect, if they are not given */
  ph_vec3 end[2]; /* clamped: velocities with respect to the knots */

  double *knots; /* [m + 1] of the record: the numbers given, or sums of h */
  double center[3];
  double radius;
  double moved; /* by how much the points were moved at most, / radius */
  size_t moved_at;
  bool tell_moved; /* by more than rounding: a warning is due */
  double rounding; /* error of the coordinates of p, from those given */
};

/*
 * ph_sphere_data_read: the data of a problem.
 *
 * out  data  arrays in the arena
 * ret  PH_OK | PH_MISSING_FIELD | PH_BAD_VALUE | PH_BAD_SHAPE |
 *      PH_TOO_FEW_POINTS | PH_COINCIDENT_POINTS (neighbours nearer than 1e-8) |
 *      PH_ANTIPODAL_POINTS (farther than pi - 1e-6) | PH_NOT_ON_SPHERE |
 *      PH_ZERO_TANGENT | PH_TOO_LARGE | PH_NO_MEMORY
 */
enum ph_status ph_sphere_data_read(const struct ph_problem *problem,
                                   struct ph_arena *arena,
                                   struct ph_sphere_data *data,
                                   struct ph_diag *diag);

/* ph_sphere_before: the segment that ends at node i; only where there is one.
 */
static inline size_t ph_sphere_before(const struct ph_sphere_data *d,
                                      size_t i) {
  return i > 0 ? i - 1 : d->m - 1;
}

/* ph_sphere_next: the node at the end of segment k. */
static inline size_t ph_sphere_next(const struct ph_sphere_data *d, size_t k) {
  return k + 1 < d->n ? k + 1 : 0;
}

/* ph_sphere_is_end: whether node i is an end of open data. */
static inline bool ph_sphere_is_end(const struct ph_sphere_data *d, size_t i) {
  return !d->closed && (i == 0 || i + 1 == d->n);
}

/* ph_sphere_left, ph_sphere_right: the spacing before and after node i; 0
 * beyond the ends. */
static inline double ph_sphere_left(const struct ph_sphere_data *d, size_t i) {
  return !d->closed && i == 0 ? 0 : d->h[ph_sphere_before(d, i)];
}

static inline double ph_sphere_right(const struct ph_sphere_data *d, size_t i) {
  return !d->closed && i + 1 == d->n ? 0 : d->h[i];
}

/* ph_sphere_stiffness: what the velocity at node i, which is no end, is
 * multiplied by in its equation in the plane, beside the tension:
 * 4/h_i + 4/h_{i+1}. */
static inline double ph_sphere_stiffness(const struct ph_sphere_data *d,
                                         size_t i) {
  return 4 / d->h[ph_sphere_before(d, i)] + 4 / d->h[i];
}

#endif
