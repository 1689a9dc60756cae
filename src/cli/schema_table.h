/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The members of io/members.h as data, for schema.c. */
#ifndef PH_CLI_SCHEMA_TABLE_H
#define PH_CLI_SCHEMA_TABLE_H

#include "check/promise.h"
#include "cli/command.h"

/* The record that is described: of a command, of one kind of curve. */
struct ph_form {
  const struct ph_command *command;
  const char *status;
  const struct ph_promise *promise; /* NULL: there is no curve */
  enum ph_curve_kind kind;
};

struct ph_member {
  const char *name; /* NULL ends a list */
  bool must;
  int of;           /* for ph_form_has */
  const char *type; /* io/members.h */
  const char *what;
};

struct ph_members {
  const char *name; /* of the object */
  bool shared;      /* it is the same for all commands and kinds */
  const struct ph_member *rows;
};

/* ph_members_of: those of an object, which must be one of schema_table.c. */
const struct ph_members *ph_members_of(const char *name);

/* ph_form_has: whether records of a form may have a member. */
bool ph_form_has(const struct ph_form *form, const struct ph_member *member);

/* ph_form_quotients: whether offsets are quotients, and not rational: those of
 * atph curves, and of the Bezier curves that stand for them. */
bool ph_form_quotients(const struct ph_form *form);

#endif
