/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The method `planar`: what it refuses and how it says so, what it assumes
 * where the problem is silent, what it warns of. */
#include "unit.h"
#include "segment_unit.h"
#include "planar_unit.h"

#include "curve/cross/cross.h"
#include "curve/fair/energy.h"
#include "solve/method.h"

static const double PI = 3.14159265358979323846;

/* Four points with nothing special about them. */
static const double SOME[] = {0, 0, 2, 1, 3, 0, 5, 2};

static struct unit_solution u;

static void finish(void) {
  unit_solution_free(&u);
}

static void begin(const double *v, size_t n, bool closed) {
  unit_solution_free(&u);
  u = unit_planar_of(v, n, closed);
}

#define POINTS(closed, ...) \
  begin((double[]){__VA_ARGS__}, sizeof((double[]){__VA_ARGS__}) / 16, closed)
#define KNOTS(...)                               \
  unit_planar_knots(&u, (double[]){__VA_ARGS__}, \
                    sizeof((double[]){__VA_ARGS__}) / 8)
#define ENDS(...) unit_planar_ends(&u, (double[]){__VA_ARGS__})

static void ck_solved(void) {
  enum ph_status status = unit_planar_solve(&u);
  ck_assert_msg(status == PH_OK, "%s %s", u.diag.field, u.diag.message);
}

static void ck_refused(enum ph_status status, const char *field,
                       const char *message) {
  ck_assert_int_eq(unit_planar_solve(&u), status);
  ck_assert_str_eq(u.diag.field, field);
  ck_assert_str_eq(u.diag.message, message);
}

PH_TEST(test_method) {
  ck_assert_str_eq(ph_method_planar.schema.command, "planar");
  ck_assert_uint_eq(ph_method_planar.dimension, 2);
  for (size_t i = 0; i < ph_method_planar.schema.fields_n; i++) {
    const struct ph_field *row = &ph_method_planar.schema.fields[i];
    ck_assert_int_eq(row->required, row->id == PH_F_POINTS);
    ck_assert(row->required == (row->standard == NULL));
  }
}

PH_TEST(test_too_few_points) {
  begin(SOME, 0, true);
  ck_refused(PH_E_TOO_FEW_POINTS, "points",
             "must be at least 3 different points for a closed curve, found 0");
}

PH_TEST(test_coincident_points) {
  POINTS(false, 0, 0, 1, 1, 1, 1, 2, 0);
  ck_refused(PH_E_COINCIDENT_POINTS, "points[2]",
             "coincides with points[1]" JOINS);
  /* Equal up to rounding of the coordinates, which may be far from 0. */
  POINTS(false, 0, 0, 1, 1, 1 + 4e-16, 1, 2, 0);
  ck_refused(PH_E_COINCIDENT_POINTS, "points[2]",
             "coincides with points[1]" JOINS);
  POINTS(false, 1e12, 0, 1e12 + 1, 0, 1e12 + 1.001, 0);
  ck_refused(PH_E_COINCIDENT_POINTS, "points[2]",
             "coincides with points[1]" JOINS);
  /* A second repetition of the first point closes nothing. */
  POINTS(true, 0, 0, 1, 1, 2, 0, 0, 0, 0, 0);
  ck_refused(PH_E_COINCIDENT_POINTS, "points[0]",
             "coincides with points[3]" JOINS);
}

PH_TEST(test_points_not_consecutive_may_coincide) {
  POINTS(false, 0, 0, 1, 1, 0, 0, 1, 1);
  ck_solved();
  POINTS(true, 0, 0, 1, 0, 0, 1, 1, 0, 1, 1);
  ck_solved();
}

PH_TEST(test_knots_refused) {
  POINTS(false, 0, 0, 1, 1, 2, 0);
  KNOTS(0, 1, 2, 3);
  ck_refused(PH_E_BAD_SHAPE, "knots",
             "must have 3 numbers, one for each point, found 4");
  KNOTS(0, -0.5, 1);
  ck_refused(PH_E_BAD_VALUE, "knots[1]",
             "must be greater than the knot before, 0, found -0.5");
  KNOTS(-1.7e308, 1.7e308, 1.75e308);
  ck_refused(PH_E_TOO_LARGE, "knots[1]",
             "differs from the knot before by more than a double can hold");
  POINTS(false, -1.7e308, 0, 1.7e308, 1);
  ck_refused(PH_E_TOO_LARGE, "knots", "span more than a double can hold");
}

