/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Approximation of Bezier curves by Tschirnhausen cubics (see approx.h). */
#include "solve/tc/approx.h"

#include <math.h>
#include <string.h>

/* At most so many parts of one curve, as cubics may be asked for; and so many
 * cubics have room at first. */
enum { LIMIT = 1000000, ARCS = 16 };

/* So much of a tolerance is used: another bound of the same distance, as that
 * of the certificate, may be a little larger. */
static const double USED = 0.98;

/* A curve of a chain, ready to be approximated. */
struct item {
  struct ph_tc_target target;
  double *u; /* [n] inflections */
  size_t n;
};

/* What all curves of a chain are worked on with, one after another. */
struct room {
  ph_cplx *points;
  double *u; /* [2 * degree] */
};

static enum ph_status room_of(const struct ph_tc_bezier *curves, size_t n,
                              struct ph_arena *scratch, struct room *room,
                              struct ph_diag *diag) {
  size_t most = 0;
  for (size_t k = 0; k < n; k++) {
    size_t degree = curves[k].degree;
    if (degree < 1 || degree > PH_TC_DEGREE_MAX) {
      return ph_fail(diag, PH_E_NO_CONVERGENCE, NULL,
                     "has degree %zu; 1 to %d are allowed", degree,
                     PH_TC_DEGREE_MAX);
    }
    most = degree > most ? degree : most;
  }
  room->points =
      ph_arena_array(scratch, ph_tc_target_room(most), sizeof *room->points);
  room->u = ph_arena_array(scratch, 2 * most, sizeof *room->u);
  return room->points && room->u ? PH_OK : ph_fail_memory(diag);
}

static enum ph_status item_of(const struct ph_tc_bezier *curve,
                              const struct room *room, struct ph_arena *scratch,
                              struct item *item, struct ph_diag *diag) {
  enum ph_status status =
      ph_tc_inflections(curve, scratch, room->u, &item->n, diag);
  if (status != PH_OK) {
    return status;
  }
  item->target = ph_tc_target_of(curve, room->points);
  item->u = ph_arena_array(scratch, item->n, sizeof *item->u);
  if (!item->u) {
    return ph_fail_memory(diag);
  }
  memcpy(item->u, room->u, item->n * sizeof *item->u);
  return PH_OK;
}

/* ---- the cubics of a plan ----------------------------------------------- */

static enum ph_status add_arc(struct ph_tc_arcs *arcs,
                              const struct ph_tc_arc *arc,
                              struct ph_diag *diag) {
  arcs->arc = ph_arena_grow(arcs->arena, arcs->arc, arcs->n, sizeof *arcs->arc,
                            ARCS, &arcs->room);
  if (!arcs->arc) {
    return ph_fail_memory(diag);
  }
  arcs->arc[arcs->n++] = *arc;
  return PH_OK;
}

