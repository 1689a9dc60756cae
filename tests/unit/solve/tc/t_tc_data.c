/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Reading problems of Tschirnhausen cubics: which mode they mean, every field
 * that is refused, and the vectors at the points, at any scale.
 */
#include "tc_unit.h"
#include "unit.h"

#include "kernel/pi.h"

#define POINTS \
  { PH_F_POINTS, VECTORS(2, 0, 0, 1, 0, 1, 1) }
#define RING \
  { PH_F_POINTS, VECTORS(2, 0, 0, 1, 0, 1, 1, 0, 0) }
#define TANGENTS \
  { PH_F_TANGENTS, VECTORS(2, 1, 0, 1, 1, 0, 1) }
#define DERIVATIVES \
  { PH_F_DERIVATIVES, VECTORS(2, 1, 0, 1, 1, 0, 1) }
#define BEZIER \
  { PH_F_CURVE, VECTORS(2, 0, 0, 1, 0, 1, 1) }
#define MODE(x) \
  { PH_F_MODE, WORD(x) }
#define ON_CHORD POINTS, TANGENTS, MODE("g1-pair"), JOINT("chord")
#define JOINT(x) \
  { PH_F_JOINT, WORD(x) }
#define ENDS(x) \
  { PH_F_ENDS, WORD(x) }
#define AUXILIARY(x) \
  { PH_F_AUXILIARY, WORD(x) }
#define LAMBDA(x) \
  { PH_F_LAMBDA, NUMBER(x) }
#define END_TANGENTS(...) \
  { PH_F_END_TANGENTS, VECTORS(2, __VA_ARGS__) }
#define END_DERIVATIVES(...) \
  { PH_F_END_DERIVATIVES, VECTORS(2, __VA_ARGS__) }

/* ---- modes --------------------------------------------------------------- */

static const struct {
  struct given given[GIVEN_MAX];
  enum ph_tc_mode mode;
} MODES[] = {
    {{POINTS}, PH_TC_G2},
    {{POINTS, MODE("spline")}, PH_TC_SPLINE},
    {{POINTS, TANGENTS}, PH_TC_G1_FAIR},
    {{POINTS, DERIVATIVES}, PH_TC_C1},
    {{BEZIER}, PH_TC_APPROXIMATE},
    {{POINTS, MODE("approximate")}, PH_TC_APPROXIMATE},
    {{MODE("approximate"), BEZIER, {PH_F_PIECES, NUMBER(3)}},
     PH_TC_APPROXIMATE},
    {{BEZIER, {PH_F_TOLERANCE, NUMBER(1)}, {PH_F_SOLUTIONS, WORD("best")}},
     PH_TC_APPROXIMATE},
    {{POINTS, TANGENTS, MODE("g1")}, PH_TC_G1},
    {{POINTS, TANGENTS, MODE("g1-pair"), LAMBDA(1)}, PH_TC_G1_PAIR},
    {{POINTS, TANGENTS, MODE("g1-pair"), JOINT("free"), LAMBDA(1)},
     PH_TC_G1_PAIR},
    {{ON_CHORD, {PH_F_JOINT_ANGLE, NUMBER(1)}}, PH_TC_G1_PAIR},
    {{ON_CHORD, {PH_F_JOINT_POSITION, NUMBER(0.5)}}, PH_TC_G1_PAIR},
    {{POINTS, TANGENTS, MODE("g1-auto"), LAMBDA(1)}, PH_TC_G1_AUTO},
    {{POINTS, TANGENTS, MODE("g1-fair"), LAMBDA(1)}, PH_TC_G1_FAIR},
    {{POINTS, DERIVATIVES, MODE("c1")}, PH_TC_C1},
    {{POINTS, MODE("spline"), LAMBDA(1), ENDS("circle")}, PH_TC_SPLINE},
    {{POINTS, MODE("g2"), ENDS("smooth")}, PH_TC_G2},
    {{POINTS, MODE("g2"), END_TANGENTS(1, 0, 0, 1)}, PH_TC_G2},
    {{POINTS, MODE("g2"), AUXILIARY("never")}, PH_TC_G2},
    {{POINTS, END_TANGENTS(1, 0, 0, 1)}, PH_TC_G2},
    {{POINTS, END_DERIVATIVES(1, 0, 0, 1)}, PH_TC_SPLINE},
};

