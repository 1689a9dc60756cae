/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Approximation of chains of Bezier curves: what is read, what is refused, and
 * what the result says, at any place and scale. */
#include "tc_unit.h"
#include "unit.h"
#include "tc_curve_unit.h"

enum { ROOM = 512 };

/* Two cubics and a line, one after another; the line ends where all began. */
static double chain[] = {0, 0,  1, 2,  3, 2,  4, 0,  /* */
                         4, 0,  5, -2, 3, -3, 2, -2, /* */
                         2, -2, 0, 0};
static size_t chain_sizes[] = {4, 4, 2};

static struct ph_value polyline(double *v, size_t *sizes, size_t n) {
  struct ph_value value = {
      .kind = PH_POLYLINE, .v = v, .dimension = 2, .sizes = sizes};
  value.sizes_n = n;
  for (size_t k = 0; k < n; k++) {
    value.n += sizes[k];
  }
  return value;
}

static struct unit_solution chain_to(double tolerance) {
  struct unit_solution s = {.result = {.offsets_n = 0}};
  *unit_tc_field(&s, PH_F_CURVE) = polyline(chain, chain_sizes, 3);
  unit_set_number(&s.problem, PH_F_TOLERANCE, tolerance);
  return s;
}

static struct unit_solution curve_to(double *v, size_t n, double tolerance) {
  struct unit_solution s = {.result = {.offsets_n = 0}};
  unit_set_array(&s.problem, PH_F_CURVE, v, n, 2);
  unit_set_number(&s.problem, PH_F_TOLERANCE, tolerance);
  return s;
}

static double distance_of(const struct unit_solution *s) {
  ck_assert(s->result.diagnostics.known >> PH_D_DISTANCE & 1);
  return s->result.diagnostics.value[PH_D_DISTANCE];
}

/* The cubics of one Bezier curve p: they begin and end at its own points, no
 * point of them is further away than claimed, and they meet on it at their
 * knots, but in the middle of a pair. */
static void check_piece(const struct unit_solution *s, size_t k,
                        const double *v, size_t n, double rounding) {
  const struct ph_curve *curve = &s->result.curve;
  const struct ph_interval *at = &s->result.intervals[k];
  const double *first = ph_curve_points(curve, at->first);
  const double *last = ph_curve_points(curve, at->last);
  ph_cplx p[ROOM];
  struct ph_tc_bezier b = {p, n - 1, 0};
  double length = 0;
  bool was_on = false;
  ck_assert_uint_le(n, ROOM);
  for (size_t i = 0; i < n; i++) {
    p[i] = unit_get(v + 2 * i);
  }
  ck_assert_int_eq(memcmp(first, v, 2 * sizeof *v), 0);
  ck_assert_int_eq(memcmp(last + 6, v + 2 * (n - 1), 2 * sizeof *v), 0);
  ck_abs(curve->knots[at->first], (double)k, 0);
  ck_abs(curve->knots[at->last + 1], (double)k + 1, 0);
  for (size_t i = at->first; i <= at->last; i++) {
    const double *q = ph_curve_points(curve, i);
    ph_cplx on = unit_bezier_at(&b, curve->knots[i] - (double)k);
    bool is_on = unit_distance(on, unit_get(q)) <= rounding;
    ck_assert_double_lt(curve->knots[i], curve->knots[i + 1]);
    ck_assert(was_on || is_on);
    was_on = is_on;
    for (size_t j = 1; j < 5; j++) {
      ph_cplx r = unit_bezier(q, 3, 0, (double)j / 5);
      ck_assert_double_le(unit_bezier_away(&b, r), distance_of(s));
    }
    length += curve->lengths[i];
  }
  ck_rel(at->length, length, 1e-14);
}

static void check_chain(const struct unit_solution *s) {
  const struct ph_value *value = &s->problem.field[PH_F_CURVE];
  const struct ph_result *r = &s->result;
  size_t pieces = value->kind == PH_POLYLINE ? value->sizes_n : 1, at = 0;
  double size = 0, length = 0;
  for (size_t i = 0; i < 2 * value->n; i++) {
    size = unit_larger(size, fabs(value->v[i]));
  }
  ck_assert_int_eq(r->curve.kind, PH_CURVE_TC);
  ck_assert_uint_eq(r->intervals_n, pieces);
  ck_assert_uint_eq(r->intervals[0].first, 0);
  ck_assert_uint_eq(r->intervals[pieces - 1].last, r->curve.n - 1);
  for (size_t k = 0; k < pieces; k++) {
    size_t n = value->kind == PH_POLYLINE ? value->sizes[k] : value->n;
    check_piece(s, k, value->v + 2 * at, n, 8 * DBL_EPSILON * size);
    ck_assert_int_eq(r->intervals[k].root, PH_ROOT_N);
    ck_assert(k == 0 || r->intervals[k].first == r->intervals[k - 1].last + 1);
    length += r->intervals[k].length;
    at += n;
  }
  ck_rel(r->curve.length, length, 1e-14);
  ck_abs(r->diagnostics.value[PH_D_ITERATIONS], 0, 0);
  ck_assert_double_le(r->diagnostics.value[PH_D_RESIDUAL], 1e-14);
}

