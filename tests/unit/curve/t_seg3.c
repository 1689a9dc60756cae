/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Points, curvature, torsion, frames and parts of spatial segments.
 *
 * Derivatives of the curve are formed here from those of A by products of
 * quaternions, those of A by differences; curvature and torsion by the formulas
 * for any curve:
 *
 *   kappa = |r' x r''| / |r'|^3,  tau = [r', r'', r'''] / |r' x r''|^2     (1)
 */
#include "unit.h"
#include "planar_unit.h"
#include "segment_unit.h"
#include "tc_curve_unit.h"

enum { SEGMENTS = 200 };

static const double PI = 3.14159265358979323846;

/* ---- derivatives ---------------------------------------------------- */

/* f'(u) from f at u - 2h, u - h, u + h, u + 2h: to h^4. */
static double difference(const double f[4], double h) {
  return (f[0] - 8 * f[1] + 8 * f[2] - f[3]) / (12 * h);
}

static const double STEPS[4] = {-2, -1, 1, 2};

/* Each derivative of A is the slope of the one before, and the first is A. */
PH_TEST(test_jet) {
  struct unit_random r = unit_random_of(930);
  const double h = 1e-3;
  for (size_t n = 0; n < SEGMENTS; n++) {
    struct ph_seg3 seg = unit_seg3_random(&r);
    double u = unit_random_in(&r, 0.01, 0.99);
    ph_quat jet[4], near[4][4], miss;
    ph_seg3_jet(&seg, u, jet, 4);
    miss = ph_quat_sub(jet[0], unit_seg3_preimage(&seg, u));
    ck_assert_double_le(ph_quat_abs(miss), 4e-15);
    for (size_t k = 0; k < 4; k++) {
      ph_seg3_jet(&seg, u + STEPS[k] * h, near[k], 4);
    }
    for (size_t d = 0; d < 3; d++) {
      double f[4][4];
      for (size_t k = 0; k < 4; k++) {
        f[0][k] = near[k][d].u;
        f[1][k] = near[k][d].v;
        f[2][k] = near[k][d].p;
        f[3][k] = near[k][d].q;
      }
      ck_abs(difference(f[0], h), jet[d + 1].u, 1e-9);
      ck_abs(difference(f[1], h), jet[d + 1].v, 1e-9);
      ck_abs(difference(f[2], h), jet[d + 1].p, 1e-9);
      ck_abs(difference(f[3], h), jet[d + 1].q, 1e-9);
    }
  }
}

/* vect(a i b*), by quaternion products alone. */
static ph_vec3 product(ph_quat a, ph_quat b) {
  return ph_quat_vector(
      ph_quat_mul(ph_quat_mul(a, ph_quat_of(0, 1, 0, 0)), ph_quat_conj(b)));
}

/* r', ..., r'''' at u, by Leibniz's unit_quad(12)-> */
static void derivatives(const struct ph_seg3 *seg, double u, ph_vec3 d[4]) {
  ph_quat a[4];
  ph_seg3_jet(seg, u, a, 4);
  d[0] = product(a[0], a[0]);
  d[1] = ph_vec3_scale(2, product(a[0], a[1]));
  d[2] = ph_vec3_scale(2, product(a[0], a[2]));
  d[2] = ph_vec3_along(d[2], 2, product(a[1], a[1]));
  d[3] = ph_vec3_scale(2, product(a[0], a[3]));
  d[3] = ph_vec3_along(d[3], 6, product(a[1], a[2]));
}

