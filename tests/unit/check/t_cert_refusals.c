/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The certificate of arclength for what makes a curve the right one among those
 * that fit the data: F, first and second order.  The curves are those of the
 * solver; what is changed is what they claim to be, or the problem, by so much
 * that the same curve still fits it, but is no longer stationary.
 */
#include "unit.h"

#include "check/certify.h"
#include "solve/method.h"

#include <string.h>

enum { N = 6 };

enum kind { OPEN, CLOSED, DERIVATIVES, TANGENTS, KINDS };

static struct {
  struct ph_problem problem;
  struct ph_result result;
  struct ph_diag diag;
  struct ph_arena arena, scratch;
  double vectors[3 * (N + 1)], lengths[N];
} u;

static void finish(void) {
  ph_arena_free(&u.arena);
  ph_arena_free(&u.scratch);
}

static struct ph_value numbers(double *v, size_t n) {
  return (struct ph_value){.kind = PH_NUMBERS, .v = v, .n = n, .dimension = 1};
}

static struct ph_value number(double x) {
  return (struct ph_value){.kind = PH_NUMBER, .number = x};
}

static void set_vectors(enum ph_field_id id, size_t n) {
  u.problem.field[id] = (struct ph_value){
      .kind = PH_VECTORS, .v = u.vectors, .n = n, .dimension = 3};
}

/* A turn of a helix, or of a wave that comes back; lengths are somewhat above
 * the chords. */
static void begin(enum kind kind) {
  size_t n = kind == CLOSED ? N : N + 1;
  memset(&u, 0, sizeof u);
  for (size_t i = 0; i < n; i++) {
    double t = 6.283185307179586 * (double)i / N;
    const double point[] = {cos(t), sin(t),
                            kind == CLOSED ? 0.2 * sin(2 * t) : 0.3 * t};
    const double tangent[] = {-sin(t), cos(t), 0.3};
    memcpy(u.vectors + 3 * i, kind <= CLOSED ? point : tangent, sizeof point);
  }
  set_vectors(kind <= CLOSED        ? PH_F_POINTS
              : kind == DERIVATIVES ? PH_F_DERIVATIVES
                                    : PH_F_TANGENTS,
              n);
  u.problem.field[PH_F_CLOSED] =
      (struct ph_value){.kind = PH_BOOL, .flag = kind == CLOSED};
  for (size_t i = 0; i < N; i++) {
    u.lengths[i] = 1.1;
  }
  u.problem.field[PH_F_LENGTHS] = numbers(u.lengths, N);
  u.problem.field[PH_F_REFINE] = number(2);
}

/* Three points of a sine in its plane: there the curve is a saddle
 * [HUA14, fig. 3]. */
static void begin_sine(void) {
  static const double lengths[] = {1.364647438430407, 1.0909029121668972,
                                   1.3646474384304073};
  memset(&u, 0, sizeof u);
  for (size_t i = 0; i < 4; i++) {
    double t = 3.141592653589793 / 3 * (double)i;
    u.vectors[3 * i] = t;
    u.vectors[3 * i + 1] = sin(t);
  }
  memcpy(u.lengths, lengths, sizeof lengths);
  set_vectors(PH_F_POINTS, 4);
  u.problem.field[PH_F_LENGTHS] = numbers(u.lengths, 3);
  u.problem.field[PH_F_REFINE] = number(1);
}

static void solve(void) {
  enum ph_status status = ph_method_arclength.solve(
      &u.problem, &u.arena, &u.scratch, &u.result, &u.diag);
  ck_assert_msg(status == PH_OK, "%s %s", u.diag.field, u.diag.message);
}

static enum ph_status certify(void) {
  struct ph_diagnostics diagnostics = u.result.diagnostics; /* stay claims */
  memset(&u.diag, 0, sizeof u.diag);
  return ph_certify("arclength", &u.problem, &u.result.curve, &u.scratch,
                    &diagnostics, &u.diag);
}

static void ck_accepted(void) {
  enum ph_status status = certify();
  ck_assert_msg(status == PH_OK, "%s %s", u.diag.field, u.diag.message);
}

static void ck_refused(const char *why) {
  ck_assert_int_eq(certify(), PH_NO_CONVERGENCE);
  ck_assert_msg(strstr(u.diag.message, why) != NULL, "%s", u.diag.message);
}

static enum ph_outcome claim(void) {
  return (enum ph_outcome)u.result.diagnostics.value[PH_D_SECOND_ORDER];
}

/* F to ten digits. */
PH_TEST_EACH(test_functional, KINDS) {
  double *f = &u.result.diagnostics.value[PH_D_F], keep;
  begin((enum kind)_i);
  solve();
  ck_assert_int_eq(claim(), PH_OUTCOME_MINIMISER);
  ck_accepted();
  keep = *f;
  *f *= 1 + 1e-8;
  ck_refused("F is");
  *f = (double)NAN;
  ck_refused("F is");
  *f = keep;
  ck_accepted();
}

/* Where the lengths are free the curve has more room than it has used. */
PH_TEST_EACH(test_first_order, KINDS) {
  begin((enum kind)_i);
  solve();
  ck_accepted();
  u.problem.field[PH_F_LENGTHS].kind = PH_ABSENT;
  ck_refused("kkt_error");
}

/* Soft lengths have multipliers that follow from how soft they are. */
PH_TEST_EACH(test_soft, 2) {
  begin(_i ? CLOSED : OPEN);
  u.problem.field[PH_F_LENGTH_SIGMA] = number(0.01);
  solve();
  ck_accepted();
  u.problem.field[PH_F_LENGTH_SIGMA] = number(0.02);
  ck_refused("kkt_error");
  u.problem.field[PH_F_LENGTH_SIGMA] = number(0.01);
  u.lengths[2] *= 1.001;
  ck_refused("kkt_error");
}

/* That it is a saddle is believed, and nothing else. */
PH_TEST(test_second_order) {
  begin_sine();
  solve();
  ck_assert_int_eq(claim(), PH_OUTCOME_SADDLE);
  ck_accepted();
  u.result.diagnostics.value[PH_D_SECOND_ORDER] = PH_OUTCOME_MINIMISER;
  ck_refused("F can fall");
  u.problem.field[PH_F_PLANAR] =
      (struct ph_value){.kind = PH_WORD, .word = "free"};
  memset(&u.result, 0, sizeof u.result);
  solve();
  ck_assert_int_eq(claim(), PH_OUTCOME_MINIMISER);
  ck_accepted();
}

PH_TESTS_WITH(NULL, finish, test_functional, test_first_order, test_soft,
              test_second_order)
