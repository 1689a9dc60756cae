/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The curve of a chain (see g2.h).
 *
 * Cubics of the solution that turn by more than 2 pi/3 get a point at the apex
 * of their tangents, and the data are solved again: such cubics are long loops
 * beside which the curve could be much fairer.
 */
#include "solve/tc/g2.h"

#include "kernel/pi.h"

#include <string.h>

/* A cubic that turns by more gets a point; how often this is done: once or not
 * at all, but for a handful of data. */
static const double TURN = 2 * PH_PI / 3;
enum { LOOPS_MAX = 6 };

/* ---- solutions ----------------------------------------------------------- */

static bool is_loop(const struct ph_g2_chain *chain,
                    const struct ph_g2_solution *s, size_t i) {
  return chain->span[i].form == PH_G2_ARC && s->a[i] + s->b[i] > TURN;
}

/* Points over cubics that turn too much.  ret NULL when memory is exhausted */
static struct ph_g2_apex *loops_of(const struct ph_g2_chain *chain,
                                   const struct ph_g2_solution *s,
                                   struct ph_arena *arena, size_t *n) {
  struct ph_g2_apex *apex;
  size_t at = 0;
  *n = 0;
  for (size_t i = 0; i < chain->n; i++) {
    *n += is_loop(chain, s, i);
  }
  apex = ph_arena_array(arena, *n, sizeof *apex);
  for (size_t i = 0; apex && at < *n; i++) {
    if (is_loop(chain, s, i)) {
      apex[at++] = (struct ph_g2_apex){
          i, {s->a[i] / 2, s->b[i] / 2}, chain->span[i].sense};
    }
  }
  return apex;
}

/* A chain into other memory.  ret false: it is exhausted */
static bool move_chain(struct ph_g2_chain *chain, struct ph_arena *arena) {
  struct ph_g2_node *node = ph_arena_array(arena, chain->nodes_n, sizeof *node);
  struct ph_g2_span *span = ph_arena_array(arena, chain->n, sizeof *span);
  if (!node || !span) {
    return false;
  }
  memcpy(node, chain->node, chain->nodes_n * sizeof *node);
  memcpy(span, chain->span, chain->n * sizeof *span);
  chain->node = node;
  chain->span = span;
  return true;
}

/* What stands between the points of a chain, which is another one where some
 * are added; what it takes to find that is gone after it. */
static enum ph_status plan(struct ph_g2_chain *chain, bool may_add,
                           struct ph_arena *arena, struct ph_diag *diag) {
  const struct ph_g2_node *given = chain->node;
  struct ph_arena work = ph_arena_beside(arena);
  enum ph_status status = ph_g2_plan(chain, may_add, &work, diag);
  if (status == PH_OK && chain->node != given && !move_chain(chain, arena)) {
    status = ph_fail_memory(diag);
  }
  ph_arena_free(&work);
  return status;
}

/* A chain with its solution, in memory of its own. */
struct solved {
  struct ph_g2_chain chain;
  struct ph_g2_solution solution;
  struct ph_arena arena;
  struct ph_arena given; /* of the chain as it was before points were added */
};

static struct solved nothing(const struct ph_arena *arena) {
  return (struct solved){.arena = ph_arena_beside(arena),
                         .given = ph_arena_beside(arena)};
}

/* What stands between the points of a chain that is given, and the angles; with
 * more points where that fails. */
static enum ph_status plan_and_solve(struct solved *s, bool may_add,
                                     enum ph_g2_rule rule,
                                     struct ph_diag *diag) {
  const struct ph_g2_chain given = s->chain;
  enum ph_status status;
  ph_g2_mark(&s->chain, 0, s->chain.n, PH_G2_EASY);
  status = plan(&s->chain, may_add, &s->arena, diag);
  if (status == PH_OK) {
    status = ph_g2_solve(&s->chain, rule, &s->arena, &s->solution, diag);
  }
  if (status == PH_E_NO_CONVERGENCE && may_add && !ph_arena_late(&s->arena)) {
    s->chain = given;
    ph_arena_reset(&s->arena);
    status = plan(&s->chain, true, &s->arena, diag);
    if (status == PH_OK) {
      ph_g2_mark(&s->chain, 0, s->chain.n, PH_G2_EASY);
      status = ph_g2_solve(&s->chain, rule, &s->arena, &s->solution, diag);
    }
  }
  if (s->chain.node != given.node) {
    ph_arena_free(&s->given);
  }
  return status;
}

/* Into `next`, the solution with points over the cubics of `last` that turn too
 * much.  ret false: there are none, or (*status) memory is exhausted, or there
 * is no solution */
static bool lengthen(const struct solved *last, enum ph_g2_rule rule,
                     struct solved *next, enum ph_status *status,
                     struct ph_diag *diag) {
  struct ph_diag why;
  size_t n;
  struct ph_g2_apex *apex =
      loops_of(&last->chain, &last->solution, &next->given, &n);
  if (!apex) {
    *status = ph_fail_memory(diag);
    return false;
  }
  if (n == 0) {
    return false;
  }
  next->solution = (struct ph_g2_solution){.iterations = 0};
  *status = ph_g2_add(&last->chain, apex, n, &next->given, &next->chain, diag);
  if (*status != PH_OK) {
    return false;
  }
  const enum ph_status solved = plan_and_solve(next, true, rule, &why);
  if (solved == PH_E_NO_MEMORY) { /* not that there is none */
    *status = ph_fail_memory(diag);
  }
  if (solved != PH_OK) {
    return false;
  }
  next->solution.iterations += last->solution.iterations;
  return true;
}

/* What was found, into the caller's memory. */
static enum ph_status hand_over(const struct solved *found,
                                struct ph_arena *arena,
                                struct ph_g2_chain *chain,
                                struct ph_g2_solution *s,
                                struct ph_diag *diag) {
  const size_t n = found->chain.n;
  double *angles = ph_arena_array(arena, n, 2 * sizeof *angles);
  *chain = found->chain;
  if (!angles || !move_chain(chain, arena)) {
    return ph_fail_memory(diag);
  }
  memcpy(angles, found->solution.a, n * sizeof *angles);
  memcpy(angles + n, found->solution.b, n * sizeof *angles);
  *s = found->solution;
  s->a = angles;
  s->b = angles + n;
  return PH_OK;
}

static void forget(struct solved *s) {
  ph_arena_free(&s->arena);
  ph_arena_free(&s->given);
}

/* With points over cubics that turn too much, as long as there is a solution
 * with them.  Of all that is tried no more than two are in memory. */
enum ph_status ph_g2_find(size_t first, size_t n, const ph_cplx tangent[2],
                          bool may_add, enum ph_g2_rule rule,
                          struct ph_arena *arena, struct ph_g2_chain *chain,
                          struct ph_g2_solution *s, struct ph_diag *diag) {
  struct solved tried[2] = {nothing(arena), nothing(arena)};
  struct solved *last = &tried[0], *next = &tried[1];
  enum ph_status status =
      ph_g2_chain_of(first, n, tangent, &last->given, chain, diag);
  last->chain = *chain;
  if (status == PH_OK) {
    status = plan_and_solve(last, may_add, rule, diag);
  }
  for (size_t round = 0; status == PH_OK && may_add && round < LOOPS_MAX &&
                         lengthen(last, rule, next, &status, diag);
       round++) {
    struct solved *before = last;
    last = next;
    next = before;
    forget(next);
  }
  forget(next);
  if (status == PH_OK) {
    status = hand_over(last, arena, chain, s, diag);
  }
  forget(last);
  return status;
}
