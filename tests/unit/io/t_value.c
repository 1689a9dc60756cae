/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Values of fields: what each kind reads, and what is said of the rest. */
#include "unit.h"

#include "io/json_scan.h"
#include "io/value.h"

enum { PLANE = 1u << 2, SPACE = 1u << 3 };

static const struct ph_field points = {PH_F_POINTS, PH_VECTORS, PLANE, true,
                                       "",          "",         ""};
static const struct ph_field points3 = {PH_F_POINTS, PH_VECTORS, SPACE, true,
                                        "",          "",         ""};
static const struct ph_field any_points = {
    PH_F_POINTS, PH_VECTORS, PLANE | SPACE, true, "", "", ""};
static const struct ph_field closed = {PH_F_CLOSED, PH_BOOL, 0, false,
                                       "",          "false", ""};
static const struct ph_field basis = {PH_F_BASIS, PH_WORD, 0, false,
                                      "ph|atph",  "ph",    ""};
static const struct ph_field knots = {
    PH_F_KNOTS, PH_WORD | PH_NUMBERS,          0,
    false,      "chordal|centripetal|uniform", "chordal",
    ""};
static const struct ph_field ends = {
    PH_F_END_DERIVATIVES, PH_VECTORS, PLANE, false, "", "", ""};
/* Kinds that no field of today has together. */
static const struct ph_field number = {PH_F_BASIS, PH_NUMBER, 0, false,
                                       "",         "",        ""};
static const struct ph_field everything = {PH_F_KNOTS,
                                           PH_BOOL | PH_NUMBER | PH_WORD |
                                               PH_NUMBERS | PH_VECTORS,
                                           PLANE | SPACE,
                                           false,
                                           "warn",
                                           "",
                                           ""};
static const struct ph_field shape = {
    PH_F_SHAPE, PH_BOOL | PH_WORD, 0, false, "warn", "true", ""};
static const struct ph_field increase = {
    PH_F_INCREASE, PH_WORD, 0, false, "minimal|plus:V|times:V", "minimal", ""};
static const struct ph_field curve = {
    PH_F_CURVE, PH_VECTORS | PH_POLYLINE, PLANE, false, "", "none", ""};
static const struct ph_field any_curve = {
    PH_F_CURVE, PH_VECTORS | PH_POLYLINE, PLANE | SPACE, false, "", "none", ""};
static struct ph_value value;
static struct ph_diag diag;
/* Reads a value from a copy of its own size: a read beyond it shows. */
static enum ph_status get(const struct ph_field *row, const char *text) {
  size_t n = strlen(text);
  char *copy = malloc(n);
  struct ph_json_scan scan = {0};
  enum ph_status status;
  ck_assert_ptr_nonnull(copy);
  memcpy(copy, text, n);
  ck_assert_int_eq(ph_json_scan(&scan, copy, n, true), PH_JSON_DONE);
  ck_assert_uint_eq(scan.at, n);
  memset(&diag, 0, sizeof diag);
  status = ph_value_read(copy, n, row, &unit_arena, &value, &diag);
  free(copy);
  return status;
}

static enum ph_status option(const struct ph_field *row, const char *text) {
  memset(&diag, 0, sizeof diag);
  return ph_value_read_option(text, row, &unit_arena, &value, &diag);
}

static void ck_diag(enum ph_status found, enum ph_status status,
                    const char *field, const char *message) {
  ck_assert_str_eq(diag.message, message);
  ck_assert_str_eq(diag.field, field);
  ck_assert_int_eq(found, status);
  ck_assert_int_eq(diag.status, status);
}

static void bad(const struct ph_field *row, const char *text,
                enum ph_status status, const char *field, const char *message) {
  ck_diag(get(row, text), status, field, message);
}

static void bad_option(const struct ph_field *row, const char *text,
                       enum ph_status status, const char *message) {
  ck_diag(option(row, text), status, ph_field_name(row->id), message);
}

static void ck_word(enum ph_status status, const char *word) {
  ck_assert_int_eq(status, PH_OK);
  ck_assert_int_eq(value.kind, PH_WORD);
  ck_assert_str_eq(value.word, word);
}

