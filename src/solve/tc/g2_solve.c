/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The tangents of curvature-continuous splines (see g2.h): Newton's method and
 * continuation, for the equations of g2_system.h.
 */
#include "solve/tc/g2_system.h"

#include <float.h>
#include <math.h>
#include <string.h>

/* Residuals of no more are none; those that do not fall any more, or by less
 * than Newton's method makes them fall near a solution, are rounding below
 * this, or so many times what rounding of the angles makes of them, if the step
 * is as small as this. */
static const double DONE = 4e-13, ROUNDING = 1e-8, ANGLES = 8, TINY_STEP = 1e-5;
static const double FALLS = 0.5;

/* No unknown changes by more in a step. */
static const double STEP_MAX = 4;

/* Part of a residual that a step must remove, times its length. */
static const double ARMIJO = 1e-4;

enum { NEWTON_MAX = 60, CONTINUED_MAX = 25, HALVINGS_MAX = 24 };

/*
 * Chains of more nodes are solved in blocks if Newton's method fails without
 * halvings: one knot that is hard must not slow down, or fail, the others. What
 * is BESIDE nodes away changes a tangent by less than 1e-5 of itself, and
 * Newton's method for all goes on from there.
 */
enum { LONG = 1024, BLOCK = 128, BESIDE = 24, BLOCKS_SHARED = 8 };
enum { WIDE = BESIDE + BLOCK + BESIDE };

/* Where Newton's method stops for all, nodes are hard whose residuals are this
 * part of the largest. */
static const double HARD = 0.1;

/* Continuation: its first step, and where it gives up. */
static const double FIRST_STEP = 0.1, LAST_STEP = 1e-3;
enum { CONTINUATIONS_MAX = 500 };

/* ---- Newton's method ------------------------------------------------------
 */

/* The step of Newton's method.  ret its largest element, or not finite */
static double newton_step(struct ph_g2_system *s) {
  const size_t n = s->chain->nodes_n;
  struct ph_tri_row row;
  double largest = 0, sum = 0;
  ph_tri_begin(&s->tri, n, ph_g2_system_row(s, 0), ph_g2_system_row(s, n - 1));
  for (size_t k = 1; k + 1 < n; k++) {
    row = ph_g2_system_row(s, k);
    ph_tri_push(&s->tri, &row);
  }
  ph_tri_finish_here(&s->tri);
  for (size_t k = 0; k < n; k++) {
    const double x = ph_g2_system_step(s, k);
    largest = fmax(largest, fabs(x));
    sum += x - x;
  }
  return largest + sum;
}

static void swap_unknowns(struct ph_g2_system *s) {
  double *swap = s->now.y;
  s->now.y = s->last;
  s->last = swap;
}

/* Goes along the step until the residual falls; where it does not, what is
 * evaluated is the iterate that there was. */
static bool descend(struct ph_g2_system *s, double largest, size_t halvings) {
  const double before = sqrt(s->now.norm2);
  double part = fmin(1, STEP_MAX / largest);
  swap_unknowns(s);
  for (size_t halving = 0; halving <= halvings; halving++, part /= 2) {
    for (size_t k = 0; k < s->chain->nodes_n; k++) {
      s->now.y[k] = s->last[k] + part * ph_g2_system_step(s, k);
    }
    if (ph_g2_system_evaluate(s) &&
        sqrt(s->now.norm2) <= (1 - ARMIJO * part) * before) {
      return true;
    }
  }
  swap_unknowns(s);
  (void)ph_g2_system_evaluate(s);
  return false;
}

/* What rounding makes of the angles at node k: one is the turn less the other.
 */
static double angle_error(const struct ph_g2_state *at, size_t k) {
  return DBL_EPSILON * (fabs(at->before[k]) + fabs(at->after[k]));
}

/* Whether all residuals are rounding: of a bend on a short chord, with angles
 * of 1e-9 beside one of 1, they cannot be less than 1e-7. */
