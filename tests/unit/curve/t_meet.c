/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Pieces of planar segments: their bounds, and where two of them meet. */
#include "segment_unit.h"
#include "unit.h"

#include "curve/cross/meet.h"
#include "curve/segment/seg2.h"

enum { SEGMENTS = 150, POINTS = 20 };

static const double PI = 3.14159265358979323846;

/* A segment from its preimage; it ends where the preimage says. */
static struct ph_seg2 seg_of(double angle, const ph_cplx w[3], ph_cplx from) {
  struct ph_seg2 seg = {ph_atph_of(angle), {w[0], w[1], w[2]}, from, {0, 0}};
  struct ph_quad gauss;
  ck_assert(ph_quad_gauss(&gauss, 16));
  seg.end = from;
  for (size_t i = 0; i < gauss.n; i++) {
    ph_cplx at;
    ph_atph_jet(&seg.space, w, gauss.node[i], &at, 1);
    at = ph_cplx_mul(at, at);
    seg.end = ph_cplx_add(seg.end, ph_cplx_scale(gauss.weight[i], at));
  }
  return seg;
}

/* PH for every third, else ATPH of any angle. */
static struct ph_seg2 random_seg(struct unit_random *r, int i) {
  const double angle = i % 3 == 0 ? 0 : unit_random_in(r, 0, 3.1);
  ph_cplx w[3], from = unit_random_cplx(r, 1);
  for (int k = 0; k < 3; k++) {
    w[k] = unit_random_cplx(r, 1);
  }
  return seg_of(angle, w, from);
}

PH_TEST(test_cones) {
  const ph_cplx east = {1, 0}, north = {0, 2}, west = {-3, 0}, south = {0, -1};
  const ph_cplx almost_west = {-1, 1e-6}, past_west = {-1, -1e-6};
  struct ph_cone right = ph_cone_of(east, north), up = ph_cone_of(north, west);
  struct ph_cone both = ph_cone_join(&right, &up), point, far;
  ck_assert_int_eq(right.kind, PH_CONE_NARROW);
  ck_assert_int_eq(both.kind, PH_CONE_WIDE); /* exactly a half turn */
  up = ph_cone_of(north, almost_west);
  both = ph_cone_join(&right, &up);
  ck_assert_int_eq(both.kind, PH_CONE_NARROW);
  up = ph_cone_of(north, past_west);
  both = ph_cone_join(&right, &up);
  ck_assert_int_eq(both.kind, PH_CONE_WIDE);
  /* Three quarters, and all the way round. */
  far = ph_cone_of(south, east);
  both = ph_cone_join(&far, &right);
  ck_assert_int_eq(both.kind, PH_CONE_WIDE);
  up = ph_cone_of(ph_cplx_of(1, 1e-6), almost_west);
  far = ph_cone_of(almost_west, ph_cplx_of(1, -1e-6));
  both = ph_cone_join(&up, &far);
  ck_assert_int_eq(both.kind, PH_CONE_WIDE);
  /* A straight line, to rounding either way. */
  point = ph_cone_of(east, ph_cplx_of(7, -1e-15));
  ck_assert_int_eq(point.kind, PH_CONE_NARROW);
  both = ph_cone_join(&point, &PH_CONE_NONE);
  ck_assert_int_eq(both.kind, PH_CONE_NARROW);
  both = ph_cone_join(&PH_CONE_ALL, &PH_CONE_NONE);
  ck_assert_int_eq(both.kind, PH_CONE_WIDE);
  /* The shorter way, a reversal, no direction, no number. */
  ck_assert_int_eq(ph_cone_turn(east, past_west).kind, PH_CONE_NARROW);
  ck_assert_int_eq(ph_cone_turn(east, west).kind, PH_CONE_WIDE);
  ck_assert_int_eq(ph_cone_turn(east, ph_cplx_of(0, 0)).kind, PH_CONE_WIDE);
  ck_assert_int_eq(ph_cone_turn(east, ph_cplx_of((double)NAN, 0)).kind,
                   PH_CONE_WIDE);
}

PH_TEST(test_halves) {
  struct unit_random r = unit_random_of(1);
  for (int i = 0; i < unit_count(SEGMENTS); i++) {
    struct ph_seg2 seg = random_seg(&r, i);
    struct ph_piece piece = ph_piece_of(&seg, 7), half[2];
    ph_piece_halves(&piece, half);
    for (int k = 0; k < 2; k++) {
      struct ph_seg2 part =
          unit_seg2_part(&seg, unit_quad(12), 0.5 * k, 0.5 * k + 0.5);
      ck_assert_uint_eq(half[k].segment, 7);
      ck_abs(half[k].from, 0.5 * k, 0);
      ck_abs(half[k].to, 0.5 * k + 0.5, 0);
      ck_abs(half[k].seg.space.angle, part.space.angle, 0);
      ck_abs(unit_distance(half[k].seg.start, part.start), 0, 1e-14);
      ck_abs(unit_distance(half[k].seg.end, part.end), 0, 1e-14);
      for (int j = 0; j < 3; j++) {
        ck_abs(unit_distance(half[k].seg.w[j], part.w[j]), 0, 1e-14);
      }
    }
  }
}

