/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The cyclic tridiagonal solver against GSL's dense LU decomposition. */
#include "unit.h"

#include "kernel/tri.h"

#include <gsl/gsl_complex_math.h>
#include <gsl/gsl_linalg.h>

enum { N_MAX = 40 };

/* What the rows of a random system are like. */
struct family {
  bool cyclic;
  double zeros;    /* part of the entries that vanish */
  double diagonal; /* the diagonal is multiplied by this */
};

static ph_cplx entry(struct unit_random *r, double zeros) {
  ph_cplx z = unit_random_cplx(r, 1);
  return unit_random_in(r, 0, 1) < zeros ? ph_cplx_of(0, 0) : z;
}

static void make(struct unit_random *r, const struct family *family, size_t n,
                 struct ph_tri_row *row) {
  const ph_cplx zero = {0, 0};
  for (size_t i = 0; i < n; i++) {
    row[i].lo = entry(r, family->zeros);
    row[i].di = ph_cplx_scale(family->diagonal, entry(r, family->zeros));
    row[i].up = entry(r, family->zeros);
    row[i].f = unit_random_cplx(r, 1);
  }
  if (!family->cyclic) {
    row[0].lo = row[n - 1].up = zero;
  }
}

static void solve(const struct ph_tri_row *row, size_t n, ph_cplx *x) {
  struct ph_tri tri;
  ck_assert(ph_tri_alloc(&tri, &unit_arena, n));
  ph_tri_begin(&tri, n, row[0], row[n - 1]);
  for (size_t i = 1; i + 1 < n; i++) {
    ph_tri_push(&tri, &row[i]);
  }
  ph_tri_finish(&tri, x);
  ph_tri_finish_here(&tri);
  for (size_t k = 0; k < n; k++) {
    const ph_cplx y = tri.pivot[k].f;
    ck_assert(unit_distance(x[k], y) <= 0 ||
              (!ph_cplx_is_finite(x[k]) && !ph_cplx_is_finite(y)));
  }
}

/* Largest |A x - f| of a row in units of the sum of its terms' sizes. */
static double backward_error(const struct ph_tri_row *row, size_t n,
                             const ph_cplx *x) {
  double worst = 0;
  for (size_t i = 0; i < n; i++) {
    const ph_cplx a[3] = {row[i].lo, row[i].di, row[i].up};
    const ph_cplx v[3] = {x[(i + n - 1) % n], x[i], x[(i + 1) % n]};
    ph_cplx sum = row[i].f;
    double size = 0, error;
    for (int j = 0; j < 3; j++) {
      sum = ph_cplx_sub(sum, ph_cplx_mul(a[j], v[j]));
      size += ph_cplx_abs(a[j]) * ph_cplx_abs(v[j]);
    }
    error = ph_cplx_abs(sum) / (size + ph_cplx_abs(row[i].f));
    worst = unit_larger(worst, error);
  }
  return worst;
}

static double largest(const gsl_matrix_complex *a) {
  double max = 0;
  for (size_t i = 0; i < a->size1; i++) {
    for (size_t j = 0; j < a->size2; j++) {
      max = fmax(max, gsl_complex_abs(gsl_matrix_complex_get(a, i, j)));
    }
  }
  return max;
}

/* The dense solution x, and how much it may change, relatively, when the
 * entries of the matrix change by eps: 0 for a singular matrix. */
