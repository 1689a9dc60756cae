/* SPDX-License-Identifier: GPL-3.0-or-later */
/* C1 interpolation by pairs of Tschirnhausen cubics: examples of the thesis,
 * what the four pairs have in common, and which of them is chosen. */
#include "unit.h"
#include "tc_unit.h"

#include "solve/tc/tc.h"

/* ---- examples ------------------------------------------------------------ */

struct known_pair {
  ph_cplx joint;
  double length, energy;
  unsigned loops;
  bool simple;
};

#define PAIR(re, im, length, energy, loops, simple) \
  { {re, im}, length, energy, loops, simple }

/* [BYR11, example 5, fig. 5.15]: derivatives, and the pairs in our order;
 * energies and which are simple are ours. */
static const struct {
  double chord;
  ph_cplx t[2];
  struct known_pair pairs[PH_TC_PAIRS];
  enum ph_root best;
} KNOWN[] = {
    {5,
     {{6, 6}, {6, 3}},
     {PAIR(2.630679266133899, 0.5185095123159149, 6.833423844162369,
           8.83300748356202, 0, true),
      PAIR(2.369320733866101, 0.23149048768408506, 6.833423844162369,
           237.61039625749675, 2, false),
      PAIR(4.393929583832286, -0.2289050910426884, 8.204138048003836,
           18.096520811664828, 1, false),
      PAIR(0.6060704161677143, 0.9789050910426884, 8.204138048003836,
           15.003182912958064, 0, false)},
     PH_ROOT_PLUS_PLUS},
    {3,
     {{-2.1213203435596424, 2.1213203435596424},
      {2.1213203435596424, 2.1213203435596424}},
     {PAIR(0.6877481391944552, 0.3895937342474276, 4.731550641516597,
           8.636864078893778, 0, true),
      PAIR(1.2515916890257235, -0.3895937342474276, 4.731550641516597,
           600.6638353173743, 1, false),
      PAIR(1.985510990783681, 0.6301822771739048, 5.275279111831263,
           59.73237018385851, 1, false),
      PAIR(-0.04617116256350224, -0.6301822771739048, 5.275279111831263,
           9.630629121242258, 0, true)},
     PH_ROOT_PLUS_PLUS},
    {3,
     {{-6.363961030678928, 6.363961030678928},
      {6.363961030678928, 6.363961030678928}},
     {PAIR(-0.46207933429171866, 0.8879400982766926, 8.935744403271297,
           12.4886543759364, 0, false),
      PAIR(0.28009881895225486, -0.8879400982766926, 8.935744403271297,
           138.29049380793012, 1, false),
      PAIR(2.418748347580099, 0.7652171922675952, 11.157338166769469,
           11.56910026081894, 1, false),
      PAIR(-2.6007288629195626, -0.7652171922675952, 11.157338166769469,
           2.9907041261342773, 0, true)},
     PH_ROOT_MINUS_MINUS},
    {3,
     {{-2.1213203435596424, 2.1213203435596424},
      {-1.414213562373095, -2.82842712474619}},
     {PAIR(1.2586586721005268, 1.9312119220462658, 6.239099783456877,
           3.3965919966710585, 0, true),
      PAIR(1.5645646326028364, -0.6937750549698077, 6.239099783456877,
           25.846581072248977, 0, true),
      PAIR(2.04490011219946, 0.6672969608721915, 5.428698073807963,
           49.503262485154394, 1, false),
      PAIR(0.7783231925039029, 0.5701399062042666, 5.428698073807963,
           35.39857826489792, 1, false)},
     PH_ROOT_PLUS_PLUS},
};

static ph_cplx joint_of(const struct ph_tc_fit *fit) {
  return ph_tc_leg(&fit->tc[0]);
}

