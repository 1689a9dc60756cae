/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Parts of arcs, cut and judged (see part.h). */
#include "curve/offset/part.h"

#include "curve/fair/enclosed.h"
#include "curve/offset/clear.h"

#include <stdlib.h>
#include <string.h>

/* Of the size: places of a shorter run need not agree, as the one curve is
 * further from them than the other by rounding. */
static const double SHORT = 1e-6;

/* Of the size: what is within a miter by less, is not. */
static const double NEAR = 1e-9;

enum { PLACES = 3 };

enum ph_status ph_strands_fail(const struct ph_strands *strands, ph_cplx at,
                               const char *what, struct ph_diag *diag) {
  const struct ph_pow2 unit = ph_pow2_of(strands->exponent);
  return ph_fail(diag, PH_E_NO_CONVERGENCE, NULL,
                 "the trimmed offset at distance %.6g was not found: near "
                 "(%.6g, %.6g) %s",
                 ph_pow2_apply(unit, strands->distance),
                 strands->center.re + ph_pow2_apply(unit, at.re),
                 strands->center.im + ph_pow2_apply(unit, at.im), what);
}

/* ---- cuts -----------------------------------------------------------------
 */

struct cutter {
  const struct ph_strands *strands;
  const struct ph_arcs *arcs;
  const struct ph_break *at, *end; /* breaks */
  struct ph_strand_eval eval;
  struct ph_part_list *parts;
  size_t *first; /* [arcs] the part that an arc begins with */
  bool *begun;   /* [arcs] others meet it there */
};

static void add(struct cutter *c, size_t arc, double u0,
                const struct ph_spot *a, double u1, const struct ph_spot *b,
                bool cut) {
  struct ph_part *part = &c->parts->v[c->parts->n++];
  const struct ph_bit *bit = &c->arcs->v[arc].bit;
  const bool whole = !(u0 > bit->u[0]) && !(u1 < bit->u[1]);
  const double turn = whole ? bit->turn : ph_spot_turn(a, b);
  *part = (struct ph_part){.arc = arc,
                           .of = {c->arcs->v[arc].strand,
                                  {u0, u1},
                                  {*a, *b},
                                  b->s - a->s - c->strands->distance * turn,
                                  turn},
                           .next = c->parts->n,
                           .cut = cut};
}

/* The parts of one arc; a cut that is no distance from the one before, or from
 * an end, is there. */
static void cut_arc(struct cutter *c, size_t i) {
  const struct ph_arc *arc = &c->arcs->v[i];
  const double least = PH_ARC_LEAST * c->strands->size;
  const double d = c->strands->distance;
  struct ph_spot from = arc->bit.end[0];
  const struct ph_spot *end = &arc->bit.end[1];
  double u = arc->bit.u[0];
  bool at_end = false;
  c->first[i] = c->parts->n;
  for (; c->at < c->end && c->at->arc == i; c->at++) {
    const double to = c->at->u;
    struct ph_spot spot;
    ph_strand_enter(&c->eval, c->strands, arc->strand);
    spot = ph_strand_spot(&c->eval, to);
    if (!(fabs(ph_spot_length(d, &from, &spot)) > least)) {
      c->begun[i] |= c->first[i] == c->parts->n;
    } else if (!(fabs(ph_spot_length(d, &spot, end)) > least)) {
      at_end = true;
    } else {
      add(c, i, u, &from, to, &spot, true);
      u = to;
      from = spot;
    }
  }
  add(c, i, u, &from, arc->bit.u[1], end, at_end);
}

/* What follows what. */
static void link_parts(struct cutter *c) {
  struct ph_part *v = c->parts->v;
  for (size_t k = 0; k < c->parts->n; k++) {
    const size_t next = c->arcs->v[v[k].arc].next;
    if (k == c->first[v[k].arc]) {
      v[k].begun = c->begun[v[k].arc];
    }
    if (k + 1 == c->parts->n || v[k + 1].arc != v[k].arc) {
      v[k].next = next == PH_NO_STRAND ? next : c->first[next];
    }
    if (v[k].next != PH_NO_STRAND) {
      v[v[k].next].follows = true;
    }
  }
  for (size_t k = 0; k < c->parts->n; k++) {
    if (v[k].next != PH_NO_STRAND) {
      struct ph_part *next = &v[v[k].next];
      v[k].cut |= next->begun;
      next->begun |= v[k].cut;
    }
  }
}

