/* SPDX-License-Identifier: GPL-3.0-or-later */
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
#include "solve/tc/approx.h"

#include "kernel/bern.h"

#include <math.h>
#include <string.h>

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

/* Points of the curve that are compared with places of the cubic, some of which
 * are no farther than half a step from any other. */
enum { POINTS = 3 };

double ph_tc_least_distance(const struct ph_tc_target *t, double from,
                            double to, const ph_cplx c[4]) {
  double away = 0, leg = 0;
  for (int i = 0; i < 3; i++) {
    leg = fmax(leg, ph_cplx_abs(ph_cplx_sub(c[i + 1], c[i])));
  }
  for (int i = 1; i <= POINTS; i++) {
    double u = from + (to - from) * i / (POINTS + 1);
    ph_cplx p = ph_bern_value(t->p, t->degree, u), inner[4];
    double nearest = (double)INFINITY;
    for (int k = 0; k <= PLACES; k++) {
      ph_cplx place = cut(c, (double)k / PLACES, inner);
      nearest = fmin(nearest, ph_cplx_abs(ph_cplx_sub(p, place)));
    }
    away = fmax(away, nearest - 3 * leg / (2 * PLACES));
  }
  return away;
}
