/* SPDX-License-Identifier: GPL-3.0-or-later */
/* CSV: rows, cells, and records of rows as problems. */
#include "unit.h"

#include "io/csv_in.h"
#include "io/json_in.h"

enum { PLANE = 1u << 2, SPACE = 1u << 3 };

static const struct ph_field rows[] = {
    {PH_F_POINTS, PH_VECTORS, PLANE | SPACE, true, "", "", ""},
    {PH_F_CLOSED, PH_BOOL, 0, false, "", "false", ""},
    {PH_F_KNOTS, PH_WORD | PH_NUMBERS, 0, false, "chordal", "chordal", ""},
};
static const struct ph_schema schema = {"planar", rows, 3};
/* Points or derivatives, and numbers of segments. */
static const struct ph_field segment_rows[] = {
    {PH_F_POINTS, PH_VECTORS, PLANE | SPACE, false, "", "", ""},
    {PH_F_DERIVATIVES, PH_VECTORS, PLANE | SPACE, false, "", "", ""},
    {PH_F_LENGTHS, PH_NUMBERS | PH_SEGMENTS, 0, false, "", "", ""},
    {PH_F_KNOTS, PH_WORD | PH_NUMBERS, 0, false, "chordal", "chordal", ""},
};
static const struct ph_schema of_segments = {"arclength", segment_rows, 4};

static struct ph_problem problem;
static struct ph_echo echo;
static struct ph_diag diag;
static char *copy;
static struct ph_csv_columns *columns;

static void finish(void) {
  free(copy);
  free(columns);
  copy = NULL;
  columns = NULL;
}

/* A copy of its own size on the heap: a read beyond it shows. */
static const char *heap(const char *text, size_t n) {
  free(copy);
  copy = malloc(n ? n : 1);
  ck_assert_ptr_nonnull(copy);
  memcpy(copy, text, n);
  return copy;
}

/* ---- rows and cells ------------------------------------------------- */

/* Scans the first row of a text in portions of every size. */
static void ck_scan(const char *text, enum ph_csv_state state, size_t at,
                    const char *message) {
  size_t n = strlen(text);
  for (size_t step = n + 1; step >= 1; step--) {
    struct ph_csv_scan scan = {.at = 0};
    enum ph_csv_state found = PH_CSV_MORE;
    for (size_t have = step; found == PH_CSV_MORE && have < n; have += step) {
      found = ph_csv_scan(&scan, heap(text, have), have, ',', false);
    }
    if (found == PH_CSV_MORE) {
      found = ph_csv_scan(&scan, heap(text, n), n, ',', true);
    }
    ck_assert_msg(found == state, "%s: state %d: %s", text, (int)found,
                  scan.message);
    ck_assert_msg(scan.at == at, "%s: at %zu", text, scan.at);
    if (state == PH_CSV_ERROR) {
      ck_assert_str_eq(scan.message, message);
    }
  }
}

PH_TEST(test_rows) {
  ck_scan("1,2", PH_CSV_ROW, 3, NULL);
  ck_scan("1,2\n3,4", PH_CSV_ROW, 4, NULL);
  ck_scan("1,2\r\n3,4", PH_CSV_ROW, 5, NULL);
  ck_scan("\"a\nb\",2\n3", PH_CSV_ROW, 8, NULL);
  ck_scan("\"a\"\"b\"\nx", PH_CSV_ROW, 7, NULL);
  ck_scan("\"a\"\"\n\"\nx", PH_CSV_ROW, 7, NULL);
  ck_scan(" \"a\n\" , 1\nx", PH_CSV_ROW, 10, NULL);
  ck_scan("a\"b\nx", PH_CSV_ROW, 4, NULL);
  ck_scan("\"\"\nx", PH_CSV_ROW, 3, NULL);
  ck_scan(",\nx", PH_CSV_ROW, 2, NULL);
  ck_scan(" , \nx", PH_CSV_ROW, 4, NULL);
  ck_scan("a,#\nx", PH_CSV_ROW, 4, NULL);
  ck_scan(" #\nx", PH_CSV_ROW, 3, NULL);
  ck_scan("\nx", PH_CSV_BLANK, 1, NULL);
  ck_scan("\r\nx", PH_CSV_BLANK, 2, NULL);
  ck_scan(" \t \nx", PH_CSV_BLANK, 4, NULL);
  ck_scan("  ", PH_CSV_BLANK, 2, NULL);
  ck_scan("#\nx", PH_CSV_COMMENT, 2, NULL);
  ck_scan("# it's \"so\nx", PH_CSV_COMMENT, 11, NULL);
  ck_scan("#\"", PH_CSV_COMMENT, 2, NULL);
}

