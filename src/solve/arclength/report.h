/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What is told of a search for arc-length splines: curves, lengths, diagnostics
 * and warnings, or why there is none. */
#ifndef PH_SOLVE_ARCLENGTH_REPORT_H
#define PH_SOLVE_ARCLENGTH_REPORT_H

#include "curve/result.h"
#include "solve/arclength/search.h"

/*
 * ph_arc_report: the result of a search that found something.
 *
 * in   left_plane  data in a plane whose curve is not
 * out  result      curve, intervals, starts, solutions if all were asked for,
 *                  diagnostics and warnings
 * ret  PH_OK | PH_NO_MEMORY
 */
enum ph_status ph_arc_report(const struct ph_arc_search *search,
                             bool left_plane, struct ph_arena *scratch,
                             struct ph_arena *out, struct ph_result *result,
                             struct ph_diag *diag);

/* ph_arc_report_failure: why nothing was found: the interval that is missed
 * most, with its lengths.  ret PH_NO_CONVERGENCE | PH_NO_MEMORY */
enum ph_status ph_arc_report_failure(const struct ph_arc_search *search,
                                     struct ph_arena *scratch,
                                     struct ph_diag *diag);

#endif
