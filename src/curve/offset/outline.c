/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Outlines of offsets (see outline.h). */
#include "curve/offset/outline.h"

#include "curve/offset/part.h"
#include "base/sum.h"

#include <stdlib.h>

#include <string.h>

/* Of the size: ends of parts that are as near are at one place; what is nearer
 * than that is not told apart; chains that are no longer are none, nor are
 * parts along a touch that lead nowhere. */
static const double NEAR = 1e-9, SAME = 1e-11, SHORT = 1e-8, SPUR = 1e-6;

/* Tangents whose sine is less do not tell where lines along them meet. */
static const double PARALLEL = 1e-3;

/* Ends that others may follow, and starts. */
enum { ROOM = 64 };

/* A kept part that may follow another one. */
struct match {
  size_t from, to;
  double gap, turn;
};

struct linker {
  const struct ph_strands *strands;
  struct ph_part_list *parts;
  size_t *starts;
  size_t starts_n;
  struct match *matches;
  size_t matches_n, room;
  struct ph_strand_eval eval;
  struct ph_diag *diag;
};

/* ---- which part follows which ---------------------------------------------
 */

/* Keeps what goes on along its arcs. */
static void keep_links(struct linker *l) {
  struct ph_part *v = l->parts->v;
  for (size_t k = 0; k < l->parts->n; k++) {
    v[k].follows = false;
  }
  for (size_t k = 0; k < l->parts->n; k++) {
    if (v[k].kept && v[k].next != PH_NO_STRAND && v[v[k].next].kept) {
      v[v[k].next].follows = true;
    } else {
      v[k].next = PH_NO_STRAND;
    }
  }
}

static double start_x(const struct linker *l, size_t k) {
  return l->parts->v[k].of.end[0].o.re;
}

/* Starts in order of x, by merging. */
static void sort_starts(const struct linker *l, size_t *v, size_t n,
                        size_t *scratch) {
  const size_t half = n / 2;
  size_t i = 0, j = half;
  if (n < 2) {
    return;
  }
  sort_starts(l, v, half, scratch);
  sort_starts(l, v + half, n - half, scratch);
  for (size_t k = 0; k < n; k++) {
    scratch[k] = j == n || (i < half && start_x(l, v[i]) <= start_x(l, v[j]))
                     ? v[i++]
                     : v[j++];
  }
  memcpy(v, scratch, n * sizeof *v);
}

static enum ph_status add_match(struct linker *l, size_t from, size_t to) {
  const struct ph_spot *a = &l->parts->v[from].of.end[1];
  const struct ph_spot *b = &l->parts->v[to].of.end[0];
  const double gap = ph_cplx_abs(ph_cplx_sub(b->o, a->o));
  struct match *m;
  if (!(gap <= NEAR * l->strands->size)) {
    return PH_OK;
  }
  l->matches = ph_arena_grow(l->strands->arena, l->matches, l->matches_n,
                             sizeof *l->matches, ROOM, &l->room);
  if (!l->matches) {
    return ph_fail_memory(l->diag);
  }
  m = &l->matches[l->matches_n++];
  *m = (struct match){from, to, gap > SAME * l->strands->size ? gap : 0,
                      ph_spot_angle(a, b)};
  return PH_OK;
}