PH_TEST(test_ends_refused) {
  POINTS(false, 0, 0, 1, 1, 2, 0);
  ENDS(0, 0, 0, 1);
  ck_refused(PH_E_ZERO_TANGENT, "end_derivatives[0]", "must not be zero");
  ENDS(1, 0, 0, -0.0);
  ck_refused(PH_E_ZERO_TANGENT, "end_derivatives[1]", "must not be zero");
  ENDS(1e308, 1e308, 1, 0);
  u.problem.field[PH_F_POINTS].v[2] = 1e-10;
  u.problem.field[PH_F_POINTS].v[3] = 1e-10;
  u.problem.field[PH_F_POINTS].v[4] = 2e-10;
  ck_refused(PH_E_TOO_LARGE, "end_derivatives[0]",
             "is too large for these points");
}

PH_TEST(test_no_convergence) {
  POINTS(false, 0, 0, 1, 1, 2, 0);
  ENDS(1e150, 0, 0, 1);
  ck_assert_int_eq(unit_planar_solve(&u), PH_E_NO_CONVERGENCE);
  ck_assert_str_eq(u.diag.field, "segments[1]");
  ck_assert_ptr_nonnull(strstr(u.diag.message, "does not close: the best "
                                               "relative residual reached is"));
}

/* Of random points no solution is fairer than the good one, but one that
 * crosses itself where the good one does not. */
PH_TEST_EACH(test_fairest, 4) {
  struct unit_random r = unit_random_of(2200 + (uint64_t)_i);
  for (int i = 0; i < unit_count(40); i++) {
    size_t n = 4 + (size_t)i % 4, good;
    double v[14], ies[256];
    bool simple[256];
    for (size_t j = 0; j < 2 * n; j++) {
      v[j] = unit_random_in(&r, 0, 1);
    }
    begin(v, n, _i % 2 == 1);
    if (_i >= 2) {
      unit_set_word(&u.problem, PH_F_BASIS, "atph");
    }
    unit_set_word(&u.problem, PH_F_SOLUTIONS, "all");
    ck_solved();
    good = u.result.solutions_n;
    ck_assert_uint_le(good, 256);
    for (size_t k = 0; k < u.result.solutions_n; k++) {
      const struct ph_solution *s = &u.result.solutions[k];
      struct ph_energy energy;
      struct ph_cross cross;
      ck_assert(ph_energy_planar(&s->curve, &energy));
      ck_assert_int_eq(ph_cross_planar(&s->curve, &unit_arena, &cross, &u.diag),
                       PH_OK);
      ies[k] = energy.ies;
      simple[k] = cross.simple;
      good = s->good ? k : good;
    }
    ck_assert_uint_lt(good, u.result.solutions_n);
    for (size_t k = 0; k < u.result.solutions_n; k++) {
      ck_assert(!(ies[k] < ies[good] * (1 - 1e-8)) ||
                (simple[good] && !simple[k]));
    }
  }
}

/* What a solution is made of. */
PH_TEST(test_shape) {
  const struct ph_curve *curve = &u.result.curve;
  double sum = 0;
  begin(SOME, 4, true);
  ck_solved();
  ck_assert_int_eq(curve->kind, PH_CURVE_PH);
  ck_assert(curve->closed);
  ck_assert_uint_eq(curve->dimension, 2);
  ck_assert_uint_eq(curve->degree, 5);
  ck_assert_uint_eq(curve->n, 4);
  ck_assert_uint_eq(curve->preimage.n, 3);
  ck_assert_uint_eq(curve->preimage.dimension, 2);
  for (size_t k = 0; k < 4; k++) {
    const double *next = SOME + 2 * ((k + 1) % 4);
    ck_abs(curve->control_points[12 * k], SOME[2 * k], 0);
    ck_abs(curve->control_points[12 * k + 1], SOME[2 * k + 1], 0);
    ck_abs(curve->control_points[12 * k + 10], next[0], 0);
    ck_abs(curve->control_points[12 * k + 11], next[1], 0);
    sum += curve->lengths[k];
  }
  ck_rel(curve->length, sum, 1e-15);
  ck_assert(u.result.diagnostics.known >> PH_D_ITERATIONS & 1);
  ck_assert(u.result.diagnostics.known >> PH_D_RESIDUAL & 1);
  ck_assert(!(u.result.diagnostics.known >> PH_D_END_DERIVATIVE_ERROR & 1));
  begin(SOME, 4, false);
  ck_solved();
  ck_assert_uint_eq(u.result.warnings_n, 0);
  ck_assert(!curve->closed);
  ck_assert_uint_eq(curve->n, 3);
}

