/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A place on a PH or ATPH segment, or a cubic (see sample.h), by way of the
 * preimage, in closed form (curve/segment/seg3_fast.h).
 *
 * Planar curves are taken in space, where z = 0 (curve/segment/seg3.h).
 */
#include "curve/sample/bend.h"
#include "curve/kind/kind.h"
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

static double bend(const struct ph_sampler *sampler, double u0, double u1) {
  const struct ph_fast3 *fast = sampler->state;
  return ph_pow2_apply(fast->grow, ph_bend_ph(&fast->seg, u0, u1));
}

/* Curvature and torsion at unit scale, by (1) and (2) of curve/segment/seg3.h.
 */
static void bend_at(ph_quat a, ph_quat slope, ph_quat bending, bool planar,
                    struct ph_sample *sample) {
  const double per = 1 / ph_quat_dot(a, a);
  const ph_quat w = ph_quat_between(a, slope);
  const ph_quat w1 = ph_quat_between(a, bending);
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
  const ph_quat a = ph_fast3_preimage(&place), slope = ph_fast3_slope(&place);
  const ph_quat bending = ph_fast3_bend(fast, &place);
  const double speed = ph_quat_dot(a, a);
  struct ph_sample sample;
  ph_quat e = a;
  sample.lonlat[0] = sample.lonlat[1] = 0;
  sample.curvature = sample.torsion = (double)NAN;
  sample.point = ph_fast3_point(fast, &place);
  if (speed > ROUNDING * ROUNDING) {
    bend_at(a, slope, bending, sampler->curve->dimension == 2, &sample);
    sample.curvature = ph_pow2_apply(fast->shrink, sample.curvature);
    sample.torsion = ph_pow2_apply(fast->shrink, sample.torsion);
  } else {
    e = ph_fast3_direction(fast, &place);
  }
  sample.tangent = ph_vec3_scale(1 / ph_quat_dot(e, e), ph_quat_i(e, e));
  return sample;
}

const struct ph_sample_kind ph_sample_kind_ph = {begin, enter, at, length,
                                                 bend};
