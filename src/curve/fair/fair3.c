/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Fairness of spatial segments (see fair3.h).
 *
 * With v = S1 / (S0 + S1) in [0,1] in the place of u (kernel/atph.h),
 *
 *   A = B / q,  B(v) = a0 (1-v)^2 + 2 c a1 v (1-v) + a2 v^2
 *   q(v) = 1 - 2 (1-c) v (1-v),  ds = |B|^2 sinc / q^3 dv              (1)
 *
 * as S0^2 + 2 c S0 S1 + S1^2 = 1 and S0 S1' - S0' S1 = 1/sinc: an ATPH segment
 * has the tangents of a PH quintic, and everything is rational in v.  With
 * sigma = |B|^2, W = vect(B* B') = x i + p j + q k and z = p + i q for this
 * quintic, and primes for derivatives by v,
 *
 *   kappa = q^3/sinc 2 |z| / sigma^2                                    (2)
 *   tau   = q^3/sinc T / sigma,  T = (arg z)' + 2 x / sigma             (3)
 *
 * and the integrands by v are, up to powers of sinc,
 *
 *   4 q^3 |z|^2 / sigma^3                                               (4)
 *   4 q^9 |z|^2 / sigma^5 (3 q'/q + (log |z|)' - 2 sigma'/sigma)^2      (5)
 *   q^9 / sigma^3 ((3 q'/q - sigma'/sigma) T + T')^2                    (6)
 *
 * Places are written as y = v - 1/2.  z is of degree 2, and the interval
 * is cut at its zeros, near to which (5) and (6) change fast.  The poles of all
 * integrands are known: the zeros of sigma, z and its conjugate.  One that is
 * nearer to a node than a few times the next node may be seen by none:
 * such an interval is halved whatever the rules say.  At a distance d from a
 * node, however complex, sigma is not 0 as long as
 *
 *   |B'| d + |B''/2| d^2 < (sqrt 2 - 1) |B|                             (7)
 *
 * since its terms besides |B|^2 are at most 2 |B| times that and its square,
 * and z is not 0 as long as |z'| d + |z''/2| d^2 < |z|.  At a zero that
 * is real, an inflection, z changes its sign and arg z jumps, while (arg z)' is
 * that of the other factor of z.  16 nodes on an interval are compared with 16
 * on either half, which are kept.
 *
 * Every interval has polynomials of its own, in the distance from its middle:
 * where B is small, those of the whole are small differences.
 */
#include "curve/fair/fair3.h"

#include <float.h>
#include <math.h>

/* Halvings, and intervals of one segment, at most. */
enum { DEPTH_MAX = 50, PARTS_MAX = 1024, SUMS = 3 };

/* How far the two values may differ: the halves, which are kept, are nearer to
 * the integral by an order or more. */
static const double AGREE = 3e-10;
/* Poles are looked for up to so many times the distance of nodes: beyond that,
 * values do not agree by accident. */
static const double AWAY = 3;
/* Error of what is squared in units of its terms. */
static const double ROUNDING = 16 * DBL_EPSILON;
/* Out of the plane, or off the line: less than this is rounding. */
static const double FLAT = 1e-13;
/* A zero of z farther from the interval does not cut it; a real one, if it is
 * double, is nearer to it than that. */
static const double NEAR = 0.3, INFLECTION = 1e-6;
/* There z is rounding of its products: |kappa| of a curve that passes a
 * straight place at a small distance turns within that, which counts. */
static const double PASSING = 32 * DBL_EPSILON;
/* Half the square of sqrt 2 - 1, and of 1: (x + y)^2 <= 2 (x^2 + y^2). */
static const double CLEAR_SIGMA = 0.0857, CLEAR_Z = 0.5;

/* A segment: B at either end, with its derivative, and half the second one. */
struct form {
  ph_quat end[2], first[2], second;
  double q0, q2;      /* q = q0 + q2 y^2 */
  bool twists;        /* the torsion counts */
  bool inflected;     /* z has a real zero on the interval */
  ph_cplx zero;       /* then: the other one */
  size_t parts;       /* intervals so far */
  double total[SUMS]; /* of what is done */
};

/* An interval, and the polynomials in x = y - middle: of B, of W, and of
 * Im(conj(z) z'). */
struct part {
  double middle, length;
  ph_quat b[3];
  ph_quat w[3];
  double nu[3];
  double b2, z2;  /* |B''/2|^2, |z''/2|^2 */
  double b2_size; /* of the terms of B, and of what
                   * it is found from, squared */
  double z2_size; /* of the products that z is made of, squared */
};

/* An integral of squares, and the same integral of their terms. */
struct square {
  double value, terms;
};

struct squares {
  struct square of[SUMS];
  bool clear; /* no pole is near to a node */
};

static ph_cplx z_of(ph_quat w) {
  return ph_cplx_of(w.p, w.q);
}

static struct form form_of(const struct ph_atph *space, const ph_quat a[3]) {
  ph_quat middle = ph_quat_scale(space->c, a[1]);
  ph_quat first = ph_quat_sub(middle, a[0]), last = ph_quat_sub(a[2], middle);
  struct form f = {.end = {a[0], a[2]},
                   .first = {ph_quat_scale(2, first), ph_quat_scale(2, last)},
                   .second = ph_quat_sub(last, first),
                   .q0 = 0.5 * (1 + space->c),
                   .q2 = 2 * (1 - space->c)};
  return f;
}

/* From the nearer end on, so that next to an end at which B is small it is as
 * exact as it is there. */
static void set_part(struct part *p, const struct form *f, double y0,
                     double y1) {
  double middle = 0.5 * (y0 + y1), length = y1 - y0,
         h2 = 0.25 * length * length;
  size_t end = middle > 0;
  double x = end ? middle - 0.5 : middle + 0.5, size[3], slope;
  ph_cplx z[3];
  p->middle = middle;
  p->length = length;
  p->b[2] = f->second;
  p->b[1] = ph_quat_add(f->first[end], ph_quat_scale(2 * x, f->second));
  p->b[0] = ph_quat_add(
      f->end[end], ph_quat_scale(x, ph_quat_add(f->first[end],
                                                ph_quat_scale(x, f->second))));
  p->w[0] = ph_quat_between(p->b[0], p->b[1]);
  p->w[1] = ph_quat_scale(2, ph_quat_between(p->b[0], p->b[2]));
  p->w[2] = ph_quat_between(p->b[1], p->b[2]);
  for (size_t i = 0; i < 3; i++) {
    z[i] = z_of(p->w[i]);
    size[i] = ph_quat_dot(p->b[i], p->b[i]);
  }
  p->nu[0] = ph_cplx_cross(z[0], z[1]);
  p->nu[1] = 2 * ph_cplx_cross(z[0], z[2]);
  p->nu[2] = ph_cplx_cross(z[1], z[2]);
  p->b2 = size[2];
  p->z2 = ph_cplx_norm2(z[2]);
  slope = ph_quat_dot(f->first[end], f->first[end]) + 4 * x * x * size[2];
  p->b2_size = ph_quat_dot(f->end[end], f->end[end]) + x * x * slope +
               h2 * (size[1] + h2 * size[2]);
  p->z2_size = p->b2_size * (slope + 4 * h2 * size[2]);
}

/* The values at one node that the integrands are made of. */
struct node {
  double per_sigma, ds;  /* 1/sigma, sigma'/sigma */
  double z2, per_z2, dz; /* |z|^2, 1/|z|^2, (log |z|)' */
  double x, x1;          /* x, x' */
  double turn, turn1;    /* (arg z)' and its derivative */
  double turn1_terms;    /* what turn1 is a difference of */
  double q3, dq;         /* q^3, q'/q */
  double sigma, b1, z1;  /* sigma, |B'|^2, |z'|^2 */
  double other2;         /* of an inflected one, the square of the distance from
                            the other zero */
  double noise;          /* squared, what enlarges rounding */
};

static inline double at(double c0, double c1, double c2, double y) {
  return c0 + y * (c1 + y * c2);
}

static inline struct node node_at(const struct form *f, const struct part *on,
                                  double x) {
  const ph_quat *b = on->b, *w = on->w;
  double u = at(b[0].u, b[1].u, b[2].u, x), v = at(b[0].v, b[1].v, b[2].v, x);
  double p = at(b[0].p, b[1].p, b[2].p, x), r = at(b[0].q, b[1].q, b[2].q, x);
  double re = at(w[0].p, w[1].p, w[2].p, x), im = at(w[0].q, w[1].q, w[2].q, x);
  double y = on->middle + x, x2 = 2 * x, q = f->q0 + f->q2 * y * y;
  double sigma = u * u + v * v + p * p + r * r;
  double u1 = b[1].u + x2 * b[2].u, v1 = b[1].v + x2 * b[2].v;
  double p1 = b[1].p + x2 * b[2].p, r1 = b[1].q + x2 * b[2].q;
  double re1 = w[1].p + x2 * w[2].p, im1 = w[1].q + x2 * w[2].q;
  double half = u * u1 + v * v1 + p * p1 + r * r1;
  struct node n;
  n.per_sigma = 1 / sigma;
  n.ds = 2 * half * n.per_sigma;
  n.z2 = re * re + im * im;
  n.per_z2 = 1 / n.z2;
  n.dz = (re * re1 + im * im1) * n.per_z2;
  n.sigma = sigma;
  n.b1 = u1 * u1 + v1 * v1 + p1 * p1 + r1 * r1;
  n.z1 = re1 * re1 + im1 * im1;
  n.other2 = 0;
  n.x = at(w[0].v, w[1].v, w[2].v, x);
  n.x1 = w[1].v + x2 * w[2].v;
  if (f->inflected) {
    double away = y - f->zero.re;
    double per;
    n.other2 = away * away + f->zero.im * f->zero.im;
    per = 1 / n.other2;
    n.turn = f->zero.im * per;
    n.turn1 = -2 * away * n.turn * per;
    n.turn1_terms = fabs(n.turn1);
  } else {
    double part = (on->nu[1] + x2 * on->nu[2]) * n.per_z2;
    n.turn = at(on->nu[0], on->nu[1], on->nu[2], x) * n.per_z2;
    n.turn1 = part - 2 * n.turn * n.dz;
    n.turn1_terms = fabs(part) + fabs(2 * n.turn * n.dz);
  }
  n.q3 = q * q * q;
  n.dq = 2 * f->q2 * y / q;
  n.noise = on->b2_size * n.per_sigma + on->z2_size * n.per_z2;
  return n;
}

/* (7) */
static inline bool is_clear(const struct form *f, const struct part *on,
                            const struct node *n, double d) {
  double d2 = d * d;
  return d2 * (n->b1 + d2 * on->b2) < CLEAR_SIGMA * n->sigma &&
         (f->inflected ? d2 < n->other2
                       : d2 * (n->z1 + d2 * on->z2) < CLEAR_Z * n->z2);
}

/* Up to where node i is the nearest one, in [0,1]. */
static inline double reach_of(const struct ph_quad *rule, size_t i) {
  const double *x = rule->node;
  double left = i > 0 ? 0.5 * (x[i] - x[i - 1]) : x[0];
  double right = i + 1 < rule->n ? 0.5 * (x[i + 1] - x[i]) : 1 - x[i];
  return left > right ? left : right;
}

static inline void add_square(struct square *sum, double weight, double x,
                              double terms) {
  sum->value += weight * x * x;
  sum->terms += weight * terms;
}

/* (6) */
static inline void add_twisting(struct square *sum, const struct node *n,
                                double weight) {
  double twist = 2 * n->x * n->per_sigma, twist1 = 2 * n->x1 * n->per_sigma;
  double slope = 3 * n->dq - n->ds;
  double terms = (fabs(n->turn) + fabs(twist)) * (fabs(slope) + fabs(n->ds)) +
                 n->turn1_terms + fabs(twist1);
  add_square(sum, weight,
             slope * (n->turn + twist) + n->turn1 + (twist1 - twist * n->ds),
             n->noise * terms * terms);
}

/* looks: whether poles are looked for, up to the first that is found. */
static struct squares integrate(const struct form *f, const struct part *on,
                                const struct ph_quad *rule, bool looks) {
  struct squares sum = {{{0, 0}, {0, 0}, {0, 0}}, true};
  for (size_t i = 0; i < rule->n; i++) {
    struct node n = node_at(f, on, on->length * (rule->node[i] - 0.5));
    double weight = on->length * rule->weight[i] * n.q3;
    double per3 = n.per_sigma * n.per_sigma * n.per_sigma;
    double slope = 3 * n.dq + n.dz - 2 * n.ds;
    double terms = fabs(3 * n.dq) + fabs(n.dz) + fabs(2 * n.ds);
    double factor = 4 * weight * per3 * n.z2;
    if (looks && sum.clear) {
      sum.clear = is_clear(f, on, &n, AWAY * on->length * reach_of(rule, i));
    }
    add_square(&sum.of[0], factor, 1, n.noise);
    weight *= n.q3 * n.q3 * per3;
    factor = 4 * weight * n.z2 * n.per_sigma * n.per_sigma;
    add_square(&sum.of[1], factor, slope, n.noise * terms * terms);
    if (f->twists) {
      add_twisting(&sum.of[2], &n, weight);
    }
  }
  return sum;
}

/* Whether two values agree, or what they differ by is rounding (of a square
 * that is nearly nothing), or is lost in the sum so far. */
static bool agree(const struct square *a, const struct square *b,
                  double total) {
  double difference = fabs(a->value - b->value);
  double noise = ROUNDING * sqrt(b->terms);
  return difference <= AGREE * (b->value + total) + 2 * noise * sqrt(b->value) +
                           noise * noise;
}

/* Halves an interval until the halves agree with the whole.  What still does
 * not when it cannot be halved any more has no value. */
static void refine(struct form *f, const struct ph_quad *rule, double y0,
                   double y1, const struct squares *whole, int depth) {
  double middle = 0.5 * (y0 + y1);
  struct part half;
  struct squares left, right, sum;
  bool last = depth == DEPTH_MAX || f->parts >= PARTS_MAX, done = true;
  set_part(&half, f, y0, middle);
  left = integrate(f, &half, rule, !whole->clear);
  set_part(&half, f, middle, y1);
  right = integrate(f, &half, rule, !whole->clear);
  sum.clear = left.clear && right.clear;
  f->parts++;
  for (size_t i = 0; i < SUMS; i++) {
    struct square *of = &sum.of[i];
    of->value = left.of[i].value + right.of[i].value;
    of->terms = left.of[i].terms + right.of[i].terms;
    if (!(sum.clear && agree(&whole->of[i], of, f->total[i]))) {
      of->value = last || !isfinite(of->value) ? HUGE_VAL : of->value;
      done = false;
    }
  }
  if (done || last) {
    for (size_t i = 0; i < SUMS; i++) {
      f->total[i] += sum.of[i].value;
    }
    return;
  }
  refine(f, rule, y0, middle, &left, depth + 1);
  refine(f, rule, middle, y1, &right, depth + 1);
}

static void add_interval(struct form *f, const struct ph_fair3_rules *rules,
                         double y0, double y1) {
  struct part on;
  struct squares whole;
  set_part(&on, f, y0, y1);
  whole = integrate(f, &on, &rules->rule, true);
  refine(f, &rules->rule, y0, y1, &whole, 0);
}

/* The zeros of z, those of largest modulus first; 1e300 is as good as none. */
static void zeros_of(const struct part *whole, ph_cplx zero[2]) {
  ph_cplx z0 = z_of(whole->w[0]), z2 = z_of(whole->w[2]);
  ph_cplx half = ph_cplx_scale(-0.5, z_of(whole->w[1])), root, sum;
  root =
      ph_cplx_sqrt(ph_cplx_sub(ph_cplx_mul(half, half), ph_cplx_mul(z0, z2)));
  if (ph_cplx_dot(half, root) < 0) {
    root = ph_cplx_scale(-1, root);
  }
  sum = ph_cplx_add(half, root); /* of two that do not cancel */
  zero[0] = ph_cplx_mul(sum, ph_cplx_inverse(z2));
  zero[1] = ph_cplx_mul(z0, ph_cplx_inverse(sum));
}

/* Whether the curve is a line: z is rounding. */
static bool is_straight(const struct part *whole) {
  double size = 0;
  for (size_t i = 0; i < 3; i++) {
    size += ph_cplx_norm2(z_of(whole->w[i]));
  }
  return sqrt(size) <= FLAT * whole->b2_size;
}

/* Whether a zero of z is real and on the segment: z is rounding there. */
static bool is_inflection(const struct part *whole, ph_cplx zero) {
  double y = zero.re;
  double re = at(whole->w[0].p, whole->w[1].p, whole->w[2].p, y);
  double im = at(whole->w[0].q, whole->w[1].q, whole->w[2].q, y);
  return fabs(y) < 0.5 && fabs(zero.im) <= INFLECTION &&
         hypot(re, im) <= PASSING * whole->b2_size;
}

/* Zero i of z is real and on the interval.  Where the other one is real, too,
 * or there is none, arg z only jumps. */
static void set_inflection(struct form *f, const struct part *whole,
                           const ph_cplx zero[2], size_t i) {
  ph_cplx other = zero[1 - i];
  bool turns = !is_inflection(whole, other) && fabs(other.im) > 0 &&
               isfinite(ph_cplx_norm2(other));
  f->zero = turns ? other : ph_cplx_of(1, 0);
  f->inflected = true;
}

/* Whether the curve lies in a plane: all products of coefficients of B do. */
static bool is_plane(const ph_quat b[3]) {
  ph_vec3 g[6], longest = {0, 0, 0}, normal = {0, 0, 0};
  double size = 0, most = 0;
  size_t n = 0;
  for (size_t i = 0; i < 3; i++) {
    for (size_t j = i; j < 3; j++, n++) {
      g[n] = ph_quat_i(b[i], b[j]);
      if (ph_vec3_dot(g[n], g[n]) > size) {
        longest = g[n];
        size = ph_vec3_dot(g[n], g[n]);
      }
    }
  }
  for (size_t i = 0; i < 6; i++) {
    ph_vec3 cross = ph_vec3_cross(longest, g[i]);
    if (ph_vec3_dot(cross, cross) > most) {
      normal = cross;
      most = ph_vec3_dot(cross, cross);
    }
  }
  for (size_t i = 0; i < 6; i++) {
    if (fabs(ph_vec3_dot(normal, g[i])) > FLAT * sqrt(size * most)) {
      return false;
    }
  }
  return true;
}

bool ph_fair3_begin(struct ph_fair3_rules *rules) {
  return ph_quad_gauss(&rules->rule, 16);
}

struct ph_fair3 ph_fair3_of(const struct ph_fair3_rules *rules,
                            const struct ph_atph *space, const ph_quat a[3]) {
  struct ph_fair3 fair = {0, 0, 0, false};
  struct form f = form_of(space, a);
  struct part whole;
  ph_cplx zero[2];
  double cut[4] = {-0.5, 0, 0, 0.5}, per = 1 / space->sinc;
  size_t n = 1;
  set_part(&whole, &f, -0.5, 0.5);
  if (is_straight(&whole)) {
    return fair;
  }
  f.twists = !is_plane(whole.b);
  zeros_of(&whole, zero);
  for (size_t i = 0; i < 2; i++) {
    if (fabs(zero[i].re) < 0.5 && fabs(zero[i].im) < NEAR) {
      if (is_inflection(&whole, zero[i])) {
        set_inflection(&f, &whole, zero, i);
      }
      cut[n++] = zero[i].re;
    }
  }
  if (n == 3 && cut[1] > cut[2]) {
    double swap = cut[1];
    cut[1] = cut[2];
    cut[2] = swap;
  }
  cut[n] = 0.5;
  for (size_t i = 0; i < n; i++) {
    add_interval(&f, rules, cut[i], cut[i + 1]);
  }
  fair.bending = per * f.total[0];
  fair.varying = per * per * per * f.total[1];
  fair.twisting = per * per * per * f.total[2];
  fair.inflected = f.inflected && f.twists;
  return fair;
}

double ph_fair3_functional(const struct ph_fair3 *fair, double length, int k) {
  double l3 = length * length * length;
  return k == 1   ? length * fair->bending
         : k == 2 ? l3 * fair->varying
                  : l3 * (fair->varying + fair->twisting);
}
