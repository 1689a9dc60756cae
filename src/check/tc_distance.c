/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Bounds of the distance of cubics from a curve (see tc_distance.h). */
#include "check/tc_distance.h"

#include "check/error.h"
#include "kernel/bern.h"

#include <float.h>
#include <math.h>
#include <string.h>

/* r of degree 3 after psi of degree 3. */
enum { COMPOSED = 9 };

/* A part is 2^-DEPTH of a cubic at least, of which there are at most PARTS. */
enum { DEPTH = 12, PARTS = 512 };

/* A whole and two halves of each depth, and two that are subtracted. */
enum { ROOM = 2 * DEPTH + 3 };

/* Steps to the nearest point: each leaves (distance times curvature) of the
 * error of the one before. */
enum { STEPS = 4 };

/* A near point is not nearer than this part of it to an end of a part. */
static const double EDGE = 1.0 / 16;

/* A bound within this of a distance that there is is good. */
static const double GOOD = 1.05;

/* What a part of a low degree may be off the curve, over a distance that there
 * is. */
static const double LOST = 1e-3;

/* Rounding of a difference, in eps of the largest coordinate: of cuts, 1.5 for
 * each degree and each of DEPTH + 2 of them, of raising, and of composing. */
static const double NOISE_BY_DEGREE = 24, NOISE = 24;

/*
 * How points are matched: with the nearest ones, and psi by their projection;
 * or with near ones, but for the ends of what there is to match with, and psi
 * by the speeds of both.  In a hairpin what is nearest may be on the wrong
 * side, and all that follows suffers from one bad match: then other points are.
 */
struct way {
  bool nearest;
  double cut; /* where the curve is cut */
};

static const struct way WAYS[] = {
    {true, 0.5}, {false, 0.5}, {false, 0.375}, {false, 0.625}, {true, 0.4375}};

/* A part of the curve, and of the cubic that it is matched with. */
struct part {
  struct way way;
  ph_cplx *c; /* [degree + 1] */
  size_t degree;
  const ph_cplx *cubic; /* the whole one */
  double from, to;      /* the part of it */
  double inner[2];      /* psi is 0, inner, 1 */
};

bool ph_check_distance_begin(struct ph_check_distance *d,
                             struct ph_arena *arena, size_t degree,
                             double allowed) {
  size_t size = (degree > COMPOSED ? degree : COMPOSED) + 1;
  *d = (struct ph_check_distance){
      .arena = arena, .size = size, .allowed = allowed};
  d->room = ph_arena_array(arena, ROOM, size * sizeof *d->room);
  return d->room != NULL;
}

static ph_cplx *room_of(const struct ph_check_distance *d, size_t i) {
  return d->room + i * d->size;
}

/* x in [0,1], or `none` where it is no number. */
static double inside(double x, double none) {
  return x <= 0 ? 0 : x >= 1 ? 1 : isnan(x) ? none : x;
}

/* ---- pieces of polynomials ---------------------------------------------- */

/* The polar form of a cubic. */
static ph_cplx polar(const ph_cplx p[4], double x, double y, double z) {
  ph_cplx a = ph_cplx_between(p[0], p[1], x);
  ph_cplx b = ph_cplx_between(p[1], p[2], x);
  ph_cplx c = ph_cplx_between(p[2], p[3], x);
  a = ph_cplx_between(a, b, y);
  b = ph_cplx_between(b, c, y);
  return ph_cplx_between(a, b, z);
}

/* ---- the difference ----------------------------------------------------- */

/* Adds the product of p and q, both coefficients times binomials. */
static void add_product(const ph_cplx *p, size_t n, const double q[4],
                        ph_cplx *sum) {
  for (size_t i = 0; i <= n; i++) {
    for (size_t j = 0; j < 4; j++) {
      sum[i + j].re += q[j] * p[i].re;
      sum[i + j].im += q[j] * p[i].im;
    }
  }
}

