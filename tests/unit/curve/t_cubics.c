/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Curves as cubics: near enough in both directions, by nearest points; joined
 * and in order; and not many more than are needed.
 */
#include "curve/bezier/cubics.h"

#include "curve_unit.h"
#include "segment_unit.h"
#include "spherical_unit.h"
#include "tc_curve_unit.h"

#include "curve/offset/cusp.h"
#include "curve/offset/gap.h"
#include "curve/offset/offset.h"
#include "curve/segment/seg2.h"
#include "kernel/pi.h"

enum { PLACES = 8, STEPS = 60, ROUNDS = 9, NARROW = 8, CURVES = 10 };

static const double PI = 3.141592653589793;

/* ---- curves -------------------------------------------------------------- */

enum kind { PLANE, SPACE, CUBICS, SPHERE, BEZIER, KINDS };

/* One of them. */
struct any {
  struct unit_segments plane;
  struct unit_curve3 space;
  struct unit_cubics cubics;
  struct unit_spherical sphere;
  struct ph_curve *curve;
};

static void plane_random(struct any *any, struct unit_random *r) {
  struct ph_seg2 seg = unit_seg2_random(r);
  unit_seg2_curve(&seg, 1, &any->plane);
  any->plane.lengths[0] = ph_seg2_length(&seg.space, seg.w);
  any->curve = &any->plane.curve;
}

/* Any points, of degree 5. */
static void bezier_random(struct any *any, struct unit_random *r) {
  struct ph_curve *curve = &any->plane.curve;
  plane_random(any, r);
  curve->kind = PH_CURVE_BEZIER;
  curve->preimage.alpha = NULL;
  curve->preimage.v = NULL;
  for (size_t i = 0; i < 12; i++) {
    any->plane.control_points[i] = unit_random_in(r, -1, 1);
  }
  any->plane.lengths[0] = 0; /* no less than its own: that of the polygon */
  for (size_t i = 0; i < 10; i += 2) {
    const double *p = any->plane.control_points + i;
    any->plane.lengths[0] += hypot(p[2] - p[0], p[3] - p[1]);
  }
}

static void any_random(struct any *any, enum kind kind, struct unit_random *r) {
  switch (kind) {
  case PLANE:
    plane_random(any, r);
    break;
  case SPACE:
    unit_curve3_random(&any->space, 2, unit_random_below(r, 2), 1, r);
    any->curve = &any->space.curve;
    break;
  case CUBICS:
    unit_cubics_random(&any->cubics, r, 3, 1, ph_cplx_of(1, 2));
    any->curve = &any->cubics.curve;
    break;
  case BEZIER:
    bezier_random(any, r);
    break;
  default:
    unit_spherical_random(&any->sphere, 3, 0.8, r);
    any->curve = &any->sphere.curve;
  }
}

/* ---- distances ----------------------------------------------------------- */

struct pair {
  const struct ph_sampler *sampler;
  double interval[2];
  ph_cplx c[4];
};

static struct pair pair_of(const struct ph_sampler *sampler,
                           const struct ph_pieces *cubics, size_t i) {
  struct pair pair = {.sampler = sampler};
  pair.interval[0] = cubics->interval[2 * i];
  pair.interval[1] = cubics->interval[2 * i + 1];
  for (size_t j = 0; j < 4; j++) {
    const double *p = cubics->control_points + 8 * i + 2 * j;
    pair.c[j] = ph_cplx_of(p[0], p[1]);
  }
  return pair;
}

/* Point and direction, at x in [0,1] of the piece; side 0: of the cubic, side
 * 1: of the curve. */
static ph_cplx place(const struct pair *pair, int side, double x,
                     ph_cplx *direction) {
  const double *u = pair->interval;
  const ph_cplx *c = pair->c;
  if (side == 0) {
    ph_cplx a = ph_cplx_between(c[0], c[1], x), b, d;
    ph_cplx m = ph_cplx_between(c[1], c[2], x);
    b = ph_cplx_between(m, ph_cplx_between(c[2], c[3], x), x);
    a = ph_cplx_between(a, m, x);
    d = ph_cplx_sub(b, a);
    *direction = d;
    return ph_cplx_between(a, b, x);
  } else {
    struct ph_sample s =
        ph_sampler_at(pair->sampler, (1 - x) * u[0] + x * u[1]);
    *direction = ph_cplx_of(s.tangent.x, s.tangent.y);
    return ph_cplx_of(s.point.x, s.point.y);
  }
}

/* From a point to one side: the least at equal steps, again and again about the
 * least so far. */
