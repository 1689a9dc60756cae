/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Places on offsets: of curves whose offsets are known in closed form, and of
 * curves by chance against definitions and quadrature.
 */
#include "adapt_unit.h"
#include "curve_unit.h"
#include "segment_unit.h"
#include "tc_curve_unit.h"
#include "unit.h"

#include "curve/offset/cusp.h"
#include "curve/segment/seg2.h"

enum { STEPS = 24, CURVES = 200 };

/* The offset with its cusps, for samplers. */
static struct ph_offset offset_of(const struct ph_curve *curve, double distance,
                                  enum ph_normal normal) {
  struct ph_offset offset = {.distance = distance, .dimension = 3};
  struct ph_diag diag;
  offset.dimension = curve->dimension;
  offset.vector = curve->dimension == 2 ? NULL : normal == PH_E2 ? "e2" : "e3";
  ck_assert_int_eq(
      ph_cusps_of(curve, distance, normal, &unit_arena, &offset.cusps, &diag),
      PH_OK);
  return offset;
}

/* ---- known offsets ------------------------------------------------------- */

/* Circles about the center (0, radius): of radius - d, beyond it reversed. */
PH_TEST(test_circle) {
  static const double angles[] = {0.1, 1, 2, 3, 3.1};
  static const double distances[] = {-20, -1, -1e-6, 0.3, 2.9, 3.1, 50};
  const double radius = 3;
  for (size_t n = 0; n < 35; n++) {
    const double angle = angles[n % 5], d = distances[n / 5], rest = radius - d;
    const double size = radius + fabs(d);
    struct unit_segments c;
    struct ph_sampler sampler;
    struct ph_offset offset;
    unit_circle(angle, radius, &c);
    offset = offset_of(&c.curve, d, PH_E2);
    ck_assert_uint_eq(offset.cusps.n, 0);
    sampler = unit_sampler(&c.curve, &offset, 0);
    ck_abs(sampler.length, 2 * angle * fabs(rest), 4e-15 * angle * size);
    for (int i = 0; i <= STEPS; i++) {
      double u = (double)i / STEPS, turn = 2 * angle * u, speed;
      double s = ph_sampler_length(&sampler, u, &speed);
      struct ph_sample at = ph_sampler_at(&sampler, u);
      ph_vec3 t = ph_vec3_of(cos(turn), sin(turn), 0);
      ck_abs(s, turn * fabs(rest), 4e-15 * angle * size);
      ck_abs(speed, 2 * angle * fabs(rest), 2e-14 * size);
      ck_vec3(at.point,
              ph_vec3_of(rest * sin(turn), radius - rest * cos(turn), 0),
              4e-15 * size);
      ck_vec3(at.tangent, ph_vec3_scale(rest > 0 ? 1 : -1, t), 4e-15);
      ck_rel(at.curvature, 1 / fabs(rest), 4e-13 * size / fabs(rest));
    }
    ph_arena_reset(&unit_arena);
  }
}

PH_TEST(test_line) {
  const ph_cplx w[3] = {{2, 0}, {3, 0}, {2, 0}};
  struct ph_seg2 seg = unit_seg2(0, w);
  struct unit_segments c;
  struct ph_offset offset;
  struct ph_sampler curve, moved;
  unit_seg2_curve(&seg, 1, &c);
  c.lengths[0] = seg.end.re;
  offset = offset_of(&c.curve, -0.75, PH_E2);
  curve = unit_sampler(&c.curve, NULL, 0);
  moved = unit_sampler(&c.curve, &offset, 0);
  ck_rel(moved.length, seg.end.re, 4e-16);
  for (int i = 0; i <= STEPS; i++) {
    double u = (double)i / STEPS;
    struct ph_sample at = ph_sampler_at(&moved, u);
    ck_rel(unit_length(&moved, u), unit_length(&curve, u), 1e-15);
    ck_abs(at.point.x, ph_sampler_at(&curve, u).point.x, 0);
    ck_abs(at.point.y, -0.75, 0);
    ck_vec3(at.tangent, ph_vec3_of(1, 0, 0), 0);
    ck_abs(at.curvature, 0, 0);
  }
}

