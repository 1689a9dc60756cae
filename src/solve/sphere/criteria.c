/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Shape criteria of data on the sphere (see sphere.h).
 *
 * Where they differ from [IOR15, sec. 3.3]:
 *
 * The indicator there is the sign of an angle whose cosine is compared with 1,
 * which unit vectors decide by their rounding.  Here the data turn by
 *   tau_i = atan2(P_i . (A x B), A . B),   A = -Log_{P_i} P_{i-1},
 *                                          B = Log_{P_i} P_{i+1},        (1)
 * and Q_i = 0 where |sin tau_i| is at most
 *   lim_i = max(min(1e-4, epsilon (a + b) / 8), 8 u (1/a + 1/b)),        (2)
 * a and b the angles to both neighbours, u the rounding of the coordinates: the
 * angle by which a curve of geodesic curvature epsilon / 4 turns at node i. One
 * limit for all spacings would call a dense smooth track a great circle.  Where
 * the second term of (2) decides, the data do not say whether |kappa_g| <
 * epsilon, and it is not asked.
 *
 * Geodesic curvature does not tend to 0 at a node whose tension grows, as
 * [IOR15, thm. 3.2] says, but grows: |S'|^3 falls faster than K.  It does tend
 * to 0 when the tensions of both neighbours grow, which makes the velocity
 * there point along the great circle; for a run of co-circular nodes, those of
 * the two nodes that bound it.  The thesis's code has K alone for its measure
 * ("legacy"), which falls when all three tensions grow.
 *
 * That K > 0 on a segment is not tested at its ends or at a stationary point of
 * K, of which there may be several, but on all of it, in three ways:
 *
 * By the plane.  K of a plane cubic with the differences a, b, c of its control
 * points has the Bernstein coefficients
 *   B_0 = 18 a x b,   B_1 = 9 a x c,   B_2 = 18 b x c,                   (3)
 * and that of a spherical one, with a, b, c the chords and . P_0, P_1 + P_2 and
 * P_3 in the place of "x" alone, differs from it by at most
 *   C |B| (|a| + |b| + |c|)^2,   |B| the largest of the three,           (4)
 * C = 1/3 in the limit of short segments: it is positive where B_0, B_2 and
 * B_1 + sqrt(B_0 B_2) are by more than that.  This was found by experiment, not
 * proved; t_sphere_criteria.c repeats it with C = 1/2, up to a sum of 1.  B_0
 * and B_2 have the exact signs of K(0) and K(1).
 *
 * By values at nine points: one of the wrong sign rejects.
 *
 * By cubics.  On each of the eight pieces, the cubic with the same K and K' at
 * both ends is compared with K in the middle; it is accepted when all of its
 * Bernstein coefficients are above four times that error, and else the piece is
 * halved.
 */
#include "solve/sphere/sphere.h"

#include "curve/segment/spherical_net.h"
#include "kernel/s2.h"

#include <math.h>
#include <stdint.h>

static const double QTOL = 1e-4;

/* Of (4), and up to where. */
static const double FROM_PLANE = 0.5, GENTLE = 1;

/* K below this part of its largest value is rounding. */
static const double TINY = 1e-13;

/* Pieces of the parameter to begin with, and how often they may be halved. */
enum { PIECES = 8, DEPTH = 12 };

/* The sine of the turn from one vector to another at p; |.|: its size. */
static double turn_of(ph_vec3 p, ph_vec3 a, ph_vec3 b) {
  return ph_vec3_triple(p, a, b) / (ph_vec3_abs(a) * ph_vec3_abs(b));
}

/* ---- indicators ---------------------------------------------------------- */

static size_t before(const struct ph_sphere_data *d, size_t i) {
  return i > 0 ? i - 1 : d->n - 1;
}

/* Whether the data go on: the thesis asks it of the distances. */
static bool goes_on(const struct ph_sphere_shape *shape, size_t i, double a,
                    double b, double cosine) {
  const struct ph_sphere_data *d = shape->data;
  double across;
  if (!shape->legacy) {
    return cosine > 0;
  }
  across = ph_s2_angle(d->p[before(d, i)], d->p[ph_sphere_next(d, i)]);
  return across > a && across > b;
}

