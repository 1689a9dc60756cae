/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Patches at their edges and corners (see bubble.h). */
#include "check/bubble_exact.h"

#include "check/certify.h"
#include "check/data.h"

#include <float.h>
#include <string.h>

enum { ROUND = PH_CHECK_PATCH_ROUND, MOST = PH_CHECK_PATCH_MOST };

/* What a certificate allows: the angle of a normal to that of its point. */
static const double NORMAL = 1e-9;

/* Normals that are known to less than this say nothing. */
static const double VAGUE = 1e-3;

/* What both sides say of a corner may differ by so much. */
static const double FIT = 1e-9;

/* The corner of a patch, at u and v, that vertex k of a face is. */
static const size_t CORNER[] = {0, 1, 3, 2};

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

/* Whether no patch has control points: they are quotients (bubble_exact.h). */
static bool is_exact(const struct ph_curve *c) {
  for (size_t i = 0; i < c->n; i++) {
    const struct ph_patch *p = &c->surface.patches[i];
    if (p->points_n || p->bidegree[0] != PH_NO_SEGMENT) {
      return false;
    }
  }
  return true;
}

/* Whether patches are such, with finite numbers. */
static bool are_arrays(struct ph_check *v, const struct ph_curve *c) {
  const bool exact = is_exact(c);
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

struct ph_check_where ph_check_patch_where(const struct ph_check_patchwork *w,
                                           size_t patch) {
  return patch_of(patch, w->edges ? NULL : "control_points");
}

/* ---- corners ------------------------------------------------------------- */

/* The control point of vertex k of a patch, and its neighbours. */
static const double *corner_of(const struct ph_patch *p, size_t k,
                               const double *beside[2]) {
  const size_t width = p->bidegree[0] + 1, high = p->bidegree[1] + 1;
  const bool right = k == 1 || k == 2, top = k >= 2;
  const size_t at = (right ? width - 1 : 0) + (top ? width * (high - 1) : 0);
  beside[0] = p->control_points + 3 * (right ? at - 1 : at + 1);
  beside[1] = p->control_points + 3 * (top ? at - width : at + width);
  return p->control_points + 3 * at;
}

const double *ph_check_patch_point(const struct ph_curve *curve, size_t i,
                                   size_t k) {
  const struct ph_surface *s = &curve->surface;
  const double *beside[2];
  return s->patches[i].points_n ? corner_of(&s->patches[i], k, beside)
                                : s->vertices[s->patches[i].vertices[k]].point;
}

/* The angle between two lines. */
static double angle_of(ph_vec3 a, ph_vec3 b) {
  return atan2(ph_vec3_abs(ph_vec3_cross(a, b)), fabs(ph_vec3_dot(a, b)));
}

/* The angle of a normal to the surface at a corner with these legs. */
static void check_normal(struct ph_check_patchwork *w, size_t i, ph_vec3 u,
                         ph_vec3 v, ph_vec3 given) {
  const struct ph_check_scale *scale = &w->v->scale;
  const ph_vec3 normal = ph_vec3_cross(u, v);
  const double doubt =
      ROUND * scale->rounding * scale->size / ph_vec3_abs(normal);
  if (doubt <= VAGUE) { /* else the sides are in line: there is a limit */
    ph_check_add(&w->normal, i, angle_of(normal, given), 1, NORMAL + doubt);
  }
}

static void check_corner(struct ph_check_patchwork *w, size_t i, size_t k) {
  const struct ph_check *v = w->v;
  const struct ph_patch *p = &w->curve->surface.patches[i];
  const struct ph_value *points = &v->problem->field[PH_F_POINTS];
  const struct ph_value *normals = &v->problem->field[PH_F_NORMALS];
  const ph_vec3 at =
      ph_check_vector(v, ph_check_patch_point(w->curve, i, k), 3);
  ph_vec3 given;
  ph_check_miss(
      w->v, PH_CHECK_INTERPOLATION, ph_check_patch_where(w, i),
      ph_check_apart(at, ph_check_vector(v, points->v + 3 * p->vertices[k], 3)),
      v->scale.size, ROUND * v->scale.rounding, "miss a point that is given");
  if (normals->kind != PH_VECTORS || w->curve->surface.continuity == 0) {
    return;
  }
  given = ph_check_direction(normals->v + 3 * p->vertices[k], 3);
  if (w->edges) { /* which is held against the surface elsewhere */
    ph_check_add(
        &w->normal, i,
        angle_of(
            ph_vec3_get(w->curve->surface.vertices[p->vertices[k]].normal, 3),
            given),
        1, NORMAL);
  } else {
    const double *beside[2];
    corner_of(p, k, beside);
    check_normal(w, i, ph_vec3_sub(ph_check_vector(v, beside[0], 3), at),
                 ph_vec3_sub(ph_check_vector(v, beside[1], 3), at), given);
  }
}

/* Whether both sides at a corner say the same of it: the height's Taylor
 * coefficients there, relative to what they are made of. */
static double miss_of(const struct ph_check_quotient *patch, size_t corner) {
  const size_t k = corner & 1, l = corner >> 1;
  const struct ph_check_cross *along = &patch->side[l].end[k];
  const struct ph_check_cross *across = &patch->side[2 + k].end[l];
  double miss = 0, size = 0;
  for (size_t i = 0; i <= patch->continuity; i++) {
    for (size_t j = 0; j <= patch->continuity; j++) {
      const double a = along->h[j][i], b = across->h[i][j];
      miss = ph_check_is_larger(fabs(a - b), miss) ? fabs(a - b) : miss;
      size = ph_check_larger(size, fabs(a));
    }
  }
  return miss / (size + ph_check_apart(patch->p[corner], patch->p[corner ^ 3]));
}

/* The place of a corner, by the ends of its sides. */
static void set_corner(const struct ph_check_quotient *patch, size_t corner,
                       struct ph_check_place *at) {
  const size_t end[] = {corner & 1, corner >> 1};
  struct ph_check_node node[2];
  struct ph_check_cross cross[2][2];
  for (size_t d = 0; d < 2; d++) {
    ph_check_node_at(patch->continuity, (double)end[d], &node[d]);
    for (size_t k = 0; k < 2; k++) {
      cross[d][k] = patch->side[2 * d + k].end[end[d]];
    }
  }
  ph_check_quotient_at(patch, &node[0], (const struct ph_check_cross *)cross[0],
                       &node[1], (const struct ph_check_cross *)cross[1], at);
}

/* Whether the quotients have the points and normals of their vertices. */
static void check_vertices(struct ph_check_patchwork *w, size_t i) {
  const struct ph_surface *s = &w->curve->surface;
  struct ph_check_quotient patch;
  ph_check_quotient_begin(w, i, &patch);
  for (size_t k = 0; k < 4; k++) {
    const struct ph_patch_vertex *vertex =
        &s->vertices[s->patches[i].vertices[k]];
    struct ph_check_place at;
    set_corner(&patch, CORNER[k], &at);
    if (!w->v->error) { /* what was solved has one quadric there */
      ph_check_miss(w->v, PH_CHECK_CONTINUITY, patch_of(i, NULL),
                    s->continuity ? miss_of(&patch, CORNER[k]) : 0, 1, FIT,
                    "has sides that do not fit at a corner");
    }
    ph_check_miss(
        w->v, PH_CHECK_INTERPOLATION, patch_of(i, NULL),
        ph_check_apart(at.x[0][0], ph_check_vector(w->v, vertex->point, 3)),
        w->v->scale.size, ROUND * w->v->scale.rounding,
        "misses one of its vertices");
    if (s->continuity > 0) {
      check_normal(w, i, at.x[1][0], at.x[0][1],
                   ph_vec3_get(vertex->normal, 3));
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

/* interpolation_error, and with normals of the problem the angles of these to
 * the tangent planes. */
static void check_corners(struct ph_check_patchwork *w) {
  const struct ph_problem *problem = w->v->problem;
  const struct ph_value *points = &problem->field[PH_F_POINTS];
  const struct ph_value *normals = &problem->field[PH_F_NORMALS];
  const bool fits = points->kind == PH_VECTORS && points->dimension == 3 &&
                    (normals->kind != PH_VECTORS ||
                     (normals->n == points->n && normals->dimension == 3)) &&
                    problem->field[PH_F_FACES].sizes_n == w->curve->n;
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
    for (size_t k = 0; k < 4; k++) {
      check_corner(w, i, k);
    }
  }
}

/* ---- certificate --------------------------------------------------------- */

/* The scale is that of all corners. */
static bool set_scale(struct ph_check *v, enum ph_status *status) {
  const struct ph_curve *c = v->curve;
  double *p = ph_arena_array(v->scratch, 12 * c->n, sizeof *p);
  if (!p) {
    *status = ph_fail_memory(v->diag);
    return false;
  }
  for (size_t i = 0; i < 4 * c->n; i++) {
    memcpy(p + 3 * i, ph_check_patch_point(c, i / 4, i % 4), 3 * sizeof *p);
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

/* What certificate and verification look at.
 * ret  whether what was found says something */
static bool look(struct ph_check_patchwork *w, enum ph_status *status) {
  struct ph_check *v = w->v;
  bool good = are_arrays(v, v->curve);
  w->jump_allowed = w->bend_allowed = HUGE_VAL;
  *status = good ? ph_check_patch_sides(w) : PH_OK;
  if (*status == PH_OK && good && is_exact(v->curve)) {
    *status = ph_check_patch_strips(w, &good);
  }
  if (*status != PH_OK || !good || !set_scale(v, status)) {
    return false;
  }
  if (v->problem) {
    set_allowed(w);
    check_corners(w);
  }
  for (size_t i = 0; w->edges && i < v->curve->n; i++) {
    check_vertices(w, i);
  }
  *status = ph_check_patch_edges(w);
  return *status == PH_OK;
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
  enum ph_status status;
  v->error = error;
  points->what = PH_D_INTERPOLATION_ERROR;
  continuity->what = PH_D_CONTINUITY_ERROR;
  w.normal.what = PH_D_NORMAL_ERROR;
  w.jump.what = PH_D_NORMAL_JUMP;
  w.bend.what = PH_D_CURVATURE_JUMP;
  if (!look(&w, &status) || v->status != PH_OK) {
    return status == PH_OK ? v->status : status;
  }
  for (size_t i = 0; i < lists; i++) {
    ((struct ph_check_error *)list[i])->list = "patches";
    list[i] = list[i]->done ? list[i] : NULL;
  }
  return ph_check_conclude(list, lists, diagnostics, v->diag);
}

/* ---- verification -------------------------------------------------------- */

enum ph_status ph_check_patchwork(struct ph_check *v) {
  struct ph_check_patchwork w = {.v = v, .curve = v->curve};
  enum ph_status status = PH_OK;
  if (!ph_check_is_promised(v)) {
    return PH_OK;
  }
  return look(&w, &status) ? ph_check_patch_told(&w) : status;
}
