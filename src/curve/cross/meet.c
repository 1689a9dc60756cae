/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Where two pieces of planar segments meet (see meet.h).
 *
 * Pieces are halved until one of these tells the answer:
 *
 *   box        their boxes are apart
 *   cone       from one to the other, the curve turns by less than a half turn
 *   strip      one lies to one side of the strip about the other's chord
 *   parabola   one lies to one side of a parabola through the other's ends:
 *              separates arcs that run side by side
 *   crossing   each one's ends lie to either side of the other's strip
 *   size       both are smaller than the tolerance: they meet
 *
 * Why the bounds hold.  (1) The control points' functions are differences of
 *   J_j(u) = integral of S0^(4-j) S1^j over [0,u] / the same over [0,1],
 * and J_j >= J_(j+1) because S1/S0 increases: they are nowhere negative, and
 * their sum is 1.  (2) S0 and S1 are nowhere negative, so that w lies in the
 * cone of its coefficients.  (3) Strips: where the ends of two pieces lie so,
 * each crosses the parallelogram in which the strips meet from side to side.
 */
#include "curve/cross/meet.h"

#include "curve/segment/seg2.h"

#include <math.h>

/* A piece of 2^-50 of a segment is at the rounding of its parameter, and far
 * below the tolerance. */
enum { NEWTON_MAX = 8 };
static const double NARROWEST = 0x1p-50;

/* A crossing is located when the pieces are this close, in tolerances. */
static const double LOCATED = 0.01;

/* The largest angle to the axis of a parabola: 60 degrees. */
static const double COS_MAX = 0.5;

struct ph_cone ph_piece_cone(const ph_cplx w[3]) {
  ph_cplx low = w[0], high = w[0];
  if (!ph_seg2_is_monotone(w)) {
    return PH_CONE_ALL;
  }
  for (size_t i = 1; i < 3; i++) {
    low = ph_cplx_cross(low, w[i]) < 0 ? w[i] : low;
    high = ph_cplx_cross(high, w[i]) > 0 ? w[i] : high;
  }
  return ph_cone_of(ph_cplx_mul(low, low), ph_cplx_mul(high, high));
}

static struct ph_piece piece_of(const struct ph_seg2 *seg, size_t segment,
                                double from, double to) {
  struct ph_piece piece = {.segment = segment, .from = from, .to = to};
  piece.seg = *seg;
  ph_seg2_control_points(&seg->space, seg->w, seg->start, seg->end, piece.p);
  piece.box = ph_box2_of(piece.p, 6);
  piece.cone = ph_piece_cone(seg->w);
  return piece;
}

struct ph_piece ph_piece_of(const struct ph_seg2 *seg, size_t segment) {
  return piece_of(seg, segment, 0, 1);
}

/* The integral of w^2 over [0,1]. */
static ph_cplx chord_of(const struct ph_seg2 *seg) {
  const double *q = seg->space.q;
  const ph_cplx *w = seg->w;
  ph_cplx ends = ph_cplx_add(ph_cplx_mul(w[0], w[0]), ph_cplx_mul(w[2], w[2]));
  ph_cplx sides = ph_cplx_mul(w[1], ph_cplx_add(w[0], w[2]));
  ph_cplx sum =
      ph_cplx_add(ph_cplx_scale(q[0], ends), ph_cplx_scale(q[1], sides));
  sum = ph_cplx_add(sum, ph_cplx_scale(q[2], ph_cplx_mul(w[1], w[1])));
  return ph_cplx_add(sum, ph_cplx_scale(q[3], ph_cplx_mul(w[0], w[2])));
}

/*
 * (4) With s0, s1 the functions of the half angle on the first half,
 *       S0 = s0 + k s1,  S1 = k s1,  k = 1 / (2 cos(a/4)),
 *     so that its coefficients are w0, (w0 + c w1) / (1 + c), and
 *     w(1/2) = (w0 + 2 c w1 + w2) / (2 (1 + c)).
 *     Tested by t_meet.c: halves.
 */
