/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Spare threads (see team.h). */
#include "base/team.h"

#include <pthread.h>
#include <stdbool.h>

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

void ph_team_run(atomic_int *spare, size_t n, void (*work)(void *, size_t),
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
