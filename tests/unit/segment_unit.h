/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What tests of segments share, in the plane and in space: segments by chance,
 * what they are by definition, curves of a few. */
#ifndef PH_TESTS_SEGMENT_UNIT_H
#define PH_TESTS_SEGMENT_UNIT_H

#include "unit.h"

#include "curve/result.h"
#include "curve/segment/seg2.h"
#include "curve/segment/seg3.h"

/* ---- planar segments ----------------------------------------------------- */

/* A curve with room for a few segments. */
struct unit_segments {
  struct ph_curve curve;
  double knots[4], control_points[36], alpha[3], preimage[18], lengths[3];
};

/* unit_seg2: the segment with this angle and preimage, from 0. */
struct ph_seg2 unit_seg2(double angle, const ph_cplx w[3]);

/* unit_seg2_random: an angle of 0 (one in four) or in (0, 3), a preimage that
 * turns by any angle. */
struct ph_seg2 unit_seg2_random(struct unit_random *r);

/* unit_seg2_curve: the curve of n <= 3 segments, all of angle 0 or none. */
void unit_seg2_curve(const struct ph_seg2 *seg, size_t n,
                     struct unit_segments *segments);

/* unit_seg2_w: w at u, straight from its definition. */
ph_cplx unit_seg2_w(const struct ph_seg2 *seg, double u);

/* unit_seg2_part: the part [u0,u1] on [0,1] again; points as for ph_seg2_point.
 */
struct ph_seg2 unit_seg2_part(const struct ph_seg2 *seg,
                              const struct ph_quad *rule, double u0, double u1);

/* ---- PH quintics by themselves ------------------------------------------- */

/* The space of PH quintics. */
static const struct ph_atph ph_quintic = {
    0, 1, 1, 1, {1.0 / 5, 1.0 / 5, 2.0 / 15, 1.0 / 15}};
/* The Bernstein coefficients of w^2. */
static inline void ph_hodograph(const ph_cplx w[3], ph_cplx hodograph[5]) {
  ph_cplx middle = ph_cplx_add(ph_cplx_scale(2, ph_cplx_mul(w[1], w[1])),
                               ph_cplx_mul(w[0], w[2]));
  hodograph[0] = ph_cplx_mul(w[0], w[0]);
  hodograph[1] = ph_cplx_mul(w[0], w[1]);
  hodograph[2] = ph_cplx_scale(1.0 / 3, middle);
  hodograph[3] = ph_cplx_mul(w[1], w[2]);
  hodograph[4] = ph_cplx_mul(w[2], w[2]);
}

static inline double ph_length(const ph_cplx w[3]) {
  return ph_seg2_length(&ph_quintic, w);
}

static inline void ph_control_points(const ph_cplx w[3], ph_cplx start,
                                     ph_cplx end, ph_cplx p[6]) {
  ph_seg2_control_points(&ph_quintic, w, start, end, p);
}

static inline double ph_rotation(const ph_cplx w[3]) {
  struct ph_seg2 seg = {ph_atph_of(0), {w[0], w[1], w[2]}, {0, 0}, {0, 0}};
  return ph_seg2_rotation(&seg, NULL);
}

/* ---- spatial segments ---------------------------------------------------- */

/* Uniform in the cube |x|, |y|, |z| < size. */
static inline ph_vec3 unit_random_vec3(struct unit_random *r, double size) {
  double x = unit_random_in(r, -size, size);
  double y = unit_random_in(r, -size, size);
  return ph_vec3_of(x, y, unit_random_in(r, -size, size));
}

/* A at u, straight from its definition (kernel/atph.h). */
static inline ph_quat unit_seg3_preimage(const struct ph_seg3 *seg, double u) {
  const double a = seg->space.angle, c = cos(a / 2);
  const double s0 = a > 0 ? sin(a * (1 - u) / 2) / sin(a / 2) : 1 - u;
  const double s1 = a > 0 ? sin(a * u / 2) / sin(a / 2) : u;
  ph_quat sum = ph_quat_scale(s0 * s0, seg->a[0]);
  sum = ph_quat_add(sum, ph_quat_scale(2 * c * s0 * s1, seg->a[1]));
  return ph_quat_add(sum, ph_quat_scale(s1 * s1, seg->a[2]));
}

