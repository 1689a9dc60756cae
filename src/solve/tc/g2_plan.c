/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Which spans there are, and where points are added (see g2.h). */
#include "solve/tc/g2.h"

#include "kernel/pi.h"

#include <float.h>
#include <math.h>
#include <string.h>

/* Turns of no more are none. */
static const double STRAIGHT = 1e-12;

/* So near to half a turn the data turn back. */
static const double REVERSAL = 1e-9;

/* Sums of two turns beyond which a point is added: in general, and where the
 * solution is proved to be the only one, 2 arccos((sqrt(33) - 1)/8) rounded
 * down. */
static const double TURNS = 7 * PH_PI / 6, TURNS_SAFE = 1.8718;

/* Of a turn that is too large for a bend: over the sum of two turns of an arc.
 * For TURNS it is a right angle, and a little more: right angles of data
 * are none. */
static const double OF_BEND = 3. / 7 * (1 + 1e-9);

/* Where a point is added in a bend, over the chord: of those tried between .1
 * and .35 the one whose zigzags of all angles bend least. */
static const double PART = 0.18;

/* Turns that are too large get a point where the angles that are to be expected
 * sum to this part of them or more, half of the part of even chords: a short
 * span between long ones turns little, and a point over it would make it turn
 * more.  Where they sum to the larger part, long spans turn too much. */
static const double EVEN = 0.25, UNEVEN = 0.75;

/* No apex has larger angles. */
static const double BASE_MAX = PH_PI / 4;

/* Rounds of adding points: each halves turns, or nearly so. */
enum { ROUNDS_MAX = 12 };

/* ---- chains -------------------------------------------------------------- */

static bool alloc(struct ph_g2_chain *chain, size_t n, struct ph_arena *arena) {
  chain->n = n;
  chain->nodes_n = chain->closed ? n : n + 1;
  chain->node = ph_arena_array(arena, chain->nodes_n, sizeof *chain->node);
  chain->span = ph_arena_array(arena, n, sizeof *chain->span);
  return chain->node && chain->span;
}

/* From one direction to another, in (-pi, pi]. */
static double angle_between(ph_cplx from, ph_cplx to) {
  return atan2(ph_cplx_cross(from, to), ph_cplx_dot(from, to));
}

static double coordinate(ph_cplx p) {
  return fmax(fabs(p.re), fabs(p.im));
}

/* By this angle rounding of coordinates may turn span i. */
static double off(const struct ph_g2_chain *chain, size_t i) {
  const struct ph_g2_node *a = &chain->node[i];
  const struct ph_g2_node *b = &chain->node[ph_g2_next(chain, i)];
  return DBL_EPSILON * (coordinate(a->p) + coordinate(b->p)) /
         chain->span[i].length;
}

/* Whether the turn at a node is none, or no more than coordinates are rounded
 * by. */
static bool is_straight(const struct ph_g2_chain *chain, size_t k) {
  const struct ph_g2_node *node = &chain->node[k];
  const double before =
      node->inner || k > 0 ? off(chain, ph_g2_before(chain, k)) : 0;
  const double after = k < chain->n ? off(chain, k) : 0;
  return !(fabs(node->turn) > fmax(STRAIGHT, before + after));
}

static bool set_chords(void *context, size_t thread, size_t first, size_t end) {
  const struct ph_g2_chain *chain = context;
  (void)thread;
  for (size_t i = first; i < end; i++) {
    const struct ph_g2_node *a = &chain->node[i];
    const struct ph_g2_node *b = &chain->node[ph_g2_next(chain, i)];
    struct ph_g2_span *s = &chain->span[i];
    s->chord = ph_cplx_sub(b->p, a->p);
    s->length = hypot(s->chord.re, s->chord.im);
  }
  return true;
}

static bool set_turns(void *context, size_t thread, size_t first, size_t end) {
  const struct ph_g2_chain *chain = context;
  (void)thread;
  for (size_t k = first; k < end; k++) {
    struct ph_g2_node *node = &chain->node[k];
    node->inner = chain->closed || (k > 0 && k + 1 < chain->nodes_n);
    node->turn = 0;
    if (node->inner) {
      node->turn = angle_between(chain->span[ph_g2_before(chain, k)].chord,
                                 chain->span[k].chord);
    } else if (chain->given[k > 0]) {
      node->turn =
          k > 0 ? angle_between(chain->span[k - 1].chord, chain->tangent[1])
                : angle_between(chain->tangent[0], chain->span[0].chord);
    }
    node->sign = (signed char)(is_straight(chain, k) ? 0
                               : node->turn > 0      ? 1
                                                     : -1);
  }
  return true;
}