static double solve_dense(const struct ph_tri_row *row, size_t n, ph_cplx *x) {
  gsl_matrix_complex *a = gsl_matrix_complex_calloc(n, n);
  gsl_matrix_complex *inverse = gsl_matrix_complex_alloc(n, n);
  gsl_vector_complex *f = gsl_vector_complex_alloc(n);
  gsl_permutation *p = gsl_permutation_alloc(n);
  double condition;
  int sign;
  ck_assert(a && inverse && f && p);
  for (size_t i = 0; i < n; i++) {
    const ph_cplx z[3] = {row[i].lo, row[i].di, row[i].up};
    for (size_t j = 0; j < 3; j++) {
      gsl_complex *e = gsl_matrix_complex_ptr(a, i, (i + n - 1 + j) % n);
      *e = gsl_complex_add(*e, gsl_complex_rect(z[j].re, z[j].im));
    }
    gsl_vector_complex_set(f, i, gsl_complex_rect(row[i].f.re, row[i].f.im));
  }
  condition = (double)n * largest(a);
  ck_assert_int_eq(gsl_linalg_complex_LU_decomp(a, p, &sign), 0);
  if (gsl_linalg_complex_LU_invert(a, p, inverse) != 0) {
    condition = 0;
  } else {
    condition *= (double)n * largest(inverse);
    gsl_linalg_complex_LU_svx(a, p, f);
    for (size_t i = 0; i < n; i++) {
      gsl_complex z = gsl_vector_complex_get(f, i);
      x[i] = ph_cplx_of(GSL_REAL(z), GSL_IMAG(z));
    }
  }
  gsl_matrix_complex_free(a);
  gsl_matrix_complex_free(inverse);
  gsl_vector_complex_free(f);
  gsl_permutation_free(p);
  return condition * DBL_EPSILON;
}

/* Compares both solutions of one system; false if it was too near to singular
 * for a comparison. */
static bool compare(const struct ph_tri_row *row, size_t n, unsigned which) {
  ph_cplx x[N_MAX], dense[N_MAX];
  double sensitivity = solve_dense(row, n, dense), error = 0, size = 0;
  if (!(sensitivity > 0 && sensitivity < 1e-6)) {
    return false;
  }
  solve(row, n, x);
  for (size_t i = 0; i < n; i++) {
    error = unit_larger(error, unit_distance(x[i], dense[i]));
    size = fmax(size, ph_cplx_abs(dense[i]));
  }
  ck_assert_msg(error <= 16 * sensitivity * size,
                "seed %lu, system %u of %zu unknowns: error %.3g of %.3g, "
                "sensitivity %.3g",
                unit_seed(), which, n, error, size, sensitivity);
  error = backward_error(row, n, x);
  ck_assert_msg(error <= 1e-13, "seed %lu, system %u of %zu unknowns: %.3g",
                unit_seed(), which, n, error);
  return true;
}

/* With small diagonals ten digits would be lost without row interchanges. */
static const struct {
  struct family family;
  uint64_t stream;
} FAMILIES[] = {
    {{false, 0, 1}, 1},      {{false, 0.2, 1}, 2},   {{false, 0, 0}, 3},
    {{false, 0, 1e-10}, 12}, {{true, 0, 1e-10}, 13}, {{true, 0, 1}, 4},
    {{true, 0.2, 1}, 5},     {{true, 0, 0}, 6},      {{true, 0, 100}, 7}};

PH_TEST_EACH(test_dense, COUNT(FAMILIES)) {
  struct unit_random r = unit_random_of(FAMILIES[_i].stream);
  struct ph_tri_row row[N_MAX];
  unsigned compared = 0, tried = 0;
  for (size_t n = 3; n <= N_MAX; n++) {
    for (int i = 0; i < unit_count(30); i++) {
      make(&r, &FAMILIES[_i].family, n, row);
      compared += compare(row, n, tried++);
      ph_arena_reset(&unit_arena);
    }
  }
  /* With many zeros most larger matrices are singular. */
  ck_assert_uint_ge(compared, tried / 10);
}

/* The last row goes along for as long as its corner entry matters; how large
 * its entries are beside those of the others has no influence. */
