/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Random numbers that are the same on every machine: splitmix64 (Steele, Lea,
 * Flood 2014).  The seed is 1, or PH_SEED; messages of failures name it.
 */
#ifndef PH_TESTS_RANDOM_UNIT_H
#define PH_TESTS_RANDOM_UNIT_H

#include "kernel/cplx.h"

#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

struct unit_random {
  uint64_t state;
};

/* The seed of this run. */
static inline unsigned long unit_seed(void) {
  const char *text = getenv("PH_SEED");

  return text != NULL ? strtoul(text, NULL, 10) : 1;
}

/* Generator number `stream` of this run: tests do not share their numbers. */
static inline struct unit_random unit_random_of(uint64_t stream) {
  struct unit_random r = {unit_seed() * 0xD1B54A32D192ED03u + stream};

  return r;
}

static inline uint64_t unit_random_bits(struct unit_random *r) {
  uint64_t z = r->state += 0x9E3779B97F4A7C15u;

  z = (z ^ z >> 30) * 0xBF58476D1CE4E5B9u;
  z = (z ^ z >> 27) * 0x94D049BB133111EBu;
  return z ^ z >> 31;
}

/* Uniform in [low, high). */
static inline double unit_random_in(struct unit_random *r, double low,
                                    double high) {
  double u = (double)(unit_random_bits(r) >> 11) * 0x1p-53;

  return low + u * (high - low);
}

/* 0, 1, ..., n - 1; n is so small that the bias does not matter. */
static inline size_t unit_random_below(struct unit_random *r, size_t n) {
  return (size_t)(unit_random_bits(r) % n);
}

/* Uniform in the square |re|, |im| < size. */
static inline ph_cplx unit_random_cplx(struct unit_random *r, double size) {
  double re = unit_random_in(r, -size, size);

  return ph_cplx_of(re, unit_random_in(r, -size, size));
}

/* |a - b|, without overflow. */
static inline double unit_distance(ph_cplx a, ph_cplx b) {
  return hypot(a.re - b.re, a.im - b.im);
}

/* The larger; NaN if either is, where fmax would take the other. */
static inline double unit_larger(double a, double b) {
  return b <= a || isnan(a) ? a : b;
}

#endif
