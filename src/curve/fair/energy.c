/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Fairness of planar splines (see energy.h).
 *
 * With derivatives by u and w the preimage,
 *
 *   E  = integral of kappa^2 |w|^2 du
 *   MV = integral of (dkappa/du)^2 / |w|^2 du
 *
 * Both are smooth unless w nearly vanishes: their poles are the zeros of w and
 * the conjugates of these.  Of PH quintics w has two zeros, and how far the
 * nearer one is, as an ellipse around the interval, says how many nodes are
 * enough; nothing is compared.  Where 20 are not, the interval is cut in half.
 *
 * Otherwise rules of 4, 8 and 16 nodes are compared in turn.  Where not even
 * the last two agree, 16 nodes on an interval are compared with 16 on either
 * half; so they are in parts that grow from where w nearly vanishes.  The finer
 * value is kept, which is far better than the difference says.  GSL's QAG, for
 * each integral by itself, takes 1.4 times as long on gentle segments and twice
 * as long on bent ones, and does not know what is rounding.
 */
#include "curve/fair/energy.h"

#include "kernel/pi.h"
#include "kernel/pow2.h"

#include <float.h>
#include <math.h>

/* The nodes of the rules; and from which ellipse on, by its major semiaxis over
 * that of the interval, each has both integrals to 3e-13: of 3000 pairs of
 * zeros, one on the ellipse and the other on it or beyond, near the same place,
 * its mirror images or anywhere, the worst was near 2e-13 there. */
static const size_t NODES[PH_ENERGY_RULES] = {4, 6, 8, 12, 16, 20};
static const double ENOUGH[PH_ENERGY_RULES] = {200, 30, 12.5, 5.3, 3.1, 2.4};

/* Rules that are compared: 4, 8, 16. */
enum { FIRST_RULE = 0, NEXT_RULE = 2, LAST_RULE = 4 };

/* Cuts in half: to 1/256 of a segment that does not nearly stand still. */
enum { CUTS_MAX = 8 };

/* Intervals of one segment, at most; 2^-50 of it is at the rounding of u. */
enum { DEPTH_MAX = 50, PARTS_MAX = 4096 };

static const double AGREE = 1e-12;
/* Error of a curvature or its rate in units of its terms. */
static const double ROUNDING = 16 * DBL_EPSILON;

/* A segment nearly stands still where w changes by as much as it is within
 * this; parts that begin there grow by a factor, from no less than this. */
static const double SLOW = 1.0 / 32, GROW = 4, SHORTEST = 1e-15;

/* Squares of numbers whose products may be subnormal. */
static const double TINY = 1e-140;

/* An integral of squares, and the same integral of their terms. */
struct square {
  double value, terms;
};

struct pair {
  struct square bending, varying;
};

static void add_square(struct square *sum, double weight, double x,
                       double terms) {
  sum->value += weight * x * x;
  sum->terms += weight * terms;
}

static struct pair integrate(const struct ph_seg2 *seg,
                             const struct ph_quad *rule, double u0, double u1) {
  struct pair sum = {{0, 0}, {0, 0}};
  for (size_t i = 0; i < rule->n; i++) {
    double u = u0 + (u1 - u0) * rule->node[i];
    struct ph_curvature at = ph_seg2_curvature(seg, u);
    double weight = (u1 - u0) * rule->weight[i];
    add_square(&sum.bending, weight * at.speed, at.curvature, at.terms[0]);
    add_square(&sum.varying, weight / at.speed, at.rate, at.terms[1]);
  }
  return sum;
}

/* Whether two values agree, or what they differ by is rounding (of a square
 * that is nearly nothing), or is lost in the sum so far. */
static bool agree(const struct square *a, const struct square *b,
                  const struct ph_sum *sum) {
  double difference = fabs(a->value - b->value);
  double noise = ROUNDING * sqrt(b->terms);
  return difference <= AGREE * b->value + 2 * noise * sqrt(b->value) +
                           noise * noise + 0.1 * AGREE * ph_sum_value(sum);
}

static void accept(struct ph_energy_sum *c, const struct pair *part) {
  ph_sum_add(&c->bending, part->bending.value);
  ph_sum_add(&c->varying, part->varying.value);
}

