/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Curves for tests: splines in space whose frames join, ATPH segments that are
 * known in closed form, and samples of either; what is known of them comes
 * straight from the definitions.
 */
#ifndef PH_TESTS_CURVE_UNIT_H
#define PH_TESTS_CURVE_UNIT_H

#include "segment_unit.h"
#include "unit.h"

#include "curve/result.h"
#include "curve/sample/inversion.h"
#include "curve/segment/seg3.h"
#include "kernel/quat.h"

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

/* ---- curves in closed form ----------------------------------------------- */

/* unit_circle: from the origin along x and to the left, 2 alpha of a circle:
 * w = sqrt(2 radius) e^(it), by t. */
static inline void unit_circle(double alpha, double radius,
                               struct unit_segments *c) {
  const double rest = alpha / (2 * ph_atph_of(alpha).slope);
  const ph_cplx one = ph_cplx_of(1, 0);
  const ph_cplx w[3] = {one, ph_cplx_of(1, rest), ph_cplx_polar(alpha)};
  const double root = sqrt(2 * radius) * sqrt(alpha);
  struct ph_seg2 seg = {.space = ph_atph_of(alpha)};
  for (size_t i = 0; i < 3; i++) {
    seg.w[i] = ph_cplx_scale(root, w[i]);
  }
  seg.end =
      ph_cplx_of(radius * sin(2 * alpha), 2 * radius * sin(alpha) * sin(alpha));
  unit_seg2_curve(&seg, 1, c);
  c->lengths[0] = c->curve.length = 2 * radius * alpha;
}

/*
 * The helix about z with the radius a that climbs b a radian, turning by
 * 2 alpha: A0 = sqrt(2 m) (cos f/2 - sin f/2 j) has A0 i A0* = 2 m (cos f, 0,
 * sin f), with a = m cos f and b = m sin f.
 */
struct unit_helix {
  double alpha, a, b;
};

static inline ph_quat unit_helix_preimage(const struct unit_helix *h) {
  const double f = atan2(h->b, h->a), root = sqrt(2 * hypot(h->a, h->b));
  return ph_quat_of(root * cos(f / 2), 0, -root * sin(f / 2), 0);
}

static inline void unit_helix_curve(const struct unit_helix *h,
                                    struct unit_curve3 *c) {
  const ph_quat k = {0, 0, 0, 1}, turn = {cos(h->alpha), 0, 0, sin(h->alpha)};
  const double rest = h->alpha / (2 * ph_atph_of(h->alpha).slope);
  const ph_quat a0 = ph_quat_scale(sqrt(h->alpha), unit_helix_preimage(h));
  const ph_quat pre[3] = {
      a0, ph_quat_add(a0, ph_quat_scale(rest, ph_quat_mul(k, a0))),
      ph_quat_mul(turn, a0)};
  unit_curve3_of(c, 1, &h->alpha, pre, ph_vec3_of(0, -h->a, 0));
}

/* The point at u of what is at (0, -radius, 0) turned by `before` about z, and
 * climbs as the helix does. */
static inline ph_vec3 unit_helix_at(const struct unit_helix *h, double u,
                                    double radius, double before) {
  const double turn = 2 * h->alpha * u;
  return ph_vec3_of(radius * sin(turn + before), -radius * cos(turn + before),
                    h->b * turn);
}

/* ---- samples ------------------------------------------------------------- */

/* A sampler of a curve, or of an offset of it, at segment k. */
static inline struct ph_sampler unit_sampler(const struct ph_curve *curve,
                                             const struct ph_offset *offset,
                                             size_t k) {
  struct ph_sampler sampler;
  struct ph_diag diag;
  ck_assert_int_eq(
      ph_sampler_begin(&sampler, curve, offset, &unit_arena, &diag), PH_OK);
  ck_assert_int_eq(ph_sampler_enter(&sampler, k, &diag), PH_OK);
  return sampler;
}

/* The length up to u, without the speed. */
static inline double unit_length(const struct ph_sampler *sampler, double u) {
  double speed;
  return ph_sampler_length(sampler, u, &speed);
}

/* Where the length is s, found from nothing. */
static inline double unit_parameter(const struct ph_sampler *sampler,
                                    double s) {
  struct ph_inversion past = {.n = 0};
  return ph_inversion_next(&past, sampler, s, NULL);
}

static inline struct ph_samples unit_samples(const struct ph_curve *curve,
                                             struct ph_sample_rules rules) {
  struct ph_samples s;
  struct ph_diag diag;
  ck_assert_int_eq(ph_sample_curve(curve, &rules, &unit_arena, &s, &diag),
                   PH_OK);
  ck_assert_uint_eq(s.dimension, curve->dimension);
  return s;
}

/* n + 1 samples of every segment, equally spaced in its parameter. */
static inline struct ph_samples unit_samples_even(const struct ph_curve *curve,
                                                  size_t n) {
  const struct ph_sample_rules rules = {.how = PH_SAMPLE_PARAMETER, .n = n};
  struct ph_samples s = unit_samples(curve, rules);
  ck_assert_uint_eq(s.n, curve->n * (n + 1));
  return s;
}

#endif
