/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What patches differ by at their edges (see places.h). */
#include "curve/surface/places.h"

#include <math.h>
#include <string.h>

/* Places of an edge: those of the certificate; and the ends of sides. */
enum { PLACES = 16, ALL = PLACES + 2 };

/* What is seen of an edge from the one patch and from the other. */
struct local {
  ph_vec3 p, normal;
  double form[6]; /* the second fundamental form in space */
};

struct seen {
  struct local at[PLACES];
};

static void set_local(const struct ph_patch_jet *jet, double u, double v,
                      struct local *at) {
  const ph_vec3 normal = ph_patch_normal(jet, u, v);
  const ph_vec3 a = ph_vec3_scale(1 / ph_vec3_abs(jet->u), jet->u);
  const ph_vec3 b = ph_vec3_cross(normal, a);
  double f[3];
  ph_vec3 x, y;
  ph_patch_bend(jet, normal, f);
  x = ph_vec3_along(ph_vec3_scale(f[0], a), f[1], b);
  y = ph_vec3_along(ph_vec3_scale(f[1], a), f[2], b);
  at->p = jet->p;
  at->normal = normal;
  at->form[0] = a.x * x.x + b.x * y.x;
  at->form[1] = a.y * x.y + b.y * y.y;
  at->form[2] = a.z * x.z + b.z * y.z;
  at->form[3] = a.x * x.y + b.x * y.y;
  at->form[4] = a.x * x.z + b.x * y.z;
  at->form[5] = a.y * x.z + b.y * y.z;
}

/* Side k of the face, from its lower point on; j counts along it. */
static void look(const struct ph_places *places, size_t k, bool back, size_t j,
                 struct local *to) {
  const size_t along = (k < 2) != back ? j : PLACES - 1 - j;
  const size_t i = k == 1 ? ALL - 1 : k == 3 ? 0 : along + 1;
  struct ph_patch_jet jet;
  ph_places_jet(places, i, &jet);
  set_local(&jet, places->at[i], places->at[places->j], to);
}

/* What was seen of all edges, from both sides. */
struct seer {
  const struct ph_mesh *mesh;
  struct seen *seen; /* [edges][2] */
};

/* All four sides of a patch: that number `line' of its lines has of them. */
static bool look_around(void *context, struct ph_places *places) {
  const struct seer *seer = context;
  const struct ph_mesh *mesh = seer->mesh;
  const size_t face = places->patch;
  for (size_t line = 0; line < ALL; line++) {
    ph_places_line(places, line);
    for (size_t k = 0; k < 4; k++) {
      const struct ph_mesh_edge *e = &mesh->edge[mesh->side[face][k]];
      const bool back = mesh->face[face][k] != e->point[0];
      struct seen *to =
          &seer->seen[2 * mesh->side[face][k] + (e->face[0] != face)];
      if (k % 2 == 0 && line == (k ? ALL - 1 : 0)) {
        for (size_t j = 0; j < PLACES; j++) {
          look(places, k, back, j, &to->at[j]);
        }
      } else if (k % 2 == 1 && line > 0 && line < ALL - 1) {
        const size_t j = (k == 1) != back ? line - 1 : PLACES - line;
        look(places, k, back, j, &to->at[j]);
      }
    }
  }
  return true;
}

static double larger(double a, double b) {
  return b <= a ? a : b; /* NaN is larger */
}

static void compare(const struct seen *a, const struct seen *b, double length,
                    struct ph_patch_edge *to) {
  to->normal_jump = to->curvature_jump = to->gap = 0;
  for (size_t j = 0; j < PLACES; j++) {
    const ph_vec3 m = a->at[j].normal, n = b->at[j].normal;
    const double cosine = ph_vec3_dot(m, n), sign = cosine < 0 ? -1 : 1;
    double sum = 0;
    for (size_t i = 0; i < 6; i++) {
      const double d = a->at[j].form[i] - sign * b->at[j].form[i];
      sum += (i < 3 ? 1 : 2) * d * d;
    }
    to->gap = larger(to->gap, ph_vec3_abs(ph_vec3_sub(a->at[j].p, b->at[j].p)));
    to->normal_jump = larger(
        to->normal_jump, atan2(ph_vec3_abs(ph_vec3_cross(m, n)), fabs(cosine)));
    to->curvature_jump = larger(to->curvature_jump, length * sqrt(sum));
  }
}