static void ck_bool(enum ph_status status, bool flag) {
  ck_assert_int_eq(status, PH_OK);
  ck_assert_int_eq(value.kind, PH_BOOL);
  ck_assert_int_eq(value.flag, flag);
}

static void ck_number(enum ph_status status, double x) {
  ck_assert_int_eq(status, PH_OK);
  ck_assert_int_eq(value.kind, PH_NUMBER);
  ck_rel(value.number, x, 0);
}

static void ck_array(enum ph_status status, enum ph_value_kind kind, size_t n,
                     size_t dimension, const double *v) {
  ck_assert_msg(status == PH_OK, "%s %s", diag.field, diag.message);
  ck_assert_int_eq(value.kind, kind);
  ck_assert_uint_eq(value.n, n);
  ck_assert_uint_eq(value.dimension, dimension);
  ck_assert_ptr_nonnull(value.v);
  for (size_t i = 0; i < n * dimension; i++) {
    ck_rel(value.v[i], v[i], 0);
  }
}

PH_TEST(test_scalars) {
  ck_bool(get(&closed, "true"), true);
  ck_bool(get(&closed, "false"), false);
  ck_word(get(&basis, "\"ph\""), "ph");
  ck_word(get(&basis, "\"atph\""), "atph");
  ck_word(get(&basis, "\"\\u0070\\u0068\""), "ph");
  ck_number(get(&number, "-1.5e3"), -1500);
  ck_number(get(&number, "0"), 0);
  /* One double below the middle of two: cJSON's strtod is not asked. */
  ck_number(get(&number, "9007199254740993"), 9007199254740992.0);
  ck_number(get(&number, "1e-400"), 0);
}

/* A truth value or a word, in JSON and as an option. */
PH_TEST(test_flag_or_word) {
  ck_bool(get(&shape, "true"), true);
  ck_bool(get(&shape, "false"), false);
  ck_word(get(&shape, "\"warn\""), "warn");
  ck_bool(option(&shape, ""), true);
  ck_bool(option(&shape, "true"), true);
  ck_bool(option(&shape, "false"), false);
  ck_word(option(&shape, "warn"), "warn");
  ck_word(option(&shape, "\"warn\""), "warn");
  bad(&shape, "\"false\"", PH_E_BAD_VALUE, "shape",
      "must be true, false or \"warn\", found \"false\"");
  bad_option(&shape, "wran", PH_E_BAD_VALUE,
             "must be true, false or \"warn\", found \"wran\"; did you mean "
             "\"warn\"?");
}

/* Words of one list that have a number and that have none. */
PH_TEST(test_words_with_numbers) {
  ck_word(get(&increase, "\"minimal\""), "minimal");
  ck_word(get(&increase, "\"plus:10\""), "plus:10");
  ck_rel(value.number, 10, 0);
  ck_word(option(&increase, "times:.5e1"), "times:.5e1");
  ck_rel(value.number, 5, 0);
  bad_option(&increase, "minimal:1", PH_E_BAD_VALUE,
             "must be \"minimal\", \"plus:V\" or \"times:V\", found "
             "\"minimal:1\"; did you mean \"minimal\"?");
}

PH_TEST(test_arrays) {
  static const double v[] = {0, -1, 2.5, 3, 4e2, 5};
  ck_array(get(&points, "[[0,-1],[2.5,3],[4e2,5]]"), PH_VECTORS, 3, 2, v);
  ck_array(get(&points, "[ [ 0 , -1 ] , [\n2.5,3] , [4e2\t,5]\r\n]"),
           PH_VECTORS, 3, 2, v);
  ck_array(get(&any_points, "[[0,-1,2.5],[3,4e2,5]]"), PH_VECTORS, 2, 3, v);
  ck_array(get(&any_points, "[[0,-1]]"), PH_VECTORS, 1, 2, v);
  ck_array(get(&knots, "[0,-1,2.5,3,4e2,5]"), PH_NUMBERS, 6, 1, v);
  ck_array(get(&knots, "[ 0 ]"), PH_NUMBERS, 1, 1, v);
  ck_array(get(&knots, "[]"), PH_NUMBERS, 0, 1, NULL);
  ck_array(get(&points, "[ ]"), PH_VECTORS, 0, 2, NULL);
  ck_array(get(&points3, "[]"), PH_VECTORS, 0, 3, NULL);
  ck_array(get(&everything, "[0,-1]"), PH_NUMBERS, 2, 1, v);
  ck_array(get(&everything, "[[0,-1]]"), PH_VECTORS, 1, 2, v);
}

