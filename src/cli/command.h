/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The commands of phspline.  Those that solve problems are each a method, its
 * certificate, and what can be derived from its curves; the other one verifies
 * results.  Adding a command is adding a row (command.c).
 */
#ifndef PH_CLI_COMMAND_H
#define PH_CLI_COMMAND_H

#include "base/buf.h"
#include "curve/fair/describe.h"
#include "curve/kind/kind.h"
#include "solve/method.h"

struct ph_options;
struct ph_worker;
struct ph_item;

/* What a command is for, and so which of the common options it has: it solves
 * problems, by curves, by surfaces of strips or of patches, or it verifies. */
enum ph_use {
  PH_USE_CURVE = 1,
  PH_USE_SURFACE = 2,
  PH_USE_DRAW = 3, /* these have points in their figures */
  PH_USE_VERIFY = 4,
  PH_USE_PATCHES = 8,
  PH_USE_ANY_SURFACE = 10,
  PH_USE_SOLVE = 11,
  PH_USE_ALL = 15
};

struct ph_command {
  const struct ph_schema *schema; /* its name, and the fields of its records */
  const char *title;              /* one line for the help */
  enum ph_use use;
  /* work: one record, bytes to bytes (cli/work.h) */
  void (*work)(const struct ph_options *options, struct ph_worker *worker,
               struct ph_item *item, struct ph_buf *out, struct ph_buf *err);

  /* What follows belongs to commands that solve. */
  const struct ph_method *method;
  ph_describe_fn *describe; /* NULL: all is in the solution and certificate */
  const char *examples;     /* lines for the help: command, tab, what it does */
};

/* ph_command_kind: the kind of its curves, or one that they may have. */
static inline const struct ph_kind *
ph_command_kind(const struct ph_command *command) {
  return ph_kinds[command->method->kind];
}

/* The members of a command that solves by a method, up to that one. */
#define PH_SOLVES_BY(by, use) \
  &(by).schema, (by).title, PH_USE_##use, ph_work, &(by)

extern const struct ph_command ph_commands[];
extern const size_t ph_commands_n;

/* ph_command_field: the field that a name[n] on the command line means, which
 * may have dashes in place of underscores; NULL: none. */
const struct ph_field *ph_command_field(const struct ph_schema *schema,
                                        const char *name, size_t n);

/* ph_command_find: the command of that name, or NULL. */
const struct ph_command *ph_command_find(const char *name);

#endif
