/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Band matrices against the dense matrices that they stand for: residuals of
 * solutions, and GSL's dense Cholesky factor.
 */
#include "unit.h"

#include "kernel/band.h"

#include <gsl/gsl_linalg.h>

enum { N_MAX = 40, K_MAX = N_MAX + 5 };

static struct dense {
  size_t n;
  double a[N_MAX][N_MAX];
} dense;

static double sym[N_MAX * (K_MAX + 1)];
static double band[N_MAX * (3 * K_MAX + 1)];
static uint32_t pivot[N_MAX];

static bool in_band(size_t i, size_t j, size_t k) {
  return i <= j + k && j <= i + k;
}

/* How the elements of a random matrix of half bandwidth k are chosen. */
struct family {
  double zeros;    /* part of them that vanish */
  double diagonal; /* is added to the diagonal */
  double corner;   /* ... and to the element furthest down in each column */
  size_t kkt;      /* rows of a stage, the last a constraint; 0: no stages */
};

static void make(struct unit_random *r, const struct family *f, size_t n,
                 size_t k) {
  dense.n = n;
  for (size_t i = 0; i < n; i++) {
    for (size_t j = 0; j < n; j++) {
      const double value = unit_random_in(r, -1, 1);
      const bool zero = unit_random_in(r, 0, 1) < f->zeros;
      dense.a[i][j] = in_band(i, j, k) && !zero ? value : 0;
      dense.a[i][j] += i == j ? f->diagonal : 0;
      dense.a[i][j] += i == j + k ? f->corner : 0;
    }
  }
  for (size_t i = 0; f->kkt > 0 && i < n; i++) {
    for (size_t j = 0; j <= i; j++) {
      const bool both = i % f->kkt == f->kkt - 1 && j % f->kkt == f->kkt - 1;
      dense.a[j][i] = dense.a[i][j] = both ? 0 : dense.a[i][j];
    }
  }
}

/* dense, of which the band is k, in `band'; NaN where the matrix is not. */
static void pack(size_t k) {
  const size_t n = dense.n;
  for (size_t i = 0; i < n; i++) {
    for (size_t c = 0; c <= 3 * k; c++) {
      const bool inside = i + c >= k && i + c - k < n;
      double value = inside && c <= 2 * k ? dense.a[i][i + c - k] : 0;
      band[i * (3 * k + 1) + c] = inside || c > 2 * k ? value : (double)NAN;
    }
  }
}

/* The lower triangle of dense, in `sym'. */
static void pack_sym(size_t k) {
  const size_t n = dense.n;
  for (size_t j = 0; j < n; j++) {
    for (size_t i = j; i <= j + k; i++) {
      *ph_sym_at(sym, k, i, j) = i < n ? dense.a[i][j] : 0;
    }
  }
}

/* Makes dense symmetric, from its lower triangle. */
static void reflect(void) {
  for (size_t i = 0; i < dense.n; i++) {
    for (size_t j = 0; j < i; j++) {
      dense.a[j][i] = dense.a[i][j];
    }
  }
}

/* The largest |A x - b|, as a part of the largest row sum of |A| by the largest
 * |x|. */
static double residual(const double *x, const double *b) {
  double worst = 0, norm = 0, size = 0;
  for (size_t i = 0; i < dense.n; i++) {
    double sum = -b[i], row = 0;
    for (size_t j = 0; j < dense.n; j++) {
      sum += dense.a[i][j] * x[j];
      row += fabs(dense.a[i][j]);
    }
    worst = unit_larger(worst, fabs(sum));
    norm = unit_larger(norm, row);
    size = unit_larger(size, fabs(x[i]));
  }
  return worst / (norm * size);
}

static void fill(struct unit_random *r, double *x, double *b) {
  for (size_t i = 0; i < dense.n; i++) {
    x[i] = b[i] = unit_random_in(r, -1, 1);
  }
}

