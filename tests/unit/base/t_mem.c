/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The arena: alignment, overflow, marks, and what a reset keeps.  Every byte
 * handed out is written, so that a sanitizer sees a chunk that is too small. */
#include "unit.h"

#include "base/mem.h"

static void finish(void) {
  ck_assert_ptr_null(unit_arena.chunks);
}

PH_TEST(test_malloc_of_nothing) {
  void *a = ph_malloc(0), *b = ph_malloc(0);
  ck_assert(a && b && a != b);
  ph_free(a);
  b = ph_realloc(b, 0);
  ck_assert_ptr_nonnull(b);
  ph_free(b);
  ph_free(NULL);
}

PH_TEST(test_alignment) {
  for (size_t n = 0; n < 100; n++) {
    char *p = ph_arena_array(&unit_arena, n, 1);
    ck_assert_ptr_nonnull(p);
    ck_assert_uint_eq((uintptr_t)p % 16, 0);
    memset(p, 1, n);
  }
}

/* Pieces of all sizes, each filled with its number: none overlaps. */
PH_TEST(test_pieces) {
  enum { PIECES = 400 };
  struct unit_random r = unit_random_of(1);
  unsigned char *piece[PIECES];
  size_t size[PIECES];
  for (size_t i = 0; i < PIECES; i++) {
    size[i] = unit_random_below(&r, i % 20 ? 300 : 60000);
    piece[i] = ph_arena_array(&unit_arena, size[i], 1);
    ck_assert_ptr_nonnull(piece[i]);
    memset(piece[i], (int)(i % 256), size[i]);
  }
  for (size_t i = 0; i < PIECES; i++) {
    size_t kept = 0;
    while (kept < size[i] && piece[i][kept] == i % 256) {
      kept++;
    }
    ck_assert_uint_eq(kept, size[i]);
  }
}

PH_TEST(test_large) {
  size_t n = (size_t)3 << 20;
  char *p = ph_arena_array(&unit_arena, n, 1), *q;
  ck_assert_ptr_nonnull(p);
  memset(p, 1, n);
  q = ph_arena_array(&unit_arena, 1, 1);
  ck_assert_ptr_nonnull(q);
  ck_assert(q < p || q >= p + n);
}

PH_TEST(test_overflow) {
  ck_assert_ptr_null(ph_arena_array(&unit_arena, SIZE_MAX, 1));
  ck_assert_ptr_null(ph_arena_array(&unit_arena, SIZE_MAX, 16));
  ck_assert_ptr_null(ph_arena_array(&unit_arena, SIZE_MAX / 8, 16));
  ck_assert_ptr_null(ph_arena_array(&unit_arena, 2, SIZE_MAX / 2 + 1));
  ck_assert_ptr_null(ph_arena_array(&unit_arena, SIZE_MAX - 16, 1));
  ck_assert_ptr_null(ph_arena_copy(&unit_arena, "", SIZE_MAX));
  ck_assert_ptr_null(unit_arena.chunks);
  ck_assert_ptr_nonnull(ph_arena_array(&unit_arena, SIZE_MAX, 0));
  ck_assert_ptr_nonnull(ph_arena_array(&unit_arena, 0, SIZE_MAX));
}

PH_TEST(test_copy) {
  char text[] = {'a', 'b', '\0', 'c'};
  char *copy = ph_arena_copy(&unit_arena, text, sizeof text);
  ck_assert_ptr_nonnull(copy);
  ck_assert_mem_eq(copy, "ab\0c\0", 5);
  ck_assert_str_eq(ph_arena_copy(&unit_arena, NULL, 0), "");
}

/* What was taken before the mark stays; what comes after it is taken again. */
PH_TEST(test_mark) {
  char *before = ph_arena_copy(&unit_arena, "before", 6), *first = NULL;
  struct ph_mark mark = ph_arena_mark(&unit_arena);
  for (int round = 0; round < 3; round++) {
    char *p = ph_arena_array(&unit_arena, 100, 1);
    ck_assert_ptr_nonnull(p);
    memset(p, round, 100);
    first = round ? first : p;
    ck_assert_ptr_eq(p, first);
    for (int i = 0; i < 50; i++) { /* into further chunks */
      ck_assert_ptr_nonnull(ph_arena_array(&unit_arena, 5000, 1));
    }
    ph_arena_release(&unit_arena, mark);
    ck_assert_ptr_eq(ph_arena_mark(&unit_arena).chunk, mark.chunk);
    ck_assert_uint_eq(ph_arena_mark(&unit_arena).used, mark.used);
  }
  ck_assert_str_eq(before, "before");
}

