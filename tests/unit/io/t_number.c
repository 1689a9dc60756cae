/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Numbers as text, compared with strtod and snprintf of the C library and with
 * decimals known exactly.  What number.c assumes about its table is proved in
 * t_number_table.c.
 *
 * PH_LONG=1 raises the random samples to 10^8 doubles (minutes).
 */
#include "unit.h"

#include "io/number.h"

#include <inttypes.h>
#include <locale.h>

#define INFINITY_BITS (UINT64_C(0x7ff) << 52)

static uint64_t to_bits(double x) {
  uint64_t bits;
  memcpy(&bits, &x, sizeof bits);
  return bits;
}

static double from_bits(uint64_t bits) {
  double x;
  memcpy(&x, &bits, sizeof x);
  return x;
}

/* splitmix64 (Steele, Lea and Flood 2014) */
static uint64_t next_random(uint64_t *state) {
  uint64_t z = *state += UINT64_C(0x9e3779b97f4a7c15);
  z = (z ^ z >> 30) * UINT64_C(0xbf58476d1ce4e5b9);
  z = (z ^ z >> 27) * UINT64_C(0x94d049bb133111eb);
  return z ^ z >> 31;
}

static double random_double(uint64_t *state) {
  for (;;) {
    double x = from_bits(next_random(state));
    if (isfinite(x)) {
      return x;
    }
  }
}

/* ---- reading -------------------------------------------------------- */

typedef const char *reader(const char *p, const char *end, double *x);

/* Reads n bytes of text in memory of exactly that size, for the sanitizers;
   returns the length of the number, 0 if there is none. */
static size_t read_exactly(reader *read, const char *text, size_t n,
                           double *x) {
  char *copy = malloc(n ? n : 1);
  if (!copy) {
    ck_abort();
  }
  memcpy(copy, text, n);
  const char *end = read(copy, copy + n, x);
  size_t length = end ? (size_t)(end - copy) : 0;
  free(copy);
  return length;
}

/* The n bytes of text are a number for both readers, namely x. */
static void check_read(const char *text, size_t n, double x) {
  reader *readers[] = {ph_number_read, ph_number_read_text};
  for (size_t i = 0; i < 2; i++) {
    double y = -1;
    size_t length = read_exactly(readers[i], text, n, &y);
    if (length != n || to_bits(x) != to_bits(y)) {
      ck_abort_msg("%.*s: read %.17g (%d bytes), not %.17g (%d)",
                   n < 900 ? (int)n : 900, text, y, (int)length, x, (int)n);
    }
  }
}

static void check_text(const char *text, double x) {
  check_read(text, strlen(text), x);
}

PH_TEST(test_known_values) {
  static const struct {
    const char *text;
    double x;
  } known[] = {{"0", 0.0},
               {"-0", -0.0},
               {"-0.0e7", -0.0},
               {"0e99999999999999999999", 0.0},
               {"1e23", 0x1.52d02c7e14af6p+76},
               {"9007199254740991", 0x1.fffffffffffffp+52},
               {"9007199254740992", 0x1p+53},
               {"9007199254740993", 0x1p+53},
               {"9007199254740993.0000000000", 0x1p+53},
               {"9007199254740993.0000000001", 0x1.0000000000001p+53},
               {"9007199254740992.9999999999", 0x1p+53},
               {"9007199254740995", 0x1.0000000000002p+53},
               {"-9007199254740995e0", -0x1.0000000000002p+53},
               {"4.9e-324", 0x1p-1074},
               {"5e-324", 0x1p-1074},
               {"2.4703282292062327e-324", 0.0},
               {"2.4703282292062328e-324", 0x1p-1074},
               {"2.2250738585072011e-308", 0x0.fffffffffffffp-1022},
               {"2.2250738585072012e-308", 0x1p-1022},
               {"1.7976931348623157e308", 0x1.fffffffffffffp+1023},
               {"1.7976931348623158e308", 0x1.fffffffffffffp+1023},
               {"1.7976931348623159e308", HUGE_VAL},
               {"-1e309", -HUGE_VAL},
               {"1e99999999999999999999", HUGE_VAL},
               {"-1e-99999999999999999999", -0.0},
               {"1.00000000000000011102230246251565404236316680908203125", 1.0},
               {"1.00000000000000011102230246251565404236316680908203126",
                0x1.0000000000001p+0},
               {"6.802601037806062e215", 0x1.f92bacb3cb40cp+716}};
  for (size_t i = 0; i < COUNT(known); i++) {
    check_text(known[i].text, known[i].x);
  }
}

