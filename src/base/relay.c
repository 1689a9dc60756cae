/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Text by several threads (see relay.h).
 *
 * Each thread writes chunks to a buffer of its own, which goes into the one for
 * all when it is the turn of the chunk.  It holds a piece, and what is more
 * waits for the turn, too: it is made before the first byte, and never grows.
 */
#include "base/relay.h"

#include "base/team.h"

#include <pthread.h>

/* As much as a chunk mostly takes. */
enum { PIECE = 512 << 10 };

struct relay {
  struct ph_buf *buf;
  void (*write)(void *, struct ph_buf *, size_t, size_t);
  void *context;
  pthread_mutex_t lock;
  pthread_cond_t changed;
  size_t turn; /* the element that is to follow */
};

/* What one thread has of it. */
struct runner {
  struct relay *relay;
  struct ph_buf own;
  size_t first; /* of its chunk */
};

struct runners {
  struct runner of[PH_TEAM_MAX];
};

/* Waits for the turn of a chunk, and hands over what there is of it. */
static void hand_over(void *context, struct ph_buf *own) {
  const struct runner *runner = context;
  struct relay *relay = runner->relay;
  pthread_mutex_lock(&relay->lock);
  while (relay->turn != runner->first) {
    pthread_cond_wait(&relay->changed, &relay->lock);
  }
  pthread_mutex_unlock(&relay->lock);
  ph_buf_put(relay->buf, own->data, own->n);
  own->n = 0;
}

static bool run(void *context, size_t thread, size_t first, size_t end) {
  struct runner *runner = &((struct runners *)context)->of[thread];
  struct relay *relay = runner->relay;
  runner->first = first;
  relay->write(relay->context, &runner->own, first, end);
  hand_over(runner, &runner->own);
  pthread_mutex_lock(&relay->lock);
  relay->turn = end;
  pthread_cond_broadcast(&relay->changed);
  pthread_mutex_unlock(&relay->lock);
  return true;
}

/* A buffer for each thread, before any writes; false: memory is exhausted. */
static bool begin(struct runners *runners, size_t n, struct relay *relay) {
  bool good = true;
  for (size_t i = 0; i < n; i++) {
    struct runner *runner = &runners->of[i];
    *runner = (struct runner){.relay = relay};
    good = good && ph_buf_reserve(&runner->own, PIECE);
    runner->own.piece = PIECE;
    runner->own.spill = hand_over;
    runner->own.context = runner;
  }
  return good;
}

void ph_relay(struct ph_buf *buf, size_t n,
              void (*write)(void *context, struct ph_buf *to, size_t first,
                            size_t end),
              void *context) {
  const size_t threads = ph_team_take(buf->spare, n / PH_RELAY_WORTH);
  struct relay relay = {.buf = buf, .write = write, .context = context};
  struct runners runners;
  bool good = threads > 1 && begin(&runners, threads, &relay);
  if (good && pthread_mutex_init(&relay.lock, NULL) == 0) {
    pthread_cond_init(&relay.changed, NULL);
    ph_team_spread(buf->spare, threads, n, PH_RELAY_CHUNK, run, &runners);
    pthread_cond_destroy(&relay.changed);
    pthread_mutex_destroy(&relay.lock);
  } else {
    for (size_t i = 1; i < threads; i++) {
      ph_team_leave(buf->spare);
    }
    write(context, buf, 0, n);
  }
  for (size_t i = 0; threads > 1 && i < threads; i++) {
    ph_buf_free(&runners.of[i].own);
  }
}