void ph_piece_halves(const struct ph_piece *piece, struct ph_piece half[2]) {
  const struct ph_seg2 *seg = &piece->seg;
  const double root = 0.70710678118654752440; /* sqrt(1/2), for r' = w^2 */
  double c = seg->space.c, middle = 0.5 * (piece->from + piece->to);
  ph_cplx m = ph_cplx_scale(c, seg->w[1]);
  struct ph_seg2 part[2];
  part[0].space =
      seg->space.angle > 0 ? ph_atph_of(0.5 * seg->space.angle) : seg->space;
  part[1].space = part[0].space;
  for (size_t i = 0; i < 2; i++) {
    part[i].w[2 * i] = ph_cplx_scale(root, seg->w[2 * i]);
    part[i].w[1] = ph_cplx_scale(root / (1 + c), ph_cplx_add(seg->w[2 * i], m));
    part[i].w[2 - 2 * i] = ph_cplx_scale(
        0.5 * root / (1 + c),
        ph_cplx_add(ph_cplx_add(seg->w[0], seg->w[2]), ph_cplx_add(m, m)));
  }
  part[0].start = seg->start;
  part[1].end = seg->end;
  /* The mean from both ends: the same for the reversed piece. */
  part[0].end = ph_cplx_scale(
      0.5, ph_cplx_add(ph_cplx_add(seg->start, chord_of(&part[0])),
                       ph_cplx_sub(seg->end, chord_of(&part[1]))));
  part[1].start = part[0].end;
  half[0] = piece_of(&part[0], piece->segment, piece->from, middle);
  half[1] = piece_of(&part[1], piece->segment, middle, piece->to);
}

/*
 * (5) curvature = 2 Im(conj(w) w') / |w|^4.  In the normalised basis b of w,
 *       Im(conj(w) w') = (2 / sinc(a/2)) (k0 b0 + k1 b1 + k2 b2),
 *       k0 = c Im(conj(w0) w1), k1 = Im(conj(w0) w2) / (2 c),
 *       k2 = c Im(conj(w1) w2),
 *       |w|^2 = sum of b_i b_j Re(w_i conj(w_j)),
 *     and the b are nowhere negative.  Tested by t_meet.c: curvature.
 */
void ph_piece_curvature(const struct ph_piece *piece, double range[2]) {
  const struct ph_atph *space = &piece->seg.space;
  const ph_cplx *w = piece->seg.w;
  double k[3] = {space->c * ph_cplx_cross(w[0], w[1]),
                 0.5 / space->c * ph_cplx_cross(w[0], w[2]),
                 space->c * ph_cplx_cross(w[1], w[2])};
  double slow = ph_cplx_dot(w[0], w[2]), fast = 0, low = k[0], high = k[0];
  for (size_t i = 0; i < 3; i++) {
    double mixed = ph_cplx_dot(w[i], w[(i + 1) % 3]);
    double pure = ph_cplx_norm2(w[i]);
    slow = mixed < slow ? mixed : slow;
    slow = pure < slow ? pure : slow;
    fast = pure > fast ? pure : fast;
    low = k[i] < low ? k[i] : low;
    high = k[i] > high ? k[i] : high;
  }
  low *= 4 / space->sinc;
  high *= 4 / space->sinc;
  range[0] = low / (low < 0 ? slow * slow : fast * fast);
  range[1] = high / (high > 0 ? slow * slow : fast * fast);
}

bool ph_between_narrow(const struct ph_between *between,
                       const struct ph_cone *first,
                       const struct ph_cone *second) {
  struct ph_cone inner = ph_cone_join(first, &between->inner);
  struct ph_cone outer = ph_cone_join(second, &between->outer);
  inner = ph_cone_join(&inner, second);
  outer = ph_cone_join(&outer, first);
  return inner.kind != PH_CONE_WIDE || outer.kind != PH_CONE_WIDE;
}

/* ---- strips ------------------------------------------------------------- */

/* How far the control points of a piece lie to the left of a line. */
struct side {
  double low, high;  /* of all */
  double start, end; /* of the two ends */
};

static struct side side_of(const struct ph_piece *piece, ph_cplx origin,
                           ph_cplx direction) {
  struct side side;
  side.start = ph_cplx_cross(direction, ph_cplx_sub(piece->p[0], origin));
  side.end = ph_cplx_cross(direction, ph_cplx_sub(piece->p[5], origin));
  side.low = fmin(side.start, side.end);
  side.high = fmax(side.start, side.end);
  for (size_t i = 1; i < 5; i++) {
    double at = ph_cplx_cross(direction, ph_cplx_sub(piece->p[i], origin));
    side.low = at < side.low ? at : side.low;
    side.high = at > side.high ? at : side.high;
  }
  return side;
}

enum verdict { UNKNOWN, APART, CROSSING };

/* One piece and the strip about the chord of another. */
static enum verdict strip(const struct ph_piece *about,
                          const struct ph_piece *other, ph_cplx direction,
                          double tolerance) {
  struct side own = side_of(about, about->p[0], direction);
  struct side far = side_of(other, about->p[0], direction);
  if (far.low > own.high + tolerance || far.high < own.low - tolerance) {
    return APART;
  }
  return (far.start < own.low && far.end > own.high) ||
                 (far.end < own.low && far.start > own.high)
             ? CROSSING
             : UNKNOWN;
}

