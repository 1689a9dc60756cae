/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * tc: what Tschirnhausen cubics take, from points and vectors in the unit of
 * the data to control points, and the approximation of Bezier curves.
 */
#include "bench.h"

#include "base/mem.h"
#include "kernel/pi.h"
#include "solve/tc/approx.h"
#include "solve/tc/tc.h"

#include <gsl/gsl_errno.h>

enum { SEED = 1, BATCH = 1024 };

/* ---- one interval -------------------------------------------------------- */

struct datum {
  ph_cplx p[2], t[2];
};

struct batch {
  struct datum datum[BATCH];
  ph_cplx control[BATCH][2][4];
  size_t solved;
};

static struct ph_tc_hermite hermite_of(const struct datum *d) {
  ph_cplx over = ph_cplx_inverse(ph_cplx_sub(d->p[1], d->p[0]));
  struct ph_tc_hermite h = {{ph_tc_snap(ph_cplx_mul(d->t[0], over)),
                             ph_tc_snap(ph_cplx_mul(d->t[1], over))}};
  return h;
}

static struct ph_tc_hermite directions_of(const struct datum *d) {
  struct ph_tc_hermite h = hermite_of(d);
  for (int i = 0; i < 2; i++) {
    h.t[i] = ph_cplx_scale(1 / ph_cplx_abs(h.t[i]), h.t[i]);
  }
  return h;
}

/* Scaled by the square root of the chord, with their control points. */
static void put(struct batch *b, size_t i, const struct ph_tc_fit *fit) {
  const struct datum *d = &b->datum[i];
  ph_cplx root = ph_cplx_sqrt(ph_cplx_sub(d->p[1], d->p[0])), at = d->p[0];
  for (size_t k = 0; k < fit->n; k++) {
    struct ph_tc tc = {{ph_cplx_mul(root, fit->tc[k].w[0]),
                        ph_cplx_mul(root, fit->tc[k].w[1])}};
    ph_cplx end = k + 1 < fit->n ? ph_cplx_add(at, ph_tc_leg(&tc)) : d->p[1];
    ph_tc_control_points(&tc, at, end, b->control[i][k]);
    at = end;
  }
  b->solved++;
}

static void standard(void *data) {
  struct batch *b = data;
  for (size_t i = 0; i < BATCH; i++) {
    struct ph_tc_hermite h = hermite_of(&b->datum[i]);
    struct ph_tc_fit fit;
    if (ph_tc_pair_standard(&h, &fit)) {
      put(b, i, &fit);
    }
  }
}

static void single(void *data) {
  struct batch *b = data;
  for (size_t i = 0; i < BATCH; i++) {
    struct ph_tc_hermite h = directions_of(&b->datum[i]);
    struct ph_tc_fit fits[2];
    if (ph_tc_g1(&h, fits) > 0) {
      put(b, i, &fits[0]);
    }
  }
}

static void best_of_four(void *data) {
  struct batch *b = data;
  for (size_t i = 0; i < BATCH; i++) {
    struct ph_tc_hermite h = hermite_of(&b->datum[i]);
    struct ph_tc_fit fit;
    if (ph_tc_pair_best(&h, &fit)) {
      put(b, i, &fit);
    }
  }
}

static void two_free(void *data) {
  struct batch *b = data;
  for (size_t i = 0; i < BATCH; i++) {
    struct ph_tc_hermite h = directions_of(&b->datum[i]);
    struct ph_tc_fit fit;
    if (ph_tc_two_free(&h, &fit)) {
      put(b, i, &fit);
    }
  }
}

static void two_chord(void *data) {
  struct batch *b = data;
  for (size_t i = 0; i < BATCH; i++) {
    struct ph_tc_hermite h = directions_of(&b->datum[i]);
    struct ph_tc_fit fit;
    if (ph_tc_two_chord(&h, (double)NAN, (double)NAN, &fit)) {
      put(b, i, &fit);
    }
  }
}

/* A chord anywhere; vectors of 0.1 to 1.4 of it, of any direction. */
static struct datum datum_of(uint64_t *state) {
  struct datum d;
  ph_cplx chord =
      ph_cplx_scale(bench_uniform(state, 1, 10),
                    ph_cplx_polar(bench_uniform(state, -PH_PI, PH_PI)));
  d.p[0] = ph_cplx_scale(bench_uniform(state, 0, 10),
                         ph_cplx_polar(bench_uniform(state, -PH_PI, PH_PI)));
  d.p[1] = ph_cplx_add(d.p[0], chord);
  for (int i = 0; i < 2; i++) {
    double size = bench_uniform(state, 0.1, 1.4);
    ph_cplx turn = ph_cplx_polar(bench_uniform(state, -PH_PI, PH_PI));
    d.t[i] = ph_cplx_scale(size, ph_cplx_mul(turn, chord));
  }
  return d;
}