static bool both_agree(const struct ph_energy_sum *c, const struct pair *a,
                       const struct pair *b) {
  return agree(&a->bending, &b->bending, &c->bending) &&
         agree(&a->varying, &b->varying, &c->varying);
}

static struct square add_squares(struct square a, struct square b) {
  struct square sum = {a.value + b.value, a.terms + b.terms};
  return sum;
}

/* Halves an interval until the halves agree with the whole. */
static void refine(struct ph_energy_sum *c, const struct ph_seg2 *seg,
                   double u0, double u1, const struct pair *whole, int depth) {
  const struct ph_quad *rule = &c->rule[LAST_RULE];
  double middle = 0.5 * (u0 + u1);
  struct pair left = integrate(seg, rule, u0, middle);
  struct pair right = integrate(seg, rule, middle, u1);
  struct pair sum = {add_squares(left.bending, right.bending),
                     add_squares(left.varying, right.varying)};
  c->parts++;
  if (depth == DEPTH_MAX || c->parts >= PARTS_MAX ||
      !isfinite(sum.bending.value + sum.varying.value) ||
      both_agree(c, whole, &sum)) {
    accept(c, &sum);
    return;
  }
  refine(c, seg, u0, middle, &left, depth + 1);
  refine(c, seg, middle, u1, &right, depth + 1);
}

/* How far from u the preimage has changed by as much as it is. */
static double reach_at(const struct ph_seg2 *seg, double u) {
  ph_cplx w[3];
  double size;
  ph_atph_jet(&seg->space, seg->w, u, w, 3);
  size = ph_cplx_abs(w[0]);
  return fmin(size / ph_cplx_abs(w[1]), sqrt(size / ph_cplx_abs(w[2])));
}

/* Adds the interval from `slow` to `end`, on either side, in parts that grow
 * from there. */
static void add_growing(struct ph_energy_sum *c, const struct ph_seg2 *seg,
                        double slow, double end) {
  double whole = fabs(end - slow), part = reach_at(seg, slow), to;
  part = fmax(part, SHORTEST * whole);
  for (double from = 0; from < whole; from = to, part *= GROW) {
    double a, b;
    struct pair sum;
    to = fmin(from + part, whole);
    a = end > slow ? slow + from : to < whole ? slow - to : end;
    b = end < slow ? slow - from : to < whole ? slow + to : end;
    sum = integrate(seg, &c->rule[LAST_RULE], a, b);
    refine(c, seg, a, b, &sum, 0);
  }
}

/* Whether it nearly stands still nowhere, by sight: within a quarter turn |w|
 * is least at an end, or above an eighth of the smaller (ph_seg2_moves_on);
 * from ends like these w changes by as much as it is in 1/34 of the segment. */
static bool is_brisk(const ph_cplx w[3]) {
  double first = ph_cplx_norm2(w[0]), last = ph_cplx_norm2(w[2]);
  double sum = first + ph_cplx_norm2(w[1]) + last;
  return ph_seg2_is_monotone(w) && 256 * first > sum && 256 * last > sum;
}

/* Whether it nearly stands still; then it is added.  A peak there may be
 * narrower than nodes are apart: halving would miss it, least beside another.
 */
static bool add_slow(struct ph_energy_sum *c, const struct ph_seg2 *seg) {
  double at[2], cut[4] = {0, 0, 0, 1};
  ph_seg2_slow(seg, at);
  if (!(reach_at(seg, at[0]) < SLOW) && !(reach_at(seg, at[1]) < SLOW)) {
    return false;
  }
  cut[1] = fmin(at[0], at[1]);
  cut[2] = fmax(at[0], at[1]);
  for (size_t i = 0; i < 3; i++) {
    double middle = 0.5 * (cut[i] + cut[i + 1]);
    add_growing(c, seg, cut[i], middle);
    add_growing(c, seg, cut[i + 1], middle);
  }
  return true;
}

/* ---- PH quintics --------------------------------------------------------- */

/* A zero of w, p / d. */
struct zero {
  ph_cplx p, d;
};

/* The zeros of a preimage; false: rounding may have them elsewhere. */
static bool zeros_of(const ph_cplx w[3], struct zero zeros[2]) {
  const ph_cplx square =
      ph_cplx_sub(ph_cplx_mul(w[1], w[1]), ph_cplx_mul(w[0], w[2]));
  const ph_cplx root = ph_cplx_sqrt(square);
  const ph_cplx q = ph_cplx_dot(w[1], root) >= 0 ? ph_cplx_add(w[1], root)
                                                 : ph_cplx_sub(w[1], root);
  zeros[0] = (struct zero){q, ph_cplx_sub(q, w[2])};
  zeros[1] = (struct zero){w[0], ph_cplx_sub(w[0], q)};
  return ph_cplx_norm2(q) > TINY;
}

