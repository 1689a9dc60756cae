/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The splitter's way through CSV (see split.h): cuts the rows into records.
 *
 * A record is a run of rows with the same id, ended by another id, a blank line
 * or the end of the file; without an id column the blank line and the end are
 * what is left.  Rows stay in the window until their record is complete; the
 * window begins with the first row of the open record, or with the row that is
 * being read.  Of a record that is too long no more than a row is kept, and of
 * a row that is too long nothing but what is read at once.
 *
 * What the cells hold is not looked at here, but for the ids.
 *
 * Of a part (see split.h) a row is a line, and one that is broken is a record,
 * after which the next one begins.  Splitting begins at the line before the
 * part, which tells whether its first row begins a record; what began before
 * it is passed over.
 */
#include "io/split.h"

#include <math.h>
#include <stdint.h>
#include <string.h>

/* ---- records -------------------------------------------------------- */

/* Of a part: the columns are not known, and so nothing that follows. */
static enum ph_split_state fail_head(struct ph_split *split,
                                     struct ph_diag *diag) {
  const struct ph_diag why = *diag;
  split->ended = true;
  ph_fail(diag, PH_E_INPUT, NULL, "cannot read the columns of %s: %s",
          split->name, why.message);
  return PH_SPLIT_FAILED;
}

/* Gives out the broken row that is being read, with the open record, if any,
 * in front of it; the stream ends.  `offset` is where diag's column counts
 * from. */
static enum ph_split_state stop(struct ph_split *split, size_t offset,
                                struct ph_record *record,
                                struct ph_diag *diag) {
  enum ph_status status = diag->status;
  size_t column = diag->column > 0 ? diag->column - 1 : 0;
  if (status == PH_E_NO_MEMORY) {
    split->ended = true;
    return PH_SPLIT_FAILED;
  }
  if (ph_split_is_part(split)) {
    return fail_head(split, diag);
  }
  ph_split_locate(split, offset, diag);
  diag->column = status == PH_E_LIMIT ? 1 : diag->column + column;
  split->stopped = true;
  ph_split_give(split,
                status == PH_E_LIMIT || split->over.on ? 0 : split->csv.scan.at,
                0, record);
  record->line = split->over.on ? split->over.place.line : record->line;
  record->status = status;
  record->columns = split->csv.columns;
  return PH_SPLIT_RECORD;
}

/* Hands out the open record, and with it `taken` bytes of the window. */
static enum ph_split_state give(struct ph_split *split, size_t taken,
                                struct ph_record *record,
                                struct ph_diag *diag) {
  if (split->over.on) {
    ph_split_give_over(split, taken, record, diag);
  } else {
    ph_split_give(split, split->csv.row, taken, record);
  }
  record->columns = split->csv.columns;
  split->csv.open = false;
  split->csv.row = 0;
  split->csv.scan = (struct ph_csv_scan){.at = 0};
  return PH_SPLIT_RECORD;
}

/* The cell of the id in a row, empty when there is none; `after` is the first
 * byte that does not matter for it. */
static struct ph_csv_cell id_cell(const struct ph_csv_columns *columns,
                                  const char *p, const char *end,
                                  const char **after) {
  struct ph_csv_cell cell = {p, 0, false};
  size_t id = 0;
  *after = p;
  end = ph_csv_row_end(p, end);
  while (id < columns->n && columns->column[id].field != PH_CSV_ID) {
    id++;
  }
  if (id == columns->n) {
    return cell;
  }
  p = ph_csv_cell(p, end, columns->delimiter, &cell);
  for (; id > 0 && p < end; id--) {
    p = ph_csv_cell(p + 1, end, columns->delimiter, &cell);
  }
  cell.n = id > 0 ? 0 : cell.n;
  *after = p;
  return cell;
}

/* Of results: whether the row [p,end) does not lie further along the curve than
 * the open record's last one. */
