/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The unit sphere: angles, great-circle interpolation, exponential and
 * logarithm.  Points are unit vectors; nothing here uses acos, and nothing
 * branches where two points are equal.
 *
 * Interpolation needs sin(tau theta) / sin(theta), smooth in X = theta^2 when
 * written by
 *   f_n(X) = j_n(theta) / theta^n,   f_n' = -f_{n+1} / 2,              (1)
 * j_n the spherical Bessel functions: f_0 = sin(theta) / theta.
 */
#ifndef PH_KERNEL_S2_H
#define PH_KERNEL_S2_H

#include "kernel/vec3.h"

/* ph_s2_f0_far: ph_s2_f0 of any X. */
double ph_s2_f0_far(double x);

/* ph_s2_f0: sin(theta) / theta for X = theta^2, 0 <= X <= pi^2; three terms of
 * its series reach rounding where X is small. */
static inline double ph_s2_f0(double x) {
  return x < 0x1p-16 ? 1 - x / 6 * (1 - x / 20) : ph_s2_f0_far(x);
}

/* ph_s2_bessel: f_0, ..., f_3 of (1) for 0 <= X <= pi^2; out  f[4] */
void ph_s2_bessel(double x, double f[4]);

/* ph_s2_angle: the angle between two unit vectors, in [0, pi]; relative error
 * of rounding only, for small angles too. */
static inline double ph_s2_angle(ph_vec3 p, ph_vec3 q) {
  return 2 *
         atan2(ph_vec3_abs(ph_vec3_sub(p, q)), ph_vec3_abs(ph_vec3_add(p, q)));
}

/* ph_s2_near_square: the square of the angle of a short chord of the square c
 * < 2^-12: 4 asin(sqrt(c) / 2)^2 = 2 sum_n c^n / (n^2 binomial(2 n, n)), four
 * terms; the next one is below 2^-59 of the sum. */
static inline double ph_s2_near_square(double c) {
  return c * (1 + c * (1.0 / 12 + c * (1.0 / 90 + c * (1.0 / 560))));
}

/* ph_s2_square: the square of ph_s2_angle. */
static inline double ph_s2_square(ph_vec3 p, ph_vec3 q) {
  ph_vec3 d = ph_vec3_sub(p, q);
  double c = ph_vec3_dot(d, d), angle;
  if (c < 0x1p-12) {
    return ph_s2_near_square(c);
  }
  angle = ph_s2_angle(p, q);
  return angle * angle;
}

/* ph_s2_weight: sin(tau theta) / sin(theta) for X = theta^2 < pi^2. */
static inline double ph_s2_weight(double tau, double x) {
  return tau * ph_s2_f0(tau * tau * x) / ph_s2_f0(x);
}

/* ph_s2_between: ph_s2_slerp where the square x of the angle is known. */
static inline ph_vec3 ph_s2_between(ph_vec3 p, ph_vec3 q, double x, double t) {
  double s = 1 - t, w = 1 / ph_s2_f0(x);
  return ph_vec3_along(ph_vec3_scale(s * ph_s2_f0(s * s * x) * w, p),
                       t * ph_s2_f0(t * t * x) * w, q);
}

/* ph_s2_slerp: the point at t on the great circle from p, t = 0, to q, t = 1;
 * not finite, or anything, where they are antipodal. */
static inline ph_vec3 ph_s2_slerp(ph_vec3 p, ph_vec3 q, double t) {
  return ph_s2_between(p, q, ph_s2_square(p, q), t);
}

/* ph_s2_exp: where the geodesic from p with velocity v is at time 1; v.p = 0.
 */
static inline ph_vec3 ph_s2_exp(ph_vec3 p, ph_vec3 v) {
  double x = ph_vec3_dot(v, v);
  return ph_vec3_along(ph_vec3_scale(cos(sqrt(x)), p), ph_s2_f0(x), v);
}

/* ph_s2_log: the velocity at p of the geodesic that is at q at time 1; 0 for
 * q = p, undefined for q = -p. */
static inline ph_vec3 ph_s2_log(ph_vec3 p, ph_vec3 q) {
  ph_vec3 d = ph_vec3_sub(q, p);
  /* q - (p.q) p with p.q = 1 - |d|^2 / 2, so that nothing cancels */
  ph_vec3 u = ph_vec3_along(d, ph_vec3_dot(d, d) / 2, p);
  return ph_vec3_scale(1 / ph_s2_f0(ph_s2_square(p, q)), u);
}

#endif