PH_TEST(test_broken_rows) {
  const char *never = "the quote that begins this cell is never closed";
  ck_scan("\"a", PH_CSV_ERROR, 0, never);
  ck_scan("1, \"a\n2,3\n", PH_CSV_ERROR, 3, never);
  ck_scan("1,\"a\"\",2\n", PH_CSV_ERROR, 2, never);
  ck_scan("\"a\"x\n", PH_CSV_ERROR, 3,
          "expected ',' or the end of the row after a quoted cell, found 'x'");
  ck_scan("\"a\" \"b\"\n", PH_CSV_ERROR, 4,
          "expected ',' or the end of the row after a quoted cell, "
          "found '\"'");
  ck_scan("\"a\"\xC3\xA4\n", PH_CSV_ERROR, 3,
          "expected ',' or the end of the row after a quoted cell, "
          "found '\xC3\xA4'");
  ck_scan("\"a\"\xC3", PH_CSV_ERROR, 3,
          "expected ',' or the end of the row after a quoted cell, "
          "found '\\xc3'");
}

/* Cell i of a row. */
static struct ph_csv_cell cell_of(const char *row, char delimiter, size_t i) {
  size_t n = strlen(row);
  const char *p = heap(row, n);
  const char *end = ph_csv_row_end(p, p + n);
  struct ph_csv_cell cell;
  for (p = ph_csv_cell(p, end, delimiter, &cell); i > 0; i--) {
    ck_assert_ptr_ne(p, end);
    p = ph_csv_cell(p + 1, end, delimiter, &cell);
  }
  return cell;
}

static void ck_cell(const char *row, char delimiter, size_t i,
                    const char *content) {
  struct ph_csv_cell cell = cell_of(row, delimiter, i);
  char out[64];
  size_t n = ph_csv_content(&cell, out);
  ck_assert_uint_le(n, cell.n);
  out[n] = '\0';
  ck_assert_str_eq(out, content);
}

PH_TEST(test_cells) {
  ck_cell("1,2\r\n", ',', 0, "1");
  ck_cell("1,2\r\n", ',', 1, "2");
  ck_cell(" 1 ,\t2 \n", ',', 0, "1");
  ck_cell(" 1 ,\t2 \n", ',', 1, "2");
  ck_cell("1,,3", ',', 1, "");
  ck_cell("1,", ',', 1, "");
  ck_cell("", ',', 0, "");
  ck_cell("\"a,b\",2", ',', 0, "a,b");
  ck_cell("\"a,b\",2", ',', 1, "2");
  ck_cell(" \" a\"\"b \" , 2", ',', 0, " a\"b ");
  ck_cell(" \" a\"\"b \" , 2", ',', 1, "2");
  ck_cell("\"\"\"\"", ',', 0, "\"");
  ck_cell("\"\",x", ',', 0, "");
  ck_cell("\"a\nb\"\n", ',', 0, "a\nb");
  ck_cell("a\"b,c", ',', 0, "a\"b");
  ck_cell("a b\tc d\t", '\t', 0, "a b");
  ck_cell("a b\tc d\t", '\t', 1, "c d");
  ck_cell("a b\tc d\t", '\t', 2, "");
  ck_cell("1;2,5", ';', 1, "2,5");
  ck_cell(" 1 \t 2  3 \r\n", PH_CSV_WORDS, 0, "1");
  ck_cell(" 1 \t 2  3 \r\n", PH_CSV_WORDS, 1, "2");
  ck_cell(" 1 \t 2  3 \r\n", PH_CSV_WORDS, 2, "3");
  ck_cell("\" a \"\"b\"  2", PH_CSV_WORDS, 0, " a \"b");
  ck_cell("\" a \"\"b\"  2", PH_CSV_WORDS, 1, "2");
  ck_cell("", PH_CSV_WORDS, 0, "");
  ck_assert(!cell_of("a", ',', 0).quoted);
  ck_assert(cell_of("\"\"", ',', 0).quoted);
}

