/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Cubics for one part of a curve (see approx.h).
 *
 * One cubic has the tangents of the curve at both ends and nothing else, but it
 * is of fourth order where the curvature keeps its sign. A pair is of third
 * order, with the derivatives h C' of the curve over half of the part [BYR11,
 * sec. 5.4]; it exists always.  Where the curve stands still, or is so fast
 * that its derivative says nothing about the part, the length of the derivative
 * is kept within what makes good pairs.
 */
#include "solve/tc/approx.h"

#include "kernel/bern.h"
#include "kernel/pi.h"
#include "solve/tc/tc.h"

#include <float.h>
#include <math.h>
#include <string.h>

/* A cubic that turns by a half turn or more is taken only where it is this near
 * to the curve, over the chord: it may go another way round. */
static const double SURE = 0.0625;

/* Nor is one whose first leg is so much shorter than its last, or the other way
 * round: it has nearly a cusp at an end, and its tangent there is lost in the
 * rounding of control points. */
static const double EVEN = 0x1p-16;

/* Derivatives of no more than this, beside the largest that a curve may have,
 * lose their direction to rounding. */
static const double STILL = 1e-12;

size_t ph_tc_target_room(size_t degree) {
  return 3 * (degree + 1) + ph_tc_match_room(degree);
}

struct ph_tc_target ph_tc_target_of(const struct ph_tc_bezier *curve,
                                    ph_cplx *room) {
  size_t n = curve->degree;
  double size = 0, step = 0, extent = 0;
  struct ph_tc_target target = {.p = curve->p,
                                .degree = n,
                                .part = room,
                                .cut = room + (n + 1),
                                .spare = room + 2 * (n + 1),
                                .pool = room + 3 * (n + 1)};
  ph_bern_low_of(&target.low, curve->p, n, target.part);
  for (size_t k = 0; k <= n; k++) {
    double a = ph_cplx_abs(curve->p[k]);
    double d =
        ph_cplx_abs(ph_cplx_sub(curve->p[k], curve->p[k > 0 ? k - 1 : 0]));
    double e = ph_cplx_abs(ph_cplx_sub(curve->p[k], curve->p[0]));
    size = a > size ? a : size;
    extent = e > extent ? e : extent;
    step = d > step ? d : step;
  }
  target.size = size;
  target.extent = extent;
  /* n steps each of two cuts (2 eps a step, and eps for the parameter), of 2 +
   * 4 halvings (eps/2) and of an elevation (2 eps); as much as `same` for n
   * points that are not looked at; 56 eps for the cubic, cut and composed */
  target.noise = (14 * (double)n + 56) * DBL_EPSILON * size;
  target.same = fmax(4 * DBL_EPSILON * size, curve->shortest);
  target.still = STILL * (double)n * step;
  return target;
}

static ph_cplx unit(ph_cplx a) {
  return ph_cplx_scale(1 / ph_cplx_abs(a), a);
}

/* The direction in which the curve leaves an end where it stands still: that of
 * the first point that is elsewhere. */
static ph_cplx limit(const struct ph_tc_target *t, bool last) {
  size_t n = t->degree;
  for (size_t k = 1; k <= n; k++) {
    ph_cplx d = last ? ph_cplx_sub(t->p[n], t->p[n - k])
                     : ph_cplx_sub(t->p[k], t->p[0]);
    if (ph_cplx_abs(d) > t->same) {
      return unit(d);
    }
  }
  return ph_cplx_of(0, 0);
}

struct ph_tc_knot ph_tc_knot_at(const struct ph_tc_target *t, double u) {
  struct ph_tc_knot knot = {.u = u};
  size_t n = t->degree;
  if (n < PH_BERN_HIGH) {
    ph_bern_cut(t->p, n, u, t->cut, t->spare);
    knot.p = t->spare[0];
    knot.derivative =
        ph_cplx_scale((double)n, ph_cplx_sub(t->spare[1], t->cut[n - 1]));
  } else {
    knot.p = ph_bern_value(t->p, n, u);
    knot.derivative = ph_bern_slope(t->p, n, u);
  }
  if (ph_cplx_abs(knot.derivative) > t->still) {
    knot.tangent = unit(knot.derivative);
  } else if (u <= 0 || u >= 1) {
    knot.tangent = limit(t, u >= 1);
  }
  return knot;
}

