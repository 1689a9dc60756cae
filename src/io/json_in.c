/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * JSON object -> problem (see json_in.h).
 *
 * One walk over the members says what each is and finds unknown and repeated
 * names; the values of the fields are read after it, in the order of the
 * schema.  So id and meta are known whatever else is wrong.  Names are compared
 * as what they stand for: "po\u0069nts" is points.
 */
#include "io/json_in.h"

#include "base/suggest.h"
#include "io/csv_in.h"
#include "io/geojson.h"
#include "io/json_scan.h"
#include "io/number.h"
#include "io/value.h"

#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

/* What a record has, besides its fields, by the same kind of index. */
enum { ID = PH_FIELD_N, META, MEMBERS };

/* The values of the members, by field; NULL: absent. */
struct members {
  struct ph_json_item item[MEMBERS];
};

static bool is_name(const char *text, size_t n, const char *name) {
  return strlen(name) == n && memcmp(text, name, n) == 0;
}

static enum ph_status unknown_field(const struct ph_schema *schema,
                                    const struct ph_record *record,
                                    const char *name,
                                    const struct ph_json_item *item,
                                    struct ph_diag *diag) {
  struct ph_suggest suggest;
  char excerpt[PH_EXCERPT_MAX];
  char clause[PH_DID_YOU_MEAN_MAX];
  ph_suggest_init(&suggest, name, strlen(name));
  for (size_t i = 0; i < schema->fields_n; i++) {
    const char *field = ph_field_name(schema->fields[i].id);
    ph_suggest_try(&suggest, field, strlen(field));
  }
  ph_suggest_list(&suggest, "id|meta");
  ph_did_you_mean(&suggest, clause);
  ph_fail(diag, PH_E_UNKNOWN_FIELD,
          item->key_n ? ph_excerpt(item->key, item->key_n, excerpt) : "\"\"",
          "is not a field of %s%s", schema->command, clause);
  if (ph_geojson_is(record->text, record->n) == PH_JSON_DONE) {
    ph_diag_add(diag, "--input-format=geojson reads GeoJSON");
  } else if (strlen(name) == 1 && strchr("xyz", *name)) {
    ph_diag_add(diag, "an object is a whole problem, and its points are one "
                      "array, \"points\"");
  }
  return diag->status;
}

/* Puts one member where it belongs. */
static enum ph_status
sort_member(const struct ph_schema *schema, const struct ph_record *record,
            const struct ph_json_item *item, struct ph_arena *arena,
            struct members *members, struct ph_diag *diag) {
  const struct ph_field *row;
  const char *name = ph_arena_copy(arena, item->key, item->key_n);
  size_t index;
  if (name && memchr(item->key, '\\', item->key_n)) {
    name = ph_value_string(item->key - 1, item->key_n + 2, arena);
  }
  if (!name) {
    return ph_fail_memory(diag);
  }
  row = ph_field_find(schema, name, strlen(name));
  if (row) {
    index = row->id;
  } else if (is_name(name, strlen(name), "id")) {
    index = ID;
  } else if (is_name(name, strlen(name), "meta")) {
    index = META;
  } else {
    return unknown_field(schema, record, name, item, diag);
  }
  if (members->item[index].value) {
    return ph_fail(diag, PH_E_BAD_VALUE, name, "occurs twice");
  }
  members->item[index] = *item;
  return PH_OK;
}

/* ---- what is echoed ------------------------------------------------- */

/* For qsort: by length, then by bytes. */
static int compare_keys(const void *a, const void *b) {
  const struct ph_json_item *x = a;
  const struct ph_json_item *y = b;
  if (x->key_n != y->key_n) {
    return x->key_n < y->key_n ? -1 : 1;
  }
  return x->key_n ? memcmp(x->key, y->key, x->key_n) : 0;
}

