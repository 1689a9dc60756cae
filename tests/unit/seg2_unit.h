/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What tests of planar segments share: segments by chance, curves of one. */
#ifndef PH_TESTS_SEG2_UNIT_H
#define PH_TESTS_SEG2_UNIT_H

#include "curve/result.h"
#include "curve/segment/seg2.h"
#include "unit.h"

/* A curve with room for a few segments. */
struct unit_segments {
  struct ph_curve curve;
  double knots[4], control_points[36], alpha[3], preimage[18], lengths[3];
};

/* unit_seg2: the segment with this angle and preimage, from 0. */
struct ph_seg2 unit_seg2(double angle, const ph_cplx w[3]);

/* unit_seg2_random: an angle of 0 (one in four) or in (0, 3), a preimage that
 * turns by any angle. */
struct ph_seg2 unit_seg2_random(struct unit_random *r);

/* unit_seg2_curve: the curve of n <= 3 segments, all of angle 0 or none. */
void unit_seg2_curve(const struct ph_seg2 *seg, size_t n,
                     struct unit_segments *segments);

/* unit_seg2_w: w at u, straight from its definition. */
ph_cplx unit_seg2_w(const struct ph_seg2 *seg, double u);

/* unit_seg2_part: the part [u0,u1] on [0,1] again; points as for ph_seg2_point.
 */
struct ph_seg2 unit_seg2_part(const struct ph_seg2 *seg,
                              const struct ph_quad *rule, double u0, double u1);

#endif
