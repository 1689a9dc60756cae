/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Whether a few Tschirnhausen cubics, one after another, cross each other or
 * themselves: the fast test for choosing among solutions.  Whole splines are
 * looked at by cross.h.
 */
#ifndef PH_CURVE_CROSS_TC_SIMPLE_H
#define PH_CURVE_CROSS_TC_SIMPLE_H

#include "curve/segment/tc.h"

#include <stddef.h>

/* PH_TC_SIMPLE_NEAR: points no further apart than this, relative to the length
 * of the chain, meet, if the tangent turns by a half turn or more between them.
 */
#define PH_TC_SIMPLE_NEAR 1e-11

/* At most so many cubics. */
enum { PH_TC_CHAIN_MAX = 2 };

/*
 * ph_tc_is_simple: no cubic is irregular or has a loop, and no two points of
 * the chain meet: a chain whose tangent turns within less than a half turn
 * cannot meet itself.
 *
 * in   tc[n]  1 <= n <= PH_TC_CHAIN_MAX, G1 at the joint; each starts where the
 *             one before ends
 */
bool ph_tc_is_simple(const struct ph_tc *tc, size_t n);

#endif