/* ---- what is read -------------------------------------------------------- */

PH_TEST(test_chain) {
  for (double tolerance = 1e-1; tolerance > 1e-6; tolerance /= 100) {
    struct unit_solution s = chain_to(tolerance);
    unit_tc_solve_ok(&s);
    check_chain(&s);
    ck_assert(!s.result.curve.closed);
    ck_assert_double_le(distance_of(&s), tolerance);
    ck_assert_uint_eq(s.result.intervals[2].first,
                      s.result.intervals[2].last); /* the line */
    unit_tc_flag(&s, PH_F_CLOSED);
    unit_tc_solve_ok(&s);
    check_chain(&s);
    ck_assert(s.result.curve.closed);
    unit_solution_free(&s);
  }
}

/* One curve by itself, in a list of one, and as points. */
PH_TEST(test_one_curve) {
  struct unit_solution s = curve_to(chain, 4, 1e-3);
  struct unit_solution t = {.problem = s.problem}, u = {.problem = s.problem};
  *unit_tc_field(&t, PH_F_CURVE) = polyline(chain, chain_sizes, 1);
  *unit_tc_field(&u, PH_F_CURVE) = (struct ph_value){.kind = PH_ABSENT};
  unit_set_array(&u.problem, PH_F_POINTS, chain, 4, 2);
  unit_set_word(&u.problem, PH_F_MODE, "approximate");
  unit_tc_solve_ok(&s);
  unit_tc_solve_ok(&t);
  unit_tc_solve_ok(&u);
  check_chain(&s);
  check_chain(&t);
  ck_assert_uint_eq(t.result.curve.n, s.result.curve.n);
  ck_assert_uint_eq(u.result.curve.n, s.result.curve.n);
  ck_abs(unit_curves_apart(&s.result.curve, &t.result.curve), 0, 0);
  ck_abs(unit_curves_apart(&s.result.curve, &u.result.curve), 0, 0);
  unit_solution_free(&s);
  unit_solution_free(&t);
  unit_solution_free(&u);
}

/* As many cubics as asked for, at most, and the more the nearer. */
PH_TEST(test_pieces) {
  double before = HUGE_VAL;
  for (int pieces = 3; pieces <= 24; pieces *= 2) {
    struct unit_solution s = chain_to(1);
    *unit_tc_field(&s, PH_F_TOLERANCE) = (struct ph_value){.kind = PH_ABSENT};
    unit_set_number(&s.problem, PH_F_PIECES, pieces > 3 ? pieces : 2);
    if (pieces == 3) {
      unit_tc_refused(&s, PH_E_BAD_VALUE, "pieces",
                      "must be at least 3, one for each curve, found 2");
    } else {
      unit_tc_solve_ok(&s);
      check_chain(&s);
      ck_assert_uint_le(s.result.curve.n, (size_t)pieces);
      ck_assert_double_lt(distance_of(&s), before);
      before = distance_of(&s);
    }
    unit_solution_free(&s);
  }
}

/* A Tschirnhausen cubic is one. */
PH_TEST(test_own_cubic) {
  struct unit_random r = unit_random_of(1);
  for (int i = 0; i < unit_count(20); i++) {
    struct unit_cubics c;
    struct unit_solution s;
    double turn = unit_random_in(&r, -0.7, 0.7);
    double grow = unit_random_in(&r, 0.7, 1.5);
    ph_cplx w0 = ph_cplx_polar(unit_random_in(&r, -3, 3));
    unit_cubics_begin(&c, unit_random_cplx(&r, 1));
    unit_cubics_add(&c, w0,
                    ph_cplx_scale(grow, ph_cplx_mul(w0, ph_cplx_polar(turn))));
    s = curve_to(c.control_points, 4, 1e-9);
    unit_tc_solve_ok(&s);
    check_chain(&s);
    ck_assert_uint_eq(s.result.curve.n, 1);
    ck_assert_double_le(unit_curves_apart(&s.result.curve, &c.curve), 1e-13);
    ck_rel(s.result.curve.length, c.curve.length, 1e-13);
    unit_solution_free(&s);
  }
}

