/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * One cubic Bezier curve for an arc of a plane curve (see fit.h).
 *
 * With unit tangents T0 and T3 at the ends, the cubic has the control points
 *   P0, P0 + a T0, P3 - b T3, P3                                         (1)
 * and two free numbers, a and b.  At a place P of the arc with tangent T and
 * normal N, let c(t) be where the cubic meets the normal:
 *   T . (c(t) - P) = 0,  f = N . (c(t) - P)                              (2)
 * |f| is no less than the distance of P from the cubic, and that of c(t) from
 * the arc.  Newton's method makes f = 0 at two places: differentiating (2),
 * with B1 = 3 t (1-t)^2 and T . (B1 T0 + c' dt/da) = 0,
 *   df/da = B1 (N . T0 - N . c' (T . T0) / (T . c'))                    (3)
 * and likewise for b with -B2 T3, B2 = 3 t^2 (1-t).
 *
 * A difference with double zeros at the ends and zeros at x^2 = z of [-1,1] is
 * (1-x^2)^2 (x^2 - z) at first; its extrema are equal for z = 0.106, which is
 * a third and two thirds of the way nearly.
 *
 * Where arc and cubic both go forward along the chord, the feet t increase and
 * every point of the cubic is met by a normal: distances in both directions are
 * at most the greatest |f|.  Derived here; tested by t_cubics.c.
 */
#include "curve/bezier/fit.h"

#include <stddef.h>

enum { LAST = PH_ARC_STEPS, FEET_MAX = 12, NEWTON_MAX = 8 };

/* What is between the places is at most this farther. */
static const double MARGIN = 1.1;

/* The least cosine between what goes forward and the chord. */
static const double FORWARD = 0.05;

/* Handles are at least this part of the arc. */
static const double SHORTEST = 1e-3;

/* ---- a cubic against an arc ---------------------------------------------- */

static ph_cplx along(ph_cplx p, double s, ph_cplx v) {
  return ph_cplx_add(p, ph_cplx_scale(s, v));
}

/* out  c1  the derivative */
static ph_cplx cubic_at(const ph_cplx c[4], double t, ph_cplx *c1) {
  ph_cplx p[3], q[2];
  for (size_t i = 0; i < 3; i++) {
    p[i] = ph_cplx_between(c[i], c[i + 1], t);
  }
  for (size_t i = 0; i < 2; i++) {
    q[i] = ph_cplx_between(p[i], p[i + 1], t);
  }
  *c1 = ph_cplx_scale(3, ph_cplx_sub(q[1], q[0]));
  return ph_cplx_between(q[0], q[1], t);
}

/* Where the cubic meets the normal at a place, by (2). */
struct foot {
  double t, f;
  ph_cplx c1; /* of the cubic */
};

/* A bracket [low,1] is kept, as T . (c - P) goes from minus to plus; f is NaN
 * if it does not. */
static struct foot foot_of(const ph_cplx c[4], ph_cplx p, ph_cplx tangent,
                           double low, double t) {
  struct foot foot = {t, (double)NAN, {0, 0}};
  double high = 1, step = 1;
  ph_cplx gap;
  for (size_t i = 0; i < FEET_MAX && fabs(step) > 1e-9; i++) {
    double ahead, slope, next;
    gap = ph_cplx_sub(cubic_at(c, foot.t, &foot.c1), p);
    ahead = ph_cplx_dot(gap, tangent);
    slope = ph_cplx_dot(foot.c1, tangent);
    *(ahead > 0 ? &high : &low) = foot.t;
    next = foot.t - ahead / slope;
    next = slope > 0 && next > low && next < high ? next : 0.5 * (low + high);
    step = next - foot.t;
    foot.t = next;
  }
  gap = ph_cplx_sub(cubic_at(c, foot.t, &foot.c1), p);
  if (ph_cplx_dot(foot.c1, tangent) > 0) {
    foot.f = ph_cplx_cross(tangent, gap);
  }
  return foot;
}

/* The greatest |f|, infinite where there is none.
 * in  part[]  of the way along the arc, where feet are at first sought */
static double distance_of(const struct ph_arc *arc, const double *part,
                          const ph_cplx c[4]) {
  double greatest = 0, low = 0;
  for (size_t j = 1; j < LAST; j++) {
    struct foot foot = foot_of(c, arc->point[j], arc->tangent[j], low, part[j]);
    if (!(fabs(foot.f) <= greatest)) {
      greatest = fabs(foot.f);
    }
    if (isnan(greatest)) {
      return (double)INFINITY;
    }
    low = foot.t;
  }
  return MARGIN * greatest;
}

/* ---- the fit ------------------------------------------------------------- */

static void cubic_of(const struct ph_arc *arc, double a, double b,
                     ph_cplx c[4]) {
  c[0] = arc->point[0];
  c[1] = along(c[0], a, arc->tangent[0]);
  c[3] = arc->point[LAST];
  c[2] = along(c[3], -b, arc->tangent[LAST]);
}

