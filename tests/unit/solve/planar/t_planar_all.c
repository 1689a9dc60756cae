/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Every solution of the C2 equations: as many as Bezout's theorem says, each a
 * curve that the certificate accepts, none twice; those of [GON18, table 2.1];
 * and what becomes of data that were made to break the count.  This test
 * includes the source: paths are practically never lost by themselves.
 */
#include "solve/planar/all.c" /* NOLINT */

#include "table21_unit.h"
#include "planar_unit.h"
#include "unit.h"

#include "check/certify.h"
#include "curve/fair/describe.h"
#include "curve/fair/energy.h"
#include "solve/planar/planar.h"

enum { N_MAX = PH_PLANAR_ALL_MAX, SETS = 200 };

static const double PI = 3.14159265358979323846;

/* A problem, its equations, and all solutions. */
struct set {
  struct unit_solution u;
  struct ph_planar_data data;
  struct ph_planar_all all;
};

static void set_word(struct unit_solution *u, size_t field, const char *word) {
  u->problem.field[field] = (struct ph_value){.kind = PH_WORD, .word = word};
}

static void set_of(struct set *f, const double *v, size_t n, bool closed) {
  memset(f, 0, sizeof *f);
  f->u = unit_planar_of(v, n, closed);
}

static void atph(struct set *f, double alpha) {
  set_word(&f->u, PH_F_BASIS, "atph");
  f->u.problem.field[PH_F_ALPHA] =
      (struct ph_value){.kind = PH_NUMBER, .number = alpha};
}

static enum ph_status solve_all(struct set *f) {
  struct unit_solution *u = &f->u;
  struct ph_mark before, after;
  enum ph_status status;
  ck_assert_int_eq(ph_planar_data_of(&u->problem, &u->scratch, &u->scratch,
                                     &u->scratch, &f->data, &u->diag),
                   PH_OK);
  before = ph_arena_mark(&u->scratch);
  status =
      ph_planar_all(&f->data.c2, &u->arena, &u->scratch, &f->all, &u->diag);
  after = ph_arena_mark(&u->scratch);
  ck_assert_ptr_eq(before.chunk, after.chunk);
  ck_assert_uint_eq(before.used, after.used);
  return status;
}

static const ph_cplx *solution(const struct set *f, size_t i) {
  return f->all.b + i * ph_planar_unknowns(&f->data.c2);
}

/* 2^(N+1) open, 2^N closed. */
static size_t bezout(const struct set *f) {
  return (size_t)1 << (f->data.n + !f->data.closed);
}

/* The curve of solution i, in `curve`, which has room. */
static void curve_of(struct set *f, size_t i, struct ph_curve *curve) {
  struct ph_planar_loops loops;
  f->data.c2.twist = ph_cplx_of(f->all.twist[i], 0);
  ph_planar_curve_fill(&f->data, solution(f, i), &f->u.arena, curve, &loops);
}

/* |a - b| or |a + b|, whichever is smaller; or any number above `enough`, if
 * that is larger. */
static double apart(const ph_cplx *a, const ph_cplx *b, size_t n,
                    double enough) {
  double minus2 = 0, plus2 = 0, enough2 = enough * enough;
  for (size_t i = 0; i < n && (minus2 <= enough2 || plus2 <= enough2); i++) {
    double m2 = ph_cplx_norm2(ph_cplx_sub(a[i], b[i]));
    double p2 = ph_cplx_norm2(ph_cplx_add(a[i], b[i]));
    minus2 = m2 > minus2 ? m2 : minus2;
    plus2 = p2 > plus2 ? p2 : plus2;
  }
  return sqrt(minus2 < plus2 ? minus2 : plus2);
}

/* The smallest distance of two solutions of the same twist. */
static double nearest(const struct set *f) {
  double least = HUGE_VAL;
  size_t n = ph_planar_unknowns(&f->data.c2);
  for (size_t i = 0; i < f->all.n; i++) {
    for (size_t j = 0; j < i; j++) {
      if (unit_same(f->all.twist[i], f->all.twist[j])) {
        least = fmin(least, apart(solution(f, i), solution(f, j), n, least));
      }
    }
  }
  return least;
}

/* The equations hold: in units of their terms, to rounding. */
static void check_equations(struct set *f, int set) {
  for (size_t i = 0; i < f->all.n; i++) {
    double error;
    f->data.c2.twist = ph_cplx_of(f->all.twist[i], 0);
    error = ph_planar_rounding(&f->data.c2, solution(f, i));
    ck_assert_msg(error <= 1e-13, "seed %lu, set %d, curve %zu: %.3g",
                  unit_seed(), set, i, error);
  }
}

