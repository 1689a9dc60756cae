/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * spatial: what a segment of a spatial Hermite interpolant takes, step by step,
 * beside an ordinary cubic; and what the whole method does.
 *
 * spatial million [N] [SEED]: N random Hermite data (1000000), each solved and
 * certified, its shape looked at again by code of its own.  (52) and (59) are
 * the conditions of [FAR15] under which some tension keeps the shape.
 */
#include "spatial.h"

#include "base/mem.h"
#include "check/certify.h"
#include "curve/segment/seg3.h"
#include "solve/spatial/spatial.h"
#include "solve/method.h"

#include <gsl/gsl_errno.h>
#include <string.h>

enum { SEED = 1, BATCH = 4096 };

typedef struct ph_spatial_member criterion(const struct ph_spatial_family *);

/* What is written of a segment. */
struct segment {
  ph_vec3 p[6];
  double length;
};

/* Data and results of one table row. */
struct batch {
  struct ph_spatial_data data[BATCH];
  struct segment segment[BATCH];
  double cubic[BATCH][4][3];
  double time[BATCH];
  unsigned char kind[BATCH];
  struct ph_atph space;
  criterion *choose;
};

enum kind { KEPT, REDUCED, UNSATISFIED, KIND_N };

/* ---- one segment ------------------------------------------------------ */

/* From the frame of the data to that of the world. */
static ph_vec3 world(const struct ph_spatial_family *f, ph_vec3 v) {
  ph_vec3 sum = ph_vec3_scale(v.x, f->axis[0]);
  sum = ph_vec3_along(sum, v.y, f->axis[1]);
  return ph_vec3_along(sum, v.z, f->axis[2]);
}

static void put(const struct ph_spatial_family *f, const ph_quat a[3],
                struct segment *out) {
  const ph_vec3 start = {0, 0, 0};
  ph_seg3_control_points(&f->space, a, start, f->dp, out->p);
  for (size_t i = 1; i < 6; i++) {
    out->p[i] = world(f, out->p[i]);
  }
  out->length = ph_seg3_length(&f->space, a);
}

/* Family, member, preimage, control points, length. */
static void plain(struct batch *b, size_t i) {
  struct ph_spatial_family f = ph_spatial_family_of(&b->data[i], &b->space);
  ph_quat a[3];
  ph_spatial_preimage(&f, b->choose(&f), a);
  put(&f, a, &b->segment[i]);
}

static enum ph_status choose(struct ph_spatial_fit *fit, void *context) {
  const struct batch *b = context;
  fit->member = b->choose(&fit->family);
  return PH_OK;
}

/* The same, with the tension that the shape asks for. */
static void shaped(struct batch *b, size_t i) {
  struct ph_spatial_tension t;
  if (ph_spatial_tension(&b->data[i], &b->space, choose, b, 1e-13, &t) !=
      PH_OK) {
    bench_die("no segment");
  }
  b->kind[i] = t.fit.violated ? UNSATISFIED : t.factor < 1 ? REDUCED : KEPT;
  put(&t.fit.family, t.fit.a, &b->segment[i]);
}

/* The polynomial coefficients of an ordinary cubic. */
static void cubic(struct batch *b, size_t i) {
  const struct ph_spatial_data *d = &b->data[i];
  ph_vec3 from = ph_vec3_scale(d->ni, d->ti), to = ph_vec3_scale(d->nf, d->tf);
  ph_vec3 sum = ph_vec3_along(ph_vec3_add(from, to), -2, d->dp);
  ph_vec3 c2 = ph_vec3_sub(ph_vec3_sub(d->dp, from), sum);
  ph_vec3_put(ph_vec3_of(0, 0, 0), 3, b->cubic[i][0]);
  ph_vec3_put(from, 3, b->cubic[i][1]);
  ph_vec3_put(c2, 3, b->cubic[i][2]);
  ph_vec3_put(sum, 3, b->cubic[i][3]);
}

