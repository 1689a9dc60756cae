/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The splitter: what it cuts out of JSON, what it does with broken text, how it
 * finds formats and files, and that neither the portions in which the text
 * arrives nor the way of waiting for it make any difference.  CSV has a file
 * of its own, t_split_csv.c.
 */
#include "split_unit.h"

/* ---- JSON ----------------------------------------------------------- */

PH_TEST(test_json_streams) {
  gives("a.json", "", "end");
  gives("a.json", " \n ", "end");
  gives("a.json", "{}", "1 1 {}\nend");
  gives("a.json", "\n {\n}\n", "1 2 {$}\nend");
  gives("a.json", "{}{}\n\n[1]", "1 1 {}\n2 1 {}\n3 3 1\nend");
  gives("a.json", "[]", "end");
  gives("a.json", "[{},\n{} , [2] ]{}", "1 1 {}\n2 2 {}\n3 2 [2]\n4 2 {}\nend");
  gives("a.json", "[][1][]", "1 1 1\nend");
  gives("a.json", "12", "1 1 12\nend");
  gives("a.json", "12 \"a\"true", "1 1 12\n2 1 \"a\"\n3 1 true\nend");
  gives("a.json", "\xEF\xBB\xBF{}", "1 1 {}\nend");
  gives("a.json", "\xEF\xBB\xBF", "end");
}

PH_TEST(test_json_stops) {
  gives("a.json", "{\"a\":}",
        "1 1 syntax 1:6 expected a value, found '}'\nstopped");
  gives("a.json", "{} {\"a\" 1}\n{}\n",
        "1 1 {}\n2 1 syntax 1:9 expected ':', found '1'\nstopped");
  gives("a.json", "{} x\n{}\n",
        "1 1 {}\n2 1 syntax 1:4 expected a value, found \"x\"\nstopped");
  gives("a.json", "[{}\n{}]",
        "1 1 {}\n2 2 syntax 2:1 expected ',' or ']', found '{'\nstopped");
  gives("a.json", "[{},]\n{}",
        "1 1 {}\n2 1 syntax 1:5 expected a value, found ']'\nstopped");
  gives("a.json", "[,1]",
        "1 1 syntax 1:2 expected a value, found ','\nstopped");
  gives("a.json", "[{}",
        "1 1 {}\n2 1 syntax 1:4 the text ends inside an array\nstopped");
  gives("a.json", "[{},\n",
        "1 1 {}\n2 2 syntax 2:1 the text ends inside an array\nstopped");
  gives("a.json", "[", "1 1 syntax 1:2 the text ends inside an array\nstopped");
  gives("a.json", "[{\"a\"",
        "1 1 syntax 1:6 the text ends inside an object\nstopped");
  gives("a.json", "{}]",
        "1 1 {}\n2 1 syntax 1:3 expected a value, found ']'\nstopped");
  gives("a.json", "{\n\"a\":[1,\n2\n",
        "1 1 syntax 4:1 the text ends inside an array\nstopped");
  /* What a pretty-printed text breaks cannot be resumed in its middle. */
  gives("a.json", "{\"a\":\n  {\"b\" 1}\n}\n{\"c\":1}\n",
        "1 1 syntax 2:8 expected ':', found '1'\nstopped");
  /* Values that share lines are no JSON Lines. */
  gives("a.json", "{}{}\n{\"a\"}\n",
        "1 1 {}\n2 1 {}\n3 2 syntax 2:5 expected ':', found '}'\nstopped");
  gives("a.json", "{\n}\n{\"a\"}\n",
        "1 1 {$}\n2 3 syntax 3:5 expected ':', found '}'\nstopped");
  gives("a.json", "[1]\n{\"a\"}\n",
        "1 1 1\n2 2 syntax 2:5 expected ':', found '}'\nstopped");
}

