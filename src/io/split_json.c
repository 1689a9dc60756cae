/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The splitter's way through JSON (see split.h): any number of values, one
 * after another; of an array its elements are the records, and it is never
 * held whole.
 *
 * A broken text is a record, too.  What follows it is trusted when the text
 * counts as a line of JSON Lines: it stands outside of an array, and
 *   (a) the suffix of the file says so, or
 *   (b) all values on the lines before it stood on lines of their own, or
 *   (c) it begins a line, and the next one that is not blank begins with '{'.
 * By (a) and (b) it may also follow a good value on its line.
 * Splitting then goes on behind the line where the text began, and the text is
 * judged as that line alone: a truncated line ends too early, whatever the
 * lines after it happen to be.
 *
 * Of a text that is longer than it may be, the scan goes on, and what it has
 * passed is dropped.  If it is broken, splitting goes on, where it may, behind
 * the line that is, or there if an object begins that line.
 */
#include "io/split.h"

#include <string.h>

/* Drops blanks, and what stands before a text of a sequence; false when the
 * window is empty after it. */
static bool skip_blanks(struct ph_split *split) {
  const bool texts = split->format == PH_SPLIT_GEOJSON &&
                     split->json.array == PH_ARRAY_NONE &&
                     split->json.scan.at == 0;
  bool again = true;
  while (again) {
    const char *p = split->data + split->start;
    size_t n = split->fill - split->start;
    size_t blanks = n ? (size_t)(ph_json_blanks(p, p + n) - p) : 0;
    again = texts && blanks < n && p[blanks] == PH_RECORD_SEPARATOR;
    if (blanks > 0) {
      split->json.line_start |= memchr(p, '\n', blanks) != NULL;
      ph_split_drop(split, blanks);
    }
    if (again) {
      ph_split_drop(split, 1);
      split->json.line_start = split->geojson.sequence = true;
    }
  }
  return split->start < split->fill;
}

/* Goes on with the scan of the text at the window: of a part to the end of its
 * line, which is the end of the text. */
static enum ph_json_state scan_text(struct ph_split *split) {
  struct ph_json_scan *scan = &split->json.scan;
  const char *text = split->data + split->start;
  const size_t n = split->fill - split->start;
  const char *end = ph_split_is_part(split) && scan->at < n
                        ? memchr(text + scan->at, '\n', n - scan->at)
                        : NULL;
  return end ? ph_json_scan(scan, text, (size_t)(end - text), true)
             : ph_json_scan(scan, text, n, split->end_of_file);
}

/* Whether the line at the window begins behind the part. */
static bool is_behind(const struct ph_split *split) {
  const size_t line =
      split->place.line == 1 ? 0 : split->offset - (split->place.column - 1);
  return ph_split_is_part(split) && split->json.line_start &&
         split->json.scan.at == 0 && line >= split->cut.end;
}

/* ---- broken texts --------------------------------------------------- */

/* Finds the end of the line at the start of the window.
 * ret  PH_SPLIT_RECORD; PH_SPLIT_END: it is longer than a record may be;
 *      PH_SPLIT_WAIT or PH_SPLIT_FAILED */
static enum ph_split_state find_line(struct ph_split *split, bool may_wait,
                                     struct ph_diag *diag) {
  struct ph_split_json *json = &split->json;
  while (json->line_n == 0) {
    const char *data = split->data + split->start;
    size_t n = split->fill - split->start;
    const char *end = memchr(data + json->look, '\n', n - json->look);
    enum ph_split_state state;
    json->look = end ? (size_t)(end + 1 - data) : n;
    if (end) {
      json->line_n = json->look;
      break;
    }
    if (split->options.most && n > split->options.most) {
      return PH_SPLIT_END;
    }
    state = ph_split_fill(split, may_wait, diag);
    if (state == PH_SPLIT_END) {
      json->line_n = n;
    } else if (state != PH_SPLIT_RECORD) {
      return state;
    }
  }
  return split->options.most && json->line_n > split->options.most + 1
             ? PH_SPLIT_END
             : PH_SPLIT_RECORD;
}

