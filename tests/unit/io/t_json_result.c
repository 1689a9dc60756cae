/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Result records read back: what the program writes, written again, is the same
 * to the byte; what is wrong is refused, and where it is is told. */
#include "unit.h"

#include "cli/option.h"
#include "cli/work.h"
#include "io/json_out.h"
#include "io/json_result.h"

enum { ARGUMENTS_MAX = 12 };

static struct ph_claim claim;
static struct ph_diag diag;
static struct ph_buf made, again;

static void finish(void) {
  ph_buf_free(&made);
  ph_buf_free(&again);
}

/* ---- the record of a command line -------------------------------------- */

/* What `phspline LINE' makes of one problem, without warnings. */
static void make(const char *line, const char *problem) {
  static char text[256];
  static char *argv[ARGUMENTS_MAX + 1];
  struct ph_options options = {.command = NULL};
  static const struct ph_worker none;
  struct ph_worker worker = none;
  struct ph_buf err = {0};
  struct ph_item item = {.record = {.text = problem,
                                    .n = strlen(problem),
                                    .file = "-",
                                    .line = 1,
                                    .number = 1}};
  char *warnings;
  int argc = 0;
  snprintf(text, sizeof text, "%s", line);
  for (char *p = strtok_r(text, " ", &warnings); p && argc < ARGUMENTS_MAX;
       p = strtok_r(NULL, " ", &warnings)) {
    argv[argc++] = p;
  }
  argv[argc] = NULL;
  options.command = ph_command_find(argv[0]);
  ck_assert_ptr_nonnull(options.command);
  ck_assert_int_eq(ph_options_read(argc, argv, &options, &diag), PH_OK);
  ph_buf_clear(&made, 0);
  ph_work(&options, &worker, &item, &made, &err);
  ck_assert_msg(item.status == PH_OK, "%s: %.*s", line, (int)err.n, err.data);
  ph_buf_put(&made, "", 1);
  warnings = strstr(made.data, ",\"warnings\":");
  if (warnings) {
    memcpy(warnings, "}\n", 3);
  }
  made.n = strlen(made.data);
  ph_buf_free(&err);
  ph_worker_free(&worker);
  ph_options_free(&options);
}

static enum ph_status read_text(const char *text, size_t n) {
  struct ph_record record = {
      .text = text, .n = n, .file = "-", .line = 1, .number = 1};
  ph_arena_reset(&unit_arena);
  memset(&diag, 0, sizeof diag);
  return ph_json_result_in(&record, &unit_arena, &claim, &diag);
}

/* Reads what was made and writes it again. */
static void ck_round_trip(const char *line, const char *problem) {
  struct ph_heading heading = {.echo = &claim.echo};
  make(line, problem);
  ck_assert_msg(read_text(made.data, made.n) == PH_OK, "%s: %s: %s", line,
                diag.field, diag.message);
  ck_assert(claim.solved);
  heading.command = claim.command;
  heading.set = claim.set;
  heading.set_n = claim.set_n;
  ph_buf_clear(&again, 0);
  ph_json_result(&again, &heading, &claim.result, false);
  ph_buf_put(&again, "", 1);
  ck_assert_str_eq(again.data, made.data);
}

/* ---- what the program writes ------------------------------------------- */