/* ---- kernels ---------------------------------------------------------- */

struct kernel {
  struct batch *batch;
  void (*run)(struct batch *batch, size_t i);
  criterion *choose;
};

static void run_kernel(void *data) {
  const struct kernel *k = data;
  k->batch->choose = k->choose;
  for (size_t i = 0; i < BATCH; i++) {
    k->run(k->batch, i);
  }
}

/* Each segment by itself, many times in a row: the least of a few blocks. */
static void time_each(struct batch *b, int times) {
  b->choose = ph_spatial_cc;
  for (size_t i = 0; i < BATCH; i++) {
    b->time[i] = HUGE_VAL;
    for (int round = 0; round < 3; round++) {
      double start = bench_cpu(), each;
      for (int k = 0; k < times; k++) {
        shaped(b, i);
      }
      each = (bench_cpu() - start) / times;
      b->time[i] = each < b->time[i] ? each : b->time[i];
    }
  }
}

static int compare(const void *a, const void *b) {
  const double *x = a, *y = b;
  return *x < *y ? -1 : *x > *y;
}

static void kinds_row(const struct batch *b) {
  static const char *const names[] = {"kept", "reduced", "none"};
  for (size_t kind = 0; kind < KIND_N; kind++) {
    double sum = 0;
    size_t n = 0;
    for (size_t i = 0; i < BATCH; i++) {
      if (b->kind[i] == kind) {
        sum += b->time[i];
        n++;
      }
    }
    printf("  %s %.1f %% at %.0f ns%s", names[kind], 100 * (double)n / BATCH,
           n ? 1e9 * sum / (double)n : 0, kind + 1 < KIND_N ? "," : "\n\n");
  }
}

static void kernel_table(const char *what, struct batch *b) {
  struct kernel k[] = {{b, cubic, NULL},
                       {b, plain, ph_spatial_cc},
                       {b, shaped, ph_spatial_cc},
                       {b, plain, ph_spatial_hc},
                       {b, plain, ph_spatial_bv}};
  static const char *const names[] = {"cubic", "CC", "CC, shape", "HC", "BV"};
  static const char *const targets[] = {"-", "300", "-", "-", "-"};
  enum { N = sizeof k / sizeof k[0] };
  struct bench_contender c[N];
  double sum = 0;
  for (size_t i = 0; i < N; i++) {
    c[i] = (struct bench_contender){run_kernel, &k[i], 0};
  }
  bench_alternate(c, N, 9, 1);
  printf("%s\n\n  segment            ns   cubics  target ns\n", what);
  for (size_t i = 0; i < N; i++) {
    printf("  %-12s %8.0f %8.0f %10s\n", names[i], 1e9 * c[i].best / BATCH,
           c[i].best / c[0].best, targets[i]);
  }
  time_each(b, 20);
  for (size_t i = 0; i < BATCH; i++) {
    sum += b->time[i];
  }
  printf("\n  CC, shape, each segment by itself, 20 times in a row: mean %.0f "
         "ns,\n",
         1e9 * sum / BATCH);
  kinds_row(b);
  qsort(b->time, BATCH, sizeof *b->time, compare);
  printf("  median %.0f ns (target 1000), nine tenths below %.0f ns\n\n",
         1e9 * b->time[BATCH / 2], 1e9 * b->time[BATCH * 9 / 10]);
}

/* ---- points ----------------------------------------------------------- */

/* A random walk with steps of 0.5 to 1.5: v[n][3]. */
static void walk(uint64_t *state, size_t n, double *v) {
  ph_vec3 at = {0, 0, 0};
  for (size_t k = 0; k < n; k++) {
    ph_vec3_put(at, 3, v + 3 * k);
    at = ph_vec3_along(at, bench_uniform(state, 0.5, 1.5),
                       bench_direction(state));
  }
}

