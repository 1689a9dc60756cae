/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * What every unit test needs: Check, comparisons of numbers and points, random
 * numbers, and main.
 *
 * A file of tests is t_NAME.c, an executable of its own, which runs what it
 * defines, in that order:
 *
 *     #include "unit.h"
 *     PH_TEST(test_this) {...}
 *     PH_TEST_EACH(test_that, 3) {... _i ...}
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
#include "kernel/cplx.h"
#include "kernel/quad.h"
#include "kernel/vec3.h"

#include <check.h>
#include <float.h>
#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Check writes down every assertion that holds, each with a system call, to
 * tell the last one before a crash: most of the time of the tests.  The message
 * of a crash names the test; a sanitizer or a debugger names the line. */
#define _mark_point(file, line) ((void)0)

/* How many elements an array has. */
#define COUNT(array) (sizeof(array) / sizeof *(array))

/* For whatever a test needs memory for; freed after each test. */
extern struct ph_arena unit_arena;

/* The Gauss rule of n nodes. */
const struct ph_quad *unit_quad(size_t n);

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
  const TTest *check;
  int n;
  struct unit_test *next;
};

/* Adds a test to those that main runs. */
void unit_add(struct unit_test *test);

/* Run before and after each test, unless NULL. */
extern void (*unit_begin)(void), (*unit_finish)(void);

/* Begins a test that runs n times. */
#define PH_TEST_EACH(name, n)                                           \
  static void name##_run(int _i);                                       \
  static __attribute__((constructor)) void name(void) {                 \
    static const TTest check = {#name, name##_run, __FILE__, __LINE__}; \
    static struct unit_test test = {&check, (int)(n), NULL};            \
    unit_add(&test);                                                    \
  }                                                                     \
  static void name##_run(int _i CK_ATTRIBUTE_UNUSED)

/* Begins a test. */
#define PH_TEST(name) PH_TEST_EACH(name, 1)

/* What runs before and after each test of a file; NULL: nothing. */
#define PH_FIXTURE(begin, finish)                      \
  static __attribute__((constructor)) void fix(void) { \
    unit_begin = (begin);                              \
    unit_finish = (finish);                            \
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

/* ---- random numbers ---------------------------------------------------- */

/* The same on every machine: splitmix64 (Steele, Lea, Flood 2014).  The seed is
 * 1, or PH_SEED; messages of failures name it. */
struct unit_random {
  uint64_t state;
};

/* The seed of this run. */
static inline unsigned long unit_seed(void) {
  const char *text = getenv("PH_SEED");
  return text != NULL ? strtoul(text, NULL, 10) : 1;
}

/* Generator number `stream` of this run: tests do not share their numbers. */
static inline struct unit_random unit_random_of(uint64_t stream) {
  struct unit_random r = {unit_seed() * 0xD1B54A32D192ED03u + stream};
  return r;
}

static inline uint64_t unit_random_bits(struct unit_random *r) {
  uint64_t z = r->state += 0x9E3779B97F4A7C15u;
  z = (z ^ z >> 30) * 0xBF58476D1CE4E5B9u;
  z = (z ^ z >> 27) * 0x94D049BB133111EBu;
  return z ^ z >> 31;
}

/* Uniform in [low, high). */
static inline double unit_random_in(struct unit_random *r, double low,
                                    double high) {
  double u = (double)(unit_random_bits(r) >> 11) * 0x1p-53;
  return low + u * (high - low);
}

/* 0, 1, ..., n - 1; n is so small that the bias does not matter. */
static inline size_t unit_random_below(struct unit_random *r, size_t n) {
  return (size_t)(unit_random_bits(r) % n);
}

/* Uniform in the square |re|, |im| < size. */
static inline ph_cplx unit_random_cplx(struct unit_random *r, double size) {
  double re = unit_random_in(r, -size, size);
  return ph_cplx_of(re, unit_random_in(r, -size, size));
}

/* |a - b|, without overflow. */
static inline double unit_distance(ph_cplx a, ph_cplx b) {
  return hypot(a.re - b.re, a.im - b.im);
}

static inline double unit_apart(ph_vec3 a, ph_vec3 b) {
  return ph_vec3_abs(ph_vec3_sub(a, b));
}

/* The larger; NaN if either is, where fmax would take the other. */
static inline double unit_larger(double a, double b) {
  return b <= a || isnan(a) ? a : b;
}

/* ---- comparisons of points: their distance is at most tol -------------- */

#define ck_cplx(found, wanted, tol)                                           \
  do {                                                                        \
    const ph_cplx ck_p_ = (found), ck_q_ = (wanted);                          \
    const double ck_d_ = unit_distance(ck_p_, ck_q_), ck_most_ = (tol);       \
    ck_assert_msg(ck_d_ <= ck_most_,                                          \
                  "seed %lu: (%.17g, %.17g), not (%.17g, %.17g): %.3g > "     \
                  "%.3g",                                                     \
                  unit_seed(), ck_p_.re, ck_p_.im, ck_q_.re, ck_q_.im, ck_d_, \
                  ck_most_);                                                  \
  } while (0)

#define ck_vec3(found, wanted, tol)                                         \
  do {                                                                      \
    const ph_vec3 ck_p_ = (found), ck_q_ = (wanted);                        \
    const double ck_d_ = unit_apart(ck_p_, ck_q_);                          \
    const double ck_most_ = (tol);                                          \
    ck_assert_msg(ck_d_ <= ck_most_,                                        \
                  "seed %lu: (%.17g, %.17g, %.17g), not (%.17g, %.17g, "    \
                  "%.17g): %.3g > %.3g",                                    \
                  unit_seed(), ck_p_.x, ck_p_.y, ck_p_.z, ck_q_.x, ck_q_.y, \
                  ck_q_.z, ck_d_, ck_most_);                                \
  } while (0)

/* ---- how much is tested ------------------------------------------------ */

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

/* What the failure PH_E_COINCIDENT_POINTS ends with. */
#define JOINS "; --merge=D joins points nearer than D"

#endif
