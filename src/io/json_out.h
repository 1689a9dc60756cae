/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Results and errors as JSON records: one compact object on a line, or
 * indented.  Numbers are written by io/number.h; cJSON is not involved.
 */
#ifndef PH_IO_JSON_OUT_H
#define PH_IO_JSON_OUT_H

#include "base/buf.h"
#include "base/diag.h"
#include "curve/result.h"
#include "io/chosen.h"
#include "io/json_write.h"
#include "io/record.h"

/* A field and what it was swept or set to, as in "sweep": {"lengths[1]": 1.414}
 * and "set": {"knots": "uniform"}. */
struct ph_swept {
  const char *name;
  const char *value; /* JSON, NUL-terminated; strings need no escapes */
};

/* What every record says of itself, solved or not. */
struct ph_heading {
  const struct ph_echo *echo;
  const char *command;
  const struct ph_swept *swept;
  size_t swept_n;
  const struct ph_swept *set; /* by options, which the problem does not have */
  size_t set_n;
  const char *file;               /* of the problem; NULL: standard input */
  const struct ph_chosen *chosen; /* members that are written; NULL: all */
  const size_t *byte; /* that an error tells in place of its line, or NULL */
};

/* ph_json_result: appends the record of a solved problem, with its newline. */
void ph_json_result(struct ph_buf *buf, const struct ph_heading *heading,
                    const struct ph_result *result, bool pretty);

/* ph_json_error: appends the record of a failed problem; file may be NULL. */
void ph_json_error(struct ph_buf *buf, const struct ph_heading *heading,
                   const struct ph_diag *diag, const char *file, bool pretty);

/* ---- parts of records -------------------------------------------------- */

/* ph_json_heading: the members that every record begins with. */
void ph_json_heading(struct ph_json_writer *w, const struct ph_heading *heading,
                     const char *status);

/* ph_json_fields: a member {"FIELD":VALUE,...}, unless it is empty. */
void ph_json_fields(struct ph_json_writer *w, const char *name,
                    const struct ph_swept *fields, size_t n);

/* ph_json_failure: the member "error"; file and byte may be NULL. */
void ph_json_failure(struct ph_json_writer *w, const struct ph_diag *diag,
                     const char *file, const size_t *byte);

#endif