/* Chords and turns, from the points; a long chain by the threads that the arena
 * knows of. */
static void measure(struct ph_g2_chain *chain, const struct ph_arena *arena) {
  ph_g2_share(arena, chain->n, set_chords, chain);
  ph_g2_share(arena, chain->nodes_n, set_turns, chain);
}

enum ph_status ph_g2_chain_of(size_t first, size_t n, const ph_cplx tangent[2],
                              struct ph_arena *arena, struct ph_g2_chain *chain,
                              struct ph_diag *diag) {
  const struct ph_tc_data *data = chain->data;
  chain->closed = data->closed && n == data->n && !tangent;
  if (!alloc(chain, n, arena)) {
    return ph_fail_memory(diag);
  }
  for (size_t end = 0; !chain->closed && end < 2; end++) {
    chain->tangent[end] = tangent[end];
    chain->given[end] = !isnan(tangent[end].re);
  }
  for (size_t k = 0; k < chain->nodes_n; k++) {
    const size_t datum = data->closed ? (first + k) % data->n : first + k;
    ph_cplx p = ph_tc_point(data, datum);
    chain->node[k] =
        (struct ph_g2_node){.p = {ph_pow2_apply(data->to_unit, p.re),
                                  ph_pow2_apply(data->to_unit, p.im)},
                            .datum = datum};
  }
  measure(chain, arena);
  return PH_OK;
}

/* The apex of a triangle over a span. */
static ph_cplx apex_of(const struct ph_g2_chain *chain,
                       const struct ph_g2_apex *apex) {
  double far = sin(apex->base[1]) / sin(apex->base[0] + apex->base[1]);
  ph_cplx side = ph_cplx_polar(-apex->sense * apex->base[0]);
  return ph_cplx_add(
      chain->node[apex->span].p,
      ph_cplx_mul(ph_cplx_scale(far, side), chain->span[apex->span].chord));
}

enum ph_status ph_g2_add(const struct ph_g2_chain *chain,
                         const struct ph_g2_apex *apex, size_t n,
                         struct ph_arena *arena, struct ph_g2_chain *grown,
                         struct ph_diag *diag) {
  size_t to = 0, next = 0;
  struct ph_g2_chain longer = *chain;
  if (!alloc(&longer, chain->n + n, arena)) {
    return ph_fail_memory(diag);
  }
  for (size_t k = 0; k < chain->nodes_n; k++) {
    longer.node[to++] = chain->node[k];
    for (; next < n && apex[next].span == k; next++) {
      longer.node[to++] = (struct ph_g2_node){.p = apex_of(chain, &apex[next]),
                                              .datum = PH_G2_ADDED};
    }
  }
  *grown = longer;
  measure(grown, arena);
  return PH_OK;
}

/* ---- turns that are too large -------------------------------------------- */

/*
 * The angle between the tangent at an end of span i and its chord that is to be
 * expected, in the sense of the turn: of the turn the part that the span has of
 * the lengths of both beside it, as small turns of a circle have it.  At an end
 * of open data it is all of the angle.
 */
static double expected(const struct ph_g2_chain *chain, size_t i, size_t end) {
  size_t k = end == 0 ? i : ph_g2_next(chain, i);
  const struct ph_g2_node *node = &chain->node[k];
  double here = chain->span[i].length, other;
  if (!node->inner) {
    return fabs(node->turn);
  }
  other = chain->span[end == 0 ? ph_g2_before(chain, k) : k].length;
  return fabs(node->turn) * (here / (here + other));
}

/* Whether a span is a bend for this end of it: the other end turns to the other
 * side, or not at all where a given tangent leaves the line. */
static bool is_bend_for(const struct ph_g2_node *node,
                        const struct ph_g2_node *other) {
  return node->sign * other->sign < 0 || (!node->inner && other->sign == 0);
}

/* Whether an angle, of a span of which turns sum to `turn`, is too large. */
static bool is_too_large(double turn, double angle, double most) {
  return (turn > most && angle > EVEN * most) || angle > UNEVEN * most;
}

