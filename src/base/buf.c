/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The byte buffer (see buf.h): grows by half its size, checked. */
#include "base/buf.h"

#include "base/mem.h"

#include <stdint.h>
#include <string.h>

enum { FIRST_CAPACITY = 4096 };

char *ph_buf_reserve(struct ph_buf *buf, size_t n) {
  size_t capacity = buf->capacity ? buf->capacity : FIRST_CAPACITY;
  char *data;
  if (buf->failed) {
    return NULL;
  }
  if (buf->data && n <= buf->capacity - buf->n) {
    return buf->data + buf->n;
  }
  if (buf->piece && buf->capacity >= buf->piece && buf->n >= buf->piece / 2) {
    buf->spill(buf->context, buf);
    if (n <= buf->capacity - buf->n) {
      return buf->data + buf->n;
    }
  }
  if (buf->most && buf->n > buf->most) {
    buf->failed = true;
    return NULL;
  }
  while (capacity - buf->n < n) {
    if (capacity > SIZE_MAX / 3 * 2) {
      buf->failed = true;
      return NULL;
    }
    capacity += capacity / 2;
  }
  data = ph_realloc(buf->data, capacity);
  if (!data) {
    buf->failed = true;
    return NULL;
  }
  buf->data = data;
  buf->capacity = capacity;
  return buf->data + buf->n;
}

void ph_buf_put(struct ph_buf *buf, const char *bytes, size_t n) {
  char *to;
  for (const size_t half = buf->piece / 2; half && n > half; n -= half) {
    ph_buf_put(buf, bytes, half);
    bytes += half;
  }
  to = ph_buf_reserve(buf, n);
  if (to && n) {
    memcpy(to, bytes, n);
    buf->n += n;
  }
}

void ph_buf_puts(struct ph_buf *buf, const char *text) {
  ph_buf_put(buf, text, strlen(text));
}

void ph_buf_cut(struct ph_buf *buf, size_t n, size_t keep) {
  const size_t capacity = n + FIRST_CAPACITY > keep ? n + FIRST_CAPACITY : keep;
  char *data =
      buf->capacity > capacity ? ph_realloc(buf->data, capacity) : NULL;
  if (data) {
    buf->data = data;
    buf->capacity = capacity;
  }
  buf->n = n;
  buf->failed = false;
}

void ph_buf_clear(struct ph_buf *buf, size_t keep) {
  if (buf->capacity > keep) {
    ph_buf_free(buf);
  }
  buf->n = 0;
  buf->failed = false;
}

void ph_buf_free(struct ph_buf *buf) {
  ph_free(buf->data);
  *buf = (struct ph_buf){0};
}
