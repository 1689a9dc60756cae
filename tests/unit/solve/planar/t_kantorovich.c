/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The theorem of Kantorovich for the C2 equations: B against inverses of full
 * matrices, K against [GON18, table 2.5] and against what it promises, and the
 * theorem against Newton.  Also the forms of the equations, from which K comes.
 */
#include "unit.h"

#include "solve/planar/planar.h"

#include <gsl/gsl_complex.h>
#include <gsl/gsl_complex_math.h>
#include <gsl/gsl_linalg.h>

enum { N_MAX = 100, SYSTEMS = 200 };

static const double PI = 3.14159265358979323846;

/* The equations with room of their own, and a vector of unknowns. */
struct system {
  struct ph_planar_c2 c2;
  ph_cplx direction[N_MAX];
  double ratio[N_MAX], y[N_MAX + 1];
  struct ph_atph space[N_MAX];
  ph_cplx b[N_MAX + 2];
};

static void system_init(struct system *s, size_t n, bool closed) {
  memset(s, 0, sizeof *s);
  s->c2 = (struct ph_planar_c2){.n = n,
                                .closed = closed,
                                .twist = {1, 0},
                                .direction = s->direction,
                                .ratio = s->ratio,
                                .y = s->y,
                                .space = s->space,
                                .space_stride = 1};
}

/* Equations and unknowns that have nothing to do with each other. */
static void random_system(struct unit_random *r, size_t n, bool closed,
                          struct system *s) {
  system_init(s, n, closed);
  s->c2.twist = ph_cplx_polar(unit_random_in(r, -3, 3));
  for (size_t k = 0; k < n; k++) {
    s->space[k] = ph_atph_of(unit_random_in(r, 0, 2));
    s->direction[k] = ph_cplx_polar(unit_random_in(r, -4, 4));
    s->ratio[k] = unit_random_in(r, 0.2, 3);
    s->y[k] = unit_random_in(r, 0.2, 0.8);
  }
  s->y[0] = closed ? s->y[0] : 0.5;
  s->y[n] = s->y[0];
  for (int side = 0; side < 2; side++) {
    s->c2.end[side] = ph_cplx_polar(unit_random_in(r, -4, 4));
    s->c2.end_size[side] = unit_random_in(r, 0.2, 2);
  }
  for (size_t i = 0; i < ph_planar_unknowns(&s->c2); i++) {
    s->b[i] = unit_random_cplx(r, 1);
  }
}

/* Equations of a polygon of unit chords that turns gently, solved. */
static void solved_system(struct unit_random *r, size_t n, bool closed,
                          struct system *s) {
  struct ph_planar_report report;
  struct ph_diag diag;
  double heading = 0;
  system_init(s, n, closed);
  for (size_t k = 0; k < n; k++) {
    s->space[k] = ph_atph_of(unit_random_in(r, 0, 1.5));
    s->direction[k] = ph_cplx_polar(heading);
    s->ratio[k] = 1;
    heading += closed ? 2 * PI / (double)n * unit_random_in(r, 0.9, 1.1)
                      : unit_random_in(r, -0.8, 0.8);
  }
  for (size_t k = 0; k <= n; k++) {
    double a = s->space[k ? k - 1 : n - 1].slope, b = s->space[k % n].slope;
    s->y[k] = !closed && k % n == 0 ? 0.5 : a / (a + b);
  }
  for (int side = 0; side < 2; side++) {
    s->c2.end[side] = s->direction[side ? n - 1 : 0];
    s->c2.end_size[side] = 1;
  }
  ck_assert_int_eq(
      ph_planar_c2_solve(&s->c2, &unit_arena, s->b, &report, &diag), PH_OK);
}

/* The unknown over an end of a closed curve comes with its twist. */
static ph_cplx unknown(const struct system *s, size_t i, int by) {
  size_t n = ph_planar_unknowns(&s->c2);
  const ph_cplx zero = {0, 0};
  if (by < 0 && i == 0) {
    return s->c2.closed ? ph_cplx_mul(ph_cplx_conj(s->c2.twist), s->b[n - 1])
                        : zero;
  }
  if (by > 0 && i + 1 == n) {
    return s->c2.closed ? ph_cplx_mul(s->c2.twist, s->b[0]) : zero;
  }
  return by < 0 ? s->b[i - 1] : by > 0 ? s->b[i + 1] : s->b[i];
}