static const struct {
  const char *line, *problem;
} cases[] = {
    {"planar", "{\"points\":[[0,0],[2,1],[3,0],[5,2]]}"},
    {"planar --offset=0.1,-2 --sample=3",
     "{\"id\":\"a\",\"meta\":{\"b\":[1,2]},\"closed\":true,"
     "\"points\":[[0,0],[2,1],[3,0],[5,2]]}"},
    {"planar --spacing=0.3 --offset=0.5", "{\"points\":[[0,0],[2,1],[3,0]]}"},
    {"planar --solutions=all", "{\"id\":3,\"points\":[[0,0],[2,1],[3,0]]}"},
    {"planar --basis=atph --offset=1.5 --sample=2",
     "{\"points\":[[0,0],[2,1],[3,0],[5,2]],\"knots\":\"uniform\"}"},
    {"planar --basis=atph --convert=bezier --chord-error=0.01",
     "{\"points\":[[0,0],[2,1],[3,0],[5,2]]}"},
    {"planar --minimize=IES", "{\"points\":[[0,0],[2,1],[3,0],[5,2]]}"},
    {"spatial-hermite --offset=0.1 --sample=2",
     "{\"points\":[[0,0,0],[1,1,0],[2,0,1]]}"},
    {"spatial-hermite --sample=2 --frame=frenet --criterion=hc",
     "{\"points\":[[0,0,0],[1,1,0],[2,0,1]]}"},
    {"spatial-hermite --basis=atph --spacing=0.1 --frame=erf",
     "{\"points\":[[0,0,0],[1,1,0],[2,0,1]]}"},
    {"spatial-hermite --sample=1", "{\"points\":[[0,0,0],[1,1,1],[3,3,3]]}"},
    {"arclength", "{\"points\":[[0,0,0],[1,1,0],[2,0,1]]}"},
    {"arclength --all_minima --starts=2 --offset=0.05 --sample=1 --frame=rmf",
     "{\"points\":[[0,0,0],[1,1,0],[2,0,1]],\"lengths\":[1.6,1.8]}"},
    {"arclength --length_sigma=0.01",
     "{\"points\":[[0,0],[1,1],[2,0]],\"lengths\":[1.6,1.5]}"},
    {"sphere --sample=2 --offset=0.1",
     "{\"points\":[[1,0,0],[0,1,0],[0,0,1],[0,-1,0]]}"},
    {"sphere --closed --radius=2 --model=nielson --frame=rmf --sample=2",
     "{\"lonlat\":[[0,0],[40,10],[80,-20],[120,50]]}"},
    {"tc --sample=2 --offset=0.2", "{\"points\":[[0,0],[2,1],[3,0],[5,2]]}"},
    {"tc --blaschke --solutions=all",
     "{\"points\":[[0,1],[6,1]],\"tangents\":[[1,-1],[1,1]],\"mode\":\"g1\"}"},
    {"tc --mode=g1-pair --solutions=all --blaschke",
     "{\"points\":[[0,0],[2,1],[3,0]],\"tangents\":[[1,1],[1,0],[1,-1]]}"},
    {"tc --tolerance=0.01", "{\"curve\":[[0,0],[1,2],[3,2],[4,-1],[6,0]]}"},
};

PH_TEST_EACH(test_round_trip, COUNT(cases)) {
  ck_round_trip(cases[_i].line, cases[_i].problem);
}

/* What is only passed on. */
PH_TEST(test_heading) {
  const char sweep[] = "{\"knots\":\"uniform\",\n \"lengths[1]\":2}";
  char text[512];
  int n;
  make("planar", "{\"points\":[[0,0],[2,1],[3,0]]}");
  n = snprintf(text, sizeof text,
               "{\"status\":\"error\",\"sweep\":%s,\"set\":{\"closed\":true}}",
               sweep);
  ck_assert_int_eq(read_text(text, (size_t)n), PH_OK);
  ck_assert(!claim.solved);
  ck_assert_ptr_null(claim.command);
  ck_assert_uint_eq(claim.swept_n, 2);
  ck_assert_str_eq(claim.swept[0].name, "knots");
  ck_assert_str_eq(claim.swept[0].value, "\"uniform\"");
  ck_assert_str_eq(claim.swept[1].name, "lengths[1]");
  ck_assert_str_eq(claim.swept[1].value, "2");
  ck_assert_uint_eq(claim.set_n, 1);
  ck_assert_str_eq(claim.set[0].name, "closed");
  ck_assert_str_eq(claim.set[0].value, "true");
  ck_assert_ptr_null(claim.echo.id);
  n = snprintf(text, sizeof text,
               "{\"id\":7,\"status\":\"error\",\"command\":\"tc\",\"meta\":"
               "[1,2],\"more\":{\"segments\":3,\"segments\":3}}");
  ck_assert_int_eq(read_text(text, (size_t)n), PH_OK);
  ck_assert_str_eq(claim.command, "tc");
  ck_assert_uint_eq(claim.swept_n, 0);
  ck_assert_uint_eq(claim.set_n, 0);
  ck_assert(strncmp(claim.echo.id, "7", claim.echo.id_n) == 0);
  ck_assert_uint_eq(claim.echo.meta_n, 5);
}

