/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Points, curvature, parts and rotation of planar segments. */
#include "unit.h"
#include "planar_unit.h"
#include "segment_unit.h"
#include "tc_curve_unit.h"

#include "curve/segment/seg2.h"

enum { SEGMENTS = 200, PANELS = 16 };

/* The integral of w^2 over [0,u], in panels. */
static ph_cplx integral(const struct ph_seg2 *seg, double u) {
  ph_cplx sum = ph_cplx_of(0, 0);
  for (size_t i = 0; i < PANELS; i++) {
    for (size_t j = 0; j < unit_quad(20)->n; j++) {
      ph_cplx w =
          unit_seg2_w(seg, u * ((double)i + unit_quad(20)->node[j]) / PANELS);
      sum =
          ph_cplx_add(sum, ph_cplx_scale(u * unit_quad(20)->weight[j] / PANELS,
                                         ph_cplx_mul(w, w)));
    }
  }
  return sum;
}

PH_TEST(test_point) {
  struct unit_random r = unit_random_of(500);
  for (size_t n = 0; n < SEGMENTS; n++) {
    struct ph_seg2 seg = unit_seg2_random(&r);
    double u = unit_random_in(&r, 0, 1);
    ck_cplx(ph_seg2_point(&seg, unit_quad(12), u), integral(&seg, u), 2e-13);
    ck_cplx(ph_seg2_point(&seg, unit_quad(12), 0), seg.start, 0);
    ck_cplx(ph_seg2_point(&seg, unit_quad(12), 1), seg.end, 0);
  }
}

/* Speed and tangent from w itself, curvature and its slope from differences of
 * the tangent's direction and of the curvature. */
PH_TEST(test_bend) {
  struct unit_random r = unit_random_of(501);
  const double step = 1e-4;
  for (size_t n = 0; n < SEGMENTS; n++) {
    struct ph_seg2 seg = unit_seg2_random(&r);
    double u = unit_random_in(&r, 0.1, 0.9);
    struct ph_curvature bend = ph_seg2_curvature(&seg, u);
    struct ph_curvature left = ph_seg2_curvature(&seg, u - step);
    struct ph_curvature right = ph_seg2_curvature(&seg, u + step);
    ph_cplx w = unit_seg2_w(&seg, u);
    double turn = atan2(ph_cplx_cross(left.tangent, right.tangent),
                        ph_cplx_dot(left.tangent, right.tangent));
    if (bend.speed < 0.05) {
      continue; /* differences would be rough there */
    }
    ck_rel(bend.speed, ph_cplx_norm2(w), 1e-12);
    ck_cplx(ph_cplx_scale(bend.speed, bend.tangent), ph_cplx_mul(w, w), 1e-12);
    ck_abs(ph_cplx_norm2(bend.tangent), 1, 1e-14);
    ck_abs(turn / (2 * step * bend.speed), bend.curvature,
           1e-4 * (1 + sqrt(bend.terms[0])));
    ck_abs((right.curvature - left.curvature) / (2 * step), bend.rate,
           1e-3 * (1 + sqrt(bend.terms[1])));
    ck_assert_double_le(pow(bend.curvature, 2), bend.terms[0] * (1 + 1e-14));
    ck_assert_double_le(pow(bend.rate, 2), bend.terms[1] * (1 + 1e-14));
  }
}

/* A part is the same curve: points, curvature, and speed times its share. */
PH_TEST(test_part) {
  struct unit_random r = unit_random_of(502);
  for (size_t n = 0; n < SEGMENTS; n++) {
    struct ph_seg2 seg = unit_seg2_random(&r);
    double u0 = unit_random_in(&r, 0, 0.5), u1 = unit_random_in(&r, 0.6, 1);
    struct ph_seg2 part = unit_seg2_part(&seg, unit_quad(12), u0, u1);
    ck_rel(part.space.angle, seg.space.angle * (u1 - u0), 1e-14);
    for (size_t i = 0; i <= 8; i++) {
      double x = (double)i / 8, u = u0 + x * (u1 - u0);
      struct ph_curvature a = ph_seg2_curvature(&part, x),
                          b = ph_seg2_curvature(&seg, u);
      ck_cplx(ph_seg2_point(&part, unit_quad(12), x),
              ph_seg2_point(&seg, unit_quad(12), u), 1e-13);
      ck_abs(a.speed, b.speed * (u1 - u0), 1e-12);
      ck_abs(a.curvature, b.curvature, 1e-11 * (1 + sqrt(b.terms[0])));
    }
  }
}

