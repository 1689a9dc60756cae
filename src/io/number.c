/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Text <-> double, exactly (see number.h).
 *
 * Both directions rest on one product: w 10^q for a 64-bit integer w, taken
 * to 128 bits with a table of powers rounded up (number_table.h).  It is too
 * large by less than one unit of its last bit, and this never matters: no
 * w 10^q comes that close to a place of decision without lying on it, which
 * tests/unit/io/t_number_table.c proves by continued fractions, for every w and
 * q in use.  Hence there is no "cannot tell" exit in either direction.
 *
 * Reading: the product is rounded to 53 bits [Lemire 2021; Mushtak and Lemire
 * 2023, who prove the same for a table rounded down].  A text of more than 19
 * digits lies between w 10^q and (w + 1) 10^q; only if these round to
 * different doubles, all of its digits are looked at.  The fast path of
 * Clinger (1990), one multiplication of doubles, gains nothing here, and
 * depends on the rounding mode and on wide x87 registers: left out.
 *
 * Writing: Schubfach [Giulietti 2020]: scale the rounding interval of x by the
 * power of ten that makes it a few units wide, and take the best integer.
 *
 * No formatting with a given number of digits, no hexadecimal, no NaN.
 */
#include "io/number.h"

#include "io/number_table.h"

#include <assert.h>
#include <float.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

_Static_assert(FLT_RADIX == 2 && DBL_MANT_DIG == 53 && DBL_MAX_EXP == 1024 &&
                   sizeof(double) == sizeof(uint64_t),
               "double must be the 64-bit IEEE 754 format");

#define SIGN_BIT (UINT64_C(1) << 63)
#define HIDDEN_BIT (UINT64_C(1) << 52)
#define INFINITY_BITS (UINT64_C(0x7ff) << 52)

/* ---- the product ---------------------------------------------------- */

/*
 * The upper 128 bits of the 192-bit product of w and ph_pow10[q].  The table
 * is rounded up, so the 192 bits exceed the true product by less than
 * w < 2^64.
 */
static inline struct ph_u128 scale(uint64_t w, int q) {
  const struct ph_u128 *power = &ph_pow10[q - PH_POW10_MIN];
  struct ph_u128 v = ph_mul64(w, power->hi);
  uint64_t carried = ph_mul64(w, power->lo).hi;
  v.lo += carried;
  v.hi += v.lo < carried;
  return v;
}

static inline int leading_zeros(uint64_t w) {
#ifdef __GNUC__
  return __builtin_clzll(w);
#else
  int n = 0;
  for (; w < SIGN_BIT; w <<= 1) {
    n++;
  }
  return n;
#endif
}

/* ---- digits --------------------------------------------------------- */

/* The number of digits of v < 10^17, which is mostly 16 or 17. */
static inline int count_digits(uint64_t v) {
  if (v >= UINT64_C(1000000000000000)) {
    return 16 + (v >= UINT64_C(10000000000000000));
  }
  int n = 1;
  for (uint64_t power = 10; v >= power; power *= 10) {
    n++;
  }
  return n;
}

static inline void put_pair(char *to, uint32_t v) {
  static const char pairs[] = "00010203040506070809"
                              "10111213141516171819"
                              "20212223242526272829"
                              "30313233343536373839"
                              "40414243444546474849"
                              "50515253545556575859"
                              "60616263646566676869"
                              "70717273747576777879"
                              "80818283848586878889"
                              "90919293949596979899";
  memcpy(to, pairs + 2 * v, 2);
}

/* Writes v so that it ends just before `end`. */
static inline void put_digits(char *end, uint64_t v) {
  while (v >= 100000000) { /* four pairs that do not wait for each other */
    uint32_t low = (uint32_t)(v % 100000000);
    v /= 100000000;
    end -= 8;
    put_pair(end, low / 1000000);
    put_pair(end + 2, low / 10000 % 100);
    put_pair(end + 4, low / 100 % 100);
    put_pair(end + 6, low % 100);
  }
  uint32_t u = (uint32_t)v;
  for (; u >= 100; u /= 100) {
    put_pair(end -= 2, u % 100);
  }
  if (u >= 10) {
    put_pair(end - 2, u);
  } else {
    end[-1] = (char)('0' + u);
  }
}

