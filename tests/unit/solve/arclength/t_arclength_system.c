/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The equations of arclength against their definition: rows by quadrature of
 * |w|^2 and H(w), first and second derivatives by differences, for everything
 * that may be given, in space, in the plane and on a line, open and closed.
 */
#include "unit.h"

#include "kernel/band.h"
#include "kernel/quad.h"
#include "solve/arclength/system.h"
#include "solve/arclength/arclength.h"

/* Matrices are put together by stretches of 16 intervals. */
enum { N = 40, X_MAX = 4 * (3 * N + 2) + 1, Y_MAX = 4 * N + 3 * (N + 1) };

/* One kind of system. */
struct sort {
  enum ph_arc_mode mode;
  bool lengths;
  bool closed;
  size_t dim;
  size_t refine;
};

/* Random data of a sort, in the pose that the equations expect. */
struct setting {
  struct ph_arc_data data;
  double h[N], length[N], chord[N];
  ph_vec3 step[N], given[N + 1];
  struct ph_arc_system system;
  struct ph_arc_linear linear;
  double x[X_MAX], y[Y_MAX];
};

static ph_vec3 random_vector(struct unit_random *r, size_t dim) {
  double x = unit_random_in(r, 0.3, 1), y = unit_random_in(r, -1, 1);
  double z = unit_random_in(r, -1, 1);
  return ph_vec3_of(x, dim > 1 ? y : 0, dim > 2 ? z : 0);
}

static void set_up(struct unit_random *r, const struct sort *sort,
                   struct setting *t) {
  struct ph_arc_data *d = &t->data;
  memset(t, 0, sizeof *t);
  d->mode = sort->mode;
  d->closed = sort->closed;
  d->n = N;
  d->h = t->h;
  d->length = sort->lengths ? t->length : NULL;
  d->step = sort->mode == PH_ARC_POINTS ? t->step : NULL;
  d->chord = sort->mode == PH_ARC_POINTS ? t->chord : NULL;
  d->given = sort->mode == PH_ARC_POINTS ? NULL : t->given;
  for (size_t i = 0; i < N; i++) {
    t->h[i] = unit_random_in(r, 0.5, 2);
    t->step[i] = random_vector(r, sort->dim);
    t->chord[i] = ph_vec3_abs(t->step[i]);
    t->length[i] = t->chord[i] * unit_random_in(r, 1.01, 1.3);
  }
  for (size_t j = 0; j <= N; j++) {
    t->given[j] = random_vector(r, sort->dim);
    if (sort->mode == PH_ARC_TANGENTS) {
      t->given[j] = ph_vec3_unit(t->given[j]);
    }
  }
  ck_assert(ph_arc_system_of(d, sort->refine, sort->dim, true, &unit_arena,
                             &t->system));
  ck_assert(ph_arc_linear_alloc(&t->system, &unit_arena, &t->linear));
  ck_assert_uint_le(t->system.x_n, X_MAX);
  ck_assert_uint_le(t->system.y_n, Y_MAX);
  t->system.sign = sort->closed && sort->dim == 2 ? -1 : 1;
  t->system.phases = sort->dim == 4; /* of these few points, too */
  for (size_t k = 0; k < t->system.x_n; k++) {
    t->x[k] = unit_random_in(r, -1, 1);
  }
  for (size_t k = 0; k < t->system.y_n; k++) {
    t->y[k] = unit_random_in(r, -1, 1);
  }
}

static const struct sort sorts[] = {
    {PH_ARC_POINTS, true, false, 4, 1},
    {PH_ARC_POINTS, true, false, 4, 2},
    {PH_ARC_POINTS, true, false, 4, 3},
    {PH_ARC_POINTS, false, false, 4, 1},
    {PH_ARC_POINTS, true, true, 4, 1},
    {PH_ARC_POINTS, true, true, 4, 2},
    {PH_ARC_POINTS, false, true, 4, 3},
    {PH_ARC_POINTS, true, true, 2, 1},
    {PH_ARC_POINTS, true, true, 2, 2},
    {PH_ARC_POINTS, true, false, 2, 1},
    {PH_ARC_POINTS, false, false, 2, 2},
    {PH_ARC_POINTS, true, false, 1, 1},
    {PH_ARC_DERIVATIVES, true, false, 4, 1},
    {PH_ARC_DERIVATIVES, true, false, 4, 2},
    {PH_ARC_DERIVATIVES, true, false, 2, 2},
    {PH_ARC_TANGENTS, true, false, 4, 1},
    {PH_ARC_TANGENTS, true, false, 4, 3},
    {PH_ARC_TANGENTS, true, false, 2, 2},
    {PH_ARC_TANGENTS, true, false, 1, 2},
};
enum { SORTS = COUNT(sorts) };

