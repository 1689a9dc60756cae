/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Dips of functions of a segment (see dips.h). */
#include "check/dips.h"

#include "kernel/golden.h"

/* Places among which dips are searched, and steps that find one. */
enum { PLACES = 32, STEPS = 40 };

struct ph_check_dips ph_check_dips_of(double (*f)(const void *, double),
                                      const struct ph_check_segment *s) {
  struct ph_check_dips dips = {.low = HUGE_VAL};
  double g[PLACES + 1];
  for (size_t i = 0; i <= PLACES; i++) {
    g[i] = f(s, (double)i / PLACES);
    dips.high = ph_check_larger(dips.high, g[i]);
    dips.low = ph_check_smaller(dips.low, g[i]);
  }
  for (size_t i = 0; i <= PLACES && dips.n < PH_CHECK_DIPS; i++) {
    size_t before = i > 0 ? i - 1 : 0, after = i < PLACES ? i + 1 : PLACES;
    if ((i == 0 || g[i] < g[before]) && (i == PLACES || g[i] <= g[after])) {
      struct ph_bracket b = {(double)before / PLACES, (double)i / PLACES,
                             (double)after / PLACES, g[i]};
      ph_golden(f, s, STEPS, &b);
      dips.low = ph_check_smaller(dips.low, b.value);
      if (b.x > 0 && b.x < 1) {
        dips.x[dips.n++] = b.x;
      }
    }
  }
  return dips;
}

double ph_check_square_speed(const void *s, double u) {
  ph_vec3 jet[1];
  ph_check_jet(s, u, jet, 1);
  return ph_vec3_dot(jet[0], jet[0]);
}