PH_TEST_EACH(test_mode, COUNT(MODES)) {
  const struct ph_problem problem = unit_problem_of(MODES[_i].given);
  enum ph_tc_mode mode;
  struct ph_diag diag;
  enum ph_status status = ph_tc_mode_of(&problem, &mode, &diag);
  ck_assert_msg(status == PH_OK, "%s: %s", diag.field, diag.message);
  ck_assert_int_eq(mode, MODES[_i].mode);
}

/* ---- failures ------------------------------------------------------------ */

/* A problem and why it is refused; tests/cli/tc-errors.t has more. */
#define FAILS(status, field, message, ...) \
  { {__VA_ARGS__}, status, field, message }

static const struct {
  struct given given[GIVEN_MAX];
  enum ph_status status;
  const char *field, *message;
} FAILURES[] = {
    /* modes without what they need */
    FAILS(PH_E_MISSING_FIELD, "tangents", "is required by the mode g1-pair",
          POINTS, MODE("g1-pair")),
    FAILS(PH_E_MISSING_FIELD, "tangents", "is required by the mode g1-fair",
          POINTS, MODE("g1-fair"), DERIVATIVES),
    /* fields of other modes */
    FAILS(PH_E_BAD_VALUE, "tangents",
          "are for the modes g1, g1-pair, g1-auto, g1-fair", POINTS, TANGENTS,
          BEZIER),
    FAILS(PH_E_BAD_VALUE, "lambda",
          "is for the modes spline, g1-pair, g1-auto, g1-fair", BEZIER,
          LAMBDA(1)),
    FAILS(PH_E_BAD_VALUE, "ends",
          "is for the modes spline and g2 of open curves whose ends are not "
          "given",
          POINTS, END_DERIVATIVES(1, 0, 0, 1), ENDS("chord")),
    FAILS(PH_E_BAD_VALUE, "ends", "must be circle or chord in the mode spline",
          POINTS, ENDS("smooth"), MODE("spline")),
    FAILS(PH_E_BAD_VALUE, "ends", "must be circle or smooth in the mode g2",
          POINTS, ENDS("chord"), MODE("g2")),
    FAILS(PH_E_BAD_VALUE, "auxiliary", "is for the mode g2", POINTS,
          AUXILIARY("auto"), MODE("spline")),
    FAILS(PH_E_BAD_VALUE, "lambda",
          "is for the modes spline, g1-pair, g1-auto, g1-fair", POINTS,
          MODE("g2"), LAMBDA(1)),
    FAILS(PH_E_BAD_VALUE, "solutions",
          "must not be all in the modes approximate and g2", POINTS, MODE("g2"),
          {PH_F_SOLUTIONS, WORD("all")}),
    FAILS(PH_E_BAD_VALUE, "end_derivatives",
          "are for the mode spline of open curves, without end_tangents",
          POINTS, MODE("g2"), END_DERIVATIVES(1, 0, 0, 1)),
    FAILS(PH_E_ZERO_TANGENT, "end_tangents[1]", "must not be zero", POINTS,
          MODE("g2"), END_TANGENTS(1, 0, 0, 0)),
    /* numbers */
    FAILS(PH_E_BAD_VALUE, "lambda",
          "must be between 1e-12 and 1e12, found 1000000000000", POINTS,
          LAMBDA(1e12)),
    FAILS(PH_E_BAD_VALUE, "lambda", "must be between 1e-12 and 1e12, found nan",
          POINTS, LAMBDA((double)NAN)),
    /* points */
    FAILS(PH_E_COINCIDENT_POINTS, "points[1]", "coincides with points[0]" JOINS,
          {PH_F_POINTS, VECTORS(2, 1, 0, 1 + 4 * DBL_EPSILON, 0)}),
    FAILS(PH_E_COINCIDENT_POINTS, "points[1]", "coincides with points[0]" JOINS,
          {PH_F_POINTS, VECTORS(2, 0, 0, 1e-140, 0, 1, 0)}),
    FAILS(PH_E_COINCIDENT_POINTS, "points[0]", "coincides with points[3]" JOINS,
          CLOSED, {PH_F_POINTS, VECTORS(2, 1, 1, 2, 0, 3, 3, 1, 1, 1, 1)}),
    FAILS(PH_E_INFEASIBLE, "points[2]",
          "is where the data turn back by 180 degrees: the chords have no "
          "bisector there",
          {PH_F_POINTS, VECTORS(2, 0, 0, 1, 1, 3, 3, 2, 2)}, MODE("spline")),
    /* vectors */
    FAILS(PH_E_BAD_SHAPE, "tangents",
          "must have 3 vectors, one for each point, found 2", POINTS,
          {PH_F_TANGENTS, VECTORS(2, 1, 0, 0, 1)}),
    FAILS(PH_E_BAD_SHAPE, "derivatives",
          "must have 4 vectors, one for each point, found 3", RING,
          {PH_F_DERIVATIVES, VECTORS(2, 1, 0, 1, 1, 0, 1)}),
    FAILS(PH_E_BAD_VALUE, "tangents[3]",
          "must equal tangents[0], as the point does", RING, CLOSED,
          {PH_F_TANGENTS, VECTORS(2, 1, 0, 1, 1, 0, 1, 1, 1e-8)}),
    FAILS(PH_E_ZERO_TANGENT, "derivatives[2]", "must not be zero", POINTS,
          {PH_F_DERIVATIVES, VECTORS(2, 1, 0, 1, 0, 0, 0)}),
    FAILS(PH_E_BAD_SHAPE, "end_derivatives",
          "must have 2 vectors, one for each end, found 1", POINTS,
          END_DERIVATIVES(1, 0)),
    FAILS(PH_E_ZERO_TANGENT, "end_tangents[1]", "must not be zero", POINTS,
          END_TANGENTS(1, 0, 0, 0)),
    FAILS(PH_E_ZERO_TANGENT, "end_derivatives[0]", "must not be zero", POINTS,
          END_DERIVATIVES(0, 0, 1, 0)),
    /* ratios */
    FAILS(PH_E_ZERO_TANGENT, "derivatives[2]",
          "is too small beside the chord from points[1] to points[2]", POINTS,
          {PH_F_DERIVATIVES, VECTORS(2, 1, 0, 1, 1, 1e-13, 0)}),
    FAILS(PH_E_TOO_LARGE, "derivatives[0]",
          "is too large beside the chord from points[0] to points[1]", POINTS,
          {PH_F_DERIVATIVES, VECTORS(2, 1e13, 0, 1, 1, 1, 0)}),
    FAILS(PH_E_COINCIDENT_POINTS, "points[1]",
          "gets a derivative that is too small beside the chord from points[1] "
          "to points[2]" JOINS,
          {PH_F_POINTS, VECTORS(2, 0, 0, 1e-13, 0, 1, 0)}, MODE("spline")),
    FAILS(PH_E_TOO_LARGE, "points[2]",
          "gets a derivative that is too large beside the chord from points[1] "
          "to points[2]",
          POINTS, END_DERIVATIVES(1, 0, 0, 1e13)),
};