/* The text is broken where its scan is. */
static void break_over(struct ph_split *split) {
  struct ph_split_over *over = &split->over;
  struct ph_diag place;
  if (!over->on) {
    ph_split_over(split);
  }
  ph_split_locate(split, split->json.scan.at, &place);
  over->broken = (struct ph_split_place){place.line, place.column};
  over->part = PH_OVER_LINE;
  over->on = true;
}

/* The broken text is judged as its first line alone.  ret  its length, without
 * the line break */
static size_t scan_line(struct ph_split *split) {
  struct ph_split_json *json = &split->json;
  const char *text = split->data + split->start;
  size_t n = (size_t)(ph_csv_row_end(text, text + json->line_n) - text);
  struct ph_json_scan line = {0};
  if (ph_json_scan(&line, text, n, true) == PH_JSON_ERROR) {
    json->scan = line; /* always: what has a good beginning is good */
  }
  return n;
}

/* Whether the first line after that one that is not blank begins with '{'; of
 * a text that is too long, or of many blanks, no more is kept than is needed.
 * ret  PH_SPLIT_RECORD: it does; PH_SPLIT_END: it does not; or as above */
static enum ph_split_state object_follows(struct ph_split *split, bool may_wait,
                                          struct ph_diag *diag) {
  struct ph_split_json *json = &split->json;
  const size_t most = split->options.most;
  for (;;) {
    const char *data = split->data + split->start;
    const char *end = split->data + split->fill;
    const char *first = ph_json_blanks(data + json->look, end);
    enum ph_split_state state;
    json->look = (size_t)(first - data);
    if (most && !split->over.on && json->look - json->line_n > most) {
      scan_line(split);
      break_over(split);
      split->over.part = PH_OVER_FOLLOWING;
    }
    if (split->over.on && json->look > 1) {
      ph_split_drop(split, json->look - 1);
      json->look = 1;
    }
    if (first < end) {
      return first[-1] == '\n' && *first == '{' ? PH_SPLIT_RECORD
                                                : PH_SPLIT_END;
    }
    state = ph_split_fill(split, may_wait, diag);
    if (state != PH_SPLIT_RECORD) {
      return state;
    }
  }
}

/* Hands out the broken text at the start of the window. */
static enum ph_split_state give_broken(struct ph_split *split, size_t n,
                                       size_t taken,
                                       const struct ph_json_scan *scan,
                                       struct ph_record *record,
                                       struct ph_diag *diag) {
  ph_fail(diag, PH_E_SYNTAX, NULL, "%s", scan->message);
  ph_split_locate(split, scan->at, diag);
  ph_split_give(split, n, taken, record);
  record->status = PH_E_SYNTAX;
  return PH_SPLIT_RECORD;
}

/* The next text begins. */
static void begin_text(struct ph_split *split) {
  split->json.scan = (struct ph_json_scan){0};
  split->geojson.head = (struct ph_geojson_head){.at = 0};
  split->geojson.whole = false;
}

static enum ph_split_state
stop(struct ph_split *split, struct ph_record *record, struct ph_diag *diag) {
  split->stopped = true;
  return give_broken(split, split->json.scan.at, 0, &split->json.scan, record,
                     diag);
}

/* Hands out the broken text of a sequence; reading goes on at its next one. */
static enum ph_split_state break_text(struct ph_split *split,
                                      struct ph_record *record,
                                      struct ph_diag *diag) {
  struct ph_split_json *json = &split->json;
  const struct ph_json_scan scan = json->scan;
  begin_text(split);
  json->array = PH_ARRAY_NONE;
  json->broken = false;
  split->geojson.skip = true;
  return give_broken(split, scan.at, scan.at, &scan, record, diag);
}

/* Whether the texts so far count as lines of JSON Lines, whatever follows. */
static bool are_lines(const struct ph_split *split) {
  const struct ph_split_json *json = &split->json;
  size_t on_this_line = json->line_start ? 0 : 1;
  return split->lines_suffix || (json->lines && json->values > on_this_line);
}

/* The next text begins a line. */
static void begin_line(struct ph_split *split) {
  struct ph_split_json *json = &split->json;
  begin_text(split);
  json->broken = false;
  json->line_start = true;
  json->line_n = 0;
  json->look = 0;
}

