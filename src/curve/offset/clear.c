/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Distances of places from a curve (see clear.h). */
#include "curve/offset/clear.h"

#include "kernel/pi.h"

/* Halvings of a segment: what is left is a point. */
enum { HALVINGS_MAX = 60 };

/* Of a length: a place is beyond an ellipse by more than that. */
static const double ROUNDING = 1e-12;

/* ---- the tree -------------------------------------------------------------
 */

static struct ph_boxtree_node leaf_of(void *context, size_t k) {
  const struct ph_strands *strands = context;
  const double *p = ph_curve_points(&strands->curve, k);
  struct ph_boxtree_node box = ph_boxtree_empty();
  for (size_t i = 0; i <= strands->curve.degree; i++) {
    ph_boxtree_add(&box, p[2 * i], p[2 * i + 1]);
  }
  return box;
}

enum ph_status ph_clear_begin(struct ph_clear *clear,
                              const struct ph_strands *strands,
                              struct ph_diag *diag) {
  *clear = (struct ph_clear){.strands = strands, .segment = PH_NO_STRAND};
  return ph_boxtree_of(&clear->boxes, strands->n, leaf_of, (void *)strands,
                       strands->arena)
             ? PH_OK
             : ph_fail_memory(diag);
}

/* ---- one segment ----------------------------------------------------------
 */

struct end {
  double u, s;
  ph_cplx r;
  double away; /* from the place */
};

struct look {
  struct ph_clear *clear;
  ph_cplx place;
  double least; /* what is nearer, is near */
};

static struct end end_at(const struct look *look, double u) {
  const struct ph_fast3 *fast = &look->clear->fast;
  const struct ph_fast3_place at = ph_fast3_at(fast, u);
  const ph_vec3 r = ph_fast3_point(fast, &at);
  const double s = ph_fast3_integral(&at, at.end->s);
  struct end end = {.u = u, .r = {r.x, r.y}};
  end.s = ph_pow2_apply(fast->grow, s + (u > 0.5 ? look->clear->whole : 0));
  end.away = ph_cplx_abs(ph_cplx_sub(end.r, look->place));
  return end;
}

static double from_chord(ph_cplx place, ph_cplx a, ph_cplx b) {
  const ph_cplx chord = ph_cplx_sub(b, a), from = ph_cplx_sub(place, a);
  const double norm2 = ph_cplx_norm2(chord);
  double x = norm2 > 0 ? ph_cplx_dot(from, chord) / norm2 : 0;
  x = x < 0 ? 0 : x > 1 ? 1 : x;
  return ph_cplx_abs(ph_cplx_sub(from, ph_cplx_scale(x, chord)));
}

/* Whether no point between two ends is near; these are not. */
static bool is_part_clear(struct look *look, const struct end *a,
                          const struct end *b, int depth) {
  const double l = b->s - a->s;
  const double c = ph_cplx_abs(ph_cplx_sub(b->r, a->r));
  const double semi = 0.5 * sqrt(fmax((l - c) * (l + c), 0));
  struct end middle;
  bool first;
  if (0.5 * (a->away + b->away - l) >= look->least ||
      from_chord(look->place, a->r, b->r) - semi >= look->least ||
      depth == HALVINGS_MAX) {
    return true;
  }
  middle = end_at(look, 0.5 * (a->u + b->u));
  if (!(middle.away >= look->least)) {
    return false;
  }
  first = a->away < b->away;
  return is_part_clear(look, first ? a : &middle, first ? &middle : b,
                       depth + 1) &&
         is_part_clear(look, first ? &middle : a, first ? b : &middle,
                       depth + 1);
}

static void prepare(struct ph_clear *clear, size_t k) {
  if (clear->segment != k) {
    struct ph_fast3_place left, right;
    ph_fast3_of(&clear->strands->curve, k, &clear->fast);
    left = ph_fast3_from(&clear->fast, 0, 0.5);
    right = ph_fast3_from(&clear->fast, 1, -0.5);
    clear->whole = ph_fast3_integral(&left, left.end->s) -
                   ph_fast3_integral(&right, right.end->s);
    clear->segment = k;
  }
}

static bool is_segment_clear(struct look *look, size_t k) {
  struct end a, b;
  prepare(look->clear, k);
  a = end_at(look, 0);
  b = end_at(look, 1);
  return a.away >= look->least && b.away >= look->least &&
         is_part_clear(look, &a, &b, 0);
}

/* By how much the direction from the place to a point turns between two ends.
 */
static double angle_of(const struct look *look, const struct end *a,
                       const struct end *b, int depth) {
  struct end middle;
  if (a->away + b->away > (1 + ROUNDING) * (b->s - a->s) ||
      depth == HALVINGS_MAX) {
    return ph_cplx_angle(ph_cplx_sub(a->r, look->place),
                         ph_cplx_sub(b->r, look->place));
  }
  middle = end_at(look, 0.5 * (a->u + b->u));
  return angle_of(look, a, &middle, depth + 1) +
         angle_of(look, &middle, b, depth + 1);
}

/* ---- all ------------------------------------------------------------------
 */

int ph_clear_around(struct ph_clear *clear, ph_cplx place) {
  struct look look = {.clear = clear, .place = place};
  double sum = 0;
  for (size_t k = 0; k < clear->strands->n; k++) {
    struct end a, b;
    prepare(clear, k);
    a = end_at(&look, 0);
    b = end_at(&look, 1);
    sum += angle_of(&look, &a, &b, 0);
  }
  return (int)lround(sum / (2 * PH_PI));
}

struct search {
  struct ph_boxtree_search base;
  struct look *look;
};

static void visit(struct ph_boxtree_search *base, size_t k) {
  const struct search *search = (const struct search *)base;
  base->limit = is_segment_clear(search->look, k) ? base->limit : 0;
}

bool ph_clear_of(struct ph_clear *clear, ph_cplx place, size_t near) {
  const struct ph_strands *strands = clear->strands;
  struct look look = {clear, place,
                      fabs(strands->distance) -
                          PH_CLEAR_TOLERANCE * strands->size};
  struct search search = {{.from = {{place.re, place.im}, {place.re, place.im}},
                           .skip = near,
                           .skip_n = 1,
                           .limit = look.least,
                           .visit = visit},
                          &look};
  if (!is_segment_clear(&look, near)) {
    return false;
  }
  ph_boxtree_near(&clear->boxes, &search.base);
  return search.base.limit > 0;
}
