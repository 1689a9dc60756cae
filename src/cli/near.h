/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What is said of a curve that is refused as its points are too near. */
#ifndef PH_CLI_NEAR_H
#define PH_CLI_NEAR_H

#include "base/diag.h"
#include "curve/problem.h"

/*
 * ph_near_points: whether the nearest two of consecutive points are less than
 * 4096 roundings of the largest coordinate apart.
 *
 * inout diag  if so, names them and says what helps; else stays
 * ret   PH_E_COINCIDENT_POINTS, or the status that diag has
 */
enum ph_status ph_near_points(const struct ph_problem *problem,
                              struct ph_diag *diag);

#endif
