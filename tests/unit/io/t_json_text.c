/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Strings as JSON writes them: escapes, UTF-8, and what is neither. */
#include "unit.h"

#include "io/json_text.h"

/* Text and result in memory of their own sizes: what is beyond shows. */
static void ck_quoted(const char *text, size_t n, const char *expected) {
  char *copy = malloc(n ? n : 1), *quoted = malloc(PH_JSON_QUOTED_MAX(n));
  size_t length;
  ck_assert(copy && quoted);
  memcpy(copy, text, n);
  length = ph_json_quote(quoted, copy, n);
  ck_assert_uint_eq(length, strlen(expected));
  ck_assert_mem_eq(quoted, expected, length);
  free(copy);
  free(quoted);
}

PH_TEST(test_plain) {
  ck_quoted("", 0, "\"\"");
  ck_quoted("a b/c'", 6, "\"a b/c'\"");
  ck_quoted("\xC3\xA4\xE2\x82\xAC\xF0\x9F\x98\x80", 9,
            "\"\xC3\xA4\xE2\x82\xAC\xF0\x9F\x98\x80\"");
}

PH_TEST(test_escapes) {
  ck_quoted("\"\\", 2, "\"\\\"\\\\\"");
  ck_quoted("\0\n\x1F\x7F", 4, "\"\\u0000\\u000a\\u001f\\u007f\"");
}

/* Each byte that is not UTF-8 for itself, also at the end of the text. */
PH_TEST(test_not_utf8) {
  ck_quoted("a\xFF", 2, "\"a\\ufffd\"");
  ck_quoted("\xE2\x82", 2, "\"\\ufffd\\ufffd\"");
  ck_quoted("\xE2x", 2, "\"\\ufffdx\"");
  ck_quoted("\xC0\x80", 2, "\"\\ufffd\\ufffd\"");
  ck_quoted("\xED\xA0\x80", 3, "\"\\ufffd\\ufffd\\ufffd\"");
}
