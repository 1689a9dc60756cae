/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What is said of problems whose points were joined. */
#ifndef PH_CLI_MERGED_H
#define PH_CLI_MERGED_H

#include "curve/merge.h"
#include "curve/result.h"

/* ph_merge_tell: what is said of a problem is said of the points and intervals
 * that were given: renumbers "points[3]", and the like of other fields, in
 * field and message. */
void ph_merge_tell(const struct ph_merge *merge, struct ph_diag *diag);

/* ph_merge_result: what a result says of points that were joined, and a
 * warning; its other warnings are renumbered (ph_merge_tell). */
void ph_merge_result(const struct ph_merge *merge, struct ph_result *result);

#endif
