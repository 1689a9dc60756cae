/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Fairness of planar splines (see energy.h).
 *
 * With derivatives by u and w the preimage,
 *
 *   E  = integral of kappa^2 |w|^2 du
 *   MV = integral of (dkappa/du)^2 / |w|^2 du
 *
 * Both are smooth unless w nearly vanishes: each piece has a rule that is
 * enough (pieces.h).  Where none is, 16 nodes on an interval are compared with
 * 16 on either half, and the halves are cut in turn; so they are in parts that
 * grow from where w nearly vanishes.  The finer value is kept, which is far
 * better than the difference says.
 */
#include "curve/fair/energy.h"

#include "kernel/pi.h"
#include "kernel/pow2.h"

#include <float.h>
#include <math.h>

/* The rule whose halves are compared. */
enum { HALVED_RULE = PH_PIECE_SIXTEEN };

/* Intervals of one segment, at most; 2^-50 of it is at the rounding of u. */
enum { DEPTH_MAX = 50, PARTS_MAX = 4096 };

static const double AGREE = 1e-12;
/* Error of a curvature or its rate in units of its terms. */
static const double ROUNDING = 16 * DBL_EPSILON;

/* A segment nearly stands still where w changes by as much as it is within
 * this; parts that begin there grow by a factor, from no less than this. */
static const double SLOW = 1.0 / 32, GROW = 4, SHORTEST = 1e-15;

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
  const struct ph_quad *rule = &c->rule[HALVED_RULE];
  double middle = 0.5 * (u0 + u1);
  struct pair left = integrate(seg, rule, u0, middle);
  struct pair right = integrate(seg, rule, middle, u1);
  struct pair sum = {add_squares(left.bending, right.bending),
                     add_squares(left.varying, right.varying)};
  c->halved++;
  if (depth == DEPTH_MAX || c->halved >= PARTS_MAX ||
      !isfinite(sum.bending.value + sum.varying.value) ||
      both_agree(c, whole, &sum)) {
    accept(c, &sum);
    return;
  }
  refine(c, seg, u0, middle, &left, depth + 1);
  refine(c, seg, middle, u1, &right, depth + 1);
}

static void add_halves(struct ph_energy_sum *c, const struct ph_seg2 *seg,
                       double u0, double u1) {
  const struct pair whole = integrate(seg, &c->rule[HALVED_RULE], u0, u1);
  refine(c, seg, u0, u1, &whole, 0);
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
    to = fmin(from + part, whole);
    a = end > slow ? slow + from : to < whole ? slow - to : end;
    b = end < slow ? slow - from : to < whole ? slow + to : end;
    add_halves(c, seg, a, b);
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

/* ---- pieces -------------------------------------------------------------- */

/* Of a PH segment w' at either end, and w''. */
struct bernstein {
  ph_cplx first, last, second;
};

static struct bernstein bernstein_of(const ph_cplx w[3]) {
  struct bernstein b = {.first = ph_cplx_scale(2, ph_cplx_sub(w[1], w[0])),
                        .last = ph_cplx_scale(2, ph_cplx_sub(w[2], w[1]))};
  b.second = ph_cplx_sub(b.last, b.first);
  return b;
}

static void jet_at(const struct ph_seg2 *seg, const struct bernstein *b,
                   double u, ph_cplx jet[3]) {
  const ph_cplx *w = seg->w;
  const double v = 1 - u, b0 = v * v, b1 = 2 * u * v, b2 = u * u;
  if (seg->space.angle > 0) {
    ph_atph_jet_by_basis(&seg->space, w, u, jet, 3);
    return;
  }
  jet[0] = ph_cplx_of(b0 * w[0].re + b1 * w[1].re + b2 * w[2].re,
                      b0 * w[0].im + b1 * w[1].im + b2 * w[2].im);
  jet[1] = ph_cplx_of(v * b->first.re + u * b->last.re,
                      v * b->first.im + u * b->last.im);
  jet[2] = b->second;
}

/* Both integrals on a piece, by its rule. */
static void add_rule(struct ph_energy_sum *c, const struct ph_seg2 *seg,
                     const struct ph_piece *piece) {
  const struct ph_quad *rule = &c->rule[piece->rule];
  const struct bernstein b = bernstein_of(seg->w);
  const double u0 = piece->from, u1 = piece->to;
  double bending = 0, varying = 0;
  for (size_t i = 0; i < rule->n; i++) {
    ph_cplx w[3];
    double per, turn, stretch, more, rate;
    jet_at(seg, &b, u0 + (u1 - u0) * rule->node[i], w);
    per = 1 / ph_cplx_norm2(w[0]);
    turn = ph_cplx_cross(w[0], w[1]) * per;
    stretch = ph_cplx_dot(w[0], w[1]) * per;
    more = ph_cplx_cross(w[0], w[2]) * per;
    rate = 2 * more - 8 * turn * stretch;
    bending += rule->weight[i] * 4 * turn * turn * per;
    varying += rule->weight[i] * rate * rate * per * per * per;
  }
  ph_sum_add(&c->bending, (u1 - u0) * bending);
  ph_sum_add(&c->varying, (u1 - u0) * varying);
}

/* ---- the whole ----------------------------------------------------------- */

bool ph_energy_begin(struct ph_energy_sum *sum) {
  ph_energy_clear(sum);
  return ph_pieces_rules(sum->rule);
}

void ph_energy_clear(struct ph_energy_sum *sum) {
  sum->bending = sum->varying = (struct ph_sum){0, 0};
  sum->halved = 0;
}

bool ph_energy_add(struct ph_energy_sum *sum, const struct ph_seg2 *seg) {
  struct ph_piece piece[PH_PIECES_MAX];
  size_t n;
  sum->halved = 0;
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
  n = ph_pieces_of(seg, piece);
  for (size_t i = 0; i < n; i++) {
    if (piece[i].enough) {
      add_rule(sum, seg, &piece[i]);
    } else {
      add_halves(sum, seg, piece[i].from, piece[i].to);
    }
  }
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
