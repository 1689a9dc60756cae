/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * ATPH segments that are known in closed form: preimages that only turn, and
 * with them the tangent, at an even rate.
 *
 * With t = alpha u, E(t) A0 and E(t) = cos t + sin t k lies in the space of
 * preimages, as A0 does not change; its value A0 and its derivative k A0 at 0
 * give A1 = A0 + alpha / (2 slope) k A0 (kernel/atph.h). A i A* is A0 i A0*,
 * turned about z by 2 t. [derived here; tested by t_sample_ph.c]
 */
#ifndef PH_TESTS_KNOWN_UNIT_H
#define PH_TESTS_KNOWN_UNIT_H

#include "curve3_unit.h"
#include "seg2_unit.h"

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

#endif
