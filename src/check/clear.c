/* SPDX-License-Identifier: GPL-3.0-or-later */
/* How near a curve comes to places (see clear.h). */
#include "check/clear.h"

/* Places of a segment where r'' is looked at, and what it may be more between;
 * halvings until a part is a point. */
enum { PLACES = 8, HALVINGS_MAX = 50 };
static const double BETWEEN = 1.5;

/* ---- the tree -------------------------------------------------------------
 */

static void enter(struct ph_check_tree *tree, size_t k) {
  ph_check_load(tree->v, k, &tree->segment);
}

static struct ph_check_box leaf_of(struct ph_check_tree *tree, size_t k) {
  const struct ph_check_segment *s = &tree->segment;
  struct ph_check_box box = {{HUGE_VAL, HUGE_VAL}, {-HUGE_VAL, -HUGE_VAL}};
  double most = 0;
  enter(tree, k);
  for (size_t i = 0; i <= tree->v->curve->degree; i++) {
    const double x[2] = {s->p[i].x, s->p[i].y};
    for (size_t j = 0; j < 2; j++) {
      box.low[j] = fmin(box.low[j], x[j]);
      box.high[j] = fmax(box.high[j], x[j]);
    }
  }
  for (size_t i = 0; i <= PLACES; i++) {
    ph_vec3 jet[2];
    ph_check_jet(s, (double)i / PLACES, jet, 2);
    most = fmax(most, ph_vec3_abs(jet[1]));
  }
  tree->bend[k] = BETWEEN * most;
  return box;
}

static void build(struct ph_check_tree *tree, size_t at, size_t first,
                  size_t n) {
  struct ph_check_box *box = &tree->boxes[at];
  const struct ph_check_box *left = box + 1, *right;
  const size_t half = n / 2;
  if (n == 1) {
    *box = leaf_of(tree, first);
    return;
  }
  build(tree, at + 1, first, half);
  build(tree, at + 2 * half, first + half, n - half);
  right = &tree->boxes[at + 2 * half];
  for (size_t j = 0; j < 2; j++) {
    box->low[j] = fmin(left->low[j], right->low[j]);
    box->high[j] = fmax(left->high[j], right->high[j]);
  }
}

enum ph_status ph_check_tree_of(const struct ph_check *v,
                                struct ph_check_tree *tree) {
  const size_t n = v->curve->n;
  *tree = (struct ph_check_tree){.v = v};
  tree->boxes = ph_arena_array(v->scratch, 2 * n, sizeof *tree->boxes);
  tree->bend = ph_arena_array(v->scratch, n, sizeof *tree->bend);
  if (!tree->boxes || !tree->bend) {
    return ph_fail_memory(v->diag);
  }
  build(tree, 0, 0, n);
  return PH_OK;
}

/* ---- places ---------------------------------------------------------------
 */

struct look {
  struct ph_check_tree *tree;
  ph_vec3 place;
  double distance, least; /* less the tolerance */
  double nearest;
  size_t k;
};

struct end {
  double u;
  ph_vec3 r;
};

static struct end end_at(struct look *look, double u) {
  struct end end = {u, ph_check_point(look->tree->v, &look->tree->segment, u)};
  look->nearest = fmin(look->nearest, ph_check_apart(end.r, look->place));
  return end;
}

static double from_chord(ph_vec3 place, ph_vec3 a, ph_vec3 b) {
  const ph_vec3 chord = ph_vec3_sub(b, a), from = ph_vec3_sub(place, a);
  const double norm2 = ph_vec3_dot(chord, chord);
  double x = norm2 > 0 ? ph_vec3_dot(from, chord) / norm2 : 0;
  x = x < 0 ? 0 : x > 1 ? 1 : x;
  return ph_vec3_abs(ph_vec3_along(from, -x, chord));
}

static void look_between(struct look *look, const struct end *a,
                         const struct end *b, int depth) {
  const double h = b->u - a->u;
  struct end middle;
  if (from_chord(look->place, a->r, b->r) -
              look->tree->bend[look->k] * h * h / 8 >=
          fmin(look->least, look->nearest) ||
      depth == HALVINGS_MAX) {
    return;
  }
  middle = end_at(look, 0.5 * (a->u + b->u));
  look_between(look, a, &middle, depth + 1);
  look_between(look, &middle, b, depth + 1);
}

static double from_box(const struct ph_check_box *box, ph_vec3 p) {
  const double x = fmax(fmax(box->low[0] - p.x, p.x - box->high[0]), 0);
  const double y = fmax(fmax(box->low[1] - p.y, p.y - box->high[1]), 0);
  return sqrt(x * x + y * y);
}

static void look_in(struct look *look, size_t at, size_t first, size_t n) {
  const struct ph_check_box *boxes = look->tree->boxes;
  const size_t half = n / 2, left = at + 1, right = at + 2 * half;
  if (from_box(&boxes[at], look->place) >= fmin(look->least, look->nearest)) {
    return;
  }
  if (n == 1) {
    struct end a, b;
    enter(look->tree, first);
    look->k = first;
    a = end_at(look, 0);
    b = end_at(look, 1);
    look_between(look, &a, &b, 0);
  } else if (from_box(&boxes[right], look->place) <
             from_box(&boxes[left], look->place)) {
    look_in(look, right, first + half, n - half);
    look_in(look, left, first, half);
  } else {
    look_in(look, left, first, half);
    look_in(look, right, first + half, n - half);
  }
}

double ph_check_nearer(struct ph_check_tree *tree, ph_vec3 place,
                       double distance, double tolerance) {
  struct look look = {.tree = tree,
                      .place = place,
                      .distance = distance,
                      .least = distance - tolerance,
                      .nearest = HUGE_VAL};
  look_in(&look, 0, 0, tree->v->curve->n);
  return look.nearest < look.least ? distance - look.nearest : 0;
}
