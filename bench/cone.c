/* SPDX-License-Identifier: GPL-3.0-or-later */
/* cone: pairs of circular cones through random contact elements, and through
 * neighbours on a smooth surface, of which each is timed alone. */
#include "bench.h"
#include "solve/cone/cone.h"

enum { ELEMENTS = 10001, ROUNDS = 20 };

static void scatter(uint64_t *state, struct ph_contact_element *e) {
  ph_vec3 d;
  e->p = ph_vec3_of(bench_uniform(state, -0.5, 0.5),
                    bench_uniform(state, -0.5, 0.5),
                    bench_uniform(state, -0.5, 0.5));
  e->e = ph_vec3_unit(ph_vec3_of(bench_uniform(state, -1, 1),
                                 bench_uniform(state, -1, 1),
                                 bench_uniform(state, 0.1, 1)));
  d = ph_vec3_of(bench_uniform(state, -1, 1), bench_uniform(state, 0.1, 1),
                 bench_uniform(state, -1, 1));
  e->d = ph_vec3_unit(ph_vec3_normal(d, e->e));
  e->n = ph_vec3_cross(e->e, e->d);
}

/* A place of a row around the z axis, whose rulings waver. */
static void walk(double t, struct ph_contact_element *e) {
  const double w = 0.3 * sin(0.37 * t);
  e->p = ph_vec3_of(0.4 * cos(t), 0.4 * sin(t), 1e-5 * t);
  e->e = ph_vec3_of(-w * cos(t), -w * sin(t), sqrt(1 - w * w));
  e->d = ph_vec3_of(-sin(t), cos(t), 0);
  e->n = ph_vec3_cross(e->e, e->d);
}

static void measure(const char *name, const struct ph_contact_element *e) {
  double best = HUGE_VAL;
  size_t solved = 0;
  for (size_t round = 0; round < ROUNDS; round++) {
    const double start = bench_cpu();
    double time;
    solved = 0;
    for (size_t i = 0; i + 1 < ELEMENTS; i++) {
      struct ph_cone_pair pair;
      solved += ph_cone_pair(&e[i], &e[i + 1], (double)NAN, PH_CONE_DEGENERATE,
                             &pair) == PH_CONE_OK;
    }
    time = bench_cpu() - start;
    best = time < best ? time : best;
  }
  printf("%-12s%8.3f us a pair, %zu of %d have one\n", name,
         1e6 * best / (ELEMENTS - 1), solved, ELEMENTS - 1);
}

int main(void) {
  struct ph_contact_element *e = bench_malloc(ELEMENTS, sizeof *e);
  uint64_t state = 1;
  printf("Pairs of circular cones between two contact elements\n");
  for (size_t i = 0; i < ELEMENTS; i++) {
    scatter(&state, &e[i]);
  }
  measure("anywhere", e);
  for (size_t i = 0; i < ELEMENTS; i++) {
    walk(0.05 * (double)i, &e[i]);
  }
  measure("neighbours", e);
  free(e);
  return 0;
}
