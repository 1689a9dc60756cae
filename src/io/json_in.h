/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A JSON record as a problem, and where in the file its parts are.
 */
#ifndef PH_IO_JSON_IN_H
#define PH_IO_JSON_IN_H

#include "base/mem.h"
#include "io/json_scan.h"
#include "io/record.h"

/*
 * ph_json_in: reads one problem object.
 *
 * in   record   JSON text (no columns) whose status is PH_OK
 * in   arena    takes the memory of the values
 * out  problem  the fields that the record has; whether required ones are
 *               there is not checked (ph_problem_check_required)
 * out  echo     id and meta, as far as they are there, also on failure
 * ret  PH_OK; PH_E_BAD_TYPE, PH_E_BAD_VALUE (also for a name that occurs
 *      twice), PH_E_BAD_SHAPE, PH_E_NOT_FINITE, PH_E_UNKNOWN_FIELD,
 *      PH_E_NO_MEMORY; diag has the field, but no line (ph_record_line)
 */
enum ph_status ph_json_in(const struct ph_record *record,
                          const struct ph_schema *schema,
                          struct ph_arena *arena, struct ph_problem *problem,
                          struct ph_echo *echo, struct ph_diag *diag);

/*
 * ph_json_echo: what a result repeats of its problem, and a verdict of its
 * result.
 *
 * in   id, meta  values of these members; NULL: absent
 * out  echo      as far as they are good
 * ret  PH_OK | PH_E_BAD_TYPE | PH_E_BAD_VALUE | PH_E_NOT_FINITE |
 *      PH_E_NO_MEMORY
 */
enum ph_status ph_json_echo(const struct ph_json_item *id,
                            const struct ph_json_item *meta,
                            struct ph_arena *arena, struct ph_echo *echo,
                            struct ph_diag *diag);

/* ph_json_one_line: a value without line breaks, NUL-terminated; NULL when
 * memory is exhausted. */
const char *ph_json_one_line(const struct ph_json_item *item,
                             struct ph_arena *arena);

/* ph_json_line: of JSON, as ph_record_line (io/record.h). */
size_t ph_json_line(const struct ph_record *record, const char *path);

#endif
