/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Adaptive quadrature: smooth and kinked integrands, and what it gives up. */
#include "adapt_unit.h"
#include "unit.h"

static double peak(const void *context, double x) {
  const double *width = context;
  return *width / (*width * *width + x * x);
}

static double kink(const void *context, double x) {
  const double *at = context;
  return fabs(x - *at);
}

static double root(const void *context, double x) {
  (void)context;
  return sqrt(x);
}

static double pole(const void *context, double x) {
  const double *at = context;
  return 1 / (x - *at);
}

PH_TEST(test_peak) {
  for (int e = 0; e <= 30; e++) {
    double width = ldexp(1, -e);
    ck_rel(unit_adapt(unit_quad(8), peak, &width, -0.3, 1, 1e-13, 0),
           atan(0.3 / width) + atan(1 / width), 4e-13);
  }
}

PH_TEST(test_kink) {
  const double places[] = {0, 0.5, 1.0 / 3, 0.9, 1};
  for (size_t i = 0; i < COUNT(places); i++) {
    double a = places[i];
    ck_abs(unit_adapt(unit_quad(8), kink, &a, 0, 1, 1e-13, 0),
           a * a / 2 + (1 - a) * (1 - a) / 2, 1e-13);
  }
  ck_rel(unit_adapt(unit_quad(8), root, NULL, 0, 4, 1e-13, 0), 16.0 / 3, 1e-13);
  ck_abs(unit_adapt(unit_quad(8), root, NULL, 2, 2, 1e-13, 0), 0, 0);
}

/* Nothing is asked of rounding: a tolerance of 0 ends, too. */
PH_TEST(test_no_tolerance) {
  double width = 0.5;
  ck_rel(unit_adapt(unit_quad(8), peak, &width, 0, 1, 0, 0), atan(2), 1e-15);
}

PH_TEST(test_not_finite) {
  double at = (double)NAN;
  ck_assert(isnan(unit_adapt(unit_quad(8), kink, &at, 0, 1, 1e-13, 0)));
  at = unit_quad(8)->node[3]; /* the rule hits the pole */
  ck_assert(!isfinite(unit_adapt(unit_quad(8), pole, &at, 0, 1, 1e-13, 0)));
}
