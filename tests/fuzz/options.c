/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Fuzz target: the command line.  Each line of the input is an argument; what
 * was read is applied to a small problem.
 */
#include "fuzz.h"

#include "cli/option.h"
#include "cli/sweep.h"
#include "io/json_scan.h"

#include <getopt.h>
#include <math.h>
#include <stdbool.h>
#include <string.h>

enum { OPTIONS_ARGUMENTS_MAX = 64 };

/* A scan that broke off inside of -abc leaves getopt in the middle of it; 0
 * makes it begin anew. */
static void options_forget(void) {
  static char name[] = "x";
  char *argv[] = {name, NULL};
  optind = 0;
  FUZZ_REQUIRE(getopt(1, argv, "") == -1);
}

/* What a record says of the sweep is one line of JSON. */
static void options_check_names(struct ph_options *o, size_t which) {
  struct ph_swept *swept = calloc(o->sweeps_n + 1, sizeof *swept);
  const struct ph_echo echo = {0};
  const struct ph_heading heading = {&echo,       "planar", swept,
                                     o->sweeps_n, NULL,     0};
  struct ph_json_scan scan = {0};
  struct ph_buf out = {0};
  struct ph_diag diag = {PH_SYNTAX, "", "none", 0, 0};
  FUZZ_REQUIRE(swept != NULL);
  FUZZ_REQUIRE(ph_sweep_name(o->sweeps, o->sweeps_n, which, &o->arena, swept,
                             &diag) == PH_OK);
  ph_json_error(&out, &heading, &diag, NULL, false);
  FUZZ_REQUIRE(!out.failed);
  FUZZ_REQUIRE(ph_json_scan(&scan, out.data, out.n, true) == PH_JSON_DONE);
  FUZZ_REQUIRE(memchr(out.data, '\n', out.n) == out.data + scan.at);
  ph_buf_free(&out);
  free(swept);
}

static void options_apply(struct ph_options *o, size_t which) {
  double points[] = {0, 0, 1, 0, 1, 1, 0, 1};
  struct ph_problem problem = {0};
  struct ph_diag diag;
  enum ph_status status;
  problem.field[PH_F_POINTS] = (struct ph_value){
      .kind = PH_VECTORS, .v = points, .n = 4, .dimension = 2};
  for (size_t i = 0; i < o->assignments_n; i++) {
    problem.field[o->assignments[i].field] = o->assignments[i].value;
  }
  status =
      ph_sweep_apply(o->sweeps, o->sweeps_n, which, &o->arena, &problem, &diag);
  FUZZ_REQUIRE(status == PH_OK || status == PH_BAD_SHAPE);
  FUZZ_REQUIRE(status == PH_OK || diag.message[0] != '\0');
  options_check_names(o, which);
}

static void options_check(struct ph_options *o, int argc) {
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
  options_apply(o, 0);
  options_apply(o, o->sweep_count - 1);
}

FUZZ_TARGET(options, data, n) {
  struct ph_options options = {.command = ph_command_find("planar")};
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
    argv[argc++] = p;
  }
  argv[argc] = NULL;
  options_forget();
  status = ph_options_read(argc, argv, &options, &diag);
  FUZZ_REQUIRE(status == PH_OK || status == PH_USAGE);
  if (status == PH_OK) {
    options_check(&options, argc);
  } else {
    FUZZ_REQUIRE(diag.status == status && diag.message[0] != '\0');
  }
  ph_options_free(&options);
  free(text);
  return 0;
}