static bool any(const struct datum *d) {
  (void)d;
  return true;
}

static bool has_single(const struct datum *d) {
  struct ph_tc_hermite h = directions_of(d);
  struct ph_tc_fit fits[2];
  return ph_tc_g1(&h, fits) > 0;
}

/* Of data that are safe the best pair is known by sight. */
static bool is_not_safe(const struct datum *d) {
  struct ph_tc_hermite h = hermite_of(d);
  return !ph_tc_pair_is_safe(&h);
}

static struct batch *batch_of(bool (*wanted)(const struct datum *d)) {
  struct batch *b = bench_malloc(1, sizeof *b);
  uint64_t state = SEED;
  for (size_t i = 0; i < BATCH;) {
    b->datum[i] = datum_of(&state);
    i += wanted(&b->datum[i]);
  }
  return b;
}

struct row {
  const char *name, *target;
  void (*run)(void *data);
  bool (*wanted)(const struct datum *d);
  int times;
};

static void interval_row(const struct row *row) {
  struct batch *b = batch_of(row->wanted);
  struct bench_contender c = {row->run, b, 0};
  bench_alternate(&c, 1, 25, row->times);
  b->solved = 0;
  row->run(b);
  printf("  %-20s %7zu %7.0f %8s\n", row->name, b->solved, 1e9 * c.best / BATCH,
         row->target);
  free(b);
}

static void interval_table(void) {
  static const struct row rows[] = {
      {"g1", "200", single, has_single, 16},
      {"standard pair", "150", standard, any, 16},
      {"best of four", "1500", best_of_four, is_not_safe, 16},
      {"g1-pair", "-", two_free, any, 1},
      {"g1-pair on the chord", "-", two_chord, any, 1}};
  printf("Tschirnhausen cubics of one interval, from points and vectors to "
         "control points:\nprocessor ns, the best of 25 runs of %d data\n\n"
         "                         solved      ns   target\n",
         BATCH);
  for (size_t k = 0; k < sizeof rows / sizeof rows[0]; k++) {
    interval_row(&rows[k]);
  }
  puts("\n  Directions are uniform, lengths 0.1 to 1.4 of the chord; only data "
       "of which\n  there is a g1 cubic, or for which all four pairs are "
       "looked at.");
}

/* ---- Bezier curves ------------------------------------------------------- */

enum { DEGREE = 7, CURVES = 2 };

static const double beziers[CURVES][DEGREE + 1][2] = {
    {{0, 0}, {1, 4}, {3, 5}, {4, -2}, {6, -4}, {8, 3}, {9, 5}, {11, 0}},
    {{0, 0}, {1, 3}, {3, 4}, {4, -5}, {5, -4}, {6, 5}, {8, 3}, {9, 0}}};

struct approximation {
  ph_cplx p[DEGREE + 1];
  double tolerance;
  struct ph_arena arena;
  struct ph_tc_arcs arcs;
};

static void approximate(void *data) {
  struct approximation *a = data;
  struct ph_tc_bezier curve = {a->p, DEGREE, 0};
  struct ph_diag diag;
  ph_arena_reset(&a->arena);
  a->arcs = (struct ph_tc_arcs){.arena = &a->arena};
  if (ph_tc_approximate(&curve, a->tolerance, &a->arcs, &diag) != PH_OK) {
    bench_die(diag.message);
  }
}

static void bezier_row(size_t curve, double tolerance, const char *target) {
  const double unit = 0x1p-3; /* solvers work near unit scale */
  struct approximation a = {.tolerance = unit * tolerance};
  struct bench_contender c = {approximate, &a, 0};
  for (size_t k = 0; k <= DEGREE; k++) {
    a.p[k] = ph_cplx_scale(
        unit, ph_cplx_of(beziers[curve][k][0], beziers[curve][k][1]));
  }
  bench_alternate(&c, 1, 5, 1);
  printf("  %zu     %8.0e %10.3g %8zu %8s %8.2f\n", curve + 1, tolerance,
         a.arcs.distance / unit, a.arcs.n, target, 1e3 * c.best);
  ph_arena_free(&a.arena);
}

static void bezier_table(void) {
  static const double tolerances[] = {1e-2, 1e-4, 1e-6};
  puts("\nTwo Bezier curves of degree 7 and size 10 by Tschirnhausen cubics, "
       "processor ms\n\n"
       "  curve tolerance   distance   cubics   target       ms");
  for (size_t curve = 0; curve < CURVES; curve++) {
    for (size_t k = 0; k < 3; k++) {
      bezier_row(curve, tolerances[k], k == 2 ? "400" : "-");
    }
  }
  puts("\n  The target is 200 pairs, 400 cubics.  distance: the bound that was "
       "proved.");
}

int main(void) {
  gsl_set_error_handler_off();
  interval_table();
  bezier_table();
  return 0;
}
