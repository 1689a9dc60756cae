/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The forms of records, of which schemas are made (schema.h). */
#ifndef PH_CLI_SCHEMA_FORM_H
#define PH_CLI_SCHEMA_FORM_H

#include "check/promise.h"
#include "cli/command.h"
#include "curve/kind/kind.h"
#include "io/members.h"

#include <stdbool.h>
#include <stddef.h>

/* A record that is described: of a command, of one kind of curve. */
struct ph_schema_form {
  const struct ph_command *command;
  const char *status;
  const struct ph_promise *promise; /* NULL: there is no curve */
  enum ph_curve_kind kind;
};

/* ph_schema_has_quotients: whether offsets are quotients, and not rational:
 * those of atph curves, and of the Bezier curves that stand for them. */
bool ph_schema_has_quotients(const struct ph_schema_form *form);

/* ph_schema_has: whether records of a form may have a member. */
bool ph_schema_has(const struct ph_schema_form *form,
                   const struct ph_member *member);

/* ph_schema_may_lack: whether there are records of the form without a member
 * that it has. */
bool ph_schema_may_lack(const struct ph_schema_form *form,
                        const struct ph_member *member);

/* ph_schema_size: the number that stands between the brackets of a type
 * (io/members.h); 0: it is not known. */
size_t ph_schema_size(const struct ph_schema_form *form, const char *text);

#endif
