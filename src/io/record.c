/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Records of all formats as problems (see record.h). */
#include "io/record.h"

#include "io/csv_in.h"
#include "io/json_in.h"
#include "io/obj_in.h"

#include <string.h>

enum ph_status ph_record_read(const struct ph_record *record,
                              const struct ph_schema *schema,
                              struct ph_arena *arena,
                              struct ph_problem *problem, struct ph_echo *echo,
                              struct ph_diag *diag) {
  if (record->columns) {
    return ph_csv_in(record, schema, arena, problem, echo, diag);
  }
  if (record->mesh) {
    *echo = (struct ph_echo){NULL, 0, NULL, 0};
    return ph_obj_in(record, schema, arena, problem, diag);
  }
  return ph_json_in(record, schema, arena, problem, echo, diag);
}

/* The same in the arena; NULL: there is none, or memory is exhausted. */
static const char *keep(const char *text, size_t n, struct ph_arena *arena) {
  return text ? ph_arena_copy(arena, text, n) : NULL;
}

bool ph_record_keep(struct ph_echo *echo, struct ph_arena *arena) {
  const char *id = keep(echo->id, echo->id_n, arena);
  const char *meta = keep(echo->meta, echo->meta_n, arena);
  if ((echo->id && !id) || (echo->meta && !meta)) {
    return false;
  }
  echo->id = id;
  echo->meta = meta;
  return true;
}

bool ph_record_forget(struct ph_record *record, struct ph_echo *echo,
                      struct ph_arena *arena) {
  if (record->columns || record->mesh ||
      memchr(record->text, '\n', record->n) || !ph_record_keep(echo, arena)) {
    return false;
  }
  record->text = NULL;
  return true;
}

size_t ph_record_line(const struct ph_record *record, const char *path) {
  return !record->text     ? record->line
         : record->columns ? ph_csv_line(record, path)
         : record->mesh    ? ph_obj_line(record, path)
                           : ph_json_line(record, path);
}