static void ck_polyline(enum ph_status status, size_t n, const size_t *sizes,
                        size_t dimension, const double *v) {
  size_t total = 0;
  ck_assert_uint_eq(value.sizes_n, n);
  for (size_t i = 0; i < n; i++) {
    ck_assert_uint_eq(value.sizes[i], sizes[i]);
    total += sizes[i];
  }
  ck_array(status, PH_POLYLINE, total, dimension, v);
}

/* Control points of one curve, or of several. */
PH_TEST(test_polyline) {
  static const double v[] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11};
  static const size_t sizes[] = {2, 1, 3};
  static const size_t one[] = {3};
  ck_array(get(&curve, "[[0,1],[2,3],[4,5]]"), PH_VECTORS, 3, 2, v);
  ck_assert_uint_eq(value.sizes_n, 0);
  ck_array(get(&curve, "[]"), PH_VECTORS, 0, 2, NULL);
  ck_polyline(get(&curve, "[[[0,1],[2,3]],[[4,5]],[[6,7],[8,9],[10,11]]]"), 3,
              sizes, 2, v);
  ck_polyline(get(&curve, "[ [\t[0 ,1], [2,3] ] ,\n[[4,5]] ,[[6,7],[8,9] , "
                          "[10,11]]]"),
              3, sizes, 2, v);
  ck_polyline(get(&curve, "[[[0,1],[2,3],[4,5]]]"), 1, one, 2, v);
  ck_polyline(get(&any_curve, "[[[0,1,2],[3,4,5],[6,7,8]]]"), 1, one, 3, v);
  ck_polyline(option(&curve, "[[[0,1],[2,3],[4,5]]] "), 1, one, 2, v);
  ck_array(option(&curve, "[[0,1],[2,3]]"), PH_VECTORS, 2, 2, v);
}

/* More pieces, and more points in one, than memory would be asked for by
 * mistake: each is where it belongs. */
PH_TEST(test_polyline_long) {
  enum { PIECES = 40, POINTS = 7, ROOM = PIECES * (POINTS * 12 + 4) + 4 };
  static char text[ROOM];
  size_t n = 0;
  for (int i = 0; i < PIECES; i++) {
    for (int j = 0; j < i % POINTS + 1; j++) {
      n += (size_t)snprintf(text + n, ROOM - n, "%s[%d,%d]",
                            j   ? ","
                            : i ? "],["
                                : "[[",
                            i, j);
    }
  }
  snprintf(text + n, ROOM - n, "]]");
  ck_assert_int_eq(get(&curve, text), PH_OK);
  ck_assert_uint_eq(value.sizes_n, PIECES);
  n = 0;
  for (int i = 0; i < PIECES; i++) {
    ck_assert_uint_eq(value.sizes[i], (size_t)(i % POINTS + 1));
    for (int j = 0; j < i % POINTS + 1; j++) {
      ck_rel(value.v[n], i, 0);
      ck_rel(value.v[n + 1], j, 0);
      n += 2;
    }
  }
  ck_assert_uint_eq(value.n, n / 2);
}