/* All starts that are where an end is. */
static enum ph_status match_end(struct linker *l, size_t from) {
  const double x = l->parts->v[from].of.end[1].o.re;
  const double near = NEAR * l->strands->size;
  size_t low = 0, high = l->starts_n;
  enum ph_status status = PH_OK;
  while (low < high) {
    const size_t middle = low + (high - low) / 2;
    if (start_x(l, l->starts[middle]) < x - near) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  for (size_t i = low; status == PH_OK && i < l->starts_n &&
                       start_x(l, l->starts[i]) <= x + near;
       i++) {
    status = add_match(l, from, l->starts[i]);
  }
  return status;
}

/* The nearest first; of those at one place the sharpest turn to the left, where
 * the inside is. */
static int compare(const void *a, const void *b) {
  const struct match *p = a, *q = b;
  const int gap = (p->gap > q->gap) - (p->gap < q->gap);
  const int turn = (p->turn < q->turn) - (p->turn > q->turn);
  return gap ? gap : turn ? turn : (p->from > q->from) - (p->from < q->from);
}

static enum ph_status link_parts(struct linker *l) {
  struct ph_part *v = l->parts->v;
  const size_t n = l->parts->n;
  size_t *scratch =
      ph_arena_array(l->strands->arena, 2 * n + 2, sizeof *scratch);
  enum ph_status status = PH_OK;
  if (!scratch) {
    return ph_fail_memory(l->diag);
  }
  keep_links(l);
  l->starts = scratch + n + 1;
  for (size_t k = 0; k < n; k++) {
    if (v[k].kept && !v[k].follows) {
      l->starts[l->starts_n++] = k;
    }
  }
  sort_starts(l, l->starts, l->starts_n, scratch);
  for (size_t k = 0; status == PH_OK && k < n; k++) {
    if (v[k].kept && v[k].next == PH_NO_STRAND) {
      status = match_end(l, k);
    }
  }
  if (l->matches_n) {
    qsort(l->matches, l->matches_n, sizeof *l->matches, compare);
  }
  for (size_t i = 0; i < l->matches_n; i++) {
    const struct match *m = &l->matches[i];
    if (v[m->from].next == PH_NO_STRAND && !v[m->to].follows) {
      v[m->from].next = m->to;
      v[m->to].follows = true;
    }
  }
  return status;
}

/* ---- where they meet ------------------------------------------------------
 */

/* Moves an end of a span along its strand, by a length; false: the strand ends
 * before, or so does the span. */
static bool move_end(struct linker *l, struct ph_span *span, size_t which,
                     double by) {
  const double d = l->strands->distance, sign = which ? 1 : -1;
  const struct ph_spot old = span->end[which];
  const double u = span->u[which] + by / old.rate;
  if (!(u >= 0 && u <= 1 && (which ? u > span->u[0] : u < span->u[1]))) {
    return false;
  }
  ph_strand_enter(&l->eval, l->strands, span->strand);
  span->u[which] = u;
  span->end[which] = ph_strand_spot(&l->eval, u);
  span->length += sign * ph_spot_length(d, &old, &span->end[which]);
  span->turn += sign * ph_spot_turn(&old, &span->end[which]);
  return true;
}

static double gap_of(const struct ph_span *a, const struct ph_span *b) {
  return ph_cplx_abs(ph_cplx_sub(b->end[0].o, a->end[1].o));
}

/* Spans that touch end where the search did, which may be anywhere along the
 * touch.  There the one goes on to where the other begins, or begins where the
 * one ends; false: both are shorter than what they have in common. */
static bool meet(struct linker *l, struct ph_span *a, struct ph_span *b) {
  const ph_cplx apart = ph_cplx_sub(b->end[0].o, a->end[1].o);
  const ph_cplx t[2] = {ph_spot_tangent(&a->end[1]),
                        ph_spot_tangent(&b->end[0])};
  const double along = ph_cplx_dot(apart, t[0]);
  if (!(gap_of(a, b) > SAME * l->strands->size) || !(a->length > 0) ||
      !(b->length > 0) ||
      !(fabs(ph_cplx_cross(t[0], t[1])) < PARALLEL &&
        ph_cplx_dot(t[0], t[1]) > 0)) {
    return true;
  }
  return move_end(l, a, 1, along) ||
         move_end(l, b, 0, -ph_cplx_dot(apart, t[1])) || along > 0;
}

/* All spans of a chain; those that are lost are left out.  ret  how many */
static size_t meet_all(struct linker *l, struct ph_span *v, size_t n,
                       bool closed) {
  for (size_t i = 0; n > 2 && i + !closed < n;) {
    const size_t j = (i + 1) % n;
    if (meet(l, &v[i], &v[j])) {
      i++;
    } else {
      const size_t lost = v[i].length < v[j].length ? i : j;
      n--;
      memmove(v + lost, v + lost + 1, (n - lost) * sizeof *v);
      i -= i > 0;
    }
  }
  return n;
}

/* ---- chains ---------------------------------------------------------------
 */

/* One on a strand that goes on where another one ends is part of it. */
static void add_span(struct ph_outline *out, size_t first,
                     const struct ph_span *span) {
  struct ph_span *last =
      out->spans_n > first ? &out->spans[out->spans_n - 1] : NULL;
  if (last && last->strand == span->strand &&
      !(fabs(span->u[0] - last->u[1]) > 0) && last->length * span->length > 0 &&
      fabs(last->turn + span->turn) < PH_SPAN_TURN) {
    last->u[1] = span->u[1];
    last->end[1] = span->end[1];
    last->length += span->length;
    last->turn += span->turn;
  } else {
    out->spans[out->spans_n++] = *span;
  }
}

/* The place of the curve that a part begins beside. */
static double begin_of(const struct ph_strands *strands,
                       const struct ph_span *span) {
  double u;
  const size_t k = ph_strand_foot(strands, span->strand, span->u[0], &u);
  return (double)k + u;
}

/* The chain that a part belongs to, from its beginning on. */
static void follow(struct linker *l, size_t at, bool open,
                   struct ph_outline *out) {
  struct ph_part *v = l->parts->v;
  struct ph_chain *chain = &out->chains[out->chains_n];
  double length = 0, least;
  size_t first = at, k = at;
  *chain = (struct ph_chain){.first = out->spans_n};
  do { /* where it begins */
    const double a = begin_of(l->strands, &v[k].of);
    first = v[at].follows && a < begin_of(l->strands, &v[first].of) ? k : first;
    k = v[k].next;
  } while (k != PH_NO_STRAND && k != at);
  chain->closed = k == at;
  chain->begin = begin_of(l->strands, &v[first].of);
  k = first;
  do {
    const size_t next = v[k].next;
    add_span(out, chain->first, &v[k].of);
    v[k].kept = false;
    k = next;
  } while (k != PH_NO_STRAND && k != first);
  chain->n = meet_all(l, out->spans + chain->first, out->spans_n - chain->first,
                      chain->closed);
  out->spans_n = chain->first + chain->n;
  for (size_t i = 0; i < chain->n; i++) {
    const struct ph_span *span = &out->spans[chain->first + i];
    length += fabs(span->length);
    if (i + !chain->closed < chain->n) {
      out->gap =
          fmax(out->gap,
               gap_of(span, &out->spans[chain->first + (i + 1) % chain->n]));
    }
  }
  least = chain->closed || open ? SHORT : SPUR;
  if (length > least * l->strands->size) {
    out->length += length;
    out->chains_n++;
  } else {
    out->spans_n = chain->first;
  }
}

static int compare_chains(const void *a, const void *b) {
  const struct ph_chain *p = a, *q = b;
  return p->begin < q->begin   ? -1
         : p->begin > q->begin ? 1
                               : (p->first > q->first) - (p->first < q->first);
}

/* Open chains from their first parts on, then loops. */
static enum ph_status collect(struct linker *l, bool open,
                              struct ph_outline *out) {
  const struct ph_part *v = l->parts->v;
  for (int round = 0; round < 2; round++) {
    for (size_t k = 0; k < l->parts->n; k++) {
      if (v[k].kept && (round || !v[k].follows)) {
        const size_t chains = out->chains_n;
        const ph_cplx at = v[k].of.end[0].o;
        follow(l, k, open, out);
        if (out->chains_n > chains && !out->chains[chains].closed && !open) {
          return ph_strands_fail(l->strands, at, "it does not close", l->diag);
        }
      }
    }
  }
  if (out->chains_n) {
    qsort(out->chains, out->chains_n, sizeof *out->chains, compare_chains);
  }
  return PH_OK;
}

enum ph_status ph_outline_of(const struct ph_strands *strands,
                             const struct ph_offset_rules *rules, bool open,
                             struct ph_outline *outline, struct ph_diag *diag) {
  const bool trim = rules->mode == PH_OFFSET_TRIMMED;
  struct ph_arcs arcs;
  struct ph_crossings crossings = {.breaks = NULL};
  struct ph_part_list parts;
  struct linker linker = {.strands = strands, .parts = &parts, .diag = diag};
  enum ph_status status = ph_arcs_of(strands, trim, &arcs, diag);
  double whole = 0;
  *outline = (struct ph_outline){.spans = NULL};
  if (status == PH_OK && trim) {
    status = ph_crossings_of(strands, &arcs, &crossings, diag);
  }
  if (status == PH_OK) {
    status = ph_parts_cut(strands, &arcs, &crossings, &parts, diag);
  }
  if (status != PH_OK) {
    return status;
  }
  for (size_t k = 0; k < parts.n; k++) {
    whole += fabs(parts.v[k].of.length);
    parts.v[k].kept = true;
  }
  if (trim) {
    status =
        ph_parts_judge(strands, &arcs, &crossings, rules->keep, &parts, diag);
  }
  outline->spans =
      ph_arena_array(strands->arena, parts.n + 1, sizeof *outline->spans);
  outline->chains =
      ph_arena_array(strands->arena, parts.n + 1, sizeof *outline->chains);
  if (!outline->spans || !outline->chains) {
    return ph_fail_memory(diag);
  }
  if (status == PH_OK) {
    status = link_parts(&linker);
  }
  if (status == PH_OK) {
    status = collect(&linker, open || !trim, outline);
  }
  outline->crossings = crossings.points;
  outline->touches = crossings.touches;
  outline->removed = whole - outline->length;
  return status;
}