static void set_indicator(struct ph_sphere_shape *shape, size_t i) {
  const struct ph_sphere_data *d = shape->data;
  double a = d->theta[ph_sphere_before(d, i)], b = d->theta[i];
  ph_vec3 p = d->p[i], in = ph_s2_log(p, d->p[before(d, i)]);
  ph_vec3 out = ph_s2_log(p, d->p[ph_sphere_next(d, i)]);
  double sine = -ph_vec3_triple(p, in, out), cosine = -ph_vec3_dot(in, out);
  double size = hypot(sine, cosine);
  double curvature = fmin(QTOL, shape->epsilon * (a + b) / 8);
  double rounding = 8 * d->rounding * (1 / a + 1 / b);
  ph_vec3 from = ph_vec3_sub(p, d->p[before(d, i)]);
  ph_vec3 to = ph_vec3_sub(d->p[ph_sphere_next(d, i)], p);
  bool zero = !(fabs(sine) > fmax(curvature, rounding) * size);
  shape->turn[i] = fabs(turn_of(p, from, to));
  shape->q[i] = (signed char)(zero ? 0 : sine > 0 ? 1 : -1);
  shape->inorder[i] =
      zero && rounding <= curvature && goes_on(shape, i, a, b, cosine);
}

/* The nodes that bound the runs of nodes in order.  Closed data are gone round
 * twice, as the first run may begin before the first node. */
static void set_runs(struct ph_sphere_shape *shape) {
  const struct ph_sphere_data *d = shape->data;
  size_t steps = d->closed ? 2 * d->n : d->n;
  size_t last = SIZE_MAX, next = SIZE_MAX;
  for (size_t step = 0; step < steps; step++) {
    size_t i = step % d->n, j = d->n - 1 - i;
    shape->before[i] = last;
    shape->after[j] = next;
    last = shape->inorder[i] ? last : i;
    next = shape->inorder[j] ? next : j;
  }
}

bool ph_sphere_shape_of(const struct ph_sphere_data *data, double epsilon,
                        bool legacy, struct ph_arena *arena,
                        struct ph_sphere_shape *shape) {
  *shape = (struct ph_sphere_shape){
      .data = data, .epsilon = epsilon, .legacy = legacy};
  shape->q = ph_arena_array(arena, data->n, sizeof *shape->q);
  shape->turn = ph_arena_array(arena, data->n, sizeof *shape->turn);
  shape->inorder = ph_arena_array(arena, data->n, sizeof *shape->inorder);
  shape->before = ph_arena_array(arena, data->n, sizeof *shape->before);
  shape->after = ph_arena_array(arena, data->n, sizeof *shape->after);
  if (!shape->q || !shape->turn || !shape->inorder || !shape->before ||
      !shape->after) {
    return false;
  }
  for (size_t i = 0; i < data->n; i++) {
    shape->q[i] = 0;
    shape->turn[i] = 0;
    shape->inorder[i] = false;
    if (!ph_sphere_is_end(data, i)) {
      set_indicator(shape, i);
    }
  }
  set_runs(shape);
  return true;
}

/* ---- nodes --------------------------------------------------------------- */

static bool is_straight(const struct ph_sphere_shape *shape,
                        const struct ph_spherical_legs *left,
                        const struct ph_spherical_legs *right, size_t i) {
  const struct ph_sphere_data *d = shape->data;
  if (shape->legacy) {
    double h = d->h[i],
           k = ph_spherical_legs_numerator_start(right) / (h * h * h);
    return fabs(k) * d->theta[0] * d->theta[0] <= shape->epsilon;
  }
  return fabs(ph_spherical_legs_curvature_end(left)) < shape->epsilon &&
         fabs(ph_spherical_legs_curvature_start(right)) < shape->epsilon;
}

