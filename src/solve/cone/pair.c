/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Two contact elements to two strips (see cone.h).
 *
 * The contact points, where both arcs begin and end, are on the rulings, where
 * one sphere touches both tangent planes.  Its centre m solves
 *
 *   (m - p1) . d1 = 0,  (m - p2) . d2 = 0,  (m - p1) . n1 = (m - p2) . n2
 *
 * [GON18, (4.2), where m2.n1 stands for m2.n2].  Of neighbours the rows are all
 * but the same: half the sum of the first two, and the differences over their
 * lengths, have the digits that the data have.  The first two of these are
 * orthogonal.
 *
 * The arcs are those of a biarc on the sphere, (4.4) with d1.d2 for e1.e2, and
 * (4.5), which hold without a sphere, too, where the axes are parallel.
 *
 * Where the rulings meet, the sphere is no more than that point, and the biarc
 * is on any sphere about it: its contact points have one distance from it, a2 -
 * a1 is normal to e1 + e2.
 */
#include "solve/cone/cone.h"

#include <math.h>

/* Differences of unit vectors below this are rounding. */
static const double SAME = 1e-13;

/* A pair whose last frame misses by less than this is as good as any. */
static const double EXACT = 1e-12;

/* What is small beside the distance of the points counts as nothing. */
static const double NOTHING = 1e-8;

/* An arc, or the distance of contact points, below this is none, relative. */
static const double NO_ARC = 1e-12;

const char *ph_cone_reason_text(enum ph_cone_reason reason) {
  static const char *const texts[] = {
      [PH_CONE_OK] = "has a pair of cones",
      [PH_CONE_REVERSED] = "has no pair of cones: one contact element is the "
                           "other one turned by 180 degrees; ruling and "
                           "tangent must not turn back",
      [PH_CONE_PLANES] = "has no pair of cones: the tangent planes are "
                         "parallel, and not the same",
      [PH_CONE_SADDLE] = "has no pair of circular cones: the rulings are those "
                         "of a saddle, as of a helicoid; see whether one "
                         "of them points the other way",
      [PH_CONE_CONTACT] = "has no pair of cones: the arcs would begin and end "
                          "at the same point",
      [PH_CONE_LAMBDA] = "has no pair of cones with such legs: the second "
                         "contact element is not ahead of the first, or no "
                         "second leg belongs to this lambda",
      [PH_CONE_ARC] = "has no pair of cones with this lambda: one of the arcs "
                      "would have no length, or go all around"};
  return texts[reason];
}

/* ---- the contact points -------------------------------------------------- */

/* The equations of the centre, from the middle of both points. */
struct rows {
  ph_vec3 row[3];
  double rhs[3];
  ph_vec3 cross[3]; /* of the two rows that follow */
  double size[3];   /* of that */
  size_t largest;
  double to_by, to_up; /* over the lengths of differences; 0: there is none */
};

/* A difference that is nothing has no row, but a right hand side, which is to
 * be nothing, too. */
static struct rows rows_of(const struct ph_contact_element *first,
                           const struct ph_contact_element *last,
                           ph_vec3 half) {
  const ph_vec3 sum = ph_vec3_add(first->d, last->d);
  const ph_vec3 by = ph_vec3_sub(last->d, first->d);
  const ph_vec3 up = ph_vec3_sub(first->n, last->n);
  const double by_size = ph_vec3_abs(by), up_size = ph_vec3_abs(up);
  const double to_by = by_size > SAME ? 1 / by_size : 0;
  const double to_up = up_size > SAME ? 1 / up_size : 0;
  struct rows rows = {
      .row = {ph_vec3_scale(0.5, sum), ph_vec3_scale(to_by, by),
              ph_vec3_scale(to_up, up)},
      .rhs = {0.5 * ph_vec3_dot(by, half),
              (by_size > SAME ? to_by : 1) * ph_vec3_dot(sum, half),
              -(up_size > SAME ? to_up : 1) *
                  ph_vec3_dot(ph_vec3_add(first->n, last->n), half)},
      .to_by = to_by,
      .to_up = to_up};
  for (size_t i = 0; i < 3; i++) {
    rows.cross[i] = ph_vec3_cross(rows.row[(i + 1) % 3], rows.row[(i + 2) % 3]);
    rows.size[i] = ph_vec3_abs(rows.cross[i]);
    rows.largest = rows.size[i] > rows.size[rows.largest] ? i : rows.largest;
  }
  return rows;
}

