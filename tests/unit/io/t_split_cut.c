/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Parts of the input: whatever the files hold, the records of all shards in
 * order are those of one shard, for every number of shards; and where nothing
 * is broken these are the records of the stream.
 */
#include "split_unit.h"

/* A kind of file: its name, how it begins, and lines that it may have; of these
 * the first `good` ones are not broken. */
struct sort {
  const char *name;
  enum ph_split_format format;
  const char *head;
  size_t most;
  size_t good, lines_n;
  const char *lines[20];
};

#define LONG "________________________________________"

static const struct sort sorts[] = {
    {"a.jsonl",
     PH_SPLIT_AUTO,
     "",
     36,
     7,
     14,
     {"{\"id\":1}\n", "{\"id\":2} {\"id\":3}\n", "\n", "  \t\n", " {\"i\":[4]}",
      "\r\n", "7\n", "{\"id\":\n", "[1,\n", "[{}]\n", "x{}\n",
      "{\"id\":5,\"x\":\"" LONG "\"}\n", "\"" LONG "\n", "}\"{\n"}},
    {"a.txt",
     PH_SPLIT_AUTO,
     "\xEF\xBB\xBF{\"id\":0}\n",
     0,
     4,
     6,
     {"{\"id\":1}\n", "{\"id\":\"" LONG "\"}\n", "\n", "{}\n", "{\"id\":\n",
      "]\n"}},
    {"a.csv",
     PH_SPLIT_AUTO,
     "id,x,y\n",
     36,
     10,
     19,
     {"a,0,1\n", "a,0,2\n", "b,3,4\n", "\n", " \t\r\n", "# b,1,2\n", "#\n",
      "\"a\",5,6\r\n", "a\n", ",,\n", "\"a\n", "\"a\"x,1,2\n", "b,\"1\n",
      "# " LONG "\n", "a,1,2,\"" LONG "\n", "a,1," LONG "\n",
      "\"" LONG "\",1,2\n", LONG LONG "\n", "          " LONG "\n"}},
    {"a.csv",
     PH_SPLIT_AUTO,
     "\xEF\xBB\xBF",
     0,
     5,
     7,
     {"0,1\n", "2,3\n", "\n", "# 4\n", "5\n", "\"0,1\n", "\"a\"b\n"}},
    {"b.csv",
     PH_SPLIT_AUTO,
     "# y, id, x\n# 1,2\n\n",
     0,
     4,
     5,
     {"0,a,1\n", "2,b,3\n", "\n", "#\n", "\"0\"0,a,1\n"}},
    {"a.tsv",
     PH_SPLIT_AUTO,
     "id\tx\ty\n",
     0,
     3,
     4,
     {"a\t0\t1\n", "b\t2\t3\n", "\n", "\"a\t0\t1\n"}},
    {"a.txt",
     PH_SPLIT_TEXT,
     "",
     0,
     3,
     4,
     {"0 1\n", " 2  3\n", "\n", "\"0 1\n"}},
};

/* Adds what a part of the files gives. */
static void note_part(const struct sort *sort, const char *const *files,
                      size_t n, struct ph_split_part part) {
  const struct ph_split_options options = {
      .format = sort->format, .most = sort->most, .part = part};
  struct ph_split split;
  struct ph_record record;
  struct ph_diag diag = {PH_OK, "", "", 0, 0};
  enum ph_split_state state;
  ck_assert_int_eq(ph_split_init(&split, files, n, &options, &schema, &diag),
                   PH_OK);
  while ((state = ph_split_next(&split, true, &record, &diag)) ==
         PH_SPLIT_RECORD) {
    char head[64];
    snprintf(head, sizeof head, "%s %zu ", record.file, record.byte);
    ph_buf_puts(&transcript, head);
    note(record.text, record.status == PH_E_SYNTAX ? 0 : record.n);
    if (record.status != PH_OK) {
      snprintf(head, sizeof head, " :%zu ", diag.column);
      ph_buf_puts(&transcript, head);
      ph_buf_puts(&transcript, diag.message);
    }
    ph_buf_puts(&transcript, "\n");
  }
  ck_assert_msg(state == PH_SPLIT_END, "%s", diag.message);
  ck_assert(!ph_split_stopped(&split));
  ph_split_free(&split);
}

