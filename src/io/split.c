/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The splitter's files and window (see split.h).
 *
 * The bytes of a file pass through one buffer.  Records are handed out as
 * slices of it; what was handed out is dropped when the next one is asked for.
 * When the buffer is full, the rest is moved to its front if that frees half
 * of it, else the buffer doubles: moving costs at most as much as reading.
 * After a huge record it shrinks to what the present ones need.
 *
 * How records are found in the window: split_json.c, split_csv.c.
 */
#include "io/split.h"

#include "base/mem.h"
#include "base/suggest.h"

#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <stdint.h>
#include <string.h>
#include <unistd.h>

enum {
  FIRST_CAPACITY = 1 << 16, /* what a pipe of Linux holds */
  LEAST_READ = 1 << 12,     /* less room than a page is not worth a call */
  KEEP_CAPACITY = 1 << 20,  /* buffers up to this never shrink */
  SHRINK_RATIO = 8,         /* a buffer so many times too large shrinks */
  RELEASED = KEEP_CAPACITY  /* a record that is large */
};

/* ---- the window ----------------------------------------------------- */

static void move_to_front(struct ph_split *split) {
  if (split->start > 0) {
    memmove(split->data, split->data + split->start,
            split->fill - split->start);
    split->fill -= split->start;
    split->start = 0;
  }
}

static bool make_room(struct ph_split *split) {
  size_t capacity = split->capacity ? 2 * split->capacity : FIRST_CAPACITY;
  char *data;
  if (split->capacity - split->fill >= LEAST_READ) {
    return true;
  }
  if (split->capacity && split->start >= split->capacity / 2) {
    move_to_front(split);
    return true;
  }
  if (split->capacity > SIZE_MAX / 2) {
    return false;
  }
  move_to_front(split);
  data = ph_realloc(split->data, capacity);
  if (!data) {
    return false;
  }
  split->data = data;
  split->capacity = capacity;
  return true;
}

/* Gives memory back that neither the last record nor the window needs. */
static void shrink(struct ph_split *split, size_t last_record) {
  size_t need = split->fill - split->start;
  size_t capacity = FIRST_CAPACITY;
  char *data;
  need = need > last_record ? need : last_record;
  if (split->capacity <= KEEP_CAPACITY ||
      need > split->capacity / SHRINK_RATIO) {
    return;
  }
  while (capacity < 2 * need) {
    capacity *= 2;
  }
  move_to_front(split);
  data = ph_realloc(split->data, capacity);
  if (data) {
    split->data = data;
    split->capacity = capacity;
  }
}

static void advance(struct ph_split_place *place, const char *p, size_t n) {
  const char *end = p + n;
  const char *line_end;
  while ((line_end = memchr(p, '\n', (size_t)(end - p)))) {
    place->line++;
    place->column = 1;
    p = line_end + 1;
  }
  place->column += (size_t)(end - p);
}

void ph_split_drop(struct ph_split *split, size_t n) {
  if (n > 0) {
    advance(&split->place, split->data + split->start, n);
    split->passed += n;
    split->offset += n;
    split->start += n;
  }
}

void ph_split_give(struct ph_split *split, size_t n, size_t taken,
                   struct ph_record *record) {
  *record = (struct ph_record){.text = split->data + split->start,
                               .n = n,
                               .file = split->name,
                               .line = split->place.line,
                               .byte = split->offset,
                               .number = ++split->number,
                               .status = PH_OK};
  split->done = taken;
}

void ph_split_over(struct ph_split *split) {
  struct ph_buf kept = split->over.kept;
  ph_buf_clear(&kept, KEEP_CAPACITY);
  split->over = (struct ph_split_over){.on = true,
                                       .place = split->place,
                                       .byte = split->offset,
                                       .kept = kept,
                                       .one_line = true};
}

void ph_split_give_over(struct ph_split *split, size_t taken,
                        struct ph_record *record, struct ph_diag *diag) {
  ph_split_give(split, 0, taken, record);
  record->text = split->over.kept.data;
  record->n = split->over.kept.n;
  record->line = split->over.place.line;
  record->byte = split->over.byte;
  record->status = split->over.kept.failed
                       ? ph_fail_memory(diag)
                       : ph_fail(diag, PH_E_LIMIT, NULL,
                                 "the record is longer than the %zu bytes of "
                                 "--max-record-bytes",
                                 split->options.most);
  diag->line = record->line;
  split->over.on = false;
}