PH_TEST(test_bad_polyline) {
  bad(&curve, "[[[0,0],[1,1]],[[1,1],[2,2],[3,3],[1e999,4]]]", PH_E_NOT_FINITE,
      "curve[1][3][0]", "is 1e999, which overflows a double");
  bad(&curve, "[[[0,0],[1,1]],[[1,1],[2,\"2\"]]]", PH_E_BAD_TYPE,
      "curve[1][1][1]", "must be a number, found a string");
  bad(&curve, "[[[0,0],[1,1]],[[1,1],[2,[2]]]]", PH_E_BAD_TYPE,
      "curve[1][1][1]", "must be a number, found an array");
  bad(&curve, "[[[0,0],[1,1]],[[1,1],2]]", PH_E_BAD_TYPE, "curve[1][1]",
      "must be an array of numbers, found a number");
  bad(&curve, "[[[0,0],[1,1]],null]", PH_E_BAD_TYPE, "curve[1]",
      "must be an array of points, found null");
  bad(&curve, "[[[0,0],[1,1]],[1,1]]", PH_E_BAD_TYPE, "curve[1][0]",
      "must be an array of numbers, found a number");
  bad(&curve, "[[0,0],[[1,1],[2,2]]]", PH_E_BAD_TYPE, "curve[1][0]",
      "must be a number, found an array");
  bad(&curve, "[[[0,0],[1,1]],[]]", PH_E_BAD_SHAPE, "curve[1]",
      "has no points");
  bad(&curve, "[[ ], [[0,0],[1,1]]]", PH_E_BAD_SHAPE, "curve[0]",
      "has no points");
  bad(&curve, "[[]]", PH_E_BAD_SHAPE, "curve[0]",
      "must have 2 numbers, found 0");
  bad(&curve, "[[[]]]", PH_E_BAD_SHAPE, "curve[0][0]",
      "must have 2 numbers, found 0");
  bad(&curve, "[[[0,0],[1,1]],[[1,1],[2,2,2]]]", PH_E_BAD_SHAPE, "curve[1][1]",
      "must have 2 numbers, found 3");
  bad(&any_curve, "[[[0,0,0],[1,1,1]],[[1,1]]]", PH_E_BAD_SHAPE, "curve[1][0]",
      "must have 3 numbers as curve[0][0] has, found 2");
  bad(&any_curve, "[[0,0],[1,1,1]]", PH_E_BAD_SHAPE, "curve[1]",
      "must have 2 numbers as curve[0] has, found 3");
  bad(&curve, "[1,[[0,0]]]", PH_E_BAD_TYPE, "curve",
      "must be an array of points [x,y] or an array of such arrays, found an "
      "array of numbers");
  bad(&curve, "null", PH_E_BAD_TYPE, "curve",
      "must be an array of points [x,y] or an array of such arrays, found "
      "null");
  bad_option(&curve, "0,1", PH_E_BAD_TYPE,
             "must be an array of points [x,y] or an array of such arrays, "
             "found \"0,1\"");
  bad_option(&curve, "[[[0,1]]", PH_E_SYNTAX,
             "must be JSON: the text ends inside an array");
}

PH_TEST(test_bad_types) {
  bad(&any_points, "{}", PH_E_BAD_TYPE, "points",
      "must be an array of points [x,y] or [x,y,z], found an object");
  bad(&ends, "null", PH_E_BAD_TYPE, "end_derivatives",
      "must be an array of vectors [x,y], found null");
  bad(&closed, "[]", PH_E_BAD_TYPE, "closed",
      "must be true or false, found an array");
  bad(&basis, "true", PH_E_BAD_TYPE, "basis",
      "must be \"ph\" or \"atph\", found true");
  bad(&knots, "false", PH_E_BAD_TYPE, "knots",
      "must be \"chordal\", \"centripetal\", \"uniform\" or an array of "
      "numbers, found false");
  bad(&everything, "null", PH_E_BAD_TYPE, "knots",
      "must be true, false, \"warn\", a number, an array of numbers or an "
      "array of vectors [x,y] or [x,y,z], found null");
}

PH_TEST(test_bad_elements) {
  bad(&points, "[[0,0],null]", PH_E_BAD_TYPE, "points[1]",
      "must be an array of numbers, found null");
  bad(&points, "[[[0],0]]", PH_E_BAD_TYPE, "points[0][0]",
      "must be a number, found an array");
  bad(&points, "[[0,null]]", PH_E_BAD_TYPE, "points[0][1]",
      "must be a number, found null");
  bad(&knots, "[0,1,{}]", PH_E_BAD_TYPE, "knots[2]",
      "must be a number, found an object");
  bad(&knots, "[0,[1]]", PH_E_BAD_TYPE, "knots[1]",
      "must be a number, found an array");
}

PH_TEST(test_bad_shapes) {
  bad(&points, "[[0,0],[1,1],[2,2],[3,3,3]]", PH_E_BAD_SHAPE, "points[3]",
      "must have 2 numbers, found 3");
  bad(&points, "[[0,0],[]]", PH_E_BAD_SHAPE, "points[1]",
      "must have 2 numbers, found 0");
  bad(&any_points, "[[1,2,3,4,5,6,7,8]]", PH_E_BAD_SHAPE, "points[0]",
      "must have 2 or 3 numbers, found 8");
}