/* The frame turns about z as the helix does: so do e2 and e3, and the offsets
 * are helices of other radii that climb as much. */
PH_TEST(test_helix) {
  static const double angles[] = {0.3, 1, 2, 3};
  for (size_t n = 0; n < 16; n++) {
    const struct unit_helix h = {angles[n % 4], 0.7, 0.4};
    const enum ph_normal normal = n % 8 < 4 ? PH_E2 : PH_E3;
    const double d = n < 8 ? 0.3 : -2;
    const ph_quat a0 = unit_helix_preimage(&h);
    const ph_vec3 e = ph_vec3_scale(1 / ph_quat_dot(a0, a0),
                                    ph_normal_between(normal, a0, a0));
    const double x = d * e.x, y = d * e.y - h.a, radius = hypot(x, y);
    const double before = atan2(x, -y), squares = radius * radius + h.b * h.b;
    struct unit_curve3 c;
    struct ph_offset offset;
    struct ph_sampler sampler;
    unit_helix_curve(&h, &c);
    offset = offset_of(&c.curve, d, normal);
    sampler = unit_sampler(&c.curve, &offset, 0);
    for (int i = 0; i <= STEPS; i++) {
      double u = (double)i / STEPS, turn = 2 * h.alpha * u + before;
      struct ph_sample at = ph_sampler_at(&sampler, u);
      ph_vec3 point = unit_helix_at(&h, u, radius, before);
      ph_vec3 t = ph_vec3_of(radius * cos(turn), radius * sin(turn), h.b);
      point.z += d * e.z;
      ck_vec3(at.point, point, 2e-14);
      ck_vec3(at.tangent, ph_vec3_unit(t), 4e-15);
      ck_rel(at.curvature, radius / squares, 1e-12 / (h.alpha * h.alpha));
      ck_rel(at.torsion, h.b / squares, 1e-12 / (h.alpha * h.alpha));
      ck_rel(unit_length(&sampler, u), 2 * h.alpha * u * sqrt(squares), 2e-14);
    }
  }
}

/* ---- by definition ------------------------------------------------------- */

/* At the distance, square to the tangent of the curve; in the plane along it,
 * or, between cusps, against it. */
static void ck_place(const struct ph_sampler *curve,
                     const struct ph_sampler *moved, double u) {
  const double d = moved->offset->distance;
  const struct ph_sample r = ph_sampler_at(curve, u);
  const struct ph_sample o = ph_sampler_at(moved, u);
  const ph_vec3 leg = ph_vec3_sub(o.point, r.point);
  const double rounding = 1e-15 * (ph_vec3_abs(r.point) + fabs(d));
  ck_abs(ph_vec3_abs(leg), fabs(d), 1e-12 * fabs(d) + rounding);
  ck_abs(ph_vec3_dot(leg, r.tangent), 0, 1e-13 * fabs(d) + rounding);
  ck_abs(ph_vec3_abs(o.tangent), 1, 1e-14);
  if (curve->curve->dimension == 2) {
    double way = 1 - d * r.curvature;
    ck_abs(ph_vec3_dot(leg, ph_vec3_of(-r.tangent.y, r.tangent.x, 0)), d,
           1e-12 * fabs(d) + rounding);
    if (fabs(way) > 1e-9 * (1 + fabs(d * r.curvature))) {
      ck_vec3(o.tangent, ph_vec3_scale(way > 0 ? 1 : -1, r.tangent), 1e-14);
      ck_rel(o.curvature, r.curvature / fabs(way),
             1e-11 * (1 + fabs(d * r.curvature)) / fabs(way));
    }
  }
}

/* |o'| from the preimage by quaternion products: e = A n A* / sigma. */
struct moved {
  const struct ph_curve *curve;
  size_t k;
  double distance;
  enum ph_normal normal;
};

