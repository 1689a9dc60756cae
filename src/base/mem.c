/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Allocation and the arena (see mem.h).
 *
 * Large blocks ask for huge pages: a curve of a million points is written once
 * into fresh memory, and page faults would take as long as solving it.
 *
 * Chunks double from 16 kB up to 1 MB; a request that does not fit gets a
 * chunk of its own size.  In the fault-injection build the allocation whose
 * number is in the environment variable PH_FAIL_AT (from 0) fails, and with
 * PH_FAIL_ON=1 all after it; and the look at the clock whose number is in
 * PH_LATE_AT finds that the time is over.  The product does not contain that
 * code.
 */
#define _DEFAULT_SOURCE /* madvise, clock_gettime */
#include "base/mem.h"

#include <stdalign.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <time.h>

#ifdef __GLIBC__
#include <malloc.h>
#endif

#ifdef PH_FAULT_INJECTION
#include <stdatomic.h>

static bool counts_to(atomic_long *count, const char *at, const char *on) {
  long number = atomic_fetch_add(count, 1);
  long limit = at ? atol(at) : -1;
  return limit >= 0 && (number == limit || (on && number > limit));
}

static bool fails(void) {
  static atomic_long count;
  return counts_to(&count, getenv("PH_FAIL_AT"), getenv("PH_FAIL_ON"));
}

static bool jumps(void) {
  static atomic_long count;
  return counts_to(&count, getenv("PH_LATE_AT"), NULL);
}
#else
static bool fails(void) {
  return false;
}

static bool jumps(void) {
  return false;
}
#endif

enum { CHUNK_MIN = 16 << 10, CHUNK_MAX = 1 << 20, ALIGNMENT = 16 };

struct ph_chunk {
  struct ph_chunk *older;
  size_t size; /* of data */
  size_t used;
  alignas(ALIGNMENT) unsigned char data[];
};

/* What stays with the process; blocks from 2 MB on never do, which would leave
 * gaps of their size. */
enum { KEPT = 32 << 20, APART = 2 << 20 };

void ph_memory_keep(void) {
#ifdef M_TRIM_THRESHOLD
  mallopt(M_MMAP_THRESHOLD, APART);
  mallopt(M_TRIM_THRESHOLD, KEPT);
#endif
}

/* Blocks from 8 MB on hold enough whole pages of the usual 2 MB. */
enum { HUGE_PAGE = 2 << 20, HUGE_BLOCK = 8 << 20 };

/* Advice that the system may ignore: no failure. */
static void *advise(void *memory, size_t size) {
#ifdef MADV_HUGEPAGE
  if (memory && size >= HUGE_BLOCK) {
    uintptr_t start = (uintptr_t)memory;
    uintptr_t first = (start + HUGE_PAGE - 1) / HUGE_PAGE * HUGE_PAGE;
    madvise((void *)first, start + size - first, MADV_HUGEPAGE);
  }
#else
  (void)size;
#endif
  return memory;
}

void *ph_malloc(size_t size) {
  return fails() ? NULL : advise(malloc(size ? size : 1), size);
}

void *ph_realloc(void *old, size_t size) {
  /* No advice here: a block with advice can not grow in its place. */
  return fails() ? NULL : realloc(old, size ? size : 1);
}

void ph_free(void *memory) {
  free(memory);
}

static struct ph_chunk *add_chunk(struct ph_arena *arena, size_t need) {
  size_t size = arena->chunks ? 2 * arena->chunks->size : CHUNK_MIN;
  struct ph_chunk *chunk;
  if (size > CHUNK_MAX) {
    size = CHUNK_MAX;
  }
  if (size < need) {
    size = need;
  }
  if (size > SIZE_MAX - sizeof *chunk) {
    return NULL;
  }
  chunk = ph_malloc(sizeof *chunk + size);
  if (chunk) {
    chunk->older = arena->chunks;
    chunk->size = size;
    chunk->used = 0;
    arena->chunks = chunk;
  }
  return chunk;
}