/* What the steps below share; half: from the middle to the second point. */
struct elements {
  const struct ph_contact_element *first, *last;
  ph_vec3 half;
  double apart; /* of the points */
  double degenerate;
  unsigned tried; /* cases that are not to be taken again, as bits */
};

/* The points where a sphere touches. */
static void touch(const struct elements *in, ph_vec3 center,
                  struct ph_cone_pair *pair) {
  const ph_vec3 from = ph_vec3_add(center, in->half);
  pair->center = center;
  pair->radius = ph_vec3_dot(from, in->first->n);
  pair->shift[0] = ph_vec3_dot(from, in->first->e);
  pair->shift[1] = ph_vec3_dot(ph_vec3_sub(center, in->half), in->last->e);
}

/* Of a line of centres the one whose points are nearest to the given ones. */
static void touch_nearest(const struct elements *in, const struct rows *rows,
                          ph_vec3 w, struct ph_cone_pair *pair) {
  const size_t i = (rows->largest + 1) % 3, j = (rows->largest + 2) % 3;
  const ph_vec3 sum =
      ph_vec3_along(ph_vec3_scale(rows->rhs[i], ph_vec3_cross(rows->row[j], w)),
                    rows->rhs[j], ph_vec3_cross(w, rows->row[i]));
  const ph_vec3 m = ph_vec3_scale(1 / rows->size[rows->largest], sum);
  const double a = ph_vec3_dot(w, in->first->e);
  const double b = ph_vec3_dot(w, in->last->e);
  const double t = (a * ph_vec3_dot(ph_vec3_add(m, in->half), in->first->e) +
                    b * ph_vec3_dot(ph_vec3_sub(m, in->half), in->last->e)) /
                   (a * a + b * b);
  pair->which = PH_PAIR_PENCIL;
  touch(in, ph_vec3_along(m, -t, w), pair);
}

/* Whether the rulings meet, but not far away. */
static bool meets(const struct elements *in) {
  const ph_vec3 w = ph_vec3_cross(in->first->e, in->last->e);
  const double size = ph_vec3_abs(w);
  return size > in->degenerate && 2 * fabs(ph_vec3_dot(w, in->half)) <=
                                      in->degenerate * size * in->apart;
}

/* Of all spheres about the point where they do, the one nearest to the given
 * points; where it is that point, which they have between them, another. */
static void touch_apex(const struct elements *in, struct ph_cone_pair *pair) {
  const ph_vec3 e = ph_vec3_add(in->first->e, in->last->e);
  const double s = 2 * ph_vec3_dot(in->half, e) / ph_vec3_dot(e, e);
  const ph_vec3 rest = ph_vec3_along(in->half, -s / 2, e);
  const double more = 2 * ph_vec3_abs(rest) > NOTHING * in->apart ? 0 : 1;
  pair->which = PH_PAIR_APEX;
  pair->shift[0] = s + more * in->apart;
  pair->shift[1] = -s + more * in->apart;
}

/* How far the right hand sides are from those of dependent rows. */
static double inconsistency(const struct rows *rows, ph_vec3 w) {
  double sum = 0, squares = 0;
  for (size_t i = 0; i < 3; i++) {
    const double y = ph_vec3_dot(rows->cross[i], w);
    sum += y * rows->rhs[i];
    squares += y * y;
  }
  return fabs(sum) / sqrt(squares);
}

static bool is_tried(const struct elements *in, enum ph_pair_case which) {
  return in->tried >> which & 1;
}

