/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Curvature, frames and parts of spatial segments (see seg3_unit.h). */
#include "seg3_unit.h"

/* Halvings of an interval of the twist and of all, and its tolerance in radians
 * and relative. */
enum { HALVINGS_MAX = 30, PARTS_MAX = 4096 };
static const double TWIST = 1e-13;
static const double TWIST_RELATIVE = 4e-15;

struct unit_bend3 unit_seg3_bend(const struct ph_seg3 *seg, double u) {
  ph_quat a[4], w, w1, w2;
  struct unit_bend3 bend;
  double s, s1, z2, change, turn1;
  ph_cplx z, z1, second;
  ph_seg3_jet(seg, u, a, 4);
  w = ph_quat_between(a[0], a[1]); /* W, and its derivatives in w1, w2 */
  w1 = ph_quat_between(a[0], a[2]);
  w2 = ph_quat_add(ph_quat_between(a[0], a[3]), ph_quat_between(a[1], a[2]));
  s = ph_quat_dot(a[0], a[0]);
  s1 = 2 * w.u / s;
  z = ph_cplx_of(w.p, w.q);
  z1 = ph_cplx_of(w1.p, w1.q);
  second = ph_cplx_of(w2.p, w2.q);
  z2 = ph_cplx_norm2(z);
  change = ph_cplx_cross(z, z1) / z2; /* (arg z)' */
  bend.speed = s;
  bend.z = z;
  bend.turn = 2 * w.v / s;
  bend.curvature = 2 * sqrt(z2) / (s * s);
  bend.torsion = (change + bend.turn) / s;
  bend.slope = bend.curvature * (ph_cplx_dot(z, z1) / z2 - 2 * s1);
  turn1 = 2 * w1.v / s - bend.turn * s1;
  bend.torsion_slope =
      ((ph_cplx_cross(z, second) - 2 * change * ph_cplx_dot(z, z1)) / z2 +
       turn1) /
          s -
      bend.torsion * s1;
  return bend;
}

void unit_seg3_frame(const struct ph_seg3 *seg, double u, ph_vec3 e[3]) {
  ph_quat a;
  double per_s;
  ph_seg3_jet(seg, u, &a, 1);
  per_s = 1 / ph_quat_dot(a, a);
  e[0] = ph_vec3_scale(per_s, ph_quat_i(a, a));
  e[1] = ph_vec3_scale(per_s, ph_quat_j(a, a));
  e[2] = ph_vec3_scale(per_s, ph_quat_k(a, a));
}

static double turn_at(const struct ph_seg3 *seg, double u) {
  ph_quat a[2];
  ph_seg3_jet(seg, u, a, 2);
  return 2 * ph_quat_between(a[0], a[1]).v / ph_quat_dot(a[0], a[0]);
}

static double turn_over(const struct ph_seg3 *seg, const struct ph_quad *rule,
                        double u0, double u1) {
  double sum = 0;
  for (size_t i = 0; i < rule->n; i++) {
    sum += rule->weight[i] * turn_at(seg, u0 + (u1 - u0) * rule->node[i]);
  }
  return (u1 - u0) * sum;
}

/* The integral over [u0,u1], `whole` by one rule, from its halves. */
static double refine(const struct ph_seg3 *seg, const struct ph_quad *rule,
                     double u0, double u1, double whole, int depth,
                     size_t *parts) {
  double middle = 0.5 * (u0 + u1);
  double left = turn_over(seg, rule, u0, middle);
  double right = turn_over(seg, rule, middle, u1);
  double rounding = TWIST_RELATIVE * (fabs(left) + fabs(right));
  if (fabs(left + right - whole) <= TWIST * (u1 - u0) + rounding ||
      depth == HALVINGS_MAX || ++*parts > PARTS_MAX ||
      !isfinite(left + right)) {
    return left + right;
  }
  return refine(seg, rule, u0, middle, left, depth + 1, parts) +
         refine(seg, rule, middle, u1, right, depth + 1, parts);
}

double unit_seg3_twist(const struct ph_seg3 *seg, const struct ph_quad *rule,
                       double u) {
  size_t parts = 0;
  return refine(seg, rule, 0, u, turn_over(seg, rule, 0, u), 0, &parts);
}

struct ph_seg3 unit_seg3_part(const struct ph_seg3 *seg,
                              const struct ph_quad *rule, double u0,
                              double u1) {
  struct ph_seg3 part;
  ph_quat jet[2];
  double root = sqrt(u1 - u0);
  part.space = ph_atph_of(seg->space.angle * (u1 - u0));
  ph_seg3_jet(seg, u1, &part.a[2], 1);
  ph_seg3_jet(seg, u0, jet, 2);
  part.a[0] = jet[0];
  part.a[1] = ph_quat_add(
      jet[0], ph_quat_scale((u1 - u0) / (2 * part.space.slope), jet[1]));
  for (size_t i = 0; i < 3; i++) {
    part.a[i] = ph_quat_scale(root, part.a[i]);
  }
  part.start = ph_seg3_point(seg, rule, u0);
  part.end = ph_seg3_point(seg, rule, u1);
  return part;
}
