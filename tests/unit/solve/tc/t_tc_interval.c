/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Curves of one interval: what each mode gives for data that have no, one or
 * two single cubics, or one that is nearly a cusp; choices and failures.
 */
#include "tc_unit.h"

#include "solve/tc/tc.h"

/* The data hold their points: these outlive every test. */
static double chord[] = {0, 0, 1, 0};

#define CHORD                                                \
  {                                                          \
    PH_F_POINTS, {                                           \
      .kind = PH_VECTORS, .v = chord, .n = 2, .dimension = 2 \
    }                                                        \
  }

/* Data of one interval, over the chord from 0 to 1 as they are. */
static struct ph_tc_data data_of(enum ph_tc_mode mode, double a, double b) {
  static const char *const NAMES[] = {"g1", "g1-pair", "g1-auto", "g1-fair"};
  double v[] = {cos(a), sin(a), cos(b), sin(b)};
  const struct given given[GIVEN_MAX] = {
      {PH_F_MODE, WORD(NAMES[mode])},
      CHORD,
      {PH_F_TANGENTS, {.kind = PH_VECTORS, .v = v, .n = 2, .dimension = 2}}};
  return unit_tc_given(given);
}

/* Solves what has a solution. */
static struct ph_tc_fit solved(const struct ph_tc_data *d) {
  struct ph_tc_fit fit;
  struct ph_diag diag;
  enum ph_status status = ph_tc_interval(d, 0, &fit, &diag);
  ck_assert_msg(status == PH_OK, "%s: %s", diag.field, diag.message);
  ck_assert(fit.regular);
  ck_abs(unit_tc_miss(&fit), 0, 1e-14);
  return fit;
}

static double f_of(const struct ph_tc_fit *fit) {
  return fit->energy * fit->length;
}

/* The same preimages, and the same said of them. */
static void ck_same(const struct ph_tc_fit *x, const struct ph_tc_fit *y) {
  ck_assert_uint_eq(x->n, y->n);
  ck_assert_int_eq(x->root, y->root);
  ck_abs(unit_tc_apart(x, false, false, y), 0, 0);
  ck_rel(f_of(x), f_of(y), 0);
}

/* ---- modes --------------------------------------------------------------- */

/* How many single cubics there are, and how many cubics the modes g1 and
 * g1-auto give; 0: none. */
static const struct {
  double a, b;
  size_t single, g1, automatic;
  unsigned loops;                          /* of g1 */
} CASES[] = {{0, 0, 1, 1, 1, 0},           /* the straight line */
             {1.2, -1.2, 1, 1, 1, 0},      /* one */
             {0.5, -0.3, 2, 1, 1, 0},      /* two, one with a loop */
             {0.5, 0.5, 0, 0, 2, 0},       /* none */
             {0.02, 1.02, 2, 1, 2, 1},     /* two with loops */
             {PH_PI, 0, 0, 0, 2, 0},       /* backward */
             {1e-13, 2.5, 1, 0, 2, 0},     /* a cusp */
             {0.99e-6, 2.5, 1, 1, 2, 0},   /* nearly a cusp */
             {1.01e-6, 2.5, 1, 1, 1, 0},   /* hardly a cusp */
             {-2.5, -0.99e-6, 1, 1, 2, 0}, /* the same from the other end */
             {-2.5, -1.01e-6, 1, 1, 1, 0}};

PH_TEST_EACH(test_modes, COUNT(CASES)) {
  const double a = CASES[_i].a, b = CASES[_i].b;
  struct ph_tc_data d = data_of(PH_TC_G1, a, b);
  const struct ph_tc_hermite h = ph_tc_hermite_of(&d, 0);
  struct ph_tc_fit fits[2], fit, pair;
  struct ph_diag diag;
  ck_assert_uint_eq(ph_tc_g1(&h, fits), CASES[_i].single);
  ck_assert_int_eq(ph_tc_interval(&d, 0, &fit, &diag),
                   CASES[_i].g1 > 0 ? PH_OK : PH_E_INFEASIBLE);
  if (CASES[_i].g1 > 0) {
    ck_same(&fit, &fits[0]);
    ck_assert_uint_eq(fit.loops, CASES[_i].loops);
    ck_assert(fit.simple == (fit.loops == 0));
  }
  d.mode = PH_TC_G1_PAIR;
  pair = solved(&d);
  ck_assert_uint_eq(pair.n, 2);
  ck_assert(pair.simple && isfinite(pair.lambda));
  d.mode = PH_TC_G1_AUTO;
  fit = solved(&d);
  ck_assert_uint_eq(fit.n, CASES[_i].automatic);
  ck_same(&fit, fit.n == 1 ? &fits[0] : &pair);
  ck_assert(fit.simple);
}

