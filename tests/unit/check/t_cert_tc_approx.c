/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The certificate of Tschirnhausen cubics that approximate a chain of Bezier
 * curves.  The approximations are pairs with the derivatives of the curve
 * [BYR11, sec. 5.4], or cubics that are the curve.
 */
#include "cert_tc_unit.h"
#include "planar_unit.h"
#include "unit.h"

static const double MOVED = 1e-9;

enum { DEGREE = 7, PIECES = 2, PAIRS = 6, GIVEN = PIECES * (DEGREE + 1) };

/* Two curves that meet at an angle. */
static const double SOME[2 * GIVEN] = {0, 0, 1, 2, 2.5, 2, 3.5, -1, 5, -1, 6,
                                       1, 7, 2, 8, 1,   8, 1,   9,  4, 8,  5,
                                       7, 5, 5, 6, 4,   6, 3,   8,  1, 8};

static double given[2 * GIVEN];
static size_t sizes[PIECES] = {DEGREE + 1, DEGREE + 1};

static void say_chain(size_t pieces) {
  unit_tc.problem.field[PH_F_CURVE] =
      (struct ph_value){.kind = PH_POLYLINE,
                        .v = given,
                        .n = pieces * (DEGREE + 1),
                        .dimension = 2,
                        .sizes = sizes,
                        .sizes_n = pieces};
}

/* A pair for the part [from,to] of a curve; the derivative at its start is
 * turned. */
static void add_part(const double *p, double from, double to, double turn) {
  double h = 0.5 * (to - from), end[2];
  ph_cplx a = unit_bezier(p, DEGREE, 0, from),
          b = unit_bezier(p, DEGREE, 0, to);
  size_t n = unit_tc.c.curve.n;
  double knot = unit_tc.c.knots[n];
  unit_put(end, b);
  unit_tc.c.at = a;
  unit_add_pair(ph_cplx_mul(ph_cplx_polar(turn),
                            ph_cplx_scale(h, unit_bezier(p, DEGREE, 1, from))),
                ph_cplx_scale(h, unit_bezier(p, DEGREE, 1, to)),
                ph_cplx_sub(b, a), end);
  unit_tc.c.knots[n + 1] = floor(knot) + 0.5 * (from + to);
  unit_tc.c.knots[n + 2] = floor(knot) + to;
}

/* Pairs for both curves; the start of one of them is turned. */
static void approximate(double scale, double offset, size_t which,
                        double turn) {
  unit_cert_begin();
  for (size_t i = 0; i < 2 * GIVEN; i++) {
    given[i] = offset + scale * SOME[i];
  }
  unit_cubics_begin(&unit_tc.c, ph_cplx_of(0, 0));
  for (size_t i = 0; i < PIECES * PAIRS; i++) {
    size_t k = i % PAIRS;
    add_part(given + i / PAIRS * 2 * (DEGREE + 1), (double)k / PAIRS,
             (double)(k + 1) / PAIRS, i == which ? turn : 0);
  }
  say_chain(PIECES);
}

static void start(void) {
  approximate(1, 0, 0, 0);
}

/* The largest distance of points from chords, of both curves, by the parts that
 * pairs stand for. */
static double seen(void) {
  enum { N = 100 };
  double largest = 0;
  for (size_t i = 0; i < PIECES * PAIRS; i++) {
    ph_cplx at[2][2 * N + 1];
    for (int j = 0; j <= 2 * N; j++) {
      double t = (double)j / N, u = t <= 1 ? t : t - 1;
      const double *p = given + i / PAIRS * 2 * (DEGREE + 1);
      at[0][j] =
          unit_bezier(p, DEGREE, 0, ((double)(i % PAIRS) + 0.5 * t) / PAIRS);
      at[1][j] = unit_curve(&unit_tc.c.curve, 2 * i + (t > 1), 0, u);
    }
    for (int j = 0; j <= 4 * N; j++) {
      const ph_cplx *from = at[j % 2], *to = at[1 - j % 2];
      double nearest = HUGE_VAL;
      for (int k = 0; k < 2 * N; k++) {
        ph_cplx along = ph_cplx_sub(to[k + 1], to[k]);
        ph_cplx p = ph_cplx_sub(from[j / 2], to[k]);
        double t = ph_cplx_dot(p, along) / ph_cplx_norm2(along);
        t = t > 0 ? t : 0;
        t = t < 1 ? t : 1;
        nearest = fmin(nearest, unit_distance(p, ph_cplx_scale(t, along)));
      }
      largest = unit_larger(largest, nearest);
    }
  }
  return largest;
}