PH_TEST(test_json_resumes) {
  /* (a) the suffix says so */
  gives("a.jsonl", "{\"a\"}\n", "1 1 syntax 1:5 expected ':', found '}'\nend");
  gives("a.NDJSON", "x\n\n  {\"a\"}\r\n1\n",
        "1 1 syntax 1:1 expected a value, found \"x\"\n"
        "2 3 syntax 3:7 expected ':', found '}'\n3 4 1\nend");
  gives("a.jsonl", "{\"a\":[1,2",
        "1 1 syntax 1:10 the text ends inside an array\nend");
  gives("a.jsonl", "{} x\n{}\n",
        "1 1 {}\n2 1 syntax 1:4 expected a value, found \"x\"\n3 2 {}\nend");
  gives("a.jsonl", "{}},x y\n,{} {}\n{}",
        "1 1 {}\n2 1 syntax 1:3 expected a value, found '}'\n"
        "3 2 syntax 2:1 expected a value, found ','\n4 3 {}\nend");
  gives("a.jsonl", "[1,\nx]\n{}\n",
        "1 1 1\n2 2 syntax 2:1 expected a value, found \"x\"\nstopped");
  /* (b) the values before it were lines */
  gives("a.json", "{}\n {} \r\n{\"a\"}\n5\n",
        "1 1 {}\n2 2 {}\n3 3 syntax 3:5 expected ':', found '}'\n4 4 5\nend");
  gives("a.json", "{}\n{\"a\"",
        "1 1 {}\n2 2 syntax 2:5 the text ends inside an object\nend");
  gives("a.json", "{}\n{},\n5\n",
        "1 1 {}\n2 2 {}\n3 2 syntax 2:3 expected a value, found ','\n"
        "4 3 5\nend");
  gives("a.json", "{}\n{},\n{}\nx\n5\n",
        "1 1 {}\n2 2 {}\n3 2 syntax 2:3 expected a value, found ','\n"
        "4 3 {}\n5 4 syntax 4:1 expected a value, found \"x\"\n6 5 5\nend");
  gives("a.json", "{}\n{} {},\n5\n",
        "1 1 {}\n2 2 {}\n3 2 {}\n"
        "4 2 syntax 2:6 expected a value, found ','\nstopped");
  /* (c) an object follows */
  gives("a.json", "{\"a\"}\n{}\n",
        "1 1 syntax 1:5 expected ':', found '}'\n2 2 {}\nend");
  gives("a.json", "{\"a\"}\n\n \t\r\n{}\n",
        "1 1 syntax 1:5 expected ':', found '}'\n2 4 {}\nend");
  gives("a.json", "{\"a\"}\n\n {}\n",
        "1 1 syntax 1:5 expected ':', found '}'\nstopped");
  gives("a.json", "{\"a\"}\n[]\n",
        "1 1 syntax 1:5 expected ':', found '}'\nstopped");
}

/* A truncated line takes none of the good lines after it away. */
PH_TEST(test_json_truncated_line) {
  gives("a.json", "{\"a\":[1,\n{\"b\":2}\n{\"c\":[[1,\n{\"d\":\"x\n{\"e\":4}\n",
        "1 1 syntax 1:9 the text ends inside an array\n2 2 {\"b\":2}\n"
        "3 3 syntax 3:10 the text ends inside an array\n"
        "4 4 syntax 4:8 the text ends inside a string\n5 5 {\"e\":4}\nend");
  gives("a.jsonl", "{\"a\":\r\n{\"b\":2}\r\n",
        "1 1 syntax 1:6 the text ends inside an object\n2 2 {\"b\":2}\nend");
  /* In JSON Lines or not: a good value may have several lines. */
  gives("a.jsonl", "{\"a\":\n{\"b\":2}}\n", "1 1 {\"a\":${\"b\":2}}\nend");
}

/* ---- files and descriptors ------------------------------------------ */

PH_TEST(test_formats) {
  struct ph_split_options json = {.format = PH_SPLIT_JSON};
  gives("a.txt", "\n \t{}", "1 2 {}\nend");
  gives("a.txt", "[1]", "1 1 1\nend");
  gives("a.txt", "\xEF\xBB\xBF\n{}", "1 2 {}\nend");
  gives("a.txt", "0,1\n", "1 1 0,1$\nend");
  gives("a.txt", "\n\n  x,y\n0,1\n", "1 4 0,1$\nend");
  gives("a.txt", "\xEF\xBBx,y\n0,1\n",
        "1 1 unknown-field 1:1 column \"\\xef\\xbbx\" is unknown to planar "
        "(--ignore-columns skips it)\nstopped");
  gives("a.txt", "", "end");
  gives("a.txt", "\n ", "end");
  gives("a.csv", "{}\n",
        "1 1 syntax 1:1 the input is JSON: --input-format=json and geojson "
        "read it\nstopped");
  gives("a.json", "0,1\n",
        "1 1 0\n2 1 syntax 1:2 expected a value, found ','\nstopped");
  gives_with(&json, &schema, "5", "1 1 5\nend");
  gives_with(&csv, &schema, "0,1", "1 1 0,1\nend");
}

PH_TEST(test_several_files) {
  static const char *const files[] = {"a.json", "a.csv", "b.csv", "a.tsv",
                                      "b.json"};
  put_file("a.json", "{}\n{}");
  put_file("a.csv", "x,y\n0,1");
  put_file("b.csv", "id,y,x\n0,1,2\n1,2,3\n");
  put_file("a.tsv", "0\t1\n");
  put_file("b.json", "[{}, {}]");
  ck_files(files, 5, &automatic, &schema,
           "1 1 {}\n2 2 {}\n3 2 0,1\n4 2 0,1,2$\n5 3 1,2,3$\n6 1 0\t1$\n"
           "7 1 {}\n8 1 {}\nend");
}

