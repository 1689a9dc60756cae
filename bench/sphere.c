/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * sphere: what splines on the sphere take.
 *
 *   sphere            random paths without tension: how many have a spline;
 *                     tracks with noise, whose shape is kept; a segment
 *   sphere smooth     long smooth tracks, one line of numbers for each row:
 *                     MODEL SHAPE N SECONDS CERTIFICATE ITERATIONS RAISED
 *
 * Every curve is certified.  Times are those of the solver alone, without the
 * certificate unless said.
 */
#include "spatial.h"

#include "base/mem.h"
#include "check/certify.h"
#include "curve/segment/spherical.h"
#include "kernel/pi.h"
#include "kernel/s2.h"
#include "solve/method.h"

#include <gsl/gsl_errno.h>
#include <string.h>

enum { SEED = 1 };

static const char *const models[] = {"exact", "nielson"};

/* ---- one problem --------------------------------------------------------- */

struct run {
  struct ph_problem problem;
  struct ph_result result;
  struct ph_diag diag;
  enum ph_status status;
  struct ph_arena out, scratch;
};

static struct run run_of(double *points, size_t n, const char *model,
                         bool shape) {
  struct run run = {.status = PH_OK};
  run.problem.field[PH_F_POINTS] = (struct ph_value){
      .kind = PH_VECTORS, .v = points, .n = n, .dimension = 3};
  run.problem.field[PH_F_MODEL] =
      (struct ph_value){.kind = PH_WORD, .word = model};
  run.problem.field[PH_F_SHAPE] =
      (struct ph_value){.kind = PH_BOOL, .flag = shape};
  return run;
}

static void solve(void *data) {
  struct run *run = data;
  ph_arena_reset(&run->out);
  memset(&run->result, 0, sizeof run->result);
  run->status = ph_method_sphere.solve(&run->problem, &run->out, &run->scratch,
                                       &run->result, &run->diag);
}

static void certify(void *data) {
  struct run *run = data;
  if (run->status == PH_OK) {
    run->status =
        ph_certify("sphere", &run->problem, &run->result.curve, &run->scratch,
                   &run->result.diagnostics, &run->diag);
  }
}

static void finish(struct run *run) {
  ph_arena_free(&run->out);
  ph_arena_free(&run->scratch);
}

/* Nodes with tension. */
static size_t raised(const struct run *run, size_t n) {
  size_t sum = 0;
  for (size_t i = 0; i < n; i++) {
    sum += run->result.curve.sphere.tensions[i] > 0;
  }
  return sum;
}

static double iterations(const struct run *run) {
  return run->result.diagnostics.value[PH_D_ITERATIONS];
}

/* ---- tracks -------------------------------------------------------------- */

enum track { SMOOTH, WALK, NOISE, TRACKS };
static const char *const tracks[] = {"smooth", "walk", "noise"};

/* A normal number, nearly. */
static double normal(uint64_t *state) {
  double sum = 0;
  for (int i = 0; i < 12; i++) {
    sum += bench_uniform(state, -0.5, 0.5);
  }
  return sum;
}

static ph_vec3 lonlat(double lon, double lat) {
  ph_cplx a = ph_cplx_polar(lon), b = ph_cplx_polar(lat);
  return ph_vec3_of(b.re * a.re, b.re * a.im, b.im);
}

/* From `at', facing with `left' to the left: turn, then go. */
static void go(ph_vec3 *at, ph_vec3 *left, double turn, double step) {
  ph_cplx t = ph_cplx_polar(turn), s = ph_cplx_polar(step);
  ph_vec3 on = ph_vec3_cross(*left, *at);
  *left = ph_vec3_along(ph_vec3_scale(t.re, *left), -t.im, on);
  on = ph_vec3_cross(*left, *at);
  *at = ph_vec3_unit(ph_vec3_along(ph_vec3_scale(s.re, *at), s.im, on));
  *left = ph_vec3_unit(ph_vec3_normal(*left, *at));
}

/* n points: smooth, steps of about 0.06; a walk, steps of 0.01 to 0.03 that
 * turn by 0.5 or so; a smooth track of such steps with noise of 0.001. */