/* A row by its form, with the corner entries as entries of the matrix. */
static struct ph_tri_row row_of_form(const struct system *s, size_t i) {
  struct ph_planar_form f = ph_planar_form(&s->c2, i);
  ph_cplx l = unknown(s, i, -1), m = unknown(s, i, 0), r = unknown(s, i, 1);
  struct ph_tri_row row;
  row.lo.re = 2 * f.ll * l.re + f.lm * m.re + f.lr * r.re;
  row.lo.im = 2 * f.ll * l.im + f.lm * m.im + f.lr * r.im;
  row.di.re = f.lm * l.re + 2 * f.mm * m.re + f.mr * r.re;
  row.di.im = f.lm * l.im + 2 * f.mm * m.im + f.mr * r.im;
  row.up.re = f.lr * l.re + f.mr * m.re + 2 * f.rr * r.re;
  row.up.im = f.lr * l.im + f.mr * m.im + 2 * f.rr * r.im;
  row.f = ph_cplx_add(ph_cplx_mul(row.lo, l), ph_cplx_mul(row.di, m));
  row.f = ph_cplx_add(row.f, ph_cplx_mul(row.up, r));
  row.f = ph_cplx_sub(ph_cplx_scale(0.5, row.f), f.wanted);
  if (s->c2.closed && i == 0) {
    row.lo = ph_cplx_mul(ph_cplx_conj(s->c2.twist), row.lo);
  }
  if (s->c2.closed && i + 1 == ph_planar_unknowns(&s->c2)) {
    row.up = ph_cplx_mul(s->c2.twist, row.up);
  }
  return row;
}

/* Forms and rows are the same equations, and those of Newton: their measure
 * is, and the Newton step solves them. */
PH_TEST(test_rows) {
  struct unit_random r = unit_random_of(1);
  struct system s;
  for (int i = 0; i < SYSTEMS; i++) {
    struct ph_planar_measure m;
    ph_cplx step[N_MAX + 2];
    struct ph_tri tri;
    double sum2 = 0, size = 1;
    size_t n;
    random_system(&r, 3 + unit_random_below(&r, 20), i % 2, &s);
    n = ph_planar_unknowns(&s.c2);
    ck_assert(ph_tri_alloc(&tri, &unit_arena, n));
    m = ph_planar_newton_step(&s.c2, s.b, &tri, step);
    for (size_t k = 0; k < n; k++) {
      size = fmax(size, ph_cplx_abs(step[k]));
    }
    for (size_t k = 0; k < n; k++) {
      struct ph_tri_row row = ph_planar_row(&s.c2, s.b, k);
      struct ph_tri_row form = row_of_form(&s, k);
      ph_cplx left = ph_cplx_mul(row.lo, step[(k + n - 1) % n]);
      left = ph_cplx_add(left, ph_cplx_mul(row.di, step[k]));
      left = ph_cplx_add(left, ph_cplx_mul(row.up, step[(k + 1) % n]));
      ck_abs(unit_distance(left, row.f), 0, 1e-11 * size);
      ck_abs(unit_distance(row.lo, form.lo), 0, 1e-13);
      ck_abs(unit_distance(row.di, form.di), 0, 1e-13);
      ck_abs(unit_distance(row.up, form.up), 0, 1e-13);
      ck_abs(unit_distance(row.f, form.f), 0, 1e-13);
      sum2 += ph_cplx_norm2(row.f);
    }
    ck_rel(m.sum2, sum2, 1e-13);
    ph_arena_reset(&unit_arena);
  }
}

