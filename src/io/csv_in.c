/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * CSV rows -> problem (see csv_in.h).
 *
 * The splitter has already cut the file into records of whole rows and has
 * found the meaning of the columns.  Here every row is scanned again for its
 * end, then cell by cell; numbers go straight into the arrays of their fields.
 *
 * Reference: RFC 4180.  Which names columns may have: io/split_csv.c.
 */
#include "io/csv_in.h"

#include "base/suggest.h"
#include "io/json_text.h"
#include "io/number.h"
#include "io/value.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- rows ----------------------------------------------------------- */

enum row_state {
  ROW_START,
  CELL_START, /* only blanks since the delimiter */
  PLAIN,
  QUOTED,
  QUOTE, /* a quote in a quoted cell: its end, or half of a doubled one */
  AFTER_QUOTED,
  COMMENT
};

static bool is_blank(char c, char delimiter) {
  return (c == ' ' || c == '\t' || c == '\r') && c != delimiter;
}

/* The state after c, which is no line break, outside of quoted text and
 * comments; -1: c cannot follow a quoted cell. */
static int next_state(int state, char c, char delimiter) {
  if (c == delimiter) {
    return CELL_START;
  }
  switch (state) {
  case ROW_START:
    if (c == '#') {
      return COMMENT;
    }
    /* fall through */
  case CELL_START:
    return c == '"' ? QUOTED : is_blank(c, delimiter) ? CELL_START : PLAIN;
  case QUOTE:
  case AFTER_QUOTED:
    return is_blank(c, delimiter)       ? AFTER_QUOTED
           : c == '"' && state == QUOTE ? QUOTED
                                        : -1;
  default:
    return PLAIN;
  }
}

/* Text at p follows a quoted cell. */
static enum ph_csv_state after_quoted(struct ph_csv_scan *scan, const char *p,
                                      const char *end, char delimiter,
                                      bool last) {
  int n = ph_utf8_length(p, end);
  char found[PH_EXCERPT_MAX];
  char separator[PH_EXCERPT_MAX];
  if (n < 0 && !last) {
    return PH_CSV_MORE;
  }
  snprintf(scan->message, sizeof scan->message,
           "expected '%s' or the end of the row after a quoted cell, "
           "found '%s'",
           ph_excerpt(&delimiter, 1, separator),
           ph_excerpt(p, n > 0 ? (size_t)n : 1, found));
  return PH_CSV_ERROR;
}

static enum ph_csv_state finish_row(const struct ph_csv_scan *scan) {
  bool blank = scan->state <= CELL_START && !scan->delimiters;
  return scan->state == COMMENT ? PH_CSV_COMMENT
         : blank                ? PH_CSV_BLANK
                                : PH_CSV_ROW;
}

/* The first of the bytes from `at` on that ends the line or is `stop`. */
static size_t skip(const char *text, size_t at, size_t n, char stop) {
  while (at < n && text[at] != '\n' && text[at] != stop) {
    at++;
  }
  return at;
}

enum ph_csv_state ph_csv_scan(struct ph_csv_scan *scan, const char *text,
                              size_t n, char delimiter, bool last) {
  for (; scan->at < n; scan->at++) {
    char c = text[scan->at];
    int next;
    if (scan->state == QUOTED) {
      scan->state = c == '"' ? QUOTE : QUOTED;
      continue;
    }
    if (scan->state == PLAIN || scan->state == COMMENT) {
      char stop = scan->state == PLAIN ? delimiter : '\n';
      scan->at = skip(text, scan->at, n, stop);
      if (scan->at == n) {
        break;
      }
      c = text[scan->at];
    }
    if (c == '\n') {
      scan->at++;
      return finish_row(scan);
    }
    next = next_state(scan->state, c, delimiter);
    if (next < 0) {
      return after_quoted(scan, text + scan->at, text + n, delimiter, last);
    }
    scan->delimiters |= c == delimiter;
    if (next == QUOTED && scan->state <= CELL_START) {
      scan->quote = scan->at;
    }
    scan->state = (unsigned char)next;
  }
  if (!last) {
    return PH_CSV_MORE;
  }
  if (scan->state == QUOTED) {
    scan->at = scan->quote;
    snprintf(scan->message, sizeof scan->message,
             "the quote that begins this cell is never closed");
    return PH_CSV_ERROR;
  }
  return finish_row(scan);
}

const char *ph_csv_row_end(const char *p, const char *end) {
  if (end > p && end[-1] == '\n') {
    end--;
  }
  if (end > p && end[-1] == '\r') {
    end--;
  }
  return end;
}

