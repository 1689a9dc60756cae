/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The planar solver beside GSL's cubic splines, on the same points and knots.
 *
 *   ours   ph_method_planar.solve, or ph_method_tc.solve: from the points to
 *          control points, preimage and lengths of every segment
 *   GSL    gsl_interp_init for x and for y with the knots given: what two cubic
 *          splines need before they can be evaluated
 *
 * Warm: the memory is there and was used before.  Fresh: nothing is there, as
 * in a program that solves one problem; GSL then allocates, too, and has to
 * find the chordal knots.
 */
#include "bench.h"

#include "base/mem.h"
#include "solve/method.h"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_interp.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

static const double TWO_PI = 6.283185307179586;

/* Room that a solution is given, bytes a point, and for small ones. */
enum { ROOM = 1024, ROOM_MIN = 1 << 16 };

struct row {
  const char *name;
  bool closed;
  size_t per_wave;   /* points a wave; 0: no waves */
  const char *basis; /* of the segments; of cubics NULL */
  const char *mode;  /* of cubics, of the command tc */
};

static const struct row rows[] = {
    {"closed", true, 0, "ph", NULL},
    {"open", false, 0, "ph", NULL},
    {"closed, waves", true, 10, "ph", NULL},
    {"closed, atph", true, 0, "atph", NULL},
    {"closed, tc g2", true, 0, NULL, "g2"},
    {"waves, tc g2", true, 10, NULL, "g2"},
    {"waves, tc spline", true, 10, NULL, "spline"}};

static const size_t sizes[] = {1000, 10000, 100000, 1000000};

enum {
  ROWS = sizeof rows / sizeof rows[0],
  SIZES = sizeof sizes / sizeof sizes[0]
};

struct data {
  size_t n; /* points */
  double *points;
  const struct ph_method *method;
  struct ph_problem problem;
  struct ph_arena out, scratch;
  struct ph_mark out_start, scratch_start;
  double steps;
  /* the same for GSL: a closed curve repeats its first point */
  size_t gsl_n;
  double *knots, *x, *y;
  const gsl_interp_type *type;
  gsl_interp *spline[2];
};

static void set_knots(struct data *d) {
  double t = 0;
  d->knots[0] = 0;
  for (size_t k = 1; k < d->gsl_n; k++) {
    double dx = d->x[k] - d->x[k - 1], dy = d->y[k] - d->y[k - 1];
    t += sqrt(dx * dx + dy * dy);
    d->knots[k] = t;
  }
}

static void data_init(struct data *d, const struct row *row, size_t n) {
  size_t steps = row->closed ? n : n - 1;
  double waves = row->per_wave ? (double)(n / row->per_wave) : 0;
  memset(d, 0, sizeof *d);
  d->n = n;
  d->gsl_n = steps + 1;
  d->type = row->closed ? gsl_interp_cspline_periodic : gsl_interp_cspline;
  d->points = bench_malloc(n + 1, 2 * sizeof *d->points);
  d->knots = bench_malloc(n + 1, sizeof *d->knots);
  d->x = bench_malloc(n + 1, sizeof *d->x);
  d->y = bench_malloc(n + 1, sizeof *d->y);
  for (size_t k = 0; k < d->gsl_n; k++) {
    size_t i = row->closed && k == n ? 0 : k;
    double part = (row->closed ? 1 : 0.8) * (double)i / (double)steps;
    bench_wobble(TWO_PI * part, waves, d->points + 2 * k);
    d->x[k] = d->points[2 * k];
    d->y[k] = d->points[2 * k + 1];
  }
  set_knots(d);
  d->problem.field[PH_F_POINTS] = (struct ph_value){
      .kind = PH_VECTORS, .v = d->points, .n = n, .dimension = 2};
  d->method = row->mode ? &ph_method_tc : &ph_method_planar;
  d->problem.field[row->mode ? PH_F_MODE : PH_F_BASIS] = (struct ph_value){
      .kind = PH_WORD, .word = row->mode ? row->mode : row->basis};
  d->problem.field[PH_F_CLOSED] =
      (struct ph_value){.kind = PH_BOOL, .flag = row->closed};
}

static void data_free(struct data *d) {
  ph_arena_free(&d->out);
  ph_arena_free(&d->scratch);
  free(d->points);
  free(d->knots);
  free(d->x);
  free(d->y);
}

static void solve(struct data *d) {
  struct ph_result result = {0};
  struct ph_diag diag;
  if (d->method->solve(&d->problem, &d->out, &d->scratch, &result, &diag) !=
      PH_OK) {
    bench_die(diag.message);
  }
  d->steps = result.diagnostics.value[PH_D_ITERATIONS];
}

static void init_splines(struct data *d) {
  if (gsl_interp_init(d->spline[0], d->knots, d->x, d->gsl_n) ||
      gsl_interp_init(d->spline[1], d->knots, d->y, d->gsl_n)) {
    bench_die("GSL refuses the points");
  }
}

static void alloc_splines(struct data *d) {
  for (int i = 0; i < 2; i++) {
    d->spline[i] = gsl_interp_alloc(d->type, d->gsl_n);
    if (!d->spline[i]) {
      bench_die("out of memory");
    }
  }
}