/* The same for PH quintics from their control points. */
PH_TEST(test_derivatives) {
  struct unit_random r = unit_random_of(931);
  for (size_t n = 0; n < SEGMENTS; n++) {
    struct ph_seg3 seg = unit_seg3_random(&r);
    double u = unit_random_in(&r, 0, 1);
    ph_vec3 p[6], q[6], d[4];
    seg = unit_seg3(0, seg.a, seg.start);
    ph_seg3_control_points(&seg.space, seg.a, seg.start, seg.end, p);
    derivatives(&seg, u, d);
    for (size_t order = 0; order <= 4; order++) {
      ph_vec3 wanted =
          order > 0 ? d[order - 1] : ph_seg3_point(&seg, unit_quad(12), u);
      size_t degree = 5;
      for (size_t i = 0; i < 6; i++) {
        q[i] = p[i];
      }
      for (; degree > 5 - order; degree--) {
        for (size_t i = 0; i < degree; i++) {
          q[i] = ph_vec3_scale((double)degree, ph_vec3_sub(q[i + 1], q[i]));
        }
      }
      for (; degree > 0; degree--) {
        for (size_t i = 0; i < degree; i++) {
          q[i] = ph_vec3_along(ph_vec3_scale(1 - u, q[i]), u, q[i + 1]);
        }
      }
      ck_assert_double_le(unit_apart(q[0], wanted),
                          1e-13 * pow(10, (double)order / 2));
    }
  }
}

/* Curvature, torsion and their slopes by the formulas for any curve, tau' by
 * the quotient unit_quad(12)-> */
struct bend {
  double curvature, torsion, slope, torsion_slope;
};

static struct bend bend_of(const ph_vec3 d[4]) {
  ph_vec3 normal = ph_vec3_cross(d[0], d[1]);
  double speed = ph_vec3_abs(d[0]), size = ph_vec3_abs(normal);
  double w = size * size, x = ph_vec3_dot(normal, d[2]);
  double half_w1 = ph_vec3_dot(normal, ph_vec3_cross(d[0], d[2]));
  double x1 = ph_vec3_dot(normal, d[3]);
  struct bend bend;
  bend.curvature = size / pow(speed, 3);
  bend.torsion = x / w;
  bend.slope = half_w1 / size / pow(speed, 3) -
               3 * bend.curvature * ph_vec3_dot(d[0], d[1]) / (speed * speed);
  bend.torsion_slope = (w * x1 - 2 * x * half_w1) / (w * w);
  return bend;
}

PH_TEST(test_bend) {
  struct unit_random r = unit_random_of(932);
  size_t compared = 0;
  for (size_t n = 0; n < SEGMENTS; n++) {
    struct ph_seg3 seg = unit_seg3_random(&r);
    double u = unit_random_in(&r, 0, 1);
    struct unit_bend3 bend = unit_seg3_bend(&seg, u);
    struct bend wanted;
    ph_vec3 d[4];
    derivatives(&seg, u, d);
    wanted = bend_of(d);
    ck_rel(bend.speed, ph_vec3_abs(d[0]), 1e-12);
    if (bend.speed > 0.1 && bend.curvature > 0.1) {
      ck_rel(bend.curvature, wanted.curvature, 1e-11);
      ck_abs(bend.torsion, wanted.torsion, 1e-9 * (1 + fabs(wanted.torsion)));
      ck_abs(bend.slope, wanted.slope, 1e-9 * (1 + fabs(wanted.slope)));
      ck_abs(bend.torsion_slope, wanted.torsion_slope,
             1e-7 * (1 + fabs(wanted.torsion_slope)));
      compared++;
    }
  }
  ck_assert_uint_ge(compared, SEGMENTS / 2);
}

/* The slopes once more, as what they are called. */
PH_TEST(test_slopes) {
  struct unit_random r = unit_random_of(933);
  const double h = 1e-4;
  size_t compared = 0;
  for (size_t n = 0; n < SEGMENTS; n++) {
    struct ph_seg3 seg = unit_seg3_random(&r);
    double u = unit_random_in(&r, 0.1, 0.9), f[4], g[4];
    struct unit_bend3 bend = unit_seg3_bend(&seg, u);
    for (size_t k = 0; k < 4; k++) {
      struct unit_bend3 near = unit_seg3_bend(&seg, u + STEPS[k] * h);
      f[k] = near.curvature;
      g[k] = near.torsion;
    }
    if (bend.speed > 0.5 && bend.curvature > 0.5) {
      ck_abs(difference(f, h), bend.slope, 1e-7 * (1 + fabs(bend.slope)));
      ck_abs(difference(g, h), bend.torsion_slope,
             1e-6 * (1 + fabs(bend.torsion_slope)));
      compared++;
    }
  }
  ck_assert_uint_ge(compared, SEGMENTS / 4);
}