static bool is_rounding(const struct ph_g2_system *s) {
  const struct ph_g2_chain *c = s->chain;
  const struct ph_g2_state *at = &s->now;
  for (size_t k = 0; k < c->nodes_n; k++) {
    const size_t l = ph_g2_before(c, k), next = ph_g2_next(c, k);
    double most = ROUNDING;
    if (s->kind[k] == PH_G2_KNOWN) {
      continue;
    }
    most =
        fmax(most, ANGLES * ((fabs(at->ends[l].g_b) + fabs(at->ends[k].f_a)) *
                                 angle_error(at, k) +
                             fabs(at->ends[l].g_a) * angle_error(at, l) +
                             fabs(at->ends[k].f_b) * angle_error(at, next)));
    if (!(fabs(ph_g2_system_residual(s, k)) < most)) {
      return false;
    }
  }
  return true;
}

/* From s->now.y.  ret whether s->now is a solution */
static bool newton(struct ph_g2_system *s, size_t most, size_t halvings,
                   const struct ph_arena *arena) {
  if (!ph_g2_system_evaluate(s)) {
    return false;
  }
  for (size_t i = 0; i < most && !ph_arena_late(arena); i++) {
    const double before = s->now.norm2;
    double largest;
    bool fell;
    if (s->now.largest < DONE) {
      return true;
    }
    s->iterations++;
    largest = newton_step(s);
    if (!isfinite(largest)) {
      return false;
    }
    fell = descend(s, largest, halvings);
    if (!(fell && s->now.norm2 < FALLS * FALLS * before) &&
        largest < TINY_STEP && is_rounding(s)) {
      return true;
    }
    if (!fell) {
      return false;
    }
  }
  return s->now.largest < DONE;
}

/* ---- continuation ---------------------------------------------------------
 */

/* Unknowns for another h, by the same parts of the turns. */
static void shift(struct ph_g2_system *s, const double *y, double from,
                  double to) {
  for (size_t k = 0; k < s->chain->nodes_n; k++) {
    bool is_log = s->kind[k] == PH_G2_OF_BEFORE || s->kind[k] == PH_G2_OF_AFTER;
    s->now.y[k] = is_log                              ? y[k] + log(to / from)
                  : s->kind[k] == PH_G2_BETWEEN_BENDS ? y[k] * (to / from)
                                                      : y[k];
  }
}

/* From nearly straight data; y[nodes] is memory for the last solution. */
static bool continued(struct ph_g2_system *s, double *y,
                      const struct ph_arena *arena) {
  const size_t size = s->chain->nodes_n * sizeof *y;
  double from = 1, reached = 0, step = FIRST_STEP;
  ph_g2_system_start(s, true);
  memcpy(y, s->now.y, size);
  for (size_t i = 0; i < CONTINUATIONS_MAX && reached < 1; i++) {
    s->h = fmin(1, reached + step);
    shift(s, y, from, s->h);
    if (newton(s, CONTINUED_MAX, HALVINGS_MAX, arena)) {
      memcpy(y, s->now.y, size);
      from = reached = s->h;
      step *= 1.5;
    } else {
      step /= 2;
      if (step < LAST_STEP || ph_arena_late(arena)) {
        break;
      }
    }
  }
  s->h = 1;
  return reached >= 1;
}

/* ---- all ------------------------------------------------------------------
 */

/* Beside the angles. */
static bool alloc_state(struct ph_g2_state *at, const struct ph_g2_chain *c,
                        struct ph_arena *arena) {
  double *v = ph_arena_array(arena, c->nodes_n, 2 * sizeof *v);
  at->ends = ph_arena_array(arena, c->n, sizeof *at->ends);
  at->sum = ph_arena_array(arena, c->nodes_n / PH_G2_PART + 1, sizeof *at->sum);
  if (!v || !at->ends || !at->sum) {
    return false;
  }
  at->y = v;
  at->rate = v + c->nodes_n;
  return true;
}

static bool alloc_angles(struct ph_g2_state *at, const struct ph_g2_chain *c,
                         struct ph_arena *arena) {
  at->before = ph_arena_array(arena, c->nodes_n, sizeof *at->before);
  at->after = ph_arena_array(arena, c->nodes_n, sizeof *at->after);
  return at->before && at->after;
}

