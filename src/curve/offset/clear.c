/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Distances of places from a curve (see clear.h). */
#include "curve/offset/clear.h"

/* Halvings of a segment: what is left is a point. */
enum { HALVINGS_MAX = 60 };

/* ---- the tree -------------------------------------------------------------
 */

static struct ph_clear_node leaf_of(const struct ph_strands *strands,
                                    size_t k) {
  const struct ph_curve *c = &strands->curve;
  const double *p = ph_curve_points(c, k);
  struct ph_clear_node node = {{p[0], p[1]}, {p[0], p[1]}};
  for (size_t i = 1; i <= c->degree; i++) {
    for (size_t j = 0; j < 2; j++) {
      node.low[j] = fmin(node.low[j], p[2 * i + j]);
      node.high[j] = fmax(node.high[j], p[2 * i + j]);
    }
  }
  return node;
}

static void build(struct ph_clear *clear, size_t at, size_t first, size_t n) {
  struct ph_clear_node *node = &clear->nodes[at];
  const struct ph_clear_node *left = node + 1, *right;
  const size_t half = n / 2;
  if (n == 1) {
    *node = leaf_of(clear->strands, first);
    return;
  }
  build(clear, at + 1, first, half);
  build(clear, at + 2 * half, first + half, n - half);
  right = &clear->nodes[at + 2 * half];
  for (size_t j = 0; j < 2; j++) {
    node->low[j] = fmin(left->low[j], right->low[j]);
    node->high[j] = fmax(left->high[j], right->high[j]);
  }
}

enum ph_status ph_clear_begin(struct ph_clear *clear,
                              const struct ph_strands *strands,
                              struct ph_diag *diag) {
  *clear = (struct ph_clear){.strands = strands, .segment = PH_NO_STRAND};
  clear->nodes =
      ph_arena_array(strands->arena, 2 * strands->n, sizeof *clear->nodes);
  if (!clear->nodes) {
    return ph_fail_memory(diag);
  }
  build(clear, 0, 0, strands->n);
  return PH_OK;
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

static bool is_segment_clear(struct look *look, size_t k) {
  struct ph_clear *clear = look->clear;
  struct end a, b;
  if (clear->segment != k) {
    struct ph_fast3_place left, right;
    ph_fast3_of(&clear->strands->curve, k, &clear->fast);
    left = ph_fast3_from(&clear->fast, 0, 0.5);
    right = ph_fast3_from(&clear->fast, 1, -0.5);
    clear->whole = ph_fast3_integral(&left, left.end->s) -
                   ph_fast3_integral(&right, right.end->s);
    clear->segment = k;
  }
  a = end_at(look, 0);
  b = end_at(look, 1);
  return a.away >= look->least && b.away >= look->least &&
         is_part_clear(look, &a, &b, 0);
}

/* ---- all ------------------------------------------------------------------
 */

static double from_box(const struct ph_clear_node *node, ph_cplx place) {
  const double x =
      fmax(fmax(node->low[0] - place.re, place.re - node->high[0]), 0);
  const double y =
      fmax(fmax(node->low[1] - place.im, place.im - node->high[1]), 0);
  return sqrt(x * x + y * y);
}

/* The half with the segment `near`, or the nearer one, comes first. */
static bool is_node_clear(struct look *look, size_t at, size_t first, size_t n,
                          size_t near) {
  const struct ph_clear_node *nodes = look->clear->nodes;
  const size_t half = n / 2, left = at + 1, right = at + 2 * half;
  bool swap;
  if (from_box(&nodes[at], look->place) >= look->least) {
    return true;
  }
  if (n == 1) {
    return is_segment_clear(look, first);
  }
  swap = near >= first && near < first + n
             ? near >= first + half
             : from_box(&nodes[right], look->place) <
                   from_box(&nodes[left], look->place);
  if (swap) {
    return is_node_clear(look, right, first + half, n - half, near) &&
           is_node_clear(look, left, first, half, near);
  }
  return is_node_clear(look, left, first, half, near) &&
         is_node_clear(look, right, first + half, n - half, near);
}

bool ph_clear_of(struct ph_clear *clear, ph_cplx place, size_t near) {
  const struct ph_strands *strands = clear->strands;
  struct look look = {clear, place,
                      fabs(strands->distance) -
                          PH_CLEAR_TOLERANCE * strands->size};
  return is_node_clear(&look, 0, 0, strands->n, near);
}
