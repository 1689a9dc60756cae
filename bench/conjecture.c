/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * conjecture [TRIALS] [SEED]: looks for a counterexample to Conjecture 22 of
 * [BYR11]: where both end derivatives are at most sqrt(3)/2 of the chord long,
 * one of the four pairs of Tschirnhausen cubics neither crosses itself nor has
 * a cusp.  More is asked here: that the standard pair is one.
 *
 * A million trials and seed 1, or as said.  Directions are uniform, or near the
 * chord, forward or backward; lengths are uniform, the greatest, or tiny.
 * Exit status 1, and the data, if there is a counterexample.
 */
#include "bench.h"

#include "curve/cross/tc_simple.h"
#include "kernel/pi.h"
#include "solve/tc/tc.h"

/* Small numbers of all sizes down to 1e-12. */
static double small(uint64_t *state) {
  return pow(10, bench_uniform(state, -12, 0));
}

static double direction(uint64_t *state) {
  double sign = bench_random(state) % 2 ? 1 : -1;
  switch (bench_random(state) % 4) {
  case 0:
    return sign * small(state);
  case 1:
    return sign * (PH_PI - small(state));
  default:
    return bench_uniform(state, -PH_PI, PH_PI);
  }
}

static double length(uint64_t *state) {
  const double most = sqrt(0.75);
  switch (bench_random(state) % 4) {
  case 0:
    return most;
  case 1:
    return most * small(state);
  default:
    return most * bench_uniform(state, 0x1p-53, 1);
  }
}

static ph_cplx derivative(uint64_t *state) {
  double size = length(state);
  return ph_tc_snap(ph_cplx_scale(size, ph_cplx_polar(direction(state))));
}

static void report(const struct ph_tc_hermite *h) {
  printf("counterexample: from 0 to 1\n"
         "  derivatives %.17g %.17g  %.17g %.17g\n",
         h->t[0].re, h->t[0].im, h->t[1].re, h->t[1].im);
}

static unsigned long number(int argc, char **argv, int at,
                            unsigned long otherwise) {
  char *end;
  unsigned long n;
  if (at >= argc) {
    return otherwise;
  }
  n = strtoul(argv[at], &end, 10);
  if (argv[at][0] < '0' || argv[at][0] > '9' || *end != '\0') {
    bench_die("usage: conjecture [TRIALS] [SEED]");
  }
  return n;
}

int main(int argc, char **argv) {
  unsigned long trials = number(argc, argv, 1, 1000000);
  unsigned long seed = number(argc, argv, 2, 1);
  uint64_t state = seed;
  unsigned long undefined = 0, found = 0;
  for (unsigned long i = 0; i < trials; i++) {
    struct ph_tc_hermite h;
    struct ph_tc_fit fit;
    h.t[0] = derivative(&state);
    h.t[1] = derivative(&state);
    if (!ph_tc_pair_standard(&h, &fit)) {
      undefined++; /* exactly backward */
    } else if (!ph_tc_is_simple(fit.tc, fit.n)) {
      report(&h);
      found++;
    }
  }
  printf("Conjecture 22, the standard pair: %lu trials, seed %lu: %lu "
         "counterexamples\n%lu data were exactly backward\n",
         trials, seed, found, undefined);
  return found > 0;
}