/* r(psi), by de Casteljau's algorithm with polynomials.
 * out  out[COMPOSED + 1] */
static void compose(const ph_cplx r[4], const double inner[2], ph_cplx *out) {
  static const double binomial[] = {1, 9, 36, 84, 126, 126, 84, 36, 9, 1};
  const double psi[4] = {0, 3 * inner[0], 3 * inner[1], 1};
  const double rest[4] = {1, 3 * (1 - inner[0]), 3 * (1 - inner[1]), 0};
  ph_cplx one[3][4] = {{{0, 0}}}, two[2][7] = {{{0, 0}}};
  for (size_t j = 0; j < 3; j++) {
    add_product(&r[j], 0, rest, one[j]);
    add_product(&r[j + 1], 0, psi, one[j]);
  }
  for (size_t j = 0; j < 2; j++) {
    add_product(one[j], 3, rest, two[j]);
    add_product(one[j + 1], 3, psi, two[j]);
  }
  memset(out, 0, (COMPOSED + 1) * sizeof *out);
  add_product(two[0], 6, rest, out);
  add_product(two[1], 6, psi, out);
  for (size_t k = 0; k <= COMPOSED; k++) {
    out[k] = ph_cplx_scale(1 / binomial[k], out[k]);
  }
}

/* A third of the slope of psi at an end, from the legs there. */
static double slope(bool nearest, ph_cplx leg, size_t degree, ph_cplx r) {
  double square = ph_cplx_norm2(r);
  double step =
      nearest ? ph_cplx_dot(leg, r) / square : ph_cplx_abs(leg) / sqrt(square);
  return (double)degree / 9 * step;
}

/* The part of r, and the difference, r first. */
struct difference {
  ph_cplx r[4];
  const ph_cplx *composed, *c;
  size_t degree;
};

/* Sets psi of the part, too. */
static void subtract(const struct ph_check_distance *d, struct part *part,
                     struct difference *out) {
  bool nearest = part->way.nearest;
  ph_cplx *composed = room_of(d, ROOM - 2), *c = room_of(d, ROOM - 1);
  ph_cplx nine[COMPOSED + 1];
  double x = part->from, y = part->to;
  size_t n = part->degree, degree = n > COMPOSED ? n : COMPOSED;
  ph_cplx *r = out->r;
  r[0] = polar(part->cubic, x, x, x);
  r[1] = polar(part->cubic, x, x, y);
  r[2] = polar(part->cubic, x, y, y);
  r[3] = polar(part->cubic, y, y, y);
  part->inner[0] = inside(slope(nearest, ph_cplx_sub(part->c[1], part->c[0]), n,
                                ph_cplx_sub(r[1], r[0])),
                          1.0 / 3);
  part->inner[1] =
      inside(1 - slope(nearest, ph_cplx_sub(part->c[n], part->c[n - 1]), n,
                       ph_cplx_sub(r[3], r[2])),
             2.0 / 3);
  if (!(part->inner[0] <= part->inner[1])) {
    part->inner[0] = part->inner[1] = (part->inner[0] + part->inner[1]) / 2;
  }
  compose(r, part->inner, nine);
  ph_bern_lift(nine, COMPOSED, degree, composed);
  ph_bern_lift(part->c, n, degree, c);
  out->composed = composed;
  out->c = c;
  out->degree = degree;
}

/* (1) */
static double plain_bound(const struct difference *f) {
  double largest = 0;
  for (size_t k = 0; k <= f->degree; k++) {
    double away = ph_cplx_norm2(ph_cplx_sub(f->composed[k], f->c[k]));
    if (ph_check_is_larger(away, largest)) {
      largest = away;
    }
  }
  return sqrt(largest);
}

/* The steepest leg over an axis, or what there was; infinite where one does not
 * go forward, but for those that are rounding. */