static bool begins_curve(struct ph_split_csv *csv, bool part, const char *p,
                         const char *end) {
  const double last[2] = {csv->at[0], csv->at[1]};
  if (part) { /* what cannot be read is no older one */
    csv->at[0] = csv->at[1] = (double)NAN;
  }
  end = ph_csv_row_end(p, end);
  for (size_t i = 0; i <= PH_CSV_WITHIN && p <= end; i++, p++) {
    struct ph_csv_cell cell;
    double x;
    p = ph_csv_cell(p, end, csv->columns->delimiter, &cell);
    if (i >= PH_CSV_SEGMENT && ph_csv_number(cell.text, cell.n, &x)) {
      csv->at[i - PH_CSV_SEGMENT] = x;
    }
  }
  return csv->open && !(csv->at[0] > last[0]) &&
         (csv->at[0] < last[0] || !(csv->at[1] > last[1]));
}

/* Takes the row [p,end) into the open record, or opens one with it; false
 * when it belongs to the next record, or when (id.failed) memory is short. */
static bool take_row(struct ph_split *split, const char *p, const char *end) {
  struct ph_split_csv *csv = &split->csv;
  const bool nameless = split->over.on && split->over.nameless;
  const char *after;
  struct ph_csv_cell cell = id_cell(csv->columns, p, end, &after);
  size_t old_n = csv->open ? csv->id.n : 0;
  char *content;
  size_t n;
  if (csv->open && nameless) {
    return false;
  }
  if (csv->columns->results &&
      begins_curve(csv, ph_split_is_part(split), p, end)) {
    return false;
  }
  csv->id.n = old_n;
  content = ph_buf_reserve(&csv->id, cell.n + 1);
  if (!content) {
    return false;
  }
  n = ph_csv_content(&cell, content);
  if (csv->open) {
    return n == old_n && memcmp(csv->id.data, content, n) == 0;
  }
  csv->id.n = n;
  csv->open = true;
  return true;
}

/* ---- records that are too long ---------------------------------------- */

/* The end of what says the id in a row [p,end), of which there may be more:
 * NULL if it is not all there. */
static const char *id_end(const struct ph_csv_columns *columns, const char *p,
                          const char *end, bool more) {
  const char *after;
  id_cell(columns, p, end, &after);
  return after < ph_csv_row_end(p, end) || !more ? after : NULL;
}

/* The record that begins at the window is too long: keeps what says its id, if
 * it is in as much of the first row as a record may have. */
static void begin_over(struct ph_split *split) {
  const struct ph_csv_columns *columns = split->csv.columns;
  const char *p = split->data + split->start;
  struct ph_csv_scan scan = {.at = 0};
  const char *end = NULL;
  const char *after;
  if (!split->csv.blanks) {
    bool more = ph_csv_scan(&scan, p, split->options.most, columns->delimiter,
                            false) != PH_CSV_ROW;
    end = id_end(columns, p, p + scan.at, more);
  }
  ph_split_over(split);
  split->over.nameless = !end;
  if (end && id_cell(columns, p, end, &after).n > 0) {
    ph_buf_put(&split->over.kept, p, (size_t)(end - p));
  }
}

/* Drops what was read, up to the end of the row or inside it. */
static void drop_row(struct ph_split *split, bool inside) {
  struct ph_split_csv *csv = &split->csv;
  struct ph_diag place;
  if (csv->scan.quote < csv->scan.at) {
    ph_split_locate(split, csv->scan.quote, &place);
    split->over.quote = (struct ph_split_place){place.line, place.column};
    csv->scan.quote = SIZE_MAX;
  }
  ph_split_drop(split, csv->scan.at);
  split->over.inside = inside;
  csv->row = 0;
  csv->scan.at = 0;
  if (!inside) {
    csv->scan = (struct ph_csv_scan){.at = 0};
  }
}

/* Goes on with the next row; this one belongs to the open record, or else to
 * none. */
static void next_row(struct ph_split *split) {
  struct ph_split_csv *csv = &split->csv;
  const size_t most = split->options.most, row_end = csv->scan.at;
  if (csv->open && !split->over.on && most && row_end > most) {
    begin_over(split);
  }
  if (!csv->open || split->over.on) {
    drop_row(split, false);
  } else {
    csv->row = row_end;
    csv->scan = (struct ph_csv_scan){.at = row_end};
  }
}