PH_TEST(test_failures) {
  static const char *const missing[] = {"b.json", "a.txt", "b.json"};
  static const char *const folder[] = {"."};
  put_file("b.json", "{}");
  ck_files(missing, 3, &automatic, &schema,
           "1 1 {}\nfailed: cannot open a.txt: No such file or directory");
  ck_files(folder, 1, &automatic, &schema,
           "failed: cannot read .: Is a directory");
}

/* The names and columns of records outlive the records. */
PH_TEST(test_record_parts) {
  static const char *const files[] = {"a.csv", "b.csv"};
  struct ph_split split;
  struct ph_record first;
  struct ph_record second;
  struct ph_diag diag;
  put_file("a.csv", "y,x\n0,1\n");
  put_file("b.csv", "x,y\n0,1\n");
  begin(&split, files, 2, &automatic, &schema);
  ck_assert_int_eq(ph_split_next(&split, true, &first, &diag), PH_SPLIT_RECORD);
  ck_assert_int_eq(ph_split_next(&split, true, &second, &diag),
                   PH_SPLIT_RECORD);
  ck_assert_str_eq(first.file, "a.csv");
  ck_assert_str_eq(second.file, "b.csv");
  ck_assert_uint_eq(first.columns->column[0].component, 1);
  ck_assert_uint_eq(second.columns->column[0].component, 0);
  ph_split_free(&split);
}

/* A record is handed out with its last byte. */
PH_TEST(test_interactive) {
  int fd = open_pipe();
  struct ph_split split;
  struct ph_record record;
  struct ph_diag diag;
  begin(&split, NULL, 0, &automatic, &schema);
  ck_assert_int_eq(ph_split_next(&split, false, &record, &diag), PH_SPLIT_WAIT);
  write_all(fd, "{\"a\":1", 6);
  ck_assert_int_eq(ph_split_next(&split, false, &record, &diag), PH_SPLIT_WAIT);
  write_all(fd, "}", 1);
  ck_assert_int_eq(ph_split_next(&split, false, &record, &diag),
                   PH_SPLIT_RECORD);
  ck_assert_uint_eq(record.n, 7);
  ck_assert_str_eq(record.file, "-");
  write_all(fd, "\n{}{}", 5);
  ck_assert_int_eq(ph_split_next(&split, true, &record, &diag),
                   PH_SPLIT_RECORD);
  ck_assert_int_eq(ph_split_next(&split, false, &record, &diag),
                   PH_SPLIT_RECORD);
  ck_assert_int_eq(ph_split_next(&split, false, &record, &diag), PH_SPLIT_WAIT);
  close(fd);
  ck_assert_int_eq(ph_split_next(&split, false, &record, &diag), PH_SPLIT_END);
  ck_assert(!ph_split_stopped(&split));
  ph_split_free(&split);
  ck_assert_int_ge(fcntl(0, F_GETFD), 0); /* standard input stays open */
}

PH_TEST(test_nonblocking_input) {
  int fd = open_pipe();
  struct ph_split split;
  struct ph_record record;
  struct ph_diag diag;
  ck_assert_int_eq(fcntl(0, F_SETFL, O_NONBLOCK), 0);
  begin(&split, NULL, 0, &automatic, &schema);
  ck_assert_int_eq(ph_split_next(&split, false, &record, &diag), PH_SPLIT_WAIT);
  write_all(fd, "{}", 2);
  ck_assert_int_eq(ph_split_next(&split, true, &record, &diag),
                   PH_SPLIT_RECORD);
  close(fd);
  ck_assert_int_eq(ph_split_next(&split, true, &record, &diag), PH_SPLIT_END);
  ph_split_free(&split);
}

/* ---- memory --------------------------------------------------------- */

/* Records from tiny to larger than any buffer so far and back. */
PH_TEST(test_sizes) {
  static const size_t sizes[] = {10,    100,  70000,  3,       3000000,
                                 65535, 5000, 131072, 1000000, 2};
  enum { N = COUNT(sizes) };
  const size_t repeat = (size_t)unit_count(40);
  const char *name = "a.json";
  struct ph_split split;
  struct ph_record record;
  struct ph_diag diag;
  FILE *file = fopen(name, "w");
  size_t largest = 0;
  ck_assert_ptr_nonnull(file);
  for (size_t i = 0; i < N * repeat; i++) {
    size_t n = sizes[i / repeat];
    fprintf(file, "\"%0*zu\"\n", (int)n - 2, i % 7);
    largest = n > largest ? n : largest;
  }
  fclose(file);
  begin(&split, &name, 1, &automatic, &schema);
  for (size_t i = 0; i < N * repeat; i++) {
    size_t n = sizes[i / repeat];
    ck_assert_int_eq(ph_split_next(&split, true, &record, &diag),
                     PH_SPLIT_RECORD);
    ck_assert_uint_eq(record.n, n == 2 ? 3 : n);
    ck_assert_uint_eq(record.line, i + 1);
    ck_assert_int_eq(record.text[record.n - 2], (int)('0' + i % 7));
    ck_assert_uint_le(split.capacity, 4 * largest + (1 << 17));
  }
  ck_assert_int_eq(ph_split_next(&split, true, &record, &diag), PH_SPLIT_END);
  /* The buffer of three megabytes is gone. */
  ck_assert_uint_le(split.capacity, 1 << 20);
  ph_split_free(&split);
}