static int max(int a, int b) {
  return a > b ? a : b;
}

/*
 * The middle between the doubles of bits and bits + 1, written exactly as
 * d.ddd; text has room for 900 bytes.  Returns its length and sets the decimal
 * exponent that belongs behind it.
 */
static size_t write_middle(uint64_t bits, char *text, int *exponent) {
  uint64_t hidden = UINT64_C(1) << 52;
  uint64_t m = bits < hidden ? bits : hidden | bits % hidden;
  int q = max((int)(bits / hidden), 1) - 1076;
  unsigned char digit[900] = {0}; /* the lowest first */
  size_t n = 0;
  for (uint64_t odd = 2 * m + 1; odd; odd /= 10) {
    digit[n++] = (unsigned char)(odd % 10);
  }
  for (int i = 0; i < abs(q); i++) { /* times 2^q, or times 5^-q 10^q */
    unsigned carry = 0;
    for (size_t k = 0; k < n || carry; k++) {
      carry += digit[k] * (q < 0 ? 5U : 2U);
      digit[k] = (unsigned char)(carry % 10);
      carry /= 10;
      n += k == n;
    }
  }
  *exponent = (q < 0 ? q : 0) + (int)n - 1;
  size_t to = 0, zeros = 0;
  for (; digit[zeros] == 0; zeros++) {
  }
  while (n > zeros) {
    text[to++] = (char)('0' + digit[--n]);
    if (to == 1) {
      text[to++] = '.';
    }
  }
  return to;
}

/* The middle itself, and numbers that differ from it in a far digit. */
static void check_middle(uint64_t bits, int zeros) {
  static char text[3000];
  int e;
  size_t n = write_middle(bits, text, &e);
  int tail = sprintf(text + n, "%se%d", text[n - 1] == '.' ? "0" : "", e);
  check_read(text, n + (size_t)tail, from_bits(bits + (bits & 1)));
  memset(text + n, '0', (size_t)zeros);
  sprintf(text + n + zeros, "1e%d", e);
  check_text(text, from_bits(bits + 1));
  text[n - (text[n - 1] == '.' ? 2 : 1)]--;
  memset(text + n, '9', (size_t)zeros);
  sprintf(text + n + zeros, "9e%d", e);
  check_text(text, from_bits(bits));
}

PH_TEST(test_middles) {
  const uint64_t hidden = UINT64_C(1) << 52;
  uint64_t state = 2;
  check_middle(0, 1);
  check_middle(1, 900);
  check_middle(hidden - 2, 1);
  check_middle(hidden - 1, 50);
  check_middle(hidden, 2);
  check_middle(2 * hidden - 1, 3); /* 768 digits, the most there are */
  check_middle(INFINITY_BITS - 1, 0);
  check_middle(INFINITY_BITS - 1, 2000);
  for (int i = 0; i < (unit_long() ? 100000 : unit_count(500)); i++) {
    uint64_t bits = next_random(&state) % INFINITY_BITS;
    if (i % 4 == 0) {
      bits %= hidden;
    } else if (i % 4 == 1) {
      bits = to_bits(1) + bits % (hidden * 100);
    }
    check_middle(bits, (int)(next_random(&state) % 1000));
  }
}

/* A million digits, in no more than linear time. */
PH_TEST(test_many_digits) {
  enum { ZEROS = 1000000 };
  char *text = malloc(ZEROS + 50);
  ck_assert(text != NULL);
  memset(text, '0', ZEROS + 50);
  memcpy(text, "9007199254740993.", 17);
  check_read(text, ZEROS, 9007199254740992.0);
  text[ZEROS - 1] = '1';
  check_read(text, ZEROS, 9007199254740994.0);
  memset(text, '9', ZEROS);
  text[1] = '.';
  check_read(text, ZEROS, 10.0);
  memset(text, '0', ZEROS);
  text[1] = '.';
  check_read(text, (size_t)(ZEROS + sprintf(text + ZEROS, "15e999999")), 1.5);
  text[0] = '7';
  text[1] = '0';
  check_read(text, (size_t)(ZEROS + sprintf(text + ZEROS, "e-999999")), 7.0);
  memset(text, '0', ZEROS);
  text[0] = '1';
  check_read(text, ZEROS, HUGE_VAL);
  free(text);
}

