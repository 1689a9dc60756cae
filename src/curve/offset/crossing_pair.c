/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Where two arcs of an offset meet (see crossing.h). */
#include "curve/offset/crossing.h"

/* Steps of Newton's method, and places of an arc that are compared with another
 * one; room at first. */
enum { STEPS = 16, PLACES = 9, ROOM = 64 };

/* All of the size: room of bounds for rounding; how near a root has to be; arcs
 * that are points; bits that are no longer are compared, and their arcs; these
 * run on each other if they are so near, and share that, bits if they share
 * more; what may be flat. */
static const double ROUNDING = 1e-14, ROOT = 1e-13, POINT = 1e-10, SHORT = 2e-3,
                    NEAR = 1e-9, LEAST = 1e-8, LONG = 1e-4, FLAT = 1e-6;

/* Directions, radians: tangents are apart, or the same. */
static const double APART = 1e-9, SAME = 1e-6;

/* A bit, and what bounds it. */
struct bound {
  ph_cplx middle, chord; /* unit */
  double semi[2];        /* axes of the ellipse */
  double height;         /* of the triangle of the chord and both tangents */
  ph_cplx tangent;       /* in the middle of its directions */
  double half;           /* they are no further from it */
};

struct state {
  struct ph_pairing *p;
  size_t arc[2];
  size_t n;
  bool tried; /* whether the arcs run on each other */
};

static ph_cplx unit(ph_cplx a) {
  return ph_cplx_scale(1 / ph_cplx_abs(a), a);
}

static struct bound bound_of(const struct ph_bit *bit) {
  const ph_cplx a = bit->end[0].o, b = bit->end[1].o;
  const ph_cplx w = ph_cplx_add(unit(bit->end[0].w), unit(bit->end[1].w));
  const double l = fabs(bit->length), c = ph_cplx_abs(ph_cplx_sub(b, a));
  struct bound bound = {.middle = ph_cplx_between(a, b, 0.5),
                        .tangent = unit(ph_cplx_mul(w, w)),
                        .half = 0.5 * fabs(bit->turn)};
  bound.chord = c > 0 ? ph_cplx_scale(1 / c, ph_cplx_sub(b, a)) : bound.tangent;
  bound.semi[0] = 0.5 * l;
  bound.semi[1] = 0.5 * sqrt(fmax((l - c) * (l + c), 0));
  bound.height = 0.5 * l * tan(bound.half);
  return bound;
}

/* Half the extent along a direction: of the ellipse, or of the box round the
 * triangle, which loses nothing by rounding. */
static double extent(const struct bound *b, ph_cplx along) {
  const double x = fabs(b->semi[0] * ph_cplx_dot(along, b->chord));
  const double y = fabs(ph_cplx_cross(along, b->chord));
  return fmin(hypot(x, b->semi[1] * y), x + b->height * y);
}

static bool are_apart(const struct bound *a, const struct bound *b,
                      double rounding) {
  const ph_cplx between = ph_cplx_sub(b->middle, a->middle);
  const ph_cplx along[] = {{1, 0},   {0, 1},
                           a->chord, {-a->chord.im, a->chord.re},
                           b->chord, {-b->chord.im, b->chord.re}};
  for (size_t i = 0; i < sizeof along / sizeof along[0]; i++) {
    if (fabs(ph_cplx_dot(between, along[i])) >
        extent(a, along[i]) + extent(b, along[i]) + rounding) {
      return true;
    }
  }
  return false;
}

/* Whether no tangent of the one is parallel to one of the other. */
static bool is_transversal(const struct bound *a, const struct bound *b) {
  const double half = a->half + b->half + APART;
  return half < 1.5 && fabs(ph_cplx_cross(a->tangent, b->tangent)) > sin(half);
}

/* ---- what is found --------------------------------------------------------
 */

static enum ph_status add_break(struct state *s, size_t which, double u) {
  struct ph_crossings *out = s->p->out;
  struct ph_break *to =
      ph_arena_grow(s->p->strands->arena, out->breaks, out->breaks_n,
                    sizeof *to, ROOM, &s->p->breaks_room);
  if (!to) {
    return ph_fail_memory(s->p->diag);
  }
  out->breaks = to;
  to[out->breaks_n++] = (struct ph_break){s->arc[which], u};
  return PH_OK;
}

