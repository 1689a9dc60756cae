/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Segments for tests (see segment_unit.h). */
#include "segment_unit.h"

/* ---- planar segments ----------------------------------------------------- */

struct ph_seg2 unit_seg2(double angle, const ph_cplx w[3]) {
  struct ph_seg2 seg = {.space = ph_atph_of(angle)};
  const double *q = seg.space.q;
  ph_cplx sum = ph_cplx_scale(q[0], ph_cplx_mul(w[0], w[0]));
  memcpy(seg.w, w, sizeof seg.w);
  sum = ph_cplx_add(sum, ph_cplx_scale(q[0], ph_cplx_mul(w[2], w[2])));
  sum = ph_cplx_add(
      sum, ph_cplx_scale(q[1], ph_cplx_mul(w[1], ph_cplx_add(w[0], w[2]))));
  sum = ph_cplx_add(sum, ph_cplx_scale(q[2], ph_cplx_mul(w[1], w[1])));
  sum = ph_cplx_add(sum, ph_cplx_scale(q[3], ph_cplx_mul(w[0], w[2])));
  seg.end = sum;
  return seg;
}

struct ph_seg2 unit_seg2_random(struct unit_random *r) {
  double angle = unit_random_below(r, 4) ? unit_random_in(r, 1e-3, 3) : 0;
  ph_cplx w[3];
  for (size_t i = 0; i < 3; i++) {
    w[i] = unit_random_cplx(r, 2);
  }
  return unit_seg2(angle, w);
}

void unit_seg2_curve(const struct ph_seg2 *seg, size_t n,
                     struct unit_segments *s) {
  const bool atph = seg[0].space.angle > 0;
  memset(s, 0, sizeof *s);
  ck_assert_uint_le(n, 3);
  s->curve = (struct ph_curve){.kind = atph ? PH_CURVE_ATPH : PH_CURVE_PH,
                               .dimension = 2,
                               .degree = 5,
                               .n = n,
                               .knots = s->knots,
                               .control_points = s->control_points,
                               .preimage.alpha = atph ? s->alpha : NULL,
                               .preimage.n = 3,
                               .preimage.dimension = 2,
                               .preimage.v = s->preimage,
                               .lengths = s->lengths};
  for (size_t k = 0; k < n; k++) {
    double angle = seg[k].space.angle, root = atph ? sqrt(angle) : 1;
    double *p = s->control_points + 12 * k;
    ck_assert((angle > 0) == atph);
    s->alpha[k] = angle;
    s->knots[k + 1] = s->knots[k] + (atph ? angle : 1);
    p[0] = seg[k].start.re;
    p[1] = seg[k].start.im;
    p[10] = seg[k].end.re;
    p[11] = seg[k].end.im;
    for (size_t i = 0; i < 3; i++) {
      s->preimage[6 * k + 2 * i] = seg[k].w[i].re / root;
      s->preimage[6 * k + 2 * i + 1] = seg[k].w[i].im / root;
    }
  }
}

ph_cplx unit_seg2_w(const struct ph_seg2 *seg, double u) {
  const double a = seg->space.angle, c = cos(a / 2);
  const double s0 = a > 0 ? sin(a * (1 - u) / 2) / sin(a / 2) : 1 - u;
  const double s1 = a > 0 ? sin(a * u / 2) / sin(a / 2) : u;
  ph_cplx w = ph_cplx_scale(s0 * s0, seg->w[0]);
  w = ph_cplx_add(w, ph_cplx_scale(2 * c * s0 * s1, seg->w[1]));
  return ph_cplx_add(w, ph_cplx_scale(s1 * s1, seg->w[2]));
}

struct ph_seg2 unit_seg2_part(const struct ph_seg2 *seg,
                              const struct ph_quad *rule, double u0,
                              double u1) {
  struct ph_seg2 part;
  double root = sqrt(u1 - u0);
  ph_atph_part(&seg->space, seg->w, u0, u1, &part.space, part.w);
  for (size_t i = 0; i < 3; i++) {
    part.w[i] = ph_cplx_scale(root, part.w[i]);
  }
  part.start = ph_seg2_point(seg, rule, u0);
  part.end = ph_seg2_point(seg, rule, u1);
  return part;
}

/* ---- spatial segments ---------------------------------------------------- */

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