static double *track_of(enum track kind, size_t n) {
  double *v = bench_malloc(n, 3 * sizeof *v);
  uint64_t state = SEED;
  ph_vec3 at = {1, 0, 0}, left = {0, 0, 1};
  for (size_t i = 0; i < n; i++) {
    double t = (double)i * (kind == SMOOTH ? 0.063 : 0.01);
    double rise = kind == SMOOTH ? 0.4 : 0.5;
    double noise = kind == NOISE ? 0.001 : 0, lon = t + noise * normal(&state);
    double lat = rise * sin(0.7 * t) + noise * normal(&state);
    ph_vec3_put(kind == WALK ? at : lonlat(lon, lat), 3, v + 3 * i);
    go(&at, &left, 0.5 * normal(&state), bench_uniform(&state, 0.01, 0.03));
  }
  return v;
}

static void smooth_row(size_t n, const char *model, bool shape) {
  double *points = track_of(SMOOTH, n);
  struct run run = run_of(points, n, model, shape);
  struct bench_contender c[] = {{solve, &run, 0}, {certify, &run, 0}};
  bench_alternate(c, 2, n <= 10000 ? 7 : n <= 100000 ? 3 : 1, 1);
  if (run.status != PH_OK) {
    bench_die(run.diag.message);
  }
  printf("%s %s %zu %.9g %.9g %.0f %zu\n", model, shape ? "true" : "false", n,
         c[0].best, c[1].best, iterations(&run), raised(&run, n));
  fflush(stdout);
  finish(&run);
  free(points);
}

static void smooth(void) {
  static const size_t sizes[] = {1000, 10000, 100000, 1000000};
  for (size_t m = 0; m < 2; m++) {
    for (int shape = 0; shape < 2; shape++) {
      for (size_t i = 0; i < sizeof sizes / sizeof sizes[0]; i++) {
        smooth_row(sizes[i], models[m], shape);
      }
    }
  }
}

static void noisy_table(void) {
  static const size_t sizes[] = {1000, 10000};
  puts("Tracks whose shape is kept: smooth, a random walk, and with noise; "
       "model exact,\nprocessor us a node\n\n"
       "  track         N   solve   cert.    its.  raised  sum of tensions");
  for (int kind = SMOOTH; kind < TRACKS; kind++) {
    for (size_t i = 0; i < sizeof sizes / sizeof sizes[0]; i++) {
      size_t n = sizes[i];
      double *points = track_of((enum track)kind, n), unit = 1e6 / (double)n;
      struct run run = run_of(points, n, models[0], true);
      struct bench_contender c[] = {{solve, &run, 0}, {certify, &run, 0}};
      bench_alternate(c, 2, 1, 1);
      printf("  %-7s %7zu %7.1f %7.1f ", tracks[kind], n, unit * c[0].best,
             unit * c[1].best);
      if (run.status == PH_OK) {
        printf("%7.0f %7zu %16.6g\n", iterations(&run), raised(&run, n),
               run.result.diagnostics.value[PH_D_TENSION_SUM]);
      } else {
        printf("%s %s\n", run.diag.field, run.diag.message);
      }
      fflush(stdout);
      finish(&run);
      free(points);
    }
  }
}

/* ---- random paths -------------------------------------------------------- */

enum { PATHS = 1000, PATH = 8 };

struct tally {
  size_t solved, refused;
  double seconds, worst, iterations, most;
};

static void path_of(uint64_t *state, double least, double most,
                    double points[3 * PATH]) {
  ph_vec3 at = bench_direction(state);
  for (size_t i = 0; i < PATH; i++) {
    ph_vec3 left = ph_vec3_unit(ph_vec3_cross(at, bench_direction(state)));
    ph_vec3_put(at, 3, points + 3 * i);
    go(&at, &left, 0, bench_uniform(state, least, most));
  }
}

static struct tally paths(const char *model, double least, double most) {
  struct tally t = {0, 0, 0, 0, 0, 0};
  uint64_t state = SEED;
  for (size_t i = 0; i < PATHS; i++) {
    double points[3 * PATH], seconds;
    struct run run = run_of(points, PATH, model, false);
    path_of(&state, least, most, points);
    seconds = bench_cpu();
    solve(&run);
    seconds = bench_cpu() - seconds;
    t.seconds += seconds;
    t.worst = seconds > t.worst ? seconds : t.worst;
    if (run.status == PH_OK) {
      t.iterations += iterations(&run);
      t.most = iterations(&run) > t.most ? iterations(&run) : t.most;
      certify(&run);
      t.refused += run.status != PH_OK;
      t.solved += run.status == PH_OK;
    }
    finish(&run);
  }
  return t;
}

