/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The certificate of arclength curves knows a stationary curve and a minimum
 * when it sees one: solutions pass, also as solutions of every problem that
 * they solve, and those of other problems do not.
 */
#include "check_unit.h"
#include "problem_unit.h"
#include "unit.h"

#include "kernel/quat.h"
#include "solve/method.h"

enum { N = 8, MODES = 4 };

enum mode { EXACT, RELAXED, DERIVATIVES, TANGENTS };

/* A problem with its data, and its result. */
static struct unit_solution u;
static double data[3 * (N + 1)], lengths[N];

static void begin(void) {
  unit_solution_free(&u);
  memset(data, 0, sizeof data);
  memset(lengths, 0, sizeof lengths);
  checked.command = "arclength";
  checked.problem = &u.problem;
  checked.curve = &u.result.curve;
}

static void finish(void) {
  unit_solution_free(&u);
}

static void set_vectors(enum ph_field_id id, size_t n) {
  unit_set_array(&u.problem, id, data, n, 3);
}

static void set_number(enum ph_field_id id, double number) {
  unit_set_number(&u.problem, id, number);
}

static void set_lengths(void) {
  unit_set_array(&u.problem, PH_F_LENGTHS, lengths, N, 1);
}

static void solve(void) {
  enum ph_status status = unit_solve(&ph_method_arclength, &u);
  ck_assert_msg(status == PH_OK, "%s %s", u.diag.field, u.diag.message);
  checked.claims = u.result.diagnostics;
}

/* The problem is another one now, of which nothing is claimed. */
static void claim_nothing(void) {
  memset(&checked.claims, 0, sizeof checked.claims);
}

/* ---- data ------------------------------------------------------------- */

/* A helix of one turn, its lengths 1 % too long. */
static void helix(enum mode mode, double refine) {
  double turn = 2 * acos(-1) / N;
  begin();
  for (size_t j = 0; j <= N; j++) {
    double t = (double)j * turn, *v = data + 3 * j;
    bool at = mode == EXACT || mode == RELAXED;
    v[0] = at ? cos(t) : -sin(t);
    v[1] = at ? sin(t) : cos(t);
    v[2] = at ? 0.3 * t : 0.3;
  }
  for (size_t i = 0; i < N; i++) {
    lengths[i] = 1.01 * turn * sqrt(1.09);
  }
  if (mode == DERIVATIVES) {
    for (size_t i = 0; i < 3 * (N + 1); i++) {
      data[i] *= turn;
    }
  }
  set_vectors(mode == DERIVATIVES ? PH_F_DERIVATIVES
              : mode == TANGENTS  ? PH_F_TANGENTS
                                  : PH_F_POINTS,
              N + 1);
  if (mode != RELAXED) {
    set_lengths();
  }
  set_number(PH_F_REFINE, refine);
}

/* A closed curve that is not in a plane. */
static void ring(bool exact, double refine) {
  begin();
  for (size_t j = 0; j < N; j++) {
    double t = (double)j * 2 * acos(-1) / N, *v = data + 3 * j;
    v[0] = 2 * cos(t);
    v[1] = sin(t);
    v[2] = 0.3 * sin(2 * t);
  }
  for (size_t j = 0; j < N; j++) {
    ph_vec3 from = ph_vec3_get(data + 3 * j, 3);
    ph_vec3 to = ph_vec3_get(data + 3 * ((j + 1) % N), 3);
    lengths[j] = 1.05 * ph_vec3_abs(ph_vec3_sub(to, from));
  }
  set_vectors(PH_F_POINTS, N);
  unit_set_flag(&u.problem, PH_F_CLOSED, true);
  if (exact) {
    set_lengths();
  }
  set_number(PH_F_REFINE, refine);
}

/* ---- solutions -------------------------------------------------------- */

/* Points with exact lengths and one segment each have next to no freedom, and
 * so large multipliers that the rest of the gradient is what these leave. */
PH_TEST_EACH(test_solutions, 3 * MODES) {
  enum mode mode = (enum mode)(_i % MODES);
  double f;
  helix(mode, 1 + _i / MODES);
  solve();
  f = checked.claims.value[PH_D_F];
  ck_accepted();
  ck_assert_double_le(checked.diagnostics.value[PH_D_KKT_ERROR], 1e-10);
  ck_rel(checked.diagnostics.value[PH_D_F], f, 1e-10);
  ck_abs(checked.diagnostics.value[PH_D_SECOND_ORDER], PH_OUTCOME_MINIMISER, 0);
}

PH_TEST_EACH(test_closed, 4) {
  ring(_i % 2, 2 + _i / 2);
  solve();
  ck_accepted();
  ck_assert_double_le(checked.diagnostics.value[PH_D_KKT_ERROR], 1e-10);
  ck_abs(checked.diagnostics.value[PH_D_SECOND_ORDER], PH_OUTCOME_MINIMISER, 0);
}

/* A is as good as A exp(x i), if it is one x for all segments: then the phase
 * at the seam is another, and that is all. */
PH_TEST(test_phase) {
  ring(true, 2);
  solve();
  for (int each = 0; each < 2; each++) {
    double *a = u.result.curve.preimage.v;
    for (size_t i = 0; i < 3 * u.result.curve.n; i++, a += 4) {
      ph_cplx e = ph_cplx_polar(each ? (double)(i / 3) : 0.7);
      ph_quat turned = ph_quat_turn(ph_quat_of(a[0], a[1], a[2], a[3]), e);
      memcpy(a, &turned, sizeof turned);
    }
    if (each) {
      ck_refused_for("F is");
      claim_nothing();
      ck_refused_for("kkt_error");
    } else {
      ck_accepted();
      ck_assert_double_le(checked.diagnostics.value[PH_D_KKT_ERROR], 1e-10);
    }
  }
}