PH_TEST(test_decimal_commas) {
  static const char *const commas[] = {"1,5", "-1,5e3", ",5", "1,"};
  static const char *const none[] = {"1.5", "1,5,0", "a,b", ",", "", "1,5m"};
  struct ph_csv_cell cell = {NULL, 0, false};
  for (size_t i = 0; i < COUNT(commas) + COUNT(none); i++) {
    bool is = i < COUNT(commas);
    cell.text = is ? commas[i] : none[i - COUNT(commas)];
    cell.n = strlen(cell.text);
    ck_assert_msg(ph_csv_decimal_comma(&cell) == is, "%s", cell.text);
  }
}

PH_TEST(test_thousands) {
  static const char *const thousands[] = {"1,234.5",
                                          "-1,234,567",
                                          "1 234",
                                          "1'234'567.25",
                                          "1.234,5",
                                          "1_000e3",
                                          "12\xc2\xa0"
                                          "345",
                                          "12\xe2\x80\xaf"
                                          "345,5"};
  static const char *const none[] = {"1234",  "1,23",   "1,2345", ",123",
                                     "a,123", "1,234m", "",       "1 23"};
  struct ph_csv_cell cell = {NULL, 0, false};
  for (size_t i = 0; i < COUNT(thousands) + COUNT(none); i++) {
    bool is = i < COUNT(thousands);
    const char *text = is ? thousands[i] : none[i - COUNT(thousands)];
    cell.n = strlen(text);
    cell.text = heap(text, cell.n);
    ck_assert_msg(ph_csv_thousands(&cell) == is, "%s", text);
  }
}

static bool number(const char *text, double *x) {
  return ph_csv_number(heap(text, strlen(text)), strlen(text), x);
}

PH_TEST(test_numbers) {
  static const char *const words[] = {"",    "a",    "1a",   "1 2",       "-",
                                      "+-1", "nano", "na",   "infinitys", "in",
                                      "-a",  "1e",   "0x10", "1,5",       "."};
  double x = 0;
  ck_assert(number("-1.5e3", &x));
  ck_rel(x, -1500, 0);
  ck_assert(number(".5", &x));
  ck_rel(x, 0.5, 0);
  ck_assert(number("+007", &x));
  ck_rel(x, 7, 0);
  ck_assert(number("NaN", &x) && isnan(x));
  ck_assert(number("-nan", &x) && isnan(x));
  ck_assert(number("-Inf", &x) && isinf(x) && x < 0);
  ck_assert(number("infinity", &x) && isinf(x) && x > 0);
  ck_assert(number("1e999", &x) && isinf(x));
  for (size_t i = 0; i < COUNT(words); i++) {
    ck_assert_msg(!number(words[i], &x), "%s", words[i]);
  }
}

/* ---- records -------------------------------------------------------- */

/* Columns by one letter each: i, x, y, z, u (dx), v (dy), k(not), l(ength),
 * -. */
static void set_columns(const char *letters) {
  size_t n = strlen(letters);
  columns = malloc(sizeof *columns + n * sizeof *columns->column);
  ck_assert_ptr_nonnull(columns);
  *columns = (struct ph_csv_columns){.delimiter = ',', .n = n};
  for (size_t i = 0; i < n; i++) {
    char c = letters[i];
    columns->column[i] =
        c == 'i'   ? (struct ph_csv_column){PH_CSV_ID, 0, "id", false}
        : c == 'x' ? (struct ph_csv_column){PH_F_POINTS, 0, "x", false}
        : c == 'y' ? (struct ph_csv_column){PH_F_POINTS, 1, "y", false}
        : c == 'z' ? (struct ph_csv_column){PH_F_POINTS, 2, "z", false}
        : c == 'u' ? (struct ph_csv_column){PH_F_DERIVATIVES, 0, "dx", false}
        : c == 'v' ? (struct ph_csv_column){PH_F_DERIVATIVES, 1, "dy", false}
        : c == 'l' ? (struct ph_csv_column){PH_F_LENGTHS, 0, "length", true}
        : c == 'k' ? (struct ph_csv_column){PH_F_KNOTS, 0, "knot", false}
                   : (struct ph_csv_column){PH_CSV_SKIP, 0, "-", false};
  }
}

