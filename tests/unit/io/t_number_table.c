/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * What number.c takes for granted, proved with exact integers: every entry of
 * the table of powers of ten, the 128-bit product, and the two gaps, that is,
 * that rounding the table up never changes a result.
 */
#include "unit.h"

#include "io/number_table.h"

#include <inttypes.h>

/* splitmix64 (Steele, Lea and Flood 2014) */
static uint64_t next_random(uint64_t *state) {
  uint64_t z = *state += UINT64_C(0x9e3779b97f4a7c15);
  z = (z ^ z >> 30) * UINT64_C(0xbf58476d1ce4e5b9);
  z = (z ^ z >> 27) * UINT64_C(0x94d049bb133111eb);
  return z ^ z >> 31;
}

/* ---- exact integers ------------------------------------------------- */

/* 1024 bits: the products below have at most 923. */
enum { LIMBS = 32 };

struct big {
  uint32_t limb[LIMBS]; /* the lowest first */
};

static struct big big_make(uint64_t hi, uint64_t lo) {
  return (struct big){
      {(uint32_t)lo, (uint32_t)(lo >> 32), (uint32_t)hi, (uint32_t)(hi >> 32)}};
}

static int big_compare(const struct big *a, const struct big *b) {
  for (size_t i = LIMBS; i-- > 0;) {
    if (a->limb[i] != b->limb[i]) {
      return a->limb[i] < b->limb[i] ? -1 : 1;
    }
  }
  return 0;
}

/* a -= b, for b <= a */
static void big_subtract(struct big *a, const struct big *b) {
  uint64_t borrow = 0;
  for (size_t i = 0; i < LIMBS; i++) {
    uint64_t difference = (uint64_t)a->limb[i] - b->limb[i] - borrow;
    a->limb[i] = (uint32_t)difference;
    borrow = difference >> 63;
  }
}

static void big_multiply(struct big *a, uint32_t factor) {
  uint64_t carry = 0;
  for (size_t i = 0; i < LIMBS; i++) {
    carry += (uint64_t)a->limb[i] * factor;
    a->limb[i] = (uint32_t)carry;
    carry >>= 32;
  }
  if (carry) {
    ck_abort_msg("struct big is too small");
  }
}

/* a *= 5^n 2^shift */
static void big_scale(struct big *a, int n, int shift) {
  for (; n > 0; n--) {
    big_multiply(a, 5);
  }
  for (; shift >= 31; shift -= 31) {
    big_multiply(a, UINT32_C(1) << 31);
  }
  big_multiply(a, UINT32_C(1) << shift);
}

static int max(int a, int b) {
  return a > b ? a : b;
}

/* ---- the table and the product -------------------------------------- */

/* The sign of T - 10^q 2^-e for T = hi 2^64 + lo. */
static int compare_power(uint64_t hi, uint64_t lo, int q, int e) {
  struct big a = big_make(hi, lo), b = big_make(0, 1);
  big_scale(&a, max(-q, 0), max(e - q, 0));
  big_scale(&b, max(q, 0), max(q - e, 0));
  return big_compare(&a, &b);
}

/* T - 1 < 10^q 2^-e <= T and 2^127 <= T < 2^128 leave no other T and e. */
PH_TEST(test_table) {
  for (int q = PH_POW10_MIN; q <= PH_POW10_MAX; q++) {
    struct ph_u128 t = ph_pow10[q - PH_POW10_MIN];
    int e = ph_log2_pow10(q) - 127;
    ck_assert_msg(t.hi >> 63 == 1, "10^%d", q);
    ck_assert_msg(compare_power(t.hi, t.lo, q, e) >= 0, "10^%d", q);
    ck_assert_msg(compare_power(t.hi - (t.lo == 0), t.lo - 1, q, e) < 0,
                  "10^%d", q);
  }
}

PH_TEST(test_multiply) {
  uint64_t state = 1;
  for (int i = 0; i < 100000; i++) {
    uint64_t a = next_random(&state), b = next_random(&state);
    if (i % 4 == 1) {
      a = (uint64_t)0 - (a & 3);
    } else if (i % 4 == 2) {
      b = UINT64_C(0xffffffff) << (b & 63);
    } else if (i % 4 == 3) {
      a >>= a & 63;
      b >>= b & 63;
    }
    struct ph_u128 p = ph_mul64(a, b), r = ph_mul64_portable(a, b);
    struct big exact = big_make(0, a);
    big_multiply(&exact, (uint32_t)b);
    struct big upper = big_make(a >> 32, a << 32);
    big_multiply(&upper, (uint32_t)(b >> 32));
    struct big product = big_make(p.hi, p.lo);
    big_subtract(&product, &exact);
    if (p.hi != r.hi || p.lo != r.lo || big_compare(&product, &upper) != 0) {
      ck_abort_msg("%" PRIu64 " * %" PRIu64, a, b);
    }
  }
}