/* Whether a row that is read is longer than a record may be. */
static bool is_long(const struct ph_split *split, enum ph_csv_state row) {
  const struct ph_split_csv *csv = &split->csv;
  const size_t most = split->options.most;
  /* a quote that is never closed: the row was read to its end */
  bool open_quote = row == PH_CSV_ERROR && csv->scan.at == csv->scan.quote;
  size_t end = ph_split_is_part(split) ? csv->line_end
               : open_quote            ? split->fill - split->start
                                       : csv->scan.at;
  return row != PH_CSV_BLANK &&
         (csv->blanks || (most && end - csv->row > most));
}

/* Whether the first n bytes of the row are blanks. */
static bool is_blank(const struct ph_split *split, size_t n) {
  const char *p = split->data + split->start + split->csv.row;
  size_t blanks = 0;
  while (blanks < n && memchr(" \t\r", p[blanks], 3)) {
    blanks++;
  }
  return blanks == n;
}

/* It is.  PH_SPLIT_END: go on. */
static enum ph_split_state handle_long(struct ph_split *split,
                                       enum ph_csv_state row,
                                       struct ph_record *record,
                                       struct ph_diag *diag) {
  struct ph_split_csv *csv = &split->csv;
  const size_t most = split->options.most;
  const char *p = split->data + split->start + csv->row;
  const bool comment = *p == '#' && !csv->blanks;
  if (!comment && !csv->columns) {
    ph_fail(diag, PH_E_LIMIT, NULL,
            "the first row is longer than the %zu bytes of --max-record-bytes",
            most);
    return stop(split, 0, record, diag);
  }
  if (!comment) {
    const char *end =
        csv->blanks ? NULL : id_end(csv->columns, p, p + most, true);
    bool open = csv->open;
    bool taken = end && take_row(split, p, end);
    if (csv->id.failed) {
      ph_fail_memory(diag);
      return stop(split, 0, record, diag);
    }
    if (open && !taken) {
      return give(split, csv->row, record, diag);
    }
    csv->open = true;
  }
  if (csv->open && !split->over.on) {
    begin_over(split);
  }
  csv->blanks = false;
  if (row == PH_CSV_ERROR && ph_split_is_part(split)) {
    ph_csv_scan_pass(&csv->scan);
  } else if (row == PH_CSV_ERROR && csv->scan.at == csv->scan.quote) {
    csv->scan.at = split->fill - split->start;
  }
  if (row == PH_CSV_ERROR) {
    split->over.inside = true; /* and met again */
  } else {
    drop_row(split, row == PH_CSV_MORE);
  }
  return PH_SPLIT_END;
}

/* A row that is too long begins with blanks, which it may consist of: these are
 * dropped.  Either way the open record ends before it.  PH_SPLIT_END: go on. */
static enum ph_split_state handle_blanks(struct ph_split *split,
                                         enum ph_csv_state row,
                                         struct ph_record *record,
                                         struct ph_diag *diag) {
  struct ph_split_csv *csv = &split->csv;
  if (csv->open) {
    return give(split, csv->row, record, diag);
  }
  csv->blanks = true;
  if (row != PH_CSV_MORE || !is_blank(split, csv->scan.at)) {
    return handle_long(split, row, record, diag);
  }
  ph_split_drop(split, csv->scan.at);
  csv->scan.at = 0;
  return PH_SPLIT_END;
}

/* Finds out what delimits cells, by the first row, as far as it is scanned;
 * false: that is known.  The row is then to be scanned again. */
static bool know_delimiter(struct ph_split *split) {
  struct ph_csv_scan *scan = &split->csv.scan;
  const char *row = split->data + split->start + split->csv.row;
  if (split->delimiter != PH_CSV_ANY) {
    return false;
  }
  ph_split_find_delimiter(split, row, split->data + split->start + scan->at);
  *scan = (struct ph_csv_scan){.at = split->csv.row};
  return true;
}

