/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Pairs of arcs that may meet, by a tree of boxes (see crossing.h). */
#include "curve/offset/crossing.h"

#include "kernel/boxtree.h"

#include <stdlib.h>

/* Decisions for each arc, and besides: arcs that run on each other take more.
 */
enum { TESTS_EACH = 2000, TESTS_LEAST = 100000 };

/* A smooth chain that turns by less is a graph over a direction. */
static const double GRAPH = 3;

/* What is known of a node besides its box. */
struct node {
  double turn; /* of a smooth chain; infinite if it is none */
  bool active; /* there are arcs of strands that are not passive */
};

struct tree {
  struct ph_pairing pairing;
  struct ph_boxtree boxes;
  struct node *nodes;
};

static bool is_smooth(const struct ph_arcs *arcs, size_t i) {
  return arcs->v[i].next == i + 1 && arcs->v[i].smooth;
}

static struct ph_boxtree_node leaf_of(void *context, size_t i) {
  const struct tree *tree = context;
  const struct ph_strands *strands = tree->pairing.strands;
  const struct ph_arc *arc = &tree->pairing.arcs->v[i];
  const ph_cplx a = arc->bit.end[0].o, b = arc->bit.end[1].o;
  const ph_cplx chord = ph_cplx_sub(b, a);
  const double l = fabs(arc->bit.length), c = ph_cplx_abs(chord);
  const double semi = fmax((l - c) * (l + c), 0);
  const double side[2] = {chord.re, chord.im};
  const double middle[2] = {0.5 * (a.re + b.re), 0.5 * (a.im + b.im)};
  struct ph_boxtree_node node;
  for (size_t j = 0; j < 2; j++) {
    /* (l x)^2 + (l^2 - c^2)(1 - x^2), x the cosine: l x = l side / c */
    const double x = c > 0 ? side[j] / c : 1;
    const double half =
        0.5 * sqrt(l * l * x * x + semi * (1 - x * x)) + 1e-14 * strands->size;
    node.low[j] = middle[j] - half;
    node.high[j] = middle[j] + half;
  }
  return node;
}

static void build(struct tree *tree, size_t at, size_t first, size_t n) {
  struct node *node = &tree->nodes[at];
  const struct node *left = &tree->nodes[ph_boxtree_left(at)];
  const struct node *right = &tree->nodes[ph_boxtree_right(at, n)];
  const struct ph_arc *arc = &tree->pairing.arcs->v[first];
  if (n == 1) {
    node->turn = fabs(arc->bit.turn);
    node->active = !tree->pairing.strands->v[arc->strand].passive;
    return;
  }
  build(tree, ph_boxtree_left(at), first, n / 2);
  build(tree, ph_boxtree_right(at, n), first + n / 2, n - n / 2);
  node->turn = is_smooth(tree->pairing.arcs, first + n / 2 - 1)
                   ? left->turn + right->turn
                   : HUGE_VAL;
  node->active = left->active || right->active;
}

/* Whether arcs are a smooth chain from i to j that turns by little. */
static bool is_chain(const struct ph_arcs *arcs, size_t i, size_t j) {
  double turn = fabs(arcs->v[i].bit.turn);
  for (size_t steps = 0; i != j && steps < 16; steps++) {
    if (arcs->v[i].next == PH_NO_STRAND || !arcs->v[i].smooth) {
      return false;
    }
    i = arcs->v[i].next;
    turn += fabs(arcs->v[i].bit.turn);
  }
  return i == j && turn < GRAPH;
}

/* Pairs of an arc of the one node and one of the other, which is the same or
 * follows it. */
