/* SPDX-License-Identifier: GPL-3.0-or-later */
/* One record, bytes to bytes: read, solve, certify, derive, write. */
#ifndef PH_CLI_WORK_H
#define PH_CLI_WORK_H

#include "base/buf.h"
#include "base/mem.h"
#include "cli/option.h"
#include "io/record.h"
#include "plot/drawing.h"

struct ph_paired;

/* Output that a record has failed to write leaves no more memory than this. */
enum { PH_WORK_KEEP = 1 << 20 };

/* A text that is written in pieces has no more than this in memory, about. */
enum { PH_WORK_PIECE = 512 << 10 };

/* What a worker keeps from record to record. */
struct ph_worker {
  struct ph_arena arena;   /* of the record, but for what */
  struct ph_arena given;   /* has: the problem as it was read */
  struct ph_arena scratch; /* of the solver */
  struct ph_budget budget; /* of all */
};

/* One result to be: a record and a combination of swept values. */
struct ph_item {
  struct ph_record record;
  struct ph_diag diag; /* of a record whose text is broken, or a result that
                          solves no problem */
  bool cut_off;        /* ... so that nothing behind it could be read */
  size_t sweep;
  struct ph_buf *held; /* the text, of this item alone, which may be freed when
                          it is read; NULL: of others, too */
  const struct ph_paired *paired; /* the problem of a result (cli/pairing.h) */
  bool draw;                      /* for the figure */
  struct ph_drawing *drawing;     /* out: to be freed; NULL: there is none */
  struct ph_panorama *panorama;   /* out: the same */
  double box[4];                  /* out: what was drawn (io/svg_out.h) */
  enum ph_status status;          /* the outcome */
};

/*
 * ph_work: appends the record of one item to `out` and its messages to `err`,
 * and sets item->status and item->drawing.  Depends on nothing but the item and
 * the options.
 */
void ph_work(const struct ph_options *options, struct ph_worker *worker,
             struct ph_item *item, struct ph_buf *out, struct ph_buf *err);

/* ph_work_begin: the work on a record begins, on a budget by the options. */
void ph_work_begin(const struct ph_options *options, struct ph_worker *worker);

/* ph_work_settle: it has ended so; what spent its budget has failed for that,
 * whatever the solver made of it.  From then on there is no budget, and no
 * scratch.  ret  the status, PH_E_LIMIT if there was too little */
enum ph_status ph_work_settle(const struct ph_options *options,
                              struct ph_worker *worker, enum ph_status status,
                              struct ph_diag *diag);

/*
 * ph_work_assign: --set gives what a problem lacks, --override anything; the
 * last one that is about a field counts.
 *
 * out  set[PH_FIELD_N]  the fields that were set, or NULL
 * ret  how many
 */
size_t ph_work_assign(const struct ph_assignment *assignments, size_t n,
                      struct ph_problem *problem, struct ph_swept *set);

/* ph_work_byte: of a part of the input where a record begins; else NULL. */
const size_t *ph_work_byte(const struct ph_options *options,
                           const struct ph_record *record);

/* ph_work_id: an id as people write it, without the quotes of a JSON string;
 * NULL: there is none, or memory is exhausted. */
const char *ph_work_id(const struct ph_echo *echo, struct ph_arena *arena);

/* ph_worker_free: gives back a worker's memory. */
void ph_worker_free(struct ph_worker *worker);

#endif