/* A row of cells is complete.  PH_SPLIT_END: go on with the next one. */
static enum ph_split_state handle_row(struct ph_split *split,
                                      struct ph_record *record,
                                      struct ph_diag *diag) {
  struct ph_split_csv *csv = &split->csv;
  const char *window = split->data + split->start;
  bool data = true;
  if (know_delimiter(split)) {
    return PH_SPLIT_END;
  }
  if (!csv->columns && ph_split_find_columns(split, &data, diag) != PH_OK) {
    return stop(split, 0, record, diag);
  }
  if (data && !take_row(split, window + csv->row, window + csv->scan.at)) {
    if (csv->id.failed) {
      ph_fail_memory(diag);
      return stop(split, 0, record, diag);
    }
    return give(split, csv->row, record, diag);
  }
  next_row(split);
  return PH_SPLIT_END;
}

/* A comment is complete; the first line of a file may be its header. */
static enum ph_split_state handle_comment(struct ph_split *split,
                                          struct ph_record *record,
                                          struct ph_diag *diag) {
  const char *p = split->data + split->start + 1;
  const char *end = split->data + split->start + split->csv.scan.at;
  bool first = split->place.line == 1 && split->csv.row == 0;
  char separator;
  if (first && ph_split_is_header(split, p, end, &separator) &&
      ph_split_columns(split, p, (size_t)(end - p), separator, false,
                       &split->csv.columns, diag) != PH_OK) {
    return stop(split, 1, record, diag);
  }
  next_row(split);
  return PH_SPLIT_END;
}

/* A row of a part is broken: a record of its own. */
static enum ph_split_state break_row(struct ph_split *split,
                                     struct ph_record *record,
                                     struct ph_diag *diag) {
  struct ph_split_csv *csv = &split->csv;
  ph_fail(diag, PH_E_SYNTAX, NULL, "%s", csv->scan.message);
  ph_split_locate(split, csv->scan.at, diag);
  csv->row = csv->line_end;
  give(split, csv->line_end, record, diag);
  record->status = PH_E_SYNTAX;
  return PH_SPLIT_RECORD;
}

/* A row is broken.  What stands of it tells whether it belongs to the open
 * record; if not, that one is whole, and the row is met again. */
static enum ph_split_state handle_broken(struct ph_split *split,
                                         struct ph_record *record,
                                         struct ph_diag *diag) {
  struct ph_split_csv *csv = &split->csv;
  const char *window = split->data + split->start;
  if (know_delimiter(split)) {
    return PH_SPLIT_END;
  }
  if (!csv->columns &&
      ph_split_is_foreign(window + csv->row, window + csv->scan.at, diag)) {
    return stop(split, csv->row, record, diag);
  }
  if (ph_split_is_part(split) && csv->columns) {
    return csv->open ? give(split, csv->row, record, diag)
                     : break_row(split, record, diag);
  }
  if (!csv->open || take_row(split, window + csv->row, window + csv->scan.at)) {
    ph_fail(diag, PH_E_SYNTAX, NULL, "%s", csv->scan.message);
  } else if (csv->id.failed) {
    ph_fail_memory(diag);
  } else {
    return give(split, csv->row, record, diag);
  }
  return stop(split, csv->scan.at, record, diag);
}

/* A row is broken, of which some is gone. */
static enum ph_split_state handle_inside_broken(struct ph_split *split,
                                                struct ph_record *record,
                                                struct ph_diag *diag) {
  struct ph_csv_scan *scan = &split->csv.scan;
  const bool gone = scan->at == SIZE_MAX;
  enum ph_split_state state;
  scan->at = gone ? 0 : scan->at;
  ph_fail(diag, PH_E_SYNTAX, NULL, "%s", scan->message);
  state = stop(split, scan->at, record, diag);
  if (gone) {
    diag->line = split->over.quote.line;
    diag->column = split->over.quote.column;
  }
  return state;
}

/* More bytes, or the end of the file.  PH_SPLIT_END: go on. */
static enum ph_split_state handle_more(struct ph_split *split, bool may_wait,
                                       bool *end_of_file,
                                       struct ph_diag *diag) {
  enum ph_split_state state = ph_split_fill(split, may_wait, diag);
  *end_of_file = state == PH_SPLIT_END;
  return state == PH_SPLIT_RECORD ? PH_SPLIT_END : state;
}

