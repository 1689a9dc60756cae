/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Forms in two functions (see form.h). */
#include "kernel/form.h"

#include <float.h>
#include <math.h>

/* Halvings until an interval of v says nothing more: its coefficients differ by
 * less than the tolerances in use long before. */
enum { HALVINGS_MAX = 40 };

/* Steps of a search for a root, of which each at least halves the one before or
 * the interval. */
enum { STEPS_MAX = 200 };

void ph_form_multiply(const double *f, size_t f_degree, const double *g,
                      size_t g_degree, double *product) {
  for (size_t k = 0; k <= f_degree + g_degree; k++) {
    product[k] = 0;
  }
  for (size_t i = 0; i <= f_degree; i++) {
    for (size_t j = 0; j <= g_degree; j++) {
      product[i + j] += f[i] * g[j];
    }
  }
}

void ph_form_bernstein(const double *f, size_t degree, double *b) {
  double choose = 1;
  for (size_t k = 0; k <= degree; k++) {
    b[k] = f[k] / choose;
    /* A product of neighbours over k + 1: both are exact. */
    choose = choose * (double)(degree - k) / (double)(k + 1);
  }
}

void ph_form_halve(const double *b, size_t degree, double *left,
                   double *right) {
  for (size_t k = 0; k <= degree; k++) {
    right[k] = b[k];
  }
  for (size_t n = degree; n > 0; n--) {
    left[degree - n] = right[0];
    for (size_t k = 0; k < n; k++) {
      right[k] = 0.5 * (right[k] + right[k + 1]);
    }
  }
  left[degree] = right[0];
}

bool ph_form_is_mixed(const double *b, size_t degree) {
  bool plus = false, minus = false;
  for (size_t k = 0; k <= degree; k++) {
    plus = plus || b[k] > 0;
    minus = minus || b[k] < 0;
  }
  return plus && minus;
}

/* The value at v, and the derivative, by the algorithm of de Casteljau. */
static double value_at(const double *b, size_t degree, double v,
                       double *slope) {
  double c[PH_FORM_DEGREE_MAX + 1];
  for (size_t k = 0; k <= degree; k++) {
    c[k] = b[k];
  }
  for (size_t n = degree; n > 1; n--) {
    for (size_t k = 0; k < n; k++) {
      c[k] += v * (c[k + 1] - c[k]);
    }
  }
  *slope = (double)degree * (c[1] - c[0]);
  return c[0] + v * (c[1] - c[0]);
}

bool ph_form_root(const double *b, size_t degree, double *root) {
  double low = 0, high = 1, v = b[0] / (b[0] - b[degree]), move = 1;
  const bool up = b[0] < 0;
  bool finite = isfinite(b[0]);
  size_t changes = 0;
  for (size_t k = 0; k < degree; k++) {
    changes += (b[k] < 0) != (b[k + 1] < 0);
    finite = finite && isfinite(b[k + 1]);
  }
  if (!finite || changes != 1 || !(b[0] * b[degree] < 0)) {
    return false;
  }
  for (int i = 0; i < STEPS_MAX && fabs(move) > DBL_EPSILON; i++) {
    const double before = fabs(move), value = value_at(b, degree, v, &move);
    low = (value < 0) == up ? v : low;
    high = (value < 0) == up ? high : v;
    move = -value / move;
    if (!(fabs(move) <= 0.5 * before && v + move > low && v + move < high)) {
      move = 0.5 * (low + high) - v;
    }
    v += move;
  }
  *root = v;
  return true;
}

/* Whether all coefficients, times the sign, exceed zero. */
static bool exceeds(const double *b, size_t degree, double sign, double zero) {
  for (size_t k = 0; k <= degree; k++) {
    if (!(sign * b[k] > zero)) {
      return false;
    }
  }
  return true;
}

/* Whether the polynomial, times the sign, exceeds zero on all of [0,1]. */
static bool keeps(const double *b, size_t degree, double sign, double zero,
                  int depth) {
  double left[PH_FORM_DEGREE_MAX + 1], right[PH_FORM_DEGREE_MAX + 1];
  if (exceeds(b, degree, sign, zero)) {
    return true;
  }
  /* The end coefficients are values. */
  if (depth == HALVINGS_MAX || !(sign * b[0] > zero) ||
      !(sign * b[degree] > zero)) {
    return false;
  }
  ph_form_halve(b, degree, left, right);
  return keeps(left, degree, sign, zero, depth + 1) &&
         keeps(right, degree, sign, zero, depth + 1);
}

int ph_form_sign(const double *f, size_t degree, double tolerance) {
  double b[PH_FORM_DEGREE_MAX + 1], largest = 0;
  int sign = f[0] > 0 ? 1 : -1;
  ph_form_bernstein(f, degree, b);
  for (size_t k = 0; k <= degree; k++) {
    largest = fabs(b[k]) > largest ? fabs(b[k]) : largest;
  }
  return keeps(b, degree, sign, tolerance * largest, 0) ? sign : 0;
}