/* ---- what is refused ----------------------------------------------------- */

PH_TEST(test_goal) {
  const double bad_tolerance[] = {0, -1, (double)NAN};
  const double bad_pieces[] = {0, -1, 2.5, 1000001, (double)NAN};
  struct unit_solution s = chain_to(1);
  unit_set_number(&s.problem, PH_F_PIECES, 5);
  unit_tc_refused(&s, PH_E_BAD_VALUE, "pieces", "excludes tolerance");
  *unit_tc_field(&s, PH_F_TOLERANCE) = (struct ph_value){.kind = PH_ABSENT};
  for (size_t i = 0; i < COUNT(bad_pieces); i++) {
    *unit_tc_field(&s, PH_F_PIECES) =
        (struct ph_value){.kind = PH_NUMBER, .number = bad_pieces[i]};
    unit_tc_refused(&s, PH_E_BAD_VALUE, "pieces",
                    "must be a whole number from 1 to 1000000, found ");
  }
  *unit_tc_field(&s, PH_F_PIECES) = (struct ph_value){.kind = PH_ABSENT};
  unit_tc_refused(&s, PH_E_MISSING_FIELD, "tolerance", "or pieces is required");
  for (size_t i = 0; i < COUNT(bad_tolerance); i++) {
    *unit_tc_field(&s, PH_F_TOLERANCE) =
        (struct ph_value){.kind = PH_NUMBER, .number = bad_tolerance[i]};
    unit_tc_refused(&s, PH_E_BAD_VALUE, "tolerance",
                    "must be greater than 0, found ");
  }
  unit_solution_free(&s);
}

PH_TEST(test_fields) {
  struct unit_solution s = chain_to(1);
  unit_set_array(&s.problem, PH_F_POINTS, chain, 4, 2);
  unit_tc_refused(&s, PH_E_BAD_VALUE, "points", "excludes curve");
  *unit_tc_field(&s, PH_F_POINTS) = (struct ph_value){.kind = PH_ABSENT};
  *unit_tc_field(&s, PH_F_CURVE) = (struct ph_value){.kind = PH_ABSENT};
  unit_set_word(&s.problem, PH_F_MODE, "approximate");
  unit_tc_refused(&s, PH_E_MISSING_FIELD, "curve",
                  "is required by the mode approximate");
  *unit_tc_field(&s, PH_F_CURVE) = polyline(chain, chain_sizes, 0);
  unit_tc_refused(&s, PH_E_TOO_FEW_POINTS, "curve", "has no curves");
  unit_solution_free(&s);
}

/* Curves of too few points, of none but one place, and of too many. */
PH_TEST(test_points) {
  static double many[2 * 2 * ROOM];
  double same[] = {0, 0, 1, 1, 1, 1, 1, 1, 1, 1};
  size_t one[] = {4, 1}, three[] = {2, 3}, most[] = {2, PH_TC_DEGREE_MAX + 2};
  struct unit_solution s = curve_to(chain, 1, 1);
  unit_tc_refused(&s, PH_E_TOO_FEW_POINTS, "curve",
                  "must have at least 2 control points");
  *unit_tc_field(&s, PH_F_CURVE) = polyline(chain, one, 2);
  unit_tc_refused(&s, PH_E_TOO_FEW_POINTS, "curve[1]",
                  "must have at least 2 control points");
  *unit_tc_field(&s, PH_F_CURVE) = polyline(same, three, 2);
  unit_tc_refused(&s, PH_E_COINCIDENT_POINTS, "curve[1]", "are all the same");
  unit_set_array(&s.problem, PH_F_CURVE, same + 2, 4, 2);
  unit_tc_refused(&s, PH_E_COINCIDENT_POINTS, "curve", "are all the same");
  for (size_t i = 0; i < 2 * ROOM; i++) {
    many[2 * i] = (double)i;
  }
  many[4] = many[2];
  *unit_tc_field(&s, PH_F_CURVE) = polyline(many, most, 2);
  unit_tc_refused(&s, PH_E_BAD_VALUE, "curve[1]",
                  "has degree 501, at most 500 is allowed");
  unit_set_array(&s.problem, PH_F_CURVE, many, PH_TC_DEGREE_MAX + 2, 2);
  unit_tc_refused(&s, PH_E_BAD_VALUE, "curve",
                  "has degree 501, at most 500 is allowed");
  unit_set_array(&s.problem, PH_F_CURVE, many, PH_TC_DEGREE_MAX + 1, 2);
  unit_tc_solve_ok(&s);
  ck_assert_uint_eq(s.result.curve.n, 1);
  ck_rel(s.result.curve.length, PH_TC_DEGREE_MAX, 1e-14);
  unit_solution_free(&s);
}