static void free_splines(struct data *d) {
  gsl_interp_free(d->spline[0]);
  gsl_interp_free(d->spline[1]);
}

/* ---- the contenders --------------------------------------------------- */

static void ours_fresh(void *data) {
  struct data *d = data;
  solve(d);
  ph_arena_free(&d->out);
  ph_arena_free(&d->scratch);
}

static void gsl_fresh(void *data) {
  struct data *d = data;
  set_knots(d);
  alloc_splines(d);
  init_splines(d);
  free_splines(d);
}

static void ours_warm(void *data) {
  struct data *d = data;
  ph_arena_release(&d->out, d->out_start);
  ph_arena_release(&d->scratch, d->scratch_start);
  solve(d);
}

static void gsl_warm(void *data) {
  init_splines(data);
}

/* One chunk that any solution fits in, and its beginning to return to. */
static struct ph_mark reserve(struct ph_arena *arena, size_t n) {
  struct ph_mark start;
  if (!ph_arena_array(arena, n + ROOM_MIN, ROOM)) {
    bench_die("out of memory");
  }
  start = ph_arena_mark(arena);
  start.used = 0;
  return start;
}

/* ---- memory ----------------------------------------------------------- */

static double peak_bytes(void) {
  struct rusage usage;
  getrusage(RUSAGE_SELF, &usage);
  return 1024 * (double)usage.ru_maxrss;
}

/* What a solution takes at its peak beyond its points, bytes a point.  By a
 * child, as a peak never goes down; the parent must not have used memory that
 * the child could use again. */
static double peak_memory(const struct row *row, size_t n) {
  int ends[2];
  double bytes = 0;
  pid_t child;
  if (pipe(ends) != 0 || (child = fork()) < 0) {
    bench_die("cannot start a process");
  }
  if (child == 0) {
    struct data d;
    data_init(&d, row, n);
    bytes = -peak_bytes();
    solve(&d);
    bytes += peak_bytes();
    _exit(write(ends[1], &bytes, sizeof bytes) != (ssize_t)sizeof bytes);
  }
  if (read(ends[0], &bytes, sizeof bytes) != (ssize_t)sizeof bytes) {
    bench_die("cannot measure memory");
  }
  close(ends[0]);
  close(ends[1]);
  waitpid(child, NULL, 0);
  return bytes / (double)n;
}

/* ---- the table -------------------------------------------------------- */

/* A row of the table; ns a point of ours, warm. */
static double measure(const struct row *row, size_t n, double memory) {
  struct data d;
  struct bench_contender c[4] = {{ours_fresh, &d, 0},
                                 {gsl_fresh, &d, 0},
                                 {ours_warm, &d, 0},
                                 {gsl_warm, &d, 0}};
  int times = (int)((100000 + n - 1) / n), rounds = n < 1000000 ? 9 : 5;
  data_init(&d, row, n);
  bench_alternate(c, 2, rounds, times);
  d.out_start = reserve(&d.out, n);
  d.scratch_start = reserve(&d.scratch, n);
  alloc_splines(&d);
  bench_alternate(c + 2, 2, rounds, times);
  for (int i = 0; i < 4; i++) {
    c[i].best *= 1e9 / (double)n;
  }
  printf("  %-16s %8zu %5.0f %8.0f %6.0f %6.2f %8.0f %6.0f %6.2f %8.0f\n",
         row->name, n, d.steps, c[2].best, c[3].best, c[2].best / c[3].best,
         c[0].best, c[1].best, c[0].best / c[1].best, memory);
  fflush(stdout);
  free_splines(&d);
  data_free(&d);
  return c[2].best;
}

/* fit [NAME]: all curves, or those whose names contain NAME. */
int main(int argc, char **argv) {
  const char *name = argc > 1 ? argv[1] : "";
  double memory[ROWS][SIZES];
  double last[ROWS] = {0};
  gsl_set_error_handler_off();
  for (size_t i = 0; i < ROWS; i++) {
    for (size_t k = 0; strstr(rows[i].name, name) && k < SIZES; k++) {
      memory[i][k] = peak_memory(&rows[i], sizes[k]);
    }
  }
  puts("Fitting: the planar solver and two GSL cubic splines (x and y) through "
       "the\nsame points, processor ns a point, best of many runs\n");
  puts(
      "                                      warm memory          fresh memory"
      "         peak\n"
      "  curve              points steps     ours    GSL  ratio     ours    GSL"
      "  ratio  B/point");
  for (size_t i = 0; i < ROWS; i++) {
    for (size_t k = 0; strstr(rows[i].name, name) && k < SIZES; k++) {
      last[i] = measure(&rows[i], sizes[k], memory[i][k]);
    }
  }
  puts("\n  Target, warm, at 1000000 points: ratio <= 1.7 closed, 2 open, 3 "
       "with "
       "waves; tc g2:\n  1500 ns.  Steps and ns a point do not grow with the "
       "number of points.");
  if (last[0] > 0 && last[3] > 0) {
    printf(
        "  ATPH segments: %.2f times what PH quintics take (rows 4 and 1).\n",
        last[3] / last[0]);
  }
  return 0;
}