/* Where the parts of both arcs that meet end, for all. */
static enum ph_status add_ends(struct state *s, double u[2][2]) {
  enum ph_status status = PH_OK;
  for (size_t i = 0; status == PH_OK && i < 4; i++) {
    status = add_break(s, i / 2, u[i / 2][i % 2]);
  }
  return status;
}

/* Parts of both arcs that run on each other. */
static enum ph_status add_overlap(struct state *s, double u[2][2],
                                  bool opposite) {
  struct ph_crossings *out = s->p->out;
  for (size_t i = 0; i < 2; i++) {
    struct ph_overlap *to =
        ph_arena_grow(s->p->strands->arena, out->overlaps, out->overlaps_n,
                      sizeof *to, ROOM, &s->p->overlaps_room);
    if (!to) {
      return ph_fail_memory(s->p->diag);
    }
    out->overlaps = to;
    to[out->overlaps_n++] =
        (struct ph_overlap){.arc = s->arc[i],
                            .u = {u[i][0], u[i][1]},
                            .other = s->arc[1 - i],
                            .on = {u[1 - i][0], u[1 - i][1]},
                            .opposite = opposite};
  }
  return add_ends(s, u);
}

/* ---- decisions ------------------------------------------------------------
 */

static double within(double u, double low, double high) {
  return u < low ? low : u > high ? high : u;
}

/* The common point of bits that are not parallel, u in both; false if the one
 * that is found is not in both. */
static bool find_root(struct state *s, const struct ph_bits *pair,
                      double u[2]) {
  const double size = s->p->strands->size;
  double width[2];
  bool inside = false;
  for (size_t i = 0; i < 2; i++) {
    const struct ph_bit *bit = &pair->v[i];
    width[i] = bit->u[1] - bit->u[0];
    u[i] = 0.5 * (bit->u[0] + bit->u[1]);
  }
  for (int step = 0; step < STEPS; step++) {
    struct ph_spot at[2];
    ph_cplx apart, t[2];
    double cross, move[2];
    for (size_t i = 0; i < 2; i++) {
      at[i] = ph_strand_spot(&s->p->eval[i], u[i]);
      t[i] = ph_spot_tangent(&at[i]);
    }
    apart = ph_cplx_sub(at[1].o, at[0].o);
    inside = ph_cplx_abs(apart) < ROOT * size;
    cross = ph_cplx_cross(t[0], t[1]);
    move[0] = ph_cplx_cross(apart, t[1]) / (cross * at[0].rate);
    move[1] = ph_cplx_cross(apart, t[0]) / (cross * at[1].rate);
    if (!isfinite(move[0]) || !isfinite(move[1])) {
      return false;
    }
    for (size_t i = 0; i < 2; i++) {
      const struct ph_bit *bit = &pair->v[i];
      const double slack = 0.5 * width[i];
      u[i] += within(move[i], -width[i], width[i]);
      u[i] =
          within(u[i], fmax(bit->u[0] - slack, 0), fmin(bit->u[1] + slack, 1));
      if (!(fabs(move[i]) * fabs(at[i].rate) < ROOT * size)) {
        inside = false;
      }
    }
    if (inside) {
      break;
    }
  }
  for (size_t i = 0; i < 2; i++) {
    const struct ph_bit *bit = &pair->v[i];
    const double room = width[i] * fmin(1e-12 * size / fabs(bit->length), 0.02);
    inside = inside && u[i] >= bit->u[0] - room && u[i] <= bit->u[1] + room;
    u[i] = within(u[i], bit->u[0], bit->u[1]);
  }
  return inside;
}

/* The place within limits whose normal a point is on, by Newton's method from
 * their middle. */
