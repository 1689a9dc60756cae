/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Results as the program makes them, and what verification finds of them; for
 * tests that change one thing of a result.
 */
#ifndef PH_TESTS_VERIFY_UNIT_H
#define PH_TESTS_VERIFY_UNIT_H

#include "cli/command.h"
#include "check/verify.h"

#include <stdbool.h>

/* What is asked for beside the curve. */
struct unit_wanted {
  struct ph_sample_rules samples;
  double offset; /* 0: none */
  bool bezier;   /* --convert=bezier */
};

/* A problem, its result, and the verdict.  {0} is none. */
struct unit_claim {
  const struct ph_command *command;
  struct ph_problem problem;
  struct ph_result result;
  struct ph_verdict verdict;
  struct ph_diag diag;
  struct ph_arena arena, scratch;
};

/* unit_derive: offsets, Bezier curves and samples of a curve that is there. */
enum ph_status unit_derive(const struct unit_wanted *wanted,
                           struct ph_arena *arena, struct ph_result *result,
                           struct ph_diag *diag);

/* unit_claim_make: solves and certifies a problem in JSON; fails where there is
 * no curve.
 *
 * inout claim  what it held is given back
 */
void unit_claim_make(struct unit_claim *claim, const char *command,
                     const char *json, const struct unit_wanted *wanted);

/* unit_claim_verify: with the problem or without. */
void unit_claim_verify(struct unit_claim *claim, bool with_problem);

/* unit_worst: the largest error. */
double unit_worst(const struct ph_verdict *verdict);

void unit_claim_free(struct unit_claim *claim);

#endif