/* How far v lies outside of the cone, as a sine. */
static double outside(const struct ph_cone *cone, ph_cplx v) {
  double low = ph_cplx_cross(cone->low, v) / ph_cplx_abs(cone->low);
  double high = ph_cplx_cross(v, cone->high) / ph_cplx_abs(cone->high);
  return -fmin(low, high) / ph_cplx_abs(v);
}

/* How far z lies outside of the convex hull of the control points, as seen
 * from a number of directions. */
static double off_hull(const struct ph_piece *piece, ph_cplx z) {
  double worst = -HUGE_VAL;
  for (int i = 0; i < 16; i++) {
    ph_cplx axis = ph_cplx_polar(PI * i / 8);
    double far = -HUGE_VAL;
    for (int k = 0; k < 6; k++) {
      far = fmax(far, ph_cplx_dot(axis, piece->p[k]));
    }
    worst = fmax(worst, ph_cplx_dot(axis, z) - far);
  }
  return worst;
}

/* All bounds at points of a piece; returns how wide that of the curvature is,
 * or infinity where there is none. */
static double ck_bounds(const struct ph_piece *piece) {
  bool monotone = ph_seg2_is_monotone(piece->seg.w);
  double curvature[2] = {-HUGE_VAL, HUGE_VAL}, off = 0;
  int bad = 0;
  if (monotone) {
    ph_piece_curvature(piece, curvature);
  }
  ck_assert_int_eq(piece->cone.kind, monotone ? PH_CONE_NARROW : PH_CONE_WIDE);
  for (int i = 0; i <= POINTS; i++) {
    double u = (double)i / POINTS;
    struct ph_curvature local = ph_seg2_curvature(&piece->seg, u);
    ph_cplx at = ph_seg2_point(&piece->seg, unit_quad(12), u);
    double slack = 1e-14 / local.speed; /* rounding of Im(conj(w) w') */
    struct ph_box2 point = ph_box2_of(&at, 1);
    off = fmax(off, off_hull(piece, at));
    bad += ph_box2_apart(&point, &piece->box, 1e-14) ? 1 : 0;
    bad += monotone && !(outside(&piece->cone, local.tangent) <= 1e-13) ? 1 : 0;
    bad += monotone && !(curvature[0] <= local.curvature + slack &&
                         local.curvature <= curvature[1] + slack)
               ? 1
               : 0;
  }
  ck_assert_double_le(off, 1e-14);
  ck_assert_int_eq(bad, 0);
  return curvature[1] - curvature[0];
}

PH_TEST(test_bounds) {
  struct unit_random r = unit_random_of(2);
  size_t monotone = 0;
  for (int i = 0; i < unit_count(SEGMENTS); i++) {
    struct ph_seg2 seg = random_seg(&r, i);
    struct ph_piece piece = ph_piece_of(&seg, 0), half[2];
    for (int depth = 0; depth < 12; depth++) {
      double width = ck_bounds(&piece), next;
      ph_piece_halves(&piece, half);
      piece = half[unit_random_below(&r, 2)];
      next = ck_bounds(&piece);
      /* From here on the width goes down with the length. */
      ck_assert(depth < 9 || isinf(width) || next <= 0.55 * width);
      monotone += isfinite(next) ? 1 : 0;
    }
  }
  ck_assert_uint_ge(monotone, unit_count(SEGMENTS) * 8);
}

static const struct ph_between FAR = {{{0, 0}, {0, 0}, PH_CONE_WIDE},
                                      {{0, 0}, {0, 0}, PH_CONE_WIDE}};

/* Whether two segments meet, and in how many steps. */
static bool meets(const struct ph_seg2 *a, const struct ph_seg2 *b,
                  struct ph_meet *meet) {
  struct ph_piece first = ph_piece_of(a, 3), second = ph_piece_of(b, 5);
  *meet = (struct ph_meet){
      .rule = unit_quad(12), .tolerance = 1e-12, .steps = 100000};
  ph_meet_pair(meet, &first, &second, &FAR);
  if (meet->found) {
    double apart = unit_distance(ph_seg2_point(a, unit_quad(12), meet->u[0]),
                                 ph_seg2_point(b, unit_quad(12), meet->u[1]));
    ck_assert_msg(apart <= 3e-12 && meet->segment[0] == 3 &&
                      meet->segment[1] == 5,
                  "segments %zu, %zu apart by %g", meet->segment[0],
                  meet->segment[1], apart);
  }
  return meet->found;
}

