/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Measuring and choosing fits of Tschirnhausen cubics (see tc.h).
 *
 * "Agree to 1e-9" is not transitive.  So the one of least energy says which
 * others agree with it, of these the shortest says which agree in length, and
 * of those the first is best; the second best is the best of the rest.
 */
#include "solve/tc/tc.h"

#include "curve/cross/tc_simple.h"
#include "kernel/pi.h"

#include <float.h>

static const double AGREE = 1e-9;

void ph_tc_fit_measure(struct ph_tc_fit *fit) {
  fit->regular = true;
  fit->loops = 0;
  fit->simple = false;
  fit->length = 0;
  fit->energy = 0;
  for (size_t i = 0; i < fit->n; i++) {
    fit->regular = fit->regular && ph_tc_is_regular(&fit->tc[i]);
    fit->loops += ph_tc_has_loop(&fit->tc[i]);
    fit->length += ph_tc_length(&fit->tc[i]);
    fit->energy += ph_tc_energy(&fit->tc[i]);
  }
}

bool ph_tc_fit_test(struct ph_tc_fit *fit) {
  fit->simple = fit->loops == 0 && ph_tc_is_simple(fit->tc, fit->n);
  return fit->simple;
}

/* ---- the best of some --------------------------------------------------- */

/* Which fits may be chosen; irregular ones never. */
typedef bool admit(struct ph_tc_fit *fit);

static bool admit_simple(struct ph_tc_fit *fit) {
  return fit->simple || ph_tc_fit_test(fit);
}

static bool admit_tested(struct ph_tc_fit *fit) {
  return fit->simple;
}

static bool admit_regular(struct ph_tc_fit *fit) {
  return fit->regular;
}

static double limit_of(double value) {
  return value + AGREE * value;
}

/* The regular one that comes after `last` (NULL: the first) in the order of
 * energy; NULL if none does. */
static struct ph_tc_fit *next_energy(struct ph_tc_fit *fits, size_t n,
                                     const struct ph_tc_fit *last) {
  struct ph_tc_fit *next = NULL;
  for (struct ph_tc_fit *f = fits; f < fits + n; f++) {
    bool after = last == NULL || f->energy > last->energy ||
                 (f->energy >= last->energy && f > last);
    if (f->regular && after && (next == NULL || f->energy < next->energy)) {
      next = f;
    }
  }
  return next;
}

/* The best of those that bend no more than `energy`. */
static struct ph_tc_fit *best_of(struct ph_tc_fit *fits, size_t n,
                                 double energy, admit *admitted) {
  struct ph_tc_fit *shortest = NULL;
  for (struct ph_tc_fit *f = fits; f < fits + n; f++) {
    if (f->energy <= energy &&
        (shortest == NULL || f->length < shortest->length) && admitted(f)) {
      shortest = f;
    }
  }
  for (struct ph_tc_fit *f = fits; shortest != NULL && f < shortest; f++) {
    if (f->energy <= energy && f->length <= limit_of(shortest->length) &&
        admitted(f)) {
      return f;
    }
  }
  return shortest;
}

/* NULL if none is regular and admitted. */
static struct ph_tc_fit *choose(struct ph_tc_fit *fits, size_t n,
                                admit *admitted) {
  struct ph_tc_fit *least = next_energy(fits, n, NULL);
  while (least != NULL && !admitted(least)) {
    least = next_energy(fits, n, least);
  }
  return least == NULL ? NULL
                       : best_of(fits, n, limit_of(least->energy), admitted);
}

struct ph_tc_fit *ph_tc_fit_best(struct ph_tc_fit *fits, size_t n) {
  struct ph_tc_fit *best = choose(fits, n, admit_simple);
  return best != NULL ? best : choose(fits, n, admit_regular);
}

/* ---- all in order ------------------------------------------------------- */

void ph_tc_fit_order(struct ph_tc_fit *fits, size_t n) {
  for (size_t i = 0; i < n; i++) {
    ph_tc_fit_test(&fits[i]);
  }
  for (size_t i = 0; i < n; i++) {
    struct ph_tc_fit *best = choose(fits + i, n - i, admit_tested), moved;
    if (best == NULL) {
      best = choose(fits + i, n - i, admit_regular);
    }
    if (best == NULL) {
      return;
    }
    moved = *best;
    for (; best > fits + i; best--) {
      best[0] = best[-1];
    }
    fits[i] = moved;
  }
}

/* ---- one cubic ----------------------------------------------------------- */

/*
 * G1 Hermite interpolation by one Tschirnhausen cubic [BYR11, ch. 4], see
 * tc.h.
 *
 * The solutions come from the quadratic (4.5) with square roots only.  Where
 * there are any comes from the angles: dividing 3 (r(1) - r(0)) = w0^2 + w0 w1
 * + w1^2 by w0 w1 leaves, with D = +-exp(tau),
 *
 *   1 + 2 (+-cosh tau cos delta + i (+-sinh tau) sin delta),
 *
 * which must have the argument -phi.  It runs on a hyperbola with the foci 3
 * and -1, so that tangents, asymptotes and the point where loops close bound
 * all regions.
 */