/* The major semiaxis of the ellipse around [u0,u1], its foci, through a zero,
 * over half of u1 - u0. */
static double ellipse(const struct zero *z, double u0, double u1) {
  const ph_cplx a = ph_cplx_sub(z->p, ph_cplx_scale(u0, z->d));
  const ph_cplx b = ph_cplx_sub(z->p, ph_cplx_scale(u1, z->d));
  return (ph_cplx_abs(a) + ph_cplx_abs(b)) / (ph_cplx_abs(z->d) * (u1 - u0));
}

/* Both integrals by one rule. */
static void add_rule(struct ph_energy_sum *c, const struct ph_quad *rule,
                     const ph_cplx w[3], double u0, double u1) {
  const ph_cplx first = ph_cplx_scale(2, ph_cplx_sub(w[1], w[0]));
  const ph_cplx last = ph_cplx_scale(2, ph_cplx_sub(w[2], w[1]));
  const ph_cplx second = ph_cplx_sub(last, first);
  double bending = 0, varying = 0;
  for (size_t i = 0; i < rule->n; i++) {
    const double u = u0 + (u1 - u0) * rule->node[i], v = 1 - u;
    const double b0 = v * v, b1 = 2 * u * v, b2 = u * u;
    const ph_cplx at = ph_cplx_of(b0 * w[0].re + b1 * w[1].re + b2 * w[2].re,
                                  b0 * w[0].im + b1 * w[1].im + b2 * w[2].im);
    const ph_cplx to =
        ph_cplx_of(v * first.re + u * last.re, v * first.im + u * last.im);
    const double per = 1 / ph_cplx_norm2(at);
    const double turn = ph_cplx_cross(at, to) * per;
    const double stretch = ph_cplx_dot(at, to) * per;
    const double more = ph_cplx_cross(at, second) * per;
    const double rate = 2 * more - 8 * turn * stretch;
    bending += rule->weight[i] * 4 * turn * turn * per;
    varying += rule->weight[i] * rate * rate * per * per * per;
  }
  ph_sum_add(&c->bending, (u1 - u0) * bending);
  ph_sum_add(&c->varying, (u1 - u0) * varying);
}

/* Adds an interval by the rule that has enough nodes, or in halves. */
static void add_by_zeros(struct ph_energy_sum *c, const struct ph_seg2 *seg,
                         const struct zero *zeros, double u0, double u1,
                         int cuts) {
  const double nearer =
      fmin(ellipse(&zeros[0], u0, u1), ellipse(&zeros[1], u0, u1));
  const double middle = 0.5 * (u0 + u1);
  size_t i = 0;
  while (i < PH_ENERGY_RULES && nearer < ENOUGH[i]) {
    i++;
  }
  if (i < PH_ENERGY_RULES) {
    c->parts++;
    add_rule(c, &c->rule[i], seg->w, u0, u1);
  } else if (cuts < CUTS_MAX) {
    add_by_zeros(c, seg, zeros, u0, middle, cuts + 1);
    add_by_zeros(c, seg, zeros, middle, u1, cuts + 1);
  } else {
    const struct pair whole = integrate(seg, &c->rule[LAST_RULE], u0, u1);
    refine(c, seg, u0, u1, &whole, cuts);
  }
}

/* ---- the whole ----------------------------------------------------------- */

bool ph_energy_begin(struct ph_energy_sum *sum) {
  ph_energy_clear(sum);
  for (size_t i = 0; i < PH_ENERGY_RULES; i++) {
    if (!ph_quad_gauss(&sum->rule[i], NODES[i])) {
      return false;
    }
  }
  return true;
}

void ph_energy_clear(struct ph_energy_sum *sum) {
  sum->bending = sum->varying = (struct ph_sum){0, 0};
  sum->parts = 0;
}

