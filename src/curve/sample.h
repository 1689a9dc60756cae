/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Samples of a curve of any kind: point, tangent, arc length, curvature,
 * torsion.  What a sample is (a place on a segment) and where samples are taken
 * are kept apart.
 *
 * What is not defined is NaN:
 *   the curvature and torsion where the curve stands still, as at the rest ends
 *     of a spherical curve (the tangent there is the limit, of what follows
 *     or, at the end of a segment, of what comes before);
 *   the torsion where the curvature vanishes, to rounding: everywhere on a
 *     straight line;
 *   the tangent of a segment that is a point.
 */
#ifndef PH_CURVE_SAMPLE_H
#define PH_CURVE_SAMPLE_H

#include "base/diag.h"
#include "base/mem.h"
#include "curve/result.h"
#include "kernel/quad.h"
#include "kernel/vec3.h"

#include <stdbool.h>

/* A curve to take samples of. */
struct ph_sampler {
  const struct ph_curve *curve;
  struct ph_quad rule;
};

/* A curve at one place, in the unit of the data; z = 0 in the plane. */
struct ph_sample {
  ph_vec3 point;
  ph_vec3 tangent;  /* unit */
  double length;    /* of the arc from the start of the segment */
  double curvature; /* signed in the plane, geodesic on the sphere */
  double torsion;   /* in space */
  double lonlat[2]; /* on the sphere: degrees */
};

/* ph_sampler_begin: false when memory is exhausted. */
bool ph_sampler_begin(struct ph_sampler *sampler, const struct ph_curve *curve);

/*
 * ph_sample_at: the curve at u in [0,1] of segment k.
 *
 * Of PH and ATPH curves and cubics the length is in closed form; of Bezier
 * curves it is that of the curve they stand for, as curve->lengths: a Gauss
 * rule says how it is distributed within a segment; of spherical curves it is
 * by ph_spherical_length.  Points at u = 0 and u = 1 are control points, and
 * the length at u = 1 is curve->lengths[k], to the last bit.
 */
struct ph_sample ph_sample_at(const struct ph_sampler *sampler, size_t k,
                              double u);

/*
 * ph_samples_alloc: room for samples->n samples.
 *
 * in   torsion, lonlat  whether there are arrays of these
 * ret  PH_OK | PH_NO_MEMORY
 */
enum ph_status ph_samples_alloc(struct ph_samples *samples, size_t dimension,
                                bool torsion, bool lonlat,
                                struct ph_arena *arena, struct ph_diag *diag);

/* ph_samples_count: n + 1 for each of the segments; 0: too many. */
size_t ph_samples_count(size_t segments, size_t n);

/* ph_samples_put: stores sample i, with s from the start of the curve. */
void ph_samples_put(struct ph_samples *samples, size_t i, size_t segment,
                    double t, double s, const struct ph_sample *sample);

/*
 * ph_sample_curve: n + 1 samples of each segment, n > 0, equally spaced in its
 * local parameter ([0,1]; atph: [0, alpha]) and at both of its ends: a joint is
 * there twice, with the curvatures on either side.
 *
 * out  samples  arrays from the arena
 * ret  PH_OK | PH_NO_MEMORY
 */
enum ph_status ph_sample_curve(const struct ph_curve *curve, size_t n,
                               struct ph_arena *arena,
                               struct ph_samples *samples,
                               struct ph_diag *diag);

#endif
