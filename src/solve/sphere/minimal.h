/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The smallest tensions that keep the shape of data, starting from some that
 * do. */
#ifndef PH_SOLVE_SPHERE_MINIMAL_H
#define PH_SOLVE_SPHERE_MINIMAL_H

#include "solve/sphere/tension.h"

/*
 * ph_sphere_minimise: lowers the sum of the tensions to a local minimum,
 * nearly, while all criteria that the spline satisfies go on to hold.
 *
 * Blocks of tensions are solved and judged with their neighbourhood only: the
 * caller solves and judges the whole once more.
 *
 * inout raise  after its rounds
 * ret  false when memory is exhausted
 */
bool ph_sphere_minimise(struct ph_sphere_raise *raise,
                        struct ph_arena *scratch);

#endif
