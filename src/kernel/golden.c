/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Golden section (see golden.h). */
#include "kernel/golden.h"

#include <math.h>
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

/* ---- peaks --------------------------------------------------------------- */

/* What may lie above the greatest value that was seen; and steps for 1e-8. */
static const double NEARLY = 0.8;
enum { STEPS = 24 };

struct function {
  double (*f)(const void *context, double x);
  const void *context;
};

static double negative(const void *context, double x) {
  const struct function *of = context;
  return -of->f(of->context, x);
}

/* NaN stays. */
static double greater(double a, double b) {
  return isnan(a) || b <= a ? a : b;
}

double ph_golden_greatest(double (*f)(const void *context, double x),
                          const void *context, size_t n, double seen) {
  const struct function of = {f, context};
  double before = -HUGE_VAL, here = f(context, 0), low = 0, x = 0;
  seen = greater(seen, here);
  for (size_t i = 1; i <= n + 1; i++) {
    const double high = i <= n ? (double)i / (double)n : 1;
    const double after = i <= n ? f(context, high) : -HUGE_VAL;
    seen = greater(seen, after);
    if (here >= before && here >= after && here > NEARLY * seen) {
      struct ph_bracket b = {low, x, high, -here};
      ph_golden(negative, &of, STEPS, &b);
      seen = greater(seen, -b.value);
    }
    low = x;
    x = high;
    before = here;
    here = after;
  }
  return seen;
}
