/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Adaptive quadrature of verification, against closed forms. */
#include "unit.h"

#include "check/integral.h"

static struct ph_check_rule rule;

/* A peak of area about pi at `at', `width' wide, on a level; uncertain by some
 * multiple of itself. */
struct peak {
  double at, width, level, uncertain;
};

static void peak_at(const void *context, double x, double *value) {
  const struct peak *p = context;
  double y = (x - p->at) / p->width, peak = 1 / (p->width * (1 + y * y));
  value[0] = p->level + peak;
  value[1] = p->uncertain * peak;
}

static double peak_area(const struct peak *p, double from, double to) {
  return atan((to - p->at) / p->width) - atan((from - p->at) / p->width);
}

PH_TEST(peaks) {
  ck_assert(ph_check_rule_of(&rule, &unit_arena));
  for (int e = 0; e <= 20; e++) {
    const struct peak peak = {0.4, ldexp(1, -e), 1, 0};
    const struct ph_check_integrands of = {peak_at, &peak, 1, 0, 0, 1e-13};
    double sum[2];
    ph_check_integral(&rule, &of, 0, 1, sum);
    ck_rel(sum[0], 1 + peak_area(&peak, 0, 1), 1e-12);
  }
}

/* At an end, where no node is near, what is as uncertain as it is large is
 * found, and so is how uncertain it is. */
PH_TEST(uncertain_peaks) {
  ck_assert(ph_check_rule_of(&rule, &unit_arena));
  for (int e = 0; e <= 20; e++) {
    for (double uncertain = 1e-3; uncertain < 2000; uncertain *= 10) {
      const struct peak peak = {e % 2 ? 0 : 1, ldexp(1, -e), 0.01, uncertain};
      const struct ph_check_integrands of = {peak_at, &peak, 2, 1, 0, 1e-13};
      double area = peak_area(&peak, 0, 1), sum[2];
      ph_check_integral(&rule, &of, 0, 1, sum);
      ck_rel(sum[1], uncertain * area, 0.5);
      ck_abs(sum[0], 0.01 + area, 0.2 * fmin(uncertain, 1) * area);
    }
  }
}

/* What is not finite is no number, and others do not suffer from it. */
static void not_finite(const void *context, double x, double *value) {
  (void)context;
  value[0] = x > 0.5 ? HUGE_VAL : 1;
  value[1] = x * x;
}

PH_TEST(no_number) {
  const struct ph_check_integrands of = {not_finite, NULL, 2, 0, 0, 1e-13};
  double sum[2];
  ck_assert(ph_check_rule_of(&rule, &unit_arena));
  ph_check_integral(&rule, &of, 0, 1, sum);
  ck_assert(isnan(sum[0]));
  ck_rel(sum[1], 1.0 / 3, 4 * DBL_EPSILON);
}