PH_TEST(test_random_digits) {
  uint64_t state = 3;
  int count = unit_long() ? 20000000 : unit_count(200000);
  for (int i = 0; i < count; i++) {
    char text[64];
    size_t n = 1 + next_random(&state) % 40;
    size_t point = 1 + next_random(&state) % n;
    size_t to = 0;
    for (size_t k = 0; k < n; k++) {
      if (k == point) {
        text[to++] = '.';
      }
      uint64_t digit = next_random(&state) % (k ? 10 : 9);
      text[to++] = (char)('0' + digit + (k == 0));
    }
    int e = (int)(next_random(&state) % 700) - 370;
    sprintf(text + to, "e%s%d", i & 1 && e >= 0 ? "+" : "", i & 2 ? e : e % 20);
    check_text(text, strtod(text, NULL));
  }
}

/* ---- grammar -------------------------------------------------------- */

PH_TEST(test_grammar) {
  static const struct {
    const char *text;
    size_t json, cell; /* length of the number; 0: none */
  } cases[] = {{"", 0, 0},          {"-", 0, 0},
               {"+", 0, 0},         {".", 0, 0},
               {"-.", 0, 0},        {"+.", 0, 0},
               {"e5", 0, 0},        {".e5", 0, 0},
               {"-e5", 0, 0},       {" 1", 0, 0},
               {"--1", 0, 0},       {"+-1", 0, 0},
               {"-+1", 0, 0},       {"nan", 0, 0},
               {"NaN", 0, 0},       {"inf", 0, 0},
               {"-Infinity", 0, 0}, {"\"1\"", 0, 0},
               {"+1", 0, 2},        {".5", 0, 2},
               {"-.5", 0, 3},       {"+.5e1", 0, 5},
               {"01", 1, 2},        {"-01", 2, 3},
               {"007.5", 1, 5},     {"00", 1, 2},
               {"5.", 1, 2},        {"-5.", 2, 3},
               {"5.e3", 1, 4},      {"5.e", 1, 2},
               {"0.", 1, 2},        {"1..5", 1, 2},
               {"1", 1, 1},         {"0", 1, 1},
               {"-0", 2, 2},        {"-7", 2, 2},
               {"0x10", 1, 1},      {"0b1", 1, 1},
               {"1_0", 1, 1},       {"1e", 1, 1},
               {"1e+", 1, 1},       {"1e-", 1, 1},
               {"1e-x", 1, 1},      {"1ee5", 1, 1},
               {"1e5", 3, 3},       {"1E5", 3, 3},
               {"1e+5", 4, 4},      {"1e-05", 5, 5},
               {"1e5.5", 3, 3},     {"1e5e6", 3, 3},
               {"0e0", 3, 3},       {"0.0", 3, 3},
               {"1.5.2", 3, 3},     {"1.5,2", 3, 3},
               {"1,5", 1, 1},       {"12]", 2, 2},
               {"12 34", 2, 2},     {"1.25}", 4, 4},
               {"1e2\n", 3, 3},     {"12345678", 8, 8},
               {"123456789", 9, 9}, {"1.12345678e9", 12, 12}};
  for (size_t i = 0; i < COUNT(cases); i++) {
    double x = 42;
    size_t n = strlen(cases[i].text);
    size_t json = read_exactly(ph_number_read, cases[i].text, n, &x);
    ck_assert_msg(json == cases[i].json, "%s: %zu", cases[i].text, json);
    ck_assert_msg(json || unit_same(x, 42), "%s", cases[i].text);
    size_t cell = read_exactly(ph_number_read_text, cases[i].text, n, &x);
    ck_assert_msg(cell == cases[i].cell, "%s: %zu", cases[i].text, cell);
    ck_assert_msg(!cell || unit_same(x, strtod(cases[i].text, NULL)) ||
                      cases[i].text[1] == 'x',
                  "%s", cases[i].text);
  }
}

/* Every byte ends a number wherever it stands; no byte beyond the end has any
   influence on what is read. */