/* A record whose first row is in line 10. */
static struct ph_record record_of(const char *letters, const char *text) {
  size_t n = strlen(text);
  free(columns);
  set_columns(letters);
  return (struct ph_record){.text = heap(text, n),
                            .n = n,
                            .file = "a.csv",
                            .line = 10,
                            .number = 1,
                            .columns = columns};
}

static enum ph_status get_by(const struct ph_schema *by, const char *letters,
                             const char *text) {
  struct ph_record record = record_of(letters, text);
  memset(&diag, 0, sizeof diag);
  return ph_csv_in(&record, by, &unit_arena, &problem, &echo, &diag);
}

static enum ph_status get(const char *letters, const char *text) {
  return get_by(&schema, letters, text);
}

static void ck_array(enum ph_field_id id, enum ph_value_kind kind, size_t n,
                     size_t dimension, const double *v) {
  const struct ph_value *value = &problem.field[id];
  ck_assert_msg(diag.message[0] == '\0', "%s %s", diag.field, diag.message);
  ck_assert_int_eq(value->kind, kind);
  ck_assert_uint_eq(value->n, n);
  ck_assert_uint_eq(value->dimension, dimension);
  for (size_t i = 0; i < n * dimension; i++) {
    ck_rel(value->v[i], v[i], 0);
  }
}

static void ck_id(const char *id) {
  ck_assert_int_eq(!echo.id, !id);
  ck_assert_uint_eq(echo.id_n, id ? strlen(id) : 0);
  if (id) {
    ck_assert_mem_eq(echo.id, id, echo.id_n);
  }
  ck_assert_ptr_null(echo.meta);
}

static void bad_by(const struct ph_schema *by, const char *letters,
                   const char *text, enum ph_status status, const char *field,
                   size_t line, const char *message) {
  enum ph_status found = get_by(by, letters, text);
  ck_assert_str_eq(diag.message, message);
  ck_assert_str_eq(diag.field, field);
  ck_assert_int_eq(found, status);
  ck_assert_int_eq(diag.status, status);
  ck_assert_uint_eq(diag.line, line);
}

static void bad(const char *letters, const char *text, enum ph_status status,
                const char *field, size_t line, const char *message) {
  bad_by(&schema, letters, text, status, field, line, message);
}

PH_TEST(test_good) {
  static const double v[] = {0, 1, 2, 3, 4, 5};
  static const double k[] = {7, 8};
  ck_assert_int_eq(get("xy", "0,1\n2,3\n4,5\n"), PH_OK);
  ck_array(PH_F_POINTS, PH_VECTORS, 3, 2, v);
  ck_assert_int_eq(problem.field[PH_F_KNOTS].kind, PH_ABSENT);
  ck_id(NULL);
  ck_assert_int_eq(get("xyz", "0,1,2\r\n3, 4 ,\"5\""), PH_OK);
  ck_array(PH_F_POINTS, PH_VECTORS, 2, 3, v);
  ck_assert_int_eq(get("yk-xz", "1,7,a,0,2\n# a,b\n4,8,,3,5\n"), PH_OK);
  ck_array(PH_F_POINTS, PH_VECTORS, 2, 3, v);
  ck_array(PH_F_KNOTS, PH_NUMBERS, 2, 1, k);
  ck_assert_int_eq(get("i", "a\n"), PH_OK);
  ck_assert_int_eq(problem.field[PH_F_POINTS].kind, PH_ABSENT);
}

PH_TEST(test_empty_columns) {
  static const double v[] = {0, 1, 2, 3};
  ck_assert_int_eq(get("xyz", "0,1,\n2,3, \n"), PH_OK);
  ck_array(PH_F_POINTS, PH_VECTORS, 2, 2, v);
  ck_assert_int_eq(get("xyk", "0,1,\n2,3,\"\"\n"), PH_OK);
  ck_array(PH_F_POINTS, PH_VECTORS, 2, 2, v);
  ck_assert_int_eq(problem.field[PH_F_KNOTS].kind, PH_ABSENT);
  ck_assert_int_eq(get("xyk", ",,0\n,,1\n"), PH_OK);
  ck_assert_int_eq(problem.field[PH_F_POINTS].kind, PH_ABSENT);
  ck_array(PH_F_KNOTS, PH_NUMBERS, 2, 1, v);
}

