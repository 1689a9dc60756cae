/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Rows of tables (see csv_cell.h). */
#include "io/csv_cell.h"

#include "io/number.h"

#include <math.h>
#include <string.h>

struct ph_csv_row ph_csv_row_of(struct ph_buf *buf,
                                const struct ph_csv_shape *shape,
                                const struct ph_csv_heading *heading) {
  return (struct ph_csv_row){buf, shape, heading, shape->text ? ' ' : ','};
}

void ph_csv_between(const struct ph_csv_row *row) {
  ph_buf_put(row->buf, &row->between, 1);
}

/* A word for gnuplot and awk: no blanks, none empty. */
static void word_cell(const struct ph_csv_row *row, const char *text,
                      size_t n) {
  for (size_t i = 0; i < n; i++) {
    bool apart = (unsigned char)text[i] <= ' ' || text[i] == '"' ||
                 (i == 0 && text[i] == '#');
    ph_buf_put(row->buf, apart ? "_" : text + i, 1);
  }
  ph_buf_put(row->buf, "-", n == 0);
}

static bool is_blank(char c) {
  return c == ' ' || c == '\t';
}

void ph_csv_text_cell(const struct ph_csv_row *row, const char *text,
                      size_t n) {
  /* a # begins a comment in the first cell, blanks at both ends are dropped */
  bool quoted =
      n > 0 && (text[0] == '#' || is_blank(text[0]) || is_blank(text[n - 1]));
  if (row->shape->text) {
    word_cell(row, text, n);
    return;
  }
  for (size_t i = 0; i < n; i++) {
    quoted |= memchr(",\"\r\n", text[i], 4) != NULL;
  }
  if (!quoted) {
    ph_buf_put(row->buf, text, n);
    return;
  }
  ph_buf_put(row->buf, "\"", 1);
  for (size_t i = 0; i < n; i++) {
    ph_buf_put(row->buf, "\"", text[i] == '"');
    ph_buf_put(row->buf, text + i, 1);
  }
  ph_buf_put(row->buf, "\"", 1);
}

/* A JSON value; of a string, which holds no escapes, what it stands for. */
static void json_cell(const struct ph_csv_row *row, const char *json) {
  size_t n = strlen(json);
  size_t quote = *json == '"';
  ph_csv_text_cell(row, json + quote, n - 2 * quote);
}

/* Numbers as they are in memory. */
static void double_cells(const struct ph_csv_row *row, const double *v,
                         size_t n) {
  char *to = ph_buf_reserve(row->buf, n * sizeof *v);
  if (to) {
    memcpy(to, v, n * sizeof *v);
    row->buf->n += n * sizeof *v;
  }
}

void ph_csv_number_cell(const struct ph_csv_row *row, double x) {
  char *to;
  if (row->shape->binary) {
    double_cells(row, &x, 1);
    return;
  }
  to = ph_buf_reserve(row->buf, PH_NUMBER_MAX + 1);
  if (to) {
    *to = row->between;
    row->buf->n += 1 + (isfinite(x) ? ph_number_write(to + 1, x) : 0);
  }
  if (!isfinite(x) && row->shape->text) {
    ph_buf_puts(row->buf, "NaN");
  }
}

void ph_csv_number_cells(const struct ph_csv_row *row, const double *v,
                         size_t n) {
  if (row->shape->binary) {
    double_cells(row, v, n);
    return;
  }
  for (size_t i = 0; i < n; i++) {
    ph_csv_number_cell(row, v[i]);
  }
}

void ph_csv_begin_row(const struct ph_csv_row *row) {
  if (row->shape->binary) {
    ph_csv_number_cell(row, (double)row->heading->number);
    return;
  }
  ph_csv_text_cell(row, row->heading->id, strlen(row->heading->id));
}

void ph_csv_end_row(const struct ph_csv_row *row) {
  if (row->shape->binary) {
    return;
  }
  for (size_t i = 0; i < row->heading->swept_n; i++) {
    ph_csv_between(row);
    json_cell(row, row->heading->swept[i].value);
  }
  if (row->shape->file) {
    ph_csv_between(row);
    ph_csv_text_cell(row, row->heading->file, strlen(row->heading->file));
  }
  ph_buf_put(row->buf, "\n", 1);
}

void ph_csv_end_curve(const struct ph_csv_row *row) {
  ph_buf_put(row->buf, "\n", row->shape->text);
}
