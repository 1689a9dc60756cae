/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Properties of curves of Tschirnhausen cubics on random data: what must follow
 * when the data are moved, turned, scaled, mirrored, reversed or begun
 * elsewhere; that there is a curve where there must be one, the best of all.
 * Every curve is certified, and looked at by tc/data.c.
 *
 * The seed is 1, or PH_SEED; PH_LONG=1 takes ten times as many data.
 */
#include "tc_data.h"
#include "tc_unit.h"
#include "unit.h"

#include "kernel/pi.h"
#include "solve/tc/tc.h"

static struct unit_solution one, other;
static struct tc_data data, image;

static void finish(void) {
  unit_solution_free(&one);
  unit_solution_free(&other);
}

/* ---- motions ------------------------------------------------------------- */

/* A similarity of the plane: p times `turn`, its conjugate if `mirror`, plus
 * `shift`; then backward from point `first`, or on from it. */
struct motion {
  ph_cplx turn, shift;
  bool mirror, reverse;
  size_t first;
};

static const struct motion REST = {{1, 0}, {0, 0}, false, false, 0};

static ph_cplx turned(const struct motion *m, ph_cplx p) {
  return ph_cplx_mul(m->turn, m->mirror ? ph_cplx_conj(p) : p);
}

static ph_cplx moved(const struct motion *m, ph_cplx p) {
  return ph_cplx_add(turned(m, p), m->shift);
}

/* The point of the data that point k of the image comes from. */
static size_t point_from(const struct motion *m, size_t k) {
  size_t n = data.n;
  return !m->reverse   ? (m->first + k) % n
         : data.closed ? (m->first + n - k) % n
                       : n - 1 - k;
}

static size_t interval_from(const struct motion *m, size_t k) {
  size_t n = tc_intervals(&data);
  return !m->reverse   ? (m->first + k) % n
         : data.closed ? (m->first + 2 * n - 1 - k) % n
                       : n - 1 - k;
}

static void move_data(const struct motion *m) {
  double sign = m->reverse ? -1 : 1;
  image = data;
  for (size_t k = 0; k < data.n; k++) {
    size_t from = point_from(m, k);
    image.point[k] = moved(m, data.point[from]);
    image.vector[k] = ph_cplx_scale(sign, turned(m, data.vector[from]));
  }
  for (size_t i = 0; i < 2; i++) {
    size_t from = m->reverse ? 1 - i : i;
    image.end[i] = ph_cplx_scale(sign, turned(m, data.end[from]));
  }
  image.tolerance *= ph_cplx_abs(m->turn);
  image.joint_angle *= m->mirror ? -1 : 1;
  image.joint_position =
      m->reverse ? 1 - data.joint_position : data.joint_position;
}

/* Backward, w2 takes the place of w0: with the sign - of w2 that changes the
 * sign of w0 + w2, and so that of rho. */
static enum ph_root root_from(const struct motion *m, enum ph_root root) {
  return !m->reverse                   ? root
         : root == PH_ROOT_MINUS_PLUS  ? PH_ROOT_MINUS_MINUS
         : root == PH_ROOT_MINUS_MINUS ? PH_ROOT_MINUS_PLUS
                                       : root;
}

/* How far cubics of one interval are from where they should be, over its
 * length. */
static double interval_away(const struct motion *m, size_t k) {
  const struct ph_interval *a = &one.result.intervals[interval_from(m, k)];
  const struct ph_interval *b = &other.result.intervals[k];
  double worst = 0;
  ck_that(b->root == root_from(m, a->root), "roots %d and %d", (int)a->root,
          (int)b->root);
  ck_assert_uint_eq(a->last - a->first, b->last - b->first);
  for (size_t i = 0; i < 4 * (b->last - b->first + 1); i++) {
    size_t j = m->reverse ? 4 * (a->last + 1) - 1 - i : 4 * a->first + i;
    ph_cplx wanted = moved(m, tc_point(&one.result.curve, j / 4, j % 4));
    ph_cplx found = tc_point(&other.result.curve, b->first + i / 4, i % 4);
    worst = unit_larger(worst, unit_distance(wanted, found));
  }
  return worst / b->length;
}

static double diagnostic(const struct unit_solution *s,
                         enum ph_diagnostic which) {
  return unit_diagnostic(&s->result.diagnostics, which);
}

