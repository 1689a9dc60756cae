/* SPDX-License-Identifier: GPL-3.0-or-later */
/* How near a curve comes to places (see clear.h). */
#include "check/clear.h"

#include "kernel/pi.h"

/* Places of a segment where r'' is looked at, and what it may be more between,
 * unless it is a polynomial; halvings until a part is a point. */
enum { PLACES = 8, HALVINGS_MAX = 50 };
static const double BETWEEN = 1.5;

/* Nearer than what was found by this part of the tolerance is not looked for:
 * of parts that are all as far from a place, as those of an arc about it, one
 * would be cut for every rounding of their points. */
static const double FOUND = 0.5;

/* The company of a segment turns by less than that to either side. */
static const double TURN = 1.5;

/* ---- segments -------------------------------------------------------------
 */

/* A leg of a segment, in the plane. */
struct leg {
  double x, y;
};

static double dot(struct leg a, struct leg b) {
  return a.x * b.x + a.y * b.y;
}

static double cross(struct leg a, struct leg b) {
  return a.x * b.y - a.y * b.x;
}

/* Of a segment, for places to the left and to the right of it: by how much the
 * curve turns up to where it begins and ends, from the first one on, and
 * whether it bends more than they allow. */
struct bends {
  double begin[2], end[2];
  bool is_sharp[2];
};

struct build {
  struct ph_check_tree *tree;
  struct bends *bends; /* [segments] */
  struct leg before;   /* the last leg of the one before */
  ph_vec3 end;         /* and its end */
};

/* From the legs: where they are within a quarter turn of the chord, r' is, and
 * no less along it than the least is; r' and r'' are means of r' and r'' at
 * control points, and r' x r'' is one of their products.
 * out  most[2]  of the curvature, to the left and to the right
 * ret  by which it turns, not less */
static double bounds_of(const struct leg *leg, size_t m, double most[2]) {
  struct leg chord = {0, 0};
  double least = HUGE_VAL, low = 0, high = 0, length, scale;
  for (size_t i = 0; i <= m; i++) {
    chord.x += leg[i].x;
    chord.y += leg[i].y;
  }
  length = sqrt(dot(chord, chord));
  for (size_t i = 0; i <= m; i++) {
    const double along = dot(leg[i], chord), to = cross(chord, leg[i]) / along;
    least = ph_check_smaller(least, along);
    low = ph_check_smaller(low, to);
    high = ph_check_larger(high, to);
  }
  most[0] = most[1] = 0;
  for (size_t j = 0; j < m; j++) {
    const struct leg to = {leg[j + 1].x - leg[j].x, leg[j + 1].y - leg[j].y};
    for (size_t i = 0; i <= m; i++) {
      const double across = cross(leg[i], to);
      most[0] = ph_check_larger(most[0], across);
      most[1] = ph_check_larger(most[1], -across);
    }
  }
  least /= length;
  scale = (double)m / ((double)(m + 1) * least * least * least);
  most[0] *= scale;
  most[1] *= scale;
  return least > 0 ? high - low : HUGE_VAL;
}

/* By how much more the curve turns where a segment begins, whose first leg and
 * point these are.  Jumps to the side of the place, and gaps, in all, may bring
 * points nearer by half of the tolerance: they count as if that were TURN. */
static double turn_at(const struct build *b, size_t side, struct leg first,
                      ph_vec3 at) {
  const struct ph_check_tree *tree = b->tree;
  const double along = dot(b->before, first);
  const double jump = cross(b->before, first) / along;
  const double to = ph_check_larger(side ? -jump : jump, 0);
  const double nearer = ph_check_apart(at, b->end) + to * tree->distance;
  const double turn = fabs(jump) + TURN * nearer / (tree->tolerance / 2);
  return along > 0 && turn < 2 * TURN ? turn : 2 * TURN;
}