/* g1-auto takes a loop-free cubic, g1-fair it or the pair: the smaller F. */
PH_TEST(test_fair) {
  struct unit_random r = unit_random_of(1);
  size_t singles = 0, pairs = 0;
  for (int i = 0; i < unit_count(200); i++) {
    double a = unit_random_in(&r, -2, 2), b = unit_random_in(&r, -2, 2);
    struct ph_tc_data d = data_of(PH_TC_G1_PAIR, a, b);
    const struct ph_tc_hermite h = ph_tc_hermite_of(&d, 0);
    struct ph_tc_fit fits[2], pair = solved(&d), fair, either;
    bool one = ph_tc_g1(&h, fits) > 0 && fits[0].loops == 0;
    d.mode = PH_TC_G1_FAIR;
    fair = solved(&d);
    d.mode = PH_TC_G1_AUTO;
    either = solved(&d);
    ck_same(&either, one ? &fits[0] : &pair);
    one = one && f_of(&fits[0]) <= f_of(&pair);
    ck_same(&fair, one ? &fits[0] : &pair);
    singles += fair.n == 1;
    pairs += fair.n == 2 && either.n == 1;
    ph_arena_reset(&unit_arena);
  }
  ck_assert_uint_gt(singles, 0);
  ck_assert_uint_gt(pairs, 0);
}

/* A lambda makes derivatives of the tangents; a single cubic does not mind. */
PH_TEST_EACH(test_lambda, 2) {
  const struct given given[GIVEN_MAX] = {
      {PH_F_MODE, WORD(_i == 0 ? "g1-pair" : "g1-auto")},
      CHORD,
      {PH_F_TANGENTS, VECTORS(2, 3, 4, 3, -4)},
      {PH_F_LAMBDA, NUMBER(0.75)}};
  struct ph_tc_data d = unit_tc_given(given);
  struct ph_tc_fit fit = solved(&d);
  ck_assert_uint_eq(fit.n, _i == 0 ? 2 : 1);
  for (size_t k = 0; k < 2; k++) {
    ph_cplx v = unit_tc_end(&fit, k);
    ck_abs(v.im / v.re, k == 0 ? 4.0 / 3 : -4.0 / 3, 1e-14);
    ck_assert(v.re > 0);
    ck_assert(unit_near(ph_cplx_abs(v), 0.75, 1e-14) == (_i == 0));
  }
}

/* ---- choices ------------------------------------------------------------- */

/* [BYR11, example 5]: the standard pair of the first data is the best, that of
 * the others crosses itself; a backward derivative has no standard pair. */
static const struct {
  double v[4];
  enum ph_root best, standard;
  bool simple; /* the standard one */
} CHOICES[] = {
    {{1.2, 1.2, 1.2, 0.6}, PH_ROOT_PLUS_PLUS, PH_ROOT_PLUS_PLUS, true},
    {{-2.121320343559643, 2.121320343559643, 2.121320343559643,
      2.121320343559643},
     PH_ROOT_MINUS_MINUS,
     PH_ROOT_PLUS_PLUS,
     false},
};

static struct ph_tc_data c1_of(const double v[4], const char *solutions) {
  const struct given given[GIVEN_MAX] = {
      CHORD,
      {PH_F_DERIVATIVES, VECTORS(2, v[0], v[1], v[2], v[3])},
      {PH_F_SOLUTIONS, WORD(solutions)}};
  return unit_tc_given(given);
}

PH_TEST_EACH(test_standard, COUNT(CHOICES)) {
  struct ph_tc_data d = c1_of(CHOICES[_i].v, "best");
  struct ph_tc_fit fit = solved(&d);
  ck_assert_int_eq(fit.root, CHOICES[_i].best);
  ck_assert(fit.simple);
  d.choice = PH_TC_STANDARD;
  fit = solved(&d);
  ck_assert_int_eq(fit.root, CHOICES[_i].standard);
  ck_assert(fit.simple == CHOICES[_i].simple);
}

