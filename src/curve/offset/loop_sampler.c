/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The sampler of loops (see loop.h): pieces of segments by the sampler of the
 * offset, joins as arcs and lines. */
#include "curve/offset/loop.h"

#include "kernel/cplx.h"

#include <string.h>

struct state {
  struct ph_sampler side[2]; /* the offset along the curve, and against it */
  const struct ph_loop_piece *piece;
  bool back;      /* against the curve */
  double u, h;    /* where the piece begins, and how far it goes */
  double start;   /* length of the offset there */
  ph_cplx center; /* of an arc */
  ph_cplx first, last;
};

static enum ph_status begin(struct ph_sampler *sampler, struct ph_diag *diag) {
  struct state *state = ph_arena_array(sampler->arena, 1, sizeof *state);
  enum ph_status status = state ? PH_OK : ph_fail_memory(diag);
  sampler->state = state;
  for (size_t i = 0; status == PH_OK && i < 2; i++) {
    status = ph_sampler_begin(&state->side[i], sampler->curve,
                              &sampler->offset->loops.sides[i], sampler->arena,
                              diag);
    state->side[i].k = PH_NO_SEGMENT;
  }
  return status;
}

/* The corner of a join. */
static ph_cplx corner_of(const struct ph_curve *curve, size_t join) {
  const bool end = join == curve->n;
  const double *p = ph_curve_points(curve, end ? join - 1 : join) +
                    (end ? 2 * curve->degree : 0);
  return ph_cplx_of(p[0], p[1]);
}

static enum ph_status enter(struct ph_sampler *sampler, struct ph_diag *diag) {
  struct state *state = sampler->state;
  const struct ph_loop_piece *piece = &sampler->loop->pieces[sampler->k];
  const double *p = piece->control_points;
  const size_t last = sampler->offset->degree;
  struct ph_sampler *side;
  enum ph_status status = PH_OK;
  double speed;
  state->piece = piece;
  state->first = ph_cplx_of(p[0], p[1]);
  state->last = ph_cplx_of(p[2 * last], p[2 * last + 1]);
  state->back = piece->interval[1] < piece->interval[0];
  sampler->length = piece->length;
  if (piece->segment == PH_NO_SEGMENT) {
    state->center = corner_of(sampler->curve, piece->join);
    return PH_OK;
  }
  state->u = piece->interval[0];
  state->h = piece->interval[1] - piece->interval[0];
  side = &state->side[state->back];
  if (side->k != piece->segment) {
    status = ph_sampler_enter(side, piece->segment, diag);
  }
  if (status == PH_OK) {
    state->start = ph_sampler_length(side, state->u, &speed);
  }
  return status;
}

static const struct ph_sampler *side_of(const struct ph_sampler *sampler) {
  const struct state *state = sampler->state;
  return &state->side[state->back];
}

static double place(const struct state *state, double u) {
  return u < 1 ? state->u + u * state->h : state->piece->interval[1];
}

/* An arc, or a line. */
static struct ph_sample at_join(const struct ph_sampler *sampler, double u) {
  const struct state *state = sampler->state;
  const double angle = state->piece->angle;
  const ph_cplx from = ph_cplx_sub(state->first, state->center);
  const ph_cplx along = ph_cplx_sub(state->last, state->first);
  struct ph_sample sample = {.torsion = (double)NAN};
  ph_cplx at, t;
  if (fabs(angle) > 0) {
    const ph_cplx turned = ph_cplx_mul(ph_cplx_polar(u * angle), from);
    at = u < 1 ? ph_cplx_add(state->center, turned) : state->last;
    t = ph_cplx_scale((angle > 0 ? 1 : -1) / ph_cplx_abs(turned),
                      ph_cplx_of(-turned.im, turned.re));
    sample.curvature = angle / sampler->length;
  } else {
    at = u < 1 ? ph_cplx_between(state->first, state->last, u) : state->last;
    t = ph_cplx_scale(1 / ph_cplx_abs(along), along);
  }
  sample.point = ph_vec3_of(at.re, at.im, 0);
  sample.tangent = ph_vec3_of(t.re, t.im, 0);
  return sample;
}

static struct ph_sample at(const struct ph_sampler *sampler, double u) {
  const struct state *state = sampler->state;
  struct ph_sample sample;
  if (state->piece->segment == PH_NO_SEGMENT) {
    return at_join(sampler, u);
  }
  sample = ph_sampler_at(side_of(sampler), place(state, u));
  if (state->back) {
    sample.tangent = ph_vec3_of(0 - sample.tangent.x, 0 - sample.tangent.y, 0);
    sample.curvature = 0 - sample.curvature;
  }
  if (!(u > 0)) { /* pieces meet in one point */
    sample.point = ph_vec3_of(state->first.re, state->first.im, 0);
  } else if (!(u < 1)) {
    sample.point = ph_vec3_of(state->last.re, state->last.im, 0);
  }
  return sample;
}

static double length(const struct ph_sampler *sampler, double u,
                     double *speed) {
  const struct state *state = sampler->state;
  double s;
  if (state->piece->segment == PH_NO_SEGMENT) {
    *speed = sampler->length;
    return u * sampler->length;
  }
  s = ph_sampler_length(side_of(sampler), place(state, u), speed);
  *speed *= fabs(state->h);
  return u < 1 ? fabs(s - state->start) : sampler->length;
}

static double chord_bound(const struct ph_sampler *sampler, double u0,
                          double u1) {
  const struct state *state = sampler->state;
  const double h = state->h, a = place(state, u0), b = place(state, u1);
  if (state->piece->segment == PH_NO_SEGMENT) {
    return sampler->length * fabs(state->piece->angle);
  }
  return h * h *
         ph_sampler_chord_bound(side_of(sampler), fmin(a, b), fmax(a, b));
}

const struct ph_sampler_ops ph_loop_ops = {begin,  enter,       at,
                                           length, chord_bound, NULL};
