/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Reads result records, as json_out.h writes them, back into structs: the claim
 * that `verify' looks at.
 *
 * Members that are missing are missing in the struct (NULL, n = 0, not known);
 * members that no version of the program writes are passed over, as results may
 * carry what others added.  What has the wrong type or size is an error, and
 * says where.
 */
#ifndef PH_IO_JSON_RESULT_H
#define PH_IO_JSON_RESULT_H

#include "base/diag.h"
#include "base/mem.h"
#include "curve/result.h"
#include "io/json_out.h"
#include "io/record.h"

#include <stdbool.h>

/* A result record. */
struct ph_claim {
  const char *command; /* that it says it is of; NULL: it does not say */
  bool solved;         /* status "ok"; an error record has no result */
  struct ph_echo echo;
  struct ph_swept *swept; /* its member "sweep", values on one line */
  size_t swept_n;
  struct ph_swept *set; /* its member "set" */
  size_t set_n;
  struct ph_result result;
};

/*
 * ph_json_result_in: reads one.
 *
 * out  claim  arrays from the arena
 * ret  PH_OK | PH_E_SYNTAX, PH_E_MISSING_FIELD, PH_E_BAD_TYPE, PH_E_BAD_VALUE,
 *      PH_E_BAD_SHAPE (naming the field) | PH_E_NO_MEMORY
 */
enum ph_status ph_json_result_in(const struct ph_record *record,
                                 struct ph_arena *arena, struct ph_claim *claim,
                                 struct ph_diag *diag);

#endif