/* ---- points and parts ----------------------------------------------- */

PH_TEST(test_point) {
  struct unit_random r = unit_random_of(934);
  for (size_t n = 0; n < SEGMENTS; n++) {
    struct ph_seg3 seg = unit_seg3_random(&r);
    double u = unit_random_in(&r, 0, 1);
    ph_vec3 wanted = ph_vec3_add(seg.start, unit_seg3_leg(&seg, 0, u));
    ck_assert_double_le(
        unit_apart(ph_seg3_point(&seg, unit_quad(12), u), wanted), 2e-13);
    ck_abs(unit_apart(ph_seg3_point(&seg, unit_quad(12), 0), seg.start), 0, 0);
    ck_abs(unit_apart(ph_seg3_point(&seg, unit_quad(12), 1), seg.end), 0, 0);
  }
}

/* A part is the same curve: points, speed times its share, what bends it. */
PH_TEST(test_part) {
  struct unit_random r = unit_random_of(935);
  for (size_t n = 0; n < SEGMENTS; n++) {
    struct ph_seg3 seg = unit_seg3_random(&r);
    double u0 = unit_random_in(&r, 0, 0.5), u1 = unit_random_in(&r, 0.6, 1);
    struct ph_seg3 part = unit_seg3_part(&seg, unit_quad(12), u0, u1);
    ck_rel(part.space.angle, seg.space.angle * (u1 - u0), 1e-14);
    for (size_t i = 0; i <= 8; i++) {
      double x = (double)i / 8, u = u0 + x * (u1 - u0);
      struct unit_bend3 a = unit_seg3_bend(&part, x),
                        b = unit_seg3_bend(&seg, u);
      ph_quat miss = ph_quat_sub(
          unit_seg3_preimage(&part, x),
          ph_quat_scale(sqrt(u1 - u0), unit_seg3_preimage(&seg, u)));
      ck_assert_double_le(ph_quat_abs(miss), 1e-14);
      ck_assert_double_le(unit_apart(ph_seg3_point(&part, unit_quad(12), x),
                                     ph_seg3_point(&seg, unit_quad(12), u)),
                          1e-13);
      if (b.speed > 0.1 && b.curvature > 0.1) {
        ck_abs(a.speed, b.speed * (u1 - u0), 1e-12);
        ck_rel(a.curvature, b.curvature, 1e-10);
        ck_abs(a.torsion, b.torsion, 1e-8 * (1 + fabs(b.torsion)));
        ck_abs(a.slope, b.slope * (u1 - u0), 1e-8 * (1 + fabs(b.slope)));
      }
    }
  }
}

/* Both ends of a part that is all of the segment. */
PH_TEST(test_part_whole) {
  struct unit_random r = unit_random_of(936);
  for (size_t n = 0; n < SEGMENTS; n++) {
    struct ph_seg3 seg = unit_seg3_random(&r);
    struct ph_seg3 part = unit_seg3_part(&seg, unit_quad(12), 0, 1);
    for (size_t i = 0; i < 3; i++) {
      ck_assert_double_le(ph_quat_abs(ph_quat_sub(part.a[i], seg.a[i])), 2e-14);
    }
    ck_abs(unit_apart(part.start, seg.start), 0, 0);
    ck_abs(unit_apart(part.end, seg.end), 0, 0);
  }
}

