/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Records that leave before they are whole (see outlet.h). */
#include "cli/outlet.h"

#include "base/team.h"

enum ph_status ph_outlet_put(struct ph_outlet *outlet, const char *bytes,
                             size_t n) {
  ph_progress_hide(outlet->progress);
  if (outlet->status == PH_OK) {
    outlet->status = ph_document_add(outlet->document, bytes, n, &outlet->diag);
  }
  return outlet->status;
}

void ph_outlet_next(struct ph_outlet *outlet, bool closed) {
  pthread_mutex_lock(&outlet->lock);
  outlet->turn++;
  outlet->closed |= closed;
  pthread_cond_broadcast(&outlet->changed);
  pthread_mutex_unlock(&outlet->lock);
}

/* Waits for the turn of a batch; false: it never comes. */
static bool wait_for_turn(struct ph_spout *spout) {
  struct ph_outlet *outlet = spout->outlet;
  if (outlet->turn != spout->number && !outlet->closed) {
    ph_team_leave(spout->spare);
    while (outlet->turn != spout->number && !outlet->closed) {
      pthread_cond_wait(&outlet->changed, &outlet->lock);
    }
    ph_team_enter(spout->spare);
  }
  return !outlet->closed;
}

void ph_spout_spill(void *context, struct ph_buf *buf) {
  struct ph_spout *spout = context;
  struct ph_outlet *outlet = spout->outlet;
  bool wanted;
  pthread_mutex_lock(&outlet->lock);
  if (outlet->turn != spout->number && buf->n < PH_OUTLET_HOLD) {
    pthread_mutex_unlock(&outlet->lock);
    return;
  }
  wanted = wait_for_turn(spout);
  pthread_mutex_unlock(&outlet->lock);
  if (wanted) {
    ph_outlet_put(outlet, buf->data, buf->n);
  }
  buf->n = 0;
}
