/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Whether two Tschirnhausen cubics cross (see tc_simple.h).
 *
 * A cubic without a loop does not meet itself.  Of two, both are followed from
 * their joint outwards, as arcs with preimages w(0) = v at the joint and
 *
 *   F(t) = t/3 (v^2 + v w + w^2),  w = w(t)
 *
 * the way from the joint, up to its sign.  What matters of an arc up to t is
 * z = conj(v) w(t): its argument is half the turn from the joint to t.
 *
 * Derived here; tested by t_tc_simple.c: test_slow, test_cross.
 */
#include "curve/cross/tc_simple.h"

#include "curve/cross/bound2.h"

#include <math.h>

/* Cuts at most; past them the cubics are said to meet.  A few are usual, and
 * about a hundred where cubics just touch (575 of 23598 random such at most).
 */
enum { STEPS = 4096 };

/* A piece is straight if it bends by no more than this many tolerances. */
static const double STRAIGHT = 0.1;

/* Directions closer than this, in radians, are not told apart by sectors(). */
static const double CLEAR = 1e-6;

/* An arc from the joint outwards. */
struct arc {
  ph_cplx v, d; /* w(t) = v + t d */
  double sign;  /* of F: -1 if travelled towards the joint */
};

/* A piece [from,to] of an arc. */
struct piece {
  const struct arc *arc;
  double from, to;
  ph_cplx w[2]; /* preimages at its ends */
  ph_cplx z;    /* of its outer end */
  ph_cplx p[4]; /* control points; the joint is the origin */
  struct ph_box2 box;
  double sagitta; /* if monotone, it is no further than this from its chord */
};

struct search {
  double tolerance;
  size_t steps; /* that are left */
  bool found;
};

/* ---- what can be seen without cutting ----------------------------------- */

/*
 * Whether the tangent turns by less than a half turn from the outer end of one
 * arc to the outer end of the other: then the chain moves along an axis.
 *
 * Each arc turns to one side.  If both turn to the same side the sum counts:
 * arg z_a and arg z_b, of different signs, are less than a quarter turn apart.
 * If not, the sum is less than the larger, and each alone must be narrow.
 */
static bool is_narrow(ph_cplx a, ph_cplx b) {
  return a.re > 0 && b.re > 0 && ph_cplx_dot(a, b) > 0;
}

/*
 * The direction from the joint to the outmost control point of an arc, seen
 * from the tangent there, turned to the left of it: one of
 *   n + z, n^2 + n z + z^2,  n = |v|^2, z with |K| for K.
 */
static ph_cplx outmost(double n, ph_cplx z) {
  ph_cplx left = ph_cplx_of(z.re, fabs(z.im));
  ph_cplx second = ph_cplx_of(n + left.re, left.im);
  ph_cplx third = ph_cplx_mul(left, second);
  third.re += n * n;
  return ph_cplx_cross(second, third) > 0 ? third : second;
}

/*
 * Whether the joint sees the arcs in sectors of their own.
 *
 * An arc lies in the sector of its control points, between the tangent of the
 * joint and the outmost one, if that is below a half turn: R > -n/2.  If the
 * arcs turn to different sides the tangent separates them; else their angles
 * must add up to less than a half turn.
 */
static bool sectors(double na, ph_cplx a, double nb, ph_cplx b) {
  ph_cplx product;
  if (!(na + 2 * a.re > CLEAR * na && nb + 2 * b.re > CLEAR * nb)) {
    return false;
  }
  if ((a.im >= 0) == (b.im >= 0)) {
    return true;
  }
  product = ph_cplx_mul(outmost(na, a), outmost(nb, b));
  return product.re > 0 ? product.im >= 0 : product.im > -CLEAR * product.re;
}

/* ---- pieces ------------------------------------------------------------- */

static ph_cplx preimage_at(const struct arc *arc, double t) {
  return ph_cplx_add(arc->v, ph_cplx_scale(t, arc->d));
}