/* A curve writes its preimage by t, the segment has it by u. */
PH_TEST(test_of_curve) {
  struct unit_random r = unit_random_of(937);
  for (size_t n = 0; n < SEGMENTS; n++) {
    struct ph_seg3 seg = unit_seg3_random(&r), again;
    bool atph = seg.space.angle > 0;
    double root = atph ? sqrt(seg.space.angle) : 1, alpha[2],
           preimage[24] = {0};
    double points[36] = {0};
    struct ph_curve curve = {.kind = atph ? PH_CURVE_ATPH : PH_CURVE_PH,
                             .dimension = 3,
                             .degree = 5,
                             .n = 2,
                             .control_points = points,
                             .preimage.n = 3,
                             .preimage.dimension = 4,
                             .preimage.v = preimage};
    alpha[0] = 1;
    alpha[1] = seg.space.angle;
    curve.preimage.alpha = atph ? alpha : NULL;
    for (size_t i = 0; i < 3; i++) {
      preimage[12 + 4 * i] = seg.a[i].u / root;
      preimage[12 + 4 * i + 1] = seg.a[i].v / root;
      preimage[12 + 4 * i + 2] = seg.a[i].p / root;
      preimage[12 + 4 * i + 3] = seg.a[i].q / root;
      points[18 + i] = (double)i + 1;
      points[33 + i] = (double)i + 4;
    }
    again = ph_seg3_of(&curve, 1);
    ck_rel(again.space.angle, seg.space.angle, 0);
    for (size_t i = 0; i < 3; i++) {
      ck_assert_double_le(ph_quat_abs(ph_quat_sub(again.a[i], seg.a[i])),
                          2e-15);
    }
    ck_abs(unit_apart(again.start, ph_vec3_of(1, 2, 3)), 0, 0);
    ck_abs(unit_apart(again.end, ph_vec3_of(4, 5, 6)), 0, 0);
  }
}

/* A cubic, taken in space: A = w with k for i, and e2 to its left. */
PH_TEST(test_of_cubics) {
  struct unit_random r = unit_random_of(944);
  for (size_t n = 0; n < SEGMENTS; n++) {
    const size_t k = n % 3;
    struct unit_cubics c;
    struct ph_seg3 seg;
    struct unit_bend3 bend;
    double u = unit_random_in(&r, 0, 1), speed;
    ph_cplx w, p;
    ph_vec3 e[3];
    ph_quat a;
    unit_cubics_random(&c, &r, 3, 1, unit_random_cplx(&r, 1));
    seg = ph_seg3_of(&c.curve, k);
    w = unit_preimage(&c.curve, k, 0, u);
    speed = ph_cplx_norm2(w);
    ph_seg3_jet(&seg, u, &a, 1);
    ck_assert_double_le(
        ph_quat_abs(ph_quat_sub(a, ph_quat_of(w.re, 0, 0, w.im))), 2e-15);
    bend = unit_seg3_bend(&seg, u);
    ck_abs(bend.speed, speed, 4e-15);
    ck_abs(bend.curvature * bend.speed * bend.speed,
           2 * fabs(unit_cubic_bend(&c, k)), 2e-14);
    ck_abs(bend.turn, 0, 0);
    unit_seg3_frame(&seg, u, e);
    p = ph_cplx_scale(1 / speed, ph_cplx_mul(w, w));
    ck_abs(unit_apart(e[1], ph_vec3_of(-p.im, p.re, 0)), 0,
           4e-15 / sqrt(speed));
    for (int end = 0; end < 2; end++) {
      p = unit_curve(&c.curve, k, 0, end);
      ck_abs(unit_apart(end ? seg.end : seg.start, ph_vec3_of(p.re, p.im, 0)),
             0, 0);
    }
  }
}

/* ---- frames --------------------------------------------------------- */

/* Orthonormal, right-handed, along r', and what A makes of i, j, k. */
PH_TEST(test_frame) {
  struct unit_random r = unit_random_of(938);
  const ph_quat axes[3] = {{0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}};
  for (size_t n = 0; n < SEGMENTS; n++) {
    struct ph_seg3 seg = unit_seg3_random(&r);
    double u = unit_random_in(&r, 0, 1);
    ph_quat a = unit_seg3_preimage(&seg, u);
    ph_vec3 e[3], d = unit_seg3_hodograph(&seg, u);
    unit_seg3_frame(&seg, u, e);
    for (size_t i = 0; i < 3; i++) {
      ph_vec3 turned =
          ph_vec3_scale(1 / ph_quat_dot(a, a), unit_turned(a, axes[i]));
      ck_assert_double_le(unit_apart(e[i], turned), 1e-13);
      for (size_t j = 0; j <= i; j++) {
        ck_abs(ph_vec3_dot(e[i], e[j]), i == j, 1e-14);
      }
    }
    ck_abs(ph_vec3_triple(e[0], e[1], e[2]), 1, 1e-14);
    ck_assert_double_le(unit_apart(e[0], ph_vec3_unit(d)), 1e-13);
  }
}