static double speed_at(const void *context, double u) {
  const struct moved *m = context;
  const struct ph_seg3 seg = ph_seg3_of(m->curve, m->k);
  const ph_quat n =
      m->normal == PH_E2 ? ph_quat_of(0, 0, 1, 0) : ph_quat_of(0, 0, 0, 1);
  ph_quat a[2];
  ph_vec3 r1, n1, e;
  double s, s1;
  ph_seg3_jet(&seg, u, a, 2);
  s = ph_quat_dot(a[0], a[0]);
  s1 = 2 * ph_quat_dot(a[0], a[1]);
  r1 = unit_turned(a[0], ph_quat_of(0, 1, 0, 0));
  e = ph_vec3_scale(1 / s, unit_turned(a[0], n));
  n1 = ph_quat_vector(ph_quat_mul(ph_quat_mul(a[1], n), ph_quat_conj(a[0])));
  n1 = ph_vec3_add(n1, ph_quat_vector(ph_quat_mul(ph_quat_mul(a[0], n),
                                                  ph_quat_conj(a[1]))));
  n1 = ph_vec3_scale(1 / s, ph_vec3_along(n1, -s1, e));
  return ph_vec3_abs(ph_vec3_along(r1, m->distance, n1));
}

/* The integral of |o'| over [u,v], cut at the cusps on segment k. */
static double quadrature(const struct moved *m, const struct ph_cusps *cusps,
                         double u, double v, double tolerance) {
  struct ph_quad rule;
  double sum = 0;
  ck_assert(ph_quad_gauss(&rule, 20));
  for (size_t i = 0; i < cusps->n; i++) {
    double cusp = cusps->at[i].u;
    if (cusps->at[i].segment == m->k && cusp > u && cusp < v) {
      sum += unit_adapt(&rule, speed_at, m, u, cusp, tolerance, 1e-15);
      u = cusp;
    }
  }
  return sum + unit_adapt(&rule, speed_at, m, u, v, tolerance, 1e-15);
}

/* Lengths increase from 0 to that of the segment, as |o'| says. */
static void ck_lengths(const struct ph_sampler *moved, enum ph_normal normal) {
  const struct moved m = {moved->curve, moved->k, moved->offset->distance,
                          normal};
  const struct ph_cusps *cusps = &moved->offset->cusps;
  const double scale = moved->curve->lengths[moved->k] + moved->length;
  double before = 0, at = 0, sum = 0, speed;
  ck_abs(unit_length(moved, 0), 0, 0);
  ck_abs(unit_length(moved, 1), moved->length, 0);
  for (int i = 1; i <= STEPS; i++) {
    double u = (double)i / STEPS;
    double s = ph_sampler_length(moved, u, &speed);
    ck_assert(s > before);
    sum += quadrature(&m, cusps, at, u, 1e-15 * scale);
    ck_abs(s, sum, 1e-13 * scale);
    ck_rel(speed, speed_at(&m, u), 1e-11 * (1 + scale / speed));
    before = s;
    at = u;
  }
}

/* ---- in the plane -------------------------------------------------------- */

/* Quadrature of |o'| needs a speed that is not nearly 0: what the curve's own
 * bends are there is in doubt by as much as in its offset. */
static bool slow(const struct ph_curve *curve, size_t k) {
  const struct ph_seg3 seg = ph_seg3_of(curve, k);
  double least = (double)INFINITY, most = 0;
  for (int i = 0; i <= 200; i++) {
    double speed = unit_seg3_bend(&seg, i / 200.0).speed;
    least = fmin(least, speed);
    most = fmax(most, speed);
  }
  return least < 1e-3 * most;
}

PH_TEST(test_plane) {
  struct unit_random r = unit_random_of(1400);
  size_t several = 0, turning = 0;
  for (int n = 0; n < unit_count(CURVES); n++) {
    struct ph_seg2 seg = unit_seg2_random(&r);
    struct unit_segments c;
    struct ph_offset offset;
    struct ph_sampler curve, moved;
    unit_seg2_curve(&seg, 1, &c);
    c.lengths[0] = ph_seg2_length(&seg.space, seg.w);
    offset = offset_of(&c.curve, unit_random_in(&r, -2, 2), PH_E2);
    curve = unit_sampler(&c.curve, NULL, 0);
    moved = unit_sampler(&c.curve, &offset, 0);
    for (int i = 0; i <= STEPS; i++) {
      ck_place(&curve, &moved, (double)i / STEPS);
    }
    if (!slow(&c.curve, 0)) {
      ck_lengths(&moved, PH_E2);
      several += offset.cusps.n > 1;
      turning += fabs(ph_seg2_rotation(&seg, NULL)) > 3.5;
    }
    ph_arena_reset(&unit_arena);
  }
  ck_assert_uint_ge(several, (size_t)unit_count(CURVES) / 20);
  ck_assert_uint_ge(turning, (size_t)unit_count(CURVES) / 20);
}