/* No sphere, or many: w is along the line of centres, or both axes. */
static enum ph_cone_reason without_sphere(const struct elements *in,
                                          const struct rows *rows, ph_vec3 w,
                                          bool rank2,
                                          struct ph_cone_pair *pair) {
  const double nothing = fmax(NOTHING, in->degenerate);
  const double a = ph_vec3_dot(w, in->first->e);
  const double b = ph_vec3_dot(w, in->last->e);
  const double along = ph_vec3_dot(w, in->half);
  const double off = fmax(fabs(ph_vec3_dot(in->first->n, in->half)),
                          fabs(ph_vec3_dot(in->last->n, in->half)));
  if (fabs(a) < nothing) {
    pair->which = PH_PAIR_FLAT;
    return 2 * off > nothing * in->apart ? PH_CONE_PLANES : PH_CONE_OK;
  }
  if (rank2 && !is_tried(in, PH_PAIR_PENCIL) &&
      inconsistency(rows, w) <= nothing * in->apart) {
    touch_nearest(in, rows, w, pair);
    return PH_CONE_OK;
  }
  if (!is_tried(in, PH_PAIR_APEX) && meets(in)) {
    touch_apex(in, pair);
    return PH_CONE_OK;
  }
  pair->which = PH_PAIR_PARALLEL;
  pair->shift[0] = along / a;
  pair->shift[1] = -along / b;
  return a * b > 0 ? PH_CONE_OK : PH_CONE_SADDLE;
}

/* ---- far spheres --------------------------------------------------------- */

/* a + b = sum + ret */
static double two_sum(double a, double b, double *sum) {
  const double s = a + b, c = s - a;
  *sum = s;
  return (a - (s - c)) + (b - c);
}

/* a b = product + ret, by halves of the digits. */
static double two_product(double a, double b, double *product) {
  static const double SPLIT = 134217729; /* 2^27 + 1 */
  const double p = a * b, x = SPLIT * a, y = SPLIT * b;
  const double a1 = x - (x - a), b1 = y - (y - b), a2 = a - a1, b2 = b - b1;
  *product = p;
  return ((a1 * b1 - p) + a1 * b2 + a2 * b1) + a2 * b2;
}

/* s + (a + sign b) . c with twice the digits, of which the first are in s. */
static double add_dot(double *s, ph_vec3 a, double sign, ph_vec3 b, ph_vec3 c) {
  const double terms[6][2] = {{a.x, c.x},        {a.y, c.y},
                              {a.z, c.z},        {sign * b.x, c.x},
                              {sign * b.y, c.y}, {sign * b.z, c.z}};
  double low = 0, p;
  for (size_t i = 0; i < 6; i++) {
    low += two_product(terms[i][0], terms[i][1], &p);
    low += two_sum(*s, p, s);
  }
  return low;
}

/*
 * What the equations lack of a centre, to as many digits as they have
 * themselves.  Of a sphere that is 1/sigma times as far as the points are
 * apart, a step with these brings as many digits as one without has lost.
 */
static void residuals(const struct elements *in, const struct rows *rows,
                      ph_vec3 m, double left[3]) {
  double first = 0, last = 0, up = 0, first_low, last_low, up_low;
  const ph_vec3 down = ph_vec3_scale(-1, in->last->n);
  first_low = add_dot(&first, m, 1, in->half, in->first->d);
  last_low = add_dot(&last, m, -1, in->half, in->last->d);
  up_low = add_dot(&up, m, 1, in->half, in->first->n);
  up_low += add_dot(&up, m, -1, in->half, down);
  first += first_low;
  last += last_low;
  left[0] = -(first + last) / 2;
  left[1] = (first - last) * rows->to_by;
  left[2] = -(up + up_low) * rows->to_up;
}

/* The solution of the equations with a right hand side. */
static ph_vec3 center_of(const struct rows *rows, double det,
                         const double rhs[3]) {
  ph_vec3 m = ph_vec3_scale(rhs[0], rows->cross[0]);
  m = ph_vec3_along(m, rhs[1], rows->cross[1]);
  m = ph_vec3_along(m, rhs[2], rows->cross[2]);
  return ph_vec3_scale(1 / det, m);
}