/* How far what stands for a part may be from it, over the tolerance. */
static const double LOST = 1e-3;

/* The part of a curve in work, or a half of it. */
struct part {
  const struct ph_tc_target *t;
  const struct ph_tc_knot *from, *to;
  double tolerance;
  const ph_cplx *p; /* [degree + 1] */
  size_t degree;    /* 0: it is not made yet */
  double lost;      /* how far it may be from the curve itself */
};

/* A part that was cut out, of a middle degree where that does. */
static void lower(struct part *part) {
  const struct ph_tc_target *t = part->t;
  ph_cplx near[PH_BERN_NEAR + 1];
  double away;
  size_t n = ph_bern_near(t->part, part->degree, t->spare, near, &away);
  if (n > 0 && away <= LOST * part->tolerance) {
    memcpy(t->part, near, (n + 1) * sizeof *near);
    part->degree = n;
    part->lost = 2 * away; /* and its ends are moved, where the curve's are */
  }
}

static void make(struct part *part) {
  const struct ph_tc_target *t = part->t;
  size_t n = t->degree;
  if (part->degree > 0) {
    return;
  }
  ph_bern_cut(t->p, n, part->to->u, t->cut, t->spare);
  ph_bern_cut(t->cut, n, part->from->u / part->to->u, t->spare, t->part);
  part->degree = n;
  part->lost = 0;
  lower(part);
  t->part[0] = part->from->p;
  t->part[part->degree] = part->to->p;
}

/* The part between two knots, in t->part: of a low degree where that does; else
 * it is made when it is needed, if it is worth waiting for that. */
static struct part part_of(const struct ph_tc_target *t,
                           const struct ph_tc_knot *from,
                           const struct ph_tc_knot *to, double tolerance) {
  struct part part = {t, from, to, tolerance, t->part, 0, 0};
  part.degree = ph_bern_low_part(&t->low, from->u, to->u, LOST * tolerance,
                                 t->part, &part.lost);
  if (t->degree < PH_BERN_HIGH) {
    make(&part);
  }
  return part;
}

/* Whether cubics are so far from a part that is still to be made that it need
 * not be; their distance then. */
static bool is_far(const struct part *part, const struct ph_tc *tc, size_t n,
                   const ph_cplx *joint, double *distance) {
  double from = part->from->u, h = (part->to->u - from) / (double)n;
  *distance = 0;
  for (size_t i = 0; i < n && part->degree == 0; i++) {
    ph_cplx c[4];
    ph_tc_control_points(&tc[i], joint[i], joint[i + 1], c);
    *distance =
        fmax(*distance, ph_tc_least_distance(part->t, from + h * (double)i,
                                             from + h * (double)(i + 1), c));
  }
  return *distance >= PH_TC_FAR * part->tolerance;
}

static double distance_of(const struct part *part, const struct ph_tc *tc,
                          ph_cplx start, ph_cplx end, double enough) {
  const struct ph_tc_target *t = part->t;
  struct ph_tc_match m = {.q = part->p};
  ph_tc_control_points(tc, start, end, m.c);
  return ph_tc_match_distance(&m, part->degree, t->same, enough, t->pool) +
         part->lost + t->noise;
}

static struct ph_tc turned(const struct ph_tc *tc, ph_cplx f) {
  struct ph_tc out = {{ph_cplx_mul(f, tc->w[0]), ph_cplx_mul(f, tc->w[1])}};
  return out;
}

