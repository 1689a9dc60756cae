/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * C1 Hermite interpolation by a pair of Tschirnhausen cubics [BYR11, thm 17],
 * each on its own [0,1], with the same preimage z at the joint.
 *
 *   w0 = sqrt(t0), w2 = +-sqrt(t1)                           principal roots
 *   2 z^2 + (w0 + w2) z + w0^2 + w2^2 - 3 = 0
 *   z = (-(w0 + w2) +- rho)/4,  rho = sqrt((w0 + w2)^2 - 8 (w0^2 + w2^2 - 3))
 *
 * gives four pairs; the standard one has both signs +.  The larger root is
 * taken by this formula, the other by their product.
 */
#ifndef PH_SOLVE_TC_PAIR_H
#define PH_SOLVE_TC_PAIR_H

#include "solve/tc/fit.h"

enum { PH_TC_PAIRS = 4 };

/* ph_tc_pairs: the four, in the order ++, +-, -+, --; not measured.
 *
 * in   h  derivatives over the chord, not 0, snapped */
void ph_tc_pairs(const struct ph_tc_hermite *h,
                 struct ph_tc_fit fits[PH_TC_PAIRS]);

/* Derivatives over the chord: standard pairs are simple to 1.46, and have no
 * sharp bend at an end from .03. */
#define PH_TC_PAIR_SHORTEST 0.03
#define PH_TC_PAIR_LONGEST 1.4

/* ph_tc_pair_is_safe: whether the standard pair is known to be the best by
 * sight of the data: both within a right angle of the chord, and of a length
 * between those. */
bool ph_tc_pair_is_safe(const struct ph_tc_hermite *h);

/*
 * ph_tc_pair_standard: the standard pair, not measured.  Where a derivative is
 * exactly backward it is not defined (its mirror image has the same right to
 * the name).
 *
 * ret  false there; fit is then not set
 */
bool ph_tc_pair_standard(const struct ph_tc_hermite *h, struct ph_tc_fit *fit);

/*
 * ph_tc_pair_best: of the four the best by ph_tc_fit_best, measured; safe data
 * are not tested.  Of data that are their own mirror image from the other end
 * two pairs may be equally good.
 *
 * ret  false if all four are irregular
 */
bool ph_tc_pair_best(const struct ph_tc_hermite *h, struct ph_tc_fit *fit);

#endif
