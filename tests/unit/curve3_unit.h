/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Curves in space for tests: splines whose frames join, and what is known of
 * them straight from the definitions, by quaternion products and sums alone.
 */
#ifndef PH_TESTS_CURVE3_UNIT_H
#define PH_TESTS_CURVE3_UNIT_H

#include "curve/result.h"
#include "curve/segment/seg3.h"
#include "kernel/quat.h"
#include "unit.h"

enum { UNIT_CURVE3_MAX = 4 };

/* A curve with room for a few segments. */
struct unit_curve3 {
  struct ph_curve curve;
  double knots[UNIT_CURVE3_MAX + 1], alpha[UNIT_CURVE3_MAX];
  double control_points[18 * UNIT_CURVE3_MAX], preimage[12 * UNIT_CURVE3_MAX];
  double lengths[UNIT_CURVE3_MAX];
};

/*
 * unit_curve3_of: n segments from `start`; segment k has the preimage a[2k],
 * a[2k+1], a[2k+2] by u in [0,1], so that frames and speeds join.
 *
 * in  alpha[n]  the angles, or NULL for a PH curve
 * in  a[2n + 1]
 */
void unit_curve3_of(struct unit_curve3 *c, size_t n, const double *alpha,
                    const ph_quat *a, ph_vec3 start);

/* unit_curve3_random: n segments; the larger `wild`, the more they turn, and
 * from 1 on they may nearly stand still. */
void unit_curve3_random(struct unit_curve3 *c, size_t n, bool atph, double wild,
                        struct unit_random *r);

/* unit_curve3_preimage: A at u of segment k, by u. */
ph_quat unit_curve3_preimage(const struct ph_curve *curve, size_t k, double u);

/* unit_curve3_frame: the Euler-Rodrigues frame. */
void unit_curve3_frame(const struct ph_curve *curve, size_t k, double u,
                       ph_vec3 e[3]);

/* unit_curve3_point: the point, by quadrature of the hodograph from 0. */
ph_vec3 unit_curve3_point(const struct ph_curve *curve, size_t k, double u);

/* unit_curve3_moved: the point at this distance along a normal. */
ph_vec3 unit_curve3_moved(const struct ph_curve *curve, size_t k, double u,
                          double distance, enum ph_normal normal);

/* unit_bezier3: value at t, and derivative `order` with respect to t, of the
 * Bezier curve of `degree` with points p[degree + 1][3]. */
ph_vec3 unit_bezier3(const double *p, size_t degree, size_t order, double t);

/* unit_apart3: |a - b|. */
static inline double unit_apart3(ph_vec3 a, ph_vec3 b) {
  return ph_vec3_abs(ph_vec3_sub(a, b));
}

#endif
