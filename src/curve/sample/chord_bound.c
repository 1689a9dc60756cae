/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * How far chords are from a curve (see chord_bound.h).
 *
 * The bounds (1)-(4):
 * Let s = |r'|, and let r'' = s' T + (a vector normal to T), of length b.
 * Between v and v + h, let e be a unit vector normal to the chord; y = (r -
 * chord) . e vanishes at both ends.
 * (a) y'' = r'' . e, and |y| <= max|y''| h^2 / 8: (1).  It goes for every e,
 *     so that r(u) and the place u of the chord are that near.
 * (b) If s > 0, arc length is a parameter; |d^2 r / ds^2| = b / s^2 and there
 *     are no more than h max s of it: (2).
 * (c) Let f = y', whose mean is 0; with t = (x - v) / h and P = max|f'|,
 *       |f(x)| = |mean over x' of f(x) - f(x')| <= P h (t^2 + (1-t)^2) / 2.
 * (d) r' . e = s T . e, so that f' = r'' . e = (s' / s) f + (normal part) . e.
 *     With q = max|s'| / min s and b now its maximum, P <= b + q P h / 2.
 * (e) y = -(integral of G f') for Green's function G >= 0 of y'' on [v,v+h];
 *     that of G is at most h^2 / 8, and of G (t^2 + (1-t)^2) / 2 at most
 *     7 h^2 / 192, both for the middle: the latter is, at t, h^2 t (1-t)
 *     (2 - t (1-t)) / 12.  So, by (c) and (d), for q h < 2,
 *       |y| <= h^2 / 8 (b + (7/24) q h P),  P <= b / (1 - q h / 2)
 * (f) That is the distance from the chord, and every place of the chord is
 *     that near, if the curve does not go back along it: if it turns by no
 *     more than a quarter, in all, no two tangents make an obtuse angle, nor
 *     does one with the chord, their mean.  Then
 *       M = b (1 + 7 q h / (24 - 12 q h)).                               (3)
 * (g) Likewise |T . e| is at most the angle by which T turns, so that P <= b +
 *     max|s'| (that angle), and
 *       M = b + max|s'| (that angle),                                    (4)
 *     also where s = 0, if T goes on as it was, or if s = 0 at an end only.
 * All of these grow with the interval: they hold for the chords within it.
 *
 * What goes into them:
 * (h) Restricted to [u0,u1], h = u1 - u0, with the part's S0, S1 and c =
 *     cos(a h / 2): 1 = S0^2 + 2 c S0 S1 + S1^2 [kernel/atph.h], a sum of what
 *     is not negative, so that a form with coefficients f0, 2 c f1, f2 is in
 *     the hull of f0, f1 and f2.  Likewise for products of two such, with
 *     (1, 4c, 4c^2 + 2, 4c, 1).
 * (i) S0' = -(c S0 + S1) / sinc, S1' = (S0 + c S1) / sinc [of a h], so that
 *     the derivative of such a form is one, with f1 = (f0 + f2) / (2 c^2), f0
 *     and f2 its values at u0 and u1: A' and W', where W = vect(A* A')
 *     [curve/segment/seg3.h].  W has vect(A(u0)* f1) in the middle, f1 of A'.
 * (j) s = sigma = |A|^2, s' = 2 A . A', r'' = 2 vect(A i A'*), b = 2 |p + i q|
 *     where W = x i + p j + q k; the tangent turns at the rate b / s.
 * (k) With X, P, Q = 2 x, 2 p, 2 q over sigma, e1' = Q e2 - P e3, e2' = X e3 -
 *     Q e1, e3' = P e1 - X e2; those of e2, e3 taken for e3, -e2 are X, Q, -P.
 *     For o = r + d e2, g = sigma - d Q and w = d X,
 *       o'  = g e1 + w e3,  s^2 = g^2 + w^2,  s' = (g g' + w w') / s
 *       o'' = (g' + w P) e1 + (2 q - d (Q^2 + X^2)) e2 + (w' - g P) e3
 *     and b is made of the part along e2 and of s P + (w g' - g w') / s.  In
 *     the plane w = P = 0, T = +-e1 turns at the rate |Q|, and g may serve for
 *     s while it has one sign.
 * (l) Of a Bezier curve, s is at least r' . e for any unit vector e, and |s'|
 *     and b are no more than |r' . r''| and |r' x r''| over that: quotients
 *     of polynomials of the same degree.
 */
#include "curve/sample/chord_bound.h"

#include "kernel/form.h"
#include "kernel/interval.h"

#include <assert.h>
#include <stdbool.h>
#include <string.h>

static const double QUARTER = 1.5707963267948966; /* pi / 2, less rounding */

/* Errors of what is computed here: some eps of the terms. */
static const double ROUNDING = 8 * DBL_EPSILON;

/* The largest degree of a form. */
enum { DEGREE_FORM = 10 };

/* ---- the bounds ---------------------------------------------------------- */

/* Over the interval. */
struct motion {
  double h;
  double second;           /* greatest |r''| */
  double normal_acc;       /* greatest normal part of it */
  double slope;            /* greatest |s'| */
  double slowest, fastest; /* of s */
  bool forward;            /* T does not jump where s = 0, if that is anywhere
                              but at an end */
  double turn;             /* angle by which T turns, at most */
};

static double lesser(double a, double b) {
  return a < b ? a : b;
}

/* The least of (1)-(4). */
static double bound_of(const struct motion *m) {
  double qh = m->h * m->slope / m->slowest, bound = m->second;
  double ratio = m->fastest / m->slowest;
  if (m->slowest > 0) {
    bound = lesser(m->normal_acc * ratio * ratio, bound);
  }
  if (m->slowest > 0 && m->turn <= QUARTER && qh < 2) {
    bound = lesser(m->normal_acc * (1 + 7 * qh / (24 - 12 * qh)), bound);
  }
  if (m->forward && m->turn <= QUARTER) {
    bound = lesser(m->normal_acc + m->slope * m->turn, bound);
  }
  return bound >= 0 ? bound * (1 + ROUNDING) : (double)INFINITY;
}

/* ---- PH and ATPH segments ------------------------------------------------ */

/* A part of a segment, by coefficients as in (h); derivatives are by u. */
struct part {
  double h, c;
  ph_quat a[3]; /* A */
  ph_quat b[3]; /* A' */
  double error; /* of sums of products of these */
};

/* The coefficients of A i B* and A . B. */
struct product {
  ph_vec3 vector[5];
  double number[5];
};

static void multiply_at(struct product *product, size_t k, double s, ph_quat a,
                        ph_quat b) {
  product->vector[k] = ph_vec3_along(product->vector[k], s, ph_quat_i(a, b));
  product->number[k] += s * ph_quat_dot(a, b);
}

static struct product product_of(const ph_quat a[3], const ph_quat b[3],
                                 double c) {
  const double weight[3] = {1, 2 * c, 1}, middle = 4 * c * c + 2;
  const double total[5] = {1, 4 * c, middle, 4 * c, 1};
  struct product product = {.number = {0}};
  for (size_t i = 0; i < 3; i++) {
    for (size_t j = 0; j < 3; j++) {
      multiply_at(&product, i + j, weight[i] * weight[j] / total[i + j], a[i],
                  b[j]);
    }
  }
  return product;
}

static double largest(const ph_quat a[3]) {
  double size = 0;
  for (size_t i = 0; i < 3; i++) {
    size = ph_range_greatest(size, ph_quat_abs(a[i]));
  }
  return size;
}

/* A derivative's coefficient between its values at the ends. */
static ph_quat between(ph_quat f0, ph_quat f2, double c) {
  return ph_quat_scale(0.5 / (c * c), ph_quat_add(f0, f2));
}

/* out  first, last  A, A', ... at the ends */
static struct part part_of(const struct ph_seg3 *seg, double u0, double u1,
                           ph_quat *first, ph_quat *last, size_t orders) {
  struct part part = {.h = u1 - u0};
  double half = seg->space.angle * part.h / 2, sinc, size;
  ph_seg3_jet(seg, u0, first, orders);
  ph_seg3_jet(seg, u1, last, orders);
  sinc = half > 1e-4 ? sin(half) / half : 1 - half * half / 6;
  part.c = cos(half);
  part.a[0] = first[0];
  part.a[1] = ph_quat_add(
      first[0], ph_quat_scale(part.h * sinc / (2 * part.c), first[1]));
  part.a[2] = last[0];
  part.b[0] = first[1];
  part.b[1] = between(first[1], last[1], part.c);
  part.b[2] = last[1];
  /* the terms of A' and A'' at its ends are at most some 40 |a| */
  size = largest(part.a) + largest(seg->a);
  part.error =
      ROUNDING * size * (largest(part.b) + 40 * size) / (part.c * part.c);
  return part;
}

/* |p + i q| of W. */
static double across(ph_quat w) {
  return sqrt(w.p * w.p + w.q * w.q);
}

double ph_chord_bound_ph(const struct ph_seg3 *seg, double u0, double u1) {
  ph_quat first[2], last[2];
  struct part part = part_of(seg, u0, u1, first, last, 2);
  struct product speed = product_of(part.a, part.a, part.c);
  struct product second = product_of(part.a, part.b, part.c);
  struct ph_range sigma = ph_range_of(speed.number, 5, part.error);
  struct ph_range slope = ph_range_of(second.number, 5, part.error);
  double normal_acc, longest = 0;
  struct motion m;
  for (size_t k = 0; k < 5; k++) {
    longest = ph_range_greatest(longest, ph_vec3_abs(second.vector[k]));
  }
  normal_acc = ph_range_greatest(
      across(ph_quat_between(part.a[0], part.b[0])),
      ph_range_greatest(across(ph_quat_between(part.a[0], part.b[1])),
                        across(ph_quat_between(part.a[2], part.b[2]))));
  m = (struct motion){.h = part.h,
                      .second = 2 * (longest + part.error),
                      .normal_acc = 2 * (normal_acc + part.error),
                      .slope = 2 * ph_range_farthest(slope),
                      .slowest = sigma.low,
                      .fastest = sigma.high,
                      .forward = sigma.low > 0};
  m.turn = m.h * m.normal_acc / m.slowest;
  return bound_of(&m);
}

/* ---- offsets ------------------------------------------------------------- */

/* The range of a quotient of forms, a mean of those of their coefficients as
 * the divisor's are positive; the quotients are known up to an error. */
static struct ph_range quotient(const double *f, const double *divisor,
                                size_t degree, double error) {
  double ratio[DEGREE_FORM + 1];
  for (size_t k = 0; k <= degree; k++) {
    ratio[k] = f[k] / divisor[k];
  }
  return ph_range_of(ratio, degree + 1, error);
}

/* What a part is, in the basis S0^(n-k) S1^k. */
struct forms {
  double one[3];
  double sigma[5], square[9];
  double x[3], q[3];
};

static struct forms forms_of(const struct part *part,
                             const struct product *speed, const ph_quat w[3]) {
  const double c = part->c, middle = 2 * c;
  const double total[5] = {1, 4 * c, 4 * c * c + 2, 4 * c, 1};
  struct forms forms = {.one = {1, middle, 1},
                        .x = {w[0].v, middle * w[1].v, w[2].v},
                        .q = {w[0].q, middle * w[1].q, w[2].q}};
  for (size_t k = 0; k < 5; k++) {
    forms.sigma[k] = total[k] * speed->number[k];
  }
  ph_form_multiply(forms.sigma, 4, forms.sigma, 4, forms.square);
  return forms;
}

/* f times `one`, so many times; it has room for that. */
static void raise_form(const struct forms *forms, double *f, size_t degree,
                       size_t times) {
  double raised[DEGREE_FORM + 1];
  for (; times > 0; times--, degree += 2) {
    ph_form_multiply(f, degree, forms->one, 2, raised);
    memcpy(f, raised, (degree + 3) * sizeof *f);
  }
}

/* 2 f / sigma, for a component f of W or W'. */
static struct ph_range rate_of(const struct forms *forms, double f0, double f1,
                               double f2, struct ph_range sigma, double error) {
  double f[5] = {2 * f0, 2 * forms->one[1] * f1, 2 * f2};
  double size = 2 * fmax(fabs(f0), fmax(fabs(f1), fabs(f2)));
  raise_form(forms, f, 2, 1);
  return quotient(f, forms->sigma, 4,
                  (2 + size / sigma.low) * error / sigma.low);
}

/* X, P and Q of (k), or their derivatives. */
struct turning {
  struct ph_range x, p, q;
};

/* w[3] are coefficients of W, or of W', as in (i). */
static struct turning turning_of(const ph_quat w[3], const struct forms *forms,
                                 struct ph_range sigma, double error) {
  struct turning t = {rate_of(forms, w[0].v, w[1].v, w[2].v, sigma, error),
                      rate_of(forms, w[0].p, w[1].p, w[2].p, sigma, error),
                      rate_of(forms, w[0].q, w[1].q, w[2].q, sigma, error)};
  return t;
}

/* (f / sigma)' = f' / sigma - (f / sigma) (sigma' / sigma). */
static struct turning slopes_of(struct turning change, struct turning value,
                                struct ph_range log_slope) {
  struct turning t = {ph_range_sub(change.x, ph_range_mul(value.x, log_slope)),
                      ph_range_sub(change.p, ph_range_mul(value.p, log_slope)),
                      ph_range_sub(change.q, ph_range_mul(value.q, log_slope))};
  return t;
}

/* g of (k), and the part of o'' along e2; the error of g. */
struct aside {
  struct ph_range g, beside;
  double error;
};

/*
 * Each as one quotient: (sigma^2 - 2 d q) / sigma, and (2 q sigma^2 - 4 d (q^2
 * + x^2)) / sigma^2.  With rate >= |X| + |Q|, errors of the forms change them
 * by no more than their derivatives say; to these come some eps of the terms.
 */
static struct aside aside_of(const struct forms *forms, double d, double rate,
                             struct ph_range sigma, double error) {
  double g[9], beside[DEGREE_FORM + 1], squares[DEGREE_FORM + 1];
  double by[DEGREE_FORM + 1], other[5], scale = sigma.high / sigma.low;
  double wide = fabs(d) * rate, terms = 8 * ROUNDING * (sigma.high + wide);
  struct aside a;
  memcpy(g, forms->q, sizeof forms->q);
  raise_form(forms, g, 2, 3);
  for (size_t k = 0; k <= 8; k++) {
    g[k] = forms->square[k] - 2 * d * g[k];
  }
  memcpy(by, forms->sigma, sizeof forms->sigma);
  raise_form(forms, by, 4, 2);
  a.error = error * (1 + (2 * fabs(d) + wide) / sigma.low) + scale * terms;
  a.g = quotient(g, by, 8, a.error);
  ph_form_multiply(forms->q, 2, forms->q, 2, squares);
  ph_form_multiply(forms->x, 2, forms->x, 2, other);
  for (size_t k = 0; k <= 4; k++) {
    squares[k] += other[k];
  }
  raise_form(forms, squares, 4, 3);
  ph_form_multiply(forms->q, 2, forms->square, 8, beside);
  for (size_t k = 0; k <= DEGREE_FORM; k++) {
    beside[k] = 2 * beside[k] - 4 * d * squares[k];
  }
  memcpy(by, forms->square, sizeof forms->square);
  raise_form(forms, by, 8, 1);
  a.beside = quotient(beside, by, DEGREE_FORM,
                      error * (2 + 2 * wide * (2 + rate) / sigma.low) +
                          scale * scale * rate * terms);
  return a;
}

/* The motion of the offset, by (k). */
static struct motion offset_motion(const struct aside *aside, double d,
                                   double h, struct ph_range sigma1,
                                   struct turning t, struct turning t1) {
  struct ph_range g = aside->g, w = ph_range_scale(d, t.x);
  struct ph_range g1 = ph_range_sub(sigma1, ph_range_scale(d, t1.q));
  struct ph_range w1 = ph_range_scale(d, t1.x);
  struct ph_range along = ph_range_add(g1, ph_range_mul(w, t.p));
  struct ph_range above = ph_range_sub(w1, ph_range_mul(g, t.p));
  struct ph_range speed =
      ph_range_root(ph_range_add(ph_range_square(g), ph_range_square(w)));
  struct ph_range turned =
      ph_range_sub(ph_range_mul(w, g1), ph_range_mul(g, w1));
  struct ph_range slope =
      ph_range_add(ph_range_mul(g, g1), ph_range_mul(w, w1));
  double a = ph_range_farthest(along), b = ph_range_farthest(aside->beside);
  double c = ph_range_farthest(above), normal, plane = sqrt(a * a + c * c);
  struct motion m = {.h = h, .slowest = speed.low, .fastest = speed.high};
  normal = ph_range_farthest(
      ph_range_add(ph_range_mul(speed, t.p), ph_range_div(turned, speed)));
  m.second = sqrt(a * a + b * b + c * c);
  m.normal_acc = sqrt(b * b + normal * normal);
  m.slope =
      ph_range_least(plane, ph_range_farthest(ph_range_div(slope, speed)));
  m.forward = m.slowest > 0;
  m.turn = h * m.normal_acc / m.slowest;
  return m;
}

/* The same in the plane, where g has one sign if it has it but for rounding. */
static struct motion offset_motion2(const struct aside *aside, double d,
                                    double h, struct ph_range sigma1,
                                    struct turning t, struct turning t1) {
  struct ph_range g1 = ph_range_sub(sigma1, ph_range_scale(d, t1.q));
  double none = 2 * aside->error;
  struct motion m = {.h = h,
                     .normal_acc = ph_range_farthest(aside->beside),
                     .slope = ph_range_farthest(g1),
                     .slowest = ph_range_nearest(aside->g),
                     .fastest = ph_range_farthest(aside->g),
                     .forward = aside->g.low >= -none || aside->g.high <= none,
                     .turn = h * ph_range_farthest(t.q)};
  m.second = sqrt(m.normal_acc * m.normal_acc + m.slope * m.slope);
  return m;
}

/* W and W' of a part; along e3, as if that were e2.
 * ret  whether the curve is in the plane that e2 is in */
static bool bends_of(const struct part *part, const ph_quat *first,
                     const ph_quat *last, enum ph_normal normal, ph_quat w[3],
                     ph_quat w1[3]) {
  bool planar = true;
  for (size_t i = 0; i < 3; i++) {
    w[i] = ph_quat_between(part->a[i < 2 ? 0 : 2], part->b[i]);
  }
  w1[0] = ph_quat_between(first[0], first[2]);
  w1[2] = ph_quat_between(last[0], last[2]);
  w1[1] = between(w1[0], w1[2], part->c);
  for (size_t i = 0; i < 3; i++) {
    if (normal == PH_E3) {
      w[i] = ph_quat_of(w[i].u, w[i].v, w[i].q, -w[i].p);
      w1[i] = ph_quat_of(w1[i].u, w1[i].v, w1[i].q, -w1[i].p);
    }
    planar = planar && fabs(w[i].v) + fabs(w[i].p) <= 0;
  }
  return planar;
}

double ph_chord_bound_offset(const struct ph_seg3 *seg, enum ph_normal normal,
                             double distance, double u0, double u1) {
  ph_quat first[3], last[3], w[3], w1[3];
  struct part part = part_of(seg, u0, u1, first, last, 3);
  struct product speed = product_of(part.a, part.a, part.c);
  struct product second = product_of(part.a, part.b, part.c);
  struct ph_range sigma = ph_range_of(speed.number, 5, part.error);
  struct ph_range sigma1 =
      ph_range_scale(2, ph_range_of(second.number, 5, part.error));
  bool planar = bends_of(&part, first, last, normal, w, w1);
  struct forms forms = forms_of(&part, &speed, w);
  struct turning t, t1;
  struct aside aside;
  struct motion m;
  if (!(sigma.low > 0)) {
    return (double)INFINITY;
  }
  t = turning_of(w, &forms, sigma, part.error);
  t1 = slopes_of(turning_of(w1, &forms, sigma, part.error), t,
                 ph_range_div(sigma1, sigma));
  aside = aside_of(&forms, distance,
                   ph_range_farthest(t.x) + ph_range_farthest(t.q), sigma,
                   part.error);
  m = planar ? offset_motion2(&aside, distance, part.h, sigma1, t, t1)
             : offset_motion(&aside, distance, part.h, sigma1, t, t1);
  return bound_of(&m);
}

/* ---- Bezier curves ------------------------------------------------------- */

enum { DEGREE_MAX = 5, CROSS_MAX = 2 * DEGREE_MAX - 3 };

/* The control points of the part [u0,u1]. */
static void restrict_to(ph_vec3 *p, size_t degree, double u0, double u1) {
  /* The part beyond u1 is cut off, then that before u0, as u0 / u1. */
  double x = u1 > 0 ? u0 / u1 : 0;
  for (size_t m = 1; m <= degree; m++) {
    for (size_t i = degree; i >= m; i--) {
      p[i] =
          ph_vec3_add(ph_vec3_scale(1 - u1, p[i - 1]), ph_vec3_scale(u1, p[i]));
    }
  }
  for (size_t m = 1; m <= degree; m++) {
    for (size_t i = 0; i + m <= degree; i++) {
      p[i] =
          ph_vec3_add(ph_vec3_scale(1 - x, p[i]), ph_vec3_scale(x, p[i + 1]));
    }
  }
}

static double binomial(size_t n, size_t k) {
  double product = 1;
  for (size_t i = 1; i <= k; i++) {
    product = product * (double)(n - k + i) / (double)i;
  }
  return product;
}

/* Products of r' and r'', of degree 2 n - 3, beside those of r' . e and 1. */
struct bezier_products {
  ph_vec3 cross[CROSS_MAX + 1];
  double dot[CROSS_MAX + 1], along[CROSS_MAX + 1];
};

static struct bezier_products products_of(const ph_vec3 *first,
                                          const ph_vec3 *second, size_t degree,
                                          ph_vec3 e) {
  struct bezier_products products = {.dot = {0}};
  for (size_t i = 0; i < degree; i++) {
    for (size_t j = 0; j + 1 < degree; j++) {
      size_t k = i + j;
      double weight = binomial(degree - 1, i) * binomial(degree - 2, j) /
                      binomial(2 * degree - 3, k);
      products.cross[k] = ph_vec3_along(products.cross[k], weight,
                                        ph_vec3_cross(first[i], second[j]));
      products.dot[k] += weight * ph_vec3_dot(first[i], second[j]);
      products.along[k] += weight * ph_vec3_dot(first[i], e);
    }
  }
  return products;
}

/* r' . e in the direction e of the chord is no more than s; |r' x r''| and r' .
 * r'' over it are means of quotients of coefficients, if all are positive. */
static struct motion bezier_motion(const ph_vec3 *first, const ph_vec3 *second,
                                   size_t degree, double error) {
  struct motion m = {.slowest = (double)INFINITY};
  struct bezier_products products;
  ph_vec3 e = {0, 0, 0};
  for (size_t i = 0; i < degree; i++) {
    e = ph_vec3_add(e, first[i]);
    m.fastest = ph_range_greatest(m.fastest, ph_vec3_abs(first[i]) + error);
  }
  e = ph_vec3_scale(1 / ph_vec3_abs(e), e);
  products = products_of(first, second, degree, e);
  for (size_t i = 0; i < degree; i++) {
    m.slowest = ph_range_least(m.slowest, ph_vec3_dot(first[i], e) - error);
  }
  for (size_t j = 0; j + 1 < degree; j++) {
    m.second = ph_range_greatest(m.second, ph_vec3_abs(second[j]) + error);
  }
  for (size_t k = 0; k + 2 < 2 * degree; k++) {
    double along = products.along[k] - error, wide = error * m.fastest;
    double normal_acc = (ph_vec3_abs(products.cross[k]) + wide) / along;
    double slope = (fabs(products.dot[k]) + wide) / along;
    m.normal_acc = ph_range_greatest(m.normal_acc, normal_acc);
    m.slope = ph_range_greatest(m.slope, slope);
  }
  return m;
}

double ph_chord_bound_bezier(const ph_vec3 *p, size_t degree, double u0,
                             double u1) {
  ph_vec3 first[DEGREE_MAX], second[DEGREE_MAX];
  double size = 0;
  struct motion m;
  assert(degree <= DEGREE_MAX);
  if (degree < 2) {
    return 0;
  }
  for (size_t i = 0; i < degree; i++) {
    first[i] = ph_vec3_scale((double)degree, ph_vec3_sub(p[i + 1], p[i]));
    size = ph_range_greatest(size, ph_vec3_abs(first[i]));
  }
  for (size_t i = 0; i + 1 < degree; i++) {
    second[i] = ph_vec3_scale((double)(degree - 1),
                              ph_vec3_sub(first[i + 1], first[i]));
  }
  restrict_to(first, degree - 1, u0, u1);
  restrict_to(second, degree - 2, u0, u1);
  m = bezier_motion(first, second, degree, 4 * ROUNDING * size);
  m.h = u1 - u0;
  m.forward = m.slowest > 0;
  m.turn = m.h * m.normal_acc / m.slowest;
  return bound_of(&m);
}
