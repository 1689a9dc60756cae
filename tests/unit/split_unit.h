/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * What the tests of the splitter share: files in a directory of their own, and
 * transcripts.
 *
 * A transcript is what a stream gives, one line a record:
 *   NUMBER LINE TEXT              a good record (\n in it as $)
 *   NUMBER LINE code L:C MESSAGE  a broken one, and where, with its field if it
 *                                 has one; of one that is too long, also what
 *                                 was kept
 * and at the end "stopped", "end" or "failed: MESSAGE".
 */
#ifndef PH_TESTS_SPLIT_UNIT_H
#define PH_TESTS_SPLIT_UNIT_H

#include "unit.h"

#include "io/csv_in.h"
#include "io/json_in.h"
#include "io/split.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

enum { PLANE = 1u << 2, SPACE = 1u << 3 };

static const struct ph_field rows[] = {
    {PH_F_POINTS, PH_VECTORS, PLANE, true, "", "", ""},
    {PH_F_CLOSED, PH_BOOL, 0, false, "", "false", ""},
    {PH_F_KNOTS, PH_WORD | PH_NUMBERS, 0, false, "chordal|uniform", "", ""},
};
static const struct ph_schema schema = {"planar", rows, 3};
static const struct ph_field space_rows[] = {
    {PH_F_POINTS, PH_VECTORS, SPACE, true, "", "", ""}};
static const struct ph_schema space = {"spatial", space_rows, 1};
static const struct ph_field sphere_rows[] = {
    {PH_F_POINTS, PH_VECTORS, SPACE, false, "", "", ""},
    {PH_F_LONLAT, PH_VECTORS, PLANE, false, "", "", ""}};
static const struct ph_schema sphere = {"sphere", sphere_rows, 2};
static const struct ph_split_options automatic = {.format = PH_SPLIT_AUTO};
static const struct ph_split_options csv = {.format = PH_SPLIT_CSV};
/* ---- transcripts ---------------------------------------------------- */
static struct ph_buf transcript;
static inline void note(const char *text, size_t n) {
  for (size_t i = 0; i < n; i++) {
    ph_buf_put(&transcript, text[i] == '\n' ? "$" : text + i, 1);
  }
}

static inline void note_place(size_t line, size_t column) {
  char text[64];
  snprintf(text, sizeof text, "%zu:%zu ", line, column);
  ph_buf_puts(&transcript, text);
}

/* What a record is read as, so that all of its text counts; the text is on the
 * heap, in its own size. */
static inline void note_problem(const struct ph_record *record) {
  struct ph_problem problem;
  struct ph_echo echo;
  struct ph_diag diag = {PH_OK, "", "", 0, 0};
  const struct ph_value *points = &problem.field[PH_F_POINTS];
  enum ph_status status =
      record->columns
          ? ph_csv_in(record, &schema, &unit_arena, &problem, &echo, &diag)
          : ph_json_in(record, &schema, &unit_arena, &problem, &echo, &diag);
  ph_buf_puts(&transcript, "  ");
  if (echo.id) {
    note(echo.id, echo.id_n);
  }
  if (status != PH_OK) {
    ph_buf_puts(&transcript, diag.field);
    ph_buf_puts(&transcript, diag.message);
    note_place(ph_record_line(record, diag.field), diag.line);
  }
  for (size_t i = 0; status == PH_OK && i < points->n * points->dimension;
       i++) {
    char number[32];
    snprintf(number, sizeof number, " %.17g", points->v[i]);
    ph_buf_puts(&transcript, number);
  }
  ph_buf_puts(&transcript, "\n");
  ph_arena_reset(&unit_arena);
}

static inline void note_record(const struct ph_record *record,
                               const struct ph_diag *diag, bool problems) {
  char head[64];
  snprintf(head, sizeof head, "%zu %zu ", record->number, record->line);
  ph_buf_puts(&transcript, head);
  if (record->status == PH_OK) {
    note(record->text, record->n);
  } else {
    ck_assert_int_eq(diag->status, record->status);
    ph_buf_puts(&transcript, ph_status_code(record->status));
    ph_buf_puts(&transcript, " ");
    note_place(diag->line, diag->column);
    ph_buf_puts(&transcript, diag->field);
    ph_buf_puts(&transcript, *diag->field ? ": " : "");
    ph_buf_puts(&transcript, diag->message);
  }
  if (record->status == PH_E_LIMIT) {
    ph_buf_puts(&transcript, " ");
    note(record->text, record->n);
  }
  ph_buf_puts(&transcript, "\n");
  if (problems && record->status == PH_OK) {
    struct ph_record own = *record;
    char *text = malloc(record->n);
    ck_assert_ptr_nonnull(text);
    memcpy(text, record->text, record->n);
    own.text = text;
    note_problem(&own);
    free(text);
  }
}