/* ---- rows by quadrature ------------------------------------------------ */

/* Node j in space, beyond the seam too. */
static void node(const struct setting *t, size_t j, double w[4]) {
  const struct ph_arc_system *s = &t->system;
  size_t at = j < s->nodes ? j : j - s->nodes;
  ph_cplx turn = ph_cplx_of(j < s->nodes ? 1 : s->sign, 0);
  memset(w, 0, 4 * sizeof *w);
  for (size_t k = 0; k < s->dim; k++) {
    w[s->dim == 2 ? 2 * k : k] = t->x[at * s->dim + k];
  }
  if (s->turn && j >= s->nodes) {
    turn = ph_cplx_polar(t->x[s->x_n - 1]);
  }
  for (size_t half = 0; half < 4; half += 2) {
    ph_cplx v = ph_cplx_mul(turn, ph_cplx_of(w[half], w[half + 1]));
    w[half] = v.re;
    w[half + 1] = v.im;
  }
}

/* w on segment q at u in [0, 1]; also its second derivative by t. */
static void value(const struct setting *t, size_t q, double u, double w[4],
                  double bend[4]) {
  double c[3][3], h = t->h[q / t->system.refine] / (double)t->system.refine;
  const double b[3] = {(1 - u) * (1 - u), 2 * u * (1 - u), u * u};
  static const double second[3] = {2, -4, 2};
  ph_arc_coefficients(&t->system, q, c);
  memset(w, 0, 4 * sizeof *w);
  memset(bend, 0, 4 * sizeof *bend);
  for (size_t l = 0; l < 3; l++) {
    double v[4];
    node(t, q + l, v);
    for (size_t i = 0; i < 3; i++) {
      for (size_t k = 0; k < 4; k++) {
        w[k] += b[i] * c[i][l] * v[k];
        bend[k] += second[i] * c[i][l] * v[k] / (h * h);
      }
    }
  }
}

/* |w|^2 and H(w). */
static void image(const double w[4], double out[4]) {
  ph_cplx a = ph_cplx_of(w[0], w[1]), b = ph_cplx_of(w[2], w[3]);
  ph_cplx ab = ph_cplx_mul(a, ph_cplx_conj(b));
  out[0] = ph_cplx_norm2(a) + ph_cplx_norm2(b);
  out[1] = ph_cplx_norm2(a) - ph_cplx_norm2(b);
  out[2] = 2 * ab.re;
  out[3] = 2 * ab.im;
}

PH_TEST_EACH(test_rows_are_integrals, SORTS) {
  struct unit_random r = unit_random_of(900 + (uint64_t)_i);
  struct ph_quad rule;
  struct setting t;
  double c[Y_MAX], length[N], f = 0;
  ck_assert(ph_quad_gauss(&rule, 5));
  set_up(&r, &sorts[_i], &t);
  ph_arc_residual(&t.system, t.x, c);
  ph_arc_lengths(&t.system, t.x, length);
  for (size_t i = 0; i < N; i++) {
    double sum[4] = {0, 0, 0, 0};
    for (size_t q = i * t.system.refine; q < (i + 1) * t.system.refine; q++) {
      for (size_t k = 0; k < rule.n; k++) {
        double w[4], bend[4], v[4];
        double h = t.h[i] / (double)t.system.refine * rule.weight[k];
        value(&t, q, rule.node[k], w, bend);
        image(w, v);
        for (size_t j = 0; j < 4; j++) {
          sum[j] += h * v[j];
          f += h * bend[j] * bend[j];
        }
      }
    }
    ck_rel(length[i], sum[0], 1e-13);
    for (size_t k = 0; k < t.system.forms_n; k++) {
      size_t row = i * t.system.forms_n + k;
      const double want[4] = {t.length[i], t.step[i].x, t.step[i].y,
                              t.step[i].z};
      int form = t.system.form[k];
      ck_abs(c[row], sum[form] - want[form], 1e-13);
    }
  }
  ck_rel(ph_arc_functional(&t.system, t.x), f, 1e-12);
}