PH_TEST(test_pairs) {
  static const double scales[] = {1e-9, 1, 1e9};
  double distance = 0;
  for (size_t i = 0; i < 3; i++) {
    for (int far = 0; far < 2; far++) {
      double tiny = far ? 1e-7 : 1e-13, found;
      approximate(scales[i], far ? 1e6 * scales[i] : 0, 0, 0);
      ck_accepted();
      ck_assert_double_le(value_of(PH_D_INTERPOLATION_ERROR), tiny);
      ck_assert_double_le(value_of(PH_D_TANGENT_ERROR), tiny);
      ck_assert_double_le(value_of(PH_D_PYTHAGOREAN_ERROR), tiny);
      ck_assert_double_le(value_of(PH_D_CONTINUITY_ERROR), tiny);
      ck_assert_double_le(value_of(PH_D_LENGTH_ERROR), tiny);
      ck_assert(!is_known(PH_D_END_DERIVATIVE_ERROR));
      ck_abs(value_of(PH_D_REGULAR), 1, 0);
      found = value_of(PH_D_DISTANCE) / scales[i];
      distance = distance > 0 ? distance : found;
      ck_rel(found, distance, 1e-4);
    }
  }
  start();
  ck_assert_double_ge(distance, seen() * (1 - 1e-3));
  ck_assert_double_le(distance, seen() * 1.08);
}

/* One curve, as control points in the field points. */
PH_TEST(test_points) {
  start();
  unit_tc.c.curve.n = 2 * PAIRS;
  unit_tc.c.curve.length = 0;
  for (size_t k = 0; k < 2 * PAIRS; k++) {
    unit_tc.c.curve.length += unit_tc.c.lengths[k];
  }
  unit_tc.problem.field[PH_F_CURVE].kind = PH_ABSENT;
  unit_set_array(&unit_tc.problem, PH_F_POINTS, given, DEGREE + 1, 2);
  unit_set_word(&unit_tc.problem, PH_F_MODE, "approximate");
  ck_accepted();
  unit_tc.problem.field[PH_F_MODE].kind = PH_ABSENT;
  unit_set_array(&unit_tc.problem, PH_F_CURVE, given, DEGREE + 1, 2);
  ck_accepted();
}

static void claim(double distance) {
  checked.claims.known = 0;
  ph_diagnostics_set(&checked.claims, PH_D_DISTANCE, distance);
}

/* A claim is kept if it is confirmed, and else corrected; the tolerance is what
 * counts. */
PH_TEST(test_distance) {
  static const double claims[] = {0.9, 0, (double)NAN};
  double found;
  start();
  ck_accepted();
  found = value_of(PH_D_DISTANCE);
  claim(found);
  ck_accepted();
  ck_rel(value_of(PH_D_DISTANCE), found, 0.05);
  ck_assert_double_le(value_of(PH_D_DISTANCE), found);
  for (size_t i = 0; i < 3; i++) {
    claim(claims[i] * found);
    unit_tc.problem.field[PH_F_TOLERANCE].kind = PH_ABSENT;
    ck_accepted();
    ck_assert_double_ge(value_of(PH_D_DISTANCE), 0.94 * found);
    unit_set_number(&unit_tc.problem, PH_F_TOLERANCE, found);
    ck_accepted();
    unit_set_number(&unit_tc.problem, PH_F_TOLERANCE, 0.9 * found);
    ck_refused_somewhere(PH_D_DISTANCE);
  }
  checked.claims.known = 0;
  ck_refused_somewhere(PH_D_DISTANCE);
}

PH_TEST(test_number) {
  start();
  unit_set_number(&unit_tc.problem, PH_F_PIECES, 2 * PIECES * PAIRS);
  ck_accepted();
  unit_set_number(&unit_tc.problem, PH_F_PIECES, 2 * PIECES * PAIRS - 1);
  ck_assert_int_eq(certify(), PH_E_NO_CONVERGENCE);
  ck_assert_str_eq(checked.diag.field, "segments");
  ck_assert_str_eq(checked.diag.message,
                   "is refused by its certificate: there are 24, at most 23 "
                   "are allowed");
  sizes[0] = 1; /* no curve */
  ck_assert_int_eq(certify(), PH_E_INTERNAL);
  sizes[0] = DEGREE + 1;
}

/* Knots that do not go through the chain. */
PH_TEST(test_knots) {
  static const struct {
    size_t k;
    double knot;
  } wrong[] = {{0, 1e-9},
               {0, -1e-9},
               {3, 0.1},
               {5, 0.9},
               {2 * PAIRS, 1 + 1e-9},
               {2 * PAIRS, 1 - 1e-9},
               {4 * PAIRS, 2 + 1e-9},
               {4 * PAIRS, 2 - 1e-9},
               {4 * PAIRS, (double)NAN}};
  for (size_t i = 0; i < COUNT(wrong); i++) {
    start();
    unit_tc.c.knots[wrong[i].k] = wrong[i].knot;
    ck_assert_int_eq(certify(),
                     isnan(wrong[i].knot) ? PH_E_TOO_LARGE : PH_E_INTERNAL);
  }
  start();
  say_chain(1);
  ck_assert_int_eq(certify(), PH_E_INTERNAL);
  start();
  unit_tc.c.knots[2] += 1e-6; /* the end of the first pair */
  ck_assert_int_eq(certify(), PH_E_NO_CONVERGENCE);
}