/* ---- portions ------------------------------------------------------- */

static const char json_lines[] =
    "{\"id\":1,\"points\":[[0,0],[1,-2.5e3]]}\n"
    "{\"id\":\"\\u00e4\xC3\xA4\",\"points\":[[0,0]],\"closed\":true}\n"
    "{\"points\":[[0,1],[2,3]],\"knots\":\"uniform\"}\n";
static const char json_array[] =
    "[{\"points\":[[0,0],\n[1,1e5]],\"meta\":{\"a\":[null]}},\n {} ]\n[] {}\n";
static const char csv_ids[] =
    "\xEF\xBB\xBFid,x,y,knot\r\n# c\r\na,0,1,2\r\n\"a\",2,3,4\r\n"
    "\"b \"\"\nc\",4,5,\r\n\r\n7,1e1,.5,\r\n";
static const char csv_comment[] = "# x_m,y_m\n0,1\n2,3\n\n4,5\n";
static const char csv_bad[] = "0\t1\t2\n3,4\n";
static const char json_blanks[] = " \n\n \t{\"points\":[[0,0]]}\n \n[]";
static const char csv_blanks[] = "\n \n 0,1\n";
static const char geojson[] =
    "{\"type\":\"FeatureCollection\",\"a\":[1],\"features\":[\n{\"type\":"
    "\"Feature\",\"id\":1,\"geometry\":{\"type\":\"Polygon\",\"coordinates\":"
    "[[[0,1]],[[2,3]]]}}],\"b\":{}}";
static const char geojson_texts[] =
    "\x1e{\"type\":\"MultiPoint\",\"coordinates\":[[0,1,\n2]]}\n"
    "\x1e{\"type\":\"Feature\",\"geometry\":null}\n\x1e[1]\n";
static const char *const documents[] = {json_lines,  json_array, csv_ids,
                                        csv_comment, csv_bad,    json_blanks,
                                        csv_blanks,  geojson,    geojson_texts};

/* Some of these documents' records are longer. */
static const struct ph_split_options short_records = {.format = PH_SPLIT_AUTO,
                                                      .most = 20};

/* Every byte of a document, or one in ten where every step takes long. */
static size_t stride(void) {
  return (size_t)(10 / unit_count(10));
}

/* Every beginning of a document. */
PH_TEST_EACH(test_prefixes, COUNT(documents)) {
  const char *text = documents[_i];
  for (size_t n = 0; n <= strlen(text); n += stride()) {
    ck_portions(&automatic, text, n);
    ck_portions(&short_records, text, n);
  }
}

/* Every document with one byte replaced, left out or doubled; where every step
 * takes long, replaced by one in four of the others, in turn. */
PH_TEST_EACH(test_mutations, COUNT(documents)) {
  static const char bytes[] = "\n\"{]#,0\xC3";
  const char *text = documents[_i];
  size_t n = strlen(text);
  size_t every = unit_long() ? 256 : sizeof bytes - 1;
  size_t step = stride() > 1 ? 4 : 1;
  char spoilt[256];
  ck_assert_uint_lt(n + 1, sizeof spoilt);
  for (size_t i = 0; i < n; i += stride()) {
    for (size_t k = i / stride() % step; k < every; k += step) {
      memcpy(spoilt, text, n);
      spoilt[i] = unit_long() ? (char)k : bytes[k];
      ck_portions(&automatic, spoilt, n);
      ck_portions(&short_records, spoilt, n);
    }
    memcpy(spoilt, text, i);
    memcpy(spoilt + i, text + i + 1, n - i - 1);
    ck_portions(&automatic, spoilt, n - 1);
    ck_portions(&short_records, spoilt, n - 1);
    memcpy(spoilt, text, i + 1);
    memcpy(spoilt + i + 1, text + i, n - i);
    ck_portions(&automatic, spoilt, n + 1);
    ck_portions(&short_records, spoilt, n + 1);
  }
}

PH_FIXTURE(setup, finish)