/* ---- parabolas ---------------------------------------------------------- */

/* A piece as the graph of a function y(x) over an axis. */
struct graph {
  double x[2], y[2]; /* of the ends */
  double second[2];  /* bounds of y'' */
};

/* False where the piece is not monotone or too steep. */
static bool graph_of(const struct ph_piece *piece, ph_cplx origin, ph_cplx axis,
                     struct graph *graph) {
  const ph_cplx edge[2] = {piece->cone.low, piece->cone.high};
  double slope2 = 0, stretch, x;
  bool back = ph_cplx_dot(edge[0], axis) < 0;
  if (piece->cone.kind != PH_CONE_NARROW) {
    return false;
  }
  for (size_t i = 0; i < 2; i++) {
    double along = ph_cplx_dot(edge[i], axis);
    double across = ph_cplx_cross(edge[i], axis);
    double steep = across * across / (along * along);
    ph_cplx end = ph_cplx_sub(piece->p[5 * i], origin);
    if (!(back ? along < 0 : along > 0) ||
        !(steep <= 1 / (COS_MAX * COS_MAX) - 1)) {
      return false;
    }
    slope2 = steep > slope2 ? steep : slope2;
    graph->x[i] = ph_cplx_dot(end, axis);
    graph->y[i] = ph_cplx_cross(axis, end);
  }
  /* y'' = curvature (1 + y'^2)^(3/2), of the direction of the axis */
  ph_piece_curvature(piece, graph->second);
  if (back) {
    x = graph->second[0];
    graph->second[0] = -graph->second[1];
    graph->second[1] = -x;
  }
  stretch = (1 + slope2) * sqrt(1 + slope2);
  graph->second[0] *= graph->second[0] < 0 ? stretch : 1;
  graph->second[1] *= graph->second[1] > 0 ? stretch : 1;
  return true;
}

/*
 * (6) q(x) = k x (x - l) / 2 goes through the ends of `about`, at 0 and l, with
 *     k in the middle of the bounds of its second derivative.  A function whose
 *     second derivative is at most e lies within e width^2 / 8 of the line
 *     through its ends: this bounds y - q of both.
 */
static bool parabola(const struct ph_piece *about, const struct ph_piece *other,
                     ph_cplx axis, double tolerance) {
  struct graph own, far;
  double k, l, e, width, rest[2], low, high, own_error, error;
  if (!graph_of(about, about->p[0], axis, &own) ||
      !graph_of(other, about->p[0], axis, &far)) {
    return false;
  }
  l = own.x[1];
  k = 0.5 * (own.second[0] + own.second[1]);
  own_error = (own.second[1] - own.second[0]) / 16 * l * l;
  for (size_t i = 0; i < 2; i++) {
    rest[i] = far.y[i] - 0.5 * k * far.x[i] * (far.x[i] - l);
  }
  width = far.x[1] - far.x[0];
  e = fmax(k - far.second[0], far.second[1] - k);
  error = e / 8 * width * width + own_error + tolerance;
  low = fmin(rest[0], rest[1]);
  high = fmax(rest[0], rest[1]);
  return low > error || high < -error;
}

/* ---- crossings ---------------------------------------------------------- */

static void tell(struct ph_meet *meet, const struct ph_piece *a,
                 const struct ph_piece *b, double x, double y) {
  meet->found = true;
  meet->segment[0] = a->segment;
  meet->segment[1] = b->segment;
  meet->u[0] = a->from + x * (a->to - a->from);
  meet->u[1] = b->from + y * (b->to - b->from);
}

/* Newton's method, from `at` on, for a crossing of two nearly straight pieces;
 * false where it leaves them. */
static bool locate(const struct ph_meet *meet, const struct ph_piece *a,
                   const struct ph_piece *b, double at[2]) {
  for (int i = 0; i < NEWTON_MAX; i++) {
    ph_cplx d = ph_cplx_sub(ph_seg2_point(&a->seg, meet->rule, at[0]),
                            ph_seg2_point(&b->seg, meet->rule, at[1]));
    ph_cplx va, vb;
    double det;
    if (ph_cplx_abs(d) <= LOCATED * meet->tolerance) {
      return true;
    }
    ph_atph_jet(&a->seg.space, a->seg.w, at[0], &va, 1);
    ph_atph_jet(&b->seg.space, b->seg.w, at[1], &vb, 1);
    va = ph_cplx_mul(va, va);
    vb = ph_cplx_mul(vb, vb);
    det = ph_cplx_cross(va, vb);
    at[0] -= ph_cplx_cross(d, vb) / det;
    at[1] -= ph_cplx_cross(d, va) / det;
    if (!(at[0] >= 0 && at[0] <= 1 && at[1] >= 0 && at[1] <= 1)) {
      return false;
    }
  }
  return false;
}

