/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The parts of a Bezier curve that its cubics stand for; private to
 * tc_approx*.c.
 */
#ifndef PH_SOLVE_TC_APPROX_PLAN_H
#define PH_SOLVE_TC_APPROX_PLAN_H

#include "solve/tc/approx_part.h"

/* One part of the curve, with the cubics of ph_tc_patch_of. */
struct ph_tc_part {
  double from, to;
  double distance;
  enum ph_tc_kind kind;
  unsigned n; /* cubics: 1 or 2 */
};

/* Parts in their order; room grows by doubling, in an arena. */
struct ph_tc_plan {
  struct ph_arena *arena;
  struct ph_tc_part *part;
  size_t n, room;
  size_t cubics;
  size_t limit; /* of parts */
};

/* ph_tc_plan_add: ret  PH_OK | PH_NO_CONVERGENCE beyond the limit | NO_MEMORY
 */
enum ph_status ph_tc_plan_add(struct ph_tc_plan *plan,
                              const struct ph_tc_part *part,
                              struct ph_diag *diag);

/*
 * ph_tc_plan_curve: parts of a curve within a tolerance, as few cubics as are
 * found; appended.
 *
 * in   u[n]  its inflections
 * ret  PH_OK | PH_NO_CONVERGENCE | PH_NO_MEMORY
 */
enum ph_status ph_tc_plan_curve(const struct ph_tc_target *target,
                                const double *u, size_t n, double tolerance,
                                struct ph_tc_plan *plan, struct ph_diag *diag);

/*
 * ph_tc_plan_even: replaces the parts from `first` on, all of one cubic or
 * without choice, by fewer of them with distances that are even, where it
 * finds them.
 */
enum ph_status ph_tc_plan_even(const struct ph_tc_target *target, size_t first,
                               double tolerance, struct ph_tc_plan *plan,
                               struct ph_diag *diag);

#endif
