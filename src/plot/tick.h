/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Ticks of an axis: multiples of 1, 2 or 5 times a power of ten, and their
 * labels.
 *
 * A label times 10^power, plus base, is the value: power and base are there for
 * axes whose numbers would be too long, as 4000000.25 or 0.000000125.
 */
#ifndef PH_PLOT_TICK_H
#define PH_PLOT_TICK_H

#include <stddef.h>

enum { PH_TICKS_MAX = 16, PH_TICK_LABEL_MAX = 40, PH_TICK_BASE_MAX = 48 };

struct ph_ticks {
  size_t n;
  double at[PH_TICKS_MAX];
  char label[PH_TICKS_MAX][PH_TICK_LABEL_MAX]; /* UTF-8, with a real minus */
  int power;
  char base[PH_TICK_BASE_MAX]; /* its absolute value; "": 0 */
  int base_negative;
};

/*
 * ph_ticks_make: at most `wanted` + 1 ticks in [low, high].
 *
 * in   wanted  1 .. PH_TICKS_MAX - 1
 * out  ticks   none when low < high does not hold, or when the ends have more
 *              than 15 digits in common
 */
void ph_ticks_make(double low, double high, size_t wanted,
                   struct ph_ticks *ticks);

#endif