/* Compares with what is there of one shard. */
static void ck_same(const struct ph_buf *one, const char *what, size_t k,
                    const char *text) {
  ck_assert_msg(one->n == transcript.n &&
                    memcmp(one->data, transcript.data, one->n) == 0,
                "%s %zu of\n%s\none part:\n%.*s\nmore:\n%.*s", what, k, text,
                (int)one->n, one->data, (int)transcript.n, transcript.data);
}

/* Every number of shards, and every place to cut at. */
static void ck_cuts(const struct sort *sort, const char *const *files, size_t n,
                    size_t bytes, size_t most, const char *text) {
  const size_t cuts = (size_t)unit_count(40);
  struct ph_buf one = {0};
  transcript.n = 0;
  note_part(sort, files, n, (struct ph_split_part){PH_PART_SHARD, 0, 1, 0, 0});
  ph_buf_put(&one, transcript.data, transcript.n);
  ck_assert_uint_gt(one.n, 0);
  for (size_t shards = 2; shards <= most; shards++) {
    transcript.n = 0;
    for (size_t k = 0; k < shards; k++) {
      note_part(sort, files, n,
                (struct ph_split_part){PH_PART_SHARD, k, shards, 0, 0});
    }
    ck_same(&one, "shards:", shards, text);
  }
  for (size_t at = 0; at <= bytes; at += 1 + bytes / cuts) {
    transcript.n = 0;
    note_part(sort, files, n,
              (struct ph_split_part){PH_PART_RANGE, 0, 0, 0, at});
    note_part(sort, files, n,
              (struct ph_split_part){PH_PART_RANGE, 0, 0, at, SIZE_MAX});
    ck_same(&one, "cut at", at, text);
  }
  ph_buf_free(&one);
}

/* Writes a random file. */
static size_t write_random(const struct sort *sort, const char *name,
                           size_t lines, bool good, struct unit_random *r,
                           struct ph_buf *text) {
  const size_t n = good ? sort->good : sort->lines_n;
  ph_buf_clear(text, SIZE_MAX);
  ph_buf_puts(text, sort->head);
  ph_buf_puts(text, sort->lines[0]);
  for (size_t i = 0; i < lines; i++) {
    ph_buf_puts(text, sort->lines[unit_random_below(r, n)]);
  }
  if (unit_random_below(r, 2) && text->data[text->n - 1] == '\n') {
    text->n--;
  }
  ph_buf_put(text, "", 1);
  put_file(name, text->data);
  return text->n - 1;
}

PH_TEST_EACH(test_random, COUNT(sorts)) {
  const struct sort *sort = &sorts[_i];
  struct unit_random r = unit_random_of((uint64_t)_i);
  struct ph_buf text = {0};
  const size_t trials = unit_cases(12);
  for (size_t trial = 0; trial < trials; trial++) {
    size_t bytes = write_random(sort, sort->name, trial % 23, false, &r, &text);
    ck_cuts(sort, &sort->name, 1, bytes, bytes + 2 < 30 ? bytes + 2 : 30,
            text.data);
  }
  ph_buf_free(&text);
}

/* Two files, one of which is larger than what is read at once. */
PH_TEST_EACH(test_large, COUNT(sorts)) {
  const struct sort *sort = &sorts[_i];
  const char *other = strcmp(sort->name, "b.csv") == 0 ? "a.csv" : "b.csv";
  const char *const files[] = {sort->name, other, sort->name};
  const size_t most = 1 + (size_t)unit_count(4);
  struct sort any = *sort;
  struct unit_random r = unit_random_of(100 + (uint64_t)_i);
  struct ph_buf text = {0};
  size_t bytes = 2 * write_random(sort, sort->name, 20000, false, &r, &text);
  any.format = _i < 2 ? PH_SPLIT_JSON : PH_SPLIT_CSV;
  bytes += write_random(sort, other, 50, false, &r, &text);
  ck_assert_uint_gt(bytes, 1 << 17);
  any.format = sort->format == PH_SPLIT_TEXT ? PH_SPLIT_TEXT : any.format;
  if (strcmp(sort->name, "a.tsv") != 0) { /* of which the name says it */
    ck_cuts(&any, files, COUNT(files), bytes, most, "large files");
  } else {
    ck_cuts(&any, files, 1, bytes, most, "a large file");
  }
  ph_buf_free(&text);
}

