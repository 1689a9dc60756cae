/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Words of the input in messages: excerpts, and the name that was meant. */
#include "unit.h"

#include "base/suggest.h"

/* A copy of its own size on the heap: a read beyond it shows. */
static char *heap(const char *text, size_t n) {
  char *copy = calloc(n ? n : 1, 1);
  ck_assert_ptr_nonnull(copy);
  memcpy(copy, text, n);
  return copy;
}

static int utf8(const char *text, size_t n) {
  char *copy = heap(text, n);
  int length = ph_utf8_length(copy, copy + n);
  free(copy);
  return length;
}

/* The definition of RFC 3629: count what is accepted of all pairs of bytes, and
 * of those followed by bytes at the ends of the range 0x80 to 0xBF. */
PH_TEST(test_utf8_against_definition) {
  static const char next[] = {'\0', '\x7F', '\x80', '\xBF', '\xC0', '\xFF'};
  long good2 = 0;
  long good3 = 0;
  long good4 = 0;
  for (int a = 0; a < 256; a++) {
    for (int b = 0; b < 256; b++) {
      char text[4] = {(char)a, (char)b};
      good2 += ph_utf8_length(text, text + 2) == 2;
      for (size_t c = 0; c < sizeof next; c++) {
        text[2] = next[c];
        good3 += ph_utf8_length(text, text + 3) == 3;
        for (size_t d = 0; d < sizeof next; d++) {
          text[3] = next[d];
          good4 += ph_utf8_length(text, text + 4) == 4;
        }
      }
    }
  }
  /* two of the 64 in each place, and no surrogates */
  ck_assert_int_eq(good2, 0x800 - 0x80);
  ck_assert_int_eq(good3, (0x10000 - 0x800 - 0x800) / 64 * 2);
  ck_assert_int_eq(good4, 0x100000 / 64 / 64 * 2 * 2);
}

PH_TEST(test_utf8) {
  ck_assert_int_eq(utf8("a", 1), 1);
  ck_assert_int_eq(utf8("\0", 1), 1);
  ck_assert_int_eq(utf8("\xC3\xA4", 2), 2);
  ck_assert_int_eq(utf8("\xE2\x82\xAC", 3), 3);
  ck_assert_int_eq(utf8("\xF0\x9F\x98\x80", 4), 4);
  ck_assert_int_eq(utf8("\xF4\x8F\xBF\xBF", 4), 4);
  ck_assert_int_eq(utf8("\xF4\x90\x80\x80", 4), 0);
  ck_assert_int_eq(utf8("\xC0\x80", 2), 0);
  ck_assert_int_eq(utf8("\xE0\x9F\xBF", 3), 0);
  ck_assert_int_eq(utf8("\xED\xA0\x80", 3), 0);
  ck_assert_int_eq(utf8("\xF0\x8F\xBF\xBF", 4), 0);
  ck_assert_int_eq(utf8("\x80", 1), 0);
  ck_assert_int_eq(utf8("\xFF", 1), 0);
  ck_assert_int_eq(utf8("\xC3", 1), -1);
  ck_assert_int_eq(utf8("\xE2\x82", 2), -1);
  ck_assert_int_eq(utf8("\xF0\x9F\x98", 3), -1);
  ck_assert_int_eq(utf8("\xE2x", 2), 0);
}

static void ck_excerpt(const char *text, size_t n, const char *expected) {
  char excerpt[PH_EXCERPT_MAX];
  char *copy = heap(text, n);
  ck_assert_str_eq(ph_excerpt(copy, n, excerpt), expected);
  free(copy);
}

static size_t encode(uint32_t c, char text[4]) {
  static const unsigned char lead[] = {0, 0, 0xC0, 0xE0, 0xF0};
  size_t n = c < 0x80 ? 1 : c < 0x800 ? 2 : c < 0x10000 ? 3 : 4;
  for (size_t i = n; i-- > 1; c >>= 6) {
    text[i] = (char)(0x80 | (c & 0x3F));
  }
  text[0] = (char)(lead[n] | c);
  return n;
}

/* Every character: as many as the header names, all where it names them.  Where
 * every step takes long, none of the planes 2 to 13. */
