/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Measures of fits of Tschirnhausen cubics, their order, and the best. */
#include "unit.h"

#include "solve/tc/tc.h"

enum { SETS = 5000, MANY = 5 };

static const struct ph_tc line = {{{1, 0}, {1, 0}}};
static const struct ph_tc loop = {{{1, 0}, {-1, 0.5}}};
static const struct ph_tc cusp = {{{1, 0}, {-1, 0}}};

/* A fit of one cubic that is said to have these measures; its number is kept in
 * `ratio`. */
static struct ph_tc_fit fit_of(const struct ph_tc *tc, size_t number,
                               double energy, double length) {
  struct ph_tc_fit fit = {.tc = {*tc}, .n = 1, .ratio = (double)number};
  ph_tc_fit_measure(&fit);
  fit.energy = energy;
  fit.length = length;
  return fit;
}

static void expect_order(const struct ph_tc_fit *fits, size_t n,
                         const size_t *number) {
  for (size_t i = 0; i < n; i++) {
    ck_assert_uint_eq((size_t)fits[i].ratio, number[i]);
  }
}

/* [BYR11, ex. 5] over its chord: z of the four pairs; measures by Gauss
 * quadrature of the curvature. */
PH_TEST(test_measure) {
  const ph_cplx w0 = {1.20354814503777, 0.49852596464362514};
  const ph_cplx w2 = {1.1273066988401768, 0.266121012417165};
  const ph_cplx z[4] = {{0.28613298450635427, -0.5808823156467595},
                        {-1.4515604064453276, 0.1985588271163644},
                        {0.7691716723378779, -0.6275941666583581},
                        {-0.8072923954366746, 0.511391690545128}};
  const double length[4] = {6.833423844162367, 6.833423844162367,
                            8.204138048003838, 8.204138048003838};
  const double energy[4] = {8.833007483562023, 237.6103962574967,
                            18.096520811664817, 15.00318291295807};
  const unsigned loops[4] = {0, 2, 1, 0};
  const size_t number[4] = {0, 3, 2, 1};
  struct ph_tc_fit fits[4], *best;
  for (size_t i = 0; i < 4; i++) {
    ph_cplx end = i < 2 ? w2 : ph_cplx_scale(-1, w2);
    fits[i] = (struct ph_tc_fit){.n = 2, .simple = true, .ratio = (double)i};
    fits[i].tc[0] = (struct ph_tc){{w0, z[i]}};
    fits[i].tc[1] = (struct ph_tc){{z[i], end}};
    ph_tc_fit_measure(&fits[i]);
    ck_assert(fits[i].regular);
    ck_assert(!fits[i].simple);
    ck_assert_uint_eq(fits[i].loops, loops[i]);
    ck_rel(5 * fits[i].length, length[i], 1e-14);
    ck_rel(fits[i].energy / 5, energy[i], 1e-13);
  }
  best = ph_tc_fit_best(fits, 4);
  ck_assert_ptr_eq(best, &fits[0]);
  ck_assert(best->simple);
  for (size_t i = 0; i < 4; i++) {
    ck_assert_int_eq(ph_tc_fit_test(&fits[i]), i == 0);
    ck_assert_int_eq(fits[i].simple, i == 0);
  }
  ph_tc_fit_order(fits, 4);
  expect_order(fits, 4, number);
}

PH_TEST(test_measure_irregular) {
  struct ph_tc_fit fit = {.tc = {line, cusp}, .n = 2};
  ph_tc_fit_measure(&fit);
  ck_assert(!fit.regular);
  ck_assert(!isfinite(fit.energy));
  ck_assert(!ph_tc_fit_test(&fit));
  ck_assert_ptr_null(ph_tc_fit_best(&fit, 1));
  ck_assert_ptr_null(ph_tc_fit_best(&fit, 0));
}

/* Simple ones first whatever they bend, then the other regular ones, then the
 * rest as they were. */
PH_TEST(test_order_classes) {
  struct ph_tc_fit fits[] = {
      fit_of(&cusp, 0, (double)INFINITY, 1),
      fit_of(&loop, 1, 3, 1),
      fit_of(&line, 2, 9, 1),
      fit_of(&cusp, 3, 0, 1),
      fit_of(&loop, 4, 2, 1),
      fit_of(&line, 5, 8, 1),
  };
  const size_t number[] = {5, 2, 4, 1, 0, 3};
  ph_tc_fit_order(fits, 6);
  expect_order(fits, 6, number);
  for (size_t i = 0; i < 6; i++) {
    ck_assert_int_eq(fits[i].simple, i < 2);
  }
}

