/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Verification with a problem: results pass beside their own problem, at every
 * scale and far from the origin, and fail beside one that differs in one
 * number, by as much as it does.
 */
#include "unit.h"
#include "verify_unit.h"

static const double TOLERANCE = 1e-9;

static struct unit_claim claim;

static double error_of(enum ph_check_id check) {
  return claim.verdict.check[check].error;
}

static void make(const char *command, const char *json) {
  unit_claim_make(&claim, command, json, NULL);
}

/* The result and its problem, as both are now, by one check. */
static void expect_pass(enum ph_check_id check) {
  unit_claim_verify(&claim, true);
  ck_assert_msg(claim.verdict.check[check].done, "%s was not done",
                ph_check_name(check));
  ck_assert_msg(unit_worst(&claim.verdict) <= TOLERANCE, "%s: %s %s",
                ph_check_name(claim.verdict.worst),
                claim.verdict.check[claim.verdict.worst].where.field,
                claim.verdict.check[claim.verdict.worst].where.message);
}

static void expect_fail(enum ph_check_id check, double least, double most) {
  unit_claim_verify(&claim, true);
  ck_assert_msg(error_of(check) >= least && error_of(check) <= most,
                "%s is %.3g, not from %.3g to %.3g", ph_check_name(check),
                error_of(check), least, most);
}

/* One number of a field is changed: before, all is right; afterwards, the check
 * has an error between the two. */
static void changed(enum ph_field_id id, size_t i, double by,
                    enum ph_check_id check, double least, double most) {
  struct ph_value *value = &claim.problem.field[id];
  double *number = value->kind == PH_NUMBER ? &value->number : &value->v[i];
  double before = *number;
  expect_pass(check);
  *number += by;
  expect_fail(check, least, most);
  *number = before;
}

/* ---- points ----------------------------------------------------------------
 */

PH_TEST(points) {
  static const struct {
    const char *command, *json;
    enum ph_field_id id;
    double size; /* of the curve, about */
  } cases[] = {
      {"planar", "{\"points\":[[0,0],[2,1],[3,0],[5,2]]}", PH_F_POINTS, 3},
      {"planar", "{\"points\":[[0,0],[2,1],[3,0],[5,2]],\"basis\":\"atph\"}",
       PH_F_POINTS, 3},
      {"planar", "{\"points\":[[0,0],[2,1],[1,3]],\"closed\":true}",
       PH_F_POINTS, 3},
      {"planar", "{\"points\":[[0,0],[2,1],[1,3],[0,0]],\"closed\":true}",
       PH_F_POINTS, 3},
      {"spatial-hermite", "{\"points\":[[0,0,0],[1,1,0],[2,0,1],[3,1,1]]}",
       PH_F_POINTS, 2},
      {"spatial-hermite", "{\"points\":[[0,0],[1,1],[2,0],[3,1]]}", PH_F_POINTS,
       2},
      {"arclength",
       "{\"points\":[[0,0,0],[1,1,0],[2,0,1]],\"lengths\":[1.6,1.9]}",
       PH_F_POINTS, 2},
      {"arclength", "{\"points\":[[0,0],[1,1],[2,0]],\"lengths\":1.7}",
       PH_F_POINTS, 2},
      {"arclength",
       "{\"derivatives\":[[1,0,0],[1,1,0],[0,1,1]],\"lengths\":[1.2,1.5],"
       "\"start\":[1,2,3]}",
       PH_F_START, 2},
      {"sphere", "{\"points\":[[1,0,0],[0,1,0],[0,0.6,0.8]]}", PH_F_POINTS, 1},
      {"tc", "{\"points\":[[0,0],[2,1],[3,0],[5,2]]}", PH_F_POINTS, 3},
  };
  const double by = 1e-6;
  for (size_t i = 0; i < COUNT(cases); i++) {
    make(cases[i].command, cases[i].json);
    changed(cases[i].id, 1, by, PH_CHECK_INTERPOLATION,
            0.3 * by / cases[i].size, 3 * by / cases[i].size);
  }
}

/* Points of a sphere may be off it, but not by more than is allowed. */
PH_TEST(degrees) {
  make("sphere", "{\"lonlat\":[[0,0],[40,10],[80,-20]],\"radius\":3,"
                 "\"center\":[1,2,3]}");
  changed(PH_F_LONLAT, 2, 1e-5, PH_CHECK_INTERPOLATION, 1e-8, 1e-6);
  make("sphere", "{\"points\":[[1,0,0],[0,1.0005,0],[0,0.6,0.8]]}");
  expect_pass(PH_CHECK_INTERPOLATION);
  changed(PH_F_POINTS, 4, 1e-3, PH_CHECK_INTERPOLATION, 4e-4, 6e-4);
}