/* The ribbon of an edge, in the unit of the data. */
static bool set_ribbon(const struct ph_patchwork *work, size_t e,
                       struct ph_arena *arena, struct ph_patch_strip *to) {
  const struct ph_ribbon *ribbon = &work->ribbons[e];
  const struct ph_pow2 from = ph_pow2_of(-work->exponent);
  const struct ph_pow2 back = ph_pow2_of(work->exponent);
  to->height_n = ph_ribbon_height_degree(work->continuity) + 1;
  to->gradient_n = ph_ribbon_gradient_degree(work->continuity) + 1;
  to->hessian_n = work->continuity == 2 ? PH_RIBBON_HESSIAN : 0;
  to->height = ph_arena_array(arena, to->height_n, sizeof *to->height);
  to->gradient = ph_arena_array(arena, to->gradient_n, 3 * sizeof(double));
  to->hessian = ph_arena_array(arena, to->hessian_n, 6 * sizeof(double));
  if (!to->height || !to->gradient || !to->hessian) {
    return false;
  }
  for (size_t i = 0; i < to->height_n; i++) {
    to->height[i] = ph_pow2_apply(from, ribbon->height[i]);
  }
  for (size_t i = 0; i < 3 * to->gradient_n; i++) {
    to->gradient[i] = ribbon->gradient[i % 3][i / 3];
  }
  for (size_t i = 0; i < 6 * to->hessian_n; i++) {
    const double h = ph_pow2_apply(back, ribbon->hessian[i % 6][i / 6]);
    to->hessian[i] = isfinite(h) ? h : (double)NAN;
  }
  return true;
}

static enum ph_status conclude(const struct ph_patchwork *work,
                               const struct seen *seen, struct ph_arena *arena,
                               struct ph_patch_edges *edges,
                               struct ph_diag *diag) {
  const struct ph_mesh *mesh = &work->mesh;
  const struct ph_pow2 from = ph_pow2_of(-work->exponent);
  for (size_t e = 0; e < mesh->edges_n; e++) {
    const struct ph_mesh_edge *edge = &mesh->edge[e];
    struct ph_patch_edge *to = &edges->v[e];
    const double length = ph_vec3_abs(
        ph_vec3_sub(work->at[edge->point[1]].p, work->at[edge->point[0]].p));
    *to = (struct ph_patch_edge){.normal_jump = (double)NAN,
                                 .curvature_jump = (double)NAN,
                                 .gap = (double)NAN};
    memcpy(to->vertices, edge->point, sizeof to->vertices);
    to->faces = work->mesh.edge[e].face;
    to->faces_n = edge->face[1] == PH_NO_FACE ? 1 : 2;
    if (to->faces_n == 2) {
      compare(&seen[2 * e], &seen[2 * e + 1], length, to);
      to->gap = ph_pow2_apply(from, to->gap);
    }
    if (work->continuity > 0 && !set_ribbon(work, e, arena, &to->strip)) {
      return ph_fail_memory(diag);
    }
  }
  return PH_OK;
}

enum ph_status ph_patch_edges_of(const struct ph_curve *curve,
                                 struct ph_arena *arena,
                                 struct ph_patch_edges *edges,
                                 struct ph_diag *diag) {
  const struct ph_patchwork *work = curve->surface.base;
  struct ph_arena scratch = ph_arena_beside(arena);
  struct seer seer = {.mesh = &work->mesh};
  double at[ALL] = {0};
  enum ph_status status;
  for (size_t j = 0; j < PLACES; j++) {
    at[j + 1] = ((double)j + 0.5) / PLACES;
  }
  at[ALL - 1] = 1;
  edges->n = work->mesh.edges_n;
  edges->v = ph_arena_array(arena, edges->n, sizeof *edges->v);
  seer.seen = ph_arena_array(&scratch, 2 * edges->n, sizeof *seer.seen);
  status = edges->v && seer.seen ? ph_places_spread(curve, at, ALL, &scratch,
                                                    look_around, &seer, diag)
                                 : ph_fail_memory(diag);
  if (status == PH_OK) {
    status = conclude(work, seer.seen, arena, edges, diag);
  }
  ph_arena_free(&scratch);
  return status;
}
