/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Rows and cells of CSV (see csv_in.h).
 *
 * Reference: RFC 4180.
 */
#include "io/csv_in.h"

#include "base/suggest.h"
#include "io/number.h"

#include <math.h>
#include <stdint.h>
#include <stdio.h>
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

/* Whether words are delimited, by any run of these. */
static bool is_gap(char c) {
  return c == ' ' || c == '\t' || c == '\r';
}

/* Whether c, which is not `delimiter`, ends a cell nevertheless. */
static bool also_delimits(char c, char delimiter) {
  return (delimiter == PH_CSV_ANY && (c == ',' || c == ';' || is_gap(c))) ||
         (delimiter == PH_CSV_WORDS && is_gap(c));
}

/* The state after c, which is no line break, outside of quoted text and
 * comments; -1: c cannot follow a quoted cell. */
static int next_state(int state, char c, char delimiter) {
  if (c == delimiter || also_delimits(c, delimiter)) {
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
  bool blank = scan->state <= CELL_START && !scan->filled;
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

/* The same of bytes that may end a cell there. */
static size_t skip_word(const char *text, size_t at, size_t n) {
  while (at < n && text[at] != '\n' && !also_delimits(text[at], PH_CSV_ANY)) {
    at++;
  }
  return at;
}

/* Passes a whole row at its start, if its line is there and plain: without
 * quotes, no comment, and not blank.  What delimits its cells does not matter
 * then. */
static bool skip_row(struct ph_csv_scan *scan, const char *text, size_t n) {
  const char *p = text + scan->at;
  const char *line = memchr(p, '\n', n - scan->at);
  if (!line || *p == '#' || memchr(p, '"', (size_t)(line - p))) {
    return false;
  }
  while (is_gap(*p)) {
    p++;
  }
  if (p == line) {
    return false;
  }
  scan->at = (size_t)(line + 1 - text);
  return true;
}

enum ph_csv_state ph_csv_scan(struct ph_csv_scan *scan, const char *text,
                              size_t n, char delimiter, bool last) {
  const bool loose = delimiter == PH_CSV_WORDS || delimiter == PH_CSV_ANY;
  if (scan->state == ROW_START && scan->at < n && skip_row(scan, text, n)) {
    return PH_CSV_ROW;
  }
  for (; scan->at < n; scan->at++) {
    char c = text[scan->at];
    int next;
    if (scan->state == QUOTED) {
      scan->state = c == '"' ? QUOTE : QUOTED;
      continue;
    }
    if (scan->state == PLAIN || scan->state == COMMENT) {
      char stop = scan->state == PLAIN ? delimiter : '\n';
      scan->at = loose && scan->state == PLAIN ? skip_word(text, scan->at, n)
                                               : skip(text, scan->at, n, stop);
      if (scan->at == n) {
        break;
      }
      c = text[scan->at];
      if (c == delimiter && c != '\n') {
        scan->state = CELL_START;
        continue;
      }
    }
    if (c == '\n') {
      scan->at++;
      return finish_row(scan);
    }
    next = next_state(scan->state, c, delimiter);
    if (next < 0) {
      return after_quoted(scan, text + scan->at, text + n, delimiter, last);
    }
    scan->filled |=
        next > CELL_START || (c == delimiter ? c != PH_CSV_WORDS : !is_gap(c));
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

void ph_csv_scan_pass(struct ph_csv_scan *scan) {
  scan->at = scan->at == SIZE_MAX ? 0 : scan->at;
  scan->state = COMMENT;
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

/* The end of a quoted cell's content, which begins at p. */
static const char *quoted_end(const char *p, const char *end) {
  while (p < end && (*p != '"' || (p + 1 < end && p[1] == '"'))) {
    p += *p == '"' ? 2 : 1;
  }
  return p;
}

/* ph_csv_cell of words: the last of the blanks before the next one is what
 * delimits them. */
static const char *word(const char *p, const char *end,
                        struct ph_csv_cell *cell) {
  while (p < end && is_gap(*p)) {
    p++;
  }
  cell->quoted = p < end && *p == '"';
  p += cell->quoted;
  cell->text = p;
  p = cell->quoted ? quoted_end(p, end) : p;
  cell->n = (size_t)(p - cell->text);
  while (p < end && !is_gap(*p)) {
    p++;
  }
  cell->n = cell->quoted ? cell->n : (size_t)(p - cell->text);
  while (p < end && is_gap(*p)) {
    p++;
  }
  return p < end ? p - 1 : end;
}

const char *ph_csv_cell(const char *p, const char *end, char delimiter,
                        struct ph_csv_cell *cell) {
  const char *cell_end;
  if (delimiter == PH_CSV_WORDS) {
    return word(p, end, cell);
  }
  while (p < end && is_blank(*p, delimiter)) {
    p++;
  }
  cell->quoted = p < end && *p == '"';
  if (cell->quoted) {
    cell->text = ++p;
    p = quoted_end(p, end);
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

bool ph_csv_decimal_comma(const struct ph_csv_cell *cell) {
  const char *comma = cell->n ? memchr(cell->text, ',', cell->n) : NULL;
  size_t n = comma ? (size_t)(comma - cell->text) : 0;
  char text[PH_EXCERPT_MAX];
  double x;
  if (!comma || cell->n > sizeof text) {
    return false;
  }
  memcpy(text, cell->text, cell->n);
  text[n] = '.';
  return ph_csv_number(text, cell->n, &x);
}

/* The length of a mark between groups of digits at p: of a blank that does not
 * break a line, too; 0: it is none. */
static size_t thousands_mark(const char *p, const char *end) {
  static const char *const marks[] = {
      ",", ".", "'", " ", "_", "\xc2\xa0", "\xe2\x80\xaf", "\xe2\x80\x99"};
  for (size_t i = 0; i < sizeof marks / sizeof marks[0]; i++) {
    const size_t n = strlen(marks[i]);
    if ((size_t)(end - p) >= n && memcmp(p, marks[i], n) == 0) {
      return n;
    }
  }
  return 0;
}

/* How many digits begin at p. */
static size_t digits_at(const char *p, const char *end) {
  size_t n = 0;
  while (p + n < end && p[n] >= '0' && p[n] <= '9') {
    n++;
  }
  return n;
}

bool ph_csv_thousands(const struct ph_csv_cell *cell) {
  const char *p = cell->text, *end = p + cell->n;
  char text[PH_EXCERPT_MAX];
  size_t n = 0, marks = 0;
  double x;
  if (cell->n > sizeof text) {
    return false;
  }
  while (p < end) {
    const size_t mark =
        n > 0 && digits_at(text + n - 1, text + n) ? thousands_mark(p, end) : 0;
    if (mark > 0 && digits_at(p + mark, end) == 3) {
      p += mark;
      marks++;
    } else {
      text[n++] = *p == ',' ? '.' : *p;
      p++;
    }
  }
  return marks > 0 && ph_csv_number(text, n, &x);
}
