/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * arclength: what C2 splines with prescribed arc lengths take, and how near
 * they come to the curve that the data are from.
 *
 *   arclength                the data of [HUA14], and samples of smooth curves
 *   arclength paper          only the former, as bench/arclength_ipopt has them
 *   arclength tables FILE..  the problems of JSON Lines, each with the F of its
 *                            `meta' beside; and the smooth curves, many sizes
 *   arclength perturbed [N]  samples with perturbed lengths (10000): solved or
 *                            refused, never a wrong curve
 *
 * Every curve is certified.  Times are those of the solver alone.
 */
#include "arclength.h"
#include "curves.h"

#include "base/mem.h"
#include "check/certify.h"
#include "io/json_in.h"
#include "kernel/bern.h"
#include "solve/method.h"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_interp.h>

enum { SEED = 1, UNEVEN = 4 /* of bench_curves: smooth3 */ };

/* ---- one problem ------------------------------------------------------ */

struct run {
  struct ph_problem problem;
  struct ph_result result;
  struct ph_diag diag;
  enum ph_status status, certificate;
  struct ph_arena out, scratch;
};

static void solve(void *data) {
  struct run *run = data;
  ph_arena_reset(&run->out);
  memset(&run->result, 0, sizeof run->result);
  run->status = ph_method_arclength.solve(
      &run->problem, &run->out, &run->scratch, &run->result, &run->diag);
  ph_arena_reset(&run->scratch);
}

static void certify(struct run *run) {
  run->certificate =
      ph_certify("arclength", &run->problem, &run->result.curve, &run->scratch,
                 &run->result.diagnostics, &run->diag);
  ph_arena_reset(&run->scratch);
}

/* Solves, certifies; the least seconds of so many rounds. */
static double measure(struct run *run, int rounds) {
  struct bench_contender c = {solve, run, 0};
  bench_alternate(&c, 1, rounds, 1);
  if (run->status == PH_OK) {
    certify(run);
  }
  return c.best;
}

static void finish(struct run *run) {
  ph_arena_free(&run->out);
  ph_arena_free(&run->scratch);
}

static bool is_solved(const struct run *run) {
  return run->status == PH_OK && run->certificate == PH_OK;
}

static double value(const struct run *run, enum ph_diagnostic which) {
  return run->result.diagnostics.value[which];
}

static const char *outcome(const struct run *run) {
  return run->status != PH_OK ? ph_status_code(run->status)
         : run->certificate != PH_OK
             ? "WRONG"
             : ph_outcome_name((enum ph_outcome)value(run, PH_D_SECOND_ORDER));
}

static void set_vectors(struct run *run, enum ph_field_id id, double *v,
                        size_t n) {
  run->problem.field[id] =
      (struct ph_value){.kind = PH_VECTORS, .v = v, .n = n, .dimension = 3};
}

static void set_numbers(struct run *run, enum ph_field_id id, double *v,
                        size_t n) {
  run->problem.field[id] =
      (struct ph_value){.kind = PH_NUMBERS, .v = v, .n = n, .dimension = 1};
}

static void set_number(struct run *run, enum ph_field_id id, double number) {
  run->problem.field[id] =
      (struct ph_value){.kind = PH_NUMBER, .number = number};
}

static void set_word(struct run *run, enum ph_field_id id, const char *word) {
  run->problem.field[id] = (struct ph_value){.kind = PH_WORD, .word = word};
}

/* ---- the data of HUA14 ------------------------------------------------ */

static void paper(void) {
  for (size_t kind = 0; kind < BENCH_ARC_KINDS; kind++) {
    for (size_t i = 0; i < BENCH_ARC_SIZES; i++) {
      struct bench_arc data = bench_arc_of(kind, bench_arc_sizes[i]);
      struct run run = {.status = PH_OK};
      double seconds;
      set_vectors(&run, PH_F_POINTS, data.points, data.n + 1);
      set_numbers(&run, PH_F_LENGTHS, data.lengths, data.n);
      set_number(&run, PH_F_REFINE, 1);
      set_word(&run, PH_F_KNOTS, "uniform");
      seconds = measure(&run, 5);
      printf("%s %zu ", bench_arc_kinds[kind], data.n);
      if (is_solved(&run)) {
        printf("%.9g", value(&run, PH_D_F));
      } else {
        putchar('-');
      }
      printf(" %.0f %.9g\n", is_solved(&run) ? value(&run, PH_D_ITERATIONS) : 0,
             seconds);
      finish(&run);
      bench_arc_free(&data);
    }
  }
}

/* All fields but data and lengths by default. */
static void typical(void) {
  struct bench_arc data = bench_arc_of(0, 5);
  struct run run = {.status = PH_OK};
  double seconds;
  set_vectors(&run, PH_F_POINTS, data.points, data.n + 1);
  set_numbers(&run, PH_F_LENGTHS, data.lengths, data.n);
  seconds = measure(&run, 50);
  printf("Helix, N = 5, exact lengths, all by default: %.3f ms, %.0f "
         "iterations, %s, F %.9g.\nTarget: 0.5 ms.\n\n",
         1e3 * seconds, value(&run, PH_D_ITERATIONS), outcome(&run),
         value(&run, PH_D_F));
  finish(&run);
  bench_arc_free(&data);
}

/* ---- smooth curves ---------------------------------------------------- */

enum mode { POINTS, RELAXED, TANGENTS, DERIVATIVES };
static const char *const mode_names[] = {"points", "relaxed", "tangents",
                                         "derivs"};

/* What a row is about. */
struct row {
  const struct bench_curve *curve;
  size_t n;
  enum mode mode;
  int refine;
  bool even;         /* intervals are equally long */
  const char *knots; /* NULL: by default */
};

/* The field that says how the curve is given at the knots.  Derivatives are
 * tangents times the mean length. */
static void set_sample(struct run *run, const struct bench_sample *s,
                       const struct row *row, double *vectors) {
  double mean = 0;
  set_number(run, PH_F_REFINE, row->refine);
  if (row->knots) {
    set_word(run, PH_F_KNOTS, row->knots);
  }
  if (row->mode != RELAXED) {
    set_numbers(run, PH_F_LENGTHS, s->lengths, s->n);
  }
  if (row->mode == POINTS || row->mode == RELAXED) {
    set_vectors(run, PH_F_POINTS, s->points, s->n + 1);
    return;
  }
  for (size_t i = 0; i < s->n; i++) {
    mean += s->lengths[i] / (double)s->n;
  }
  for (size_t i = 0; i < 3 * s->n + 3; i++) {
    vectors[i] =
        row->mode == DERIVATIVES ? mean * s->tangents[i] : s->tangents[i];
  }
  set_vectors(run, row->mode == DERIVATIVES ? PH_F_DERIVATIVES : PH_F_TANGENTS,
              vectors, s->n + 1);
  set_numbers(run, PH_F_START, s->points, 3);
}

/* How far the spline is from the curve, eight times in each segment. */
static double deviation(const struct bench_sample *s,
                        const struct ph_curve *curve) {
  size_t refine = curve->n / s->n;
  double worst = 0;
  for (size_t k = 0; k < curve->n; k++) {
    const double *p = curve->control_points + 18 * k, *t = s->t + k / refine;
    for (int j = 1; j <= 8; j++) {
      double u = j / 8.0, basis[6], d;
      double f = ((double)(k % refine) + u) / (double)refine;
      ph_vec3 q = {0, 0, 0};
      ph_bern_basis(5, u, basis);
      for (size_t i = 0; i < 6; i++) {
        q = ph_vec3_along(q, basis[i], ph_vec3_get(p + 3 * i, 3));
      }
      d = bench_curve_distance(&s->curve, q, t[0] + (t[1] - t[0]) * f);
      worst = d <= worst ? worst : d;
    }
  }
  return worst;
}

/* The same of the natural cubic spline by chord length. */
static double cubic_deviation(const struct bench_sample *s) {
  size_t n = s->n + 1;
  double *knots = bench_malloc(4 * n, sizeof *knots), worst = 0;
  gsl_interp *spline[3];
  for (size_t i = 1; i < n; i++) {
    ph_vec3 p = ph_vec3_get(s->points + 3 * i, 3);
    knots[i] =
        knots[i - 1] +
        ph_vec3_abs(ph_vec3_sub(p, ph_vec3_get(s->points + 3 * i - 3, 3)));
  }
  for (size_t c = 0; c < 3; c++) {
    double *x = knots + (c + 1) * n;
    for (size_t i = 0; i < n; i++) {
      x[i] = s->points[3 * i + c];
    }
    spline[c] = gsl_interp_alloc(gsl_interp_cspline, n);
    if (!spline[c] || gsl_interp_init(spline[c], knots, x, n)) {
      bench_die("no cubic spline");
    }
  }
  for (size_t k = 0; k < 16 * s->n; k++) {
    size_t i = k / 16;
    double f = (double)(k % 16) / 16, at, v[3], d;
    at = knots[i] + (knots[i + 1] - knots[i]) * f;
    for (size_t c = 0; c < 3; c++) {
      v[c] = gsl_interp_eval(spline[c], knots, knots + (c + 1) * n, at, NULL);
    }
    d = bench_curve_distance(&s->curve, ph_vec3_get(v, 3),
                             s->t[i] + (s->t[i + 1] - s->t[i]) * f);
    worst = d <= worst ? worst : d;
  }
  for (size_t c = 0; c < 3; c++) {
    gsl_interp_free(spline[c]);
  }
  free(knots);
  return worst;
}

static void smooth_head(void) {
  puts("  curve    mode     r       N  its.         ms  us/int.  F            "
       "outcome         deviation     cubic  ratio");
}

static void smooth_row(const struct row *row) {
  struct bench_sample s = bench_sample_of(row->curve, row->n, row->even);
  double *vectors = bench_malloc(row->n + 1, 3 * sizeof *vectors), seconds;
  struct run run = {.status = PH_OK};
  set_sample(&run, &s, row, vectors);
  seconds = measure(&run, row->n <= 200 ? 5 : row->n <= 2000 ? 3 : 1);
  printf("  %-8s %-8s %d %7zu ", row->curve->name, mode_names[row->mode],
         row->refine, row->n);
  if (is_solved(&run)) {
    double ours = deviation(&s, &run.result.curve);
    double cubic = cubic_deviation(&s);
    printf("%5.0f %10.3f %8.2f  %-12.7g %-14s %10.1e %9.1e %6.1f\n",
           value(&run, PH_D_ITERATIONS), 1e3 * seconds,
           1e6 * seconds / (double)row->n, value(&run, PH_D_F), outcome(&run),
           ours, cubic, cubic / ours);
  } else {
    printf("    - %10.3f %8.2f  %-12s %s\n", 1e3 * seconds,
           1e6 * seconds / (double)row->n, "-", outcome(&run));
  }
  fflush(stdout);
  finish(&run);
  free(vectors);
  bench_sample_free(&s);
}

static void smooth_table(void) {
  static const size_t sizes[] = {20, 200, 2000, 20000, 100000};
  uint64_t state = SEED;
  const struct bench_curve random = bench_curve_random(&state);
  const struct bench_curve *curves[] = {&bench_curves[0], &bench_curves[1],
                                        &bench_curves[2], &random};
  puts("Samples of smooth curves, all certified; processor time.  r: segments "
       "in each\ninterval.  deviation: from the curve that was sampled; cubic: "
       "that of the natural\ncubic spline by chord length.\n");
  smooth_head();
  for (size_t c = 0; c < sizeof curves / sizeof curves[0]; c++) {
    for (size_t i = 0; i < 4; i++) {
      struct row row = {curves[c], sizes[i], POINTS, 2, true, NULL};
      smooth_row(&row);
    }
  }
  for (int mode = RELAXED; mode <= TANGENTS; mode++) {
    for (size_t i = 0; i < 5; i++) {
      struct row row = {
          &bench_curves[2], sizes[i], (enum mode)mode, 1, true, NULL};
      smooth_row(&row);
    }
  }
  puts("\n  Targets: at most 20 iterations; us/int. the same within 2 times; "
       "150 ms for\n  N = 2000; ratio at least 5.");
}

/* ---- the tables of the specification ---------------------------------- */

/* The number after "F": in meta; NaN if there is none. */
static double known_f(const struct ph_echo *echo) {
  static const char name[] = "\"F\":";
  for (size_t i = 0; i + sizeof name <= echo->meta_n; i++) {
    if (!memcmp(echo->meta + i, name, sizeof name - 1)) {
      return strtod(echo->meta + i + sizeof name - 1, NULL);
    }
  }
  return (double)NAN;
}

/* Other minima that some start led to, after the best one. */
static void print_others(const struct ph_result *result) {
  const char *between = "  ";
  for (size_t i = 0; i < result->solutions_n; i++) {
    const struct ph_solution *s = &result->solutions[i];
    double f = s->diagnostics.value[PH_D_F];
    if (i > 0) {
      printf("%s%.7g", between, f);
      between = ", ";
    }
  }
  putchar('\n');
}

static void problem_row(const char *text, size_t n) {
  struct run run = {.status = PH_OK};
  struct ph_arena arena = {0};
  struct ph_record record = {.text = text, .n = n};
  struct ph_echo echo = {0};
  double seconds, known;
  if (ph_json_in(&record, &ph_method_arclength.schema, &arena, &run.problem,
                 &echo, &run.diag) != PH_OK) {
    bench_die(run.diag.message);
  }
  known = known_f(&echo);
  seconds = measure(&run, 3);
  printf("  %-52.*s %12.10g ", (int)echo.id_n, echo.id, known);
  if (is_solved(&run)) {
    const struct ph_result *r = &run.result;
    printf("%12.10g %9.1e %5.0f %8.3f %-9s %s", value(&run, PH_D_F),
           value(&run, PH_D_F) / known - 1, value(&run, PH_D_ITERATIONS),
           1e3 * seconds, outcome(&run),
           r->starts_n ? r->starts[r->start].name : "");
    run.problem.field[PH_F_ALL_MINIMA] =
        (struct ph_value){.kind = PH_BOOL, .flag = true};
    solve(&run);
    print_others(&run.result);
  } else {
    printf("%12s %26.3f %s\n", "-", 1e3 * seconds, outcome(&run));
  }
  finish(&run);
  ph_arena_free(&arena);
}

static void problem_table(const char *path) {
  static char line[1 << 16];
  FILE *file = fopen(path, "r");
  if (!file) {
    bench_die("cannot read the file");
  }
  printf("%s\n\n  %-52s %12s %12s %9s %5s %8s %s\n", path, "problem", "known F",
         "F", "apart", "its.", "ms", "outcome, start  other minima");
  while (fgets(line, sizeof line, file)) {
    problem_row(line, strlen(line));
  }
  fclose(file);
  putchar('\n');
}

static void tables(char **paths) {
  static const size_t sizes[] = {5, 20, 200, 2000};
  for (; *paths; paths++) {
    problem_table(*paths);
  }
  smooth_head();
  for (size_t c = 0; c < BENCH_CURVES; c++) {
    for (size_t i = 0; i < 4; i++) {
      struct row row = {&bench_curves[c], sizes[i],
                        RELAXED,          1,
                        c != UNEVEN,      c != UNEVEN ? "uniform" : NULL};
      smooth_row(&row);
      row.refine = 2;
      smooth_row(&row);
      row.mode = POINTS;
      smooth_row(&row);
    }
  }
  for (int mode = TANGENTS; mode <= DERIVATIVES; mode++) {
    for (size_t i = 1; i < 4; i++) {
      struct row row = {&bench_curves[2], sizes[i], (enum mode)mode, 2, true,
                        "uniform"};
      smooth_row(&row);
    }
  }
}

/* ---- perturbed lengths ------------------------------------------------ */

/* What became of the data with one size of perturbation. */
struct tally {
  double size;
  size_t n, solved, saddles, below, infeasible, no_solution, other, wrong;
  double seconds, worst; /* of one */
};

static void perturbed_one(struct tally *t, uint64_t *state) {
  const struct bench_curve curve = bench_curve_random(state);
  size_t n = 5 + (size_t)(bench_random(state) % 8);
  struct bench_sample s = bench_sample_of(&curve, n, false);
  struct row row = {&curve, n, POINTS, 2, false, NULL};
  struct run run = {.status = PH_OK};
  bool below = false;
  double seconds;
  for (size_t i = 0; i < n; i++) {
    double u = (double)(bench_random(state) >> 11) * 0x1p-52 - 1;
    ph_vec3 p = ph_vec3_get(s.points + 3 * i, 3);
    ph_vec3 q = ph_vec3_get(s.points + 3 * i + 3, 3);
    s.lengths[i] *= 1 + t->size * u;
    below = below || s.lengths[i] < ph_vec3_abs(ph_vec3_sub(q, p));
  }
  set_sample(&run, &s, &row, NULL);
  seconds = measure(&run, 1);
  t->n++;
  t->below += below;
  t->seconds += seconds;
  t->worst = seconds <= t->worst ? t->worst : seconds;
  t->solved += is_solved(&run) && !below;
  t->saddles +=
      is_solved(&run) &&
      (enum ph_outcome)value(&run, PH_D_SECOND_ORDER) == PH_OUTCOME_SADDLE;
  t->infeasible += run.status == PH_E_INFEASIBLE;
  t->no_solution += run.status == PH_E_NO_CONVERGENCE;
  t->other += run.status != PH_OK && run.status != PH_E_INFEASIBLE &&
              run.status != PH_E_NO_CONVERGENCE;
  if (run.status == PH_OK && (run.certificate != PH_OK || below)) {
    t->wrong++;
    printf("  wrong: datum %zu, %s\n", t->n, run.diag.message);
  }
  finish(&run);
  bench_sample_free(&s);
}

static void perturbed(size_t n) {
  static const double sizes[] = {0.001, 0.01, 0.1};
  uint64_t state = SEED;
  printf("%zu samples of random smooth curves, 5 to 12 intervals, lengths "
         "perturbed by up\nto so much; all curves are certified\n\n"
         "  perturbed  data    solved  saddles  < chord  infeasible  "
         "no solution  else  wrong  mean ms   max ms\n",
         n);
  for (size_t k = 0; k < 3; k++) {
    struct tally t = {.size = sizes[k]};
    for (size_t i = 0; i < (n + 2 - k) / 3; i++) {
      perturbed_one(&t, &state);
    }
    printf("  %7.1f %%  %5zu  %6.2f %%  %7zu  %7zu  %10zu  %11zu  %4zu  %5zu "
           "%8.2f %8.1f\n",
           100 * t.size, t.n, 100 * (double)t.solved / (double)t.n, t.saddles,
           t.below, t.infeasible, t.no_solution, t.other, t.wrong,
           1e3 * t.seconds / (double)t.n, 1e3 * t.worst);
  }
  puts("\n  Target: none wrong; infeasible are those with a length below its "
       "chord.");
}

int main(int argc, char **argv) {
  const char *mode = argc > 1 ? argv[1] : "";
  gsl_set_error_handler_off();
  if (!strcmp(mode, "paper")) {
    paper();
  } else if (!strcmp(mode, "tables")) {
    tables(argv + 2);
  } else if (!strcmp(mode, "perturbed")) {
    perturbed(argc > 2 ? strtoul(argv[2], NULL, 10) : 10000);
  } else {
    typical();
    smooth_table();
  }
  return 0;
}
