/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Patches at their edges and corners (see bubble.h). */
#include "check/bubble.h"

#include "check/certify.h"
#include "check/data.h"

#include <float.h>
#include <stdlib.h>
#include <string.h>

/* Of points, in the rounding of coordinates. */
enum { ROUND = 64 };

/* Places of an edge. */
enum { PLACES = 16 };

/* Control points of a side: so many by one parameter at most. */
enum { MOST = 64 };

/* What a certificate allows: the angle of a normal to that of its point. */
static const double NORMAL = 1e-9;

/* Normals that are known to less than this say nothing. */
static const double VAGUE = 1e-3;

/* The field tolerance where it is absent, and what of it curvatures may have,
 * over the length of the edge. */
static const double TOLERANCE = 1e-6, CURVATURE = 1000;

static struct ph_check_where patch_of(size_t i, const char *member) {
  return ph_check_of("patches", i, member);
}

/* ---- arrays -------------------------------------------------------------- */

static const char *fault_of_vertices(const struct ph_patch *p,
                                     const char **member) {
  *member = "vertices";
  for (size_t k = 0; k < 4; k++) {
    for (size_t j = 0; j < k; j++) {
      if (p->vertices[k] == p->vertices[j]) {
        return "are not four";
      }
    }
  }
  return NULL;
}

/* Why a patch is none, or NULL. */
static const char *fault_of(const struct ph_patch *p, bool exact,
                            const char **member) {
  *member = "bidegree";
  if (exact) {
    return fault_of_vertices(p, member);
  }
  if (p->bidegree[0] >= MOST || p->bidegree[1] >= MOST) {
    return "is too high";
  }
  *member = "control_points";
  if (p->points_n != (p->bidegree[0] + 1) * (p->bidegree[1] + 1)) {
    return "are not as many as the bidegree says";
  }
  if (!ph_are_finite(p->control_points, 3 * p->points_n)) {
    return "hold what is not finite";
  }
  return fault_of_vertices(p, member);
}

bool ph_check_patch_exact(const struct ph_curve *c) {
  for (size_t i = 0; i < c->n; i++) {
    const struct ph_patch *p = &c->surface.patches[i];
    if (p->points_n || p->bidegree[0] != PH_NO_SEGMENT) {
      return false;
    }
  }
  return true;
}

bool ph_check_patch_arrays(struct ph_check *v, const struct ph_curve *c) {
  const bool exact = ph_check_patch_exact(c);
  for (size_t i = 0; i < c->n; i++) {
    const char *member;
    const char *fault = fault_of(&c->surface.patches[i], exact, &member);
    if (fault && v->error) {
      v->status =
          ph_fail_at(v->diag, PH_E_TOO_LARGE, "patches", i, "%s", fault);
      return false;
    }
    if (fault) {
      ph_check_wrong(v, PH_CHECK_SHAPE, patch_of(i, member), fault);
      return false;
    }
  }
  return true;
}

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