PH_TEST_EACH(test_failure, COUNT(FAILURES)) {
  struct ph_tc_data data;
  struct ph_diag diag;
  ck_assert_int_eq(unit_tc_read(FAILURES[_i].given, &data, &diag),
                   FAILURES[_i].status);
  ck_assert_int_eq(diag.status, FAILURES[_i].status);
  ck_assert_str_eq(diag.field, FAILURES[_i].field);
  ck_assert_str_eq(diag.message, FAILURES[_i].message);
}

/* ---- vectors ------------------------------------------------------------- */

/* Chords of 5, 12, 15 and, closed, 20. */
#define POLYGON \
  { PH_F_POINTS, VECTORS(2, 0, 0, 3, 4, 3, 16, -12, 16) }

/* Their directions are .6 + .8 i, i, -1 and .6 - .8 i; lengths are lambda times
 * 5, 5, 12 and 15. */
static const struct {
  struct given given[GIVEN_MAX];
  double lambda;
  ph_cplx along[4];  /* of any length */
  double lengths[4]; /* over lambda */
} SPLINES[] = {
    {{POLYGON, MODE("spline")},
     0.5,
     {{3, 4}, {1, 3}, {-1, 1}, {-1, 0}},
     {5, 5, 12, 15}},
    {{POLYGON, ENDS("chord"), LAMBDA(0.25)},
     0.25,
     {{3, 4}, {1, 3}, {-1, 1}, {-1, 0}},
     {5, 5, 12, 15}},
    /* (3 + 4i)^2 (1 - 3i) = 65 + 45i, (-1)^2 (-1 - i) */
    {{POLYGON, MODE("spline"), ENDS("circle")},
     0.5,
     {{13, 9}, {1, 3}, {-1, 1}, {-1, -1}},
     {5, 5, 12, 15}},
    {{POLYGON, CLOSED, LAMBDA(2)},
     2,
     {{1, 0}, {1, 3}, {-1, 1}, {-1, -2}},
     {5, 5, 12, 15}},
    {{POLYGON, END_TANGENTS(0, 7, 1e-300, -1e-300), LAMBDA(1)},
     1,
     {{0, 1}, {1, 3}, {-1, 1}, {1, -1}},
     {5, 5, 12, 15}},
    {{POLYGON, END_DERIVATIVES(0, 7, 3, -4), LAMBDA(1)},
     1,
     {{0, 1}, {1, 3}, {-1, 1}, {3, -4}},
     {7, 5, 12, 5}},
    {{POLYGON,
      {PH_F_TANGENTS, VECTORS(2, 1, 0, 0, -3, 2, 2, -1e300, 1e300)},
      MODE("g1-pair"),
      LAMBDA(0.75)},
     0.75,
     {{1, 0}, {0, -1}, {1, 1}, {-1, 1}},
     {5, 5, 12, 15}},
};