/* The bookkeeping, of any data. */
static void check_counts(const struct set *f) {
  size_t sum = 0, plus = 0;
  for (size_t i = 0; i < f->all.n; i++) {
    sum += f->all.multiplicity[i];
    plus += f->all.twist[i] > 0 ? f->all.multiplicity[i] : 0;
    ck_abs(fabs(f->all.twist[i]), 1, 0);
    ck_assert(i == 0 || f->all.twist[i] <= f->all.twist[i - 1]);
  }
  ck_assert_uint_eq(sum, bezout(f));
  ck_assert_uint_eq(plus, f->data.closed ? sum / 2 : sum);
  ck_assert_uint_eq(f->all.paths - f->all.lost, sum);
}

/* Every curve is one that the certificate accepts, and bends or stands still.
 */
static void check_curves(struct set *f, int set) {
  struct ph_curve curve;
  struct ph_diag *diag = &f->u.diag;
  ck_assert_int_eq(ph_planar_curve_alloc(&f->data, &f->u.arena, &curve, diag),
                   PH_OK);
  for (size_t i = 0; i < f->all.n; i++) {
    struct ph_diagnostics d = {.known = 0};
    enum ph_status status;
    curve_of(f, i, &curve);
    status =
        ph_certify("planar", &f->u.problem, &curve, &f->u.scratch, &d, diag);
    if (status == PH_OK) {
      status = ph_describe_planar(&curve, &f->u.scratch, &d, diag);
    }
    ck_assert_msg(status == PH_OK,
                  "seed %lu, set %d, %zu segments, curve %zu: %s %s",
                  unit_seed(), set, curve.n, i, diag->field, diag->message);
    if (!(d.known >> PH_D_ENERGY & 1)) { /* it stands still */
      ck_assert_double_gt(d.value[PH_D_LOOPS], 0);
      continue;
    }
    ck_assert_double_gt(d.value[PH_D_ENERGY], 0);
    ck_assert_double_gt(d.value[PH_D_ABSOLUTE_ROTATION_INDEX], 0);
    if (curve.closed) { /* Cauchy and Schwarz: E L >= (2 pi)^2 */
      ck_assert_double_ge(d.value[PH_D_IES], 4 * PI * PI * (1 - 1e-12));
    }
  }
}

/* As many different curves as there should be, of random data. */
PH_TEST(test_random) {
  struct unit_random r = unit_random_of(1);
  for (int set = 0; set < unit_count(SETS); set++) {
    bool closed = set % 2;
    size_t n = (closed ? 3 : 2) + unit_random_below(&r, closed ? 4 : 6);
    double v[2 * N_MAX], ends[4];
    struct set f;
    for (size_t i = 0; i < 2 * n; i++) {
      v[i] = unit_random_in(&r, -1, 1);
    }
    for (size_t i = 0; i < 4; i++) {
      ends[i] = unit_random_in(&r, -2, 2);
    }
    set_of(&f, v, n, closed);
    if (!closed && (n == 2 || set % 8 == 0)) {
      unit_planar_ends(&f.u, ends);
    }
    if (set / 2 % 2) {
      atph(&f, unit_random_in(&r, 0.1, 2.1));
    }
    ck_assert_int_eq(solve_all(&f), PH_OK);
    check_counts(&f);
    ck_assert_uint_eq(f.all.n, bezout(&f));
    ck_assert_double_gt(nearest(&f), 1e-6);
    check_equations(&f, set);
    if (set % 16 < 4) { /* of each kind some: this takes time */
      check_curves(&f, set);
    }
    unit_solution_free(&f.u);
  }
}

/* Chords of very different lengths on uniform knots: the unknowns have very
 * different sizes, too. */
PH_TEST(test_uneven) {
  struct unit_random r = unit_random_of(2);
  for (int set = 0; set < unit_count(20); set++) {
    bool closed = set % 2;
    size_t n = closed ? 5 : 6;
    double v[2 * N_MAX], x = 0, y = 0, heading = 0;
    struct set f;
    for (size_t i = 0; i < n; i++) {
      double chord = pow(10, unit_random_in(&r, -3, 0));
      v[2 * i] = x;
      v[2 * i + 1] = y;
      x += chord * cos(heading);
      y += chord * sin(heading);
      heading += unit_random_in(&r, -1, 1);
    }
    set_of(&f, v, n, closed);
    unit_planar_rule(&f.u, "uniform");
    ck_assert_int_eq(solve_all(&f), PH_OK);
    check_counts(&f);
    ck_assert_uint_eq(f.all.n, bezout(&f));
    check_equations(&f, set);
    unit_solution_free(&f.u);
  }
}