/* Where a derivative is backward the standard pair is the best. */
PH_TEST(test_standard_backward) {
  static const double V[4] = {-2, 0, 1, 1};
  struct ph_tc_data d = c1_of(V, "best");
  struct ph_tc_fit best = solved(&d), fit;
  d.choice = PH_TC_STANDARD;
  fit = solved(&d);
  ck_same(&fit, &best);
}

/* Of tangents the standard pair has lambda 1/2, and the best a lambda of which
 * F is no larger. */
PH_TEST(test_standard_tangents) {
  struct ph_tc_data d = data_of(PH_TC_G1_PAIR, 1.5, 0.25);
  struct ph_tc_fit best = solved(&d), fit;
  d.choice = PH_TC_STANDARD;
  fit = solved(&d);
  ck_assert_int_eq(fit.root, PH_ROOT_PLUS_PLUS);
  ck_rel(fit.lambda, 0.5, 0);
  ck_rel(ph_cplx_abs(unit_tc_end(&fit, 0)), 0.5, 1e-15);
  ck_rel(ph_cplx_abs(unit_tc_end(&best, 1)), best.lambda, 1e-14);
  ck_assert(f_of(&best) < f_of(&fit));
}

/* ---- on the chord -------------------------------------------------------- */

static struct ph_tc_data on_chord(double angle) {
  const struct given given[GIVEN_MAX] = {
      {PH_F_MODE, WORD("g1-pair")},
      CHORD,
      {PH_F_TANGENTS, VECTORS(2, 3, 4, 4, 3)},
      {PH_F_JOINT, WORD("chord")},
      {PH_F_JOINT_ANGLE, NUMBER(angle)}};
  return unit_tc_given(given);
}

PH_TEST(test_on_chord) {
  struct ph_tc_data d = on_chord(-0.75);
  struct ph_tc_fit fit, fits[PH_TC_FITS_MAX];
  struct ph_diag diag;
  size_t n = 0;
  d.joint_position = 0.375;
  fit = solved(&d);
  ck_assert_int_eq(fit.root, PH_ROOT_ON_CHORD);
  ck_abs(unit_distance(ph_tc_leg(&fit.tc[0]), ph_cplx_of(0.375, 0)), 0, 1e-15);
  ck_rel(fit.joint_angle, -0.75, 0);
  ck_rel(fit.joint_position, 0.375, 0);
  ck_assert_int_eq(ph_tc_interval_all(&d, 0, fits, &n, &diag), PH_OK);
  ck_assert_uint_eq(n, 1);
  ck_same(&fits[0], &fit);
}

/* ---- all ----------------------------------------------------------------- */

/* As many as there are, the first of them the one that is given alone. */
PH_TEST(test_all) {
  struct unit_random r = unit_random_of(2);
  for (int i = 0; i < unit_count(100); i++) {
    double v[4];
    struct ph_tc_data d;
    struct ph_tc_fit alone, fits[PH_TC_FITS_MAX];
    struct ph_diag diag;
    size_t n = 0;
    for (size_t j = 0; j < 4; j++) {
      v[j] = unit_random_in(&r, -2, 2);
    }
    d = i % 2 == 0 ? c1_of(v, "all") : data_of(PH_TC_G1_AUTO, v[0], v[1]);
    alone = solved(&d);
    ck_assert_int_eq(ph_tc_interval_all(&d, 0, fits, &n, &diag), PH_OK);
    ck_assert_int_eq(fits[0].root, alone.root);
    ck_abs(unit_tc_apart(&fits[0], false, false, &alone), 0, 1e-14);
    ck_assert(fits[0].simple == alone.simple);
    if (alone.n == 1) {
      struct unit_tc_count count = unit_tc_count_by_angles(v[0], v[1]);
      ck_assert_uint_eq(n, count.without_loop + count.with_loop);
    } else {
      ck_assert_uint_eq(n, PH_TC_PAIRS);
    }
    for (size_t j = 0; j < n; j++) {
      ck_abs(unit_tc_miss(&fits[j]), 0, 1e-14);
      ck_assert(unit_same(fits[j].lambda, alone.lambda) ||
                (isnan(fits[j].lambda) && isnan(alone.lambda)));
      for (size_t k = 0; k < j; k++) {
        ck_assert(unit_tc_apart(&fits[k], false, false, &fits[j]) > 1e-9);
      }
    }
    ph_arena_reset(&unit_arena);
  }
}

