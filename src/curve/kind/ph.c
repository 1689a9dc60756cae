/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The kinds with a preimage (see kind.h): PH and ATPH curves and Tschirnhausen
 * cubics.  A place is found in closed form (curve/segment/seg3_fast.h).
 *
 * Planar curves are taken in space, where z = 0 (curve/segment/seg3.h).
 */
#include "curve/kind/ph.h"

#include "curve/kind/kind.h"
#include "curve/sample/chord_bound.h"
#include "curve/segment/seg3_fast.h"

/* A at unit scale that is less than this has no curvature but its rounding;
 * likewise the torsion, as z of the curvature. */
static const double ROUNDING = PH_FAST3_ROUNDING;

static enum ph_status begin(struct ph_sampler *sampler, struct ph_diag *diag) {
  sampler->state = ph_arena_array(sampler->arena, 1, sizeof(struct ph_fast3));
  return sampler->state ? PH_OK : ph_fail_memory(diag);
}

static enum ph_status enter(struct ph_sampler *sampler, struct ph_diag *diag) {
  (void)diag;
  ph_fast3_of(sampler->curve, sampler->k, sampler->state);
  sampler->length = sampler->curve->lengths[sampler->k];
  return PH_OK;
}

static double length(const struct ph_sampler *sampler, double u,
                     double *speed) {
  const struct ph_fast3 *fast = sampler->state;
  const struct ph_fast3_place at = ph_fast3_at(fast, u);
  const ph_quat a = ph_fast3_preimage(&at);
  double s = ph_pow2_apply(fast->grow, ph_fast3_integral(&at, at.end->s));
  *speed = ph_pow2_apply(fast->grow, ph_quat_dot(a, a));
  return u > 0.5 ? sampler->length + s : s;
}

static double chord_bound(const struct ph_sampler *sampler, double u0,
                          double u1) {
  const struct ph_fast3 *fast = sampler->state;
  return ph_pow2_apply(fast->grow, ph_chord_bound_ph(&fast->seg, u0, u1));
}

/* Curvature and torsion at unit scale, by (1) and (2) of curve/segment/seg3.h.
 */
static void curvature_at(ph_quat a, ph_quat first, ph_quat second, bool planar,
                         struct ph_sample *sample) {
  const double per = 1 / ph_quat_dot(a, a);
  const ph_quat w = ph_quat_between(a, first);
  const ph_quat w1 = ph_quat_between(a, second);
  const double z2 = w.p * w.p + w.q * w.q;
  const double turn = w.p * w1.q - w.q * w1.p;
  sample->curvature = 2 * (planar ? w.q : sqrt(z2)) * (per * per);
  if (!planar && z2 * per > ROUNDING * ROUNDING) {
    sample->torsion = (turn / z2 + 2 * w.v * per) * per;
  }
}

static struct ph_sample at(const struct ph_sampler *sampler, double u) {
  const struct ph_fast3 *fast = sampler->state;
  const struct ph_fast3_place place = ph_fast3_at(fast, u);
  const ph_quat a = ph_fast3_preimage(&place), first = ph_fast3_first(&place);
  const ph_quat second = ph_fast3_second(fast, &place);
  const double speed = ph_quat_dot(a, a);
  struct ph_sample sample;
  ph_quat e = a;
  sample.lonlat[0] = sample.lonlat[1] = 0;
  sample.curvature = sample.torsion = (double)NAN;
  sample.point = ph_fast3_point(fast, &place);
  if (speed > ROUNDING * ROUNDING) {
    curvature_at(a, first, second, sampler->curve->dimension == 2, &sample);
    sample.curvature = ph_pow2_apply(fast->shrink, sample.curvature);
    sample.torsion = ph_pow2_apply(fast->shrink, sample.torsion);
  } else {
    e = ph_fast3_direction(fast, &place);
  }
  sample.tangent = ph_vec3_scale(1 / ph_quat_dot(e, e), ph_quat_i(e, e));
  return sample;
}

/* ---- frames -------------------------------------------------------------- */

/* The Euler-Rodrigues frame. */
static void reference(const struct ph_sampler *sampler, double u,
                      ph_vec3 e[3]) {
  const struct ph_fast3 *fast = sampler->state;
  const struct ph_fast3_place place = ph_fast3_at(fast, u);
  const ph_quat a = ph_fast3_direction(fast, &place);
  const double per = 1 / ph_quat_dot(a, a);
  e[0] = ph_vec3_scale(per, ph_quat_i(a, a));
  e[1] = ph_vec3_scale(per, ph_quat_j(a, a));
  e[2] = ph_vec3_scale(per, ph_quat_k(a, a));
}

/* 2x / sigma of curve/segment/seg3.h */
static double turn(const void *context, double u) {
  const struct ph_sampler *sampler = context;
  const struct ph_fast3_place place = ph_fast3_at(sampler->state, u);
  const ph_quat a = ph_fast3_preimage(&place);
  const ph_quat w = ph_quat_between(a, ph_fast3_first(&place));
  return 1 + 2 * w.v / ph_quat_dot(a, a);
}

/* q e2 - p e3 */
static ph_vec3 principal(const struct ph_sampler *sampler, double u,
                         const struct ph_sample *sample) {
  const struct ph_fast3_place place = ph_fast3_at(sampler->state, u);
  const ph_quat a = ph_fast3_preimage(&place);
  const ph_quat w = ph_quat_between(a, ph_fast3_first(&place));
  const ph_vec3 normal =
      ph_vec3_along(ph_vec3_scale(w.q, ph_quat_j(a, a)), -w.p, ph_quat_k(a, a));
  return ph_sample_principal(sample, normal);
}

/* ---- the kinds ----------------------------------------------------------- */

/* What they have in common. */
#define WITH_PREIMAGE                                               \
  .erf = true, .cusp = "radius of curvature equals it",             \
  .curve = {begin, enter, at, length, chord_bound, NULL},           \
  .beside = {ph_beside_begin,  ph_beside_enter,       ph_beside_at, \
             ph_beside_length, ph_beside_chord_bound, NULL},        \
  .reference = reference, .turn = turn, .principal = principal,     \
  .offsets_n = {1, PH_OFFSETS_SPATIAL}

const struct ph_kind ph_kind_ph = {WITH_PREIMAGE, .bernstein = true,
                                   .offset = ph_offset_rational,
                                   .bezier = ph_bezier_itself};

const struct ph_kind ph_kind_tc = {WITH_PREIMAGE, .bernstein = true,
                                   .cubic = true, .offset = ph_offset_rational,
                                   .bezier = ph_bezier_itself};

const struct ph_kind ph_kind_atph = {WITH_PREIMAGE, .angles = true,
                                     .offset = ph_offset_quotient,
                                     .bezier = ph_bezier_quintics};