/* What the scan of a row has found.  PH_SPLIT_END: go on. */
static enum ph_split_state handle(struct ph_split *split, enum ph_csv_state row,
                                  struct ph_record *record,
                                  struct ph_diag *diag) {
  struct ph_split_csv *csv = &split->csv;
  if (split->over.inside && row == PH_CSV_ERROR && ph_split_is_part(split)) {
    ph_csv_scan_pass(&csv->scan);
    return PH_SPLIT_END;
  }
  if (split->over.inside && row == PH_CSV_ERROR) {
    return handle_inside_broken(split, record, diag);
  }
  if (split->over.inside) {
    drop_row(split, row == PH_CSV_MORE);
    return PH_SPLIT_END;
  }
  if (is_long(split, row)) {
    return csv->blanks || is_blank(split, split->options.most)
               ? handle_blanks(split, row, record, diag)
               : handle_long(split, row, record, diag);
  }
  switch (row) {
  case PH_CSV_ROW:
    return handle_row(split, record, diag);
  case PH_CSV_COMMENT:
    return handle_comment(split, record, diag);
  case PH_CSV_ERROR:
    return handle_broken(split, record, diag);
  case PH_CSV_BLANK:
    csv->blanks = false;
    if (csv->open) {
      return give(split, csv->scan.at, record, diag);
    }
    next_row(split);
    break;
  case PH_CSV_MORE:
    break;
  }
  return PH_SPLIT_END;
}

/* Goes on with the scan of the row: of a part when its line is there, or as
 * much of it as a record may have. */
static enum ph_csv_state scan_row(struct ph_split *split) {
  struct ph_split_csv *csv = &split->csv;
  const char *text = split->data + split->start;
  const size_t n = split->fill - split->start, most = split->options.most;
  const size_t at = csv->scan.at < n ? csv->scan.at : csv->row;
  const char *line = NULL;
  if (!ph_split_is_part(split)) {
    return ph_csv_scan(&csv->scan, text, n, split->delimiter,
                       split->end_of_file);
  }
  line = at < n ? memchr(text + at, '\n', n - at) : NULL;
  csv->line_end = line ? (size_t)(line + 1 - text) : n;
  if (!line && !split->end_of_file && !(most && n - csv->row > most)) {
    return PH_CSV_MORE;
  }
  return ph_csv_scan(&csv->scan, text, csv->line_end, split->delimiter,
                     line || split->end_of_file);
}

/* Of a part: whether the row begins behind it, and no record goes on there that
 * began in it. */
static bool is_behind(const struct ph_split *split) {
  const struct ph_split_csv *csv = &split->csv;
  const size_t record = split->over.on ? split->over.byte : split->offset;
  return ph_split_is_part(split) && split->cut.sought &&
         (!csv->open || record < split->cut.begin) &&
         split->offset + csv->row >= split->cut.end;
}

/* Whether the record began before the part: then it is none. */
static bool is_before(struct ph_split *split, const struct ph_record *record) {
  if (!ph_split_is_part(split) || record->byte >= split->cut.begin) {
    return false;
  }
  ph_split_drop(split, split->done);
  split->done = 0;
  split->number--;
  return true;
}

enum ph_split_state ph_split_csv(struct ph_split *split, bool may_wait,
                                 struct ph_record *record,
                                 struct ph_diag *diag) {
  struct ph_split_csv *csv = &split->csv;
  enum ph_split_state state = PH_SPLIT_END;
  bool end_of_file = false;
  while (state == PH_SPLIT_END) {
    size_t n = split->fill - split->start;
    enum ph_csv_state row = PH_CSV_MORE;
    if (ph_split_is_part(split) && !split->cut.sought && csv->columns) {
      return PH_SPLIT_RECORD;
    }
    if (is_behind(split)) {
      return PH_SPLIT_END;
    }
    if (csv->row < n || split->over.inside) {
      row = scan_row(split);
      state = handle(split, row, record, diag);
    } else if (end_of_file) {
      if (!csv->open) {
        return PH_SPLIT_END;
      }
      state = give(split, csv->row, record, diag);
    }
    if (row == PH_CSV_MORE && state == PH_SPLIT_END) {
      state = handle_more(split, may_wait, &end_of_file, diag);
    }
    if (state == PH_SPLIT_RECORD && is_before(split, record)) {
      state = PH_SPLIT_END;
    }
  }
  return state;
}
