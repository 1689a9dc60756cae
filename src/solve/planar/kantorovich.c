/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The theorem of Kantorovich for the C2 equations (c2.h).
 *
 * K.  Row i of F'(x) - F'(y) is made of the form's coefficients times the
 * differences of three unknowns; each coefficient occurs with the sum of its
 * factors 2, so that K = max over i of 2 (|ll| + |lm| + |mm| + |lr| + |mr| +
 * |rr|) [GON18, lemma 2.3].  A row of an open end gives 2/|d|.
 *
 * B, few unknowns.  The columns of the inverse are solved for one by one.
 *
 * B, an open curve.  J is tridiagonal, with rows lo, di, up.  Row i of X =
 * J^-1 satisfies the equations of column j of X J = I,
 *
 *   X[i][j-1] up[j-1] + X[i][j] di[j] + X[i][j+1] lo[j+1] = (i == j),
 *
 * so that outwards from i they are two-term recurrences in the pivots of the
 * elimination from above, d, and from below, e:
 *
 *   d[j] = di[j] - lo[j] up[j-1] / d[j-1],   X[i][j] = -X[i][j+1] lo[j+1] /
 * d[j] e[j] = di[j] - up[j] lo[j+1] / e[j+1],   X[i][j] = -X[i][j-1] up[j-1] /
 * e[j] X[i][i] = 1 / (d[i] + e[i] - di[i])                                  (1)
 *
 * With the sums of absolute values left and right of i in units of |X[i][i]|,
 *
 *   L[i] = |lo[i] / d[i-1]| (1 + L[i-1]),  R[i] = |up[i] / e[i+1]| (1 + R[i+1])
 *
 * the row sum of |X| is |X[i][i]| (1 + L[i] + R[i]).  Nothing overflows where
 * the inverse decays (Higham 1986 has the same in other terms).
 *
 * B, a closed curve.  Border the tridiagonal T of all rows and columns but the
 * last by the last column u, the last row v and the corner a.  With z = T^-1 u,
 * y = v T^-1 and s = a - v z the inverse is
 *
 *   [ T^-1 + z y / s   -z / s ]
 *   [    -y / s          1/s  ]                                          (2)
 *
 * so that row i has a sum of at most (that of T^-1) + |z[i]| Y, and the last
 * row at most Y, where Y = (1 + |y|) / |s|, |y| at most the row sums of T^-1
 * in the first and the last row, times the two entries of v.
 */
#include "solve/planar/c2.h"

#include <math.h>

/* Unknowns up to which the whole inverse is formed. */
enum { EXACT_MAX = 64 };

/* A pivot of elimination without interchanges that is smaller than this part
 * of its diagonal entry has lost half of its digits. */
static const double PIVOT = 1e-8;

static double larger(double a, double b) {
  return isnan(a) || b <= a ? a : b; /* NaN if either is */
}

static double lipschitz(const struct ph_planar_c2 *c2) {
  double k = 0;
  for (size_t i = 0; i < ph_planar_unknowns(c2); i++) {
    struct ph_planar_form f = ph_planar_form(c2, i);
    k = larger(k, 2 * (fabs(f.ll) + fabs(f.lm) + fabs(f.mm) + fabs(f.lr) +
                       fabs(f.mr) + fabs(f.rr)));
  }
  return k;
}

static double largest_of(const double *sum, size_t n) {
  double largest = 0;
  for (size_t i = 0; i < n; i++) {
    largest = larger(largest, sum[i]);
  }
  return largest;
}

