/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Threads that have nothing to do, for a part of the work on one record.
 *
 * Workers (cli/run.c) share a count of spare threads.  Whoever has work that
 * can be cut takes some, and gives them back at its end: so one large record is
 * spread over all, and many small ones cost no thread.
 */
#ifndef PH_BASE_TEAM_H
#define PH_BASE_TEAM_H

#include "base/mem.h"

#include <stdatomic.h>
#include <stdbool.h>
#include <stddef.h>

/* More threads than this do not work together. */
enum { PH_TEAM_MAX = 64 };

/* ph_team_enter, ph_team_leave: work on a record begins and ends in the thread
 * of a worker, which is not spare in between.  spare may be NULL. */
void ph_team_enter(atomic_int *spare);
void ph_team_leave(atomic_int *spare);

/* ph_team_take: how many threads there are for some work, `most` at most: that
 * of the caller, and spare ones. */
size_t ph_team_take(atomic_int *spare, size_t most);

/*
 * ph_team_spread: calls work(context, thread, first, end) for n things, `chunk'
 * at a time, each time with the next ones that nobody has taken, and gives the
 * threads back when all have ended; end is n at most, thread less than
 * `threads', which were taken.  Where a thread cannot be made, the caller does
 * its work as well, afterwards.  Where work returns false, nobody takes more:
 * all that come before are done, and who needs to know which failed first can.
 */
void ph_team_spread(atomic_int *spare, size_t threads, size_t n, size_t chunk,
                    bool (*work)(void *context, size_t thread, size_t first,
                                 size_t end),
                    void *context);

/*
 * ph_team_share: the same, by a thread for each `worth' things that there are,
 * as far as the budget of an arena has spare ones.  What is looked for in
 * chunks, and put together in their order, is the same for any number of
 * threads.
 */
void ph_team_share(const struct ph_arena *arena, size_t n, size_t worth,
                   size_t chunk,
                   bool (*work)(void *context, size_t thread, size_t first,
                                size_t end),
                   void *context);

#endif