/* A length stands in the row in which its segment ends; the first row has none
 * or that of the segment which closes the curve. */
PH_TEST(test_segments) {
  static const double v[] = {0, 1, 2, 3, 4, 5};
  static const double l[] = {7, 8, 6};
  ck_assert_int_eq(get_by(&of_segments, "xyl", "0,1,\n2,3,7\n4,5,8\n"), PH_OK);
  ck_array(PH_F_POINTS, PH_VECTORS, 3, 2, v);
  ck_array(PH_F_LENGTHS, PH_NUMBERS, 2, 1, l);
  ck_assert_int_eq(get_by(&of_segments, "lxy", "6,0,1\n7,2,3\n8,4,5\n"), PH_OK);
  ck_array(PH_F_LENGTHS, PH_NUMBERS, 3, 1, l);
  ck_assert_int_eq(get_by(&of_segments, "ulv", "0,\"\",1\n2,7,3\n4, 8 ,5"),
                   PH_OK);
  ck_assert_int_eq(problem.field[PH_F_POINTS].kind, PH_ABSENT);
  ck_array(PH_F_DERIVATIVES, PH_VECTORS, 3, 2, v);
  ck_array(PH_F_LENGTHS, PH_NUMBERS, 2, 1, l);
  ck_assert_int_eq(get_by(&of_segments, "xylk", "0,1,,4\n2,3,7,5\n"), PH_OK);
  ck_array(PH_F_LENGTHS, PH_NUMBERS, 1, 1, l);
  ck_array(PH_F_KNOTS, PH_NUMBERS, 2, 1, v + 4);
  /* empty in all rows is absent */
  ck_assert_int_eq(get_by(&of_segments, "xyl", "0,1,\n2,3,\n4,5,\n"), PH_OK);
  ck_assert_int_eq(problem.field[PH_F_LENGTHS].kind, PH_ABSENT);
  /* a row alone has no segment that ends in it, unless it closes */
  ck_assert_int_eq(get_by(&of_segments, "xyl", "0,1,7\n"), PH_OK);
  ck_array(PH_F_LENGTHS, PH_NUMBERS, 1, 1, l);
}

PH_TEST(test_segment_gaps) {
  static const char wanted[] =
      "needs a number in column length of every row but the first";
  bad_by(&of_segments, "xyl", "0,1,\n2,3,7\n4,5,\n", PH_E_BAD_VALUE, "lengths",
         0, wanted);
  bad_by(&of_segments, "xyl", "0,1,\n2,3,\n4,5,7\n", PH_E_BAD_VALUE, "lengths",
         0, wanted);
  bad_by(&of_segments, "xyl", "0,1,6\n2,3,\n4,5,7\n", PH_E_BAD_VALUE, "lengths",
         0, wanted);
  bad_by(&of_segments, "xyl", "0,1,6\n2,3,\n4,5,\n", PH_E_BAD_VALUE, "lengths",
         0, wanted);
  bad_by(&of_segments, "xyl", "0,1,\n2,3,far\n", PH_E_BAD_TYPE, "lengths[0]",
         11, "needs a number in column length, found \"far\"");
  bad_by(&of_segments, "xyl", "0,1,far\n2,3,7\n", PH_E_BAD_TYPE, "lengths", 10,
         "needs a number in column length, found \"far\"");
  bad_by(&of_segments, "xyl", "0,1,\n2,3,inf\n", PH_E_NOT_FINITE, "lengths[0]",
         11, "needs a finite number in column length, found \"inf\"");
}

PH_TEST(test_gaps) {
  bad("xy", "0,\n2,\n", PH_E_BAD_VALUE, "points[0]", 10,
      "needs a number in column y, found an empty cell");
  bad("xy", ",0\n,2\n", PH_E_BAD_VALUE, "points[0]", 10,
      "needs a number in column x, found an empty cell");
  bad("xyk", "0,1,2\n#\n0,1,3\n0,1,\n", PH_E_BAD_VALUE, "knots[2]", 13,
      "needs a number in column knot, found an empty cell");
}