void ph_split_locate(const struct ph_split *split, size_t offset,
                     struct ph_diag *diag) {
  struct ph_split_place place = split->place;
  if (offset > 0) {
    advance(&place, split->data + split->start, offset);
  }
  diag->line = place.line;
  diag->column = place.column;
}

/* ---- reading -------------------------------------------------------- */

static enum ph_split_state fail(struct ph_split *split, const char *what,
                                struct ph_diag *diag) {
  split->ended = true;
  ph_fail(diag, PH_E_INPUT, NULL, "cannot %s %s: %s", what, split->name,
          strerror(errno));
  return PH_SPLIT_FAILED;
}

static enum ph_split_state fail_memory(struct ph_split *split,
                                       struct ph_diag *diag) {
  split->ended = true;
  ph_fail_memory(diag);
  return PH_SPLIT_FAILED;
}

/* Waits until the file can be read; false: it cannot, and waiting is not
 * allowed.  A poll that fails leaves the verdict to read. */
static bool readable(int fd, bool may_wait) {
  struct pollfd descriptor = {.fd = fd, .events = POLLIN};
  int n;
  do {
    n = poll(&descriptor, 1, may_wait ? -1 : 0);
  } while (n < 0 && errno == EINTR);
  return n != 0;
}

enum ph_split_state ph_split_fill(struct ph_split *split, bool may_wait,
                                  struct ph_diag *diag) {
  ssize_t n;
  if (split->end_of_file) {
    return PH_SPLIT_END;
  }
  if (!make_room(split)) {
    return fail_memory(split, diag);
  }
  if (!may_wait && !readable(split->fd, false)) {
    return PH_SPLIT_WAIT;
  }
  while ((n = read(split->fd, split->data + split->fill,
                   split->capacity - split->fill)) < 0) {
    /* A descriptor that was inherited may be a non-blocking one. */
    bool again = errno == EAGAIN || errno == EWOULDBLOCK;
    if (!again && errno != EINTR) {
      return fail(split, "read", diag);
    }
    if (again && !readable(split->fd, may_wait)) {
      return PH_SPLIT_WAIT;
    }
  }
  if (n == 0) {
    split->end_of_file = true;
    return PH_SPLIT_END;
  }
  split->fill += (size_t)n;
  return PH_SPLIT_RECORD;
}

/* ---- files ---------------------------------------------------------- */

/* Whether the name ends with one of the suffixes in a list ".json|.csv". */
static bool has_suffix(const char *name, const char *suffixes) {
  const char *dot = strrchr(name, '.');
  while (dot && *suffixes) {
    size_t n = strcspn(suffixes, "|");
    if (strlen(dot) == n) {
      char suffix[16] = "";
      memcpy(suffix, suffixes, n);
      if (ph_word_is(dot, n, suffix)) {
        return true;
      }
    }
    suffixes += n + (suffixes[n] == '|');
  }
  return false;
}

static void close_file(struct ph_split *split) {
  if (split->fd > STDIN_FILENO) {
    close(split->fd); /* nothing was written: no failure matters */
  }
  split->fd = -1;
  ph_split_xml_close(split);
}

