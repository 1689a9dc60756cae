/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Writes JSON (see json_write.h). */
#include "io/json_write.h"

#include "io/json_text.h"
#include "io/number.h"

#include <math.h>

#include <string.h>

/* So many numbers of an array are written in one piece. */
enum { TOGETHER = 4096 };

void ph_write_put(struct ph_json_writer *w, char c) {
  char *to = ph_buf_reserve(w->buf, 1);
  if (to) {
    *to = c;
    w->buf->n++;
  }
}

static void new_line(struct ph_json_writer *w) {
  if (w->pretty) {
    ph_write_put(w, '\n');
    for (size_t i = 0; i < w->depth; i++) {
      ph_buf_put(w->buf, "  ", 2);
    }
  }
}

void ph_write_element(struct ph_json_writer *w) {
  if (w->comma[w->depth]) {
    ph_write_put(w, ',');
  }
  w->comma[w->depth] = true;
  if (w->depth > 0) {
    new_line(w);
  }
}

void ph_write_begin(struct ph_json_writer *w, char bracket) {
  ph_write_put(w, bracket);
  w->depth++;
  w->comma[w->depth] = false;
}

void ph_write_end(struct ph_json_writer *w, char bracket) {
  bool empty = !w->comma[w->depth];
  w->depth--;
  if (!empty) {
    new_line(w);
  }
  ph_write_put(w, bracket);
}

void ph_write_string(struct ph_json_writer *w, const char *text) {
  size_t n = strlen(text);
  char *to = ph_buf_reserve(w->buf, PH_JSON_QUOTED_MAX(n));
  if (to) {
    w->buf->n += ph_json_quote(to, text, n);
  }
}

void ph_write_key(struct ph_json_writer *w, const char *name) {
  size_t n = strlen(name);
  char *to;
  ph_write_element(w);
  to = ph_buf_reserve(w->buf, n + 4);
  if (to) {
    *to++ = '"';
    memcpy(to, name, n);
    memcpy(to + n, "\": ", 3);
    w->buf->n += n + (w->pretty ? 4 : 3);
  }
}

void ph_write_number(struct ph_json_writer *w, double x) {
  char *to = ph_buf_reserve(w->buf, PH_NUMBER_MAX);
  if (to) {
    w->buf->n += ph_number_write(to, x);
  }
}

/* In one piece; the bulk of all output passes through here. */
void ph_write_open(struct ph_json_writer *w, const double *v, size_t n) {
  size_t finite = 0;
  for (size_t i = 0; i < n; i++) {
    finite += isfinite(v[i]) != 0;
  }
  if (finite == 0) {
    ph_buf_puts(w->buf, "null");
    return;
  }
  for (size_t i = 0; i < n; i++) {
    ph_write_put(w, i > 0 ? ',' : '[');
    if (isfinite(v[i])) {
      ph_write_number(w, v[i]);
    } else {
      ph_buf_puts(w->buf, "null");
    }
  }
  ph_write_put(w, ']');
}

void ph_write_numbers(struct ph_json_writer *w, const double *v, size_t n) {
  char mark = '[';
  do {
    const size_t now = n < TOGETHER ? n : TOGETHER;
    char *to = ph_buf_reserve(w->buf, now * (PH_NUMBER_MAX + 1) + 2);
    char *start = to;
    if (!to) {
      return;
    }
    for (size_t i = 0; i < now; i++) {
      *to++ = mark;
      to += ph_number_write(to, *v++);
      mark = ',';
    }
    n -= now;
    if (mark == '[') {
      *to++ = mark;
    }
    if (n == 0) {
      *to++ = ']';
    }
    w->buf->n += (size_t)(to - start);
  } while (n > 0);
}

void ph_write_vectors(struct ph_json_writer *w, const double *v, size_t n,
                      size_t dimension) {
  ph_write_begin(w, '[');
  for (size_t i = 0; i < n; i++) {
    ph_write_element(w);
    ph_write_numbers(w, v + i * dimension, dimension);
  }
  ph_write_end(w, ']');
}

void ph_write_key_string(struct ph_json_writer *w, const char *name,
                         const char *text) {
  ph_write_key(w, name);
  ph_write_string(w, text);
}

void ph_write_key_number(struct ph_json_writer *w, const char *name, double x) {
  ph_write_key(w, name);
  ph_write_number(w, x);
}

void ph_write_key_raw(struct ph_json_writer *w, const char *name,
                      const char *json, size_t n) {
  if (json) {
    ph_write_key(w, name);
    ph_buf_put(w->buf, json, n);
  }
}

void ph_write_flag(struct ph_json_writer *w, bool flag) {
  ph_buf_puts(w->buf, flag ? "true" : "false");
}
