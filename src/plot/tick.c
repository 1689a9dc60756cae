/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Ticks of an axis (see tick.h).  Values are integers times a power of ten, and
 * labels are made of the integers: no rounding, no locale, no -0.
 */
#include "plot/tick.h"

#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

/* Plain labels have so many digits before and after the point at most; more of
 * those after it where the first is not 0. */
enum { WHOLE_MAX = 5, DECIMALS_MAX = 4, DECIMALS_FULL = 6 };

/* More digits than this, and a base is taken off. */
enum { DIGITS_MAX = 6 };

/* Integers beyond this are not exact in a double, with room for a step. */
#define INTEGER_MAX 1e15

static int digits_of(int64_t k) {
  int n = 1;
  for (k = k < 0 ? -k : k; k >= 10; k /= 10) {
    n++;
  }
  return n;
}

/* Appends a byte while there is room. */
static void put(char *text, size_t size, size_t *n, char c) {
  if (*n + 1 < size) {
    text[(*n)++] = c;
    text[*n] = '\0';
  }
}

static void put_text(char *text, size_t size, size_t *n, const char *more) {
  for (; *more; more++) {
    put(text, size, n, *more);
  }
}

/* |k| 10^e as plain decimals. */
static void put_plain(char *text, size_t size, size_t *n, int64_t k, int e) {
  char digits[32];
  int count = 0, point = e < 0 ? -e : 0;
  k = k < 0 ? -k : k;
  do {
    digits[count++] = (char)('0' + k % 10);
    k /= 10;
  } while (k > 0 || count <= point);
  for (int i = count; i-- > 0;) {
    put(text, size, n, digits[i]);
    if (i == point && i > 0) {
      put(text, size, n, '.');
    }
  }
  for (int i = 0; i < e; i++) {
    put(text, size, n, '0');
  }
}

/* |e| and its sign, as an exponent. */
static void put_exponent(char *text, size_t size, size_t *n, int e) {
  put(text, size, n, 'e');
  if (e < 0) {
    put(text, size, n, '-');
  }
  put_plain(text, size, n, e, 0);
}

/* What is taken off all labels, in the unit of the last digit of the step. */
static void base_text(struct ph_ticks *ticks, int64_t base, int e) {
  size_t n = 0;
  int digits = digits_of(base);
  ticks->base_negative = base < 0;
  while (base % 10 == 0) {
    base /= 10;
    e++;
    digits--;
  }
  if (digits + e <= 15 && e >= -9 && digits <= 15) {
    put_plain(ticks->base, sizeof ticks->base, &n, base, e);
  } else {
    put_plain(ticks->base, sizeof ticks->base, &n, base, 1 - digits);
    put_exponent(ticks->base, sizeof ticks->base, &n, e + digits - 1);
  }
}

static int64_t floor_to(int64_t k, int64_t unit) {
  int64_t rest = k % unit;
  return k - (rest < 0 ? rest + unit : rest);
}

/* A round number among first .. last, or below them, where it saves digits. */
static int64_t base_of(int64_t first, int64_t last) {
  int64_t most = llabs(first) > llabs(last) ? first : last, unit = 1, base;
  if (digits_of(most) <= DIGITS_MAX) {
    return 0;
  }
  while (unit < last - first) {
    unit *= 10;
  }
  if (digits_of(unit) + 1 >= digits_of(most)) {
    return 0;
  }
  base = floor_to(last, unit);
  return base >= first ? base : floor_to(first, unit);
}

static void labels(struct ph_ticks *ticks, int64_t first, int64_t step, int e) {
  int64_t last = first + (int64_t)(ticks->n - 1) * step;
  int64_t base = base_of(first, last), most;
  int digits, decimals;
  if (base != 0) {
    base_text(ticks, base, e);
  }
  first -= base;
  last -= base;
  most = llabs(first) > llabs(last) ? first : last;
  digits = digits_of(most);
  decimals = digits + e >= 0 ? DECIMALS_FULL : DECIMALS_MAX;
  if (most != 0 && (digits + e > WHOLE_MAX || e < -decimals)) {
    ticks->power = e + digits - 1;
  }
  for (size_t i = 0; i < ticks->n; i++) {
    int64_t k = first + (int64_t)i * step;
    size_t n = 0;
    ticks->label[i][0] = '\0';
    if (k < 0) {
      put_text(ticks->label[i], PH_TICK_LABEL_MAX, &n, "\xE2\x88\x92");
    }
    put_plain(ticks->label[i], PH_TICK_LABEL_MAX, &n, k,
              k == 0 ? 0 : e - ticks->power);
  }
}

/* k 10^e: by parts, where 10^e alone would be no normal number. */
static double value(double k, int e) {
  return e < -300 ? k * pow(10, e + 40) * 1e-40 : k * pow(10, e);
}

void ph_ticks_make(double low, double high, size_t wanted,
                   struct ph_ticks *ticks) {
  double raw = high / (double)wanted - low / (double)wanted, first, last;
  static const int steps[] = {1, 2, 5, 10};
  int e, i = 0, step;
  memset(ticks, 0, sizeof *ticks);
  if (!(raw > 0 && isfinite(raw))) {
    return;
  }
  e = (int)floor(log10(raw));
  while (i < 3 && !(value(steps[i], e) >= raw * (1 - 1e-9))) {
    i++;
  }
  e += i == 3;
  step = i == 3 ? 1 : steps[i];
  /* both divided by the unit in two parts: neither need be a normal number */
  first = ceil(low / value(step, e) - 1e-6);
  last = floor(high / value(step, e) + 1e-6);
  if (!(fabs(first) * step < INTEGER_MAX && fabs(last) * step < INTEGER_MAX &&
        first <= last)) {
    return;
  }
  for (double k = first; k <= last && ticks->n < PH_TICKS_MAX; k++) {
    ticks->at[ticks->n++] = value(k * step, e);
  }
  labels(ticks, (int64_t)first * step, step, e);
}
