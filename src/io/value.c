/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Values of fields (see value.h).
 *
 * Arrays of numbers are read straight from the bytes, in one pass after the
 * one that counts what memory they need: a tree of cJSON would cost 240 bytes
 * a point.  Truth values and strings go through cJSON, whose strings are
 * unescaped; its numbers are not used (it takes 1e999, and depends on the
 * locale), and nothing is printed with it.
 *
 * The text is known to be JSON, so that what is not a bracket, a comma or a
 * blank is a value, and its type shows in its first byte.
 */
#include "io/value.h"

#include "base/suggest.h"
#include "io/json_scan.h"
#include "io/number.h"
#include "io/svg_path.h"

#include <cjson/cJSON.h>

#include <math.h>
#include <stdio.h>
#include <string.h>

/* A value being read. */
struct reader {
  const struct ph_field *row;
  const char *name; /* of the field, or of a piece: curve[1] */
  const char *p;
  const char *end;
  struct ph_arena *arena;
  struct ph_diag *diag;
};

static enum ph_status bad_type(struct reader *r, const char *found) {
  char phrase[PH_VALUE_PHRASE_MAX];
  return ph_fail(r->diag, PH_E_BAD_TYPE, r->name, "must be %s, found %s",
                 ph_value_describe(r->row, phrase), found);
}

/* ---- single values -------------------------------------------------- */

/* PH_OK, or the failure of a number, written text[n], that overflowed. */
static enum ph_status check_finite(double x, const char *path, const char *text,
                                   size_t n, struct ph_diag *diag) {
  char excerpt[PH_EXCERPT_MAX];
  if (isfinite(x)) {
    return PH_OK;
  }
  return ph_fail(diag, PH_E_NOT_FINITE, path, "is %s, which overflows a double",
                 ph_excerpt(text, n, excerpt));
}

/* Whether an escape of text[n], a JSON string, stands for NUL. */
static bool has_escaped_nul(const char *text, size_t n) {
  for (size_t i = 0; i + 5 < n; i++) {
    if (text[i] == '\\') {
      if (memcmp(text + i + 1, "u0000", 5) == 0) {
        return true;
      }
      i++;
    }
  }
  return false;
}

const char *ph_value_string(const char *text, size_t n,
                            struct ph_arena *arena) {
  const char *rest;
  const char *string = NULL;
  cJSON *item;
  if (has_escaped_nul(text, n)) {
    return ph_arena_copy(arena, text + 1, n - 2);
  }
  /* With `rest` no error is reported through a global variable. */
  item = cJSON_ParseWithLengthOpts(text, n, &rest, 0);
  if (cJSON_IsString(item)) {
    string = ph_arena_copy(arena, item->valuestring, strlen(item->valuestring));
  }
  cJSON_Delete(item);
  return string;
}

/* Whether word[n] is the listed one, w[w_n].  One that is listed as "name:V"
 * has a number in the place of V. */
static bool is_word(const char *w, size_t w_n, const char *word, size_t n,
                    double *number) {
  size_t stem = w_n > 2 && memcmp(w + w_n - 2, ":V", 2) == 0 ? w_n - 1 : w_n;
  if (n < stem || memcmp(w, word, stem) != 0) {
    return false;
  }
  *number = 0;
  return stem == w_n
             ? n == w_n
             : ph_number_read_text(word + stem, word + n, number) == word + n &&
                   n > stem && isfinite(*number);
}

static enum ph_status check_word(struct reader *r, const char *word,
                                 size_t shown_n, const char *shown,
                                 struct ph_value *value) {
  size_t n = strlen(word);
  struct ph_suggest suggest;
  char phrase[PH_VALUE_PHRASE_MAX];
  char excerpt[PH_EXCERPT_MAX];
  char clause[PH_DID_YOU_MEAN_MAX];
  for (const char *w = r->row->words; *w;) {
    size_t w_n = strcspn(w, "|");
    if (is_word(w, w_n, word, n, &value->number)) {
      value->kind = PH_WORD;
      value->word = word;
      return PH_OK;
    }
    w += w_n + (w[w_n] == '|');
  }
  ph_suggest_init(&suggest, word, n);
  ph_suggest_list(&suggest, r->row->words);
  ph_did_you_mean(&suggest, clause);
  return ph_fail(r->diag, PH_E_BAD_VALUE, r->name, "must be %s, found \"%s\"%s",
                 ph_value_describe(r->row, phrase),
                 ph_excerpt(shown, shown_n, excerpt), clause);
}