/* The curve of a problem, to be compared after another was solved. */
static struct ph_curve kept(double p[60]) {
  struct ph_curve curve = u.result.curve;
  ck_assert_uint_le(curve.n, 5);
  memcpy(p, curve.control_points, curve.n * 12 * sizeof *p);
  curve.control_points = p;
  return curve;
}

PH_TEST(test_repeated_last_point) {
  double p[60];
  struct ph_curve curve;
  begin(SOME, 4, true);
  ck_solved();
  curve = kept(p);
  POINTS(true, 0, 0, 2, 1, 3, 0, 5, 2, 0, 0);
  ck_solved();
  ck_abs(unit_curves_apart(&curve, &u.result.curve), 0, 0);
  /* ... up to rounding of the coordinates */
  POINTS(true, 0, 0, 2, 1, 3, 0, 5, 2, 1e-15, -1e-15);
  ck_solved();
  ck_abs(unit_curves_apart(&curve, &u.result.curve), 0, 0);
}

/* Knots by rule, and the same ones as numbers. */
static void ck_rule(const char *rule, bool closed,
                    double (*spacing)(double chord)) {
  double p[60], knots[6] = {0};
  size_t n = closed ? 4 : 3;
  struct ph_curve curve;
  begin(SOME, 4, closed);
  if (rule) {
    unit_planar_rule(&u, rule);
  }
  ck_solved();
  curve = kept(p);
  for (size_t k = 0; k < n; k++) {
    const double *a = SOME + 2 * k, *b = SOME + 2 * ((k + 1) % 4);
    ck_rel(u.result.curve.knots[k], knots[k], 1e-15);
    knots[k + 1] = knots[k] + spacing(hypot(b[0] - a[0], b[1] - a[1]));
  }
  ck_rel(u.result.curve.knots[n], knots[n], 1e-15);
  /* Origin and unit of the parameter do not matter. */
  for (size_t k = 0; k <= n; k++) {
    knots[k] = -7 + 32 * knots[k];
  }
  unit_planar_knots(&u, knots, n + 1);
  ck_solved();
  ck_assert_double_le(unit_curves_apart(&curve, &u.result.curve), 1e-13);
  for (size_t k = 0; k <= n; k++) {
    ck_abs(u.result.curve.knots[k], knots[k], 0);
  }
}

static double chordal(double chord) {
  return chord;
}

static double centripetal(double chord) {
  return sqrt(chord);
}

static double uniform(double chord) {
  (void)chord;
  return 1;
}

PH_TEST(test_knot_rules) {
  for (int closed = 0; closed < 2; closed++) {
    ck_rule(NULL, closed, chordal);
    ck_rule("chordal", closed, chordal);
    ck_rule("centripetal", closed, centripetal);
    ck_rule("uniform", closed, uniform);
  }
}

/* Derivative at t[0] of the parabola through three points. */
static ph_cplx parabola(const double *q0, const double *q1, const double *q2,
                        double h1, double h2) {
  ph_cplx s1 = ph_cplx_of((q1[0] - q0[0]) / h1, (q1[1] - q0[1]) / h1);
  ph_cplx s2 = ph_cplx_of((q2[0] - q1[0]) / h2, (q2[1] - q1[1]) / h2);
  ph_cplx bend = ph_cplx_scale(h1 / (h1 + h2), ph_cplx_sub(s1, s2));
  return ph_cplx_add(s1, bend);
}

