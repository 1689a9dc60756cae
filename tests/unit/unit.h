/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * What every unit test needs: Check, two comparisons of doubles, and main.
 *
 * A test is tests/unit/t_NAME.c, an executable of its own:
 *
 *     #include "unit.h"
 *     static Suite *suite(void) {...}
 *     PH_TEST_MAIN(suite)
 *
 * Check's ck_assert_double_eq_tol asks for |a - b| < tol, so that a tolerance
 * of 0 always fails; ours ask for <=, and say what they saw to the last digit.
 */
#ifndef PH_TESTS_UNIT_H
#define PH_TESTS_UNIT_H

#include <check.h>
#include <gsl/gsl_errno.h>
#include <math.h>
#include <stdlib.h>

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

/* GSL's handler is off, as in the program: by default it aborts. */
#define PH_TEST_MAIN(suite_fn)                        \
  int main(void) {                                    \
    SRunner *runner = srunner_create(suite_fn());     \
    int failed;                                       \
                                                      \
    gsl_set_error_handler_off();                      \
    srunner_run_all(runner, CK_ENV);                  \
    failed = srunner_ntests_failed(runner);           \
    srunner_free(runner);                             \
    return failed == 0 ? EXIT_SUCCESS : EXIT_FAILURE; \
  }

#endif