const char *ph_csv_cell(const char *p, const char *end, char delimiter,
                        struct ph_csv_cell *cell) {
  const char *cell_end;
  while (p < end && is_blank(*p, delimiter)) {
    p++;
  }
  cell->quoted = p < end && *p == '"';
  if (cell->quoted) {
    cell->text = ++p;
    while (p < end && (*p != '"' || (p + 1 < end && p[1] == '"'))) {
      p += *p == '"' ? 2 : 1;
    }
    cell->n = (size_t)(p - cell->text);
  }
  cell_end = p < end ? memchr(p, delimiter, (size_t)(end - p)) : NULL;
  cell_end = cell_end ? cell_end : end;
  if (!cell->quoted) {
    const char *text_end = cell_end;
    while (text_end > p && is_blank(text_end[-1], delimiter)) {
      text_end--;
    }
    cell->text = p;
    cell->n = (size_t)(text_end - p);
  }
  return cell_end;
}

size_t ph_csv_content(const struct ph_csv_cell *cell, char *out) {
  size_t n = 0;
  for (size_t i = 0; i < cell->n; i++) {
    out[n++] = cell->text[i];
    i += cell->quoted && cell->text[i] == '"';
  }
  return n;
}

bool ph_csv_number(const char *text, size_t n, double *x) {
  bool negative = n > 0 && *text == '-';
  bool sign = n > 0 && (*text == '-' || *text == '+');
  const char *after = ph_number_read_text(text, text + n, x);
  if (after) {
    return after == text + n;
  }
  if (ph_word_is(text + sign, n - sign, "nan")) {
    *x = (double)NAN;
    return true;
  }
  *x = negative ? -HUGE_VAL : HUGE_VAL;
  return ph_word_is(text + sign, n - sign, "inf") ||
         ph_word_is(text + sign, n - sign, "infinity");
}

/* ---- fields --------------------------------------------------------- */

/* The array of a field as its columns fill it. */
struct series {
  double *v;            /* v[rows][dimension], NULL: the field has no columns */
  size_t dimension;     /* of the columns */
  size_t filled[3];     /* rows that have the component */
  size_t first_gap[3];  /* the first row that has not, if there is one */
  const char *names[3]; /* of the columns */
};

/* A record being read. */
struct reader {
  const struct ph_record *record;
  const struct ph_csv_columns *columns;
  struct ph_arena *arena;
  struct ph_diag *diag;
  struct series series[PH_FIELD_N];
  size_t rows; /* read so far */
};

/* The line of the byte at p. */
static size_t line_at(const struct ph_record *record, const char *p) {
  size_t line = record->line;
  for (const char *q = record->text; q < p; q++) {
    line += *q == '\n';
  }
  return line;
}

static enum ph_status prepare(struct reader *r) {
  size_t rows_max = 1;
  for (size_t i = 0; i < r->record->n; i++) {
    rows_max += r->record->text[i] == '\n';
  }
  for (size_t i = 0; i < r->columns->n; i++) {
    const struct ph_csv_column *column = &r->columns->column[i];
    if (column->field < PH_FIELD_N) {
      struct series *series = &r->series[column->field];
      series->names[column->component] = column->name;
      if (series->dimension <= column->component) {
        series->dimension = column->component + 1;
      }
    }
  }
  for (size_t i = 0; i < PH_FIELD_N; i++) {
    struct series *series = &r->series[i];
    if (series->dimension > 0) {
      series->v = ph_arena_array(r->arena, rows_max,
                                 series->dimension * sizeof *series->v);
      if (!series->v) {
        return ph_fail_memory(r->diag);
      }
    }
  }
  return PH_OK;
}

/* The element that a bad cell of the current row is: of the numbers of segments
 * row i + 1 has element i, and which one the first row has shows at the end. */
static enum ph_status bad_cell(struct reader *r, enum ph_status status,
                               const struct ph_csv_column *column,
                               const struct ph_csv_cell *cell) {
  const char *field = ph_field_name((enum ph_field_id)column->field);
  const char *what = status == PH_E_NOT_FINITE ? "finite " : "";
  char excerpt[PH_EXCERPT_MAX];
  ph_excerpt(cell->text, cell->n, excerpt);
  if (column->segments && r->rows == 0) {
    return ph_fail(r->diag, status, field,
                   "needs a %snumber in column %s, found \"%s\"", what,
                   column->name, excerpt);
  }
  return ph_fail_at(r->diag, status, field, r->rows - column->segments,
                    "needs a %snumber in column %s, found \"%s\"", what,
                    column->name, excerpt);
}

