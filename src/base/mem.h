/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Memory: checked allocation and the arena.
 *
 * Ownership in one sentence: a record's memory belongs to its slot's arena and
 * dies when the arena is reset; a function that allocates says which arena it
 * takes.  Every allocation of the program goes through this file, so that the
 * fault-injection build (PH_FAULT_INJECTION) can fail any one of them.
 */
#ifndef PH_BASE_MEM_H
#define PH_BASE_MEM_H

#include <stdatomic.h>
#include <stdbool.h>
#include <stddef.h>

/*
 * ph_memory_keep: from now on memory that is given back stays with the process,
 * up to 32 MB of it for each thread: the system clears every page that it gives
 * again, which takes longer than most work on it.  Before any thread exists.
 */
void ph_memory_keep(void);

/* ph_malloc, ph_realloc, ph_free: as in libc; size 0 gives a unique pointer. */
void *ph_malloc(size_t size);
void *ph_realloc(void *old, size_t size);
void ph_free(void *memory);

/*
 * What the work on one record may take, all its arenas together.  An arena that
 * has a budget gives nothing more once it is spent, so that work on the record
 * ends as if memory were exhausted; who began it tells the two apart.
 *
 * Bytes are those that were asked for, not those of chunks: whether a record
 * keeps to its budget does not depend on the records before it.
 */
struct ph_budget {
  size_t bytes;        /* 0: any number */
  size_t used;         /* now */
  size_t needed;       /* by the first request beyond; 0: there was none */
  double seconds;      /* 0: any number */
  double end;          /* on the monotonic clock */
  atomic_bool late;    /* it has passed, and that was seen */
  atomic_size_t apart; /* of accounts that are done, and not ended */
  atomic_int *spare; /* threads for the work on the record (team.h), or NULL */
};

/* ph_budget_start: the time begins; what is used already, counts. */
void ph_budget_start(struct ph_budget *budget, size_t bytes, double seconds);

/* ph_budget_stop: from now on nothing is refused; what was, stays known. */
void ph_budget_stop(struct ph_budget *budget);

struct ph_chunk;

/* An arena: bump allocation out of chunks.  {0} is an empty arena. */
struct ph_arena {
  struct ph_chunk *chunks;  /* newest first */
  struct ph_budget *budget; /* NULL: none */
  size_t taken;             /* bytes that were asked for */
};

/* ph_arena_beside: another arena, empty, on the same budget. */
struct ph_arena ph_arena_beside(const struct ph_arena *arena);

/* ph_arena_late: whether the time of its budget is over.  What iterates asks
 * from step to step, and stops; it need not say why, as its caller knows. */
bool ph_arena_late(const struct ph_arena *arena);

/* ph_arena_left: the bytes that its budget has left; SIZE_MAX: any number. */
size_t ph_arena_left(const struct ph_arena *arena);

/*
 * What a part of the work on a record takes, which any thread may do beside
 * others: it is counted apart, up to what the record has left, until who began
 * it ends it.  Accounts that are ended in their order take from the budget of
 * the record the same for any number of threads.
 */
struct ph_account {
  struct ph_arena arena;
  struct ph_budget budget; /* where the record has one, */
  struct ph_budget *whole; /* which is this; or NULL */
};

/* ph_account_begin: an empty arena beside another; the account must not move.
 */
void ph_account_begin(struct ph_account *account, const struct ph_arena *arena);

/* ph_account_done: its thread takes no more; false: all that are done hold more
 * than there was left, and no other part need begin. */
bool ph_account_done(struct ph_account *account);

/* ph_account_end: what it holds is of the budget of the record from now on,
 * until its arena is freed; false: the part, or this, finds the budget spent.
 */
bool ph_account_end(struct ph_account *account);

/* A moment of an arena, to return to. */
struct ph_mark {
  struct ph_chunk *chunk;
  size_t used;
  size_t taken;
};

/*
 * ph_arena_array: uninitialised memory for n elements of `size` bytes, aligned
 * to 16 bytes.
 *
 * ret  NULL when n * size overflows, memory is exhausted or the budget spent
 */
void *ph_arena_array(struct ph_arena *arena, size_t n, size_t size);

/*
 * ph_arena_grow: an array of n elements of `size` bytes with room for one more:
 * itself, or a copy with twice the room; `least` at first, when it is NULL.
 *
 * inout  room  elements that there is memory for, 0 at first
 * ret    NULL when memory is exhausted
 */
void *ph_arena_grow(struct ph_arena *arena, void *array, size_t n, size_t size,
                    size_t least, size_t *room);

/* ph_arena_copy: a NUL-terminated copy of n bytes, or NULL. */
char *ph_arena_copy(struct ph_arena *arena, const char *text, size_t n);

/* ph_arena_mark, ph_arena_release: give back what was taken since the mark. */
struct ph_mark ph_arena_mark(const struct ph_arena *arena);
void ph_arena_release(struct ph_arena *arena, struct ph_mark mark);

/* ph_arena_reset: empties the arena; keeps its largest chunk of ordinary size,
 * so that small records cost no allocation and a huge one leaves nothing. */
void ph_arena_reset(struct ph_arena *arena);

/* ph_arena_free: gives everything back. */
void ph_arena_free(struct ph_arena *arena);

#endif