/* Rows of knots: H(w) - d, or the part of H(w) that is not along d. */
PH_TEST_EACH(test_rows_of_knots, SORTS) {
  struct unit_random r = unit_random_of(930 + (uint64_t)_i);
  struct setting t;
  double c[Y_MAX];
  set_up(&r, &sorts[_i], &t);
  ph_arc_residual(&t.system, t.x, c);
  for (size_t j = 0; t.system.knot_rows > 0 && j <= N; j++) {
    size_t q = j < N ? j * t.system.refine : t.system.segments - 1;
    const double *row = c + N * t.system.forms_n + j * t.system.knot_rows;
    double w[4], bend[4], v[4];
    ph_vec3 h, d = t.given[j];
    value(&t, q, j < N ? 0 : 1, w, bend);
    image(w, v);
    h = ph_vec3_of(v[1], v[2], v[3]);
    if (t.data.mode == PH_ARC_DERIVATIVES) {
      const double want[3] = {h.x - d.x, h.y - d.y, h.z - d.z};
      for (size_t k = 0; k < t.system.knot_rows; k++) {
        ck_abs(row[k], want[k], 1e-13);
      }
    } else { /* |s_a m_b - s_b m_a|^2 = |m|^2 sin^2 of half the angle */
      double sum = 0, size = v[0];
      for (size_t k = 0; k < t.system.knot_rows; k++) {
        sum += row[k] * row[k];
      }
      ck_abs(sum, (size - ph_vec3_dot(h, d)) / 2, 1e-13);
    }
  }
}

/* ---- derivatives by differences ------------------------------------------ */

static const double STEP = 1e-5;

/* The gradient of the Lagrangian, moved by `step` in unknown k. */
static void gradient_at(struct setting *t, size_t k, double step,
                        double out[X_MAX]) {
  double old = t->x[k];
  t->x[k] = old + step;
  ph_arc_linearise(&t->system, t->x, t->y, &t->linear);
  memcpy(out, t->linear.l_x, t->system.x_n * sizeof *out);
  t->x[k] = old;
}

static double lagrangian_at(struct setting *t, size_t k, double step) {
  double old = t->x[k], c[Y_MAX], sum;
  t->x[k] = old + step;
  ph_arc_residual(&t->system, t->x, c);
  sum = ph_arc_functional(&t->system, t->x);
  for (size_t r = 0; r < t->system.y_n; r++) {
    sum += t->y[r] * c[r];
  }
  t->x[k] = old;
  return sum;
}

PH_TEST_EACH(test_gradient, SORTS) {
  struct unit_random r = unit_random_of(960 + (uint64_t)_i);
  struct setting t;
  set_up(&r, &sorts[_i], &t);
  for (size_t k = 0; k < t.system.x_n; k++) {
    double difference =
        (lagrangian_at(&t, k, STEP) - lagrangian_at(&t, k, -STEP)) / (2 * STEP);
    double scale = fabs(lagrangian_at(&t, k, 0)) + 1;
    ph_arc_linearise(&t.system, t.x, t.y, &t.linear);
    ck_abs(t.linear.l_x[k], difference, 1e-8 * scale);
  }
}

/* The dense form of a band matrix of the unknowns and rows. */
static double kkt_at(struct setting *t, double *matrix, uint32_t i,
                     uint32_t j) {
  size_t k = t->system.kkt_band;
  return i > j + k || j > i + k ? 0 : *ph_band_at(matrix, k, i, j);
}