/* A size and a half bandwidth: often 1, 0, and wider than the matrix. */
static void shape(struct unit_random *r, size_t *n, size_t *k) {
  *n = 1 + unit_random_below(r, unit_random_below(r, 2) ? 8 : N_MAX);
  *k = unit_random_below(r, *n + 6);
}

/* The first columns, then what is left, are the factor in sym; as rounded, of
 * an even number of columns. */
static void is_factored_in_parts(struct unit_random *r, size_t n, size_t k) {
  static double whole[N_MAX * (K_MAX + 1)];
  size_t first = unit_random_below(r, n + 1), size = ph_sym_size(n, k);
  bool even = first % 2 == 0;
  memcpy(whole, sym, ph_sym_size(n, k) * sizeof *sym);
  pack_sym(k);
  ck_assert(ph_sym_reduce(sym, n, k, first));
  ck_assert(ph_sym_factor(sym + ph_sym_size(first, k), n - first, k));
  for (size_t i = 0; i < size; i++) {
    ck_abs(sym[i], whole[i], even ? 0 : 1e-14 * (1 + (double)k));
  }
}

PH_TEST(cholesky) {
  const struct family family = {.zeros = 0.2};
  struct unit_random r = unit_random_of(1);
  for (int trial = 0; trial < unit_count(600); trial++) {
    double x[N_MAX], b[N_MAX];
    size_t n, k;
    gsl_matrix_view l;
    shape(&r, &n, &k);
    make(&r, &family, n, k);
    for (size_t i = 0; i < n; i++) {
      dense.a[i][i] = 1 + (double)(k < n ? k : n);
    }
    reflect();
    pack_sym(k);
    fill(&r, x, b);
    ck_assert(ph_sym_factor(sym, n, k));
    is_factored_in_parts(&r, n, k);
    ph_sym_solve(sym, n, k, x);
    ck_assert_double_le(residual(x, b), 20 * DBL_EPSILON);
    l = gsl_matrix_view_array_with_tda(&dense.a[0][0], n, n, N_MAX);
    ck_assert_int_eq(gsl_linalg_cholesky_decomp1(&l.matrix), 0);
    for (size_t j = 0; j < n; j++) {
      for (size_t i = j; i < n && i <= j + k; i++) {
        ck_abs(*ph_sym_at(sym, k, i, j), dense.a[i][j],
               20 * DBL_EPSILON * sqrt((double)k + 1));
      }
    }
  }
}

/* L L^T of small integers, which has no rounding: one diagonal element less is
 * the end of it. */
PH_TEST(indefinite) {
  for (size_t k = 0; k < 8; k++) {
    for (size_t at = 0; at < 12; at++) {
      for (int less = 0; less < 3; less++) {
        const size_t n = 12;
        dense.n = n;
        for (size_t i = 0; i < n; i++) {
          for (size_t j = 0; j <= i; j++) {
            dense.a[i][j] = 0;
            for (size_t m = 0; m <= j; m++) {
              dense.a[i][j] += in_band(i, m, k) && in_band(j, m, k) ? 1 : 0;
            }
          }
        }
        dense.a[at][at] -= less;
        pack_sym(k);
        ck_assert_int_eq(ph_sym_factor(sym, n, k), less == 0);
      }
    }
  }
}

static void check_lu(struct unit_random *r, size_t k, double tolerance) {
  double x[N_MAX], b[N_MAX];
  pack(k);
  fill(r, x, b);
  ck_assert(ph_band_factor(band, pivot, dense.n, k));
  for (size_t i = 0; i < dense.n; i++) {
    ck_assert_uint_ge(pivot[i], i);
    ck_assert_uint_le(pivot[i], i + k);
  }
  ph_band_solve(band, pivot, dense.n, k, x);
  ck_assert_double_le(residual(x, b), tolerance);
}

static const struct family families[] = {
    {.zeros = 0},                   /* any */
    {.zeros = 0.3, .diagonal = 1},  /* many zeros */
    {.zeros = 0.2, .diagonal = 50}, /* no exchanges */
    {.corner = 50},                 /* nothing but exchanges, by k rows */
};

