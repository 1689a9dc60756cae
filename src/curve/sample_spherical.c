/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A place on a spherical segment (see sample.h), on the unit sphere first. */
#include "curve/bend.h"
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

static enum ph_status begin(struct ph_sampler *sampler, struct ph_diag *diag) {
  sampler->state =
      ph_arena_array(sampler->arena, 1, sizeof(struct ph_spherical));
  return sampler->state ? PH_OK : ph_fail_memory(diag);
}

static enum ph_status enter(struct ph_sampler *sampler, struct ph_diag *diag) {
  struct ph_spherical *segment = sampler->state;
  (void)diag;
  *segment = ph_spherical_of(sampler->curve, sampler->k);
  sampler->length = sampler->curve->lengths[sampler->k];
  return PH_OK;
}

static double length(const struct ph_sampler *sampler, double u,
                     double *speed) {
  const struct ph_spherical *segment = sampler->state;
  const double radius = sampler->curve->radius;
  *speed = radius * ph_motion_at(segment, u).speed;
  return !(u < 1) ? sampler->length
         : u > 0  ? radius * ph_spherical_length(segment, u)
                  : 0;
}

static double bend(const struct ph_sampler *sampler, double u0, double u1) {
  const double radius = sampler->curve->radius;
  return radius * ph_bend_spherical(sampler->state, 0, u0, u1);
}

static struct ph_sample at(const struct ph_sampler *sampler, double u) {
  const struct ph_curve *curve = sampler->curve;
  struct ph_motion motion = ph_motion_at(sampler->state, u);
  struct ph_sample sample;
  sample.point = point_at(curve, sampler->k, u, motion.s);
  sample.tangent = motion.tangent;
  sample.curvature = motion.speed > 0
                         ? motion.turn / motion.speed / curve->radius
                         : (double)NAN;
  sample.torsion = (double)NAN;
  ph_degree_of_unit(motion.s, sample.lonlat);
  return sample;
}

const struct ph_sample_kind ph_sample_kind_spherical = {begin, enter, at,
                                                        length, bend};