/* Writes "e-7" at p and returns its end. */
static inline char *put_exponent(char *p, int e) {
  *p++ = 'e';
  if (e < 0) {
    *p++ = '-';
    e = -e;
  }
  p += count_digits((uint64_t)e);
  put_digits(p, (uint64_t)e);
  return p;
}

static inline bool is_digit(char c) {
  return (unsigned char)(c - '0') < 10;
}

/* Eight characters, the first one in the lowest byte whatever the machine's
   byte order is; compilers make this one load. */
static inline uint64_t load_eight(const char *p) {
  const unsigned char *u = (const unsigned char *)p;
  return (uint64_t)u[0] | (uint64_t)u[1] << 8 | (uint64_t)u[2] << 16 |
         (uint64_t)u[3] << 24 | (uint64_t)u[4] << 32 | (uint64_t)u[5] << 40 |
         (uint64_t)u[6] << 48 | (uint64_t)u[7] << 56;
}

/* A digit has 3 in its upper half, and still has it when 6 is added. */
static inline bool are_eight_digits(uint64_t c) {
  const uint64_t upper = UINT64_C(0xf0f0f0f0f0f0f0f0);
  return ((c & upper) | ((c + UINT64_C(0x0606060606060606)) & upper) >> 4) ==
         UINT64_C(0x3333333333333333);
}

/* Joins neighbours: digits to pairs, then pairs 0, 2 and 1, 3 with their
   weights, all four of which meet in the upper word. */
static inline uint64_t eight_digits(uint64_t c) {
  const uint64_t mask = UINT64_C(0x000000ff000000ff);
  c -= UINT64_C(0x3030303030303030);
  c = c * 10 + (c >> 8);
  return ((c & mask) * (100 + (UINT64_C(1000000) << 32)) +
          (c >> 16 & mask) * (1 + (UINT64_C(10000) << 32))) >>
         32;
}

/* Appends the digits at p to *w (modulo 2^64) and returns their end. */
static inline const char *take_digits(const char *p, const char *end,
                                      uint64_t *w) {
  while (end - p >= 8) {
    uint64_t c = load_eight(p);
    if (!are_eight_digits(c)) {
      break;
    }
    *w = *w * 100000000 + eight_digits(c);
    p += 8;
  }
  for (; p != end && is_digit(*p); p++) {
    *w = *w * 10 + (uint64_t)(*p - '0');
  }
  return p;
}

/* ---- reading -------------------------------------------------------- */

/*
 * The bits of the double nearest to w 10^q, ties to even.
 *
 * With lz = the leading zeros of w, L = floor(log2(10^q)), and v read as an
 * integer of 128 bits,
 *   w 10^q = v 2^(L - 63 - lz),  2^62 <= v.hi < 2^64,
 * except that v is rounded.  The result depends on the upper 54 bits of v (53
 * and the half bit; fewer for a subnormal) and on whether the others are all
 * zero.  The true product is either a multiple of 2^137, the lowest half bit
 * in units of the 192-bit product, or at least 2^64 away from all of them
 * (test_gap_reader); v decides rightly in both cases.
 */
static uint64_t nearest(uint64_t w, int64_t q) {
  if (w == 0 || q < PH_POW10_MIN) {
    return 0; /* 2^64 10^-343 is below half the smallest subnormal */
  }
  if (q > DBL_MAX_10_EXP) {
    return INFINITY_BITS;
  }
  int lz = leading_zeros(w);
  struct ph_u128 v = scale(w << lz, (int)q);
  /* v.hi >> spare keeps the 54 bits; the result is f 2^(e - 1075). */
  int spare = 9 + (int)(v.hi >> 63);
  int e = ph_log2_pow10((int)q) - lz + spare + 1077;
  if (e < 1) {
    spare += 1 - e;
    e = 1;
    if (spare > 63) {
      return 0;
    }
  }
  uint64_t twice_f = v.hi >> spare;
  bool exact = v.lo == 0 && twice_f << spare == v.hi;
  if (exact && (twice_f & 3) == 1) {
    twice_f--; /* a tie, and the even neighbour is below */
  }
  uint64_t f = (twice_f + 1) >> 1;
  /* The hidden bit of f adds one to e - 1, as does a carry out of f. */
  uint64_t bits = ((uint64_t)(e - 1) << 52) + f;
  return bits < INFINITY_BITS ? bits : INFINITY_BITS;
}

/* The middle between two doubles has at most 768 significant digits, just
   below 2^-1021; later digits only tell "at" the middle from "above" it. */