PH_TEST(test_mark_of_nothing) {
  struct ph_mark mark = ph_arena_mark(&unit_arena);
  ck_assert_ptr_null(mark.chunk);
  ck_assert_ptr_nonnull(ph_arena_array(&unit_arena, 1, 1));
  ph_arena_release(&unit_arena, mark);
  ck_assert_uint_eq(ph_arena_mark(&unit_arena).used, 0);
  ph_arena_release(&unit_arena, mark);
  ck_assert_uint_eq(ph_arena_mark(&unit_arena).used, 0);
}

/* After small records the same memory serves again, without an allocation. */
PH_TEST(test_reset_keeps) {
  char *p = ph_arena_array(&unit_arena, 1000, 1);
  struct ph_chunk *chunk = unit_arena.chunks;
  ph_arena_reset(&unit_arena);
  ck_assert_ptr_eq(unit_arena.chunks, chunk);
  ck_assert_ptr_eq(ph_arena_array(&unit_arena, 1000, 1), p);
}

/* Of several chunks the largest is kept: the next record needs no second. */
PH_TEST(test_reset_keeps_largest) {
  struct ph_chunk *chunk;
  for (int i = 0; i < 100; i++) {
    ck_assert_ptr_nonnull(ph_arena_array(&unit_arena, 5000, 1));
  }
  ph_arena_reset(&unit_arena);
  chunk = unit_arena.chunks;
  ck_assert_ptr_nonnull(chunk);
  for (int i = 0; i < 40; i++) {
    char *p = ph_arena_array(&unit_arena, 5000, 1);
    ck_assert_ptr_nonnull(p);
    memset(p, i, 5000);
    ck_assert_ptr_eq(unit_arena.chunks, chunk);
  }
}

/* After a huge one nothing is kept of it. */
PH_TEST(test_reset_gives_back) {
  ck_assert_ptr_nonnull(ph_arena_array(&unit_arena, (size_t)8 << 20, 1));
  ph_arena_reset(&unit_arena);
  ck_assert_ptr_null(unit_arena.chunks);
  ck_assert_ptr_nonnull(ph_arena_array(&unit_arena, 1000, 1));
  ck_assert_ptr_nonnull(ph_arena_array(&unit_arena, (size_t)8 << 20, 1));
  ph_arena_reset(&unit_arena);
  ck_assert_ptr_nonnull(unit_arena.chunks);
  ck_assert_uint_eq(ph_arena_mark(&unit_arena).used, 0);
  ph_arena_reset(&(struct ph_arena){0});
}

/* What there was is kept, and little is copied. */
PH_TEST(test_grow) {
  size_t *v = NULL, room = 0, copies = 0;
  for (size_t n = 0; n < 1000; n++) {
    size_t *grown = ph_arena_grow(&unit_arena, v, n, sizeof *v, 3, &room);
    ck_assert_ptr_nonnull(grown);
    ck_assert_uint_gt(room, n);
    copies += grown != v;
    v = grown;
    v[n] = n;
  }
  for (size_t n = 0; n < 1000; n++) {
    ck_assert_uint_eq(v[n], n);
  }
  ck_assert_uint_eq(room, 3 << 9);
  ck_assert_uint_eq(copies, 10);
  room = 1;
  ck_assert_ptr_null(
      ph_arena_grow(&unit_arena, v, 1, SIZE_MAX / 2 + 1, 1, &room));
  ck_assert_uint_eq(room, 1);
}

