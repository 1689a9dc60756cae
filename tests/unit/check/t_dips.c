/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Where |r'| of a segment falls far below its largest value: that it is so
 * where dips are told, and nowhere where none are; and r' with its derivatives.
 */
#include "unit.h"

#include "check/dips.h"
#include "check/kind.h"

enum { FINE = 1024 };

/* A segment of r' = sum of w[j] binomial(m, j) S0^(m-j) S1^j. */
static struct ph_check_segment segment_of(const ph_vec3 *w, size_t m,
                                          double angle) {
  struct ph_check_segment s = {.kind = &ph_check_kinds[PH_CURVE_PH],
                               .m = m,
                               .angle = angle,
                               .plane = true};
  double normal = 1;
  for (size_t j = 0; j <= m; j++) {
    s.h[j] = ph_vec3_scale(normal, w[j]);
    s.plane = s.plane && !(fabs(w[j].z) > 0);
    normal *= (double)(m - j) / (double)(j + 1);
  }
  return s;
}

static double speed(const struct ph_check_segment *s, double u) {
  ph_vec3 first;
  ph_check_jet(s, u, &first, 1);
  return ph_vec3_abs(first);
}

static ph_vec3 any(struct unit_random *r, bool plane) {
  double x = unit_random_in(r, -1, 1), y = unit_random_in(r, -1, 1);
  return ph_vec3_of(x, y, plane ? 0 : unit_random_in(r, -1, 1));
}

/* Random segments, of which some nearly stop: what is told is so. */
PH_TEST_EACH(test_slow, 8) {
  const bool plane = _i & 1;
  const size_t m = _i & 2 ? 2 : 4;
  const double angle = _i & 4 ? 2 : 0;
  struct unit_random r = unit_random_of((uint64_t)_i);
  size_t found = 0, none = 0;
  for (int n = 0; n < 1200; n++) {
    struct ph_check_segment s;
    struct ph_check_dips dips;
    ph_vec3 w[5], towards = any(&r, plane);
    double least = HUGE_VAL, most = 0;
    for (size_t j = 0; j <= m; j++) {
      w[j] = ph_vec3_along(any(&r, plane), n % 3, towards);
    }
    s = segment_of(w, m, angle);
    dips = ph_check_slow_of(&s);
    for (int i = 0; i <= FINE; i++) {
      double x = speed(&s, (double)i / FINE);
      least = fmin(least, x);
      most = fmax(most, x);
    }
    unit_case("segment %d, least speed %g of %g", n, least, most);
    ck_assert(sqrt(dips.low) <= least * (1 + 1e-12));
    if (least < most / 16) {
      double best = fmin(speed(&s, 0), speed(&s, 1));
      for (size_t i = 0; i < dips.n; i++) {
        best = fmin(best, speed(&s, dips.x[i]));
      }
      ck_assert(best <= sqrt(dips.low) * (1 + 1e-9));
      found++;
    }
    none += dips.n == 0;
  }
  ck_assert_uint_gt(found, 5);
  ck_assert_uint_gt(none, 50);
}

/* Derivatives against differences, in the plane and in space. */
PH_TEST_EACH(test_jet, 8) {
  const bool plane = _i & 1;
  const size_t m = _i & 2 ? 2 : 4;
  const double angle = _i & 4 ? 2 : 0, h = 1e-5;
  struct unit_random r = unit_random_of((uint64_t)_i);
  for (int n = 0; n < 50; n++) {
    struct ph_check_segment s;
    ph_vec3 w[5], jet[PH_CHECK_JET], before[PH_CHECK_JET], after[PH_CHECK_JET];
    double u = unit_random_in(&r, 0.01, 0.99);
    for (size_t j = 0; j <= m; j++) {
      w[j] = any(&r, plane);
    }
    s = segment_of(w, m, angle);
    ph_check_jet(&s, u, jet, PH_CHECK_JET);
    ph_check_jet(&s, u - h, before, PH_CHECK_JET);
    ph_check_jet(&s, u + h, after, PH_CHECK_JET);
    for (size_t d = 0; d + 1 < PH_CHECK_JET; d++) {
      ph_vec3 slope =
          ph_vec3_scale(1 / (2 * h), ph_vec3_sub(after[d], before[d]));
      unit_case("derivative %zu at %g", d + 1, u);
      ck_assert(ph_vec3_abs(ph_vec3_sub(slope, jet[d + 1])) < 1e-5);
    }
    for (size_t few = 1; few < PH_CHECK_JET; few++) { /* the same of fewer */
      ph_check_jet(&s, u, before, few);
      ck_assert_mem_eq(before, jet, few * sizeof *jet);
    }
  }
}