static double steepest(const ph_cplx *p, size_t degree, ph_cplx axis,
                       double noise, double so_far) {
  for (size_t i = 0; i < degree; i++) {
    ph_cplx leg = ph_cplx_sub(p[i + 1], p[i]);
    double along = ph_cplx_dot(axis, leg);
    double across = fabs(ph_cplx_cross(axis, leg));
    if (fabs(along) > noise || across > noise) {
      so_far = along > 0 ? ph_check_larger(so_far, across / along) : HUGE_VAL;
    }
  }
  return so_far;
}

/* (2), infinite where it does not hold. */
static double graph_bound(const struct ph_check_distance *d,
                          const struct part *part, const struct difference *f) {
  ph_cplx chord = ph_cplx_sub(f->r[3], f->r[0]);
  ph_cplx axis = ph_cplx_scale(1 / ph_cplx_abs(chord), chord);
  double along = 0, across = 0, end = 0, slope;
  slope = steepest(f->r, 3, axis, d->noise, 0);
  slope = steepest(part->c, part->degree, axis, d->noise, slope);
  if (!(slope <= 1)) {
    return HUGE_VAL;
  }
  for (size_t k = 0; k <= f->degree; k++) {
    ph_cplx miss = ph_cplx_sub(f->composed[k], f->c[k]);
    double x = fabs(ph_cplx_dot(axis, miss));
    along = ph_check_larger(along, x);
    across = ph_check_larger(across, fabs(ph_cplx_cross(axis, miss)));
    if (k == 0 || k == f->degree) {
      end = ph_check_larger(end, x);
    }
  }
  return across + slope * along + end;
}

/* ---- parts -------------------------------------------------------------- */

static double distance_at(const struct part *part, double s, ph_cplx p) {
  return ph_cplx_abs(ph_cplx_sub(polar(part->cubic, s, s, s), p));
}

/* The parameter in [low, high] of a point of r that is near to p: from where
 * psi has it by steps that are taken as long as they help. */
static double near(const struct part *part, double s, double low, double high,
                   ph_cplx p) {
  double away = distance_at(part, s, p);
  for (int i = 0; i < STEPS; i++) {
    ph_cplx a = polar(part->cubic, s, s, 0), b = polar(part->cubic, s, s, 1);
    ph_cplx along = ph_cplx_scale(3, ph_cplx_sub(b, a));
    ph_cplx miss = ph_cplx_sub(p, ph_cplx_between(a, b, s));
    double next = s + ph_cplx_dot(miss, along) / ph_cplx_norm2(along), there;
    next = next > low ? next : low;
    next = next < high ? next : high;
    there = distance_at(part, next, p);
    if (!(there < away)) {
      break;
    }
    s = next;
    away = there;
  }
  return s;
}

/* The parameter of the point of r that p, where the part is cut, is matched
 * with. */
static double match(const struct part *part, ph_cplx p) {
  double width = part->to - part->from, u = part->way.cut, v = 1 - u;
  double edge = part->way.nearest ? 0 : EDGE * width;
  double psi = u * (3 * v * (v * part->inner[0] + u * part->inner[1]) + u * u);
  return near(part, part->from + width * psi, part->from + edge,
              part->to - edge, p);
}

static void sample(struct ph_check_distance *d, const struct part *part,
                   double s, ph_cplx p) {
  d->sampled = ph_check_larger(d->sampled, distance_at(part, s, p));
}

/* Whether a part need not be halved: its bound is below `floor`, or is allowed
 * and near enough to a distance that there is. */
static bool is_done(const struct ph_check_distance *d, double bound,
                    double floor, size_t depth) {
  return bound <= floor || depth == DEPTH || d->parts >= PARTS ||
         ph_arena_late(d->arena) ||
         (bound <= d->allowed + d->noise &&
          bound <= GOOD * d->sampled + 2 * d->noise);
}

/* The better bound of the part as a whole.  Also sets its psi. */
static double bound_of(const struct ph_check_distance *d, struct part *part,
                       double floor, size_t depth) {
  struct difference f;
  double bound, graph;
  subtract(d, part, &f);
  bound = plain_bound(&f) + d->noise;
  if (is_done(d, bound, floor, depth)) {
    return bound;
  }
  graph = graph_bound(d, part, &f) + d->noise;
  return graph < bound ? graph : bound;
}

