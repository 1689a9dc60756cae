/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * How far chords are from a spherical curve and its parallels (see
 * chord_bound.h).
 *
 * Over a block [u0,u1] the points of de Casteljau's algorithm and all that is
 * made of them are Taylor coefficients f_k = f^(k) / k!, k <= 4: what they are
 * in the middle, and the most that they are in size anywhere in the block.  The
 * latter follow from those of the operands by the rules for products, quotients
 * and so on; and as
 *   |f_k(u)| <= |f_k(middle)| + radius (k + 1) max|f_{k+1}|,            (1)
 * all but the last are exact to the second order of the length of the block.
 * The range of a number is that about the middle.
 *
 * A step joins u and w, an angle theta apart, by
 *   Z = W(1 - t) u + W(t) w,  W(tau) = tau f_0(tau^2 X) / f_0(X),       (2)
 * with X = theta^2 and f_n of s2.h, which are positive and fall on [0, pi^2],
 * f_n' = -f_{n+1} / 2; with E = |w - u|^2 / 4 = sin^2(theta / 2),
 *   X = 4 asin^2 sqrt E,   X' = 4 E' / f_0(X).                          (3)
 * Points are displacements from a control point P, as in spherical_fast.c:
 *   Z - P = (A - 1) P + W(1 - t) (u - P) + W(t) (w - P)                 (4)
 *   A = W(1 - t) + W(t) = cos((2t - 1) theta/2) / cos(theta/2),
 *   A' = A_sigma sigma' + A_E E'.
 * Between two control points |Z^(k)| = theta^k.
 *
 * O' = g T and T' = turn N - v S, where v = |S'|, turn = K / v^2, N = S x T,
 * and g = v cos d - turn sin d (curve/kind/spherical.c), so that
 *   |O''|^2 = g'^2 + g^2 (v^2 + turn^2),                                (5)
 * and O has the curvature sqrt(v^2 + turn^2) / |g| in space.            (6)
 * At an end at rest S' = t V: the Taylor coefficients of V over a block from
 * there on are in those of S' of the next order, as V = mean of S'' over [0,t];
 *   v = t |V|,   turn = [S,V,V'] / V^2.                                 (7)
 */
#include "curve/sample/chord_bound.h"
#include "kernel/pi.h"
#include "kernel/s2.h"

#include <float.h>
#include <stdbool.h>

enum { ORDER = 4 };

/* What the result is known to. */
static const double ROUNDING = 64 * DBL_EPSILON;

/* Coefficients of order 0, ..., n in the middle of a block, and the most over
 * it. */
struct series {
  size_t n;
  double at[ORDER + 1], most[ORDER + 1];
};

struct vector {
  size_t n;
  ph_vec3 at[ORDER + 1];
  double most[ORDER + 1];
};

/* ---- series -------------------------------------------------------------- */

/* The lesser of two bounds, of which one may be NaN. */
static double lesser(double a, double b) {
  return a < b ? a : b <= a ? b : (double)INFINITY;
}

/* (1) */
static void tighten(double radius, struct series *f) {
  for (size_t k = f->n; k-- > 0;) {
    f->most[k] = lesser(f->most[k], fabs(f->at[k]) + radius * (double)(k + 1) *
                                                         f->most[k + 1]);
  }
}

static void tighten_vector(double radius, struct vector *f) {
  for (size_t k = f->n; k-- > 0;) {
    f->most[k] =
        lesser(f->most[k], ph_vec3_abs(f->at[k]) +
                               radius * (double)(k + 1) * f->most[k + 1]);
  }
}

/* The least and the greatest value. */
static double least(double radius, const struct series *f) {
  return f->at[0] - radius * f->most[1];
}

static double greatest(double radius, const struct series *f) {
  return f->at[0] + radius * f->most[1];
}

/* sum_{j = first}^{k} a_j b_{k-j} */
static double convolve(const double *a, const double *b, size_t first,
                       size_t k) {
  double sum = 0;
  for (size_t j = first; j <= k; j++) {
    sum += a[j] * b[k - j];
  }
  return sum;
}

static size_t common(size_t a, size_t b) {
  return a < b ? a : b;
}

static struct series times(double radius, const struct series *a,
                           const struct series *b) {
  struct series p = {.n = common(a->n, b->n)};
  for (size_t k = 0; k <= p.n; k++) {
    p.at[k] = convolve(a->at, b->at, 0, k);
    p.most[k] = convolve(a->most, b->most, 0, k);
  }
  tighten(radius, &p);
  return p;
}

/* a / b, b > 0 */
static struct series quotient(double radius, const struct series *a,
                              const struct series *b) {
  const double low = least(radius, b);
  struct series q = {.n = common(a->n, b->n)};
  for (size_t k = 0; k <= q.n; k++) {
    double at = a->at[k], most = a->most[k];
    if (k > 0) {
      at -= convolve(b->at, q.at, 1, k);
      most += convolve(b->most, q.most, 1, k);
    }
    q.at[k] = at / b->at[0];
    q.most[k] = low > 0 ? most / low : (double)INFINITY;
  }
  tighten(radius, &q);
  return q;
}

/* sqrt(a), a > 0 */
static struct series root(double radius, const struct series *a) {
  const double low = least(radius, a);
  struct series r = {.n = a->n};
  r.at[0] = sqrt(a->at[0]);
  r.most[0] = sqrt(a->most[0]);
  for (size_t k = 1; k <= r.n; k++) {
    double at = a->at[k], most = a->most[k];
    for (size_t j = 1; j < k; j++) {
      at -= r.at[j] * r.at[k - j];
      most += r.most[j] * r.most[k - j];
    }
    r.at[k] = at / (2 * r.at[0]);
    r.most[k] = low > 0 ? most / (2 * sqrt(low)) : (double)INFINITY;
  }
  tighten(radius, &r);
  return r;
}

/* Taylor coefficients of f_0 at x, or, with sign 1, their sizes. */
static void bessel(double x, double sign, double f[ORDER + 1]) {
  ph_s2_bessel(x > 0 ? x : 0, f);
  f[4] = 1.0 / 945; /* no less than f_4, and of use for the most alone */
  f[1] *= sign / 2;
  f[2] *= 1.0 / 8;
  f[3] *= sign / 48;
  f[4] *= 1.0 / 384;
}

/* f(x), from the Taylor coefficients of f at x[0]. */
static void compose(const double f[ORDER + 1], const double *x, size_t n,
                    double *y) {
  for (size_t k = 0; k <= n; k++) {
    y[k] = 0;
  }
  y[0] = f[n];
  for (size_t k = n; k-- > 0;) {
    /* what follows raises by k: no more orders are needed */
    for (size_t j = n - k; j > 0; j--) {
      double sum = 0;
      for (size_t i = 1; i <= j; i++) {
        sum += x[i] * y[j - i];
      }
      y[j] = sum;
    }
    y[0] = f[k];
  }
}

/* f_0 of a series of numbers from `low` on. */
static struct series f0_of(double radius, double low, const struct series *x) {
  struct series y = {.n = x->n};
  double f[ORDER + 1];
  bessel(x->at[0], -1, f);
  compose(f, x->at, y.n, y.at);
  bessel(low, 1, f);
  compose(f, x->most, y.n, y.most);
  tighten(radius, &y);
  return y;
}

/* ---- vectors ------------------------------------------------------------- */

static struct vector difference(double radius, const struct vector *a,
                                const struct vector *b) {
  struct vector d = {.n = common(a->n, b->n)};
  for (size_t k = 0; k <= d.n; k++) {
    d.at[k] = ph_vec3_sub(a->at[k], b->at[k]);
    d.most[k] = a->most[k] + b->most[k];
  }
  tighten_vector(radius, &d);
  return d;
}

static struct vector derivative(const struct vector *a) {
  struct vector d = {.n = a->n - 1};
  for (size_t k = 0; k <= d.n; k++) {
    d.at[k] = ph_vec3_scale((double)(k + 1), a->at[k + 1]);
    d.most[k] = (double)(k + 1) * a->most[k + 1];
  }
  return d;
}

/* |a|^2 */
static struct series square(double radius, const struct vector *a) {
  struct series p = {.n = a->n};
  for (size_t k = 0; k <= p.n; k++) {
    for (size_t j = 0; j <= k; j++) {
      p.at[k] += ph_vec3_dot(a->at[j], a->at[k - j]);
    }
    p.most[k] = convolve(a->most, a->most, 0, k);
  }
  tighten(radius, &p);
  return p;
}

/* [a,b,c] */
static struct series triple(double radius, const struct vector *a,
                            const struct vector *b, const struct vector *c) {
  struct series p = {.n = common(common(a->n, b->n), c->n)};
  for (size_t i = 0; i <= p.n; i++) {
    for (size_t j = 0; i + j <= p.n; j++) {
      ph_vec3 side = ph_vec3_cross(a->at[i], b->at[j]);
      double most = a->most[i] * b->most[j];
      for (size_t k = 0; i + j + k <= p.n; k++) {
        p.at[i + j + k] += ph_vec3_dot(side, c->at[k]);
        p.most[i + j + k] += most * c->most[k];
      }
    }
  }
  tighten(radius, &p);
  return p;
}

/* ---- the steps ----------------------------------------------------------- */

/* A block of a segment; 1 - t and t over it. */
struct block {
  double middle, radius;
  ph_vec3 base; /* P */
  struct series tau[2];
};

static struct block block_of(const struct ph_spherical *segment, double u0,
                             double u1) {
  struct block block = {.middle = 0.5 * (u0 + u1)};
  double before = block.middle - u0, after = u1 - block.middle;
  block.radius = (before > after ? before : after) * (1 + 2 * DBL_EPSILON);
  block.base = segment->p[block.middle < 0.5 ? 0 : 3];
  for (size_t i = 0; i < 2; i++) {
    struct series *tau = &block.tau[i];
    *tau = (struct series){.n = ORDER};
    tau->at[0] = i ? block.middle : 1 - block.middle;
    tau->at[1] = i ? 1 : -1;
    tau->most[0] = tau->at[0] + block.radius;
    tau->most[1] = 1;
  }
  return block;
}

/* 4 asin^2 sqrt e */
static double angle_square(double e) {
  double angle =
      e < 1 ? 2 * atan2(sqrt(e > 0 ? e : 0), sqrt(1 - e)) : (double)INFINITY;
  return angle * angle;
}

/* (3): X from x[0] and E, and f_0(X); in the middle, where sign is -1, or the
 * most, by the least f_0(X). */
static void angle_over(const double *e, size_t n, double sign,
                       const double f[ORDER + 1], double least_f0, double *x,
                       double *f0) {
  double inverse[ORDER + 1];
  for (size_t k = 0; k < n; k++) {
    double sum = 0;
    compose(f, x, k, f0);
    inverse[k] = (k > 0 ? sign * convolve(f0, inverse, 1, k) : 1) / least_f0;
    for (size_t j = 1; j <= k + 1; j++) {
      sum += (double)j * e[j] * inverse[k + 1 - j];
    }
    x[k + 1] = 4 * sum / (double)(k + 1);
  }
  compose(f, x, n, f0);
}

/* theta: X, its least value, and f_0(X). */
struct angle {
  double low;
  struct series x, f0;
};

/* Whether there is one, less than pi. */
static bool angle_of(double radius, const struct series *e,
                     struct angle *angle) {
  const double high = angle_square(greatest(radius, e));
  double f[ORDER + 1];
  if (!(high < PH_PI * PH_PI)) {
    return false;
  }
  angle->low = angle_square(least(radius, e));
  angle->x = angle->f0 = (struct series){.n = e->n};
  angle->x.at[0] = angle_square(e->at[0]);
  angle->x.most[0] = high;
  bessel(angle->x.at[0], -1, f);
  angle_over(e->at, e->n, -1, f, f[0], angle->x.at, angle->f0.at);
  bessel(angle->low, 1, f);
  angle_over(e->most, e->n, 1, f, ph_s2_f0(high), angle->x.most,
             angle->f0.most);
  tighten(radius, &angle->x);
  tighten(radius, &angle->f0);
  return true;
}

/* (2), W(tau) */
static struct series weight(double radius, const struct series *tau,
                            const struct angle *angle) {
  const double low = tau->at[0] - radius;
  struct series y = times(radius, tau, tau);
  y = times(radius, &y, &angle->x);
  y = f0_of(radius, low * low * angle->low, &y);
  y = quotient(radius, &y, &angle->f0);
  return times(radius, tau, &y);
}

/* A - 1 of (4), without the rounding of 1. */
static struct series sum_of(const struct block *block,
                            const struct angle *angle, const struct series *e,
                            const struct series *before,
                            const struct series *after) {
  const double phi = 0.5 * sqrt(angle->x.at[0]), cosine = cos(phi);
  const double t = block->tau[1].at[0], s = block->tau[0].at[0];
  const double a = 2 * sin(t * phi) * sin(s * phi) / cosine;
  const double b = after->at[0] - before->at[0];
  const double slope = (1 + a - (t - s) * b) / (2 * cosine * cosine);
  struct series sum = {.n = before->n};
  for (size_t k = 0; k <= sum.n; k++) {
    sum.at[k] = before->at[k] + after->at[k];
    sum.most[k] = before->most[k] + after->most[k];
  }
  sum.at[0] = a;
  sum.at[1] = slope * e->at[1] - 2 * phi * tan(phi) * b;
  tighten(block->radius, &sum);
  return sum;
}

/* (4); whether it could be done. */
static bool step(const struct block *block, const struct vector *u,
                 const struct vector *w, struct vector *z) {
  const double radius = block->radius;
  const struct vector d = difference(radius, w, u);
  struct vector joined = {.n = d.n};
  struct series e = square(radius, &d), before, after, sum;
  struct angle angle;
  for (size_t k = 0; k <= e.n; k++) {
    e.at[k] *= 0.25;
    e.most[k] *= 0.25;
  }
  if (!angle_of(radius, &e, &angle)) {
    return false;
  }
  before = weight(radius, &block->tau[0], &angle);
  after = weight(radius, &block->tau[1], &angle);
  sum = sum_of(block, &angle, &e, &before, &after);
  for (size_t k = 0; k <= joined.n; k++) {
    ph_vec3 at = ph_vec3_scale(sum.at[k], block->base);
    for (size_t j = 0; j <= k; j++) {
      at = ph_vec3_along(at, before.at[j], u->at[k - j]);
      at = ph_vec3_along(at, after.at[j], w->at[k - j]);
    }
    joined.at[k] = at;
    joined.most[k] = sum.most[k] + convolve(before.most, u->most, 0, k) +
                     convolve(after.most, w->most, 0, k);
  }
  tighten_vector(radius, &joined);
  *z = joined;
  return true;
}

/* The same between two control points p and q: Z'' = -theta^2 Z. */
static void arc(const struct block *block, size_t order, ph_vec3 p, ph_vec3 q,
                struct vector *z) {
  const double theta = ph_s2_angle(p, q), half = theta / 2;
  const double t = block->tau[1].at[0], s = block->tau[0].at[0];
  const double x = theta * theta, f0 = ph_s2_f0(half * half);
  const double before = ph_s2_weight(s, x), after = ph_s2_weight(t, x);
  const double a = 2 * sin(t * half) * sin(s * half) / cos(half);
  const ph_vec3 m = ph_vec3_scale(0.5, ph_vec3_add(p, q));
  const ph_vec3 d = ph_vec3_scale(0.5, ph_vec3_sub(q, p));
  double size = 2;
  z->n = order;
  z->at[0] = ph_vec3_scale(a, block->base);
  z->at[0] = ph_vec3_along(z->at[0], before, ph_vec3_sub(p, block->base));
  z->at[0] = ph_vec3_along(z->at[0], after, ph_vec3_sub(q, block->base));
  z->at[1] =
      ph_vec3_along(ph_vec3_scale(-theta * tan(half) * (after - before), m),
                    2 * cos(half) / f0 * (1 + a), d);
  for (size_t k = 2; k <= order; k++) {
    ph_vec3 full = k > 2 ? z->at[k - 2] : ph_vec3_add(block->base, z->at[0]);
    z->at[k] = ph_vec3_scale(-x / (double)(k * (k - 1)), full);
  }
  for (size_t k = 0; k <= order; k++) {
    z->most[k] = size;
    size = k > 0 ? size * theta / (double)(k + 1) : theta;
  }
  tighten_vector(block->radius, z);
}

/* S over a block; whether it could be found. */
static bool curve_over(const struct block *block, size_t order,
                       const struct ph_spherical *s, struct vector *z) {
  struct vector a[3];
  for (size_t i = 0; i < 3; i++) {
    arc(block, order, s->p[i], s->p[i + 1], &a[i]);
  }
  if (!step(block, &a[0], &a[1], &a[0]) || !step(block, &a[1], &a[2], &a[1]) ||
      !step(block, &a[0], &a[1], z)) {
    return false;
  }
  z->at[0] = ph_vec3_add(block->base, z->at[0]);
  z->most[0] = 1;
  return true;
}

/* ---- bounds -------------------------------------------------------------- */

/* The lesser of two bounds, and what rounding may have taken away. */
static double bound_of(double a, double b) {
  return lesser(a, b) * (1 + ROUNDING);
}

/* Of the curve: |S''|, and by its speed and curvature. */
static double bound_curve(const struct ph_spherical *segment, double u0,
                          double u1) {
  const struct block block = block_of(segment, u0, u1);
  struct vector s, first, second;
  struct series w, k;
  double low, kappa;
  if (!curve_over(&block, ORDER - 1, segment, &s)) {
    return (double)INFINITY;
  }
  first = derivative(&s);
  second = derivative(&first);
  w = square(block.radius, &first);
  k = triple(block.radius, &s, &first, &second);
  low = least(block.radius, &w);
  kappa = low > 0 ? k.most[0] / (low * sqrt(low)) : (double)INFINITY;
  return bound_of(second.most[0], w.most[0] * sqrt(1 + kappa * kappa));
}

/* (5) and (6) */
static double bound_parallel(double radius, double distance,
                             const struct series *v,
                             const struct series *turn) {
  const double cosine = cos(distance), sine = sin(distance);
  const double rate = hypot(v->most[0], turn->most[0]);
  struct series g = {.n = common(v->n, turn->n)};
  double low;
  for (size_t k = 0; k <= g.n; k++) {
    g.at[k] = cosine * v->at[k] - sine * turn->at[k];
    g.most[k] = fabs(cosine) * v->most[k] + fabs(sine) * turn->most[k];
  }
  tighten(radius, &g);
  low = fabs(g.at[0]) - radius * g.most[1];
  return bound_of(hypot(g.most[1], g.most[0] * rate),
                  low > 0 ? g.most[0] * g.most[0] * rate / low
                          : (double)INFINITY);
}

/* Away from rest. */
static double bound_moving(const struct ph_spherical *segment, double distance,
                           double u0, double u1) {
  const struct block block = block_of(segment, u0, u1);
  struct vector s, first, second;
  struct series w, v, k, turn;
  if (!curve_over(&block, ORDER, segment, &s)) {
    return (double)INFINITY;
  }
  first = derivative(&s);
  second = derivative(&first);
  w = square(block.radius, &first);
  v = root(block.radius, &w);
  k = triple(block.radius, &s, &first, &second);
  turn = quotient(block.radius, &k, &w);
  return bound_parallel(block.radius, distance, &v, &turn);
}

/* (7), on the least block up to an end at rest that has u in it. */
static double bound_rest(const struct ph_spherical *segment, bool start,
                         double distance, double u) {
  const struct block block =
      start ? block_of(segment, 0, u) : block_of(segment, u, 1);
  const double t = start ? block.middle : block.middle - 1;
  struct vector s, first, v, slope;
  struct series w, k, turn, speed;
  if (!curve_over(&block, ORDER, segment, &s)) {
    return (double)INFINITY;
  }
  first = derivative(&s);
  v.n = first.n - 1;
  for (size_t n = 0; n <= v.n; n++) {
    ph_vec3 at = n > 0 ? ph_vec3_sub(first.at[n], v.at[n - 1]) : first.at[0];
    v.at[n] = ph_vec3_scale(1 / t, at);
    v.most[n] = first.most[n + 1];
  }
  tighten_vector(block.radius, &v);
  slope = derivative(&v);
  w = square(block.radius, &v);
  k = triple(block.radius, &s, &v, &slope);
  turn = quotient(block.radius, &k, &w);
  speed = root(block.radius, &w);
  speed = times(block.radius, &block.tau[start ? 1 : 0], &speed);
  return bound_parallel(block.radius, distance, &speed, &turn);
}

static bool is_same(ph_vec3 a, ph_vec3 b) {
  return ph_s2_angle(a, b) <= 0;
}

double ph_chord_bound_spherical(const struct ph_spherical *segment,
                                double distance, double u0, double u1) {
  const ph_vec3 *p = segment->p;
  const bool start = is_same(p[0], p[1]), end = is_same(p[2], p[3]);
  double bound;
  if (!(fabs(distance) > 0)) {
    return bound_curve(segment, u0, u1);
  }
  if (is_same(p[1], p[2]) && (start || end)) {
    /* on a great circle: its parallel is S cos d but for a constant */
    return fabs(cos(distance)) * bound_curve(segment, u0, u1);
  }
  bound = (start && u0 <= 0) || (end && u1 >= 1)
              ? (double)INFINITY
              : bound_moving(segment, distance, u0, u1);
  if (start && u1 <= 0.5) {
    bound = fmin(bound, bound_rest(segment, true, distance, u1));
  }
  if (end && u0 >= 0.5) {
    bound = fmin(bound, bound_rest(segment, false, distance, u0));
  }
  return bound;
}
