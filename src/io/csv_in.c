/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * CSV rows -> problem (see csv_in.h).
 *
 * The splitter has already cut the file into records of whole rows and has
 * found the meaning of the columns.  Here every row is scanned again for its
 * end, then cell by cell; numbers go straight into the arrays of their fields.
 *
 * Which names columns may have: io/split_columns.c.
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

/* Of results, points so near each other, over their size, are one. */
static const double SAME = 1e-9;

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
  const char *remedy = ph_csv_thousands(cell) && !ph_csv_decimal_comma(cell)
                           ? "; numbers have no thousands separators"
                       : !ph_csv_decimal_comma(cell) ? ""
                       : r->columns->delimiter == ','
                           ? "; numbers have a decimal point"
                           : "; numbers have a decimal point (tr , . turns "
                             "commas into points)";
  char excerpt[PH_EXCERPT_MAX];
  ph_excerpt(cell->text, cell->n, excerpt);
  if (column->segments && r->rows == 0) {
    return ph_fail(r->diag, status, field,
                   "needs a %snumber in column %s, found \"%s\"%s", what,
                   column->name, excerpt, remedy);
  }
  return ph_fail_at(r->diag, status, field, r->rows - column->segments,
                    "needs a %snumber in column %s, found \"%s\"%s", what,
                    column->name, excerpt, remedy);
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

/* The rows of a record, one after another; {.at = 0} begins. */
struct rows {
  size_t at;     /* offset to go on from */
  const char *p; /* the row */
  const char *end;
  double last[4]; /* of results: the point of the row, and 1; 0: none yet */
};

/* Whether a row of results begins a segment where the row before it ended. */
static bool repeats(const struct ph_csv_columns *columns, struct rows *rows) {
  double now[4] = {0, 0, 0, 1}, size = 0, apart = 0;
  bool begins = false;
  const char *p = rows->p;
  for (size_t i = 0; i < columns->n; i++, p++) {
    const struct ph_csv_column *column = &columns->column[i];
    struct ph_csv_cell cell;
    double x;
    p = ph_csv_cell(p, rows->end, columns->delimiter, &cell);
    if (ph_csv_number(cell.text, cell.n, &x)) {
      if (column->field == PH_F_POINTS) {
        now[column->component] = x;
      }
      begins |= i == PH_CSV_WITHIN && !(fabs(x) > 0);
    }
    if (p == rows->end) {
      break;
    }
  }
  for (size_t c = 0; c < 4; c++) {
    apart = fmax(apart, fabs(now[c] - rows->last[c]));
    size = c < 3 ? fmax(size, fabs(now[c])) : size;
    rows->last[c] = now[c];
  }
  return begins && apart <= SAME * size;
}

/* The next row of the record that counts; false at its end. */
static bool next_row(const struct ph_record *record, struct rows *rows) {
  while (rows->at < record->n) {
    struct ph_csv_scan scan = {.at = rows->at};
    enum ph_csv_state state = ph_csv_scan(&scan, record->text, record->n,
                                          record->columns->delimiter, true);
    rows->p = record->text + rows->at;
    rows->at = scan.at;
    rows->end = ph_csv_row_end(rows->p, record->text + scan.at);
    if (state == PH_CSV_ROW &&
        !(record->columns->results && repeats(record->columns, rows))) {
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
  struct rows rows = {.at = 0};
  while (status == PH_OK && next_row(record, &rows)) {
    if (r->rows == 0) {
      status = read_id(r, rows.p, rows.end, echo);
    }
    if (status == PH_OK) {
      status = read_row(r, rows.p, rows.end);
    }
    if (status != PH_OK) {
      r->diag->line = line_at(record, rows.p);
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
  size_t i = 0, row = 0;
  struct rows rows = {.p = record->text};
  if (column && path[name_n]) {
    i = strtoul(path + name_n + 1, NULL, 10) + segments;
  }
  while (row <= i && next_row(record, &rows)) {
    row++;
  }
  return row <= i && segments ? record->line : line_at(record, rows.p);
}