static enum ph_status read_string(struct reader *r, struct ph_value *value) {
  size_t n = (size_t)(r->end - r->p);
  const char *word;
  if (!(r->row->kinds & (PH_WORD | PH_PATH))) {
    return bad_type(r, "a string");
  }
  word = ph_value_string(r->p, n, r->arena);
  if (!word) {
    return ph_fail_memory(r->diag);
  }
  return r->row->kinds & PH_PATH
             ? ph_svg_path_value(word, strlen(word), r->name, r->arena, value,
                                 r->diag)
             : check_word(r, word, n - 2, r->p + 1, value);
}

static enum ph_status read_literal(struct reader *r, struct ph_value *value) {
  const char *rest;
  cJSON *item;
  if (*r->p == 'n' || !(r->row->kinds & PH_BOOL)) {
    return bad_type(r, ph_value_type(*r->p));
  }
  item = cJSON_ParseWithLengthOpts(r->p, (size_t)(r->end - r->p), &rest, 0);
  if (!item) {
    return ph_fail_memory(r->diag);
  }
  value->kind = PH_BOOL;
  value->flag = cJSON_IsTrue(item) != 0;
  cJSON_Delete(item);
  return PH_OK;
}

static enum ph_status read_number(struct reader *r, struct ph_value *value) {
  if (!(r->row->kinds & PH_NUMBER) ||
      !ph_number_read(r->p, r->end, &value->number)) {
    return bad_type(r, "a number");
  }
  value->kind = PH_NUMBER;
  return check_finite(value->number, r->name, r->p, (size_t)(r->end - r->p),
                      r->diag);
}

/* ---- arrays --------------------------------------------------------- */

/* How often c occurs from the current place on. */
static size_t count(const struct reader *r, char c) {
  size_t n = 0;
  for (const char *p = r->p; p < r->end; p++) {
    n += *p == c;
  }
  return n;
}

/* points[i], or points[i][j] with j >= 0. */
static const char *path(const struct reader *r, size_t i, long j,
                        char text[PH_DIAG_FIELD_MAX]) {
  if (j < 0) {
    snprintf(text, PH_DIAG_FIELD_MAX, "%s[%zu]", r->name, i);
  } else {
    snprintf(text, PH_DIAG_FIELD_MAX, "%s[%zu][%ld]", r->name, i, j);
  }
  return text;
}

/* To the next element of an array; false at its end. */
static bool next_element(struct reader *r) {
  r->p = ph_json_blanks(r->p, r->end);
  if (r->p < r->end && *r->p == ',') {
    r->p = ph_json_blanks(r->p + 1, r->end);
  }
  return r->p < r->end && *r->p != ']';
}

/* Element i, or [i][j], of an array: a finite number. */
static enum ph_status read_element(struct reader *r, size_t i, long j,
                                   double *x) {
  const char *after = ph_number_read(r->p, r->end, x);
  const char *before = r->p;
  char text[PH_DIAG_FIELD_MAX];
  if (!after) {
    return ph_fail(r->diag, PH_E_BAD_TYPE, path(r, i, j, text),
                   "must be a number, found %s", ph_value_type(*r->p));
  }
  r->p = after;
  if (isfinite(*x)) {
    return PH_OK;
  }
  return check_finite(*x, path(r, i, j, text), before, (size_t)(after - before),
                      r->diag);
}

