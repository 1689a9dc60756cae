/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * bubble: a torus with noise, of continuity 1 and 2, as polynomials and exact:
 * the surface and its certificate are timed on one processor; then the surface
 * on two, by the clock on the wall.
 */
#include "bench.h"

#include "check/certify.h"
#include "solve/method.h"

#include <stdatomic.h>

enum { ROUND = 96, ACROSS = 48, FACES = ROUND * ACROSS, TIMES = 3 };

static const double TWO_PI = 6.283185307179586;

struct run {
  double x[FACES][3], corner[FACES][4];
  size_t sizes[FACES];
  struct ph_problem problem;
  struct ph_arena out, scratch;
  struct ph_result result;
  struct ph_diag diag;
};

static size_t at(size_t i, size_t j) {
  return i % ROUND * ACROSS + j % ACROSS;
}

static void set(struct run *r) {
  struct ph_value *field = r->problem.field;
  uint64_t state = 1;
  for (size_t f = 0; f < FACES; f++) {
    const size_t i = f / ACROSS, j = f % ACROSS;
    const double u = TWO_PI * (double)i / ROUND,
                 v = TWO_PI * (double)j / ACROSS;
    const double thick = bench_uniform(&state, 0.998, 1.002);
    const double far = 2 + thick * cos(v);
    const size_t corner[] = {at(i, j), at(i + 1, j), at(i + 1, j + 1),
                             at(i, j + 1)};
    r->x[f][0] = far * cos(u);
    r->x[f][1] = far * sin(u);
    r->x[f][2] = thick * sin(v);
    for (size_t k = 0; k < 4; k++) {
      r->corner[f][k] = (double)corner[k];
    }
    r->sizes[f] = 4;
  }
  field[PH_F_POINTS] = (struct ph_value){
      .kind = PH_VECTORS, .v = r->x[0], .n = FACES, .dimension = 3};
  field[PH_F_FACES] = (struct ph_value){.kind = PH_LISTS,
                                        .v = r->corner[0],
                                        .n = (size_t)4 * FACES,
                                        .dimension = 1,
                                        .sizes = r->sizes,
                                        .sizes_n = FACES};
}

static double wall(void) {
  struct timespec t;
  clock_gettime(CLOCK_MONOTONIC, &t);
  return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static void check(const struct run *r, enum ph_status status) {
  if (status != PH_OK) {
    bench_die(r->diag.message);
  }
}

static void solve(struct run *r) {
  ph_arena_reset(&r->out);
  r->result = (struct ph_result){.curve = {.n = 0}};
  check(r, ph_method_bubble.solve(&r->problem, &r->out, &r->scratch, &r->result,
                                  &r->diag));
}

static void certify(struct run *r) {
  check(r, ph_certify("bubble", &r->problem, &r->result.curve, &r->scratch,
                      &r->result.diagnostics, &r->diag));
}

/* The least seconds of some runs. */
static double best(struct run *r, void (*make)(struct run *r),
                   double (*now)(void)) {
  double least = HUGE_VAL;
  for (int i = 0; i < TIMES; i++) {
    const double start = now();
    double time;
    make(r);
    time = now() - start;
    least = time < least ? time : least;
  }
  return least;
}

static void row(struct run *r, double continuity, bool exact) {
  const double each = 1e6 / FACES;
  double *value = r->result.diagnostics.value;
  double solved, checked;
  struct ph_value *field = r->problem.field;
  field[PH_F_CONTINUITY] =
      (struct ph_value){.kind = PH_NUMBER, .number = continuity};
  field[PH_F_DEGREE] =
      (struct ph_value){.kind = PH_WORD, .word = exact ? "exact" : "auto"};
  solved = best(r, solve, bench_cpu);
  checked = best(r, certify, bench_cpu);
  printf("  G%.0f %-6s %9.1f %9.1f %9.1f %10.1e\n", continuity,
         exact ? "exact" : "auto", each * solved, each * checked,
         each * (solved + checked), value[PH_D_NORMAL_JUMP]);
}

/* With two processors against one. */
static void spread(struct run *r) {
  atomic_int spare = 0;
  struct ph_budget budget = {.spare = &spare};
  double one, two;
  r->out.budget = &budget;
  one = best(r, solve, wall);
  atomic_store(&spare, 1);
  two = best(r, solve, wall);
  r->out.budget = NULL;
  printf("  the last one on two processors: %.1f us a face of wall time, %.2f "
         "times as fast\n",
         1e6 * two / FACES, one / two);
}

int main(void) {
  struct run *r = bench_malloc(1, sizeof *r);
  printf("Bubble patches, a torus with noise of %d faces; processor us a face\n"
         "\n             surface     cert.      both       jump\n",
         FACES);
  set(r);
  for (int exact = 0; exact < 2; exact++) {
    for (int continuity = 1; continuity < 3; continuity++) {
      row(r, continuity, exact);
    }
  }
  spread(r);
  printf("\n  Target: G1 100 us, G2 300 us, 1.7 times as fast on two free "
         "processors.\n");
  ph_arena_free(&r->out);
  ph_arena_free(&r->scratch);
  free(r);
  return 0;
}
