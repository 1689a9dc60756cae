/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Trimmed offsets: `trim D FILE' reads points x,y of a closed curve and prints
 * its segments, loops and pieces at distance D, the area, the processor seconds
 * of the offset and of its certificate, the size of the curve, and whether it
 * crosses itself: then the offset is that of both sides.
 *
 * With a third argument, the name of a file, it writes the curve to that as a
 * polygon: a point x y a line, with chords within 1e-6 of the size.
 */
#include "bench.h"

#include "base/mem.h"
#include "check/loop.h"
#include "curve/cross/cross.h"
#include "curve/offset/loop.h"
#include "kernel/bern.h"
#include "solve/method.h"

#include <gsl/gsl_errno.h>
#include <string.h>

enum { ROUNDS = 3, LINE_MAX_BYTES = 4096, DEGREE_MAX = 5 };

/* Seconds that are spent at least. */
static const double LEAST = 0.3;

struct work {
  struct ph_curve curve;
  bool crosses;
  double distance;
  struct ph_arena arena, scratch;
  struct ph_offset offset;
  struct ph_diag diag;
  double offset_s, certificate_s; /* the least */
};

/* Points of a file, from its first two columns. */
static double *read_points(const char *name, size_t *n) {
  FILE *file = fopen(name, "r");
  char line[LINE_MAX_BYTES];
  double *v = NULL;
  size_t room = 0;
  *n = 0;
  while (file && fgets(line, sizeof line, file)) {
    double x, y;
    if (sscanf(line, "%lf,%lf", &x, &y) != 2) {
      continue;
    }
    if (*n == room) {
      room = room ? 2 * room : 1024;
      v = realloc(v, 2 * room * sizeof *v);
      if (!v) {
        bench_die("out of memory");
      }
    }
    v[2 * *n] = x;
    v[2 * *n + 1] = y;
    ++*n;
  }
  if (!file || *n < 3) {
    bench_die("no points");
  }
  fclose(file);
  return v;
}

static void solve(struct work *w, double *points, size_t n) {
  struct ph_problem problem = {{{0}}};
  struct ph_result result;
  struct ph_cross cross;
  memset(&result, 0, sizeof result);
  problem.field[PH_F_POINTS] = (struct ph_value){
      .kind = PH_VECTORS, .v = points, .n = n, .dimension = 2};
  problem.field[PH_F_CLOSED] = (struct ph_value){.kind = PH_BOOL, .flag = true};
  if (ph_method_planar.solve(&problem, &w->arena, &w->scratch, &result,
                             &w->diag) != PH_OK) {
    bench_die(w->diag.message);
  }
  w->curve = result.curve;
  if (ph_cross_planar(&w->curve, &w->scratch, &cross, &w->diag) != PH_OK) {
    bench_die(w->diag.message);
  }
  w->crosses = !cross.simple;
}

static void run(struct work *w, int round) {
  const struct ph_offset_rules rules = {.mode = PH_OFFSET_TRIMMED,
                                        .crosses = w->crosses,
                                        .both = w->crosses,
                                        .tolerance = 1e-9};
  struct ph_arena arena = {0};
  double at[3];
  w->offset = (struct ph_offset){.distance = w->distance, .dimension = 2};
  at[0] = bench_cpu();
  if (ph_loops_of(&w->curve, &rules, &arena, &w->offset, &w->diag) != PH_OK) {
    bench_die(w->diag.message);
  }
  at[1] = bench_cpu();
  if (ph_certify_loops(&w->curve, &w->offset, 1, &w->scratch, &w->diag) !=
      PH_OK) {
    bench_die(w->diag.message);
  }
  at[2] = bench_cpu();
  if (round == 0 || at[2] - at[0] < w->offset_s + w->certificate_s) {
    w->offset_s = at[1] - at[0];
    w->certificate_s = at[2] - at[1];
  }
  if (round == 0) {
    size_t pieces = 0;
    for (size_t i = 0; i < w->offset.loops.n; i++) {
      pieces += w->offset.loops.v[i].n;
    }
    printf("%zu %zu %zu %.17g", w->curve.n, w->offset.loops.n, pieces,
           w->offset.loops.area);
  }
  ph_arena_free(&arena);
}

static double size_of(const struct ph_curve *c) {
  double low[2] = {HUGE_VAL, HUGE_VAL}, high[2] = {-HUGE_VAL, -HUGE_VAL};
  for (size_t i = 0; i < 2 * ph_curve_points_n(c); i++) {
    const double x = c->control_points[i];
    low[i % 2] = fmin(low[i % 2], x);
    high[i % 2] = fmax(high[i % 2], x);
  }
  return fmax(high[0] - low[0], high[1] - low[1]);
}

/* Points from the first one of each segment on, whose chords are so near:
 * M h^2 / 8, with M the largest second derivative. */
static void write_polygon(const struct ph_curve *c, double tolerance,
                          const char *name) {
  FILE *file = fopen(name, "w");
  const size_t n = c->degree;
  if (!file) {
    bench_die("cannot write the polygon");
  }
  for (size_t k = 0; k < c->n; k++) {
    const double *p = ph_curve_points(c, k);
    double most = 0;
    size_t parts;
    for (size_t i = 0; i + 2 <= n; i++) {
      const double *q = p + 2 * i;
      most = fmax(most, hypot(q[4] - 2 * q[2] + q[0], q[5] - 2 * q[3] + q[1]));
    }
    parts = (size_t)ceil(sqrt((double)(n * (n - 1)) * most / (8 * tolerance)));
    for (size_t j = 0; j < parts || j == 0; j++) {
      double b[DEGREE_MAX + 1], x = 0, y = 0;
      ph_bern_basis(n, j ? (double)j / (double)parts : 0, b);
      for (size_t i = 0; i <= n; i++) {
        x += b[i] * p[2 * i];
        y += b[i] * p[2 * i + 1];
      }
      fprintf(file, "%.17g %.17g\n", x, y);
    }
  }
  if (fclose(file) != 0) {
    bench_die("cannot write the polygon");
  }
}

int main(int argc, char **argv) {
  struct work w = {.curve = {.n = 0}};
  double *points, begin;
  size_t n;
  if (argc < 3) {
    bench_die("trim D FILE [POLYGON]");
  }
  ph_memory_keep();
  gsl_set_error_handler_off();
  points = read_points(argv[2], &n);
  solve(&w, points, n);
  w.distance = strtod(argv[1], NULL);
  begin = bench_cpu();
  for (int round = 0; round < ROUNDS || bench_cpu() < begin + LEAST; round++) {
    run(&w, round);
  }
  printf(" %.9g %.9g %.9g %d\n", w.offset_s, w.certificate_s, size_of(&w.curve),
         w.crosses);
  if (argc > 3) {
    write_polygon(&w.curve, 1e-6 * size_of(&w.curve), argv[3]);
  }
  ph_arena_free(&w.arena);
  ph_arena_free(&w.scratch);
  free(points);
  return 0;
}
