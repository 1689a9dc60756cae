/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Bezier pieces of ATPH curves and of offsets: near, joined, in order. */
#include "unit.h"
#include "curve_unit.h"
#include "planar_unit.h"

#include "curve/bezier/hermite.h"
#include "curve/segment/seg2.h"

/* Turns both ways, by up to a right angle; kappa stays below 4. */
static const double SOME[] = {0, 0, 2, 1, 3, 0, 5, 2};

static struct unit_solution u;
static struct ph_quad rule;
static struct ph_pieces pieces;

static void finish(void) {
  unit_solution_free(&u);
}

static void begin(void) {
  static const double alpha[] = {1, 0.7, 2, 1.2};
  ck_assert(ph_quad_gauss(&rule, 12));
  u = unit_planar_of(SOME, 4, true);
  unit_planar_atph(&u, alpha, 4);
  ck_assert_int_eq(unit_planar_solve(&u), PH_OK);
}

static enum ph_status convert(double distance, double tolerance) {
  return ph_hermite_pieces(&u.result.curve, distance, PH_E2, tolerance,
                           &u.arena, &pieces, &u.diag);
}

static ph_cplx exact(const struct ph_seg2 *seg, double at, double distance) {
  ph_cplx tangent = ph_seg2_curvature(seg, at).tangent;
  ph_cplx normal = ph_cplx_of(-tangent.im, tangent.re);
  return ph_cplx_add(ph_seg2_point(seg, &rule, at),
                     ph_cplx_scale(distance, normal));
}

/* The greatest distance of pieces and curve, at 33 points of each piece. */
static double apart(double distance) {
  double worst = 0;
  for (size_t i = 0; i < pieces.n; i++) {
    struct ph_seg2 seg = ph_seg2_of(&u.result.curve, pieces.segment[i]);
    const double *part = pieces.interval + 2 * i;
    for (size_t j = 0; j <= 32; j++) {
      double t = (double)j / 32, at = part[0] + t * (part[1] - part[0]);
      ph_cplx p = unit_bezier(pieces.control_points + 12 * i, 5, 0, t);
      worst = unit_larger(
          worst, ph_cplx_abs(ph_cplx_sub(p, exact(&seg, at, distance))));
    }
  }
  return worst;
}

PH_TEST_EACH(test_near, 3) {
  static const double distances[] = {0, 0.2, -0.2};
  const double distance = distances[_i];
  size_t before = 0;
  for (double tolerance = 1e-2; tolerance > 1e-11;
       tolerance /= unit_count(100) < 100 ? 1e4 : 100) {
    double away;
    ck_assert_int_eq(convert(distance, tolerance), PH_OK);
    ck_assert_uint_eq(pieces.degree, 5);
    ck_assert_uint_eq(pieces.dimension, 2);
    ck_assert_double_le(pieces.error, tolerance);
    away = apart(distance);
    ck_assert_double_le(away, 1.1 * pieces.error + 1e-14);
    ck_assert_double_ge(away, 0.9 * pieces.error);
    ck_assert_uint_ge(pieces.n, before);
    before = pieces.n;
  }
  ck_assert_uint_ge(before, 20);
}

/* Every segment from 0 to 1 without gaps. */
static void ck_order(size_t segments) {
  for (size_t i = 0; i < pieces.n; i++) {
    const double *part = pieces.interval + 2 * i;
    const bool first = !i || pieces.segment[i] != pieces.segment[i - 1];
    ck_assert(part[0] < part[1]);
    ck_rel(part[0], first ? 0 : part[-1], 0);
    if (first) {
      ck_assert_uint_eq(pieces.segment[i], i ? pieces.segment[i - 1] + 1 : 0);
      ck_rel(i ? part[-1] : 1, 1, 0);
    }
  }
  ck_assert_uint_eq(pieces.segment[pieces.n - 1], segments - 1);
  ck_rel(pieces.interval[2 * pieces.n - 1], 1, 0);
}

PH_TEST(test_order) {
  ck_assert_int_eq(convert(0.1, 1e-8), PH_OK);
  ck_order(4);
}

/* Where two pieces meet, and where the curve closes: the same point, and the
 * same derivatives by the knots.  Pieces of an offset take their second
 * derivative from the third of the curve, which jumps at knots: C1 there. */
PH_TEST_EACH(test_joints, 2) {
  const double *alpha = u.result.curve.preimage.alpha;
  const bool offset = _i;
  ck_assert_int_eq(convert(offset ? 0.2 : 0, 1e-6), PH_OK);
  for (size_t i = 0; i < pieces.n; i++) {
    const size_t next = (i + 1) % pieces.n;
    const size_t k[2] = {pieces.segment[i], pieces.segment[next]};
    const double *a = pieces.interval + 2 * i, *b = pieces.interval + 2 * next;
    const double h[2] = {alpha[k[0]] * (a[1] - a[0]),
                         alpha[k[1]] * (b[1] - b[0])};
    const size_t orders = offset && k[0] != k[1] ? 2 : 3;
    for (size_t order = 0; order < orders; order++) {
      ph_cplx left = unit_bezier(pieces.control_points + 12 * i, 5, order, 1);
      ph_cplx right =
          unit_bezier(pieces.control_points + 12 * next, 5, order, 0);
      left = ph_cplx_scale(pow(h[0], -(double)order), left);
      right = ph_cplx_scale(pow(h[1], -(double)order), right);
      ck_assert_double_le(ph_cplx_abs(ph_cplx_sub(left, right)),
                          order == 0   ? 1e-15
                          : order == 1 ? 1e-12
                                       : 1e-9);
    }
  }
}