PH_TEST(test_not_finite) {
  bad(&points, "[[0,0],[1,1],[2,2],[3,3],[4,1e999]]", PH_E_NOT_FINITE,
      "points[4][1]", "is 1e999, which overflows a double");
  bad(&knots, "[0,-1e309]", PH_E_NOT_FINITE, "knots[1]",
      "is -1e309, which overflows a double");
  bad(&number, "2e308", PH_E_NOT_FINITE, "basis",
      "is 2e308, which overflows a double");
  bad(&number, "1000000000000000000000000000000000000000000e500",
      PH_E_NOT_FINITE, "basis",
      "is 1000000000000000000000000000000000000000..., "
      "which overflows a double");
}

PH_TEST(test_bad_words) {
  const char *phrase = "must be \"chordal\", \"centripetal\", \"uniform\" or "
                       "an array of numbers, found ";
  char message[PH_DIAG_MESSAGE_MAX];
  snprintf(message, sizeof message, "%s\"chordl\"; did you mean \"chordal\"?",
           phrase);
  bad(&knots, "\"chordl\"", PH_E_BAD_VALUE, "knots", message);
  snprintf(message, sizeof message, "%s\"geodesic\"", phrase);
  bad(&knots, "\"geodesic\"", PH_E_BAD_VALUE, "knots", message);
  bad(&basis, "\"\"", PH_E_BAD_VALUE, "basis",
      "must be \"ph\" or \"atph\", found \"\"");
  bad(&basis, "\"PH\"", PH_E_BAD_VALUE, "basis",
      "must be \"ph\" or \"atph\", found \"PH\"; did you mean \"ph\"?");
  bad(&basis, "\"ph|atph\"", PH_E_BAD_VALUE, "basis",
      "must be \"ph\" or \"atph\", found \"ph|atph\"");
  bad(&basis, "\"a\\nb\"", PH_E_BAD_VALUE, "basis",
      "must be \"ph\" or \"atph\", found \"a\\nb\"");
  /* A text that cJSON would end at its NUL is no word. */
  bad(&basis, "\"ph\\u0000\"", PH_E_BAD_VALUE, "basis",
      "must be \"ph\" or \"atph\", found \"ph\\u0000\"");
  bad(&basis, "\"ph\\\\u0000\"", PH_E_BAD_VALUE, "basis",
      "must be \"ph\" or \"atph\", found \"ph\\\\u0000\"");
  bad(&basis, "\"12345678901234567890123456789012345678\xC3\xA4\xC3\xA4 \"",
      PH_E_BAD_VALUE, "basis",
      "must be \"ph\" or \"atph\", found "
      "\"12345678901234567890123456789012345678\xC3\xA4...\"");
}

PH_TEST(test_string) {
  static const char text[] =
      "\"\\\"\\\\\\/\\b\\f\\n\\r\\t\\u00e4\\uD83D\\uDE00\xC3\xA4\"";
  static const char nul[] = "\"a\\u0000b\"";
  static const char no_nul[] = "\"a\\\\u0000b\"";
  ck_assert_str_eq(ph_value_string(text, sizeof text - 1, &unit_arena),
                   "\"\\/\b\f\n\r\t\xC3\xA4\xF0\x9F\x98\x80\xC3\xA4");
  ck_assert_str_eq(ph_value_string(nul, sizeof nul - 1, &unit_arena),
                   "a\\u0000b");
  ck_assert_str_eq(ph_value_string(no_nul, sizeof no_nul - 1, &unit_arena),
                   "a\\u0000b");
  ck_assert_str_eq(ph_value_string("\"\"", 2, &unit_arena), "");
}

