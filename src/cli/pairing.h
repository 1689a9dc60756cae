/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Which of the problems of --problems=FILE a result solves.
 *
 * By id: the problem with the same id; of several with one id, each result
 * takes the next.  Without ids: each takes the next of all.  Results of a sweep
 * are of one problem until the swept values begin again with those of the first
 * of them.
 *
 * The problems are kept in memory.  They are read when the first result has
 * said what command they are for, which decides what columns of CSV mean.
 */
#ifndef PH_CLI_PAIRING_H
#define PH_CLI_PAIRING_H

#include "base/diag.h"
#include "base/mem.h"
#include "cli/option.h"
#include "io/record.h"
#include "io/split.h"

#include <stdbool.h>

/* A problem as it stands in its file. */
struct ph_paired {
  struct ph_record record;
  struct ph_diag diag;            /* of a record whose text is broken */
  const struct ph_schema *schema; /* by which its columns were understood */
  const char *key;                /* of its id; NULL: it has none */
  size_t index;                   /* in the file */
  bool used;                      /* a result was found for it */
};

/* Problems with one id, or all that have none, or simply all. */
struct ph_paired_group {
  struct ph_paired *const *paired; /* [n] */
  size_t n;
  size_t next;       /* the one that the next result takes */
  const char *sweep; /* of the first result of the one before; or NULL */
};

/* {0} has read no problems yet. */
struct ph_pairing {
  struct ph_arena arena;   /* of the problems */
  struct ph_arena scratch; /* of one record */
  struct ph_split split;
  bool split_begun, loaded, cut_off;
  struct ph_paired **paired; /* in their order */
  size_t paired_n;
  struct ph_paired **by_key; /* the same, by key */
  struct ph_paired_group *groups;
  size_t groups_n; /* by key; the first is of those without, if any */
  struct ph_paired_group all;
  size_t before; /* results before the first one that named its command */
};

/*
 * ph_pairing_find: the problem of the next result.
 *
 * in   result  JSON; its status may be that of a broken text
 * out  paired   NULL: there is none, and diag says why; or the result is
 *              broken
 * ret  PH_OK | PH_E_NO_MEMORY; PH_E_INPUT | PH_E_USAGE: the problems cannot be
 *      read
 */
enum ph_status ph_pairing_find(struct ph_pairing *pairing,
                               const struct ph_options *options,
                               const struct ph_record *result,
                               const struct ph_paired **paired,
                               struct ph_diag *diag);

/* ph_pairing_finish: whether all problems had results.
 * ret  PH_OK | PH_E_NOT_VERIFIED | PH_E_INPUT (the problems were cut off by a
 *      syntax error) */
enum ph_status ph_pairing_finish(const struct ph_pairing *pairing,
                                 const struct ph_options *options,
                                 struct ph_diag *diag);

void ph_pairing_free(struct ph_pairing *pairing);

#endif