/* The turn of w^2 between neighbours of many points: exact for the whole but
 * for rounding, and for the absolute turn but for the pieces that hold an
 * inflection. */
static double turn(const struct ph_seg2 *seg, double *absolute) {
  enum { STEPS = 20000 };
  double sum = 0;
  ph_cplx w = unit_seg2_w(seg, 0);
  *absolute = 0;
  for (size_t i = 1; i <= STEPS; i++) {
    ph_cplx next = unit_seg2_w(seg, (double)i / STEPS);
    double step = 2 * atan2(ph_cplx_cross(w, next), ph_cplx_dot(w, next));
    sum += step;
    *absolute += fabs(step);
    w = next;
  }
  return sum;
}

PH_TEST(test_rotation) {
  struct unit_random r = unit_random_of(503);
  size_t loops = 0, inflected = 0, segments = (size_t)unit_count(SEGMENTS);
  for (size_t n = 0; n < segments; n++) {
    struct ph_seg2 seg = unit_seg2_random(&r);
    double absolute, wanted_absolute, wanted = turn(&seg, &wanted_absolute);
    double rotation = ph_seg2_rotation(&seg, &absolute);
    ck_abs(rotation, wanted, 1e-9);
    ck_abs(absolute, wanted_absolute, 1e-4);
    ck_assert_double_ge(absolute, fabs(rotation) - 1e-12);
    ck_rel(ph_seg2_rotation(&seg, NULL), rotation, 0);
    loops += fabs(rotation) > 3.2;
    inflected += absolute > fabs(rotation) + 1e-3;
  }
  ck_assert_uint_ge(loops, segments / 20);
  ck_assert_uint_ge(inflected, segments / 20);
}

/* A curve writes its preimage by t, the segment has it by u. */
PH_TEST(test_of_curve) {
  struct unit_random r = unit_random_of(504);
  for (size_t n = 0; n < SEGMENTS; n++) {
    struct ph_seg2 seg = unit_seg2_random(&r), again;
    struct unit_segments s;
    unit_seg2_curve(&seg, 1, &s);
    again = ph_seg2_of(&s.curve, 0);
    ck_rel(again.space.angle, seg.space.angle, 0);
    for (size_t i = 0; i < 3; i++) {
      ck_cplx(again.w[i], seg.w[i], 1e-14);
    }
    ck_cplx(again.start, seg.start, 0);
    ck_cplx(again.end, seg.end, 0);
  }
}

/* Of a cubic the preimage has three coefficients too: speed, curvature and
 * rotation are those of the linear one. */
PH_TEST(test_of_cubics) {
  struct unit_random r = unit_random_of(505);
  for (size_t n = 0; n < SEGMENTS; n++) {
    const double scale = n % 4 ? 1 : 1e150;
    const size_t k = n % 3;
    struct unit_cubics c;
    struct ph_seg2 seg;
    struct ph_curvature bend;
    double u = unit_random_in(&r, 0, 1), absolute, turned;
    ph_cplx w, w0, w1;
    unit_cubics_random(&c, &r, 3, scale, unit_random_cplx(&r, scale));
    seg = ph_seg2_of(&c.curve, k);
    w0 = unit_preimage(&c.curve, k, 0, 0);
    w1 = unit_preimage(&c.curve, k, 0, 1);
    w = unit_preimage(&c.curve, k, 0, u);
    ck_abs(seg.space.angle, 0, 0);
    ck_cplx(seg.w[0], w0, 0);
    ck_cplx(seg.w[2], w1, 0);
    ck_cplx(seg.start, unit_curve(&c.curve, k, 0, 0), 0);
    ck_cplx(seg.end, unit_curve(&c.curve, k, 0, 1), 0);
    ck_cplx(ph_seg2_point(&seg, unit_quad(12), u),
            unit_curve(&c.curve, k, 0, u), 4e-15 * scale);
    bend = ph_seg2_curvature(&seg, u);
    ck_abs(bend.speed, ph_cplx_norm2(w), 4e-15 * scale);
    ck_abs(bend.curvature * bend.speed * bend.speed / scale,
           2 * unit_cubic_bend(&c, k) / scale, 2e-14);
    turned = 2 * atan2(ph_cplx_cross(w0, w1), ph_cplx_dot(w0, w1));
    ck_abs(ph_seg2_rotation(&seg, &absolute), turned, 2e-15);
    ck_abs(absolute, fabs(turned), 2e-15);
  }
}