static enum ph_status visit(struct tree *tree, size_t a, size_t a_first,
                            size_t a_n, size_t b, size_t b_first, size_t b_n) {
  const struct ph_boxtree_node *p = &tree->boxes.v[a], *q = &tree->boxes.v[b];
  const double turn = tree->nodes[a].turn;
  const struct ph_arcs *arcs = tree->pairing.arcs;
  const size_t half = (a_n >= b_n ? a_n : b_n) / 2;
  enum ph_status status;
  if ((!tree->nodes[a].active && !tree->nodes[b].active) ||
      p->low[0] > q->high[0] || q->low[0] > p->high[0] ||
      p->low[1] > q->high[1] || q->low[1] > p->high[1] ||
      (a == b && turn < GRAPH)) {
    return PH_OK;
  }
  if (a != b && a_first + a_n == b_first && is_smooth(arcs, b_first - 1) &&
      turn + tree->nodes[b].turn < GRAPH) {
    return PH_OK;
  }
  if (a_n == 1 && b_n == 1) {
    return a == b || is_chain(arcs, a_first, b_first) ||
                   is_chain(arcs, b_first, a_first)
               ? PH_OK
               : ph_pair_decide(&tree->pairing, a_first, b_first);
  }
  if (a == b) {
    const size_t left = ph_boxtree_left(a), right = ph_boxtree_right(a, a_n);
    const size_t after = a_first + half;
    status = visit(tree, left, a_first, half, left, a_first, half);
    if (status == PH_OK) {
      status = visit(tree, right, after, a_n - half, right, after, a_n - half);
    }
    return status == PH_OK
               ? visit(tree, left, a_first, half, right, after, a_n - half)
               : status;
  }
  if (a_n >= b_n) {
    status = visit(tree, ph_boxtree_left(a), a_first, half, b, b_first, b_n);
    return status == PH_OK ? visit(tree, ph_boxtree_right(a, a_n),
                                   a_first + half, a_n - half, b, b_first, b_n)
                           : status;
  }
  status = visit(tree, a, a_first, a_n, ph_boxtree_left(b), b_first, half);
  return status == PH_OK
             ? visit(tree, a, a_first, a_n, ph_boxtree_right(b, b_n),
                     b_first + half, b_n - half)
             : status;
}

static int compare(const void *a, const void *b) {
  const struct ph_break *p = a, *q = b;
  return p->arc != q->arc ? (p->arc < q->arc ? -1 : 1)
                          : (p->u > q->u) - (p->u < q->u);
}

enum ph_status ph_crossings_of(const struct ph_strands *strands,
                               const struct ph_arcs *arcs,
                               struct ph_crossings *crossings,
                               struct ph_diag *diag) {
  const size_t n = arcs->n;
  struct tree tree = {
      .pairing = {.strands = strands,
                  .arcs = arcs,
                  .out = crossings,
                  .tests_most = strands->effort ? *strands->effort
                                                : TESTS_LEAST + TESTS_EACH * n,
                  .diag = diag}};
  enum ph_status status;
  *crossings = (struct ph_crossings){.breaks = NULL};
  if (n == 0) {
    return PH_OK;
  }
  tree.nodes = ph_arena_array(strands->arena, 2 * n, sizeof *tree.nodes);
  tree.pairing.stack =
      ph_arena_array(strands->arena, PH_BITS_MAX, sizeof(struct ph_bits));
  if (!tree.nodes || !tree.pairing.stack ||
      !ph_boxtree_of(&tree.boxes, n, leaf_of, &tree, strands->arena)) {
    return ph_fail_memory(diag);
  }
  build(&tree, 0, 0, n);
  status = visit(&tree, 0, 0, n, 0, 0, n);
  if (strands->effort) {
    const size_t tests = tree.pairing.tests;
    *strands->effort -= tests < *strands->effort ? tests : *strands->effort;
  }
  if (status == PH_E_NO_CONVERGENCE) {
    return ph_fail(diag, status, NULL,
                   "the offset at distance %g runs along itself in too many "
                   "places",
                   ldexp(strands->distance, strands->exponent));
  }
  if (status == PH_OK && crossings->breaks_n) {
    qsort(crossings->breaks, crossings->breaks_n, sizeof *crossings->breaks,
          compare);
  }
  return status;
}
