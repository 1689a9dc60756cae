/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Tests of records that are longer than they may be: in every format, at the
 * beginning, in the middle and at the end of a stream, and with every portion
 * in which the text can arrive.
 */
#include "split_unit.h"

#define OVER "the record is longer than the 20 bytes of --max-record-bytes "

static const struct ph_split_options of_20 = {.format = PH_SPLIT_AUTO,
                                              .most = 20};
static const struct ph_split_options csv_of_20 = {.format = PH_SPLIT_CSV,
                                                  .most = 20};

/* What a text gives, whole and in portions. */
static void ck_over(const struct ph_split_options *options, const char *text,
                    const char *expected) {
  ck_portions(options, text, strlen(text));
  gives_with(options, &schema, text, expected);
}

PH_TEST(test_json_sizes) {
  /* 19, 20 and 21 bytes, as lines, as an array and one after another */
  ck_over(&of_20,
          "{\"id\":1,\"a\":\"1234\"}\n{\"id\":2,\"a\":\"12345\"}\n"
          "{\"id\":3,\"a\":\"123456\"}\n",
          "1 1 {\"id\":1,\"a\":\"1234\"}\n2 2 {\"id\":2,\"a\":\"12345\"}\n"
          "3 3 limit 3:0 " OVER "{\"id\":3}\nend");
  ck_over(&of_20,
          "[{\"id\":3,\"a\":\"123456\"},{\"id\":1,\"a\":\"1234\"},\n"
          "{\"id\":2,\"a\":\"12345\"}]",
          "1 1 limit 1:0 " OVER "{\"id\":3}\n2 1 {\"id\":1,\"a\":\"1234\"}\n"
          "3 2 {\"id\":2,\"a\":\"12345\"}\nend");
  ck_over(&of_20,
          "{\"id\":1,\"a\":\"1234\"}{\"id\":3,\"a\":\"123456\"} "
          "{\"id\":2,\n\"a\":\"1234\"}",
          "1 1 {\"id\":1,\"a\":\"1234\"}\n2 1 limit 1:0 " OVER "{\"id\":3}\n"
          "3 1 {\"id\":2,$\"a\":\"1234\"}\nend");
}

/* What looks like an end inside a string is none. */
PH_TEST(test_json_strings) {
  ck_over(&of_20, "{\"a\":\"}]{\\\"}\\\\\\u007d\",\"b\":[{},\"]\"]}\n{}\n",
          "1 1 limit 1:0 " OVER "\n2 2 {}\nend");
  ck_over(&of_20, "[{\"a\":\"}]{\\\"}\\\\\",\"b\":[[[\n\n]]]},\n7]{}",
          "1 1 limit 1:0 " OVER "\n2 4 7\n3 4 {}\nend");
}

/* The id is known if it is all there in what a record may have. */
PH_TEST(test_json_ids) {
  ck_over(&of_20, "{\"id\":\"0123456789abc\"}", "1 1 limit 1:0 " OVER "\nend");
  ck_over(&of_20, "{ \"id\" : \"\\u00e4\" ,\"b\":1}",
          "1 1 limit 1:0 " OVER "{\"id\":\"\\u00e4\"}\nend");
  ck_over(&of_20, "{\"b\":\"0123456789\",\"id\":1}",
          "1 1 limit 1:0 " OVER "\nend");
  ck_over(&of_20, "{\"a\":{\"id\":1},\"b\":123}",
          "1 1 limit 1:0 " OVER "\nend");
}

/* A text that is broken is that, however long, and splitting goes on where it
 * does after a short one. */
PH_TEST(test_json_broken) {
  ck_over(&of_20, "{\"a\":\"0123456789012345678",
          "1 1 syntax 1:26 the text ends inside a string\nstopped");
  ck_over(&of_20, "{}\n{\"a\":\"0123456789012345678",
          "1 1 {}\n2 2 syntax 2:26 the text ends inside a string\nend");
  ck_over(&of_20, "{}\n{\"a\":\"01234567890123456\",}\n{\"a\":\n1}\n",
          "1 1 {}\n2 2 syntax 2:26 expected a name in double quotes, found "
          "'}'\n3 3 {\"a\":$1}\nend");
  ck_over(&of_20, "{}\n{\"a\":\"01234567890123456\"\n{\"a\":1}\n",
          "1 1 {}\n2 2 syntax 3:1 expected ',' or '}', found '{'\n"
          "3 3 {\"a\":1}\nend");
  ck_over(&of_20, "[{\"a\":\"01234567890123456\" 1},{}]",
          "1 1 syntax 1:27 expected ',' or '}', found '1'\nstopped");
  /* the line is too long, and broken at once */
  ck_over(&of_20, "{}\n{a 0123456789012345678901234567890123456789}\n{}\n",
          "1 1 {}\n2 2 syntax 2:2 expected a name in double quotes or '}', "
          "found 'a'\n3 3 {}\nend");
  ck_over(&of_20, "{a 0123456789012345678901234567890123456789}\n\n{}\n",
          "1 1 syntax 1:2 expected a name in double quotes or '}', "
          "found 'a'\n2 3 {}\nend");
  ck_over(&of_20, "{a 0123456789012345678901234567890123456789}\n 7\n",
          "1 1 syntax 1:2 expected a name in double quotes or '}', "
          "found 'a'\nstopped");
}

