/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Curves in space for tests (see curve_unit.h). */
#include "curve_unit.h"

#include "curve/segment/seg3.h"

enum { DEGREE_MAX = 9, PANELS = 16, NODES = 5 };

static const ph_quat UNIT[3] = {{0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}};

ph_quat unit_curve3_preimage(const struct ph_curve *curve, size_t k, double u) {
  const double *a = curve->preimage.v + 12 * k;
  const double angle = curve->preimage.alpha ? curve->preimage.alpha[k] : 0;
  const double s0 =
      angle > 0 ? sin(angle * (1 - u) / 2) / sin(angle / 2) : 1 - u;
  const double s1 = angle > 0 ? sin(angle * u / 2) / sin(angle / 2) : u;
  const double root = angle > 0 ? sqrt(angle) : 1;
  const double b[3] = {s0 * s0, 2 * cos(angle / 2) * s0 * s1, s1 * s1};
  double sum[4];
  for (size_t i = 0; i < 4; i++) {
    sum[i] = root * (b[0] * a[i] + b[1] * a[4 + i] + b[2] * a[8 + i]);
  }
  return ph_quat_of(sum[0], sum[1], sum[2], sum[3]);
}

static ph_vec3 turned(ph_quat a, ph_quat unit) {
  return ph_quat_vector(ph_quat_mul(ph_quat_mul(a, unit), ph_quat_conj(a)));
}

void unit_curve3_frame(const struct ph_curve *curve, size_t k, double u,
                       ph_vec3 e[3]) {
  ph_quat a = unit_curve3_preimage(curve, k, u);
  for (size_t i = 0; i < 3; i++) {
    e[i] = ph_vec3_scale(1 / ph_quat_dot(a, a), turned(a, UNIT[i]));
  }
}

ph_vec3 unit_curve3_point(const struct ph_curve *curve, size_t k, double u) {
  ph_vec3 sum = ph_vec3_get(curve->control_points + 18 * k, 3);
  struct ph_quad rule;
  ck_assert(ph_quad_gauss(&rule, NODES));
  for (size_t i = 0; i < PANELS; i++) {
    for (size_t j = 0; j < NODES; j++) {
      double at = ((double)i + rule.node[j]) / PANELS * u;
      sum = ph_vec3_along(sum, u * rule.weight[j] / PANELS,
                          turned(unit_curve3_preimage(curve, k, at), UNIT[0]));
    }
  }
  return sum;
}

ph_vec3 unit_curve3_moved(const struct ph_curve *curve, size_t k, double u,
                          double distance, enum ph_normal normal) {
  ph_vec3 e[3], point = unit_curve3_point(curve, k, u);
  unit_curve3_frame(curve, k, u, e);
  return fabs(distance) > 0
             ? ph_vec3_along(point, distance, normal == PH_E2 ? e[1] : e[2])
             : point;
}

void unit_curve3_of(struct unit_curve3 *c, size_t n, const double *alpha,
                    const ph_quat *a, ph_vec3 start) {
  memset(c, 0, sizeof *c);
  ck_assert_uint_le(n, UNIT_CURVE3_MAX);
  c->curve = (struct ph_curve){.kind = alpha ? PH_CURVE_ATPH : PH_CURVE_PH,
                               .dimension = 3,
                               .degree = 5,
                               .n = n,
                               .knots = c->knots,
                               .control_points = c->control_points,
                               .preimage.alpha = alpha ? c->alpha : NULL,
                               .preimage.n = 3,
                               .preimage.dimension = 4,
                               .preimage.v = c->preimage,
                               .lengths = c->lengths};
  for (size_t k = 0; k < n; k++) {
    struct ph_atph space = ph_atph_of(alpha ? alpha[k] : 0);
    double root = alpha ? sqrt(alpha[k]) : 1;
    double *out = c->control_points + 18 * k;
    ph_vec3 end, p[6];
    c->alpha[k] = space.angle;
    c->knots[k + 1] = c->knots[k] + (alpha ? alpha[k] : 1);
    for (size_t i = 0; i < 3; i++) {
      ph_quat by_t = ph_quat_scale(1 / root, a[2 * k + i]);
      memcpy(c->preimage + 12 * k + 4 * i, &by_t, sizeof by_t);
    }
    ph_vec3_put(start, 3, out);
    end = unit_curve3_point(&c->curve, k, 1);
    ph_seg3_control_points(&space, a + 2 * k, start, end, p);
    for (size_t i = 0; i < 6; i++) {
      ph_vec3_put(p[i], 3, out + 3 * i);
    }
    c->lengths[k] = ph_seg3_length(&space, a + 2 * k);
    c->curve.length += c->lengths[k];
    start = end;
  }
}

void unit_curve3_random(struct unit_curve3 *c, size_t n, bool atph, double wild,
                        struct unit_random *r) {
  ph_quat a[2 * UNIT_CURVE3_MAX + 1];
  double alpha[UNIT_CURVE3_MAX];
  ck_assert_uint_le(n, UNIT_CURVE3_MAX);
  for (size_t i = 0; i <= 2 * n; i++) {
    ph_cplx left = unit_random_cplx(r, wild);
    ph_cplx right = unit_random_cplx(r, wild);
    a[i] = ph_quat_of(1 + left.re, left.im, right.re, right.im);
  }
  for (size_t k = 0; k < n; k++) {
    alpha[k] = unit_random_in(r, 0.1, 2);
  }
  unit_curve3_of(c, n, atph ? alpha : NULL, a, ph_vec3_of(3, -1, 2));
}

ph_vec3 unit_bezier3(const double *p, size_t degree, size_t order, double t) {
  const long double u = (long double)t;
  double at[3];
  for (size_t j = 0; j < 3; j++) {
    long double x[DEGREE_MAX + 1];
    size_t n = degree;
    ck_assert_uint_le(degree, DEGREE_MAX);
    for (size_t i = 0; i <= n; i++) {
      x[i] = (long double)p[3 * i + j];
    }
    for (; n + order > degree; n--) {
      for (size_t i = 0; i < n; i++) {
        x[i] = (long double)n * (x[i + 1] - x[i]);
      }
    }
    for (; n > 0; n--) {
      for (size_t i = 0; i < n; i++) {
        x[i] = (1 - u) * x[i] + u * x[i + 1];
      }
    }
    at[j] = (double)x[0];
  }
  return ph_vec3_of(at[0], at[1], at[2]);
}