static double nearest(const struct pair *pair, int side, ph_cplx from) {
  double least = (double)INFINITY, low = 0, step = 1. / STEPS, at = 0;
  for (size_t round = 0; round < ROUNDS; round++) {
    size_t n = round > 0 ? 2 * NARROW : STEPS;
    for (size_t i = 0; i <= n; i++) {
      ph_cplx direction;
      double x = fmin(fmax(low + (double)i * step, 0), 1);
      double d = unit_distance(place(pair, side, x, &direction), from);
      at = d < least ? x : at;
      least = fmin(d, least);
    }
    low = at - step;
    step /= NARROW;
  }
  return least;
}

static double distance_of(const struct pair *pair) {
  double greatest = 0;
  for (int side = 0; side < 2; side++) {
    for (size_t i = 0; i <= PLACES; i++) {
      ph_cplx direction;
      ph_cplx from =
          place(pair, side, ((double)i + 0.37) / (PLACES + 1), &direction);
      greatest = unit_larger(greatest, nearest(pair, 1 - side, from));
    }
  }
  return greatest;
}

/* ---- checks -------------------------------------------------------------- */

static struct ph_pieces cubics_of(const struct ph_curve *curve,
                                  const struct ph_offset *offset,
                                  double tolerance) {
  struct ph_pieces cubics;
  struct ph_diag diag;
  enum ph_status status =
      ph_cubics_of(curve, offset, tolerance, &unit_arena, &cubics, &diag);
  ck_assert_msg(status == PH_OK, "%s", diag.message);
  ck_assert_uint_eq(cubics.degree, 3);
  ck_assert_uint_eq(cubics.dimension, 2);
  ck_assert_double_le(cubics.error, tolerance);
  return cubics;
}

/* In order, without gaps in the parameter; points meet within a segment. */
static void check_order(const struct ph_curve *curve,
                        const struct ph_pieces *cubics) {
  size_t k = 0;
  double u = 0;
  for (size_t i = 0; i < cubics->n; i++) {
    const double *interval = cubics->interval + 2 * i;
    const double *p = cubics->control_points + 8 * i;
    if (cubics->segment[i] > k) {
      ck_abs(u, 1, 0);
      k++;
      u = 0;
    } else if (i > 0) {
      ck_assert(unit_same(p[0], p[-2]) && unit_same(p[1], p[-1]));
    }
    ck_assert_uint_eq(cubics->segment[i], k);
    ck_abs(interval[0], u, 0);
    ck_assert_double_gt(interval[1], u);
    u = interval[1];
  }
  ck_abs(u, 1, 0);
  ck_assert_uint_eq(k, curve->n - 1);
}

/* Some of the pieces, if there are many. */
static void check_near(const struct ph_curve *curve,
                       const struct ph_offset *offset,
                       const struct ph_pieces *cubics, double tolerance) {
  size_t k = 0, stride = 1 + cubics->n / 12;
  struct ph_sampler sampler = unit_sampler(curve, offset, 0);
  for (size_t i = 0; i < cubics->n; i += stride) {
    struct ph_diag diag;
    struct pair pair = pair_of(&sampler, cubics, i);
    double distance;
    if (cubics->segment[i] > k) {
      k = cubics->segment[i];
      ck_assert_int_eq(ph_sampler_enter(&sampler, k, &diag), PH_OK);
    }
    distance = distance_of(&pair);
    ck_assert_msg(distance <= tolerance * (1 + 1e-9) + 1e-14,
                  "segment %zu, [%g, %g]: %.3g from the curve, not %.3g", k,
                  pair.interval[0], pair.interval[1], distance, tolerance);
  }
}

static size_t check(const struct ph_curve *curve,
                    const struct ph_offset *offset, double tolerance) {
  struct ph_pieces cubics = cubics_of(curve, offset, tolerance);
  size_t n = cubics.n;
  check_order(curve, &cubics);
  if (offset || curve->kind != PH_CURVE_TC) {
    check_near(curve, offset, &cubics, tolerance);
  }
  return n;
}

static const double tolerances[] = {1e-2, 1e-3, 1e-4, 1e-6, 1e-8};
enum { TOLERANCES = 5 };

/* Samples of spherical curves take longer. */
static int curves_of(enum kind kind) {
  return unit_count(kind == SPHERE ? CURVES / 3 : CURVES);
}