PH_TEST(test_best_without_simple) {
  struct ph_tc_fit fits[] = {fit_of(&cusp, 0, 0, 1), fit_of(&loop, 1, 3, 1),
                             fit_of(&loop, 2, 2, 1)};
  struct ph_tc_fit *best = ph_tc_fit_best(fits, 3);
  ck_assert_ptr_eq(best, &fits[2]);
  ck_assert(!best->simple);
}

/* One that is not simple hides none of the same energy, and an energy that is
 * no number hides none at all. */
PH_TEST(test_best_behind) {
  struct ph_tc_fit fits[] = {fit_of(&cusp, 0, (double)NAN, 1),
                             fit_of(&loop, 1, 2, 1), fit_of(&loop, 2, 2, 1),
                             fit_of(&line, 3, 2, 1), fit_of(&line, 4, 3, 0.5)};
  const size_t number[] = {3, 4, 1, 2, 0};
  ck_assert_ptr_eq(ph_tc_fit_best(fits, 5), &fits[3]);
  ph_tc_fit_order(fits, 5);
  expect_order(fits, 5, number);
}

/* Energies that agree: the shorter; lengths that agree too: the first. */
PH_TEST(test_order_ties) {
  struct ph_tc_fit fits[] = {
      fit_of(&line, 0, 5, 4),
      fit_of(&line, 1, 5 * (1 - 0.9e-9), 4 * (1 - 0.9e-9)),
      fit_of(&line, 2, 5 * (1 - 0.8e-9), 3),
      fit_of(&line, 3, 5 * (1 + 3e-9), 2),
      fit_of(&line, 4, 0, 9),
      fit_of(&line, 5, 0, 8),
  };
  const size_t number[] = {5, 4, 2, 0, 1, 3};
  ck_assert_ptr_eq(ph_tc_fit_best(fits, 6), &fits[5]);
  ph_tc_fit_order(fits, 6);
  expect_order(fits, 6, number);
}

/* Neighbours agree, the outer ones do not: the one of least energy says which
 * others agree with it, in whichever order they come. */
PH_TEST(test_order_chain) {
  static const size_t come[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2},
                                    {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
  const size_t number[] = {1, 0, 2};
  const struct ph_tc_fit all[] = {
      fit_of(&line, 0, 1, 3),
      fit_of(&line, 1, 1 + 0.8e-9, 2),
      fit_of(&line, 2, 1 + 1.6e-9, 1),
  };
  for (size_t k = 0; k < 6; k++) {
    struct ph_tc_fit fits[3];
    for (size_t i = 0; i < 3; i++) {
      fits[i] = all[come[k][i]];
    }
    ck_assert_uint_eq((size_t)ph_tc_fit_best(fits, 3)->ratio, 1);
    ph_tc_fit_order(fits, 3);
    expect_order(fits, 3, number);
  }
}

/* A loop at the least energy does not say who agrees. */
PH_TEST(test_best_chain_with_loop) {
  struct ph_tc_fit fits[] = {
      fit_of(&loop, 0, 1, 3),
      fit_of(&line, 1, 1 + 0.8e-9, 2),
      fit_of(&line, 2, 1 + 1.6e-9, 1),
  };
  ck_assert_ptr_eq(ph_tc_fit_best(fits, 3), &fits[2]);
}

/* A few values, or some that differ by about the tolerance. */
static double random_measure(struct unit_random *r) {
  double step = unit_random_below(r, 2) == 0 ? 0.5e-9 : 0.5;
  return 1 + step * (double)unit_random_below(r, 4);
}

PH_TEST(test_best_is_first) {
  const struct ph_tc *tc[] = {&line, &line, &loop, &cusp};
  struct unit_random r = unit_random_of(1);
  int n = unit_count(SETS);
  for (int i = 0; i < n; i++) {
    struct ph_tc_fit fits[MANY], *best;
    size_t count = 1 + unit_random_below(&r, MANY), number = MANY;
    bool seen[MANY] = {false};
    for (size_t k = 0; k < count; k++) {
      double energy = random_measure(&r), length = random_measure(&r);
      fits[k] = fit_of(tc[unit_random_below(&r, 4)], k, energy, length);
    }
    best = ph_tc_fit_best(fits, count);
    number = best == NULL ? MANY : (size_t)best->ratio;
    ph_tc_fit_order(fits, count);
    if (number == MANY) {
      ck_assert(!fits[0].regular);
    } else {
      ck_assert_uint_eq((size_t)fits[0].ratio, number);
    }
    for (size_t k = 0; k < count; k++) {
      ck_assert(!seen[(size_t)fits[k].ratio]);
      seen[(size_t)fits[k].ratio] = true;
    }
  }
}