/* What a record need not have is missing in the struct. */
PH_TEST(test_missing) {
  static const char text[] =
      "{\"status\":\"ok\",\"curve\":\"ph\",\"dimension\":2,\"degree\":1,"
      "\"closed\":false,\"segments\":[{\"control_points\":[[0,0],[1,0]]},"
      "{\"control_points\":[[1,0],[2,0]]}]}";
  const struct ph_curve *c = &claim.result.curve;
  ck_assert_int_eq(read_text(text, sizeof text - 1), PH_OK);
  ck_assert(claim.solved);
  ck_assert_uint_eq(c->n, 2);
  ck_abs(c->control_points[6], 2, 0);
  ck_assert_ptr_null(c->knots);
  ck_assert_ptr_null(c->lengths);
  ck_assert_ptr_null(c->preimage.alpha);
  ck_assert_ptr_null(c->preimage.v);
  ck_assert_uint_eq(c->preimage.n, 0);
  ck_assert_ptr_null(c->sphere.tensions);
  ck_assert(isnan(c->length));
  ck_assert_uint_eq(claim.result.diagnostics.known, 0);
  ck_assert_uint_eq(claim.result.offsets_n, 0);
  ck_assert_uint_eq(claim.result.samples.n, 0);
}

/* ---- what is refused --------------------------------------------------- */

/* Reads what was made, with the first `from' behind `after' replaced; NULL:
 * from there to the end. */
static enum ph_status changed(const char *after, const char *from,
                              const char *to) {
  static char text[1 << 16];
  char *at = strstr(made.data, after);
  char *rest;
  ck_assert_msg(at != NULL, "no %s", after);
  at = strstr(at, from);
  ck_assert_msg(at != NULL, "no %s", from);
  rest = at + strlen(from);
  snprintf(text, sizeof text, "%.*s%s%s", (int)(at - made.data), made.data, to,
           rest);
  return read_text(text, strlen(text));
}