/* A value was handed out, which stood on one line or on more. */
static void finish_value(struct ph_split *split, bool one_line) {
  struct ph_split_json *json = &split->json;
  if (json->array == PH_ARRAY_NONE || json->array == PH_ARRAY_TAIL) {
    json->array = PH_ARRAY_NONE;
    json->lines &= json->line_start && one_line;
    json->values++;
  } else {
    json->array = PH_ARRAY_COMMA;
  }
  json->line_start = false;
  begin_text(split);
}

/* ---- texts that are too long ------------------------------------------ */

/* Keeps what says to whom the text belongs, as far as it is in what a record
 * may have. */
static void keep_names(struct ph_split *split) {
  static const char *const names[] = {"id", "command"};
  const char *text = split->data + split->start;
  const char *end = text + split->options.most;
  struct ph_buf *kept = &split->over.kept;
  struct ph_json_walk walk;
  struct ph_json_item item;
  ph_json_walk_init(&walk, text, split->options.most);
  while (ph_json_walk_next(&walk, &item) && item.value + item.value_n < end) {
    for (size_t i = 0; item.key && i < sizeof names / sizeof *names; i++) {
      if (item.key_n == strlen(names[i]) &&
          memcmp(item.key, names[i], item.key_n) == 0) {
        ph_buf_puts(kept, kept->n ? ",\"" : "{\"");
        ph_buf_put(kept, item.key, item.key_n);
        ph_buf_puts(kept, "\":");
        ph_buf_put(kept, item.value, item.value_n);
      }
    }
  }
  if (kept->n) {
    ph_buf_puts(kept, "}");
  }
}

/* Drops n bytes of the text. */
static void pass(struct ph_split *split, size_t n) {
  struct ph_split_over *over = &split->over;
  const char *text = split->data + split->start;
  size_t i = n;
  while (i > 0 && memchr(" \t\r", text[i - 1], 3)) {
    i--;
  }
  over->blank = i > 0 ? text[i - 1] == '\n' : over->blank;
  over->one_line &= !memchr(text, '\n', n);
  ph_split_drop(split, n);
}

/* Hands it out. */
static enum ph_split_state give_over(struct ph_split *split, bool stopped,
                                     struct ph_record *record,
                                     struct ph_diag *diag) {
  struct ph_split_json *json = &split->json;
  struct ph_split_over *over = &split->over;
  const bool broken = over->part != PH_OVER_VALUE;
  ph_split_give_over(split, 0, record, diag);
  if (broken) {
    record->n = 0;
    record->status = ph_fail(diag, PH_E_SYNTAX, NULL, "%s", json->scan.message);
    diag->line = over->broken.line;
    diag->column = over->broken.column;
    split->stopped = stopped;
    begin_line(split);
    return PH_SPLIT_RECORD;
  }
  finish_value(split, over->one_line);
  return PH_SPLIT_RECORD;
}

/* Drops what the scanner goes through, to its end or an error.
 * ret  PH_SPLIT_RECORD: that far; else as ph_split_fill */
static enum ph_split_state pass_scan(struct ph_split *split, bool may_wait,
                                     enum ph_json_state *state,
                                     struct ph_diag *diag) {
  struct ph_json_scan *scan = &split->json.scan;
  for (;;) {
    enum ph_split_state filled;
    *state = scan_text(split);
    pass(split, scan->at);
    scan->at = 0;
    if (*state != PH_JSON_MORE) {
      return PH_SPLIT_RECORD;
    }
    filled = ph_split_fill(split, may_wait, diag);
    if (filled == PH_SPLIT_WAIT || filled == PH_SPLIT_FAILED) {
      return filled;
    }
  }
}

/* Goes on with the text itself.
 * ret  PH_SPLIT_RECORD: it is over, or broken; else as ph_split_fill */
static enum ph_split_state pass_value(struct ph_split *split, bool may_wait,
                                      struct ph_diag *diag) {
  enum ph_json_state scanned;
  enum ph_split_state state = pass_scan(split, may_wait, &scanned, diag);
  if (state == PH_SPLIT_RECORD && scanned == PH_JSON_ERROR) {
    break_over(split);
  }
  return state;
}

