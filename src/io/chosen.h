/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The members of a record that are written, as chosen by a list of names: those
 * of the table of members (members.h), of an object inside as NAME.NAME.
 */
#ifndef PH_IO_CHOSEN_H
#define PH_IO_CHOSEN_H

#include "base/diag.h"
#include "base/mem.h"
#include "curve/result.h"

#include <stdbool.h>

/* A member that was chosen; NULL in place of the first one: all are. */
struct ph_chosen {
  const char *name;
  struct ph_chosen *next;
  struct ph_chosen *inner; /* of an object, or of each of a list of them */
  bool whole;              /* with all that it has */
};

/*
 * ph_chosen_read: the list "NAME,NAME.NAME,..." of members of a result.
 *
 * in   parts   what the result consists of
 * out  chosen  in the arena
 * ret  PH_OK; PH_E_USAGE for a name that is none; PH_E_NO_MEMORY
 */
enum ph_status ph_chosen_read(const char *text, enum ph_parts parts,
                              struct ph_arena *arena, struct ph_chosen **chosen,
                              struct ph_diag *diag);

/* ph_chosen_enter: whether a member is chosen.
 * inout chosen  becomes what is chosen of it */
bool ph_chosen_enter(const struct ph_chosen **chosen, const char *name);

/* ph_chosen_unasked: the diagnostics of which no record tells, as in struct
 * ph_diagnostics. */
uint64_t ph_chosen_unasked(const struct ph_chosen *chosen);

#endif
