/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Samplers and samples for tests, in one call. */
#ifndef PH_TESTS_SAMPLE_UNIT_H
#define PH_TESTS_SAMPLE_UNIT_H

#include "unit.h"

#include "curve/sample/inversion.h"

/* A sampler of a curve, or of an offset of it, at segment k. */
static inline struct ph_sampler unit_sampler(const struct ph_curve *curve,
                                             const struct ph_offset *offset,
                                             size_t k) {
  struct ph_sampler sampler;
  struct ph_diag diag;
  ck_assert_int_eq(
      ph_sampler_begin(&sampler, curve, offset, &unit_arena, &diag), PH_OK);
  ck_assert_int_eq(ph_sampler_enter(&sampler, k, &diag), PH_OK);
  return sampler;
}

/* The length up to u, without the speed. */
static inline double unit_length(const struct ph_sampler *sampler, double u) {
  double speed;
  return ph_sampler_length(sampler, u, &speed);
}

/* Where the length is s, found from nothing. */
static inline double unit_parameter(const struct ph_sampler *sampler,
                                    double s) {
  struct ph_inversion past = {.n = 0};
  return ph_inversion_next(&past, sampler, s, NULL);
}

static inline struct ph_samples unit_samples(const struct ph_curve *curve,
                                             struct ph_sample_rules rules) {
  struct ph_samples s;
  struct ph_diag diag;
  ck_assert_int_eq(ph_sample_curve(curve, &rules, &unit_arena, &s, &diag),
                   PH_OK);
  ck_assert_uint_eq(s.dimension, curve->dimension);
  return s;
}

/* n + 1 samples of every segment, equally spaced in its parameter. */
static inline struct ph_samples unit_samples_even(const struct ph_curve *curve,
                                                  size_t n) {
  const struct ph_sample_rules rules = {.how = PH_SAMPLE_PARAMETER, .n = n};
  struct ph_samples s = unit_samples(curve, rules);
  ck_assert_uint_eq(s.n, curve->n * (n + 1));
  return s;
}

#endif
