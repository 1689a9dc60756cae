/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Records that leave before they are whole.
 *
 * A batch of records is written when all of it is done.  What is too long to be
 * kept until then spills (base/buf.h): the batch whose turn it is, that is, the
 * first one that is not written, goes to the output at once; another is kept up
 * to a bound, and then waits for its turn, its thread being spare meanwhile.
 * The first batch waits for nobody, so that there is always one that goes on.
 */
#ifndef PH_CLI_OUTLET_H
#define PH_CLI_OUTLET_H

#include "base/buf.h"
#include "base/diag.h"
#include "cli/document.h"
#include "cli/progress.h"

#include <pthread.h>
#include <stdatomic.h>
#include <stdbool.h>
#include <stddef.h>

/* A batch that is not the first has no more text than this, about. */
enum { PH_OUTLET_HOLD = 8 << 20 };

/* Who may write.  Its turn and closed change under the lock only. */
struct ph_outlet {
  struct ph_document *document;
  struct ph_progress *progress;
  pthread_mutex_t lock;
  pthread_cond_t changed; /* also by others, who have to wait in a loop */
  size_t turn;            /* number of the batch that is the first */
  bool closed;            /* nothing more is wanted */
  enum ph_status status;  /* of the output; then nothing more is written */
  struct ph_diag diag;    /* why */
};

/* Where the text of one batch goes. */
struct ph_spout {
  struct ph_outlet *outlet;
  size_t number;
  atomic_int *spare; /* of the thread that works on it (base/team.h) */
};

/* ph_outlet_put: text of the first batch goes to the output; by its thread, or,
 * when it is done, by the one that calls ph_outlet_next. */
enum ph_status ph_outlet_put(struct ph_outlet *outlet, const char *bytes,
                             size_t n);

/* ph_outlet_next: what there was of the first batch is written; the turn is the
 * next one's, or, closed, nobody's. */
void ph_outlet_next(struct ph_outlet *outlet, bool closed);

/* ph_spout_spill: the spill of a batch's buffer; context is its spout. */
void ph_spout_spill(void *spout, struct ph_buf *buf);

#endif
