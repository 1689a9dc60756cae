/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The JSON scanner: what it accepts, what it says, and that it does not matter
 * in which portions the text arrives. */
#include "unit.h"

#include "io/json_scan.h"

/* A copy of its own size on the heap: a read beyond it shows. */
static char *heap(const char *text, size_t n) {
  char *copy = malloc(n ? n : 1);
  ck_assert_ptr_nonnull(copy);
  memcpy(copy, text, n);
  return copy;
}

/* One more portion of a scan, of text[n]. */
static enum ph_json_state go_on(struct ph_json_scan *scan, const char *text,
                                size_t n, bool last) {
  char *copy = heap(text, n);
  enum ph_json_state state = ph_json_scan(scan, copy, n, last);
  free(copy);
  return state;
}

/* The scan of a whole text, which arrives in portions of `step` bytes. */
static enum ph_json_state in_portions(struct ph_json_scan *scan,
                                      const char *text, size_t n, size_t step) {
  enum ph_json_state state = PH_JSON_MORE;
  *scan = (struct ph_json_scan){0};
  for (size_t have = step; state == PH_JSON_MORE && have < n; have += step) {
    state = go_on(scan, text, have, false);
  }
  return state == PH_JSON_MORE ? go_on(scan, text, n, true) : state;
}

/* Checks a text in portions of every size. */
static void ck_scan(const char *text, size_t n, enum ph_json_state state,
                    size_t at, const char *message) {
  for (size_t step = n + 1; step >= 1; step--) {
    struct ph_json_scan scan;
    enum ph_json_state found = in_portions(&scan, text, n, step);
    ck_assert_msg(found == state, "%s by %zu: state %d: %s", text, step,
                  (int)found, scan.message);
    ck_assert_msg(scan.at == at, "%s by %zu: at %zu, expected %zu", text, step,
                  scan.at, at);
    if (state == PH_JSON_ERROR) {
      ck_assert_str_eq(scan.message, message);
    }
  }
}

static void good(const char *text) {
  ck_scan(text, strlen(text), PH_JSON_DONE, strlen(text), NULL);
}

static void bad(const char *text, size_t at, const char *message) {
  ck_scan(text, strlen(text), PH_JSON_ERROR, at, message);
}

PH_TEST(test_good) {
  good("0");
  good("-0");
  good("12");
  good("-12.50e+03");
  good("1E5");
  good("1e-5");
  good("0.5");
  good("0e1");
  good("true");
  good("false");
  good("null");
  good("\"\"");
  good("\"abc\x7f\"");
  good("\"\\\"\\\\\\/\\b\\f\\n\\r\\t\\u00e4\\uD83D\\uDE00\\u0000\"");
  good("\"\xC3\xA4\xE2\x82\xAC\xF0\x9F\x98\x80\"");
  good("[]");
  good("{}");
  good("[ ]");
  good("{ }");
  good(" \t\r\n[1]");
  good("[1,-2.5,[true,{}],\"]\"]");
  good("[ 1 , 2 ]");
  good("{\"a\":1,\"b\" : [ ] , \"c\":{\"d\":null}}");
}

PH_TEST(test_end) {
  ck_scan("1,", 2, PH_JSON_DONE, 1, NULL);
  ck_scan("1 2", 3, PH_JSON_DONE, 1, NULL);
  ck_scan("[1]]", 4, PH_JSON_DONE, 3, NULL);
  ck_scan("{}{}", 4, PH_JSON_DONE, 2, NULL);
  ck_scan("\"a\"b", 4, PH_JSON_DONE, 3, NULL);
  ck_scan("true,", 5, PH_JSON_DONE, 4, NULL);
}

PH_TEST(test_bad_structure) {
  bad("[1 x", 3, "expected ',' or ']', found 'x'");
  bad("[1}", 2, "expected ',' or ']', found '}'");
  bad("{\"a\":1]", 6, "expected ',' or '}', found ']'");
  bad("{\"a\" 1}", 5, "expected ':', found '1'");
  bad("{\"a\":}", 5, "expected a value, found '}'");
  bad("{\"a\":1,}", 7, "expected a name in double quotes, found '}'");
  bad("{a:1}", 1, "expected a name in double quotes or '}', found 'a'");
  bad("{'a':1}", 1, "expected a name in double quotes or '}', found \"'\"");
  bad("[1,]", 3, "expected a value, found ']'");
  bad("[,1]", 1, "expected a value or ']', found ','");
  bad("}", 0, "expected a value, found '}'");
  bad("'a'", 0, "expected a value, found \"'\"");
  bad("// a\n1", 0, "expected a value, found '/'; JSON has no comments");
  bad("[1 /* a */]", 3, "expected ',' or ']', found '/'; JSON has no comments");
  bad("[1\x01]", 2, "expected ',' or ']', found '\\x01'");
  bad("[1\xC3\xA4]", 2, "expected ',' or ']', found '\xC3\xA4'");
  bad("[1\xFF]", 2, "expected ',' or ']', found '\\xff'");
  bad("[1\xC3", 2, "expected ',' or ']', found '\\xc3'");
  bad("\xEF\xBB\xBF[]", 0, "expected a value, found '\\xef\\xbb\\xbf'");
  ck_scan("[1\0]", 4, PH_JSON_ERROR, 2, "expected ',' or ']', found '\\x00'");
}

