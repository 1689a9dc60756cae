/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Help and version texts, derived from the tables of commands, options, fields
 * and outcomes. */
#ifndef PH_CLI_HELP_H
#define PH_CLI_HELP_H

#include "base/buf.h"
#include "cli/command.h"

/* ph_help_program: what `phspline --help` prints. */
void ph_help_program(struct ph_buf *buf);

/* ph_help_command: what `phspline COMMAND --help` prints. */
void ph_help_command(struct ph_buf *buf, const struct ph_command *command);

/* ph_help_version: what `phspline --version` prints. */
void ph_help_version(struct ph_buf *buf);

#endif
