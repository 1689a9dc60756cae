/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A place on a spherical segment (see sample.h), on the unit sphere first. */
#include "curve/sample_kind.h"
#include "kernel/degree.h"

#include <float.h>

/* What is less than this of its terms is their rounding. */
static const double ROUNDING = 64 * DBL_EPSILON;

struct ph_motion ph_motion_at(const struct ph_spherical *segment, double u) {
  struct ph_motion motion;
  ph_vec3 jet[4], along;
  double first, second, third;
  ph_spherical_jet(segment, u, jet);
  first = ph_vec3_abs(jet[1]);
  second = ph_vec3_abs(jet[2]);
  third = ph_vec3_abs(jet[3]);
  motion.s = jet[0];
  if (first > ROUNDING * (second + third)) {
    motion.speed = first;
    motion.turn = ph_vec3_triple(jet[0], jet[1], jet[2]) / (first * first);
    motion.noise = second / first;
    along = jet[1];
  } else {
    bool back = second > ROUNDING * third; /* before the end, S' is -S'' */
    double k = ph_vec3_triple(jet[0], jet[2], jet[3]);
    motion.speed = 0;
    motion.noise = 0;
    motion.turn =
        fabs(k) > ROUNDING * second * third ? 0.5 * k / (second * second) : 0;
    along = !back ? jet[3] : ph_vec3_scale(u < 1 ? 1 : -1, jet[2]);
  }
  /* S'' and S''' need not be normal to S. */
  motion.tangent = ph_vec3_unit(ph_vec3_normal(along, jet[0]));
  return motion;
}

ph_vec3 ph_motion_point(const struct ph_curve *curve, ph_vec3 s) {
  return ph_vec3_along(ph_vec3_get(curve->center, 3), curve->radius, s);
}

/* The point, which at the ends is as given: without a rounding of its own. */
static ph_vec3 point_at(const struct ph_curve *curve, size_t k, double u,
                        ph_vec3 s) {
  const double *p = curve->control_points + 12 * k;
  return !(u > 0)   ? ph_vec3_get(p, 3)
         : !(u < 1) ? ph_vec3_get(p + 9, 3)
                    : ph_motion_point(curve, s);
}

struct ph_sample ph_sample_spherical(const struct ph_sampler *sampler, size_t k,
                                     double u) {
  const struct ph_curve *curve = sampler->curve;
  struct ph_spherical segment = ph_spherical_of(curve, k);
  struct ph_motion motion = ph_motion_at(&segment, u);
  struct ph_sample sample;
  sample.point = point_at(curve, k, u, motion.s);
  sample.tangent = motion.tangent;
  sample.length =
      u > 0 && u < 1 ? curve->radius * ph_spherical_length(&segment, u) : 0;
  sample.curvature = motion.speed > 0
                         ? motion.turn / motion.speed / curve->radius
                         : (double)NAN;
  sample.torsion = (double)NAN;
  ph_degree_of_unit(motion.s, sample.lonlat);
  return sample;
}
