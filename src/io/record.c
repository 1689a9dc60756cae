/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Records of all formats as problems (see record.h). */
#include "io/record.h"

#include "io/csv_in.h"
#include "io/json_in.h"
#include "io/obj_in.h"

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

size_t ph_record_line(const struct ph_record *record, const char *path) {
  return record->columns ? ph_csv_line(record, path)
         : record->mesh  ? ph_obj_line(record, path)
                         : ph_json_line(record, path);
}
