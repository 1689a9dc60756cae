/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Arcs of strands (see arc.h). */
#include "curve/offset/arc.h"

#include "curve/offset/cusp.h"
#include "curve/segment/seg2.h"

/* Halvings until an arc turns by little: of what the curve stands still in,
 * none suffice.  More room than for strands, at first; places where a segment
 * is cut. */
enum { HALVINGS_MAX = 40, ROOM = 64, CUTS_MAX = 16 };

/* A turn that is less is none. */
static const double SMOOTH = 1e-6;

struct walk {
  const struct ph_strands *strands;
  bool forward;
  struct ph_arcs *arcs;
  size_t room;
  struct ph_strand_eval eval;
  size_t strand;
  size_t before; /* the arc that ends where the next one begins, or none */
  bool smooth;   /* nothing was left out since */
  struct ph_diag *diag;
};

struct ph_bit ph_bit_of(double distance, double u0, const struct ph_spot *a,
                        double u1, const struct ph_spot *b) {
  struct ph_bit bit = {.u = {u0, u1}, .end = {*a, *b}};
  const double chord = ph_cplx_abs(ph_cplx_sub(b->o, a->o));
  bit.turn = ph_spot_turn(a, b);
  bit.length = b->s - a->s - distance * bit.turn;
  bit.length = copysign(fmax(fabs(bit.length), chord), bit.length);
  return bit;
}

/* Whether the second goes on in the direction of the first. */
static bool goes_on(const struct ph_bit *a, const struct ph_bit *b) {
  return a->length * b->length > 0 &&
         fabs(ph_spot_angle(&a->end[1], &b->end[0])) < SMOOTH;
}

/* ---- one part of a strand, between cusps and inflections ------------------
 */

static enum ph_status see(struct walk *walk, const struct ph_bit *bit) {
  struct ph_arcs *arcs = walk->arcs;
  struct ph_arc *arc;
  if (fabs(bit->length) <= PH_ARC_LEAST * walk->strands->size) {
    walk->smooth = false; /* it is a point */
    return PH_OK;
  }
  if (walk->forward && bit->length < 0) {
    walk->before = PH_NO_STRAND;
    return PH_OK;
  }
  arcs->v =
      ph_arena_grow(walk->strands->arena, arcs->v, arcs->n, sizeof *arcs->v,
                    walk->strands->strands_n + ROOM, &walk->room);
  if (!arcs->v) {
    return ph_fail_memory(walk->diag);
  }
  arc = &arcs->v[arcs->n];
  *arc = (struct ph_arc){.strand = walk->strand, .bit = *bit};
  arc->next = PH_NO_STRAND;
  if (walk->before != PH_NO_STRAND) {
    struct ph_arc *before = &arcs->v[walk->before];
    before->next = arcs->n;
    before->smooth = walk->smooth && goes_on(&before->bit, bit);
  }
  walk->before = arcs->n++;
  walk->smooth = true;
  return PH_OK;
}

/* Whether the preimage of a part of a strand stays within a quarter turn. */
static bool is_tame(const struct walk *walk, double u0, double u1) {
  const struct ph_fast3 *fast = &walk->eval.fast;
  struct ph_atph part;
  ph_cplx w[3], v[3];
  if (walk->eval.of->kind != PH_STRAND_SEGMENT) {
    return true;
  }
  for (size_t i = 0; i < 3; i++) {
    w[i] = ph_cplx_of(fast->seg.a[i].u, fast->seg.a[i].q);
  }
  if (!(u0 > 0) && !(u1 < 1)) {
    return ph_seg2_is_monotone(w);
  }
  ph_atph_part(&fast->seg.space, w, u0, u1, &part, v);
  return ph_seg2_is_monotone(v);
}

static enum ph_status split(struct walk *walk, const struct ph_bit *bit,
                            int depth) {
  enum ph_status status;
  struct ph_spot middle;
  struct ph_bit half;
  double u;
  if (fabs(bit->turn) < PH_ARC_TURN && is_tame(walk, bit->u[0], bit->u[1])) {
    return see(walk, bit);
  }
  u = 0.5 * (bit->u[0] + bit->u[1]);
  middle = ph_strand_spot(&walk->eval, u);
  if (depth == HALVINGS_MAX || !isfinite(middle.rate)) {
    return ph_fail_at(walk->diag, PH_E_INFEASIBLE, "segments",
                      walk->eval.of->at % walk->strands->n,
                      "has no offset: the curve stands still in it and has no "
                      "normal there");
  }
  half =
      ph_bit_of(walk->strands->distance, bit->u[0], &bit->end[0], u, &middle);
  status = split(walk, &half, depth + 1);
  if (status == PH_OK) {
    half =
        ph_bit_of(walk->strands->distance, u, &middle, bit->u[1], &bit->end[1]);
    status = split(walk, &half, depth + 1);
  }
  return status;
}

/* ---- where strands are cut ------------------------------------------------
 */