PH_TEST(test_default_ends) {
  const double knots[] = {0, 1, 4, 6};
  ph_cplx d0 = parabola(SOME, SOME + 2, SOME + 4, 1, 3);
  ph_cplx d1 = parabola(SOME + 6, SOME + 4, SOME + 2, -2, -3);
  double p[60];
  struct ph_curve curve;
  begin(SOME, 4, false);
  unit_planar_knots(&u, knots, 4);
  ck_solved();
  curve = kept(p);
  ENDS(d0.re, d0.im, d1.re, d1.im);
  ck_solved();
  ck_assert_double_le(unit_curves_apart(&curve, &u.result.curve), 1e-14);
  ck_assert(u.result.diagnostics.known >> PH_D_END_DERIVATIVE_ERROR & 1);
}

/* [GON18, Table 2.2] prints the parabolic rule's values for uniform knots. */
PH_TEST(test_default_ends_published) {
  ph_cplx end;
  POINTS(false, -2.1, 1.8, -0.8333, -0.1, 0.9833, 1.4167, 2.5667, 0.6);
  unit_planar_rule(&u, "uniform");
  ck_solved();
  end = unit_curve(&u.result.curve, 0, 1, 0);
  ck_assert_double_le(unit_distance(end, ph_cplx_of(0.9918, -3.6084)), 1e-4);
  end = unit_curve(&u.result.curve, 2, 1, 1);
  ck_assert_double_le(unit_distance(end, ph_cplx_of(1.4668, -1.9834)), 1e-4);
}

/* Where the parabola stands still at the end, the chord is taken: on a line
 * with spacings 1, 3 and knots 0, 1, 2 its derivative there is 1 - 3/2 + 1/2 =
 * 0 at the start. */
PH_TEST(test_default_ends_standstill) {
  POINTS(false, 0, 0, 1, 0, 4, 0, 5, 1);
  unit_planar_rule(&u, "uniform");
  ck_solved();
  ck_abs(unit_curve(&u.result.curve, 0, 1, 0).re, 1, 1e-14);
  ck_abs(unit_curve(&u.result.curve, 0, 1, 0).im, 0, 1e-14);
  /* ... also where rounding leaves something of it, 1.4e-17 here */
  POINTS(false, 0, 0, 0.1, 0, 0.4, 0, 0.5, 0.1);
  unit_planar_rule(&u, "uniform");
  ck_solved();
  ck_abs(unit_curve(&u.result.curve, 0, 1, 0).re, 0.1, 1e-14);
}

PH_TEST(test_given_ends) {
  struct unit_random r = unit_random_of(1);
  for (int i = 0; i < 200; i++) {
    const double knots[] = {3, 4, 4.5, 6};
    double d[4];
    begin(SOME, 4, false);
    unit_planar_knots(&u, knots, 4);
    for (int k = 0; k < 4; k++) {
      d[k] = unit_random_in(&r, 0.3, 2);
    }
    unit_planar_ends(&u, d);
    ck_solved();
    /* With respect to the knots: local derivatives are h times as large. */
    ck_assert_double_le(unit_distance(unit_curve(&u.result.curve, 0, 1, 0),
                                      ph_cplx_of(1 * d[0], 1 * d[1])),
                        1e-13);
    ck_assert_double_le(unit_distance(unit_curve(&u.result.curve, 2, 1, 1),
                                      ph_cplx_of(1.5 * d[2], 1.5 * d[3])),
                        1e-13);
  }
}

static const struct ph_diag *warning(enum ph_status status, size_t segment) {
  const struct ph_warning *found = NULL;
  for (size_t i = 0; i < u.result.warnings_n; i++) {
    if (u.result.warnings[i].diag.status == status) {
      ck_assert_ptr_null(found);
      found = &u.result.warnings[i];
    }
  }
  ck_assert_ptr_nonnull(found);
  ck_assert_uint_eq(found->segment, segment);
  return &found->diag;
}