/* ||J^-1|| of the full matrix. */
static double full_norm(const struct system *s) {
  size_t n = ph_planar_unknowns(&s->c2);
  gsl_matrix_complex *j = gsl_matrix_complex_calloc(n, n);
  gsl_matrix_complex *inverse = gsl_matrix_complex_alloc(n, n);
  gsl_permutation *p = gsl_permutation_alloc(n);
  double norm = 0;
  int sign;
  for (size_t i = 0; i < n; i++) {
    struct ph_tri_row row = row_of_form(s, i);
    const ph_cplx entry[3] = {row.lo, row.di, row.up};
    for (size_t k = 0; k < 3; k++) {
      size_t column = (i + n + k - 1) % n;
      gsl_matrix_complex_set(j, i, column,
                             gsl_complex_rect(entry[k].re, entry[k].im));
      if (!s->c2.closed && i == 0 && k == 0) {
        gsl_matrix_complex_set(j, 0, n - 1, gsl_complex_rect(0, 0));
      }
    }
  }
  if (!s->c2.closed) { /* row n-1 has no entry in column 0 */
    gsl_matrix_complex_set(j, n - 1, 0, gsl_complex_rect(0, 0));
  }
  gsl_linalg_complex_LU_decomp(j, p, &sign);
  gsl_linalg_complex_LU_invert(j, p, inverse);
  for (size_t i = 0; i < n; i++) {
    double sum = 0;
    for (size_t k = 0; k < n; k++) {
      sum += gsl_complex_abs(gsl_matrix_complex_get(inverse, i, k));
    }
    norm = fmax(norm, sum);
  }
  gsl_permutation_free(p);
  gsl_matrix_complex_free(inverse);
  gsl_matrix_complex_free(j);
  return norm;
}

static struct ph_kantorovich kantorovich_of(const struct system *s) {
  struct ph_kantorovich k;
  struct ph_mark before, after;
  ck_assert_ptr_nonnull(ph_arena_array(&unit_arena, 1, 1)); /* it has a chunk */
  before = ph_arena_mark(&unit_arena);
  ck_assert(ph_planar_kantorovich(&s->c2, s->b, &unit_arena, &k));
  after = ph_arena_mark(&unit_arena);
  ck_assert_ptr_eq(before.chunk, after.chunk);
  ck_assert_uint_eq(before.used, after.used);
  return k;
}

/* Up to 64 unknowns, at any b. */
PH_TEST(test_norm_few) {
  struct unit_random r = unit_random_of(2);
  struct system s;
  for (int i = 0; i < 60; i++) {
    bool closed = i % 2;
    size_t n = i < 2 ? (closed ? 64 : 62) : 3 + unit_random_below(&r, 20);
    random_system(&r, n, closed, &s);
    ck_rel(kantorovich_of(&s).b, full_norm(&s), 1e-9);
    ph_arena_reset(&unit_arena);
  }
}

/* With more unknowns: the same of open curves, at any b and at solutions. */
PH_TEST(test_norm_open) {
  struct unit_random r = unit_random_of(3);
  struct system s;
  for (int i = 0; i < 20; i++) {
    size_t n = 63 + unit_random_below(&r, N_MAX - 63);
    (i % 2 ? random_system : solved_system)(&r, n, false, &s);
    ck_rel(kantorovich_of(&s).b, full_norm(&s), 1e-9);
    ph_arena_reset(&unit_arena);
  }
}

/* Of closed curves it is a bound, at solutions a close one. */
PH_TEST(test_norm_closed) {
  struct unit_random r = unit_random_of(4);
  struct system s;
  for (int i = 0; i < 20; i++) {
    size_t n = 65 + unit_random_below(&r, N_MAX - 65);
    double bound, norm;
    (i % 2 ? random_system : solved_system)(&r, n, true, &s);
    bound = kantorovich_of(&s).b;
    norm = full_norm(&s);
    ck_assert_double_ge(bound, norm * (1 - 1e-9));
    if (i % 2 == 0) {
      ck_assert_double_le(bound, norm * 1.01);
    }
    ph_arena_reset(&unit_arena);
  }
}

/* A regular J of which elimination without interchanges loses a pivot: di[1] -
 * lo[1] up[0] / di[0] = 0, where row 0 has two equal entries.  There is no
 * bound rather than a wrong one. */
