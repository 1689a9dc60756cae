/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Minimisation in a box: functions whose minima are known. */
#include "unit.h"

#include "kernel/box.h"

enum { N = 8 };

/* Rosenbrock's function, chained; refused where x[0] > limit. */
struct valley {
  double last[N], limit;
  size_t values, accepted, fail_at;
};

static enum ph_status value(void *context, const double *x, double *f) {
  struct valley *v = context;
  *f = x[0] > v->limit ? (double)NAN : 0;
  for (size_t i = 0; i + 1 < N; i++) {
    double d = x[i + 1] - x[i] * x[i];
    *f += 100 * d * d + (1 - x[i]) * (1 - x[i]);
  }
  for (size_t i = 0; i < N; i++) {
    v->last[i] = x[i];
  }
  return ++v->values == v->fail_at ? PH_E_NO_CONVERGENCE : PH_OK;
}

static void gradient(void *context, double *g) {
  const struct valley *v = context;
  const double *x = v->last;
  for (size_t i = 0; i < N; i++) {
    g[i] = 0;
  }
  for (size_t i = 0; i + 1 < N; i++) {
    double d = x[i + 1] - x[i] * x[i];
    g[i] -= 400 * d * x[i] + 2 * (1 - x[i]);
    g[i + 1] += 200 * d;
  }
}

static void accept(void *context) {
  ((struct valley *)context)->accepted++;
}

static struct valley valley;
static struct ph_box_report report;
static double x[N];

static enum ph_status run(double upper, size_t steps) {
  double low[N], high[N];
  struct ph_box box = {.n = N,
                       .lower = low,
                       .upper = high,
                       .decrease = 1e-14,
                       .steps_max = steps,
                       .context = &valley,
                       .value = value,
                       .gradient = gradient,
                       .accept = accept};
  enum ph_status status;
  for (size_t i = 0; i < N; i++) {
    low[i] = -3;
    high[i] = upper;
    x[i] = -1.2;
  }
  valley.values = valley.accepted = 0;
  status = ph_box_minimize(&box, &unit_arena, x, &report);
  return status;
}

PH_TEST(test_inside) {
  valley = (struct valley){.limit = 10};
  ck_assert_int_eq(run(3, 1000), PH_OK);
  ck_assert(report.converged);
  ck_assert_uint_eq(report.evaluations, valley.values);
  /* it has a second, local minimum near (-1, 1, ..., 1), of about 4 */
  ck_assert(report.value <= 1e-12 || fabs(report.value - 3.98) < 0.02);
  for (size_t i = 1; i < N; i++) {
    ck_abs(x[i], 1, 1e-2);
  }
}

/* At the bound the gradient pushes outwards, elsewhere it vanishes. */
PH_TEST(test_bounds) {
  double g[N], most = 0;
  valley = (struct valley){.limit = 10};
  ck_assert_int_eq(run(0.5, 1000), PH_OK);
  ck_assert(report.converged);
  for (size_t i = 0; i < N; i++) {
    valley.last[i] = x[i];
    ck_assert_double_le(x[i], 0.5);
  }
  gradient(&valley, g);
  for (size_t i = 0; i < N; i++) {
    most = x[i] < 0.5 ? fmax(most, fabs(g[i])) : most;
    ck_assert(x[i] < 0.5 || g[i] < 0);
  }
  ck_assert_double_le(most, 1e-5);
}

/* Points that are refused are avoided; where the start is one, it stays. */
PH_TEST(test_refused) {
  valley = (struct valley){.limit = 0.25};
  ck_assert_int_eq(run(3, 1000), PH_OK);
  ck_assert_double_le(x[0], 0.25);
  ck_assert(isfinite(report.value));
  valley = (struct valley){.limit = -2};
  ck_assert_int_eq(run(3, 1000), PH_OK);
  ck_assert(!isfinite(report.value) && !report.converged);
  ck_assert_uint_eq(valley.accepted, 0);
}

/* The cap of the steps, and failures of the function, end the search. */
PH_TEST(test_ends) {
  valley = (struct valley){.limit = 10};
  ck_assert_int_eq(run(3, 3), PH_OK);
  ck_assert(!report.converged);
  ck_assert_uint_le(valley.accepted, 4);
  valley.fail_at = 5;
  ck_assert_int_eq(run(3, 1000), PH_E_NO_CONVERGENCE);
  ck_assert_uint_eq(valley.values, 5);
}
