/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Small linear programs: against all vertices, and by their multipliers. */
#include "unit.h"

#include "kernel/lp.h"

enum { N_MAX = 16, M_MAX = 400 };

/* A program in its own memory. */
struct program {
  size_t n, m;
  double c[N_MAX], lower[N_MAX], upper[N_MAX];
  double a[M_MAX * N_MAX], b[M_MAX];
};

static struct ph_lp view(const struct program *p) {
  return (struct ph_lp){p->n, p->m, p->c, p->lower, p->upper, p->a, p->b};
}

static double dot(const double *a, const double *b, size_t n) {
  double sum = 0;
  for (size_t j = 0; j < n; j++) {
    sum += a[j] * b[j];
  }
  return sum;
}

static struct ph_lp_work work_of(size_t n, size_t m) {
  struct ph_lp_work w;
  ck_assert(ph_lp_alloc(&w, &unit_arena, n, m));
  return w;
}

/* ---- random programs ----------------------------------------------------- */

static void random_box(struct unit_random *r, struct program *p) {
  for (size_t j = 0; j < p->n; j++) {
    p->c[j] = unit_random_in(r, -1, 1);
    p->lower[j] = unit_random_in(r, -2, 0);
    p->upper[j] = unit_random_in(r, 0, 2);
  }
}

/* A row of norm 1 that x satisfies with this much to spare. */
static void random_row(struct unit_random *r, struct program *p, size_t i,
                       const double *x, double spare) {
  double *a = p->a + i * p->n, norm;
  do {
    for (size_t j = 0; j < p->n; j++) {
      a[j] = unit_random_in(r, -1, 1);
    }
    norm = sqrt(dot(a, a, p->n));
  } while (!(norm > 0.1));
  for (size_t j = 0; j < p->n; j++) {
    a[j] /= norm;
  }
  p->b[i] = dot(a, x, p->n) - spare;
}

/* A program that a point satisfies; rows to spare at most so much. */
static void random_feasible(struct unit_random *r, size_t n, size_t m,
                            double spare, struct program *p) {
  double x[N_MAX];
  p->n = n;
  p->m = m;
  random_box(r, p);
  for (size_t j = 0; j < n; j++) {
    x[j] = unit_random_in(r, p->lower[j], p->upper[j]);
  }
  for (size_t i = 0; i < m; i++) {
    random_row(r, p, i, x, unit_random_in(r, 0, spare));
  }
}

/* Numbers so small and so few that rows are parallel, repeated, empty and meet
 * in one point, and that c is parallel to some. */
static void random_degenerate(struct unit_random *r, size_t n, size_t m,
                              struct program *p) {
  p->n = n;
  p->m = m;
  for (size_t j = 0; j < n; j++) {
    p->c[j] = (double)unit_random_below(r, 3) - 1;
    p->lower[j] = -(double)unit_random_below(r, 2);
    p->upper[j] = (double)unit_random_below(r, 2);
  }
  for (size_t i = 0; i < m; i++) {
    for (size_t j = 0; j < n; j++) {
      p->a[i * n + j] = (double)unit_random_below(r, 3) - 1;
    }
    p->b[i] = -(double)unit_random_below(r, 8) / 4;
    p->b[i] += unit_random_below(r, 4) == 0 ? 0.5 : 0;
  }
}

/* ---- all vertices -------------------------------------------------------- */

/* Constraint k as g . x >= h: bounds first. */
static double normal(const struct program *p, size_t k, double *g) {
  const size_t n = p->n;
  if (k >= 2 * n) {
    memcpy(g, p->a + (k - 2 * n) * n, n * sizeof *g);
    return p->b[k - 2 * n];
  }
  for (size_t j = 0; j < n; j++) {
    g[j] = j != k / 2 ? 0 : k % 2 == 0 ? 1 : -1;
  }
  return k % 2 == 0 ? p->lower[k / 2] : -p->upper[k / 2];
}

