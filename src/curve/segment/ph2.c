/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Planar PH quintic and ATPH segments (see ph2.h). */
#include "curve/segment/ph2.h"

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
