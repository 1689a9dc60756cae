/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Parts of a curve for its cubics (see tc_approx_plan.h).
 *
 * A part that no one or two cubics are near enough to is cut at the inflection
 * next to its middle: cubics have none.  A part without inflections is halved
 * until it is near everywhere, which ph_tc_plan_even then improves.
 *
 * All rules are the same for the curve backward.
 */
#include "solve/tc/approx_plan.h"

#include <math.h>

/* So often is a part halved; and so many parts have room at first. */
enum { DEPTH = 48, PARTS = 64 };

/* Cuts beside a middle where the curve stands still, as a part of the part. */
static const double BESIDE = 0.0625;

struct cover {
  const struct ph_tc_target *target;
  const double *u; /* inflections */
  double tolerance;
  struct ph_tc_plan *plan;
  struct ph_diag *diag;
};

enum ph_status ph_tc_plan_add(struct ph_tc_plan *plan,
                              const struct ph_tc_part *part,
                              struct ph_diag *diag) {
  struct ph_tc_part *grown;
  if (plan->n == plan->limit) {
    return ph_fail(diag, PH_NO_CONVERGENCE, NULL,
                   "would need more than %zu cubics", plan->limit);
  }
  grown = ph_arena_grow(plan->arena, plan->part, plan->n, sizeof *grown, PARTS,
                        &plan->room);
  if (!grown) {
    return ph_fail_memory(diag);
  }
  plan->part = grown;
  plan->part[plan->n++] = *part;
  plan->cubics += part->n;
  return PH_OK;
}

/* Adds the part if its cubics are near enough. */
static enum ph_status add_if_near(struct cover *c,
                                  const struct ph_tc_knot *from,
                                  const struct ph_tc_knot *to,
                                  enum ph_tc_kind kind, bool *near,
                                  double *distance) {
  struct ph_tc_patch patch =
      ph_tc_patch_of(c->target, from, to, kind, c->tolerance);
  struct ph_tc_part part = {.from = from->u,
                            .to = to->u,
                            .distance = patch.distance,
                            .kind = kind,
                            .n = (unsigned)patch.n};
  *near = patch.distance <= c->tolerance;
  *distance = patch.distance;
  return *near ? ph_tc_plan_add(c->plan, &part, c->diag) : PH_OK;
}

static enum ph_status bisect(struct cover *c, const struct ph_tc_knot *from,
                             const struct ph_tc_knot *to, int depth) {
  const struct ph_tc_target *t = c->target;
  double middle = (from->u + to->u) / 2, distance;
  double beside = BESIDE * (to->u - from->u);
  struct ph_tc_knot knot = ph_tc_knot_at(t, middle), other;
  bool near;
  enum ph_status status = add_if_near(c, from, to, PH_TC_ONE, &near, &distance);
  if (status != PH_OK || near) {
    return status;
  }
  if (depth == DEPTH) {
    return ph_fail(c->diag, PH_NO_CONVERGENCE, NULL,
                   "has no cubics within the tolerance near its parameter "
                   "%.6g: try a larger one",
                   middle);
  }
  if (ph_cplx_norm2(knot.tangent) > 0) {
    status = bisect(c, from, &knot, depth + 1);
    return status == PH_OK ? bisect(c, &knot, to, depth + 1) : status;
  }
  /* A curve that stands still in the middle is cut on both sides; not so if
   * both are at the same place. */
  knot = ph_tc_knot_at(t, middle - beside);
  other = ph_tc_knot_at(t, middle + beside);
  status = bisect(c, from, &knot, depth + 1);
  if (ph_cplx_abs(ph_cplx_sub(knot.p, other.p)) >
      ph_tc_shortest(t, c->tolerance)) {
    status = status == PH_OK ? bisect(c, &knot, &other, depth + 1) : status;
    knot = other;
  }
  return status == PH_OK ? bisect(c, &knot, to, depth + 1) : status;
}

/* The inflection of u[n] next to the middle of a part, or the middle if two are
 * equally near. */
static double cut_of(const double *u, size_t n, double from, double to) {
  double middle = (from + to) / 2, best = (double)INFINITY, at = middle;
  for (size_t i = 0; i < n; i++) {
    double d = fabs(u[i] - middle);
    if (d < best) {
      at = fabs(d - best) <= 0x1p-29 ? middle : u[i];
      best = d;
    } else if (d - best <= 0x1p-29) {
      at = middle;
    }
  }
  return at;
}

static enum ph_status cover(struct cover *c, const struct ph_tc_knot *from,
                            const struct ph_tc_knot *to, size_t low,
                            size_t high) {
  size_t first = c->plan->n, left = low, right;
  struct ph_tc_knot cut;
  double distance;
  bool near;
  enum ph_status status =
      add_if_near(c, from, to, PH_TC_ONE_OR_PAIR, &near, &distance);
  if (status != PH_OK || near) {
    return status;
  }
  cut =
      ph_tc_knot_at(c->target, cut_of(c->u + low, high - low, from->u, to->u));
  if (low == high || !(ph_cplx_norm2(cut.tangent) > 0)) {
    status = bisect(c, from, to, 0);
    return status == PH_OK ? ph_tc_plan_even(c->target, first, c->tolerance,
                                             c->plan, c->diag)
                           : status;
  }
  while (left < high && c->u[left] < cut.u) {
    left++;
  }
  right = left < high && c->u[left] <= cut.u ? left + 1 : left;
  status = cover(c, from, &cut, low, left);
  return status == PH_OK ? cover(c, &cut, to, right, high) : status;
}

enum ph_status ph_tc_plan_curve(const struct ph_tc_target *target,
                                const double *u, size_t n, double tolerance,
                                struct ph_tc_plan *plan, struct ph_diag *diag) {
  struct cover c = {.target = target,
                    .u = u,
                    .tolerance = tolerance,
                    .plan = plan,
                    .diag = diag};
  struct ph_tc_knot from = ph_tc_knot_at(target, 0);
  struct ph_tc_knot to = ph_tc_knot_at(target, 1);
  if (!(tolerance > target->noise)) {
    return ph_fail(diag, PH_NO_CONVERGENCE, NULL,
                   "is not known to the tolerance: rounding alone may be up "
                   "to %.2g of its coordinates",
                   target->noise / target->size);
  }
  return cover(&c, &from, &to, 0, n);
}
