/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Tschirnhausen cubics: plane cubics whose hodograph is the square of a linear
 * preimage, wherever they start.  [BYR11, ch. 4]
 *
 *   r'(t) = w(t)^2,  w(t) = w0 (1-t) + w1 t,  t in [0,1]
 *   sigma(t) = |w(t)|^2                                  parametric speed
 *
 * With A = |w0|^2, B = |w1|^2, R = Re(conj(w0) w1), K = Im(conj(w0) w1) and
 * M = |w1 - w0|^2 = A - 2 R + B, all is in closed form: the length is
 * (A + R + B)/3, the curvature 2 K / |w|^4, of one sign, and the tangent turns
 * by 2 atan2(K, R), less than a whole turn to either side.  Both signs of (w0,
 * w1) give the same curve.
 *
 * Preimages are expected near unit scale.
 */
#ifndef PH_CURVE_SEGMENT_TC_H
#define PH_CURVE_SEGMENT_TC_H

#include "kernel/cplx.h"

#include <stdbool.h>

struct ph_tc {
  ph_cplx w[2];
};

/* A, B, R and K of a cubic. */
struct ph_tc_form {
  double a, b, r, k;
};

static inline struct ph_tc_form ph_tc_form_of(const struct ph_tc *tc) {
  struct ph_tc_form f = {ph_cplx_norm2(tc->w[0]), ph_cplx_norm2(tc->w[1]),
                         ph_cplx_dot(tc->w[0], tc->w[1]),
                         ph_cplx_cross(tc->w[0], tc->w[1])};
  return f;
}

/* ph_tc_leg: r(1) - r(0) = (w0^2 + w0 w1 + w1^2)/3. */
ph_cplx ph_tc_leg(const struct ph_tc *tc);

/*
 * ph_tc_control_points: Bezier points of the cubic from `start` to `end`.
 *
 * The first leg is taken from the start and the last from the end, so that the
 * end points are reproduced exactly; what ph_tc_leg misses `end - start` by is
 * in the middle leg.
 *
 * out  p[4]
 */
void ph_tc_control_points(const struct ph_tc *tc, ph_cplx start, ph_cplx end,
                          ph_cplx p[4]);

/* ph_tc_length: the exact length. */
double ph_tc_length(const struct ph_tc *tc);

/* ph_tc_turning: the angle by which the tangent turns, in (-2 pi, 2 pi). */
double ph_tc_turning(const struct ph_tc *tc);

/*
 * ph_tc_is_regular: false where w is 0, or nearly so beside its coefficients:
 * at an end (1e-12 of the other) or within, where w passes through 0 (K = 0 and
 * R < 0, to 1e-12): a cusp.  A w that is not finite is not regular.
 */
bool ph_tc_is_regular(const struct ph_tc *tc);

/*
 * ph_tc_has_loop: whether the double point of the unbounded cubic [BYR11,
 * (5.16), (5.17)] is on [0,1]: it turns by more than 4 pi/3 and covers 2 pi/3
 * to either side of its vertex.
 *
 *   R < 0, K != 0 and sqrt3 |K| <= min(A, B) - R,  without a division
 */
bool ph_tc_has_loop(const struct ph_tc *tc);

/*
 * ph_tc_energy: the integral of kappa^2 ds, in 1/unit: a closed form that is
 * good to some eps of what A, B, R and K say, for every sweep of w.  K itself,
 * a difference, is known to fewer digits where the sweep is small.
 *
 * ret  0 for a straight line; infinite unless regular
 */
double ph_tc_energy(const struct ph_tc *tc);

/* ph_tc_vertex: the parameter in [0,1] of the largest |curvature|, that of the
 * foot (A - R)/M of the origin on the line of w, or the end next to it. */
double ph_tc_vertex(const struct ph_tc *tc);

/* ph_tc_part: the part [u,v] on [0,1] again. */
struct ph_tc ph_tc_part(const struct ph_tc *tc, double u, double v);

#endif
