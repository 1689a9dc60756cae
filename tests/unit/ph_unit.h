/* SPDX-License-Identifier: GPL-3.0-or-later */
/* PH quintic segments by themselves: what the library knows of segments in any
 * space of preimages, for the polynomial one. */
#ifndef PH_TESTS_PH_UNIT_H
#define PH_TESTS_PH_UNIT_H

#include "curve/segment/seg2.h"

/* The space of PH quintics. */
static const struct ph_atph ph_quintic = {
    0, 1, 1, 1, {1.0 / 5, 1.0 / 5, 2.0 / 15, 1.0 / 15}};
/* The Bernstein coefficients of w^2. */
static inline void ph_hodograph(const ph_cplx w[3], ph_cplx hodograph[5]) {
  ph_cplx middle = ph_cplx_add(ph_cplx_scale(2, ph_cplx_mul(w[1], w[1])),
                               ph_cplx_mul(w[0], w[2]));
  hodograph[0] = ph_cplx_mul(w[0], w[0]);
  hodograph[1] = ph_cplx_mul(w[0], w[1]);
  hodograph[2] = ph_cplx_scale(1.0 / 3, middle);
  hodograph[3] = ph_cplx_mul(w[1], w[2]);
  hodograph[4] = ph_cplx_mul(w[2], w[2]);
}

static inline double ph_length(const ph_cplx w[3]) {
  return ph_seg2_length(&ph_quintic, w);
}

static inline void ph_control_points(const ph_cplx w[3], ph_cplx start,
                                     ph_cplx end, ph_cplx p[6]) {
  ph_seg2_control_points(&ph_quintic, w, start, end, p);
}

static inline double ph_rotation(const ph_cplx w[3]) {
  struct ph_seg2 seg = {ph_atph_of(0), {w[0], w[1], w[2]}, {0, 0}, {0, 0}};
  return ph_seg2_rotation(&seg, NULL);
}

#endif
