/* SPDX-License-Identifier: GPL-3.0-or-later */
/* JSON records as problems: members, echoes, failures and their lines. */
#include "unit.h"

#include "io/csv_in.h"
#include "io/json_in.h"
#include "io/json_scan.h"

enum { PLANE = 1u << 2 };

static const struct ph_field rows[] = {
    {PH_F_POINTS, PH_VECTORS, PLANE, true, "", "", ""},
    {PH_F_CLOSED, PH_BOOL, 0, false, "", "false", ""},
    {PH_F_BASIS, PH_WORD, 0, false, "ph|atph", "ph", ""},
    {PH_F_KNOTS, PH_WORD | PH_NUMBERS, 0, false, "chordal|centripetal|uniform",
     "chordal", ""},
};
static const struct ph_schema schema = {"planar", rows, 4};

static struct ph_problem problem;
static struct ph_echo echo;
static struct ph_diag diag;
static char *copy;

static void finish(void) {
  free(copy);
  copy = NULL;
}

/* A record, of a text of its own size on the heap, that begins in line 10. */
static struct ph_record record_of(const char *text) {
  size_t n = strlen(text);
  struct ph_json_scan scan = {0};
  free(copy);
  copy = malloc(n);
  ck_assert_ptr_nonnull(copy);
  memcpy(copy, text, n);
  ck_assert_int_eq(ph_json_scan(&scan, copy, n, true), PH_JSON_DONE);
  return (struct ph_record){
      .text = copy, .n = n, .file = "a.json", .line = 10, .number = 1};
}

static enum ph_status get(const char *text) {
  struct ph_record record = record_of(text);
  memset(&diag, 0, sizeof diag);
  return ph_json_in(&record, &schema, &unit_arena, &problem, &echo, &diag);
}

static void bad(const char *text, enum ph_status status, const char *field,
                const char *message) {
  enum ph_status found = get(text);
  ck_assert_str_eq(diag.message, message);
  ck_assert_str_eq(diag.field, field);
  ck_assert_int_eq(found, status);
}

static void ck_echo(const char *id, const char *meta) {
  ck_assert_uint_eq(echo.id_n, id ? strlen(id) : 0);
  ck_assert_uint_eq(echo.meta_n, meta ? strlen(meta) : 0);
  ck_assert_int_eq(!echo.id, !id);
  ck_assert_int_eq(!echo.meta, !meta);
  if (id) {
    ck_assert_mem_eq(echo.id, id, echo.id_n);
  }
  if (meta) {
    ck_assert_mem_eq(echo.meta, meta, echo.meta_n);
  }
}

PH_TEST(test_good) {
  const struct ph_value *points = &problem.field[PH_F_POINTS];
  ck_assert_int_eq(get("{\"points\":[[0,1],[2,3],[4,5]], \"closed\" :true,"
                       "\"basis\":\"atph\",\"knots\":[0,1,2]}"),
                   PH_OK);
  ck_assert_int_eq(points->kind, PH_VECTORS);
  ck_assert_uint_eq(points->n, 3);
  ck_rel(points->v[5], 5, 0);
  ck_assert_int_eq(problem.field[PH_F_CLOSED].kind, PH_BOOL);
  ck_assert(problem.field[PH_F_CLOSED].flag);
  ck_assert_str_eq(problem.field[PH_F_BASIS].word, "atph");
  ck_assert_uint_eq(problem.field[PH_F_KNOTS].n, 3);
  ck_assert_int_eq(problem.field[PH_F_END_DERIVATIVES].kind, PH_ABSENT);
  ck_echo(NULL, NULL);
  /* Required fields may come from the command line. */
  ck_assert_int_eq(get("{}"), PH_OK);
  ck_assert_int_eq(points->kind, PH_ABSENT);
}

PH_TEST(test_names) {
  ck_assert_int_eq(get("{\"po\\u0069nts\":[[0,1]]}"), PH_OK);
  ck_assert_int_eq(problem.field[PH_F_POINTS].kind, PH_VECTORS);
  ck_assert_int_eq(get("{\"\\u0069d\":1}"), PH_OK);
  ck_echo("1", NULL);
  bad("{\"id\":1,\"id\":1}", PH_E_BAD_VALUE, "id", "occurs twice");
  ck_echo("1", NULL);
  bad("{\"meta\":1,\"meta\":1}", PH_E_BAD_VALUE, "meta", "occurs twice");
  bad("{\"pints\":[]}", PH_E_UNKNOWN_FIELD, "pints",
      "is not a field of planar; did you mean \"points\"?");
  bad("{\"Meta\":[]}", PH_E_UNKNOWN_FIELD, "Meta",
      "is not a field of planar; did you mean \"meta\"?");
  bad("{\"lengths\":[]}", PH_E_UNKNOWN_FIELD, "lengths",
      "is not a field of planar");
  bad("{\"end_derivatives\":[]}", PH_E_UNKNOWN_FIELD, "end_derivatives",
      "is not a field of planar");
  bad("{\"points\\u0000\":[]}", PH_E_UNKNOWN_FIELD, "points\\u0000",
      "is not a field of planar");
  bad("{\"a\\nb\":[]}", PH_E_UNKNOWN_FIELD, "a\\nb",
      "is not a field of planar");
  bad("{\"1234567890123456789012345678901234567890\xC3\xA4\":[]}",
      PH_E_UNKNOWN_FIELD, "1234567890123456789012345678901234567890...",
      "is not a field of planar");
}