PH_TEST_EACH(lu, COUNT(families)) {
  struct unit_random r = unit_random_of(2 + (uint64_t)_i);
  for (int trial = 0; trial < unit_count(600); trial++) {
    size_t n, k;
    shape(&r, &n, &k);
    make(&r, &families[_i], n, k);
    check_lu(&r, k, 100 * DBL_EPSILON);
  }
}

/* Stages of variables and a constraint on them: every such diagonal element is
 * 0, exactly, and the matrix is indefinite. */
PH_TEST(kkt) {
  struct unit_random r = unit_random_of(10);
  for (int trial = 0; trial < unit_count(300); trial++) {
    const size_t stage = 2 + unit_random_below(&r, 4);
    const size_t n = stage * (1 + unit_random_below(&r, N_MAX / stage));
    const size_t k = stage + unit_random_below(&r, stage);
    const struct family family = {.kkt = stage};
    make(&r, &family, n, k);
    check_lu(&r, k, 100 * DBL_EPSILON);
  }
}

/* The diagonal is 0, and every pivot is one row further down or up. */
PH_TEST(permutation) {
  struct unit_random r = unit_random_of(11);
  for (size_t k = 1; k < 8; k++) {
    const size_t n = 4 * k;
    dense.n = n;
    for (size_t i = 0; i < n; i++) {
      for (size_t j = 0; j < n; j++) {
        dense.a[i][j] = j == (i / k % 2 ? i - k : i + k) ? (double)(i + 1) : 0;
      }
    }
    check_lu(&r, k, 2 * DBL_EPSILON);
  }
}

/* Columns that are reduced a few at a time, as their rows come to be known,
 * have the factors of all at once. */
PH_TEST(lu_in_parts) {
  const struct family family = {.zeros = 0.1};
  struct unit_random r = unit_random_of(17);
  static double whole[N_MAX * (3 * K_MAX + 1)];
  static uint32_t exchanged[N_MAX];
  for (size_t trial = 0; trial < 200; trial++) {
    size_t n, k, end = 0;
    shape(&r, &n, &k);
    make(&r, &family, n, k);
    pack(k);
    memcpy(whole, band, ph_band_size(n, k) * sizeof *band);
    if (!ph_band_factor(whole, exchanged, n, k)) {
      continue;
    }
    for (size_t from = 0, to; from < n; from = to) {
      to = from + 1 + unit_random_below(&r, n - from);
      ck_assert(ph_band_reduce(band, pivot, n, k, from, to, &end));
    }
    ck_assert_mem_eq(band, whole, ph_band_size(n, k) * sizeof *band);
    ck_assert_mem_eq(pivot, exchanged, n * sizeof *pivot);
  }
}

/* Without exchanges, nothing is written where the fill would be. */
PH_TEST(no_fill) {
  const struct family family = {.diagonal = 50};
  struct unit_random r = unit_random_of(12);
  for (size_t k = 1; k < 12; k++) {
    make(&r, &family, N_MAX, k);
    pack(k);
    ck_assert(ph_band_factor(band, pivot, N_MAX, k));
    for (size_t i = 0; i < N_MAX; i++) {
      ck_assert_uint_eq(pivot[i], i);
      for (size_t c = 2 * k + 1; c <= 3 * k; c++) {
        ck_abs(band[i * (3 * k + 1) + c], 0, 0);
      }
    }
  }
}