static struct ph_boxtree_node leaf_of(void *context, size_t k) {
  struct build *b = context;
  struct ph_check_tree *tree = b->tree;
  const struct ph_curve *c = tree->v->curve;
  const double *p = ph_curve_points(c, k);
  const size_t m = c->degree - 1;
  struct ph_boxtree_node box = ph_boxtree_empty();
  struct bends *bends = &b->bends[k];
  struct leg leg[PH_CHECK_DEGREE_MAX];
  ph_vec3 at = ph_check_vector(tree->v, p, 2), start = at;
  double most[2], bend = 0, turn;
  ph_boxtree_add(&box, at.x, at.y);
  for (size_t i = 0; i <= m; i++) {
    const ph_vec3 to = ph_check_vector(tree->v, p + 2 * (i + 1), 2);
    leg[i] = (struct leg){to.x - at.x, to.y - at.y};
    ph_boxtree_add(&box, to.x, to.y);
    at = to;
    if (i > 0) {
      const struct leg by = {leg[i].x - leg[i - 1].x, leg[i].y - leg[i - 1].y};
      bend = ph_check_larger(bend, dot(by, by));
    }
  }
  turn = ph_check_smaller(bounds_of(leg, m, most), 2 * TURN);
  for (size_t side = 0; side < 2; side++) {
    bends->begin[side] = (k ? bends[-1].end[side] : 0) +
                         (k || c->closed ? turn_at(b, side, leg[0], start) : 0);
    bends->end[side] = bends->begin[side] + turn;
    bends->is_sharp[side] =
        c->preimage.alpha || !(most[side] * tree->distance <= 1);
  }
  b->before = leg[m];
  b->end = at;
  tree->bend[k] = (double)((m + 1) * m) * sqrt(bend);
  return box;
}

/* r'' is no polynomial of these control points. */
static void bend_of_atph(struct ph_check_tree *tree) {
  for (size_t k = 0; k < tree->v->curve->n; k++) {
    double most = 0;
    ph_check_load(tree->v, k, &tree->segment);
    for (size_t i = 0; i <= PLACES; i++) {
      ph_vec3 jet[2];
      ph_check_jet(&tree->segment, (double)i / PLACES, jet, 2);
      most = ph_check_larger(most, ph_vec3_abs(jet[1]));
    }
    tree->bend[k] = BETWEEN * most;
  }
}

/* ---- company --------------------------------------------------------------
 */

/* From segment to segment, of closed curves twice round: the first one that is
 * company of it goes on as they do, and is company of no more where it does. */
static void find_company(const struct build *b, size_t side) {
  const size_t n = b->tree->v->curve->n;
  const size_t all = (b->tree->v->curve->closed ? 2 : 1) * n;
  const double whole = b->bends[n - 1].end[side];
  struct ph_check_company *company = b->tree->company[side];
  size_t first = 0;
  for (size_t k = 0; k <= all; k++) {
    const struct bends *at = &b->bends[k % n];
    const bool stop = k == all || at->is_sharp[side];
    for (; first < k; first++) {
      const double begin = b->bends[first % n].begin[side];
      const double turn =
          at->end[side] - begin + (k < n ? 0 : whole) - (first < n ? 0 : whole);
      if (!stop && turn < TURN && k - first < n) {
        break;
      }
      if (first < n) {
        company[first].after = k - first;
      }
    }
    if (k < all) {
      company[k % n].before = k - first;
    }
    if (k < all && stop) {
      company[k % n].after = 0;
      first++;
    }
  }
}

static enum ph_status begin(struct ph_check_tree *tree, struct build *b) {
  const struct ph_curve *c = tree->v->curve;
  struct ph_arena *arena = tree->v->scratch;
  const double *p = ph_curve_points(c, c->n - 1) + 2 * c->degree;
  tree->bend = ph_arena_array(arena, c->n, sizeof *tree->bend);
  b->bends = ph_arena_array(arena, c->n, sizeof *b->bends);
  for (size_t side = 0; side < 2; side++) {
    tree->company[side] =
        ph_arena_array(arena, c->n, sizeof *tree->company[side]);
  }
  if (!tree->bend || !b->bends || !tree->company[0] || !tree->company[1]) {
    return ph_fail_memory(tree->v->diag);
  }
  b->end = ph_check_vector(tree->v, p, 2);
  p -= 2;
  b->before.x = b->end.x - ph_check_vector(tree->v, p, 2).x;
  b->before.y = b->end.y - ph_check_vector(tree->v, p, 2).y;
  return PH_OK;
}