static enum ph_status add_patch(struct ph_tc_arcs *arcs,
                                const struct ph_tc_patch *patch,
                                const struct ph_tc_knot *from,
                                const struct ph_tc_knot *to,
                                struct ph_diag *diag) {
  struct ph_tc_arc arc = {.from = from->u,
                          .to = to->u,
                          .start = from->p,
                          .end = to->p,
                          .tc = patch->tc[0]};
  enum ph_status status;
  if (patch->n == 2) {
    arc.to = patch->at;
    arc.end = patch->joint;
    status = add_arc(arcs, &arc, diag);
    if (status != PH_OK) {
      return status;
    }
    arc = (struct ph_tc_arc){.from = patch->at,
                             .to = to->u,
                             .start = patch->joint,
                             .end = to->p,
                             .tc = patch->tc[1]};
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
  struct ph_arena scratch = ph_arena_beside(arcs->arena);
  struct ph_tc_plan plan = {.arena = &scratch, .limit = LIMIT};
  struct room room;
  struct item item;
  double used = USED * tolerance;
  enum ph_status status = room_of(curve, 1, &scratch, &room, diag);
  status =
      status == PH_OK ? item_of(curve, &room, &scratch, &item, diag) : status;
  if (status == PH_OK) {
    status = ph_tc_plan_curve(&item.target, item.u, item.n, used, &plan, diag);
  }
  if (status == PH_OK) {
    status = add_plan(&item, &plan, used, arcs, diag);
  }
  ph_arena_free(&scratch);
  return status;
}

/* ---- to a number of cubics ---------------------------------------------- */

/* Trials of a tolerance; how near to one that fails the best distance need not
 * come; and no less than so many times the noise is tried, which is part of a
 * distance.  Every other trial halves a logarithm of 30 at most, that of 1/eps:
 * 14 of those come as near. */
enum { TRIALS = 40 };
static const double CLOSE = 1.002, CLEAR = 64;

struct chain {
  struct ph_arena *arena;
  const struct item *items;
  size_t n;
  size_t pieces;
  double low;       /* a tolerance that fails */
  double tolerance; /* the best one that does not, */
  double distance;  /* the distance there, */
  size_t cubics;    /* and how many cubics */
};

/* What a tolerance gives; PH_E_NO_CONVERGENCE if too many cubics or none. */
static enum ph_status try_tolerance(struct chain *c, double tolerance,
                                    struct ph_diag *diag) {
  double distance = 0;
  size_t cubics = 0;
  for (size_t k = 0; k < c->n; k++) {
    const struct item *item = &c->items[k];
    struct ph_arena scratch = ph_arena_beside(c->arena);
    /* halving finds a few times as many parts as are needed in the end */
    struct ph_tc_plan plan = {.arena = &scratch, .limit = 8 * c->pieces + 64};
    enum ph_status status = ph_tc_plan_curve(&item->target, item->u, item->n,
                                             tolerance, &plan, diag);
    for (size_t i = 0; i < plan.n; i++) {
      double d = plan.part[i].distance;
      distance = d > distance ? d : distance;
    }
    cubics += plan.cubics;
    ph_arena_free(&scratch);
    if (status != PH_OK) {
      return status;
    }
  }
  c->cubics = cubics;
  if (cubics > c->pieces) {
    return ph_fail(diag, PH_E_NO_CONVERGENCE, NULL, "needs %zu cubics", cubics);
  }
  c->tolerance = tolerance;
  c->distance = distance;
  return PH_OK;
}

/*
 * The next tolerance to try: by the fourth power of the number of cubics in
 * turn with the middle of what is left, both of the logarithm.
 */
static double next_tolerance(const struct chain *c, size_t cubics, int trial) {
  double ratio = (double)cubics / ((double)c->pieces + 0.5);
  double guess = c->distance * ratio * ratio * ratio * ratio;
  double middle = sqrt(c->low * c->distance);
  return trial % 2 == 0 && guess > c->low * CLOSE && guess * CLOSE < c->distance
             ? guess
             : middle;
}

static enum ph_status search_tolerance(struct chain *c, struct ph_diag *diag) {
  struct ph_diag dropped;
  double size = 0;
  size_t cubics;
  enum ph_status status;
  for (size_t k = 0; k < c->n; k++) {
    size = fmax(c->items[k].target.size, size);
    c->low = fmax(CLEAR * c->items[k].target.noise, c->low);
  }
  c->cubics = 0;
  status = try_tolerance(c, 8 * size, diag); /* no cubics are that far */
  if (status == PH_E_NO_CONVERGENCE && c->cubics > c->pieces) {
    return ph_fail(diag, PH_E_BAD_VALUE, "pieces",
                   "is too few: the fewest cubics found are %zu", c->cubics);
  }
  cubics = c->cubics;
  for (int i = 0; status == PH_OK && i < TRIALS; i++) {
    double tolerance = next_tolerance(c, cubics, i);
    if (!(c->distance > CLOSE * c->low)) {
      break;
    }
    status = try_tolerance(c, tolerance, &dropped);
    if (status == PH_OK) {
      cubics = c->cubics;
    } else if (status == PH_E_NO_CONVERGENCE) {
      c->low = tolerance;
      status = PH_OK;
    } else {
      *diag = dropped;
    }
  }
  return status;
}

/* The cubics of all curves. */
static enum ph_status add_chain(const struct chain *c, struct ph_arena *scratch,
                                struct ph_tc_arcs *arcs, size_t *first,
                                struct ph_diag *diag) {
  enum ph_status status = PH_OK;
  for (size_t k = 0; status == PH_OK && k < c->n; k++) {
    const struct item *item = &c->items[k];
    struct ph_mark mark = ph_arena_mark(scratch);
    struct ph_tc_plan plan = {.arena = scratch, .limit = LIMIT};
    first[k] = arcs->n;
    status = ph_tc_plan_curve(&item->target, item->u, item->n, c->tolerance,
                              &plan, diag);
    if (status == PH_OK) {
      status = add_plan(item, &plan, c->tolerance, arcs, diag);
    }
    ph_arena_release(scratch, mark);
  }
  first[c->n] = arcs->n;
  return status;
}

enum ph_status ph_tc_approximate_pieces(const struct ph_tc_bezier *curves,
                                        size_t n, size_t pieces, double least,
                                        struct ph_tc_arcs *arcs, size_t *first,
                                        struct ph_diag *diag) {
  struct ph_arena scratch = ph_arena_beside(arcs->arena);
  struct item *items = ph_arena_array(&scratch, n, sizeof *items);
  struct chain c = {.arena = &scratch,
                    .items = items,
                    .n = n,
                    .pieces = pieces,
                    .low = least};
  struct room room;
  enum ph_status status =
      items ? room_of(curves, n, &scratch, &room, diag) : ph_fail_memory(diag);
  for (size_t k = 0; status == PH_OK && k < n; k++) {
    status = item_of(&curves[k], &room, &scratch, &items[k], diag);
  }
  status = status == PH_OK ? search_tolerance(&c, diag) : status;
  status =
      status == PH_OK ? add_chain(&c, &scratch, arcs, first, diag) : status;
  ph_arena_free(&scratch);
  return status;
}
