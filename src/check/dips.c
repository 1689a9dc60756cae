/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Dips of functions of a segment (see dips.h). */
#include "check/dips.h"

#include "kernel/golden.h"

/* Places among which dips are searched, and steps that find one. */
enum { PLACES = 32, STEPS = 40 };

struct ph_check_dips ph_check_dips_of(double (*f)(const void *, double),
                                      const void *of) {
  struct ph_check_dips dips = {.low = HUGE_VAL};
  double g[PLACES + 1];
  for (size_t i = 0; i <= PLACES; i++) {
    g[i] = f(of, (double)i / PLACES);
    dips.high = ph_check_larger(dips.high, g[i]);
    dips.low = ph_check_smaller(dips.low, g[i]);
  }
  for (size_t i = 0; i <= PLACES && dips.n < PH_CHECK_DIPS; i++) {
    size_t before = i > 0 ? i - 1 : 0, after = i < PLACES ? i + 1 : PLACES;
    if ((i == 0 || g[i] < g[before]) && (i == PLACES || g[i] <= g[after])) {
      struct ph_bracket b = {(double)before / PLACES, (double)i / PLACES,
                             (double)after / PLACES, g[i]};
      ph_golden(f, of, STEPS, &b);
      dips.low = ph_check_smaller(dips.low, b.value);
      if (b.x > 0 && b.x < 1) {
        dips.x[dips.n++] = b.x;
      }
    }
  }
  return dips;
}

/* |r'|^2 */
static double square_speed(const void *s, double u) {
  ph_vec3 jet[1];
  ph_check_jet(s, u, jet, 1);
  return ph_vec3_dot(jet[0], jet[0]);
}

/* Where |r'| is nowhere below this part of its bound, a dip is not felt. */
static const double SLOW = 0.25;

/* How often a segment is halved to see this. */
enum { HALVINGS = 4 };

/* Whether the curve of control points w[m + 1] is as far as `least` from 0: all
 * of a part of it are on one side of a line, or plane, at that distance. */
static bool is_far(const ph_vec3 *w, size_t m, double least, int depth) {
  ph_vec3 half[2][PH_CHECK_FORM_MAX], mean = w[0];
  double low = HUGE_VAL;
  for (size_t j = 1; j <= m; j++) {
    mean = ph_vec3_add(mean, w[j]);
  }
  for (size_t j = 0; j <= m; j++) {
    low = ph_check_smaller(low, ph_vec3_dot(mean, w[j]));
  }
  if (low > least * ph_vec3_abs(mean) || depth == HALVINGS) {
    return low > least * ph_vec3_abs(mean);
  }
  for (size_t j = 0; j <= m; j++) { /* de Casteljau's algorithm */
    half[1][j] = w[j];
  }
  for (size_t i = 0; i <= m; i++) {
    half[0][i] = half[1][0];
    for (size_t j = 0; j + i < m; j++) {
      half[1][j] = ph_vec3_scale(0.5, ph_vec3_add(half[1][j], half[1][j + 1]));
    }
  }
  return is_far(half[0], m, least, depth + 1) &&
         is_far(half[1], m, least, depth + 1);
}

struct ph_check_dips ph_check_slow_of(const struct ph_check_segment *s) {
  double normal = 1, high = 0, least;
  ph_vec3 w[PH_CHECK_FORM_MAX] = {{0, 0, 0}};
  for (size_t j = 0; j <= s->m && s->m > 0; j++) {
    w[j] = ph_vec3_scale(1 / normal, s->h[j]);
    high = ph_check_larger(high, ph_vec3_abs(w[j]));
    normal *= (double)(s->m - j) / (double)(j + 1);
  }
  least = SLOW * high;
  if (s->m > 0 && is_far(w, s->m, least, s->angle > 0 ? HALVINGS : 0)) {
    return (struct ph_check_dips){.low = least * least};
  }
  return ph_check_dips_of(square_speed, s);
}
