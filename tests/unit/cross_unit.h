/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * What tests of crossings share: the answer, checked, and curves to ask about.
 */
#ifndef PH_TESTS_CROSS_UNIT_H
#define PH_TESTS_CROSS_UNIT_H

#include "planar_unit.h"
#include "unit.h"

#include "curve/cross/cross.h"

/* unit_cross: what cross.h says of a curve of about this size; a crossing that
 * it tells of is one, and its memory is given back. */
struct ph_cross unit_cross(const struct ph_curve *curve, double size);

enum { UNIT_PIECES = 300 };

/* A curve of up to so many PH segments. */
struct unit_chain {
  struct ph_curve curve;
  double p[12 * UNIT_PIECES], w[6 * UNIT_PIECES];
};

/* unit_chain_begin: no segments. */
void unit_chain_begin(struct unit_chain *chain, bool closed);

/* unit_chain_add: goes on from where the chain ends, at first from 0. */
void unit_chain_add(struct unit_chain *chain, const ph_cplx w[3]);

/* unit_chain_random: n segments that turn as they like, with one tangent at
 * each joint. */
void unit_chain_random(struct unit_chain *chain, struct unit_random *r,
                       size_t n);

/* unit_planar_random: a spline through 5 to 20 points, PH or ATPH, open or
 * closed, gently or sharply turning as i goes from 0 on. */
struct unit_solution unit_planar_random(struct unit_random *r, int i);

#endif