/* [GON18, table 2.1]: the points, for angles and ends that are not printed. */
static const double table_points[] = {1, 2, 3, 5, 6, 4, 7, 3, 9, 4};
static const double table_ends[] = {1.5, 5, 2.5, 2};

static int by_rotation(const void *a, const void *b) {
  const double *x = a, *y = b;
  return (x[0] > y[0]) - (x[0] < y[0]);
}

PH_TEST(test_table_2_1) {
  struct set f;
  struct ph_curve curve;
  double found[32][2], energy[32];
  size_t good = 0, unknowns;
  ph_cplx b[6];
  struct ph_planar_report report;
  set_of(&f, table_points, 5, false);
  atph(&f, PI / 3);
  unit_planar_ends(&f.u, table_ends);
  ck_assert_int_eq(solve_all(&f), PH_OK);
  check_counts(&f);
  ck_assert_uint_eq(f.all.n, 32);
  ck_assert_uint_eq(f.all.lost, 0);
  check_curves(&f, 0);
  ck_assert_int_eq(
      ph_planar_curve_alloc(&f.data, &f.u.arena, &curve, &f.u.diag), PH_OK);
  for (size_t i = 0; i < 32; i++) {
    struct ph_energy e;
    curve_of(&f, i, &curve);
    ck_assert(ph_energy_planar(&curve, &e));
    found[i][0] = e.absolute_rotation;
    found[i][1] = curve.length;
    energy[i] = e.bending;
    good = e.bending < energy[good] ? i : good;
  }
  /* the one that is asked for otherwise is the one that bends least */
  unknowns = ph_planar_unknowns(&f.data.c2);
  ck_assert_int_eq(
      ph_planar_c2_solve(&f.data.c2, &f.u.scratch, b, &report, &f.u.diag),
      PH_OK);
  ck_assert_double_le(apart(solution(&f, good), b, unknowns, 1), 1e-11);
  ck_abs(found[good][0], table21_unit[0][0], 1e-8);
  qsort(found, 32, sizeof found[0], by_rotation);
  for (size_t i = 0; i < 32; i++) {
    ck_abs(found[i][0], table21_unit[i][0], 1e-8);
    ck_abs(found[i][1], table21_unit[i][1], 1e-9);
  }
  unit_solution_free(&f.u);
}

/* Ten segments have 2048 curves, or seven 256; the same every time. */
PH_TEST(test_ten) {
  struct unit_random r = unit_random_of(3);
  size_t n = unit_count(10) < 10 ? 7 : 10, curves = (size_t)2 << n;
  double v[22];
  struct set f;
  const ph_cplx *first;
  for (size_t i = 0; i <= n; i++) {
    v[2 * i] = (double)i + unit_random_in(&r, -0.3, 0.3);
    v[2 * i + 1] = unit_random_in(&r, -1, 1);
  }
  set_of(&f, v, n + 1, false);
  ck_assert_int_eq(solve_all(&f), PH_OK);
  check_counts(&f);
  ck_assert_uint_eq(f.all.n, curves);
  ck_assert_uint_eq(f.all.lost, 0);
  ck_assert_double_gt(nearest(&f), 1e-6);
  first = f.all.b;
  ck_assert_int_eq(solve_all(&f), PH_OK);
  ck_assert_uint_eq(f.all.n, curves);
  ck_assert_int_eq(memcmp(first, f.all.b, curves * (n + 2) * sizeof *first), 0);
  unit_solution_free(&f.u);
}

/* The most segments, and one more. */
PH_TEST(test_most) {
  double v[2 * (PH_PLANAR_ALL_MAX + 2)];
  struct set f;
  for (size_t i = 0; i < PH_PLANAR_ALL_MAX + 2; i++) {
    v[2 * i] = cos((double)i * 0.4);
    v[2 * i + 1] = (1 + (double)i / 30) * sin((double)i * 0.4);
  }
  set_of(&f, v, PH_PLANAR_ALL_MAX, true);
  ck_assert_int_eq(solve_all(&f), PH_OK);
  check_counts(&f);
  ck_assert_uint_eq(f.all.n, 4096);
  unit_solution_free(&f.u);
  for (int closed = 0; closed < 2; closed++) {
    set_of(&f, v, PH_PLANAR_ALL_MAX + (closed ? 1 : 2), closed);
    ck_assert_int_eq(solve_all(&f), PH_E_BAD_VALUE);
    ck_assert_uint_eq(f.all.n, 0);
    ck_assert_str_eq(f.u.diag.field, "solutions");
    ck_assert_ptr_nonnull(strstr(f.u.diag.message, "than 12"));
    unit_solution_free(&f.u);
  }
}

