/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Curves to be sampled (see places_data.h). */
#include "places_data.h"
#include "unit.h"

#include "curve/bezier/convert.h"
#include "curve/offset/cusp.h"
#include "curve/offset/offset.h"

#include <string.h>

enum { SEGMENTS = 3 };

/* The curve in the plane of a curve in space with A = Re w + Im w k. */
static void flatten(struct places_data *data) {
  const struct unit_curve3 *from = &data->space;
  struct ph_curve *c = &data->curve;
  *c = from->curve;
  c->dimension = c->preimage.dimension = 2;
  c->control_points = data->points;
  c->preimage.v = data->preimage;
  for (size_t i = 0; i < 6 * c->n; i++) {
    data->points[2 * i] = from->control_points[3 * i];
    data->points[2 * i + 1] = from->control_points[3 * i + 1];
  }
  for (size_t i = 0; i < 3 * c->n; i++) {
    data->preimage[2 * i] = from->preimage[4 * i];
    data->preimage[2 * i + 1] = from->preimage[4 * i + 3];
  }
}

static void plane(struct places_data *data, bool atph, struct unit_random *r) {
  ph_quat a[2 * SEGMENTS + 1];
  double alpha[SEGMENTS];
  for (size_t i = 0; i <= 2 * SEGMENTS; i++) {
    ph_cplx w = unit_random_cplx(r, 1.2);
    a[i] = ph_quat_of(0.5 + w.re, 0, 0, w.im);
  }
  for (size_t k = 0; k < SEGMENTS; k++) {
    alpha[k] = unit_random_in(r, 0.1, 2.5);
  }
  unit_curve3_of(&data->space, SEGMENTS, atph ? alpha : NULL, a,
                 ph_vec3_of(1, -2, 0));
  flatten(data);
}

static void sphere(struct places_data *data, struct unit_random *r) {
  const ph_vec3 center = {1, 2, -1};
  unit_spherical_random(&data->sphere, SEGMENTS, 0.6, r);
  unit_spherical_place(&data->sphere, center, 1.5);
  data->curve = data->sphere.curve;
}

/* The Bezier curve of an ATPH curve. */
static void bezier(struct places_data *data, struct unit_random *r) {
  struct ph_curve atph;
  struct ph_diag diag;
  double error;
  if (unit_random_below(r, 2)) {
    plane(data, true, r);
    atph = data->curve;
  } else {
    unit_curve3_random(&data->space, SEGMENTS, true, 0.7, r);
    atph = data->space.curve;
  }
  ck_assert_int_eq(
      ph_bezier_curve(&atph, 1e-3, &data->arena, &data->curve, &error, &diag),
      PH_OK);
  ck_assert_int_eq(data->curve.kind, PH_CURVE_BEZIER);
}

void places_random(struct places_data *data, enum places_kind kind,
                   struct unit_random *r) {
  data->kind = kind;
  data->has_offset = false;
  ph_arena_reset(&data->arena);
  switch (kind) {
  case PLACES_PH2:
  case PLACES_ATPH2:
    plane(data, kind == PLACES_ATPH2, r);
    break;
  case PLACES_TC:
    unit_cubics_random(&data->cubics, r, SEGMENTS, 1, ph_cplx_of(1, -2));
    data->curve = data->cubics.curve;
    break;
  case PLACES_SPHERE:
    sphere(data, r);
    break;
  case PLACES_BEZIER:
    bezier(data, r);
    break;
  default:
    unit_curve3_random(&data->space, SEGMENTS, kind == PLACES_ATPH3, 0.9, r);
    data->curve = data->space.curve;
  }
}

void places_offset(struct places_data *data, struct unit_random *r) {
  const struct ph_offset none = {.distance = unit_random_in(r, -0.8, 0.8)};
  const struct ph_offset_rules rules = {
      .tolerance = 1e-3, .samples = {.how = PH_SAMPLE_PARAMETER, .n = 1}};
  const bool e3 = data->curve.dimension == 3 && unit_random_below(r, 2);
  struct ph_offset *o = &data->offset;
  struct ph_diag diag;
  enum ph_status status;
  if (data->kind == PLACES_BEZIER) {
    return;
  }
  *o = none;
  data->has_offset = true;
  if (data->kind == PLACES_SPHERE) {
    status =
        ph_offset(&data->curve, none.distance, &rules, &data->arena, o, &diag);
  } else {
    o->vector = data->curve.dimension == 2 ? NULL : e3 ? "e3" : "e2";
    o->dimension = data->curve.dimension;
    status = ph_cusps_of(&data->curve, none.distance, e3 ? PH_E3 : PH_E2,
                         &data->arena, &o->cusps, &diag);
  }
  ck_assert_int_eq(status, PH_OK);
}

/* Exchanges vectors i and j. */
static void exchange(double *v, size_t size, size_t i, size_t j) {
  double old[4];
  memcpy(old, v + size * i, size * sizeof *v);
  memmove(v + size * i, v + size * j, size * sizeof *v);
  memcpy(v + size * j, old, size * sizeof *v);
}

static void reverse(double *v, size_t size, size_t n) {
  for (size_t i = 0; v && i < n / 2; i++) {
    exchange(v, size, i, n - 1 - i);
  }
}

/* -r'(1 - u) has the preimage i w(1 - u) or A(1 - u) j. */
void places_reverse(struct places_data *data) {
  struct ph_curve *c = &data->curve;
  reverse(c->control_points, c->dimension, (c->degree + 1) * c->n);
  reverse(c->preimage.v, c->preimage.dimension, c->preimage.n * c->n);
  reverse(c->lengths, 1, c->n);
  reverse(c->preimage.alpha, 1, c->n);
  for (size_t i = 0; c->preimage.v && i < c->preimage.n * c->n; i++) {
    const ph_quat j = {0, 0, 1, 0};
    double *w = c->preimage.v + c->preimage.dimension * i, re = w[0];
    if (c->preimage.dimension == 2) {
      w[0] = -w[1];
      w[1] = re;
    } else {
      ph_quat a = ph_quat_mul(ph_quat_of(w[0], w[1], w[2], w[3]), j);
      memcpy(w, &a, sizeof a);
    }
  }
}

static void scale(double *v, size_t n, int exponent) {
  for (size_t i = 0; v && i < n; i++) {
    v[i] = ldexp(v[i], exponent);
  }
}

void places_scale(struct places_data *data, int exponent) {
  struct ph_curve *c = &data->curve;
  scale(c->control_points, (c->degree + 1) * c->dimension * c->n, exponent);
  scale(c->preimage.v, c->preimage.n * c->preimage.dimension * c->n,
        exponent / 2);
  scale(c->lengths, c->n, exponent);
  scale(&c->length, 1, exponent);
  scale(c->sphere.center, 3, exponent);
  scale(&c->sphere.radius, 1, exponent);
  scale(&data->offset.distance, 1, exponent);
}

void places_free(struct places_data *data) {
  ph_arena_free(&data->arena);
}