PH_TEST(test_norm_lost_pivot) {
  struct unit_random r = unit_random_of(5);
  struct system s;
  struct ph_kantorovich k;
  struct ph_planar_form f;
  solved_system(&r, 80, false, &s);
  f = ph_planar_form(&s.c2, 1);
  for (int i = 0; i < 2; i++) { /* di[1] = lo[1] by the choice of b[2] */
    double sum = (f.lm - 2 * f.ll) * (i ? s.b[0].im : s.b[0].re) +
                 (2 * f.mm - f.lm) * (i ? s.b[1].im : s.b[1].re);
    *(i ? &s.b[2].im : &s.b[2].re) = -sum / (f.mr - f.lr);
  }
  ck_assert_double_lt(full_norm(&s), 1e3);
  k = kantorovich_of(&s);
  ck_abs(k.b, HUGE_VAL, 0);
  ck_abs(k.h, HUGE_VAL, 0);
  ck_assert(!k.certified);
}

/* [GON18, table 2.5]: pi/18 times 5 ... 17, the printed values, and those of
 * the formula. */
static const double table[][3] = {
    {5, 2, 0.07991573435815251},      {6, 2, 1.1780972450961762},
    {7, 9.9, 9.894736499143411},      {8, 53.5, 53.527023631495915},
    {9, 201.1, 201.0619298297467},    {10, 549.2, 549.1876289832294},
    {11, 1119.4, 1119.3798767065607}, {12, 1717.7, 1717.6657833502184},
    {13, 1965.8, 1965.7807032730339}, {14, 1620.0, 1619.9258331909245},
    {15, 884.2, 884.2273111779053},   {16, 260.5, 260.50228681537664},
    {17, 21.1, 21.111926481272192},
};

/*
 * The printed equations are epsilon (r(alpha) - r(0) - chord) with epsilon = 16
 * x^4 sin^4(alpha/2), x = 2 sin(alpha) (cos(alpha) - 1) for equal angles, and
 * w^2 - d at open ends.  So K is ours if h/|c| is alpha epsilon and |d| is 1.
 * The 2 that is printed for small angles is the K of open ends.
 */
PH_TEST(test_table_2_5) {
  for (size_t i = 0; i < COUNT(table); i++) {
    double alpha = table[i][0] * PI / 18;
    double x = 2 * sin(alpha) * (cos(alpha) - 1);
    double epsilon = 16 * pow(x * sin(alpha / 2), 4);
    for (int closed = 0; closed < 2; closed++) {
      struct unit_random r = unit_random_of(6);
      struct system s;
      random_system(&r, 5, closed, &s);
      for (size_t k = 0; k < 5; k++) {
        s.space[k] = ph_atph_of(alpha);
        s.ratio[k] = alpha * epsilon;
        s.y[k] = 0.5;
      }
      s.y[5] = 0.5;
      s.c2.end_size[0] = s.c2.end_size[1] = 1;
      ck_rel(kantorovich_of(&s).k, closed ? table[i][2] : fmax(2, table[i][2]),
             1e-10);
      if (!closed) {
        ck_abs(kantorovich_of(&s).k, table[i][1], 0.1);
      }
    }
  }
}

/* ||F'(x) - F'(y)|| <= K ||x - y||, and some difference comes near. */
PH_TEST(test_lipschitz) {
  struct unit_random r = unit_random_of(7);
  double sharpest = 0;
  for (int i = 0; i < SYSTEMS; i++) {
    struct system s;
    size_t n;
    double distance = 0, norm = 0, k;
    random_system(&r, 3 + unit_random_below(&r, 4), i % 2, &s);
    n = ph_planar_unknowns(&s.c2);
    k = kantorovich_of(&s).k;
    for (size_t j = 0; j < n; j++) { /* F' is linear: s.b is x - y */
      distance = fmax(distance, ph_cplx_abs(s.b[j]));
    }
    for (size_t j = 0; j < n; j++) {
      struct ph_tri_row row = ph_planar_row(&s.c2, s.b, j);
      norm = fmax(norm, ph_cplx_abs(row.lo) + ph_cplx_abs(row.di) +
                            ph_cplx_abs(row.up));
    }
    ck_assert_double_le(norm, k * distance * (1 + 1e-14));
    sharpest = fmax(sharpest, norm / (k * distance));
    ph_arena_reset(&unit_arena);
  }
  ck_assert_double_gt(sharpest, 0.7);
}