static enum ph_status read_number(struct reader *r,
                                  const struct ph_csv_column *column,
                                  const struct ph_csv_cell *cell) {
  struct series *series = &r->series[column->field];
  size_t c = column->component;
  double *x = &series->v[r->rows * series->dimension + c];
  if (cell->n == 0) {
    if (series->filled[c] == r->rows) {
      series->first_gap[c] = r->rows;
    }
    return PH_OK;
  }
  if (!ph_csv_number(cell->text, cell->n, x)) {
    return bad_cell(r, PH_E_BAD_TYPE, column, cell);
  }
  if (!isfinite(*x)) {
    return bad_cell(r, PH_E_NOT_FINITE, column, cell);
  }
  series->filled[c]++;
  return PH_OK;
}

/* A row that has not one cell for each column says no more than that. */
static enum ph_status read_row(struct reader *r, const char *p,
                               const char *end) {
  enum ph_status status = PH_OK;
  size_t n = 0;
  for (;; p++) {
    struct ph_csv_cell cell;
    p = ph_csv_cell(p, end, r->columns->delimiter, &cell);
    if (status == PH_OK && n < r->columns->n &&
        r->columns->column[n].field < PH_FIELD_N) {
      status = read_number(r, &r->columns->column[n], &cell);
    }
    n++;
    if (p == end) {
      break;
    }
  }
  if (n != r->columns->n) {
    status = ph_fail(r->diag, PH_E_BAD_SHAPE, NULL,
                     "the row has %zu cells, expected %zu", n, r->columns->n);
  }
  r->rows++;
  return status;
}

/* ---- the id --------------------------------------------------------- */

static enum ph_status echo_id(struct reader *r, const struct ph_csv_cell *cell,
                              struct ph_echo *echo) {
  char *text = ph_arena_array(r->arena, cell->n, 1);
  char *json = ph_arena_array(r->arena, PH_JSON_QUOTED_MAX(cell->n), 1);
  double x;
  size_t n;
  if (!text || !json) {
    return ph_fail_memory(r->diag);
  }
  n = ph_csv_content(cell, text);
  for (size_t i = 0; i < n;) {
    int length = ph_utf8_length(text + i, text + n);
    if (length <= 0) {
      return ph_fail(r->diag, PH_E_SYNTAX, "id",
                     "has the byte \\x%02x, which is not UTF-8",
                     (unsigned char)text[i]);
    }
    i += (size_t)length;
  }
  if (n > 0 && ph_number_read(text, text + n, &x) == text + n && isfinite(x)) {
    echo->id = text;
    echo->id_n = n;
  } else if (n > 0) {
    echo->id = json;
    echo->id_n = ph_json_quote(json, text, n);
  }
  return PH_OK;
}

/* The id of the record is that of its first row, [p,end). */
static enum ph_status read_id(struct reader *r, const char *p, const char *end,
                              struct ph_echo *echo) {
  for (size_t i = 0; i < r->columns->n; i++, p++) {
    struct ph_csv_cell cell;
    p = ph_csv_cell(p, end, r->columns->delimiter, &cell);
    if (r->columns->column[i].field == PH_CSV_ID) {
      return echo_id(r, &cell, echo);
    }
    if (p == end) {
      break;
    }
  }
  return PH_OK;
}

/* ---- the record ----------------------------------------------------- */

/* The next row of cells of the record; false at its end.  `at` is the offset
 * to go on from. */
static bool next_row(const struct ph_record *record, size_t *at, const char **p,
                     const char **end) {
  while (*at < record->n) {
    struct ph_csv_scan scan = {.at = *at};
    enum ph_csv_state state = ph_csv_scan(&scan, record->text, record->n,
                                          record->columns->delimiter, true);
    *p = record->text + *at;
    *at = scan.at;
    *end = ph_csv_row_end(*p, record->text + scan.at);
    if (state == PH_CSV_ROW) {
      return true;
    }
    if (state == PH_CSV_ERROR) {
      return false; /* not in a record whose status is PH_OK */
    }
  }
  return false;
}

static enum ph_status read_rows(struct reader *r, struct ph_echo *echo) {
  const struct ph_record *record = r->record;
  enum ph_status status = PH_OK;
  const char *p;
  const char *end;
  size_t at = 0;
  while (status == PH_OK && next_row(record, &at, &p, &end)) {
    if (r->rows == 0) {
      status = read_id(r, p, end, echo);
    }
    if (status == PH_OK) {
      status = read_row(r, p, end);
    }
    if (status != PH_OK) {
      r->diag->line = line_at(record, p);
    }
  }
  return status;
}