/*
 * What must be added over a span; in a bend beside the end that turns too much,
 * outside of the turn.
 *
 * ret  how many: 0, 1 or 2
 */
static size_t wanted_over(const struct ph_g2_chain *chain, size_t i,
                          double most, struct ph_g2_apex apex[2]) {
  const struct ph_g2_node *node[2] = {&chain->node[i],
                                      &chain->node[ph_g2_next(chain, i)]};
  double turn[2], angle[2], base[2];
  size_t n = 0;
  for (size_t end = 0; end < 2; end++) {
    turn[end] = fabs(node[end]->turn);
    angle[end] = expected(chain, i, end);
    base[end] = fmin(angle[end] / 2, BASE_MAX);
  }
  if (node[0]->sign * node[1]->sign > 0 &&
      is_too_large(turn[0] + turn[1], angle[0] + angle[1], most)) {
    apex[n++] = (struct ph_g2_apex){i, {base[0], base[1]}, node[0]->sign};
  }
  /* the apex over a part of the chord: its height there by the angle at the
   * near end */
  for (size_t end = 0; end < 2; end++) {
    if (is_too_large(turn[end], angle[end], OF_BEND * most) &&
        is_bend_for(node[end], node[1 - end])) {
      double far = atan(tan(base[end]) * PART / (1 - PART));
      apex[n++] = (struct ph_g2_apex){
          i,
          {end == 0 ? base[0] : far, end == 0 ? far : base[1]},
          node[end]->sign};
    }
  }
  return n;
}

/* How many must be added in all; writes them where there is room. */
static size_t want_all(const struct ph_g2_chain *chain,
                       struct ph_g2_apex *apex) {
  size_t total = 0, interval = 0;
  for (size_t i = 0; i < chain->n; i++) {
    struct ph_g2_apex two[2];
    size_t here;
    if (chain->node[i].datum != PH_G2_ADDED) {
      interval = chain->node[i].datum;
    }
    here =
        wanted_over(chain, i, chain->hard[interval] ? TURNS_SAFE : TURNS, two);
    if (apex) {
      memcpy(apex + total, two, here * sizeof *apex);
    }
    total += here;
  }
  return total;
}

/* All of them.  ret NULL when memory is exhausted */
static struct ph_g2_apex *wanted(const struct ph_g2_chain *chain,
                                 struct ph_arena *arena, size_t *n) {
  struct ph_g2_apex *apex;
  *n = want_all(chain, NULL);
  apex = ph_arena_array(arena, *n, sizeof *apex);
  if (apex) {
    want_all(chain, apex);
  }
  return apex;
}

void ph_g2_mark(const struct ph_g2_chain *chain, size_t first, size_t end,
                enum ph_g2_hard hard) {
  size_t at = first;
  while (chain->node[at].datum == PH_G2_ADDED) {
    at--; /* the first is one of the data */
  }
  for (size_t i = at; i < end; i++) {
    if (chain->node[i].datum != PH_G2_ADDED) {
      chain->hard[chain->node[i].datum] = (unsigned char)hard;
    }
  }
}

/* Both intervals beside an inner node have no curve. */
static void mark_stuck(const struct ph_g2_chain *chain, size_t k) {
  const size_t before = ph_g2_before(chain, k);
  ph_g2_mark(chain, before, before + 1, PH_G2_STUCK);
  ph_g2_mark(chain, k, k + 1, PH_G2_STUCK);
}

static enum ph_status check_reversal(const struct ph_g2_chain *chain,
                                     struct ph_diag *diag) {
  enum ph_status status = PH_OK;
  for (size_t k = 0; k < chain->nodes_n; k++) {
    const struct ph_g2_node *node = &chain->node[k];
    if (fabs(node->turn) < PH_PI - REVERSAL) {
      continue;
    }
    if (node->inner) {
      mark_stuck(chain, k);
    }
    if (status == PH_OK) {
      status = node->inner
                   ? ph_fail_at(diag, PH_E_INFEASIBLE, "points", node->datum,
                                "is where the data turn back by 180 "
                                "degrees: no curve of bounded curvature "
                                "does")
                   : ph_fail_at(diag, PH_E_INFEASIBLE, "end_tangents", k > 0,
                                "points back along the chord");
    }
  }
  return status;
}

