/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Fuzz target: the command line, and what commands make of it.  Each line of
 * the input is an argument, the first one may name the command, and a line that
 * begins with { is the record in place of a small problem.  Whatever they say,
 * the outcome is a result or a failure of the record, in the form that was
 * asked for.
 */
#include "fuzz.h"

#include "cli/option.h"
#include "cli/work.h"
#include "io/csv_in.h"
#include "io/json_scan.h"

#include <getopt.h>
#include <math.h>
#include <stdbool.h>
#include <string.h>

enum { OPTIONS_ARGUMENTS_MAX = 64, OPTIONS_MEMORY_MAX = 1 << 24 };

static const double OPTIONS_SECONDS = 0.2;

/* Problems of the commands, in their order. */
static const char *const options_problems[] = {
    "{\"id\":\"a, b\",\"points\":[[0,0],[1,0],[1,1],[0,1]]}",
    "{\"points\":[[0,0,0],[1,0,1],[1,1,2],[0,1,0]]}",
    "{\"points\":[[0,0,0],[1,0,1],[1,1,2]],\"lengths\":[1.5,1.5]}",
    "{\"lonlat\":[[0,0],[20,10],[40,0],[60,30]],\"meta\":[1]}",
    "{\"points\":[[0,0],[1,0],[1,1],[0,2]]}",
    ("{\"points\":[[0,0,0],[3,1,0]],\"rulings\":[[0,0,1],[0,0,1]],"
     "\"tangents\":[[1,0,0],[1,1,0]],\"height\":[-1,1]}"),
    ("{\"points\":[[0,0,0],[1,0,0],[1,1,1],[0,1,0]],"
     "\"faces\":[[0,1,2,3]],\"continuity\":2}"),
    ("{\"command\":\"planar\",\"status\":\"error\",\"error\":{\"code\":"
     "\"syntax\",\"message\":\"m\"}}")};

/* A scan that broke off inside of -abc leaves getopt in the middle of it; 0
 * makes it begin anew. */
static void options_forget(void) {
  static char name[] = "x";
  char *argv[] = {name, NULL};
  optind = 0;
  FUZZ_REQUIRE(getopt(1, argv, "") == -1);
}

/* One value of JSON, on a line of its own or on several. */
static void options_check_object(const struct ph_buf *out, bool pretty) {
  struct ph_json_scan scan = {0};
  FUZZ_REQUIRE(ph_json_scan(&scan, out->data, out->n, true) == PH_JSON_DONE);
  FUZZ_REQUIRE(scan.at == out->n - 1 && out->data[scan.at] == '\n');
  FUZZ_REQUIRE(pretty ||
               memchr(out->data, '\n', out->n) == out->data + scan.at);
}

static size_t options_words(const char *p, const char *end, bool text) {
  size_t n = 0;
  while (p < end) {
    struct ph_csv_cell cell;
    if (text) {
      p += strspn(p, " ");
      n += *p != '\n';
      p += strcspn(p, " \n");
      p += *p == '\n';
    } else {
      p = ph_csv_cell(p, ph_csv_row_end(p, end), ',', &cell) + 1;
      n++;
    }
  }
  return n;
}

/* Rows of as many cells as the header has; text is NUL-terminated. */
static void options_check_table(const struct ph_buf *out, size_t header,
                                bool text, size_t columns) {
  struct ph_csv_scan scan = {.at = header};
  size_t row = header;
  while (row < out->n) {
    enum ph_csv_state state =
        ph_csv_scan(&scan, out->data, out->n, text ? '\n' : ',', true);
    FUZZ_REQUIRE(state == PH_CSV_ROW || (text && state == PH_CSV_BLANK));
    FUZZ_REQUIRE(out->data[scan.at - 1] == '\n');
    FUZZ_REQUIRE(state == PH_CSV_BLANK ||
                 options_words(out->data + row, out->data + scan.at, text) ==
                     columns);
    row = scan.at;
    scan = (struct ph_csv_scan){.at = row};
  }
}

static void options_check_output(const struct ph_options *o,
                                 const struct ph_buf *out, size_t header) {
  const struct ph_format_row *format = &ph_formats[o->format];
  if (format->is_objects) {
    options_check_object(out, o->pretty);
  } else if (format->is_table) {
    /* the header of text has a # before it */
    size_t columns =
        options_words(out->data, out->data + header, format->is_text) -
        format->is_text;
    options_check_table(out, header, format->is_text, columns);
  } else {
    FUZZ_REQUIRE(out->n == 0 || out->data[out->n - 1] == '\n');
  }
}

/* What the command makes of a problem by these options, for one combination of
 * swept values. */
static void options_work(const struct ph_options *o, size_t which,
                         const char *text) {
  const struct ph_format_row *format = &ph_formats[o->format];
  struct ph_swept *swept = calloc(o->sweeps_n + 1, sizeof *swept);
  struct ph_worker worker = {.arena = {.chunks = NULL}};
  struct ph_item item = {.record = {.text = text,
                                    .n = strlen(text),
                                    .file = "-",
                                    .line = 1,
                                    .number = 1},
                         .sweep = which};
  struct ph_buf out = {0}, err = {0};
  size_t header;
  FUZZ_REQUIRE(swept != NULL);
  for (size_t i = 0; i < o->sweeps_n; i++) {
    swept[i].name = o->sweeps[i].name;
  }
  if (format->header) {
    const struct ph_print print = ph_options_print(o); /* not of verify */
    format->header(&out, &print, swept, o->sweeps_n);
  }
  header = out.n;
  o->command->work(o, &worker, &item, &out, &err);
  FUZZ_REQUIRE(!out.failed && !err.failed);
  FUZZ_REQUIRE(item.status == PH_OK ||
               ph_status_class(item.status) == PH_CLASS_RECORD);
  FUZZ_REQUIRE(item.status == PH_OK || err.n > 0);
  ph_buf_put(&out, "", 1);
  out.n--;
  options_check_output(o, &out, header);
  ph_buf_free(&out);
  ph_buf_free(&err);
  ph_worker_free(&worker);
  free(swept);
}

/* Whether a splitter would hand it out. */
static bool options_is_json(const char *text) {
  struct ph_json_scan scan = {0};
  size_t n = strlen(text);
  return ph_json_scan(&scan, text, n, true) == PH_JSON_DONE && scan.at == n;
}

static void options_check(struct ph_options *o, int argc, const char *text) {
  if (o->help || o->version) {
    return;
  }
  FUZZ_REQUIRE(o->jobs >= 1 && o->jobs <= 1024 && o->sweep_count >= 1);
  FUZZ_REQUIRE(o->files_n >= 1 && o->files_n <= (size_t)argc);
  for (size_t i = 0; i < o->files_n; i++) {
    FUZZ_REQUIRE(o->files[i] != NULL);
  }
  for (size_t i = 0; i < o->offsets_n; i++) {
    FUZZ_REQUIRE(isfinite(o->offsets[i]));
  }
  o->max_memory =
      o->max_memory < OPTIONS_MEMORY_MAX ? o->max_memory : OPTIONS_MEMORY_MAX;
  o->time_limit = OPTIONS_SECONDS;
  options_work(o, 0, text);
  options_work(o, o->sweep_count - 1, text);
}

FUZZ_TARGET(options, data, n) {
  const struct ph_command *command = &ph_commands[0];
  struct ph_options options = {.version = false};
  const char *record = NULL;
  struct ph_diag diag = {PH_OK, "", "", 0, 0};
  char *text = malloc(n + 1), *argv[OPTIONS_ARGUMENTS_MAX + 2];
  static char name[] = "planar";
  enum ph_status status;
  int argc = 0;
  FUZZ_REQUIRE(text != NULL);
  if (n > 0) {
    memcpy(text, data, n);
  }
  text[n] = '\0';
  argv[argc++] = name;
  for (char *p = text, *end; p < text + n && argc <= OPTIONS_ARGUMENTS_MAX;
       p = end + 1) {
    end = p + strcspn(p, "\n");
    *end = '\0';
    if (*p == '{' && options_is_json(p)) {
      record = p;
    } else if (argc == 1 && p == text && ph_command_find(p)) {
      command = ph_command_find(p);
    } else {
      argv[argc++] = p;
    }
  }
  argv[argc] = NULL;
  options_forget();
  options.command = command;
  status = ph_options_read(argc, argv, &options, &diag);
  FUZZ_REQUIRE(status == PH_OK || status == PH_E_USAGE);
  FUZZ_REQUIRE(sizeof options_problems / sizeof *options_problems ==
               ph_commands_n);
  if (status == PH_OK) {
    options_check(&options, argc,
                  record ? record : options_problems[command - ph_commands]);
  } else {
    FUZZ_REQUIRE(diag.status == status && diag.message[0] != '\0');
  }
  ph_options_free(&options);
  free(text);
  return 0;
}
