/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A stream of bytes through the splitter and the readers, for the targets json,
 * csv and xml.
 *
 * The bytes come through a pipe that is standard input, once as a whole and
 * once in portions with nothing to read in between.  Records, places and
 * values must be the same, and within what the headers say.
 */
#ifndef PH_TESTS_FUZZ_STREAM_H
#define PH_TESTS_FUZZ_STREAM_H

#include "fuzz.h"

#include "base/buf.h"
#include "io/csv_in.h"
#include "io/json_in.h"
#include "io/json_out.h"
#include "io/json_scan.h"
#include "io/split.h"
#include "io/value.h"
#include "solve/method.h"

#include <math.h>
#include <string.h>
#include <unistd.h>

/* A pipe holds at least so many bytes, so that writing never waits. */
enum { STREAM_MAX = 4096 };

/* Kinds of values that the fields of `planar' are not. */
static const struct ph_field stream_rows[] = {
    {PH_F_CURVE, PH_VECTORS | PH_POLYLINE, 1u << 2 | 1u << 3, false, NULL, "",
     ""},
    {PH_F_LAMBDA, PH_NUMBER | PH_NUMBERS, 0, false, NULL, "", ""},
};
static const struct ph_schema stream_schema = {"tc", stream_rows, 2};

/* Elements of XML are told by their line. */
static bool stream_by_line;

static void stream_note(struct ph_buf *log, const void *bytes, size_t n) {
  ph_buf_put(log, bytes, n);
}

static void stream_note_size(struct ph_buf *log, size_t n) {
  stream_note(log, &n, sizeof n);
}

static void stream_check_diag(const struct ph_diag *diag,
                              enum ph_status status) {
  FUZZ_REQUIRE(diag->status == status);
  FUZZ_REQUIRE(ph_status_class(status) == PH_CLASS_RECORD);
  FUZZ_REQUIRE(diag->message[0] != '\0');
}

/* A value is of a kind and size that its row allows, and finite. */
static void stream_check_value(struct ph_buf *log, const struct ph_field *row,
                               const struct ph_value *value) {
  stream_note_size(log, (size_t)value->kind);
  if (value->kind == PH_ABSENT) {
    return;
  }
  FUZZ_REQUIRE(row->kinds & (unsigned)value->kind);
  if (value->kind == PH_WORD) {
    stream_note(log, value->word, strlen(value->word));
  }
  if (value->kind & (PH_VECTORS | PH_POLYLINE) && value->n > 0) {
    FUZZ_REQUIRE(row->dimensions >> value->dimension & 1);
  }
  if (value->kind == PH_POLYLINE) {
    size_t n = 0;
    for (size_t i = 0; i < value->sizes_n; i++) {
      FUZZ_REQUIRE(value->sizes[i] >= 1);
      n += value->sizes[i];
    }
    FUZZ_REQUIRE(n == value->n && n >= 1);
    stream_note(log, value->sizes, value->sizes_n * sizeof *value->sizes);
  }
  if (value->kind & (PH_VECTORS | PH_POLYLINE | PH_NUMBERS)) {
    FUZZ_REQUIRE(value->kind != PH_NUMBERS || value->dimension == 1);
    stream_note_size(log, value->n);
    for (size_t i = 0; i < value->n * value->dimension; i++) {
      FUZZ_REQUIRE(isfinite(value->v[i]));
      stream_note(log, &value->v[i], sizeof value->v[i]);
    }
  }
}

/* Whatever a record holds, its error record is one line of JSON. */
static void stream_check_output(const struct ph_echo *echo,
                                const struct ph_diag *diag,
                                struct ph_buf *log) {
  struct ph_heading heading = {.echo = echo, .command = "planar"};
  struct ph_json_scan scan = {0};
  struct ph_buf out = {0};
  ph_json_error(&out, &heading, diag, "file", false);
  FUZZ_REQUIRE(!out.failed);
  FUZZ_REQUIRE(ph_json_scan(&scan, out.data, out.n, true) == PH_JSON_DONE);
  FUZZ_REQUIRE(scan.at == out.n - 1);
  FUZZ_REQUIRE(memchr(out.data, '\n', out.n) == out.data + scan.at);
  stream_note(log, out.data, out.n);
  ph_buf_free(&out);
}

/* A record that the splitter has found good. */
static void stream_check_problem(const struct ph_record *record,
                                 const struct ph_schema *schema,
                                 struct ph_arena *arena, struct ph_buf *log) {
  struct ph_problem problem = {0};
  struct ph_echo echo = {0};
  struct ph_diag diag = {PH_E_SYNTAX, "", "none", 0, 0};
  enum ph_status status =
      record->columns
          ? ph_csv_in(record, schema, arena, &problem, &echo, &diag)
          : ph_json_in(record, schema, arena, &problem, &echo, &diag);
  stream_note_size(log, (size_t)status);
  if (status != PH_OK) {
    stream_check_diag(&diag, status);
    if (!diag.line) {
      diag.line = ph_record_line(record, diag.field);
    }
    FUZZ_REQUIRE(diag.line >= record->line);
  }
  for (size_t i = 0; status == PH_OK && i < schema->fields_n; i++) {
    const struct ph_field *row = &schema->fields[i];
    stream_check_value(log, row, &problem.field[row->id]);
  }
  stream_check_output(&echo, &diag, log);
}

