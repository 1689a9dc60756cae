/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The byte buffer: content over many growths, and growth that fails. */
#include "unit.h"

#include "base/buf.h"

#include <string.h>

static struct ph_buf buf;

static void finish(void) {
  ph_buf_free(&buf);
  ck_assert_ptr_null(buf.data);
  ck_assert_uint_eq(buf.n + buf.capacity, 0);
  ck_assert(!buf.failed);
}

PH_TEST(test_append) {
  ph_buf_put(&buf, "ab\0c", 4);
  ph_buf_puts(&buf, "");
  ph_buf_put(&buf, NULL, 0);
  ph_buf_puts(&buf, "def");
  ck_assert_uint_eq(buf.n, 7);
  ck_assert_mem_eq(buf.data, "ab\0cdef", 7);
}

/* One byte at a time and in large pieces: nothing is lost by growing. */
PH_TEST(test_growth) {
  static char large[100000];
  size_t n = 0;
  for (size_t i = 0; i < sizeof large; i++) {
    large[i] = (char)(i % 251);
    ph_buf_put(&buf, &large[i], 1);
  }
  ck_assert_uint_eq(buf.n, sizeof large);
  ck_assert_mem_eq(buf.data, large, sizeof large);
  n = buf.n;
  ph_buf_put(&buf, large, sizeof large);
  ck_assert_uint_eq(buf.n, 2 * n);
  ck_assert_mem_eq(buf.data, large, n);
  ck_assert_mem_eq(buf.data + n, large, n);
  ck_assert_uint_le(buf.n, buf.capacity);
}

/* Reserved room is ours to write into, up to the last byte. */
PH_TEST(test_reserve) {
  for (size_t n = 1; n < 20000; n = 2 * n + 1) {
    char *to = ph_buf_reserve(&buf, n);
    ck_assert_ptr_nonnull(to);
    ck_assert_ptr_eq(to, buf.data + buf.n);
    memset(to, 'x', n);
    buf.n += n;
  }
  for (size_t i = 0; i < buf.n; i++) {
    ck_assert_int_eq(buf.data[i], 'x');
  }
}

/* Too much to ask for is remembered; what follows does nothing. */
PH_TEST(test_failure) {
  ph_buf_puts(&buf, "before");
  ck_assert_ptr_null(ph_buf_reserve(&buf, SIZE_MAX - 10));
  ck_assert(buf.failed);
  ph_buf_puts(&buf, "after");
  ck_assert_ptr_null(ph_buf_reserve(&buf, 1));
  ck_assert_uint_eq(buf.n, 6);
  ck_assert_mem_eq(buf.data, "before", 6);
  ph_buf_clear(&buf, SIZE_MAX);
  ck_assert(!buf.failed);
  ph_buf_puts(&buf, "again");
  ck_assert_mem_eq(buf.data, "again", 5);
}

PH_TEST(test_clear) {
  size_t capacity;
  ph_buf_puts(&buf, "some");
  capacity = buf.capacity;
  ph_buf_clear(&buf, capacity);
  ck_assert_uint_eq(buf.n, 0);
  ck_assert_uint_eq(buf.capacity, capacity);
  ph_buf_puts(&buf, "more");
  ph_buf_clear(&buf, capacity - 1);
  ck_assert_uint_eq(buf.n, 0);
  ck_assert_uint_eq(buf.capacity, 0);
  ck_assert_ptr_null(buf.data);
}

/* What has left a buffer, and how often; it may leave when it is let go. */
static char gone[1 << 16];
static size_t gone_n, times;
static bool let_go;

static void spill(void *context, struct ph_buf *from) {
  ck_assert_ptr_eq(context, &times);
  if (let_go) {
    ck_assert_uint_le(from->n, sizeof gone - gone_n);
    memcpy(gone + gone_n, from->data, from->n);
    gone_n += from->n;
    from->n = 0;
  }
  times++;
}

PH_TEST(test_spill) {
  enum { PIECE = 8192 };
  static char text[50000];
  size_t capacity;
  for (size_t i = 0; i < sizeof text; i++) {
    text[i] = (char)('a' + i % 23);
  }
  gone_n = times = 0;
  buf = (struct ph_buf){.piece = PIECE, .spill = spill, .context = &times};
  let_go = false; /* it grows, and asks each time */
  ph_buf_put(&buf, text, 20000);
  ck_assert_uint_eq(buf.n, 20000);
  ck_assert_uint_gt(times, 0);
  let_go = true; /* no growth, however long */
  capacity = buf.capacity;
  ph_buf_put(&buf, text + 20000, 29000);
  for (size_t i = 49000; i < sizeof text; i++) {
    ph_buf_put(&buf, &text[i], 1);
  }
  ck_assert_uint_eq(buf.capacity, capacity);
  ck_assert(!buf.failed);
  memcpy(gone + gone_n, buf.data, buf.n);
  ck_assert_uint_eq(gone_n + buf.n, sizeof text);
  ck_assert_mem_eq(gone, text, sizeof text);
}

PH_FIXTURE(NULL, finish)