enum ph_status ph_parts_cut(const struct ph_strands *strands,
                            const struct ph_arcs *arcs,
                            const struct ph_crossings *crossings,
                            struct ph_part_list *parts, struct ph_diag *diag) {
  const size_t n = arcs->n, breaks = crossings->breaks_n;
  struct cutter c = {.strands = strands, .arcs = arcs, .parts = parts};
  c.at = crossings->breaks;
  c.end = breaks ? c.at + breaks : c.at;
  parts->n = 0;
  parts->v = ph_arena_array(strands->arena, n + breaks + 1, sizeof *parts->v);
  c.first = ph_arena_array(strands->arena, n + 1, sizeof *c.first);
  c.begun = ph_arena_array(strands->arena, n + 1, sizeof *c.begun);
  if (!parts->v || !c.first || !c.begun) {
    return ph_fail_memory(diag);
  }
  for (size_t i = 0; i < n; i++) {
    c.begun[i] = false;
    c.first[i] = PH_NO_STRAND;
    if (strands->v[arcs->v[i].strand].passive) {
      while (c.at < c.end && c.at->arc == i) {
        c.at++;
      }
    } else {
      cut_arc(&c, i);
    }
  }
  link_parts(&c);
  return PH_OK;
}

/* ---- judgement ------------------------------------------------------------
 */

struct judge {
  const struct ph_strands *strands;
  const struct ph_arcs *arcs;
  struct ph_part_list *parts;
  struct ph_clear clear;
  struct ph_strand_eval eval;
  size_t *kites; /* strands that begin a miter */
  size_t kites_n;
  bool *judged; /* [parts] */
};

/* Whether the end of a part, or its start, is where nothing goes on, but is no
 * end of an open curve. */
static bool is_dead(const struct judge *j, const struct ph_part *part) {
  const struct ph_strand *s = &j->strands->v[part->of.strand];
  const bool last = s->kind == PH_STRAND_SEGMENT && s->at + 1 == j->strands->n;
  return part->next == PH_NO_STRAND && !part->cut &&
         !(last && !(part->of.u[1] < 1) && !j->strands->curve.closed &&
           !j->strands->both);
}

static bool is_born_dead(const struct judge *j, const struct ph_part *part) {
  return !part->follows && !part->begun &&
         !(part->of.strand == 0 && !(part->of.u[0] > 0) &&
           !j->strands->curve.closed && !j->strands->both);
}

/* Whether a place is within a miter: the corner, both ends, and the tip. */
static bool is_in_miter(const struct judge *j, ph_cplx at) {
  const double near = NEAR * j->strands->size;
  const double side = j->strands->distance > 0 ? -1 : 1;
  for (size_t i = 0; i < j->kites_n; i++) {
    const struct ph_strand *s = &j->strands->v[j->kites[i]];
    const ph_cplx p[5] = {s->point, s[0].line[0], s[0].line[1], s[1].line[1],
                          s->point};
    bool inside = true;
    for (size_t k = 0; inside && k < 4; k++) {
      const ph_cplx edge = ph_cplx_sub(p[k + 1], p[k]);
      const double across = ph_cplx_cross(edge, ph_cplx_sub(at, p[k]));
      inside = side * across > near * ph_cplx_abs(edge);
    }
    if (inside) {
      return true;
    }
  }
  return false;
}

/* Three places of a part: how many of them keep the distance. */
static int ask(struct judge *j, const struct ph_part *part) {
  const size_t strand = part->of.strand;
  int clear = 0;
  ph_strand_enter(&j->eval, j->strands, strand);
  for (int i = 1; i <= PLACES; i++) {
    const double x = (double)i / (PLACES + 1);
    const double u = part->of.u[0] + x * (part->of.u[1] - part->of.u[0]);
    const struct ph_spot at = ph_strand_spot(&j->eval, u);
    double foot;
    const size_t near = ph_strand_foot(j->strands, strand, u, &foot);
    clear += ph_clear_of(&j->clear, at.o, near) && !is_in_miter(j, at.o);
  }
  return clear;
}

/* Whether a place is on the other side of the curve than what is asked for:
 * within it, or round it. */
static enum ph_status see_side(struct judge *j, ph_cplx at, bool *beyond,
                               struct ph_diag *diag) {
  const struct ph_strands *strands = j->strands;
  const int around = ph_clear_around(&j->clear, at);
  enum ph_status status = PH_OK;
  double area = 0;
  if (around == 0) { /* outside: to the right, if the inside is to the left */
    struct ph_curve given = strands->curve;
    given.n = strands->n;
    status = ph_enclosed_area(&given, strands->arena, &area, diag);
  }
  *beyond = strands->distance * (around == 0 ? -area : around) < 0;
  return status;
}

/* The part that goes on with the run of another one, or none. */
static size_t go_on(const struct judge *j, size_t at) {
  const struct ph_part *part = &j->parts->v[at];
  return part->cut ? PH_NO_STRAND : part->next;
}

static bool is_line(const struct judge *j, const struct ph_part *part) {
  return j->strands->v[part->of.strand].kind == PH_STRAND_LINE;
}

/* The run that begins with a part.  Parts of miters alone may be beyond another
 * part of the curve. */