/* The first empty cell of a column that has to be full. */
static enum ph_status gap(struct reader *r, const struct ph_field *row,
                          size_t component) {
  const struct series *series = &r->series[row->id];
  size_t i = series->first_gap[component];
  char path[PH_DIAG_FIELD_MAX];
  ph_fail_at(r->diag, PH_E_BAD_VALUE, ph_field_name(row->id), i,
             "needs a number in column %s, found an empty cell",
             series->names[component]);
  memcpy(path, r->diag->field, sizeof path);
  r->diag->line = ph_csv_line(r->record, path);
  return PH_E_BAD_VALUE;
}

/* A number for each segment, in the row in which the segment ends: the first
 * row has none, or that of the segment which closes the curve. */
static enum ph_status finish_segments(struct reader *r,
                                      const struct ph_field *row,
                                      struct ph_value *value) {
  struct series *series = &r->series[row->id];
  bool closes = series->filled[0] == r->rows;
  double first = series->v[0];
  if (!closes &&
      (series->filled[0] + 1 < r->rows || series->first_gap[0] > 0)) {
    return ph_fail(r->diag, PH_E_BAD_VALUE, ph_field_name(row->id),
                   "needs a number in column %s of every row but the first",
                   series->names[0]);
  }
  memmove(series->v, series->v + 1, (r->rows - 1) * sizeof *series->v);
  series->v[r->rows - 1] = first;
  value->kind = PH_NUMBERS;
  value->v = series->v;
  value->n = closes ? r->rows : r->rows - 1;
  value->dimension = 1;
  return PH_OK;
}

/* The value of a field from its columns, without empty ones at their end. */
static enum ph_status finish(struct reader *r, const struct ph_field *row,
                             struct ph_value *value) {
  const struct series *series = &r->series[row->id];
  size_t d = series->dimension;
  while (d > 0 && series->filled[d - 1] == 0) {
    d--;
  }
  if (d == 0) {
    return PH_OK;
  }
  if (row->kinds & PH_SEGMENTS) {
    return finish_segments(r, row, value);
  }
  if (series->dimension > 1 && !(row->dimensions >> d & 1)) {
    return gap(r, row, d < 2 ? 1 : d);
  }
  for (size_t c = 0; c < d; c++) {
    if (series->filled[c] < r->rows) {
      return gap(r, row, c);
    }
  }
  for (size_t i = 1; d < series->dimension && i < r->rows; i++) {
    memmove(series->v + i * d, series->v + i * series->dimension,
            d * sizeof *series->v);
  }
  value->kind = series->dimension > 1 ? PH_VECTORS : PH_NUMBERS;
  value->v = series->v;
  value->n = r->rows;
  value->dimension = d;
  return PH_OK;
}

enum ph_status ph_csv_in(const struct ph_record *record,
                         const struct ph_schema *schema, struct ph_arena *arena,
                         struct ph_problem *problem, struct ph_echo *echo,
                         struct ph_diag *diag) {
  struct reader r = {record, record->columns, arena, diag, {{0}}, 0};
  enum ph_status status;
  *problem = (struct ph_problem){0};
  *echo = (struct ph_echo){0};
  status = prepare(&r);
  if (status == PH_OK) {
    status = read_rows(&r, echo);
  }
  for (size_t i = 0; status == PH_OK && i < schema->fields_n; i++) {
    const struct ph_field *row = &schema->fields[i];
    status = finish(&r, row, &problem->field[row->id]);
  }
  return status;
}

/* A column that belongs to the field of that name, or NULL. */
static const struct ph_csv_column *
column_of(const struct ph_csv_columns *columns, const char *name, size_t n) {
  for (size_t i = 0; i < columns->n; i++) {
    int field = columns->column[i].field;
    const char *is =
        field < PH_FIELD_N ? ph_field_name((enum ph_field_id)field) : "";
    if (strlen(is) == n && memcmp(is, name, n) == 0) {
      return &columns->column[i];
    }
  }
  return NULL;
}

size_t ph_csv_line(const struct ph_record *record, const char *path) {
  size_t name_n = strcspn(path, "[");
  const struct ph_csv_column *column = column_of(record->columns, path, name_n);
  bool segments = column && column->segments;
  size_t i = 0, row = 0, at = 0;
  const char *p = record->text;
  const char *end;
  if (column && path[name_n]) {
    i = strtoul(path + name_n + 1, NULL, 10) + segments;
  }
  while (row <= i && next_row(record, &at, &p, &end)) {
    row++;
  }
  return row <= i && segments ? record->line : line_at(record, p);
}