/* Notes records until there is none; true when the splitter waits. */
static inline bool note_records(struct ph_split *split, bool may_wait,
                                bool problems) {
  struct ph_record record;
  struct ph_diag diag = {PH_OK, "", "", 0, 0};
  enum ph_split_state state;
  while ((state = ph_split_next(split, may_wait, &record, &diag)) ==
         PH_SPLIT_RECORD) {
    note_record(&record, &diag, problems);
  }
  if (state == PH_SPLIT_WAIT) {
    ck_assert(!may_wait);
    return true;
  }
  if (state == PH_SPLIT_FAILED) {
    ph_buf_puts(&transcript, "failed: ");
    ph_buf_puts(&transcript, diag.message);
  } else {
    ph_buf_puts(&transcript, ph_split_stopped(split) ? "stopped" : "end");
  }
  ck_assert_int_eq(ph_split_next(split, may_wait, &record, &diag),
                   PH_SPLIT_END);
  ph_buf_put(&transcript, "", 1);
  ck_assert(!transcript.failed);
  return false;
}

static inline void begin(struct ph_split *split, const char *const *files,
                         size_t n, const struct ph_split_options *options,
                         const struct ph_schema *fields) {
  struct ph_diag diag;
  transcript.n = 0;
  ck_assert_int_eq(ph_split_init(split, files, n, options, fields, &diag),
                   PH_OK);
}

/* ---- files ---------------------------------------------------------- */

static char directory[64];
static int standard_input = -1;

static inline void setup(void) {
  const char *parent = getenv("TMPDIR");
  snprintf(directory, sizeof directory, "%s/t_split.XXXXXX",
           parent && strlen(parent) < 40 ? parent : "/tmp");
  ck_assert_ptr_nonnull(mkdtemp(directory));
  ck_assert_int_eq(chdir(directory), 0);
  standard_input = dup(0);
}

static inline void finish(void) {
  static const char *const names[] = {"a.json", "a.jsonl", "a.NDJSON", "a.csv",
                                      "a.tsv",  "a.txt",   "b.json",   "b.csv"};
  for (size_t i = 0; i < COUNT(names); i++) {
    unlink(names[i]);
  }
  ck_assert_int_eq(chdir("/"), 0);
  ck_assert_int_eq(rmdir(directory), 0);
  dup2(standard_input, 0);
  close(standard_input);
  ph_buf_free(&transcript);
}

static inline void write_all(int fd, const char *text, size_t n) {
  while (n > 0) {
    ssize_t done = write(fd, text, n);
    ck_assert_int_gt(done, 0);
    text += done;
    n -= (size_t)done;
  }
}

static inline void put_file(const char *name, const char *text) {
  int fd = open(name, O_WRONLY | O_CREAT | O_TRUNC, 0600);
  ck_assert_int_ge(fd, 0);
  write_all(fd, text, strlen(text));
  close(fd);
}

static inline void ck_files(const char *const *files, size_t n,
                            const struct ph_split_options *options,
                            const struct ph_schema *fields,
                            const char *expected) {
  struct ph_split split;
  begin(&split, files, n, options, fields);
  ck_assert(!note_records(&split, true, false));
  ph_split_free(&split);
  ck_assert_str_eq(transcript.data, expected);
}

/* What is in a file gives. */
static inline void gives(const char *name, const char *text,
                         const char *expected) {
  put_file(name, text);
  ck_files(&name, 1, &automatic, &schema, expected);
}

static inline void gives_with(const struct ph_split_options *options,
                              const struct ph_schema *fields, const char *text,
                              const char *expected) {
  const char *name = "a.txt";
  put_file(name, text);
  ck_files(&name, 1, options, fields, expected);
}

/* ---- portions ------------------------------------------------------------ */

/* A pipe as standard input; its other end. */
static inline int open_pipe(void) {
  int ends[2];
  ck_assert_int_eq(pipe(ends), 0);
  ck_assert_int_eq(dup2(ends[0], 0), 0);
  close(ends[0]);
  return ends[1];
}

/* The transcript of a text that comes through a pipe in portions. */
static inline void by_portions(const struct ph_split_options *options,
                               const char *text, size_t n, size_t step) {
  int fd = open_pipe();
  struct ph_split split;
  begin(&split, NULL, 0, options, &schema);
  for (size_t i = 0; i < n; i += step) {
    write_all(fd, text + i, step < n - i ? step : n - i);
    if (i + step < n && !note_records(&split, false, true)) {
      break; /* it has stopped */
    }
  }
  close(fd);
  if (transcript.n == 0 || transcript.data[transcript.n - 1] != '\0') {
    ck_assert(!note_records(&split, true, true));
  }
  ph_split_free(&split);
}

static inline void ck_portions(const struct ph_split_options *options,
                               const char *text, size_t n) {
  static const size_t steps[] = {1, 2, 7};
  char *whole;
  by_portions(options, text, n, n + 1);
  whole = malloc(transcript.n);
  ck_assert_ptr_nonnull(whole);
  memcpy(whole, transcript.data, transcript.n);
  for (size_t i = 0; i < COUNT(steps); i++) {
    by_portions(options, text, n, steps[i]);
    ck_assert_msg(strcmp(transcript.data, whole) == 0,
                  "%.*s\nby %zu gives\n%s\ninstead of\n%s", (int)n, text,
                  steps[i], transcript.data, whole);
  }
  free(whole);
}

#endif
