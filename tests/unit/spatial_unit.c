/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Spatial Hermite curves for tests (see spatial_unit.h). */
#include "spatial_unit.h"

#include "kernel/pow2.h"

/* ---- curves -------------------------------------------------------------- */

static ph_vec3 vector_at(const double *v, size_t dimension, size_t k) {
  const double *x = v + dimension * k;
  return ph_vec3_of(x[0], x[1], dimension > 2 ? x[2] : 0);
}

static ph_vec3 scaled(struct ph_pow2 s, ph_vec3 v) {
  return ph_vec3_of(ph_pow2_apply(s, v.x), ph_pow2_apply(s, v.y),
                    ph_pow2_apply(s, v.z));
}

/* Segment k, at unit scale for the family and back. */
static void build_segment(struct unit_hermite3 *s, size_t k, double phi) {
  const struct ph_value *points = &s->problem.field[PH_F_POINTS];
  bool tangents = s->problem.field[PH_F_TANGENTS].kind == PH_VECTORS;
  size_t n = points->n, d = points->dimension;
  ph_vec3 from = vector_at(s->points, d, k);
  ph_vec3 to = vector_at(s->points, d, (k + 1) % n);
  ph_vec3 vi = vector_at(s->vectors, d, k);
  ph_vec3 vf = vector_at(s->vectors, d, (k + 1) % n);
  double unit = s->curve.preimage.alpha ? s->alpha[k] : 1;
  double factor = s->tension[k] * s->tension[k], largest = 0;
  struct ph_atph space = ph_atph_of(s->curve.preimage.alpha ? s->alpha[k] : 0);
  struct ph_spatial_data data = {.noise = 0};
  struct ph_spatial_family family;
  struct ph_spatial_member member;
  struct ph_pow2 down, up;
  ph_quat a[3];
  ph_vec3 p[6];
  int exponent;
  for (size_t i = 0; i < d * n; i++) {
    largest = unit_larger(largest, fabs(s->points[i]));
  }
  exponent = ph_pow2_exponent(largest) / 2 * 2;
  down = ph_pow2_of(-exponent);
  up = ph_pow2_of(exponent);
  data.dp = ph_vec3_sub(scaled(down, to), scaled(down, from));
  if (!tangents) {
    vi = scaled(down, vi);
    vf = scaled(down, vf);
  }
  data.ti = ph_vec3_unit(vi);
  data.tf = ph_vec3_unit(vf);
  data.ni = factor * (tangents ? ph_vec3_abs(data.dp) : unit * ph_vec3_abs(vi));
  data.nf = factor * (tangents ? ph_vec3_abs(data.dp) : unit * ph_vec3_abs(vf));
  data.noise = 0;
  data.planarity = 0;
  family = ph_spatial_family_of(&data, &space);
  member = ph_spatial_cc(&family);
  member.phi = ph_cplx_polar(phi);
  unit_spatial_preimage(&family, member, a);
  ph_seg3_control_points(&space, a, scaled(down, from), scaled(down, to), p);
  for (size_t i = 0; i < 6; i++) {
    ph_vec3 q = scaled(up, p[i]);
    memcpy(s->control_points + 18 * k + 3 * i, &q, sizeof q);
  }
  s->lengths[k] = ph_pow2_apply(up, ph_seg3_length(&space, a));
  for (size_t i = 0; i < 3; i++) {
    a[i] = ph_quat_scale(ldexp(1, exponent / 2) / sqrt(unit), a[i]);
    memcpy(s->preimage + 12 * k + 4 * i, &a[i], sizeof a[i]);
  }
}

void unit_hermite3_build(struct unit_hermite3 *s, double phi) {
  s->curve.length = 0;
  for (size_t k = 0; k < s->curve.n; k++) {
    build_segment(s, k, phi);
    s->curve.length += s->lengths[k];
    s->knots[k + 1] = s->knots[k] + 1;
  }
}

void unit_hermite3_of(struct unit_hermite3 *s, const double *points,
                      enum ph_field_id which, const double *vectors, size_t n,
                      size_t dimension, bool closed, double alpha) {
  struct ph_value *field;
  memset(s, 0, sizeof *s);
  ck_assert_uint_le(n, UNIT_HERMITE3_MAX);
  memcpy(s->points, points, n * dimension * sizeof *points);
  memcpy(s->vectors, vectors, n * dimension * sizeof *vectors);
  field = s->problem.field;
  field[PH_F_POINTS] = (struct ph_value){
      .kind = PH_VECTORS, .v = s->points, .n = n, .dimension = dimension};
  field[which] = (struct ph_value){
      .kind = PH_VECTORS, .v = s->vectors, .n = n, .dimension = dimension};
  field[PH_F_CLOSED] = (struct ph_value){.kind = PH_BOOL, .flag = closed};
  s->curve = (struct ph_curve){.kind = alpha > 0 ? PH_CURVE_ATPH : PH_CURVE_PH,
                               .closed = closed,
                               .dimension = 3,
                               .degree = 5,
                               .n = closed ? n : n - 1,
                               .knots = s->knots,
                               .control_points = s->control_points,
                               .preimage.alpha = alpha > 0 ? s->alpha : NULL,
                               .preimage.n = 3,
                               .preimage.dimension = 4,
                               .preimage.v = s->preimage,
                               .lengths = s->lengths,
                               .choice.tension = s->tension,
                               .choice.shape_ok = s->shape_ok};
  for (size_t k = 0; k < s->curve.n; k++) {
    s->alpha[k] = alpha;
    s->tension[k] = 1;
  }
  unit_hermite3_build(s, 0);
}