/* h and the radius are what they are called. */
static void check_formulas(const struct ph_kantorovich *k) {
  ck_rel(k->h, k->b * k->c * k->k, 1e-15);
  ck_assert_int_eq(k->certified, k->h <= 0.5);
  if (k->certified) {
    /* the smaller root of B K r^2 / 2 - r + C */
    double r = k->radius;
    ck_abs(k->b * k->k * r * r / 2 - r + k->c, 0, 1e-14 * k->c);
    ck_assert(r >= k->c && r <= 2 * k->c * (1 + 1e-15));
  } else {
    ck_abs(k->radius, HUGE_VAL, 0);
  }
}

/* Newton from where the theorem holds goes no further than it says. */
PH_TEST(test_theorem) {
  struct unit_random r = unit_random_of(8);
  int certified = 0, refused = 0;
  for (int i = 0; i < SYSTEMS; i++) {
    struct system s;
    struct ph_kantorovich k;
    struct ph_tri tri;
    ph_cplx from[N_MAX + 2], step[N_MAX + 2];
    double size = pow(10, unit_random_in(&r, -6, 0)), moved = 0;
    size_t n;
    solved_system(&r, 5 + unit_random_below(&r, i < 10 ? 90 : 10), i % 2, &s);
    n = ph_planar_unknowns(&s.c2);
    for (size_t j = 0; j < n; j++) {
      s.b[j] = ph_cplx_add(s.b[j], unit_random_cplx(&r, size));
      from[j] = s.b[j];
    }
    k = kantorovich_of(&s);
    check_formulas(&k);
    refused += !k.certified;
    certified += k.certified;
    ck_assert(ph_tri_alloc(&tri, &unit_arena, n));
    for (int t = 0; t < 60 && k.certified; t++) {
      ph_planar_newton_step(&s.c2, s.b, &tri, step);
      for (size_t j = 0; j < n; j++) {
        s.b[j] = ph_cplx_sub(s.b[j], step[j]);
      }
    }
    for (size_t j = 0; j < n; j++) {
      moved = fmax(moved, unit_distance(s.b[j], from[j]));
    }
    if (k.certified) {
      ck_assert_double_le(sqrt(ph_planar_residual(&s.c2, s.b).max2), 1e-13);
      ck_assert_double_le(moved, k.radius + 1e-13);
      ck_assert_double_ge(moved, 0.5 * k.c);
    }
    ph_arena_reset(&unit_arena);
  }
  ck_assert_int_ge(certified, SYSTEMS / 4);
  ck_assert_int_ge(refused, SYSTEMS / 20);
}

/* Solutions are certified, of any number of points. */
PH_TEST(test_solutions) {
  struct unit_random r = unit_random_of(9);
  for (int i = 0; i < 40; i++) {
    struct system s;
    struct ph_kantorovich k;
    solved_system(&r, 3 + unit_random_below(&r, N_MAX - 3), i % 2, &s);
    k = kantorovich_of(&s);
    check_formulas(&k);
    ck_assert(k.certified);
    ck_assert_double_lt(k.h, 1e-9);
    ck_assert_double_lt(k.radius, 1e-11);
    ph_arena_reset(&unit_arena);
  }
}

/* Nothing is certified where J is singular or anything is not a number. */
PH_TEST(test_nothing) {
  struct unit_random r = unit_random_of(10);
  for (int i = 0; i < 4; i++) {
    size_t n = i / 2 ? 80 : i % 2 ? 4 : 2;
    for (int what = 0; what < 2; what++) {
      struct system s;
      struct ph_kantorovich k;
      solved_system(&r, n, i % 2, &s);
      for (size_t j = 0; j < n && what == 0; j++) {
        s.b[j] = ph_cplx_of(0, 0);
      }
      if (what) {
        s.b[n / 2] = ph_cplx_of(nan(""), 0);
      }
      k = kantorovich_of(&s);
      ck_assert(!k.certified);
      ck_abs(k.b, HUGE_VAL, 0);
      ck_abs(k.h, HUGE_VAL, 0);
      ck_abs(k.radius, HUGE_VAL, 0);
    }
  }
}