PH_TEST_EACH(test_kkt_matrix, SORTS) {
  struct unit_random r = unit_random_of(990 + (uint64_t)_i);
  static const struct ph_arc_weights weights = {.functional = 1};
  struct setting t;
  double *matrix, plus[X_MAX], minus[X_MAX];
  set_up(&r, &sorts[_i], &t);
  matrix = ph_arena_array(&unit_arena,
                          ph_band_size(t.system.kkt_n, t.system.kkt_band),
                          sizeof *matrix);
  ph_arc_linearise(&t.system, t.x, t.y, &t.linear);
  ph_arc_kkt(&t.system, t.x, t.y, &t.linear, &weights, matrix);
  for (size_t k = 0; k < t.system.x_n; k++) {
    uint32_t at = t.system.place_x[k];
    double v[X_MAX] = {0}, column[Y_MAX];
    gradient_at(&t, k, STEP, plus);
    gradient_at(&t, k, -STEP, minus);
    for (size_t l = 0; l < t.system.x_n; l++) {
      double difference = (plus[l] - minus[l]) / (2 * STEP);
      double scale = fabs(plus[l]) + fabs(plus[k]) + 100;
      ck_abs(kkt_at(&t, matrix, t.system.place_x[l], at), difference,
             1e-8 * scale);
    }
    v[k] = 1;
    ph_arc_linearise(&t.system, t.x, t.y, &t.linear);
    ph_arc_rows_times(&t.system, &t.linear, v, column);
    for (size_t l = 0; l < t.system.y_n; l++) {
      uint32_t row = t.system.place_y[l];
      ck_abs(kkt_at(&t, matrix, row, at), column[l], 0);
      ck_abs(kkt_at(&t, matrix, at, row), column[l], 0);
    }
  }
}

/* v . (A + rho J^T J) v in one way and the other. */
PH_TEST_EACH(test_penalised_matrix, SORTS) {
  struct unit_random r = unit_random_of(1020 + (uint64_t)_i);
  static const struct ph_arc_weights weights = {
      .functional = 1, .shift = 0.5, .pin = 3, .retracted = true};
  const double rho = 7;
  struct setting t;
  double *kkt, *sym, v[X_MAX], jv[Y_MAX], want = 0, got = 0;
  size_t band;
  set_up(&r, &sorts[_i], &t);
  band = t.system.order_band;
  kkt = ph_arena_array(&unit_arena,
                       ph_band_size(t.system.kkt_n, t.system.kkt_band),
                       sizeof *kkt);
  sym =
      ph_arena_array(&unit_arena, ph_sym_size(t.system.x_n, band), sizeof *sym);
  ph_arc_linearise(&t.system, t.x, t.y, &t.linear);
  ph_arc_kkt(&t.system, t.x, t.y, &t.linear, &weights, kkt);
  ph_arc_penalised(&t.system, t.x, t.y, &t.linear, &weights, rho, sym);
  for (size_t k = 0; k < t.system.x_n; k++) {
    v[k] = unit_random_in(&r, -1, 1);
  }
  ph_arc_rows_times(&t.system, &t.linear, v, jv);
  for (size_t k = 0; k < t.system.x_n; k++) {
    for (size_t l = 0; l < t.system.x_n; l++) {
      uint32_t i = t.system.order[k], j = t.system.order[l];
      uint32_t high = i > j ? i : j, low = i > j ? j : i;
      want += v[k] * v[l] *
              kkt_at(&t, kkt, t.system.place_x[k], t.system.place_x[l]);
      if (high - low <= band) {
        got += v[k] * v[l] * *ph_sym_at(sym, band, high, low);
      }
    }
  }
  for (size_t row = 0; row < t.system.y_n; row++) {
    want += rho * jv[row] * jv[row];
  }
  ck_rel(got, want, 1e-12);
}

/* A matrix whose memory has no meaning before. */
static double *no_matrix(size_t size) {
  double *matrix = ph_arena_array(&unit_arena, size, sizeof *matrix);
  for (size_t i = 0; i < size; i++) {
    matrix[i] = (double)NAN;
  }
  return matrix;
}