/* A circle in its plane, all nodes alike: leading minors must not vanish. */
PH_TEST_EACH(test_circle, 3) {
  enum { POINTS = 200 };
  static double points[2 * POINTS];
  begin();
  for (size_t j = 0; j < POINTS; j++) {
    double t = (double)j * 2 * acos(-1) / POINTS;
    points[2 * j] = cos(t);
    points[2 * j + 1] = sin(t);
  }
  unit_set_array(&u.problem, PH_F_POINTS, points, POINTS, 2);
  unit_set_flag(&u.problem, PH_F_CLOSED, true);
  set_number(PH_F_REFINE, 1 + _i);
  solve();
  ck_accepted();
  ck_abs(checked.diagnostics.value[PH_D_SECOND_ORDER], PH_OUTCOME_MINIMISER, 0);
}

/* ---- of which problem? ------------------------------------------------ */

/* With free lengths F would be smaller; a curve whose lengths were free is a
 * solution also when they are prescribed. */
PH_TEST(test_lengths_matter) {
  helix(EXACT, 2);
  solve();
  u.problem.field[PH_F_LENGTHS].kind = PH_ABSENT;
  claim_nothing();
  ck_refused_for("kkt_error");
  ck_assert_double_gt(checked.diagnostics.value[PH_D_KKT_ERROR], 1e-3);
  helix(RELAXED, 2);
  solve();
  for (size_t i = 0; i < N; i++) {
    lengths[i] =
        u.result.curve.lengths[2 * i] + u.result.curve.lengths[2 * i + 1];
  }
  set_lengths();
  ck_accepted();
}

/* The same for the magnitudes of tangents. */
PH_TEST(test_magnitudes_matter) {
  helix(DERIVATIVES, 2);
  solve();
  set_vectors(PH_F_TANGENTS, N + 1);
  u.problem.field[PH_F_DERIVATIVES].kind = PH_ABSENT;
  claim_nothing();
  ck_refused_for("kkt_error");
  helix(TANGENTS, 2);
  solve();
  for (size_t j = 0; j <= N; j++) {
    size_t last = j == N;
    const double *p = u.result.curve.control_points + 18 * (2 * j - last);
    ph_vec3 leg = ph_vec3_sub(ph_vec3_get(p + (last ? 15 : 3), 3),
                              ph_vec3_get(p + (last ? 12 : 0), 3));
    double h = u.result.curve.knots[1] - u.result.curve.knots[0];
    ph_vec3_put(ph_vec3_scale(5 / h, leg), 3, data + 3 * j);
  }
  set_vectors(PH_F_DERIVATIVES, N + 1);
  u.problem.field[PH_F_TANGENTS].kind = PH_ABSENT;
  ck_accepted();
}

/* So do the deviation of lengths and what they are weighed by, unless there is
 * one segment in each, where the points all but settle the lengths. */
PH_TEST_EACH(test_sigma_matters, 4) {
  const double sigma = _i % 2 ? 1e-2 : 1e-3;
  helix(EXACT, 2 + _i / 2);
  set_number(PH_F_LENGTH_SIGMA, sigma);
  solve();
  ck_accepted();
  ck_assert_double_le(checked.diagnostics.value[PH_D_KKT_ERROR], 1e-10);
  set_number(PH_F_LENGTH_SIGMA, sigma * 1.5);
  ck_refused_for("kkt_error");
  set_number(PH_F_LENGTH_SIGMA, sigma);
  checked.claims.value[PH_D_F_RELAXED] *= 2;
  ck_refused_for("kkt_error");
}

/* Lengths that are all but exact are taken as exact. */
PH_TEST_EACH(test_tiny_sigma, 2) {
  helix(EXACT, 2 + _i);
  set_number(PH_F_LENGTH_SIGMA, 1e-9);
  solve();
  ck_accepted();
  ck_assert_double_le(checked.diagnostics.value[PH_D_KKT_ERROR], 1e-9);
}

/* ---- claims ----------------------------------------------------------- */

/* A sine whose lengths keep it in its plane only as a saddle
 * [HUA14, fig. 3]. */
PH_TEST(test_saddle) {
  begin();
  for (size_t j = 0; j <= 3; j++) {
    double t = (double)j * acos(-1) / 3;
    data[3 * j] = t;
    data[3 * j + 1] = sin(t);
  }
  lengths[0] = lengths[2] = 1.3646439;
  lengths[1] = 1.0909097;
  set_vectors(PH_F_POINTS, 4);
  set_lengths();
  u.problem.field[PH_F_LENGTHS].n = 3;
  unit_set_word(&u.problem, PH_F_KNOTS, "uniform");
  set_number(PH_F_REFINE, 1);
  solve();
  ck_abs(checked.claims.value[PH_D_SECOND_ORDER], PH_OUTCOME_SADDLE, 0);
  ck_accepted();
  ph_diagnostics_set(&checked.claims, PH_D_SECOND_ORDER, PH_OUTCOME_MINIMISER);
  ck_refused_for("claimed to be a minimiser");
}

PH_TEST(test_functional) {
  double f;
  helix(EXACT, 2);
  solve();
  f = checked.claims.value[PH_D_F];
  checked.claims.value[PH_D_F] *= 1 + 1e-9;
  ck_refused_for("F is");
  checked.claims.value[PH_D_F] = (double)NAN;
  ck_refused_for("F is");
  claim_nothing();
  ck_accepted();
  ck_rel(checked.diagnostics.value[PH_D_F], f, 1e-11);
}

PH_FIXTURE(NULL, finish)
