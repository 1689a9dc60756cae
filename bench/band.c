/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Factors and solutions of band matrices beside GSL's, from the same elements.
 * A factor starts with a copy of the matrix, as it destroys it.
 */
#include "bench.h"

#include "kernel/band.h"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_linalg.h>
#include <gsl/gsl_version.h>
#include <string.h>

/* gsl_linalg_LU_band_decomp is of GSL 2.7 */
#define GSL_HAS_LU_BAND \
  (GSL_MAJOR_VERSION > 2 || (GSL_MAJOR_VERSION == 2 && GSL_MINOR_VERSION >= 7))

enum { ROWS = 10000, SEED = 1, ROUNDS = 7, SOLVES = 5 };

/* What is factored: a positive definite matrix, or a general one. */
enum kind { SYMMETRIC, DOMINANT, RANDOM, KINDS };

static const char *const kinds[KINDS] = {"L L^T", "LU, dominant", "LU, random"};

struct data {
  enum kind kind;
  size_t k, size; /* half bandwidth; elements */
  double *matrix, *factor, *x;
  uint32_t *pivot;
  double *gsl_matrix, *gsl_factor;
  gsl_vector_uint *gsl_pivot;
  gsl_vector *gsl_x;
};

static double uniform(uint64_t *state) {
  return (double)(bench_random(state) >> 11) * 0x1p-52 - 1;
}

/* The places of element (i, j) in both. */
static void set(struct data *d, size_t i, size_t j, double value) {
  const size_t k = d->k;
  if (d->kind == SYMMETRIC) {
    *ph_sym_at(d->matrix, k, i, j) = value;
    d->gsl_matrix[j * (k + 1) + i - j] = value;
  } else {
    *ph_band_at(d->matrix, k, i, j) = value;
    d->gsl_matrix[j * (3 * k + 1) + 2 * k + i - j] = value;
  }
}

static void begin(struct data *d) {
  uint64_t state = SEED;
  const bool symmetric = d->kind == SYMMETRIC;
  d->size = symmetric ? ph_sym_size(ROWS, d->k) : ph_band_size(ROWS, d->k);
  d->matrix = bench_malloc(d->size, sizeof *d->matrix);
  d->factor = bench_malloc(d->size, sizeof *d->factor);
  d->gsl_matrix = bench_malloc(d->size, sizeof *d->gsl_matrix);
  d->gsl_factor = bench_malloc(d->size, sizeof *d->gsl_factor);
  d->x = bench_malloc(ROWS, sizeof *d->x);
  d->pivot = bench_malloc(ROWS, sizeof *d->pivot);
  d->gsl_x = gsl_vector_calloc(ROWS);
  d->gsl_pivot = gsl_vector_uint_calloc(ROWS);
  if (!d->gsl_x || !d->gsl_pivot) {
    bench_die("out of memory");
  }
  for (size_t j = 0; j < ROWS; j++) {
    for (size_t i = symmetric || j < d->k ? (symmetric ? j : 0) : j - d->k;
         i <= j + d->k && i < ROWS; i++) {
      const bool large = i == j && d->kind != RANDOM;
      set(d, i, j, uniform(&state) + (large ? 2 * (double)d->k + 2 : 0));
    }
  }
}

static void end(struct data *d) {
  free(d->matrix);
  free(d->factor);
  free(d->gsl_matrix);
  free(d->gsl_factor);
  free(d->x);
  free(d->pivot);
  gsl_vector_free(d->gsl_x);
  gsl_vector_uint_free(d->gsl_pivot);
}

static void factor(void *data) {
  struct data *d = data;
  memcpy(d->factor, d->matrix, d->size * sizeof *d->factor);
  if (!(d->kind == SYMMETRIC
            ? ph_sym_factor(d->factor, ROWS, d->k)
            : ph_band_factor(d->factor, d->pivot, ROWS, d->k))) {
    bench_die("no factor");
  }
}