/* Factors that are taken by stretches are those of the whole matrix, as
 * rounded. */
PH_TEST_EACH(test_factors, SORTS) {
  struct unit_random r = unit_random_of(1040 + (uint64_t)_i);
  const struct ph_arc_weights weights = {1, .shift = 500, .pin = 3};
  const double rho = 1e4;
  struct setting t;
  struct ph_arc_system *s = &t.system;
  double *kkt[2], *sym[2];
  uint32_t *pivot[2];
  size_t kkt_size, sym_size;
  set_up(&r, &sorts[_i], &t);
  kkt_size = ph_band_size(s->kkt_n, s->kkt_band);
  sym_size = ph_sym_size(s->x_n, s->order_band);
  for (size_t k = 0; k < 2; k++) {
    kkt[k] = no_matrix(kkt_size);
    sym[k] = no_matrix(sym_size);
    pivot[k] = ph_arena_array(&unit_arena, s->kkt_n, sizeof *pivot[k]);
  }
  ph_arc_linearise(s, t.x, t.y, &t.linear);
  ph_arc_kkt(s, t.x, t.y, &t.linear, &weights, kkt[0]);
  ck_assert(ph_band_factor(kkt[0], pivot[0], s->kkt_n, s->kkt_band));
  ck_assert(
      ph_arc_kkt_factor(s, t.x, t.y, &t.linear, &weights, kkt[1], pivot[1]));
  ck_assert_mem_eq(kkt[1], kkt[0], kkt_size * sizeof **kkt);
  ck_assert_mem_eq(pivot[1], pivot[0], s->kkt_n * sizeof *pivot[0]);
  ph_arc_penalised(s, t.x, NULL, &t.linear, &weights, rho, sym[0]);
  ck_assert(ph_sym_factor(sym[0], s->x_n, s->order_band));
  ck_assert(
      ph_arc_penalised_factor(s, t.x, NULL, &t.linear, &weights, rho, sym[1]));
  ck_assert_mem_eq(sym[1], sym[0], sym_size * sizeof **sym);
}

/* ---- phases -------------------------------------------------------------- */

/* out = A v of the KKT matrix at t->x. */
static void matrix_times(struct setting *t,
                         const struct ph_arc_weights *weights, const double *v,
                         double out[X_MAX]) {
  const struct ph_arc_system *s = &t->system;
  double *matrix = ph_arena_array(
      &unit_arena, ph_band_size(s->kkt_n, s->kkt_band), sizeof *matrix);
  ph_arc_linearise(s, t->x, t->y, &t->linear);
  ph_arc_kkt(s, t->x, t->y, &t->linear, weights, matrix);
  for (size_t k = 0; k < s->x_n; k++) {
    out[k] = 0;
    for (size_t l = 0; l < s->x_n; l++) {
      out[k] += kkt_at(t, matrix, s->place_x[k], s->place_x[l]) * v[l];
    }
  }
}

static void set_random(struct unit_random *r, const struct setting *t,
                       double v[X_MAX]) {
  for (size_t k = 0; k < t->system.x_n; k++) {
    v[k] = unit_random_in(r, -1, 1);
  }
}

/* Second derivatives along retracted steps are differences of values there. */
PH_TEST_EACH(test_retracted_matrix, SORTS) {
  static const struct ph_arc_weights weights = {.functional = 1,
                                                .retracted = true};
  static const double step = 1e-3;
  struct unit_random r = unit_random_of(1050 + (uint64_t)_i);
  struct setting t;
  double x[X_MAX], v[X_MAX], av[X_MAX], value[3], scale = 1;
  set_up(&r, &sorts[_i], &t);
  set_random(&r, &t, v);
  matrix_times(&t, &weights, v, av);
  memcpy(x, t.x, sizeof x);
  for (int k = 0; k < 3; k++) {
    ph_arc_retract(&t.system, x, v, (k - 1) * step, t.x);
    value[k] = lagrangian_at(&t, 0, 0);
    scale += fabs(value[k]);
  }
  ck_abs(ph_arc_dot(t.system.x_n, v, av),
         (value[0] - 2 * value[1] + value[2]) / (step * step), 1e-4 * scale);
}