PH_TEST(test_ends) {
  const char *digits = "1234567890123456";
  for (int c = 0; c < 256; c++) {
    for (size_t at = 1; at < 16; at++) {
      char text[17];
      double x;
      memcpy(text, digits, sizeof text);
      text[at] = (char)c;
      size_t expected = c >= '0' && c <= '9' ? 16 : at;
      if (c == '.' || ((c == 'e' || c == 'E'))) {
        expected = at < 15 ? 16 : 15;
      }
      ck_assert_uint_eq(read_exactly(ph_number_read, text, 16, &x), expected);
    }
  }
  const char *text = "-12345678901234567890.1234567890123456789012e+1234567890";
  for (size_t n = 1; n <= strlen(text); n++) {
    double x = 0, y = 0;
    size_t length = read_exactly(ph_number_read, text, n, &x);
    ck_assert_uint_le(length, n);
    ck_assert(n == 1 || length >= n - 2);
    ck_assert_uint_eq(read_exactly(ph_number_read, text, length, &y), length);
    ck_assert_uint_eq(to_bits(x), to_bits(y));
  }
}

/* ---- writing -------------------------------------------------------- */

/* Writes x in a buffer of the promised size; returns the text with a NUL. */
static size_t write_text(double x, char *text) {
  char *buffer = malloc(PH_NUMBER_MAX);
  size_t n = buffer ? ph_number_write(buffer, x) : PH_NUMBER_MAX;
  if (n >= PH_NUMBER_MAX) {
    ck_abort_msg("%.17g", x);
  }
  memcpy(text, buffer, n);
  text[n] = '\0';
  free(buffer);
  return n;
}

PH_TEST(test_form) {
  static const struct {
    double x;
    const char *text;
  } cases[] = {{0.0, "0"},
               {-0.0, "-0"},
               {1, "1"},
               {-1, "-1"},
               {10, "10"},
               {-100, "-100"},
               {123456789, "123456789"},
               {3e8, "300000000"},
               {0.5, "0.5"},
               {-12.5, "-12.5"},
               {0.30000000000000004, "0.30000000000000004"},
               {0.3333333333333333, "0.3333333333333333"},
               {9007199254740991, "9007199254740991"},
               {9007199254740994, "9007199254740994"},
               {2251799813685248.5, "2251799813685248.5"},
               {123456789012345680000.0, "123456789012345680000"},
               {1e20, "100000000000000000000"},
               {999999999999999868928.0, "999999999999999900000"},
               {1e21, "1e21"},
               {-1.5e22, "-1.5e22"},
               {1e23, "1e23"},
               {0.000001, "0.000001"},
               {-2.4691357802469135e-06, "-0.0000024691357802469135"},
               {9.5e-7, "9.5e-7"},
               {1e-7, "1e-7"},
               {1.25e-100, "1.25e-100"},
               {5e-324, "5e-324"},
               {1e-323, "1e-323"},
               {DBL_MIN, "2.2250738585072014e-308"},
               {DBL_MAX, "1.7976931348623157e308"},
               {-DBL_MAX, "-1.7976931348623157e308"},
               {0x1.f92bacb3cb40cp+716, "6.802601037806062e215"}};
  for (size_t i = 0; i < COUNT(cases); i++) {
    char text[PH_NUMBER_MAX + 1];
    write_text(cases[i].x, text);
    ck_assert_str_eq(text, cases[i].text);
  }
}

/* The significant digits of a number, and the exponent of 0.ddd 10^e. */
static int digits_of(const char *text, char *digits, int *e) {
  int n = 0, place = 0;
  bool point = false;
  *e = 0;
  for (; *text && *text != 'e'; text++) {
    point |= *text == '.';
    if (*text >= '0' && *text <= '9' && (n || *text != '0')) {
      digits[n++] = *text;
      place += !point;
    } else if (*text == '0') {
      place -= point;
    }
  }
  *e = place + (*text ? atoi(text + 1) : 0);
  for (; n && digits[n - 1] == '0'; n--) {
  }
  digits[n] = '\0';
  return n;
}

