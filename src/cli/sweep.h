/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Sweeps: one problem solved for many values of its fields.
 *
 * The values of a range are computed where they are needed: a sweep takes no
 * more memory for a million values than for one.
 */
#ifndef PH_CLI_SWEEP_H
#define PH_CLI_SWEEP_H

#include "base/diag.h"
#include "cli/range.h"
#include "base/mem.h"
#include "curve/problem.h"
#include "io/json_out.h"

#include <stdbool.h>

enum { PH_SWEEP_INDICES_MAX = 3 };

/* --sweep FIELD=... or FIELD*=...: the values that one field, or one number of
 * an array field, takes, or is multiplied by. */
struct ph_sweep {
  const char *name; /* as given: lengths[1] */
  const struct ph_field *field;
  size_t index[PH_SWEEP_INDICES_MAX];
  size_t index_n; /* 0: the field as a whole */
  size_t n;
  struct ph_value *values; /* [n]; NULL: a range */
  const char **texts;      /* [n], JSON on one line; NULL: a range */
  struct ph_range range;   /* of n numbers */
  bool factor; /* values multiply what the problem has; the name ends in * */
};

/*
 * ph_sweep_read: reads FIELD=START:STOP:COUNT or FIELD=V1,V2,...
 *
 * START:STOP:COUNT gives COUNT equally spaced numbers with both ends exact;
 * START:STOP:COUNT:log numbers of which each is the same multiple of the one
 * before.  With FIELD*= all numbers of the field, or the one, are multiplied.
 *
 * ret  PH_OK | PH_E_USAGE | PH_E_NO_MEMORY
 */
enum ph_status ph_sweep_read(const char *text, const struct ph_schema *schema,
                             struct ph_arena *arena, struct ph_sweep *sweep,
                             struct ph_diag *diag);

/* ph_sweep_same: whether two sweeps set the same number or field. */
bool ph_sweep_same(const struct ph_sweep *a, const struct ph_sweep *b);

/* ph_sweep_count: results for each problem, the product of the counts; 0 when
 * it does not fit a size_t. */
size_t ph_sweep_count(const struct ph_sweep *sweeps, size_t n);

/*
 * ph_sweep_name: what a record says of combination number `which` of the
 * values, the last sweep varying fastest.
 *
 * out  swept[n]  names and values
 * ret  PH_OK | PH_E_NO_MEMORY
 */
enum ph_status ph_sweep_name(const struct ph_sweep *sweeps, size_t n,
                             size_t which, struct ph_arena *arena,
                             struct ph_swept *swept, struct ph_diag *diag);

/*
 * ph_sweep_apply: sets the swept fields of a problem to that combination, in
 * the order of the sweeps.
 *
 * inout problem  arrays are copied to the arena before an element is changed
 * ret   PH_OK | PH_E_BAD_SHAPE (the problem has no such element) |
 *      PH_E_NO_MEMORY
 */
enum ph_status ph_sweep_apply(const struct ph_sweep *sweeps, size_t n,
                              size_t which, struct ph_arena *arena,
                              struct ph_problem *problem, struct ph_diag *diag);

#endif
