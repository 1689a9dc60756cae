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
  const ph_cplx *p; /* [degree + 1] */
  size_t degree;
  double lost; /* how far it may be from the curve itself */
};

/* The part between two knots, in t->part: of a low degree where that does. */
static struct part part_of(const struct ph_tc_target *t,
                           const struct ph_tc_knot *from,
                           const struct ph_tc_knot *to, double tolerance) {
  struct part part = {.t = t, .p = t->part, .lost = 0};
  size_t n = t->degree;
  part.degree = ph_bern_low_part(&t->low, from->u, to->u, LOST * tolerance,
                                 t->part, &part.lost);
  if (part.degree > 0) {
    return part;
  }
  part.degree = n;
  part.lost = 0;
  ph_bern_cut(t->p, n, to->u, t->cut, t->spare);
  ph_bern_cut(t->cut, n, from->u / to->u, t->spare, t->part);
  t->part[0] = from->p;
  t->part[n] = to->p;
  return part;
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

static void try_one(const struct part *part, const struct ph_tc_knot *from,
                    const struct ph_tc_knot *to, double enough,
                    struct ph_tc_patch *best) {
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
    distance = distance_of(part, &tc, from->p, to->p, enough);
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

static void try_pair(const struct part *part, const struct ph_tc_knot *from,
                     const struct ph_tc_knot *to, double enough,
                     struct ph_tc_patch *best) {
  const struct ph_tc_target *t = part->t;
  struct part half[2] = {*part, *part};
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
  half[0].p = t->cut;
  half[1].p = t->spare;
  ph_bern_cut(part->p, part->degree, 0.5, t->cut, t->spare);
  patch.distance =
      fmax(distance_of(&half[0], &patch.tc[0], from->p, patch.joint, enough),
           distance_of(&half[1], &patch.tc[1], patch.joint, to->p, enough));
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
  try_one(&part, from, to, enough, &best);
  if (best.n == 0 ||
      (kind == PH_TC_ONE_OR_PAIR && !(best.distance <= tolerance))) {
    try_pair(&part, from, to, enough, &best);
  }
  return best;
}

/* ---- bounds of a distance ------------------------------------------------ */

/*
 * The distance between cubics and a polynomial curve q (see approx.h).
 *
 * Points are matched: with a monotone cubic psi from [0,1] onto itself, whose
 * slopes at the ends make r(psi(u)) as fast as q(u),
 *
 *   d(u) = r(psi(u)) - q(u)                                              (1)
 *
 * is a polynomial of degree max(9, degree), and no coefficient of its Bernstein
 * form is longer than the bound.  Both curves are halved, q in the middle and r
 * next to it, which brings psi to the fourth order nearer to the nearest points
 * and the coefficients to the second order nearer to the values.
 *
 * What psi misses along the curve counts less: where r and q both move forward
 * along the chord, as graphs with slopes of at most s, the points above the
 * same point of the chord are no further apart than
 *
 *   |d across the chord| + s |d along the chord| + e                     (2)
 *
 * with e the larger |d along the chord| at the ends, for points beyond the end
 * of the other; 0 for a straight line, however it is travelled.
 *
 * Derived here; tested by t_tc_approx_bound.c: test_known, test_random.
 */

/* Halvings that are always done, and how many more there may be; a match is
 * tight when it is within this factor of a distance that was seen.  Whatever is
 * chosen here and below, a bound is one: it may only be loose. */
enum { LEVELS = 2, DEEPER = 4, LEAVES = 1 << LEVELS };
static const double TIGHT = 1.05;

/* The cubic is cut no nearer to its ends than EDGE, as both parts must have a
 * direction; a foot is one to this cosine of the angle, or to this step; and so
 * many places are looked at where that fails. */
static const double EDGE = 0x1p-6, NORMAL = 0.1, STEP = 1e-6;
enum { PLACES = 16 };

/* The degree of r(psi(u)). */
enum { COMPOSED = 9 };

struct graph {
  ph_cplx axis; /* unit vector along the chord */
  double slope; /* infinite if the curves are no graphs over it */
  double ends;  /* e of (2) */
};

struct search {
  size_t degree;
  struct graph graph;
  double seen; /* a distance of matched points */
  double same;
  ph_cplx *pool; /* (2 LEAVES + 2 DEEPER) (degree + 1) points */
  ph_cplx *wide; /* max(COMPOSED, degree) + 1 points */
};

size_t ph_tc_match_room(size_t degree) {
  return (2 * LEAVES + 2 * DEEPER) * (degree + 1) +
         (degree > COMPOSED ? degree : COMPOSED) + 1;
}

static double larger(double a, double b) {
  return a > b || isnan(a) ? a : b;
}

/* The two inner coefficients of psi. */
static void speeds(const struct ph_tc_match *m, size_t degree, double psi[2]) {
  const ph_cplx *q = m->q, *c = m->c;
  double n = (double)degree / 9;
  double q0 = ph_cplx_abs(ph_cplx_sub(q[1], q[0]));
  double q1 = ph_cplx_abs(ph_cplx_sub(q[degree], q[degree - 1]));
  double c0 = ph_cplx_abs(ph_cplx_sub(c[1], c[0]));
  double c1 = ph_cplx_abs(ph_cplx_sub(c[3], c[2]));
  double low = n * q0 < c0 ? n * q0 / c0 : 1;
  double high = n * q1 < c1 ? 1 - n * q1 / c1 : 0;
  if (!(low <= high)) {
    low = high = (low + high) / 2;
  }
  psi[0] = low;
  psi[1] = high;
}

/* c(psi(u)), by de Casteljau's algorithm with products of Bernstein forms:
 * b <- (1 - psi) b_i + psi b_i+1. */
static void compose(const ph_cplx c[4], const double inner[2],
                    ph_cplx out[COMPOSED + 1]) {
  /* binomial(3, i) binomial(d, j) / binomial(d + 3, i + j), d = 3 and 6 */
  static const double c3[4] = {1, 3, 3, 1};
  static const double c6[7] = {1, 6, 15, 20, 15, 6, 1};
  static const double c9[10] = {1, 9, 36, 84, 126, 126, 84, 36, 9, 1};
  const double psi[4] = {0, inner[0], inner[1], 1};
  ph_cplx one[3][4], two[2][7];
  memset(two, 0, sizeof two);
  memset(out, 0, (COMPOSED + 1) * sizeof *out);
  for (size_t k = 0; k < 3; k++) {
    for (size_t i = 0; i < 4; i++) {
      one[k][i] = ph_cplx_between(c[k], c[k + 1], psi[i]);
    }
  }
  for (size_t k = 0; k < 2; k++) {
    for (size_t i = 0; i < 4; i++) {
      for (size_t j = 0; j < 4; j++) {
        ph_cplx x = ph_cplx_between(one[k][j], one[k + 1][j], psi[i]);
        two[k][i + j] = ph_cplx_add(
            two[k][i + j], ph_cplx_scale(c3[i] * c3[j] / c6[i + j], x));
      }
    }
  }
  for (size_t i = 0; i < 4; i++) {
    for (size_t j = 0; j < 7; j++) {
      ph_cplx x = ph_cplx_between(two[0][j], two[1][j], psi[i]);
      out[i + j] =
          ph_cplx_add(out[i + j], ph_cplx_scale(c3[i] * c6[j] / c9[i + j], x));
    }
  }
}

/* A bound of d on a match, by (1) or (2). */
static double upper(const struct search *s, const struct ph_tc_match *m) {
  size_t n = s->degree > COMPOSED ? s->degree : COMPOSED;
  double psi[2], whole = 0, across = 0, along = 0;
  ph_cplx r[COMPOSED + 1];
  const ph_cplx *a = s->wide, *b = r;
  speeds(m, s->degree, psi);
  compose(m->c, psi, r);
  if (s->degree > COMPOSED) {
    ph_bern_lift(r, COMPOSED, n, s->wide);
    b = m->q;
  } else {
    ph_bern_lift(m->q, s->degree, n, s->wide);
  }
  for (size_t k = 0; k <= n; k++) {
    ph_cplx d = ph_cplx_sub(a[k], b[k]);
    whole = larger(ph_cplx_norm2(d), whole);
    across = larger(fabs(ph_cplx_cross(s->graph.axis, d)), across);
    along = larger(fabs(ph_cplx_dot(s->graph.axis, d)), along);
  }
  whole = sqrt(whole);
  /* not 0 * infinity */
  across +=
      isfinite(s->graph.slope) ? s->graph.slope * along + s->graph.ends : whole;
  return across < whole ? across : whole;
}

/* The cubic cut at t. */
static ph_cplx cut(const ph_cplx c[4], double t, ph_cplx inner[4]) {
  ph_cplx b = ph_cplx_between(c[1], c[2], t);
  inner[0] = ph_cplx_between(c[0], c[1], t);
  inner[3] = ph_cplx_between(c[2], c[3], t);
  inner[1] = ph_cplx_between(inner[0], b, t);
  inner[2] = ph_cplx_between(b, inner[3], t);
  return ph_cplx_between(inner[1], inner[2], t);
}

/* Whether a cut, by its inner points and its point, is next to p, where the
 * curve goes in the direction v: on the normal, or a step from it that does not
 * matter. */
static bool is_foot(const ph_cplx inner[4], ph_cplx point, ph_cplx p,
                    ph_cplx v) {
  ph_cplx d = ph_cplx_sub(inner[2], inner[1]), miss = ph_cplx_sub(p, point);
  double along = fabs(ph_cplx_dot(miss, d)), length = ph_cplx_abs(d);
  return ph_cplx_dot(d, v) > 0 &&
         (along <= NORMAL * length * ph_cplx_abs(miss) ||
          along <= STEP * length * length);
}

/* The nearest of some places that go in the direction v, or t if none does. */
static double look_round(const ph_cplx c[4], ph_cplx p, ph_cplx v, double t) {
  double best = (double)INFINITY;
  for (int i = 1; i < PLACES; i++) {
    double at = (double)i / PLACES, away;
    ph_cplx inner[4], point = cut(c, at, inner);
    away = ph_cplx_norm2(ph_cplx_sub(p, point));
    if (away < best && ph_cplx_dot(ph_cplx_sub(inner[2], inner[1]), v) > 0) {
      best = away;
      t = at;
    }
  }
  return t;
}

/* The parameter, away from the ends, of a point of the cubic near p. */
static double approach(const ph_cplx c[4], ph_cplx p, double t) {
  for (int i = 0; i < 4; i++) {
    ph_cplx inner[4], point = cut(c, t, inner);
    ph_cplx d = ph_cplx_sub(inner[2], inner[1]);
    double step =
        ph_cplx_dot(ph_cplx_sub(p, point), d) / (3 * ph_cplx_norm2(d));
    t += isfinite(step) ? step : 0;
    t = t > EDGE ? t : EDGE;
    t = t < 1 - EDGE ? t : 1 - EDGE;
  }
  return t;
}

/*
 * Both halves of a match; their points go to q[2][degree + 1].  Where the cubic
 * has a hairpin, steps from the guess may end on its other side.
 */
static void halve(const struct ph_tc_match *m, size_t degree, ph_cplx *q,
                  struct ph_tc_match out[2]) {
  const ph_cplx *c = m->c;
  ph_cplx *left = q, *right = q + degree + 1;
  ph_cplx inner[4], point, v;
  double psi[2], guess, t;
  ph_bern_cut(m->q, degree, 0.5, left, right);
  v = ph_cplx_sub(right[1], right[0]);
  speeds(m, degree, psi);
  guess = 0.125 + 0.375 * (psi[0] + psi[1]);
  t = approach(c, right[0], guess);
  point = cut(c, t, inner);
  if (!is_foot(inner, point, right[0], v)) {
    guess = look_round(c, right[0], v, guess);
    t = approach(c, right[0], guess);
    point = cut(c, t, inner);
    if (!is_foot(inner, point, right[0], v)) {
      point = cut(c, guess, inner);
    }
  }
  out[0] = (struct ph_tc_match){left, {c[0], inner[0], inner[1], point}};
  out[1] = (struct ph_tc_match){right, {point, inner[2], inner[3], c[3]}};
}

/* The steepest of the differences of points over the axis; infinite if one is
 * above 1, where (2) gains nothing. */
static double steepest(const struct search *s, const ph_cplx *p, size_t degree,
                       double slope) {
  for (size_t k = 0; k < degree; k++) {
    ph_cplx d = ph_cplx_sub(p[k + 1], p[k]);
    double x = ph_cplx_dot(s->graph.axis, d);
    double y = fabs(ph_cplx_cross(s->graph.axis, d));
    if (x <= s->same && y <= s->same && x >= -s->same) {
      continue; /* it says nothing */
    }
    slope = y <= x ? larger(y / x, slope) : (double)INFINITY;
  }
  return slope;
}

/* The bound of a match, halved until it is tight. */
static double refine(struct search *s, const struct ph_tc_match *m, int depth) {
  struct ph_tc_match half[2];
  double bound = upper(s, m), a, b;
  if (depth == DEEPER || bound <= TIGHT * s->seen) {
    return bound;
  }
  halve(m, s->degree,
        s->pool + (2 * LEAVES + 2 * (size_t)depth) * (s->degree + 1), half);
  a = refine(s, &half[0], depth + 1);
  b = refine(s, &half[1], depth + 1);
  return larger(a, b);
}

/* The axis of a match, and d at its ends. */
static void begin(struct search *s, const struct ph_tc_match *m) {
  ph_cplx chord = ph_cplx_sub(m->c[3], m->c[0]);
  ph_cplx first = ph_cplx_sub(m->c[0], m->q[0]);
  ph_cplx last = ph_cplx_sub(m->c[3], m->q[s->degree]);
  ph_cplx axis = ph_cplx_scale(1 / ph_cplx_abs(chord), chord);
  s->graph.axis = axis;
  s->graph.slope = 0;
  s->graph.ends =
      larger(fabs(ph_cplx_dot(axis, first)), fabs(ph_cplx_dot(axis, last)));
  s->seen = larger(ph_cplx_abs(first), ph_cplx_abs(last));
}

double ph_tc_match_distance(const struct ph_tc_match *match, size_t degree,
                            double same, double enough, ph_cplx *pool) {
  size_t step = degree + 1, n = 1;
  struct search s = {.degree = degree, .same = same, .pool = pool};
  struct ph_tc_match level[2][LEAVES];
  double bound = 0;
  s.wide = pool + (2 * LEAVES + 2 * DEEPER) * step;
  begin(&s, match);
  level[0][0] = *match;
  for (size_t k = 0; k < LEVELS; k++, n *= 2) {
    for (size_t i = 0; i < n; i++) {
      ph_cplx *q = pool + (k % 2 * LEAVES + 2 * i) * step;
      halve(&level[k % 2][i], degree, q, &level[(k + 1) % 2][2 * i]);
    }
  }
  for (size_t i = 0; i < n; i++) {
    const struct ph_tc_match *m = &level[LEVELS % 2][i];
    double seen = ph_cplx_abs(ph_cplx_sub(m->q[0], m->c[0]));
    s.graph.slope = steepest(&s, m->q, degree, s.graph.slope);
    s.graph.slope = steepest(&s, m->c, 3, s.graph.slope);
    s.seen = larger(seen, s.seen);
  }
  s.seen = larger(s.seen, same);
  for (size_t i = 0; i < n; i++) {
    const struct ph_tc_match *m = &level[LEVELS % 2][i];
    bound = larger(refine(&s, m, s.seen > enough ? DEEPER : 0), bound);
  }
  return bound;
}