/* Cubics with a loop turn by nearly a whole turn next to their vertex, others
 * by more than half of one in each half. */
PH_TEST(test_turns) {
  static const double gaps[] = {0.3, 0.05, 0.01};
  static const double places[] = {0.1, 0.25, 0.5, 0.8};
  for (size_t n = 0; n < 24; n++) {
    const double gap = n % 2 ? gaps[n / 8] : -gaps[n / 8];
    const double x0 = places[n / 2 % 4];
    /* (x - x0 + i gap) (x - 0.3 + 2 i gap): turns twice by almost pi */
    const ph_cplx f[2] = {{-x0, gap}, {1 - x0, gap}};
    const ph_cplx g[2] = {{-0.3, 2 * gap}, {0.7, 2 * gap}};
    const ph_cplx w[3] = {
        ph_cplx_mul(f[0], g[0]),
        ph_cplx_scale(
            0.5, ph_cplx_add(ph_cplx_mul(f[0], g[1]), ph_cplx_mul(f[1], g[0]))),
        ph_cplx_mul(f[1], g[1])};
    const double d = n / 2 % 2 ? 0.01 : -0.02;
    struct ph_seg2 seg = unit_seg2(0, w);
    struct unit_segments c;
    struct ph_offset offset;
    struct ph_sampler moved;
    struct moved m = {&c.curve, 0, d, PH_E2};
    double length;
    unit_seg2_curve(&seg, 1, &c);
    c.lengths[0] = ph_seg2_length(&seg.space, seg.w);
    ck_assert(fabs(ph_seg2_rotation(&seg, NULL)) > 4);
    offset = offset_of(&c.curve, d, PH_E2);
    moved = unit_sampler(&c.curve, &offset, 0);
    for (int i = 1; i <= STEPS; i++) {
      double u = (double)i / STEPS;
      length = quadrature(&m, &offset.cusps, 0, u, 1e-15);
      ck_rel(unit_length(&moved, u), length, 1e-13);
    }
    ph_arena_reset(&unit_arena);
  }
}

/* At a cusp there is no curvature, and the tangent is that of what follows. The
 * curve w = 1 + v i, v in [-1,1], has the curvature 4 / |w|^4. */
PH_TEST(test_at_cusp) {
  const ph_cplx w[3] = {{1, -1}, {1, 0}, {1, 1}};
  struct ph_seg2 seg = unit_seg2(0, w);
  struct unit_segments c;
  struct ph_offset offset;
  struct ph_sampler curve, moved;
  unit_seg2_curve(&seg, 1, &c);
  c.lengths[0] = ph_seg2_length(&seg.space, seg.w);
  offset = offset_of(&c.curve, 0.5, PH_E2);
  ck_assert_uint_eq(offset.cusps.n, 2);
  curve = unit_sampler(&c.curve, NULL, 0);
  moved = unit_sampler(&c.curve, &offset, 0);
  for (size_t i = 0; i < 2; i++) {
    const double u = offset.cusps.at[i].u, way = i == 0 ? -1 : 1;
    ph_vec3 t = ph_sampler_at(&curve, u).tangent;
    struct ph_sample at = ph_sampler_at(&moved, u), near;
    ck_vec3(at.tangent, ph_vec3_scale(way, t), 1e-15);
    ck_assert(isnan(at.curvature));
    near = ph_sampler_at(&moved, u - 1e-9);
    ck_vec3(near.tangent, ph_vec3_scale(-way, t), 1e-8);
    near = ph_sampler_at(&moved, u + 1e-9);
    ck_vec3(near.tangent, ph_vec3_scale(way, t), 1e-8);
    ck_assert(near.curvature > 1e6);
  }
}

/* Cubics at any size, entered in any order, and where one cusp is at a joint.
 */