/* The image has the curve of the data, moved. */
static void ck_moved(const struct motion *m, double tol, size_t which) {
  const double scale = ph_cplx_abs(m->turn);
  double length = one.result.curve.length, energy, found, bend, away = 0;
  tc_must(&image, which, &other);
  for (size_t k = 0; k < tc_intervals(&data); k++) {
    away = unit_larger(away, interval_away(m, k));
  }
  ck_that(away <= tol, "it is %.3g away", away);
  ck_that(unit_near_rel(other.result.curve.length, scale * length, tol),
          "length %.17g, not %.17g", other.result.curve.length, scale * length);
  /* far away a loop may be no larger than what coordinates are rounded by */
  if (ph_cplx_abs(m->shift) < 100) {
    ck_abs(diagnostic(&other, PH_D_LOOPS), diagnostic(&one, PH_D_LOOPS), 0);
    ck_abs(diagnostic(&other, PH_D_SIMPLE), diagnostic(&one, PH_D_SIMPLE), 0);
  }
  energy = length * diagnostic(&one, PH_D_ENERGY);
  found = other.result.curve.length * diagnostic(&other, PH_D_ENERGY);
  bend = diagnostic(&one, PH_D_MAX_CURVATURE) * length;
  /* it is computed at the scale of the curve, a straight line's to rounding */
  tol = unit_larger(tol, 1e-11);
  ck_that(unit_near(found, energy, tol * (1 + bend) * (1e-12 + energy)),
          "energy * length %.17g, not %.17g", found, energy);
}

/* What two solutions of one problem may differ by: they are closed formulas,
 * and data near the border of what is possible are few.  A lambda that is
 * searched for is at a minimum of F, known to the root of what F is; cubics of
 * an approximation are made equally distant. */
static double same(void) {
  bool closed_form = data.family == TC_ONE || data.family == TC_LAMBDA ||
                     data.family == TC_CHORD || data.family == TC_C1 ||
                     data.family == TC_SPLINE;
  return closed_form ? 1e-11 : 1e-6;
}

static void turn(struct unit_random *r, struct motion *m) {
  m->turn = ph_cplx_polar(unit_random_in(r, -PH_PI, PH_PI));
  m->shift = unit_random_cplx(r, 5);
}

static void scale(struct unit_random *r, struct motion *m) {
  m->turn = ph_cplx_of(pow(10, unit_random_in(r, -9, 9)), 0);
}

static void reverse(struct unit_random *r, struct motion *m) {
  m->first = data.closed ? unit_random_below(r, data.n) : 0;
  m->reverse = true;
}

static void start(struct unit_random *r, struct motion *m) {
  m->first = data.closed ? unit_random_below(r, data.n) : 0;
}

/* Coordinates are multiples of 2^-20, so that none is rounded: only those of
 * the result are. */
static void far(struct unit_random *r, struct motion *m) {
  (void)r;
  m->shift = ph_cplx_of(1e6, -1e6);
}

/* Only signs change. */
static void mirror(struct unit_random *r, struct motion *m) {
  (void)r;
  m->mirror = true;
}

/* A power of four has a root. */
static void scale_exactly(struct unit_random *r, struct motion *m) {
  m->turn = ph_cplx_of(ldexp(1, 2 * ((int)unit_random_below(r, 201) - 100)), 0);
}

static const struct {
  void (*choose)(struct unit_random *, struct motion *);
  bool exact; /* not a digit differs */
} changes[] = {{turn, false},        {scale, false}, {reverse, false},
               {start, false},       {far, false},   {mirror, true},
               {scale_exactly, true}};
enum { CHANGES = COUNT(changes) };

PH_TEST_EACH(test_motion, CHANGES) {
  struct unit_random r = unit_random_of(1 + (uint64_t)_i);
  size_t solved = 0;
  for (size_t i = 0; i < unit_cases(15 * TC_FAMILY_N); i++) {
    struct motion m = REST;
    double tol;
    tc_of(&r, (enum tc_family)(i % TC_FAMILY_N), &data);
    changes[_i].choose(&r, &m);
    move_data(&m);
    tol = changes[_i].exact           ? 0
          : changes[_i].choose == far ? unit_larger(same(), 1e-8)
                                      : same();
    if (tc_solve(&data, i, &one)) {
      ck_moved(&m, tol, i);
      solved++;
    } else {
      ck_that(!tc_solve(&image, i, &other), "the image has a solution");
    }
  }
  ck_assert_uint_gt(solved, unit_cases(10 * TC_FAMILY_N));
}

