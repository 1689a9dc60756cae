/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Planar PH quintic segments (see ph2.h). */
#include "curve/ph2.h"

void ph_ph2_hodograph(const ph_cplx w[3], ph_cplx hodograph[5]) {
  ph_cplx middle = ph_cplx_add(ph_cplx_scale(2, ph_cplx_mul(w[1], w[1])),
                               ph_cplx_mul(w[0], w[2]));
  hodograph[0] = ph_cplx_mul(w[0], w[0]);
  hodograph[1] = ph_cplx_mul(w[0], w[1]);
  hodograph[2] = ph_cplx_scale(1.0 / 3, middle);
  hodograph[3] = ph_cplx_mul(w[1], w[2]);
  hodograph[4] = ph_cplx_mul(w[2], w[2]);
}

void ph_ph2_speed(const ph_cplx w[3], double speed[5]) {
  speed[0] = ph_cplx_norm2(w[0]);
  speed[1] = ph_cplx_dot(w[0], w[1]);
  speed[2] = (2 * ph_cplx_norm2(w[1]) + ph_cplx_dot(w[0], w[2])) / 3;
  speed[3] = ph_cplx_dot(w[1], w[2]);
  speed[4] = ph_cplx_norm2(w[2]);
}

double ph_ph2_length(const ph_cplx w[3]) {
  double s[5];
  ph_ph2_speed(w, s);
  /* The integral of a Bernstein polynomial is the mean of its coefficients. */
  return (s[0] + s[1] + s[2] + s[3] + s[4]) / 5;
}

void ph_ph2_control_points(const ph_cplx w[3], ph_cplx start, ph_cplx end,
                           ph_cplx p[6]) {
  ph_cplx first = ph_cplx_mul(w[0], w[0]), second = ph_cplx_mul(w[0], w[1]);
  ph_cplx fourth = ph_cplx_mul(w[1], w[2]), fifth = ph_cplx_mul(w[2], w[2]);
  ph_cplx a = ph_cplx_add(start, ph_cplx_scale(0.2, first));
  ph_cplx b = ph_cplx_add(a, ph_cplx_scale(0.2, second));
  ph_cplx d = ph_cplx_sub(end, ph_cplx_scale(0.2, fifth));
  ph_cplx c = ph_cplx_sub(d, ph_cplx_scale(0.2, fourth));
  p[0] = start;
  p[1] = a;
  p[2] = b;
  p[3] = c;
  p[4] = d;
  p[5] = end;
}

/* The angle from a to b, in (-pi, pi]. */
static double angle_between(ph_cplx a, ph_cplx b) {
  return atan2(ph_cplx_cross(a, b), ph_cplx_dot(a, b));
}

double ph_ph2_rotation(const ph_cplx w[3]) {
  /*
   * (1) w(u) = w0 (1-u)^2 + 2 w1 (1-u) u + w2 u^2.
   * (2) With d = sqrt(w1^2 - w0 w2), signed so that q = w1 + d does not
   *     cancel:  q w(u) = (q (1-u) + w2 u) (w0 (1-u) + q u),
   *     as w0 w2 + q^2 = 2 w1 q.        Tested by t_ph2.c: factorisation.
   */
  ph_cplx d = ph_cplx_sqrt(
      ph_cplx_sub(ph_cplx_mul(w[1], w[1]), ph_cplx_mul(w[0], w[2])));
  ph_cplx q =
      ph_cplx_dot(w[1], d) >= 0 ? ph_cplx_add(w[1], d) : ph_cplx_sub(w[1], d);
  return 2 * (angle_between(q, w[2]) + angle_between(w[0], q));
}
