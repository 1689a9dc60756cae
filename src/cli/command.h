/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The commands of phspline: each a method, its certificate, and what can be
 * derived from its curves.  Adding a command is adding a row (command.c).
 */
#ifndef PH_CLI_COMMAND_H
#define PH_CLI_COMMAND_H

#include "cert/cert.h"
#include "curve/offset.h"
#include "solve/method.h"

struct ph_command {
  const struct ph_method *method;
  ph_cert_fn *certify;
  /* offset: the offsets_n offset curves at a distance */
  enum ph_status (*offset)(const struct ph_curve *curve, double distance,
                           const struct ph_offset_rules *rules,
                           struct ph_arena *arena, struct ph_offset *offsets,
                           struct ph_diag *diag);
  size_t offsets_n;
  /* convert: to polynomial Bezier curves; NULL if they cannot be */
  enum ph_status (*convert)(const struct ph_curve *curve, double tolerance,
                            struct ph_arena *arena, struct ph_curve *bezier,
                            double *error, struct ph_diag *diag);
  const char *examples; /* lines for the help: command, tab, what it does */
};

extern const struct ph_command ph_commands[];
extern const size_t ph_commands_n;

/* ph_command_find: the command of that name, or NULL. */
const struct ph_command *ph_command_find(const char *name);

#endif