static enum ph_status set_sides(struct ph_check_patchwork *w) {
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
  const bool back = p->vertices[side->k] != side->low;
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

/* The second fundamental form as a tensor, by the dual of the tangents. */
static void set_form(struct local *at, ph_vec3 s, ph_vec3 w, ph_vec3 ss,
                     ph_vec3 sw, ph_vec3 ww) {
  const double ee = ph_vec3_dot(s, s), ff = ph_vec3_dot(s, w);
  const double gg = ph_vec3_dot(w, w), det = ee * gg - ff * ff;
  const ph_vec3 a = ph_vec3_along(ph_vec3_scale(gg / det, s), -ff / det, w);
  const ph_vec3 b = ph_vec3_along(ph_vec3_scale(ee / det, w), -ff / det, s);
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

static void set_local(const struct layers *layers, double u, struct local *at) {
  const double n = (double)layers->across, m = (double)layers->along;
  ph_vec3 jet[3][3], w, sw, ww, cross;
  double area, across;
  for (size_t j = 0; j < 3 && j <= layers->across; j++) {
    evaluate(layers->c[j], layers->along, u, jet[j]);
  }
  w = ph_vec3_scale(n, ph_vec3_sub(jet[1][0], jet[0][0]));
  sw = ph_vec3_scale(n, ph_vec3_sub(jet[1][1], jet[0][1]));
  ww = layers->across < 2
           ? ph_vec3_of(0, 0, 0)
           : ph_vec3_scale(n * (n - 1),
                           ph_vec3_add(ph_vec3_sub(jet[2][0], jet[1][0]),
                                       ph_vec3_sub(jet[0][0], jet[1][0])));
  cross = ph_vec3_cross(jet[0][1], w);
  area = ph_vec3_abs(cross);
  at->p = jet[0][0];
  at->normal = ph_vec3_scale(1 / area, cross);
  set_form(at, jet[0][1], w, jet[0][2], sw, ww);
  across =
      ph_check_smaller(area / ph_vec3_abs(jet[0][1]), area / ph_vec3_abs(w));
  at->rounding = 2 * (m + n) / across;
  at->noise = 4 * (m + n) * (m + n) / (across * across) +
              4 * size_of(at->form) * at->rounding;
}

/* ---- edges --------------------------------------------------------------- */

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

static void check_place(struct ph_check_patchwork *w, size_t patch,
                        double length, const struct local *a,
                        const struct local *b, struct ph_check_seam *seam) {
  const struct ph_check *v = w->v;
  const double gap = ph_check_apart(a->p, b->p);
  const double angle = angle_of(a->normal, b->normal);
  const double bend = length * bend_of(a, b);
  const double noise = ROUND * v->scale.rounding;
  const double noises[] = {noise * (a->rounding + b->rounding),
                           length * noise * (a->noise + b->noise)};
  for (size_t i = 0; i < 2; i++) {
    seam->value[i] = ph_check_larger(seam->value[i], i ? bend : angle);
    seam->noise[i] = ph_check_larger(seam->noise[i], noises[i]);
  }
  ph_check_miss(w->v, PH_CHECK_CONTINUITY, patch_of(patch, "control_points"),
                gap, v->scale.size, noise, "leaves a gap at an edge");
  if (w->curve->surface.continuity == 0) {
    if (angle >= 0) { /* a corner may be degenerate */
      ph_check_add(&w->jump, patch, angle, 1, HUGE_VAL);
    }
    return;
  }
  ph_check_add(&w->jump, patch, angle, 1, w->jump_allowed + noises[0]);
  ph_check_add(&w->bend, patch, bend, 1, w->bend_allowed + noises[1]);
}

static void check_edge(struct ph_check_patchwork *w,
                       const struct ph_check_side *side) {
  struct ph_check_seam *seam = &w->seams[w->seams_n++];
  struct layers layers[2];
  double length;
  bool back[2];
  *seam = (struct ph_check_seam){.low = side->low, .high = side->high};
  for (size_t i = 0; i < 2; i++) {
    set_layers(w, side + i, &layers[i]);
    back[i] = w->curve->surface.patches[side[i].patch].vertices[side[i].k] !=
              side->low;
  }
  w->oriented = w->oriented && back[0] != back[1];
  length = ph_check_apart(layers[0].c[0][0], layers[0].c[0][layers[0].along]);
  for (size_t i = 0; i < PLACES; i++) {
    const double u = ((double)i + 0.5) / PLACES;
    struct local a, b;
    set_local(&layers[0], u, &a);
    set_local(&layers[1], u, &b);
    check_place(w, side->patch, length, &a, &b, seam);
  }
}

enum ph_status ph_check_patch_edges(struct ph_check_patchwork *w) {
  const size_t n = 4 * w->curve->n;
  enum ph_status status = set_sides(w);
  w->closed = w->oriented = true;
  for (size_t i = 0; status == PH_OK && i < n; i++) {
    const bool two = i + 1 < n && is_same_edge(&w->sides[i], &w->sides[i + 1]);
    if (two && i + 2 < n && is_same_edge(&w->sides[i], &w->sides[i + 2])) {
      ph_check_wrong(w->v, PH_CHECK_SHAPE,
                     patch_of(w->sides[i + 2].patch, "vertices"),
                     "are at an edge of two other patches");
      return PH_OK;
    }
    if (two) {
      check_edge(w, &w->sides[i]);
      i++;
    } else {
      w->closed = false;
    }
    if (ph_arena_late(w->v->scratch)) {
      return ph_fail_memory(w->v->diag);
    }
  }
  return status;
}

/* ---- corners ------------------------------------------------------------- */

/* Corner k of a patch, and the normal there. */
static ph_vec3 corner_of(const struct ph_check_patchwork *w,
                         const struct ph_patch *p, size_t k, ph_vec3 *normal) {
  const size_t width = p->bidegree[0] + 1, high = p->bidegree[1] + 1;
  const bool right = k == 1 || k == 2, top = k >= 2;
  const size_t at = (right ? width - 1 : 0) + (top ? width * (high - 1) : 0);
  const size_t beside = right ? at - 1 : at + 1;
  const size_t above = top ? at - width : at + width;
  const ph_vec3 c = ph_check_vector(w->v, p->control_points + 3 * at, 3);
  *normal = ph_vec3_cross(
      ph_vec3_sub(ph_check_vector(w->v, p->control_points + 3 * beside, 3), c),
      ph_vec3_sub(ph_check_vector(w->v, p->control_points + 3 * above, 3), c));
  return c;
}

static void check_corner(struct ph_check_patchwork *w, size_t i, size_t k) {
  const struct ph_check *v = w->v;
  const struct ph_patch *p = &w->curve->surface.patches[i];
  const struct ph_value *points = &v->problem->field[PH_F_POINTS];
  const struct ph_value *normals = &v->problem->field[PH_F_NORMALS];
  const double rounding = ROUND * v->scale.rounding;
  ph_vec3 normal;
  const ph_vec3 at = corner_of(w, p, k, &normal);
  ph_check_miss(
      w->v, PH_CHECK_INTERPOLATION, patch_of(i, "control_points"),
      ph_check_apart(at, ph_check_vector(v, points->v + 3 * p->vertices[k], 3)),
      v->scale.size, rounding, "miss a point that is given");
  if (normals->kind == PH_VECTORS && w->curve->surface.continuity > 0) {
    const ph_vec3 given =
        ph_check_direction(normals->v + 3 * p->vertices[k], 3);
    const double doubt = rounding * v->scale.size / ph_vec3_abs(normal);
    if (doubt <= VAGUE) { /* else the sides are in line: there is a limit */
      ph_check_add(&w->normal, i, angle_of(normal, given), 1, NORMAL + doubt);
    }
  }
}

/* Whether a patch is over the face that it says. */
static bool is_over(const struct ph_patch *p,
                    const struct ph_problem *problem) {
  const struct ph_value *faces = &problem->field[PH_F_FACES];
  bool same = p->face < faces->sizes_n && 4 * faces->sizes_n == faces->n;
  for (size_t k = 0; same && k < 4; k++) {
    const double vertex = faces->v[4 * p->face + k];
    same = vertex >= (double)p->vertices[k] &&
           vertex <= (double)p->vertices[k] &&
           p->vertices[k] < problem->field[PH_F_POINTS].n;
  }
  return same;
}

/* Of a mesh that was subdivided, how many patches there must be: its points
 * have moved. */
static void check_subdivided(struct ph_check_patchwork *w,
                             const struct ph_problem *problem) {
  double n = (double)problem->field[PH_F_FACES].n;
  for (double step = 1;
       n <= (double)w->curve->n && step < problem->field[PH_F_SUBDIVIDE].number;
       step++) {
    n *= 4;
  }
  if ((double)w->curve->n < n || (double)w->curve->n > n) {
    ph_check_wrong(w->v, PH_CHECK_SHAPE,
                   ph_check_of("patches", PH_CHECK_ONE, NULL),
                   "are not as many as the steps make of the faces");
  }
}

void ph_check_patch_corners(struct ph_check_patchwork *w) {
  const struct ph_problem *problem = w->v->problem;
  const struct ph_value *points = &problem->field[PH_F_POINTS];
  const struct ph_value *normals = &problem->field[PH_F_NORMALS];
  const bool fits = points->kind == PH_VECTORS && points->dimension == 3 &&
                    (normals->kind != PH_VECTORS ||
                     (normals->n == points->n && normals->dimension == 3)) &&
                    problem->field[PH_F_FACES].sizes_n == w->curve->n;
  const bool exact = ph_check_patch_exact(w->curve);
  if (problem->field[PH_F_SUBDIVIDE].number > 0) {
    check_subdivided(w, problem);
    return;
  }
  for (size_t i = 0; i < w->curve->n; i++) {
    if (!fits || !is_over(&w->curve->surface.patches[i], problem)) {
      ph_check_wrong(w->v, PH_CHECK_SHAPE, patch_of(i, "vertices"),
                     "are not those of the face in the problem");
      return;
    }
    for (size_t k = 0; !exact && k < 4; k++) {
      check_corner(w, i, k);
    }
  }
}

/* ---- certificate --------------------------------------------------------- */

/* The scale is that of all control points at corners. */
static bool set_scale(struct ph_check *v, enum ph_status *status) {
  const struct ph_curve *c = v->curve;
  double *p = ph_arena_array(v->scratch, 12 * c->n, sizeof *p);
  if (!p) {
    *status = ph_fail_memory(v->diag);
    return false;
  }
  for (size_t i = 0; i < c->n; i++) {
    const struct ph_patch *patch = &c->surface.patches[i];
    const size_t width = patch->bidegree[0] + 1;
    const size_t at[] = {0, width - 1, patch->points_n - width,
                         patch->points_n - 1};
    for (size_t k = 0; k < 4; k++) {
      memcpy(p + 12 * i + 3 * k, patch->control_points + 3 * at[k],
             3 * sizeof *p);
    }
  }
  if (!ph_check_scale_of(p, 4 * c->n, 3, &v->scale)) {
    ph_check_wrong(v, PH_CHECK_SHAPE,
                   ph_check_of("patches", PH_CHECK_ONE, NULL),
                   "have no extent");
    return false;
  }
  return true;
}

/* By how much normals may jump: as the problem asks for it, if it does. */
static void set_allowed(struct ph_check_patchwork *w) {
  const struct ph_problem *p = w->v->problem;
  const struct ph_value *tolerance = &p->field[PH_F_TOLERANCE];
  const double own =
      tolerance->kind == PH_NUMBER ? tolerance->number : TOLERANCE;
  const bool bound = p->field[PH_F_DEGREE].kind != PH_NUMBER;
  w->jump_allowed = bound ? own : HUGE_VAL;
  w->bend_allowed =
      bound && w->curve->surface.continuity == 2 ? CURVATURE * own : HUGE_VAL;
}

enum ph_status ph_check_bubble(struct ph_check *v,
                               struct ph_diagnostics *diagnostics) {
  struct ph_check_error error[PH_CHECK_N] = {{.done = false}};
  struct ph_check_error *continuity = &error[PH_CHECK_CONTINUITY];
  struct ph_check_error *points = &error[PH_CHECK_INTERPOLATION];
  struct ph_check_patchwork w = {.v = v, .curve = v->curve};
  const struct ph_check_error *list[] = {points, continuity, &w.normal, &w.jump,
                                         &w.bend};
  const size_t lists = sizeof list / sizeof list[0];
  enum ph_status status = PH_OK;
  v->error = error;
  points->what = PH_D_INTERPOLATION_ERROR;
  continuity->what = PH_D_CONTINUITY_ERROR;
  w.normal.what = PH_D_NORMAL_ERROR;
  w.jump.what = PH_D_NORMAL_JUMP;
  w.bend.what = PH_D_CURVATURE_JUMP;
  if (!ph_check_patch_arrays(v, v->curve)) {
    return v->status;
  }
  if (ph_check_patch_exact(v->curve)) {
    ph_check_patch_corners(&w);
    return v->status;
  }
  if (!set_scale(v, &status)) {
    return status == PH_OK ? v->status : status;
  }
  set_allowed(&w);
  ph_check_patch_corners(&w);
  status = ph_check_patch_edges(&w);
  for (size_t i = 0; i < lists; i++) {
    ((struct ph_check_error *)list[i])->list = "patches";
    list[i] = list[i]->done ? list[i] : NULL;
  }
  if (status != PH_OK || v->status != PH_OK) {
    return status != PH_OK ? status : v->status;
  }
  return ph_check_conclude(list, lists, diagnostics, v->diag);
}

/* ---- verification -------------------------------------------------------- */

enum ph_status ph_check_patchwork(struct ph_check *v) {
  struct ph_check_patchwork w = {.v = v, .curve = v->curve};
  enum ph_status status = PH_OK;
  const char *member, *breach;
  ph_check_done(v, PH_CHECK_SHAPE);
  breach = ph_promise_breach(v->promise, v->curve, &member);
  if (breach) {
    ph_check_wrong(v, PH_CHECK_SHAPE, ph_check_of(NULL, PH_CHECK_ONE, member),
                   breach);
    return PH_OK;
  }
  if (!ph_check_patch_arrays(v, v->curve)) {
    return status;
  }
  if (ph_check_patch_exact(v->curve)) {
    if (v->problem) {
      ph_check_patch_corners(&w);
    }
    return PH_OK;
  }
  if (!set_scale(v, &status)) {
    return status;
  }
  w.jump_allowed = w.bend_allowed = HUGE_VAL;
  if (v->problem) {
    set_allowed(&w);
    ph_check_patch_corners(&w);
  }
  status = ph_check_patch_edges(&w);
  return status == PH_OK ? ph_check_patch_told(&w) : status;
}