/* The point of an arc at t, where its preimage is w. */
static ph_cplx point_at(const struct arc *arc, double t, ph_cplx w) {
  ph_cplx sum = ph_cplx_add(ph_cplx_mul(arc->v, ph_cplx_add(arc->v, w)),
                            ph_cplx_mul(w, w));
  return ph_cplx_scale(arc->sign * t / 3, sum);
}

/* A piece from its ends: its parameters, preimages and end points are set. */
static void complete(struct piece *piece) {
  double h = piece->to - piece->from, third = piece->arc->sign * h / 3;
  const ph_cplx *w = piece->w;
  ph_cplx first = ph_cplx_scale(third, ph_cplx_mul(w[0], w[0]));
  ph_cplx last = ph_cplx_scale(third, ph_cplx_mul(w[1], w[1]));
  piece->p[1] = ph_cplx_add(piece->p[0], first);
  piece->p[2] = ph_cplx_sub(piece->p[3], last);
  piece->z = ph_cplx_mul(ph_cplx_conj(piece->arc->v), w[1]);
  piece->box = ph_box2_of(piece->p, 4);
  piece->sagitta = fabs(ph_cplx_cross(w[0], w[1])) * h;
}

static struct piece whole(const struct arc *arc) {
  struct piece piece = {.arc = arc, .from = 0, .to = 1};
  piece.w[0] = arc->v;
  piece.w[1] = preimage_at(arc, 1);
  piece.p[0] = ph_cplx_of(0, 0);
  piece.p[3] = point_at(arc, 1, piece.w[1]);
  complete(&piece);
  return piece;
}

/* Whether the preimage turns by less than an eighth turn. */
static bool is_monotone(const struct piece *piece) {
  double cross = ph_cplx_cross(piece->w[0], piece->w[1]);
  return ph_cplx_dot(piece->w[0], piece->w[1]) > fabs(cross);
}

/* Halves: by the angle of w, where it is at a/(a + b) with a = |w0|, b = |w1|,
 * until the piece is monotone; then by the parameter. */
static void cut(const struct piece *piece, struct piece half[2]) {
  double at = 0.5, t;
  ph_cplx w;
  if (!is_monotone(piece)) {
    double a = ph_cplx_abs(piece->w[0]);
    at = a / (a + ph_cplx_abs(piece->w[1]));
  }
  t = piece->from + at * (piece->to - piece->from);
  w = preimage_at(piece->arc, t);
  half[0] = *piece;
  half[1] = *piece;
  half[0].to = t;
  half[0].w[1] = w;
  half[0].p[3] = point_at(piece->arc, t, w);
  half[1].from = t;
  half[1].w[0] = w;
  half[1].p[0] = half[0].p[3];
  complete(&half[0]);
  complete(&half[1]);
}

/* ---- two pieces --------------------------------------------------------- */

enum verdict { UNKNOWN, APART, MEET };

/* The strip about the chord of one piece, and the other. */
static enum verdict strip(const struct piece *about, const struct piece *other,
                          double tolerance) {
  ph_cplx chord = ph_cplx_sub(about->p[3], about->p[0]);
  double near = tolerance * ph_cplx_abs(chord), low = 0, high = 0, far[4];
  double least, most;
  for (size_t i = 1; i < 3; i++) {
    double y = ph_cplx_cross(chord, ph_cplx_sub(about->p[i], about->p[0]));
    low = y < low ? y : low;
    high = y > high ? y : high;
  }
  for (size_t i = 0; i < 4; i++) {
    far[i] = ph_cplx_cross(chord, ph_cplx_sub(other->p[i], about->p[0]));
  }
  least = fmin(fmin(far[0], far[1]), fmin(far[2], far[3]));
  most = fmax(fmax(far[0], far[1]), fmax(far[2], far[3]));
  if (least > high + near || most < low - near) {
    return APART;
  }
  return (far[0] < low && far[3] > high) || (far[0] > high && far[3] < low)
             ? MEET
             : UNKNOWN;
}