static enum ph_split_state open_next(struct ph_split *split,
                                     struct ph_diag *diag) {
  const char *name;
  if (ph_split_is_part(split) && !ph_split_cut_skip(split)) {
    return PH_SPLIT_END;
  }
  name = split->files[split->next_file++];
  split->name = name;
  split->before = split->number;
  if (!make_room(split)) {
    return fail_memory(split, diag);
  }
  split->fd = STDIN_FILENO;
  if (strcmp(name, "-") != 0) {
    do {
      split->fd = open(name, O_RDONLY | O_CLOEXEC);
    } while (split->fd < 0 && errno == EINTR);
  }
  if (split->fd < 0) {
    return fail(split, "open", diag);
  }
  split->end_of_file = false;
  split->lines_suffix = has_suffix(name, ".ndjson|.jsonl|.geojsonl");
  split->delimiter = split->options.delimiter ? split->options.delimiter
                     : split->options.format == PH_SPLIT_TEXT ? PH_CSV_WORDS
                     : has_suffix(name, ".tsv")               ? '\t'
                                                              : PH_CSV_ANY;
  split->format = split->options.format != PH_SPLIT_AUTO ? split->options.format
                  : has_suffix(name, ".json|.ndjson|.jsonl") ? PH_SPLIT_JSON
                  : has_suffix(name, ".geojson|.geojsonl|.geojsons")
                      ? PH_SPLIT_GEOJSON
                  : has_suffix(name, ".obj")      ? PH_SPLIT_OBJ
                  : has_suffix(name, ".svg")      ? PH_SPLIT_SVG
                  : has_suffix(name, ".gpx")      ? PH_SPLIT_GPX
                  : has_suffix(name, ".csv|.tsv") ? PH_SPLIT_CSV
                                                  : PH_SPLIT_AUTO;
  split->guessed = split->format == PH_SPLIT_AUTO;
  split->begun = false;
  split->blanks = 0;
  split->start = 0;
  split->fill = 0;
  split->place = (struct ph_split_place){1, 1};
  split->offset = 0;
  split->json = (struct ph_split_json){.line_start = true, .lines = true};
  ph_buf_clear(&split->csv.id, 0);
  split->csv = (struct ph_split_csv){.row = 0};
  ph_buf_clear(&split->geojson.problem, 0);
  split->geojson =
      (struct ph_split_geojson){.told = split->format != PH_SPLIT_JSON ||
                                        split->options.format == PH_SPLIT_JSON};
  return PH_SPLIT_RECORD;
}

static void note_empty(struct ph_split *split) {
  if (split->empty.n < PH_SPLIT_EMPTY_NAMES) {
    split->empty.names[split->empty.n] = split->name;
  }
  split->empty.n++;
}

/* Skips a byte-order mark, which can be told from other text only when three
 * bytes are there. */
static enum ph_split_state skip_mark(struct ph_split *split, bool may_wait,
                                     struct ph_diag *diag) {
  static const char mark[3] = {'\xEF', '\xBB', '\xBF'};
  while (!split->begun) {
    const char *p = split->data + split->start;
    size_t n = split->fill - split->start;
    bool maybe = n == 0 || memcmp(p, mark, n < 3 ? n : 3) == 0;
    if (maybe && n < 3) {
      enum ph_split_state state = ph_split_fill(split, may_wait, diag);
      if (state == PH_SPLIT_RECORD) {
        continue;
      }
      if (state != PH_SPLIT_END) {
        return state;
      }
      maybe = false;
    }
    split->start += maybe ? 3 : 0; /* counts for no column */
    split->offset += maybe ? 3 : 0;
    split->begun = true;
  }
  return PH_SPLIT_RECORD;
}

/* Tells JSON from CSV by the first byte that is no blank.  Blank lines before
 * it mean nothing in either and are dropped, lest they are read again. */
static enum ph_split_state detect(struct ph_split *split, bool may_wait,
                                  struct ph_diag *diag) {
  while (split->format == PH_SPLIT_AUTO) {
    const char *p = split->data + split->start;
    const char *end = split->data + split->fill;
    const char *first = ph_json_blanks(p + split->blanks, end);
    const char *line = first;
    enum ph_split_state state;
    if (first < end) {
      split->format = memchr("{[\x1e", *first, 3) ? PH_SPLIT_JSON
                      : *first == '<'             ? PH_SPLIT_XML
                                                  : PH_SPLIT_CSV;
      split->geojson.told = split->format != PH_SPLIT_JSON;
    }
    while (line > p + split->blanks && line[-1] != '\n') {
      line--;
    }
    line = line > p + split->blanks ? line : p;
    split->blanks = (size_t)(first - line);
    split->csv.blanks = split->csv.blanks && line == p;
    ph_split_drop(split, (size_t)(line - p));
    if (split->format != PH_SPLIT_AUTO) {
      break;
    }
    if (split->options.most && split->blanks > split->options.most) {
      ph_split_drop(split, split->blanks);
      split->blanks = 0;
      split->csv.blanks = true;
    }
    state = ph_split_fill(split, may_wait, diag);
    if (state != PH_SPLIT_RECORD) {
      return state;
    }
  }
  return PH_SPLIT_RECORD;
}

/* ---- the stream ----------------------------------------------------- */

