/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A place on a spherical segment (see sample.h), on the unit sphere first. */
#include "curve/sample/bend.h"
#include "curve/kind/kind.h"
#include "kernel/degree.h"
#include "kernel/primitive.h"

#include <float.h>

/* What is less than this of its terms is their rounding. */
static const double ROUNDING = 64 * DBL_EPSILON;

/* The motion at or next to rest, where S'' and S''' say what S' does not. */
static struct ph_motion motion_slow(const struct ph_spherical *segment,
                                    double u) {
  struct ph_motion motion = {.speed = 0};
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
    motion.turn =
        fabs(k) > ROUNDING * second * third ? 0.5 * k / (second * second) : 0;
    along = !back ? jet[3] : ph_vec3_scale(u < 1 ? 1 : -1, jet[2]);
  }
  /* S'' and S''' need not be normal to S. */
  motion.tangent = ph_vec3_unit(ph_vec3_normal(along, jet[0]));
  return motion;
}

struct ph_motion ph_motion_at(const struct ph_spherical_fast *fast, double u) {
  struct ph_motion motion;
  ph_vec3 jet[3];
  double square, bend;
  ph_spherical_fast_jet(fast, u, jet);
  square = ph_vec3_dot(jet[1], jet[1]);
  bend = ph_vec3_dot(jet[2], jet[2]);
  if (!(square > ROUNDING * ROUNDING * bend)) {
    return motion_slow(&fast->segment, u);
  }
  motion.s = jet[0];
  motion.speed = sqrt(square);
  motion.turn = ph_vec3_triple(jet[0], jet[1], jet[2]) / square;
  motion.noise = sqrt(bend / square);
  motion.tangent = ph_vec3_unit(ph_vec3_normal(jet[1], jet[0]));
  return motion;
}

/* Where a point of the unit sphere is in the user's unit. */
static ph_vec3 placed(const struct ph_curve *curve, ph_vec3 s) {
  return ph_vec3_along(ph_vec3_get(curve->sphere.center, 3),
                       curve->sphere.radius, s);
}

/* The point, which at the ends is as given: without a rounding of its own. */
static ph_vec3 point_at(const struct ph_curve *curve, size_t k, double u,
                        ph_vec3 s) {
  const double *p = curve->control_points + 12 * k;
  return !(u > 0)   ? ph_vec3_get(p, 3)
         : !(u < 1) ? ph_vec3_get(p + 9, 3)
                    : placed(curve, s);
}

double ph_motion_pace(const struct ph_motion *motion, double cosine,
                      double sine) {
  double pace = cosine * motion->speed - sine * motion->turn;
  double terms = fabs(cosine) * motion->speed +
                 fabs(sine) * (motion->noise + motion->speed);
  return fabs(pace) > ROUNDING * terms ? pace : 0;
}

/* ---- one segment --------------------------------------------------------- */

/* A segment of a curve, or of its parallel. */
struct state {
  struct ph_spherical_fast segment;
  double angle, cosine, sine; /* d of parallel.h; 0 of the curve itself */
  struct ph_primitive length; /* by u, on the unit sphere */
  double scale;               /* to the unit of the data */
  double *breaks;             /* u of cusps, those of the segment at next */
  size_t breaks_n, next;
};

static enum ph_status begin(struct ph_sampler *sampler, struct ph_diag *diag) {
  const struct ph_offset *offset = sampler->offset;
  const size_t n = offset ? offset->cusps.n : 0;
  struct state *state = ph_arena_array(sampler->arena, 1, sizeof *state);
  double *breaks = ph_arena_array(sampler->arena, n + 1, sizeof *breaks);
  if (!state || !breaks) {
    return ph_fail_memory(diag);
  }
  *state = (struct state){.breaks = breaks, .cosine = 1};
  if (offset) {
    state->angle = offset->distance / sampler->curve->sphere.radius;
    state->cosine = cos(state->angle);
    state->sine = sin(state->angle);
  }
  for (size_t i = 0; i < n; i++) {
    breaks[i] = offset->cusps.at[i].u;
  }
  sampler->state = state;
  return PH_OK;
}

/* Goes to the cusps within segment k; those at its start do not count. */
static void find_breaks(struct state *state, const struct ph_offset *offset,
                        size_t k) {
  const struct ph_place *at = offset->cusps.at;
  const size_t n = offset->cusps.n;
  size_t i = state->next + state->breaks_n;
  if (i > 0 && at[i - 1].segment >= k) {
    i = 0;
  }
  while (i < n && (at[i].segment < k || (at[i].segment == k && at[i].u <= 0))) {
    i++;
  }
  state->next = i;
  while (i < n && at[i].segment == k && at[i].u < 1) {
    i++;
  }
  state->breaks_n = i - state->next;
}

/* |g| */
static double pace_at(const void *context, double u) {
  const struct state *state = context;
  struct ph_motion motion = ph_motion_at(&state->segment, u);
  return fabs(ph_motion_pace(&motion, state->cosine, state->sine));
}

/* How well the length of a segment can be known: as |g|, which is a difference
 * of what may be much larger. */