bool ph_energy_add(struct ph_energy_sum *sum, const struct ph_seg2 *seg) {
  struct pair coarse;
  struct zero zeros[2];
  sum->parts = 0;
  if (!is_brisk(seg->w)) {
    if (ph_seg2_stands_still(seg, NULL)) {
      ph_sum_add(&sum->bending, (double)NAN);
      ph_sum_add(&sum->varying, (double)NAN);
      return false;
    }
    if (add_slow(sum, seg)) {
      return true;
    }
  }
  if (!(seg->space.angle > 0) && zeros_of(seg->w, zeros)) {
    add_by_zeros(sum, seg, zeros, 0, 1, 0);
    return true;
  }
  coarse = integrate(seg, &sum->rule[FIRST_RULE], 0, 1);
  for (size_t i = NEXT_RULE; i <= LAST_RULE; i += NEXT_RULE) {
    struct pair fine = integrate(seg, &sum->rule[i], 0, 1);
    if (both_agree(sum, &coarse, &fine)) {
      accept(sum, &fine);
      return true;
    }
    coarse = fine;
  }
  refine(sum, seg, 0, 1, &coarse, 0);
  return true;
}

/* Half the exponent of the power of two that brings r' = w^2 to unit scale. */
static int unit_exponent(const struct ph_curve *curve) {
  size_t n = curve->n * curve->preimage.n * 2;
  double largest = 0;
  for (size_t i = 0; i < n; i++) {
    largest = fmax(largest, fabs(curve->preimage.v[i]));
  }
  return largest > 0 ? -ilogb(largest) : 0;
}

bool ph_energy_part_begin(struct ph_energy_part *part,
                          const struct ph_curve *curve) {
  *part = (struct ph_energy_part){.exponent = unit_exponent(curve)};
  return ph_energy_begin(&part->sum);
}

void ph_energy_part_add(struct ph_energy_part *part,
                        const struct ph_curve *curve, size_t first) {
  const size_t end =
      curve->n - first > PH_ENERGY_PART ? first + PH_ENERGY_PART : curve->n;
  const double scale = ldexp(1, part->exponent);
  for (size_t k = first; k < end && !part->still; k++) {
    struct ph_seg2 seg = ph_seg2_of(curve, k);
    double turned;
    for (size_t i = 0; i < 3; i++) {
      seg.w[i] = ph_cplx_scale(scale, seg.w[i]);
    }
    part->still = !ph_energy_add(&part->sum, &seg);
    ph_sum_add(&part->rotation, ph_seg2_rotation(&seg, &turned));
    ph_sum_add(&part->absolute, turned);
  }
}

void ph_energy_part_join(struct ph_energy_part *part,
                         const struct ph_energy_part *next) {
  ph_sum_join(&part->sum.bending, &next->sum.bending);
  ph_sum_join(&part->sum.varying, &next->sum.varying);
  ph_sum_join(&part->rotation, &next->rotation);
  ph_sum_join(&part->absolute, &next->absolute);
  part->still |= next->still;
}

struct ph_energy ph_energy_of(const struct ph_energy_part *part,
                              const struct ph_curve *curve) {
  const double turn = 2 * PH_PI, none = (double)NAN;
  const int exponent = part->exponent;
  const double length = ldexp(curve->length, 2 * exponent);
  const double bending = ph_sum_value(&part->sum.bending);
  const double varying = ph_sum_value(&part->sum.varying);
  if (part->still) {
    return (struct ph_energy){none, none, none, none, none, none};
  }
  return (struct ph_energy){.bending = ph_pow2_positive(bending, 2 * exponent),
                            .varying = ph_pow2_positive(varying, 6 * exponent),
                            .ies = bending * length,
                            .imv = varying * length * length * length,
                            .rotation = ph_sum_value(&part->rotation) / turn,
                            .absolute_rotation =
                                ph_sum_value(&part->absolute) / turn};
}

bool ph_energy_planar(const struct ph_curve *curve, struct ph_energy *energy) {
  struct ph_energy_part whole, part;
  if (!ph_energy_part_begin(&whole, curve)) {
    return false;
  }
  part = whole;
  for (size_t first = 0; first < curve->n; first += PH_ENERGY_PART) {
    struct ph_energy_part next = part;
    ph_energy_part_add(&next, curve, first);
    if (first == 0) {
      whole = next;
    } else {
      ph_energy_part_join(&whole, &next);
    }
  }
  *energy = ph_energy_of(&whole, curve);
  return true;
}
