/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Trees of boxes (see boxtree.h). */
#include "kernel/boxtree.h"

#include <math.h>

struct ph_boxtree_node ph_boxtree_empty(void) {
  const struct ph_boxtree_node box = {{HUGE_VAL, HUGE_VAL},
                                      {-HUGE_VAL, -HUGE_VAL}};
  return box;
}

struct build {
  struct ph_boxtree_node *v;
  ph_boxtree_leaf *leaf;
  void *context;
};

static void build(const struct build *b, size_t at, size_t first, size_t n) {
  struct ph_boxtree_node *node = &b->v[at];
  const struct ph_boxtree_node *right = &b->v[ph_boxtree_right(at, n)];
  if (n == 1) {
    *node = b->leaf(b->context, first);
    return;
  }
  build(b, ph_boxtree_left(at), first, n / 2);
  build(b, ph_boxtree_right(at, n), first + n / 2, n - n / 2);
  *node = b->v[ph_boxtree_left(at)];
  ph_boxtree_add(node, right->low[0], right->low[1]);
  ph_boxtree_add(node, right->high[0], right->high[1]);
}

bool ph_boxtree_of(struct ph_boxtree *tree, size_t n, ph_boxtree_leaf *leaf,
                   void *context, struct ph_arena *arena) {
  struct build b = {.leaf = leaf, .context = context};
  b.v = ph_arena_array(arena, 2 * n, sizeof *b.v);
  *tree = (struct ph_boxtree){n, b.v};
  if (b.v) {
    build(&b, 0, 0, n);
  }
  return b.v;
}

/* ---- search --------------------------------------------------------------
 */

/* The square of the distance of two boxes. */
static double apart(const struct ph_boxtree_node *a,
                    const struct ph_boxtree_node *b) {
  double sum = 0;
  for (size_t j = 0; j < 2; j++) {
    const double below = b->low[j] - a->high[j], above = a->low[j] - b->high[j];
    const double most = below > above ? below : above;
    sum += most > 0 ? most * most : 0;
  }
  return sum;
}

/* Node `at`, whose distance is given as its square. */
static void search_node(const struct ph_boxtree *tree,
                        struct ph_boxtree_search *s, size_t at, size_t first,
                        size_t n, double away) {
  const size_t half = n / 2, l = ph_boxtree_left(at);
  const size_t r = ph_boxtree_right(at, n);
  const size_t after = first - s->skip + (first < s->skip ? tree->n : 0);
  double left, right;
  if (away >= s->limit * s->limit || after + n <= s->skip_n) {
    return;
  }
  if (n == 1) {
    s->visit(s, first);
    return;
  }
  left = apart(&tree->v[l], &s->from);
  right = apart(&tree->v[r], &s->from);
  if (left <= right) {
    search_node(tree, s, l, first, half, left);
    search_node(tree, s, r, first + half, n - half, right);
  } else {
    search_node(tree, s, r, first + half, n - half, right);
    search_node(tree, s, l, first, half, left);
  }
}

void ph_boxtree_near(const struct ph_boxtree *tree,
                     struct ph_boxtree_search *s) {
  search_node(tree, s, 0, 0, tree->n, apart(&tree->v[0], &s->from));
}
