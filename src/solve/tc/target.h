/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The mode `approximate`: a chain of Bezier curves to Tschirnhausen cubics. */
#ifndef PH_SOLVE_TC_TARGET_H
#define PH_SOLVE_TC_TARGET_H

#include "base/mem.h"
#include "curve/problem.h"
#include "curve/result.h"

/*
 * ph_tc_target: reads the field curve (or points, the control points of one
 * Bezier curve), approximates it within `tolerance` or with `pieces` cubics,
 * and fills result: the curve, an interval for each Bezier curve, and the
 * distance. A knot is the parameter of the chain, k + t on its curve k.
 *
 * ret  PH_OK | PH_MISSING_FIELD | PH_BAD_VALUE | PH_BAD_SHAPE |
 *      PH_TOO_FEW_POINTS | PH_COINCIDENT_POINTS | PH_NO_CONVERGENCE |
 *      PH_TOO_LARGE | PH_NO_MEMORY
 */
enum ph_status ph_tc_target(const struct ph_problem *problem,
                            struct ph_arena *out, struct ph_arena *scratch,
                            struct ph_result *result, struct ph_diag *diag);

#endif