PH_TEST(test_bad_words) {
  bad("NaN", 0, "NaN is not JSON: numbers are finite");
  bad("[1,nan]", 3, "nan is not JSON: numbers are finite");
  bad("Infinity", 0, "Infinity is not JSON: numbers are finite");
  bad("-Infinity", 1, "Infinity is not JSON: numbers are finite");
  bad("[-inf]", 2, "inf is not JSON: numbers are finite");
  bad("tru", 0, "expected a value, found \"tru\"");
  bad("True", 0, "expected a value, found \"True\"");
  bad("truefalse", 0, "expected a value, found \"truefalse\"");
  bad("undefined", 0, "expected a value, found \"undefined\"");
  bad("-null", 1, "expected a digit, found 'n'");
  bad("abcdefghijklmnopqrstuvwxyz", 0,
      "expected a value, found \"abcdefghijklmno\"");
}

PH_TEST(test_bad_numbers) {
  bad("01", 1, "a number has no leading zero");
  bad("[-01]", 3, "a number has no leading zero");
  bad("+1", 0, "expected a value, found '+'");
  bad(".5", 0, "expected a value, found '.'");
  bad("[1.]", 3, "expected a digit, found ']'");
  bad("1.e5", 2, "expected a digit, found 'e'");
  bad("[1e]", 3, "expected a digit, found ']'");
  bad("[1e+]", 4, "expected a digit, found ']'");
  bad("1.\n", 2, "expected a digit, found the end of the line");
  bad("--1", 1, "expected a digit, found '-'");
  bad("[1.2.3]", 4, "expected ',' or ']', found '.'");
  bad("[0x10]", 2, "expected ',' or ']', found 'x'");
}

PH_TEST(test_bad_strings) {
  const char *escape = "a backslash in a string begins none of "
                       "\\\" \\\\ \\/ \\b \\f \\n \\r \\t \\u";
  const char *half = "a \\u escape is half of a surrogate pair";
  bad("\"a\nb\"", 2,
      "a string has the control character \\x0a, which must be escaped");
  bad("\"a\tb\"", 2,
      "a string has the control character \\x09, which must be escaped");
  bad("\"\\q\"", 1, escape);
  bad("\"\\x41\"", 1, escape);
  bad("\"\\u12g4\"", 1, "expected four hexadecimal digits after \\u");
  bad("\"\\uD800\"", 1, half);
  bad("\"\\uD800 1234567\"", 1, half);
  bad("\"\\uD800\\n1234567\"", 1, half);
  bad("\"\\uD800\\uD800\"", 1, half);
  bad("\"\\uD800\\u12345678\"", 1, half);
  bad("\"\\uDC00\\uD800\"", 1, half);
  bad("\"a\xFF\"", 2, "the byte \\xff is not UTF-8");
  bad("\"a\xC3\"", 2, "the byte \\xc3 is not UTF-8");
  bad("\"\xED\xA0\x80\"", 1, "the byte \\xed is not UTF-8");
  bad("\"\xC0\x80\"", 1, "the byte \\xc0 is not UTF-8");
  ck_scan("\"\0\"", 3, PH_JSON_ERROR, 1,
          "a string has the control character \\x00, which must be escaped");
}

PH_TEST(test_cut_off) {
  bad("", 0, "the text ends inside a value");
  bad("  ", 2, "the text ends inside a value");
  bad("[", 1, "the text ends inside an array");
  bad("[1,", 3, "the text ends inside an array");
  bad("[1 ", 3, "the text ends inside an array");
  bad("{", 1, "the text ends inside an object");
  bad("{\"a\"", 4, "the text ends inside an object");
  bad("{\"a\":", 5, "the text ends inside an object");
  bad("[{\"a\":[]", 8, "the text ends inside an object");
  bad("\"abc", 4, "the text ends inside a string");
  bad("\"abc\\", 4 + 1, "the text ends inside a string");
  bad("\"\\u12", 5, "the text ends inside a string");
  bad("\"\\uD800", 7, "the text ends inside a string");
  bad("\"\\uD800\\uDC0", 12, "the text ends inside a string");
  bad("\"\xC3", 2, "the text ends inside a string");
  bad("-", 1, "the text ends inside a number");
  bad("1.", 2, "the text ends inside a number");
  bad("1e", 2, "the text ends inside a number");
  bad("1e-", 3, "the text ends inside a number");
}

