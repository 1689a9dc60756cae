/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * CSV: rows and cells, what the columns of a file mean, and a record of rows
 * as a problem.
 */
#ifndef PH_IO_CSV_IN_H
#define PH_IO_CSV_IN_H

#include "base/mem.h"
#include "io/record.h"

#include <stdbool.h>
#include <stddef.h>

/* ---- rows and cells ------------------------------------------------- */

/* What delimits cells, other than a character between any two of them. */
enum {
  PH_CSV_ANY = '\0', /* not known yet: whatever may; only scans have it */
  PH_CSV_WORDS = ' ' /* any number of blanks and tabs; a row may begin and end
                        with some */
};

enum ph_csv_state {
  PH_CSV_ROW,     /* a row of cells */
  PH_CSV_BLANK,   /* a line of nothing but blanks */
  PH_CSV_COMMENT, /* a line that begins with # */
  PH_CSV_MORE,    /* the text ends inside the row */
  PH_CSV_ERROR    /* no CSV: at is the offending byte, message says why */
};

enum { PH_CSV_MESSAGE_MAX = 128 };

/* The scan of one row, which can be interrupted; {.at = n} begins one. */
struct ph_csv_scan {
  size_t at;           /* offset of the next byte to look at */
  size_t quote;        /* offset of the quote that opened the cell */
  unsigned char state; /* of the scan */
  bool filled;         /* the row has cells, or delimiters */
  char message[PH_CSV_MESSAGE_MAX];
};

/*
 * ph_csv_scan: goes on with the scan of one row (RFC 4180) in text[n].
 *
 * in   last  nothing will follow the n bytes
 * ret  on ROW, BLANK and COMMENT, scan->at is the first byte of the next row
 *
 * Cells may be quoted, with blanks around the quotes; a quote inside a cell
 * that does not begin with one is an ordinary character.  Every byte is looked
 * at once.
 */
enum ph_csv_state ph_csv_scan(struct ph_csv_scan *scan, const char *text,
                              size_t n, char delimiter, bool last);

/* ph_csv_scan_pass: after an error: what is left of the line is scanned as a
 * comment is. */
void ph_csv_scan_pass(struct ph_csv_scan *scan);

/* The content of a cell: without blanks around it, and without its quotes,
 * but with quotes inside it still doubled when it was quoted. */
struct ph_csv_cell {
  const char *text;
  size_t n;
  bool quoted;
};

/*
 * ph_csv_cell: reads the cell at p of the row that ends at end, without its
 * line break (ph_csv_row_end).
 *
 * ret  the delimiter after the cell, or the end of the row's last cell; p of
 *      the next cell is one byte further
 */
const char *ph_csv_cell(const char *p, const char *end, char delimiter,
                        struct ph_csv_cell *cell);

/* ph_csv_row_end: the end of a row without its line break. */
const char *ph_csv_row_end(const char *p, const char *end);

/* ph_csv_content: copies what a cell stands for (at most cell->n bytes) to
 * out; its length. */
size_t ph_csv_content(const struct ph_csv_cell *cell, char *out);

/* ph_csv_number: whether text[n] is a number as CSV has them, or nan or inf;
 * infinite also when it overflows a double. */
bool ph_csv_number(const char *text, size_t n, double *x);

/* ph_csv_decimal_comma: whether a cell is a number but for a comma in place of
 * the decimal point. */
bool ph_csv_decimal_comma(const struct ph_csv_cell *cell);

/* ph_csv_thousands: whether a cell is a number but for marks between groups of
 * three digits, and perhaps a decimal comma. */
bool ph_csv_thousands(const struct ph_csv_cell *cell);

/* ---- records -------------------------------------------------------- */

/* What a column holds, when it is no field. */
enum { PH_CSV_ID = PH_FIELD_N, PH_CSV_SKIP };

struct ph_csv_column {
  int field;        /* enum ph_field_id, PH_CSV_ID or PH_CSV_SKIP */
  size_t component; /* of a vector field: 0, 1, 2 */
  const char *name; /* for messages */
  bool segments;    /* row i + 1 has element i, the first row the last */
};

/* Of results, the columns that say where a row is: they grow along a curve. */
enum { PH_CSV_SEGMENT = 1, PH_CSV_WITHIN = 2 };

/* The columns of one file (io/split.h makes and keeps them). */
struct ph_csv_columns {
  struct ph_csv_columns *older; /* of the file before */
  char delimiter;
  bool results; /* the rows are samples or control points, as csv_out.h prints
                   them: points, of which a joint has two */
  size_t n;
  struct ph_csv_column column[];
};

/*
 * ph_csv_in: reads the rows of one record; in, out and ret as ph_json_in.
 *
 * Each row is one element of every field that has columns; columns that are
 * empty in all rows are as good as absent.  Failures have the row's line.  An
 * id is echoed as the number it is, or else as a string; an empty one is none.
 */
enum ph_status ph_csv_in(const struct ph_record *record,
                         const struct ph_schema *schema, struct ph_arena *arena,
                         struct ph_problem *problem, struct ph_echo *echo,
                         struct ph_diag *diag);

/* ph_csv_line: the line of the row of a record that has element i, for a path
 * points[i] of a field that has columns; for any other path the record's first
 * line. */
size_t ph_csv_line(const struct ph_record *record, const char *path);

#endif