PH_TEST(test_shown) {
  int few = unit_count(10) < 10;
  size_t unseen = 0;
  for (uint32_t c = 0; c < 0x110000; c++) {
    char text[4];
    size_t n = encode(c, text), shown;
    if ((c >= 0xD800 && c < 0xE000) || (few && c >= 0x20000 && c < 0xE0000)) {
      continue;
    }
    shown = ph_shown_length(text, text + n);
    unseen += shown == 0;
    ck_assert(shown == n ||
              (shown == 0 &&
               (c < 0x20 || (c >= 0x7F && c < 0xA0) || c == 0x61C ||
                (c >= 0x200B && c <= 0x200F) || (c >= 0x2028 && c <= 0x202E) ||
                (c >= 0x2060 && c < 0x2070) || c == 0xFEFF || c == 0xFFFE ||
                c == 0xFFFF || (c >= 0xE0000 && c < 0xE0080))));
    if (n > 1) {
      ck_assert_uint_eq(ph_shown_length(text, text + n - 1), 0);
    }
  }
  ck_assert_uint_eq(unseen, 32 + 33 + 1 + 5 + 7 + 16 + 1 + 2 + 128);
}

PH_TEST(test_excerpt) {
  ck_excerpt("", 0, "");
  ck_excerpt("abc", 3, "abc");
  ck_excerpt("a\0b\n\x1b[0m\x7f", 9, "a\\x00b\\x0a\\x1b[0m\\x7f");
  ck_excerpt("\xC3\xA4\xFF\xC3", 4, "\xC3\xA4\\xff\\xc3");
  ck_excerpt("\xC2\x9b", 2, "\\xc2\\x9b"); /* a control character, too */
  ck_excerpt("123456789012345678901234567890123456789\x1b", 40,
             "123456789012345678901234567890123456789...");
  ck_excerpt("1234567890123456789012345678901234567890", 40,
             "1234567890123456789012345678901234567890");
  ck_excerpt("12345678901234567890123456789012345678901", 41,
             "1234567890123456789012345678901234567890...");
  ck_excerpt("123456789012345678901234567890123456789\xC3\xA4", 41,
             "123456789012345678901234567890123456789...");
}

PH_TEST(test_word_is) {
  ck_assert(ph_word_is("Points", 6, "points"));
  ck_assert(ph_word_is("", 0, ""));
  ck_assert(!ph_word_is("point", 5, "points"));
  ck_assert(!ph_word_is("points", 6, "point"));
  ck_assert(!ph_word_is("po\0nts", 6, "po"));
}

static const char *meant(const char *word, const char *names) {
  static char clause[PH_DID_YOU_MEAN_MAX];
  struct ph_suggest suggest;
  ph_suggest_init(&suggest, word, strlen(word));
  ph_suggest_list(&suggest, names);
  ck_assert_int_eq(ph_did_you_mean(&suggest, clause), clause[0] != '\0');
  return clause;
}

PH_TEST(test_did_you_mean) {
  const char *names = "points|closed|basis|knots|id";
  ck_assert_str_eq(meant("pints", names), "; did you mean \"points\"?");
  ck_assert_str_eq(meant("ponits", names), "; did you mean \"points\"?");
  ck_assert_str_eq(meant("POINTS", names), "; did you mean \"points\"?");
  ck_assert_str_eq(meant("pointss", names), "; did you mean \"points\"?");
  ck_assert_str_eq(meant("colsed", names), "; did you mean \"closed\"?");
  ck_assert_str_eq(meant("knot", names), "; did you mean \"knots\"?");
  ck_assert_str_eq(meant("nkots", names), "; did you mean \"knots\"?");
  ck_assert_str_eq(meant("wknotsw", names), "; did you mean \"knots\"?");
  ck_assert_str_eq(meant("wwknots1", names), "");
  ck_assert_str_eq(meant("di", names), "; did you mean \"id\"?");
  ck_assert_str_eq(meant("i", names), ""); /* all of the word is wrong */
  ck_assert_str_eq(meant("zz", names), "");
  ck_assert_str_eq(meant("", names), "");
  ck_assert_str_eq(meant("anything", ""), "");
  /* A name that begins with the word, three letters of it. */
  ck_assert_str_eq(meant("out", "set|output"), "; did you mean \"output\"?");
  ck_assert_str_eq(meant("input", names), "");
  ck_assert_str_eq(meant("inp", "input-format"),
                   "; did you mean \"input-format\"?");
  ck_assert_str_eq(meant("in", "input-format"), "");
  /* The nearest, and of equally near ones the first. */
  ck_assert_str_eq(meant("knotz", "knotted|knots|knott"),
                   "; did you mean \"knots\"?");
  ck_assert_str_eq(meant("pointspointspointspointspointspoints", names), "");
}