/* Coordinates from 1e-9 to 1e9, and 1e6 from the origin. */
PH_TEST(scales) {
  static const char *const commands[] = {"planar", "spatial-hermite",
                                         "arclength", "tc"};
  static const double scale[] = {1e-9, 1, 1e9}, away[] = {0, 1e6};
  for (size_t i = 0; i < 24; i++) {
    double s = scale[i % 3], d = s * away[i / 3 % 2];
    char json[400];
    snprintf(json, sizeof json,
             "{\"points\":[[%.17g,%.17g],[%.17g,%.17g],[%.17g,%.17g]]}", d, d,
             d + 2 * s, d + s, d + 3 * s, d);
    make(commands[i / 6], json);
    expect_pass(PH_CHECK_INTERPOLATION);
  }
}

/* ---- tangents and derivatives ----------------------------------------------
 */

PH_TEST(vectors) {
  static const struct {
    const char *command, *json;
    enum ph_field_id id;
    enum ph_check_id check;
  } cases[] = {
      {"spatial-hermite",
       "{\"points\":[[0,0,0],[1,1,0],[2,0,1]],"
       "\"tangents\":[[1,0,0],[1,1,0],[1,0,1]]}",
       PH_F_TANGENTS, PH_CHECK_TANGENT},
      {"spatial-hermite",
       "{\"points\":[[0,0,0],[1,1,0],[2,0,1]],\"tension\":0.8,"
       "\"derivatives\":[[1,0,0],[1,1,0],[1,0,1]]}",
       PH_F_DERIVATIVES, PH_CHECK_TANGENT},
      {"spatial-hermite",
       "{\"points\":[[0,0,0],[1,1,0],[2,0,1]],\"basis\":\"atph\","
       "\"alpha\":1.2,\"derivatives\":[[1,0,0],[1,1,0],[1,0,1]]}",
       PH_F_DERIVATIVES, PH_CHECK_TANGENT},
      {"arclength",
       "{\"derivatives\":[[1,0,0],[1,1,0],[0,1,1]],\"lengths\":[1.2,1.5]}",
       PH_F_DERIVATIVES, PH_CHECK_TANGENT},
      {"arclength",
       "{\"tangents\":[[1,0,0],[1,1,0],[0,1,1]],\"lengths\":[1.2,1.5]}",
       PH_F_TANGENTS, PH_CHECK_TANGENT},
      {"arclength",
       "{\"tangents\":[[1,0,0],[1,1,0],[0,1,1]],\"lengths\":[1.2,1.5],"
       "\"magnitudes\":\"mean\"}",
       PH_F_LENGTHS, PH_CHECK_TANGENT},
      {"tc",
       "{\"points\":[[0,1],[6,1],[8,3]],\"tangents\":[[1,-1],[1,1],[1,0]]}",
       PH_F_TANGENTS, PH_CHECK_TANGENT},
      {"tc",
       "{\"points\":[[0,1],[6,1],[8,3]],\"derivatives\":[[1,-1],[1,1],[1,0]]}",
       PH_F_DERIVATIVES, PH_CHECK_TANGENT},
      {"planar",
       "{\"points\":[[0,0],[2,1],[3,0]],\"end_derivatives\":[[1,1],[1,0]]}",
       PH_F_END_DERIVATIVES, PH_CHECK_END},
      {"planar",
       "{\"points\":[[0,0],[2,1],[3,0]],\"end_derivatives\":[[1,1],[1,0]],"
       "\"basis\":\"atph\"}",
       PH_F_END_DERIVATIVES, PH_CHECK_END},
      {"tc", "{\"points\":[[0,0],[2,1],[3,0]],\"end_tangents\":[[1,1],[1,0]]}",
       PH_F_END_TANGENTS, PH_CHECK_END},
      {"tc",
       "{\"points\":[[0,0],[2,1],[3,0]],\"end_derivatives\":[[1,1],[1,0]]}",
       PH_F_END_DERIVATIVES, PH_CHECK_END},
      {"sphere",
       "{\"lonlat\":[[0,0],[40,10],[80,-20]],"
       "\"end_tangents\":[[0,1,1],[-1,0.1,0]]}",
       PH_F_END_TANGENTS, PH_CHECK_END},
  };
  const double by = 1e-5;
  for (size_t i = 0; i < COUNT(cases); i++) {
    make(cases[i].command, cases[i].json);
    changed(cases[i].id, 1, by, cases[i].check, 0.1 * by, 2 * by);
  }
}

