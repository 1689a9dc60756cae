/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A tree of boxes in the plane over items in an order in which neighbours are
 * near, as along a curve.  The node over items first .. first + n - 1 has the
 * first half of them, n / 2, in the node after it.
 */
#ifndef PH_KERNEL_BOXTREE_H
#define PH_KERNEL_BOXTREE_H

#include "base/mem.h"

#include <stdbool.h>
#include <stddef.h>

struct ph_boxtree_node {
  double low[2], high[2];
};

struct ph_boxtree {
  size_t n; /* items */
  struct ph_boxtree_node *v;
};

/* The box of an item. */
typedef struct ph_boxtree_node ph_boxtree_leaf(void *context, size_t item);

/* ph_boxtree_of: the tree over n > 0 items; false where memory is exhausted. */
bool ph_boxtree_of(struct ph_boxtree *tree, size_t n, ph_boxtree_leaf *leaf,
                   void *context, struct ph_arena *arena);

/* ph_boxtree_left, ph_boxtree_right: the halves of node `at` over n > 1 items,
 * the second after n / 2 of them. */
static inline size_t ph_boxtree_left(size_t at) {
  return at + 1;
}

static inline size_t ph_boxtree_right(size_t at, size_t n) {
  return at + 2 * (n / 2);
}

/* ph_boxtree_add: makes a box hold a point. */
static inline void ph_boxtree_add(struct ph_boxtree_node *box, double x,
                                  double y) {
  box->low[0] = x < box->low[0] ? x : box->low[0];
  box->low[1] = y < box->low[1] ? y : box->low[1];
  box->high[0] = x > box->high[0] ? x : box->high[0];
  box->high[1] = y > box->high[1] ? y : box->high[1];
}

/* ph_boxtree_empty: the box of nothing. */
struct ph_boxtree_node ph_boxtree_empty(void);

/*
 * A search for items near a box, of which a point is one.
 *
 * skip, skip_n  that many items from there on, round the end, are left out
 * limit         items whose boxes are as far are not visited; visits may make
 *               it less: 0 ends the search
 */
struct ph_boxtree_search {
  struct ph_boxtree_node from;
  size_t skip, skip_n;
  double limit;
  void (*visit)(struct ph_boxtree_search *search, size_t item);
};

/* ph_boxtree_near: visits items, of each node the nearer half first. */
void ph_boxtree_near(const struct ph_boxtree *tree,
                     struct ph_boxtree_search *search);

#endif
