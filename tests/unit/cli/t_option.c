/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The command line of a command whose fields are an option's namesake and the
 * control points of a curve, and its help. */
#include "unit.h"

#include "cli/help.h"
#include "cli/option.h"
#include "cli/work.h"
#include "curve/bezier/convert.h"

static const struct ph_field rows[] = {
    {PH_F_CURVE, PH_VECTORS | PH_POLYLINE, 1u << 2, false, NULL, "none",
     "control points of a Bezier curve, or of several"},
    {PH_F_TOLERANCE, PH_NUMBER, 0, false, NULL, "none", "how near to come"},
};
static const struct ph_method named = {
    .schema = {"named", rows, 2}, .title = "A title", .dimension = 2};
static const struct ph_method other = {
    .schema = {"other", rows, 1}, .title = "A title", .dimension = 2};
static const struct ph_command of_named = {PH_SOLVES_BY(named, CURVE), NULL,
                                           ""};
static const struct ph_command of_other = {PH_SOLVES_BY(other, CURVE), NULL,
                                           ""};
static struct ph_options options;
static struct ph_diag diag;
static struct ph_buf buf;
static void finish(void) {
  ph_options_free(&options);
  ph_buf_free(&buf);
}

/* Reads a command line of up to three arguments. */
static enum ph_status get(const struct ph_command *command, const char *first,
                          const char *second, const char *third) {
  static char text[4][96];
  const char *const given[] = {"command", first, second, third};
  static char *argv[5];
  int argc = 0;
  for (; argc < 4 && given[argc]; argc++) {
    snprintf(text[argc], sizeof text[argc], "%s", given[argc]);
    argv[argc] = text[argc];
  }
  argv[argc] = NULL;
  ph_options_free(&options);
  options = (struct ph_options){.command = command};
  memset(&diag, 0, sizeof diag);
  return ph_options_read(argc, argv, &options, &diag);
}

static void ck_refused(enum ph_status status, const char *message) {
  ck_assert_str_eq(diag.message, message);
  ck_assert_int_eq(status, PH_E_USAGE);
}

static void ck_assigned(size_t i, double x, bool override) {
  const struct ph_assignment *a = &options.assignments[i];
  ck_assert_int_eq(a->field, PH_F_TOLERANCE);
  ck_assert_int_eq(a->value.kind, PH_NUMBER);
  ck_abs(a->value.number, x, 0);
  ck_assert_int_eq(a->override, override);
}

/* The option of a field's name is the option, and sets the field. */
PH_TEST(test_namesake) {
  ck_assert_int_eq(get(&of_named, "--tolerance=.5", NULL, NULL), PH_OK);
  ck_abs(options.tolerance, 0.5, 0);
  ck_assert_uint_eq(options.assignments_n, 1);
  ck_assigned(0, 0.5, false);
  ck_assert_int_eq(get(&of_named, "--tolerance", "2", "file"), PH_OK);
  ck_abs(options.tolerance, 2, 0);
  ck_assert_uint_eq(options.assignments_n, 1);
  ck_assigned(0, 2, false);
  ck_assert_uint_eq(options.files_n, 1);
  ck_assert_str_eq(options.files[0], "file");
}

/* The last one that is given sets the field, after all other assignments, which
 * are about the field alone; beside --convert it is not the field's. */
PH_TEST(test_namesakes) {
  ck_assert_int_eq(get(&of_named, "--tolerance=1", "--override=tolerance=3",
                       "--tolerance=2"),
                   PH_OK);
  ck_abs(options.tolerance, 2, 0);
  ck_assert_uint_eq(options.assignments_n, 2);
  ck_assigned(0, 3, true);
  ck_assigned(1, 2, false);
  ck_assert_int_eq(get(&of_named, "--tolerance=1", "--convert=bezier", NULL),
                   PH_OK);
  ck_abs(options.tolerance, 1, 0);
  ck_assert_uint_eq(options.assignments_n, 0);
  ck_assert_int_eq(get(&of_named, "--set=tolerance=4", NULL, NULL), PH_OK);
  ck_abs(options.tolerance, 0, 0);
  ck_assert_uint_eq(options.assignments_n, 1);
  ck_assigned(0, 4, false);
  ck_assert_int_eq(get(&of_named, "-S", "tolerance=1,2", NULL), PH_OK);
  ck_abs(options.tolerance, 0, 0);
  ck_assert_uint_eq(options.sweep_count, 2);
}