/* Two arenas on one budget; what is given back can be had again. */
PH_TEST(test_budget_of_bytes) {
  struct ph_budget budget = {.used = 0};
  struct ph_arena a = {.budget = &budget}, b = ph_arena_beside(&a);
  struct ph_mark mark;
  ph_budget_start(&budget, 1000, 0);
  ck_assert_ptr_nonnull(ph_arena_array(&a, 50, 10)); /* 512 of them */
  mark = ph_arena_mark(&b);
  ck_assert_ptr_nonnull(ph_arena_array(&b, 400, 1));
  ck_assert_uint_eq(budget.used, 912);
  ph_arena_release(&b, mark);
  ck_assert_uint_eq(budget.used, 512);
  ck_assert_ptr_nonnull(ph_arena_array(&b, 480, 1));
  ck_assert_uint_eq(budget.needed, 0);
  ck_assert_ptr_null(ph_arena_array(&a, 16, 1));
  ck_assert_uint_eq(budget.needed, 1008);
  ck_assert_ptr_null(ph_arena_array(&a, 1, 1)); /* once spent, it stays so */
  ck_assert_ptr_null(ph_arena_array(&b, SIZE_MAX / 2, 1));
  ck_assert_uint_eq(budget.needed, 1008);
  ph_budget_stop(&budget);
  ck_assert_ptr_nonnull(ph_arena_array(&a, 5000, 1));
  ph_arena_reset(&a);
  ph_arena_reset(&b);
  ck_assert_uint_eq(budget.used, 0);
  ph_budget_start(&budget, 1000, 0); /* whatever chunks there are */
  ck_assert_ptr_nonnull(ph_arena_array(&a, 992, 1));
  ck_assert_ptr_null(ph_arena_array(&b, 16, 1));
  ph_arena_free(&a);
  ph_arena_free(&b);
  ck_assert_uint_eq(budget.used, 0);
}

/* Parts of the work, each with what was left; whoever was first, the budget is
 * spent by the one at which, in their order, it is. */
PH_TEST(test_accounts) {
  static const struct {
    size_t taken[3], failed; /* 3: none */
    size_t needed;
    bool room; /* for another, when all are done */
  } cases[] = {{{16, 32, 48}, 3, 0, true},
               {{400, 400, 160}, 2, 1056, false},
               {{400, 944, 16}, 1, 1440, true},
               {{512, 400, 400}, 1, 1008, false}};
  for (size_t i = 0; i < COUNT(cases); i++) {
    struct ph_budget budget = {.used = 0};
    struct ph_arena whole = {.budget = &budget};
    struct ph_account account[3];
    size_t failed = 3, used = 96;
    bool room = true;
    unit_case("case %zu", i);
    ph_budget_start(&budget, 1000, 0);
    ck_assert_ptr_nonnull(ph_arena_array(&whole, 96, 1));
    for (size_t k = 0; k < 3; k++) {
      ph_account_begin(&account[k], &whole);
    }
    for (size_t k = 3; k-- > 0;) {
      const size_t n = cases[i].taken[k];
      ck_assert(!ph_arena_array(&account[k].arena, n, 1) == (n > 904));
      room = ph_account_done(&account[k]);
      ck_assert_uint_eq(budget.used, 96);
    }
    ck_assert(room == cases[i].room);
    for (size_t k = 0; k < 3; k++) {
      const bool good = ph_account_end(&account[k]);
      failed = good || failed < 3 ? failed : k;
      used += failed < 3 ? 0 : cases[i].taken[k];
      ck_assert_uint_eq(budget.used, used);
    }
    ck_assert_uint_eq(failed, cases[i].failed);
    ck_assert_uint_eq(budget.needed, cases[i].needed);
    for (size_t k = 0; k < 3; k++) {
      ph_arena_free(&account[k].arena);
    }
    ck_assert_uint_eq(budget.used, 96);
    ck_assert_uint_eq(budget.apart, 0);
    ph_arena_free(&whole);
  }
}

PH_TEST(test_budget_of_time) {
  struct ph_budget budget = {.used = 0};
  struct ph_arena a = {.budget = &budget};
  ph_budget_start(&budget, 0, 0);
  ck_assert(!ph_arena_late(&a));
  ck_assert(!ph_arena_late(&unit_arena));
  ph_budget_start(&budget, 0, 1e6);
  ck_assert(!ph_arena_late(&a));
  ck_assert_ptr_nonnull(ph_arena_array(&a, 1, 1));
  ph_budget_start(&budget, 0, 1e-9);
  while (!ph_arena_late(&a)) { /* a clock may be coarse */
  }
  ck_assert_ptr_null(ph_arena_array(&a, 1, 1));
  ck_assert_uint_eq(budget.needed, 0);
  ph_budget_stop(&budget);
  ck_assert(budget.late);
  ck_assert_ptr_nonnull(ph_arena_array(&a, 1, 1));
  ph_arena_free(&a);
}

PH_FIXTURE(NULL, finish)
