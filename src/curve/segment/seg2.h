/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * One segment of a planar PH or ATPH spline, or a Tschirnhausen cubic, by
 * itself: points, derivatives, curvature, parts, rotation.
 *
 * The preimage is with respect to u in [0,1], whatever the curve writes:
 * r'(u) = w(u)^2, with the parametric speed sigma(u) = |w(u)|^2.  It lies in
 * the segment's space (kernel/atph.h), by coefficients w0, w1, w2: for PH
 * quintics, Bernstein coefficients of degree 2.  [GON18, ch. 2]  That of a
 * cubic is raised to degree 2: w0, (w0 + w1)/2, w1.
 */
#ifndef PH_CURVE_SEGMENT_SEG2_H
#define PH_CURVE_SEGMENT_SEG2_H

#include "curve/result.h"
#include "kernel/atph.h"
#include "kernel/cplx.h"
#include "kernel/quad.h"

#include <float.h>
#include <stdbool.h>

struct ph_seg2 {
  struct ph_atph space;
  ph_cplx w[3];
  ph_cplx start, end;
};

/* ph_seg2_length: the exact arc length, integral of |w|^2 over [0,1]. */
static inline double ph_seg2_length(const struct ph_atph *space,
                                    const ph_cplx w[3]) {
  const double *q = space->q;
  return q[0] * (ph_cplx_norm2(w[0]) + ph_cplx_norm2(w[2])) +
         q[1] * (ph_cplx_dot(w[0], w[1]) + ph_cplx_dot(w[1], w[2])) +
         q[2] * ph_cplx_norm2(w[1]) + q[3] * ph_cplx_dot(w[0], w[2]);
}

/*
 * ph_seg2_control_points: control points of the segment from `start` to `end`,
 * in the basis of its space: Bezier points of a PH quintic [GON18, (2.12)].
 *
 * The first three are summed up from the start and the last three from the
 * end: the end points are reproduced exactly, the construction is symmetric
 * under reversal, and what the integral of w^2 misses `end - start` by (the
 * solver's residual) shows up in the middle leg, where the certificate looks.
 *
 * in   w[3]         preimage, in the root of the unit of the points
 * out  p[6]
 */
static inline void ph_seg2_control_points(const struct ph_atph *space,
                                          const ph_cplx w[3], ph_cplx start,
                                          ph_cplx end, ph_cplx p[6]) {
  double outer = space->q[0], inner = space->q[1];
  ph_cplx first = ph_cplx_mul(w[0], w[0]), second = ph_cplx_mul(w[0], w[1]);
  ph_cplx fourth = ph_cplx_mul(w[1], w[2]), fifth = ph_cplx_mul(w[2], w[2]);
  ph_cplx a = ph_cplx_add(start, ph_cplx_scale(outer, first));
  ph_cplx b = ph_cplx_add(a, ph_cplx_scale(inner, second));
  ph_cplx d = ph_cplx_sub(end, ph_cplx_scale(outer, fifth));
  ph_cplx c = ph_cplx_sub(d, ph_cplx_scale(inner, fourth));
  p[0] = start;
  p[1] = a;
  p[2] = b;
  p[3] = c;
  p[4] = d;
  p[5] = end;
}

/* ph_seg2_preimage: the preimage of segment k as the curve has it, but of three
 * coefficients always. */
void ph_seg2_preimage(const struct ph_curve *curve, size_t k, ph_cplx w[3]);

/* ph_seg2_of: segment k of a planar curve. */
struct ph_seg2 ph_seg2_of(const struct ph_curve *curve, size_t k);

/*
 * ph_seg2_point: r(u), by quadrature of the hodograph from the nearer end, so
 * that the ends are met exactly and nothing cancels.
 *
 * in   rule  12 Gauss nodes reach rounding for every angle below pi
 */
ph_cplx ph_seg2_point(const struct ph_seg2 *seg, const struct ph_quad *rule,
                      double u);

/* Curvature at u: derivatives of the curve by way of its preimage. */
struct ph_curvature {
  double speed;     /* |r'| = |w|^2, per u */
  ph_cplx tangent;  /* unit */
  double curvature; /* signed, positive to the left */
  double rate;      /* d curvature / du; divide by speed for d/ds */
  double terms[2];  /* bounds of the squares of what curvature and rate are
                       differences of: their errors are some eps times that */
};