/* e1', e2', e3' from differences: (3) of seg3.h with its z and turn, and the
 * curvature vector. */
PH_TEST(test_frame_slopes) {
  struct unit_random r = unit_random_of(939);
  const double h = 1e-4;
  size_t compared = 0;
  for (size_t n = 0; n < SEGMENTS; n++) {
    struct ph_seg3 seg = unit_seg3_random(&r);
    double u = unit_random_in(&r, 0.1, 0.9);
    struct unit_bend3 b = unit_seg3_bend(&seg, u);
    ph_vec3 e[3], near[4][3], wanted[3], found;
    double p = 2 * b.z.re / b.speed, q = 2 * b.z.im / b.speed;
    if (b.speed < 0.3) {
      continue; /* differences would be rough there */
    }
    unit_seg3_frame(&seg, u, e);
    for (size_t k = 0; k < 4; k++) {
      unit_seg3_frame(&seg, u + STEPS[k] * h, near[k]);
    }
    wanted[0] = ph_vec3_along(ph_vec3_scale(q, e[1]), -p, e[2]);
    wanted[1] = ph_vec3_along(ph_vec3_scale(b.turn, e[2]), -q, e[0]);
    wanted[2] = ph_vec3_along(ph_vec3_scale(p, e[0]), -b.turn, e[1]);
    for (size_t i = 0; i < 3; i++) {
      found = ph_vec3_sub(near[0][i], near[3][i]);
      found = ph_vec3_along(found, 8, ph_vec3_sub(near[2][i], near[1][i]));
      found = ph_vec3_scale(1 / (12 * h), found);
      ck_assert_double_le(unit_apart(found, wanted[i]), 1e-8);
    }
    ck_rel(ph_vec3_abs(wanted[0]), b.curvature * b.speed, 1e-13);
    compared++;
  }
  ck_assert_uint_ge(compared, SEGMENTS / 2);
}

/* The frame turned back by the twist minimises rotation: its normals turn about
 * the tangent no more. */
PH_TEST(test_rmf) {
  struct unit_random r = unit_random_of(940);
  const double h = 1e-4;
  size_t compared = 0;
  for (size_t n = 0; n < SEGMENTS; n++) {
    struct ph_seg3 seg = unit_seg3_random(&r);
    double u = unit_random_in(&r, 0.1, 0.9);
    ph_vec3 f2[4], f3 = {0, 0, 0}, slope;
    if (unit_seg3_bend(&seg, u).speed < 0.3) {
      continue;
    }
    for (size_t k = 0; k < 5; k++) {
      double at = u + (k < 4 ? STEPS[k] * h : 0);
      ph_cplx t = ph_cplx_polar(unit_seg3_twist(&seg, unit_quad(12), at));
      ph_vec3 e[3];
      unit_seg3_frame(&seg, at, e);
      if (k < 4) {
        f2[k] = ph_vec3_along(ph_vec3_scale(t.re, e[1]), -t.im, e[2]);
      } else {
        f3 = ph_vec3_along(ph_vec3_scale(t.im, e[1]), t.re, e[2]);
      }
    }
    slope = ph_vec3_sub(f2[0], f2[3]);
    slope = ph_vec3_along(slope, 8, ph_vec3_sub(f2[2], f2[1]));
    ck_abs(ph_vec3_dot(slope, f3) / (12 * h), 0, 1e-7);
    compared++;
  }
  ck_assert_uint_ge(compared, SEGMENTS / 2);
}