static enum ph_status read_numbers(struct reader *r, struct ph_value *value) {
  enum ph_status status = PH_OK;
  size_t n = 0;
  double *v = ph_arena_array(r->arena, count(r, ',') + 1, sizeof *v);
  if (!v) {
    return ph_fail_memory(r->diag);
  }
  while (status == PH_OK && next_element(r)) {
    status = read_element(r, n, -1, &v[n]);
    n++;
  }
  value->kind = PH_NUMBERS;
  value->dimension = 1;
  value->v = v;
  value->n = n;
  return status;
}

/* Vector i was found to have `found` numbers; dimension 0: it is the first. */
static enum ph_status bad_size(struct reader *r, size_t i, size_t dimension,
                               size_t found) {
  unsigned allowed = r->row->dimensions;
  const char *field = ph_field_name(r->row->id);
  char text[PH_DIAG_FIELD_MAX];
  const char *sizes = allowed == (1u << 2 | 1u << 3) ? "2 or 3 numbers"
                      : allowed == 1u << 3           ? "3 numbers"
                                                     : "2 numbers";
  if (dimension == 0 || allowed == 1u << dimension) {
    return ph_fail(r->diag, PH_E_BAD_SHAPE, path(r, i, -1, text),
                   "must have %s, found %zu", sizes, found);
  }
  return ph_fail(r->diag, PH_E_BAD_SHAPE, path(r, i, -1, text),
                 "must have %zu numbers as %s%s has, found %zu", dimension,
                 field, r->name == field ? "[0]" : "[0][0]", found);
}

/* Goes into element i of an array, one of numbers or points. */
static enum ph_status enter(struct reader *r, size_t i, const char *of) {
  char text[PH_DIAG_FIELD_MAX];
  if (*r->p != '[') {
    return ph_fail(r->diag, PH_E_BAD_TYPE, path(r, i, -1, text),
                   "must be an array of %s, found %s", of,
                   ph_value_type(*r->p));
  }
  r->p++;
  return PH_OK;
}

/* Vector i, of `dimension` numbers or (0) of any allowed number of them. */
static enum ph_status read_vector(struct reader *r, size_t i, size_t dimension,
                                  double v[3], size_t *size) {
  enum ph_status status = enter(r, i, "numbers");
  double more;
  size_t n = 0;
  while (status == PH_OK && next_element(r)) {
    status = read_element(r, i, (long)n, n < 3 ? &v[n] : &more);
    n++;
  }
  if (status != PH_OK) {
    return status;
  }
  r->p++;
  *size = n;
  if (dimension ? n != dimension : n > 3 || !(r->row->dimensions >> n & 1)) {
    return bad_size(r, i, dimension, n);
  }
  return PH_OK;
}

/* Vectors up to the end of their array, behind the value's others; n_max in
 * all. */
static enum ph_status add_vectors(struct reader *r, size_t n_max,
                                  struct ph_value *value) {
  size_t before = value->n;
  while (next_element(r)) {
    double vector[3];
    enum ph_status status = read_vector(r, value->n - before, value->dimension,
                                        vector, &value->dimension);
    size_t dimension = value->dimension;
    if (status != PH_OK) {
      return status;
    }
    if (!value->v) {
      value->v = ph_arena_array(r->arena, n_max, dimension * sizeof *value->v);
      if (!value->v) {
        return ph_fail_memory(r->diag);
      }
    }
    memcpy(value->v + value->n++ * dimension, vector,
           dimension * sizeof *vector);
  }
  return PH_OK;
}

static enum ph_status read_vectors(struct reader *r, struct ph_value *value) {
  value->kind = PH_VECTORS;
  return add_vectors(r, count(r, '['), value);
}

/* Piece i of several, up to its end. */
static enum ph_status read_piece(struct reader *r, size_t i, size_t n_max,
                                 struct ph_value *value) {
  const char *name = r->name;
  size_t before = value->n;
  char text[PH_DIAG_FIELD_MAX];
  enum ph_status status = enter(r, i, "points");
  if (status != PH_OK) {
    return status;
  }
  r->name = path(r, i, -1, text);
  status = add_vectors(r, n_max, value);
  r->name = name;
  r->p++;
  if (status == PH_OK && value->n == before) {
    return ph_fail(r->diag, PH_E_BAD_SHAPE, text, "has no points");
  }
  value->sizes[i] = value->n - before;
  return status;
}