static double clock_now(void) {
  struct timespec now;
  clock_gettime(CLOCK_MONOTONIC, &now);
  return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

void ph_budget_start(struct ph_budget *budget, size_t bytes, double seconds) {
  budget->bytes = bytes;
  budget->needed = 0;
  budget->seconds = seconds;
  budget->end = seconds > 0 ? clock_now() + seconds : 0;
  budget->late = false;
  budget->apart = 0;
}

void ph_budget_stop(struct ph_budget *budget) {
  budget->bytes = 0;
  budget->seconds = 0;
}

struct ph_arena ph_arena_beside(const struct ph_arena *arena) {
  return (struct ph_arena){.budget = arena->budget};
}

bool ph_arena_late(const struct ph_arena *arena) {
  struct ph_budget *b = arena->budget;
  if (!b || !(b->seconds > 0)) {
    return false;
  }
  b->late = b->late || clock_now() >= b->end || jumps();
  return b->late;
}

/* What a budget has left. */
static size_t left(const struct ph_budget *b) {
  return !b->bytes ? SIZE_MAX : b->used < b->bytes ? b->bytes - b->used : 0;
}

size_t ph_arena_left(const struct ph_arena *arena) {
  return arena->budget ? left(arena->budget) : SIZE_MAX;
}

/* Takes bytes from the budget; false: it is spent. */
static bool spend(struct ph_arena *arena, size_t bytes) {
  struct ph_budget *b = arena->budget;
  if (!b) {
    return true;
  }
  if (ph_arena_late(arena)) {
    return false;
  }
  if (b->bytes && (b->needed || bytes > left(b))) {
    b->needed = b->needed                    ? b->needed
                : bytes > SIZE_MAX - b->used ? SIZE_MAX
                                             : b->used + bytes;
    return false;
  }
  b->used += bytes;
  arena->taken += bytes;
  return true;
}

/* Gives back what was taken beyond so many bytes. */
static void refund(struct ph_arena *arena, size_t taken) {
  if (arena->budget) {
    arena->budget->used -= arena->taken - taken;
    arena->taken = taken;
  }
}

void ph_account_begin(struct ph_account *account,
                      const struct ph_arena *arena) {
  struct ph_budget *whole = arena->budget;
  *account = (struct ph_account){.whole = whole};
  if (whole) {
    const size_t rest = left(whole);
    account->arena.budget = &account->budget;
    account->budget.bytes = !whole->bytes ? 0 : rest ? rest : 1;
    account->budget.seconds = whole->seconds;
    account->budget.end = whole->end;
  }
}

bool ph_account_done(struct ph_account *account) {
  const size_t taken = account->arena.taken;
  return !account->whole ||
         atomic_fetch_add(&account->whole->apart, taken) + taken <=
             left(account->whole);
}

bool ph_account_end(struct ph_account *account) {
  const struct ph_budget *own = &account->budget;
  struct ph_budget *whole = account->whole;
  const size_t taken = account->arena.taken;
  if (!whole) {
    return true;
  }
  atomic_fetch_sub(&whole->apart, taken);
  whole->late = whole->late || own->late;
  account->arena.budget = whole;
  account->arena.taken = 0;
  return spend(&account->arena, own->needed ? own->needed : taken) &&
         !own->needed;
}

void *ph_arena_array(struct ph_arena *arena, size_t n, size_t size) {
  struct ph_chunk *chunk = arena->chunks;
  size_t need;
  void *memory;
  if (size && n > (SIZE_MAX - ALIGNMENT) / size) {
    return NULL;
  }
  need = (n * size + ALIGNMENT - 1) / ALIGNMENT * ALIGNMENT;
  if (!spend(arena, need)) {
    return NULL;
  }
  if (!chunk || need > chunk->size - chunk->used) {
    chunk = add_chunk(arena, need);
    if (!chunk) {
      return NULL;
    }
  }
  memory = chunk->data + chunk->used;
  chunk->used += need;
  return memory;
}

void *ph_arena_grow(struct ph_arena *arena, void *array, size_t n, size_t size,
                    size_t least, size_t *room) {
  size_t more = *room > 0 ? 2 * *room : least;
  void *grown;
  if (n < *room) {
    return array;
  }
  grown = ph_arena_array(arena, more, size);
  if (grown) {
    if (n > 0) {
      memcpy(grown, array, n * size);
    }
    *room = more;
  }
  return grown;
}

char *ph_arena_copy(struct ph_arena *arena, const char *text, size_t n) {
  char *copy = n < SIZE_MAX ? ph_arena_array(arena, n + 1, 1) : NULL;
  if (copy) {
    if (n) {
      memcpy(copy, text, n);
    }
    copy[n] = '\0';
  }
  return copy;
}

struct ph_mark ph_arena_mark(const struct ph_arena *arena) {
  struct ph_mark mark = {arena->chunks, arena->chunks ? arena->chunks->used : 0,
                         arena->taken};
  return mark;
}

static void drop_chunk(struct ph_arena *arena) {
  struct ph_chunk *chunk = arena->chunks;
  arena->chunks = chunk->older;
  ph_free(chunk);
}

void ph_arena_release(struct ph_arena *arena, struct ph_mark mark) {
  if (!mark.chunk) {
    ph_arena_reset(arena);
    return;
  }
  refund(arena, mark.taken);
  while (arena->chunks != mark.chunk) {
    drop_chunk(arena);
  }
  arena->chunks->used = mark.used;
}

void ph_arena_reset(struct ph_arena *arena) {
  struct ph_chunk *keep = NULL;
  refund(arena, 0);
  while (arena->chunks) {
    struct ph_chunk *chunk = arena->chunks;
    if (chunk->size <= CHUNK_MAX && (!keep || chunk->size > keep->size)) {
      arena->chunks = chunk->older;
      ph_free(keep);
      keep = chunk;
      keep->older = NULL;
      keep->used = 0;
    } else {
      drop_chunk(arena);
    }
  }
  arena->chunks = keep;
}

void ph_arena_free(struct ph_arena *arena) {
  refund(arena, 0);
  while (arena->chunks) {
    drop_chunk(arena);
  }
}
