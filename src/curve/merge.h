/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The field merge: consecutive points that are nearer than a distance become
 * one, before a method or a check sees the problem.
 *
 * A point is joined to the last one that was kept.  The first point stays, of
 * open data the last one as well: points nearer to it than the distance are
 * joined to it; of closed data those at the end that are near the first point
 * are joined to that.  Distances are in the unit of the points; on a sphere
 * they are along great circles, in the unit of its radius.
 */
#ifndef PH_CURVE_MERGE_H
#define PH_CURVE_MERGE_H

#include "base/diag.h"
#include "base/mem.h"
#include "curve/problem.h"

/* What was joined; {0}: nothing. */
struct ph_merge {
  const struct ph_schema *schema; /* NULL: nothing was joined */
  enum ph_field_id points;        /* the field that has them */
  double distance;
  size_t n;           /* points that were given, */
  const size_t *to;   /* to[n]: the one that each was joined to, or itself */
  const size_t *kept; /* kept[kept_n]: those that are left */
  size_t kept_n;
  const size_t *gone; /* gone[gone_n]: those that are not, but for a last one of
                         closed data that repeats the first */
  size_t gone_n;
  const size_t *interval; /* interval[kept_n]: of the intervals that became the
                             one after each, the one with the longest chord */
};

/*
 * ph_merge: does what the field merge of a problem says.
 *
 * Of joined points the one that stays keeps what is given there; vectors and
 * tensions at the others must be the same to a tenth.  Lengths of intervals are
 * added; of other numbers that belong to intervals those of the longest stay.
 *
 * inout problem  its arrays are replaced, not written to
 * out   merge    memory of the arena
 * ret   PH_OK | PH_E_BAD_VALUE | PH_E_BAD_SHAPE | PH_E_NO_MEMORY
 */
enum ph_status ph_merge(const struct ph_schema *schema, struct ph_arena *arena,
                        struct ph_problem *problem, struct ph_merge *merge,
                        struct ph_diag *diag);

#endif
