/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Ticks: known axes, and what must hold of any. */
#include "unit.h"

#include "plot/tick.h"

static struct ph_ticks ticks;

/* All labels, with commas between. */
static const char *all(double low, double high, size_t wanted) {
  static char text[PH_TICKS_MAX * PH_TICK_LABEL_MAX];
  text[0] = '\0';
  ph_ticks_make(low, high, wanted, &ticks);
  for (size_t i = 0; i < ticks.n; i++) {
    strcat(text, i ? "," : "");
    strcat(text, ticks.label[i]);
  }
  return text;
}

#define MINUS "\xE2\x88\x92"

PH_TEST(plain) {
  ck_assert_str_eq(all(0, 1, 5), "0,0.2,0.4,0.6,0.8,1.0");
  ck_assert_str_eq(all(-0.1, 10.1, 6), "0,2,4,6,8,10");
  ck_assert_str_eq(all(-1, 1, 4), MINUS "1.0," MINUS "0.5,0,0.5,1.0");
  ck_assert_str_eq(all(-7.5e4, 2.6e4, 3), MINUS "50000,0");
  ck_assert_str_eq(all(0.0011, 0.0038, 3), "0.002,0.003");
  ck_assert_str_eq(all(100, 1100, 2), "500,1000");
  ck_assert_int_eq(ticks.power, 0);
  ck_assert_str_eq(ticks.base, "");
}

PH_TEST(powers) {
  ck_assert_str_eq(all(0, 2.1e-9, 4), "0,1,2");
  ck_assert_int_eq(ticks.power, -9);
  ck_assert_str_eq(all(-1e12, 2e12, 6),
                   MINUS "1.0," MINUS "0.5,0,0.5,1.0,1.5,2.0");
  ck_assert_int_eq(ticks.power, 12);
  ck_assert_str_eq(all(-1e300, 1.1e300, 3), MINUS "1,0,1");
  ck_assert_int_eq(ticks.power, 300);
  ck_assert_str_eq(all(0, 2.5e-310, 3), "0,1,2");
  ck_assert_int_eq(ticks.power, -310);
}

PH_TEST(bases) {
  ck_assert_str_eq(all(4e6 - 1, 4e6 + 1, 4),
                   MINUS "1.0," MINUS "0.5,0,0.5,1.0");
  ck_assert_str_eq(ticks.base, "4000000");
  ck_assert(!ticks.base_negative);
  ck_assert_str_eq(all(-1e9, -1e9 + 3, 3), "0,1,2,3");
  ck_assert_str_eq(ticks.base, "1000000000");
  ck_assert(ticks.base_negative);
  ck_assert_str_eq(all(1.0000001, 1.0000004, 3), "1,2,3,4");
  ck_assert_str_eq(ticks.base, "1");
  ck_assert_int_eq(ticks.power, -7);
  ck_assert_str_eq(all(123456.1, 123456.4, 3), "0.1,0.2,0.3,0.4");
  ck_assert_str_eq(ticks.base, "123456");
}

PH_TEST(none) {
  all(1, 1, 5);
  ck_assert_uint_eq(ticks.n, 0);
  all(2, 1, 5);
  ck_assert_uint_eq(ticks.n, 0);
  all((double)NAN, 1, 5);
  ck_assert_uint_eq(ticks.n, 0);
  all(0, (double)INFINITY, 5);
  ck_assert_uint_eq(ticks.n, 0);
  all(1, nextafter(1, 2), 5); /* more digits than there are */
  ck_assert_uint_eq(ticks.n, 0);
}

/* The number that a label stands for. */
static double read(const char *label) {
  bool minus = strncmp(label, MINUS, 3) == 0;
  double x = strtod(minus ? label + 3 : label, NULL) * pow(10, ticks.power);
  double base = strtod(ticks.base, NULL);
  return (minus ? -x : x) + (ticks.base_negative ? -base : base);
}

PH_TEST(any) {
  struct unit_random random = unit_random_of(81);
  for (int i = unit_count(5000); i-- > 0;) {
    double size = pow(10, unit_random_in(&random, -12, 12));
    double width = size * pow(10, unit_random_in(&random, -9, 0));
    double low = size * unit_random_in(&random, -1, 1), high = low + width;
    size_t wanted = 1 + unit_random_below(&random, 8);
    ph_ticks_make(low, high, wanted, &ticks);
    ck_assert_uint_le(ticks.n, wanted + 1);
    ck_assert(wanted < 3 || ticks.n > 0);
    for (size_t k = 0; k < ticks.n; k++) {
      double slack = 1e-5 * width + 1e-15 * size;
      ck_assert(ticks.at[k] >= low - slack && ticks.at[k] <= high + slack);
      ck_abs(read(ticks.label[k]), ticks.at[k], slack);
      ck_assert_uint_le(strlen(ticks.label[k]), 12);
      ck_assert(k == 0 || strcmp(ticks.label[k], ticks.label[k - 1]) != 0);
    }
  }
}
