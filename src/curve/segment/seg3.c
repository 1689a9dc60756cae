/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Segments of spatial PH and ATPH splines (see seg3.h).
 *
 * A quaternion (u + v i) + (p + q i) j is two complex numbers, and a preimage
 * two complex preimages: kernel/atph.h serves both dimensions.
 */
#include "curve/segment/seg3.h"

#include "kernel/pow2.h"

#include <math.h>

static ph_quat quaternion(const double *a, size_t dimension) {
  return dimension == 2 ? ph_quat_of(a[0], 0, 0, a[1])
                        : ph_quat_of(a[0], a[1], a[2], a[3]);
}

struct ph_seg3 ph_seg3_of(const struct ph_curve *curve, size_t k) {
  size_t dimension = curve->dimension, size = dimension == 2 ? 2 : 4;
  size_t last = curve->preimage.n - 1;
  const double *a = ph_curve_preimage(curve, k);
  const double *p = ph_curve_points(curve, k);
  double angle = ph_curve_angle(curve, k),
         root = sqrt(ph_curve_range(curve, k));
  struct ph_seg3 seg;
  seg.space = ph_atph_of(angle);
  seg.a[0] = quaternion(a, size);
  seg.a[2] = quaternion(a + size * last, size);
  seg.a[1] = last == 2 ? quaternion(a + size, size)
                       : ph_quat_scale(0.5, ph_quat_add(seg.a[0], seg.a[2]));
  for (size_t i = 0; i < 3; i++) {
    seg.a[i] = ph_quat_scale(root, seg.a[i]);
  }
  seg.start = ph_vec3_get(p, dimension);
  seg.end = ph_vec3_get(p + curve->degree * dimension, dimension);
  return seg;
}

/* The largest component of what A is a sum of. */
static double size_of(const struct ph_seg3 *seg) {
  double largest = 0;
  for (size_t i = 0; i < 3; i++) {
    double weight = i == 1 ? seg->space.c : 1;
    ph_quat a = seg->a[i];
    largest = fmax(largest, weight * fmax(fmax(fabs(a.u), fabs(a.v)),
                                          fmax(fabs(a.p), fabs(a.q))));
  }
  return largest;
}

int ph_seg3_rescale(struct ph_seg3 *seg) {
  double largest = size_of(seg);
  int exponent = largest > 0 ? ph_pow2_exponent(largest) : 0;
  double scale = ldexp(1, -exponent);
  for (size_t i = 0; i < 3; i++) {
    seg->a[i] = ph_quat_scale(scale, seg->a[i]);
  }
  return exponent;
}

void ph_seg3_pair(const struct ph_seg3 *seg, ph_cplx pair[2][3]) {
  for (size_t i = 0; i < 3; i++) {
    pair[0][i] = ph_cplx_of(seg->a[i].u, seg->a[i].v);
    pair[1][i] = ph_cplx_of(seg->a[i].p, seg->a[i].q);
  }
}

void ph_seg3_jet(const struct ph_seg3 *seg, double u, ph_quat *jet, size_t n) {
  ph_cplx w[2][3], w_jet[4], v_jet[4];
  ph_seg3_pair(seg, w);
  ph_atph_jet(&seg->space, w[0], u, w_jet, n);
  ph_atph_jet(&seg->space, w[1], u, v_jet, n);
  for (size_t i = 0; i < n; i++) {
    jet[i] = ph_quat_of(w_jet[i].re, w_jet[i].im, v_jet[i].re, v_jet[i].im);
  }
}

/* The integral of A i A* over [u0,u1]. */
static ph_vec3 leg(const struct ph_seg3 *seg, const struct ph_quad *rule,
                   double u0, double u1) {
  ph_vec3 sum = {0, 0, 0};
  for (size_t i = 0; i < rule->n; i++) {
    ph_quat a;
    ph_seg3_jet(seg, u0 + (u1 - u0) * rule->node[i], &a, 1);
    sum = ph_vec3_along(sum, rule->weight[i], ph_quat_i(a, a));
  }
  return ph_vec3_scale(u1 - u0, sum);
}

ph_vec3 ph_seg3_point(const struct ph_seg3 *seg, const struct ph_quad *rule,
                      double u) {
  return u <= 0.5 ? ph_vec3_add(seg->start, leg(seg, rule, 0, u))
                  : ph_vec3_sub(seg->end, leg(seg, rule, u, 1));
}

void ph_seg3_speed(const ph_quat a[3], double speed[5]) {
  speed[0] = ph_quat_dot(a[0], a[0]);
  speed[1] = ph_quat_dot(a[0], a[1]);
  speed[2] = (2 * ph_quat_dot(a[1], a[1]) + ph_quat_dot(a[0], a[2])) / 3;
  speed[3] = ph_quat_dot(a[1], a[2]);
  speed[4] = ph_quat_dot(a[2], a[2]);
}

double ph_seg3_length(const struct ph_atph *space, const ph_quat a[3]) {
  const double *q = space->q;
  return q[0] * (ph_quat_dot(a[0], a[0]) + ph_quat_dot(a[2], a[2])) +
         q[1] * (ph_quat_dot(a[0], a[1]) + ph_quat_dot(a[1], a[2])) +
         q[2] * ph_quat_dot(a[1], a[1]) + q[3] * ph_quat_dot(a[0], a[2]);
}

void ph_seg3_control_points(const struct ph_atph *space, const ph_quat a[3],
                            ph_vec3 start, ph_vec3 end, ph_vec3 p[6]) {
  double outer = space->q[0], inner = space->q[1];
  p[0] = start;
  p[1] = ph_vec3_along(start, outer, ph_quat_i(a[0], a[0]));
  p[2] = ph_vec3_along(p[1], inner, ph_quat_i(a[0], a[1]));
  p[4] = ph_vec3_along(end, -outer, ph_quat_i(a[2], a[2]));
  p[3] = ph_vec3_along(p[4], -inner, ph_quat_i(a[1], a[2]));
  p[5] = end;
}