/* The square of the distance of a point from a chord. */
static double distance2(ph_cplx point, const struct piece *piece) {
  ph_cplx chord = ph_cplx_sub(piece->p[3], piece->p[0]);
  ph_cplx way = ph_cplx_sub(point, piece->p[0]);
  double along = ph_cplx_dot(way, chord), norm = ph_cplx_norm2(chord);
  double across = ph_cplx_cross(chord, way);
  if (!(along > 0)) {
    return ph_cplx_norm2(way);
  }
  if (along >= norm) {
    return ph_cplx_norm2(ph_cplx_sub(point, piece->p[3]));
  }
  return across * (across / norm);
}

/* Whether the chords of two pieces that do not cross are near each other: then
 * an end is. */
static bool is_near(const struct piece *a, const struct piece *b,
                    double tolerance) {
  double start = fmin(distance2(a->p[0], b), distance2(b->p[0], a));
  double end = fmin(distance2(a->p[3], b), distance2(b->p[3], a));
  return fmin(start, end) <= tolerance * tolerance;
}

static enum verdict judge(const struct piece *a, const struct piece *b,
                          double tolerance) {
  enum verdict first, second;
  if (is_narrow(a->z, b->z) || ph_box2_apart(&a->box, &b->box, tolerance)) {
    return APART;
  }
  first = strip(a, b, tolerance);
  second = first == APART ? APART : strip(b, a, tolerance);
  if (second == APART || (first == MEET && second == MEET)) {
    return second;
  }
  if (fmax(a->sagitta, b->sagitta) <= STRAIGHT * tolerance && is_monotone(a) &&
      is_monotone(b)) {
    return is_near(a, b, tolerance) ? MEET : APART;
  }
  return UNKNOWN;
}

/* Whether to cut the first of two: the one that is not monotone, or bends more.
 */
static bool cut_first(const struct piece *a, const struct piece *b) {
  bool monotone[2] = {is_monotone(a), is_monotone(b)};
  return monotone[0] == monotone[1] ? a->sagitta >= b->sagitta : monotone[1];
}

static void search(struct search *s, const struct piece *a,
                   const struct piece *b) {
  enum verdict verdict = s->steps > 0 ? judge(a, b, s->tolerance) : MEET;
  struct piece half[2];
  if (verdict != UNKNOWN) {
    s->found = verdict == MEET;
    return;
  }
  s->steps--;
  if (cut_first(a, b)) {
    cut(a, half);
    for (size_t i = 2; i-- > 0 && !s->found;) {
      search(s, &half[i], b);
    }
  } else {
    cut(b, half);
    for (size_t i = 2; i-- > 0 && !s->found;) {
      search(s, a, &half[i]);
    }
  }
}

static bool is_fine(const struct ph_tc *tc) {
  return ph_tc_is_regular(tc) && !ph_tc_has_loop(tc);
}

bool ph_tc_is_simple(const struct ph_tc *tc, size_t n) {
  struct ph_tc_form f[2];
  struct arc arc[2];
  struct piece piece[2];
  struct search s = {.steps = STEPS};
  ph_cplx z[2];
  if (!is_fine(&tc[0])) {
    return false;
  }
  if (n == 1) {
    return true;
  }
  if (!is_fine(&tc[1])) {
    return false;
  }
  f[0] = ph_tc_form_of(&tc[0]);
  f[1] = ph_tc_form_of(&tc[1]);
  z[0] = ph_cplx_of(f[0].r, -f[0].k);
  z[1] = ph_cplx_of(f[1].r, f[1].k);
  if (is_narrow(z[0], z[1]) || sectors(f[0].b, z[0], f[1].a, z[1])) {
    return true;
  }
  s.tolerance =
      PH_TC_SIMPLE_NEAR * (ph_tc_length(&tc[0]) + ph_tc_length(&tc[1]));
  for (size_t i = 0; i < 2; i++) {
    ph_cplx v = tc[i].w[1 - i];
    arc[i].v = v;
    arc[i].d = ph_cplx_sub(tc[i].w[i], v);
    arc[i].sign = i == 0 ? -1 : 1;
    piece[i] = whole(&arc[i]);
  }
  search(&s, &piece[0], &piece[1]);
  return !s.found;
}