PH_TEST(test_last_row_scale) {
  const double scales[] = {1e-16, 1e-8, 1e8, 1e16};
  const struct family family = {true, 0, 8};
  struct unit_random r = unit_random_of(8);
  struct ph_tri_row row[N_MAX];
  ph_cplx x[N_MAX], y[N_MAX];
  for (int i = 0; i < unit_count(400); i++) {
    size_t n = 3 + unit_random_below(&r, N_MAX - 2);
    struct ph_tri_row *last = &row[n - 1];
    double s = scales[i % 4];
    make(&r, &family, n, row);
    for (size_t k = 0; k < n; k++) {
      ph_cplx z = unit_random_cplx(&r, 1);
      row[k].di = ph_cplx_scale(8 / ph_cplx_abs(z), z);
    }
    solve(row, n, x);
    last->lo = ph_cplx_scale(s, last->lo);
    last->di = ph_cplx_scale(s, last->di);
    last->up = ph_cplx_scale(s, last->up);
    last->f = ph_cplx_scale(s, last->f);
    solve(row, n, y);
    for (size_t k = 0; k < n; k++) {
      ck_assert_msg(unit_distance(x[k], y[k]) <= 1e-12,
                    "seed %lu, system %d of %zu unknowns: x[%zu] moves by %.3g",
                    unit_seed(), i, n, k, unit_distance(x[k], y[k]));
    }
    ph_arena_reset(&unit_arena);
  }
}

/* Long enough for the corner entries to decay, and for them not to. */
PH_TEST(test_long) {
  const struct family families[] = {{true, 0, 100}, {true, 0, 1},
                                    {true, 0, 0},   {true, 0, 1.5},
                                    {false, 0, 1},  {false, 0, 0}};
  enum { N = 20000 };
  struct unit_random r = unit_random_of(9);
  struct ph_tri_row *row = malloc(N * sizeof *row);
  ph_cplx *x = malloc(N * sizeof *x);
  ck_assert(row && x);
  for (size_t i = 0; i < COUNT(families); i++) {
    double error, size = 0;
    make(&r, &families[i], N, row);
    solve(row, N, x);
    error = backward_error(row, N, x);
    for (size_t k = 0; k < N; k++) {
      size = fmax(size, ph_cplx_abs(x[k]));
    }
    ck_assert_msg(error <= 1e-13, "seed %lu, family %zu: %.3g, largest %.3g",
                  unit_seed(), i, error, size);
    ph_arena_reset(&unit_arena);
  }
  free(row);
  free(x);
}

/* The workspace is used again, for fewer unknowns and another kind. */
PH_TEST(test_reuse) {
  struct unit_random r = unit_random_of(10);
  struct ph_tri_row row[N_MAX];
  ph_cplx x[N_MAX];
  struct ph_tri tri;
  ck_assert(ph_tri_alloc(&tri, &unit_arena, N_MAX));
  for (size_t n = N_MAX; n >= 3; n--) {
    struct family family = {n % 2 == 0, 0, 8};
    make(&r, &family, n, row);
    ph_tri_begin(&tri, n, row[0], row[n - 1]);
    for (size_t i = 1; i + 1 < n; i++) {
      ph_tri_push(&tri, &row[i]);
    }
    ph_tri_finish(&tri, x);
    ck_assert_double_le(backward_error(row, n, x), 1e-14);
  }
}

/* A singular matrix gives something that is not finite. */
PH_TEST(test_singular) {
  struct unit_random r = unit_random_of(11);
  for (size_t n = 3; n <= 12; n++) {
    for (size_t dead = 0; dead < n; dead++) {
      struct family family = {dead % 2 == 0, 0, 1};
      struct ph_tri_row row[N_MAX];
      const ph_cplx zero = {0, 0};
      ph_cplx x[N_MAX];
      bool finite = true;
      make(&r, &family, n, row);
      row[dead].lo = row[dead].di = row[dead].up = zero;
      solve(row, n, x);
      for (size_t i = 0; i < n; i++) {
        finite = finite && ph_cplx_is_finite(x[i]);
      }
      ck_assert_msg(!finite, "row %zu of %zu is zero", dead, n);
      ph_arena_reset(&unit_arena);
    }
  }
}

PH_TEST(test_no_memory) {
  struct ph_tri tri;
  ck_assert(!ph_tri_alloc(&tri, &unit_arena, SIZE_MAX / 2));
}
