/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * What every unit test needs: Check, two comparisons of doubles, and main.
 *
 * A file of tests is t_NAME.c, an executable of its own:
 *
 *     #include "unit.h"
 *     PH_TEST(test_this) {...}
 *     PH_TEST_EACH(test_that, 3) {... _i ...}
 *     PH_TESTS(test_this, test_that)
 *
 * Tests of many cases are tables: one loop over an array of structs, whose
 * names unit_case takes down for the message of a failure.
 *
 * Check's ck_assert_double_eq_tol asks for |a - b| < tol, so that a tolerance
 * of 0 always fails; ours ask for <=, and say what they saw to the last digit.
 */
#ifndef PH_TESTS_UNIT_H
#define PH_TESTS_UNIT_H

#include "base/mem.h"

#include <check.h>
#include <math.h>
#include <stdlib.h>

/* For whatever a test needs memory for; freed after each test. */
extern struct ph_arena unit_arena;

/* Takes down which case is being tested, as printf does: a failure from here
 * to the end of the test says it. */
void unit_case(const char *format, ...) CK_ATTRIBUTE_FORMAT(printf, 1, 2);

/* Prints the case, if there is one. */
void unit_case_print(void);

/* Every assertion of Check fails through this function. */
#define _ck_assert_failed(...) \
  (unit_case_print(), (_ck_assert_failed)(__VA_ARGS__))

/* A test, and how often it runs: _i counts from 0. */
struct unit_test {
  TTest check;
  int n;
};

/* Begins a test that runs n times. */
#define PH_TEST_EACH(name, n)                               \
  static void name##_run(int _i);                           \
  static const struct unit_test name[] = {                  \
      {{#name, name##_run, __FILE__, __LINE__}, (int)(n)}}; \
  static void name##_run(int _i CK_ATTRIBUTE_UNUSED)

/* Begins a test. */
#define PH_TEST(name) PH_TEST_EACH(name, 1)

/* Runs n tests; begin and finish, unless NULL, before and after each. */
int unit_main(const char *file, const struct unit_test *const *tests, size_t n,
              void (*begin)(void), void (*finish)(void));

/* Ends a file: its tests, in the order in which they run. */
#define PH_TESTS(...) PH_TESTS_WITH(NULL, NULL, __VA_ARGS__)
#define PH_TESTS_WITH(begin, finish, ...)                                    \
  int main(void) {                                                           \
    static const struct unit_test *const tests[] = {__VA_ARGS__};            \
    return unit_main(__FILE__, tests, sizeof tests / sizeof tests[0], begin, \
                     finish);                                                \
  }

/* The same number: NaN is none, infinities are, and -0 is +0. */
static inline int unit_same(double a, double b) {
  return a <= b && b <= a;
}

/* |a - b| <= tol, or the same; an infinity is near nothing but itself. */
static inline int unit_near(double a, double b, double tol) {
  return unit_same(a, b) || (isfinite(a) && isfinite(b) && fabs(a - b) <= tol);
}

/* |a - b| <= tol max(|a|, |b|), or the same.  fmax is not used: it takes
 * one number for an answer where the other is NaN. */
static inline int unit_near_rel(double a, double b, double tol) {
  double size = fabs(a) > fabs(b) ? fabs(a) : fabs(b);

  return unit_near(a, b, tol * size);
}

/* How far a and b are apart, relative to the larger, for the message. */
static inline double unit_rel_error(double a, double b) {
  double size = fabs(a) > fabs(b) ? fabs(a) : fabs(b);

  return unit_same(a, b) ? 0.0 : fabs(a - b) / size;
}

/* Fails unless a and b agree to the relative tolerance tol (0: exactly). */
#define ck_rel(a, b, tol)                                                    \
  do {                                                                       \
    const double ck_a_ = (a);                                                \
    const double ck_b_ = (b);                                                \
    const double ck_tol_ = (tol);                                            \
    if (!unit_near_rel(ck_a_, ck_b_, ck_tol_)) {                             \
      ck_abort_msg("%s = %.17g, %s = %.17g: relative error %.3g > %.3g", #a, \
                   ck_a_, #b, ck_b_, unit_rel_error(ck_a_, ck_b_), ck_tol_); \
    }                                                                        \
  } while (0)

/* Fails unless a and b agree to the absolute tolerance tol (0: exactly). */
#define ck_abs(a, b, tol)                                                      \
  do {                                                                         \
    const double ck_a_ = (a);                                                  \
    const double ck_b_ = (b);                                                  \
    const double ck_tol_ = (tol);                                              \
    if (!unit_near(ck_a_, ck_b_, ck_tol_)) {                                   \
      ck_abort_msg("%s = %.17g, %s = %.17g: error %.3g > %.3g", #a, ck_a_, #b, \
                   ck_b_, fabs(ck_a_ - ck_b_), ck_tol_);                       \
    }                                                                          \
  } while (0)

/* Fails, saying why, unless the condition holds. */
#define ck_that(condition, ...)  \
  do {                           \
    if (!(condition)) {          \
      ck_abort_msg(__VA_ARGS__); \
    }                            \
  } while (0)

/* True when the long form of a test is wanted: PH_LONG=1. */
static inline int unit_long(void) {
  const char *s = getenv("PH_LONG");

  return s != NULL && s[0] == '1';
}

/* n, or a tenth of it where every step takes long: under valgrind and the
 * sanitizers, PH_SHORT=1. */
static inline int unit_count(int n) {
  const char *s = getenv("PH_SHORT");

  return s != NULL && s[0] == '1' ? (n + 9) / 10 : n;
}

/* How many random cases: n, ten times as many, or a tenth of them. */
static inline size_t unit_cases(size_t n) {
  return unit_long() ? 10 * n : (size_t)unit_count((int)n);
}

#endif
