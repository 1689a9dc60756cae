/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * How far chords are from a spherical curve and its parallels (see bend.h).
 *
 * Over a block [u0,u1] the points of de Casteljau's algorithm and all that is
 * made of them are Taylor coefficients f^(k) / k!, k <= 4, in intervals: what
 * they may be anywhere in the block, and what they are in its middle.  As
 *   f^(k)(u) is in f^(k)(middle) + [-radius,radius] f^(k+1)(block),     (1)
 * intervals of all orders but the last are as narrow as that after every step,
 * and bounds are exact to the second order of the length of the block.
 *
 * A step joins u and w, an angle theta apart, by
 *   Z = W(1 - t) u + W(t) w,  W(tau) = tau f_0(tau^2 X) / f_0(X),       (2)
 * with X = theta^2 and f_0 of s2.h; with E = |w - u|^2 / 4 = sin^2(theta / 2),
 *   X = 4 asin^2 sqrt E,   X' = 4 E' / f_0(X).                          (3)
 * Between two control points |Z^(k)| = theta^k.
 *
 * O' = g T and T' = turn N - v S, where v = |S'|, turn = K / v^2, N = S x T,
 * and g = v cos d - turn sin d (parallel.h), so that
 *   |O''|^2 = g'^2 + g^2 (v^2 + turn^2),                                (4)
 * and O has the curvature sqrt(v^2 + turn^2) / |g| in space.            (5)
 * At an end at rest S' = t V: the Taylor coefficients of V over a block from
 * there on are in those of S' of the next order, as V = mean of S'' over [0,t];
 *   v = t |V|,   turn = [S,V,V'] / V^2.                                 (6)
 */
#include "curve/bend.h"
#include "kernel/interval.h"
#include "kernel/pi.h"
#include "kernel/s2.h"

#include <stdbool.h>

enum { ORDER = 4 };

/* Coefficients of order 0, ..., n, over the block and in its middle. */
struct series {
  size_t n;
  struct ph_range over[ORDER + 1], middle[ORDER + 1];
};

struct vector {
  struct series x[3];
};

static const struct ph_range none = {0, 0};

/* ---- series -------------------------------------------------------------- */

/* (1) */
static void tighten(double radius, struct series *f) {
  for (size_t k = f->n; k-- > 0;) {
    double reach = radius * (double)(k + 1) * ph_range_farthest(f->over[k + 1]);
    struct ph_range near =
        ph_range_wider(f->middle[k].low - reach, f->middle[k].high + reach);
    struct ph_range *over = &f->over[k];
    over->low = near.low > over->low ? near.low : over->low;
    over->high = near.high < over->high ? near.high : over->high;
  }
}

/* sum_{j = first}^{k} a_j b_{k-j} */
static struct ph_range convolve(const struct ph_range *a,
                                const struct ph_range *b, size_t first,
                                size_t k) {
  struct ph_range sum = none;
  for (size_t j = first; j <= k; j++) {
    sum = ph_range_add(sum, ph_range_mul(a[j], b[k - j]));
  }
  return sum;
}

static size_t lesser(size_t a, size_t b) {
  return a < b ? a : b;
}

static struct series times(double radius, const struct series *a,
                           const struct series *b) {
  struct series p = {.n = lesser(a->n, b->n)};
  for (size_t k = 0; k <= p.n; k++) {
    p.over[k] = convolve(a->over, b->over, 0, k);
    p.middle[k] = convolve(a->middle, b->middle, 0, k);
  }
  tighten(radius, &p);
  return p;
}

/* The square, which is not negative. */
static struct series square(double radius, const struct series *a) {
  struct series p = times(radius, a, a);
  struct ph_range over = ph_range_square(a->over[0]);
  p.over[0].low = over.low > p.over[0].low ? over.low : p.over[0].low;
  p.over[0].high = over.high < p.over[0].high ? over.high : p.over[0].high;
  return p;
}

/* x a + y b */
static struct series combine(double radius, double x, const struct series *a,
                             double y, const struct series *b) {
  struct series s = {.n = lesser(a->n, b->n)};
  for (size_t k = 0; k <= s.n; k++) {
    s.over[k] = ph_range_add(ph_range_scale(x, a->over[k]),
                             ph_range_scale(y, b->over[k]));
    s.middle[k] = ph_range_add(ph_range_scale(x, a->middle[k]),
                               ph_range_scale(y, b->middle[k]));
  }
  tighten(radius, &s);
  return s;
}

static void divide(const struct ph_range *a, const struct ph_range *b, size_t n,
                   struct ph_range *q) {
  for (size_t k = 0; k <= n; k++) {
    struct ph_range rest =
        k > 0 ? ph_range_sub(a[k], convolve(b, q, 1, k)) : a[0];
    q[k] = ph_range_div(rest, b[0]);
  }
}

static struct series quotient(double radius, const struct series *a,
                              const struct series *b) {
  struct series q = {.n = lesser(a->n, b->n)};
  divide(a->over, b->over, q.n, q.over);
  divide(a->middle, b->middle, q.n, q.middle);
  tighten(radius, &q);
  return q;
}

static void extract(const struct ph_range *a, size_t n, struct ph_range *r) {
  r[0] = ph_range_root(a[0]);
  for (size_t k = 1; k <= n; k++) {
    struct ph_range rest = a[k];
    for (size_t j = 1; j < k; j++) {
      rest = ph_range_sub(rest, ph_range_mul(r[j], r[k - j]));
    }
    r[k] = ph_range_div(rest, ph_range_scale(2, r[0]));
  }
}

static struct series root(double radius, const struct series *a) {
  struct series r = {.n = a->n};
  extract(a->over, r.n, r.over);
  extract(a->middle, r.n, r.middle);
  tighten(radius, &r);
  return r;
}

static struct series derivative(const struct series *a) {
  struct series d = {.n = a->n - 1};
  for (size_t k = 0; k <= d.n; k++) {
    d.over[k] = ph_range_scale((double)(k + 1), a->over[k + 1]);
    d.middle[k] = ph_range_scale((double)(k + 1), a->middle[k + 1]);
  }
  return d;
}

/* ---- f_0 of a series ----------------------------------------------------- */

/* Taylor coefficients of f_0 at x: f_n' = -f_{n+1} / 2, and all f_n are
 * positive and fall from 1 / (2 n + 1)!! on [0, pi^2]. */
static void bessel(struct ph_range x, struct ph_range f[ORDER + 1]) {
  static const double first[ORDER + 1] = {1, 1.0 / 3, 1.0 / 15, 1.0 / 105,
                                          1.0 / 945};
  static const double factor[ORDER + 1] = {1, -1.0 / 2, 1.0 / 8, -1.0 / 48,
                                           1.0 / 384};
  static const double rounding = 32 * DBL_EPSILON;
  double at[2][ORDER];
  bool inside = x.high < PH_PI * PH_PI;
  ph_s2_bessel(x.low > 0 ? x.low : 0, at[0]);
  ph_s2_bessel(inside && x.high > 0 ? x.high : 0, at[1]);
  for (size_t n = 0; n <= ORDER; n++) {
    struct ph_range all = {0, first[n]};
    if (n < ORDER && inside) {
      all.low = at[1][n] - rounding * first[n];
      all.high = at[0][n] + rounding * first[n];
    }
    f[n] = ph_range_scale(factor[n], all);
  }
}

/* f(x), from the Taylor coefficients of f at x[0]. */
static void compose(const struct ph_range f[ORDER + 1],
                    const struct ph_range *x, size_t n, struct ph_range *y) {
  for (size_t k = 1; k <= n; k++) {
    y[k] = none;
  }
  y[0] = f[n];
  for (size_t k = n; k-- > 0;) {
    /* what follows raises by k: no more orders are needed */
    for (size_t j = n - k; j > 0; j--) {
      struct ph_range sum = none;
      for (size_t i = 1; i <= j; i++) {
        sum = ph_range_add(sum, ph_range_mul(x[i], y[j - i]));
      }
      y[j] = sum;
    }
    y[0] = f[k];
  }
}

static struct series f0_of(double radius, const struct series *x) {
  struct series y = {.n = x->n};
  struct ph_range f[ORDER + 1];
  bessel(x->over[0], f);
  compose(f, x->over, y.n, y.over);
  bessel(x->middle[0], f);
  compose(f, x->middle, y.n, y.middle);
  tighten(radius, &y);
  return y;
}

/* ---- (3) ----------------------------------------------------------------- */

/* 4 asin^2 sqrt e */
static double angle_square(double e) {
  double angle = 2 * atan2(sqrt(e), sqrt(1 - e));
  return angle * angle;
}

static void angle_over(const struct ph_range *e, size_t n, struct ph_range *x) {
  static const double rounding = 8 * DBL_EPSILON;
  struct ph_range f[ORDER + 1], y[ORDER + 1], inverse[ORDER + 1];
  const struct ph_range one[ORDER + 1] = {{1, 1}};
  double low = angle_square(e[0].low > 0 ? e[0].low : 0);
  double high = e[0].high < 1 ? angle_square(e[0].high) : (double)INFINITY;
  x[0] = ph_range_wider(low * (1 - rounding), high * (1 + rounding));
  bessel(x[0], f);
  for (size_t k = 1; k <= n; k++) {
    struct ph_range sum = none;
    compose(f, x, k - 1, y);
    divide(one, y, k - 1, inverse);
    for (size_t j = 1; j <= k; j++) {
      struct ph_range slope = ph_range_scale((double)j, e[j]);
      sum = ph_range_add(sum, ph_range_mul(slope, inverse[k - j]));
    }
    x[k] = ph_range_scale(4 / (double)k, sum);
  }
}

static struct series angle_of(double radius, const struct series *e) {
  struct series x = {.n = e->n};
  angle_over(e->over, x.n, x.over);
  angle_over(e->middle, x.n, x.middle);
  tighten(radius, &x);
  return x;
}

/* ---- the steps ----------------------------------------------------------- */

/* A block of a segment; t and 1 - t over it. */
struct block {
  double middle, radius;
  struct series tau[2];
};

static struct block block_of(double u0, double u1) {
  struct block block = {.middle = 0.5 * (u0 + u1)};
  double before = block.middle - u0, after = u1 - block.middle;
  block.radius = (before > after ? before : after) * (1 + 2 * DBL_EPSILON);
  for (size_t i = 0; i < 2; i++) {
    struct series *tau = &block.tau[i];
    double to = i ? 1 : -1, m = i ? block.middle : 1 - block.middle;
    *tau = (struct series){.n = ORDER};
    tau->over[0] = i ? ph_range_wider(u0, u1) : ph_range_wider(1 - u1, 1 - u0);
    tau->middle[0] = ph_range_wider(m, m);
    tau->over[1] = tau->middle[1] = (struct ph_range){to, to};
  }
  return block;
}

static struct series dot(double radius, const struct vector *a,
                         const struct vector *b) {
  struct series sum = times(radius, &a->x[0], &b->x[0]);
  for (size_t i = 1; i < 3; i++) {
    struct series product = times(radius, &a->x[i], &b->x[i]);
    sum = combine(radius, 1, &sum, 1, &product);
  }
  return sum;
}

static struct series norm(double radius, const struct vector *a) {
  struct series sum = square(radius, &a->x[0]);
  for (size_t i = 1; i < 3; i++) {
    struct series product = square(radius, &a->x[i]);
    sum = combine(radius, 1, &sum, 1, &product);
  }
  return sum;
}

/* [a,b,c] */
static struct series triple(double radius, const struct vector *a,
                            const struct vector *b, const struct vector *c) {
  struct vector cross;
  for (size_t i = 0; i < 3; i++) {
    size_t j = (i + 1) % 3, k = (i + 2) % 3;
    struct series left = times(radius, &b->x[j], &c->x[k]);
    struct series right = times(radius, &b->x[k], &c->x[j]);
    cross.x[i] = combine(radius, 1, &left, -1, &right);
  }
  return dot(radius, a, &cross);
}

/* (2), W(tau) */
static struct series weight(double radius, const struct series *tau,
                            const struct series *x, const struct series *f0) {
  struct series y = square(radius, tau);
  y = times(radius, &y, x);
  y = f0_of(radius, &y);
  y = quotient(radius, &y, f0);
  return times(radius, tau, &y);
}

/* (2) */
static void step(const struct block *block, const struct vector *u,
                 const struct vector *w, struct vector *z) {
  const double radius = block->radius;
  struct vector half;
  struct series e, x, f0, to[2];
  for (size_t i = 0; i < 3; i++) {
    half.x[i] = combine(radius, 0.5, &w->x[i], -0.5, &u->x[i]);
  }
  e = norm(radius, &half);
  x = angle_of(radius, &e);
  f0 = f0_of(radius, &x);
  to[0] = weight(radius, &block->tau[0], &x, &f0);
  to[1] = weight(radius, &block->tau[1], &x, &f0);
  for (size_t i = 0; i < 3; i++) {
    struct series before = times(radius, &to[0], &u->x[i]);
    struct series after = times(radius, &to[1], &w->x[i]);
    z->x[i] = combine(radius, 1, &before, 1, &after);
  }
}

/* The same between two control points p and q: Z'' = -theta^2 Z. */
static void arc(const struct block *block, size_t order, ph_vec3 p, ph_vec3 q,
                struct vector *z) {
  static const double rounding = 32 * DBL_EPSILON;
  const double theta = ph_s2_angle(p, q), half = theta / 2;
  const double sigma = 2 * block->middle - 1, y = sigma * half;
  const double a = cos(y) / cos(half);
  const double f = ph_s2_f0(half * half), b = sigma * ph_s2_f0(y * y) / f;
  ph_vec3 m = ph_vec3_scale(0.5, ph_vec3_add(p, q));
  ph_vec3 d = ph_vec3_scale(0.5, ph_vec3_sub(q, p)), at[2];
  at[0] = ph_vec3_along(ph_vec3_scale(a, m), b, d);
  at[1] = ph_vec3_along(ph_vec3_scale(-theta * tan(half) * b, m),
                        2 * cos(half) / f * a, d);
  for (size_t i = 0; i < 3; i++) {
    struct series *x = &z->x[i];
    double size = 1 + rounding;
    x->n = order;
    for (size_t k = 0; k <= order; k++) {
      double v[3], error = rounding * size;
      ph_vec3_put(at[k % 2], 3, v);
      x->over[k] = (struct ph_range){-size, size};
      x->middle[k] =
          k < 2 ? ph_range_of(&v[i], 1, error)
                : ph_range_scale(-theta * theta / (double)(k * (k - 1)),
                                 x->middle[k - 2]);
      size *= theta / (double)(k + 1) * (1 + rounding);
    }
    tighten(block->radius, x);
  }
}

static void curve_over(const struct block *block, size_t order,
                       const struct ph_spherical *s, struct vector *z) {
  struct vector a[3];
  for (size_t i = 0; i < 3; i++) {
    arc(block, order, s->p[i], s->p[i + 1], &a[i]);
  }
  step(block, &a[0], &a[1], &a[0]);
  step(block, &a[1], &a[2], &a[1]);
  step(block, &a[0], &a[1], z);
}

/* ---- bounds -------------------------------------------------------------- */

static struct vector derivatives(const struct vector *a) {
  struct vector d;
  for (size_t i = 0; i < 3; i++) {
    d.x[i] = derivative(&a->x[i]);
  }
  return d;
}

/* The lesser of two bounds; a bound that is no number is none. */
static double bound_of(struct ph_range a, struct ph_range b) {
  double m = b.high < a.high ? b.high : a.high;
  return m < (double)INFINITY ? m : (double)INFINITY;
}

/* Of the curve: |S''|, and by its speed and curvature. */
static double bend_curve(const struct ph_spherical *segment, double u0,
                         double u1) {
  const struct block block = block_of(u0, u1);
  const struct ph_range one = {1, 1};
  struct vector s, first, second;
  struct series w, q, k;
  struct ph_range cube, kappa;
  curve_over(&block, ORDER - 1, segment, &s);
  first = derivatives(&s);
  second = derivatives(&first);
  w = norm(block.radius, &first);
  q = norm(block.radius, &second);
  k = triple(block.radius, &s, &first, &second);
  cube = ph_range_mul(ph_range_square(w.over[0]), w.over[0]);
  kappa = ph_range_div(ph_range_square(k.over[0]), cube);
  kappa = ph_range_root(ph_range_add(one, kappa));
  return bound_of(ph_range_root(q.over[0]), ph_range_mul(w.over[0], kappa));
}

/* (4) and (5) */
static double bend_parallel(double radius, double distance,
                            const struct series *v, const struct series *turn) {
  struct series g = combine(radius, cos(distance), v, -sin(distance), turn);
  struct ph_range size = ph_range_square(g.over[0]);
  struct ph_range rate =
      ph_range_add(ph_range_square(v->over[0]), ph_range_square(turn->over[0]));
  struct ph_range by_length =
      ph_range_mul(size, ph_range_root(ph_range_div(rate, size)));
  struct ph_range along = ph_range_square(g.over[1]);
  return bound_of(ph_range_root(ph_range_add(along, ph_range_mul(size, rate))),
                  by_length);
}

/* Away from rest. */
static double bend_moving(const struct block *block, double distance,
                          const struct vector *s) {
  const double radius = block->radius;
  struct vector first = derivatives(s), second = derivatives(&first);
  struct series w = norm(radius, &first), v = root(radius, &w);
  struct series k = triple(radius, s, &first, &second);
  struct series turn = quotient(radius, &k, &w);
  return bend_parallel(radius, distance, &v, &turn);
}

/* (6); from the start on, or up to the end. */
static double bend_rest(const struct block *block, bool start, double distance,
                        const struct vector *s) {
  const double radius = block->radius;
  struct series t = block->tau[start ? 1 : 0];
  struct vector first = derivatives(s), v, slope;
  struct series w, k, turn, speed;
  for (size_t i = 0; i < 3; i++) {
    const struct series *x = &first.x[i];
    v.x[i] = (struct series){.n = x->n - 1};
    divide(x->middle, t.middle, v.x[i].n, v.x[i].middle);
    for (size_t n = 0; n <= v.x[i].n; n++) {
      v.x[i].over[n] = ph_range_scale(start ? 1 : -1, x->over[n + 1]);
    }
    tighten(radius, &v.x[i]);
  }
  slope = derivatives(&v);
  w = norm(radius, &v);
  k = triple(radius, s, &v, &slope);
  turn = quotient(radius, &k, &w);
  speed = root(radius, &w);
  speed = times(radius, &t, &speed);
  return bend_parallel(radius, distance, &speed, &turn);
}

static bool is_same(ph_vec3 a, ph_vec3 b) {
  return ph_s2_angle(a, b) <= 0;
}

/* The bound (6) over the least block up to an end at rest. */
static double bend_near(const struct ph_spherical *segment, bool start,
                        double distance, double u) {
  const struct block block = start ? block_of(0, u) : block_of(u, 1);
  struct vector s;
  curve_over(&block, ORDER, segment, &s);
  return bend_rest(&block, start, distance, &s);
}

static double bend_beside(const struct ph_spherical *segment, double distance,
                          double u0, double u1) {
  const struct block block = block_of(u0, u1);
  struct vector s;
  curve_over(&block, ORDER, segment, &s);
  return bend_moving(&block, distance, &s);
}

double ph_bend_spherical(const struct ph_spherical *segment, double distance,
                         double u0, double u1) {
  const ph_vec3 *p = segment->p;
  const bool start = is_same(p[0], p[1]), end = is_same(p[2], p[3]);
  double bend;
  if (!(fabs(distance) > 0)) {
    return bend_curve(segment, u0, u1);
  }
  if (is_same(p[1], p[2]) && (start || end)) {
    /* on a great circle: its parallel is S cos d but for a constant */
    return fabs(cos(distance)) * bend_curve(segment, u0, u1);
  }
  bend = (start && u0 <= 0) || (end && u1 >= 1)
             ? (double)INFINITY
             : bend_beside(segment, distance, u0, u1);
  if (start && u1 <= 0.5) {
    bend = fmin(bend, bend_near(segment, true, distance, u1));
  }
  if (end && u0 >= 0.5) {
    bend = fmin(bend, bend_near(segment, false, distance, u0));
  }
  return bend;
}