/* Ends that do not meet; where they differ by rounding alone the later start
 * is taken. */
PH_TEST(test_joints) {
  double v[COUNT(chain)];
  struct unit_solution s = chain_to(1e-3);
  unit_tc_field(&s, PH_F_CURVE)->v = v;
  memcpy(v, chain, sizeof v);
  v[8] = 4 * (1 + DBL_EPSILON);
  unit_tc_solve_ok(&s);
  ck_abs(ph_curve_points(&s.result.curve, s.result.intervals[0].last)[6], v[8],
         0);
  ck_abs(ph_curve_points(&s.result.curve, s.result.intervals[1].first)[0], v[8],
         0);
  v[8] = 4 + 1e-12;
  unit_tc_refused(&s, PH_E_BAD_VALUE, "curve[1]",
                  "must begin where curve[0] ends");
  memcpy(v, chain, sizeof v);
  v[17] = -2.5;
  unit_tc_refused(&s, PH_E_BAD_VALUE, "curve[2]",
                  "must begin where curve[1] ends");
  memcpy(v, chain, sizeof v);
  v[19] = 1e-12;
  unit_tc_solve_ok(&s);
  check_chain(&s);
  unit_tc_flag(&s, PH_F_CLOSED);
  unit_tc_refused(&s, PH_E_BAD_VALUE, "curve",
                  "must end where it begins if closed");
  unit_solution_free(&s);
}

/* ---- place and scale ----------------------------------------------------- */

/* Far from the origin the claim has the rounding of coordinates in it, and no
 * tolerance is met that is below it. */
PH_TEST(test_far) {
  const double far = 1e6, rounding = 4 * DBL_EPSILON * far;
  double v[COUNT(chain)];
  struct unit_solution s = chain_to(1e-6);
  unit_tc_field(&s, PH_F_CURVE)->v = v;
  for (size_t i = 0; i < COUNT(v); i++) {
    v[i] = chain[i] + (i % 2 ? -far : far);
  }
  unit_tc_solve_ok(&s);
  check_chain(&s);
  ck_assert_double_le(distance_of(&s), 1e-6);
  ck_assert_double_gt(distance_of(&s), rounding);
  unit_set_number(&s.problem, PH_F_TOLERANCE, 0.9 * rounding);
  unit_tc_refused(&s, PH_E_NO_CONVERGENCE, "tolerance",
                  "is no larger than the rounding of coordinates");
  *unit_tc_field(&s, PH_F_TOLERANCE) = (struct ph_value){.kind = PH_ABSENT};
  unit_set_number(&s.problem, PH_F_PIECES, 10);
  unit_tc_solve_ok(&s);
  check_chain(&s);
  ck_assert_uint_le(s.result.curve.n, 10);
  unit_solution_free(&s);
}

/* The same cubics near the ends of the range of doubles. */
PH_TEST(test_scale) {
  const int exponents[] = {-996, 996};
  struct unit_solution s = chain_to(1e-3);
  unit_tc_solve_ok(&s);
  for (size_t k = 0; k < COUNT(exponents); k++) {
    const int e = exponents[k];
    struct unit_solution t = chain_to(ldexp(1e-3, e));
    const struct ph_curve *a = &s.result.curve, *b = &t.result.curve;
    double v[COUNT(chain)];
    for (size_t i = 0; i < COUNT(v); i++) {
      v[i] = ldexp(chain[i], e);
    }
    unit_tc_field(&t, PH_F_CURVE)->v = v;
    unit_tc_solve_ok(&t);
    ck_assert_uint_eq(a->n, b->n);
    for (size_t i = 0; i <= a->n; i++) {
      ck_abs(b->knots[i], a->knots[i], 0);
    }
    for (size_t i = 0; i < 8 * a->n; i++) {
      ck_abs(ldexp(b->control_points[i], -e), a->control_points[i], 1e-15);
    }
    ck_rel(ldexp(b->length, -e), a->length, 1e-15);
    ck_rel(ldexp(distance_of(&t), -e), distance_of(&s), 1e-15);
    unit_solution_free(&t);
  }
  unit_solution_free(&s);
}