enum { SIGNIFICANT_MAX = 768 };

/*
 * The bits of the double nearest to D 10^q, where D is the integer of all the
 * digits in [p, end); a point among them does not count, and the first is not
 * zero.  The caller has seen that the result is about a finite double, which
 * bounds the exponent.  strtod gets "ddd...de-123": without a decimal point,
 * there is nothing a locale could change.
 */
static uint64_t nearest_long(const char *p, const char *end, int64_t q) {
  char text[SIGNIFICANT_MAX + sizeof "1e-12345"];
  char *to = text;
  bool above = false;
  for (; p != end; p++) {
    if (*p == '.') {
      continue;
    }
    if (to < text + SIGNIFICANT_MAX) {
      *to++ = *p;
    } else {
      above |= *p != '0';
      q++;
    }
  }
  if (above) {
    *to++ = '1';
    q--;
  }
  to = put_exponent(to, (int)q);
  *to = '\0';
  double x = strtod(text, NULL);
  uint64_t bits;
  memcpy(&bits, &x, sizeof bits);
  return bits;
}

/* The same for any digits, n of them: the first 19 significant ones, which
   always fit into w, nearly always decide. */
static uint64_t nearest_any(const char *p, const char *end, size_t n,
                            int64_t q) {
  for (; p != end && (*p == '0' || *p == '.'); p++) {
    n -= *p == '0';
  }
  const char *first = p;
  uint64_t w = 0;
  for (int taken = 0; n && taken < 19; p++) {
    if (*p != '.') {
      w = w * 10 + (uint64_t)(*p - '0');
      taken++;
      n--;
    }
  }
  uint64_t bits = nearest(w, q + (int64_t)n);
  if (n && bits != nearest(w + 1, q + (int64_t)n)) {
    bits = nearest_long(first, end, q);
  }
  return bits;
}

/* Adds the exponent at p, such as "e-12", to *q and returns its end; returns p
   if there is none. */
static inline const char *take_exponent(const char *p, const char *end,
                                        int64_t *q) {
  const char *s = p;
  if (s == end || (*s != 'e' && *s != 'E')) {
    return p;
  }
  s++;
  bool negative = s != end && *s == '-';
  if (s != end && (*s == '-' || *s == '+')) {
    s++;
  }
  if (s == end || !is_digit(*s)) {
    return p;
  }
  int64_t e = 0;
  for (; s != end && is_digit(*s); s++) {
    /* No text has the 10^17 digits that could make up for a larger one. */
    if (e < INT64_C(100000000000000000)) {
      e = e * 10 + (*s - '0');
    }
  }
  *q += negative ? -e : e;
  return s;
}

static inline const char *read_number(const char *p, const char *end, bool json,
                                      double *x) {
  bool negative = p != end && *p == '-';
  if (negative || (!json && p != end && *p == '+')) {
    p++;
  }
  const char *first = p;
  uint64_t w = 0;
  if (json && p != end && *p == '0') {
    p++; /* a digit after it does not belong to the number */
  } else {
    p = take_digits(p, end, &w);
  }
  size_t n = (size_t)(p - first);
  int64_t q = 0;
  if (p != end && *p == '.' && (n || !json)) {
    const char *fraction = p + 1;
    const char *s = take_digits(fraction, end, &w);
    size_t n_fraction = (size_t)(s - fraction);
    n += n_fraction;
    q = -(int64_t)n_fraction;
    if (n_fraction || !json) {
      p = s;
    }
  }
  if (n == 0) {
    return NULL;
  }
  const char *last = p;
  p = take_exponent(p, end, &q);
  uint64_t bits = n <= 19 ? nearest(w, q) : nearest_any(first, last, n, q);
  bits |= negative ? SIGN_BIT : 0;
  memcpy(x, &bits, sizeof bits);
  return p;
}

const char *ph_number_read(const char *p, const char *end, double *x) {
  return read_number(p, end, true, x);
}

const char *ph_number_read_text(const char *p, const char *end, double *x) {
  return read_number(p, end, false, x);
}

/* ---- writing -------------------------------------------------------- */

/* s 10^k */
struct decimal {
  uint64_t s;
  int k;
};

/*
 * floor(u 10^q 2^j), with its last bit set when it is not exact ("round to
 * odd"); that is enough to compare with even integers.  j = -1 - floor(log2(
 * 10^q)), as the table has it; shortest() makes up for it.  The low bits of v
 * are zero if the true product is an integer, and only then, except at one
 * place where the floor is odd (test_gap_writer).
 */