PH_TEST(test_options) {
  static const double v[] = {0, 1, 2, 3};
  ck_word(option(&basis, "atph"), "atph");
  ck_word(option(&basis, "\"atph\""), "atph");
  ck_word(option(&knots, "uniform"), "uniform");
  ck_bool(option(&closed, "true"), true);
  ck_bool(option(&closed, " false "), false);
  ck_bool(option(&closed, ""), true);
  ck_bool(option(&everything, ""), true);
  ck_number(option(&number, "0.8"), 0.8);
  ck_number(option(&number, ".8"), 0.8);
  ck_number(option(&number, "+1"), 1);
  ck_number(option(&number, "-1"), -1);
  ck_number(option(&number, " 2 "), 2);
  ck_array(option(&points, "[[0,1],[2,3]]"), PH_VECTORS, 2, 2, v);
  ck_array(option(&knots, " [0, 1, 2] "), PH_NUMBERS, 3, 1, v);
}

PH_TEST(test_bad_options) {
  bad_option(&basis, "atp", PH_E_BAD_VALUE,
             "must be \"ph\" or \"atph\", found \"atp\"; "
             "did you mean \"atph\"?");
  bad_option(&basis, "", PH_E_BAD_VALUE,
             "must be \"ph\" or \"atph\", found \"\"");
  bad_option(&basis, "true", PH_E_BAD_TYPE,
             "must be \"ph\" or \"atph\", found true");
  bad_option(&basis, "a\x1b[0m", PH_E_BAD_VALUE,
             "must be \"ph\" or \"atph\", found \"a\\x1b[0m\"");
  bad_option(&closed, "yes", PH_E_BAD_TYPE,
             "must be true or false, found \"yes\"");
  bad_option(&closed, "True", PH_E_BAD_TYPE,
             "must be true or false, found \"True\"");
  bad_option(&number, "", PH_E_BAD_TYPE, "must be a number, found \"\"");
  bad_option(&number, "abc", PH_E_BAD_TYPE, "must be a number, found \"abc\"");
  bad_option(&number, "1 2", PH_E_BAD_TYPE, "must be a number, found \"1 2\"");
  bad_option(&number, "nan", PH_E_BAD_TYPE, "must be a number, found \"nan\"");
  bad_option(&number, "1e999", PH_E_NOT_FINITE,
             "is 1e999, which overflows a double");
  bad_option(&number, "+1e999", PH_E_NOT_FINITE,
             "is +1e999, which overflows a double");
  bad_option(&points, "[[0,1],[2", PH_E_SYNTAX,
             "must be JSON: the text ends inside an array");
  bad_option(&points, "[[0,1],]", PH_E_SYNTAX,
             "must be JSON: expected a value, found ']'");
  bad_option(&points, "[[0,1]] x", PH_E_SYNTAX,
             "must be JSON: something follows the value");
  bad_option(&basis, "\"ph", PH_E_SYNTAX,
             "must be JSON: the text ends inside a string");
  bad_option(&points, "0,1", PH_E_BAD_TYPE,
             "must be an array of points [x,y], found \"0,1\"");
}

PH_TEST(test_describe) {
  static const struct ph_field many = {
      PH_F_BASIS,
      PH_WORD,
      0,
      false,
      "0123456789012345678901234567890123456789|"
      "0123456789012345678901234567890123456789|"
      "0123456789012345678901234567890123456789|"
      "0123456789012345678901234567890123456789|"
      "0123456789012345678901234567890123456789|"
      "0123456789012345678901234567890123456789|end",
      "",
      ""};
  char phrase[PH_VALUE_PHRASE_MAX];
  ck_assert_str_eq(ph_value_describe(&number, phrase), "a number");
  ck_assert_str_eq(ph_value_describe(&basis, phrase), "\"ph\" or \"atph\"");
  /* What does not fit is cut. */
  ck_assert_uint_eq(strlen(ph_value_describe(&many, phrase)),
                    PH_VALUE_PHRASE_MAX - 1);
}

PH_TEST(test_required) {
  struct ph_field rows[2];
  struct ph_schema schema = {"planar", rows, 2};
  struct ph_problem problem = {0};
  rows[0] = closed;
  rows[1] = points;
  ck_diag(ph_problem_check_required(&problem, &schema, &diag),
          PH_E_MISSING_FIELD, "points",
          "is missing: it must be an array of points [x,y]");
  problem.field[PH_F_POINTS].kind = PH_VECTORS;
  ck_assert_int_eq(ph_problem_check_required(&problem, &schema, &diag), PH_OK);
}