PH_TEST(test_cubics) {
  static const double scales[] = {1, 1e-150, 1e150};
  struct unit_random r = unit_random_of(1401);
  for (int n = 0; n < unit_count(CURVES) / 2; n++) {
    const double scale = scales[n % 3];
    struct unit_cubics c, one;
    struct ph_offset offset, alone;
    unit_cubics_random(&c, &r, 3, scale, unit_random_cplx(&r, scale));
    offset = offset_of(&c.curve, scale * unit_random_in(&r, -2, 2), PH_E2);
    for (size_t i = 0; i < 3; i++) {
      const size_t k = 2 - i;
      struct ph_sampler curve = unit_sampler(&c.curve, NULL, k);
      struct ph_sampler moved = unit_sampler(&c.curve, &offset, k);
      struct ph_sampler single;
      const double *w = c.preimage + 4 * k;
      for (int j = 0; scale < 2 && scale > 0.5 && j <= STEPS; j++) {
        ck_place(&curve, &moved, (double)j / STEPS);
      }
      unit_cubics_begin(&one, ph_cplx_of(0, 0));
      unit_cubics_add(&one, ph_cplx_of(w[0], w[1]), ph_cplx_of(w[2], w[3]));
      alone = offset_of(&one.curve, offset.distance, PH_E2);
      single = unit_sampler(&one.curve, &alone, 0);
      ck_rel(moved.length, single.length, 0);
      ck_assert(isfinite(moved.length));
      ck_abs(unit_length(&moved, 0.3), unit_length(&single, 0.3), 0);
    }
    ph_arena_reset(&unit_arena);
  }
}

/* A cusp at the joint of a closed curve is the last of them, on segment 0. */
PH_TEST(test_closed) {
  const ph_cplx w[3] = {{1, -1}, {1, 0}, {1, 1}};
  struct ph_seg2 seg[2] = {unit_seg2(0, w), unit_seg2(0, w)};
  struct unit_segments c;
  struct ph_offset offset, without;
  struct ph_sampler moved, plain;
  struct ph_place at[5];
  unit_seg2_curve(seg, 2, &c);
  c.lengths[0] = c.lengths[1] = ph_seg2_length(&seg[0].space, seg[0].w);
  without = offset = offset_of(&c.curve, 0.5, PH_E2);
  ck_assert_uint_eq(offset.cusps.n, 4);
  for (size_t i = 0; i < 4; i++) {
    at[i] = offset.cusps.at[i];
  }
  at[4] = (struct ph_place){0, 0, 0};
  offset.cusps.at = at;
  offset.cusps.n = 5;
  for (size_t k = 0; k < 2; k++) {
    moved = unit_sampler(&c.curve, &offset, k);
    plain = unit_sampler(&c.curve, &without, k);
    ck_abs(moved.length, plain.length, 0);
    ck_abs(unit_length(&moved, 0.6), unit_length(&plain, 0.6), 0);
  }
}

/* ---- in space ------------------------------------------------------------ */

/* Curvature and torsion from differences of tangents T at u -+ h, -+ 2h: with
 * respect to the length, T' = kappa N, [T, T', T''] = kappa^2 tau. */
static void ck_bend(const struct ph_sampler *sampler, double u, double tol) {
  const struct ph_sample at = ph_sampler_at(sampler, u);
  double h, speed[3], slope, square;
  ph_vec3 t[5], d1, d2;
  ph_sampler_length(sampler, u, &speed[1]);
  h = 2e-3 / (1 + speed[1] * at.curvature); /* so that it turns little */
  for (size_t i = 0; i < 5; i++) {
    t[i] = ph_sampler_at(sampler, u + ((double)i - 2) * h).tangent;
  }
  for (size_t i = 0; i < 3; i++) {
    ph_sampler_length(sampler, u + ((double)i - 1) * h, &speed[i]);
  }
  slope = (speed[2] - speed[0]) / (2 * h);
  d1 = ph_vec3_sub(ph_vec3_scale(8, ph_vec3_sub(t[3], t[1])),
                   ph_vec3_sub(t[4], t[0]));
  d1 = ph_vec3_scale(1 / (12 * h * speed[1]), d1);
  d2 = ph_vec3_sub(
      ph_vec3_scale(16, ph_vec3_add(t[3], t[1])),
      ph_vec3_add(ph_vec3_add(t[4], t[0]), ph_vec3_scale(30, t[2])));
  d2 = ph_vec3_along(ph_vec3_scale(1 / (12 * h * h), d2), -slope, d1);
  d2 = ph_vec3_scale(1 / (speed[1] * speed[1]), d2);
  square = ph_vec3_dot(d1, d1);
  ck_rel(at.curvature * at.curvature, square, tol);
  ck_abs(at.torsion * square, ph_vec3_triple(t[2], d1, d2),
         tol * (1 + fabs(at.torsion * square)));
}