static bool alloc_system(struct ph_g2_system *s, struct ph_arena *arena) {
  const struct ph_g2_chain *c = s->chain;
  const size_t nodes = c->nodes_n;
  s->last = ph_arena_array(arena, nodes, sizeof *s->last);
  s->log_length = ph_arena_array(arena, c->n, sizeof *s->log_length);
  s->kind = ph_arena_array(arena, nodes, sizeof *s->kind);
  return s->last && s->log_length && s->kind &&
         alloc_state(&s->now, c, arena) && ph_tri_alloc(&s->tri, arena, nodes);
}

static bool any_unknown(const struct ph_g2_system *s) {
  for (size_t k = 0; k < s->chain->nodes_n; k++) {
    if (s->kind[k] != PH_G2_KNOWN) {
      return true;
    }
  }
  return false;
}

/* By either start, or by continuation from the second, for which y[nodes] is
 * memory. */
static bool find(struct ph_g2_system *s, double *y,
                 const struct ph_arena *arena) {
  ph_g2_system_start(s, false);
  if (newton(s, NEWTON_MAX, HALVINGS_MAX, arena)) {
    return true;
  }
  ph_g2_system_start(s, true);
  return newton(s, NEWTON_MAX, HALVINGS_MAX, arena) || continued(s, y, arena);
}

/* ---- blocks ---------------------------------------------------------------
 */

struct block {
  bool found;
  size_t iterations;
};

/* What a thread has for one block after another. */
struct bench {
  struct ph_g2_chain part;
  struct ph_g2_system own;
  double *y;
};

struct blocks {
  struct ph_g2_system *s;
  struct block *block;
  struct bench *bench; /* by thread */
};

static bool alloc_bench(struct bench *b, struct ph_arena *arena) {
  struct ph_g2_chain *part = &b->part;
  *part = (struct ph_g2_chain){.n = WIDE - 1, .nodes_n = WIDE};
  b->own = (struct ph_g2_system){.chain = part};
  part->node = ph_arena_array(arena, WIDE, sizeof *part->node);
  part->span = ph_arena_array(arena, WIDE, sizeof *part->span);
  b->y = ph_arena_array(arena, WIDE, sizeof *b->y);
  return part->node && part->span && b->y &&
         alloc_angles(&b->own.now, part, arena) && alloc_system(&b->own, arena);
}

/* The unknowns of nodes first to first + n - 1, between tangents of s->now. */
static struct block solve_block(struct ph_g2_system *s, size_t first, size_t n,
                                struct bench *bench) {
  const struct ph_g2_chain *c = s->chain;
  const size_t nodes = c->nodes_n, end = first + n;
  const size_t before = c->closed || first > BESIDE ? BESIDE : first;
  const size_t after = c->closed || end + BESIDE < nodes ? BESIDE : nodes - end;
  struct ph_g2_system *own = &bench->own;
  bool found;
  own->arena = s->arena;
  own->h = 1;
  own->smooth[0] = own->smooth[1] = (double)NAN;
  own->iterations = 0;
  ph_g2_system_part(s, (first + nodes - before) % nodes, before + n + after - 1,
                    &bench->part);
  ph_g2_system_begin(own);
  found = find(own, bench->y, s->arena);
  if (found) {
    memcpy(s->now.y + first, own->now.y + before, n * sizeof *own->now.y);
  }
  return (struct block){found, own->iterations};
}

static bool solve_some_blocks(void *context, size_t thread, size_t first,
                              size_t end) {
  const struct blocks *b = context;
  const size_t nodes = b->s->chain->nodes_n;
  for (size_t i = first; i < end; i++) {
    const size_t from = i * BLOCK;
    if (ph_arena_late(b->s->arena)) {
      b->block[i] = (struct block){false, 0};
      continue;
    }
    b->block[i] =
        solve_block(b->s, from, nodes - from < BLOCK ? nodes - from : BLOCK,
                    &b->bench[thread]);
  }
  return true;
}

/* All blocks, by as many threads as there is memory for, or by one.
 * ret  false: there is none for one */