/* By the signs of B_0 after the node and B_2 before it, of (3). */
static bool is_convex(const struct ph_sphere_shape *shape,
                      const struct ph_sphere_spline *s, size_t i) {
  double q = shape->q[i];
  size_t k = ph_sphere_before(s->data, i);
  ph_vec3 p = s->data->p[i];
  return ph_vec3_triple(p, s->r[i], ph_sphere_middle(s, i)) * q >= 0 &&
         (shape->legacy ||
          ph_vec3_triple(p, s->l[k], ph_sphere_middle(s, k)) * q >= 0);
}

enum ph_sphere_criterion
ph_sphere_node_fails(const struct ph_sphere_shape *shape,
                     const struct ph_sphere_spline *s, size_t i) {
  struct ph_spherical_legs left, right;
  if (!shape->inorder[i] && shape->q[i] == 0) {
    return PH_SPHERE_FINE;
  }
  if (!shape->inorder[i]) {
    return is_convex(shape, s, i) ? PH_SPHERE_FINE : PH_SPHERE_NODAL;
  }
  left = ph_sphere_legs(s, ph_sphere_before(s->data, i));
  right = ph_sphere_legs(s, i);
  return is_straight(shape, &left, &right, i) ? PH_SPHERE_FINE
                                              : PH_SPHERE_COCIRCULARITY;
}

/* ---- segments ------------------------------------------------------------ */

enum verdict { UNKNOWN, YES, NO };

/* (3), times the sign, with the error (4), of a segment of so long legs. */
struct plane {
  double b[3], error, sum;
};

static struct plane plane_of(const struct ph_spherical_legs *s, double sign) {
  struct plane plane = {.sum = 0};
  ph_vec3 middle = ph_vec3_unit(ph_vec3_add(s->s.p[1], s->s.p[2]));
  double most;
  for (int i = 0; i < 3; i++) {
    plane.sum += ph_vec3_abs(s->leg[i]);
  }
  plane.b[0] = 18 * sign * ph_vec3_triple(s->s.p[0], s->leg[0], s->leg[1]);
  plane.b[1] = 9 * sign * ph_vec3_triple(middle, s->leg[0], s->leg[2]);
  plane.b[2] = 18 * sign * ph_vec3_triple(s->s.p[3], s->leg[1], s->leg[2]);
  most = fmax(fmax(fabs(plane.b[0]), fabs(plane.b[2])), fabs(plane.b[1]));
  plane.error = FROM_PLANE * plane.sum * plane.sum * most;
  return plane;
}

static enum verdict by_plane(const struct ph_spherical_legs *s, double sign) {
  struct plane plane = plane_of(s, sign);
  const double *b = plane.b, e = plane.error;
  if (!(b[0] > 0 && b[2] > 0)) {
    return NO;
  }
  return plane.sum <= GENTLE && b[0] > e && b[2] > e &&
                 b[1] - e > -sqrt((b[0] - e) * (b[2] - e))
             ? YES
             : UNKNOWN;
}

/* A place of a segment: t, K and K' there. */
struct knot {
  double t, k[2];
};

static struct knot knot_at(const struct ph_spherical_net *net, double sign,
                           double t) {
  struct knot at = {t, {0, 0}};
  ph_spherical_net_numerators(net, t, at.k);
  at.k[0] *= sign;
  at.k[1] *= sign;
  return at;
}

/* Whether the cubic from a to b is positive beyond its error in the middle. */
static bool is_positive(const struct knot *a, const struct knot *m,
                        const struct knot *b) {
  double w = b->t - a->t;
  double middle = (a->k[0] + b->k[0]) / 2 + w * (a->k[1] - b->k[1]) / 8;
  double error = fabs(middle - m->k[0]);
  return a->k[0] > 4 * error && a->k[0] + w * a->k[1] / 3 > 4 * error &&
         b->k[0] - w * b->k[1] / 3 > 4 * error && b->k[0] > 4 * error;
}

/* The piece from a to b, by halving from the left: the ends on the right that
 * are yet to come are a stack, end[0] = b. */
