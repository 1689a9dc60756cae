/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What values must be, in words (see value.h). */
#include "io/value.h"

#include <stdio.h>
#include <string.h>

/* A list "a, b or c" that is being written. */
struct phrase {
  char *text;
  size_t n;
  size_t items; /* still to come */
};

static void add(struct phrase *phrase, const char *before, const char *item,
                size_t item_n, const char *after) {
  const char *gap = phrase->items > 1 ? ", " : phrase->items == 1 ? " or " : "";
  size_t room = PH_VALUE_PHRASE_MAX - phrase->n;
  int n = snprintf(phrase->text + phrase->n, room, "%s%.*s%s%s", before,
                   (int)item_n, item, after, gap);
  phrase->n += n < 0 ? 0 : (size_t)n < room ? (size_t)n : room - 1;
}

static void add_item(struct phrase *phrase, const char *item) {
  phrase->items--;
  add(phrase, "", item, strlen(item), "");
}

static void add_words(struct phrase *phrase, const char *words) {
  while (*words) {
    size_t n = strcspn(words, "|");
    phrase->items--;
    add(phrase, "\"", words, n, "\"");
    words += n + (words[n] == '|');
  }
}

static size_t count_words(const char *words) {
  size_t n = *words ? 1 : 0;
  for (; *words; words++) {
    n += *words == '|';
  }
  return n;
}

static const char *vectors_phrase(const struct ph_field *row) {
  static const char *const phrases[2][3] = {
      {"an array of vectors [x,y]", "an array of vectors [x,y,z]",
       "an array of vectors [x,y] or [x,y,z]"},
      {"an array of points [x,y]", "an array of points [x,y,z]",
       "an array of points [x,y] or [x,y,z]"}};
  bool plane = row->dimensions >> 2 & 1;
  bool space = row->dimensions >> 3 & 1;
  if (row->id == PH_F_ANGLES) {
    return "an array of pairs [theta,beta]";
  }
  if (row->id == PH_F_LONLAT) {
    return "an array of pairs [lon,lat]";
  }
  return phrases[row->id == PH_F_POINTS || row->id == PH_F_CURVE][plane && space
                                                                      ? 2
                                                                  : space ? 1
                                                                          : 0];
}

const char *ph_value_describe(const struct ph_field *row,
                              char phrase[PH_VALUE_PHRASE_MAX]) {
  const char *words = row->kinds & PH_WORD ? row->words : "";
  struct phrase list = {phrase, 0, count_words(words)};
  list.items += row->kinds & PH_BOOL ? 2 : 0;
  list.items += row->kinds & PH_NUMBER ? 1 : 0;
  list.items += row->kinds & PH_NUMBERS ? 1 : 0;
  list.items += row->kinds & PH_VECTORS ? 1 : 0;
  list.items += row->kinds & PH_POLYLINE ? 1 : 0;
  list.items += row->kinds & PH_LISTS ? 1 : 0;
  list.items += row->kinds & PH_PATH ? 1 : 0;
  phrase[0] = '\0';
  if (row->kinds & PH_BOOL) {
    add_item(&list, "true");
    add_item(&list, "false");
  }
  add_words(&list, words);
  if (row->kinds & PH_NUMBER) {
    add_item(&list, "a number");
  }
  if (row->kinds & PH_NUMBERS) {
    add_item(&list, "an array of numbers");
  }
  if (row->kinds & PH_VECTORS) {
    add_item(&list, vectors_phrase(row));
  }
  if (row->kinds & PH_POLYLINE) {
    add_item(&list, "an array of such arrays");
  }
  if (row->kinds & PH_LISTS) {
    add_item(&list, "an array of arrays of numbers");
  }
  if (row->kinds & PH_PATH) {
    add_item(&list, "a string of SVG path data");
  }
  return phrase;
}

const char *ph_value_type(char first) {
  switch (first) {
  case '"':
    return "a string";
  case '[':
    return "an array";
  case '{':
    return "an object";
  case 't':
    return "true";
  case 'f':
    return "false";
  case 'n':
    return "null";
  default:
    return "a number";
  }
}

enum ph_status ph_problem_trace(struct ph_problem *problem,
                                struct ph_diag *diag) {
  struct ph_value *path = &problem->field[PH_F_PATH];
  struct ph_value *closed = &problem->field[PH_F_CLOSED];
  if (path->kind == PH_ABSENT) {
    return PH_OK;
  }
  if (problem->field[PH_F_CURVE].kind != PH_ABSENT) {
    return ph_fail(diag, PH_E_BAD_VALUE, "path",
                   "excludes curve: give one of them");
  }
  if (path->flag && closed->kind == PH_ABSENT) {
    *closed = (struct ph_value){.kind = PH_BOOL, .flag = true};
  }
  problem->field[PH_F_CURVE] = *path;
  path->kind = PH_ABSENT;
  return PH_OK;
}

enum ph_status ph_problem_check_required(const struct ph_problem *problem,
                                         const struct ph_schema *schema,
                                         struct ph_diag *diag) {
  char phrase[PH_VALUE_PHRASE_MAX];
  for (size_t i = 0; i < schema->fields_n; i++) {
    const struct ph_field *row = &schema->fields[i];
    if (row->required && problem->field[row->id].kind == PH_ABSENT) {
      return ph_fail(diag, PH_E_MISSING_FIELD, ph_field_name(row->id),
                     "is missing: it must be %s",
                     ph_value_describe(row, phrase));
    }
  }
  return PH_OK;
}