static enum ph_status check_options(struct ph_split *split,
                                    struct ph_diag *diag) {
  const char *names = split->options.columns;
  struct ph_csv_columns *columns;
  enum ph_status status;
  if (split->delimiter && strchr("\"\r\n", split->delimiter)) {
    return ph_fail(diag, PH_E_USAGE, "--delimiter",
                   "must be neither a quote nor a line break");
  }
  if (!names) {
    return PH_OK;
  }
  status =
      ph_split_columns(split, names, strlen(names), ',', true, &columns, diag);
  if (status != PH_OK && status != PH_E_NO_MEMORY) {
    diag->status = status = PH_E_USAGE;
    diag->line = 0;
    diag->column = 0;
  }
  return status;
}

enum ph_status ph_split_init(struct ph_split *split, const char *const *files,
                             size_t n, const struct ph_split_options *options,
                             const struct ph_schema *schema,
                             struct ph_diag *diag) {
  static const char *const standard_input[] = {"-"};
  enum ph_status status;
  *split = (struct ph_split){.files = n ? files : standard_input,
                             .files_n = n ? n : 1,
                             .options = *options,
                             .schema = schema,
                             .delimiter = options->delimiter,
                             .fd = -1};
  status = check_options(split, diag);
  return status == PH_OK && ph_split_is_part(split)
             ? ph_split_cut_init(split, diag)
             : status;
}

/* The next record of the file that is open. */
static enum ph_split_state next_in_file(struct ph_split *split, bool may_wait,
                                        struct ph_record *record,
                                        struct ph_diag *diag) {
  enum ph_split_state state = skip_mark(split, may_wait, diag);
  if (state == PH_SPLIT_RECORD) {
    state = detect(split, may_wait, diag);
  }
  if (state == PH_SPLIT_RECORD && !split->geojson.told) {
    state = ph_split_tell_geojson(split, may_wait, diag);
  }
  if (state == PH_SPLIT_RECORD && ph_split_is_part(split) &&
      !split->cut.sought) {
    state = ph_split_cut_seek(split, may_wait, diag);
  }
  if (state != PH_SPLIT_RECORD) {
    return state;
  }
  switch (split->format) {
  case PH_SPLIT_JSON:
    return ph_split_json(split, may_wait, record, diag);
  case PH_SPLIT_GEOJSON:
    return ph_split_geojson(split, may_wait, record, diag);
  case PH_SPLIT_OBJ:
    return ph_split_obj(split, may_wait, record, diag);
  case PH_SPLIT_SVG:
  case PH_SPLIT_GPX:
  case PH_SPLIT_XML:
    return ph_split_xml(split, may_wait, record, diag);
  default:
    return ph_split_csv(split, may_wait, record, diag);
  }
}

void ph_split_release(struct ph_split *split) {
  if (split->done >= RELEASED && !split->geojson.text.more) {
    ph_split_drop(split, split->done);
    split->done = 0;
    shrink(split, 0);
  }
}

enum ph_split_state ph_split_next(struct ph_split *split, bool may_wait,
                                  struct ph_record *record,
                                  struct ph_diag *diag) {
  size_t last_record = split->done;
  if (split->geojson.text.more) {
    return ph_split_geojson_line(split, record, diag);
  }
  ph_split_drop(split, split->done);
  split->done = 0;
  shrink(split, last_record);
  while (!split->ended && !split->stopped) {
    enum ph_split_state state;
    if (split->fd < 0 && split->next_file == split->files_n) {
      break;
    }
    state = split->fd < 0 ? open_next(split, diag) : PH_SPLIT_RECORD;
    if (state == PH_SPLIT_RECORD) {
      state = next_in_file(split, may_wait, record, diag);
    }
    if (state != PH_SPLIT_END) {
      return state;
    }
    if (split->fd >= 0 && split->number == split->before) {
      note_empty(split);
    }
    close_file(split);
  }
  return PH_SPLIT_END;
}

bool ph_split_stopped(const struct ph_split *split) {
  return split->stopped;
}

void ph_split_free(struct ph_split *split) {
  close_file(split);
  while (split->all_columns) {
    struct ph_csv_columns *columns = split->all_columns;
    split->all_columns = columns->older;
    ph_free(columns);
  }
  ph_buf_free(&split->csv.id);
  ph_buf_free(&split->geojson.problem);
  ph_buf_free(&split->over.kept);
  ph_free(split->data);
  split->data = NULL;
}
