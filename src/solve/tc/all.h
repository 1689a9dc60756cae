/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Every curve of Tschirnhausen cubics through the data, best first. */
#ifndef PH_SOLVE_TC_ALL_H
#define PH_SOLVE_TC_ALL_H

#include "base/mem.h"
#include "curve/result.h"
#include "solve/tc/interval.h"

/* PH_TC_ALL_MAX, PH_TC_ALL_INTERVALS: at most so many curves, with so many
 * intervals in all. */
enum { PH_TC_ALL_MAX = 4096, PH_TC_ALL_INTERVALS = 65536 };

/*
 * ph_tc_all: the product of what the intervals may have (tc_interval.h), simple
 * curves first, then regular ones, each by energy.
 *
 * out  result     solutions, of which the first is the curve
 * out  crossings  of the intervals of that one
 * ret  PH_OK | PH_INFEASIBLE | PH_BAD_VALUE (too many) | PH_NO_MEMORY
 */
enum ph_status ph_tc_all(const struct ph_tc_data *data, struct ph_arena *out,
                         struct ph_arena *scratch, struct ph_result *result,
                         struct ph_tc_crossings *crossings,
                         struct ph_diag *diag);

#endif
