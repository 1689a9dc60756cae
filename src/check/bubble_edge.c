/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Patches at their edges (see bubble.h): each edge is compared by itself, in
 * threads that are spare, and what was found is put together in their order. */
#include "check/bubble_exact.h"

#include "base/team.h"

#include <stdlib.h>
#include <string.h>

/* Places of an edge. */
enum { PLACES = 16 };

/* Control points of a side: so many by one parameter at most. */
enum { MOST = PH_CHECK_PATCH_MOST };

/* Edges that a thread takes at once, and as many as are worth one. */
enum { CHUNK = 64, WORTH = 256 };

/* ---- sides --------------------------------------------------------------- */

static int by_points(const void *left, const void *right) {
  const struct ph_check_side *a = left, *b = right;
  return a->low != b->low       ? (a->low > b->low) - (a->low < b->low)
         : a->high != b->high   ? (a->high > b->high) - (a->high < b->high)
         : a->patch != b->patch ? (a->patch > b->patch) - (a->patch < b->patch)
                                : (a->k > b->k) - (a->k < b->k);
}

static bool is_same_edge(const struct ph_check_side *a,
                         const struct ph_check_side *b) {
  return a->low == b->low && a->high == b->high;
}

enum ph_status ph_check_patch_sides(struct ph_check_patchwork *w) {
  const struct ph_curve *c = w->curve;
  w->sides = ph_arena_array(w->v->scratch, 4 * c->n, sizeof *w->sides);
  w->seams = ph_arena_array(w->v->scratch, 2 * c->n, sizeof *w->seams);
  w->seams_n = 0;
  if (!w->sides || !w->seams) {
    return ph_fail_memory(w->v->diag);
  }
  for (size_t i = 0; i < 4 * c->n; i++) {
    const size_t *at = c->surface.patches[i / 4].vertices;
    const size_t a = at[i % 4], b = at[(i + 1) % 4];
    w->sides[i] =
        (struct ph_check_side){a < b ? a : b, a < b ? b : a, i / 4, i % 4};
  }
  qsort(w->sides, 4 * c->n, sizeof *w->sides, by_points);
  return PH_OK;
}

static bool is_back(const struct ph_check_patchwork *w,
                    const struct ph_check_side *side) {
  const struct ph_patch *p = &w->curve->surface.patches[side->patch];
  return p->vertices[side->k] != side->low;
}

/* Three layers of control points at a side, from its lower point on. */
struct layers {
  size_t along, across; /* degrees */
  ph_vec3 c[3][MOST];
};

static void set_layers(const struct ph_check_patchwork *w,
                       const struct ph_check_side *side,
                       struct layers *layers) {
  const struct ph_patch *p = &w->curve->surface.patches[side->patch];
  const size_t width = p->bidegree[0] + 1, high = p->bidegree[1] + 1;
  const bool by_u = side->k % 2 == 0;
  const bool back = is_back(w, side);
  /* from the first vertex of the side, along it, and inwards */
  const size_t start[] = {0, width - 1, width * high - 1, width * (high - 1)};
  const ptrdiff_t row = (ptrdiff_t)width;
  const ptrdiff_t step[] = {1, row, -1, -row}, in[] = {row, -1, -row, 1};
  layers->along = by_u ? width - 1 : high - 1;
  layers->across = by_u ? high - 1 : width - 1;
  for (size_t j = 0; j < 3 && j <= layers->across; j++) {
    for (size_t i = 0; i <= layers->along; i++) {
      const size_t k = back ? layers->along - i : i;
      const ptrdiff_t at = (ptrdiff_t)start[side->k] +
                           step[side->k] * (ptrdiff_t)k +
                           in[side->k] * (ptrdiff_t)j;
      layers->c[j][i] = ph_check_vector(w->v, p->control_points + 3 * at, 3);
    }
  }
}

/* A Bezier curve with two derivatives, by de Casteljau's algorithm. */
static void evaluate(const ph_vec3 *points, size_t degree, double u,
                     ph_vec3 jet[3]) {
  ph_vec3 c[MOST];
  const double n = (double)degree;
  memcpy(c, points, (degree + 1) * sizeof *c);
  jet[1] = jet[2] = ph_vec3_of(0, 0, 0);
  for (size_t left = degree; left > 0; left--) {
    if (left == 2) {
      const ph_vec3 bend =
          ph_vec3_add(ph_vec3_sub(c[2], c[1]), ph_vec3_sub(c[0], c[1]));
      jet[2] = ph_vec3_scale(n * (n - 1), bend);
    }
    if (left == 1) {
      jet[1] = ph_vec3_scale(n, ph_vec3_sub(c[1], c[0]));
    }
    for (size_t i = 0; i < left; i++) {
      c[i] = ph_vec3_along(ph_vec3_scale(1 - u, c[i]), u, c[i + 1]);
    }
  }
  jet[0] = c[0];
}