/* ||J^-1|| by its columns. */
static bool norm_by_columns(const struct ph_planar_c2 *c2, const ph_cplx *b,
                            struct ph_arena *scratch, double *norm) {
  struct ph_tri_row row[EXACT_MAX];
  ph_cplx x[EXACT_MAX];
  double sum[EXACT_MAX] = {0};
  size_t n = ph_planar_unknowns(c2);
  struct ph_tri tri;
  if (!ph_tri_alloc(&tri, scratch, n)) {
    return false;
  }
  for (size_t i = 0; i < n; i++) {
    row[i] = ph_planar_row(c2, b, i);
    row[i].f = ph_cplx_of(0, 0);
  }
  for (size_t j = 0; j < n; j++) {
    row[j].f = ph_cplx_of(1, 0);
    ph_tri_begin(&tri, n, row[0], row[n - 1]);
    for (size_t i = 1; i < n - 1; i++) {
      ph_tri_push(&tri, &row[i]);
    }
    ph_tri_finish(&tri, x);
    for (size_t i = 0; i < n; i++) {
      sum[i] += ph_cplx_abs(x[i]);
    }
    row[j].f = ph_cplx_of(0, 0);
  }
  *norm = largest_of(sum, n);
  return true;
}

/* One pivot of (1): di less the product of the entries beside it over the
 * pivot before; NaN if next to nothing is left. */
static ph_cplx next_pivot(ph_cplx di, ph_cplx out, ph_cplx back,
                          ph_cplx before) {
  ph_cplx part = ph_cplx_mul(ph_cplx_mul(out, back), ph_cplx_inverse(before));
  ph_cplx pivot = ph_cplx_sub(di, part);
  bool lost = !(ph_cplx_norm2(pivot) >= PIVOT * PIVOT * ph_cplx_norm2(di));
  return lost ? ph_cplx_of((double)NAN, (double)NAN) : pivot;
}

static double quotient(ph_cplx a, ph_cplx b) {
  return sqrt(ph_cplx_norm2(a) / ph_cplx_norm2(b));
}

/*
 * Row sums of |T^-1| for the tridiagonal T of the first n rows and columns.
 *
 * inout sum[n]    R on the way
 * inout pivot[n]  e
 */
static void inverse_row_sums(const struct ph_planar_c2 *c2, const ph_cplx *b,
                             size_t n, ph_cplx *pivot, double *sum) {
  struct ph_tri_row row = ph_planar_row(c2, b, n - 1), above, below;
  double left = 0;
  ph_cplx d;
  pivot[n - 1] = row.di;
  sum[n - 1] = 0;
  for (size_t i = n - 1; i-- > 0;) {
    below = row;
    row = ph_planar_row(c2, b, i);
    pivot[i] = next_pivot(row.di, row.up, below.lo, pivot[i + 1]);
    sum[i] = quotient(row.up, pivot[i + 1]) * (1 + sum[i + 1]);
  }
  d = row.di;
  for (size_t i = 0; i < n; i++) {
    ph_cplx inverse; /* of X[i][i] */
    above = row;
    row = ph_planar_row(c2, b, i);
    if (i > 0) {
      left = quotient(row.lo, d) * (1 + left);
      d = next_pivot(row.di, row.lo, above.up, d);
    }
    inverse = ph_cplx_sub(ph_cplx_add(d, pivot[i]), row.di);
    sum[i] = (1 + left + sum[i]) / ph_cplx_abs(inverse);
  }
}

/* ||J^-1|| of an open curve. */
static bool norm_of_open(const struct ph_planar_c2 *c2, const ph_cplx *b,
                         struct ph_arena *scratch, double *norm) {
  size_t n = ph_planar_unknowns(c2);
  ph_cplx *pivot = ph_arena_array(scratch, n, sizeof *pivot);
  double *sum = ph_arena_array(scratch, n, sizeof *sum);
  if (!pivot || !sum) {
    return false;
  }
  inverse_row_sums(c2, b, n, pivot, sum);
  *norm = largest_of(sum, n);
  return true;
}

/* z = T^-1 u of (2), T of n rows and columns. */
static bool solve_border(const struct ph_planar_c2 *c2, const ph_cplx *b,
                         size_t n, struct ph_arena *scratch, ph_cplx *z) {
  struct ph_tri_row first = ph_planar_row(c2, b, 0), row;
  struct ph_tri_row last = ph_planar_row(c2, b, n - 1);
  const ph_cplx zero = {0, 0};
  struct ph_tri tri;
  if (!ph_tri_alloc(&tri, scratch, n)) {
    return false;
  }
  first.f = first.lo;
  first.lo = zero;
  last.f = last.up;
  last.up = zero;
  ph_tri_begin(&tri, n, first, last);
  for (size_t i = 1; i < n - 1; i++) {
    row = ph_planar_row(c2, b, i);
    row.f = zero;
    ph_tri_push(&tri, &row);
  }
  ph_tri_finish(&tri, z);
  return true;
}