/* What two pieces whose boxes meet say without being halved. */
static enum verdict judge(const struct ph_meet *meet, const struct ph_piece *a,
                          const struct ph_piece *b) {
  const struct ph_piece *piece[2] = {a, b};
  enum verdict v[2] = {UNKNOWN, UNKNOWN};
  for (size_t i = 0; i < 2; i++) {
    const struct ph_piece *about = piece[i], *other = piece[1 - i];
    ph_cplx chord = ph_cplx_sub(about->p[5], about->p[0]);
    double length = ph_cplx_abs(chord);
    ph_cplx axis = ph_cplx_scale(1 / length, chord);
    if (length > 0) {
      v[i] = strip(about, other, axis, meet->tolerance);
      if (v[i] == APART || parabola(about, other, axis, meet->tolerance)) {
        return APART;
      }
    }
  }
  return v[0] == v[1] ? v[0] : UNKNOWN;
}

/* ---- the search --------------------------------------------------------- */

static bool take_step(struct ph_meet *meet, const struct ph_piece *a,
                      const struct ph_piece *b) {
  if (meet->steps == 0) {
    tell(meet, a, b, 0.5, 0.5);
    return false;
  }
  meet->steps--;
  return true;
}

static bool is_small(const struct ph_meet *meet, const struct ph_piece *piece) {
  return ph_box2_size(&piece->box) <= meet->tolerance ||
         piece->to - piece->from <= NARROWEST;
}

void ph_meet_pair(struct ph_meet *meet, const struct ph_piece *a,
                  const struct ph_piece *b, const struct ph_between *between) {
  struct ph_piece half[2];
  struct ph_between beside = *between;
  enum verdict verdict;
  double at[2] = {0.5, 0.5};
  if (meet->found || ph_box2_apart(&a->box, &b->box, meet->tolerance) ||
      ph_between_narrow(between, &a->cone, &b->cone) ||
      !take_step(meet, a, b)) {
    return;
  }
  if (is_small(meet, a) && is_small(meet, b)) {
    tell(meet, a, b, 0.5, 0.5);
    return;
  }
  verdict = judge(meet, a, b);
  if (verdict == CROSSING && (!meet->rule || locate(meet, a, b, at))) {
    tell(meet, a, b, at[0], at[1]);
  } else if (verdict == APART) {
    return;
  } else if (is_small(meet, b) ||
             (!is_small(meet, a) &&
              ph_box2_size(&a->box) >= ph_box2_size(&b->box))) {
    ph_piece_halves(a, half);
    beside.inner = ph_cone_join(&half[1].cone, &between->inner);
    ph_meet_pair(meet, &half[0], b, &beside);
    beside.inner = between->inner;
    beside.outer = ph_cone_join(&between->outer, &half[0].cone);
    ph_meet_pair(meet, &half[1], b, &beside);
  } else {
    ph_piece_halves(b, half);
    beside.outer = ph_cone_join(&half[1].cone, &between->outer);
    ph_meet_pair(meet, a, &half[0], &beside);
    beside.outer = between->outer;
    beside.inner = ph_cone_join(&between->inner, &half[0].cone);
    ph_meet_pair(meet, a, &half[1], &beside);
  }
}

void ph_meet_self(struct ph_meet *meet, const struct ph_piece *piece,
                  const struct ph_cone *outer) {
  struct ph_piece half[2];
  struct ph_between between = {PH_CONE_NONE, *outer};
  struct ph_cone rest;
  if (meet->found || piece->cone.kind == PH_CONE_NARROW ||
      !take_step(meet, piece, piece)) {
    return;
  }
  if (is_small(meet, piece)) {
    tell(meet, piece, piece, 0, 1);
    return;
  }
  ph_piece_halves(piece, half);
  rest = ph_cone_join(&half[1].cone, outer);
  ph_meet_self(meet, &half[0], &rest);
  rest = ph_cone_join(outer, &half[0].cone);
  ph_meet_self(meet, &half[1], &rest);
  ph_meet_pair(meet, &half[0], &half[1], &between);
}