/* ---- failures ------------------------------------------------------------ */

/* Asserts that one and all fail like that, at segments[0]. */
static void ck_fails(const struct ph_tc_data *d, const char *message) {
  struct ph_tc_fit fits[PH_TC_FITS_MAX];
  struct ph_diag diag;
  size_t n;
  ck_assert_int_eq(ph_tc_interval(d, 0, fits, &diag), PH_E_INFEASIBLE);
  ck_assert_str_eq(diag.field, "segments[0]");
  ck_assert_str_eq(diag.message, message);
  memset(&diag, 0, sizeof diag);
  ck_assert_int_eq(ph_tc_interval_all(d, 0, fits, &n, &diag), PH_E_INFEASIBLE);
  ck_assert_str_eq(diag.message, message);
}

#define NO_CUBIC "no Tschirnhausen cubic has angles "
#define HAS_TWO "; \"mode\":\"g1-pair\" has a curve of two"

/* For a in [pi/6, 5 pi/6] the range is from a - 4 pi/3 to 2 arctan((2 -
 * sqrt3)^2 tan(a/2)). */
static const struct {
  double a, b;
  const char *message;
} NO_G1[] = {
    {0.6, 0.5,
     NO_CUBIC "0.6 and 0.5 to the chord: for the first, the second must be "
              "between -3.58879 and 0.0444114 modulo 2 pi" HAS_TWO},
    {2.5, 0,
     NO_CUBIC "2.5 and 0 to the chord: for the first, the second must be "
              "between -1.68879 and 0.425611, and not 0" HAS_TWO},
    {1e-13, 2.5,
     "a Tschirnhausen cubic with angles 1e-13 and 2.5 to the chord has a "
     "cusp" HAS_TWO},
};

PH_TEST_EACH(test_no_g1, COUNT(NO_G1)) {
  struct ph_tc_data d = data_of(PH_TC_G1, NO_G1[_i].a, NO_G1[_i].b);
  ck_fails(&d, NO_G1[_i].message);
}

/* Along the chord, 3/2 of it, all pairs have cusps; of w0^2 + w2^2 = 3 the
 * standard one has. */
PH_TEST(test_no_pair) {
  static const double CUSPS[4] = {1.5, 0, 1.5, 0}, ONE[4] = {1.5, 1, 1.5, -1};
  struct ph_tc_data d = c1_of(CUSPS, "best");
  struct ph_tc_fit fit;
  ck_fails(&d, "all four pairs of cubics have a cusp with these derivatives; "
               "other lengths of them do not");
  d.mode = PH_TC_G1_PAIR;
  ck_fails(&d, "all four pairs of cubics have a cusp with this lambda; others "
               "do not");
  d = c1_of(ONE, "standard");
  ck_fails(&d, "the standard pair has a cusp; \"solutions\":\"best\" may have "
               "none");
  d.choice = PH_TC_BEST;
  fit = solved(&d);
  ck_assert(fit.root != PH_ROOT_PLUS_PLUS);
  /* g1-fair has the straight line where the pair fails */
  d = c1_of(CUSPS, "best");
  d.mode = PH_TC_G1_FAIR;
  fit = solved(&d);
  ck_assert_int_eq(fit.root, PH_ROOT_STRAIGHT);
}

/* Angles to the chord .927295 and .643501. */
PH_TEST(test_no_joint) {
  struct ph_tc_data d = on_chord(1);
  ck_fails(&d, "no two cubics meet on the chord at the angle 1: it must be "
               "between -3.26149 and 0.071766 modulo 2 pi and between -3.54529 "
               "and 0.0478554 modulo 2 pi, and not 0");
}

/* ---- crossings ----------------------------------------------------------- */

PH_TEST(test_crossings) {
  struct ph_tc_crossings crossings = {0, 0};
  struct ph_tc_fit fit = ph_tc_fit_of(1, PH_ROOT_PLUS);
  for (size_t k = 0; k < 9; k++) {
    fit.simple = k < 3 || k % 2 == 0;
    ph_tc_crossings_see(&crossings, k, &fit);
  }
  ck_assert_uint_eq(crossings.n, 3);
  ck_assert_uint_eq(crossings.first, 3);
}