static bool solve_blocks(struct blocks *b, size_t n, struct ph_arena *arena) {
  const size_t taken = arena->taken;
  atomic_int *spare = arena->budget ? arena->budget->spare : NULL;
  struct bench bench[PH_TEAM_MAX];
  size_t threads, ready = 1;
  b->bench = bench;
  if (!alloc_bench(&bench[0], arena)) {
    return false;
  }
  const size_t size = arena->taken - taken;
  threads = ph_team_take(spare, n / BLOCKS_SHARED);
  while (ready < threads && size <= ph_arena_left(arena) &&
         alloc_bench(&bench[ready], arena)) {
    ready++;
  }
  for (; threads > ready; threads--) {
    ph_team_leave(spare);
  }
  ph_team_spread(spare, threads, n, 1, solve_some_blocks, b);
  return true;
}

/* Marks blocks without a solution, and counts iterations: the most of any.
 * ret  whether there are none */
static bool judge_blocks(struct ph_g2_system *s, const struct block *block,
                         size_t n) {
  const struct ph_g2_chain *c = s->chain;
  bool good = true;
  size_t most = 0;
  for (size_t i = 0; i < n; i++) {
    const size_t end = i + 1 < n ? (i + 1) * BLOCK : c->n;
    most = block[i].iterations > most ? block[i].iterations : most;
    if (!block[i].found) {
      ph_g2_mark(c, i * BLOCK, end < c->n ? end : c->n, PH_G2_HARD);
      good = false;
    }
  }
  s->iterations += most;
  return good;
}

/* Marks the spans beside residuals that are large. */
static void mark_residuals(const struct ph_g2_system *s) {
  const struct ph_g2_chain *c = s->chain;
  for (size_t k = 0; k < c->nodes_n; k++) {
    if (s->kind[k] != PH_G2_KNOWN &&
        !(fabs(ph_g2_system_residual(s, k)) < HARD * s->now.largest)) {
      const size_t before = ph_g2_before(c, k);
      ph_g2_mark(c, before, before + 1, PH_G2_HARD);
      ph_g2_mark(c, k, k + 1, PH_G2_HARD);
    }
  }
}

/* The same of a long chain, of which intervals are marked. */
static enum ph_status find_long(struct ph_g2_system *s,
                                struct ph_arena *arena) {
  const size_t n = (s->chain->nodes_n + BLOCK - 1) / BLOCK;
  struct blocks b = {.s = s};
  ph_g2_system_start(s, false);
  if (newton(s, NEWTON_MAX, 0, arena)) {
    return PH_OK;
  }
  b.block = ph_arena_array(arena, n, sizeof *b.block);
  if (!b.block) {
    return PH_E_NO_MEMORY;
  }
  ph_g2_system_start(s, false);
  (void)ph_g2_system_evaluate(s); /* the tangents between blocks */
  if (!solve_blocks(&b, n, arena)) {
    return PH_E_NO_MEMORY;
  }
  if (!judge_blocks(s, b.block, n)) {
    return PH_E_NO_CONVERGENCE;
  }
  if (!newton(s, NEWTON_MAX, HALVINGS_MAX, arena)) {
    mark_residuals(s);
    return PH_E_NO_CONVERGENCE;
  }
  return PH_OK;
}

static enum ph_status find_any(struct ph_g2_system *s, struct ph_arena *arena) {
  double *y;
  if (!any_unknown(s)) {
    return ph_g2_system_evaluate(s) ? PH_OK : PH_E_NO_CONVERGENCE;
  }
  if (s->chain->nodes_n > LONG) {
    return find_long(s, arena);
  }
  y = ph_arena_array(arena, s->chain->nodes_n, sizeof *y);
  if (!y) {
    return PH_E_NO_MEMORY;
  }
  if (!find(s, y, arena)) {
    ph_g2_mark(s->chain, 0, s->chain->n, PH_G2_HARD);
    return PH_E_NO_CONVERGENCE;
  }
  return PH_OK;
}

/* ---- ends -----------------------------------------------------------------
 */

/*
 * The angle at an end by which the curvature goes on as it does beside it, from
 * the solution with circles: of the first span b[0] times the ratio a[1]/b[1]
 * of the next one, between 1/2 and 2, to the power of the squared ratio of
 * their lengths, at most 1.  (Tested by tests/cli/tc-g2.t: a circle's arcs come
 * out more even.)
 */