PH_TEST(test_space) {
  struct unit_random r = unit_random_of(1402);
  for (int n = 0; n < unit_count(CURVES) / 2; n++) {
    const enum ph_normal normal = n % 2 ? PH_E2 : PH_E3;
    struct unit_curve3 c;
    struct ph_offset offset;
    struct ph_sampler curve, moved;
    unit_curve3_random(&c, 2, n % 3 != 0, 0.5, &r);
    offset = offset_of(&c.curve, unit_random_in(&r, -0.3, 0.3), normal);
    for (size_t k = 0; k < 2; k++) {
      curve = unit_sampler(&c.curve, NULL, k);
      moved = unit_sampler(&c.curve, &offset, k);
      for (int i = 0; i <= STEPS; i++) {
        double u = (double)i / STEPS;
        ck_place(&curve, &moved, u);
        ck_vec3(ph_sampler_at(&moved, u).point,
                unit_curve3_moved(&c.curve, k, u, offset.distance, normal),
                2e-13);
      }
      ck_lengths(&moved, normal);
      ck_bend(&moved, unit_random_in(&r, 0.01, 0.99), 1e-5);
    }
    ph_arena_reset(&unit_arena);
  }
}

/* From some distance on, the offset is that of the vector alone, times the
 * distance: at any that is written, and beside curves of any size. */
PH_TEST(test_far) {
  static const int far[] = {400, 600, 1000};
  struct unit_random r = unit_random_of(1407);
  for (size_t n = 0; n < 24; n++) {
    const enum ph_normal normal = n % 2 ? PH_E2 : PH_E3;
    const int size = n % 3 == 2 ? 0 : -60 * (int)(n / 3);
    const double near_by = ldexp(1, 70), away = ldexp(1, far[n % 3] + size);
    const double grow = away / near_by;
    struct unit_curve3 c;
    struct ph_offset offset[2];
    struct ph_sampler moved[2];
    unit_curve3_random(&c, 1, n % 4 != 0, 0.5, &r);
    for (size_t i = 0; i < 2; i++) {
      offset[i] = offset_of(&c.curve, i ? away : near_by, normal);
      moved[i] = unit_sampler(&c.curve, &offset[i], 0);
      for (size_t j = 0; i == 0 && j < 12; j++) { /* now a smaller curve */
        c.preimage[j] = ldexp(c.preimage[j], size / 2);
      }
    }
    ck_rel(moved[1].length, grow * moved[0].length, 1e-13);
    for (int i = 0; i <= STEPS; i++) {
      const double u = (double)i / STEPS;
      struct ph_sample a = ph_sampler_at(&moved[0], u);
      struct ph_sample b = ph_sampler_at(&moved[1], u);
      ck_vec3(b.tangent, a.tangent, 1e-12);
      ck_rel(grow * b.curvature, a.curvature, 1e-12);
      ck_abs(grow * b.torsion, a.torsion,
             1e-10 * (fabs(a.torsion) + a.curvature));
      ck_rel(unit_length(&moved[1], u), grow * unit_length(&moved[0], u),
             1e-13);
    }
    ph_arena_reset(&unit_arena);
  }
}

/* Near to where a curve nearly stands still, and at distances at which the
 * offset nearly does. */