PH_TEST(test_not_an_object) {
  bad("null", PH_E_BAD_TYPE, "", "a problem must be an object, found null");
  ck_echo(NULL, NULL);
}

PH_TEST(test_echo) {
  ck_assert_int_eq(get("{\"meta\":{\"a\": [1, 2]},\"id\":\"w\\n1\"}"), PH_OK);
  ck_echo("\"w\\n1\"", "{\"a\": [1, 2]}");
  ck_assert_int_eq(get("{\"id\":-1.50e2,\"meta\":null}"), PH_OK);
  ck_echo("-1.50e2", "null");
  /* A result is one line. */
  ck_assert_int_eq(get("{\"meta\":{\n  \"a \\\" b\" : [ 1,\r\n 2 ],\n\t"
                       "\"c\": \" \\\\\" }}"),
                   PH_OK);
  ck_echo(NULL, "{\"a \\\" b\":[1,2],\"c\":\" \\\\\"}");
  bad("{\"id\":[1],\"meta\":2}", PH_E_BAD_TYPE, "id",
      "must be a string or a number, found an array");
  ck_echo(NULL, "2");
}

/* What is only passed on is JSON all the same. */
PH_TEST(test_bad_echo) {
  bad("{\"id\":-1e999,\"meta\":2}", PH_E_NOT_FINITE, "id",
      "is -1e999, which overflows a double");
  ck_echo(NULL, "2");
  bad("{\"id\":7,\"meta\":{\"a\":[0,{\"b\":1e309}]}}", PH_E_NOT_FINITE, "meta",
      "is 1e309, which overflows a double");
  ck_echo("7", NULL);
  bad("{\"meta\":[{\"a\":1,\"bc\":[],\"\\u0061\":2}]}", PH_E_BAD_VALUE, "meta",
      "has the name \"a\" twice");
  ck_assert_int_eq(get("{\"meta\":{\"\":1,\"a\":{\"\":1,\"a\":[]},\"b\":1}}"),
                   PH_OK);
  ck_echo(NULL, "{\"\":1,\"a\":{\"\":1,\"a\":[]},\"b\":1}");
}

/* The first failure is told; id and meta are known all the same. */
PH_TEST(test_echo_on_failure) {
  bad("{\"a\":1,\"id\":7,\"b\":2,\"meta\":[]}", PH_E_UNKNOWN_FIELD, "a",
      "is not a field of planar");
  ck_echo("7", "[]");
  bad("{\"points\":[[0]],\"id\":\"x\",\"closed\":1}", PH_E_BAD_SHAPE,
      "points[0]", "must have 2 numbers, found 1");
  ck_echo("\"x\"", NULL);
  bad("{\"points\":null,\"id\":true,\"b\":2}", PH_E_UNKNOWN_FIELD, "b",
      "is not a field of planar");
  bad("{\"points\":null,\"points\":1,\"id\":3}", PH_E_BAD_VALUE, "points",
      "occurs twice");
  ck_echo("3", NULL);
}

PH_TEST(test_values) {
  bad("{\"basis\":\"p\"}", PH_E_BAD_VALUE, "basis",
      "must be \"ph\" or \"atph\", found \"p\"");
  bad("{\"points\":[[0,0],[1,-1e400]]}", PH_E_NOT_FINITE, "points[1][1]",
      "is -1e400, which overflows a double");
}

PH_TEST(test_lines) {
  struct ph_record record = record_of("{\n\"id\":1,\n\"points\":\n[\n[0,0],\n"
                                      "[1,\n1]], \"a\\n\":[],\n\n\"closed\":1"
                                      "}");
  ck_assert_uint_eq(ph_record_line(&record, ""), 10);
  ck_assert_uint_eq(ph_record_line(&record, "id"), 11);
  ck_assert_uint_eq(ph_record_line(&record, "points"), 13);
  ck_assert_uint_eq(ph_record_line(&record, "points[0]"), 14);
  ck_assert_uint_eq(ph_record_line(&record, "points[0][1]"), 14);
  ck_assert_uint_eq(ph_record_line(&record, "points[1]"), 15);
  ck_assert_uint_eq(ph_record_line(&record, "points[1][1]"), 16);
  ck_assert_uint_eq(ph_record_line(&record, "closed"), 18);
  ck_assert_uint_eq(ph_record_line(&record, "a\\n"), 16);
  /* Of what is not there, the innermost part that is. */
  ck_assert_uint_eq(ph_record_line(&record, "points[1][7]"), 15);
  ck_assert_uint_eq(ph_record_line(&record, "points[9]"), 13);
  ck_assert_uint_eq(ph_record_line(&record, "closed[0]"), 18);
  ck_assert_uint_eq(ph_record_line(&record, "knots[1]"), 10);
  ck_assert_uint_eq(ph_record_line(&record, "points["), 13);
  ck_assert_uint_eq(ph_record_line(&record, "points[x"), 13);
  record = record_of("[1,\n2]");
  ck_assert_uint_eq(ph_record_line(&record, "points[1]"), 10);
}

PH_FIXTURE(NULL, finish)