/* G of no more than this, beside its terms, is 0 to rounding: the cubic would
 * be closed, and of any size. */
#define CLOSED 1e-14

/* Factors of the discriminant this near to each other, relative, are equal to
 * the rounding of the tangents. */
#define DOUBLE_ROOT (16 * DBL_EPSILON)

/* ---- solutions ----------------------------------------------------------- */

/* The quadratic (4.5) of unit tangents t, and the square roots of those. */
struct quadratic {
  ph_cplx t[2], u[2];
  ph_cplx middle; /* u[0] u[1] = exp(i phi) */
};

static struct quadratic quadratic_of(const struct ph_tc_hermite *h) {
  struct quadratic q = {{h->t[0], h->t[1]},
                        {ph_cplx_sqrt(h->t[0]), ph_cplx_sqrt(h->t[1])},
                        {0, 0}};
  q.middle = ph_cplx_mul(q.u[0], q.u[1]);
  return q;
}

/*
 * Its real roots but 0, in a form that does not cancel.  The discriminant sin^2
 * phi - 4 sin a sin b is (2 sin delta)^2 - 3 sin^2 phi, two factors.
 */
static size_t roots_of(const struct quadratic *q, double root[2]) {
  double phi = q->middle.im, a = q->t[0].im, b = q->t[1].im;
  double d = 2 * fabs(ph_cplx_cross(q->u[0], q->u[1]));
  double p = PH_SQRT3 * fabs(phi), gap = d - p, s;
  size_t n = 0;
  if (!(gap >= -DOUBLE_ROOT * d)) {
    return 0;
  }
  s = gap > DOUBLE_ROOT * d ? sqrt(gap * (d + p)) : 0;
  s = -0.5 * (phi + copysign(s, phi));
  if (fabs(b) > 0) {
    root[n++] = s / b;
  }
  if (fabs(a) > 0 && (n == 0 || gap > DOUBLE_ROOT * d)) {
    root[n++] = a / s;
  }
  return n;
}

/* The cubic of a root D; false unless G > 0. */
static bool fit_of(const struct quadratic *q, double root,
                   struct ph_tc_fit *fit) {
  double a = q->t[0].re, m = root * q->middle.re, b = root * root * q->t[1].re;
  double g = a + m + b, scale;
  if (!(g > CLOSED * (fabs(a) + fabs(m) + fabs(b)))) {
    return false;
  }
  scale = sqrt(3 / g);
  *fit = ph_tc_fit_of(1, PH_ROOT_N);
  fit->tc[0].w[0] = ph_cplx_scale(scale, q->u[0]);
  fit->tc[0].w[1] = ph_cplx_scale(root * scale, q->u[1]);
  fit->ratio = ph_tc_is_backward(q->t[0]) || ph_tc_is_backward(q->t[1])
                   ? fabs(root)
                   : root;
  fit->root = fit->ratio > 0 ? PH_ROOT_PLUS : PH_ROOT_MINUS;
  ph_tc_fit_measure(fit);
  fit->simple = fit->regular && fit->loops == 0;
  return true;
}

/* Whether x is better than y. */
static bool is_better(const struct ph_tc_fit *x, const struct ph_tc_fit *y) {
  if (x->regular != y->regular) {
    return x->regular;
  }
  if (x->loops != y->loops) {
    return x->loops < y->loops;
  }
  return x->energy < y->energy;
}

/* The straight line, if both tangents are forward. */
static size_t straight(const struct ph_tc_hermite *h, struct ph_tc_fit *fit) {
  static const struct quadratic line = {
      {{1, 0}, {1, 0}}, {{1, 0}, {1, 0}}, {1, 0}};
  if (!(h->t[0].re > 0 && h->t[1].re > 0) || !fit_of(&line, 1, fit)) {
    return 0;
  }
  fit->root = PH_ROOT_STRAIGHT;
  return 1;
}

size_t ph_tc_g1(const struct ph_tc_hermite *h, struct ph_tc_fit fits[2]) {
  struct quadratic q;
  double root[2];
  size_t roots, n = 0;
  if (ph_tc_is_along(h->t[0]) && ph_tc_is_along(h->t[1])) {
    return straight(h, fits);
  }
  q = quadratic_of(h);
  roots = roots_of(&q, root);
  for (size_t i = 0; i < roots; i++) {
    n += fit_of(&q, root[i], &fits[n]);
  }
  if (n == 2 && is_better(&fits[1], &fits[0])) {
    struct ph_tc_fit fit = fits[0];
    fits[0] = fits[1];
    fits[1] = fit;
  }
  return n;
}

/* ---- where there are any ------------------------------------------------- */

/* For a in [-pi, 0). */
static void range_right(double a, double range[2]) {
  const double k = (2 - PH_SQRT3) * (2 - PH_SQRT3), tangent = tan(a / 2);
  range[0] = a <= -5 * PH_PI / 6 ? a + 2 * PH_PI / 3 : 2 * atan(k * tangent);
  range[1] =
      a <= -PH_PI / 6 ? a + 4 * PH_PI / 3 : 2 * PH_PI + 2 * atan(tangent / k);
}