/* Without a field of that name there is the option alone. */
PH_TEST(test_no_namesake) {
  ck_assert_int_eq(get(&of_other, "--tolerance=.5", NULL, NULL), PH_OK);
  ck_abs(options.tolerance, 0.5, 0);
  ck_assert_uint_eq(options.assignments_n, 0);
  ck_refused(get(&of_other, "--set=tolerance=1", NULL, NULL),
             "--set: other has no field 'tolerance'");
}

PH_TEST(test_bad_namesake) {
  static const char message[] =
      "--tolerance must be a number greater than 0, found '0'";
  ck_refused(get(&of_named, "--tolerance=0", NULL, NULL), message);
  ck_refused(get(&of_other, "--tolerance=0", NULL, NULL), message);
  ck_refused(get(&of_named, "--tolerance", NULL, NULL),
             "option '--tolerance' needs a value");
  ck_refused(get(&of_named, "--toleranc=1", NULL, NULL),
             "unknown option '--toleranc'; did you mean \"tolerance\"?");
}

/* Control points as an option, of one curve or several. */
PH_TEST(test_curve) {
  const struct ph_value *value;
  ck_assert_int_eq(get(&of_named, "--curve=[[0,0],[1,1],[2,0]]", NULL, NULL),
                   PH_OK);
  value = &options.assignments[0].value;
  ck_assert_int_eq(value->kind, PH_VECTORS);
  ck_assert_uint_eq(value->n, 3);
  ck_assert_int_eq(get(&of_named, "--override",
                       "curve=[[[0,0],[1,1]],[[1,1],[2,1],[3,0]]]", NULL),
                   PH_OK);
  value = &options.assignments[0].value;
  ck_assert_int_eq(value->kind, PH_POLYLINE);
  ck_assert_uint_eq(value->sizes_n, 2);
  ck_assert_uint_eq(value->sizes[1], 3);
  ck_abs(value->v[8], 3, 0);
  ck_refused(get(&of_named, "--curve=[[[0,0]],[[1]]]", NULL, NULL),
             "--curve: curve[1][0] must have 2 numbers, found 1");
  ck_refused(get(&of_named, "--curve=1", NULL, NULL),
             "--curve: curve must be an array of points [x,y] or an array of "
             "such arrays, found a number");
}

/* How often the help of a command has a text. */
static size_t in_help(const struct ph_command *command, const char *text) {
  size_t n = 0;
  ph_buf_clear(&buf, buf.capacity);
  ph_help_command(&buf, command);
  ph_buf_put(&buf, "", 1);
  ck_assert(!buf.failed);
  for (const char *p = buf.data; (p = strstr(p, text)); p++) {
    n++;
  }
  return n;
}

/* The help tells of it once: as the field, if it is one. */
PH_TEST(test_help) {
  unsetenv("COLUMNS");
  ck_assert_uint_eq(in_help(&of_named, "tolerance"), 1);
  ck_assert_uint_eq(in_help(&of_named, "\n  tolerance                 how near "
                                       "to come; a number (default: none)\n"),
                    1);
  ck_assert_uint_eq(in_help(&of_other, "tolerance"), 1);
  ck_assert_uint_eq(in_help(&of_other, "\n      --tolerance=E         greatest "
                                       "distance"),
                    1);
  ck_assert_uint_eq(in_help(&of_named, "--jobs=N"), 1);
  ck_assert_uint_eq(
      in_help(&of_named,
              "\n  curve                     control points of a Bezier curve, "
              "or of several; an\n                            array of points "
              "[x,y] or an array of such arrays\n                            "
              "(default: none)\n"),
      1);
}

PH_FIXTURE(NULL, finish)