/* Whether a name occurs twice among the members of an object. */
static enum ph_status check_names(const struct ph_json_item *object,
                                  const char *field, struct ph_arena *arena,
                                  struct ph_diag *diag) {
  struct ph_json_walk walk;
  struct ph_json_item item;
  struct ph_json_item *members;
  char excerpt[PH_EXCERPT_MAX];
  size_t n = 0;
  ph_json_walk_init(&walk, object->value, object->value_n);
  while (ph_json_walk_next(&walk, &item)) {
    n++;
  }
  members = ph_arena_array(arena, n, sizeof *members);
  ph_json_walk_init(&walk, object->value, object->value_n);
  for (size_t i = 0; members && i < n; i++) {
    ph_json_walk_next(&walk, &item);
    if (memchr(item.key, '\\', item.key_n)) {
      item.key = ph_value_string(item.key - 1, item.key_n + 2, arena);
      if (!item.key) {
        return ph_fail_memory(diag);
      }
      item.key_n = strlen(item.key);
    }
    members[i] = item;
  }
  if (!members) {
    return ph_fail_memory(diag);
  }
  qsort(members, n, sizeof *members, compare_keys);
  for (size_t i = 1; i < n; i++) {
    if (compare_keys(&members[i - 1], &members[i]) == 0) {
      return ph_fail(diag, PH_E_BAD_VALUE, field, "has the name \"%s\" twice",
                     ph_excerpt(members[i].key, members[i].key_n, excerpt));
    }
  }
  return PH_OK;
}

/* What holds for all JSON holds for that which is only passed on: no name
 * twice, no number beyond a double.  The scanner has bounded the depth. */
static enum ph_status check_echo(const struct ph_json_item *echoed,
                                 const char *field, struct ph_arena *arena,
                                 struct ph_diag *diag) {
  const char *end = echoed->value + echoed->value_n;
  enum ph_status status = PH_OK;
  struct ph_json_walk walk;
  struct ph_json_item item;
  char excerpt[PH_EXCERPT_MAX];
  double x;
  if (ph_number_read(echoed->value, end, &x) && !isfinite(x)) {
    return ph_fail(diag, PH_E_NOT_FINITE, field,
                   "is %s, which overflows a double",
                   ph_excerpt(echoed->value, echoed->value_n, excerpt));
  }
  if (*echoed->value == '{') {
    status = check_names(echoed, field, arena, diag);
  }
  ph_json_walk_init(&walk, echoed->value, echoed->value_n);
  while (status == PH_OK && ph_json_walk_next(&walk, &item)) {
    status = check_echo(&item, field, arena, diag);
  }
  return status;
}

/* The same without line breaks, if there are any: they can only be among the
 * blanks between the tokens, which are then all dropped. */
static const char *one_line(const struct ph_json_item *item,
                            struct ph_arena *arena, size_t *n) {
  const char *end = item->value + item->value_n;
  bool in_string = false;
  char *copy;
  *n = item->value_n;
  if (!memchr(item->value, '\n', *n) && !memchr(item->value, '\r', *n)) {
    return item->value;
  }
  copy = ph_arena_array(arena, *n, 1);
  *n = 0;
  for (const char *p = item->value; copy && p < end; p++) {
    if (in_string && *p == '\\') {
      copy[(*n)++] = *p++;
    } else if (*p == '"') {
      in_string = !in_string;
    } else if (!in_string && ph_json_blanks(p, p + 1) != p) {
      continue;
    }
    copy[(*n)++] = *p;
  }
  return copy;
}

const char *ph_json_one_line(const struct ph_json_item *item,
                             struct ph_arena *arena) {
  size_t n;
  const char *text = one_line(item, arena, &n);
  return text ? ph_arena_copy(arena, text, n) : NULL;
}

static enum ph_status echo_id(const struct ph_json_item *id,
                              struct ph_arena *arena, struct ph_echo *echo,
                              struct ph_diag *diag) {
  enum ph_status status;
  if (!strchr("\"-0123456789", *id->value)) {
    return ph_fail(diag, PH_E_BAD_TYPE, "id",
                   "must be a string or a number, found %s",
                   ph_value_type(*id->value));
  }
  status = check_echo(id, "id", arena, diag);
  if (status == PH_OK) {
    echo->id = id->value;
    echo->id_n = id->value_n;
  }
  return status;
}