/* Goes on to the end of the line; ret  as pass_value, or PH_SPLIT_END */
static enum ph_split_state pass_line(struct ph_split *split, bool may_wait,
                                     struct ph_diag *diag) {
  for (;;) {
    const char *data = split->data + split->start;
    size_t n = split->fill - split->start;
    const char *end = n ? memchr(data, '\n', n) : NULL;
    enum ph_split_state state;
    ph_split_drop(split, end ? (size_t)(end - data) : n);
    state = end ? PH_SPLIT_RECORD : ph_split_fill(split, may_wait, diag);
    if (end || state != PH_SPLIT_RECORD) {
      return state;
    }
  }
}

/* A text that is too long. */
static enum ph_split_state pass_over(struct ph_split *split, bool may_wait,
                                     struct ph_record *record,
                                     struct ph_diag *diag) {
  struct ph_split_json *json = &split->json;
  struct ph_split_over *over = &split->over;
  const bool lines = are_lines(split);
  enum ph_split_state state = PH_SPLIT_RECORD;
  if (over->part == PH_OVER_VALUE) {
    state = pass_value(split, may_wait, diag);
    if (state != PH_SPLIT_RECORD || over->part == PH_OVER_VALUE) {
      return state == PH_SPLIT_RECORD ? give_over(split, false, record, diag)
                                      : state;
    }
    if (json->array != PH_ARRAY_NONE || !(lines || json->line_start)) {
      return give_over(split, true, record, diag);
    }
    if (over->blank && split->start < split->fill &&
        split->data[split->start] == '{') {
      return give_over(split, false, record, diag);
    }
  }
  if (over->part == PH_OVER_LINE) {
    state = pass_line(split, may_wait, diag);
    if (state == PH_SPLIT_WAIT || state == PH_SPLIT_FAILED) {
      return state;
    }
    if (lines || state == PH_SPLIT_END) {
      return give_over(split, !lines, record, diag);
    }
    over->part = PH_OVER_FOLLOWING;
    json->look = 1;
  }
  state = object_follows(split, may_wait, diag);
  return state == PH_SPLIT_WAIT || state == PH_SPLIT_FAILED
             ? state
             : give_over(split, state == PH_SPLIT_END, record, diag);
}

/* ---- broken texts, further -------------------------------------------- */

/* Decides whether reading can go on behind a broken text, and hands it out. */
static enum ph_split_state broken(struct ph_split *split, bool may_wait,
                                  struct ph_record *record,
                                  struct ph_diag *diag) {
  struct ph_split_json *json = &split->json;
  bool lines = are_lines(split);
  struct ph_json_scan line;
  enum ph_split_state state;
  size_t line_n, n;
  if (split->geojson.sequence) {
    return break_text(split, record, diag);
  }
  if (json->array != PH_ARRAY_NONE || !(lines || json->line_start)) {
    return stop(split, record, diag);
  }
  state = find_line(split, may_wait, diag);
  if (state == PH_SPLIT_END) {
    break_over(split);
    return pass_over(split, may_wait, record, diag);
  }
  if (state == PH_SPLIT_RECORD && !lines) {
    state = object_follows(split, may_wait, diag);
  }
  if (state != PH_SPLIT_RECORD && state != PH_SPLIT_END) {
    return state;
  }
  if (split->over.on) {
    return give_over(split, state == PH_SPLIT_END, record, diag);
  }
  if (state == PH_SPLIT_END) {
    return stop(split, record, diag);
  }
  line_n = json->line_n;
  n = scan_line(split);
  line = json->scan;
  begin_line(split);
  return give_broken(split, n, line_n, &line, record, diag);
}

/* ---- values --------------------------------------------------------- */

/* Hands out the value at the start of the window. */
static enum ph_split_state give_value(struct ph_split *split,
                                      struct ph_record *record) {
  size_t n = split->json.scan.at;
  ph_split_give(split, n, n, record);
  finish_value(split, !memchr(record->text, '\n', n));
  return PH_SPLIT_RECORD;
}

/* A bracket or comma between values, if one is due at the start of the window.
 * ret  whether there was one; if not, a value is due, or the text is broken,
 *      or PH_JSON_MORE is needed to tell how */