static inline uint64_t round_to_odd(uint64_t u, int q) {
  struct ph_u128 v = scale(u, q);
  return v.hi | (v.lo != 0);
}

/*
 * The shortest decimal that reads back as x = c 2^q, whose bits are given, and
 * the closest to x of those.  Names as in Giulietti (2020).
 *
 * The unit is 10^k, the largest power of ten not above the width of the
 * interval of reals that round to x: at least one multiple of 10^k is
 * inside, and at most one of 10^(k+1), which would be shorter.  All is
 * counted in quarters of the unit, to have the middle between two integers
 * and a bit for "inexact".
 */
static struct decimal shortest(uint64_t bits) {
  uint64_t fraction = bits & (HIDDEN_BIT - 1);
  int exponent = (int)(bits >> 52);
  uint64_t c = exponent ? HIDDEN_BIT | fraction : fraction;
  int q = (exponent ? exponent : 1) - 1075;
  if (-52 <= q && q <= 0 && (c & ((UINT64_C(1) << -q) - 1)) == 0) {
    return (struct decimal){c >> -q, 0}; /* an integer below 2^53 */
  }
  /* Below a power of two the doubles are closer together. */
  bool irregular = fraction == 0 && exponent > 1;
  /* floor(log10(2^q)) or floor(log10(3/4 2^q)): log10(2) and log10(4/3) times
     2^20, near enough for every q; 2^29 keeps the shift from negatives. */
  int k = ((q * 315653 - (irregular ? 131008 : 0) + (1 << 29)) >> 20) - 512;
  int h = q + ph_log2_pow10(-k) + 1; /* 2^q without the j of round_to_odd */
  uint64_t lower = round_to_odd((4 * c - 2 + irregular) << h, -k);
  uint64_t v = round_to_odd(4 * c << h, -k);
  uint64_t upper = round_to_odd((4 * c + 2) << h, -k);
  /* The ends round to the even neighbour: they are outside if c is odd. */
  lower += c & 1;
  upper -= c & 1;

  uint64_t s = v / 4;
  uint64_t tens = s / 10;
  bool down = lower <= 40 * tens;
  bool up = 40 * tens + 40 <= upper;
  if (tens && down != up) {
    return (struct decimal){tens + up, k + 1};
  }
  down = lower <= 4 * s;
  up = 4 * s + 4 <= upper;
  if (down == up) { /* both are inside: the closer one, or the even one */
    uint64_t middle = 4 * s + 2;
    up = v > middle || (v == middle && (s & 1));
  }
  return (struct decimal){s + up, k};
}

/* Writes d at p in the form number.h promises, and returns its end. */
static char *put_decimal(char *p, struct decimal d) {
  if (d.s % 100000000 == 0) { /* spares short decimals eight zeros */
    d.s /= 100000000;
    d.k += 8;
  }
  int n = count_digits(d.s);
  int point = n + d.k; /* the value is 0.ddd 10^point */
  if (d.k >= 0 && point <= 21) {
    memset(p, '0', 21);
    put_digits(p + n, d.s);
    return p + point;
  }
  if (-5 <= point && point <= 0) {
    memcpy(p, "0.00000", 7);
    p += 2 - point;
    put_digits(p + n, d.s);
    for (p += n; p[-1] == '0'; p--) {
    }
    return p;
  }
  /* Leave a place for the point, and move what precedes it to the left. */
  bool plain = 0 < point && point <= 21;
  int before = plain ? point : 1;
  put_digits(p + 1 + n, d.s);
  for (int i = 0; i < before; i++) {
    p[i] = p[i + 1];
  }
  p[before] = '.';
  for (; p[n] == '0'; n--) {
  }
  p += n == before ? n : n + 1; /* no point after a single digit */
  return plain ? p : put_exponent(p, point - 1);
}

size_t ph_number_write(char *out, double x) {
  uint64_t bits;
  memcpy(&bits, &x, sizeof bits);
  char *p = out;
  if (bits & SIGN_BIT) {
    *p++ = '-';
    bits ^= SIGN_BIT;
  }
  assert(bits < INFINITY_BITS);
  if (bits == 0) {
    *p++ = '0';
  } else {
    p = put_decimal(p, shortest(bits));
  }
  return (size_t)(p - out);
}