/* The integral of the torsion by length is the turn of z and the twist. */
PH_TEST(test_twist) {
  struct unit_random r = unit_random_of(941);
  enum { PANELS = 400 };
  size_t compared = 0, segments = (size_t)unit_count(SEGMENTS);
  for (size_t n = 0; n < segments; n++) {
    struct ph_seg3 seg = unit_seg3_random(&r);
    double u = unit_random_in(&r, 0.5, 1), torsion = 0, turn = 0, least = 9;
    ph_cplx z = unit_seg3_bend(&seg, 0).z;
    for (size_t i = 0; i < PANELS; i++) {
      ph_cplx next = unit_seg3_bend(&seg, u * (double)(i + 1) / PANELS).z;
      for (size_t j = 0; j < unit_quad(12)->n; j++) {
        struct unit_bend3 b = unit_seg3_bend(
            &seg, u * ((double)i + unit_quad(12)->node[j]) / PANELS);
        torsion += unit_quad(12)->weight[j] * u / PANELS * b.torsion * b.speed;
        least = fmin(least, fmin(b.speed, ph_cplx_abs(b.z)));
      }
      turn += atan2(ph_cplx_cross(z, next), ph_cplx_dot(z, next));
      z = next;
    }
    if (least > 0.05) {
      ck_abs(turn + unit_seg3_twist(&seg, unit_quad(12), u), torsion, 1e-10);
      compared++;
    }
    ck_abs(unit_seg3_twist(&seg, unit_quad(12), 0), 0, 0);
  }
  ck_assert_uint_ge(compared, segments / 10);
}

/* ---- curves that are known ------------------------------------------ */

/* (cos x, sin x, x), x from 0 to `end`: with x = 2 t, A = (cos t + sin t k) A0
 * lies in the space of the angle end / 2.  [GON18, sec. 3.6.3] */
static struct ph_seg3 helix(double end) {
  double angle = end / 2, root = sqrt(2 * sqrt(2) * angle), h = sqrt(0.5);
  struct ph_seg3 seg = {.space = ph_atph_of(angle), .start = {1, 0, 0}};
  const ph_quat k = {0, 0, 0, 1}, turn = {cos(angle), 0, 0, sin(angle)};
  ph_quat a0 = ph_quat_of_frame(ph_vec3_of(0, h, h), ph_vec3_of(1, 0, 0),
                                ph_vec3_of(0, h, -h));
  seg.a[0] = ph_quat_scale(root, a0);
  seg.a[1] = ph_quat_add(seg.a[0], ph_quat_scale(angle / (2 * seg.space.slope),
                                                 ph_quat_mul(k, seg.a[0])));
  seg.a[2] = ph_quat_mul(turn, seg.a[0]);
  seg.end = ph_vec3_of(cos(end), sin(end), end);
  return seg;
}

PH_TEST(test_helix) {
  static const double ends[] = {0.1, 1, 1.5707963267948966, 3, 6};
  for (size_t n = 0; n < COUNT(ends); n++) {
    struct ph_seg3 seg = helix(ends[n]);
    ck_rel(ph_seg3_length(&seg.space, seg.a), sqrt(2) * ends[n], 1e-14);
    for (size_t i = 0; i <= 16; i++) {
      double u = (double)i / 16, x = ends[n] * u;
      struct unit_bend3 b = unit_seg3_bend(&seg, u);
      ph_vec3 p = ph_seg3_point(&seg, unit_quad(12), u);
      ck_assert_double_le(unit_apart(p, ph_vec3_of(cos(x), sin(x), x)), 1e-14);
      ck_rel(b.speed, sqrt(2) * ends[n], 1e-14);
      ck_abs(b.curvature, 0.5, 1e-14);
      ck_abs(b.torsion, 0.5, 2e-13);
      ck_abs(b.slope, 0, 1e-13);
      ck_abs(b.torsion_slope, 0, 1e-11);
      /* z does not turn: all of the torsion is the frame's */
      ck_abs(unit_seg3_twist(&seg, unit_quad(12), u), 0.5 * b.speed * u, 1e-13);
    }
  }
}