static bool piece_holds(const struct ph_spherical_net *net, double sign,
                        double tiny, struct knot a, struct knot b) {
  struct knot end[DEPTH + 1];
  unsigned halved[DEPTH + 1]; /* how often, to come to end[n - 1] */
  size_t n = 1;
  end[0] = b;
  halved[0] = 0;
  while (n > 0) {
    struct knot m = knot_at(net, sign, (a.t + end[n - 1].t) / 2);
    if (!(m.k[0] > tiny)) {
      return false;
    }
    if (is_positive(&a, &m, &end[n - 1])) {
      a = end[--n];
    } else if (halved[n - 1] == DEPTH) {
      return false;
    } else {
      halved[n] = ++halved[n - 1];
      end[n++] = m;
    }
  }
  return true;
}

static bool by_pieces(const struct ph_spherical_legs *s, double sign) {
  struct ph_spherical_net net;
  struct knot knot[PIECES + 1];
  double most = 0;
  ph_spherical_net_of_legs(s, &net);
  for (size_t j = 0; j <= PIECES; j++) {
    knot[j] = knot_at(&net, sign, (double)j / PIECES);
    if (!(knot[j].k[0] > 0)) {
      return false;
    }
    most = fmax(most, knot[j].k[0]);
  }
  for (size_t j = 0; j <= PIECES; j++) {
    if (!(knot[j].k[0] > TINY * most)) {
      return false;
    }
  }
  for (size_t j = 0; j < PIECES; j++) {
    if (!piece_holds(&net, sign, TINY * most, knot[j], knot[j + 1])) {
      return false;
    }
  }
  return true;
}

enum ph_sphere_criterion
ph_sphere_segment_fails(const struct ph_sphere_shape *shape,
                        const struct ph_sphere_spline *s, size_t k) {
  double sign = shape->q[k];
  enum verdict verdict;
  struct ph_spherical_legs c;
  if (shape->q[k] * shape->q[ph_sphere_next(s->data, k)] <= 0) {
    return PH_SPHERE_FINE;
  }
  c = ph_sphere_legs(s, k);
  verdict = by_plane(&c, sign);
  if (verdict == UNKNOWN) {
    verdict = by_pieces(&c, sign) ? YES : NO;
  }
  return verdict == YES ? PH_SPHERE_FINE : PH_SPHERE_SEGMENT;
}

/* ---- tensions ------------------------------------------------------------ */

/* Adds a node, if its tension is to be raised and it is not there yet. */
static size_t add(const struct ph_sphere_shape *shape, size_t i, size_t n,
                  size_t node[4]) {
  if (!shape->legacy && ph_sphere_is_end(shape->data, i)) {
    return n;
  }
  for (size_t j = 0; j < n; j++) {
    if (node[j] == i) {
      return n;
    }
  }
  node[n] = i;
  return n + 1;
}

size_t ph_sphere_touched(const struct ph_sphere_shape *shape,
                         enum ph_sphere_criterion criterion, size_t at,
                         size_t node[4]) {
  const struct ph_sphere_data *d = shape->data;
  size_t n = 0, i = before(d, at), count;
  if (criterion == PH_SPHERE_COCIRCULARITY && !shape->legacy) {
    if (shape->before[at] != SIZE_MAX) {
      n = add(shape, shape->before[at], n, node);
      n = add(shape, shape->after[at], n, node);
    }
    return n;
  }
  count = criterion == PH_SPHERE_FINE      ? 0
          : criterion == PH_SPHERE_SEGMENT ? 4
                                           : 3;
  for (size_t j = 0; j < count; j++) {
    /* of a run in order, the node beyond it: that it stays straight */
    bool run = shape->inorder[i] && !shape->legacy;
    const size_t *beyond = j == 0 ? shape->before : shape->after;
    if (!run || beyond[i] != SIZE_MAX) {
      n = add(shape, run ? beyond[i] : i, n, node);
    }
    i = ph_sphere_next(d, i);
  }
  return n;
}

const char *ph_sphere_criterion_name(enum ph_sphere_criterion criterion) {
  static const char *const name[] = {"none", "co-circularity",
                                     "nodal convexity", "segment convexity"};
  return name[criterion];
}

/* ---- measures of shape --------------------------------------------------- */

/*
 * Numbers that are >= 0 where criteria of shape hold with a margin (see
 * sphere.h).
 *
 * The margin leaves room for what a linear program misses, and keeps curves
 * away from where a criterion just holds: there they may have a cusp.
 */

