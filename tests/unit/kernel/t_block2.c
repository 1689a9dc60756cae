/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The cyclic block tridiagonal solver against GSL's dense LU decomposition. */
#include "unit.h"

#include "kernel/block2.h"

#include <gsl/gsl_linalg.h>

enum { N_MAX = 40 };

/* What the blocks of a random system are like. */
enum kind {
  FULL,     /* no more than random */
  ZEROS,    /* with many zero entries */
  SINGULAR, /* diagonal blocks of rank 1, or 0 */
  SMALL,    /* small diagonal blocks */
  DOMINANT, /* large diagonal blocks */
  UNSCALED, /* dominant ones, scalar rows and unknowns of any size */
  ANTI,     /* large ones, but off their diagonal */
  KINDS
};

static double entry(struct unit_random *r, double zeros) {
  double x = unit_random_in(r, -1, 1);
  return unit_random_in(r, 0, 1) < zeros ? 0 : x;
}

/* Multiplies row i of a block row. */
static void scale_row(struct ph_block2_row *row, int i, double s) {
  for (int j = 2 * i; j < 2 * i + 2; j++) {
    row->lo[j] *= s;
    row->di[j] *= s;
    row->up[j] *= s;
  }
  row->f[i] *= s;
}

static void make_diagonal(struct unit_random *r, enum kind kind, double di[4]) {
  for (int j = 0; j < 4; j++) {
    const bool on = j == 0 || j == 3;
    di[j] *= kind == SMALL ? 1e-10 : 1;
    di[j] += (kind == DOMINANT || kind == UNSCALED) && on ? 8 : 0;
    di[j] += kind == ANTI && !on ? 8 : 0;
  }
  if (kind == SINGULAR) {
    double s = unit_random_below(r, 2) == 0 ? 0 : 0.5;
    di[0] *= 2 * s;
    di[1] *= 2 * s;
    di[2] = di[0] * s;
    di[3] = di[1] * s;
  }
}

static void make(struct unit_random *r, enum kind kind, bool cyclic, size_t n,
                 struct ph_block2_row *row) {
  const double zeros = kind == ZEROS ? 0.2 : 0;
  for (size_t i = 0; i < n; i++) {
    for (int j = 0; j < 4; j++) {
      row[i].lo[j] = entry(r, zeros);
      row[i].di[j] = entry(r, zeros);
      row[i].up[j] = entry(r, zeros);
    }
    make_diagonal(r, kind, row[i].di);
    row[i].f[0] = unit_random_in(r, -1, 1);
    row[i].f[1] = unit_random_in(r, -1, 1);
    if (kind == UNSCALED) {
      scale_row(&row[i], 0, exp2(unit_random_in(r, -20, 20)));
      scale_row(&row[i], 1, exp2(unit_random_in(r, -20, 20)));
    }
  }
  if (!cyclic) {
    for (int j = 0; j < 4; j++) {
      row[0].lo[j] = row[n - 1].up[j] = 0;
    }
  }
}

static bool is_finite(const double (*x)[2], size_t n) {
  bool finite = true;
  for (size_t i = 0; i < n; i++) {
    finite = finite && isfinite(x[i][0]) && isfinite(x[i][1]);
  }
  return finite;
}

static void push_all(struct ph_block2 *t, const struct ph_block2_row *row,
                     size_t n, double (*x)[2]) {
  ph_block2_begin(t, n, &row[0], &row[n - 1]);
  for (size_t i = 1; i + 1 < n; i++) {
    ph_block2_push(t, &row[i]);
  }
  ph_block2_finish(t, x);
}

static void solve(const struct ph_block2_row *row, size_t n, double (*x)[2]) {
  struct ph_block2 t;
  ck_assert(ph_block2_alloc(&t, &unit_arena, n));
  push_all(&t, row, n, x);
}

/* Largest |A x - f| of a scalar row in units of the sum of its entries' sizes
 * times the largest unknown. */
static double backward_error(const struct ph_block2_row *row, size_t n,
                             const double (*x)[2]) {
  double worst = 0, most = 0;
  for (size_t i = 0; i < 2 * n; i++) {
    most = unit_larger(most, fabs(x[i / 2][i % 2]));
  }
  for (size_t i = 0; i < 2 * n; i++) {
    const struct ph_block2_row *of = &row[i / 2];
    const double *a[3] = {of->lo, of->di, of->up};
    double sum = of->f[i % 2], size = 0;
    for (size_t j = 0; j < 6; j++) {
      double entry = a[j / 2][2 * (i % 2) + j % 2];
      sum -= entry * x[(i / 2 + n - 1 + j / 2) % n][j % 2];
      size += fabs(entry);
    }
    worst = unit_larger(worst, fabs(sum) / (size * most + fabs(of->f[i % 2])));
  }
  return worst;
}