/* A circle of radius 3 in its plane, which never twists; half of one. */
PH_TEST(test_circle) {
  double root = sqrt(3 * PI);
  struct ph_seg3 seg = {.space = ph_atph_of(PI / 2), .end = {0, 6, 0}};
  seg.a[0] = ph_quat_of(root, 0, 0, 0);
  seg.a[2] = ph_quat_of(0, 0, 0, root);
  seg.a[1] = ph_quat_of(root, 0, 0, root * PI / (4 * seg.space.slope));
  for (size_t i = 0; i <= 16; i++) {
    double u = (double)i / 16, x = PI * u;
    struct unit_bend3 b = unit_seg3_bend(&seg, u);
    ph_vec3 p = ph_seg3_point(&seg, unit_quad(12), u);
    ck_assert_double_le(
        unit_apart(p, ph_vec3_of(3 * sin(x), 3 - 3 * cos(x), 0)), 1e-14);
    ck_rel(b.curvature, 1. / 3, 1e-14);
    ck_abs(b.torsion, 0, 0);
    ck_abs(b.turn, 0, 0);
    ck_abs(unit_seg3_twist(&seg, unit_quad(12), u), 0, 0);
  }
}

/* A straight line has no curvature, and no torsion that could be told. */
PH_TEST(test_line) {
  const ph_quat a = {1, 2, -1, 0.5};
  const ph_quat line[3] = {a, ph_quat_scale(2, a), ph_quat_scale(0.5, a)};
  struct ph_seg3 seg = unit_seg3(0, line, ph_vec3_of(0, 0, 0));
  struct unit_bend3 b = unit_seg3_bend(&seg, 0.5);
  ck_abs(b.curvature, 0, 0);
  ck_assert(!isfinite(b.torsion));
  ck_abs(unit_seg3_twist(&seg, unit_quad(12), 1), 0, 0);
}

/* A(u) = 0: it stands still, and that is said. */
PH_TEST(test_standing) {
  const ph_quat a = {1, 0, 0, 0}, b = {0, 1, 0, 0}, zero = {0, 0, 0, 0};
  const ph_quat still[3] = {zero, a, b};
  struct ph_seg3 seg = unit_seg3(0, still, ph_vec3_of(0, 0, 0));
  struct unit_bend3 bend = unit_seg3_bend(&seg, 0);
  ck_abs(bend.speed, 0, 0);
  ck_assert(!isfinite(bend.curvature));
  ck_assert(!isfinite(bend.torsion));
}

/* Small angles lead to PH quintics: all changes by their square. */
PH_TEST(test_small_angles) {
  struct unit_random r = unit_random_of(942);
  size_t compared = 0;
  for (size_t n = 0; n < SEGMENTS; n++) {
    struct ph_seg3 seg = unit_seg3_random(&r);
    struct ph_seg3 quintic = unit_seg3(0, seg.a, seg.start);
    double u = unit_random_in(&r, 0, 1);
    struct unit_bend3 wanted = unit_seg3_bend(&quintic, u);
    if (wanted.speed < 0.5 || wanted.curvature < 0.5) {
      continue;
    }
    for (int e = 2; e <= 12; e += 2) {
      double angle = pow(10, -e), tol = 50 * angle * angle + 1e-12;
      struct ph_seg3 small = unit_seg3(angle, seg.a, seg.start);
      struct unit_bend3 b = unit_seg3_bend(&small, u);
      ck_assert_double_le(unit_apart(ph_seg3_point(&small, unit_quad(12), u),
                                     ph_seg3_point(&quintic, unit_quad(12), u)),
                          tol);
      ck_rel(ph_seg3_length(&small.space, small.a),
             ph_seg3_length(&quintic.space, quintic.a), tol);
      ck_rel(b.speed, wanted.speed, tol);
      ck_rel(b.curvature, wanted.curvature, tol);
      ck_abs(b.torsion, wanted.torsion, 10 * tol * (1 + fabs(wanted.torsion)));
      ck_abs(b.slope, wanted.slope, 10 * tol * (1 + fabs(wanted.slope)));
    }
    compared++;
  }
  ck_assert_uint_ge(compared, SEGMENTS / 4);
}