static double precision_of(const struct state *state) {
  enum { PLACES = 8 };
  static const double least = 1e-14, rounding = 4 * DBL_EPSILON;
  double terms = 0, pace = 0;
  for (int i = 0; i < PLACES; i++) {
    struct ph_motion motion = ph_motion_at(&state->segment, (i + 0.5) / PLACES);
    pace += fabs(ph_motion_pace(&motion, state->cosine, state->sine));
    terms += fabs(state->cosine) * motion.speed +
             fabs(state->sine) * (motion.noise + motion.speed);
  }
  return fmax(least, rounding * terms / fmax(pace, DBL_MIN));
}

/* Beside a turn that is nearly a cusp |g| is known to much less; a length to
 * 1e-9 is still one. */
static enum ph_status tabulate(struct ph_sampler *sampler) {
  enum { TRIES = 6 };
  struct state *state = sampler->state;
  double precision = precision_of(state);
  enum ph_status status = PH_NO_CONVERGENCE;
  for (int i = 0; i < TRIES && status == PH_NO_CONVERGENCE; i++) {
    status = ph_primitive_make(&state->length, pace_at, state,
                               state->breaks + state->next, state->breaks_n,
                               precision, sampler->arena);
    precision *= 10;
  }
  return status;
}

static enum ph_status enter(struct ph_sampler *sampler, struct ph_diag *diag) {
  const struct ph_curve *curve = sampler->curve;
  struct state *state = sampler->state;
  struct ph_spherical segment;
  enum ph_status status;
  segment = ph_spherical_of(curve, sampler->k);
  ph_spherical_fast_of(&segment, &state->segment);
  state->scale = curve->sphere.radius;
  sampler->length = (double)NAN;
  if (sampler->offset) {
    find_breaks(state, sampler->offset, sampler->k);
  }
  status = tabulate(sampler);
  if (status == PH_NO_MEMORY) {
    return ph_fail_memory(diag);
  }
  if (status != PH_OK) {
    return sampler->offset
               ? ph_fail_at(diag, status, "segments", sampler->k,
                            "has an offset at distance %g whose length was not "
                            "found",
                            sampler->offset->distance)
               : ph_fail_at(diag, status, "segments", sampler->k,
                            "has a length that was not found");
  }
  sampler->length = curve->sphere.radius * state->length.total;
  if (!sampler->offset) {
    double found = sampler->length;
    sampler->length = curve->lengths[sampler->k];
    state->scale *= found > 0 ? sampler->length / found : 1;
  }
  return PH_OK;
}

static double length(const struct ph_sampler *sampler, double u,
                     double *speed) {
  const struct state *state = sampler->state;
  double s = state->scale * ph_primitive_at(&state->length, u, speed);
  *speed *= state->scale;
  return !(u < 1) ? sampler->length : s < sampler->length ? s : sampler->length;
}

static double bend(const struct ph_sampler *sampler, double u0, double u1) {
  const struct state *state = sampler->state;
  return sampler->curve->sphere.radius *
         ph_bend_spherical(&state->segment.segment, state->angle, u0, u1);
}

/* ---- one place ----------------------------------------------------------- */

static struct ph_sample at_curve(const struct ph_sampler *sampler, double u,
                                 const struct ph_motion *motion) {
  const struct ph_curve *curve = sampler->curve;
  struct ph_sample sample = {.torsion = (double)NAN};
  sample.point = point_at(curve, sampler->k, u, motion->s);
  sample.tangent = motion->tangent;
  sample.curvature = motion->speed > 0
                         ? motion->turn / motion->speed / curve->sphere.radius
                         : (double)NAN;
  ph_degree_of_unit(motion->s, sample.lonlat);
  return sample;
}

/* (1) to (3) of parallel.h */
static struct ph_sample at_parallel(const struct ph_sampler *sampler,
                                    const struct ph_motion *m) {
  const struct ph_curve *curve = sampler->curve;
  const struct state *state = sampler->state;
  const double cosine = state->cosine, sine = state->sine;
  const double g = ph_motion_pace(m, cosine, sine);
  const double bend = cosine * m->turn + sine * m->speed;
  ph_vec3 left = ph_vec3_cross(m->s, m->tangent);
  ph_vec3 o = ph_vec3_along(ph_vec3_scale(cosine, m->s), sine, left);
  struct ph_sample sample = {.torsion = (double)NAN};
  sample.point = placed(curve, o);
  sample.tangent = g < 0 ? ph_vec3_scale(-1, m->tangent) : m->tangent;
  sample.curvature =
      fabs(g) > 0 ? bend / fabs(g) / curve->sphere.radius : (double)NAN;
  ph_degree_of_unit(o, sample.lonlat);
  return sample;
}

static struct ph_sample at(const struct ph_sampler *sampler, double u) {
  const struct state *state = sampler->state;
  struct ph_motion motion = ph_motion_at(&state->segment, u);
  return sampler->offset ? at_parallel(sampler, &motion)
                         : at_curve(sampler, u, &motion);
}

const struct ph_sample_kind ph_sample_kind_spherical = {begin, enter, at,
                                                        length, bend};