/* The bound of a part, by halves where that helps.
 *
 * in   floor  what bound there is of other parts */
static double bound_part(struct ph_check_distance *d, struct part *part,
                         double floor, size_t depth) {
  double bound = bound_of(d, part, floor, depth), halves;
  struct part half[2] = {*part, *part};
  ph_cplx middle;
  d->parts++;
  if (is_done(d, bound, floor, depth)) {
    return bound;
  }
  half[0].c = room_of(d, 2 * depth + 1);
  half[1].c = room_of(d, 2 * depth + 2);
  ph_bern_cut(part->c, part->degree, part->way.cut, half[0].c, half[1].c);
  middle = half[1].c[0];
  half[0].to = half[1].from = match(part, middle);
  sample(d, part, half[0].to, middle);
  halves = bound_part(d, &half[0], floor, depth + 1);
  if (halves < bound) {
    floor = ph_check_larger(floor, halves);
    halves = ph_check_larger(halves, bound_part(d, &half[1], floor, depth + 1));
  }
  return ph_check_smaller(halves, bound);
}

/* What rounding may do to a bound. */
static double noise_of(const ph_cplx *curve, size_t degree,
                       const ph_cplx cubic[4]) {
  double reach = 0;
  for (size_t i = 0; i <= degree; i++) {
    reach = ph_check_larger(
        reach, ph_check_larger(fabs(curve[i].re), fabs(curve[i].im)));
  }
  for (size_t i = 0; i < 4; i++) {
    reach = ph_check_larger(
        reach, ph_check_larger(fabs(cubic[i].re), fabs(cubic[i].im)));
  }
  return (NOISE_BY_DEGREE * (double)degree + NOISE) * DBL_EPSILON * reach;
}

/* The part of the curve that a cubic stands for, of a low degree where that
 * loses little.  ret  how much */
static double part_of(const struct ph_check_distance *d, double from, double to,
                      struct part *part) {
  const ph_cplx *curve = d->low.c;
  size_t degree = d->low.degree;
  double lost;
  part->degree =
      ph_bern_low_part(&d->low, from, to, LOST * d->sampled, part->c, &lost);
  if (part->degree > 0) {
    return lost;
  }
  part->degree = degree;
  ph_bern_cut(curve, degree, to, room_of(d, 1), room_of(d, 2));
  ph_bern_cut(room_of(d, 1), degree, to > 0 ? from / to : 0, room_of(d, 2),
              part->c);
  return 0;
}

void ph_check_distance_curve(struct ph_check_distance *d, const ph_cplx *curve,
                             size_t degree) {
  ph_bern_low_of(&d->low, curve, degree, d->room);
}

void ph_check_distance_add(struct ph_check_distance *d, double from, double to,
                           const ph_cplx cubic[4]) {
  const ph_cplx *curve = d->low.c;
  size_t degree = d->low.degree;
  double bound = HUGE_VAL, lost;
  struct part whole = {.c = room_of(d, 0), .cubic = cubic, .from = 0, .to = 1};
  lost = part_of(d, from, to, &whole);
  d->noise = ph_check_larger(d->noise, noise_of(curve, degree, cubic));
  sample(d, &whole, 0, whole.c[0]);
  sample(d, &whole, 1, whole.c[whole.degree]);
  for (size_t i = 0; i < sizeof WAYS / sizeof WAYS[0] &&
                     (i == 0 || !(bound <= d->allowed + d->noise));
       i++) {
    whole.way = WAYS[i];
    d->parts = 0;
    bound = ph_check_smaller(bound, bound_part(d, &whole, d->bound, 0));
  }
  bound += lost;
  if (ph_check_is_larger(bound, d->bound)) {
    d->bound = bound;
  }
}
