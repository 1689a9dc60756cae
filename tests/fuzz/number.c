/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Fuzz target: numbers.  The bytes as a text must be read as strtod reads it;
 * the first eight as a double must be written so that it comes back, with no
 * more digits than it needs.
 */
#include "fuzz.h"

#include "io/number.h"

#include <math.h>
#include <stdbool.h>
#include <string.h>

static bool number_same(double a, double b) {
  return memcmp(&a, &b, sizeof a) == 0;
}

/* strtod of the n bytes at p, which are one number to it. */
static double number_strtod(const char *p, size_t n) {
  char *text = malloc(n + 1), *end;
  double x;
  FUZZ_REQUIRE(text != NULL);
  memcpy(text, p, n);
  text[n] = '\0';
  x = strtod(text, &end);
  FUZZ_REQUIRE(end == text + n);
  free(text);
  return x;
}

static void number_check_read(const char *text, size_t n) {
  double strict = 0, loose = 0;
  const char *end = ph_number_read(text, text + n, &strict);
  const char *loose_end = ph_number_read_text(text, text + n, &loose);
  if (end) {
    FUZZ_REQUIRE(end > text && end <= text + n);
    FUZZ_REQUIRE(
        number_same(strict, number_strtod(text, (size_t)(end - text))));
    FUZZ_REQUIRE(loose_end && loose_end >= end);
  }
  if (loose_end) {
    FUZZ_REQUIRE(loose_end > text && loose_end <= text + n);
    FUZZ_REQUIRE(
        number_same(loose, number_strtod(text, (size_t)(loose_end - text))));
  }
}

static size_t number_digits(const char *text, size_t n) {
  size_t digits = 0, zeros = 0;
  for (size_t i = 0; i < n && text[i] != 'e'; i++) {
    if (text[i] >= '0' && text[i] <= '9' && (digits > 0 || text[i] != '0')) {
      digits++;
      zeros = text[i] == '0' ? zeros + 1 : 0;
    }
  }
  return digits - zeros;
}

static void number_check_write(double x) {
  char text[PH_NUMBER_MAX], fewer[64];
  size_t n = ph_number_write(text, x);
  size_t digits = number_digits(text, n);
  double back = 0;
  FUZZ_REQUIRE(n > 0 && n <= PH_NUMBER_MAX && digits <= 17);
  FUZZ_REQUIRE(ph_number_read(text, text + n, &back) == text + n);
  FUZZ_REQUIRE(number_same(x, back));
  FUZZ_REQUIRE(number_same(x, number_strtod(text, n)));
  if (digits > 1) {
    snprintf(fewer, sizeof fewer, "%.*e", (int)digits - 2, x);
    FUZZ_REQUIRE(!number_same(x, strtod(fewer, NULL)));
  }
}

FUZZ_TARGET(number, data, n) {
  double x;
  number_check_read((const char *)data, n);
  if (n >= sizeof x) {
    memcpy(&x, data, sizeof x);
    if (isfinite(x)) {
      number_check_write(x);
    }
  }
  return 0;
}