PH_TEST_EACH(test_known, COUNT(KNOWN)) {
  static const enum ph_root ROOTS[] = {PH_ROOT_PLUS_PLUS, PH_ROOT_PLUS_MINUS,
                                       PH_ROOT_MINUS_PLUS, PH_ROOT_MINUS_MINUS};
  const double chord = KNOWN[_i].chord;
  struct ph_tc_hermite h = {{ph_cplx_scale(1 / chord, KNOWN[_i].t[0]),
                             ph_cplx_scale(1 / chord, KNOWN[_i].t[1])}};
  struct ph_tc_fit fits[PH_TC_PAIRS], fit;
  ph_tc_pairs(&h, fits);
  ck_assert(ph_tc_pair_standard(&h, &fit));
  ck_abs(unit_tc_apart(&fit, false, false, &fits[0]), 0, 0);
  for (size_t i = 0; i < PH_TC_PAIRS; i++) {
    const struct known_pair *k = &KNOWN[_i].pairs[i];
    ph_cplx joint = ph_cplx_scale(chord, joint_of(&fits[i]));
    ck_assert_int_eq(fits[i].root, ROOTS[i]);
    ck_assert_uint_eq(fits[i].n, 2);
    ph_tc_fit_measure(&fits[i]);
    ck_abs(unit_distance(joint, k->joint), 0, 1e-12 * chord);
    ck_rel(fits[i].length * chord, k->length, 1e-12);
    ck_rel(fits[i].energy / chord, k->energy, 1e-11);
    ck_assert_uint_eq(fits[i].loops, k->loops);
    ck_assert(fits[i].regular);
    ck_assert(ph_tc_fit_test(&fits[i]) == k->simple);
  }
  ck_assert(ph_tc_pair_best(&h, &fit));
  ck_assert_int_eq(fit.root, KNOWN[_i].best);
  ck_assert(fit.simple);
}

/* ---- the four pairs ------------------------------------------------------ */

/* Derivatives in all directions, of lengths from .02 to 7; some along the chord
 * or symmetric: those so short that rho^2 > 0, or else the mirror image of the
 * best pair would be as good. */
static struct ph_tc_hermite random_data(struct unit_random *r) {
  double a = unit_random_in(r, -PH_PI, PH_PI);
  double b = unit_random_in(r, -PH_PI, PH_PI);
  double from = exp(unit_random_in(r, -4, 2));
  double to = exp(unit_random_in(r, -4, 2));
  switch (unit_random_below(r, 16)) {
  case 0:
    return unit_tc_data(PH_PI, from, b, to);
  case 1:
    return unit_tc_data(a, from, PH_PI, to);
  case 2:
    return unit_tc_data(0, from, b, to);
  case 3:
    return unit_tc_data(a, fmin(from, 1), -a, fmin(from, 1));
  case 4:
    return unit_tc_data(PH_PI - 1e-9 * a, from, b, to);
  default:
    return unit_tc_data(a, from, b, to);
  }
}

/* They end where they should, with the derivatives given; those of the same w2
 * have the same length, that of rho. */
PH_TEST(test_residual) {
  struct unit_random r = unit_random_of(1);
  double worst = 0, turned = 0, longer = 0;
  for (int i = 0; i < unit_count(20000); i++) {
    struct ph_tc_hermite h = random_data(&r);
    struct ph_tc_fit fits[PH_TC_PAIRS];
    ph_tc_pairs(&h, fits);
    for (size_t j = 0; j < PH_TC_PAIRS; j++) {
      worst = unit_larger(worst, unit_tc_miss(&fits[j]));
      for (size_t k = 0; k < 2; k++) {
        turned = unit_larger(turned,
                             unit_distance(unit_tc_end(&fits[j], k), h.t[k]) /
                                 ph_cplx_abs(h.t[k]));
      }
      ph_tc_fit_measure(&fits[j]);
      longer = unit_larger(longer,
                           unit_rel_error(fits[j].length, fits[j & 2].length));
    }
  }
  ck_assert_msg(worst <= 4e-15, "seed %lu: %.3g", unit_seed(), worst);
  ck_assert_msg(turned <= 2e-15, "seed %lu: %.3g", unit_seed(), turned);
  ck_assert_msg(longer <= 2e-15, "seed %lu: %.3g", unit_seed(), longer);
}

/* A cubic cut in the middle is one of the pairs; the standard one if it turns
 * by less than a half turn. */
PH_TEST(test_cut) {
  struct unit_random r = unit_random_of(2);
  const double half = sqrt(0.5);
  for (int i = 0; i < unit_count(5000); i++) {
    ph_cplx first = unit_random_cplx(&r, 1);
    struct ph_tc tc = {{first, unit_random_cplx(&r, 1)}};
    ph_cplx root = ph_cplx_sqrt(ph_cplx_inverse(ph_tc_leg(&tc)));
    ph_cplx u = ph_cplx_mul(root, tc.w[0]), v = ph_cplx_mul(root, tc.w[1]);
    ph_cplx z = ph_cplx_scale(half / 2, ph_cplx_add(u, v));
    struct ph_tc_fit fits[PH_TC_PAIRS], cut = ph_tc_fit_of(2, PH_ROOT_N);
    struct ph_tc_hermite h;
    double apart = 1;
    cut.tc[0] = (struct ph_tc){{ph_cplx_scale(half, u), z}};
    cut.tc[1] = (struct ph_tc){{z, ph_cplx_scale(half, v)}};
    h.t[0] = ph_tc_snap(unit_tc_end(&cut, 0));
    h.t[1] = ph_tc_snap(unit_tc_end(&cut, 1));
    ph_tc_pairs(&h, fits);
    for (size_t j = 0; j < PH_TC_PAIRS; j++) {
      double d = unit_tc_apart(&fits[j], false, false, &cut);
      apart = d < apart ? d : apart;
      ck_assert_msg(j > 0 || fabs(ph_tc_turning(&tc)) > PH_PI || d <= 1e-7,
                    "seed %lu, %d: %.3g", unit_seed(), i, d);
    }
    ck_assert_msg(apart <= 1e-7, "seed %lu, %d: %.3g", unit_seed(), i, apart);
  }
}

