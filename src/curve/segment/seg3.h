/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * One segment of a spatial PH or ATPH spline, or of a planar one taken in
 * space, by itself: points, derivatives, curvature and torsion, frames, parts.
 *
 * The preimage is with respect to u in [0,1], whatever the curve writes:
 * r'(u) = A(u) i A(u)*.  All invariants come from W = vect(A* A'), which lies
 * in the space of A again: with W = x i + p j + q k and z = p + i q,
 *
 *   kappa = 2 |z| / sigma^2                                             (1)
 *   tau = (Im(conj(z) z') / |z|^2 + 2 x / sigma) / sigma                (2)
 *   e2' = 2 (x e3 - q e1) / sigma,  e3' = 2 (p e1 - x e2) / sigma       (3)
 *
 * for the Euler-Rodrigues frame e1 = A i A* / sigma, e2 = A j A* / sigma,
 * e3 = A k A* / sigma.  [FAR15, sec. 3; (1)-(3) derived from r' = A i A*,
 * tested by t_seg3.c]
 */
#ifndef PH_CURVE_SEGMENT_SEG3_H
#define PH_CURVE_SEGMENT_SEG3_H

#include "curve/result.h"
#include "kernel/atph.h"
#include "kernel/quad.h"
#include "kernel/quat.h"

struct ph_seg3 {
  struct ph_atph space;
  ph_quat a[3];
  ph_vec3 start, end;
};

/* ph_seg3_speed: of a PH quintic, the Bernstein coefficients of |A|^2.
 * out speed[5] */
void ph_seg3_speed(const ph_quat a[3], double speed[5]);

/* ph_seg3_length: the exact arc length, integral of |A|^2 over [0,1]. */
double ph_seg3_length(const struct ph_atph *space, const ph_quat a[3]);

/*
 * ph_seg3_control_points: control points of the segment from `start` to `end`,
 * in the basis of its space [FAR15, (6)].
 *
 * As in the plane (seg2.h), the first three are summed up from the start and
 * the last three from the end: what the preimage misses `end - start` by shows
 * up in the middle leg, where the certificate looks.
 *
 * in   a[3]  preimage, in the root of the unit of the points
 * out  p[6]
 */
void ph_seg3_control_points(const struct ph_atph *space, const ph_quat a[3],
                            ph_vec3 start, ph_vec3 end, ph_vec3 p[6]);

/*
 * ph_seg3_of: segment k of a curve in space, or in the plane z = 0: with
 * A = Re w + Im w k, r' = w^2 there and e2 is the left normal.  The preimage of
 * a Tschirnhausen cubic is raised to degree 2, as in seg2.h.
 */
struct ph_seg3 ph_seg3_of(const struct ph_curve *curve, size_t k);

/* ph_seg3_rescale: brings A to unit scale, by a power of 2; the points stay.
 * ret  by which power of 2 A was larger */
int ph_seg3_rescale(struct ph_seg3 *seg);

/* ph_seg3_pair: the preimage as two complex ones, A = pair[0] + pair[1] j. */
void ph_seg3_pair(const struct ph_seg3 *seg, ph_cplx pair[2][3]);

/* The normals of the Euler-Rodrigues frame. */
enum ph_normal { PH_E2, PH_E3 };

/* ph_normal_between: vect(a j b*) for e2, vect(a k b*) for e3. */
static inline ph_vec3 ph_normal_between(enum ph_normal normal, ph_quat a,
                                        ph_quat b) {
  return normal == PH_E2 ? ph_quat_j(a, b) : ph_quat_k(a, b);
}

/* ph_seg3_jet: A and its derivatives with respect to u.
 * out  jet[n]  A, A', ..., n <= 4 */
void ph_seg3_jet(const struct ph_seg3 *seg, double u, ph_quat *jet, size_t n);

/*
 * ph_seg3_point: r(u), by quadrature of the hodograph from the nearer end, so
 * that the ends are met exactly and nothing cancels.
 *
 * in   rule  12 Gauss nodes reach rounding for every angle below pi
 */
ph_vec3 ph_seg3_point(const struct ph_seg3 *seg, const struct ph_quad *rule,
                      double u);

#endif