enum ph_status ph_check_tree_of(const struct ph_check *v, double distance,
                                double tolerance, struct ph_check_tree *tree) {
  struct build b = {.tree = tree};
  *tree = (struct ph_check_tree){
      .v = v, .distance = distance, .tolerance = tolerance};
  if (begin(tree, &b) != PH_OK ||
      !ph_boxtree_of(&tree->boxes, v->curve->n, leaf_of, &b, v->scratch)) {
    return ph_fail_memory(v->diag);
  }
  for (size_t side = 0; side < 2; side++) {
    find_company(&b, side);
  }
  if (v->curve->preimage.alpha) {
    bend_of_atph(tree);
  }
  return PH_OK;
}

/* ---- boxes of places ------------------------------------------------------
 */

/* A search that leaves out the company of segment k. */
static struct ph_boxtree_search search_of(const struct ph_check_tree *tree,
                                          size_t k,
                                          const struct ph_check_company *with) {
  const size_t n = tree->v->curve->n, before = with ? with->before : 0;
  return (struct ph_boxtree_search){.skip = k >= before ? k - before
                                                        : k + n - before,
                                    .skip_n = with ? before + with->after : 0,
                                    .limit = tree->distance - tree->tolerance};
}

static void stop(struct ph_boxtree_search *search, size_t k) {
  (void)k;
  search->limit = 0;
}

bool ph_check_is_clear(const struct ph_check_tree *tree,
                       const struct ph_boxtree_node *box, size_t k,
                       const struct ph_check_company *company) {
  struct ph_boxtree_search search = search_of(tree, k, company);
  search.from = *box;
  search.visit = stop;
  ph_boxtree_near(&tree->boxes, &search);
  return company->after > 0 && search.limit > 0;
}

/* ---- places ---------------------------------------------------------------
 */

struct look {
  struct ph_boxtree_search base; /* its limit: what is nearer, is near */
  struct ph_check_tree *tree;
  ph_vec3 place;
  size_t k;
};

struct end {
  double u;
  ph_vec3 r;
};

/* A point, of polynomials by the algorithm of de Casteljau. */
static ph_vec3 point_at(const struct look *look, double u) {
  const struct ph_check_segment *s = &look->tree->segment;
  const size_t degree = look->tree->v->curve->degree;
  double x[PH_CHECK_DEGREE_MAX + 1], y[PH_CHECK_DEGREE_MAX + 1];
  if (look->tree->v->curve->preimage.alpha) {
    return ph_check_point(look->tree->v, s, u);
  }
  for (size_t i = 0; i <= degree; i++) {
    x[i] = s->p[i].x;
    y[i] = s->p[i].y;
  }
  for (size_t n = degree; n > 0; n--) {
    for (size_t i = 0; i < n; i++) {
      x[i] += u * (x[i + 1] - x[i]);
      y[i] += u * (y[i + 1] - y[i]);
    }
  }
  return ph_vec3_of(x[0], y[0], 0);
}

static struct end end_at(struct look *look, double u) {
  struct end end = {u, point_at(look, u)};
  look->base.limit =
      ph_check_smaller(look->base.limit, ph_check_apart(end.r, look->place));
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
  const double away = from_chord(look->place, a->r, b->r) -
                      look->tree->bend[look->k] * h * h / 8;
  const double near = look->base.limit - FOUND * look->tree->tolerance;
  struct end middle;
  if (!(away < near) || depth == HALVINGS_MAX) {
    return;
  }
  middle = end_at(look, 0.5 * (a->u + b->u));
  look_between(look, a, &middle, depth + 1);
  look_between(look, &middle, b, depth + 1);
}

static void look_at(struct ph_boxtree_search *base, size_t k) {
  struct look *look = (struct look *)base;
  struct end a, b;
  look->k = k;
  ph_check_load(look->tree->v, k, &look->tree->segment);
  a = end_at(look, 0);
  b = end_at(look, 1);
  look_between(look, &a, &b, 0);
}

double ph_check_nearer(struct ph_check_tree *tree, ph_vec3 place, size_t k,
                       const struct ph_check_company *company) {
  struct look look = {
      .base = search_of(tree, k, company), .tree = tree, .place = place};
  const double least = look.base.limit;
  if (!(isfinite(place.x) && isfinite(place.y))) {
    return (double)NAN;
  }
  look.base.from =
      (struct ph_boxtree_node){{place.x, place.y}, {place.x, place.y}};
  look.base.visit = look_at;
  ph_boxtree_near(&tree->boxes, &look.base);
  return look.base.limit < least ? tree->distance - look.base.limit : 0;
}