static void stream_check_record(const struct ph_record *record,
                                const struct ph_diag *diag,
                                struct ph_arena *arena, struct ph_buf *log) {
  stream_note_size(log, record->number);
  stream_note_size(log, record->line);
  stream_note(log, record->text, record->n);
  FUZZ_REQUIRE(record->line >= 1);
  if (record->status == PH_OK) {
    /* in its own memory, so that reading beyond its end is seen */
    struct ph_record own = *record;
    char *text = malloc(record->n + !record->n);
    FUZZ_REQUIRE(text != NULL);
    memcpy(text, record->text, record->n);
    own.text = text;
    stream_check_problem(&own, &ph_method_planar.schema, arena, log);
    if (!own.columns) {
      stream_check_problem(&own, &stream_schema, arena, log);
    }
    free(text);
    ph_arena_reset(arena);
  } else {
    struct ph_echo none = {0};
    stream_check_diag(diag, record->status);
    FUZZ_REQUIRE(diag->line >= 1);
    FUZZ_REQUIRE(diag->column >= 1 || record->status == PH_E_LIMIT ||
                 stream_by_line);
    stream_check_output(&none, diag, log);
  }
}

/* The bytes, and how far they went through the pipe. */
struct stream_feed {
  const uint8_t *data;
  size_t n, at, portion;
  int end;
};

/* Sends the next portion; true when it was the last one. */
static bool stream_send(struct stream_feed *feed) {
  size_t left = feed->n - feed->at;
  size_t n = left < feed->portion ? left : feed->portion;
  FUZZ_REQUIRE(write(feed->end, feed->data + feed->at, n) == (ssize_t)n);
  feed->at += n;
  if (feed->at < feed->n) {
    return false;
  }
  close(feed->end);
  return true;
}

/* Splits the bytes, given portion by portion; notes what comes out. */
static void stream_run(const uint8_t *data, size_t n, size_t portion,
                       const struct ph_split_options *options,
                       struct ph_buf *log) {
  static const char *const input[] = {"-"};
  struct stream_feed feed = {data, n, 0, portion, -1};
  struct ph_arena arena = {0};
  struct ph_split split;
  struct ph_record record;
  struct ph_diag diag;
  enum ph_split_state state = PH_SPLIT_RECORD;
  int ends[2];
  bool all;
  FUZZ_REQUIRE(pipe(ends) == 0 && dup2(ends[0], STDIN_FILENO) == 0);
  close(ends[0]);
  feed.end = ends[1];
  all = stream_send(&feed);
  FUZZ_REQUIRE(ph_split_init(&split, input, 1, options,
                             &ph_method_planar.schema, &diag) == PH_OK);
  /* Each turn takes a record or gives a byte: at most one record a byte, and
   * one for an end that comes too early. */
  for (size_t turns = 0; state == PH_SPLIT_RECORD || state == PH_SPLIT_WAIT;
       turns++) {
    FUZZ_REQUIRE(turns <= 2 * n + 2);
    state = ph_split_next(&split, all, &record, &diag);
    if (state == PH_SPLIT_RECORD) {
      stream_check_record(&record, &diag, &arena, log);
    } else if (state == PH_SPLIT_WAIT) {
      FUZZ_REQUIRE(!all);
      all = stream_send(&feed);
    }
  }
  FUZZ_REQUIRE(state == PH_SPLIT_END);
  FUZZ_REQUIRE(ph_split_next(&split, true, &record, &diag) == PH_SPLIT_END);
  stream_note_size(log, ph_split_stopped(&split));
  ph_split_free(&split);
  ph_arena_free(&arena);
  if (!all) {
    close(feed.end);
  }
}

/* Whole and in portions: the same. */
static void stream_check(const uint8_t *data, size_t n,
                         const struct ph_split_options *options) {
  struct ph_buf whole = {0}, portions = {0};
  size_t portion = n > 0 ? 1 + data[n / 2] % 7 : 1;
  if (n > STREAM_MAX) {
    return;
  }
  stream_run(data, n, STREAM_MAX, options, &whole);
  stream_run(data, n, portion, options, &portions);
  FUZZ_REQUIRE(!whole.failed && !portions.failed);
  FUZZ_REQUIRE(whole.n == portions.n &&
               memcmp(whole.data, portions.data, whole.n) == 0);
  ph_buf_free(&whole);
  ph_buf_free(&portions);
}

#endif
