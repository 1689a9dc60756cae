/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Planar PH quintic and ATPH segments (see ph2.h). */
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

double ph_ph2_length(const struct ph_atph *space, const ph_cplx w[3]) {
  const double *q = space->q;
  return q[0] * (ph_cplx_norm2(w[0]) + ph_cplx_norm2(w[2])) +
         q[1] * (ph_cplx_dot(w[0], w[1]) + ph_cplx_dot(w[1], w[2])) +
         q[2] * ph_cplx_norm2(w[1]) + q[3] * ph_cplx_dot(w[0], w[2]);
}

void ph_ph2_control_points(const struct ph_atph *space, const ph_cplx w[3],
                           ph_cplx start, ph_cplx end, ph_cplx p[6]) {
  double outer = space->q[0], inner = space->q[1];
  ph_cplx first = ph_cplx_mul(w[0], w[0]), second = ph_cplx_mul(w[0], w[1]);
  ph_cplx fourth = ph_cplx_mul(w[1], w[2]), fifth = ph_cplx_mul(w[2], w[2]);
  ph_cplx a = ph_cplx_add(start, ph_cplx_scale(outer, first));
  ph_cplx b = ph_cplx_add(a, ph_cplx_scale(inner, second));
  ph_cplx d = ph_cplx_sub(end, ph_cplx_scale(outer, fifth));
  ph_cplx c = ph_cplx_sub(d, ph_cplx_scale(inner, fourth));
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

double ph_ph2_rotation(const struct ph_atph *space, const ph_cplx w[3]) {
  /*
   * (1) w(u) = w0 S0^2 + 2 m S0 S1 + w2 S1^2,  m = c w1.
   * (2) With d = sqrt(m^2 - w0 w2), signed so that q = m + d does not cancel:
   *     q w(u) = (q S0 + w2 S1) (w0 S0 + q S1),  as w0 w2 + q^2 = 2 m q.
   *     Tested by t_ph2.c: factorisation.
   */
  ph_cplx m = ph_cplx_scale(space->c, w[1]);
  ph_cplx d =
      ph_cplx_sqrt(ph_cplx_sub(ph_cplx_mul(m, m), ph_cplx_mul(w[0], w[2])));
  ph_cplx q = ph_cplx_dot(m, d) >= 0 ? ph_cplx_add(m, d) : ph_cplx_sub(m, d);
  return 2 * (angle_between(q, w[2]) + angle_between(w[0], q));
}