/* What no halving can reach is refused. */
PH_TEST(test_refused) {
  ck_assert_int_eq(convert(0, 1e-30), PH_E_NO_CONVERGENCE);
  ck_assert_str_eq(u.diag.field, "tolerance");
}

/* ---- in space ---- */

static struct unit_curve3 c;

static void begin_space(void) {
  struct unit_random r = unit_random_of(530);
  unit_curve3_random(&c, 3, true, 0.6, &r);
  unit_solution_free(&u);
  u = (struct unit_solution){0};
}

static const struct {
  double distance;
  enum ph_normal normal;
} moves[] = {
    {0, PH_E2}, {0.2, PH_E2}, {-0.2, PH_E2}, {0.2, PH_E3}, {-0.2, PH_E3}};

enum { MOVES = COUNT(moves) };

static enum ph_status move(size_t i, double tolerance) {
  return ph_hermite_pieces(&c.curve, moves[i].distance, moves[i].normal,
                           tolerance, &u.arena, &pieces, &u.diag);
}

static double apart_in_space(size_t which) {
  double worst = 0;
  for (size_t i = 0; i < pieces.n; i++) {
    const double *part = pieces.interval + 2 * i;
    for (size_t j = 0; j <= 32; j++) {
      double t = (double)j / 32, at = part[0] + t * (part[1] - part[0]);
      ph_vec3 p = unit_bezier3(pieces.control_points + 18 * i, 5, 0, t);
      ph_vec3 wanted =
          unit_curve3_moved(&c.curve, pieces.segment[i], at,
                            moves[which].distance, moves[which].normal);
      worst = unit_larger(worst, unit_apart(p, wanted));
    }
  }
  return worst;
}

PH_TEST_EACH(test_near_in_space, MOVES) {
  bool few = unit_count(100) < 100;
  size_t before = 0;
  begin_space();
  for (double tolerance = 1e-2; tolerance > (few ? 1e-9 : 1e-11);
       tolerance /= few ? 1e3 : 100) {
    double away;
    ck_assert_int_eq(move((size_t)_i, tolerance), PH_OK);
    ck_assert_uint_eq(pieces.degree, 5);
    ck_assert_uint_eq(pieces.dimension, 3);
    ck_assert_double_le(pieces.error, tolerance);
    away = apart_in_space((size_t)_i);
    ck_assert_double_le(away, 1.1 * pieces.error + 2e-14);
    ck_assert_double_ge(away, 0.9 * pieces.error);
    ck_assert_uint_ge(pieces.n, before);
    ck_order(3);
    before = pieces.n;
  }
  ck_assert_uint_ge(before, 20);
}

/* Pieces of a segment join with two derivatives; of offsets of segments whose
 * frames join, the points do. */
PH_TEST_EACH(test_joints_in_space, MOVES) {
  begin_space();
  ck_assert_int_eq(move((size_t)_i, 1e-6), PH_OK);
  for (size_t i = 0; i + 1 < pieces.n; i++) {
    const double *a = pieces.interval + 2 * i, *p = pieces.control_points;
    const double h[2] = {a[1] - a[0], a[3] - a[2]};
    const size_t orders = pieces.segment[i] == pieces.segment[i + 1] ? 3 : 1;
    for (size_t order = 0; order < orders; order++) {
      ph_vec3 left = unit_bezier3(p + 18 * i, 5, order, 1);
      ph_vec3 right = unit_bezier3(p + 18 * (i + 1), 5, order, 0);
      left = ph_vec3_scale(pow(h[0], -(double)order), left);
      right = ph_vec3_scale(pow(h[1], -(double)order), right);
      ck_assert_double_le(unit_apart(left, right), order == 0   ? 1e-14
                                                   : order == 1 ? 1e-12
                                                                : 1e-9);
    }
  }
}

/* Where the curve all but stands still, its normal turns once, or nearly, about
 * the tangent: the offset moves aside within a short part of the segment. */
PH_TEST_EACH(test_nearly_still, MOVES) {
  const double alpha = 0.5;
  begin_space();
  for (double width = 0.1; width > 1e-8; width /= 100) {
    const ph_quat a[3] = {
        {-0.81, width, 0, 0}, {-0.31, width, 0, 0}, {0.19, width, 0, 1e-5}};
    unit_curve3_of(&c, 1, &alpha, a, ph_vec3_of(0, 0, 0));
    ck_assert_int_eq(move((size_t)_i, 1e-7), PH_OK);
    ck_assert_double_le(apart_in_space((size_t)_i), 1.1e-7);
  }
}

/* Where a curve stands still it has no normal, but Bezier pieces. */
PH_TEST(test_standstill) {
  const ph_quat a[3] = {{0, 0, 0, 0}, {1, 0.2, 0, 0.1}, {1, 0, 0.3, 0}};
  const double alpha = 1;
  begin_space();
  unit_curve3_of(&c, 1, &alpha, a, ph_vec3_of(0, 0, 0));
  ck_assert_int_eq(move(0, 1e-6), PH_OK);
  ck_assert_double_le(apart_in_space(0), 1e-6);
  for (size_t i = 1; i < MOVES; i++) {
    ck_assert_int_eq(move(i, 1e-6), PH_E_NO_CONVERGENCE);
    ck_assert_str_eq(u.diag.field, "segments[0]");
  }
}

PH_FIXTURE(begin, finish)