/* A common phase changes neither F nor rows that are quadratic, wherever x is,
 * and no shift weighs it. */
PH_TEST_EACH(test_common_phase, SORTS) {
  static const struct ph_arc_weights weights = {
      .functional = 1, .shift = 0.5, .retracted = true};
  struct unit_random r = unit_random_of(1080 + (uint64_t)_i);
  struct setting t;
  double v[X_MAX] = {0}, av[X_MAX];
  if (sorts[_i].dim != 4 || sorts[_i].mode == PH_ARC_TANGENTS) {
    return;
  }
  set_up(&r, &sorts[_i], &t);
  for (size_t j = 0; j < t.system.nodes; j++) {
    ph_arc_turned(t.x + 4 * j, v + 4 * j);
  }
  matrix_times(&t, &weights, v, av);
  for (size_t k = 0; k < t.system.x_n; k++) {
    ck_abs(av[k], 0, 1e-11);
  }
}

/* What shifts make of a step: system.h has the formula. */
static double shifted_square(const struct setting *t, const double *shifts,
                             const double *v) {
  const struct ph_arc_system *s = &t->system;
  double sum = 0, before = 0;
  for (size_t j = 0; j < s->nodes; j++) {
    const double *w = t->x + j * s->dim;
    double rest[4], ww = ph_arc_dot(s->dim, w, w);
    double p = ph_arc_split(s, w, v + j * s->dim, rest);
    sum += shifts[j] * ph_arc_dot(s->dim, rest, rest);
    if (j > 0) {
      double least = fmin(ww, ph_arc_dot(s->dim, w - s->dim, w - s->dim));
      sum += (shifts[j - 1] + shifts[j]) / 2 * least * pow(p - before, 2);
    }
    before = p;
  }
  return s->turn ? sum + shifts[0] * v[s->x_n - 1] * v[s->x_n - 1] : sum;
}

PH_TEST_EACH(test_shifts, SORTS) {
  struct unit_random r = unit_random_of(1110 + (uint64_t)_i);
  double v[X_MAX], with[X_MAX], without[X_MAX], shifts[X_MAX];
  struct ph_arc_weights weights = {.functional = 1};
  struct setting t;
  set_up(&r, &sorts[_i], &t);
  set_random(&r, &t, v);
  for (size_t j = 0; j < t.system.nodes; j++) { /* some have none */
    shifts[j] = fmax(unit_random_in(&r, -1, 1), 0);
  }
  matrix_times(&t, &weights, v, without);
  weights.shifts = shifts;
  matrix_times(&t, &weights, v, with);
  ck_rel(ph_arc_dot(t.system.x_n, v, with) -
             ph_arc_dot(t.system.x_n, v, without),
         shifted_square(&t, shifts, v), 1e-10);
}

/* ---- bands, steps -------------------------------------------------------- */

/* Bands do not grow with the number of intervals. */
PH_TEST(test_bands) {
  static const struct {
    size_t refine;
    bool closed;
    size_t kkt, order;
  } want[] = {{1, false, 19, 11}, {2, false, 15, 15}, {3, false, 15, 19}};
  for (size_t k = 0; k < 3; k++) {
    struct unit_random r = unit_random_of(1050);
    struct sort sort = {PH_ARC_POINTS, true, false, 4, want[k].refine};
    struct setting t;
    set_up(&r, &sort, &t);
    ck_assert_uint_eq(t.system.kkt_band, want[k].kkt);
    ck_assert_uint_eq(t.system.order_band, want[k].order);
  }
}

/* A step along the phases alone turns every node by its phase, whatever its
 * size: the rows are left as they are where the phase is the same. */