PH_TEST(test_crossing) {
  /* (1 + u) from 0 upwards, and a stroke across it at height 1. */
  const ph_cplx line[3] = {{1, 0}, {1, 0}, {1, 0}};
  const ph_cplx arc[3] = {{1, 1}, {1.1, 1}, {1, 1.1}};
  struct ph_seg2 a = seg_of(0, line, ph_cplx_of(0, 1));
  struct ph_seg2 b = seg_of(0, arc, ph_cplx_of(0.3, 0.2)), c;
  struct ph_meet meet;
  ck_assert(meets(&a, &b, &meet));
  ck_abs(ph_seg2_point(&b, unit_quad(12), meet.u[1]).im, 1, 1e-14);
  ck_assert_uint_ge(meet.steps, 100000 - 10);
  /* From the very start of the one, and just short of it. */
  c = seg_of(0, arc, ph_cplx_of(0.3, 1));
  ck_assert(meets(&a, &c, &meet));
  ck_abs(meet.u[1], 0, 1e-11);
  c = seg_of(0, arc, ph_cplx_of(0.3, 1 + 1e-11));
  ck_assert(!meets(&a, &c, &meet));
}

/* An arc nearly of a circle, its lowest or (up = -1) highest point at gap / 2
 * above or below 0. */
static struct ph_seg2 cap(double up, double gap, double turn) {
  ph_cplx w[3], from;
  struct ph_seg2 seg;
  for (int k = 0; k < 3; k++) {
    w[k] = ph_cplx_polar(up * turn * (k - 1));
  }
  seg = seg_of(0, w, ph_cplx_of(0, 0));
  from = ph_seg2_point(&seg, unit_quad(12), 0.5);
  from.im = from.im - up * gap / 2;
  seg.start = ph_cplx_sub(seg.start, from);
  seg.end = ph_cplx_sub(seg.end, from);
  return seg;
}

PH_TEST(test_dip) {
  /* A steep arc dips through a stroke: its ends are high above. */
  const double turn = 0.5; /* of w, both ways */
  for (int reach = 0; reach < 2; reach++) {
    struct ph_seg2 arc = cap(1, 0, turn), stroke;
    const ph_cplx line[3] = {{2, 0}, {2, 0}, {2, 0}};
    struct ph_meet meet;
    double depth = reach ? 0.1 * arc.start.im : -1e-9;
    stroke = seg_of(0, line, ph_cplx_of(-2, depth));
    ck_assert(meets(&stroke, &arc, &meet) == (reach != 0));
    ck_assert(meets(&arc, &stroke, &meet) == (reach != 0));
  }
}

PH_TEST(test_touching) {
  const double gaps[] = {1e-3, 1e-6, 1e-9, 1e-11, 1e-13, 0, -1e-13, -1e-6};
  struct ph_meet meet;
  for (size_t i = 0; i < 8; i++) {
    struct ph_seg2 a = cap(1, gaps[i], 0.4), b = cap(-1, gaps[i], 0.3);
    ck_assert_msg(meets(&a, &b, &meet) == (i > 3), "gap %g", gaps[i]);
    ck_assert_uint_ge(meet.steps, 100000 - 300);
  }
}

/* A segment that turns by less than a half turn. */
static struct ph_seg2 random_arc(struct unit_random *r, int i) {
  const double angle = i % 2 ? 0 : unit_random_in(r, 0, 3);
  double from = unit_random_in(r, 0, 0.7);
  ph_cplx w[3];
  for (int k = 0; k < 3; k++) {
    w[k] = ph_cplx_scale(unit_random_in(r, 0.7, 1.3),
                         ph_cplx_polar(k * from + unit_random_in(r, 0, 0.2)));
  }
  return seg_of(angle, w, ph_cplx_of(0, 0));
}

