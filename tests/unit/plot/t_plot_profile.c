/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Ranges of profiles: of ordinary ones, of straight lines and circles, and
 * where some values are very large or are none. */
#include "unit.h"

#include "plot/profile.h"

enum { N = 1001 };

static double s[N], values[N];
static struct ph_profile profile;
static struct ph_drawing drawing;
static struct ph_range range;

/* A curve of length 10; the range of its values. */
static struct ph_range range_of(void) {
  const struct ph_drawing *d = &drawing;
  struct ph_arena scratch = {0};
  struct ph_diag diag;
  profile = (struct ph_profile){N, s, values, values};
  drawing.profiles = &profile;
  drawing.segments_n = 1;
  ck_assert_int_eq(ph_profile_range(&d, 1, PH_PROFILE_CURVATURE, 10, &scratch,
                                    &range, &diag),
                   PH_OK);
  ck_assert(range.low < range.high && isfinite(range.high - range.low));
  ph_arena_free(&scratch);
  return range;
}

static void set_up(void) {
  for (int i = 0; i < N; i++) {
    s[i] = 10.0 * i / (N - 1);
  }
}

PH_TEST(ordinary) {
  for (int i = 0; i < N; i++) {
    values[i] = sin(s[i]);
  }
  range_of();
  ck_assert(range.any);
  ck_assert(range.low < -1 && range.low > -1.3);
  ck_assert(range.high > 1 && range.high < 1.3);
}

/* From 0, unless that is far below. */
PH_TEST(origin) {
  for (int i = 0; i < N; i++) {
    values[i] = 1 + s[i];
  }
  range_of();
  ck_assert(range.low < 0 && range.low > -1);
  for (int i = 0; i < N; i++) {
    values[i] = -1 - s[i];
  }
  range_of();
  ck_assert(range.high > 0 && range.high < 1);
  for (int i = 0; i < N; i++) {
    values[i] = 1000 + s[i];
  }
  range_of();
  ck_assert(range.low > 990);
}

/* Rounding is not drawn. */
PH_TEST(constant) {
  for (int i = 0; i < N; i++) {
    values[i] = 1e-15 * (i % 7);
  }
  range_of();
  ck_assert(range.low < -0.05 && range.high > 0.05);
  for (int i = 0; i < N; i++) {
    values[i] = 3 * (1 + 1e-12 * (i % 7));
  }
  range_of();
  ck_assert(range.low < 0 && range.high > 4);
  for (int i = 0; i < N; i++) {
    values[i] = -3;
  }
  range_of();
  ck_assert(range.low < -4 && range.high > 0);
}

/* A cusp, of infinite curvature, leaves the rest to be seen; a peak that is not
 * much higher than the rest is shown as it is. */
PH_TEST(peaks) {
  for (int i = 0; i < N; i++) {
    values[i] = sin(s[i]) + 0.1 / fabs(s[i] - 5);
  }
  ck_assert(isinf(values[N / 2]));
  range_of();
  ck_assert(range.low < -0.9 && range.high > 1.5 && range.high < 20);
  for (int i = 0; i < N; i++) {
    values[i] = sin(s[i]) + (i == 700 ? 3 : 0);
  }
  range_of();
  ck_assert(range.high > 3);
}

/* The same, whether many samples or few are near the peak. */
PH_TEST(weights) {
  double high;
  for (int i = 0; i < N; i++) {
    values[i] = 1 / (0.001 + fabs(s[i] - 5));
  }
  high = range_of().high;
  for (int i = 0; i < N; i++) { /* dense near 5 */
    double x = 2.0 * i / (N - 1) - 1;
    s[i] = 5 + 5 * x * x * x;
    values[i] = 1 / (0.001 + fabs(s[i] - 5));
  }
  ck_rel(range_of().high, high, 0.1);
}

PH_TEST(none) {
  for (int i = 0; i < N; i++) {
    values[i] = (double)NAN;
  }
  ck_assert(!range_of().any);
  values[3] = (double)INFINITY;
  ck_assert(!range_of().any);
  values[5] = 1e308;
  values[6] = -1e308;
  ck_assert(range_of().any);
}

PH_FIXTURE(set_up, NULL)