/* What a patch is at a place of its side: s along, w inwards. */
struct local {
  ph_vec3 p, normal;
  double form[6];  /* the second fundamental form: xx, yy, zz, xy, xz, yz */
  double rounding; /* of the angle of the normal, for a unit rounding */
  double noise;    /* of the form, the same */
};

/* The second fundamental form as a tensor, by the dual of the tangents, which
 * cross products say without loss where these are nearly along each other. */
static void set_form(struct local *at, double area, ph_vec3 s, ph_vec3 w,
                     ph_vec3 ss, ph_vec3 sw, ph_vec3 ww) {
  const ph_vec3 a = ph_vec3_scale(1 / area, ph_vec3_cross(w, at->normal));
  const ph_vec3 b = ph_vec3_scale(1 / area, ph_vec3_cross(at->normal, s));
  const double l = ph_vec3_dot(at->normal, ss), m = ph_vec3_dot(at->normal, sw);
  const double n = ph_vec3_dot(at->normal, ww);
  const ph_vec3 x = ph_vec3_along(ph_vec3_scale(l, a), m, b);
  const ph_vec3 y = ph_vec3_along(ph_vec3_scale(m, a), n, b);
  at->form[0] = a.x * x.x + b.x * y.x;
  at->form[1] = a.y * x.y + b.y * y.y;
  at->form[2] = a.z * x.z + b.z * y.z;
  at->form[3] = a.x * x.y + b.x * y.y;
  at->form[4] = a.x * x.z + b.x * y.z;
  at->form[5] = a.y * x.z + b.y * y.z;
}

static double size_of(const double form[6]) {
  double sum = 0;
  for (size_t i = 0; i < 6; i++) {
    sum += (i < 3 ? 1 : 2) * form[i] * form[i];
  }
  return sqrt(sum);
}

/* What the form is wrong by where the normal is by an angle of 1: it takes
 * second derivatives, and lets more of what they are in the tangent plane
 * through, the nearer the tangents are to one another. */
static double tilt_of(const ph_vec3 x[3][3], double area) {
  const double s = ph_vec3_abs(x[1][0]) / area;
  const double w = ph_vec3_abs(x[0][1]) / area;
  return ph_vec3_abs(x[2][0]) * w * w + 2 * ph_vec3_abs(x[1][1]) * s * w +
         ph_vec3_abs(x[0][2]) * s * s;
}

/* ... of which derivatives are known, of degrees that add up so. */
static void set_local(const ph_vec3 x[3][3], double degrees, struct local *at) {
  const ph_vec3 cross = ph_vec3_cross(x[1][0], x[0][1]);
  const double area = ph_vec3_abs(cross);
  const double across = ph_check_smaller(area / ph_vec3_abs(x[1][0]),
                                         area / ph_vec3_abs(x[0][1]));
  at->p = x[0][0];
  at->normal = ph_vec3_scale(1 / area, cross);
  set_form(at, area, x[1][0], x[0][1], x[2][0], x[1][1], x[0][2]);
  at->rounding = 2 * degrees / across;
  at->noise = 4 * degrees * degrees / (across * across) +
              (4 * size_of(at->form) + tilt_of(x, area)) * at->rounding;
}