static enum ph_status add_points(struct ph_g2_chain *chain, bool may_add,
                                 struct ph_arena *arena, struct ph_diag *diag) {
  enum ph_status status = PH_OK;
  for (size_t round = 0; status == PH_OK && round < ROUNDS_MAX; round++) {
    size_t n;
    struct ph_g2_apex *apex = wanted(chain, arena, &n);
    if (!apex) {
      return ph_fail_memory(diag);
    }
    if (n == 0) {
      return PH_OK;
    }
    if (!may_add) {
      return ph_fail_at(diag, PH_E_INFEASIBLE, "points",
                        chain->node[apex->span].datum,
                        "begins an interval whose turns are too large for one "
                        "cubic: points must be added (auxiliary)");
    }
    status = ph_g2_add(chain, apex, n, arena, chain, diag);
  }
  if (status == PH_OK) {
    ph_g2_mark(chain, 0, chain->n, PH_G2_HARD);
    status = ph_fail(diag, PH_E_NO_CONVERGENCE, "points",
                     "turn too much: points that are added do not settle");
  }
  return status;
}

/* ---- straight runs ------------------------------------------------------- */

/* A maximal run of inner nodes without a turn. */
struct run {
  size_t first, n;
  size_t left, right; /* the nodes beside it */
};

static size_t around(const struct ph_g2_chain *chain, size_t k, size_t by) {
  k += by;
  return k < chain->nodes_n ? k : k - chain->nodes_n;
}

/*
 * The next run at or after step *at of a walk over all inner nodes that begins
 * behind `start`, which is no part of a run.
 *
 * ret  false when there is none
 */
static bool next_run(const struct ph_g2_chain *chain, size_t start, size_t *at,
                     struct run *run) {
  const size_t n = chain->closed ? chain->n : chain->nodes_n - 1;
  size_t k;
  for (; *at < n; ++*at) {
    k = around(chain, start, *at);
    if (chain->node[k].inner && chain->node[k].sign == 0) {
      break;
    }
  }
  if (*at >= n) {
    return false;
  }
  run->first = around(chain, start, *at);
  for (run->n = 0; *at < n; ++*at, run->n++) {
    k = around(chain, start, *at);
    if (!chain->node[k].inner || chain->node[k].sign != 0) {
      break;
    }
  }
  run->left = run->first > 0 ? run->first - 1 : chain->nodes_n - 1;
  run->right = around(chain, run->first, run->n);
  return true;
}

/* Whether the curve goes through the only point of a run with an inflection
 * next to it, rather than straight. */
static bool is_inflection(const struct ph_g2_chain *chain,
                          const struct run *run) {
  const struct ph_g2_node *l = &chain->node[run->left],
                          *r = &chain->node[run->right];
  return run->n == 1 && l->inner && r->inner && l->sign * r->sign < 0;
}

/* Whether the curve leaves the line on both sides of the only inner point, to
 * tangents of both ends on one side: it bends there to the other. */
static bool is_hollow(const struct ph_g2_chain *chain, const struct run *run) {
  const struct ph_g2_node *l = &chain->node[run->left],
                          *r = &chain->node[run->right];
  return run->n == 1 && !l->inner && !r->inner && l->sign * r->sign > 0;
}

/* Spans of a run: lines, but beside a corner between two runs, where the curve
 * must leave the line. */
static void set_run(struct ph_g2_chain *chain, const struct run *run,
                    bool corner_left, bool corner_right) {
  struct ph_g2_node *node = &chain->node[run->first];
  struct ph_g2_span *before = &chain->span[ph_g2_before(chain, run->first)];
  if (is_inflection(chain, run)) {
    node->sign = chain
                     ->node[before->length <= chain->span[run->first].length
                                ? run->left
                                : run->right]
                     .sign;
    return;
  }
  if (run->n == 1 && (corner_left || corner_right || is_hollow(chain, run))) {
    node->sign =
        (signed char)-chain
            ->node[!corner_left && corner_right ? run->right : run->left]
            .sign;
    return;
  }
  before->form = corner_left ? PH_G2_BEND : PH_G2_LINE;
  for (size_t i = 0; i < run->n; i++) {
    chain->span[around(chain, run->first, i)].form = PH_G2_LINE;
  }
  if (corner_right) {
    chain->span[around(chain, run->first, run->n - 1)].form = PH_G2_BEND;
  }
}