/* 19, 20 and 21 bytes of rows. */
PH_TEST(test_csv_sizes) {
  ck_over(&csv_of_20, "x,y\n0,1\n2,3\n4,5\n6,78901\n\n1,2\n",
          "1 2 0,1$2,3$4,5$6,78901$\n2 7 1,2$\nend");
  ck_over(&csv_of_20, "x,y\n0,1\n2,3\n4,5\n6,789012\n\n1,2\n",
          "1 2 limit 2:0 " OVER "\n2 7 1,2$\nend");
  ck_over(&csv_of_20, "id,x,y\na,0,1\na,2,3\na,4,56\nb,1,2\n",
          "1 2 a,0,1$a,2,3$a,4,56$\n2 5 b,1,2$\nend");
  ck_over(&csv_of_20, "id,x,y\na,0,1\na,2,3\na,4,567\nb,1,2\n",
          "1 2 a,0,1$a,2,3$a,4,567$\n2 5 b,1,2$\nend");
  ck_over(&csv_of_20, "id,x,y\nc,3,4\n\"a\",0,1\na,2,3\na,4,567\nb,1,2\n",
          "1 2 c,3,4$\n2 3 limit 3:0 " OVER "\"a\"\n3 6 b,1,2$\nend");
  ck_over(&csv_of_20, "id,x,y\nb,1,2\na,0,1\na,2,3\na,4,56\na,5,6\n",
          "1 2 b,1,2$\n2 3 limit 3:0 " OVER "a\nend");
}

/* Rows, comments and cells that are too long by themselves. */
PH_TEST(test_csv_rows) {
  ck_over(&csv_of_20,
          "id,x,y\nb,1,2\na,1,000000000000000000000002\na,3,4\nb,5,6\n",
          "1 2 b,1,2$\n2 3 limit 3:0 " OVER "a\n3 5 b,5,6$\nend");
  ck_over(&csv_of_20,
          "id,x,y\na,1,2\na,1,000000000000000000000002\na,3,4\nb,5,6\n",
          "1 2 limit 2:0 " OVER "a\n2 5 b,5,6$\nend");
  ck_over(&csv_of_20, "id,x,y\nb,1,2\n\"01234567890123456789a\",1,2\nb,5,6\n",
          "1 2 b,1,2$\n2 3 limit 3:0 " OVER "\n3 4 b,5,6$\nend");
  ck_over(&csv_of_20,
          "x,y\n# a comment is no part of a record\n1,2\n\n"
          "1,2\n# but of one in it it is\n3,4\n\n5,6\n",
          "1 3 1,2$\n2 5 limit 5:0 " OVER "\n3 9 5,6$\nend");
  ck_over(&csv_of_20, "x_m,y_m,knot,alpha,tension\n1,2\n",
          "1 1 limit 1:1 the first row is longer than the 20 bytes of "
          "--max-record-bytes \nstopped");
}

PH_TEST(test_csv_broken) {
  ck_over(&csv_of_20, "id,x,y\nb,1,2\na,1,\"0000000000\n00000000002\n\n",
          "1 2 b,1,2$\n2 3 syntax 3:5 the quote that begins this cell is never "
          "closed\nstopped");
  ck_over(&csv_of_20, "id,x,y\na,1,\"0000000000\n0000000000\"2\n\n",
          "1 2 syntax 3:12 expected ',' or the end of the row after a quoted "
          "cell, found '2'\nstopped");
}

/* Nothing of a record that is too long stays in memory. */
PH_TEST(test_memory) {
  static const char *const ends[][3] = {{"{\"a\":\"", "\"}", "{}\n"},
                                        {"{}\n{b ", "\n", "{}\n"},
                                        {"x,y\n1,2\n", "", "\n3,4\n"},
                                        {"x,y\n1,2\n3,\"", "\"\n", "\n3,4\n"}};
  const struct ph_split_options options = {.format = PH_SPLIT_AUTO,
                                           .most = 1 << 16};
  const char *name = "a.txt";
  for (size_t i = 0; i < COUNT(ends); i++) {
    struct ph_split split;
    struct ph_record record;
    struct ph_diag diag;
    size_t records = 0;
    FILE *file = fopen(name, "w");
    ck_assert_ptr_nonnull(file);
    fputs(ends[i][0], file);
    for (int k = 0; k < 1 << 19; k++) {
      fputs(i == 2 ? "3,4\n5,6\n" : "01234567", file);
    }
    fputs(ends[i][1], file);
    fputs(ends[i][2], file);
    fclose(file);
    begin(&split, &name, 1, &options, &schema);
    while (ph_split_next(&split, true, &record, &diag) == PH_SPLIT_RECORD) {
      records++;
      ck_assert_uint_le(split.capacity, 4 << 16);
    }
    ck_assert(!ph_split_stopped(&split));
    ck_assert_uint_eq(records, i == 1 ? 3 : 2);
    ph_split_free(&split);
  }
}

PH_FIXTURE(setup, finish)
