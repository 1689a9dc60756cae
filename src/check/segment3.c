/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the certificates of curves in space share (see segment3.h). */
#include "check/segment3.h"

#include <float.h>

struct ph_check3_data ph_check3_data_of(const struct ph_problem *problem,
                                        enum ph_field_id id) {
  const struct ph_value *value = &problem->field[id];
  struct ph_check3_data data = {value->v, 0, value->dimension};
  data.n = value->kind == PH_VECTORS ? value->n : 0;
  return data;
}

enum ph_status ph_check3_begin(struct ph_check3 *c,
                               const struct ph_curve *curve,
                               const double *points, size_t n, size_t dimension,
                               struct ph_diag *diag) {
  c->curve = curve;
  if (!ph_quad_gauss(&c->rule, curve->preimage.alpha ? PH_CHECK_NODES_ATPH
                                                     : PH_CHECK_NODES_PH)) {
    return ph_fail_memory(diag);
  }
  c->space = ph_check_space_of(&c->rule, 0);
  if (!ph_check_scale_of(points, n, dimension, &c->scale)) {
    return ph_fail(diag, PH_INTERNAL, "points", "have no extent");
  }
  return PH_OK;
}

static double largest_of(ph_vec3 v) {
  return ph_check_larger(ph_check_larger(fabs(v.x), fabs(v.y)), fabs(v.z));
}

ph_vec3 ph_check3_direction(ph_vec3 v) {
  double largest = largest_of(v);
  return ph_vec3_unit(ph_vec3_of(v.x / largest, v.y / largest, v.z / largest));
}

/* The legs, and what follows from their lengths. */
static void set_legs(const struct ph_check3 *c, const double *p,
                     struct ph_check3_segment *s) {
  ph_vec3 from = ph_check3_scaled(c, ph_vec3_get(p, 3));
  double farthest = largest_of(from);
  s->start = from;
  s->speed = 0;
  for (size_t i = 0; i < 5; i++) {
    ph_vec3 to = ph_check3_scaled(c, ph_vec3_get(p + 3 * (i + 1), 3));
    s->leg[i] = ph_vec3_sub(to, from);
    s->speed =
        ph_check_larger(s->speed, ph_vec3_abs(s->leg[i]) /
                                      (ph_check_binomial(i) * c->space.mu[i]));
    farthest = ph_check_larger(farthest, largest_of(to));
    from = to;
  }
  s->end = from;
  s->rounding = DBL_EPSILON * farthest + c->scale.spacing;
  s->allowance =
      PH_CHECK_ROUND_FIRST * ph_check_smaller(s->rounding, c->scale.rounding);
}

static void set_preimage(const struct ph_check3 *c, size_t k,
                         struct ph_check3_segment *s) {
  const double *v = c->curve->preimage.v + 12 * k;
  double root = c->scale.root * sqrt(s->unit);
  for (size_t i = 0; i < 3; i++, v += 4) {
    s->a[i] = ph_quat_of(root * v[0], root * v[1], root * v[2], root * v[3]);
  }
}

struct ph_check3_segment ph_check3_segment_of(struct ph_check3 *c, size_t k) {
  const struct ph_curve *curve = c->curve;
  struct ph_check3_segment s;
  ph_check_space_for(&c->space, &c->rule, curve, k);
  set_legs(c, curve->control_points + 18 * k, &s);
  s.unit = curve->preimage.alpha ? curve->preimage.alpha[k] : 1;
  set_preimage(c, k, &s);
  s.tension = curve->choice.tension ? curve->choice.tension[k] : 1;
  for (size_t i = 0; i < 2; i++) {
    double size;
    s.first[i] = ph_vec3_scale(1 / c->space.mu[0], s.leg[4 * i]);
    size = ph_vec3_abs(s.first[i]);
    s.tangent[i] = ph_vec3_scale(1 / size, s.first[i]);
    s.error[i] = s.allowance / size;
  }
  return s;
}

double ph_check3_hodograph(const struct ph_check3 *c,
                           const struct ph_check3_segment *s, double *miss) {
  double length = 0, worst = 0;
  for (size_t i = 0; i < c->rule.n; i++) {
    const double *leg = c->space.leg[i], *b = c->space.square[i];
    ph_vec3 r = ph_vec3_scale(leg[0], s->leg[0]), difference;
    ph_quat a = ph_quat_scale(b[0], s->a[0]);
    double error;
    for (size_t j = 1; j < 5; j++) {
      r = ph_vec3_along(r, leg[j], s->leg[j]);
    }
    for (size_t j = 1; j < 3; j++) {
      a = ph_quat_add(a, ph_quat_scale(b[j], s->a[j]));
    }
    difference = ph_vec3_sub(r, ph_quat_i(a, a));
    error = ph_vec3_dot(difference, difference);
    length += c->rule.weight[i] * ph_vec3_abs(r);
    if (!(error <= worst)) {
      worst = error;
    }
  }
  *miss = sqrt(worst);
  return length;
}
