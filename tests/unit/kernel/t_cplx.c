/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Complex numbers as pairs of doubles: C11's own are the reference. */
#include "unit.h"

#include <complex.h>

/* C11 promises that its complex numbers are such pairs, too. */
static double complex c11(ph_cplx z) {
  double complex c;
  memcpy(&c, &z, sizeof c);
  return c;
}

static void ck_c11(ph_cplx found, double complex wanted, double tol) {
  double error = cabs(c11(found) - wanted);
  ck_assert_msg(error <= tol * cabs(wanted),
                "seed %lu: %.17g%+.17gi, not %.17g%+.17gi: %.3g", unit_seed(),
                found.re, found.im, creal(wanted), cimag(wanted), error);
}

PH_TEST(test_arithmetic) {
  struct unit_random r = unit_random_of(1);
  for (int i = 0; i < 2000; i++) {
    ph_cplx a = unit_random_cplx(&r, 10), b = unit_random_cplx(&r, 10);
    double s = unit_random_in(&r, -3, 3);
    ck_c11(ph_cplx_add(a, b), c11(a) + c11(b), 0);
    ck_c11(ph_cplx_sub(a, b), c11(a) - c11(b), 0);
    ck_c11(ph_cplx_mul(a, b), c11(a) * c11(b), 2 * DBL_EPSILON);
    ck_c11(ph_cplx_scale(s, a), s * c11(a), 0);
    ck_c11(ph_cplx_conj(a), conj(c11(a)), 0);
    ck_c11(ph_cplx_inverse(a), 1 / c11(a), 4 * DBL_EPSILON);
    ck_c11(ph_cplx_polar(s), cexp(c11(ph_cplx_of(0, s))), 4 * DBL_EPSILON);
    ck_rel(ph_cplx_abs(a), cabs(c11(a)), 4 * DBL_EPSILON);
    ck_rel(ph_cplx_norm2(a), creal(c11(a) * conj(c11(a))), 4 * DBL_EPSILON);
    ck_abs(ph_cplx_dot(a, b), creal(c11(a) * conj(c11(b))), 1e-13);
    ck_abs(ph_cplx_cross(a, b), cimag(conj(c11(a)) * c11(b)), 1e-13);
  }
}

/* Accurate near the negative axis, too, where small parts could cancel. */
PH_TEST(test_sqrt) {
  struct unit_random r = unit_random_of(2);
  for (int i = 0; i < 5000; i++) {
    ph_cplx a = unit_random_cplx(&r, 1), root;
    a.im *= pow(10, -(double)(i % 16));
    root = ph_cplx_sqrt(a);
    ck_c11(root, csqrt(c11(a)), 4 * DBL_EPSILON);
    ck_c11(ph_cplx_mul(root, root), c11(a), 8 * DBL_EPSILON);
    ck_rel(root.im, cimag(csqrt(c11(a))), 8 * DBL_EPSILON);
    ck_assert(root.re >= 0);
  }
}

PH_TEST(test_sqrt_axes) {
  const double v[][4] = {{0, 0, 0, 0},   {4, 0, 2, 0},      {4, -0.0, 2, -0.0},
                         {-4, 0, 0, 2},  {-4, -0.0, 0, -2}, {0, 2, 1, 1},
                         {0, -2, 1, -1}, {-0.0, 2, 1, 1},   {-3, 4, 1, 2},
                         {-3, -4, 1, -2}};
  for (size_t i = 0; i < COUNT(v); i++) {
    ph_cplx root = ph_cplx_sqrt(ph_cplx_of(v[i][0], v[i][1]));
    ck_abs(root.re, v[i][2], 0);
    ck_abs(root.im, v[i][3], 0);
    ck_assert_int_eq(signbit(root.im) != 0, signbit(v[i][3]) != 0);
  }
}

/* Its ends exactly, also where they are of very different sizes. */
PH_TEST(test_between) {
  struct unit_random r = unit_random_of(3);
  for (int i = 0; i < 2000; i++) {
    ph_cplx a = unit_random_cplx(&r, 1e20), b = unit_random_cplx(&r, 1);
    double u = unit_random_in(&r, 0, 1), size = ph_cplx_abs(a);
    double complex wanted = c11(a) + u * (c11(b) - c11(a));
    ck_c11(ph_cplx_between(a, b, 0), c11(a), 0);
    ck_c11(ph_cplx_between(a, b, 1), c11(b), 0);
    ck_abs(cabs(c11(ph_cplx_between(a, b, u)) - wanted), 0,
           4 * DBL_EPSILON * size);
  }
}

PH_TEST(test_finite) {
  ck_assert(ph_cplx_is_finite(ph_cplx_of(1, -1e308)));
  ck_assert(!ph_cplx_is_finite(ph_cplx_of(1, HUGE_VAL)));
  ck_assert(!ph_cplx_is_finite(ph_cplx_of(nan(""), 0)));
  ck_assert(!ph_cplx_is_finite(ph_cplx_inverse(ph_cplx_of(0, 0))));
}