static struct ph_spot foot_of(const struct state *s, size_t which,
                              ph_cplx point, const double limit[2], double *u) {
  struct ph_spot at;
  *u = 0.5 * (limit[0] + limit[1]);
  at = ph_strand_spot(&s->p->eval[which], *u);
  for (int step = 0; step < STEPS / 2; step++) {
    const ph_cplx apart = ph_cplx_sub(point, at.o);
    *u = within(*u + ph_cplx_dot(apart, ph_spot_tangent(&at)) / at.rate,
                limit[0], limit[1]);
    at = ph_strand_spot(&s->p->eval[which], *u);
  }
  return at;
}

static double apart_by(const struct ph_spot *a, const struct ph_spot *b) {
  return ph_cplx_abs(ph_cplx_sub(a->o, b->o));
}

/* The parts of both bits that are beside the other one, in its order; false: an
 * end of the one that is within the other is further from it. */
static bool find_shared(const struct state *s, const struct ph_bits *pair,
                        double near, double u[2][2]) {
  bool is_near = true;
  for (size_t i = 0; i < 4; i++) {
    const struct ph_bit *bit = &pair->v[i / 2];
    const struct ph_spot *end = &pair->v[1 - i / 2].end[i % 2];
    double *foot = &u[i / 2][i % 2];
    const struct ph_spot at = foot_of(s, i / 2, end->o, bit->u, foot);
    is_near = is_near && (!(*foot > bit->u[0] && *foot < bit->u[1]) ||
                          apart_by(&at, end) < near);
  }
  return is_near;
}

/* Orders their ends; false: they have no length, or go which way is not known.
 */
static bool put_in_order(double u[2][2], bool *opposite) {
  *opposite = u[0][0] > u[0][1];
  for (size_t i = 0; i < 2; i++) {
    const double low = u[i][*opposite], high = u[i][!*opposite];
    if (!(low < high)) {
      return false;
    }
    u[i][0] = low;
    u[i][1] = high;
  }
  return true;
}

/* Whether bits run on each other where both are, and where: for no less than a
 * length.  Shorter parts are as near where they touch, and have to be nearer.
 */
static bool run_together(const struct state *s, const struct ph_bits *pair,
                         double least, double u[2][2], bool *opposite) {
  const double size = s->p->strands->size, d = s->p->strands->distance;
  const struct ph_spot *end = pair->v[0].end;
  struct ph_spot a, b, limit[2];
  double near = NEAR * size, length;
  if (!find_shared(s, pair, near, u) || !put_in_order(u, opposite)) {
    return false;
  }
  for (size_t j = 0; j < 2; j++) {
    limit[j] = ph_strand_spot(&s->p->eval[0], u[0][j]);
  }
  length = fabs(ph_spot_length(d, &limit[0], &limit[1]));
  near = length > LONG * size ? near : ROOT * size;
  if (!(length > least * size) || !(end[0].rate * end[1].rate > 0)) {
    return false;
  }
  for (size_t i = 0; i < PLACES; i++) {
    const double x = (double)i / (PLACES - 1);
    double v;
    a = ph_strand_spot(&s->p->eval[0], u[0][0] + x * (u[0][1] - u[0][0]));
    b = foot_of(s, 1, a.o, u[1], &v);
    if (!(apart_by(&a, &b) < near) ||
        !(fabs(ph_cplx_cross(ph_spot_tangent(&a), ph_spot_tangent(&b))) <
          SAME)) {
      return false;
    }
  }
  return true;
}

/* ---- halving --------------------------------------------------------------
 */

static void halve(struct state *s, size_t which, const struct ph_bit *bit,
                  struct ph_bit half[2]) {
  const double u = 0.5 * (bit->u[0] + bit->u[1]), d = s->p->strands->distance;
  const struct ph_spot at = ph_strand_spot(&s->p->eval[which], u);
  half[0] = ph_bit_of(d, bit->u[0], &bit->end[0], u, &at);
  half[1] = ph_bit_of(d, u, &at, bit->u[1], &bit->end[1]);
}