static enum ph_status judge_run(struct judge *j, size_t first,
                                struct ph_diag *diag) {
  struct ph_part *v = j->parts->v;
  size_t longest = first, at = first, last = first;
  enum ph_status status = PH_OK;
  double length = 0;
  bool kept, beyond = j->strands->has_inside && v[first].begun;
  do {
    last = at;
    j->judged[at] = true;
    beyond = beyond && is_line(j, &v[at]);
    length += fabs(v[at].of.length);
    longest = fabs(v[at].of.length) > fabs(v[longest].of.length) ? at : longest;
    at = go_on(j, at);
  } while (at != PH_NO_STRAND && at != first);
  kept = at == first || !(is_dead(j, &v[last]) || is_born_dead(j, &v[first]));
  if (kept) {
    const int clear = ask(j, &v[longest]);
    kept = clear == PLACES;
    if (clear > 0 && !kept && length > SHORT * j->strands->size) {
      return ph_strands_fail(j->strands, v[longest].of.end[0].o,
                             "places of a part disagree", diag);
    }
  }
  if (kept && beyond && v[last].cut) { /* no part of it is beside the curve */
    status = see_side(j, v[longest].of.end[1].o, &beyond, diag);
    kept = !beyond;
  }
  at = first;
  do {
    v[at].kept = kept;
    at = go_on(j, at);
  } while (at != PH_NO_STRAND && at != first);
  return status;
}

/* The part of an arc that a place is in. */
static const struct ph_part *part_at(const struct judge *j, size_t arc,
                                     double u) {
  const struct ph_part *v = j->parts->v;
  size_t low = 0, high = j->parts->n;
  while (low < high) {
    const size_t middle = low + (high - low) / 2;
    if (v[middle].arc < arc ||
        (v[middle].arc == arc && v[middle].of.u[1] < u)) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  return low < j->parts->n && v[low].arc == arc ? &v[low] : &v[low - 1];
}

/* Whether a part runs on another arc that is kept in its place, or against one,
 * with nothing between them. */
static bool is_double(const struct judge *j, const struct ph_overlap *o,
                      const struct ph_part *part, bool keep) {
  const double u = 0.5 * (part->of.u[0] + part->of.u[1]);
  const double x = (u - o->u[0]) / (o->u[1] - o->u[0]);
  const double along = o->opposite ? 1 - x : x;
  const bool passive = j->strands->v[j->arcs->v[o->other].strand].passive;
  if (!(x >= 0 && x <= 1) || passive) {
    return false;
  }
  return (o->opposite && !keep) ||
         (o->arc > o->other &&
          part_at(j, o->other, o->on[0] + along * (o->on[1] - o->on[0]))->kept);
}

static int compare(const void *a, const void *b) {
  const struct ph_overlap *p = a, *q = b;
  return p->arc != q->arc ? (p->arc < q->arc ? -1 : 1)
                          : (p->u[0] > q->u[0]) - (p->u[0] < q->u[0]);
}

static void drop_doubles(const struct judge *j,
                         const struct ph_crossings *crossings, bool keep) {
  const size_t n = crossings->overlaps_n;
  size_t from = 0;
  if (n == 0) {
    return;
  }
  qsort(crossings->overlaps, n, sizeof *crossings->overlaps, compare);
  for (size_t k = 0; k < j->parts->n; k++) {
    struct ph_part *part = &j->parts->v[k];
    while (from < n && crossings->overlaps[from].arc < part->arc) {
      from++;
    }
    for (size_t i = from; i < n && crossings->overlaps[i].arc == part->arc;
         i++) {
      part->kept &= !is_double(j, &crossings->overlaps[i], part, keep);
    }
  }
}

static enum ph_status begin(struct judge *j, struct ph_diag *diag) {
  const struct ph_strands *strands = j->strands;
  const size_t n = j->parts->n + 1;
  enum ph_status status = ph_clear_begin(&j->clear, strands, diag);
  j->judged = ph_arena_array(strands->arena, n, sizeof *j->judged);
  j->kites =
      ph_arena_array(strands->arena, strands->strands_n, sizeof *j->kites);
  if (status != PH_OK || !j->judged || !j->kites) {
    return ph_fail_memory(diag);
  }
  memset(j->judged, 0, n * sizeof *j->judged);
  for (size_t i = 0; i + 1 < strands->strands_n; i++) {
    const struct ph_strand *s = &strands->v[i];
    if (s->kind == PH_STRAND_LINE) {
      j->kites[j->kites_n++] = i++;
    }
  }
  return PH_OK;
}

enum ph_status ph_parts_judge(const struct ph_strands *strands,
                              const struct ph_arcs *arcs,
                              const struct ph_crossings *crossings, bool keep,
                              struct ph_part_list *parts,
                              struct ph_diag *diag) {
  struct judge j = {.strands = strands, .arcs = arcs, .parts = parts};
  enum ph_status status = begin(&j, diag);
  /* First the runs that begin somewhere, then those that go round. */
  for (int round = 0; round < 2; round++) {
    for (size_t k = 0; status == PH_OK && k < parts->n; k++) {
      const struct ph_part *part = &parts->v[k];
      if (!j.judged[k] && (round || part->begun || !part->follows)) {
        status = judge_run(&j, k, diag);
      }
    }
  }
  if (status == PH_OK) {
    drop_doubles(&j, crossings, keep);
  }
  return status;
}
