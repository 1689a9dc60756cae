/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Where the iterations of arclength begin [HUA14, sec. 4.4]. */
#ifndef PH_SOLVE_ARCLENGTH_START_H
#define PH_SOLVE_ARCLENGTH_START_H

#include "solve/arclength/system.h"

/*
 * ph_arc_start: spinors of the steps, or of the given vectors, with phases as
 * near to each other as they can be, between which the nodes are interpolated.
 *
 * inout system  the sign of a closed curve in the plane is set
 * out   x[x_n]
 * ret   false when memory is exhausted
 */
bool ph_arc_start(struct ph_arc_system *system, struct ph_arena *scratch,
                  double *x);

/*
 * ph_arc_perturb: adds a random curve of low frequencies to x.
 *
 * in    size   relative to the largest node
 * inout state  of the random numbers
 */
void ph_arc_perturb(const struct ph_arc_system *system, double size,
                    uint64_t *state, double *x);

#endif
