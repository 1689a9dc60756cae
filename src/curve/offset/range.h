/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * How far offsets of a plane curve are regular: at d, where 1 - d kappa > 0 all
 * along it.  kappa is a quotient of forms (cusp.h), and no larger than the
 * largest quotient of their Bernstein coefficients where those of the lower one
 * are positive [derived here: a mean of these quotients].  Parts whose bound
 * exceeds what is attained somewhere are halved, until none does by more than
 * 1e-13.
 */
#ifndef PH_CURVE_OFFSET_RANGE_H
#define PH_CURVE_OFFSET_RANGE_H

#include "curve/result.h"

/*
 * ph_offset_range: the distances between which all offsets of a PH, ATPH curve
 * or cubics are regular; corners are not looked at.
 *
 * out  range[2]  the largest, > 0, to the left, and the least, < 0, to the
 *                right; 0: the curve stands still somewhere; NaN: it bends
 *                nowhere to that side, and every distance is one
 */
void ph_offset_range(const struct ph_curve *curve, double range[2]);

#endif
