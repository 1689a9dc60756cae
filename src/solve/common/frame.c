/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The free phase of preimages (see frame.h). */
#include "solve/common/frame.h"

#include <math.h>

/* A tangent within this of vertical has no left. */
static const double VERTICAL = 1e-8;

/* (re + im i) / |.|, or 1. */
static ph_cplx direction(double re, double im) {
  double size = sqrt(re * re + im * im), per_size = 1 / size;
  return size > 0 ? ph_cplx_of(re * per_size, im * per_size) : ph_cplx_of(1, 0);
}

/* a at a size at which its products can be taken. */
static ph_quat sized(ph_quat a) {
  double size = fmax(fmax(fabs(a.u), fabs(a.v)), fmax(fabs(a.p), fabs(a.q)));
  return size > 0 ? ph_quat_of(a.u / size, a.v / size, a.p / size, a.q / size)
                  : a;
}

ph_cplx ph_frame_upright(ph_quat preimage) {
  ph_quat a = sized(preimage);
  ph_vec3 e1 = ph_vec3_unit(ph_quat_i(a, a));
  ph_vec3 e2 = ph_quat_j(a, a), e3 = ph_quat_k(a, a);
  /* A exp(x i) has e3 cos 2x - e2 sin 2x in the place of e3. */
  ph_cplx twice = e1.x * e1.x + e1.y * e1.y > VERTICAL * VERTICAL
                      ? direction(e3.z, -e2.z)
                      : direction(e3.x, -e2.x);
  return ph_cplx_sqrt(twice);
}

/* Both turn i to the same tangent: conj(A) before is a complex number. */
ph_cplx ph_frame_follow(ph_quat a, ph_quat before) {
  ph_quat e = ph_quat_between(sized(a), sized(before));
  return direction(e.u, e.v);
}

double ph_frame_turn(const struct ph_curve *curve, ph_quat end) {
  const double *a = curve->preimage.v;
  ph_quat start = ph_quat_of(a[0], a[1], a[2], a[3]);
  ph_cplx half = ph_frame_follow(start, end);
  ph_cplx whole = ph_cplx_mul(half, half);
  return atan2(whole.im, whole.re) + 0.0; /* no -0 */
}