PH_TEST_EACH(test_spline, COUNT(SPLINES)) {
  struct ph_tc_data d = unit_tc_given(SPLINES[_i].given);
  ck_assert_uint_eq(d.points_n, 4);
  ck_assert_uint_eq(d.n, d.closed ? 4 : 3);
  ck_assert(d.c1);
  ck_rel(d.lambda, SPLINES[_i].lambda, 0);
  for (size_t k = 0; k < 4; k++) {
    ph_cplx t = SPLINES[_i].along[k];
    double length = d.lambda * SPLINES[_i].lengths[k] / hypot(t.re, t.im);
    ck_cplx(d.vector[k], ph_cplx_scale(ldexp(length, d.exponent), t),
            4 * DBL_EPSILON);
  }
}

/* Of equally spaced points of a circle, (5.24) and the rule for the ends give
 * its tangents; the chords do not. */
PH_TEST_EACH(test_circle, 2) {
  double v[10];
  for (size_t i = 0; i < 5; i++) {
    v[2 * i] = 7 + 3 * cos(0.3 + 0.5 * (double)i);
    v[2 * i + 1] = 3 * sin(0.3 + 0.5 * (double)i) - 2;
  }
  const struct given given[GIVEN_MAX] = {
      {PH_F_POINTS, {.kind = PH_VECTORS, .v = v, .n = 5, .dimension = 2}},
      ENDS(_i ? "circle" : "chord"),
      MODE("spline")};
  const double length = 0.5 * 6 * sin(0.25), turned = _i ? 0 : 0.25;
  struct ph_tc_data d = unit_tc_given(given);
  for (size_t k = 0; k < 5; k++) {
    double end = k == 0 ? turned : k == 4 ? -turned : 0;
    double angle = PH_PI / 2 + 0.3 + 0.5 * (double)k + end;
    ck_cplx(d.vector[k],
            ph_cplx_scale(ldexp(length, d.exponent), ph_cplx_polar(angle)),
            4 * DBL_EPSILON);
  }
}

