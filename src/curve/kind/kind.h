/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * What a sampler asks of each kind of curve (see sample.h, whose functions of
 * the same names say what these do); for the sample*.c and parallel.c alone.
 */
#ifndef PH_CURVE_KIND_KIND_H
#define PH_CURVE_KIND_KIND_H

#include "curve/sample/sample.h"
#include "curve/segment/spherical_fast.h"

struct ph_sample_kind {
  /* begin: allocates sampler->state. */
  enum ph_status (*begin)(struct ph_sampler *sampler, struct ph_diag *diag);
  /* enter: sampler->k is set; fills the state and sampler->length. */
  enum ph_status (*enter)(struct ph_sampler *sampler, struct ph_diag *diag);
  struct ph_sample (*at)(const struct ph_sampler *sampler, double u);
  double (*length)(const struct ph_sampler *sampler, double u, double *speed);
  double (*bend)(const struct ph_sampler *sampler, double u0, double u1);
};

/* PH and ATPH curves and cubics; offsets of these; Bezier curves; spherical
 * curves and their parallels. */
extern const struct ph_sample_kind ph_sample_kind_ph;
extern const struct ph_sample_kind ph_sample_kind_offset;
extern const struct ph_sample_kind ph_sample_kind_bezier;
extern const struct ph_sample_kind ph_sample_kind_spherical;

/*
 * How a point moves on the unit sphere, also where it is at rest: with S' = t V
 * next to rest at t = 0, K = S . (S' x S'') = t^2 K'' / 2, so that K / |S'|^2 =
 * S . (S'' x S''') / (2 |S''|^2) in the limit, whatever the curvature does.
 */
struct ph_motion {
  ph_vec3 s;       /* S */
  ph_vec3 tangent; /* unit; NaN where the segment is a point */
  double speed;    /* |S'|, 0 at rest */
  double turn;     /* K / |S'|^2: geodesic curvature times speed */
  double noise;    /* error of turn: some eps times this */
};

/* ph_motion_at: the motion at u in [0,1]. */
struct ph_motion ph_motion_at(const struct ph_spherical_fast *segment,
                              double u);

/* ph_motion_pace: g of parallel.h, how fast the parallel at the distance of
 * this cosine and sine goes along the tangent; 0 where g is nothing but
 * rounding: at a cusp, or everywhere in the center of a circle. */
double ph_motion_pace(const struct ph_motion *motion, double cosine,
                      double sine);

#endif