/* A Bezier curve in place of a trigonometric one. */
PH_TEST(bezier) {
  const struct unit_wanted wanted = {.bezier = true};
  unit_claim_make(&claim, "planar",
                  "{\"points\":[[0,0],[2,1],[3,0],[1,-1],[0,0]],"
                  "\"closed\":true,\"basis\":\"atph\"}",
                  &wanted);
  ck_assert_int_eq(claim.result.curve.kind, PH_CURVE_BEZIER);
  ck_assert_uint_gt(claim.result.curve.n, 4);
  changed(PH_F_POINTS, 4, 1e-3, PH_CHECK_INTERPOLATION, 1e-4, 10);
}

/* ---- the rest --------------------------------------------------------------
 */

PH_TEST(lengths) {
  make("arclength",
       "{\"points\":[[0,0,0],[1,1,0],[2,0,1]],\"lengths\":[1.6,1.9]}");
  changed(PH_F_LENGTHS, 1, 1e-6, PH_CHECK_PRESCRIBED, 4e-7, 7e-7);
  make("arclength", "{\"points\":[[0,0,0],[1,1,0],[2,0,1]],"
                    "\"lengths\":[1.6,1.9],\"length_sigma\":0.01}");
  unit_claim_verify(&claim, true);
  ck_assert(!claim.verdict.check[PH_CHECK_PRESCRIBED].done);
}

PH_TEST(shape) {
  const double never = (double)INFINITY;
  make("planar", "{\"points\":[[0,0],[2,1],[3,0]]}");
  claim.problem.field[PH_F_CLOSED] =
      (struct ph_value){.kind = PH_BOOL, .flag = true};
  expect_fail(PH_CHECK_SHAPE, never, never);
  make("planar", "{\"points\":[[0,0],[2,1],[3,0]]}");
  claim.problem.field[PH_F_POINTS].n = 2;
  expect_fail(PH_CHECK_SHAPE, never, never);
  make("planar", "{\"points\":[[0,0],[2,1],[3,0]],\"basis\":\"ph\"}");
  claim.problem.field[PH_F_BASIS].word = "atph";
  expect_fail(PH_CHECK_SHAPE, never, never);
  make("tc", "{\"points\":[[0,0],[2,1],[3,0]],\"mode\":\"spline\"}");
  claim.result.intervals[1].first = 1;
  expect_fail(PH_CHECK_SHAPE, never, never);
  make("tc", "{\"points\":[[0,0],[2,1],[3,0]]}");
  claim.command = ph_command_find("planar");
  expect_fail(PH_CHECK_SHAPE, never, never);
  make("planar", "{\"points\":[[0,0],[2,1],[3,0]],\"solutions\":\"all\"}");
  expect_pass(PH_CHECK_SHAPE);
  claim.result.solutions[0] = claim.result.solutions[1];
  expect_fail(PH_CHECK_SHAPE, never, never);
}

PH_TEST(sphere) {
  const char *const json = "{\"lonlat\":[[0,0],[40,10],[80,-20],[120,50]],"
                           "\"tension\":[0,3,1,0],\"shape\":false}";
  make("sphere", json);
  expect_pass(PH_CHECK_SPHERE);
  claim.result.curve.sphere.tensions[1] += 1e-3;
  expect_fail(PH_CHECK_TENSION, 1e-5, 1e-3);
  make("sphere", json);
  claim.result.curve.control_points[12] *= 1 + 1e-6;
  expect_fail(PH_CHECK_SPHERE, 1e-7, 1e-5);
  make("sphere", "{\"lonlat\":[[0,0],[40,10],[80,-20]],\"ends\":\"rest\"}");
  expect_pass(PH_CHECK_END);
  claim.problem.field[PH_F_ENDS].word = "natural";
  expect_fail(PH_CHECK_END, 1e-2, 10);
  make("sphere", "{\"lonlat\":[[0,0],[40,10],[80,-20]],\"ends\":\"natural\"}");
  expect_pass(PH_CHECK_END);
  claim.problem.field[PH_F_ENDS].word = "rest";
  expect_fail(PH_CHECK_END, 1e-2, 10);
}