/* Two points have no circle: the chord. */
PH_TEST(test_circle_of_two) {
  struct ph_tc_data d = unit_tc_given((struct given[GIVEN_MAX]){
      {PH_F_POINTS, VECTORS(2, 1, 1, 4, 5)}, ENDS("circle"), MODE("spline")});
  for (size_t k = 0; k < 2; k++) {
    ck_cplx(d.vector[k],
            ph_cplx_of(ldexp(1.5, d.exponent), ldexp(2, d.exponent)),
            DBL_EPSILON);
  }
}

/* Vectors of closed data, also with a last point that repeats the first. */
PH_TEST_EACH(test_closed, 5) {
  const struct given GIVEN[][GIVEN_MAX] = {
      {POINTS, CLOSED, {PH_F_TANGENTS, VECTORS(2, 3, 4, 0, 2, -5, 0)}},
      {RING, CLOSED, {PH_F_TANGENTS, VECTORS(2, 3, 4, 0, 2, -5, 0)}},
      {RING, CLOSED, {PH_F_TANGENTS, VECTORS(2, 3, 4, 0, 2, -5, 0, 6, 8)}},
      {POINTS, CLOSED, {PH_F_DERIVATIVES, VECTORS(2, .6, .8, 0, 1, -1, 0)}},
      {RING,
       CLOSED,
       {PH_F_DERIVATIVES, VECTORS(2, .6, .8, 0, 1, -1, 0, .6, .8)}},
  };
  static const ph_cplx VECTOR[] = {{0.6, 0.8}, {0, 1}, {-1, 0}};
  struct ph_tc_data d = unit_tc_given(GIVEN[_i]);
  const int scale = d.c1 ? d.exponent : 0;
  ck_assert(d.c1 == (_i >= 3));
  ck_assert(d.closed && isnan(d.lambda));
  ck_assert_uint_eq(d.n, 3);
  ck_assert_uint_eq(d.points_n, 3);
  for (size_t k = 0; k < 3; k++) {
    ck_cplx(d.vector[k], ph_cplx_scale(ldexp(1, scale), VECTOR[k]),
            DBL_EPSILON);
  }
  ck_cplx(ph_tc_point(&d, 2), ph_cplx_of(1, 1), 0);
  ck_cplx(ph_tc_point(&d, 3), ph_cplx_of(0, 0), 0);
}

/* What else the fields say. */
PH_TEST(test_choices) {
  static const char *const WORDS[] = {"best", "standard", "all"};
  static const enum ph_tc_choice CHOICES[] = {PH_TC_BEST, PH_TC_STANDARD,
                                              PH_TC_ALL};
  struct ph_tc_data d;
  for (size_t i = 0; i < 3; i++) {
    d = unit_tc_given(
        (struct given[GIVEN_MAX]){POINTS, {PH_F_SOLUTIONS, WORD(WORDS[i])}});
    ck_assert_int_eq(d.choice, CHOICES[i]);
  }
  d = unit_tc_given((struct given[GIVEN_MAX]){POINTS, TANGENTS});
  ck_assert_int_eq(d.choice, PH_TC_BEST);
  ck_assert(!d.on_chord && !d.c1 && isnan(d.joint_angle) &&
            isnan(d.joint_position));
  d = unit_tc_given(
      (struct given[GIVEN_MAX]){ON_CHORD, {PH_F_JOINT_ANGLE, NUMBER(-6)}});
  ck_assert(d.on_chord && isnan(d.joint_position));
  ck_rel(d.joint_angle, -6, 0);
  d = unit_tc_given((struct given[GIVEN_MAX]){
      ON_CHORD, {PH_F_JOINT_POSITION, NUMBER(0.125)}});
  ck_assert(d.on_chord && isnan(d.joint_angle));
  ck_rel(d.joint_position, 0.125, 0);
}

/* Points that are just far enough from each other. */
PH_TEST_EACH(test_near, 3) {
  const struct given GIVEN[][GIVEN_MAX] = {
      {{PH_F_POINTS, VECTORS(2, 1, 0, 1 + 5 * DBL_EPSILON, 0)}},
      {{PH_F_POINTS, VECTORS(2, 0, 0, 1e-139, 0, 1, 0)},
       {PH_F_TANGENTS, VECTORS(2, 1, 0, 1, 0, 1, 0)}},
      {{PH_F_POINTS, VECTORS(2, 0, 0, 4e-12, 0, 1, 0)}}};
  static const double CHORD[] = {5 * DBL_EPSILON, 1e-139, 4e-12};
  struct ph_tc_data d = unit_tc_given(GIVEN[_i]);
  ck_rel(ldexp(d.chord[0], -d.exponent), CHORD[_i], DBL_EPSILON);
}

