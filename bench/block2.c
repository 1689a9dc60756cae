/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Block tridiagonal systems with 2 x 2 blocks beside GSL's band LU, as rows
 * from memory: open and cyclic, and one in which rows are interchanged.  GSL
 * has no cyclic systems: it solves the open one instead.
 */
#include "bench.h"

#include "kernel/block2.h"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_linalg.h>
#include <gsl/gsl_version.h>

/* gsl_linalg_LU_band_decomp is of GSL 2.7 */
#define GSL_HAS_LU_BAND \
  (GSL_MAJOR_VERSION > 2 || (GSL_MAJOR_VERSION == 2 && GSL_MINOR_VERSION >= 7))

enum { SEED = 1, ROUNDS = 7, BAND = 3, WIDTH = 3 * BAND + 1 };

enum kind { OPEN, CYCLIC, RANDOM, KINDS };

static const char *const kinds[KINDS] = {"open", "cyclic", "open, random"};

struct data {
  size_t n;
  struct ph_block2_row *row;
  struct ph_block2 block2;
  double (*x)[2];
  gsl_matrix *gsl_matrix;
  gsl_vector_uint *gsl_pivot;
  gsl_vector *gsl_x;
};

static double uniform(uint64_t *state) {
  return (double)(bench_random(state) >> 11) * 0x1p-52 - 1;
}

static void fill(struct data *d, enum kind kind) {
  uint64_t state = SEED;
  for (size_t i = 0; i < d->n; i++) {
    struct ph_block2_row *row = &d->row[i];
    for (int j = 0; j < 4; j++) {
      const bool on = kind != RANDOM && (j == 0 || j == 3);
      row->lo[j] = i > 0 || kind == CYCLIC ? uniform(&state) : 0;
      row->di[j] = uniform(&state) + (on ? 5 : 0);
      row->up[j] = i + 1 < d->n || kind == CYCLIC ? uniform(&state) : 0;
    }
    row->f[0] = uniform(&state);
    row->f[1] = uniform(&state);
  }
}

static void ours(void *data) {
  struct data *d = data;
  ph_block2_begin(&d->block2, d->n, &d->row[0], &d->row[d->n - 1]);
  for (size_t i = 1; i + 1 < d->n; i++) {
    ph_block2_push(&d->block2, &d->row[i]);
  }
  ph_block2_finish(&d->block2, d->x);
}

static void gsl(void *data) {
#if GSL_HAS_LU_BAND
  struct data *d = data;
  const size_t n = 2 * d->n;
  gsl_matrix_set_zero(d->gsl_matrix);
  for (size_t i = 0; i < n; i++) {
    const struct ph_block2_row *row = &d->row[i / 2];
    const double *blocks[3] = {row->lo, row->di, row->up};
    for (size_t j = 0; j < 6; j++) {
      /* column + 2, so that none is negative */
      size_t column = i / 2 * 2 + j;
      if (column >= 2 && column < n + 2) {
        gsl_matrix_set(d->gsl_matrix, column - 2, 2 * BAND + i + 2 - column,
                       blocks[j / 2][2 * (i % 2) + j % 2]);
      }
    }
    gsl_vector_set(d->gsl_x, i, row->f[i % 2]);
  }
  if (gsl_linalg_LU_band_decomp(n, BAND, BAND, d->gsl_matrix, d->gsl_pivot) ||
      gsl_linalg_LU_band_svx(BAND, BAND, d->gsl_matrix, d->gsl_pivot,
                             d->gsl_x)) {
    bench_die("GSL finds no solution");
  }
#else
  (void)data;
#endif
}

/* How far the two solutions are apart, relative to the largest element. */
static double difference(const struct data *d) {
  double most = 0, largest = 0;
  for (size_t i = 0; i < 2 * d->n; i++) {
    double x = gsl_vector_get(d->gsl_x, i), e = fabs(d->x[i / 2][i % 2] - x);
    most = e <= most ? most : e;
    largest = fabs(x) <= largest ? largest : fabs(x);
  }
  return most / largest;
}

static void row(enum kind kind, size_t n) {
  struct ph_arena arena = {0};
  struct data d = {.n = n};
  struct bench_contender c[] = {{ours, &d, 0}, {gsl, &d, 0}};
  const int times = (int)(200000 / n) + 1;
  const double unit = 1e9 / (double)n;
  d.row = bench_malloc(n, sizeof *d.row);
  d.x = bench_malloc(n, sizeof *d.x);
  d.gsl_matrix = gsl_matrix_alloc(2 * n, WIDTH);
  d.gsl_pivot = gsl_vector_uint_alloc(2 * n);
  d.gsl_x = gsl_vector_alloc(2 * n);
  if (!ph_block2_alloc(&d.block2, &arena, n) || !d.gsl_matrix || !d.gsl_pivot ||
      !d.gsl_x) {
    bench_die("out of memory");
  }
  fill(&d, kind);
  bench_alternate(c, GSL_HAS_LU_BAND ? 2 : 1, ROUNDS, times);
  printf("  %-13s %7zu %8.1f", kinds[kind], n, unit * c[0].best);
  if (GSL_HAS_LU_BAND && kind != CYCLIC) {
    printf(" %8.1f %7.3f %9.0e\n", unit * c[1].best, c[0].best / c[1].best,
           difference(&d));
  } else {
    printf(" %8s %7s %9s\n", "-", "-", "-");
  }
  fflush(stdout);
  free(d.row);
  free(d.x);
  gsl_matrix_free(d.gsl_matrix);
  gsl_vector_uint_free(d.gsl_pivot);
  gsl_vector_free(d.gsl_x);
  ph_arena_free(&arena);
}

int main(void) {
  static const size_t sizes[] = {100, 10000, 100000};
  gsl_set_error_handler_off();
  puts("Block tridiagonal systems of n block rows, 2 x 2; processor ns a block "
       "row\n\n"
       "                      n     ours      GSL   ratio     diff.");
  for (int kind = 0; kind < KINDS; kind++) {
    for (size_t i = 0; i < sizeof sizes / sizeof sizes[0]; i++) {
      row((enum kind)kind, sizes[i]);
    }
  }
  puts("\n  Target: 60 ns for an open system of 100000.  diff.: how far the "
       "solutions\n  are apart, relative to the largest element.");
  return 0;
}