PH_TEST(test_wild) {
  struct unit_random r = unit_random_of(1403);
  size_t some = 0;
  for (int n = 0; n < unit_count(CURVES) / 4; n++) {
    const enum ph_normal normal = n % 2 ? PH_E2 : PH_E3;
    struct unit_curve3 c;
    struct ph_offset offset;
    struct ph_sampler moved;
    unit_curve3_random(&c, 1, n % 3 != 0, 1.5, &r);
    offset = offset_of(&c.curve, unit_random_in(&r, -2, 2), normal);
    moved = unit_sampler(&c.curve, &offset, 0);
    if (!slow(&c.curve, 0)) {
      ck_lengths(&moved, normal);
      some += offset.cusps.n > 0;
    }
    ph_arena_reset(&unit_arena);
  }
  ck_assert_uint_ge(some, (size_t)unit_count(CURVES) / 4 / 10);
}

/* A plane curve that is taken in space has the same offset along e2, cusps and
 * all; its curvature is without a sign. */
PH_TEST(test_plane_in_space) {
  struct unit_random r = unit_random_of(1404);
  for (int n = 0; n < unit_count(CURVES) / 4; n++) {
    const double alpha = unit_random_in(&r, 0.1, 3);
    struct ph_seg2 seg;
    struct unit_segments c;
    struct unit_curve3 c3;
    struct ph_offset offset, offset3;
    struct ph_sampler plane, space;
    ph_quat a[3];
    ph_cplx w[3];
    for (size_t i = 0; i < 3; i++) {
      ph_cplx z = unit_random_cplx(&r, 0.6);
      w[i] = ph_cplx_of(1 + z.re, z.im);
      a[i] = ph_quat_of(w[i].re, 0, 0, w[i].im);
    }
    seg = unit_seg2(alpha, w);
    unit_seg2_curve(&seg, 1, &c);
    c.lengths[0] = ph_seg2_length(&seg.space, seg.w);
    unit_curve3_of(&c3, 1, &alpha, a, ph_vec3_of(0, 0, 0));
    offset = offset_of(&c.curve, unit_random_in(&r, -2, 2), PH_E2);
    offset3 = offset_of(&c3.curve, offset.distance, PH_E2);
    plane = unit_sampler(&c.curve, &offset, 0);
    space = unit_sampler(&c3.curve, &offset3, 0);
    ck_rel(space.length, plane.length,
           1e-13 * (1 + c.lengths[0] / plane.length));
    for (int i = 0; i <= STEPS; i++) {
      double u = (double)i / STEPS;
      struct ph_sample p = ph_sampler_at(&plane, u);
      struct ph_sample s = ph_sampler_at(&space, u);
      ck_vec3(s.point, p.point, 1e-14);
      ck_vec3(s.tangent, p.tangent, 1e-14);
      ck_rel(s.curvature, fabs(p.curvature),
             1e-12 * (1 + fabs(offset.distance * p.curvature)));
      ck_abs(s.torsion, 0, 1e-9 * (1 + s.curvature));
    }
    ck_assert_uint_eq(offset3.cusps.n, offset.cusps.n);
    for (size_t i = 0; i < offset.cusps.n; i++) {
      double u = offset.cusps.at[i].u, u3 = offset3.cusps.at[i].u;
      struct ph_sample s = ph_sampler_at(&space, u3);
      ck_vec3(s.tangent, ph_sampler_at(&plane, u).tangent, 1e-12);
      ck_assert(isnan(s.curvature) && isnan(s.torsion));
    }
    ph_arena_reset(&unit_arena);
  }
}

/* A line in space, its frame turning or not, has a straight offset or one that
 * winds about it. */
PH_TEST(test_line_in_space) {
  const ph_quat a[3] = {
      {1, 0.5, 0.25, 2}, {1, 0.5, 0.25, 2}, {1, 0.5, 0.25, 2}};
  struct unit_curve3 c;
  struct ph_offset offset;
  struct ph_sampler moved;
  unit_curve3_of(&c, 1, NULL, a, ph_vec3_of(0, 0, 0));
  offset = offset_of(&c.curve, 0.5, PH_E3);
  moved = unit_sampler(&c.curve, &offset, 0);
  ck_rel(moved.length, c.lengths[0], 4e-16);
  for (int i = 0; i <= STEPS; i++) {
    struct ph_sample at = ph_sampler_at(&moved, (double)i / STEPS);
    ck_abs(at.curvature, 0, 1e-15);
    ck_assert(isnan(at.torsion));
  }
}
