/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Inflections of a Bezier curve: the sign changes of C' x C'', a polynomial of
 * degree 2 degree - 3, by halving its Bernstein form, which has no more roots
 * than sign changes of its coefficients.
 */
#include "kernel/bern.h"
#include "solve/tc/approx_part.h"

#include <float.h>
#include <math.h>

/* Dyadic intervals of width 2^-DEPTH, and as many intervals as are looked at:
 * enough for every simple root; double ones need not be found. */
enum { DEPTH = 31, VISITS = 100 };

struct search {
  size_t degree;
  double noise;  /* coefficients up to this size have no sign */
  ph_cplx *pool; /* [2 DEPTH + 3][degree + 1], values in re */
  double *u;
  size_t n, room;
  size_t visits;
};

/* binomial(n, i), i <= n, all positive; n is so small that they are finite. */
static void binomials(size_t n, double *b) {
  b[0] = 1;
  for (size_t i = 1; i <= n; i++) {
    b[i] = b[i - 1] * (double)(n - i + 1) / (double)i;
  }
}

/* The coefficients of C' x C'' over some positive number. */
static void curvature_form(const struct ph_tc_bezier *curve, double *binomial,
                           struct search *s) {
  size_t n = curve->degree;
  double *b1 = binomial, *b2 = b1 + n, *b = b2 + n, size = 0;
  const ph_cplx *p = curve->p;
  binomials(n - 1, b1);
  binomials(n - 2, b2);
  binomials(2 * n - 3, b);
  for (size_t k = 0; k <= 2 * n - 3; k++) {
    s->pool[k] = ph_cplx_of(0, 0);
  }
  for (size_t i = 0; i < n; i++) {
    ph_cplx d = ph_cplx_sub(p[i + 1], p[i]);
    double length = ph_cplx_abs(d);
    size = length > size ? length : size;
    for (size_t j = 0; j + 1 < n; j++) {
      ph_cplx dd = ph_cplx_add(ph_cplx_sub(p[j + 2], p[j + 1]),
                               ph_cplx_sub(p[j], p[j + 1]));
      s->pool[i + j].re += b1[i] / b[i + j] * b2[j] * ph_cplx_cross(d, dd);
    }
  }
  s->degree = 2 * n - 3;
  s->noise = 64 * (double)n * DBL_EPSILON * size * size;
}

static int sign_of(const struct search *s, ph_cplx c) {
  return c.re > s->noise ? 1 : c.re < -s->noise ? -1 : 0;
}

/* The sign of the first or last coefficient that has one. */
static int end_sign(const struct search *s, const ph_cplx *c, bool last) {
  for (size_t k = 0; k <= s->degree; k++) {
    int sign = sign_of(s, c[last ? s->degree - k : k]);
    if (sign != 0) {
      return sign;
    }
  }
  return 0;
}

static bool has_change(const struct search *s, const ph_cplx *c) {
  int sign = end_sign(s, c, false);
  for (size_t k = 0; k <= s->degree; k++) {
    if (sign * sign_of(s, c[k]) < 0) {
      return true;
    }
  }
  return false;
}

static void found(struct search *s, double u) {
  if (s->n < s->room && (s->n == 0 || u > s->u[s->n - 1])) {
    s->u[s->n++] = u;
  }
}

static void look(struct search *s, const ph_cplx *c, double from, double to,
                 int depth) {
  ph_cplx *left = s->pool + (2 * (size_t)depth + 1) * (s->degree + 1);
  ph_cplx *right = left + (s->degree + 1);
  double middle = (from + to) / 2;
  if (!has_change(s, c) || s->visits == 0) {
    return;
  }
  s->visits--;
  if (depth == DEPTH) {
    if (end_sign(s, c, false) != end_sign(s, c, true)) {
      found(s, middle);
    }
    return;
  }
  ph_bern_cut(c, s->degree, 0.5, left, right);
  look(s, left, from, middle, depth + 1);
  if (sign_of(s, right[0]) == 0 &&
      end_sign(s, left, true) * end_sign(s, right, false) < 0) {
    found(s, middle);
  }
  look(s, right, middle, to, depth + 1);
}

enum ph_status ph_tc_inflections(const struct ph_tc_bezier *curve,
                                 struct ph_arena *arena, double *u, size_t *n,
                                 struct ph_diag *diag) {
  size_t m = curve->degree;
  struct search s = {.u = u, .room = 2 * m, .visits = VISITS * m};
  struct ph_mark mark = ph_arena_mark(arena);
  double *binomial;
  *n = 0;
  if (m < 3) {
    return PH_OK; /* a parabola has none */
  }
  s.pool = ph_arena_array(arena, (2 * DEPTH + 3) * (2 * m - 2), sizeof *s.pool);
  binomial = ph_arena_array(arena, 4 * m, sizeof *binomial);
  if (s.pool && binomial) {
    curvature_form(curve, binomial, &s);
    look(&s, s.pool, 0, 1, 0);
    *n = s.n;
  }
  ph_arena_release(arena, mark);
  return s.pool && binomial ? PH_OK : ph_fail_memory(diag);
}