/* At least ||J^-1|| of a closed curve. */
static bool norm_of_closed(const struct ph_planar_c2 *c2, const ph_cplx *b,
                           struct ph_arena *scratch, double *norm) {
  size_t n = c2->n - 1; /* of T */
  struct ph_tri_row v = ph_planar_row(c2, b, n);
  ph_cplx *z = ph_arena_array(scratch, n, sizeof *z), s;
  double *sum = ph_arena_array(scratch, n, sizeof *sum), y;
  if (!z || !sum) {
    return false;
  }
  inverse_row_sums(c2, b, n, z, sum);
  *norm = largest_of(sum, n);
  if (!isfinite(*norm)) {
    return true;
  }
  if (!solve_border(c2, b, n, scratch, z)) {
    return false;
  }
  s = ph_cplx_sub(v.di, ph_cplx_mul(v.up, z[0]));
  s = ph_cplx_sub(s, ph_cplx_mul(v.lo, z[n - 1]));
  y = ph_cplx_abs(v.up) * sum[0] + ph_cplx_abs(v.lo) * sum[n - 1];
  y = (1 + y) / ph_cplx_abs(s);
  for (size_t i = 0; i < n; i++) {
    sum[i] += ph_cplx_abs(z[i]) * y;
  }
  *norm = larger(y, largest_of(sum, n));
  return true;
}

/* C, where J is regular. */
static bool step_size(const struct ph_planar_c2 *c2, const ph_cplx *b,
                      struct ph_arena *scratch, double *size) {
  size_t n = ph_planar_unknowns(c2);
  ph_cplx *step = ph_arena_array(scratch, n, sizeof *step);
  struct ph_tri tri;
  double size2 = 0;
  if (!step || !ph_tri_alloc(&tri, scratch, n)) {
    return false;
  }
  ph_planar_newton_step(c2, b, &tri, step);
  for (size_t i = 0; i < n; i++) {
    size2 = larger(size2, ph_cplx_norm2(step[i]));
  }
  *size = sqrt(size2);
  return true;
}

/* B and C, infinite where they are not numbers.
 * ret  false when memory is exhausted */
static bool norms(const struct ph_planar_c2 *c2, const ph_cplx *b,
                  struct ph_arena *scratch, struct ph_kantorovich *out) {
  bool done;
  out->b = out->c = HUGE_VAL;
  done = ph_planar_unknowns(c2) <= EXACT_MAX
             ? norm_by_columns(c2, b, scratch, &out->b)
         : c2->closed ? norm_of_closed(c2, b, scratch, &out->b)
                      : norm_of_open(c2, b, scratch, &out->b);
  if (done && isfinite(out->b)) {
    done = step_size(c2, b, scratch, &out->c);
  }
  out->b = isfinite(out->b) ? out->b : HUGE_VAL;
  out->c = isfinite(out->c) ? out->c : HUGE_VAL;
  return done;
}

bool ph_planar_kantorovich(const struct ph_planar_c2 *c2, const ph_cplx *b,
                           struct ph_arena *scratch,
                           struct ph_kantorovich *out) {
  struct ph_mark mark = ph_arena_mark(scratch);
  bool done = norms(c2, b, scratch, out);
  ph_arena_release(scratch, mark);
  if (!done) {
    return false;
  }
  out->k = lipschitz(c2);
  out->h = out->b * out->c * out->k;
  out->h = out->h >= 0 ? out->h : HUGE_VAL; /* infinity times 0 */
  out->certified = out->h <= 0.5;
  /* the smaller root, by the formula that does not cancel */
  out->radius =
      out->certified ? 2 * out->c / (1 + sqrt(1 - 2 * out->h)) : HUGE_VAL;
  return true;
}