/* Segments of a walk with the tangents that are found from its points. */
static void walk_batch(struct batch *b) {
  uint64_t state = SEED;
  double *v = bench_malloc(BATCH + 1, 3 * sizeof *v);
  ph_vec3 *t = bench_malloc(BATCH + 1, sizeof *t);
  walk(&state, BATCH + 1, v);
  ph_spatial_tangents(v, BATCH + 1, 3, false, t);
  for (size_t k = 0; k < BATCH; k++) {
    ph_vec3 p = ph_vec3_get(v + 3 * k, 3), q = ph_vec3_get(v + 3 * k + 3, 3);
    struct ph_spatial_data *data = &b->data[k];
    *data = (struct ph_spatial_data){.dp = ph_vec3_sub(q, p)};
    data->ti = t[k];
    data->tf = t[k + 1];
    data->ni = data->nf = ph_vec3_abs(data->dp);
  }
  free(v);
  free(t);
}

static void random_batch(struct batch *b) {
  uint64_t state = SEED;
  for (size_t k = 0; k < BATCH; k++) {
    b->data[k] = bench_hermite(&state);
  }
}

/* ---- the method ------------------------------------------------------- */

struct whole {
  struct ph_problem problem;
  struct ph_result result;
  struct ph_arena out, scratch;
};

static void solve(void *data) {
  struct whole *w = data;
  struct ph_diag diag;
  ph_arena_free(&w->out);
  memset(&w->result, 0, sizeof w->result);
  if (ph_method_spatial_hermite.solve(&w->problem, &w->out, &w->scratch,
                                      &w->result, &diag) != PH_OK) {
    bench_die(diag.message);
  }
  ph_arena_free(&w->scratch);
}

static void certify(void *data) {
  struct whole *w = data;
  struct ph_diag diag;
  if (ph_certify("spatial-hermite", &w->problem, &w->result.curve, &w->scratch,
                 &w->result.diagnostics, &diag) != PH_OK) {
    bench_die(diag.message);
  }
  ph_arena_free(&w->scratch);
}

static void set_vectors(struct whole *w, enum ph_field_id id, double *v,
                        size_t n) {
  w->problem.field[id] =
      (struct ph_value){.kind = PH_VECTORS, .v = v, .n = n, .dimension = 3};
}

static void method_row(const char *name, size_t n, bool tangents, bool shape) {
  uint64_t state = SEED;
  struct whole w = {.problem = {{{0}}}};
  struct bench_contender c[] = {{solve, &w, 0}, {certify, &w, 0}};
  double *v = bench_malloc(n, 3 * sizeof *v);
  double *t = bench_malloc(n, 3 * sizeof *t);
  walk(&state, n, v);
  for (size_t k = 0; k < n; k++) {
    ph_vec3_put(bench_direction(&state), 3, t + 3 * k);
  }
  set_vectors(&w, PH_F_POINTS, v, n);
  if (tangents) {
    set_vectors(&w, PH_F_TANGENTS, t, n);
  }
  w.problem.field[PH_F_SHAPE] =
      (struct ph_value){.kind = PH_BOOL, .flag = shape};
  bench_alternate(c, 2, n < 1000000 ? 5 : 2, 1);
  printf("  %-24s %8zu %10.0f %12.0f\n", name, n, 1e9 * c[0].best / (double)n,
         1e9 * c[1].best / (double)n);
  fflush(stdout);
  ph_arena_free(&w.out);
  free(v);
  free(t);
}

static void method_table(void) {
  puts("The method on a random walk, CC: from the points to control points, "
       "preimage,\nlengths and angles; and the certificate; processor ns a "
       "point\n\n"
       "  data                       points      solve  certificate");
  for (size_t n = 100000; n <= 1000000; n *= 10) {
    method_row("points", n, false, true);
    method_row("points, shape false", n, false, false);
    method_row("random tangents", n, true, true);
  }
}

/* ---- a million segments ----------------------------------------------- */

