/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The mesh of a problem, and its normals (see bubble.h). */
#include "solve/bubble/bubble.h"
#include "solve/common/fields.h"

#include <float.h>
#include <math.h>

/* ---- faces --------------------------------------------------------------- */

static enum ph_status set_index(const struct ph_bubble_data *data, size_t i,
                                size_t k, double x, struct ph_diag *diag) {
  size_t *face = data->mesh.face[i];
  if (!(x >= 0) || !(x < (double)data->mesh.points_n) || floor(x) < x) {
    return ph_fail_at(diag, PH_E_BAD_VALUE, "faces", i,
                      "must have numbers of points, whole and from 0 to %zu, "
                      "found %.17g",
                      data->mesh.points_n - 1, x);
  }
  face[k] = (size_t)x;
  for (size_t j = 0; j < k; j++) {
    if (face[j] == face[k]) {
      return ph_fail_at(diag, PH_E_BAD_VALUE, "faces", i,
                        "has points[%zu] twice", face[k]);
    }
  }
  return PH_OK;
}

static enum ph_status set_faces(const struct ph_problem *p,
                                struct ph_arena *arena,
                                struct ph_bubble_data *data,
                                struct ph_diag *diag) {
  const struct ph_value *faces = &p->field[PH_F_FACES];
  const double *v = faces->v;
  data->mesh.faces_n = faces->sizes_n;
  if (faces->sizes_n == 0) {
    return ph_fail(diag, PH_E_BAD_SHAPE, "faces", "must have one or more");
  }
  data->mesh.face =
      ph_arena_array(arena, faces->sizes_n, sizeof *data->mesh.face);
  if (!data->mesh.face) {
    return ph_fail_memory(diag);
  }
  for (size_t i = 0; i < faces->sizes_n; i++) {
    if (faces->sizes[i] != 4) {
      return ph_fail_at(diag, PH_E_BAD_SHAPE, "faces", i,
                        "must have 4 points, found %zu", faces->sizes[i]);
    }
    for (size_t k = 0; k < 4; k++) {
      enum ph_status status = set_index(data, i, k, *v++, diag);
      if (status != PH_OK) {
        return status;
      }
    }
  }
  return PH_OK;
}

/* ---- points and normals -------------------------------------------------- */

static ph_vec3 scaled(struct ph_pow2 scale, ph_vec3 v) {
  return ph_vec3_of(ph_pow2_apply(scale, v.x), ph_pow2_apply(scale, v.y),
                    ph_pow2_apply(scale, v.z));
}

static enum ph_status set_points(const struct ph_problem *p,
                                 struct ph_bubble_data *data,
                                 struct ph_diag *diag) {
  const struct ph_value *points = &p->field[PH_F_POINTS];
  struct ph_pow2 scale;
  data->exponent =
      ph_fields_exponent(ph_fields_largest(points->v, 3 * points->n));
  scale = ph_pow2_of(data->exponent);
  for (size_t i = 0; i < points->n; i++) {
    data->at[i].p = scaled(scale, ph_fields_vector(points, i));
  }
  for (size_t e = 0; e < data->mesh.edges_n; e++) {
    const struct ph_mesh_edge *edge = &data->mesh.edge[e];
    const ph_vec3 a = data->at[edge->point[0]].p,
                  b = data->at[edge->point[1]].p;
    if (!(ph_vec3_abs(ph_vec3_sub(b, a)) >
          4 * DBL_EPSILON * ph_vec3_abs(ph_vec3_add(a, b)))) {
      return ph_fail_at(diag, PH_E_COINCIDENT_POINTS, "points", edge->point[1],
                        "coincides with points[%zu], at the other end of an "
                        "edge of faces[%zu]",
                        edge->point[0], edge->face[0]);
    }
  }
  return PH_OK;
}

static enum ph_status set_normals(const struct ph_problem *p,
                                  struct ph_bubble_data *data,
                                  struct ph_diag *diag) {
  const struct ph_value *normals = &p->field[PH_F_NORMALS];
  enum ph_status status =
      ph_fields_vectors(p, PH_F_NORMALS, data->mesh.points_n, diag);
  for (size_t i = 0; status == PH_OK && i < data->mesh.points_n; i++) {
    data->at[i].g = ph_fields_unit(ph_fields_vector(normals, i));
  }
  return status;
}

/* From the faces around each point: the sum of the cross products of the edges
 * that meet there. */