/* ---- scales -------------------------------------------------------------- */

/* The polygon with its derivatives, times a scale: at unit scale no coordinate
 * reaches 1/2, and what is over the chords does not know the scale. */
PH_TEST_EACH(test_scale, 3) {
  static const double SCALES[] = {1e-300, 1, 1e300};
  static const double POINT[] = {0, 0, 3, 4, 3, 16, -12, 16};
  static const double VECTOR[] = {6, 8, -4, 3, 0, 12, 3, -4};
  /* conj(chord) * vector / |chord|^2 by hand */
  static const ph_cplx OVER[4][2] = {{{2, 0}, {0, 1}},
                                     {{0.25, 1.0 / 3}, {1, 0}},
                                     {{0, -0.8}, {-0.2, 4.0 / 15}},
                                     {{0.25, 0}, {-0.14, 0.48}}};
  double points[8], vectors[8];
  for (size_t i = 0; i < 8; i++) {
    points[i] = SCALES[_i] * POINT[i];
    vectors[i] = SCALES[_i] * VECTOR[i];
  }
  const struct given given[GIVEN_MAX] = {
      {PH_F_POINTS, {.kind = PH_VECTORS, .v = points, .n = 4, .dimension = 2}},
      {PH_F_DERIVATIVES,
       {.kind = PH_VECTORS, .v = vectors, .n = 4, .dimension = 2}},
      CLOSED};
  struct ph_tc_data d = unit_tc_given(given);
  double largest = ph_pow2_apply(d.to_unit, points[5]);
  ck_assert_int_eq(d.exponent % 2, 0);
  ck_assert(largest >= 0.125 && largest < 0.5);
  ck_rel(ldexp(points[5], d.exponent), largest, 0);
  for (size_t k = 0; k < 4; k++) {
    struct ph_tc_hermite h = ph_tc_hermite_of(&d, k);
    ph_cplx chord = ph_tc_chord(&d, k), root = ph_tc_root(&d, k);
    ck_rel(hypot(chord.re, chord.im), d.chord[k], DBL_EPSILON);
    ck_assert(root.re >= 0);
    ck_cplx(ph_cplx_mul(root, root), chord, 4 * DBL_EPSILON);
    ck_cplx(h.t[0], OVER[k][0], 8 * DBL_EPSILON);
    ck_cplx(h.t[1], OVER[k][1], 8 * DBL_EPSILON);
  }
  /* along the chord to rounding is along the chord */
  ck_rel(ph_tc_hermite_of(&d, 0).t[0].im, 0, 0);
  ck_rel(ph_tc_hermite_of(&d, 1).t[1].im, 0, 0);
}

/* Tangents are of length 1 over every chord, whatever their own length. */
PH_TEST(test_tangent_length) {
  struct ph_tc_data d = unit_tc_given((struct given[GIVEN_MAX]){
      {PH_F_POINTS, VECTORS(2, 0, 0, 3, 4, 3, 16)},
      {PH_F_TANGENTS, VECTORS(2, 4e-320, 0, -1.2e308, 1.6e308, -30, -40)}});
  struct ph_tc_hermite h = ph_tc_hermite_of(&d, 0);
  ck_cplx(h.t[0], ph_cplx_of(0.6, -0.8), 4 * DBL_EPSILON);
  ck_cplx(h.t[1], ph_cplx_of(0.28, 0.96), 4 * DBL_EPSILON);
  h = ph_tc_hermite_of(&d, 1);
  ck_cplx(h.t[0], ph_cplx_of(0.8, 0.6), 4 * DBL_EPSILON);
  ck_cplx(h.t[1], ph_cplx_of(-0.8, 0.6), 4 * DBL_EPSILON);
}