/* Whether the solutions have the mirror image of solution i at the x axis. */
static bool has_mirror(const struct set *f, size_t i) {
  size_t n = ph_planar_unknowns(&f->data.c2);
  ph_cplx mirror[N_MAX + 2];
  for (size_t k = 0; k < n; k++) {
    mirror[k] = ph_cplx_conj(solution(f, i)[k]);
  }
  for (size_t j = 0; j < f->all.n; j++) {
    if (unit_same(f->all.twist[i], f->all.twist[j]) &&
        apart(mirror, solution(f, j), n, 1e-10) <= 1e-10) {
      return true;
    }
  }
  return false;
}

/* Points on a line, at which roots do meet on the way without a gamma: every
 * curve has its mirror image among the others. */
PH_TEST(test_line) {
  const double x[][6] = {{0, 1, 2, 3, 4, 5},
                         {0, 1, 0, 1, 0, 2},
                         {0, 3, 1, 2, 7, 4},
                         {0, 1e-3, 1, 2, 2.001, 2.002}};
  for (size_t i = 0; i < COUNT(x); i++) {
    for (int closed = 0; closed < 2; closed++) {
      double v[12] = {0};
      struct set f;
      for (size_t k = 0; k < 6; k++) {
        v[2 * k] = x[i][k];
      }
      set_of(&f, v, 6, closed);
      ck_assert_int_eq(solve_all(&f), PH_OK);
      check_counts(&f);
      ck_assert_uint_eq(f.all.n, bezout(&f));
      for (size_t k = 0; k < f.all.n; k++) {
        ck_assert(has_mirror(&f, k));
      }
      unit_solution_free(&f.u);
    }
  }
}

/* The most symmetric data: regular polygons. */
PH_TEST(test_polygon) {
  for (size_t n = 3; n <= 6; n++) {
    double v[12];
    struct set f;
    for (size_t i = 0; i < n; i++) {
      v[2 * i] = cos(2 * PI * (double)i / (double)n);
      v[2 * i + 1] = sin(2 * PI * (double)i / (double)n);
    }
    set_of(&f, v, n, true);
    ck_assert_int_eq(solve_all(&f), PH_OK);
    check_counts(&f);
    ck_assert_uint_eq(f.all.n, bezout(&f));
    check_curves(&f, (int)n);
    unit_solution_free(&f.u);
  }
}

/*
 * One PH segment from 0 to c with end derivatives 1, on a knot interval of 1:
 * w0 = 1, w2 = 1 or -1.  For w2 = 1,
 *
 *   2 w1^2 + 6 w1 + 7 - 15 c = 0,
 *
 * which at c = 1/6 has the double root w1 = -3/2.
 */
static void set_of_segment(struct set *f, double c) {
  const double v[4] = {0, 0, c, 0}, ends[4] = {1, 0, 1, 0}, knots[2] = {0, 1};
  set_of(f, v, 2, false);
  unit_planar_ends(&f->u, ends);
  unit_planar_knots(&f->u, knots, 2);
}

PH_TEST(test_double_root) {
  struct set f;
  struct ph_curve curve;
  size_t doubles = 0;
  set_of_segment(&f, 1.0 / 6);
  ck_assert_int_eq(solve_all(&f), PH_OK);
  check_counts(&f);
  ck_assert_uint_eq(f.all.n, 3);
  check_curves(&f, 0);
  ck_assert_int_eq(
      ph_planar_curve_alloc(&f.data, &f.u.arena, &curve, &f.u.diag), PH_OK);
  for (size_t i = 0; i < 3; i++) {
    const double *w = curve.preimage.v;
    curve_of(&f, i, &curve);
    if (f.all.multiplicity[i] == 2) {
      /* its digits are half of all digits */
      ck_abs(w[2] / w[0], -1.5, 1e-6);
      ck_abs(w[3] / w[0], 0, 1e-6);
      ck_rel(w[4], w[0], 1e-14);
      doubles++;
    } else {
      ck_rel(w[4], -w[0], 1e-14);
      ck_rel(fabs(w[3] / w[0]), sqrt(1.25), 1e-12);
    }
  }
  ck_assert_uint_eq(doubles, 1);
  unit_solution_free(&f.u);
}

/* Two roots that are nearly one, sqrt(5 |part|) apart, are two as long as
 * doubles tell them apart. */