/* x > 0 is written with as few digits as possible, the nearest such. */
static void check_shortest(double x, const char *text) {
  char ours[64], theirs[64], printed[64];
  int e, f;
  int n = digits_of(text, ours, &e);
  if (n > 1) {
    snprintf(printed, sizeof printed, "%.*e", n - 2, x);
    if (to_bits(strtod(printed, NULL)) == to_bits(x)) {
      ck_abort_msg("%s is longer than %s", text, printed);
    }
  }
  snprintf(printed, sizeof printed, "%.*e", n - 1, x);
  digits_of(printed, theirs, &f);
  if (to_bits(strtod(printed, NULL)) == to_bits(x) &&
      (strcmp(ours, theirs) != 0 || e != f)) {
    ck_abort_msg("%s is not as close as %s", text, printed);
  }
}

/* Both directions for x, against the C library. */
static void check_double(double x, bool shortest) {
  char text[PH_NUMBER_MAX + 1], printed[64];
  size_t n = write_text(x, text);
  if (to_bits(strtod(text, NULL)) != to_bits(x)) {
    ck_abort_msg("%.17g was written as %s", x, text);
  }
  check_read(text, n, x);
  uint64_t size = to_bits(fabs(x)); /* x87 would compare with wide constants */
  bool plain = size >= to_bits(1e-6) && size < to_bits(1e21);
  if (plain != !strchr(text, 'e') && size != 0) {
    ck_abort_msg("form of %s", text);
  }
  int m = snprintf(printed, sizeof printed, "%.17g", x);
  check_read(printed, (size_t)m, x);
  if (shortest && size != 0) {
    check_shortest(fabs(x), text[0] == '-' ? text + 1 : text);
  }
}

static void check_neighbours(double x) {
  for (uint64_t d = 0; d < 5; d++) {
    uint64_t bits = to_bits(x) + d - 2;
    if (bits < INFINITY_BITS) {
      check_double(from_bits(bits), true);
    }
  }
}

PH_TEST(test_powers) {
  for (int e = -1074; e < 1024; e++) {
    check_neighbours(ldexp(1, e));
  }
  for (int e = -345; e <= 310; e++) {
    char text[16];
    snprintf(text, sizeof text, "1e%d", e);
    double x = strtod(text, NULL);
    check_text(text, x);
    check_neighbours(x);
  }
  for (uint64_t i = 0; i < 1000; i++) {
    check_double((double)i, true);
    check_double(from_bits(i), true);
    check_double((double)((UINT64_C(1) << 53) - 500 + i), true);
    check_double(from_bits(INFINITY_BITS - 1 - i), true);
  }
}

PH_TEST(test_random) {
  uint64_t state = 4;
  long count = unit_long() ? 100000000 : unit_count(200000);
  for (long i = 0; i < count; i++) {
    check_double(random_double(&state), i % 10 == 0);
  }
  for (long i = 0; i < count / 10; i++) { /* short decimals; x in +-2^30 */
    double small = (double)(int32_t)next_random(&state);
    check_double(small / pow(10, (double)(i % 12)), i % 10 == 0);
    check_double((double)(int64_t)next_random(&state) / 0x1p33, i % 10 == 0);
  }
}

/* ---- locale --------------------------------------------------------- */

/* Sets a locale whose decimal point is a comma, if the machine has one. */
static bool set_comma_locale(void) {
  static const char *const names[] = {"de_DE.UTF-8", "de_DE.utf8",  "de_DE",
                                      "fr_FR.UTF-8", "fr_FR.utf8",  "fr_FR",
                                      "it_IT.UTF-8", "es_ES.UTF-8", "nl_NL"};
  for (size_t i = 0; i < COUNT(names); i++) {
    if (setlocale(LC_ALL, names[i]) && *localeconv()->decimal_point == ',') {
      return true;
    }
  }
  return false;
}

PH_TEST(test_locale) {
  static char middle[900];
  int e;
  size_t n = write_middle(to_bits(0.1), middle, &e);
  sprintf(middle + n, "e%d", e);
  if (set_comma_locale()) {
    char text[PH_NUMBER_MAX + 1];
    write_text(-1234.5, text);
    ck_assert_str_eq(text, "-1234.5");
    check_text("-1234.5", -1234.5);
    check_text("9007199254740993.0000000000000000000000001", 0x1p53 + 2);
    check_text(middle, 0.1);
    double x = 0;
    ck_assert_uint_eq(read_exactly(ph_number_read_text, "1,5", 3, &x), 1);
    setlocale(LC_ALL, "C");
  }
  check_text(middle, 0.1); /* the locale "C" gives the same */
}