static enum ph_cone_reason find_contact(const struct elements *in,
                                        struct ph_cone_pair *pair) {
  const struct ph_contact_element *first = in->first, *last = in->last;
  const struct rows rows = rows_of(first, last, in->half);
  const double size = rows.size[rows.largest];
  const double det = ph_vec3_dot(rows.row[0], rows.cross[0]);
  const double nan = (double)NAN;
  double left[3];
  ph_vec3 m;
  pair->center = ph_vec3_of(nan, nan, nan);
  pair->radius = nan;
  pair->shift[0] = pair->shift[1] = 0;
  if (!(size > in->degenerate)) {
    return ph_vec3_dot(first->e, last->e) > 0 &&
                   ph_vec3_dot(first->d, last->d) > 0
               ? without_sphere(in, &rows, first->e, false, pair)
               : PH_CONE_REVERSED;
  }
  if (!(fabs(det) > in->degenerate * size)) {
    return without_sphere(in, &rows,
                          ph_vec3_scale(1 / size, rows.cross[rows.largest]),
                          true, pair);
  }
  if (meets(in)) {
    touch_apex(in, pair);
    return PH_CONE_OK;
  }
  m = center_of(&rows, det, rows.rhs);
  residuals(in, &rows, m, left);
  pair->which = PH_PAIR_SPHERE;
  touch(in, ph_vec3_add(m, center_of(&rows, det, left)), pair);
  return PH_CONE_OK;
}

/* ---- the arcs ------------------------------------------------------------ */

/* The legs, and the chords of both arcs, of which the sum is a, that between
 * the contact points.  The second one is not taken as the difference, which has
 * no digits where it is short.  Where the second leg is infinite, nothing else
 * is.
 */
static enum ph_cone_reason find_chords(const struct elements *in, ph_vec3 a,
                                       double lambda, struct ph_cone_pair *pair,
                                       ph_vec3 chord[2]) {
  const ph_vec3 d1 = in->first->d, d2 = in->last->d, by = ph_vec3_sub(d2, d1);
  const double aa = ph_vec3_dot(a, a), turn = 0.5 * ph_vec3_dot(by, by);
  const double ad1 = ph_vec3_dot(a, d1), ad2 = ph_vec3_dot(a, d2);
  const double sum = ad1 + ad2;
  const double root = sqrt(sum * sum + 2 * aa * turn);
  const double high = ad1 > 0 ? 0.5 * aa / ad1 : HUGE_VAL;
  const double low = turn > 0 ? fmax(0, -ad2 / turn) : ad2 > 0 ? 0 : HUGE_VAL;
  double n, d, size;
  if (isnan(lambda)) {
    lambda = !(sum < 0)               ? aa / (root + sum)
             : 2 * turn > SAME * SAME ? (root - sum) / (2 * turn)
                                      : HUGE_VAL;
  }
  n = 0.5 * aa - lambda * ad1;
  d = ad2 + lambda * turn;
  size = lambda * d + n;
  pair->lambda[0] = lambda;
  pair->lambda[1] = fabs(d) > 0 ? n / d : (double)NAN;
  pair->interval[0] = fmin(low, high);
  pair->interval[1] = fmax(low, high);
  if (!(lambda > 0 && lambda < HUGE_VAL) || !(fabs(size) > SAME * aa)) {
    return PH_CONE_LAMBDA;
  }
  chord[0] =
      ph_vec3_scale(lambda / size, ph_vec3_along(ph_vec3_scale(d, a), -n, by));
  chord[1] = ph_vec3_scale(n / size, ph_vec3_along(a, lambda, by));
  return PH_CONE_OK;
}

