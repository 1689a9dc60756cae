/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Planar segments for tests (see seg2_unit.h). */
#include "seg2_unit.h"
#include "unit.h"

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
