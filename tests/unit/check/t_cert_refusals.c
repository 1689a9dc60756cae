/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The certificate of arclength for what makes a curve the right one among those
 * that fit the data: F, first and second order.  The curves are those of the
 * solver; what is changed is what they claim to be, or the problem, by so much
 * that the same curve still fits it, but is no longer stationary.
 */
#include "check_unit.h"
#include "problem_unit.h"
#include "unit.h"

#include "solve/method.h"

enum { N = 6 };

enum kind { OPEN, CLOSED, DERIVATIVES, TANGENTS, KINDS };

static struct unit_solution u;
static double vectors[3 * (N + 1)], lengths[N];

static void clear(void) {
  unit_solution_free(&u);
  memset(vectors, 0, sizeof vectors);
  checked.command = "arclength";
  checked.problem = &u.problem;
  checked.curve = &u.result.curve;
}

static void finish(void) {
  unit_solution_free(&u);
}

/* A turn of a helix, or of a wave that comes back; lengths are somewhat above
 * the chords. */
static void begin(enum kind kind) {
  size_t n = kind == CLOSED ? N : N + 1;
  clear();
  for (size_t i = 0; i < n; i++) {
    double t = 6.283185307179586 * (double)i / N;
    const double point[] = {cos(t), sin(t),
                            kind == CLOSED ? 0.2 * sin(2 * t) : 0.3 * t};
    const double tangent[] = {-sin(t), cos(t), 0.3};
    memcpy(vectors + 3 * i, kind <= CLOSED ? point : tangent, sizeof point);
  }
  unit_set_array(&u.problem,
                 kind <= CLOSED        ? PH_F_POINTS
                 : kind == DERIVATIVES ? PH_F_DERIVATIVES
                                       : PH_F_TANGENTS,
                 vectors, n, 3);
  unit_set_flag(&u.problem, PH_F_CLOSED, kind == CLOSED);
  for (size_t i = 0; i < N; i++) {
    lengths[i] = 1.1;
  }
  unit_set_array(&u.problem, PH_F_LENGTHS, lengths, N, 1);
  unit_set_number(&u.problem, PH_F_REFINE, 2);
}

/* Three points of a sine in its plane: there the curve is a saddle
 * [HUA14, fig. 3]. */
static void begin_sine(void) {
  static const double sine[] = {1.364647438430407, 1.0909029121668972,
                                1.3646474384304073};
  clear();
  for (size_t i = 0; i < 4; i++) {
    double t = 3.141592653589793 / 3 * (double)i;
    vectors[3 * i] = t;
    vectors[3 * i + 1] = sin(t);
  }
  memcpy(lengths, sine, sizeof sine);
  unit_set_array(&u.problem, PH_F_POINTS, vectors, 4, 3);
  unit_set_array(&u.problem, PH_F_LENGTHS, lengths, 3, 1);
  unit_set_number(&u.problem, PH_F_REFINE, 1);
}

static void solve(void) {
  enum ph_status status = unit_solve(&ph_method_arclength, &u);
  ck_assert_msg(status == PH_OK, "%s %s", u.diag.field, u.diag.message);
  checked.claims = u.result.diagnostics;
}

static enum ph_outcome claim(void) {
  return (enum ph_outcome)checked.claims.value[PH_D_SECOND_ORDER];
}

/* F to ten digits. */
PH_TEST_EACH(test_functional, KINDS) {
  double *f = &checked.claims.value[PH_D_F], keep;
  begin((enum kind)_i);
  solve();
  ck_assert_int_eq(claim(), PH_OUTCOME_MINIMISER);
  ck_accepted();
  keep = *f;
  *f *= 1 + 1e-8;
  ck_refused_for("F is");
  *f = (double)NAN;
  ck_refused_for("F is");
  *f = keep;
  ck_accepted();
}

/* Where the lengths are free the curve has more room than it has used. */
PH_TEST_EACH(test_first_order, KINDS) {
  begin((enum kind)_i);
  solve();
  ck_accepted();
  u.problem.field[PH_F_LENGTHS].kind = PH_ABSENT;
  ck_refused_for("kkt_error");
}

/* Soft lengths have multipliers that follow from how soft they are. */
PH_TEST_EACH(test_soft, 2) {
  begin(_i ? CLOSED : OPEN);
  unit_set_number(&u.problem, PH_F_LENGTH_SIGMA, 0.01);
  solve();
  ck_accepted();
  unit_set_number(&u.problem, PH_F_LENGTH_SIGMA, 0.02);
  ck_refused_for("kkt_error");
  unit_set_number(&u.problem, PH_F_LENGTH_SIGMA, 0.01);
  lengths[2] *= 1.001;
  ck_refused_for("kkt_error");
}

/* That it is a saddle is believed, and nothing else. */
PH_TEST(test_second_order) {
  begin_sine();
  solve();
  ck_assert_int_eq(claim(), PH_OUTCOME_SADDLE);
  ck_accepted();
  checked.claims.value[PH_D_SECOND_ORDER] = PH_OUTCOME_MINIMISER;
  ck_refused_for("F can fall");
  unit_set_word(&u.problem, PH_F_PLANAR, "free");
  solve();
  ck_assert_int_eq(claim(), PH_OUTCOME_MINIMISER);
  ck_accepted();
}

PH_FIXTURE(NULL, finish)