/* A strip along v, and the frame at its end. */
static bool follow(struct ph_cone_strip *strip, ph_vec3 v,
                   struct ph_cone_strip *end) {
  const double vv = ph_vec3_dot(v, v), chord = sqrt(vv);
  const double along = ph_vec3_dot(v, strip->d);
  const double across = ph_vec3_abs(ph_vec3_cross(strip->d, v));
  const double angle = atan2(across, along);
  strip->k = 2 * ph_vec3_dot(v, strip->e) / vv;
  strip->kn = 2 * ph_vec3_dot(v, strip->n) / vv;
  strip->length = across > 0 ? chord * chord / across * angle : chord;
  strip->chord = chord;
  strip->weight = cos(angle); /* never 0 */
  end->c = ph_vec3_add(strip->c, v);
  end->e = ph_vec3_along(strip->e, -strip->k, v);
  end->n = ph_vec3_along(strip->n, -strip->kn, v);
  end->d = ph_vec3_along(ph_vec3_scale(-1, strip->d), 2 * along / vv, v);
  return across > NO_ARC * chord || along > 0;
}

/* The largest coordinate of a difference. */
static double differ(ph_vec3 a, ph_vec3 b) {
  return fmax(fmax(fabs(a.x - b.x), fabs(a.y - b.y)), fabs(a.z - b.z));
}

static enum ph_cone_reason find_strips(const struct elements *in,
                                       const ph_vec3 chord[2],
                                       struct ph_cone_pair *pair) {
  struct ph_cone_strip *s = pair->strip, end;
  bool both;
  if (!(ph_vec3_abs(chord[0]) > NO_ARC * pair->chord) ||
      !(ph_vec3_abs(chord[1]) > NO_ARC * pair->chord)) {
    return PH_CONE_ARC;
  }
  s[0].c =
      ph_vec3_along(ph_vec3_scale(-1, in->half), pair->shift[0], in->first->e);
  s[0].e = in->first->e;
  s[0].d = in->first->d;
  s[0].n = in->first->n;
  both = follow(&s[0], chord[0], &s[1]);
  both = follow(&s[1], chord[1], &end) && both;
  pair->residual =
      fmax(differ(end.e, in->last->e),
           fmax(differ(end.d, in->last->d), differ(end.n, in->last->n)));
  return both ? PH_CONE_OK : PH_CONE_ARC;
}

static enum ph_cone_reason attempt(const struct elements *in, double lambda,
                                   struct ph_cone_pair *pair) {
  enum ph_cone_reason reason = find_contact(in, pair);
  ph_vec3 a, chord[2];
  if (reason != PH_CONE_OK) {
    return reason;
  }
  a = ph_vec3_along(ph_vec3_scale(2, in->half), pair->shift[1], in->last->e);
  a = ph_vec3_along(a, -pair->shift[0], in->first->e);
  pair->chord = ph_vec3_abs(a);
  if (!(pair->chord > NO_ARC * (in->apart + fabs(pair->shift[0])))) {
    return PH_CONE_CONTACT;
  }
  reason = find_chords(in, a, lambda, pair, chord);
  return reason == PH_CONE_OK ? find_strips(in, chord, pair) : reason;
}

/* Data with noise may be within the tolerance of several cases: that is taken
 * whose last frame misses the least. */
enum ph_cone_reason ph_cone_pair(const struct ph_contact_element *first,
                                 const struct ph_contact_element *last,
                                 double lambda, double degenerate,
                                 struct ph_cone_pair *pair) {
  const ph_vec3 way = ph_vec3_sub(last->p, first->p);
  struct elements in = {
      first, last, ph_vec3_scale(0.5, way), ph_vec3_abs(way), degenerate, 0};
  const enum ph_cone_reason reason = attempt(&in, lambda, pair);
  struct ph_cone_pair next;
  if (reason != PH_CONE_OK || pair->residual <= EXACT) {
    return reason;
  }
  next.which = pair->which;
  while ((next.which == PH_PAIR_PENCIL || next.which == PH_PAIR_APEX) &&
         !is_tried(&in, next.which)) {
    in.tried |= 1u << next.which;
    if (attempt(&in, lambda, &next) == PH_CONE_OK &&
        next.residual < pair->residual) {
      *pair = next;
    }
  }
  return PH_CONE_OK;
}
