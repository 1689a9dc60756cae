/* SPDX-License-Identifier: GPL-3.0-or-later */
/* cone: pairs of circular cones through random contact elements, and through
 * neighbours on a smooth surface, of which each is timed alone; then what is
 * made of surfaces of both methods. */
#include "bench.h"
#include "curve/surface/grid.h"
#include "curve/surface/locate.h"
#include "curve/surface/volume.h"
#include "solve/method.h"
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

/* ---- surfaces ------------------------------------------------------------ */

enum { PLACES = 65, STEPS = 64, ACROSS = 8, AGAIN = 5 };

/* A problem of so many elements of the row, and what is made of it. */
struct surface {
  double p[PLACES][3], e[PLACES][3], d[PLACES][3], apex[PLACES];
  size_t n; /* elements */
  struct ph_problem problem;
  struct ph_arena out, scratch;
  struct ph_result result;
  struct ph_diag diag;
  size_t made;
};

static struct ph_value vectors(double *v, size_t n, size_t dimension) {
  return (struct ph_value){.kind = dimension == 1 ? PH_NUMBERS : PH_VECTORS,
                           .v = v,
                           .n = n,
                           .dimension = dimension};
}

static void set(struct surface *s, size_t n, bool general) {
  static double height[] = {-0.05, 0.05};
  struct ph_value *field = s->problem.field;
  s->n = n;
  for (size_t i = 0; i < n; i++) {
    struct ph_contact_element e;
    walk(0.4 * (double)i, &e);
    ph_vec3_put(e.p, 3, s->p[i]);
    ph_vec3_put(e.e, 3, s->e[i]);
    ph_vec3_put(e.d, 3, s->d[i]);
    s->apex[i] = i % 2 ? 0.8 : -0.8;
  }
  field[PH_F_POINTS] = vectors(s->p[0], n, 3);
  field[PH_F_RULINGS] = vectors(s->e[0], n, 3);
  field[PH_F_TANGENTS] = vectors(s->d[0], n, 3);
  field[PH_F_HEIGHT] = vectors(height, 2, 1);
  if (general) {
    field[PH_F_METHOD] = (struct ph_value){.kind = PH_WORD, .word = "atph"};
    field[PH_F_APEXES] = vectors(s->apex, n, 1);
  }
}

static void check(const struct surface *s, enum ph_status status) {
  if (status != PH_OK) {
    bench_die(s->diag.message);
  }
}

static void solve(struct surface *s) {
  ph_arena_reset(&s->out);
  s->result = (struct ph_result){.curve = {.n = 0}};
  check(s, ph_method_cone.solve(&s->problem, &s->out, &s->scratch, &s->result,
                                &s->diag));
  s->made = s->n - 1;
}

static void sample(struct surface *s) {
  const struct ph_grid_rules rules = {STEPS, ACROSS, SIZE_MAX};
  check(s, ph_grid_of(&s->result.curve, &rules, &s->out, &s->result.grid,
                      &s->diag));
  s->made = s->result.grid.n;
}

/* Of the flat points of the samples. */
static void locate(struct surface *s) {
  const struct ph_surface_samples *grid = &s->result.grid;
  double(*flat)[2] = ph_arena_array(&s->out, grid->n, sizeof *flat);
  for (size_t i = 0; i < grid->n; i++) {
    flat[i][0] = grid->v[i].flat[0];
    flat[i][1] = grid->v[i].flat[1];
  }
  check(s, ph_surface_locate(&s->result.curve, (const double(*)[2])flat,
                             grid->n, &s->out, &s->result.located, &s->diag));
  s->made = s->result.located.n;
}

static void offset(struct surface *s) {
  struct ph_parallel parallel;
  check(s,
        ph_parallel_of(&s->result.curve, 0.01, &s->out, &parallel, &s->diag));
  s->made = s->n - 1;
}

static void panorama(struct surface *s) {
  static const double corner[8] = {1, 2, 3, 4, 5, 6, 7, 8};
  const struct ph_volume volume = {PH_VOXEL_F64,
                                   corner,
                                   {2, 2, 2},
                                   {-1, -1, -1},
                                   {{0.5, 0, 0}, {0, 0.5, 0}, {0, 0, 0.5}}};
  check(s, ph_panorama_of(&s->result.curve, &volume, 500, SIZE_MAX, &s->out,
                          &s->result.panorama, &s->diag));
  s->made = s->result.panorama.points;
}

static const struct {
  const char *name, *each;
  void (*make)(struct surface *s);
} stages[] = {{"surface", "pair", solve},
              {"samples", "sample", sample},
              {"flat", "point", locate},
              {"offset", "pair", offset},
              {"panorama", "point", panorama}};

static void measure_surface(const char *name, size_t n, bool general) {
  struct surface *s = bench_malloc(1, sizeof *s);
  printf("%s, %zu pairs\n", name, n - 1);
  set(s, n, general);
  for (size_t i = 0; i < sizeof stages / sizeof *stages; i++) {
    double best = HUGE_VAL;
    for (int round = 0; round < AGAIN; round++) {
      const double start = bench_cpu();
      double time;
      stages[i].make(s);
      time = bench_cpu() - start;
      best = time < best ? time : best;
    }
    printf("%-12s%10.3f us a %s, of %zu\n", stages[i].name,
           1e6 * best / (double)s->made, stages[i].each, s->made);
  }
  ph_arena_free(&s->out);
  ph_arena_free(&s->scratch);
  free(s);
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
  measure_surface("Circular cones", PLACES, false);
  measure_surface("General cones", 9, true);
  free(e);
  return 0;
}