static void try_one(struct part *part, double enough,
                    struct ph_tc_patch *best) {
  const struct ph_tc_knot *from = part->from, *to = part->to;
  ph_cplx chord = ph_cplx_sub(to->p, from->p);
  double length = ph_cplx_abs(chord), distance;
  ph_cplx along = ph_cplx_scale(1 / length, ph_cplx_conj(chord));
  struct ph_tc_hermite h = {{ph_tc_snap(ph_cplx_mul(along, from->tangent)),
                             ph_tc_snap(ph_cplx_mul(along, to->tangent))}};
  struct ph_tc_fit fits[2];
  size_t n = ph_tc_g1(&h, fits);
  for (size_t i = 0; i < n; i++) {
    struct ph_tc tc = turned(&fits[i].tc[0], ph_cplx_sqrt(chord));
    bool blunt = fabs(ph_tc_turning(&tc)) < PH_PI;
    double a = ph_cplx_norm2(tc.w[0]), b = ph_cplx_norm2(tc.w[1]);
    if (!(fits[i].regular && fits[i].loops == 0 && a >= EVEN * b &&
          b >= EVEN * a)) {
      continue;
    }
    if (!is_far(part, &tc, 1, (ph_cplx[]){from->p, to->p}, &distance)) {
      make(part);
      distance = distance_of(part, &tc, from->p, to->p, enough);
    }
    if (distance < best->distance && (blunt || distance <= SURE * length)) {
      best->n = 1;
      best->distance = distance;
      best->tc[0] = tc;
    }
  }
}

/* The derivative at a knot over the chord. */
static ph_cplx derivative_at(const struct ph_tc_knot *knot, double h,
                             ph_cplx along, double length) {
  double size = h * ph_cplx_abs(knot->derivative) / length;
  size = size > PH_TC_PAIR_SHORTEST ? size : PH_TC_PAIR_SHORTEST;
  size = size < PH_TC_PAIR_LONGEST ? size : PH_TC_PAIR_LONGEST;
  return ph_tc_snap(ph_cplx_scale(size, ph_cplx_mul(along, knot->tangent)));
}

static double pair_distance(struct part *part, const struct ph_tc_patch *pair,
                            double enough) {
  const struct ph_tc_target *t = part->t;
  const ph_cplx joint[3] = {part->from->p, pair->joint, part->to->p};
  struct part half[2];
  double distance;
  if (is_far(part, pair->tc, 2, joint, &distance)) {
    return distance;
  }
  make(part);
  half[0] = half[1] = *part;
  half[0].p = t->cut;
  half[1].p = t->spare;
  ph_bern_cut(part->p, part->degree, 0.5, t->cut, t->spare);
  return fmax(distance_of(&half[0], &pair->tc[0], joint[0], joint[1], enough),
              distance_of(&half[1], &pair->tc[1], joint[1], joint[2], enough));
}

static void try_pair(struct part *part, double enough,
                     struct ph_tc_patch *best) {
  const struct ph_tc_knot *from = part->from, *to = part->to;
  ph_cplx chord = ph_cplx_sub(to->p, from->p), f = ph_cplx_sqrt(chord);
  double length = ph_cplx_abs(chord), h = (to->u - from->u) / 2;
  ph_cplx along = ph_cplx_scale(1 / length, ph_cplx_conj(chord));
  struct ph_tc_hermite data = {{derivative_at(from, h, along, length),
                                derivative_at(to, h, along, length)}};
  struct ph_tc_patch patch = {.n = 2};
  struct ph_tc_fit fit;
  if (!ph_tc_pair_best(&data, &fit) || !fit.simple) {
    return;
  }
  patch.tc[0] = turned(&fit.tc[0], f);
  patch.tc[1] = turned(&fit.tc[1], f);
  patch.joint = ph_cplx_add(from->p, ph_tc_leg(&patch.tc[0]));
  patch.at = from->u + h;
  patch.distance = pair_distance(part, &patch, enough);
  if (patch.distance < best->distance) {
    *best = patch;
  }
}

struct ph_tc_patch ph_tc_patch_of(const struct ph_tc_target *target,
                                  const struct ph_tc_knot *from,
                                  const struct ph_tc_knot *to,
                                  enum ph_tc_kind kind, double tolerance) {
  struct ph_tc_patch best = {.n = 0, .distance = (double)INFINITY};
  struct part part;
  double enough = 4 * tolerance;
  double length = ph_cplx_abs(ph_cplx_sub(to->p, from->p));
  bool turns =
      ph_cplx_norm2(from->tangent) > 0 && ph_cplx_norm2(to->tangent) > 0;
  if (!(length > ph_tc_shortest(target, tolerance)) || !turns) {
    return best;
  }
  part = part_of(target, from, to, tolerance);
  try_one(&part, enough, &best);
  if (best.n == 0 ||
      (kind == PH_TC_ONE_OR_PAIR && !(best.distance <= tolerance))) {
    try_pair(&part, enough, &best);
  }
  return best;
}
