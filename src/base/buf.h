/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A growable byte buffer: the only thing that writers write to.
 *
 * A failed growth, or one that is not allowed (most), is remembered in `failed`
 * and makes every later append a no-op, so that a writer checks once, at its
 * end.
 *
 * A buffer whose text may leave before it is whole spills: instead of growing
 * beyond `piece` bytes it asks spill() to take its bytes away, and grows only
 * as long as that leaves them.  Once it has spilled, nothing fails for memory
 * that reserves half a piece at most.
 */
#ifndef PH_BASE_BUF_H
#define PH_BASE_BUF_H

#include <stdatomic.h>
#include <stdbool.h>
#include <stddef.h>

/* {0} is an empty buffer. */
struct ph_buf {
  char *data;
  size_t n;        /* bytes used */
  size_t capacity; /* bytes owned */
  bool failed;     /* memory ran out: the content is incomplete */
  size_t most;     /* it grows no more when n is above; 0: any number */
  size_t piece;    /* 0: it does not spill */
  /* takes all its bytes and sets n to 0, or leaves them for now */
  void (*spill)(void *context, struct ph_buf *buf);
  void *context;
  atomic_int *spare; /* threads for what is long (relay.h), or NULL */
};

/* ph_buf_reserve: room for n more bytes; NULL when memory is exhausted.  The
 * caller writes at the returned pointer and adds to buf->n what it wrote. */
char *ph_buf_reserve(struct ph_buf *buf, size_t n);

/* ph_buf_put: appends n bytes. */
void ph_buf_put(struct ph_buf *buf, const char *bytes, size_t n);

/* ph_buf_puts: appends a NUL-terminated text. */
void ph_buf_puts(struct ph_buf *buf, const char *text);

/* ph_buf_cut: forgets what follows the first n bytes, and a failure; memory
 * beyond `keep` bytes that these do not need is given back. */
void ph_buf_cut(struct ph_buf *buf, size_t n, size_t keep);

/* ph_buf_clear: forgets the content and, if it grew beyond `keep` bytes, the
 * memory too. */
void ph_buf_clear(struct ph_buf *buf, size_t keep);

/* ph_buf_free: gives the memory back; the buffer is empty again. */
void ph_buf_free(struct ph_buf *buf);

#endif