/* Margins, relative to epsilon, to the turn of the data, and to the largest
 * sample of a segment. */
static const double MARGIN_EPSILON = 2e-3;
static const double MARGIN_TURN = 1e-4;
static const double MARGIN_SEGMENT = 1e-5;

/* Legs that sum to no more than this have (4) so small that (3) tells what
 * samples do: K > 0 with B_0 > 0, B_2 > 0 and B_1 > -sqrt(B_0 B_2). */
static const double SHORT = 0.03;
enum { PLANE = 3 };

/* The turn of the control polygon beside node i, of the sign of K there,
 * against that of the data. */
static size_t measure_convexity(const struct ph_sphere_shape *shape,
                                const struct ph_sphere_spline *s, size_t i,
                                double *g) {
  const struct ph_sphere_data *d = s->data;
  size_t k = ph_sphere_before(d, i), n = 0;
  ph_vec3 p = d->p[i];
  double least = MARGIN_TURN * shape->turn[i], q = shape->q[i];
  g[n++] = q * turn_of(p, s->r[i], ph_sphere_middle(s, i)) - least;
  if (!shape->legacy) {
    g[n++] = q * turn_of(p, s->l[k], ph_sphere_middle(s, k)) - least;
  }
  return n;
}

size_t ph_sphere_measure_node(const struct ph_sphere_shape *shape,
                              const struct ph_sphere_spline *s, size_t i,
                              double *g) {
  const struct ph_sphere_data *d = s->data;
  double left, right, h = d->h[i],
                      bound = (1 - MARGIN_EPSILON) * shape->epsilon;
  struct ph_spherical_legs before, after;
  size_t n = 0;
  if (!shape->inorder[i]) {
    return shape->q[i] == 0 ? 0 : measure_convexity(shape, s, i, g);
  }
  before = ph_sphere_legs(s, ph_sphere_before(d, i));
  after = ph_sphere_legs(s, i);
  if (shape->legacy) {
    right = ph_spherical_legs_numerator_start(&after) / (h * h * h) *
            d->theta[0] * d->theta[0];
    left = right;
  } else {
    right = ph_spherical_legs_curvature_start(&after);
    left = ph_spherical_legs_curvature_end(&before);
  }
  g[n++] = bound - left;
  g[n++] = bound + left;
  g[n++] = bound - right;
  g[n++] = bound + right;
  return n;
}

size_t ph_sphere_measure_segment(const struct ph_sphere_shape *shape,
                                 const struct ph_sphere_spline *s, size_t k,
                                 double *g) {
  enum { LAST = PH_SPHERE_SAMPLES - 1 };
  struct ph_spherical_legs segment;
  struct ph_spherical_net net;
  struct plane plane;
  double most = 0;
  if (shape->q[k] * shape->q[ph_sphere_next(s->data, k)] <= 0) {
    return 0;
  }
  segment = ph_sphere_legs(s, k);
  plane = plane_of(&segment, shape->q[k]);
  if (plane.sum <= SHORT) {
    most = plane.error + MARGIN_SEGMENT * fmax(plane.b[0], plane.b[2]);
    g[0] = plane.b[0] - most;
    g[1] = plane.b[2] - most;
    g[2] = plane.b[1] + sqrt(fmax(plane.b[0], 0) * fmax(plane.b[2], 0)) - most;
    return PLANE;
  }
  ph_spherical_net_of_legs(&segment, &net);
  g[0] = ph_spherical_legs_numerator_start(&segment);
  g[LAST] = ph_spherical_legs_numerator_end(&segment);
  for (size_t j = 1; j < LAST; j++) {
    g[j] = ph_spherical_net_numerator(&net, (double)j / LAST);
  }
  for (size_t j = 0; j <= LAST; j++) {
    g[j] *= shape->q[k];
    most = fmax(most, g[j]);
  }
  for (size_t j = 0; j < PH_SPHERE_SAMPLES; j++) {
    g[j] -= MARGIN_SEGMENT * most;
  }
  return PH_SPHERE_SAMPLES;
}
