/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The arena: alignment, overflow, marks, and what a reset keeps.  Every byte
 * handed out is written, so that a sanitizer sees a chunk that is too small. */
#include "unit.h"
#include "random_unit.h"

#include "base/mem.h"

#include <string.h>

static struct ph_arena arena;

static void finish(void) {
  ph_arena_free(&arena);
  ck_assert_ptr_null(arena.chunks);
}

START_TEST(test_malloc_of_nothing) {
  void *a = ph_malloc(0), *b = ph_malloc(0);
  ck_assert(a && b && a != b);
  ph_free(a);
  b = ph_realloc(b, 0);
  ck_assert_ptr_nonnull(b);
  ph_free(b);
  ph_free(NULL);
}
END_TEST

START_TEST(test_alignment) {
  for (size_t n = 0; n < 100; n++) {
    char *p = ph_arena_array(&arena, n, 1);
    ck_assert_ptr_nonnull(p);
    ck_assert_uint_eq((uintptr_t)p % 16, 0);
    memset(p, 1, n);
  }
}
END_TEST

/* Pieces of all sizes, each filled with its number: none overlaps. */
START_TEST(test_pieces) {
  enum { PIECES = 400 };
  struct unit_random r = unit_random_of(1);
  unsigned char *piece[PIECES];
  size_t size[PIECES];
  for (size_t i = 0; i < PIECES; i++) {
    size[i] = unit_random_below(&r, i % 20 ? 300 : 60000);
    piece[i] = ph_arena_array(&arena, size[i], 1);
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
END_TEST

START_TEST(test_large) {
  size_t n = (size_t)3 << 20;
  char *p = ph_arena_array(&arena, n, 1), *q;
  ck_assert_ptr_nonnull(p);
  memset(p, 1, n);
  q = ph_arena_array(&arena, 1, 1);
  ck_assert_ptr_nonnull(q);
  ck_assert(q < p || q >= p + n);
}
END_TEST

START_TEST(test_overflow) {
  ck_assert_ptr_null(ph_arena_array(&arena, SIZE_MAX, 1));
  ck_assert_ptr_null(ph_arena_array(&arena, SIZE_MAX, 16));
  ck_assert_ptr_null(ph_arena_array(&arena, SIZE_MAX / 8, 16));
  ck_assert_ptr_null(ph_arena_array(&arena, 2, SIZE_MAX / 2 + 1));
  ck_assert_ptr_null(ph_arena_array(&arena, SIZE_MAX - 16, 1));
  ck_assert_ptr_null(ph_arena_copy(&arena, "", SIZE_MAX));
  ck_assert_ptr_null(arena.chunks);
  ck_assert_ptr_nonnull(ph_arena_array(&arena, SIZE_MAX, 0));
  ck_assert_ptr_nonnull(ph_arena_array(&arena, 0, SIZE_MAX));
}
END_TEST

START_TEST(test_copy) {
  char text[] = {'a', 'b', '\0', 'c'};
  char *copy = ph_arena_copy(&arena, text, sizeof text);
  ck_assert_ptr_nonnull(copy);
  ck_assert_mem_eq(copy, "ab\0c\0", 5);
  ck_assert_str_eq(ph_arena_copy(&arena, NULL, 0), "");
}
END_TEST

/* What was taken before the mark stays; what comes after it is taken again. */
START_TEST(test_mark) {
  char *before = ph_arena_copy(&arena, "before", 6), *first = NULL;
  struct ph_mark mark = ph_arena_mark(&arena);
  for (int round = 0; round < 3; round++) {
    char *p = ph_arena_array(&arena, 100, 1);
    ck_assert_ptr_nonnull(p);
    memset(p, round, 100);
    first = round ? first : p;
    ck_assert_ptr_eq(p, first);
    for (int i = 0; i < 50; i++) { /* into further chunks */
      ck_assert_ptr_nonnull(ph_arena_array(&arena, 5000, 1));
    }
    ph_arena_release(&arena, mark);
    ck_assert_ptr_eq(ph_arena_mark(&arena).chunk, mark.chunk);
    ck_assert_uint_eq(ph_arena_mark(&arena).used, mark.used);
  }
  ck_assert_str_eq(before, "before");
}
END_TEST

START_TEST(test_mark_of_nothing) {
  struct ph_mark mark = ph_arena_mark(&arena);
  ck_assert_ptr_null(mark.chunk);
  ck_assert_ptr_nonnull(ph_arena_array(&arena, 1, 1));
  ph_arena_release(&arena, mark);
  ck_assert_uint_eq(ph_arena_mark(&arena).used, 0);
  ph_arena_release(&arena, mark);
  ck_assert_uint_eq(ph_arena_mark(&arena).used, 0);
}
END_TEST

/* After small records the same memory serves again, without an allocation. */
START_TEST(test_reset_keeps) {
  char *p = ph_arena_array(&arena, 1000, 1);
  struct ph_chunk *chunk = arena.chunks;
  ph_arena_reset(&arena);
  ck_assert_ptr_eq(arena.chunks, chunk);
  ck_assert_ptr_eq(ph_arena_array(&arena, 1000, 1), p);
}
END_TEST

/* Of several chunks the largest is kept: the next record needs no second. */
START_TEST(test_reset_keeps_largest) {
  struct ph_chunk *chunk;
  for (int i = 0; i < 100; i++) {
    ck_assert_ptr_nonnull(ph_arena_array(&arena, 5000, 1));
  }
  ph_arena_reset(&arena);
  chunk = arena.chunks;
  ck_assert_ptr_nonnull(chunk);
  for (int i = 0; i < 40; i++) {
    char *p = ph_arena_array(&arena, 5000, 1);
    ck_assert_ptr_nonnull(p);
    memset(p, i, 5000);
    ck_assert_ptr_eq(arena.chunks, chunk);
  }
}
END_TEST

/* After a huge one nothing is kept of it. */
START_TEST(test_reset_gives_back) {
  ck_assert_ptr_nonnull(ph_arena_array(&arena, (size_t)8 << 20, 1));
  ph_arena_reset(&arena);
  ck_assert_ptr_null(arena.chunks);
  ck_assert_ptr_nonnull(ph_arena_array(&arena, 1000, 1));
  ck_assert_ptr_nonnull(ph_arena_array(&arena, (size_t)8 << 20, 1));
  ph_arena_reset(&arena);
  ck_assert_ptr_nonnull(arena.chunks);
  ck_assert_uint_eq(ph_arena_mark(&arena).used, 0);
  ph_arena_reset(&(struct ph_arena){0});
}
END_TEST

/* What there was is kept, and little is copied. */
START_TEST(test_grow) {
  size_t *v = NULL, room = 0, copies = 0;
  for (size_t n = 0; n < 1000; n++) {
    size_t *grown = ph_arena_grow(&arena, v, n, sizeof *v, 3, &room);
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
  ck_assert_ptr_null(ph_arena_grow(&arena, v, 1, SIZE_MAX / 2 + 1, 1, &room));
  ck_assert_uint_eq(room, 1);
}
END_TEST

static Suite *suite(void) {
  Suite *s = suite_create("mem");
  TCase *tc = tcase_create("mem");
  tcase_add_checked_fixture(tc, NULL, finish);
  tcase_add_test(tc, test_malloc_of_nothing);
  tcase_add_test(tc, test_alignment);
  tcase_add_test(tc, test_pieces);
  tcase_add_test(tc, test_large);
  tcase_add_test(tc, test_overflow);
  tcase_add_test(tc, test_grow);
  tcase_add_test(tc, test_copy);
  tcase_add_test(tc, test_mark);
  tcase_add_test(tc, test_mark_of_nothing);
  tcase_add_test(tc, test_reset_keeps);
  tcase_add_test(tc, test_reset_keeps_largest);
  tcase_add_test(tc, test_reset_gives_back);
  suite_add_tcase(s, tc);
  return s;
}

PH_TEST_MAIN(suite)