PH_TEST(test_retract_turns_phases) {
  struct unit_random r = unit_random_of(1080);
  struct setting t;
  double to[X_MAX], dx[X_MAX], before[Y_MAX], after[Y_MAX];
  set_up(&r, &sorts[1], &t);
  for (size_t j = 0; j < t.system.nodes; j++) {
    const double *w = t.x + 4 * j;
    dx[4 * j] = -w[1];
    dx[4 * j + 1] = w[0];
    dx[4 * j + 2] = -w[3];
    dx[4 * j + 3] = w[2];
  }
  ph_arc_residual(&t.system, t.x, before);
  ph_arc_retract(&t.system, t.x, dx, 2.5, to);
  ph_arc_residual(&t.system, to, after);
  for (size_t k = 0; k < t.system.y_n; k++) {
    ck_abs(after[k], before[k], 1e-13);
  }
}

/* Multipliers of directions turn with their rows: a common phase leaves what
 * the rows weigh as it is, whatever its size. */
PH_TEST_EACH(test_multipliers_turn, SORTS) {
  struct unit_random r = unit_random_of(1100 + (uint64_t)_i);
  struct setting t;
  double dx[X_MAX] = {0}, to[X_MAX], dy[Y_MAX] = {0}, y[Y_MAX], c[Y_MAX];
  double before, first;
  size_t knots;
  if (sorts[_i].dim != 4 || sorts[_i].mode != PH_ARC_TANGENTS) {
    return;
  }
  set_up(&r, &sorts[_i], &t);
  knots = t.data.n * t.system.forms_n;
  for (size_t j = 0; j < t.system.nodes; j++) {
    ph_arc_turned(t.x + 4 * j, dx + 4 * j);
  }
  for (size_t k = knots; k < t.system.y_n; k += 2) {
    dy[k] = -t.y[k + 1];
    dy[k + 1] = t.y[k];
  }
  ph_arc_residual(&t.system, t.x, c);
  first = c[knots];
  before = ph_arc_dot(t.system.y_n - knots, t.y + knots, c + knots);
  ph_arc_retract(&t.system, t.x, dx, 0.7, to);
  ph_arc_retract_rows(&t.system, t.x, dx, 0.7, t.y, dy, y);
  ph_arc_residual(&t.system, to, c);
  ck_abs(ph_arc_dot(t.system.y_n - knots, y + knots, c + knots), before, 1e-13);
  ck_assert(fabs(c[knots] - first) > 1e-3); /* they did turn */
}

/* A step of any kind is x + dx to first order. */
PH_TEST_EACH(test_retract_is_a_step, SORTS) {
  struct unit_random r = unit_random_of(1110 + (uint64_t)_i);
  const double small = 1e-7;
  struct setting t;
  double to[X_MAX], dx[X_MAX];
  set_up(&r, &sorts[_i], &t);
  for (size_t k = 0; k < t.system.x_n; k++) {
    dx[k] = unit_random_in(&r, -1, 1);
  }
  ph_arc_retract(&t.system, t.x, dx, small, to);
  for (size_t k = 0; k < t.system.x_n; k++) {
    ck_abs((to[k] - t.x[k]) / small, dx[k], 1e-5);
  }
}

/* H of the spinor of a direction is the direction, near both poles too. */
PH_TEST(test_spinor) {
  struct unit_random r = unit_random_of(1140);
  for (int round = 0; round < 100; round++) {
    double small = round % 2 ? 1 : pow(10, unit_random_in(&r, -20, 0));
    double x = unit_random_in(&r, -1, 1), y = small * unit_random_in(&r, -1, 1);
    ph_vec3 d = ph_vec3_unit(ph_vec3_of(x, y, small));
    double w[4], v[4];
    ph_arc_spinor(d, w);
    image(w, v);
    ck_abs(v[0], 1, 1e-15);
    ck_abs(ph_vec3_abs(ph_vec3_sub(ph_vec3_of(v[1], v[2], v[3]), d)), 0, 1e-15);
  }
}

/* NaN is the largest, wherever it stands. */
PH_TEST(test_largest) {
  double v[3] = {-2, 1, -3};
  ck_abs(ph_arc_largest(0, v), 0, 0);
  ck_abs(ph_arc_largest(3, v), 3, 0);
  for (size_t i = 0; i < 3; i++) {
    double keep = v[i];
    v[i] = (double)NAN;
    ck_assert(isnan(ph_arc_largest(3, v)));
    v[i] = keep;
  }
}