/* a e a*, by quaternion products alone. */
static inline ph_vec3 unit_turned(ph_quat a, ph_quat e) {
  return ph_quat_vector(ph_quat_mul(ph_quat_mul(a, e), ph_quat_conj(a)));
}

/* The hodograph A i A* at u. */
static inline ph_vec3 unit_seg3_hodograph(const struct ph_seg3 *seg, double u) {
  return unit_turned(unit_seg3_preimage(seg, u), ph_quat_of(0, 1, 0, 0));
}

/* The integral of the hodograph over [u0,u1], in panels of 20 nodes. */
static inline ph_vec3 unit_seg3_leg(const struct ph_seg3 *seg, double u0,
                                    double u1) {
  enum { PANELS = 4 };
  ph_vec3 sum = {0, 0, 0};
  struct ph_quad rule;
  if (ph_quad_gauss(&rule, 20)) {
    for (size_t i = 0; i < PANELS; i++) {
      for (size_t j = 0; j < rule.n; j++) {
        double u = u0 + (u1 - u0) * ((double)i + rule.node[j]) / PANELS;
        sum = ph_vec3_along(sum, (u1 - u0) * rule.weight[j] / PANELS,
                            unit_seg3_hodograph(seg, u));
      }
    }
  }
  return sum;
}

/* The segment with this angle and preimage. */
static inline struct ph_seg3 unit_seg3(double angle, const ph_quat a[3],
                                       ph_vec3 start) {
  struct ph_seg3 seg = {
      ph_atph_of(angle), {a[0], a[1], a[2]}, {0, 0, 0}, {0, 0, 0}};
  seg.start = start;
  seg.end = ph_vec3_add(start, unit_seg3_leg(&seg, 0, 1));
  return seg;
}

/* An angle of 0 (one in four) or in (0, 3), a preimage of any shape. */
static inline struct ph_seg3 unit_seg3_random(struct unit_random *r) {
  double angle = unit_random_below(r, 4) ? unit_random_in(r, 1e-3, 3) : 0;
  ph_quat a[3];
  for (size_t i = 0; i < 3; i++) {
    ph_cplx w = unit_random_cplx(r, 2), v = unit_random_cplx(r, 2);
    a[i] = ph_quat_of(w.re, w.im, v.re, v.im);
  }
  return unit_seg3(angle, a, unit_random_vec3(r, 1));
}

/* What bends and twists at u.  Where the curvature vanishes, torsion and slopes
 * are not finite. */
struct unit_bend3 {
  double speed;         /* |r'| = |A|^2, per u */
  double curvature;     /* (1), not negative */
  double torsion;       /* (2) */
  double slope;         /* d curvature / du */
  double torsion_slope; /* d torsion / du */
  ph_cplx z;            /* curvature vector: 2 (q e2 - p e3) / sigma^2 */
  double turn;          /* 2 x / sigma: of e2 towards e3 about the tangent,
                           relative to a rotation-minimising frame, per u */
};

/* unit_seg3_bend: the speed is positive unless A(u) = 0; there the rest is not
 * finite. */
struct unit_bend3 unit_seg3_bend(const struct ph_seg3 *seg, double u);

/* unit_seg3_frame: the Euler-Rodrigues frame at u.
 * out  e[3]  unit vectors, right-handed; e[0] is the tangent */
void unit_seg3_frame(const struct ph_seg3 *seg, double u, ph_vec3 e[3]);

/*
 * unit_seg3_twist: the angle by which the Euler-Rodrigues frame turns about the
 * tangent from 0 to u, relative to a rotation-minimising frame: that one is
 * e2, e3 turned back by it.
 *
 * Adaptive Gauss quadrature of `turn` to 1e-12; not finite where the curve
 * stands still.
 */
double unit_seg3_twist(const struct ph_seg3 *seg, const struct ph_quad *rule,
                       double u);

/* unit_seg3_part: the part [u0,u1] on [0,1] again; points as for ph_seg3_point.
 */
struct ph_seg3 unit_seg3_part(const struct ph_seg3 *seg,
                              const struct ph_quad *rule, double u0, double u1);

#endif