static void paths_table(void) {
  static const double steps[][2] = {
      {0.1, 1.57}, {0.1, 2.2}, {0.5, 2.2}, {0.1, 3}, {2, 3}};
  printf(
      "%d random paths each of %d points, no tension\n\n"
      "  steps        model     solved  refused   its.  most   mean us   max "
      "us\n",
      PATHS, PATH);
  for (size_t i = 0; i < sizeof steps / sizeof steps[0]; i++) {
    for (size_t m = 0; m < 2; m++) {
      struct tally t = paths(models[m], steps[i][0], steps[i][1]);
      printf("  %3.1f .. %4.2f  %-8s %7zu  %7zu %6.1f %5.0f %9.0f %8.0f\n",
             steps[i][0], steps[i][1], models[m], t.solved, t.refused,
             t.iterations / (double)(t.solved + t.refused), t.most,
             1e6 * t.seconds / PATHS, 1e6 * t.worst);
    }
  }
  puts("\n  Target: all to 2.2 and 950 to 3 with the model exact.  refused: by "
       "the\n  certificate, not counted as solved.\n");
}

/* ---- a segment ----------------------------------------------------------- */

enum { BATCH = 1024 };

struct batch {
  struct ph_spherical segment[BATCH];
  double out[BATCH];
  struct ph_arena arena;
};

static void numerators(void *data) {
  struct batch *b = data;
  for (size_t i = 0; i < BATCH; i++) {
    double k[2];
    ph_spherical_numerator(&b->segment[i], ((double)i + 0.5) / BATCH, k);
    b->out[i] = k[0] + k[1];
  }
}

static void numerators_start(void *data) {
  struct batch *b = data;
  for (size_t i = 0; i < BATCH; i++) {
    b->out[i] = ph_spherical_numerator_start(&b->segment[i]);
  }
}

static void lengths(void *data) {
  struct batch *b = data;
  struct ph_primitive table = {.n = 0};
  ph_arena_reset(&b->arena);
  for (size_t i = 0; i < BATCH; i++) {
    if (ph_spherical_length(&b->segment[i], &table, &b->arena, &b->out[i]) !=
        PH_OK) {
      bench_die("no length");
    }
  }
}

/* Segments of a spline through a walk with steps of so much. */
static void batch_of(double step, struct batch *b) {
  double *v = bench_malloc(BATCH + 1, 3 * sizeof *v);
  uint64_t state = SEED;
  ph_vec3 at = {1, 0, 0}, left = {0, 0, 1};
  struct run run = run_of(v, BATCH + 1, models[0], false);
  for (size_t i = 0; i <= BATCH; i++) {
    ph_vec3_put(at, 3, v + 3 * i);
    go(&at, &left, 0.5 * normal(&state), step);
  }
  solve(&run);
  if (run.status != PH_OK) {
    bench_die(run.diag.message);
  }
  for (size_t k = 0; k < BATCH; k++) {
    b->segment[k] = ph_spherical_of(&run.result.curve, k);
  }
  finish(&run);
  free(v);
}

static void segment_table(void) {
  static const double steps[] = {0.01, 0.1, 1};
  static const char *const names[] = {"K, K'", "K at t = 0", "length"};
  static const struct ph_arena empty;
  struct batch *b = bench_malloc(1, sizeof *b);
  struct bench_contender c[] = {
      {numerators, b, 0}, {numerators_start, b, 0}, {lengths, b, 0}};
  double ns[3][3];
  b->arena = empty;
  for (size_t j = 0; j < 3; j++) {
    batch_of(steps[j], b);
    bench_alternate(c, 3, 9, 4);
    for (size_t i = 0; i < 3; i++) {
      ns[i][j] = 1e9 * c[i].best / BATCH;
    }
  }
  puts("\nA segment of so long a step, processor ns, the best of many runs\n\n"
       "                   0.01      0.1        1");
  for (size_t i = 0; i < 3; i++) {
    printf("  %-12s %8.0f %8.0f %8.0f\n", names[i], ns[i][0], ns[i][1],
           ns[i][2]);
  }
  ph_arena_free(&b->arena);
  free(b);
}

int main(int argc, char **argv) {
  gsl_set_error_handler_off();
  if (argc > 1 && strcmp(argv[1], "smooth") == 0) {
    smooth();
    return 0;
  }
  paths_table();
  noisy_table();
  segment_table();
  return 0;
}