struct tally {
  size_t kind[KIND_N], backward, unexpected, refused, wrong;
  double interpolation, pythagorean, shape; /* the worst */
};

/* Derivative `order` at u of the Bezier curve of degree 5. */
static ph_vec3 derivative(const double *p, int order, double u) {
  double v[6][3];
  ph_vec3 result;
  int degree = 5;
  memcpy(v, p, sizeof v);
  for (; order > 0; order--, degree--) {
    for (int i = 0; i < degree; i++) {
      for (int j = 0; j < 3; j++) {
        v[i][j] = degree * (v[i + 1][j] - v[i][j]);
      }
    }
  }
  for (; degree > 0; degree--) {
    for (int i = 0; i < degree; i++) {
      for (int j = 0; j < 3; j++) {
        v[i][j] += u * (v[i + 1][j] - v[i][j]);
      }
    }
  }
  result = ph_vec3_get(v[0], 3);
  return result;
}

static double larger(double a, double b) {
  return b <= a ? a : b; /* NaN stays */
}

/* How far the shape is lost, relative; 0 if it is kept: convexity at both ends,
 * the sign of the torsion in 64 points. */
static double shape_lost(const struct ph_spatial_data *d, const double *p) {
  ph_vec3 normal[2] = {ph_vec3_cross(d->ti, d->dp),
                       ph_vec3_cross(d->dp, d->tf)};
  double twist = ph_vec3_triple(d->ti, d->dp, d->tf), lost = 0;
  for (int i = 0; i <= 63; i++) {
    double u = i / 63.0, x;
    ph_vec3 r1 = derivative(p, 1, u), r2 = derivative(p, 2, u);
    ph_vec3 r3 = derivative(p, 3, u), bend = ph_vec3_cross(r1, r2);
    double size = ph_vec3_abs(r1) * ph_vec3_abs(r2);
    x = -copysign(1, twist) * ph_vec3_dot(bend, r3) / (size * ph_vec3_abs(r3));
    lost = larger(lost, x);
    if (i == 0 || i == 63) {
      ph_vec3 n = normal[i == 63];
      x = -ph_vec3_dot(bend, n) / (size * ph_vec3_abs(n));
      lost = larger(lost, x);
    }
  }
  return lost;
}

/* The data of a segment, to be solved again. */
static void print_data(const struct ph_spatial_data *d, const char *why) {
  printf("%s\n{\"points\":[[0,0,0],[%.17g,%.17g,%.17g]],\"derivatives\":[", why,
         d->dp.x, d->dp.y, d->dp.z);
  printf("[%.17g,%.17g,%.17g],", d->ni * d->ti.x, d->ni * d->ti.y,
         d->ni * d->ti.z);
  printf("[%.17g,%.17g,%.17g]],\"shape\":true}\n", d->nf * d->tf.x,
         d->nf * d->tf.y, d->nf * d->tf.z);
}

static void check(const struct ph_spatial_data *d, const struct whole *w,
                  struct tally *t) {
  const struct ph_curve *curve = &w->result.curve;
  const double *value = w->result.diagnostics.value;
  double interpolation = value[PH_D_INTERPOLATION_ERROR];
  double pythagorean = value[PH_D_PYTHAGOREAN_ERROR];
  double lost =
      curve->choice.shape_ok[0] ? shape_lost(d, curve->control_points) : 0;
  enum kind kind = !curve->choice.shape_ok[0]     ? UNSATISFIED
                   : curve->choice.tension[0] < 1 ? REDUCED
                                                  : KEPT;
  t->kind[kind]++;
  if (kind == UNSATISFIED) {
    t->backward += !ph_spatial_is_forward(d);
    t->unexpected += ph_spatial_is_forward(d) && ph_spatial_is_acute(d);
  }
  t->interpolation = larger(t->interpolation, interpolation);
  t->pythagorean = larger(t->pythagorean, pythagorean);
  t->shape = larger(t->shape, lost);
  if (!(interpolation <= 1e-13 && pythagorean <= 1e-13 && lost <= 1e-9)) {
    t->wrong++;
    print_data(d, "wrong");
  }
}