static bool punctuation(struct ph_split *split, enum ph_json_state *state) {
  struct ph_split_json *json = &split->json;
  const char *p = split->data + split->start;
  *state = PH_JSON_DONE;
  if (json->scan.at > 0 || ph_split_is_part(split)) {
    return false;
  }
  if (json->array == PH_ARRAY_NONE && *p == '{') {
    if (!ph_split_collection(split, state)) {
      return false;
    }
    json->array = PH_ARRAY_BEGUN;
    json->lines = json->line_start = false;
    return true;
  }
  if (json->array == PH_ARRAY_NONE && *p == '[') {
    json->array = PH_ARRAY_BEGUN;
    json->lines = false;
  } else if (json->array == PH_ARRAY_COMMA && *p == ',') {
    json->array = PH_ARRAY_VALUE;
  } else if (*p == ']' &&
             (json->array == PH_ARRAY_COMMA || json->array == PH_ARRAY_BEGUN)) {
    json->array = PH_ARRAY_NONE;
    if (split->geojson.collection) {
      json->array = PH_ARRAY_TAIL;
      json->scan = ph_json_scan_rest();
      split->geojson.collection = false;
    }
  } else if (json->array == PH_ARRAY_COMMA) {
    *state = ph_json_unexpected(&json->scan, "',' or ']'", p,
                                split->fill - split->start, split->end_of_file);
    return false;
  } else {
    return false;
  }
  json->line_start = false;
  ph_split_drop(split, 1);
  return true;
}

/* The input ends, with an empty window. */
static enum ph_split_state
at_end(struct ph_split *split, struct ph_record *record, struct ph_diag *diag) {
  struct ph_json_scan *scan = &split->json.scan;
  if (split->json.array == PH_ARRAY_NONE) {
    return PH_SPLIT_END;
  }

  memcpy(scan->message, "the text ends inside an array",
         sizeof "the text ends inside an array");
  return stop(split, record, diag);
}

/* The rest of a collection; ret  PH_SPLIT_RECORD: go on; or as ph_split_fill */
static enum ph_split_state pass_tail(struct ph_split *split, bool may_wait,
                                     struct ph_diag *diag) {
  enum ph_json_state scanned;
  enum ph_split_state state = pass_scan(split, may_wait, &scanned, diag);
  if (state != PH_SPLIT_RECORD) {
    return state;
  }
  if (scanned == PH_JSON_ERROR) {
    split->json.broken = true;
  } else {
    finish_value(split, false);
  }
  return state;
}

enum ph_split_state ph_split_json(struct ph_split *split, bool may_wait,
                                  struct ph_record *record,
                                  struct ph_diag *diag) {
  struct ph_split_json *json = &split->json;
  for (;;) {
    enum ph_json_state state = PH_JSON_MORE;
    enum ph_split_state filled = ph_split_pass_text(split, may_wait, diag);
    if (filled == PH_SPLIT_RECORD && json->array == PH_ARRAY_TAIL &&
        !json->broken) {
      filled = pass_tail(split, may_wait, diag);
    }
    if (filled != PH_SPLIT_RECORD) {
      return filled;
    }
    if (split->over.on) {
      return pass_over(split, may_wait, record, diag);
    }
    if (json->broken) {
      return broken(split, may_wait, record, diag);
    }
    if (skip_blanks(split)) {
      if (is_behind(split)) {
        return PH_SPLIT_END;
      }
      if (punctuation(split, &state)) {
        continue;
      }
      if (state == PH_JSON_DONE) {
        state = scan_text(split);
      }
      if (split->options.most && json->scan.at > split->options.most) {
        ph_split_over(split);
        keep_names(split);
        continue;
      }
      if (state == PH_JSON_DONE) {
        return give_value(split, record);
      }
    } else if (split->end_of_file) {
      return at_end(split, record, diag);
    }
    if (state == PH_JSON_ERROR) {
      json->broken = true;
      continue;
    }
    filled = ph_split_fill(split, may_wait, diag);
    if (filled == PH_SPLIT_WAIT || filled == PH_SPLIT_FAILED) {
      return filled;
    }
  }
}
