/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Reads JSON whose members are known (see json_read.h). */
#include "io/json_read.h"

#include "base/suggest.h"
#include "io/number.h"
#include "io/value.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

/* ---- where it is ------------------------------------------------------- */

/* Goes on with the path; one that does not fit is cut.  Every number of a
 * result passes here. */
static void extend(struct ph_json_reader *r, const char *text, size_t n) {
  size_t room = sizeof r->path - 1 - r->n;
  n = n < room ? n : room;
  memcpy(r->path + r->n, text, n);
  r->n += n;
  r->path[r->n] = '\0';
}

static void exhausted(struct ph_json_reader *r) {
  if (r->status == PH_OK) {
    r->status = ph_fail_memory(r->diag);
  }
}

/* Looks at the time. */
static void look(struct ph_json_reader *r) {
  if (ph_arena_late(r->arena)) {
    exhausted(r);
  }
}

size_t ph_read_enter(struct ph_json_reader *r, const char *name) {
  size_t mark = r->n;
  extend(r, ".", mark > 0);
  extend(r, name, strlen(name));
  return mark;
}

size_t ph_read_enter_at(struct ph_json_reader *r, size_t index) {
  char text[3 * sizeof index + 2];
  size_t mark = r->n, at = sizeof text;
  text[--at] = ']';
  do {
    text[--at] = (char)('0' + index % 10);
    index /= 10;
  } while (index > 0);
  text[--at] = '[';
  look(r);
  extend(r, text + at, sizeof text - at);
  return mark;
}

void ph_read_leave(struct ph_json_reader *r, size_t mark) {
  r->n = mark;
  r->path[mark] = '\0';
}

void ph_read_fail(struct ph_json_reader *r, enum ph_status status,
                  const char *format, ...) {
  char message[PH_DIAG_MESSAGE_MAX];
  va_list args;
  if (r->status != PH_OK) {
    return;
  }
  va_start(args, format);
  vsnprintf(message, sizeof message, format, args);
  va_end(args);
  r->status = ph_fail(r->diag, status, r->n ? r->path : NULL, "%s", message);
}

void *ph_read_array_of(struct ph_json_reader *r, size_t n, size_t size) {
  void *memory;
  if (r->status != PH_OK) {
    return NULL;
  }
  memory = ph_arena_array(r->arena, n, size);
  if (!memory) {
    exhausted(r);
  }
  return memory;
}

static void wrong_type(struct ph_json_reader *r, const char *wanted,
                       const struct ph_json_item *found) {
  ph_read_fail(r, PH_E_BAD_TYPE, "must be %s, found %s", wanted,
               ph_value_type(*found->value));
}

/* ---- containers -------------------------------------------------------- */

/* Which of the rows a key is of; NULL: none. */
static const struct ph_member *row_of(struct ph_json_reader *r,
                                      const struct ph_json_item *item,
                                      const struct ph_member *rows) {
  const char *key = item->key;
  size_t n = item->key_n;
  if (memchr(key, '\\', n)) {
    key = ph_value_string(key - 1, n + 2, r->arena);
    if (!key) {
      exhausted(r);
      return NULL;
    }
    n = strlen(key);
  }
  while (rows->name &&
         (strlen(rows->name) != n || memcmp(rows->name, key, n) != 0)) {
    rows++;
  }
  return rows->name ? rows : NULL;
}

void ph_read_members(struct ph_json_reader *r, const struct ph_json_item *from,
                     const struct ph_member *rows, struct ph_json_item *items) {
  struct ph_json_walk walk;
  struct ph_json_item item;
  for (size_t i = 0; rows[i].name; i++) {
    items[i] = (struct ph_json_item){0};
  }
  if (r->status != PH_OK) {
    return;
  }
  if (*from->value != '{') {
    wrong_type(r, "an object", from);
    return;
  }
  ph_json_walk_init(&walk, from->value, from->value_n);
  while (r->status == PH_OK && ph_json_walk_next(&walk, &item)) {
    const struct ph_member *row = row_of(r, &item, rows);
    if (row && items[row - rows].value) {
      ph_read_enter(r, row->name);
      ph_read_fail(r, PH_E_BAD_VALUE, "occurs twice");
    } else if (row) {
      items[row - rows] = item;
    }
  }
}

size_t ph_read_size(struct ph_json_reader *r, const struct ph_json_item *from) {
  struct ph_json_walk walk;
  struct ph_json_item item;
  size_t n = 0;
  if (r->status != PH_OK) {
    return 0;
  }
  if (*from->value != '[') {
    wrong_type(r, "an array", from);
    return 0;
  }
  ph_json_walk_init(&walk, from->value, from->value_n);
  while (r->status == PH_OK && ph_json_walk_next(&walk, &item)) {
    look(r);
    n++;
  }
  return r->status == PH_OK ? n : 0;
}

/* ---- single values ----------------------------------------------------- */

bool ph_read_required(struct ph_json_reader *r, const struct ph_json_item *item,
                      const char *name) {
  size_t mark;
  if (item->value) {
    return true;
  }
  mark = ph_read_enter(r, name);
  ph_read_fail(r, PH_E_MISSING_FIELD, "is missing");
  ph_read_leave(r, mark);
  return false;
}

