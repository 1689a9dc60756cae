/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Tables as NumPy arrays beside the same as CSV, writing alone: a row of
 * samples of a curve in the plane and of one in space.
 */
#include "bench.h"

#include "io/csv_out.h"

enum { ROWS = 100000, ROUNDS = 9 };

struct data {
  struct ph_buf buf;
  struct ph_csv_shape shape;
  struct ph_result *result;
};

static double *numbers(size_t n, uint64_t *state) {
  double *v = bench_malloc(n, sizeof *v);
  for (size_t i = 0; i < n; i++) {
    v[i] = bench_uniform(state, -100, 100);
  }
  return v;
}

static void fill(struct ph_samples *s, size_t dimension) {
  uint64_t state = 3;
  s->n = ROWS;
  s->dimension = dimension;
  s->segment = bench_malloc(ROWS, sizeof *s->segment);
  s->t = numbers(ROWS, &state);
  s->s = numbers(ROWS, &state);
  s->point = numbers(dimension * ROWS, &state);
  s->tangent = numbers(dimension * ROWS, &state);
  s->curvature = numbers(ROWS, &state);
  s->torsion = dimension == 3 ? numbers(ROWS, &state) : NULL;
}

static void write_table(void *data) {
  static const struct ph_csv_heading heading = {"curve", NULL, 0, "-", 1};
  struct data *d = data;
  ph_buf_clear(&d->buf, SIZE_MAX);
  ph_csv_result(&d->buf, &d->shape, &heading, d->result);
  if (d->buf.failed || d->buf.n < ROWS) {
    bench_die("the table was not written");
  }
}

static void row(const char *name, enum ph_space space) {
  static struct ph_result result;
  struct data csv = {.shape = {.table = PH_TABLE_SAMPLES, .space = space},
                     .result = &result};
  struct data npy = csv;
  struct bench_contender c[2] = {{write_table, &npy, 0},
                                 {write_table, &csv, 0}};
  npy.shape.binary = true;
  fill(&result.samples, space == PH_SPACE ? 3 : 2);
  bench_alternate(c, 2, ROUNDS, 1);
  printf("  %-10s %7.1f %8.1f %6.1f   >= 5\n", name, 1e9 / ROWS * c[0].best,
         1e9 / ROWS * c[1].best, c[1].best / c[0].best);
  ph_buf_free(&csv.buf);
  ph_buf_free(&npy.buf);
}

int main(void) {
  puts("Rows of samples as an array of NumPy beside CSV, writing alone, "
       "processor ns\na row, best of many runs\n");
  puts("  samples        npy      csv  ratio   target");
  row("plane", PH_PLANE);
  row("space", PH_SPACE);
  return 0;
}