/* The halves of the longer bit, of both if they are of about a length. */
static enum ph_status divide(struct state *s, const struct ph_bits *pair) {
  const double l[2] = {fabs(pair->v[0].length), fabs(pair->v[1].length)};
  struct ph_bit half[2][2] = {{pair->v[0], pair->v[0]},
                              {pair->v[1], pair->v[1]}};
  size_t parts[2] = {1, 1};
  for (size_t i = 0; i < 2; i++) {
    if (l[i] >= 0.7 * l[1 - i]) {
      halve(s, i, &pair->v[i], half[i]);
      parts[i] = 2;
    }
  }
  if (s->n + 4 > PH_BITS_MAX) {
    return PH_E_NO_CONVERGENCE;
  }
  for (size_t i = 0; i < parts[0]; i++) {
    for (size_t j = 0; j < parts[1]; j++) {
      s->p->stack[s->n].v[0] = half[0][i];
      s->p->stack[s->n++].v[1] = half[1][j];
    }
  }
  return PH_OK;
}

/* Bits that are parallel, and whose arcs may run on each other, or they; false:
 * nothing is found. */
static bool find_overlap(struct state *s, const struct ph_bits *pair,
                         double longest, double u[2][2], bool *opposite) {
  struct ph_bits whole;
  for (size_t i = 0; i < 2; i++) {
    whole.v[i] = s->p->arcs->v[s->arc[i]].bit;
  }
  if (!s->tried && run_together(s, &whole, LEAST, u, opposite)) {
    s->n = 0; /* elsewhere there is at most one of them */
    return true;
  }
  s->tried = true;
  return longest > LONG * s->p->strands->size &&
         run_together(s, pair, LONG, u, opposite);
}

/* Bits that meet where it cannot be told any better.  What is flat is the same
 * line within rounding, and one of them is enough. */
static enum ph_status add_touch(struct state *s, const struct ph_bits *pair,
                                bool flat) {
  double u[2][2];
  bool opposite;
  s->p->out->touches++;
  find_shared(s, pair, HUGE_VAL, u);
  return put_in_order(u, &opposite) && flat ? add_overlap(s, u, opposite)
                                            : add_ends(s, u);
}

/* One pair of bits. */
static enum ph_status decide(struct state *s, const struct ph_bits *pair) {
  const double size = s->p->strands->size, rounding = ROUNDING * size;
  const struct bound a = bound_of(&pair->v[0]), b = bound_of(&pair->v[1]);
  const double longest = fmax(fabs(pair->v[0].length), fabs(pair->v[1].length));
  const double sine = fabs(ph_cplx_cross(a.tangent, b.tangent));
  const bool flat = longest < FLAT * size && a.height < rounding &&
                    b.height < rounding && sine * longest < 10 * rounding;
  double u[2][2];
  bool opposite;
  if (are_apart(&a, &b, rounding)) {
    return PH_OK;
  }
  if (is_transversal(&a, &b) && find_root(s, pair, u[0])) {
    enum ph_status status = add_break(s, 0, u[0][0]);
    s->p->out->points++;
    return status == PH_OK ? add_break(s, 1, u[0][1]) : status;
  }
  if (longest < SHORT * size && sine < SAME &&
      find_overlap(s, pair, longest, u, &opposite)) {
    return add_overlap(s, u, opposite);
  }
  return flat || longest < POINT * size ? add_touch(s, pair, flat)
                                        : divide(s, pair);
}

enum ph_status ph_pair_decide(struct ph_pairing *pairing, size_t i, size_t j) {
  struct state s = {.p = pairing, .arc = {i, j}, .n = 1};
  enum ph_status status = PH_OK;
  for (size_t k = 0; k < 2; k++) {
    const struct ph_arc *arc = &pairing->arcs->v[s.arc[k]];
    pairing->stack[0].v[k] = arc->bit;
    ph_strand_enter(&pairing->eval[k], pairing->strands, arc->strand);
  }
  while (status == PH_OK && s.n > 0) {
    const struct ph_bits pair = pairing->stack[--s.n];
    status = ++pairing->tests > pairing->tests_most ||
                     ph_arena_late(pairing->strands->arena)
                 ? PH_E_NO_CONVERGENCE
                 : decide(&s, &pair);
  }
  return status;
}
