/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Spare threads (see team.h). */
#include "base/team.h"

#include <pthread.h>

struct member {
  void (*work)(void *, size_t);
  void *context;
  size_t i;
  pthread_t thread;
  bool runs;
};

void ph_team_enter(atomic_int *spare) {
  if (spare) {
    atomic_fetch_sub(spare, 1);
  }
}

void ph_team_leave(atomic_int *spare) {
  if (spare) {
    atomic_fetch_add(spare, 1);
  }
}

size_t ph_team_take(atomic_int *spare, size_t most) {
  size_t n = 1;
  most = most < PH_TEAM_MAX ? most : PH_TEAM_MAX;
  while (spare && n < most) {
    if (atomic_fetch_sub(spare, 1) <= 0) {
      atomic_fetch_add(spare, 1);
      break;
    }
    n++;
  }
  return n;
}

static void *begin(void *argument) {
  const struct member *m = argument;
  m->work(m->context, m->i);
  return NULL;
}

/* Calls work(context, i) for i = 0 to n - 1, at the same time, and gives n - 1
 * threads back. */
static void run_all(atomic_int *spare, size_t n, void (*work)(void *, size_t),
                    void *context) {
  struct member members[PH_TEAM_MAX];
  for (size_t i = 1; i < n; i++) {
    members[i] = (struct member){.work = work, .context = context, .i = i};
    members[i].runs =
        pthread_create(&members[i].thread, NULL, begin, &members[i]) == 0;
  }
  work(context, 0);
  for (size_t i = 1; i < n; i++) {
    if (members[i].runs) {
      pthread_join(members[i].thread, NULL);
    } else {
      work(context, i);
    }
    ph_team_leave(spare);
  }
}

struct spread {
  size_t n, chunk;
  bool (*work)(void *, size_t, size_t, size_t);
  void *context;
  atomic_size_t next; /* the first that nobody has taken */
};

static void take_chunks(void *context, size_t thread) {
  struct spread *s = context;
  size_t first;
  while ((first = atomic_fetch_add(&s->next, s->chunk)) < s->n) {
    const size_t end = s->n - first > s->chunk ? first + s->chunk : s->n;
    if (!s->work(s->context, thread, first, end)) {
      atomic_store(&s->next, s->n);
    }
  }
}

void ph_team_spread(atomic_int *spare, size_t threads, size_t n, size_t chunk,
                    bool (*work)(void *context, size_t thread, size_t first,
                                 size_t end),
                    void *context) {
  struct spread s = {n, chunk, work, context, 0};
  run_all(spare, threads, take_chunks, &s);
}

void ph_team_share(const struct ph_arena *arena, size_t n, size_t worth,
                   size_t chunk,
                   bool (*work)(void *context, size_t thread, size_t first,
                                size_t end),
                   void *context) {
  atomic_int *spare = arena->budget ? arena->budget->spare : NULL;
  ph_team_spread(spare, ph_team_take(spare, n / worth), n, chunk, work,
                 context);
}