void ph_tc_g1_range(double a, double range[2]) {
  double from = fabs(a) <= PH_TC_COLLINEAR ? 0 : a, low;
  range_right(-fabs(from), range);
  if (!(fabs(from) > 0)) {
    range[0] = -2 * PH_PI / 3;
    range[1] = 2 * PH_PI / 3;
  } else if (from > 0) {
    low = -range[1];
    range[1] = -range[0];
    range[0] = low;
  }
}

/* ---- pairs --------------------------------------------------------------- */

/* C1 Hermite interpolation by a pair of Tschirnhausen cubics [BYR11, thm 17],
 * see tc.h. */

/* The preimages of both derivatives, and w0^2 + w2^2 - 3. */
struct ends {
  ph_cplx w0, w2, c;
};

static struct ends ends_of(const struct ph_tc_hermite *h) {
  struct ends e = {
      ph_cplx_sqrt(h->t[0]), ph_cplx_sqrt(h->t[1]),
      ph_cplx_of(h->t[0].re + h->t[1].re - 3, h->t[0].im + h->t[1].im)};
  return e;
}

/*
 * The joints z[0] of +rho and z[1] of -rho.  The larger does not cancel; the
 * other follows from z[0] z[1] = c/2.
 */
static void joints_of(const struct ends *e, ph_cplx z[2]) {
  ph_cplx s = ph_cplx_add(e->w0, e->w2);
  ph_cplx rho =
      ph_cplx_sqrt(ph_cplx_sub(ph_cplx_mul(s, s), ph_cplx_scale(8, e->c)));
  double sign = ph_cplx_dot(s, rho) >= 0 ? 1 : -1;
  ph_cplx large =
      ph_cplx_scale(-0.25, ph_cplx_add(s, ph_cplx_scale(sign, rho)));
  double norm2 = ph_cplx_norm2(large);
  ph_cplx small = ph_cplx_scale(norm2 > 0 ? 0.5 / norm2 : 0,
                                ph_cplx_mul(e->c, ph_cplx_conj(large)));
  z[0] = sign > 0 ? small : large;
  z[1] = sign > 0 ? large : small;
}

static void set_pair(const struct ends *e, ph_cplx z, enum ph_root root,
                     struct ph_tc_fit *fit) {
  *fit = ph_tc_fit_of(2, root);
  fit->tc[0] = (struct ph_tc){{e->w0, z}};
  fit->tc[1] = (struct ph_tc){{z, e->w2}};
}

void ph_tc_pairs(const struct ph_tc_hermite *h,
                 struct ph_tc_fit fits[PH_TC_PAIRS]) {
  struct ends e = ends_of(h);
  ph_cplx z[2];
  joints_of(&e, z);
  set_pair(&e, z[0], PH_ROOT_PLUS_PLUS, &fits[0]);
  set_pair(&e, z[1], PH_ROOT_PLUS_MINUS, &fits[1]);
  e.w2 = ph_cplx_scale(-1, e.w2);
  joints_of(&e, z);
  set_pair(&e, z[0], PH_ROOT_MINUS_PLUS, &fits[2]);
  set_pair(&e, z[1], PH_ROOT_MINUS_MINUS, &fits[3]);
}

bool ph_tc_pair_is_safe(const struct ph_tc_hermite *h) {
  const double low = PH_TC_PAIR_SHORTEST, high = PH_TC_PAIR_LONGEST;
  for (size_t i = 0; i < 2; i++) {
    double norm2 = ph_cplx_norm2(h->t[i]);
    if (!(h->t[i].re >= 0 && norm2 >= low * low && norm2 <= high * high)) {
      return false;
    }
  }
  return true;
}

bool ph_tc_pair_standard(const struct ph_tc_hermite *h, struct ph_tc_fit *fit) {
  struct ends e;
  ph_cplx z[2];
  if (ph_tc_is_backward(h->t[0]) || ph_tc_is_backward(h->t[1])) {
    return false;
  }
  e = ends_of(h);
  joints_of(&e, z);
  set_pair(&e, z[0], PH_ROOT_PLUS_PLUS, fit);
  return true;
}

bool ph_tc_pair_best(const struct ph_tc_hermite *h, struct ph_tc_fit *fit) {
  struct ph_tc_fit fits[PH_TC_PAIRS], *best;
  if (ph_tc_pair_is_safe(h) && ph_tc_pair_standard(h, fit)) {
    ph_tc_fit_measure(fit);
    fit->simple = fit->regular && fit->loops == 0;
    if (fit->simple) {
      return true;
    }
  }
  ph_tc_pairs(h, fits);
  for (size_t i = 0; i < PH_TC_PAIRS; i++) {
    ph_tc_fit_measure(&fits[i]);
  }
  best = ph_tc_fit_best(fits, PH_TC_PAIRS);
  if (best == NULL) {
    return false;
  }
  *fit = *best;
  return true;
}
