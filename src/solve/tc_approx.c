/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Approximation of Bezier curves by Tschirnhausen cubics (see tc_approx.h). */
#include "solve/tc_approx.h"

#include "solve/tc_approx_part.h"
#include "solve/tc_approx_plan.h"

#include <math.h>
#include <string.h>

/* At most so many parts. */
enum { LIMIT = 1000000 };

/* A curve of a chain, ready to be approximated. */
struct item {
  struct ph_tc_target target;
  double *u; /* inflections */
  size_t n;
};

static enum ph_status item_of(const struct ph_tc_bezier *curve,
                              struct ph_arena *scratch, struct item *item,
                              struct ph_diag *diag) {
  enum ph_status status;
  if (curve->degree < 1 || curve->degree > PH_TC_DEGREE_MAX) {
    return ph_fail(diag, PH_NO_CONVERGENCE, NULL,
                   "has degree %zu; 1 to %d are allowed", curve->degree,
                   PH_TC_DEGREE_MAX);
  }
  item->u = ph_arena_array(scratch, 2 * curve->degree, sizeof *item->u);
  if (!item->u) {
    return ph_fail_memory(diag);
  }
  status = ph_tc_target_of(curve, scratch, &item->target, diag);
  return status == PH_OK
             ? ph_tc_inflections(curve, scratch, item->u, &item->n, diag)
             : status;
}

/* ---- the cubics of a plan ----------------------------------------------- */

static enum ph_status add_arc(struct ph_tc_arcs *arcs,
                              const struct ph_tc_arc *arc,
                              struct ph_diag *diag) {
  if (arcs->n == arcs->room) {
    size_t room = arcs->room > 0 ? 2 * arcs->room : 16;
    struct ph_tc_arc *grown = ph_arena_array(arcs->arena, room, sizeof *grown);
    if (!grown) {
      return ph_fail_memory(diag);
    }
    if (arcs->n > 0) {
      memcpy(grown, arcs->arc, arcs->n * sizeof *grown);
    }
    arcs->arc = grown;
    arcs->room = room;
  }
  arcs->arc[arcs->n++] = *arc;
  return PH_OK;
}

static enum ph_status add_patch(struct ph_tc_arcs *arcs,
                                const struct ph_tc_patch *patch,
                                const struct ph_tc_knot *from,
                                const struct ph_tc_knot *to,
                                struct ph_diag *diag) {
  struct ph_tc_arc arc = {from->u, to->u, from->p, to->p, patch->tc[0]};
  enum ph_status status;
  if (patch->n == 2) {
    arc.to = patch->at;
    arc.end = patch->joint;
    status = add_arc(arcs, &arc, diag);
    if (status != PH_OK) {
      return status;
    }
    arc =
        (struct ph_tc_arc){patch->at, to->u, patch->joint, to->p, patch->tc[1]};
  }
  if (patch->distance > arcs->distance) {
    arcs->distance = patch->distance;
  }
  return add_arc(arcs, &arc, diag);
}

static enum ph_status add_plan(const struct item *item,
                               const struct ph_tc_plan *plan, double tolerance,
                               struct ph_tc_arcs *arcs, struct ph_diag *diag) {
  struct ph_tc_knot from = ph_tc_knot_at(&item->target, 0), to;
  enum ph_status status = PH_OK;
  for (size_t i = 0; status == PH_OK && i < plan->n; i++) {
    const struct ph_tc_part *part = &plan->part[i];
    struct ph_tc_patch patch;
    to = ph_tc_knot_at(&item->target, part->to);
    patch = ph_tc_patch_of(&item->target, &from, &to, part->kind, tolerance);
    status = add_patch(arcs, &patch, &from, &to, diag);
    from = to;
  }
  return status;
}

/* ---- to a tolerance ----------------------------------------------------- */

enum ph_status ph_tc_approximate(const struct ph_tc_bezier *curve,
                                 double tolerance, struct ph_tc_arcs *arcs,
                                 struct ph_diag *diag) {
  struct ph_arena scratch = {NULL};
  struct ph_tc_plan plan = {&scratch, NULL, 0, 0, 0, LIMIT};
  struct item item;
  enum ph_status status = item_of(curve, &scratch, &item, diag);
  if (status == PH_OK) {
    status =
        ph_tc_plan_curve(&item.target, item.u, item.n, tolerance, &plan, diag);
  }
  if (status == PH_OK) {
    status = add_plan(&item, &plan, tolerance, arcs, diag);
  }
  ph_arena_free(&scratch);
  return status;
}
