/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Scaling by powers of two: nothing but the exponent changes. */
#include "unit.h"

#include "kernel/pow2.h"

PH_TEST(test_exponent) {
  ck_assert_int_eq(ph_pow2_exponent(1), 0);
  ck_assert_int_eq(ph_pow2_exponent(nextafter(2, 1)), 0);
  ck_assert_int_eq(ph_pow2_exponent(2), 1);
  ck_assert_int_eq(ph_pow2_exponent(nextafter(1, 0)), -1);
  ck_assert_int_eq(ph_pow2_exponent(DBL_MAX), 1023);
  ck_assert_int_eq(ph_pow2_exponent(DBL_MIN), -1022);
  ck_assert_int_eq(ph_pow2_exponent(0x1p-1074), -1074);
  ck_assert_int_eq(ph_pow2_exponent(0x1.8p-1040), -1040);
}

/* Every size of number goes to unit scale, and comes back as it was. */
PH_TEST(test_round_trip) {
  struct unit_random r = unit_random_of(1);
  for (int e = -1074; e <= 1023; e++) {
    double x = ldexp(unit_random_in(&r, 1, 2), e);
    int exponent = ph_pow2_exponent(x);
    double unit = ph_pow2_apply(ph_pow2_of(-exponent), x);
    ck_assert(unit >= 1 && unit < 2);
    ck_abs(ldexp(unit, exponent), x, 0);
    ck_abs(ph_pow2_apply(ph_pow2_of(exponent), unit), x, 0);
    ck_abs(ph_pow2_apply(ph_pow2_of(exponent), -unit), -x, 0);
  }
}

/* Wherever the result is a normal number it is the exact one. */
PH_TEST(test_exact) {
  struct unit_random r = unit_random_of(2);
  for (int e = -2000; e <= 2000; e++) {
    double x = unit_random_in(&r, 1, 2);
    int low = e > 0 ? -1022 : -1022 - e, high = e > 0 ? 1023 - e : 1023;
    int exponents[] = {low, high};
    for (int i = 0; i < 2 && low <= high; i++) {
      double from = ldexp(x, exponents[i]);
      ck_abs(ph_pow2_apply(ph_pow2_of(e), from), ldexp(x, exponents[i] + e), 0);
    }
  }
  ck_abs(ph_pow2_apply(ph_pow2_of(2000), DBL_MIN), ldexp(DBL_MIN, 2000), 0);
}

PH_TEST(test_range) {
  ck_assert(isinf(ph_pow2_apply(ph_pow2_of(1), DBL_MAX)));
  ck_abs(ph_pow2_apply(ph_pow2_of(-2000), DBL_MIN), 0, 0);
  ck_abs(ph_pow2_apply(ph_pow2_of(2000), 0), 0, 0);
}