static void set_polynomial(const struct ph_check_patchwork *w,
                           const struct ph_check_side *side,
                           struct local at[PLACES]) {
  struct layers layers;
  double n;
  set_layers(w, side, &layers);
  n = (double)layers.across;
  for (size_t i = 0; i < PLACES; i++) {
    ph_vec3 jet[3][3], x[3][3];
    for (size_t j = 0; j < 3 && j <= layers.across; j++) {
      evaluate(layers.c[j], layers.along, ((double)i + 0.5) / PLACES, jet[j]);
    }
    memcpy(x[0], jet[0], sizeof x[0]); /* derivatives along, and so on */
    x[1][0] = jet[0][1];
    x[2][0] = jet[0][2];
    x[0][1] = ph_vec3_scale(n, ph_vec3_sub(jet[1][0], jet[0][0]));
    x[1][1] = ph_vec3_scale(n, ph_vec3_sub(jet[1][1], jet[0][1]));
    x[0][2] =
        layers.across < 2
            ? ph_vec3_of(0, 0, 0)
            : ph_vec3_scale(n * (n - 1),
                            ph_vec3_add(ph_vec3_sub(jet[2][0], jet[1][0]),
                                        ph_vec3_sub(jet[0][0], jet[1][0])));
    set_local((const ph_vec3(*)[3])x, n + (double)layers.along, &at[i]);
  }
}

/* Parameters of the places, and of both ends. */
struct nodes {
  struct ph_check_node at[PLACES], end[2];
};

static void set_nodes(const struct ph_check_patchwork *w, struct nodes *nodes) {
  const size_t n = w->curve->surface.continuity;
  for (size_t i = 0; i < PLACES; i++) {
    ph_check_node_at(n, ((double)i + 0.5) / PLACES, &nodes->at[i]);
  }
  ph_check_node_at(n, 0, &nodes->end[0]);
  ph_check_node_at(n, 1, &nodes->end[1]);
}

/* The same of a quotient, from the sides of its patch.  Of continuity 2 the
 * opposite side has nothing to do with derivatives here. */
static void set_quotient(const struct ph_check_patchwork *w,
                         const struct nodes *nodes,
                         const struct ph_check_side *side,
                         struct local at[PLACES]) {
  static const bool high[] = {false, true, true, false};
  const size_t by_v = side->k % 2, end = high[side->k];
  const bool back = is_back(w, side) != (side->k >= 2);
  struct ph_check_quotient patch;
  const struct ph_check_node *node[2];
  struct ph_check_cross cross[2][2] = {{{{{0}}}}};
  ph_check_quotient_begin(w, side->patch, &patch);
  node[!by_v] = &nodes->end[end];
  for (size_t k = 0; k < 2; k++) {
    cross[!by_v][k] = patch.side[2 * !by_v + k].end[end];
  }
  for (size_t i = 0; i < PLACES; i++) {
    struct ph_check_place place;
    node[by_v] = &nodes->at[back ? PLACES - 1 - i : i];
    for (size_t k = 0; k < 2; k++) {
      if (k == end || patch.continuity < 2) {
        ph_check_quotient_cross(&patch, 2 * by_v + k, node[by_v]->t,
                                &cross[by_v][k]);
      }
    }
    ph_check_quotient_at(&patch, node[0],
                         (const struct ph_check_cross *)cross[0], node[1],
                         (const struct ph_check_cross *)cross[1], &place);
    set_local((const ph_vec3(*)[3])place.x, PH_CHECK_LIKE, &at[i]);
  }
}

/* ---- an edge ------------------------------------------------------------- */

/* The angle between two lines. */
static double angle_of(ph_vec3 a, ph_vec3 b) {
  return atan2(ph_vec3_abs(ph_vec3_cross(a, b)), fabs(ph_vec3_dot(a, b)));
}

/* |a - b| of forms whose normals are on the same side. */
static double bend_of(const struct local *a, const struct local *b) {
  const double sign = ph_vec3_dot(a->normal, b->normal) < 0 ? -1 : 1;
  double d[6];
  for (size_t i = 0; i < 6; i++) {
    d[i] = a->form[i] - sign * b->form[i];
  }
  return size_of(d);
}

/* NaN is larger. */
static void raise_to(double *largest, double x) {
  *largest = ph_check_is_larger(x, *largest) ? x : *largest;
}

/* What both sides of a seam differ by: the largest, and that which exceeds by
 * most what is allowed. */