/* Where nothing is broken the records are those of the stream. */
PH_TEST_EACH(test_stream, COUNT(sorts)) {
  const struct sort *sort = &sorts[_i];
  const struct ph_split_part all = {PH_PART_ALL, 0, 0, 0, 0};
  const struct ph_split_part one = {PH_PART_SHARD, 0, 1, 0, 0};
  struct unit_random r = unit_random_of(200 + (uint64_t)_i);
  struct ph_buf text = {0}, stream = {0};
  const size_t trials = unit_cases(40);
  for (size_t trial = 0; trial < trials; trial++) {
    write_random(sort, sort->name, trial % 29, true, &r, &text);
    transcript.n = stream.n = 0;
    note_part(sort, &sort->name, 1, all);
    ph_buf_put(&stream, transcript.data, transcript.n);
    transcript.n = 0;
    note_part(sort, &sort->name, 1, one);
    ck_same(&stream, "the stream", 0, text.data);
  }
  ph_buf_free(&text);
  ph_buf_free(&stream);
}

/* What is no file that can be cut: in every part that has something of it. */
static void ck_refused(const char *name, const char *text, const char *why) {
  for (size_t k = 0; k < 3; k++) {
    const struct ph_split_options options = {
        .part = {PH_PART_SHARD, k, 3, 0, 0}};
    struct ph_split split;
    struct ph_record record;
    struct ph_diag diag = {PH_OK, "", "", 0, 0};
    put_file(name, text);
    ck_assert_int_eq(ph_split_init(&split, &name, 1, &options, &schema, &diag),
                     PH_OK);
    ck_assert_int_eq(ph_split_next(&split, true, &record, &diag),
                     PH_SPLIT_FAILED);
    ck_assert_int_eq(diag.status, PH_E_INPUT);
    ck_assert_str_eq(diag.message, why);
    ck_assert_int_eq(ph_split_next(&split, true, &record, &diag), PH_SPLIT_END);
    ph_split_free(&split);
  }
}

PH_TEST(test_refused) {
  static const char *const none = "none.json", *const here = ".";
  struct ph_split_options options = {.part = {PH_PART_SHARD, 0, 2, 0, 0}};
  struct ph_split split;
  struct ph_diag diag;
  ck_refused("a.json", "\n [{},\n{}]\n",
             "cannot cut a.json: it is an array; --shard and --range are of "
             "JSON Lines");
  ck_refused("a.json", "{\n \"id\": 1\n}\n{\n}\n",
             "cannot cut a.json: its first line is no whole value; --shard and "
             "--range are of JSON Lines");
  ck_refused("a.json", "{\"type\":\"FeatureCollection\",\"features\":[]}\n",
             "cannot cut a.json: it is neither JSON Lines nor CSV, which "
             "--shard and --range are of");
  ck_refused("a.csv", "id,x,yy\na,1,2\n",
             "cannot read the columns of a.csv: column \"yy\" is unknown to "
             "planar; did you mean \"y\"? (--ignore-columns skips it)");
  ck_refused("a.csv", "id,\"x,y\na,1,2\n",
             "cannot read the columns of a.csv: the quote that begins this "
             "cell is never closed");
  ck_assert_int_eq(ph_split_init(&split, &none, 1, &options, &schema, &diag),
                   PH_E_INPUT);
  ck_assert_str_eq(diag.message,
                   "cannot open none.json: No such file or directory");
  ck_assert_int_eq(ph_split_init(&split, &here, 1, &options, &schema, &diag),
                   PH_E_INPUT);
  ck_assert_str_eq(diag.message, "--shard needs regular files: . is not one");
  options.part.how = PH_PART_RANGE;
  ck_assert_int_eq(ph_split_init(&split, &here, 1, &options, &schema, &diag),
                   PH_E_INPUT);
  ck_assert_str_eq(diag.message, "--range needs regular files: . is not one");
}

PH_FIXTURE(setup, finish)
