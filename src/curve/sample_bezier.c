/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A place on a Bezier segment (see sample.h), by derivatives of its control
 * points, which are brought to unit scale by a power of two.
 */
#include "curve/bend.h"
#include "curve/sample_kind.h"
#include "kernel/adapt.h"
#include "kernel/bern.h"
#include "kernel/pow2.h"

#include <assert.h>
#include <float.h>

enum { DEGREE_MAX = 5, ORDERS = 4 };

/* Lengths are found to this, relative to the control polygon. */
static const double TOLERANCE = 1e-13;
/* What is less than this of its terms is their rounding. */
static const double ROUNDING = 64 * DBL_EPSILON;

struct bezier {
  size_t degree;
  ph_vec3 p[DEGREE_MAX + 1];
  int exponent;   /* p is smaller by 2^exponent than the curve's */
  double polygon; /* length of the control polygon */
};

static struct bezier bezier_of(const struct ph_curve *curve, size_t k) {
  size_t dimension = curve->dimension, n = (curve->degree + 1) * dimension;
  const double *v = curve->control_points + n * k;
  struct bezier b = {.degree = curve->degree};
  double largest = 0;
  struct ph_pow2 shrink;
  assert(curve->degree <= DEGREE_MAX);
  for (size_t i = 0; i < n; i++) {
    largest = fmax(largest, fabs(v[i]));
  }
  b.exponent = largest > 0 ? ph_pow2_exponent(largest) : 0;
  shrink = ph_pow2_of(-b.exponent);
  for (size_t i = 0; i <= b.degree; i++) {
    ph_vec3 p = ph_vec3_get(v + dimension * i, dimension);
    b.p[i] = ph_vec3_of(ph_pow2_apply(shrink, p.x), ph_pow2_apply(shrink, p.y),
                        ph_pow2_apply(shrink, p.z));
    b.polygon += i > 0 ? ph_vec3_abs(ph_vec3_sub(b.p[i], b.p[i - 1])) : 0;
  }
  return b;
}

/* The point and `orders` - 1 derivatives. */
static void jet_at(const struct bezier *b, double u, size_t orders,
                   ph_vec3 *jet) {
  ph_vec3 d[DEGREE_MAX + 1];
  double basis[DEGREE_MAX + 1];
  for (size_t i = 0; i <= b->degree; i++) {
    d[i] = b->p[i];
  }
  for (size_t m = 0; m < orders; m++) {
    size_t degree = b->degree - m;
    ph_vec3 sum = {0, 0, 0};
    jet[m] = sum;
    if (m > b->degree) {
      continue;
    }
    ph_bern_basis(degree, u, basis);
    for (size_t i = 0; i <= degree; i++) {
      sum = ph_vec3_along(sum, basis[i], d[i]);
    }
    jet[m] = sum;
    for (size_t i = 0; i < degree; i++) {
      d[i] = ph_vec3_scale((double)degree, ph_vec3_sub(d[i + 1], d[i]));
    }
  }
}

static double speed_at(const void *context, double u) {
  ph_vec3 jet[2];
  jet_at(context, u, 2, jet);
  return ph_vec3_abs(jet[1]);
}

/* How much of the length of a segment is in [0,u]. */
static double share_of(const struct bezier *b, const struct ph_quad *rule,
                       double u) {
  double tolerance = TOLERANCE * b->polygon;
  double before = ph_adapt(rule, speed_at, b, 0, u, tolerance, 0);
  double after = ph_adapt(rule, speed_at, b, u, 1, tolerance, 0);
  return before > 0 ? before / (before + after) : 0;
}

/* The direction of r', of r'' or r''' where r' is 0; against r'' at the end of
 * the segment, where r' = -(1 - u) r''. */
static ph_vec3 direction_of(const ph_vec3 jet[ORDERS], double least, double u) {
  size_t i = 1;
  double sign;
  while (i < ORDERS - 1 && !(ph_vec3_abs(jet[i]) > least)) {
    i++;
  }
  sign = i == 2 && !(u < 1) ? -1 : 1;
  return ph_vec3_scale(sign / ph_vec3_abs(jet[i]), jet[i]);
}

enum { NODES = 16 };

struct state {
  struct bezier b;
  struct ph_quad rule;
};

static enum ph_status begin(struct ph_sampler *sampler, struct ph_diag *diag) {
  struct state *state = ph_arena_array(sampler->arena, 1, sizeof *state);
  sampler->state = state;
  return state && ph_quad_gauss(&state->rule, NODES) ? PH_OK
                                                     : ph_fail_memory(diag);
}

static enum ph_status enter(struct ph_sampler *sampler, struct ph_diag *diag) {
  struct state *state = sampler->state;
  (void)diag;
  state->b = bezier_of(sampler->curve, sampler->k);
  sampler->length = sampler->curve->lengths[sampler->k];
  return PH_OK;
}

static double length(const struct ph_sampler *sampler, double u,
                     double *speed) {
  const struct state *state = sampler->state;
  *speed = ldexp(speed_at(&state->b, u), state->b.exponent);
  return u < 1 ? sampler->length * share_of(&state->b, &state->rule, u)
               : sampler->length;
}

static double bend(const struct ph_sampler *sampler, double u0, double u1) {
  const struct bezier *b = &((const struct state *)sampler->state)->b;
  return ldexp(ph_bend_bezier(b->p, b->degree, u0, u1), b->exponent);
}

static struct ph_sample at(const struct ph_sampler *sampler, double u) {
  const struct ph_curve *curve = sampler->curve;
  const struct bezier b = ((const struct state *)sampler->state)->b;
  const struct ph_pow2 grow = ph_pow2_of(b.exponent);
  const struct ph_pow2 shrink = ph_pow2_of(-b.exponent);
  struct ph_sample sample = {.lonlat = {0, 0}};
  ph_vec3 jet[ORDERS], cross;
  double speed, bent, least = ROUNDING * b.polygon;
  jet_at(&b, u, ORDERS, jet);
  sample.point =
      ph_vec3_of(ph_pow2_apply(grow, jet[0].x), ph_pow2_apply(grow, jet[0].y),
                 ph_pow2_apply(grow, jet[0].z));
  sample.tangent = direction_of(jet, least, u);
  sample.curvature = sample.torsion = (double)NAN;
  speed = ph_vec3_abs(jet[1]);
  if (speed > least) {
    cross = ph_vec3_cross(jet[1], jet[2]);
    bent = curve->dimension == 2 ? cross.z : ph_vec3_abs(cross);
    sample.curvature = ph_pow2_apply(shrink, bent / (speed * speed * speed));
    if (fabs(bent) > least * speed) {
      sample.torsion = ph_pow2_apply(shrink, ph_vec3_dot(cross, jet[3]) /
                                                 ph_vec3_dot(cross, cross));
    }
  }
  return sample;
}

const struct ph_sample_kind ph_sample_kind_bezier = {begin, enter, at, length,
                                                     bend};