PH_TEST(blaschke) {
  const char *const json =
      "{\"points\":[[0,1],[6,1]],\"tangents\":[[1,-1],[1,1]],"
      "\"mode\":\"g1\",\"solutions\":\"all\",\"blaschke\":true}";
  struct ph_blaschke *b;
  make("tc", json);
  expect_pass(PH_CHECK_BLASCHKE);
  b = claim.result.curve.blaschke.v;
  b[0].weights[1] *= 1.001;
  expect_fail(PH_CHECK_BLASCHKE, 1e-6, 1e-2);
  b[0].weights[1] = -1;
  expect_fail(PH_CHECK_BLASCHKE, (double)INFINITY, (double)INFINITY);
  make("tc", json);
  b = claim.result.curve.blaschke.v;
  b[0].control_points[3][0] += 1e-6;
  expect_fail(PH_CHECK_BLASCHKE, 1e-8, 1e-6);
  b[0].control_points[3][0] -= 1e-6;
  b[0].interval[0] = 0.1;
  expect_fail(PH_CHECK_BLASCHKE, (double)INFINITY, (double)INFINITY);
}

PH_TEST(distance) {
  static const char *const curves[] = {
      "{\"curve\":[[0,0],[1,2],[3,2],[4,-1],[6,0]],\"tolerance\":0.01}",
      "{\"curve\":[[[0,0],[1,2],[3,2]],[[3,2],[5,2],[6,0],[7,1]]],"
      "\"tolerance\":1e-4}",
      "{\"points\":[[0,0],[1,2],[3,2],[4,-1],[6,0]],\"mode\":\"approximate\","
      "\"pieces\":8}"};
  for (size_t i = 0; i < COUNT(curves); i++) {
    struct ph_diagnostics *d;
    make("tc", curves[i]);
    d = &claim.result.diagnostics;
    expect_pass(PH_CHECK_DISTANCE);
    d->value[PH_D_DISTANCE] *= 0.8;
    expect_fail(PH_CHECK_DISTANCE, 0.01, 0.2);
    d->value[PH_D_DISTANCE] = 0;
    expect_fail(PH_CHECK_DISTANCE, 0.9, 1);
  }
  make("tc", curves[0]);
  claim.problem.field[PH_F_TOLERANCE].number = 1e-3;
  expect_fail(PH_CHECK_DISTANCE, 0.1, 1);
  make("tc", curves[0]);
  claim.problem.field[PH_F_CURVE].v[4] += 0.1;
  expect_fail(PH_CHECK_DISTANCE, 0.1, 1);
  make("tc", curves[0]);
  claim.problem.field[PH_F_CURVE].v[0] += 1e-3;
  expect_fail(PH_CHECK_INTERPOLATION, 1e-4, 1e-3);
  make("tc", curves[2]);
  claim.problem.field[PH_F_PIECES].number = 1;
  expect_fail(PH_CHECK_SHAPE, (double)INFINITY, (double)INFINITY);
}

/* Problems that nobody could have solved. */
PH_TEST(nonsense) {
  const double never = (double)INFINITY;
  make("tc", "{\"curve\":[[[0,0],[1,2],[3,2]]],\"tolerance\":0.01}");
  claim.problem.field[PH_F_CURVE].sizes[0] = 1;
  claim.problem.field[PH_F_CURVE].n = 1;
  expect_fail(PH_CHECK_SHAPE, never, never);
  make("tc", "{\"curve\":[[[0,0],[1,2],[3,2]]],\"tolerance\":0.01}");
  claim.problem.field[PH_F_CURVE].kind = PH_NUMBER;
  expect_fail(PH_CHECK_SHAPE, never, never);
  make("arclength", "{\"tangents\":[[1,0,0],[1,1,0]],\"lengths\":[1.2],"
                    "\"start\":[1,2,3]}");
  claim.problem.field[PH_F_START].n = 1;
  expect_fail(PH_CHECK_INTERPOLATION, 1, 10);
  claim.problem.field[PH_F_TANGENTS].n = 1;
  expect_fail(PH_CHECK_SHAPE, never, never);
  make("planar", "{\"points\":[[0,0],[2,1],[3,0]]}");
  claim.problem.field[PH_F_POINTS].v[2] = (double)NAN;
  expect_fail(PH_CHECK_INTERPOLATION, never, never);
}

/* Samples in another order, each by itself right. */
PH_TEST(order) {
  const struct unit_wanted wanted = {
      .samples = {.how = PH_SAMPLE_PARAMETER, .n = 4}};
  struct ph_samples *s;
  double t;
  unit_claim_make(&claim, "planar", "{\"points\":[[0,0],[2,1],[3,0]]}",
                  &wanted);
  expect_pass(PH_CHECK_SAMPLE);
  s = &claim.result.samples;
  t = s->t[1];
  s->t[1] = s->t[2];
  s->t[2] = t;
  expect_fail(PH_CHECK_SAMPLE, (double)INFINITY, (double)INFINITY);
}

static void finish(void) {
  unit_claim_free(&claim);
}

PH_FIXTURE(NULL, finish)