/* Inflections of a segment, at most two: roots of the form of cusp.c (2) in S0
 * and S1, b0 + 2 b1 t + b2 t^2 with t = S1 : S0, where it changes its sign. */
static size_t inflections(const struct ph_fast3 *fast, double u[2]) {
  const ph_quat *a = fast->seg.a;
  const double c = fast->seg.space.c, half = fast->seg.space.angle / 2;
  const double b0 = c * (a[0].u * a[1].q - a[0].q * a[1].u);
  const double b1 = (a[0].u * a[2].q - a[0].q * a[2].u) / 2;
  const double b2 = c * (a[1].u * a[2].q - a[1].q * a[2].u);
  const double square = b1 * b1 - b0 * b2;
  const double sum = -(b1 + copysign(sqrt(fmax(square, 0)), b1));
  const double root[2] = {sum / b2, b0 / sum};
  size_t n = 0;
  for (size_t i = 0; i < 2 && square > 0; i++) {
    if (root[i] > 0 && root[i] < HUGE_VAL) {
      const double v = root[i] / (1 + root[i]);
      u[n++] =
          half > 0 ? atan2(v * sin(half), 1 - v + v * cos(half)) / half : v;
    }
  }
  return n;
}

/* Inserts a place into an increasing list. */
static size_t insert(double *cuts, size_t n, double u) {
  size_t i = n;
  if (!(u > 0 && u < 1) || n == CUTS_MAX) {
    return n;
  }
  for (; i > 0 && cuts[i - 1] > u; i--) {
    cuts[i] = cuts[i - 1];
  }
  cuts[i] = u;
  return n + 1;
}

static enum ph_status visit(struct walk *walk, const struct ph_cusps *cusps,
                            size_t *cusp) {
  const struct ph_strand *s = &walk->strands->v[walk->strand];
  double cuts[CUTS_MAX + 1], u[2], from = 0;
  size_t n = 0;
  enum ph_status status = PH_OK;
  struct ph_spot a, b;
  ph_strand_enter(&walk->eval, walk->strands, walk->strand);
  if (s->kind == PH_STRAND_SEGMENT) {
    const size_t bends = inflections(&walk->eval.fast, u);
    for (size_t i = 0; i < bends; i++) {
      n = insert(cuts, n, u[i]);
    }
    for (; *cusp < cusps->n && cusps->at[*cusp].segment <= s->at; ++*cusp) {
      if (cusps->at[*cusp].segment == s->at) {
        n = insert(cuts, n, cusps->at[*cusp].u);
      }
    }
  }
  cuts[n++] = 1;
  a = ph_strand_spot(&walk->eval, 0);
  for (size_t i = 0; status == PH_OK && i < n; i++) {
    struct ph_bit bit;
    b = ph_strand_spot(&walk->eval, cuts[i]);
    bit = ph_bit_of(walk->strands->distance, from, &a, cuts[i], &b);
    status = split(walk, &bit, 0);
    from = cuts[i];
    a = b;
  }
  return status;
}

/* ---- all ------------------------------------------------------------------
 */

/* The arc that a strand begins with; NULL: it was left out. */
static const struct ph_arc *first_of(const struct ph_arcs *arcs,
                                     size_t strand) {
  size_t low = 0, high = arcs->n;
  while (low < high) {
    const size_t middle = low + (high - low) / 2;
    if (arcs->v[middle].strand < strand) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  return low < arcs->n && arcs->v[low].strand == strand &&
                 !(arcs->v[low].bit.u[0] > 0)
             ? &arcs->v[low]
             : NULL;
}

/* A chain that is closed goes on where it began. */
static void close_chain(struct walk *walk, size_t strand) {
  const struct ph_arc *to = first_of(walk->arcs, strand);
  if (to && walk->before != PH_NO_STRAND) {
    struct ph_arc *last = &walk->arcs->v[walk->before];
    last->next = (size_t)(to - walk->arcs->v);
    last->smooth = walk->smooth && goes_on(&last->bit, &to->bit);
  }
}

enum ph_status ph_arcs_of(const struct ph_strands *strands, bool forward,
                          struct ph_arcs *arcs, struct ph_diag *diag) {
  struct walk walk = {.strands = strands,
                      .forward = forward,
                      .arcs = arcs,
                      .before = PH_NO_STRAND,
                      .diag = diag};
  struct ph_cusps cusps;
  enum ph_status status = ph_cusps_of(&strands->curve, strands->distance, PH_E2,
                                      strands->arena, &cusps, diag);
  size_t cusp = 0;
  *arcs = (struct ph_arcs){NULL, 0};
  for (size_t i = 0; status == PH_OK && i < strands->strands_n; i++) {
    const size_t next = strands->v[i].next;
    walk.strand = i;
    status = visit(&walk, &cusps, &cusp);
    if (status == PH_OK && next != i + 1) {
      if (next != PH_NO_STRAND) {
        close_chain(&walk, next);
      }
      walk.before = PH_NO_STRAND;
    }
  }
  return status;
}
