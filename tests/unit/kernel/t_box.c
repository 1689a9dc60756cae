/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Minimisation in a box: functions whose minima are known. */
#include "unit.h"

#include "kernel/box_hessian.h"

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
static size_t evaluations_max; /* evaluations; 0: no limit */

static enum ph_status run(double upper, size_t steps) {
  double low[N], high[N];
  struct ph_box box = {.n = N,
                       .lower = low,
                       .upper = high,
                       .decrease = 1e-14,
                       .steps_max = steps,
                       .evaluations_max = evaluations_max,
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

/* No step begins after so many evaluations; the last may take 30. */
PH_TEST(test_evaluations) {
  valley = (struct valley){.limit = 3};
  evaluations_max = 20;
  ck_assert_int_eq(run(3, 1000), PH_OK);
  evaluations_max = 0;
  ck_assert(!report.converged && isfinite(report.value));
  ck_assert_uint_ge(report.evaluations, 20);
  ck_assert_uint_lt(report.evaluations, 20 + 30);
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

/* ---- second derivatives by differences ------------------------------------
 */

/*
 * sum of r^(j-i) (x[i] - x[j])^2 / 2 over i < j, times sign: what is not near
 * the diagonal is small, and a change of all variables by the same amount is
 * none; own x^2 / 2 besides.
 */
enum { MANY = 30 };

struct proportions {
  double r, own, sign, limit, last[MANY];
  size_t values;
};

static enum ph_status proportions_value(void *context, const double *v,
                                        double *f) {
  struct proportions *p = context;
  p->values++;
  *f = v[0] > p->limit ? (double)NAN : 0;
  for (size_t i = 0; i < MANY; i++) {
    p->last[i] = v[i];
  }
  return PH_OK;
}

/* The second derivatives times v, which are the gradient at v. */
static void proportions_gradient(void *context, double *g) {
  const struct proportions *p = context;
  for (size_t i = 0; i < MANY; i++) {
    g[i] = p->own * p->last[i];
    for (size_t j = 0; j < MANY; j++) {
      double far = i > j ? (double)(i - j) : (double)(j - i);
      g[i] += i == j ? 0 : p->sign * pow(p->r, far) * (p->last[i] - p->last[j]);
    }
  }
}

static struct proportions shares;
static struct ph_box_hessian hessian;
static const bool NONE_FIXED[MANY];

static void find_hessian(struct proportions p, size_t k) {
  double low[MANY], high[MANY], at[MANY];
  struct ph_box box = {.n = MANY,
                       .lower = low,
                       .upper = high,
                       .context = &shares,
                       .value = proportions_value,
                       .gradient = proportions_gradient};
  shares = p;
  for (size_t i = 0; i < MANY; i++) {
    low[i] = -1;
    at[i] = high[i] = i % 3 == 0 ? 0.5 : 1;
  }
  ck_assert_int_eq(ph_box_hessian_alloc(&hessian, &unit_arena, MANY, k), PH_OK);
  ck_assert_int_eq(ph_box_hessian_find(&hessian, &box, at), PH_OK);
}

/* v <- the product with the inverse; w <- with the matrix again */
static void there_and_back(const bool *fixed, double *v, double *w) {
  ph_box_hessian_solve(&hessian, fixed, v);
  for (size_t i = 0; i < MANY; i++) {
    shares.last[i] = v[i];
  }
  proportions_gradient(&shares, w);
}

static const struct {
  double r, own;
  size_t k, most;
} NEAR_ENOUGH[] = {
    {0.5, 0.5, 29, 32}, /* the whole matrix */
    {1e-6, 0.5, 1, 5},
    {0.1, 0.5, 2, 7},
    {0.1, 1e-3, 2, 7}, /* nearly a function of proportions alone */
};

/* What is left out, r^(k+1) / (1 - r) on either side, acts on differences of v
 * that are at most twice its largest element; 1e-9 for the differences. */
static double left_out(const double *v, size_t k) {
  double most = 0;
  for (size_t i = 0; i < MANY; i++) {
    most = fmax(most, fabs(v[i]));
  }
  return 4 * most * pow(shares.r, (double)k + 1) / (1 - shares.r) + 1e-9;
}

PH_TEST_EACH(test_hessian, 4) {
  size_t k = NEAR_ENOUGH[_i].k;
  double v[MANY], w[MANY];
  bool fixed[MANY] = {false};
  find_hessian((struct proportions){.r = NEAR_ENOUGH[_i].r,
                                    .own = NEAR_ENOUGH[_i].own,
                                    .sign = 1,
                                    .limit = 2},
               k);
  ck_assert(hessian.found);
  ck_assert_uint_le(shares.values, NEAR_ENOUGH[_i].most);
  for (size_t i = 0; i < MANY; i++) {
    v[i] = sin(2.0 * (double)i);
  }
  there_and_back(NONE_FIXED, v, w);
  for (size_t i = 0; i < MANY; i++) {
    ck_abs(w[i], sin(2.0 * (double)i), left_out(v, k));
  }
  for (size_t i = 0; i < MANY; i++) {
    fixed[i] = i % 4 == 1;
    v[i] = sin(2.0 * (double)i);
  }
  there_and_back(fixed, v, w);
  for (size_t i = 0; i < MANY; i++) {
    ck_abs(fixed[i] ? v[i] : 0, 0, 0);
    ck_abs(fixed[i] ? 0 : w[i], fixed[i] ? 0 : sin(2.0 * (double)i),
           left_out(v, k));
  }
}

/* Where nothing but proportions count the step does not go along a change of
 * all variables, of which differences say nothing: what the matrix makes of a
 * sine comes from no more than that. */
PH_TEST_EACH(test_hessian_of_proportions, 6) {
  double v[MANY], most = 0;
  find_hessian((struct proportions){.r = 0.1 * (1 + _i), .sign = 1, .limit = 2},
               3);
  ck_assert(hessian.found);
  for (size_t i = 0; i < MANY; i++) {
    shares.last[i] = sin(2.0 * (double)i);
  }
  proportions_gradient(&shares, v);
  ph_box_hessian_solve(&hessian, NONE_FIXED, v);
  for (size_t i = 0; i < MANY; i++) {
    most = fmax(most, fabs(v[i]));
  }
  ck_assert_double_le(most, 2);
}

/* Where the function is not convex the step goes down nevertheless; where it
 * has no value beside x there is none. */
PH_TEST(test_hessian_refused) {
  double v[MANY], w[MANY], along = 0;
  find_hessian((struct proportions){.r = .3, .own = .1, .sign = -1, .limit = 2},
               3);
  ck_assert(hessian.found);
  for (size_t i = 0; i < MANY; i++) {
    v[i] = w[i] = sin(2.0 * (double)i);
  }
  ph_box_hessian_solve(&hessian, NONE_FIXED, v);
  for (size_t i = 0; i < MANY; i++) {
    along += v[i] * w[i];
  }
  ck_assert_double_gt(along, 0);
  find_hessian((struct proportions){.r = .3, .sign = 1, .limit = -2}, 3);
  ck_assert(!hessian.found);
}