PH_TEST_EACH(test_curves, KINDS) {
  struct unit_random r = unit_random_of(700 + (uint64_t)_i);
  size_t pieces[TOLERANCES] = {0};
  for (int n = 0; n < curves_of((enum kind)_i); n++) {
    struct any any;
    any_random(&any, (enum kind)_i, &r);
    for (size_t j = 0; j < TOLERANCES; j++) {
      pieces[j] += check(any.curve, NULL, tolerances[j]);
      ph_arena_reset(&unit_arena);
    }
  }
  /* of the sixth order: 1e-4 of the distance takes 4.6 times as many */
  ck_assert_uint_le(pieces[4], 7 * pieces[2]);
}

/* The offset of one of the curves, with its cusps. */
static struct ph_offset offset_of(const struct any *any, enum kind kind,
                                  double distance, enum ph_normal normal) {
  const struct ph_offset_rules rules = {
      .tolerance = 1, .samples = {.how = PH_SAMPLE_PARAMETER, .n = 1}};
  struct ph_offset offset = {.distance = distance};
  struct ph_diag diag;
  enum ph_status status;
  if (kind == SPHERE) {
    status =
        ph_offset(any->curve, distance, &rules, &unit_arena, &offset, &diag);
  } else {
    offset.vector = kind == PLANE || kind == CUBICS ? NULL
                    : normal == PH_E2               ? "e2"
                                                    : "e3";
    status = ph_cusps_of(any->curve, distance, normal, &unit_arena,
                         &offset.cusps, &diag);
  }
  if (status == PH_OK && kind != SPHERE) {
    status = ph_gaps_of(any->curve, distance, normal, &unit_arena, &offset.gaps,
                        &diag);
  }
  ck_assert_int_eq(status, PH_OK);
  return offset;
}

/* It is an offset that is sampled: at its distance from the curve. */
static void check_aside(const struct ph_curve *curve,
                        const struct ph_offset *offset) {
  struct ph_sampler on = unit_sampler(curve, NULL, 0);
  struct ph_sampler beside = unit_sampler(curve, offset, 0);
  double distance = unit_apart(ph_sampler_at(&on, 0.4).point,
                               ph_sampler_at(&beside, 0.4).point);
  double wanted = fabs(offset->distance);
  if (curve->sphere.radius > 0) {
    wanted =
        2 * curve->sphere.radius * sin(wanted / (2 * curve->sphere.radius));
  }
  ck_abs(distance, wanted, 1e-12);
}

/* Offsets to either side, with cusps and without. */
PH_TEST_EACH(test_offsets, BEZIER) {
  struct unit_random r = unit_random_of(800 + (uint64_t)_i);
  size_t cusps = 0;
  for (int n = 0; n < curves_of((enum kind)_i); n++) {
    double distance = unit_random_in(&r, -1, 1);
    struct any any;
    any_random(&any, (enum kind)_i, &r);
    for (size_t j = 0; j < TOLERANCES; j++) {
      struct ph_offset offset = offset_of(&any, (enum kind)_i, distance,
                                          _i == SPACE && n % 2 ? PH_E3 : PH_E2);
      cusps += offset.cusps.n;
      check_aside(any.curve, &offset);
      check(any.curve, &offset, tolerances[j]);
      ph_arena_reset(&unit_arena);
    }
  }
  /* of three curves there may be none */
  ck_assert(cusps > 0 || curves_of((enum kind)_i) < CURVES);
}

/* Offsets of a square: its sides do not meet, nor does the last the first. */
PH_TEST(test_gaps) {
  struct ph_offset offset = {.distance = 0.25};
  struct ph_pieces cubics;
  struct unit_cubics c;
  struct ph_diag diag;
  unit_cubics_begin(&c, ph_cplx_of(1, 2));
  for (int i = 0; i < 4; i++) {
    const ph_cplx w = ph_cplx_polar(0.1 + PH_PI / 4 * i);
    unit_cubics_add(&c, w, w);
  }
  c.curve.closed = true;
  ck_assert_int_eq(ph_gaps_of(&c.curve, offset.distance, PH_E2, &unit_arena,
                              &offset.gaps, &diag),
                   PH_OK);
  cubics = cubics_of(&c.curve, &offset, 1e-3);
  ck_assert_uint_eq(cubics.n, 4);
  for (size_t i = 0; i < 4; i++) {
    const double *p = cubics.control_points + 8 * i + 6;
    const double *q = cubics.control_points + 8 * ((i + 1) % 4);
    ck_abs(hypot(p[0] - q[0], p[1] - q[1]), sqrt(2) / 4, 1e-14);
  }
}