PH_TEST(test_near_double_root) {
  for (int side = -1; side <= 1; side += 2) {
    for (double part = 1e-2; part > 1e-11; part /= 10) {
      struct set f;
      set_of_segment(&f, (1 + side * part) / 6);
      ck_assert_int_eq(solve_all(&f), PH_OK);
      check_counts(&f);
      ck_assert_msg(f.all.n == 4, "c = (1 %+g) / 6: %zu", side * part, f.all.n);
      ck_assert_uint_eq(f.all.lost, 0);
      ck_rel(nearest(&f), ldexp(sqrt(5 * part), f.data.exponent / 2), 0.01);
      unit_solution_free(&f.u);
    }
  }
}

/* With a gamma of 1 the real roots of a segment from 0 to less than 1/6 would
 * have to meet on their way to become complex: all paths are lost, and followed
 * again with another gamma. */
PH_TEST(test_again) {
  const struct attempt tries[ATTEMPTS] = {{0, 1e-3}, {0.7, 1e-3}};
  struct set f;
  struct family family;
  struct ends ends;
  size_t most = 0;
  set_of_segment(&f, 0.1);
  ck_assert_int_eq(solve_all(&f), PH_OK);
  ck_assert_uint_eq(f.all.paths, 4);
  memset(&f.all, 0, sizeof f.all);
  f.data.c2.twist = ph_cplx_of(1, 0);
  family.n = 3;
  family.attempts = tries;
  ck_assert(
      allocate(3, 4, 4, &f.u.arena, &f.u.scratch, &family, &ends, &f.all));
  ck_assert_int_eq(solve_twist(&f.data.c2, &family, &f.u.scratch, &ends, &f.all,
                               &most, &f.u.diag),
                   PH_OK);
  ck_assert_uint_eq(most, 4);
  ck_assert_uint_eq(f.all.n, 4);
  ck_assert_uint_eq(f.all.lost, 4);
  ck_assert_uint_eq(f.all.paths, 8);
  check_counts(&f);
  check_curves(&f, 0);
  unit_solution_free(&f.u);
}

/* A path that went astray: its end is another's, up to the sign. */
PH_TEST(test_astray) {
  struct set f;
  struct family family;
  struct ends ends = {0};
  struct ph_planar_all unused;
  set_of(&f, table_points, 5, false);
  ck_assert_int_eq(solve_all(&f), PH_OK);
  ck_assert_uint_eq(f.all.n, 32);
  ck_assert(
      allocate(6, 32, 32, &f.u.arena, &f.u.scratch, &family, &ends, &unused));
  memcpy(ends.b, f.all.b, (size_t)32 * 6 * sizeof *ends.b);
  for (size_t k = 0; k < 6; k++) {
    ends.b[31 * 6 + k] = ph_cplx_scale(-1, ends.b[7 * 6 + k]);
  }
  for (size_t i = 0; i < 32; i++) {
    ck_assert(ends_add(&ends, &f.data.c2, &f.u.scratch));
    ck_assert(ends.is_simple[i]);
  }
  ck_assert_uint_eq(ends_compare(&ends, 6, &f.u.scratch), 31);
  for (size_t i = 0; i < 32; i++) {
    ck_assert_uint_eq(ends.copies[i], i == 7 ? 2 : i == 31 ? 0 : 1);
  }
  unit_solution_free(&f.u);
}

/* Data without solutions, which the checks of data never let through. */
PH_TEST(test_none) {
  const double bad[] = {0, HUGE_VAL, nan("")};
  for (int closed = 0; closed < 2; closed++) {
    for (size_t i = 0; i < COUNT(bad); i++) {
      const double v[6] = {0, 0, 1, 0, 1, 2};
      struct unit_solution u = unit_planar_of(v, 3, closed);
      struct ph_planar_data d;
      struct ph_planar_all all;
      ck_assert_int_eq(ph_planar_data_of(&u.problem, &u.scratch, &u.scratch,
                                         &u.scratch, &d, &u.diag),
                       PH_OK);
      d.c2.ratio[1] = bad[i];
      d.c2.twist = ph_cplx_of(-1, 0);
      ck_assert_int_eq(
          ph_planar_all(&d.c2, &u.arena, &u.scratch, &all, &u.diag),
          PH_E_NO_CONVERGENCE);
      ck_assert_uint_eq(all.n, 0);
      ck_assert_uint_eq(all.lost, all.paths);
      ck_assert_str_eq(u.diag.message, "of 8 solutions only 0 were found");
      ck_abs(d.c2.twist.re, -1, 0);
      unit_solution_free(&u);
    }
  }
}
