/* SPDX-License-Identifier: GPL-3.0-or-later */
/* JSON Schemas (draft 2020-12) of problems and results, derived from the tables
 * of commands, fields, promises, and members of records (io/members.h). */
#ifndef PH_CLI_SCHEMA_H
#define PH_CLI_SCHEMA_H

#include "base/buf.h"
#include "cli/command.h"

/* ph_schema_text: what `phspline schema COMMAND` prints; NULL: of all commands.
 * Where memory is exhausted, the buffer has failed. */
void ph_schema_text(struct ph_buf *buf, const struct ph_command *command);

#endif