/* The place that is nearest to a part of the way. */
static size_t nearest(const double *part, double wanted) {
  size_t best = 1;
  for (size_t j = 2; j < LAST; j++) {
    best = fabs(part[j] - wanted) < fabs(part[best] - wanted) ? j : best;
  }
  return best;
}

/* Within a factor of two of x, but no shorter than `least`. */
static double limited(double x, double change, double least) {
  double wanted = x + change;
  wanted = wanted > 2 * x ? 2 * x : wanted < 0.5 * x ? 0.5 * x : wanted;
  return wanted > least ? wanted : least;
}

/* One step towards f = 0 at two places; false: it is not defined. */
static bool improve(const struct ph_arc *arc, const double *part,
                    const ph_cplx c[4], double least, double handle[2]) {
  const size_t at[2] = {nearest(part, 1. / 3), nearest(part, 2. / 3)};
  double row[2][3], det, change[2];
  for (size_t i = 0; i < 2; i++) {
    ph_cplx tangent = arc->tangent[at[i]];
    struct foot foot = foot_of(c, arc->point[at[i]], tangent, 0, part[at[i]]);
    double t = foot.t, basis = 3 * t * (1 - t);
    double lean =
        ph_cplx_cross(tangent, foot.c1) / ph_cplx_dot(tangent, foot.c1);
    const ph_cplx first = arc->tangent[0], last = arc->tangent[LAST];
    row[i][0] =
        basis * (1 - t) *
        (ph_cplx_cross(tangent, first) - lean * ph_cplx_dot(tangent, first));
    row[i][1] =
        -basis * t *
        (ph_cplx_cross(tangent, last) - lean * ph_cplx_dot(tangent, last));
    row[i][2] = -foot.f;
  }
  det = row[0][0] * row[1][1] - row[0][1] * row[1][0];
  change[0] = (row[0][2] * row[1][1] - row[0][1] * row[1][2]) / det;
  change[1] = (row[0][0] * row[1][2] - row[0][2] * row[1][0]) / det;
  if (!isfinite(change[0]) || !isfinite(change[1])) {
    return false;
  }
  handle[0] = limited(handle[0], change[0], least);
  handle[1] = limited(handle[1], change[1], least);
  return true;
}

/* Whether the arc goes forward along its chord; its parts up to each place. */
static bool measure(const struct ph_arc *arc, double *part, double *length) {
  ph_cplx chord = ph_cplx_sub(arc->point[LAST], arc->point[0]);
  double sum = 0, least = FORWARD * ph_cplx_abs(chord);
  bool forward = least > 0;
  for (size_t j = 0; j <= LAST; j++) {
    sum +=
        j > 0 ? ph_cplx_abs(ph_cplx_sub(arc->point[j], arc->point[j - 1])) : 0;
    part[j] = sum;
    forward = forward && ph_cplx_dot(arc->tangent[j], chord) > least;
  }
  for (size_t j = 0; j <= LAST; j++) {
    part[j] /= sum;
  }
  *length = sum;
  return forward;
}

static bool goes_forward(const ph_cplx c[4]) {
  ph_cplx chord = ph_cplx_sub(c[3], c[0]);
  return ph_cplx_dot(ph_cplx_sub(c[2], c[1]), chord) > 0;
}

double ph_cubics_distance(const struct ph_arc *arc, const ph_cplx c[4]) {
  double part[LAST + 1], length;
  return measure(arc, part, &length) ? distance_of(arc, part, c)
                                     : (double)INFINITY;
}

void ph_cubics_respace(const struct ph_arc *arc, const double *u,
                       double *spaced) {
  double part[LAST + 1], length;
  size_t i = 0;
  (void)measure(arc, part, &length);
  for (size_t j = 0; j <= LAST; j++) {
    double wanted = (double)j / LAST;
    while (i + 1 < LAST && part[i + 1] < wanted) {
      i++;
    }
    spaced[j] =
        u[i] + (u[i + 1] - u[i]) * (wanted - part[i]) / (part[i + 1] - part[i]);
  }
  spaced[0] = u[0];
  spaced[LAST] = u[LAST];
}

double ph_cubics_fit(const struct ph_arc *arc, double enough, ph_cplx c[4]) {
  double part[LAST + 1], length, distance, handle[2];
  cubic_of(arc, 0, 0, c);
  if (!measure(arc, part, &length)) {
    return (double)INFINITY;
  }
  handle[0] = handle[1] = length / 3;
  cubic_of(arc, handle[0], handle[1], c);
  distance = distance_of(arc, part, c);
  for (size_t i = 0; i < NEWTON_MAX && !(distance <= enough); i++) {
    const double before[2] = {handle[0], handle[1]};
    if (!improve(arc, part, c, SHORTEST * length, handle)) {
      return (double)INFINITY;
    }
    cubic_of(arc, handle[0], handle[1], c);
    distance = distance_of(arc, part, c);
    if (fabs(handle[0] - before[0]) + fabs(handle[1] - before[1]) <=
        1e-6 * length) {
      break;
    }
  }
  return goes_forward(c) ? distance : (double)INFINITY;
}
