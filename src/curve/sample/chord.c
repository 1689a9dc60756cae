/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Places by the error of chords (see curve/sample/chord.h). */
#include "curve/sample/chord.h"

/*
 * A block of no more than COARSE chords is not halved, nor one that came of a
 * halving that saved less than 7 % of the chords.  Two halvings are
 * made in any case: where a segment bends most in the middle, both halves are
 * as bad as the whole.  Next to each other, blocks of MANY chords have their
 * own steps.
 */
enum { HALVINGS_MAX = 44, HALVINGS_LEAST = 2, ROOM = 64 };
static const double COARSE = 2, MANY = 16;
static const double SAVED = 0.93;
static const double ALONE = -1;

/* M is known to rounding. */
static const double ROUNDING = 1e-12;

struct ph_chord_block {
  double from, to;
  double count; /* of chords, x; ALONE: it is one chord, as it is short */
};

struct task {
  struct ph_chords *chords;
  const struct ph_sampler *sampler;
  double error;
  size_t most;
  struct ph_diag *diag;
};

/* A place, and the length up to it. */
struct end {
  double u, s;
};

static struct end end_at(const struct task *task, double u) {
  double speed;
  struct end end = {u, ph_sampler_length(task->sampler, u, &speed)};
  return end;
}

static double count_of(const struct task *task, double from, double to) {
  double m = ph_sampler_chord_bound(task->sampler, from, to);
  double count = (to - from) * sqrt(m / task->error / 8);
  return count >= 0 ? count : (double)INFINITY;
}

static enum ph_status too_large(const struct task *task) {
  return ph_fail(task->diag, PH_E_LIMIT, NULL,
                 "chords within %g of the curve take more samples than the "
                 "%zu of --max-samples",
                 task->error, task->most);
}

/* ---- blocks -------------------------------------------------------------- */

static enum ph_status keep(struct task *task, double from, double to,
                           double count) {
  struct ph_chords *c = task->chords;
  if (c->blocks_n >= task->most) {
    return too_large(task);
  }
  c->blocks = ph_arena_grow(c->arena, c->blocks, c->blocks_n, sizeof *c->blocks,
                            ROOM, &c->blocks_room);
  if (!c->blocks) {
    return ph_fail_memory(task->diag);
  }
  c->blocks[c->blocks_n++] = (struct ph_chord_block){from, to, count};
  return PH_OK;
}

/* Halves [from,to], of so many chords, as long as that saves some. */
static enum ph_status halve(struct task *task, struct end from, struct end to,
                            double count, int depth, bool idle) {
  struct end middle;
  double left, right;
  enum ph_status status;
  if (count > 1 && to.s - from.s <= 2 * task->error) {
    return keep(task, from.u, to.u, ALONE);
  }
  if (count <= COARSE || (idle && depth >= HALVINGS_LEAST)) {
    return keep(task, from.u, to.u, count);
  }
  if (depth == HALVINGS_MAX) {
    return ph_fail(task->diag, PH_E_NO_CONVERGENCE, NULL,
                   "segment %zu has no bound of its chords near %.6g of its "
                   "interval",
                   task->sampler->k, from.u);
  }
  middle = end_at(task, 0.5 * (from.u + to.u));
  left = count_of(task, from.u, middle.u);
  right = count_of(task, middle.u, to.u);
  idle = isfinite(count) && left + right > SAVED * count;
  status = halve(task, from, middle, left, depth + 1, idle);
  return status == PH_OK ? halve(task, middle, to, right, depth + 1, idle)
                         : status;
}

/* ---- places -------------------------------------------------------------- */

static enum ph_status add(struct task *task, double u) {
  struct ph_chords *c = task->chords;
  if (c->n >= task->most) {
    return too_large(task);
  }
  c->u = ph_arena_grow(c->arena, c->u, c->n, sizeof *c->u, ROOM, &c->room);
  if (!c->u) {
    return ph_fail_memory(task->diag);
  }
  c->u[c->n++] = u;
  return PH_OK;
}

