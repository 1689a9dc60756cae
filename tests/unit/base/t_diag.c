/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Diagnoses: what ph_fail stores, and what it does with too long a text. */
#include "unit.h"

#include "base/diag.h"

static struct ph_diag diag;

/* Nothing may be left over from the diagnosis before. */
static void start(void) {
  memset(&diag, 'x', sizeof diag);
}

PH_TEST(test_fail) {
  ck_assert_int_eq(
      ph_fail(&diag, PH_E_BAD_VALUE, "knots", "is %d, not %s", 3, "four"),
      PH_E_BAD_VALUE);
  ck_assert_int_eq(diag.status, PH_E_BAD_VALUE);
  ck_assert_str_eq(diag.field, "knots");
  ck_assert_str_eq(diag.message, "is 3, not four");
  ck_assert_uint_eq(diag.line, 0);
  ck_assert_uint_eq(diag.column, 0);
}

PH_TEST(test_fail_without_field) {
  ck_assert_int_eq(ph_fail(&diag, PH_E_USAGE, NULL, "100%%"), PH_E_USAGE);
  ck_assert_str_eq(diag.field, "");
  ck_assert_str_eq(diag.message, "100%");
}

PH_TEST(test_fail_at) {
  ck_assert_int_eq(
      ph_fail_at(&diag, PH_E_COINCIDENT_POINTS, "points", 3, "coincides"),
      PH_E_COINCIDENT_POINTS);
  ck_assert_str_eq(diag.field, "points[3]");
  ck_assert_str_eq(diag.message, "coincides");
  ph_fail_at(&diag, PH_E_BAD_TYPE, "points", 4294967295u, "x");
  ck_assert_str_eq(diag.field, "points[4294967295]");
}

PH_TEST(test_add) {
  char text[PH_DIAG_MESSAGE_MAX + 1];
  ph_fail(&diag, PH_E_NO_CONVERGENCE, "knots", "fail");
  ph_diag_add(&diag, "--knots=uniform may help");
  ck_assert_str_eq(diag.message, "fail; --knots=uniform may help");
  ck_assert_str_eq(diag.field, "knots");
  ck_assert_int_eq(diag.status, PH_E_NO_CONVERGENCE);
  memset(text, 'a', PH_DIAG_MESSAGE_MAX);
  text[PH_DIAG_MESSAGE_MAX] = '\0';
  ph_fail(&diag, PH_E_NO_CONVERGENCE, NULL, "%s", text);
  ph_diag_add(&diag, "cut");
  ck_assert_uint_eq(strlen(diag.message), PH_DIAG_MESSAGE_MAX - 1);
}

PH_TEST(test_fail_memory) {
  ck_assert_int_eq(ph_fail_memory(&diag), PH_E_NO_MEMORY);
  ck_assert_int_eq(diag.status, PH_E_NO_MEMORY);
  ck_assert_str_eq(diag.field, "");
  ck_assert_str_eq(diag.message, "memory is exhausted");
}

PH_TEST(test_sentence) {
  char text[64], small[8];
  ph_fail_at(&diag, PH_E_COINCIDENT_POINTS, "points", 3, "coincides");
  ph_diag_sentence(&diag, text, sizeof text);
  ck_assert_str_eq(text, "points[3] coincides");
  ph_diag_sentence(&diag, small, sizeof small);
  ck_assert_str_eq(small, "points[");
  ph_fail(&diag, PH_E_OUTPUT, NULL, "no space left");
  ph_diag_sentence(&diag, text, sizeof text);
  ck_assert_str_eq(text, "no space left");
}

/* Texts of n bytes: `before` letters and then a character over and over. */
static const char *long_text(size_t before, const char *character) {
  static char text[600];
  size_t size = strlen(character), at = before;
  memset(text, 'a', before);
  for (; at + size < 500; at += size) {
    memcpy(text + at, character, size);
  }
  text[at] = '\0';
  return text;
}

/* Cut where a character ends, as much kept as there is room for. */
PH_TEST(test_cut) {
  const char *characters[] = {"b", "\xC3\xA4", "\xE2\x82\xAC",
                              "\xF0\x9F\x98\x80"};
  for (size_t i = 0; i < 4; i++) {
    size_t size = strlen(characters[i]);
    for (size_t before = 0; before < 8; before++) {
      const char *text = long_text(before, characters[i]);
      size_t message, field;
      ph_fail(&diag, PH_E_SYNTAX, text, "%s", text);
      message = strlen(diag.message);
      field = strlen(diag.field);
      ck_assert_int_eq(strncmp(diag.message, text, message), 0);
      ck_assert_int_eq(strncmp(diag.field, text, field), 0);
      ck_assert_uint_eq((message - before) % size, 0);
      ck_assert_uint_eq((field - before) % size, 0);
      ck_assert(message < PH_DIAG_MESSAGE_MAX &&
                message + size >= PH_DIAG_MESSAGE_MAX);
      ck_assert(field < PH_DIAG_FIELD_MAX && field + size >= PH_DIAG_FIELD_MAX);
    }
  }
}

/* A text that fits is kept whole. */
PH_TEST(test_exact_fit) {
  char text[PH_DIAG_MESSAGE_MAX];
  memset(text, 'a', sizeof text);
  memcpy(text + PH_DIAG_MESSAGE_MAX - 4, "\xE2\x82\xAC", 4);
  ph_fail(&diag, PH_E_SYNTAX, NULL, "%s", text);
  ck_assert_str_eq(diag.message, text);
}

PH_FIXTURE(start, NULL)