static const struct {
  const char *line, *after, *from, *to;
  enum ph_status status;
  const char *field;
} refused[] = {
    {"planar", "", "\"curve\"", "\"kurve\"", PH_E_MISSING_FIELD, "curve"},
    {"planar", "", "\"curve\":\"ph\"", "\"curve\":\"pf\"", PH_E_BAD_VALUE,
     "curve"},
    {"planar", "", "\"curve\":\"ph\"", "\"curve\":null", PH_E_BAD_TYPE,
     "curve"},
    {"planar", "", "\"ok\"", "\"fine\"", PH_E_BAD_VALUE, "status"},
    {"planar", "", "\"command\":", "\"sweep\":[],\"command\":", PH_E_BAD_TYPE,
     "sweep"},
    {"planar", "", "\"command\":", "\"id\":[1],\"command\":", PH_E_BAD_TYPE,
     "id"},
    {"planar", "",
     "\"command\":", "\"curve\":\"ph\",\"command\":", PH_E_BAD_VALUE, "curve"},
    {"planar", "", "\"dimension\":2", "\"dimension\":4", PH_E_BAD_VALUE,
     "dimension"},
    {"planar", "", "\"degree\":5", "\"degree\":1e9", PH_E_BAD_VALUE, "degree"},
    {"planar", "", "\"degree\":5", "\"degree\":4.5", PH_E_BAD_VALUE, "degree"},
    {"planar", "", "\"degree\":5", "\"degree\":4", PH_E_BAD_SHAPE,
     "segments[0].control_points"},
    {"planar", "", "\"closed\":false", "\"closed\":0", PH_E_BAD_TYPE, "closed"},
    {"planar", "", "\"segments\"", "\"pieces\"", PH_E_MISSING_FIELD,
     "segments"},
    {"planar", "", "\"segments\":[", "\"segments\":[],\"x\":[", PH_E_BAD_SHAPE,
     "segments"},
    {"planar", "", "\"segments\":[", "\"segments\":{},\"x\":[", PH_E_BAD_TYPE,
     "segments"},
    {"planar", "", "\"segments\":[", "\"segments\":[1,", PH_E_BAD_TYPE,
     "segments[0]"},
    {"planar", "", "\"interval\":[0,", "\"interval\":[0,1,", PH_E_BAD_SHAPE,
     "segments[0].interval"},
    {"planar", "\"interval\":[2.", "2.", "2.0", PH_E_BAD_VALUE,
     "segments[1].interval"},
    {"planar", "", "\"interval\"", "\"in\"", PH_E_BAD_SHAPE,
     "segments[1].interval"},
    {"planar", "\"interval\":[2.", "\"length\"", "\"len\"", PH_E_MISSING_FIELD,
     "segments[1].length"},
    {"planar", "", "\"control_points\"", "\"points\"", PH_E_MISSING_FIELD,
     "segments[0].control_points"},
    {"planar", "", "\"control_points\":[[0,", "\"control_points\":[[0,0,",
     PH_E_BAD_SHAPE, "segments[0].control_points[0]"},
    {"planar", "", "\"control_points\":[[0,", "\"control_points\":[[1e999,",
     PH_E_NOT_FINITE, "segments[0].control_points[0][0]"},
    {"planar", "", "\"control_points\":[[0,", "\"control_points\":[[\"0\",",
     PH_E_BAD_TYPE, "segments[0].control_points[0][0]"},
    {"planar", "", "\"preimage\":[", "\"preimage\":[],\"x\":[", PH_E_BAD_SHAPE,
     "segments[0].preimage"},
    {"planar", "", "\"preimage\":[", "\"preimage\":[[0,0],", PH_E_BAD_SHAPE,
     "segments[1].preimage"},
    {"planar", "", "\"length\":", "\"length\":null,\"x\":", PH_E_BAD_TYPE,
     "segments[0].length"},
    {"planar", "", "\"diagnostics\":{", "\"diagnostics\":{\"shape_ok\":1,",
     PH_E_BAD_TYPE, "diagnostics.shape_ok"},
    {"planar", "", "\"diagnostics\":{", "\"diagnostics\":[],\"x\":{",
     PH_E_BAD_TYPE, "diagnostics"},
    {"planar", "", "\"diagnostics\":{", "\"diagnostics\":{\"F1\":\"1\",",
     PH_E_BAD_TYPE, "diagnostics.F1"},
    {"planar", "", "\"diagnostics\":{",
     "\"diagnostics\":{\"second_order\":\"minimizer\",", PH_E_BAD_VALUE,
     "diagnostics.second_order"},
    {"planar --offset=1", "\"offsets\"", "\"distance\"", "\"d\"",
     PH_E_MISSING_FIELD, "offsets[0].distance"},
    {"planar --offset=1", "\"offsets\"", "\"degree\":9", "\"degree\":8",
     PH_E_BAD_SHAPE, "offsets[0].segments[0].control_points"},
    {"planar --offset=1", "\"offsets\"", "\"segment\":1", "\"segment\":2",
     PH_E_BAD_VALUE, "offsets[0].segments[1].segment"},
    {"planar --offset=1", "\"offsets\"", "\"segment\":1", "\"segment\":-1",
     PH_E_BAD_VALUE, "offsets[0].segments[1].segment"},
    {"planar --offset=1", "\"offsets\"", "\"weights\"", "\"w\"",
     PH_E_MISSING_FIELD, "offsets[0].segments[0].weights"},
    {"planar --offset=1", "\"offsets\"", "\"cusps\":[",
     "\"cusps\":[{\"segment\":0}", PH_E_MISSING_FIELD, "offsets[0].cusps[0].t"},
    {"planar --offset=1", "\"offsets\"", "\"gaps\":[", "\"gaps\":[1,2",
     PH_E_BAD_VALUE, "offsets[0].gaps[1]"},
    {"planar --offset=1", "\"offsets\"", "\"gaps\":[", "\"gaps\":[\"1\"",
     PH_E_BAD_TYPE, "offsets[0].gaps[0]"},
    {"planar --offset=1", "\"offsets\"", "\"gaps\":[]", "\"gaps\":1",
     PH_E_BAD_TYPE, "offsets[0].gaps"},
    {"planar --basis=atph --offset=1", "\"offsets\"", "\"denominator\"",
     "\"d\"", PH_E_MISSING_FIELD, "offsets[0].segments[0].denominator"},
    {"planar --basis=atph --offset=1", "\"beziers\"", "\"control_points\"",
     "\"p\"", PH_E_MISSING_FIELD, "offsets[0].beziers[0].control_points"},
    {"planar --sample=1", "\"samples\"", "\"t\"", "\"u\"", PH_E_MISSING_FIELD,
     "samples[0].t"},
    {"planar --sample=1", "\"samples\"", "\"segment\":1", "\"segment\":9",
     PH_E_BAD_VALUE, "samples[2].segment"},
    {"planar --sample=1", "\"samples\"", "\"tangent\":[", "\"tangent\":[0,",
     PH_E_BAD_SHAPE, "samples[0].tangent"},
    {"planar --solutions=all", "\"solutions\":[", "\"segments\"", "\"s\"",
     PH_E_MISSING_FIELD, "solutions[0].segments"},
    {"planar --solutions=all", "\"solutions\":[",
     "\"good\":", "\"good\":1,\"g\":", PH_E_BAD_TYPE, "solutions[0].good"},
    {"tc", "\"intervals\"", "\"segments\":[0,", "\"segments\":[2,",
     PH_E_BAD_VALUE, "intervals[0].segments"},
    {"tc --mode=spline", "\"intervals\"", "\"root\":\"", "\"root\":\"x",
     PH_E_BAD_VALUE, "intervals[0].root"},
    {"tc --blaschke", "\"blaschke\"", "\"weights\":[", "\"weights\":[1,",
     PH_E_BAD_SHAPE, "segments[0].blaschke[0].weights"},
};