/* Every control point of the curve, and of what is given, matters. */
PH_TEST(test_control_points) {
  start();
  for (size_t i = 0; i < 8 * 2 * PIECES * PAIRS; i++) {
    double *x = &unit_tc.c.control_points[i], keep = *x;
    *x += 10 * MOVED;
    ck_assert_int_eq(certify(), PH_E_NO_CONVERGENCE);
    *x = keep;
  }
  for (size_t i = 0; i < 2 * GIVEN; i++) {
    given[i] += 1000 * MOVED;
    ck_assert_int_eq(certify(), PH_E_NO_CONVERGENCE);
    given[i] -= 1000 * MOVED;
  }
  ck_accepted();
}

/* One pair starts in another direction: at the start of a curve it is not its
 * tangent, elsewhere there is a kink. */
PH_TEST(test_tangents) {
  for (size_t i = 0; i < PIECES * PAIRS; i++) {
    approximate(1, 0, i, MOVED);
    ck_refused(i % PAIRS == 0 ? PH_D_TANGENT_ERROR : PH_D_CONTINUITY_ERROR,
               2 * i);
  }
}

/* An inner joint is on no curve: two in a row are one too many. */
PH_TEST(test_joints) {
  start();
  ck_accepted();
  for (size_t i = 0; i < 8; i++) {
    given[i] = unit_tc.c.control_points[i];
  }
  /* now the first curve is of degree 3, and its second part is missed */
  sizes[0] = 4;
  memmove(given + 8, given + 2 * (DEGREE + 1),
          2 * (DEGREE + 1) * sizeof(double));
  unit_tc.problem.field[PH_F_CURVE].n -= DEGREE + 1 - 4;
  ck_assert_int_eq(certify(), PH_E_NO_CONVERGENCE);
  sizes[0] = DEGREE + 1;
}

/* Cubics that are the curve: parts [u,v] of w have w(u) sqrt(v-u), ... */
PH_TEST(test_parts_of_a_cubic) {
  static const double cuts[] = {0, 0.3, 0.55, 1};
  const ph_cplx w0 = {1, 0.2}, w1 = {0.6, 0.9};
  unit_cert_begin();
  unit_cubics_begin(&unit_tc.c, ph_cplx_of(2, 1));
  unit_cubics_add(&unit_tc.c, w0, w1);
  memcpy(given, unit_tc.c.control_points, 8 * sizeof(double));
  unit_set_array(&unit_tc.problem, PH_F_CURVE, given, 4, 2);
  ck_accepted();
  ck_assert_double_le(value_of(PH_D_DISTANCE), 1e-13);
  unit_cubics_begin(&unit_tc.c, ph_cplx_of(2, 1));
  for (size_t k = 0; k < 3; k++) {
    double u = cuts[k], v = cuts[k + 1], root = sqrt(v - u);
    ph_cplx a = ph_cplx_add(ph_cplx_scale(1 - u, w0), ph_cplx_scale(u, w1));
    ph_cplx b = ph_cplx_add(ph_cplx_scale(1 - v, w0), ph_cplx_scale(v, w1));
    unit_cubics_add(&unit_tc.c, ph_cplx_scale(root, a), ph_cplx_scale(root, b));
    unit_tc.c.knots[k + 1] = v;
  }
  ck_accepted();
  ck_assert_double_le(value_of(PH_D_DISTANCE), 1e-13);
  claim(1e-15); /* no more than rounding is amiss */
  ck_accepted();
  ck_assert_double_le(value_of(PH_D_DISTANCE), 1e-15);
  unit_tc.c.knots[1] += 1e-4;
  ck_assert_int_eq(certify(), PH_E_NO_CONVERGENCE);
}

/* A line on which a cubic is so slow at its end that its last leg is lost to
 * rounding: a joint on the curve for all that, with no derivative to agree in.
 */
PH_TEST(test_no_direction) {
  static const double line[] = {0, 0, 1, 0, 2, 0, 3, 0};
  const double slow = 1e-10; /* root^2 + root slow + slow^2 = 4.5 */
  const double root = (sqrt(18 - 3 * slow * slow) - slow) / 2;
  unit_cert_begin();
  memcpy(given, line, sizeof line);
  unit_set_array(&unit_tc.problem, PH_F_CURVE, given, 4, 2);
  unit_cubics_begin(&unit_tc.c, ph_cplx_of(0, 0));
  unit_cubics_add(&unit_tc.c, ph_cplx_of(root, 0), ph_cplx_of(slow, 0));
  unit_cubics_add(&unit_tc.c, ph_cplx_of(sqrt(1.5), 0),
                  ph_cplx_of(sqrt(1.5), 0));
  unit_tc.c.knots[1] = 0.5;
  unit_tc.c.knots[2] = 1;
  ck_abs(unit_tc.c.control_points[4], unit_tc.c.control_points[6], 0);
  ck_accepted();
  ck_assert_double_le(value_of(PH_D_DISTANCE), 1e-9);
}
