/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "kernel/bern_near.h"

#include "kernel/bern.h"
#include "kernel/bern_low.h"
#include "kernel/pi.h"

#include <float.h>
#include <math.h>

/* Nodes of the series, and cosines of a whole turn of 2 NODES half steps. */
enum { NODES = 64, TURN = 4 * NODES };

/* Terms of this part of the largest value are rounding. */
static const double TAIL = 4 * DBL_EPSILON;

/* Rounding of raised coefficients, in eps of the largest that is raised, for
 * each degree of it: a term and its weight take two products each, a quotient
 * and two sums. */
static const double ROUNDING = 8;

static double largest_of(const ph_cplx *c, size_t degree) {
  double largest = 0;
  for (size_t k = 0; k <= degree; k++) {
    double size = ph_cplx_abs(c[k]);
    largest = size > largest || isnan(size) ? size : largest;
  }
  return largest;
}

/* The terms of the series; the degree where it ends. */
static size_t series(const ph_cplx *c, size_t degree, ph_cplx term[NODES]) {
  double cosine[TURN], largest;
  ph_cplx value[NODES];
  size_t end = 0;
  for (size_t i = 0; i < TURN; i++) {
    cosine[i] = cos(2 * PH_PI * (double)i / TURN);
  }
  for (size_t i = 0; i < NODES; i++) {
    value[i] = ph_bern_value(c, degree, 0.5 + 0.5 * cosine[2 * i + 1]);
  }
  largest = largest_of(value, NODES - 1);
  for (size_t k = 0; k < NODES; k++) {
    ph_cplx sum = {0, 0};
    for (size_t i = 0; i < NODES; i++) {
      double weight = cosine[k * (2 * i + 1) % TURN];
      sum = ph_cplx_add(sum, ph_cplx_scale(weight, value[i]));
    }
    term[k] = ph_cplx_scale((k > 0 ? 2.0 : 1.0) / NODES, sum);
    end = ph_cplx_abs(term[k]) <= TAIL * largest ? end : k;
  }
  return end;
}

/* Adds a T_k to a polynomial of degree k - 1: one of degree k. */
static void add_term(ph_cplx a, size_t k, ph_cplx *c) {
  double weight = k % 2 ? -1 : 1, n = (double)k;
  c[k] = ph_cplx_of(0, 0);
  for (size_t i = k; i > 0; i--) { /* elevated by one, from the end */
    c[i] = ph_cplx_between(c[i], c[i - 1], (double)i / n);
  }
  for (size_t i = 0; i <= k; i++) {
    c[i] = ph_cplx_add(c[i], ph_cplx_scale(weight, a));
    weight *= -(2 * (n - (double)i) - 1) / (double)(2 * i + 1); /* (1) */
  }
}

size_t ph_bern_near(const ph_cplx *c, size_t degree, ph_cplx *room,
                    ph_cplx *near, double *away) {
  ph_cplx term[NODES];
  size_t end;
  if (degree < PH_BERN_FAR) {
    return 0;
  }
  end = series(c, degree, term);
  if (end == 0 || end > PH_BERN_NEAR) {
    return 0;
  }
  near[0] = term[0];
  for (size_t k = 1; k <= end; k++) {
    add_term(term[k], k, near);
  }
  ph_bern_lift(near, end, degree, room);
  for (size_t k = 0; k <= degree; k++) {
    room[k] = ph_cplx_sub(room[k], c[k]);
  }
  *away = largest_of(room, degree) +
          ROUNDING * (double)end * DBL_EPSILON * largest_of(near, end);
  return end;
}
