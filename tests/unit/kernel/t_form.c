/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Forms in S0 and S1: products, coefficients, halves, signs. */
#include "kernel/form.h"

#include "kernel/atph.h"
#include "kernel/bern.h"
#include "unit.h"

enum { FORMS = 300, POINTS = 20, DEGREE = 8 };

/* The tolerance of the callers. */
static const double ZERO = 1e-14;

static void random_form(struct unit_random *r, size_t degree, double *f) {
  for (size_t k = 0; k <= degree; k++) {
    f[k] = unit_random_in(r, -1, 1);
  }
}

/* The form (1) of form.h where S0, S1 are s[0], s[1]. */
static double value_at(const double *f, size_t degree, const double s[2]) {
  double value = 0;
  for (size_t k = 0; k <= degree; k++) {
    value += f[k] * pow(s[0], (double)(degree - k)) * pow(s[1], (double)k);
  }
  return value;
}

static double bernstein_at(const double *b, size_t degree, double v) {
  double basis[DEGREE + 1], value = 0;
  ph_bern_basis(degree, v, basis);
  for (size_t k = 0; k <= degree; k++) {
    value += b[k] * basis[k];
  }
  return value;
}

PH_TEST(test_multiply) {
  struct unit_random r = unit_random_of(520);
  for (size_t n = 0; n < FORMS; n++) {
    size_t df = unit_random_below(&r, 5), dg = unit_random_below(&r, 5);
    double f[5], g[5], product[DEGREE + 1];
    random_form(&r, df, f);
    random_form(&r, dg, g);
    ph_form_multiply(f, df, g, dg, product);
    for (size_t i = 0; i <= POINTS; i++) {
      double t = (double)i / POINTS, s[2] = {1 - t, 2 * t};
      ck_abs(value_at(product, df + dg, s),
             value_at(f, df, s) * value_at(g, dg, s), 1e-13 * pow(2, 8));
    }
  }
}

/* A form is (S0 + S1)^n times its Bernstein polynomial in S1 / (S0 + S1). */
PH_TEST(test_bernstein) {
  struct unit_random r = unit_random_of(521);
  for (size_t n = 0; n < FORMS; n++) {
    struct ph_atph space = ph_atph_of(unit_random_in(&r, 0, 3));
    size_t degree = unit_random_below(&r, DEGREE + 1);
    double f[DEGREE + 1], b[DEGREE + 1];
    random_form(&r, degree, f);
    ph_form_bernstein(f, degree, b);
    for (size_t i = 0; i <= POINTS; i++) {
      double s[2], scale;
      ph_atph_basis(&space, (double)i / POINTS, s);
      scale = pow(s[0] + s[1], (double)degree);
      ck_abs(scale * bernstein_at(b, degree, s[1] / (s[0] + s[1])),
             value_at(f, degree, s), 1e-13 * scale);
    }
    ph_form_bernstein(f, degree, f);
    for (size_t k = 0; k <= degree; k++) {
      ck_rel(f[k], b[k], 0);
    }
  }
}

PH_TEST(test_halve) {
  struct unit_random r = unit_random_of(522);
  for (size_t n = 0; n < FORMS; n++) {
    size_t degree = unit_random_below(&r, DEGREE + 1);
    double b[DEGREE + 1], left[DEGREE + 1], right[DEGREE + 1];
    random_form(&r, degree, b);
    ph_form_halve(b, degree, left, right);
    for (size_t i = 0; i <= POINTS; i++) {
      double v = (double)i / POINTS;
      ck_abs(bernstein_at(left, degree, v), bernstein_at(b, degree, v / 2),
             1e-14);
      ck_abs(bernstein_at(right, degree, v),
             bernstein_at(b, degree, (1 + v) / 2), 1e-14);
    }
  }
}

PH_TEST(test_mixed) {
  const double plus[3] = {0, 1, 2}, minus[3] = {-1, 0, -2},
               both[3] = {1, 0, -1};
  const double none[3] = {0, 0, 0};
  ck_assert(!ph_form_is_mixed(plus, 2));
  ck_assert(!ph_form_is_mixed(minus, 2));
  ck_assert(!ph_form_is_mixed(none, 2));
  ck_assert(ph_form_is_mixed(both, 2));
  ck_assert(!ph_form_is_mixed(both, 1));
}

/* Signs of random forms, made nearly one-signed so that all three occur, agree
 * with the extrema over many points where these leave no doubt. */