/* A joint in 0 is in both signs of w2, and never chosen. */
PH_TEST(test_joint_zero) {
  for (int i = 1; i < 40; i++) {
    double y = i / 10.0, x = 0.3 + i / 25.0;
    struct ph_tc_hermite h = {{{x, y}, {3 - x, -y}}};
    struct ph_tc_fit fits[PH_TC_PAIRS], best, zero[2];
    size_t n = 0;
    ph_tc_pairs(&h, fits);
    for (size_t j = 0; j < PH_TC_PAIRS; j++) {
      ph_tc_fit_measure(&fits[j]);
      ck_abs(unit_tc_miss(&fits[j]), 0, 1e-15);
      if (!fits[j].regular) {
        ck_assert_uint_lt(n, 2);
        ck_assert_uint_eq(j / 2, n);
        zero[n++] = fits[j];
      }
    }
    ck_assert_uint_eq(n, 2);
    ck_abs(unit_distance(joint_of(&zero[0]), joint_of(&zero[1])), 0, 1e-15);
    ck_assert(ph_tc_pair_best(&h, &best));
    ck_assert(best.regular);
  }
}

/* Along the chord, 3/2 of it: all pairs have cusps. */
PH_TEST(test_all_irregular) {
  struct ph_tc_hermite h = {{{1.5, 0}, {1.5, 0}}};
  struct ph_tc_fit fits[PH_TC_PAIRS], fit;
  ck_assert(!ph_tc_pair_best(&h, &fit));
  ph_tc_pairs(&h, fits);
  for (size_t i = 0; i < PH_TC_PAIRS; i++) {
    ph_tc_fit_measure(&fits[i]);
    ck_assert(!fits[i].regular && !isfinite(fits[i].energy));
    ck_abs(unit_tc_miss(&fits[i]), 0, 1e-15);
  }
}

/* rho = 0: two pairs are one, and both are given. */
PH_TEST(test_rho_zero) {
  for (int i = 1; i < 20; i++) {
    double y = i / 10.0, x = sqrt((4 * y * y + 6) / 3);
    ph_cplx w = ph_cplx_of(x, y), t = ph_cplx_mul(w, w);
    struct ph_tc_hermite h = {{t, ph_cplx_conj(t)}};
    struct ph_tc_fit fits[PH_TC_PAIRS];
    ph_tc_pairs(&h, fits);
    ck_abs(unit_tc_apart(&fits[0], false, false, &fits[1]), 0, 1e-7);
    for (size_t j = 0; j < PH_TC_PAIRS; j++) {
      ph_tc_fit_measure(&fits[j]);
      ck_assert(fits[j].regular);
      ck_abs(unit_tc_miss(&fits[j]), 0, 1e-15);
    }
    ck_assert(fits[0].root != fits[1].root);
  }
}

/* ---- from the other end, in a mirror ------------------------------------- */

/* How near the nearest of the pairs is to a fit seen like that. */
static double nearest(const struct ph_tc_fit *fit, bool reversed, bool mirrored,
                      const struct ph_tc_fit fits[PH_TC_PAIRS]) {
  double near = 1;
  for (size_t i = 0; i < PH_TC_PAIRS; i++) {
    double d = unit_tc_apart(fit, reversed, mirrored, &fits[i]);
    near = d < near ? d : near;
  }
  return near;
}

/* The data in another place are a rounding away from a double root. */
#define SENSITIVE 1e-7

