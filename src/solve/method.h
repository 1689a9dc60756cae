/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A method: one way to turn a problem into a curve.
 *
 * Each solve/NAME.c exports one const struct ph_method; cli/commands.h lists
 * them, each with its certificate.  A solver is a pure function: no I/O, no
 * globals, and nothing but its problem decides its result.
 */
#ifndef PH_SOLVE_METHOD_H
#define PH_SOLVE_METHOD_H

#include "base/diag.h"
#include "base/mem.h"
#include "curve/problem.h"
#include "curve/result.h"

#include <stdbool.h>

struct ph_method {
  struct ph_schema schema; /* name of the command, fields of its problems */
  char title[72];          /* one line for the help */
  size_t dimension;        /* of its curves */
  bool on_sphere;          /* they are, and in 3 dimensions */
  /*
   * solve: fills result->curve, the solver's own diagnostics (iterations,
   * residual) and warnings.
   *
   * out      memory of the result
   * scratch  memory given back before the return
   * ret      PH_OK, or the status set in diag; the result is then undefined
   */
  enum ph_status (*solve)(const struct ph_problem *problem,
                          struct ph_arena *out, struct ph_arena *scratch,
                          struct ph_result *result, struct ph_diag *diag);
};

#endif