static void solve(void *data) {
  struct data *d = data;
  for (size_t i = 0; i < ROWS; i++) {
    d->x[i] = (double)(i % 7) - 3;
  }
  if (d->kind == SYMMETRIC) {
    ph_sym_solve(d->factor, ROWS, d->k, d->x);
  } else {
    ph_band_solve(d->factor, d->pivot, ROWS, d->k, d->x);
  }
}

static gsl_matrix_view gsl_view(struct data *d) {
  return gsl_matrix_view_array(d->gsl_factor, ROWS, d->size / ROWS);
}

static void gsl_factor(void *data) {
  struct data *d = data;
  gsl_matrix_view m = gsl_view(d);
  int status = GSL_EUNIMPL;
  memcpy(d->gsl_factor, d->gsl_matrix, d->size * sizeof *d->gsl_factor);
  if (d->kind == SYMMETRIC) {
    status = gsl_linalg_cholesky_band_decomp(&m.matrix);
  } else {
#if GSL_HAS_LU_BAND
    status =
        gsl_linalg_LU_band_decomp(ROWS, d->k, d->k, &m.matrix, d->gsl_pivot);
#endif
  }
  if (status) {
    bench_die("GSL finds no factor");
  }
}

static void gsl_solve(void *data) {
  struct data *d = data;
  gsl_matrix_view m = gsl_view(d);
  for (size_t i = 0; i < ROWS; i++) {
    gsl_vector_set(d->gsl_x, i, (double)(i % 7) - 3);
  }
  if (d->kind == SYMMETRIC) {
    gsl_linalg_cholesky_band_svx(&m.matrix, d->gsl_x);
  } else {
#if GSL_HAS_LU_BAND
    gsl_linalg_LU_band_svx(d->k, d->k, &m.matrix, d->gsl_pivot, d->gsl_x);
#endif
  }
}

/* How far the two solutions are apart, relative to the largest element. */
static double difference(const struct data *d) {
  double most = 0, largest = 0;
  for (size_t i = 0; i < ROWS; i++) {
    double x = gsl_vector_get(d->gsl_x, i), e = fabs(d->x[i] - x);
    most = e <= most ? most : e;
    largest = fabs(x) <= largest ? largest : fabs(x);
  }
  return most / largest;
}

static void row(enum kind kind, size_t k) {
  struct data d = {.kind = kind, .k = k};
  struct bench_contender factors[] = {{factor, &d, 0}, {gsl_factor, &d, 0}};
  struct bench_contender solves[] = {{solve, &d, 0}, {gsl_solve, &d, 0}};
  const size_t n = kind == SYMMETRIC || GSL_HAS_LU_BAND ? 2 : 1;
  const double unit = 1e9 / ROWS;
  begin(&d);
  bench_alternate(factors, n, ROUNDS, 1);
  bench_alternate(solves, n, ROUNDS, SOLVES);
  printf("  %-13s %4zu %8.0f", kinds[kind], k, unit * factors[0].best);
  if (n > 1) {
    printf(" %8.0f %7.3f %8.0f %8.0f %7.3f %9.0e\n", unit * factors[1].best,
           factors[0].best / factors[1].best, unit * solves[0].best,
           unit * solves[1].best, solves[0].best / solves[1].best,
           difference(&d));
  } else {
    printf(" %8s %7s %8.0f %8s %7s %9s\n", "-", "-", unit * solves[0].best, "-",
           "-", "-");
  }
  fflush(stdout);
  end(&d);
}

int main(void) {
  static const size_t widths[] = {11, 15, 19, 39};
  gsl_set_error_handler_off();
  printf("Band matrices of %d rows and half bandwidth k, warm; processor ns a "
         "row\n\n"
         "                            factor                    solve\n"
         "                k     ours      GSL   ratio     ours      GSL   ratio"
         "     diff.\n",
         ROWS);
  for (int kind = 0; kind < KINDS; kind++) {
    for (size_t i = 0; i < sizeof widths / sizeof widths[0]; i++) {
      row((enum kind)kind, widths[i]);
    }
  }
  puts("\n  diff.: how far the solutions are apart, relative to the largest "
       "element.");
  return 0;
}