/* An array of so many numbers, again and again. */
static double *repeated(const double *v, size_t n, size_t times) {
  double *all = ph_arena_array(&unit_arena, n * times, sizeof *all);
  ck_assert_ptr_nonnull(all);
  for (size_t i = 0; i < n * times; i++) {
    all[i] = v[i % n];
  }
  return all;
}

/* Of a long curve, whose segments several threads may cover: each of its
 * segments has the cubics that it has alone, with its cusps, and begins where
 * the one before ends, but for gaps; it is closed. */
PH_TEST(test_long) {
  enum { N = 300 };
  size_t gaps[] = {127, 128, 200}, gap = 0, k = 0;
  struct unit_random r = unit_random_of(903);
  struct any any;
  struct ph_curve curve;
  struct ph_offset alone, offset;
  struct ph_pieces one, cubics;
  const double *start;
  do {
    ph_arena_reset(&unit_arena);
    any_random(&any, PLANE, &r);
    alone = offset_of(&any, PLANE, unit_random_in(&r, -1, 1), PH_E2);
  } while (alone.cusps.n == 0);
  one = cubics_of(any.curve, &alone, 1e-4);
  curve = *any.curve;
  curve.n = N;
  curve.closed = true;
  curve.lengths = repeated(curve.lengths, 1, N);
  curve.control_points = repeated(curve.control_points, 12, N);
  curve.preimage.v = repeated(curve.preimage.v, 6, N);
  offset = alone;
  offset.cusps.n = N * alone.cusps.n;
  offset.cusps.at =
      ph_arena_array(&unit_arena, offset.cusps.n, sizeof *offset.cusps.at);
  ck_assert_ptr_nonnull(offset.cusps.at);
  for (size_t i = 0; i < offset.cusps.n; i++) {
    offset.cusps.at[i] = alone.cusps.at[i % alone.cusps.n];
    offset.cusps.at[i].segment = i / alone.cusps.n;
  }
  offset.gaps = (struct ph_gaps){COUNT(gaps), gaps};
  cubics = cubics_of(&curve, &offset, 1e-4);
  ck_assert_uint_eq(cubics.n, N * one.n);
  start = cubics.control_points;
  for (size_t i = 0; i < cubics.n; i++, start += 8) {
    const double *p = one.control_points + 8 * (i % one.n), *first = p;
    k = i / one.n;
    if (i > 0 && i % one.n == 0) {
      const bool jumps = gap < COUNT(gaps) && gaps[gap] == k;
      gap += jumps;
      first = jumps ? p : one.control_points + 8 * one.n - 2;
    }
    ck_assert_uint_eq(cubics.segment[i], k);
    for (size_t j = 0; j < 8; j++) {
      const bool last = i + 1 == cubics.n && j >= 6;
      ck_abs(start[j],
             last    ? one.control_points[j - 6]
             : j < 2 ? first[j]
                     : p[j],
             0);
    }
  }
}

/* ---- known curves -------------------------------------------------------- */

/* The arc of a unit circle from the x-axis on, turned about that axis. */
static void circle(struct any *any, double end, double tilt) {
  const double angle = end / 2, root = sqrt(end);
  const struct ph_atph space = ph_atph_of(angle);
  const double alpha[1] = {angle};
  const ph_quat tilted = {cos(tilt / 2), sin(tilt / 2), 0, 0};
  const ph_quat up = {cos(PI / 4), 0, 0, sin(PI / 4)};
  ph_quat a[3] = {{root, 0, 0, 0},
                  {root, 0, 0, root * angle / (2 * space.slope)},
                  {root * cos(angle), 0, 0, root * sin(angle)}};
  for (size_t i = 0; i < 3; i++) {
    a[i] = ph_quat_mul(tilted, ph_quat_mul(up, a[i]));
  }
  unit_curve3_of(&any->space, 1, alpha, a, ph_vec3_of(1, 0, 0));
  any->curve = &any->space.curve;
}

/* A quarter of a circle: one cubic is within 2.8e-4 of the radius, and the
 * difference goes with the sixth power of the angle. */
PH_TEST(test_circle) {
  static const double wanted[][2] = {{1e-3, 1}, {1e-4, 2}, {1e-5, 2},
                                     {1e-6, 3}, {1e-8, 6}, {1e-9, 9}};
  struct any any;
  for (size_t i = 0; i < COUNT(wanted); i++) {
    circle(&any, PI / 2, 0);
    ck_assert_double_le((double)check(any.curve, NULL, wanted[i][0]),
                        wanted[i][1]);
  }
}