static void ck_seen(const struct ph_tc_hermite *h, bool reversed, bool mirrored,
                    int trial) {
  struct ph_tc_hermite seen =
      reversed ? unit_tc_reversed(*h) : unit_tc_mirrored(*h);
  bool backward = ph_tc_is_backward(h->t[0]) || ph_tc_is_backward(h->t[1]);
  struct ph_tc_fit fits[PH_TC_PAIRS], others[PH_TC_PAIRS], x, y;
  ph_tc_pairs(h, fits);
  ph_tc_pairs(&seen, others);
  for (size_t i = 0; i < PH_TC_PAIRS; i++) {
    double apart = nearest(&others[i], reversed, mirrored, fits);
    ck_assert_msg(apart <= SENSITIVE, "seed %lu, %d: %.3g", unit_seed(), trial,
                  apart);
    if (!backward) { /* with the same name; reversed, that of -w2 changes */
      size_t j = reversed && i >= 2 ? 5 - i : i;
      ck_abs(unit_tc_apart(&others[i], reversed, mirrored, &fits[j]), 0,
             SENSITIVE);
    }
  }
  ck_assert(ph_tc_pair_standard(h, &x) == !backward);
  ck_assert(ph_tc_pair_standard(&seen, &y) == !backward);
  ck_assert(backward || unit_tc_apart(&y, reversed, mirrored, &x) <= SENSITIVE);
  ck_assert(ph_tc_pair_best(h, &x) && ph_tc_pair_best(&seen, &y));
  ck_rel(x.length, y.length, 1e-9);
  ck_rel(x.energy, y.energy, 1e-6);
  ck_assert(x.simple == y.simple);
  ck_assert(unit_tc_apart(&y, reversed, mirrored, &x) <= SENSITIVE);
}

PH_TEST(test_seen) {
  struct unit_random r = unit_random_of(3);
  for (int i = 0; i < unit_count(3000); i++) {
    struct ph_tc_hermite h = random_data(&r);
    ck_seen(&h, false, true, i);
    ck_seen(&h, true, false, i);
  }
}

/* ---- which --------------------------------------------------------------- */

PH_TEST(test_is_safe) {
  static const struct {
    double a, from, b, to;
    bool safe;
  } sight[] = {
      {1.57, 1, -1.57, 0.5, true},     {1.58, 1, 0, 1, false},
      {0, 1, -1.58, 1, false},         {PH_PI, 1, 0, 1, false},
      {0.3, 0.0301, 0.2, 1.399, true}, {0.3, 0.0299, 0.2, 1, false},
      {0.3, 1, 0.2, 1.401, false},     {0, 1, 0, (double)NAN, false},
  };
  for (size_t i = 0; i < COUNT(sight); i++) {
    struct ph_tc_hermite h =
        unit_tc_data(sight[i].a, sight[i].from, sight[i].b, sight[i].to);
    ck_assert(ph_tc_pair_is_safe(&h) == sight[i].safe);
  }
}

/* Of safe data the standard pair is simple, and bends least of those that are:
 * others bend less only where the lengths differ by a factor of 30 or so. */
PH_TEST(test_safe) {
  struct unit_random r = unit_random_of(4);
  for (int i = 0; i < unit_count(3000); i++) {
    double a = unit_random_in(&r, -PH_PI / 2, PH_PI / 2);
    double b = unit_random_in(&r, -PH_PI / 2, PH_PI / 2);
    double from = unit_random_in(&r, 0.03, 1.4);
    double to = unit_random_in(&r, 0.03, 1.4);
    struct ph_tc_hermite h = unit_tc_data(a, from, b, to);
    struct ph_tc_fit fits[PH_TC_PAIRS], best;
    ck_assert(ph_tc_pair_is_safe(&h) && ph_tc_pair_best(&h, &best));
    ck_assert_int_eq(best.root, PH_ROOT_PLUS_PLUS);
    ck_assert(best.simple && ph_tc_fit_test(&best));
    ph_tc_pairs(&h, fits);
    for (size_t j = 1; j < PH_TC_PAIRS; j++) {
      ph_tc_fit_measure(&fits[j]);
      ck_assert(!(fits[j].energy < best.energy) || !ph_tc_fit_test(&fits[j]));
    }
  }
}

/* Of others, the one that the order puts first. */
PH_TEST(test_best) {
  struct unit_random r = unit_random_of(5);
  int standard = 0;
  for (int i = 0; i < unit_count(3000); i++) {
    struct ph_tc_hermite h = random_data(&r);
    struct ph_tc_fit fits[PH_TC_PAIRS], best;
    ck_assert(ph_tc_pair_best(&h, &best));
    ph_tc_pairs(&h, fits);
    for (size_t j = 0; j < PH_TC_PAIRS; j++) {
      ph_tc_fit_measure(&fits[j]);
    }
    ph_tc_fit_order(fits, PH_TC_PAIRS);
    ck_assert_int_eq(best.root, fits[0].root);
    ck_assert(best.regular && best.simple == fits[0].simple);
    ck_rel(best.energy, fits[0].energy, 0);
    standard += best.root == PH_ROOT_PLUS_PLUS;
  }
  ck_assert_int_gt(standard, 0);
  ck_assert_int_lt(standard, unit_count(3000));
}