PH_TEST(test_sign) {
  enum { STEPS = 2000 };
  struct unit_random r = unit_random_of(523);
  size_t seen[3] = {0, 0, 0}, mixed = 0;
  for (size_t n = 0; n < FORMS; n++) {
    double f[DEGREE + 1], b[DEGREE + 1], low = HUGE_VAL, high = -HUGE_VAL;
    size_t degree = 1 + unit_random_below(&r, DEGREE);
    double shift = unit_random_in(&r, -1, 1);
    int sign;
    random_form(&r, degree, b);
    for (size_t k = 0; k <= degree; k++) {
      f[k] = b[k] += shift;
    }
    for (size_t k = 0; k <= degree; k++) {
      double choose = 1;
      for (size_t i = 0; i < k; i++) {
        choose *= (double)(degree - i) / (double)(i + 1);
      }
      f[k] *= choose;
    }
    for (size_t i = 0; i <= STEPS; i++) {
      double value = bernstein_at(b, degree, (double)i / STEPS);
      low = fmin(low, value);
      high = fmax(high, value);
    }
    sign = ph_form_sign(f, degree, ZERO);
    seen[sign + 1]++;
    mixed += sign != 0 && ph_form_is_mixed(b, degree);
    if (low > 1e-4 || high < -1e-4) {
      ck_assert_int_eq(sign, low > 0 ? 1 : -1);
    } else if (low < 0 && high > 0) {
      ck_assert_int_eq(sign, 0);
    }
  }
  ck_assert_uint_ge(seen[0], FORMS / 10);
  ck_assert_uint_ge(seen[1], FORMS / 10);
  ck_assert_uint_ge(seen[2], FORMS / 10);
  ck_assert_uint_ge(mixed, FORMS / 10); /* halving was needed */
}

/* ((2 v - 1) (3 v - 1))^2 + lift has two minima, each of them lift. */
static int lifted(double lift, double sign) {
  const double p[3] = {1, -3, 2}, one[3] = {1, 2, 1};
  double f[5], raised[5];
  ph_form_multiply(p, 2, p, 2, f);
  ph_form_multiply(one, 2, one, 2, raised);
  for (size_t k = 0; k < 5; k++) {
    f[k] = sign * (f[k] + lift * raised[k]);
  }
  return ph_form_sign(f, 4, ZERO);
}

PH_TEST(test_touching) {
  for (double lift = 1; lift > 2e-13; lift /= 2) {
    ck_assert_int_eq(lifted(lift, 1), 1);
    ck_assert_int_eq(lifted(lift, -1), -1);
    ck_assert_int_eq(lifted(-lift, 1), 0);
    ck_assert_int_eq(lifted(-lift, -1), 0);
  }
  ck_assert_int_eq(lifted(0, 1), 0);
  ck_assert_int_eq(lifted(0, -1), 0);
}

PH_TEST(test_ends) {
  const double zero_first[3] = {0, 1, 1}, zero_last[3] = {-1, -1, 0};
  const double zero[3] = {0, 0, 0}, small[2] = {1, 1e-15};
  const double enough[2] = {-1, -2e-14}, nothing[3] = {1, (double)NAN, 1};
  const double infinite[3] = {1, HUGE_VAL, 1}, constant[1] = {-3};
  ck_assert_int_eq(ph_form_sign(zero_first, 2, ZERO), 0);
  ck_assert_int_eq(ph_form_sign(zero_last, 2, ZERO), 0);
  ck_assert_int_eq(ph_form_sign(zero, 2, ZERO), 0);
  ck_assert_int_eq(ph_form_sign(small, 1, ZERO), 0);
  ck_assert_int_eq(ph_form_sign(enough, 1, ZERO), -1);
  ck_assert_int_eq(ph_form_sign(nothing, 2, ZERO), 0);
  ck_assert_int_eq(ph_form_sign(infinite, 2, ZERO), 0);
  ck_assert_int_eq(ph_form_sign(constant, 0, ZERO), -1);
}

/* One change of sign has a root; none, two, ends at 0, no numbers have not. */
PH_TEST(test_root) {
  const double line[2] = {-1, 3}, triple[4] = {-1, 1, -1, 1};
  const double cube[4] = {1, 0.5, 0.25, -1}, twice[3] = {1, -1, 1};
  const double first[3] = {0, -1, 1}, last[3] = {-1, -1, 0};
  const double none[3] = {1, 2, 1}, constant[1] = {-3};
  const double nan_end[3] = {-1, 1, (double)NAN};
  const double nan_inside[3] = {-1, (double)NAN, 1};
  const double infinite[3] = {-HUGE_VAL, 1, 1}, far_end[2] = {-1e-12, 1};
  double root = -1;
  ck_assert(!ph_form_root(twice, 2, &root) && !ph_form_root(none, 2, &root));
  ck_assert(!ph_form_root(first, 2, &root) && !ph_form_root(last, 2, &root));
  ck_assert(!ph_form_root(constant, 0, &root));
  ck_assert(!ph_form_root(triple, 3, &root));
  ck_assert(!ph_form_root(nan_end, 2, &root));
  ck_assert(!ph_form_root(nan_inside, 2, &root));
  ck_assert(!ph_form_root(infinite, 2, &root));
  ck_abs(root, -1, 0);
  ck_assert(ph_form_root(line, 1, &root));
  ck_abs(root, 0.25, 1e-15);
  ck_assert(ph_form_root(far_end, 1, &root));
  ck_abs(root, 1e-12, 1e-15);
  ck_assert(ph_form_root(cube, 3, &root));
  ck_abs(bernstein_at(cube, 3, root), 0, 1e-14);
}