PH_TEST(test_tangent) {
  /* A point of one laid on a point of the other, with nearly one tangent. */
  struct unit_random r = unit_random_of(3);
  for (int i = 0; i < 1500; i++) {
    struct ph_seg2 a = random_arc(&r, i), b = random_arc(&r, i / 2);
    double u = unit_random_in(&r, 0, 1), v = unit_random_in(&r, 0, 1);
    double off = i % 3 ? pow(10, unit_random_in(&r, -9, -1)) : 0;
    ph_cplx at = ph_seg2_point(&a, unit_quad(12), u), turn;
    struct ph_meet meet;
    turn = ph_cplx_mul(ph_seg2_curvature(&a, u).tangent,
                       ph_cplx_conj(ph_seg2_curvature(&b, v).tangent));
    turn = ph_cplx_sqrt(ph_cplx_mul(turn, ph_cplx_polar(i % 2 * PI + off)));
    for (int k = 0; k < 3; k++) {
      b.w[k] = ph_cplx_mul(b.w[k], turn);
    }
    b = seg_of(b.space.angle, b.w, ph_cplx_of(0, 0));
    at = ph_cplx_sub(at, ph_seg2_point(&b, unit_quad(12), v));
    b.start = ph_cplx_add(b.start, at);
    b.end = ph_cplx_add(b.end, at);
    if (!meets(&a, &b, &meet)) {
      ck_abort_msg("seed %lu, pair %d", unit_seed(), i);
    }
  }
}

PH_TEST(test_side_by_side) {
  /* Arcs with the same centre: no line comes between them. */
  const double gaps[] = {1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-13};
  const double angles[] = {0, 1.2};
  struct ph_meet meet;
  for (size_t i = 0; i < 12; i++) {
    ph_cplx w[3], v[3];
    double gap = gaps[i % 6], root = sqrt(1 + gap);
    struct ph_seg2 a, b;
    for (int k = 0; k < 3; k++) {
      w[k] = ph_cplx_polar(0.4 * k);
      v[k] = ph_cplx_scale(root, ph_cplx_polar(0.4 * (2 - k) + PI / 2));
    }
    a = seg_of(angles[i / 6], w, ph_cplx_of(0, 0));
    /* The second one goes back, from gap beside the end. */
    b = seg_of(angles[i / 6], v, ph_cplx_of(0, 0));
    b.start =
        ph_cplx_add(a.end, ph_cplx_scale(gap, ph_cplx_of(sin(1.6), -cos(1.6))));
    b.end = ph_cplx_add(b.start,
                        ph_cplx_scale(-(1 + gap), ph_cplx_sub(a.end, a.start)));
    ck_assert_msg(meets(&a, &b, &meet) == (gap < 1e-12), "gap %g", gap);
    ck_assert_msg(meet.steps >= 100000 - 30000, "gap %g: %zu steps", gap,
                  100000 - meet.steps);
  }
}

/* The preimage t - 1/2 + i e goes by the origin: a loop of size e^3. */
static struct ph_meet by_origin(double e, double turn) {
  const ph_cplx f = ph_cplx_polar(turn);
  const ph_cplx w[3] = {ph_cplx_mul(f, ph_cplx_of(-0.5, e)),
                        ph_cplx_mul(f, ph_cplx_of(0, e)),
                        ph_cplx_mul(f, ph_cplx_of(0.5, e))};
  struct ph_meet meet = {
      .rule = unit_quad(12), .tolerance = 1e-12, .steps = 10000};
  struct ph_seg2 seg = seg_of(0, w, ph_cplx_of(0, 0));
  struct ph_piece piece = ph_piece_of(&seg, 2);
  struct ph_cone outer = PH_CONE_ALL;
  ph_meet_self(&meet, &piece, &outer);
  return meet;
}

PH_TEST(test_self) {
  /* The loop's parameters are 1/2 +- sqrt(3) e: it must fit in. */
  const double sizes[] = {0.27, 0.2, 1e-2, 1e-4, 1e-6, 1e-12, 0};
  for (size_t i = 0; i < 7; i++) {
    struct ph_meet meet = by_origin(sizes[i], 0.3);
    ck_assert_uint_eq(meet.segment[0], 2);
    ck_assert_msg(meet.found, "size %g", sizes[i]);
    ck_assert_uint_ge(meet.steps, 9000);
    if (sizes[i] > 1e-3) {
      ck_abs(meet.u[0], 0.5 - sqrt(3) * sizes[i], 1e-6);
      ck_abs(meet.u[1], 0.5 + sqrt(3) * sizes[i], 1e-6);
    }
  }
  ck_assert(!by_origin(0.29, 0.3).found);
  ck_assert(!by_origin(1, 0.3).found);
}

PH_TEST(test_no_numbers) {
  struct ph_seg2 seg = {
      ph_atph_of(0), {{1, 0}, {1, 0}, {1, 0}}, {0, 0}, {1, 0}};
  struct ph_meet meet = {
      .rule = unit_quad(12), .tolerance = 1e-12, .steps = 1000};
  struct ph_piece piece;
  struct ph_cone outer = PH_CONE_ALL;
  seg.w[1].re = (double)NAN;
  seg.start.im = (double)NAN;
  piece = ph_piece_of(&seg, 0);
  ph_meet_self(&meet, &piece, &outer);
  ck_assert(meet.found); /* it ends, and does not vouch for anything */
}