static enum ph_status read_polyline(struct reader *r, struct ph_value *value) {
  size_t n_max = count(r, '['); /* of pieces and their points */
  enum ph_status status = PH_OK;
  value->kind = PH_POLYLINE;
  value->sizes = ph_arena_array(r->arena, n_max / 2 + 1, sizeof *value->sizes);
  if (!value->sizes) {
    return ph_fail_memory(r->diag);
  }
  while (status == PH_OK && next_element(r)) {
    status = read_piece(r, value->sizes_n++, n_max, value);
  }
  return status;
}

/* Arrays of numbers, one after another. */
static enum ph_status read_lists(struct reader *r, struct ph_value *value) {
  const size_t lists = count(r, '['), numbers = count(r, ',') + 1;
  double *v = ph_arena_array(r->arena, numbers, sizeof *v);
  enum ph_status status = PH_OK;
  *value = (struct ph_value){.kind = PH_LISTS, .v = v, .dimension = 1};
  value->sizes = ph_arena_array(r->arena, lists, sizeof *value->sizes);
  if (!v || !value->sizes) {
    return ph_fail_memory(r->diag);
  }
  while (status == PH_OK && next_element(r)) {
    const size_t i = value->sizes_n++, before = value->n;
    status = enter(r, i, "numbers");
    while (status == PH_OK && next_element(r)) {
      status = read_element(r, i, (long)(value->n - before), &v[value->n]);
      value->n++;
    }
    r->p++;
    value->sizes[i] = value->n - before;
  }
  return status;
}

/* Whether the elements of an array, the first of them that is not empty,
 * begin with an array. */
static bool is_nested(const struct reader *r) {
  int depth = 0;
  for (const char *p = r->p; p < r->end && depth < 2; p++) {
    if (*p == '[' || *p == ']') {
      depth += *p == '[' ? 1 : -1;
    } else if (*p != ',' && ph_json_blanks(p, p + 1) == p) {
      break;
    }
  }
  return depth == 2;
}

static enum ph_status read_empty(struct reader *r, struct ph_value *value) {
  bool vectors = r->row->kinds & PH_VECTORS;
  value->kind = vectors                      ? PH_VECTORS
                : r->row->kinds & PH_NUMBERS ? PH_NUMBERS
                                             : PH_LISTS;
  value->dimension = !vectors ? 1 : r->row->dimensions >> 2 & 1 ? 2 : 3;
  value->n = 0;
  value->v = ph_arena_array(r->arena, 0, sizeof *value->v);
  return value->v ? PH_OK : ph_fail_memory(r->diag);
}

static enum ph_status read_array(struct reader *r, struct ph_value *value) {
  unsigned kinds = r->row->kinds;
  if (!(kinds & (PH_NUMBERS | PH_VECTORS | PH_LISTS))) {
    return bad_type(r, "an array");
  }
  r->p++;
  if (!next_element(r)) {
    return read_empty(r, value);
  }
  if (*r->p == '[' && kinds & PH_LISTS) {
    return read_lists(r, value);
  }
  if (*r->p == '[' && kinds & PH_POLYLINE && is_nested(r)) {
    return read_polyline(r, value);
  }
  if (*r->p == '[' && kinds & PH_VECTORS) {
    return read_vectors(r, value);
  }
  if (*r->p != '[' && kinds & PH_NUMBERS) {
    return read_numbers(r, value);
  }
  if (*r->p == '[') {
    return bad_type(r, "an array of arrays");
  }
  if (*r->p == '-' || (*r->p >= '0' && *r->p <= '9')) {
    return bad_type(r, "an array of numbers");
  }
  return bad_type(r, "an array of something else");
}

/* ---- the whole ------------------------------------------------------ */