static void compare(const struct ph_check_patchwork *w,
                    const struct nodes *nodes, struct ph_check_seam *seam) {
  const struct ph_check_side *side = &w->sides[seam->side];
  const double noise = PH_CHECK_PATCH_ROUND * w->v->scale.rounding;
  const double allowed[] = {w->jump_allowed, w->bend_allowed};
  struct local at[2][PLACES];
  double excess[2] = {0, 0};
  for (size_t i = 0; i < 2; i++) {
    if (w->edges) {
      set_quotient(w, nodes, &side[i], at[i]);
    } else {
      set_polynomial(w, &side[i], at[i]);
    }
  }
  for (size_t i = 0; i < PLACES; i++) {
    const struct local *a = &at[0][i], *b = &at[1][i];
    const double value[] = {angle_of(a->normal, b->normal),
                            seam->length * bend_of(a, b)};
    const double doubt[] = {noise * (a->rounding + b->rounding),
                            seam->length * noise * (a->noise + b->noise)};
    raise_to(&seam->gap, ph_check_apart(a->p, b->p));
    for (size_t k = 0; k < 2; k++) {
      const double share = value[k] / (allowed[k] + doubt[k]);
      if (w->curve->surface.continuity == 0 && isnan(value[k])) {
        continue; /* a corner may be degenerate */
      }
      raise_to(&seam->value[k], value[k]);
      seam->noise[k] = ph_check_larger(seam->noise[k], doubt[k]);
      if (ph_check_is_larger(share, excess[k])) {
        excess[k] = share;
        seam->worst[k] = value[k];
        seam->doubt[k] = doubt[k];
      }
    }
  }
}

static bool compare_some(void *context, size_t thread, size_t first,
                         size_t end) {
  const struct ph_check_patchwork *w = context;
  struct nodes nodes;
  set_nodes(w, &nodes);
  for (size_t i = first; i < end; i++) {
    compare(w, &nodes, &w->seams[i]);
  }
  return thread || !ph_arena_late(w->v->scratch); /* it is for one to ask */
}

/* What was found of an edge, into that of all. */
static void note(struct ph_check_patchwork *w,
                 const struct ph_check_seam *seam) {
  const size_t patch = w->sides[seam->side].patch;
  ph_check_miss(w->v, PH_CHECK_CONTINUITY, ph_check_patch_where(w, patch),
                seam->gap, w->v->scale.size,
                PH_CHECK_PATCH_ROUND * w->v->scale.rounding,
                "leaves a gap at an edge");
  ph_check_add(&w->jump, patch, seam->value[0], 1, HUGE_VAL);
  if (w->curve->surface.continuity > 0) {
    ph_check_add(&w->jump, patch, seam->worst[0], 1,
                 w->jump_allowed + seam->doubt[0]);
    ph_check_add(&w->bend, patch, seam->value[1], 1, HUGE_VAL);
    ph_check_add(&w->bend, patch, seam->worst[1], 1,
                 w->bend_allowed + seam->doubt[1]);
  }
}

/* ---- all edges ----------------------------------------------------------- */

static double length_of(const struct ph_check_patchwork *w,
                        const struct ph_check_side *side) {
  ph_vec3 end[2];
  for (size_t i = 0; i < 2; i++) {
    const double *at =
        ph_check_patch_point(w->curve, side->patch, (side->k + i) % 4);
    end[i] = ph_check_vector(w->v, at, 3);
  }
  return ph_check_apart(end[0], end[1]);
}

/* Which edges have two patches.  ret whether none has more */
static bool set_seams(struct ph_check_patchwork *w) {
  const size_t n = 4 * w->curve->n;
  w->closed = w->oriented = true;
  for (size_t i = 0; i < n; i++) {
    const struct ph_check_side *side = &w->sides[i];
    const bool two = i + 1 < n && is_same_edge(side, side + 1);
    if (two && i + 2 < n && is_same_edge(side, side + 2)) {
      ph_check_wrong(w->v, PH_CHECK_SHAPE,
                     ph_check_of("patches", side[2].patch, "vertices"),
                     "are at an edge of two other patches");
      return false;
    }
    if (two) {
      w->oriented = w->oriented && is_back(w, side) != is_back(w, side + 1);
      w->seams[w->seams_n++] =
          (struct ph_check_seam){.low = side->low,
                                 .high = side->high,
                                 .side = i,
                                 .length = length_of(w, side)};
      i++;
    } else {
      w->closed = false;
    }
  }
  return true;
}

enum ph_status ph_check_patch_edges(struct ph_check_patchwork *w) {
  const struct ph_arena *scratch = w->v->scratch;
  if (!set_seams(w)) {
    return PH_OK;
  }
  ph_team_share(scratch, w->seams_n, WORTH, CHUNK, compare_some, w);
  for (size_t i = 0; i < w->seams_n; i++) {
    note(w, &w->seams[i]);
  }
  return ph_arena_late(scratch) ? ph_fail_memory(w->v->diag) : PH_OK;
}
