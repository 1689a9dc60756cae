/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The head of an NPY file (see npy_out.h). */
#include "io/npy_out.h"

#include <stdio.h>
#include <string.h>

/* Rows begin at a multiple of this; bytes before the text of the head. */
enum { ALIGN = 64, PRELUDE = 10 };

/* How doubles lie in memory. */
static char byte_order(void) {
  const unsigned one = 1;
  char first;
  memcpy(&first, &one, 1);
  return first ? '<' : '>';
}

/* The names of the columns as a list of pairs; ret how many */
static size_t put_columns(struct ph_buf *buf, const char *names,
                          const char *end) {
  size_t columns = 0;
  for (const char *p = names; p < end; columns++) {
    const char *comma = memchr(p, ',', (size_t)(end - p));
    const size_t n = (size_t)((comma ? comma : end) - p);
    char cell[64];
    snprintf(cell, sizeof cell, "%s('%.*s', '%cf8')", columns ? ", " : "",
             columns ? (int)n : 6, columns ? p : "result", byte_order());
    ph_buf_puts(buf, cell);
    p += n + 1;
  }
  return columns;
}

void ph_npy_header(struct ph_buf *buf, const struct ph_csv_shape *shape,
                   size_t bytes) {
  static const char magic[] = "\x93NUMPY\1";
  struct ph_csv_shape as_text = *shape;
  struct ph_buf names = {0}, text = {0};
  char rows[96];
  size_t n;
  as_text.binary = false;
  ph_csv_header(&names, &as_text, NULL, 0);
  ph_buf_puts(&text, "{'descr': [");
  n = put_columns(&text, names.data, names.data + (names.n ? names.n - 1 : 0));
  snprintf(rows, sizeof rows, "], 'fortran_order': False, 'shape': (%20zu,), }",
           n ? bytes / (n * sizeof(double)) : 0);
  ph_buf_puts(&text, rows);
  while ((PRELUDE + text.n + 1) % ALIGN != 0 && !text.failed) {
    ph_buf_put(&text, " ", 1);
  }
  ph_buf_put(&text, "\n", 1);
  n = text.n;
  ph_buf_put(buf, magic, sizeof magic);
  ph_buf_put(buf, (const char[]){(char)(n & 255), (char)(n >> 8)}, 2);
  ph_buf_put(buf, text.data, n);
  buf->failed |= names.failed || text.failed;
  ph_buf_free(&names);
  ph_buf_free(&text);
}