/*
 * Whether each of x a / m, x = 1..n, is an integer or at least 2^-bits away
 * from all integers; m > 1.
 *
 * rest[0] and rest[1] are the smallest positive rests of x a and of -x a modulo
 * m so far, found at x[0] and x[1].  The next improvement is at x[0] + x[1],
 * and is the difference of the two: this is the subtractive form of Euclid's
 * algorithm, which yields the best one-sided approximations of a / m.  Equal
 * steps are taken together, by doubling.
 */
static bool is_apart(struct big a, const struct big *m, uint64_t n, int bits) {
  struct big rest[2] = {a, *m};
  uint64_t x[2] = {1, 1};
  while (big_compare(&rest[0], m) >= 0) {
    big_subtract(&rest[0], m);
  }
  if (big_compare(&rest[0], &(struct big){{0}}) == 0) {
    return true;
  }
  big_subtract(&rest[1], &rest[0]);
  for (;;) {
    int order = big_compare(&rest[0], &rest[1]);
    int i = order < 0; /* the larger one */
    if (order == 0 || x[1 - i] > n - x[i]) {
      break;
    }
    struct big step = rest[1 - i];
    uint64_t dx = x[1 - i];
    while (dx <= (n - x[i]) / 2) {
      struct big twice = step;
      big_multiply(&twice, 2);
      if (big_compare(&twice, &rest[i]) >= 0) {
        break;
      }
      step = twice;
      dx *= 2;
    }
    big_subtract(&rest[i], &step);
    x[i] += dx;
  }
  big_scale(&rest[0], 0, bits);
  big_scale(&rest[1], 0, bits);
  return big_compare(&rest[0], m) >= 0 && big_compare(&rest[1], m) >= 0;
}

/* is_apart itself, against trying all x */
PH_TEST(test_apart) {
  const uint64_t most = unit_count(10) < 10 ? 20 : 50;
  for (uint64_t m = 2; m < most; m++) {
    for (uint64_t a = 0; a < 2 * m; a++) {
      uint64_t closest = m;
      for (uint64_t n = 1; n < 60; n++) {
        uint64_t rest = n * a % m;
        if (rest && rest < closest) {
          closest = rest;
        }
        if (rest && m - rest < closest) {
          closest = m - rest;
        }
        struct big modulus = big_make(0, m);
        for (int bits = 0; bits < 7; bits += 1 + (n > 9)) {
          if (is_apart(big_make(0, a), &modulus, n, bits) !=
              (closest << bits >= m)) {
            ck_abort_msg("%d %d %d", (int)m, (int)a, (int)n);
          }
        }
      }
    }
  }
}

/* The same for 10^q 2^shift in place of a / m. */
static bool is_power_apart(int q, int shift, uint64_t n, int bits) {
  struct big a = big_make(0, 1), m = big_make(0, 1);
  big_scale(&a, max(q, 0), max(q + shift, 0));
  big_scale(&m, max(-q, 0), max(-q - shift, 0));
  return is_apart(a, &m, n, bits);
}

/* The reader: w 10^q in units of the 192-bit product is w 10^q 2^(127 - L), L
   the exponent of 10^q; the half bit of the result counts 2^137 or more. */
PH_TEST(test_gap_reader) {
  for (int q = PH_POW10_MIN; q <= DBL_MAX_10_EXP; q++) {
    int shift = 127 - ph_log2_pow10(q) - 137;
    ck_assert_msg(is_power_apart(q, shift, UINT64_MAX, 137 - 64), "10^%d", q);
  }
}

/*
 * The writer: 4 c and 4 c +- 2 are 2 x, x <= 2^54 + 1, and round_to_odd(2 x)
 * stands for 2 x 2^q 10^-k; a distance of 2^-64 shows in the low bits.  There
 * is one x, at q = 664, that leaves less, but there the floor is odd anyway.
 * A second one would differ from it by some d, again close to an integer.
 * The odd 4 c - 1 of the powers of two are left to test_powers in t_number.c.
 */
PH_TEST(test_gap_writer) {
  const uint64_t last = (UINT64_C(1) << 54) + 1;
  const uint64_t odd_one = UINT64_C(17774110498711576);
  for (int q = -1074, k = -324; q <= 971; q++) {
    while (ph_log2_pow10(k + 1) < q || (k + 1 == 0 && q == 0)) {
      k++; /* the largest with 10^k <= 2^q */
    }
    uint64_t n = q == 664 ? odd_one - 1 : last;
    ck_assert_msg(is_power_apart(-k, q + 1, n, 64), "2^%d", q);
  }
  ck_assert(is_power_apart(-199, 665, last - odd_one, 60));
  /* 2 x 2^664 / 10^199 */
  struct big floor = big_make(0, odd_one), m = big_make(0, 1);
  big_scale(&floor, 0, 665 - 199);
  big_scale(&m, 199, 0);
  uint64_t quotient = 0;
  for (int i = 63; i >= 0; i--) {
    struct big part = m;
    big_scale(&part, 0, i);
    if (big_compare(&part, &floor) <= 0) {
      big_subtract(&floor, &part);
      quotient |= UINT64_C(1) << i;
    }
  }
  ck_assert_uint_eq(quotient & 1, 1);
}