static enum ph_status find_normals(struct ph_arena *arena,
                                   struct ph_bubble_data *data,
                                   struct ph_diag *diag) {
  const struct ph_mesh *mesh = &data->mesh;
  struct ph_mark mark = ph_arena_mark(arena);
  signed char *sign = ph_arena_array(arena, mesh->faces_n, sizeof *sign);
  enum ph_status status =
      sign ? ph_mesh_orient(mesh, arena, sign, diag) : ph_fail_memory(diag);
  for (size_t i = 0; i < mesh->points_n; i++) {
    data->at[i].g = ph_vec3_of(0, 0, 0);
  }
  for (size_t i = 0; status == PH_OK && i < 4 * mesh->faces_n; i++) {
    const size_t *face = mesh->face[i / 4];
    struct ph_quadric *at = &data->at[face[i % 4]];
    const ph_vec3 next = ph_vec3_sub(data->at[face[(i + 1) % 4]].p, at->p);
    const ph_vec3 last = ph_vec3_sub(data->at[face[(i + 3) % 4]].p, at->p);
    at->g = ph_vec3_along(at->g, sign[i / 4], ph_vec3_cross(next, last));
  }
  ph_arena_release(arena, mark);
  for (size_t i = 0; status == PH_OK && i < mesh->points_n; i++) {
    const ph_vec3 g = data->at[i].g;
    if (!(ph_vec3_abs(g) > 0)) {
      return ph_fail_at(diag, PH_E_ZERO_TANGENT, "points", i,
                        "has no normal: those of the faces around it add up "
                        "to 0; give normals");
    }
    data->at[i].g = ph_fields_unit(g);
  }
  return status;
}

/* ---- numbers ------------------------------------------------------------- */

static enum ph_status set_continuity(const struct ph_value *value,
                                     struct ph_bubble_data *data,
                                     struct ph_diag *diag) {
  const double x = value->number;
  data->continuity = 1;
  if (value->kind == PH_ABSENT) {
    return PH_OK;
  }
  if (!(x >= 0) || !(x <= 2) || floor(x) < x) {
    return ph_fail(diag, PH_E_BAD_VALUE, "continuity",
                   "must be 0, 1 or 2, found %.17g", x);
  }
  data->continuity = (size_t)x;
  return PH_OK;
}

static enum ph_status set_degree(const struct ph_value *value,
                                 struct ph_bubble_data *data,
                                 struct ph_diag *diag) {
  const double x = value->number;
  const size_t least = ph_ribbon_height_degree(data->continuity);
  data->degree = 0;
  data->exact = value->kind == PH_WORD && ph_value_is(value, "exact");
  if (value->kind != PH_NUMBER) {
    return PH_OK;
  }
  if (!(x >= (double)least) || !(x <= PH_BLEND_MAX) || floor(x) < x) {
    return ph_fail(diag, PH_E_BAD_VALUE, "degree",
                   "must be a whole number from %zu, the degree of edges of "
                   "continuity %zu, to %d, found %.17g",
                   least, data->continuity, PH_BLEND_MAX, x);
  }
  data->degree = (size_t)x;
  return PH_OK;
}

static enum ph_status set_tolerance(const struct ph_value *value,
                                    struct ph_bubble_data *data,
                                    struct ph_diag *diag) {
  data->tolerance = PH_BUBBLE_TOLERANCE;
  if (value->kind == PH_ABSENT) {
    return PH_OK;
  }
  data->tolerance = value->number;
  return data->tolerance >= 1e-12 && data->tolerance <= 1
             ? PH_OK
             : ph_fail(diag, PH_E_BAD_VALUE, "tolerance",
                       "must be from 1e-12 to 1 radians, found %.17g",
                       value->number);
}

/* ---- the whole ----------------------------------------------------------- */

enum ph_status ph_bubble_data_of(const struct ph_problem *problem,
                                 struct ph_arena *arena,
                                 struct ph_bubble_data *data,
                                 struct ph_diag *diag) {
  const struct ph_field_reader {
    enum ph_field_id field;
    enum ph_status (*set)(const struct ph_value *, struct ph_bubble_data *,
                          struct ph_diag *);
  } numbers[] = {{PH_F_CONTINUITY, set_continuity},
                 {PH_F_DEGREE, set_degree},
                 {PH_F_TOLERANCE, set_tolerance}};
  enum ph_status status = PH_OK;
  data->mesh.points_n = problem->field[PH_F_POINTS].n;
  if (data->mesh.points_n < 4) {
    return ph_fail(diag, PH_E_TOO_FEW_POINTS, "points",
                   "must have at least 4 points, found %zu",
                   data->mesh.points_n);
  }
  for (size_t i = 0; status == PH_OK && i < 3; i++) {
    status = numbers[i].set(&problem->field[numbers[i].field], data, diag);
  }
  if (status == PH_OK) {
    status = set_faces(problem, arena, data, diag);
  }
  if (status == PH_OK) {
    status = ph_mesh_join(&data->mesh, arena, diag);
  }
  if (status != PH_OK) {
    return status;
  }
  data->at = ph_arena_array(arena, data->mesh.points_n, sizeof *data->at);
  if (!data->at) {
    return ph_fail_memory(diag);
  }
  status = set_points(problem, data, diag);
  if (status != PH_OK) {
    return status;
  }
  return ph_fields_given(problem, PH_F_NORMALS)
             ? set_normals(problem, data, diag)
             : find_normals(arena, data, diag);
}