PH_TEST(test_reversal) {
  POINTS(false, 0, 0, 2, 0, 1, 0, 3, 0);
  ck_solved();
  ck_assert_str_eq(
      warning(PH_W_REVERSAL, 1)->message,
      "the data turn back by 180 degrees at points[1] (such points: 2): "
      "of two mirror images the left turn was taken");
  ck_assert_uint_eq(u.result.warnings_n, 1);
  /* Left of the way out, which is to the east. */
  ck_assert(unit_curve(&u.result.curve, 0, 0, 0.9).im < 0);
  ck_assert(unit_curve(&u.result.curve, 1, 0, 0.1).im > 0);
  /* Rounding in the data does not decide. */
  POINTS(false, 0, 0, 2, 0, 1, -1e-13, 3, 0);
  ck_solved();
  warning(PH_W_REVERSAL, 1);
  ck_assert(unit_curve(&u.result.curve, 1, 0, 0.1).im > 0);
  /* A degree less is no reversal. */
  POINTS(false, 0, 0, 2, 0, 1, 0.02, 3, 0);
  ck_solved();
  ck_assert(!unit_planar_warned(&u, PH_W_REVERSAL));
}

PH_TEST(test_reversal_closed) {
  POINTS(true, 0, 0, 1, 0, 2, 0, 1, 1);
  ck_solved();
  ck_assert(!unit_planar_warned(&u, PH_W_REVERSAL));
  POINTS(true, 1, 0, 2, 0, 0, 0);
  ck_solved();
  ck_assert_ptr_nonnull(
      strstr(warning(PH_W_REVERSAL, 1)->message, "points[1] (such points: 2)"));
  POINTS(true, 0, 0, 1, 0, 1, 1, 0.5, 0);
  ck_solved();
  ck_assert_ptr_nonnull(
      strstr(warning(PH_W_REVERSAL, 0)->message, "points[0] (such points: 1)"));
}

PH_TEST(test_loop) {
  ph_cplx w[3];
  POINTS(false, 0, 0, 1, 0, 2, 0);
  ENDS(-1, 0, 1, 0);
  ck_solved();
  memcpy(w, u.result.curve.preimage.v, sizeof w);
  ck_assert_double_gt(fabs(ph_rotation(w)), PI);
  ck_assert_ptr_nonnull(strstr(warning(PH_W_LOOP, 0)->message,
                               "more than half a turn (such segments: 1)"));
  ck_assert_int_eq(
      strncmp(warning(PH_W_LOOP, 0)->message, "segment 0 turns by ", 19), 0);
  /* A circle's arcs turn by less. */
  POINTS(true, 1, 0, 0, 1, -1, 0, 0, -1);
  ck_solved();
  ck_assert(!unit_planar_warned(&u, PH_W_LOOP));
}

/* As small and as large as the numbers go: the same curve. */
PH_TEST(test_range) {
  const int exponents[] = {-996, -500, 500, 1000, 1019};
  double p[60];
  struct ph_curve curve;
  begin(SOME, 4, false);
  ck_solved();
  curve = kept(p);
  for (size_t i = 0; i < COUNT(exponents); i++) {
    double v[8], apart = 0;
    for (size_t k = 0; k < 8; k++) {
      v[k] = ldexp(SOME[k], exponents[i]);
    }
    begin(v, 4, false);
    ck_solved();
    for (size_t k = 0; k < 36; k++) {
      double x = ldexp(u.result.curve.control_points[k], -exponents[i]);
      apart = unit_larger(apart, fabs(x - p[k]));
    }
    ck_assert_double_le(apart, 1e-14);
    ck_rel(ldexp(u.result.curve.length, -exponents[i]), curve.length, 1e-14);
  }
}

/* Below 2^-1022 digits are missing, and the certificate knows. */
PH_TEST(test_subnormal) {
  POINTS(false, 0, 0, 1e-310, 1e-310, 2e-310, 0, 3e-310, 1e-310);
  ck_solved();
  ck_rel(u.result.curve.length / 1e-310, 4.5049834920518458, 1e-12);
  POINTS(false, 0, 0, 5e-324, 5e-324, 1e-323, 0);
  ck_assert_int_eq(unit_planar_solve(&u), PH_E_NO_CONVERGENCE);
  ck_assert_ptr_nonnull(strstr(u.diag.message, "refused by its certificate"));
}

PH_FIXTURE(NULL, finish)
