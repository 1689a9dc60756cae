/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Integrals as tables, against closed forms. */
#include "unit.h"

#include "kernel/primitive.h"

enum { PLACES = 1000 };

static struct ph_primitive table;

static void begin(void) {
  const struct ph_primitive none = {.panels = NULL};
  table = none;
}

/* A function, its integral, and a number both depend on. */
struct known {
  ph_integrand *f, *integral;
};

static double parameter_of(const void *context) {
  return *(const double *)context;
}

/* 16 powers: the last one that is integrated exactly. */
static double power(const void *context, double x) {
  return pow(x, parameter_of(context));
}
static double power_integral(const void *context, double x) {
  const double n = parameter_of(context);
  return pow(x, n + 1) / (n + 1);
}

/* A speed that nearly vanishes, d from 0. */
static double dip(const void *context, double x) {
  return hypot(x - 0.3, parameter_of(context));
}
static double dip_to(double x, double d) {
  return 0.5 * (x * hypot(x, d) + d * d * asinh(x / d));
}
static double dip_integral(const void *context, double x) {
  const double d = parameter_of(context);
  return dip_to(x - 0.3, d) + dip_to(0.3, d);
}

/* A frame that turns all at once, in d; known to eps / d near 0.3. */
static double peak(const void *context, double x) {
  const double d = parameter_of(context);
  return d / (d * d + (x - 0.3) * (x - 0.3));
}
static double peak_integral(const void *context, double x) {
  const double d = parameter_of(context);
  return atan((x - 0.3) / d) + atan(0.3 / d);
}

static double wave(const void *context, double x) {
  return 1 + sin(parameter_of(context) * x);
}
static double wave_integral(const void *context, double x) {
  const double n = parameter_of(context), s = sin(n * x / 2);
  return x + 2 * s * s / n;
}

static double kink(const void *context, double x) {
  return fabs(x - parameter_of(context));
}
static double kink_integral(const void *context, double x) {
  const double a = parameter_of(context), b = x - a;
  return 0.5 * (a * a + b * fabs(b));
}

static double step(const void *context, double x) {
  return x < parameter_of(context) ? 2 : 3;
}
static double step_integral(const void *context, double x) {
  const double a = parameter_of(context);
  return 2 * x + fmax(x - a, 0);
}

static double pole(const void *context, double x) {
  return 1 / (x - parameter_of(context));
}

static double zero(const void *context, double x) {
  (void)context, (void)x;
  return 0;
}

/* Integrals of a positive function up to many places, and its values. */
static void ck_known(struct known known, double parameter, double tolerance) {
  const double total = known.integral(&parameter, 1);
  struct unit_random r = unit_random_of(900);
  double before = 0;
  ck_assert_int_eq(ph_primitive_make(&table, known.f, &parameter, NULL, 0,
                                     tolerance / 2, &unit_arena),
                   PH_OK);
  ck_rel(table.total, total, tolerance);
  ck_abs(ph_primitive_at(&table, 0, NULL), 0, 0);
  ck_abs(ph_primitive_at(&table, 1, NULL), table.total, 0);
  for (int i = 0; i < PLACES; i++) {
    double u = (i + unit_random_in(&r, 0, 1)) / PLACES, value;
    double at = ph_primitive_at(&table, u, &value);
    ck_abs(at, known.integral(&parameter, u), tolerance * total);
    ck_abs(value, known.f(&parameter, u),
           64 * tolerance * fmax(total, known.f(&parameter, u)));
    ck_assert(at >= before - 4 * DBL_EPSILON * total);
    before = at;
  }
}

PH_TEST(test_powers) {
  const struct known known = {power, power_integral};
  for (int n = 0; n < PH_PRIMITIVE_NODES - 2; n++) {
    ck_known(known, n, 2e-15);
    ck_assert_uint_eq(table.n, 1);
  }
  ck_known(known, 60, 1e-14);
  ck_known(known, 0.5, 1e-14);
  ck_known(known, 1.5, 1e-14);
}

PH_TEST(test_dip) {
  const struct known known = {dip, dip_integral};
  for (int e = 0; e <= 40; e += 2) {
    ck_known(known, ldexp(1, -e), 4e-15);
    ck_assert_uint_le(table.n, 120);
  }
}

PH_TEST(test_peak) {
  const struct known known = {peak, peak_integral};
  for (int e = 0; e <= 30; e += 2) {
    const double width = ldexp(1, -e);
    ck_known(known, width, fmax(1e-14, 16 * DBL_EPSILON / width));
    ck_assert(table.n <= 100 || e > 8);
  }
}

/* No better than places are rounded, however much is asked for: in few panels.
 */