/* Whether the chord of [from,to] is near the curve. */
static bool is_near(const struct task *task, double from, double to) {
  return count_of(task, from, to) <= 1 + ROUNDING ||
         end_at(task, to).s - end_at(task, from).s <= 2 * task->error;
}

/* The chord from `from` in one block to `to` in a later one: as one, or with a
 * joint of blocks between, the one nearest the middle. */
static enum ph_status cross(struct task *task, double from, size_t first,
                            double to, size_t last) {
  const struct ph_chord_block *blocks = task->chords->blocks;
  size_t joint = first;
  enum ph_status status;
  if (first == last || is_near(task, from, to)) {
    return add(task, to);
  }
  for (size_t i = first + 1; i < last; i++) {
    if (fabs(blocks[i].to - 0.5 * (from + to)) <
        fabs(blocks[joint].to - 0.5 * (from + to))) {
      joint = i;
    }
  }
  status = cross(task, from, first, blocks[joint].to, joint);
  return status == PH_OK ? cross(task, blocks[joint].to, joint + 1, to, last)
                         : status;
}

/* Where the sum of counts from the start of block `i` is `part` or less. */
static double place_in(const struct ph_chord_block *b, double part) {
  double share = b->count > 0 ? fmin(part / b->count, 1) : 1;
  return share < 1 ? b->from + (b->to - b->from) * share : b->to;
}

/* Places in the blocks first .. last - 1, equally spaced by their counts. */
static enum ph_status spread(struct task *task, size_t first, size_t last) {
  const struct ph_chord_block *b = task->chords->blocks;
  double whole = 0, n, before = 0, at = b[first].from;
  size_t here = first, now = first;
  enum ph_status status = PH_OK;
  for (size_t i = first; i < last; i++) {
    whole += b[i].count;
  }
  n = fmax(ceil(whole * (1 - ROUNDING)), 1);
  if (!(n <= (double)task->most)) {
    return too_large(task);
  }
  for (size_t m = 1; status == PH_OK && m <= (size_t)n; m++) {
    double part = (double)m / n * whole, u;
    while (now + 1 < last && (m == (size_t)n || part > before + b[now].count)) {
      before += b[now].count;
      now++;
    }
    while (here < now && !(at < b[here].to)) {
      here++;
    }
    u = m < (size_t)n ? place_in(&b[now], part - before) : b[now].to;
    status = u > at ? cross(task, at, here, u, now) : PH_OK;
    at = u;
  }
  return status;
}

/* Whether equal spacing goes on from one block to the next. */
static bool goes_on(const struct ph_chord_block *block,
                    const struct ph_chord_block *next) {
  return next->count >= 0 && !(block->count > MANY && next->count > MANY);
}

/* Places after `from` up to `to`. */
static enum ph_status plan(struct task *task, double from, double to) {
  const struct ph_chords *c = task->chords;
  size_t first = 0;
  enum ph_status status;
  task->chords->blocks_n = 0;
  status = halve(task, end_at(task, from), end_at(task, to),
                 count_of(task, from, to), 0, false);
  for (size_t i = 0; status == PH_OK && i < c->blocks_n; i++) {
    if (c->blocks[i].count < 0) {
      status = add(task, c->blocks[i].to);
      first = i + 1;
    } else if (i + 1 == c->blocks_n ||
               !goes_on(&c->blocks[i], &c->blocks[i + 1])) {
      status = spread(task, first, i + 1);
      first = i + 1;
    }
  }
  return status;
}

enum ph_status ph_chords_plan(struct ph_chords *chords,
                              const struct ph_sampler *sampler, double error,
                              const struct ph_place *stops, size_t stops_n,
                              size_t most, struct ph_diag *diag) {
  struct task task = {chords, sampler, error, most, diag};
  enum ph_status status = PH_OK;
  double from = 0;
  chords->n = 0;
  for (size_t i = 0; status == PH_OK && i <= stops_n; i++) {
    double to = i < stops_n ? stops[i].u : 1;
    if (to > from) {
      status = plan(&task, from, to);
      from = to;
    }
  }
  return status;
}
