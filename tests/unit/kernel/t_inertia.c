/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Negative eigenvalues of band matrices, where they are known. */
#include "unit.h"

#include "kernel/inertia.h"
#include "kernel/band.h"

enum { N_MAX = 60, BAND_MAX = 7 };

static double a[N_MAX * (BAND_MAX + 1)];
static double work[(BAND_MAX + 2) * (3 * BAND_MAX + 1)];

static void clear(void) {
  memset(a, 0, sizeof a);
}

/* The second difference minus x has the eigenvalues 2 - 2 cos(k pi / (n + 1))
 * - x, k = 1, ..., n. */
PH_TEST(test_second_difference) {
  for (size_t n = 1; n <= N_MAX; n++) {
    for (double x = -0.99; x < 5; x += 0.0625) {
      size_t negative = 0;
      clear();
      for (size_t i = 0; i < n; i++) {
        double angle = acos(-1) * (double)(i + 1) / (double)(n + 1);
        negative += 2 - 2 * cos(angle) < x;
        *ph_sym_at(a, 1, i, i) = 2 - x;
        if (i + 1 < n) {
          *ph_sym_at(a, 1, i + 1, i) = -1;
        }
      }
      ck_assert_uint_eq(ph_inertia_negative(a, n, 1, work), negative);
    }
  }
}

/* L D L^T has as many as D: whatever L is, also where pivots are tiny. */
PH_TEST(test_congruence) {
  struct unit_random r = unit_random_of(910);
  int count = unit_count(2000);
  for (int c = 0; c < count; c++) {
    size_t n = 1 + unit_random_below(&r, N_MAX);
    size_t k = unit_random_below(&r, BAND_MAX + 1), negative = 0;
    double size = c % 2 ? 1 : 1e-3, l[N_MAX][BAND_MAX + 1], d[N_MAX];
    clear();
    for (size_t i = 0; i < n; i++) {
      d[i] = unit_random_in(&r, -1, 1) < 0 ? -1 : 1;
      d[i] *= pow(10, unit_random_in(&r, -3, 0));
      negative += d[i] < 0;
      l[i][0] = 1;
      for (size_t j = 1; j <= k; j++) {
        l[i][j] = size * unit_random_in(&r, -1, 1); /* (i + j, i) */
      }
    }
    for (size_t i = 0; i < n; i++) {
      for (size_t j = i; j < n && j <= i + k; j++) {
        for (size_t m = 0; m <= i; m++) {
          if (j <= m + k) {
            *ph_sym_at(a, k, j, i) += l[m][i - m] * d[m] * l[m][j - m];
          }
        }
      }
    }
    ck_assert_uint_eq(ph_inertia_negative(a, n, k, work), negative);
  }
}

/* [0 x; x 0] many times: no leading pivot is any good. */
PH_TEST(test_zero_pivots) {
  clear();
  for (size_t i = 0; i < 20; i += 2) {
    *ph_sym_at(a, 2, i + 1, i) = i % 4 ? 3 : -1e-5;
  }
  ck_assert_uint_eq(ph_inertia_negative(a, 20, 2, work), 10);
}

/* A minimum under constraints has one for each of them, however nearly they
 * depend on each other: here two that differ by 1e-9. */
PH_TEST(test_constraints) {
  const double h[3] = {1, -0.5, 2};
  clear();
  for (size_t i = 0; i < 3; i++) {
    *ph_sym_at(a, 4, i, i) = h[i];
  }
  *ph_sym_at(a, 4, 3, 0) = 1;
  *ph_sym_at(a, 4, 3, 1) = 1;
  *ph_sym_at(a, 4, 4, 0) = 1;
  *ph_sym_at(a, 4, 4, 1) = 1 + 1e-9;
  ck_assert_uint_eq(ph_inertia_negative(a, 5, 4, work), 2);
  *ph_sym_at(a, 4, 2, 2) = -2;
  ck_assert_uint_eq(ph_inertia_negative(a, 5, 4, work), 3);
}

PH_TEST(test_unchanged_and_not_finite) {
  double keep[N_MAX * (BAND_MAX + 1)];
  clear();
  for (size_t i = 0; i < 10; i++) {
    *ph_sym_at(a, 1, i, i) = 1;
    if (i + 1 < 10) {
      *ph_sym_at(a, 1, i + 1, i) = 2;
    }
  }
  memcpy(keep, a, sizeof keep);
  ph_inertia_negative(a, 10, 1, work);
  ck_assert_mem_eq(keep, a, sizeof keep);
  for (size_t i = 4; i < 6; i++) { /* on the diagonal, and below it */
    double keep_one = *ph_sym_at(a, 1, i, 4);
    *ph_sym_at(a, 1, i, 4) = (double)NAN;
    ck_assert_uint_eq(ph_inertia_negative(a, 10, 1, work), SIZE_MAX);
    *ph_sym_at(a, 1, i, 4) = keep_one;
  }
}
