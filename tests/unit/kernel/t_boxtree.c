/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Trees of boxes: what a search visits, against all items. */
#include "unit.h"

#include "kernel/boxtree.h"

enum { ITEMS_MAX = 100, TRIALS = 500 };

static struct ph_boxtree_node boxes[ITEMS_MAX];

struct seen {
  struct ph_boxtree_search base;
  size_t times[ITEMS_MAX], n;
};

static struct ph_boxtree_node leaf(void *context, size_t i) {
  const struct ph_boxtree_node *v = context;
  return v[i];
}

static void see(struct ph_boxtree_search *base, size_t i) {
  struct seen *seen = (struct seen *)base;
  seen->times[i]++;
  seen->n++;
}

static void see_one(struct ph_boxtree_search *base, size_t i) {
  see(base, i);
  base->limit = 0;
}

static struct ph_boxtree_node any_box(struct unit_random *r) {
  struct ph_boxtree_node box = ph_boxtree_empty();
  const double x = unit_random_in(r, -1, 1), y = unit_random_in(r, -1, 1);
  ph_boxtree_add(&box, x, y);
  ph_boxtree_add(&box, x + unit_random_in(r, -0.1, 0.1),
                 y + unit_random_in(r, -0.1, 0.1));
  return box;
}

static double apart(const struct ph_boxtree_node *a,
                    const struct ph_boxtree_node *b) {
  double away[2];
  for (size_t j = 0; j < 2; j++) {
    away[j] = fmax(fmax(a->low[j] - b->high[j], b->low[j] - a->high[j]), 0);
  }
  return hypot(away[0], away[1]);
}

PH_TEST(test_near) {
  struct unit_random r = unit_random_of(45);
  for (size_t t = 0; t < TRIALS; t++) {
    const size_t n = 1 + unit_random_below(&r, ITEMS_MAX);
    const double limit = unit_random_in(&r, 0.01, 1);
    struct seen all = {.base = {.limit = limit, .visit = see}}, one;
    struct ph_arena arena = {.chunks = NULL};
    struct ph_boxtree tree;
    size_t near = 0;
    for (size_t i = 0; i < n; i++) {
      boxes[i] = any_box(&r);
    }
    ck_assert(ph_boxtree_of(&tree, n, leaf, boxes, &arena));
    all.base.from = any_box(&r);
    all.base.skip = unit_random_below(&r, n);
    all.base.skip_n = unit_random_below(&r, n + 1);
    one = all;
    one.base.visit = see_one;
    ph_boxtree_near(&tree, &all.base);
    ph_boxtree_near(&tree, &one.base);
    for (size_t i = 0; i < n; i++) {
      const size_t after = (i + n - all.base.skip) % n;
      const bool wanted =
          after >= all.base.skip_n && apart(&boxes[i], &all.base.from) < limit;
      ck_that(all.times[i] == wanted, "item %zu of %zu: %zu times", i, n,
              all.times[i]);
      near += wanted;
    }
    ck_assert_uint_eq(one.n, near > 0);
    ph_arena_free(&arena);
  }
}