static double largest(const gsl_matrix *a) {
  double min, max;
  gsl_matrix_minmax(a, &min, &max);
  return fmax(-min, max);
}

/* The dense solution x, with rows scaled to one size, and how much it may
 * change, relatively, when the entries of the matrix change by eps: 0 for a
 * singular matrix. */
static double solve_dense(const struct ph_block2_row *row, size_t n,
                          double (*x)[2]) {
  gsl_matrix *a = gsl_matrix_calloc(2 * n, 2 * n);
  gsl_matrix *inverse = gsl_matrix_alloc(2 * n, 2 * n);
  gsl_vector *f = gsl_vector_alloc(2 * n);
  gsl_permutation *p = gsl_permutation_alloc(2 * n);
  double condition;
  int sign;
  ck_assert(a && inverse && f && p);
  for (size_t i = 0; i < 2 * n; i++) {
    const struct ph_block2_row *from = &row[i / 2];
    const double *blocks[3] = {from->lo, from->di, from->up};
    double size = ph_block2_size(from, (int)(i % 2));
    size = size > 0 ? size : 1;
    for (size_t j = 0; j < 6; j++) {
      size_t column = 2 * ((i / 2 + n - 1 + j / 2) % n) + j % 2;
      *gsl_matrix_ptr(a, i, column) +=
          blocks[j / 2][2 * (i % 2) + j % 2] / size;
    }
    gsl_vector_set(f, i, from->f[i % 2] / size);
  }
  condition = 2 * (double)n * largest(a);
  ck_assert_int_eq(gsl_linalg_LU_decomp(a, p, &sign), 0);
  if (gsl_linalg_LU_invert(a, p, inverse) != 0) {
    condition = 0;
  } else {
    condition *= 2 * (double)n * largest(inverse);
    gsl_linalg_LU_svx(a, p, f);
    for (size_t i = 0; i < 2 * n; i++) {
      x[i / 2][i % 2] = gsl_vector_get(f, i);
    }
  }
  gsl_matrix_free(a);
  gsl_matrix_free(inverse);
  gsl_vector_free(f);
  gsl_permutation_free(p);
  return condition * DBL_EPSILON;
}

/* Compares both solutions of one system; false if it was too near to singular
 * for a comparison.  The residual is small in any case. */
static bool compare(const struct ph_block2_row *row, size_t n, unsigned which) {
  double x[N_MAX][2], dense[N_MAX][2], size = 0;
  double sensitivity = solve_dense(row, n, dense), error = 0;
  if (!(sensitivity > 0)) {
    return false;
  }
  solve(row, n, x);
  for (size_t i = 0; i < n; i++) {
    double d = hypot(x[i][0] - dense[i][0], x[i][1] - dense[i][1]);
    error = unit_larger(error, d);
    size = fmax(size, hypot(dense[i][0], dense[i][1]));
  }
  ck_assert_msg(error <= 16 * sensitivity * size || sensitivity > 1e-6,
                "seed %lu, system %u of %zu blocks: error %.3g of %.3g, "
                "sensitivity %.3g",
                unit_seed(), which, n, error, size, sensitivity);
  error = backward_error(row, n, x);
  ck_assert_msg(error <= 1e-14 || sensitivity > 1,
                "seed %lu, system %u of %zu blocks: %.3g", unit_seed(), which,
                n, error);
  return sensitivity < 1e-6;
}

/* Every kind of open and of cyclic systems. */
PH_TEST_EACH(test_dense, 2 * KINDS) {
  const enum kind kind = (enum kind)(_i / 2);
  struct unit_random r = unit_random_of((uint64_t)_i);
  struct ph_block2_row row[N_MAX];
  unsigned compared = 0, tried = 0;
  for (size_t n = 1; n <= N_MAX; n += unit_count(10) < 10 ? 3 : 1) {
    const int count = unit_count(20);
    for (int i = 0; i < count; i++) {
      make(&r, kind, _i % 2 == 1, n, row);
      compared += compare(row, n, tried++);
      ph_arena_reset(&unit_arena);
    }
  }
  /* Without diagonal blocks every open system of odd size is singular. */
  ck_assert_uint_ge(compared, tried / 3);
}

/* The last row goes along for as long as its corner block matters; how large
 * its entries are beside those of the others has no influence. */
