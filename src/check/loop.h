/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Loops of offsets: what is found of them from their control points and those
 * of the curve alone, by code that does not know how they were put together.
 *
 *   closure   where a piece ends the next one begins, and the last one of a
 *             closed loop ends where the first begins
 *   distance  pieces of segments are at the distance along the normal, at equal
 *             parameters; joins are at the distance from their corners; of
 *             trimmed offsets no place of a piece is nearer to any point of the
 *             curve, by bounds (clear.h), or where these do not say so, three
 *             places of it are not, one if there are more than 256 pieces
 *   length    of pieces by quadrature, and the sums of them
 *   area      of loops by quadrature, and the sum
 *   turns     a closed loop of a trimmed offset turns by 2 pi to one side, and
 *             where parts that crossed meet, to that of the distance
 */
#ifndef PH_CHECK_LOOP_H
#define PH_CHECK_LOOP_H

#include "check/checks.h"

/* The worst errors, lengths relative to the size of the curve and the distance
 * together, areas to its square, turns in radians. */
struct ph_check_found {
  double closure, distance, length, area, turn;
  size_t at[5]; /* the loop of each, in this order */
  bool broken;  /* something that cannot be: which loop, in at[0] */
};

/* ph_check_loops: the loops of an offset that has them.
 * ret PH_OK | PH_E_NO_MEMORY */
enum ph_status ph_check_loops(struct ph_check *v, const struct ph_offset *o,
                              struct ph_check_found *found);

/*
 * ph_certify_loops: certificates of all offsets, if they have loops.
 *
 * inout offsets  take the errors, and that they are certified
 * ret   PH_OK | PH_E_NO_CONVERGENCE (an error exceeds 1e-10 of joined and
 *       trimmed offsets, 1e-12 of closure; says which and where) |
 *       PH_E_NO_MEMORY
 */
enum ph_status ph_certify_loops(const struct ph_curve *curve,
                                struct ph_offset *offsets, size_t n,
                                struct ph_arena *scratch, struct ph_diag *diag);

#endif