/* A column or a row of zeros, and a row that is there twice. */
PH_TEST(singular) {
  const struct family family = {.zeros = 0.1};
  struct unit_random r = unit_random_of(13);
  for (int trial = 0; trial < unit_count(600); trial++) {
    const size_t n = 2 + unit_random_below(&r, N_MAX - 1);
    const size_t k = 1 + unit_random_below(&r, n);
    const size_t at = unit_random_below(&r, n - 1);
    make(&r, &family, n, k);
    for (size_t i = 0; i < n; i++) {
      if (trial % 3 == 0) {
        dense.a[i][at] = 0;
      } else if (trial % 3 == 1) {
        dense.a[at][i] = 0;
      } else {
        dense.a[at][i] = in_band(at + 1, i, k) ? dense.a[at][i] : 0;
        dense.a[at + 1][i] = dense.a[at][i];
      }
    }
    pack(k);
    ck_assert(!ph_band_factor(band, pivot, n, k));
  }
}

PH_TEST(one_row) {
  for (size_t k = 0; k < 4; k++) {
    double x = 6;
    dense.n = 1;
    dense.a[0][0] = 4;
    pack_sym(k);
    ck_assert(ph_sym_factor(sym, 1, k));
    ck_abs(sym[0], 2, 0);
    ph_sym_solve(sym, 1, k, &x);
    ck_abs(x, 1.5, 0);
    dense.a[0][0] = -4;
    pack(k);
    ck_assert(ph_band_factor(band, pivot, 1, k));
    ph_band_solve(band, pivot, 1, k, &x);
    ck_abs(x, -0.375, 0);
    pack_sym(k);
    ck_assert(!ph_sym_factor(sym, 1, k));
    dense.a[0][0] = 0;
    pack(k);
    ck_assert(!ph_band_factor(band, pivot, 1, k));
  }
}

static const double bad[] = {(double)NAN, (double)INFINITY, -(double)INFINITY};

/* One element that is no number, anywhere. */
PH_TEST_EACH(not_finite, COUNT(bad)) {
  struct unit_random r = unit_random_of(20);
  const size_t n = 9;
  for (size_t k = 0; k < 11; k++) {
    for (size_t at = 0; at < n * n; at++) {
      const size_t i = at / n, j = at % n;
      const struct family family = {.diagonal = at % 2 ? 20 : 2 * (double)n,
                                    .zeros = at % 2 ? 1 : 0.3};
      if (!in_band(i, j, k)) {
        continue;
      }
      make(&r, &family, n, k);
      dense.a[i][j] = bad[_i];
      pack(k);
      ck_assert(!ph_band_factor(band, pivot, n, k));
      if (i >= j) {
        pack_sym(k);
        ck_assert(!ph_sym_factor(sym, n, k));
      }
    }
  }
}

/* The solution of a long one is known: 1, 2, 3, 1, 2, ... */
PH_TEST(many_rows) {
  const size_t n = (size_t)unit_count(30000), k = 11;
  double *a = calloc(ph_band_size(n, k), sizeof *a);
  double *s = calloc(ph_sym_size(n, k), sizeof *s);
  double *x = calloc(n, sizeof *x), *y = calloc(n, sizeof *y);
  uint32_t *exchanged = calloc(n, sizeof *exchanged);
  ck_assert(a && s && x && y && exchanged);
  for (size_t i = 0; i < n; i++) {
    for (size_t j = i < k ? 0 : i - k; j <= i + k && j < n; j++) {
      const size_t low = i < j ? i : j, step = i < j ? j - i : i - j;
      const double value = step > 0 ? 1 / (double)(step + low % 5) : 9;
      *ph_band_at(a, k, i, j) = value;
      if (i >= j) {
        *ph_sym_at(s, k, i, j) = value;
      }
      x[i] += value * (double)(1 + j % 3);
    }
    y[i] = x[i];
  }
  ck_assert(ph_band_factor(a, exchanged, n, k));
  ph_band_solve(a, exchanged, n, k, x);
  ck_assert(ph_sym_factor(s, n, k));
  ph_sym_solve(s, n, k, y);
  for (size_t i = 0; i < n; i++) {
    ck_rel(x[i], (double)(1 + i % 3), 1e-14);
    ck_rel(y[i], (double)(1 + i % 3), 1e-14);
  }
  free(a);
  free(s);
  free(x);
  free(y);
  free(exchanged);
}
