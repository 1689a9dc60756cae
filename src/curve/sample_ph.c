/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A place on a PH or ATPH segment (see sample.h), by way of the preimage.
 *
 * A is brought to unit scale by a power of two, 2^-e, so that fourth powers of
 * it are in range: lengths are then smaller by 2^(2e), curvatures larger.
 * Planar curves are taken in space, where z = 0 (curve/seg3.h).
 */
#include "curve/bend.h"
#include "curve/ph2.h"
#include "curve/sample_kind.h"
#include "curve/seg3.h"
#include "kernel/pow2.h"

#include <float.h>

/* A at unit scale that is less than this has no direction but its rounding;
 * likewise the curvature, as its numerator z. */
static const double ROUNDING = 64 * DBL_EPSILON;

enum { NODES = 12 };

struct state {
  struct ph_seg3 seg; /* A at unit scale */
  struct ph_quad rule;
  struct ph_pow2 grow, shrink;
};

/* Brings A to unit scale; the exponent e. */
static int rescale(struct ph_seg3 *seg) {
  double largest = 0, scale;
  int exponent;
  for (size_t i = 0; i < 3; i++) {
    ph_quat a = seg->a[i];
    largest = fmax(
        largest, fmax(fmax(fabs(a.u), fabs(a.v)), fmax(fabs(a.p), fabs(a.q))));
  }
  exponent = largest > 0 ? ph_pow2_exponent(largest) : 0;
  scale = ldexp(1, -exponent);
  for (size_t i = 0; i < 3; i++) {
    seg->a[i] = ph_quat_scale(scale, seg->a[i]);
  }
  return exponent;
}

/* The exact length of [0,u]: |A|^2 is the sum of two planar speeds. */
static double length_to(const struct ph_seg3 *seg, double u) {
  ph_cplx pair[2][3];
  double sum = 0;
  ph_seg3_pair(seg, pair);
  for (size_t i = 0; i < 2; i++) {
    struct ph_atph part;
    ph_cplx w[3];
    ph_atph_part(&seg->space, pair[i], 0, u, &part, w);
    sum += u * ph_ph2_length(&part, w);
  }
  return sum;
}

/* The point, by a leg of unit scale from the nearer end. */
static ph_vec3 point_at(const struct ph_seg3 *seg, const struct ph_quad *rule,
                        struct ph_pow2 grow, double u) {
  struct ph_seg3 legs = *seg;
  ph_vec3 from = u <= 0.5 ? seg->start : seg->end, leg;
  legs.start = legs.end = ph_vec3_of(0, 0, 0);
  leg = ph_seg3_point(&legs, rule, u);
  return ph_vec3_of(from.x + ph_pow2_apply(grow, leg.x),
                    from.y + ph_pow2_apply(grow, leg.y),
                    from.z + ph_pow2_apply(grow, leg.z));
}

/* A, or the first of its derivatives that is not 0: its square has the
 * direction of r', as that of A (u - u0)^m has on either side of u0. */
static ph_quat direction_at(const struct ph_seg3 *seg, double u, bool *rests) {
  ph_quat jet[3];
  size_t i = 0;
  ph_seg3_jet(seg, u, jet, 3);
  while (i < 2 && !(ph_quat_abs(jet[i]) > ROUNDING)) {
    i++;
  }
  *rests = i > 0;
  return jet[i];
}

static enum ph_status begin(struct ph_sampler *sampler, struct ph_diag *diag) {
  struct state *state = ph_arena_array(sampler->arena, 1, sizeof *state);
  sampler->state = state;
  return state && ph_quad_gauss(&state->rule, NODES) ? PH_OK
                                                     : ph_fail_memory(diag);
}

static enum ph_status enter(struct ph_sampler *sampler, struct ph_diag *diag) {
  struct state *state = sampler->state;
  int exponent;
  (void)diag;
  state->seg = ph_seg3_of(sampler->curve, sampler->k);
  exponent = 2 * rescale(&state->seg);
  state->grow = ph_pow2_of(exponent);
  state->shrink = ph_pow2_of(-exponent);
  sampler->length = sampler->curve->lengths[sampler->k];
  return PH_OK;
}

static double length(const struct ph_sampler *sampler, double u,
                     double *speed) {
  const struct state *state = sampler->state;
  ph_quat a;
  ph_seg3_jet(&state->seg, u, &a, 1);
  *speed = ph_pow2_apply(state->grow, ph_quat_dot(a, a));
  return u < 1 ? ph_pow2_apply(state->grow, length_to(&state->seg, u))
               : sampler->length;
}

static double bend(const struct ph_sampler *sampler, double u0, double u1) {
  const struct state *state = sampler->state;
  return ph_pow2_apply(state->grow, ph_bend_ph(&state->seg, u0, u1));
}

static struct ph_sample at(const struct ph_sampler *sampler, double u) {
  const bool planar = sampler->curve->dimension == 2;
  const struct state *state = sampler->state;
  const struct ph_seg3 seg = state->seg;
  const struct ph_pow2 grow = state->grow, shrink = state->shrink;
  struct ph_sample sample = {.lonlat = {0, 0}};
  struct ph_bend3 bent;
  ph_quat a;
  bool rests, straight;
  a = direction_at(&seg, u, &rests);
  sample.point = point_at(&seg, &state->rule, grow, u);
  sample.tangent = ph_vec3_scale(1 / ph_quat_dot(a, a), ph_quat_i(a, a));
  sample.curvature = sample.torsion = (double)NAN;
  if (!rests) {
    bent = ph_seg3_bend(&seg, u);
    straight = ph_cplx_abs(bent.z) <= ROUNDING * sqrt(bent.speed);
    sample.curvature =
        ph_pow2_apply(shrink, planar ? 2 * bent.z.im / (bent.speed * bent.speed)
                                     : bent.curvature);
    sample.torsion =
        straight ? (double)NAN : ph_pow2_apply(shrink, bent.torsion);
  }
  return sample;
}

const struct ph_sample_kind ph_sample_kind_ph = {begin, enter, at, length,
                                                 bend};