/* A finite number, here; 0 after a failure. */
static double number(struct ph_json_reader *r,
                     const struct ph_json_item *item) {
  const char *end = item->value + item->value_n;
  char excerpt[PH_EXCERPT_MAX];
  double x;
  if (!ph_number_read(item->value, end, &x)) {
    wrong_type(r, "a number", item);
  } else if (!isfinite(x)) {
    ph_read_fail(r, PH_E_NOT_FINITE, "is %s, which overflows a double",
                 ph_excerpt(item->value, item->value_n, excerpt));
  } else {
    return x;
  }
  return 0;
}

double ph_read_number(struct ph_json_reader *r, const struct ph_json_item *item,
                      const char *name, double absent) {
  size_t mark;
  double x;
  if (r->status != PH_OK || !item->value) {
    return absent;
  }
  mark = ph_read_enter(r, name);
  x = number(r, item);
  ph_read_leave(r, mark);
  return r->status == PH_OK ? x : absent;
}

bool ph_read_flag(struct ph_json_reader *r, const struct ph_json_item *item,
                  const char *name, bool absent) {
  size_t mark;
  if (r->status != PH_OK || !item->value) {
    return absent;
  }
  if (*item->value != 't' && *item->value != 'f') {
    mark = ph_read_enter(r, name);
    wrong_type(r, "true or false", item);
    ph_read_leave(r, mark);
    return absent;
  }
  return *item->value == 't';
}

const char *ph_read_string(struct ph_json_reader *r,
                           const struct ph_json_item *item, const char *name,
                           const char *absent) {
  const char *text = absent;
  size_t mark;
  if (r->status != PH_OK || !item->value) {
    return absent;
  }
  mark = ph_read_enter(r, name);
  if (*item->value != '"') {
    wrong_type(r, "a string", item);
  } else {
    text = ph_value_string(item->value, item->value_n, r->arena);
    if (!text) {
      exhausted(r);
      text = absent;
    }
  }
  ph_read_leave(r, mark);
  return text;
}

size_t ph_read_whole(struct ph_json_reader *r, const struct ph_json_item *item,
                     const char *name, size_t least, size_t most) {
  char excerpt[PH_EXCERPT_MAX];
  size_t mark;
  double x;
  if (r->status != PH_OK || (name && !ph_read_required(r, item, name))) {
    return least;
  }
  mark = name ? ph_read_enter(r, name) : r->n;
  x = number(r, item);
  if (r->status == PH_OK &&
      (!(x >= (double)least) || !(x <= (double)most) || floor(x) < x)) {
    ph_read_fail(r, PH_E_BAD_VALUE,
                 "must be a whole number from %zu to %zu, found %s", least,
                 most, ph_excerpt(item->value, item->value_n, excerpt));
  }
  ph_read_leave(r, mark);
  return r->status == PH_OK ? (size_t)x : least;
}

/* ---- arrays ------------------------------------------------------------ */

/* An array of n numbers, here; where it is open, null is NaN. */
static void numbers(struct ph_json_reader *r, const struct ph_json_item *from,
                    double *v, size_t n, bool open) {
  size_t found = ph_read_size(r, from);
  struct ph_json_walk walk;
  struct ph_json_item item;
  if (r->status == PH_OK && found != n) {
    ph_read_fail(r, PH_E_BAD_SHAPE, "must have %zu number%s, found %zu", n,
                 n == 1 ? "" : "s", found);
  }
  if (r->status != PH_OK) {
    return;
  }
  ph_json_walk_init(&walk, from->value, from->value_n);
  for (size_t i = 0; r->status == PH_OK && i < n; i++) {
    size_t mark = ph_read_enter_at(r, i);
    ph_json_walk_next(&walk, &item);
    v[i] = open && *item.value == 'n' ? (double)NAN : number(r, &item);
    ph_read_leave(r, mark);
  }
}

void ph_read_numbers(struct ph_json_reader *r, const struct ph_json_item *item,
                     const char *name, double *v, size_t n) {
  size_t mark;
  if (r->status != PH_OK || !ph_read_required(r, item, name)) {
    return;
  }
  mark = ph_read_enter(r, name);
  numbers(r, item, v, n, false);
  ph_read_leave(r, mark);
}

void ph_read_open(struct ph_json_reader *r, const struct ph_json_item *item,
                  const char *name, double *v, size_t n) {
  size_t mark;
  if (r->status != PH_OK) {
    return;
  }
  for (size_t i = 0; i < n; i++) {
    v[i] = (double)NAN;
  }
  if (*item->value != 'n') {
    mark = name ? ph_read_enter(r, name) : r->n;
    numbers(r, item, v, n, true);
    ph_read_leave(r, mark);
  }
}

void ph_read_vectors(struct ph_json_reader *r, const struct ph_json_item *item,
                     const char *name, double *v, size_t n, size_t dimension) {
  size_t mark, found;
  struct ph_json_walk walk;
  struct ph_json_item vector;
  if (r->status != PH_OK || !ph_read_required(r, item, name)) {
    return;
  }
  mark = ph_read_enter(r, name);
  found = ph_read_size(r, item);
  if (r->status == PH_OK && found != n) {
    ph_read_fail(r, PH_E_BAD_SHAPE, "must have %zu vector%s, found %zu", n,
                 n == 1 ? "" : "s", found);
  }
  ph_json_walk_init(&walk, item->value, item->value_n);
  for (size_t i = 0; r->status == PH_OK && i < n; i++) {
    size_t inner = ph_read_enter_at(r, i);
    ph_json_walk_next(&walk, &vector);
    numbers(r, &vector, v + i * dimension, dimension, false);
    ph_read_leave(r, inner);
  }
  ph_read_leave(r, mark);
}