/* Two halves of a circle: where they meet there is one control point. */
PH_TEST(test_closed) {
  const double angle = PI / 2, alpha[2] = {angle, angle}, root = sqrt(PI);
  const double handle = root * angle / (2 * ph_atph_of(angle).slope);
  const ph_quat a[5] = {{root, 0, 0, 0},
                        {root, 0, 0, handle},
                        {0, 0, 0, root},
                        {-handle, 0, 0, root},
                        {-root, 0, 0, 0}};
  struct any any;
  struct ph_pieces cubics;
  size_t n, joints = 0;
  unit_curve3_of(&any.space, 2, alpha, a, ph_vec3_of(1, 1. / 3, 0));
  any.space.curve.closed = true;
  check(&any.space.curve, NULL, 1e-5);
  cubics = cubics_of(&any.space.curve, NULL, 1e-5);
  n = cubics.n;
  for (size_t i = 0; i < n; i++) {
    const double *p = cubics.control_points + 8 * i;
    const double *next = cubics.control_points + 8 * ((i + 1) % n);
    ck_abs(p[6], next[0], 0);
    ck_abs(p[7], next[1], 0);
    joints += cubics.segment[i] != cubics.segment[(i + 1) % n];
  }
  ck_assert_uint_eq(joints, 2);
}

/* Seen along z it goes to and fro on a line, and along z where it turns back:
 * there are straight pieces there. */
PH_TEST(test_edge_on) {
  struct any any;
  for (size_t j = 0; j < TOLERANCES; j++) {
    circle(&any, 1.7 * PI, PI / 2);
    check(any.curve, NULL, tolerances[j]);
    circle(&any, 1.7 * PI, PI / 2 - 0.01);
    check(any.curve, NULL, tolerances[j]);
  }
}

/* A line along z is a point. */
PH_TEST(test_upright) {
  const ph_quat a = {sqrt(0.5), 0, -sqrt(0.5), 0}; /* a i a* = k */
  const ph_quat line[3] = {a, a, a};
  struct any any;
  struct ph_pieces cubics;
  unit_curve3_of(&any.space, 1, NULL, line, ph_vec3_of(1, 2, 0));
  cubics = cubics_of(&any.space.curve, NULL, 1e-6);
  ck_assert_uint_eq(cubics.n, 1);
  for (size_t i = 0; i < 4; i++) {
    ck_abs(cubics.control_points[2 * i], 1, 1e-15);
    ck_abs(cubics.control_points[2 * i + 1], 2, 1e-15);
  }
}

/* Cubics are themselves, to the last bit. */
PH_TEST(test_exact) {
  struct unit_random r = unit_random_of(900);
  struct unit_cubics c;
  struct ph_pieces cubics;
  unit_cubics_random(&c, &r, 3, 1, ph_cplx_of(1, 2));
  cubics = cubics_of(&c.curve, NULL, 1e-300);
  ck_assert_uint_eq(cubics.n, 3);
  ck_abs(cubics.error, 0, 0);
  for (size_t i = 0; i < 24; i++) {
    ck_abs(cubics.control_points[i], c.control_points[i], 0);
  }
}

/* In any unit the same. */
PH_TEST_EACH(test_scales, 4) {
  static const int exponents[] = {-900, -300, 300, 900};
  const int e = exponents[_i];
  struct unit_random r = unit_random_of(901);
  struct any any;
  struct ph_pieces plain, scaled;
  plane_random(&any, &r);
  plain = cubics_of(any.curve, NULL, 1e-5);
  for (size_t i = 0; i < 12; i++) {
    any.plane.control_points[i] = ldexp(any.plane.control_points[i], e);
    any.plane.preimage[i % 6] =
        i < 6 ? ldexp(any.plane.preimage[i], e / 2) : any.plane.preimage[i % 6];
  }
  any.plane.lengths[0] = ldexp(any.plane.lengths[0], e);
  scaled = cubics_of(any.curve, NULL, ldexp(1e-5, e));
  ck_assert_uint_eq(scaled.n, plain.n);
  for (size_t i = 0; i < 8 * plain.n; i++) {
    ck_abs(ldexp(scaled.control_points[i], -e), plain.control_points[i], 0);
  }
}

/* What cannot be had is refused, with the segment. */
PH_TEST(test_tolerance) {
  struct unit_random r = unit_random_of(902);
  struct any any;
  struct ph_pieces cubics;
  struct ph_diag diag;
  plane_random(&any, &r);
  ck_assert_int_eq(
      ph_cubics_of(any.curve, NULL, 1e-300, &unit_arena, &cubics, &diag),
      PH_E_NO_CONVERGENCE);
  ck_assert_str_eq(diag.field, "tolerance");
}
