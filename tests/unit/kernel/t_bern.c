/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Bernstein form: the basis by its definition, and the two parts. */
#include "unit.h"

#include "kernel/bern.h"

#include <gsl/gsl_sf_gamma.h>

enum { DEGREE_MAX = 12 };

/* binomial(n, k) (1-u)^(n-k) u^k */
static double basis_by_definition(unsigned n, unsigned k, double u) {
  return gsl_sf_choose(n, k) * pow(1 - u, (double)(n - k)) * pow(u, (double)k);
}

PH_TEST(test_basis) {
  struct unit_random r = unit_random_of(1);
  double basis[DEGREE_MAX + 1];
  for (unsigned n = 0; n <= DEGREE_MAX; n++) {
    for (int i = 0; i < 200; i++) {
      double u = unit_random_in(&r, 0, 1), sum = 0;
      ph_bern_basis(n, u, basis);
      for (unsigned k = 0; k <= n; k++) {
        ck_rel(basis[k], basis_by_definition(n, k, u), 64 * DBL_EPSILON);
        sum += basis[k];
      }
      ck_rel(sum, 1.0, 16 * DBL_EPSILON);
    }
  }
}

PH_TEST(test_basis_ends) {
  double basis[DEGREE_MAX + 1];
  for (size_t n = 0; n <= DEGREE_MAX; n++) {
    for (int end = 0; end < 2; end++) {
      ph_bern_basis(n, end, basis);
      for (size_t k = 0; k <= n; k++) {
        ck_abs(basis[k], k == (end ? n : 0) ? 1.0 : 0.0, 0);
      }
    }
  }
}

static ph_cplx value(const ph_cplx *c, size_t degree, double u) {
  double basis[DEGREE_MAX + 1];
  ph_cplx sum = {0, 0};
  ph_bern_basis(degree, u, basis);
  for (size_t k = 0; k <= degree; k++) {
    sum = ph_cplx_add(sum, ph_cplx_scale(basis[k], c[k]));
  }
  return sum;
}

PH_TEST(test_cut) {
  struct unit_random r = unit_random_of(2);
  ph_cplx c[DEGREE_MAX + 1], left[DEGREE_MAX + 1], right[DEGREE_MAX + 1];
  for (size_t n = 0; n <= DEGREE_MAX; n++) {
    for (int i = 0; i < 100; i++) {
      double at;
      for (size_t k = 0; k <= n; k++) {
        c[k] = unit_random_cplx(&r, 1);
      }
      at = i % 2 ? unit_random_in(&r, 0, 1) : 0.5;
      ph_bern_cut(c, n, at, left, right);
      for (int j = 0; j < 5; j++) {
        double u = unit_random_in(&r, 0, 1);
        ph_cplx a = value(left, n, u), b = value(right, n, u);
        ck_assert_double_le(unit_distance(a, value(c, n, at * u)), 4e-15);
        ck_assert_double_le(unit_distance(b, value(c, n, at + (1 - at) * u)),
                            4e-15);
      }
    }
  }
}

/* The ends are kept, and the parts join, to the last digit. */
PH_TEST(test_cut_ends) {
  struct unit_random r = unit_random_of(3);
  ph_cplx c[DEGREE_MAX + 1], left[DEGREE_MAX + 1], right[DEGREE_MAX + 1];
  for (size_t n = 0; n <= DEGREE_MAX; n++) {
    for (size_t k = 0; k <= n; k++) {
      c[k] = unit_random_cplx(&r, 1);
    }
    ph_bern_cut(c, n, unit_random_in(&r, 0, 1), left, right);
    ck_abs(unit_distance(left[0], c[0]), 0, 0);
    ck_abs(unit_distance(right[n], c[n]), 0, 0);
    ck_abs(unit_distance(left[n], right[0]), 0, 0);
  }
}

/* From every degree to every other, and the largest. */
PH_TEST(test_lift) {
  struct unit_random r = unit_random_of(4);
  static ph_cplx raised[501];
  ph_cplx c[DEGREE_MAX + 1];
  for (size_t n = 0; n <= 9; n++) {
    for (size_t k = 0; k <= n; k++) {
      c[k] = unit_random_cplx(&r, 1);
    }
    for (size_t to = n; to <= DEGREE_MAX; to++) {
      double u = unit_random_in(&r, 0, 1);
      ph_bern_lift(c, n, to, raised);
      ck_abs(unit_distance(raised[0], c[0]), 0, 0);
      ck_abs(unit_distance(raised[to], c[n]), 0, 0);
      ck_assert_double_le(unit_distance(value(raised, to, u), value(c, n, u)),
                          4e-15);
    }
    ph_bern_lift(c, n, 500, raised);
    for (size_t k = 0; k <= 500; k++) {
      double u = (double)k / 500; /* the coefficients are O(1/degree) away */
      ck_assert_double_le(unit_distance(raised[k], value(c, n, u)),
                          (double)(n * n) / 500);
    }
  }
}