static double smooth_angle(const struct ph_g2_chain *c,
                           const struct ph_g2_state *at, size_t end) {
  size_t inner = end == 0 ? 1 : c->n - 1;
  size_t first = end == 0 ? 0 : c->n - 1, second = end == 0 ? 1 : c->n - 2;
  double near = end == 0 ? at->before[inner] : at->after[inner];
  double far = end == 0 ? at->after[inner] : at->before[inner];
  double beyond = end == 0 ? at->before[2] : at->after[c->n - 2];
  double lengths = c->span[first].length / c->span[second].length;
  double power = fmin(1, lengths * lengths);
  return near * pow(fmax(0.5, fmin(far / beyond, 2)), power);
}

/* Once more, with ends that go on smoothly. */
static bool smooth_ends(struct ph_g2_system *s, const struct ph_arena *arena) {
  const struct ph_g2_chain *c = s->chain;
  double smooth[2] = {(double)NAN, (double)NAN};
  for (size_t end = 0; !c->closed && c->n >= 3 && end < 2; end++) {
    size_t first = end == 0 ? 0 : c->n - 1, second = end == 0 ? 1 : c->n - 2;
    if (!c->given[end] && c->span[first].form == PH_G2_ARC &&
        c->span[second].form == PH_G2_ARC) {
      smooth[end] = smooth_angle(c, &s->now, end);
    }
  }
  memcpy(s->smooth, smooth, sizeof smooth);
  return (isnan(smooth[0]) && isnan(smooth[1])) ||
         newton(s, NEWTON_MAX, HALVINGS_MAX, arena);
}

/* The angles of the state become those of the spans, where they stand. */
static void take_angles(const struct ph_g2_chain *c,
                        const struct ph_g2_state *at,
                        struct ph_g2_solution *solution) {
  const double first = at->before[0];
  solution->a = at->after;
  solution->b = at->before;
  for (size_t i = 0; i < c->n; i++) {
    const size_t next = ph_g2_next(c, i);
    solution->b[i] = next > 0 ? at->before[next] : first;
  }
}

/* The angles of the chain, from the system of its turns. */
static enum ph_status solve_system(struct ph_g2_system *s, enum ph_g2_rule rule,
                                   struct ph_arena *arena,
                                   struct ph_g2_solution *solution,
                                   struct ph_diag *diag) {
  const struct ph_g2_chain *chain = s->chain;
  enum ph_status status;
  ph_g2_system_begin(s);
  status = find_any(s, arena);
  if (status == PH_E_NO_MEMORY) {
    return ph_fail_memory(diag);
  }
  if (status != PH_OK) {
    return ph_fail(diag, PH_E_NO_CONVERGENCE, "points",
                   "have no curve that was found, by Newton's method and by "
                   "continuation in the turns");
  }
  if (rule == PH_G2_SMOOTH && !smooth_ends(s, arena)) {
    ph_g2_mark(chain, 0, chain->n, PH_G2_HARD);
    return ph_fail(diag, PH_E_NO_CONVERGENCE, "ends",
                   "is smooth, for which no curve was found");
  }
  take_angles(chain, &s->now, solution);
  solution->iterations = s->iterations;
  solution->residual = s->now.largest;
  return PH_OK;
}

enum ph_status ph_g2_solve(const struct ph_g2_chain *chain,
                           enum ph_g2_rule rule, struct ph_arena *arena,
                           struct ph_g2_solution *solution,
                           struct ph_diag *diag) {
  struct ph_g2_system s = {.chain = chain,
                           .arena = arena,
                           .h = 1,
                           .smooth = {(double)NAN, (double)NAN}};
  struct ph_mark mark;
  enum ph_status status;
  if (!alloc_angles(&s.now, chain, arena)) {
    return ph_fail_memory(diag);
  }
  mark = ph_arena_mark(arena);
  status = alloc_system(&s, arena)
               ? solve_system(&s, rule, arena, solution, diag)
               : ph_fail_memory(diag);
  ph_arena_release(arena, mark);
  return status;
}