static enum ph_status echo_meta(const struct ph_json_item *meta,
                                struct ph_arena *arena, struct ph_echo *echo,
                                struct ph_diag *diag) {
  enum ph_status status = check_echo(meta, "meta", arena, diag);
  if (status == PH_OK) {
    echo->meta = one_line(meta, arena, &echo->meta_n);
    status = echo->meta ? PH_OK : ph_fail_memory(diag);
  }
  return status;
}

/* Of two failures the first is told, but for that of the memory. */
static enum ph_status both(enum ph_status first, enum ph_status second,
                           struct ph_diag *diag) {
  return second == PH_E_NO_MEMORY ? ph_fail_memory(diag)
         : first == PH_OK         ? second
                                  : first;
}

enum ph_status ph_json_echo(const struct ph_json_item *id,
                            const struct ph_json_item *meta,
                            struct ph_arena *arena, struct ph_echo *echo,
                            struct ph_diag *diag) {
  struct ph_diag later;
  enum ph_status status = PH_OK;
  *echo = (struct ph_echo){0};
  if (id->value) {
    status = echo_id(id, arena, echo, diag);
  }
  if (meta->value) {
    status = both(status,
                  echo_meta(meta, arena, echo, status == PH_OK ? diag : &later),
                  diag);
  }
  return status;
}

/* ---- the whole ------------------------------------------------------ */

enum ph_status ph_json_in(const struct ph_record *record,
                          const struct ph_schema *schema,
                          struct ph_arena *arena, struct ph_problem *problem,
                          struct ph_echo *echo, struct ph_diag *diag) {
  struct members members = {{{0}}};
  struct ph_json_walk walk;
  struct ph_json_item item;
  struct ph_diag later;
  enum ph_status status = PH_OK;
  *problem = (struct ph_problem){0};
  *echo = (struct ph_echo){0};
  if (*record->text != '{') {
    return ph_fail(diag, PH_E_BAD_TYPE, NULL,
                   "a problem must be an object, found %s",
                   ph_value_type(*record->text));
  }
  ph_json_walk_init(&walk, record->text, record->n);
  while (ph_json_walk_next(&walk, &item)) { /* to the end: id may come last */
    status = both(status,
                  sort_member(schema, record, &item, arena, &members,
                              status == PH_OK ? diag : &later),
                  diag);
  }
  status = both(status,
                ph_json_echo(&members.item[ID], &members.item[META], arena,
                             echo, status == PH_OK ? diag : &later),
                diag);
  for (size_t i = 0; status == PH_OK && i < schema->fields_n; i++) {
    const struct ph_field *row = &schema->fields[i];
    const struct ph_json_item *member = &members.item[row->id];
    if (member->value) {
      status = ph_value_read(member->value, member->value_n, row, arena,
                             &problem->field[row->id], diag);
    }
  }
  return status;
}

/* ---- lines ---------------------------------------------------------- */

/* The item of a container that `name` or, without one, `index` selects. */
static bool find(const char *text, size_t n, const char *name, size_t name_n,
                 size_t index, struct ph_json_item *found) {
  struct ph_json_walk walk;
  ph_json_walk_init(&walk, text, n);
  for (size_t i = 0; ph_json_walk_next(&walk, found); i++) {
    if (name ? found->key && found->key_n == name_n &&
                   memcmp(found->key, name, name_n) == 0
             : i == index) {
      return true;
    }
  }
  return false;
}

size_t ph_json_line(const struct ph_record *record, const char *path) {
  size_t name_n = strcspn(path, "[");
  size_t line = record->line;
  const char *place = record->text;
  struct ph_json_item item;
  bool found = name_n && find(record->text, record->n, path, name_n, 0, &item);
  for (path += name_n; found; path = strchr(path, ']') + 1) {
    place = item.value;
    if (*path != '[' || !strchr(path, ']')) {
      break;
    }
    found = find(item.value, item.value_n, NULL, 0, strtoul(path + 1, NULL, 10),
                 &item);
  }
  for (const char *p = record->text; p < place; p++) {
    line += *p == '\n';
  }
  return line;
}