enum ph_status ph_value_read(const char *text, size_t n,
                             const struct ph_field *row, struct ph_arena *arena,
                             struct ph_value *value, struct ph_diag *diag) {
  struct reader r = {row, ph_field_name(row->id), text, text + n, arena, diag};
  *value = (struct ph_value){.kind = PH_ABSENT};
  switch (*text) {
  case '"':
    return read_string(&r, value);
  case '[':
    return read_array(&r, value);
  case '{':
    return bad_type(&r, "an object");
  case 't':
  case 'f':
  case 'n':
    return read_literal(&r, value);
  default:
    return read_number(&r, value);
  }
}

/* A VALUE that is no JSON: a number or a bare word. */
static enum ph_status read_bare(struct reader *r, struct ph_value *value) {
  size_t n = (size_t)(r->end - r->p);
  const char *word;
  char found[PH_EXCERPT_MAX + 2];
  char excerpt[PH_EXCERPT_MAX];
  if (r->row->kinds & PH_NUMBER &&
      ph_number_read_text(r->p, r->end, &value->number) == r->end) {
    value->kind = PH_NUMBER;
    return check_finite(value->number, r->name, r->p, n, r->diag);
  }
  if (r->row->kinds & PH_WORD) {
    word = ph_arena_copy(r->arena, r->p, n);
    return word ? check_word(r, word, n, r->p, value) : ph_fail_memory(r->diag);
  }
  if (r->row->kinds & PH_PATH) {
    return ph_svg_path_value(r->p, n, r->name, r->arena, value, r->diag);
  }
  snprintf(found, sizeof found, "\"%s\"", ph_excerpt(r->p, n, excerpt));
  return bad_type(r, found);
}

/* A list of numbers without brackets, 0,1,3: the same with them; NULL: it is
 * none, or (*status) memory is exhausted. */
static const char *in_brackets(const char *text, struct ph_arena *arena,
                               enum ph_status *status) {
  const size_t n = strlen(text);
  struct ph_json_scan scan = {0};
  char *list;
  if (!strchr(text, ',') || strchr("[{\"", *text)) {
    return NULL;
  }
  list = ph_arena_array(arena, n + 3, 1);
  if (!list) {
    *status = PH_E_NO_MEMORY;
    return NULL;
  }
  list[0] = '[';
  memcpy(list + 1, text, n);
  memcpy(list + 1 + n, "]", 2);
  return ph_json_scan(&scan, list, n + 2, true) == PH_JSON_DONE &&
                 scan.at == n + 2
             ? list
             : NULL;
}

enum ph_status ph_value_read_option(const char *text,
                                    const struct ph_field *row,
                                    struct ph_arena *arena,
                                    struct ph_value *value,
                                    struct ph_diag *diag) {
  const char *end = text + strlen(text);
  const char *p = ph_json_blanks(text, end);
  struct reader r = {row, ph_field_name(row->id), text, end, arena, diag};
  struct ph_json_scan scan = {0};
  enum ph_json_state state;
  enum ph_status status = PH_OK;
  const char *list =
      row->kinds & PH_NUMBERS ? in_brackets(p, arena, &status) : NULL;
  *value = (struct ph_value){.kind = PH_ABSENT};
  if (status != PH_OK) {
    return ph_fail_memory(diag);
  }
  if (list) {
    return ph_value_read(list, strlen(list), row, arena, value, diag);
  }
  if (p == end && row->kinds & PH_BOOL) {
    value->kind = PH_BOOL;
    value->flag = true;
    return PH_OK;
  }
  state = ph_json_scan(&scan, p, (size_t)(end - p), true);
  if (state == PH_JSON_DONE && ph_json_blanks(p + scan.at, end) == end) {
    return ph_value_read(p, scan.at, row, arena, value, diag);
  }
  if (p < end && strchr("[{\"", *p)) {
    return ph_fail(diag, PH_E_SYNTAX, r.name, "must be JSON: %s",
                   state == PH_JSON_DONE ? "something follows the value"
                                         : scan.message);
  }
  return read_bare(&r, value);
}