static void report(const struct tally *t, size_t n, double time) {
  printf("%zu random Hermite data, CC, each by itself, %.1f s (%.0f ns each, "
         "with its\ncertificate and 64 samples)\n\n",
         n, time, 1e9 * time / (double)n);
  printf("  shape kept at tension 1   %8zu\n", t->kind[KEPT]);
  printf("  at a reduced tension      %8zu\n", t->kind[REDUCED]);
  printf("  at none                   %8zu\n", t->kind[UNSATISFIED]);
  printf("    and (52) does not hold  %8zu\n", t->backward);
  printf("    and (52), (59) hold     %8zu\n", t->unexpected);
  printf("  refused                   %8zu\n", t->refused);
  printf("  wrong                     %8zu\n\n", t->wrong);
  printf("  worst interpolation error %8.2g, target 1e-13\n", t->interpolation);
  printf("  worst Pythagorean error   %8.2g, target 1e-13\n", t->pythagorean);
  printf("  worst loss of a shape that is claimed, of 64 samples %.2g\n",
         t->shape);
}

static int million(size_t n, uint64_t seed) {
  struct tally t = {{0}, 0, 0, 0, 0, 0, 0, 0};
  struct whole w = {.problem = {{{0}}}};
  double points[6] = {0}, derivatives[6], start = bench_cpu();
  set_vectors(&w, PH_F_POINTS, points, 2);
  set_vectors(&w, PH_F_DERIVATIVES, derivatives, 2);
  /* Every sign counts, so that samples can tell. */
  w.problem.field[PH_F_PLANARITY] =
      (struct ph_value){.kind = PH_NUMBER, .number = 0};
  w.problem.field[PH_F_SHAPE] =
      (struct ph_value){.kind = PH_BOOL, .flag = true};
  for (size_t i = 0; i < n; i++) {
    struct ph_spatial_data d = bench_hermite(&seed);
    struct ph_diag diag;
    enum ph_status status;
    ph_vec3_put(d.dp, 3, points + 3);
    ph_vec3_put(ph_vec3_scale(d.ni, d.ti), 3, derivatives);
    ph_vec3_put(ph_vec3_scale(d.nf, d.tf), 3, derivatives + 3);
    ph_arena_reset(&w.out);
    memset(&w.result, 0, sizeof w.result);
    status = ph_method_spatial_hermite.solve(&w.problem, &w.out, &w.scratch,
                                             &w.result, &diag);
    if (status == PH_OK) {
      status = ph_certify("spatial-hermite", &w.problem, &w.result.curve,
                          &w.scratch, &w.result.diagnostics, &diag);
    }
    if (status == PH_OK) {
      check(&d, &w, &t);
    } else {
      t.refused++;
      print_data(&d, diag.message);
    }
  }
  report(&t, n, bench_cpu() - start);
  ph_arena_free(&w.out);
  ph_arena_free(&w.scratch);
  return t.refused + t.wrong > 0;
}

int main(int argc, char **argv) {
  struct batch *b;
  gsl_set_error_handler_off();
  if (argc > 1 && strcmp(argv[1], "million") == 0) {
    return million(argc > 2 ? strtoul(argv[2], NULL, 10) : 1000000,
                   argc > 3 ? strtoul(argv[3], NULL, 10) : SEED);
  }
  b = bench_malloc(1, sizeof *b);
  b->space = ph_atph_of(0);
  puts("Spatial Hermite segments, processor ns, the best of many runs\n");
  random_batch(b);
  kernel_table("Random data: a chord of 1, any tangents, derivatives of 0.3 to "
               "3.3",
               b);
  walk_batch(b);
  kernel_table("A random walk with the tangents found from its points", b);
  free(b);
  method_table();
  return 0;
}