/* Far away the control points are rounded, but nothing else is. */
PH_TEST(test_far_lengths) {
  struct unit_random r = unit_random_of(21);
  for (size_t i = 0; i < unit_cases(60); i++) {
    struct motion m = REST;
    tc_of(&r, i % 2 ? TC_SPLINE : TC_C1, &data);
    far(&r, &m);
    move_data(&m);
    tc_must(&data, i, &one);
    tc_must(&image, i, &other);
    ck_rel(one.result.curve.length, other.result.curve.length, 0);
  }
}

/* Whatever was solved before, in the same memory: not a digit differs. */
PH_TEST(test_neighbours) {
  struct unit_random r = unit_random_of(22);
  for (size_t i = 0; i < unit_cases(4 * TC_FAMILY_N); i++) {
    bool a, b;
    tc_of(&r, (enum tc_family)unit_random_below(&r, TC_FAMILY_N), &image);
    tc_of(&r, (enum tc_family)(i % TC_FAMILY_N), &data);
    a = tc_solve(&data, i, &one);
    tc_solve(&image, i, &other);
    b = tc_solve(&data, i, &other);
    ck_that(a == b, "%s", b ? "once" : "not again");
    if (a) {
      const struct ph_curve *x = &one.result.curve, *y = &other.result.curve;
      ck_assert_uint_eq(x->n, y->n);
      ck_assert_mem_eq(x->control_points, y->control_points,
                       8 * x->n * sizeof *x->control_points);
    } else {
      ck_assert_str_eq(one.diag.message, other.diag.message);
    }
  }
}

/* ---- one cubic -------------------------------------------------------------
 */

static double angle_to_chord(size_t i) {
  ph_cplx chord = tc_chord(&data, 0);
  return atan2(ph_cplx_cross(chord, data.vector[i]),
               ph_cplx_dot(chord, data.vector[i]));
}

/* As many solutions as the angles allow, and the best one first.  (Near the
 * chord loops are as small as rounding.) */
PH_TEST(test_one) {
  struct unit_random r = unit_random_of(23);
  size_t found[3] = {0, 0, 0};
  for (size_t i = 0; i < unit_cases(300); i++) {
    struct unit_tc_count count;
    size_t n, loops = 0;
    do {
      tc_of(&r, TC_ONE, &data);
    } while (fabs(sin(angle_to_chord(0))) < 1e-3 ||
             fabs(sin(angle_to_chord(1))) < 1e-3);
    count = unit_tc_count_by_angles(angle_to_chord(0), angle_to_chord(1));
    data.solutions = "all";
    n = tc_solve(&data, i, &one) ? one.result.solutions_n : 0;
    ck_that(n == count.without_loop + count.with_loop, "%zu solutions", n);
    for (size_t k = 0; k < n; k++) {
      const struct ph_diagnostics *d = &one.result.solutions[k].diagnostics;
      bool loop = unit_diagnostic(d, PH_D_LOOPS) > 0;
      loops += loop;
      ck_that(loop == (k >= count.without_loop), "a loop in solution %zu", k);
    }
    ck_assert_uint_eq(loops, count.with_loop);
    found[n]++;
  }
  for (size_t n = 0; n < 3; n++) {
    ck_assert_uint_gt(found[n], 0);
  }
}

/* ---- two cubics ------------------------------------------------------------
 */

/* Angles that are special, or nearly so. */
static double special(struct unit_random *r) {
  static const double parts[] = {0, 1, -1, 0.5, -0.5, 2.0 / 3, 1.0 / 3};
  double near =
      unit_random_below(r, 2) ? 0 : pow(10, unit_random_in(r, -17, -2));
  return PH_PI * parts[unit_random_below(r, 7)] + near;
}

/* There is always a curve of two, regular, without a loop or a crossing; and
 * so one of one or two, though one cubic that all but has a cusp may not be
 * told from one that touches itself. */