PH_TEST(test_last_row_scale) {
  const double scales[] = {0x1p-50, 0x1p-25, 0x1p25, 0x1p50};
  struct unit_random r = unit_random_of(100);
  struct ph_block2_row row[N_MAX];
  double x[N_MAX][2], y[N_MAX][2];
  for (int i = 0; i < 400; i++) {
    size_t n = 2 + unit_random_below(&r, N_MAX - 1);
    make(&r, DOMINANT, true, n, row);
    solve(row, n, x);
    scale_row(&row[n - 1], i / 4 % 2, scales[i % 4]);
    solve(row, n, y);
    for (size_t k = 0; k < n; k++) {
      double d = hypot(x[k][0] - y[k][0], x[k][1] - y[k][1]);
      ck_assert_msg(d <= 1e-13,
                    "seed %lu, system %d of %zu blocks: x[%zu] moves by %.3g",
                    unit_seed(), i, n, k, d);
    }
    ph_arena_reset(&unit_arena);
  }
}

/* Long enough for the corner blocks to decay, and for them not to. */
PH_TEST_EACH(test_long, 2 * KINDS) {
  enum { N = 20000 };
  struct unit_random r = unit_random_of(200 + (uint64_t)_i);
  struct ph_block2_row *row = malloc(N * sizeof *row);
  double(*x)[2] = malloc(N * sizeof *x);
  double error;
  ck_assert(row && x);
  make(&r, (enum kind)(_i / 2), _i % 2 == 1, N, row);
  solve(row, N, x);
  if (_i / 2 == ZEROS) { /* one of so many rows or columns is empty */
    ck_assert(!is_finite((const double(*)[2])x, N));
  } else {
    error = backward_error(row, N, (const double(*)[2])x);
    ck_assert_msg(error <= 1e-14, "seed %lu: %.3g", unit_seed(), error);
  }
  free(row);
  free(x);
}

/* What is dropped of the corner blocks of a long dominant system is gone for
 * good: later rows are as fast as those of an open one. */
PH_TEST(test_decay) {
  struct unit_random r = unit_random_of(300);
  struct ph_block2_row row[200];
  double x[200][2];
  struct ph_block2 t;
  ck_assert(ph_block2_alloc(&t, &unit_arena, 200));
  make(&r, DOMINANT, true, 200, row);
  push_all(&t, row, 200, x);
  ck_assert(!t.near_far && !t.last_far);
  ck_assert_uint_lt(t.far_n, 100);
  ck_assert_uint_eq(t.fill_n, 0);
}

/* The workspace is used again, for fewer unknowns and another kind. */
PH_TEST(test_reuse) {
  struct unit_random r = unit_random_of(400);
  struct ph_block2_row row[N_MAX];
  double x[N_MAX][2], again[N_MAX][2];
  struct ph_block2 t;
  ck_assert(ph_block2_alloc(&t, &unit_arena, N_MAX));
  for (size_t n = N_MAX; n >= 1; n--) {
    make(&r, n % 3 == 0 ? FULL : DOMINANT, n % 2 == 0, n, row);
    push_all(&t, row, n, x);
    ck_assert_double_le(backward_error(row, n, (const double(*)[2])x), 1e-14);
    ph_block2_finish(&t, again);
    ck_assert_mem_eq(x, again, n * sizeof *x);
  }
}

/* A singular matrix gives something that is not finite, and so does NaN. */
PH_TEST(test_not_finite) {
  const double bad[] = {0, (double)NAN, (double)INFINITY};
  struct unit_random r = unit_random_of(500);
  struct ph_block2_row row[N_MAX];
  double x[N_MAX][2];
  for (size_t n = 1; n <= 12; n++) {
    for (size_t i = 0; i < 6 * n; i++) {
      make(&r, i % 4 < 2 ? FULL : DOMINANT, i % 2 == 0, n, row);
      scale_row(&row[i / 6], i / 3 % 2, bad[i % 3]);
      solve(row, n, x);
      ck_assert_msg(!is_finite((const double(*)[2])x, n),
                    "row %zu of %zu times %g", i / 6, n, bad[i % 3]);
      ph_arena_reset(&unit_arena);
    }
  }
}

/* An empty column is found wherever it is. */
PH_TEST(test_empty_column) {
  struct unit_random r = unit_random_of(600);
  struct ph_block2_row row[N_MAX];
  double x[N_MAX][2];
  for (size_t n = 1; n <= 12; n++) {
    for (size_t i = 0; i < n; i++) {
      make(&r, FULL, true, n, row);
      for (int s = 0; s < 3; s += 2) {
        row[i].di[s] = row[(i + 1) % n].lo[s] = 0;
        row[(i + n - 1) % n].up[s] = 0;
      }
      solve(row, n, x);
      ck_assert_msg(!is_finite((const double(*)[2])x, n), "%zu of %zu", i, n);
      ph_arena_reset(&unit_arena);
    }
  }
}

PH_TEST(test_no_memory) {
  struct ph_block2 t;
  ck_assert(!ph_block2_alloc(&t, &unit_arena, SIZE_MAX / 2));
}