PH_TEST_EACH(test_refused, COUNT(refused)) {
  make(refused[_i].line, "{\"points\":[[0,0],[2,1],[3,0]]}");
  ck_assert_msg(changed(refused[_i].after, refused[_i].from, refused[_i].to) ==
                    refused[_i].status,
                "%s for %s: %s: %s", refused[_i].to, refused[_i].from,
                diag.field, diag.message);
  ck_assert_str_eq(diag.field, refused[_i].field);
  ck_assert_int_eq(diag.status, refused[_i].status);
  ck_assert_int_gt((int)strlen(diag.message), 0);
}

/* Of records on a sphere, and in space. */
PH_TEST(test_refused_elsewhere) {
  make("sphere", "{\"points\":[[1,0,0],[0,1,0],[0,0,1]]}");
  ck_assert_int_eq(changed("", "\"radius\":1", "\"radius\":0"), PH_E_BAD_VALUE);
  ck_assert_str_eq(diag.field, "radius");
  ck_assert_int_eq(changed("", "\"center\":", "\"c\":"), PH_E_MISSING_FIELD);
  ck_assert_str_eq(diag.field, "center");
  ck_assert_int_eq(changed("", "\"tensions\":[", "\"tensions\":[1,"),
                   PH_E_BAD_SHAPE);
  ck_assert_str_eq(diag.field, "tensions");
  ck_assert_int_eq(changed("", "\"indicators\":[0", "\"indicators\":[2"),
                   PH_E_BAD_VALUE);
  ck_assert_str_eq(diag.field, "indicators[0]");
  make("spatial-hermite --offset=1", "{\"points\":[[1,0,0],[0,1,0],[0,0,1]]}");
  ck_assert_int_eq(changed("", "\"e2\"", "\"e1\""), PH_E_BAD_VALUE);
  ck_assert_str_eq(diag.field, "offsets[0].vector");
  ck_assert_int_eq(read_text("[]", 2), PH_E_BAD_TYPE);
  ck_assert_str_eq(diag.field, "");
}

PH_FIXTURE(NULL, finish)