PH_TEST(test_all_angles) {
  static const enum tc_family families[] = {TC_PAIR, TC_AUTO, TC_FAIR};
  struct unit_random r = unit_random_of(24);
  for (size_t i = 0; i < unit_cases(300); i++) {
    tc_of(&r, families[i % 3], &data);
    data.n = 2;
    data.closed = false;
    for (size_t k = 0; k < 2; k++) {
      ph_cplx turn_to = ph_cplx_polar(special(&r));
      data.vector[k] = ph_cplx_mul(turn_to, tc_chord(&data, 0));
    }
    if (i % 4 == 0) { /* along the chord, or back, to the last bit */
      data.vector[i / 4 % 2] =
          ph_cplx_scale(i % 8 ? -2 : 4, tc_chord(&data, 0));
    }
    tc_must(&data, i, &one);
    ck_that(data.family == TC_AUTO || (diagnostic(&one, PH_D_SIMPLE) > 0 &&
                                       diagnostic(&one, PH_D_LOOPS) <= 0),
            "angles %.17g, %.17g: %g loops", angle_to_chord(0),
            angle_to_chord(1), diagnostic(&one, PH_D_LOOPS));
  }
}

/* F of the fairer mode is the smaller one, and no worse than either. */
PH_TEST(test_fair) {
  struct unit_random r = unit_random_of(25);
  for (size_t i = 0; i < unit_cases(100); i++) {
    double f[3];
    tc_of(&r, TC_FAIR, &data);
    data.n = 2;
    data.closed = false;
    for (size_t k = 0; k < 3; k++) {
      static const enum tc_family families[] = {TC_FAIR, TC_AUTO, TC_PAIR};
      data.family = families[k];
      tc_must(&data, i, &one);
      f[k] = diagnostic(&one, PH_D_ENERGY) * one.result.curve.length;
    }
    ck_that(unit_near_rel(f[0], fmin(f[1], f[2]), 1e-11),
            "F is %.17g, of auto %.17g, of pair %.17g", f[0], f[1], f[2]);
  }
}

/* ---- pairs with derivatives ---------------------------------------------- */

static double kind_of(const struct ph_diagnostics *d) {
  return unit_diagnostic(d, PH_D_SIMPLE) > 0    ? 0
         : unit_diagnostic(d, PH_D_REGULAR) > 0 ? 1
                                                : 2;
}

/* All four: simple ones first, then regular ones, by energy; the best one is
 * the first, and the standard one among them. */
PH_TEST(test_four) {
  struct unit_random r = unit_random_of(26);
  for (size_t i = 0; i < unit_cases(200); i++) {
    const struct ph_solution *all;
    double first;
    size_t standard = 0;
    tc_of(&r, TC_C1, &data);
    data.n = 2;
    data.closed = false;
    data.solutions = "all";
    tc_must(&data, i, &one);
    ck_assert_uint_eq(one.result.solutions_n, 4);
    all = one.result.solutions;
    for (size_t k = 0; k + 1 < 4; k++) {
      double a = kind_of(&all[k].diagnostics);
      double b = kind_of(&all[k + 1].diagnostics);
      ck_that(a <= b, "kinds %g, %g of %zu", a, b, k);
      ck_that(a < b || a > 1 ||
                  unit_diagnostic(&all[k].diagnostics, PH_D_ENERGY) <=
                      (1 + 1e-8) *
                          unit_diagnostic(&all[k + 1].diagnostics, PH_D_ENERGY),
              "energies of %zu", k);
    }
    while (standard < 4 &&
           all[standard].intervals[0].root != PH_ROOT_PLUS_PLUS) {
      standard++;
    }
    ck_assert_uint_lt(standard, 4);
    first = all[standard].curve.length;
    data.solutions = "standard";
    tc_must(&data, i, &other);
    ck_rel(first, other.result.curve.length, 1e-12);
    data.solutions = NULL;
    tc_must(&data, i, &other);
    ck_abs(other.result.intervals[0].root, all[0].intervals[0].root, 0);
    ck_rel(other.result.curve.length, all[0].curve.length, 1e-12);
  }
}

/* With derivatives up to 1.4 chords the standard pair is simple; a conjecture
 * that no data are known to break [BYR11, conj. 22]. */
PH_TEST(test_standard) {
  struct unit_random r = unit_random_of(27);
  for (size_t i = 0; i < unit_cases(200); i++) {
    tc_of(&r, TC_LAMBDA, &data);
    data.solutions = "standard";
    data.n = 2;
    data.closed = false;
    tc_must(&data, i, &one);
    ck_abs(one.result.intervals[0].root, PH_ROOT_PLUS_PLUS, 0);
    ck_that(diagnostic(&one, PH_D_SIMPLE) > 0, "%g loops",
            diagnostic(&one, PH_D_LOOPS));
  }
}

PH_FIXTURE(NULL, finish)