PH_TEST(test_steep) {
  for (int e = 20; e <= 44; e += 4) {
    const double width = ldexp(1, -e);
    ck_assert_int_eq(
        ph_primitive_make(&table, peak, &width, NULL, 0, 1e-15, &unit_arena),
        PH_OK);
    ck_rel(table.total, peak_integral(&width, 1), 16 * DBL_EPSILON / width);
    ck_assert_uint_le(table.n, 400);
  }
}

PH_TEST(test_wave) {
  const struct known known = {wave, wave_integral};
  for (double n = 1; n < 1000; n *= 3) {
    ck_known(known, n, 4e-15);
  }
}

/* Where f is not smooth it is halved until that does not matter. */
PH_TEST(test_kinks) {
  const struct known kinked = {kink, kink_integral};
  const struct known stepped = {step, step_integral};
  /* also where no node is beyond, of a panel or of its half */
  const double places[] = {0,   1e-9,   3e-4, 0.3,    0.4995, 0.4999,
                           0.5, 0.5004, 0.9,  0.9995, 1};
  for (size_t i = 0; i < COUNT(places); i++) {
    ck_known(kinked, places[i], 4e-15);
  }
  /* the value next to it is not known */
  ck_assert_int_eq(ph_primitive_make(&table, stepped.f, &places[2], NULL, 0,
                                     1e-14, &unit_arena),
                   PH_OK);
  for (double u = 0; u <= 1; u += 0.01) {
    ck_abs(ph_primitive_at(&table, u, NULL), step_integral(&places[2], u),
           1e-14);
  }
}

/* With breaks it is smooth. */
PH_TEST(test_breaks) {
  const double at = 0.3, breaks[] = {at}, twice[] = {at, at, 0.7};
  double value;
  ck_assert_int_eq(
      ph_primitive_make(&table, kink, &at, breaks, 1, 1e-15, &unit_arena),
      PH_OK);
  ck_assert_uint_eq(table.n, 2);
  for (double u = 0; u <= 1; u += 0.01) {
    ck_abs(ph_primitive_at(&table, u, &value), kink_integral(&at, u), 2e-16);
    ck_abs(value, kink(&at, u), 2e-15);
  }
  ck_assert_int_eq(
      ph_primitive_make(&table, step, &at, twice, 3, 1e-15, &unit_arena),
      PH_OK);
  ck_assert_uint_eq(table.n, 3);
  ck_rel(table.total, 2.7, 1e-15);
  ck_rel(ph_primitive_at(&table, 0.5, NULL), 1.2, 1e-15);
}

/* The memory of one table is used for the next one. */
PH_TEST(test_reuse) {
  const double narrow = 1e-6, wide = 0.5;
  const struct ph_primitive_panel *panels;
  size_t room;
  ck_assert_int_eq(
      ph_primitive_make(&table, peak, &narrow, NULL, 0, 1e-13, &unit_arena),
      PH_OK);
  panels = table.panels;
  room = table.room;
  ck_assert_uint_le(table.n, room);
  for (int i = 0; i < 100; i++) {
    ck_assert_int_eq(ph_primitive_make(&table, i % 2 ? peak : dip, &wide, NULL,
                                       0, 1e-13, &unit_arena),
                     PH_OK);
  }
  ck_assert_ptr_eq(table.panels, panels);
  ck_assert_uint_eq(table.room, room);
}

PH_TEST(test_zero) {
  double value;
  ck_assert_int_eq(
      ph_primitive_make(&table, zero, NULL, NULL, 0, 1e-14, &unit_arena),
      PH_OK);
  ck_assert_uint_eq(table.n, 1);
  ck_abs(ph_primitive_at(&table, 0.5, &value), 0, 0);
  ck_abs(value, 0, 0);
}

/* What is infinite somewhere is refused, or what takes too many panels. */
PH_TEST(test_refusals) {
  const double places[] = {0.5, 1.0 / 3}, fast = 1e6, nan = (double)NAN;
  for (size_t i = 0; i < COUNT(places); i++) {
    ck_assert_int_eq(ph_primitive_make(&table, pole, &places[i], NULL, 0, 1e-14,
                                       &unit_arena),
                     PH_E_NO_CONVERGENCE);
  }
  ck_assert_int_eq(
      ph_primitive_make(&table, wave, &fast, NULL, 0, 1e-14, &unit_arena),
      PH_E_NO_CONVERGENCE);
  ck_assert_int_eq(
      ph_primitive_make(&table, wave, &nan, NULL, 0, 1e-14, &unit_arena),
      PH_E_NO_CONVERGENCE);
}

PH_FIXTURE(begin, NULL)