PH_TEST(test_bad_rows) {
  bad("xy", "0,1\n2,abc\n", PH_E_BAD_TYPE, "points[1]", 11,
      "needs a number in column y, found \"abc\"");
  bad("ixy", "\"a\nb\",0,1\n\n#\n\"a\nb\",x\x1b[0m,1\n", PH_E_BAD_TYPE,
      "points[1]", 14, "needs a number in column x, found \"x\\x1b[0m\"");
  bad("xy", "0,1 2\n", PH_E_BAD_TYPE, "points[0]", 10,
      "needs a number in column y, found \"1 2\"");
  bad("xy", "0,NaN\n", PH_E_NOT_FINITE, "points[0]", 10,
      "needs a finite number in column y, found \"NaN\"");
  bad("xyk", "0,1,1e999\n", PH_E_NOT_FINITE, "knots[0]", 10,
      "needs a finite number in column knot, found \"1e999\"");
}

PH_TEST(test_ids) {
  static const char *const cases[][2] = {
      {"7", "7"},
      {"-1.50", "-1.50"},
      {"007", "\"007\""},
      {"+1", "\"+1\""},
      {"wing 3", "\"wing 3\""},
      {" a ", "\"a\""},
      {"\" a \"", "\" a \""},
      {"\"a\"\"b\"", "\"a\\\"b\""},
      {"a\\b", "\"a\\\\b\""},
      {"\"a\nb\x01\"", "\"a\\u000ab\\u0001\""},
      {"\xC3\xA4", "\"\xC3\xA4\""},
      {"true", "\"true\""},
      {"1e999", "\"1e999\""}};
  char text[64];
  for (size_t i = 0; i < COUNT(cases); i++) {
    strcpy(text, "0,");
    strcat(text, cases[i][0]);
    strcat(text, ",1\n");
    ck_assert_int_eq(get("xiy", text), PH_OK);
    ck_id(cases[i][1]);
  }
  ck_assert_int_eq(get("ixy", ",0,1\n"), PH_OK);
  ck_id(NULL);
  ck_assert_int_eq(get("ixy", "\"\",0,1\n"), PH_OK);
  ck_id(NULL);
}

PH_TEST(test_ids_on_failure) {
  bad("xyi", "a,1,7\n", PH_E_BAD_TYPE, "points[0]", 10,
      "needs a number in column x, found \"a\"");
  ck_id("7");
  bad("xi", "1,b,7\n", PH_E_BAD_SHAPE, "", 10,
      "the row has 3 cells, expected 2");
  ck_id("\"b\"");
  bad("xyi", "1,2\n", PH_E_BAD_SHAPE, "", 10,
      "the row has 2 cells, expected 3");
  ck_id(NULL);
  bad("ixy", "a\xFF,0,1\n", PH_E_SYNTAX, "id", 10,
      "has the byte \\xff, which is not UTF-8");
  ck_id(NULL);
}

PH_TEST(test_lines) {
  struct ph_record record =
      record_of("ikxy", "\"a\nb\",0,0,0\n# comment\n\"a\nb\",1,1,1\n"
                        "\"a\nb\",2,2,2");
  ck_assert_uint_eq(ph_record_line(&record, ""), 10);
  ck_assert_uint_eq(ph_record_line(&record, "points"), 10);
  ck_assert_uint_eq(ph_record_line(&record, "points[0]"), 10);
  ck_assert_uint_eq(ph_record_line(&record, "points[1][1]"), 13);
  ck_assert_uint_eq(ph_record_line(&record, "knots[2]"), 15);
  ck_assert_uint_eq(ph_record_line(&record, "knots[3]"), 15);
  /* no column of that field */
  ck_assert_uint_eq(ph_record_line(&record, "end_derivatives[1]"), 10);
  ck_assert_uint_eq(ph_record_line(&record, "point[1]"), 10);
}

/* Element i of the segments ends in row i + 1; the one that closes the curve
 * ends in the first row. */
PH_TEST(test_segment_lines) {
  struct ph_record record = record_of("xyl", "0,0,3\n#\n1,1,1\n\n2,2,2\n");
  ck_assert_uint_eq(ph_record_line(&record, "points[1]"), 12);
  ck_assert_uint_eq(ph_record_line(&record, "lengths"), 10);
  ck_assert_uint_eq(ph_record_line(&record, "lengths[0]"), 12);
  ck_assert_uint_eq(ph_record_line(&record, "lengths[1]"), 14);
  ck_assert_uint_eq(ph_record_line(&record, "lengths[2]"), 10);
}

PH_FIXTURE(NULL, finish)