PH_TEST(test_depth) {
  char text[2 * PH_JSON_DEPTH_MAX + 3];
  size_t n = PH_JSON_DEPTH_MAX;
  memset(text, '[', n);
  memset(text + n, ']', n);
  ck_scan(text, 2 * n, PH_JSON_DONE, 2 * n, NULL);
  memset(text, '[', n + 1);
  memset(text + n + 1, ']', n + 1);
  ck_scan(text, 2 * n + 2, PH_JSON_ERROR, n,
          "arrays and objects are nested more than 64 deep");
  /* Every level remembers what it is. */
  for (size_t i = 0; i < n; i++) {
    text[i] = '[';
    text[2 * n - 1 - i] = ']';
  }
  text[2 * n - 1] = '}';
  ck_scan(text, 2 * n, PH_JSON_ERROR, 2 * n - 1,
          "expected ',' or ']', found '}'");
}

/* Every beginning of a good text wants more, and is cut off when it is all;
 * a number is whole at any of its digits. */
PH_TEST(test_prefixes) {
  const char *text = "{\"a\\u00e4\\uD83D\\uDE00\xC3\xA4\": [1, -2.5e+3, true, "
                     "null, {\"b\": \"\\n\"}, []], \"c\": 0 }";
  size_t n = strlen(text);
  for (size_t i = 0; i < n; i++) {
    struct ph_json_scan scan = {0};
    ck_assert_int_eq(go_on(&scan, text, i, false), PH_JSON_MORE);
    ck_assert_uint_le(scan.at, i);
    ck_assert_uint_le(i - scan.at, 15);
    ck_assert_int_eq(go_on(&scan, text, i, true), PH_JSON_ERROR);
  }
}

static void ck_item(struct ph_json_walk *walk, const char *key,
                    const char *value) {
  struct ph_json_item item;
  ck_assert(ph_json_walk_next(walk, &item));
  if (key) {
    ck_assert_uint_eq(item.key_n, strlen(key));
    ck_assert_mem_eq(item.key, key, item.key_n);
  } else {
    ck_assert_ptr_null(item.key);
  }
  ck_assert_uint_eq(item.value_n, strlen(value));
  ck_assert_mem_eq(item.value, value, item.value_n);
}

PH_TEST(test_walk) {
  const char *object = " { \"a\" : 1 ,\"b\\\"]\":[1,[2,\"]\\\"\"],{}] , "
                       "\"\":\"}\",\"c\":{\"d\":[{}]},\"e\":true}";
  const char *array = "[ 1, -2e5 ,\"x\",[],{\"a\":0},null ]";
  char *copy = heap(object, strlen(object));
  struct ph_json_walk walk;
  struct ph_json_item item;
  ph_json_walk_init(&walk, copy, strlen(object));
  ck_item(&walk, "a", "1");
  ck_item(&walk, "b\\\"]", "[1,[2,\"]\\\"\"],{}]");
  ck_item(&walk, "", "\"}\"");
  ck_item(&walk, "c", "{\"d\":[{}]}");
  ck_item(&walk, "e", "true");
  ck_assert(!ph_json_walk_next(&walk, &item));
  ck_assert(!ph_json_walk_next(&walk, &item));
  free(copy);
  copy = heap(array, strlen(array));
  ph_json_walk_init(&walk, copy, strlen(array));
  ck_item(&walk, NULL, "1");
  ck_item(&walk, NULL, "-2e5");
  ck_item(&walk, NULL, "\"x\"");
  ck_item(&walk, NULL, "[]");
  ck_item(&walk, NULL, "{\"a\":0}");
  ck_item(&walk, NULL, "null");
  ck_assert(!ph_json_walk_next(&walk, &item));
  free(copy);
}

PH_TEST(test_walk_nothing) {
  static const char *const texts[] = {"[]", "{}",    " [ ] ", "{ }",
                                      "1",  "\"a\"", "null",  ""};
  for (size_t i = 0; i < COUNT(texts); i++) {
    size_t n = strlen(texts[i]);
    char *copy = heap(texts[i], n);
    struct ph_json_walk walk;
    struct ph_json_item item;
    ph_json_walk_init(&walk, copy, n);
    ck_assert_msg(!ph_json_walk_next(&walk, &item), "%s", texts[i]);
    free(copy);
  }
}

/* What the scanner finds good, cut anywhere and spoilt anywhere, in portions:
 * the verdict must be the one on the whole.  Where every step takes long, each
 * place is spoilt by one in five of the bytes, in turn. */
PH_TEST(test_mutations) {
  const char *text = "{\"p\":[[0,-1.5e3],[\"\\u00e4\xC3\xA4\",true]]}";
  static const char bytes[] = "[]{},:\"\\ntfu0-.e \n\x01\x80\xC3\xFF/'x";
  size_t n = strlen(text), step = unit_count(10) < 10 ? 5 : 1;
  char spoilt[64] = "";
  for (size_t i = 0; i < n; i++) {
    for (size_t k = i % step; k < sizeof bytes; k += step) {
      struct ph_json_scan whole;
      enum ph_json_state state;
      memcpy(spoilt, text, n);
      spoilt[i] = bytes[k];
      state = in_portions(&whole, spoilt, n, n);
      ck_scan(spoilt, n, state, whole.at, whole.message);
    }
  }
}