/* ph_seg2_curvature: the speed is positive unless w(u) = 0; there the rest is
 * not finite. */
static inline struct ph_curvature ph_seg2_curvature(const struct ph_seg2 *seg,
                                                    double u) {
  ph_cplx w[3];
  struct ph_curvature at;
  double s, per_s, a, r, a1, w1, w2;
  ph_atph_jet(&seg->space, seg->w, u, w, 3);
  s = ph_cplx_norm2(w[0]);
  per_s = 1 / s;
  a = ph_cplx_cross(w[0], w[1]) * per_s;
  r = ph_cplx_dot(w[0], w[1]) * per_s;
  a1 = ph_cplx_cross(w[0], w[2]) * per_s;
  w1 = ph_cplx_norm2(w[1]) * per_s;
  w2 = ph_cplx_norm2(w[2]) * per_s;
  at.speed = s;
  at.tangent = ph_cplx_scale(per_s, ph_cplx_mul(w[0], w[0]));
  at.curvature = 2 * a * per_s;
  at.rate = (2 * a1 - 8 * a * r) * per_s;
  /* The ones: w' and w'' are differences of coefficients as large as w. */
  at.terms[0] = 4 * (1 + w1) * per_s * per_s;
  at.terms[1] = (8 * (1 + w2) + 128 * (1 + w1 * w1)) * per_s * per_s;
  return at;
}

/* ph_seg2_is_monotone: whether the preimage stays within a quarter turn, so
 * that the tangent stays within a half turn and the curve is monotone along an
 * axis, by sight of its coefficients. */
static inline bool ph_seg2_is_monotone(const ph_cplx w[3]) {
  return ph_cplx_dot(w[0], w[1]) > 0 && ph_cplx_dot(w[1], w[2]) > 0 &&
         ph_cplx_dot(w[0], w[2]) > 0;
}

/* PH_SEG2_STILL: the speed that rounding leaves, relative. */
#define PH_SEG2_STILL (16 * DBL_EPSILON)

/*
 * ph_seg2_moves_on: whether it is monotone and stands still nowhere, by sight
 * of its coefficients at unit scale, or near it.
 *
 * In |w|^2 no term of w, within a quarter turn, takes from the others: it is at
 * least |w0|^2 (1-v)^4 + |w2|^2 v^4, an eighth of the smaller.
 */
static inline bool ph_seg2_moves_on(const ph_cplx w[3]) {
  double first = ph_cplx_norm2(w[0]), last = ph_cplx_norm2(w[2]);
  double middle = ph_cplx_norm2(w[1]), sum = first + middle + last;
  return ph_seg2_is_monotone(w) && first > 8 * PH_SEG2_STILL * sum &&
         last > 8 * PH_SEG2_STILL * sum;
}

/* ph_seg2_slow: the places in [0,1] that are nearest to the two zeros of w;
 * where the speed nearly vanishes, it is least there. */
void ph_seg2_slow(const struct ph_seg2 *seg, double u[2]);

/*
 * ph_seg2_stands_still: whether the speed |w|^2 falls somewhere, at the ends
 * too, to what rounding of the control points leaves of it: PH_SEG2_STILL of
 * its largest coefficient.  Rounding then decides on which side w passes 0, and
 * whether the tangent turns by +2 pi or -2 pi there: energies and rotations are
 * not defined.  So of what is not a number.
 *
 * out  u  NULL, or where, if so
 */
bool ph_seg2_stands_still(const struct ph_seg2 *seg, double *u);

/*
 * ph_seg2_rotation: the angle by which the tangent turns, signed and not
 * reduced modulo 2 pi, and the sum of its turns to either side.
 *
 * In closed form, exact also for loops: w is split into two linear forms of
 * S0, S1, each of which turns by less than pi, and the segment is cut at its
 * inflections, where Im(conj(w) w') changes sign.
 *
 * out  absolute  NULL, or the integral of |curvature| over arc length
 */
double ph_seg2_rotation(const struct ph_seg2 *seg, double *absolute);

#endif