/* How much x violates the program at most. */
static double violation(const struct program *p, const double *x) {
  double worst = 0, g[N_MAX];
  for (size_t k = 0; k < 2 * p->n + p->m; k++) {
    double h = normal(p, k, g);
    worst = unit_larger(worst, h - dot(g, x, p->n));
  }
  return worst;
}

/* The point in which three constraints are equalities, by Cramer's rule. */
static bool meet(const struct program *p, const size_t k[3], double x[3]) {
  double g[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, h[3] = {0, 0, 0}, det = 0;
  for (size_t i = 0; i < p->n; i++) {
    g[i][1] = g[i][2] = 0;
    h[i] = normal(p, k[i], g[i]);
  }
  for (int i = 0; i < 3; i++) {
    const double *u = g[(i + 1) % 3], *v = g[(i + 2) % 3];
    const double cross[3] = {u[1] * v[2] - u[2] * v[1],
                             u[2] * v[0] - u[0] * v[2],
                             u[0] * v[1] - u[1] * v[0]};
    det = dot(g[i], cross, 3);
    for (int j = 0; j < 3; j++) {
      x[j] = (i == 0 ? 0 : x[j]) + h[i] * cross[j];
    }
  }
  for (int j = 0; j < 3; j++) {
    x[j] /= det;
  }
  return fabs(det) > 1e-6;
}

/* The least c . x of all vertices that satisfy the program; infinite if none
 * does. */
static double least_vertex(const struct program *p, double tolerance) {
  const size_t count = 2 * p->n + p->m;
  double least = (double)INFINITY, x[3];
  size_t k[3];
  for (k[0] = 0; k[0] < count; k[0]++) {
    for (k[1] = 0; k[1] < (p->n > 1 ? k[0] : 1); k[1]++) {
      for (k[2] = 0; k[2] < (p->n > 2 ? k[1] : 1); k[2]++) {
        if (meet(p, k, x) && violation(p, x) <= tolerance) {
          least = fmin(least, dot(p->c, x, p->n));
        }
      }
    }
  }
  return least;
}

/* ---- multipliers --------------------------------------------------------- */

/* x satisfies the program; with the multipliers that the workspace has, c is a
 * sum of normals of constraints that are equalities at x. */
static void check_optimal(const struct program *p, const struct ph_lp_work *w,
                          const double *x) {
  double rest[N_MAX];
  size_t free = 0;
  memcpy(rest, p->c, p->n * sizeof *rest);
  ck_assert_double_le(violation(p, x), 1e-10);
  for (size_t i = 0; i < w->q; i++) {
    const double *a = p->a + w->row[i] * p->n;
    ck_assert_uint_lt(w->row[i], p->m);
    ck_assert_double_ge(w->price[i], -1e-10);
    ck_abs(dot(a, x, p->n), p->b[w->row[i]], 1e-10);
    for (size_t j = 0; j < p->n; j++) {
      rest[j] -= w->price[i] * a[j];
    }
  }
  for (size_t j = 0; j < p->n; j++) {
    const double price = w->price[w->q + j];
    ck_assert_double_ge(x[j], p->lower[j]);
    ck_assert_double_le(x[j], p->upper[j]);
    free += w->at[j] == PH_LP_FREE;
    ck_assert(w->at[j] != PH_LP_FREE || p->lower[j] < p->upper[j]);
    if (w->at[j] != PH_LP_FREE) {
      ck_abs(x[j], w->at[j] == PH_LP_LOWER ? p->lower[j] : p->upper[j], 0);
      rest[j] -= w->at[j] == PH_LP_LOWER ? price : -price;
    }
    ck_assert(price >= -1e-10 || !(p->lower[j] < p->upper[j]));
    ck_abs(rest[j], 0, 1e-10);
  }
  ck_assert_uint_eq(free, w->q);
}

/* ---- tests --------------------------------------------------------------- */

/* Whether the program has a solution. */
static bool compare(const struct program *p, unsigned which) {
  struct ph_lp_work w = work_of(p->n, p->m);
  struct ph_lp lp = view(p);
  double x[3], least = least_vertex(p, 1e-10);
  enum ph_lp_outcome outcome = ph_lp_solve(&lp, &w, x);
  ck_assert_msg(isfinite(least) ? outcome == PH_LP_OPTIMAL
                                : outcome == PH_LP_INFEASIBLE,
                "seed %lu, program %u, n %zu, m %zu: outcome %d, least %g",
                unit_seed(), which, p->n, p->m, (int)outcome, least);
  if (outcome == PH_LP_OPTIMAL) {
    check_optimal(p, &w, x);
    ck_assert_msg(unit_near(dot(p->c, x, p->n), least, 1e-9),
                  "seed %lu, program %u, n %zu, m %zu: %.17g, least %.17g",
                  unit_seed(), which, p->n, p->m, dot(p->c, x, p->n), least);
  } else {
    ck_assert_double_gt(violation(p, x), 0);
  }
  ph_arena_reset(&unit_arena);
  return outcome == PH_LP_OPTIMAL;
}

PH_TEST(test_vertices) {
  const int count = unit_count(600);
  struct unit_random r = unit_random_of(1);
  struct program p;
  int solved = 0;
  for (int i = 0; i < count; i++) {
    const size_t n = 1 + unit_random_below(&r, 3);
    random_feasible(&r, n, unit_random_below(&r, 9), 0.5, &p);
    for (size_t k = 0; k < p.m; k++) {
      p.b[k] += unit_random_in(&r, 0, 0.5);
    }
    solved += compare(&p, (unsigned)i);
  }
  ck_assert_int_gt(solved, count / 5);
  ck_assert_int_lt(solved, count - count / 10);
}

PH_TEST(test_degenerate_vertices) {
  const int count = unit_count(1500);
  struct unit_random r = unit_random_of(2);
  struct program p;
  int solved = 0;
  for (int i = 0; i < count; i++) {
    const size_t n = 1 + unit_random_below(&r, 3);
    random_degenerate(&r, n, unit_random_below(&r, 12), &p);
    solved += compare(&p, (unsigned)i);
  }
  ck_assert_int_gt(solved, count / 5);
  ck_assert_int_lt(solved, count - count / 10);
}

/* Rows to spare, and all rows through one point. */
PH_TEST(test_random) {
  const double spares[] = {1, 0.01, 0};
  const int count = unit_count(400);
  struct unit_random r = unit_random_of(3);
  static struct program p;
  double x[N_MAX];
  for (int i = 0; i < count; i++) {
    const size_t n = 1 + unit_random_below(&r, N_MAX);
    struct ph_lp_work w = work_of(N_MAX, M_MAX);
    struct ph_lp lp;
    enum ph_lp_outcome outcome;
    random_feasible(&r, n, unit_random_below(&r, M_MAX), spares[i % 3], &p);
    lp = view(&p);
    outcome = ph_lp_solve(&lp, &w, x);
    ck_assert_msg(outcome == PH_LP_OPTIMAL,
                  "seed %lu, program %d, n %zu, m %zu: outcome %d", unit_seed(),
                  i, p.n, p.m, (int)outcome);
    check_optimal(&p, &w, x);
    ph_arena_reset(&unit_arena);
  }
}

/* Either a solution with its multipliers, or a proof that there is none. */
PH_TEST(test_degenerate) {
  const int count = unit_count(600);
  struct unit_random r = unit_random_of(4);
  static struct program p;
  double x[N_MAX];
  int solved = 0;
  for (int i = 0; i < count; i++) {
    const size_t n = 4 + unit_random_below(&r, N_MAX - 3);
    struct ph_lp_work w = work_of(N_MAX, M_MAX);
    struct ph_lp lp;
    enum ph_lp_outcome outcome;
    random_degenerate(&r, n, unit_random_below(&r, i % 2 ? 400 : 20), &p);
    for (size_t k = 0; k < p.m && i % 2 == 1; k++) {
      p.b[k] = fmin(p.b[k], 0); /* x = 0 is a solution */
    }
    lp = view(&p);
    outcome = ph_lp_solve(&lp, &w, x);
    ck_assert_msg(outcome != PH_LP_STALLED && (i % 2 == 0 || outcome == 0),
                  "seed %lu, program %d, n %zu, m %zu: outcome %d, %zu steps",
                  unit_seed(), i, p.n, p.m, (int)outcome, w.steps);
    if (outcome == PH_LP_OPTIMAL) {
      check_optimal(&p, &w, x);
      solved++;
    }
    ph_arena_reset(&unit_arena);
  }
  ck_assert_int_lt(solved, count);
}

/* A row contradicts a sum of others, by little. */
PH_TEST(test_infeasible) {
  const int count = unit_count(200);
  struct unit_random r = unit_random_of(5);
  static struct program p;
  double x[N_MAX];
  for (int i = 0; i < count; i++) {
    const size_t n = 1 + unit_random_below(&r, N_MAX);
    const size_t m = 2 + unit_random_below(&r, 60);
    const size_t last = m - 1, from = unit_random_below(&r, last);
    struct ph_lp_work w = work_of(N_MAX, M_MAX);
    struct ph_lp lp;
    random_feasible(&r, n, m, 1, &p);
    for (size_t j = 0; j < n; j++) {
      p.a[last * n + j] = 0;
    }
    p.b[last] = 1e-8;
    for (size_t k = from; k < last; k++) {
      const double times = unit_random_in(&r, 0, 1) / (double)m;
      for (size_t j = 0; j < n; j++) {
        p.a[last * n + j] -= times * p.a[k * n + j];
      }
      p.b[last] -= times * p.b[k];
    }
    lp = view(&p);
    ck_assert_msg(ph_lp_solve(&lp, &w, x) == PH_LP_INFEASIBLE,
                  "seed %lu, program %d, n %zu, m %zu", unit_seed(), i, n, m);
    ck_assert_double_gt(violation(&p, x), 0);
    if (w.violated < m) {
      ck_assert_double_lt(dot(p.a + w.violated * n, x, n), p.b[w.violated]);
    }
    ph_arena_reset(&unit_arena);
  }
}

/* One unknown, in words. */
PH_TEST(test_one) {
  struct program p = {1, 2, {1}, {-1}, {3}, {1, -1}, {0.5, -2}};
  struct ph_lp_work w = work_of(1, 2);
  struct ph_lp lp = view(&p);
  double x;
  ck_assert_int_eq(ph_lp_solve(&lp, &w, &x), PH_LP_OPTIMAL);
  ck_abs(x, 0.5, 0);
  p.c[0] = -1;
  ck_assert_int_eq(ph_lp_solve(&lp, &w, &x), PH_LP_OPTIMAL);
  ck_abs(x, 2, 0);
  p.b[0] = 2;
  ck_assert_int_eq(ph_lp_solve(&lp, &w, &x), PH_LP_OPTIMAL);
  ck_abs(x, 2, 0);
  p.b[0] = 2.5;
  ck_assert_int_eq(ph_lp_solve(&lp, &w, &x), PH_LP_INFEASIBLE);
  lp.m = 0;
  ck_assert_int_eq(ph_lp_solve(&lp, &w, &x), PH_LP_OPTIMAL);
  ck_abs(x, 3, 0);
}

/* Empty rows: satisfied or not. */
PH_TEST(test_empty_row) {
  struct program p = {2, 1, {1, 1}, {0, 0}, {1, 1}, {0, 0}, {0}};
  struct ph_lp_work w = work_of(2, 1);
  struct ph_lp lp = view(&p);
  double x[2];
  ck_assert_int_eq(ph_lp_solve(&lp, &w, x), PH_LP_OPTIMAL);
  p.b[0] = 1e-9;
  ck_assert_int_eq(ph_lp_solve(&lp, &w, x), PH_LP_INFEASIBLE);
  ck_assert_uint_eq(w.violated, 0);
  p.b[0] = -1;
  ck_assert_int_eq(ph_lp_solve(&lp, &w, x), PH_LP_OPTIMAL);
}

/*
 * The dual of the program of Klee and Minty (1972), for which the most violated
 * row is the worst choice: 2^n - 1 steps.  From 8 unknowns on, the rule of
 * Bland ends that.
 */
PH_TEST(test_many_steps) {
  const size_t sizes[] = {4, 8, 16}, least[] = {15, 181, 261};
  static struct program p;
  double x[N_MAX];
  for (size_t s = 0; s < 3; s++) {
    const size_t n = p.n = p.m = sizes[s];
    struct ph_lp_work w = work_of(n, n);
    struct ph_lp lp = view(&p);
    for (size_t i = 0; i < n; i++) {
      p.b[i] = ldexp(1, (int)(n - 1 - i));
      p.c[i] = pow(5, (double)i + 1);
      p.lower[i] = 0;
      p.upper[i] = 1e9;
      for (size_t j = 0; j < n; j++) {
        p.a[i * n + j] = j < i ? 0 : j == i ? 1 : ldexp(2, (int)(j - i));
      }
    }
    ck_assert_int_eq(ph_lp_solve(&lp, &w, x), PH_LP_OPTIMAL);
    ck_rel(dot(p.c, x, n), p.c[n - 1], 1e-12);
    ck_assert_uint_ge(w.steps, least[s]);
    ck_assert_uint_le(w.steps, 300);
  }
}

/* The scale of x and that of c are the caller's. */
PH_TEST(test_scale) {
  const double scales[] = {1e-100, 1e-9, 1e9, 1e100};
  struct unit_random r = unit_random_of(6);
  static struct program p;
  double x[N_MAX], y[N_MAX];
  for (int i = 0; i < 40; i++) {
    struct ph_lp_work w = work_of(8, 60);
    struct ph_lp lp;
    const double s = scales[i % 4], t = scales[i / 4 % 4];
    random_feasible(&r, 8, 60, 1, &p);
    lp = view(&p);
    ck_assert_int_eq(ph_lp_solve(&lp, &w, x), PH_LP_OPTIMAL);
    for (size_t j = 0; j < 8; j++) {
      p.lower[j] *= s;
      p.upper[j] *= s;
      p.c[j] *= t;
    }
    for (size_t k = 0; k < 60; k++) {
      p.b[k] *= s;
    }
    ck_assert_int_eq(ph_lp_solve(&lp, &w, y), PH_LP_OPTIMAL);
    for (size_t j = 0; j < 8; j++) {
      ck_abs(y[j] / s, x[j], 1e-10);
    }
    ph_arena_reset(&unit_arena);
  }
}

/* What is not a number is not called a solution. */
PH_TEST(test_not_finite) {
  for (size_t i = 0; i < 5; i++) {
    struct program p = {2, 1, {1, 1}, {0, 0}, {1, 1}, {0.6, 0.8}, {0.5}};
    double *place[] = {p.c, p.lower, p.upper, p.a, p.b};
    struct ph_lp_work w = work_of(2, 1);
    struct ph_lp lp = view(&p);
    double x[2];
    ck_assert_int_eq(ph_lp_solve(&lp, &w, x), PH_LP_OPTIMAL);
    *place[i] = (double)NAN;
    ck_assert_int_eq(ph_lp_solve(&lp, &w, x), PH_LP_STALLED);
  }
}

PH_TEST(test_no_memory) {
  struct ph_lp_work w;
  ck_assert(!ph_lp_alloc(&w, &unit_arena, SIZE_MAX / 2, 4));
}
