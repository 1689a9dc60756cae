/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Text by several threads: the same as by one, whatever leaves it early. */
#include "base/relay.h"

#include "unit.h"

#include <stdio.h>
#include <string.h>

enum { N = 20 * PH_RELAY_WORTH + 77, PIECE = 600 << 10, THREADS = 5 };

static struct ph_buf one, many, gone;

static void finish(void) {
  ph_buf_free(&one);
  ph_buf_free(&many);
  ph_buf_free(&gone);
}

/* Lines of many lengths; one in 5000 is longer than what a thread holds. */
static void write_lines(void *context, struct ph_buf *to, size_t first,
                        size_t end) {
  ck_assert_uint_lt(first, end);
  ck_assert_uint_le(end, N);
  for (size_t i = first; i < end; i++) {
    char line[64];
    int n = snprintf(line, sizeof line, "%s %zu\n", (const char *)context, i);
    for (size_t k = 0; k < (i % 5000 == 7 ? 40000 : i % 7); k++) {
      ph_buf_put(to, line, (size_t)n);
    }
  }
}

static void keep(void *context, struct ph_buf *buf) {
  ck_assert_ptr_eq(context, &gone);
  ph_buf_put(&gone, buf->data, buf->n);
  buf->n = 0;
}

static void same(const struct ph_buf *a, const struct ph_buf *b) {
  ck_assert(!a->failed && !b->failed);
  ck_assert_uint_eq(a->n, b->n);
  ck_assert(memcmp(a->data, b->data, a->n) == 0);
}

PH_TEST(test_threads) {
  static char context[] = "line";
  ph_relay(&one, N, write_lines, context);
  for (int threads = 1; threads <= THREADS; threads += 2) {
    atomic_int spare;
    atomic_init(&spare, threads - 1);
    ph_buf_clear(&many, SIZE_MAX);
    many.spare = &spare;
    ph_relay(&many, N, write_lines, context);
    same(&one, &many);
    ck_assert_int_eq(atomic_load(&spare), threads - 1);
    ph_buf_free(&many);
    ph_buf_clear(&gone, SIZE_MAX);
    many = (struct ph_buf){
        .piece = PIECE, .spill = keep, .context = &gone, .spare = &spare};
    ph_relay(&many, N, write_lines, context);
    ck_assert_uint_lt(many.capacity, 2 * PIECE);
    ph_buf_put(&gone, many.data, many.n);
    same(&one, &gone);
    ph_buf_free(&many);
  }
}

PH_TEST(test_nothing) {
  static char context[] = "never";
  ph_relay(&one, 1, write_lines, context);
  ck_assert_uint_eq(one.n, 0);
}

PH_FIXTURE(NULL, finish)