/* Whether the curve must leave the line before it reaches the end of a run, a
 * node with so many beside it, or is free to. */
static bool is_corner(const struct ph_g2_chain *chain, size_t k, int runs) {
  const struct ph_g2_node *node = &chain->node[k];
  const bool loose =
      chain->loose && node->datum != PH_G2_ADDED && chain->loose[node->datum];
  return node->inner && (runs > 1 || loose);
}

/* ret  PH_OK | PH_E_NO_MEMORY */
static enum ph_status set_runs(struct ph_g2_chain *chain,
                               struct ph_arena *arena, struct ph_diag *diag) {
  size_t start = 0, at = 1;
  struct run run;
  unsigned char *runs =
      ph_arena_array(arena, chain->nodes_n, 1); /* beside each node */
  if (!runs) {
    return ph_fail_memory(diag);
  }
  memset(runs, 0, chain->nodes_n);
  while (chain->closed && start + 1 < chain->nodes_n &&
         chain->node[start].sign == 0) {
    start++;
  }
  while (next_run(chain, start, &at, &run)) {
    if (!is_inflection(chain, &run)) {
      runs[run.left]++;
      runs[run.right]++;
    }
  }
  at = 1;
  while (next_run(chain, start, &at, &run)) {
    set_run(chain, &run, is_corner(chain, run.left, runs[run.left]),
            is_corner(chain, run.right, runs[run.right]));
  }
  return PH_OK;
}

/* ---- forms --------------------------------------------------------------- */

/* The senses at both ends of a span; of what has none it is the one that needs
 * no bend, but for a straight tangent, which needs one. */
static void senses_of(const struct ph_g2_chain *chain, size_t i, int sense[2]) {
  const struct ph_g2_node *node[2] = {&chain->node[i],
                                      &chain->node[ph_g2_next(chain, i)]};
  bool free_end[2];
  for (size_t end = 0; end < 2; end++) {
    sense[end] = node[end]->sign;
    free_end[end] = !node[end]->inner && !chain->given[end];
  }
  for (size_t end = 0; end < 2; end++) {
    if (sense[end] == 0) {
      sense[end] = free_end[end] ? sense[1 - end] : -sense[1 - end];
    }
  }
}

static enum ph_status set_forms(struct ph_g2_chain *chain,
                                struct ph_diag *diag) {
  enum ph_status status = PH_OK;
  for (size_t i = 0; i < chain->n; i++) {
    struct ph_g2_span *span = &chain->span[i];
    int sense[2];
    senses_of(chain, i, sense);
    span->sense = (signed char)sense[0];
    if (span->form != PH_G2_LINE || i == 0 || i + 1 == chain->n) {
      bool line = sense[0] == 0 ||
                  (span->form == PH_G2_LINE &&
                   !((i == 0 && chain->given[0] && chain->node[0].sign != 0) ||
                     (i + 1 == chain->n && chain->given[1] &&
                      chain->node[chain->n].sign != 0)));
      span->form = line                   ? PH_G2_LINE
                   : sense[0] == sense[1] ? PH_G2_ARC
                                          : PH_G2_BEND;
    }
  }
  for (size_t k = 0; k < chain->nodes_n; k++) {
    if (chain->node[k].inner && !is_straight(chain, k) &&
        chain->span[k].form == PH_G2_LINE &&
        chain->span[ph_g2_before(chain, k)].form == PH_G2_LINE) {
      mark_stuck(chain, k);
      if (status == PH_OK) {
        status = ph_fail_at(diag, PH_E_NO_CONVERGENCE, "points",
                            chain->node[k].datum,
                            "is a corner between straight runs");
      }
    }
  }
  return status;
}

enum ph_status ph_g2_plan(struct ph_g2_chain *chain, bool may_add,
                          struct ph_arena *arena, struct ph_diag *diag) {
  enum ph_status status = check_reversal(chain, diag);
  if (status == PH_OK) {
    status = add_points(chain, may_add, arena, diag);
  }
  for (size_t i = 0; status == PH_OK && i < chain->n; i++) {
    chain->span[i].form = PH_G2_ARC;
  }
  if (status == PH_OK) {
    status = set_runs(chain, arena, diag);
  }
  return status == PH_OK ? set_forms(chain, diag) : status;
}
