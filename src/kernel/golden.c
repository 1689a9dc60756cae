/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Golden section (see golden.h). */
#include "kernel/golden.h"

#include <stdbool.h>

void ph_golden(double (*f)(const void *context, double x), const void *context,
               int steps, struct ph_bracket *b) {
  const double part = 0.3819660112501051; /* (3 - sqrt 5)/2 */
  for (int i = 0; i < steps; i++) {
    bool up = b->high - b->x > b->x - b->low;
    double x = b->x + part * (up ? b->high - b->x : b->low - b->x);
    double value = f(context, x);
    if (value < b->value) {
      *(up ? &b->low : &b->high) = b->x;
      b->x = x;
      b->value = value;
    } else {
      *(up ? &b->high : &b->low) = x;
    }
  }
}
