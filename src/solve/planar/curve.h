/* SPDX-License-Identifier: GPL-3.0-or-later */
/* From the unknowns of the C2 equations to a curve in the user's unit. */
#ifndef PH_SOLVE_PLANAR_CURVE_H
#define PH_SOLVE_PLANAR_CURVE_H

#include "curve/result.h"
#include "solve/planar/data.h"

/* Segments that turn by more than half a turn. */
struct ph_planar_loops {
  size_t n, first;
  double angle; /* of the first */
};

/* ph_planar_curve_alloc: a curve for these data, without its numbers.
 * ret  PH_OK | PH_NO_MEMORY */
enum ph_status ph_planar_curve_alloc(const struct ph_planar_data *data,
                                     struct ph_arena *arena,
                                     struct ph_curve *curve,
                                     struct ph_diag *diag);

/*
 * ph_planar_curve_fill: the numbers of a curve, for the twist in data->c2.
 *
 * in   b[unknowns]  a solution of the C2 equations
 */
void ph_planar_curve_fill(const struct ph_planar_data *data, const ph_cplx *b,
                          struct ph_curve *curve,
                          struct ph_planar_loops *loops);

#endif
