/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What sample.c asks of each kind of curve; for it and parallel.c alone. */
#ifndef PH_CURVE_SAMPLE_KIND_H
#define PH_CURVE_SAMPLE_KIND_H

#include "curve/sample.h"
#include "curve/spherical.h"

/* ph_sample_ph, ..: ph_sample_at of one kind. */
struct ph_sample ph_sample_ph(const struct ph_sampler *sampler, size_t k,
                              double u);
struct ph_sample ph_sample_bezier(const struct ph_sampler *sampler, size_t k,
                                  double u);
struct ph_sample ph_sample_spherical(const struct ph_sampler *sampler, size_t k,
                                     double u);

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
struct ph_motion ph_motion_at(const struct ph_spherical *segment, double u);

/* ph_motion_point: where a point of the unit sphere is in the user's unit. */
ph_vec3 ph_motion_point(const struct ph_curve *curve, ph_vec3 s);

#endif
