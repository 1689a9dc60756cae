/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Curves of arclength (see arclength_curve.h). */
#include "solve/arclength/curve.h"

#include "base/sum.h"
#include "curve/ph3.h"
#include "solve/arclength/form.h"
#include "solve/common/frame.h"

#include <math.h>

/* z of a curve in the plane, relative to the mean speed. */
static const double FLAT = 1e-10;

/* Node j, also once or twice around a closed curve, as a quaternion. */
static ph_quat node(const struct ph_arc_system *s, const double *x, size_t j) {
  size_t around = j / s->nodes;
  const double *w = x + (j % s->nodes) * s->dim;
  double v[4] = {w[0], 0, 0, 0};
  if (s->dim == 4) {
    double chi = s->turn ? (double)around * x[s->x_n - 1] : 0;
    ph_arc_phase(cos(chi), sin(chi), w, v);
  } else {
    for (size_t k = 0; k < s->dim; k++) {
      v[2 * k] = around % 2 == 0 ? w[k] : s->sign * w[k];
    }
  }
  return ph_quat_of(v[0], v[1], v[3], v[2]);
}

/* The preimage of the user's segment q, but for the phase. */
static void preimage(const struct ph_arc_system *s, const double *x, size_t q,
                     ph_quat a[3]) {
  const struct ph_arc_data *d = s->data;
  /* counted on around a closed curve, so that the phase goes on */
  size_t at = q + (s->segments - d->first * s->refine) % s->segments;
  size_t along = d->first > 0 ? 2 * s->segments - 1 : s->segments - 1;
  size_t node0 = d->reversed ? along - at : at, ours = node0 % s->segments;
  double c[3][3];
  double root = d->root * sqrt(d->h[ours / s->refine] / (double)s->refine);
  ph_arc_coefficients(s, ours, c);
  for (size_t k = 0; k < 3; k++) {
    size_t from = d->reversed ? 2 - k : k;
    ph_quat sum = {0, 0, 0, 0};
    for (size_t l = 0; l < 3; l++) {
      sum = ph_quat_add(
          sum, ph_quat_scale(root * c[from][l], node(s, x, node0 + l)));
    }
    if (d->mirrored) { /* (a, b) to (conj a, conj b): z to -z */
      sum = ph_quat_of(sum.u, -sum.v, -sum.p, sum.q);
    }
    if (d->reversed) { /* (a, b) to (-conj b, conj a): H to -H */
      sum = ph_quat_of(-sum.q, sum.p, -sum.v, sum.u);
    }
    a[k] = ph_quat_mul(d->turn, sum);
  }
}

/* The integral of r' over a segment. */
static ph_vec3 displacement(const ph_quat a[3]) {
  ph_vec3 v = ph_vec3_scale(
      1. / 5, ph_vec3_add(ph_quat_i(a[0], a[0]), ph_quat_i(a[2], a[2])));
  v = ph_vec3_along(v, 1. / 5,
                    ph_vec3_add(ph_quat_i(a[0], a[1]), ph_quat_i(a[1], a[2])));
  v = ph_vec3_along(v, 2. / 15, ph_quat_i(a[1], a[1]));
  return ph_vec3_along(v, 1. / 15, ph_quat_i(a[0], a[2]));
}

/* Where segment q ends: in a datum, if it ends an interval of points. */
static ph_vec3 end_of(const struct ph_arc_system *s, size_t q, ph_vec3 start,
                      const ph_quat a[3]) {
  const struct ph_arc_data *d = s->data;
  size_t to = (q + 1) / s->refine;
  if (d->mode == PH_ARC_POINTS && (q + 1) % s->refine == 0) {
    to = d->closed && to == d->n ? 0 : to;
    return ph_vec3_get(d->points + to * d->dimension, d->dimension);
  }
  return ph_vec3_add(start, displacement(a));
}

static void put_segment(size_t q, const ph_quat a[3], const ph_vec3 p[6],
                        struct ph_curve *curve) {
  for (size_t k = 0; k < 6; k++) {
    ph_vec3_put(p[k], 3, curve->control_points + (6 * q + k) * 3);
  }
  for (size_t k = 0; k < 3; k++) {
    double *out = curve->preimage.v + (3 * q + k) * 4;
    out[0] = a[k].u + 0.0; /* no -0 */
    out[1] = a[k].v + 0.0;
    out[2] = a[k].p + 0.0;
    out[3] = a[k].q + 0.0;
  }
}

static void set_knots(const struct ph_arc_system *s, double *knots) {
  const double *t = s->data->knots;
  for (size_t i = 0; i < s->data->n; i++) {
    for (size_t k = 0; k < s->refine; k++) {
      double part = (double)k / (double)s->refine;
      knots[i * s->refine + k] = t[i] + part * (t[i + 1] - t[i]);
    }
  }
  knots[s->segments] = t[s->data->n];
}

enum ph_status ph_arc_curve(const struct ph_arc_system *s, const double *x,
                            struct ph_arena *arena, struct ph_curve *curve,
                            double *turn, struct ph_diag *diag) {
  const struct ph_arc_data *d = s->data;
  struct ph_atph space = ph_atph_of(0);
  ph_vec3 start = ph_vec3_get(d->start, 3);
  struct ph_sum length = {0, 0};
  ph_cplx phase = {1, 0};
  ph_quat a[3];
  enum ph_status status;
  *curve = (struct ph_curve){.kind = PH_CURVE_PH,
                             .closed = d->closed,
                             .dimension = 3,
                             .degree = 5,
                             .n = s->segments,
                             .preimage.n = 3,
                             .preimage.dimension = 4};
  status = ph_curve_alloc(curve, arena, diag);
  if (status != PH_OK) {
    return status;
  }
  set_knots(s, curve->knots);
  for (size_t q = 0; q < s->segments; q++) {
    ph_vec3 end, p[6];
    preimage(s, x, q, a);
    phase = q == 0 ? ph_frame_upright(a[0]) : phase;
    for (size_t k = 0; k < 3; k++) {
      a[k] = ph_quat_turn(a[k], phase);
    }
    end = end_of(s, q, start, a);
    ph_ph3_control_points(&space, a, start, end, p);
    put_segment(q, a, p, curve);
    curve->lengths[q] = ph_ph3_length(&space, a);
    ph_sum_add(&length, curve->lengths[q]);
    start = end;
  }
  curve->length = ph_sum_value(&length);
  *turn = d->closed ? ph_frame_turn(curve, a[2]) : 0;
  return PH_OK;
}

/* Products of neighbouring nodes have no z. */
bool ph_arc_is_flat(const struct ph_arc_system *s, const double *x) {
  for (size_t j = 0; s->dim == 4 && j + 1 < s->nodes; j++) {
    for (size_t k = j; k <= j + 1; k++) {
      double v[4];
      ph_arc_form(4, 3, x + 4 * k, v);
      if (!(fabs(ph_arc_dot(4, x + 4 * j, v)) <= FLAT)) {
        return false;
      }
    }
  }
  return true;
}
