/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The mesh of a problem, and its normals (see bubble.h). */
#include "solve/bubble/bubble.h"
#include "solve/common/fields.h"

#include <float.h>
#include <math.h>
#include <string.h>

/* ---- faces --------------------------------------------------------------- */

static enum ph_status set_index(struct ph_polygons *mesh, size_t i, size_t at,
                                double x, struct ph_diag *diag) {
  if (!(x >= 0) || !(x < (double)mesh->points_n) || floor(x) < x) {
    return ph_fail_at(diag, PH_E_BAD_VALUE, "faces", i,
                      "must have numbers of points, whole and from 0 to %zu, "
                      "found %.17g",
                      mesh->points_n - 1, x);
  }
  mesh->corner[at] = (size_t)x;
  for (size_t j = mesh->first[i]; j < at; j++) {
    if (mesh->corner[j] == mesh->corner[at]) {
      return ph_fail_at(diag, PH_E_BAD_VALUE, "faces", i,
                        "has points[%zu] twice", mesh->corner[at]);
    }
  }
  return PH_OK;
}

/* A face of so many corners that it would take long to look for a point that is
 * there twice, is none. */
enum { CORNERS_MAX = 1000 };

static enum ph_status check_size(const struct ph_bubble_data *data, size_t i,
                                 size_t n, struct ph_diag *diag) {
  if (!data->subdivide && n != 4) {
    return ph_fail_at(diag, PH_E_BAD_SHAPE, "faces", i,
                      "must have 4 points, found %zu; with subdivide of 1 or "
                      "more it may have others",
                      n);
  }
  return n >= 3 && n <= CORNERS_MAX
             ? PH_OK
             : ph_fail_at(diag, PH_E_BAD_SHAPE, "faces", i,
                          "must have from 3 to %d points, found %zu",
                          CORNERS_MAX, n);
}

static enum ph_status set_faces(const struct ph_problem *p,
                                const struct ph_bubble_data *data,
                                struct ph_arena *arena,
                                struct ph_polygons *mesh,
                                struct ph_diag *diag) {
  const struct ph_value *faces = &p->field[PH_F_FACES];
  size_t at = 0;
  mesh->faces_n = faces->sizes_n;
  if (faces->sizes_n == 0) {
    return ph_fail(diag, PH_E_BAD_SHAPE, "faces", "must have one or more");
  }
  mesh->first = ph_arena_array(arena, faces->sizes_n + 1, sizeof *mesh->first);
  mesh->corner = ph_arena_array(arena, faces->n, sizeof *mesh->corner);
  if (!mesh->first || !mesh->corner) {
    return ph_fail_memory(diag);
  }
  mesh->first[0] = 0;
  for (size_t i = 0; i < faces->sizes_n; i++) {
    enum ph_status status = check_size(data, i, faces->sizes[i], diag);
    for (size_t k = 0; status == PH_OK && k < faces->sizes[i]; k++, at++) {
      status = set_index(mesh, i, at, faces->v[at], diag);
    }
    if (status != PH_OK) {
      return status;
    }
    mesh->first[i + 1] = at;
  }
  return PH_OK;
}

/* ---- points and normals -------------------------------------------------- */

/* At unit scale; normals are unit vectors, or 0 where there are none. */
static enum ph_status set_points(const struct ph_problem *p,
                                 struct ph_bubble_data *data,
                                 struct ph_arena *arena,
                                 struct ph_polygons *mesh,
                                 struct ph_diag *diag) {
  const struct ph_value *points = &p->field[PH_F_POINTS];
  const struct ph_value *normals = &p->field[PH_F_NORMALS];
  const bool given = ph_fields_given(p, PH_F_NORMALS);
  struct ph_pow2 scale;
  if (given) {
    enum ph_status status = ph_fields_vectors(p, PH_F_NORMALS, points->n, diag);
    if (status != PH_OK) {
      return status;
    }
  }
  data->exponent =
      ph_fields_exponent(ph_fields_largest(points->v, 3 * points->n));
  scale = ph_pow2_of(data->exponent);
  mesh->x = ph_arena_array(arena, points->n, sizeof *mesh->x);
  if (!mesh->x) {
    return ph_fail_memory(diag);
  }
  for (size_t i = 0; i < points->n; i++) {
    const ph_vec3 g = given ? ph_fields_unit(ph_fields_vector(normals, i))
                            : ph_vec3_of(0, 0, 0);
    for (size_t j = 0; j < 3; j++) {
      mesh->x[i][j] = ph_pow2_apply(scale, points->v[3 * i + j]);
    }
    ph_vec3_put(g, 3, mesh->x[i] + 3);
  }
  return PH_OK;
}

static enum ph_status check_edges(const struct ph_bubble_data *data,
                                  struct ph_diag *diag) {
  for (size_t e = 0; e < data->mesh.edges_n; e++) {
    const struct ph_mesh_edge *edge = &data->mesh.edge[e];
    const ph_vec3 a = data->at[edge->point[0]].p,
                  b = data->at[edge->point[1]].p;
    if (!(ph_vec3_abs(ph_vec3_sub(b, a)) >
          4 * DBL_EPSILON * ph_vec3_abs(ph_vec3_add(a, b)))) {
      return ph_fail_at(diag, PH_E_COINCIDENT_POINTS, "points", edge->point[1],
                        "coincides with points[%zu], at the other end of an "
                        "edge of faces[%zu]%s",
                        edge->point[0], edge->face[0],
                        data->subdivide ? ", after subdivision" : "");
    }
  }
  return PH_OK;
}

/* Normals that were moved by subdivision. */
static enum ph_status renew_normals(struct ph_polygons *mesh,
                                    struct ph_diag *diag) {
  for (size_t i = 0; i < mesh->points_n; i++) {
    const ph_vec3 g = ph_vec3_get(mesh->x[i] + 3, 3);
    if (!(ph_vec3_abs(g) > 1e-9)) {
      return ph_fail_at(diag, PH_E_ZERO_TANGENT, "points", i,
                        "has no normal after subdivision: those around it "
                        "add up to 0");
    }
    ph_vec3_put(ph_fields_unit(g), 3, mesh->x[i] + 3);
  }
  return PH_OK;
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

static enum ph_status set_subdivide(const struct ph_value *value,
                                    struct ph_bubble_data *data,
                                    struct ph_diag *diag) {
  const double x = value->number;
  data->subdivide = 0;
  if (value->kind == PH_ABSENT) {
    return PH_OK;
  }
  if (!(x >= 0) || !(x <= PH_SUBDIVIDE_MAX) || floor(x) < x) {
    return ph_fail(diag, PH_E_BAD_VALUE, "subdivide",
                   "must be a whole number from 0 to %d, found %.17g",
                   PH_SUBDIVIDE_MAX, x);
  }
  data->subdivide = (size_t)x;
  return PH_OK;
}

static enum ph_status set_boundary(const struct ph_value *value,
                                   struct ph_bubble_data *data,
                                   struct ph_diag *diag) {
  (void)diag;
  data->fixed = value->kind == PH_WORD && ph_value_is(value, "fixed");
  return PH_OK;
}

/* ---- the whole ----------------------------------------------------------- */

/* Each point must belong to a face, before it is moved. */
static enum ph_status check_used(const struct ph_polygons *mesh,
                                 struct ph_arena *arena, struct ph_diag *diag) {
  struct ph_mark mark = ph_arena_mark(arena);
  bool *used = ph_arena_array(arena, mesh->points_n, sizeof *used);
  enum ph_status status = used ? PH_OK : ph_fail_memory(diag);
  if (used) {
    memset(used, 0, mesh->points_n * sizeof *used);
    for (size_t i = 0; i < mesh->first[mesh->faces_n]; i++) {
      used[mesh->corner[i]] = true;
    }
  }
  for (size_t i = 0; status == PH_OK && i < mesh->points_n; i++) {
    if (!used[i]) {
      status =
          ph_fail_at(diag, PH_E_BAD_VALUE, "points", i, "belongs to no face");
    }
  }
  ph_arena_release(arena, mark);
  return status;
}

/* The mesh of a problem, subdivided as often as it says. */
static enum ph_status read_mesh(const struct ph_problem *problem,
                                struct ph_bubble_data *data,
                                struct ph_arena *arena,
                                struct ph_polygons *mesh,
                                struct ph_diag *diag) {
  enum ph_status status;
  mesh->points_n = problem->field[PH_F_POINTS].n;
  status = set_faces(problem, data, arena, mesh, diag);
  if (status == PH_OK) {
    status = set_points(problem, data, arena, mesh, diag);
  }
  if (status == PH_OK && data->subdivide) {
    status = check_used(mesh, arena, diag);
  }
  for (size_t i = 0; status == PH_OK && i < data->subdivide; i++) {
    const struct ph_polygons coarse = *mesh;
    status = ph_bubble_subdivide(&coarse, data->fixed, arena, mesh, diag);
    if (status == PH_OK && ph_fields_given(problem, PH_F_NORMALS)) {
      status = renew_normals(mesh, diag);
    }
  }
  return status;
}

/* ... as quadrilaterals. */
static enum ph_status set_mesh(const struct ph_polygons *mesh,
                               struct ph_arena *arena,
                               struct ph_bubble_data *data,
                               struct ph_diag *diag) {
  data->mesh.points_n = mesh->points_n;
  data->mesh.faces_n = mesh->faces_n;
  data->mesh.face =
      ph_arena_array(arena, mesh->faces_n, sizeof *data->mesh.face);
  data->at = ph_arena_array(arena, mesh->points_n, sizeof *data->at);
  if (!data->mesh.face || !data->at) {
    return ph_fail_memory(diag);
  }
  memcpy(data->mesh.face, mesh->corner,
         mesh->faces_n * sizeof *data->mesh.face);
  for (size_t i = 0; i < mesh->points_n; i++) {
    data->at[i].p = ph_vec3_get(mesh->x[i], 3);
    data->at[i].g = ph_vec3_get(mesh->x[i] + 3, 3);
  }
  return PH_OK;
}

enum ph_status ph_bubble_data_of(const struct ph_problem *problem,
                                 struct ph_arena *arena,
                                 struct ph_bubble_data *data,
                                 struct ph_diag *diag) {
  static const struct ph_field_reader {
    enum ph_field_id field;
    enum ph_status (*set)(const struct ph_value *, struct ph_bubble_data *,
                          struct ph_diag *);
  } numbers[] = {{PH_F_CONTINUITY, set_continuity},
                 {PH_F_DEGREE, set_degree},
                 {PH_F_TOLERANCE, set_tolerance},
                 {PH_F_SUBDIVIDE, set_subdivide},
                 {PH_F_BOUNDARY, set_boundary}};
  const size_t points = problem->field[PH_F_POINTS].n;
  struct ph_arena scratch = ph_arena_beside(arena);
  struct ph_polygons mesh;
  enum ph_status status = PH_OK;
  if (points < 3 || (points < 4 && !ph_fields_given(problem, PH_F_SUBDIVIDE))) {
    return ph_fail(diag, PH_E_TOO_FEW_POINTS, "points",
                   "must have at least 4 points, found %zu", points);
  }
  for (size_t i = 0; status == PH_OK && i < sizeof numbers / sizeof numbers[0];
       i++) {
    status = numbers[i].set(&problem->field[numbers[i].field], data, diag);
  }
  if (status == PH_OK) {
    status = read_mesh(problem, data, &scratch, &mesh, diag);
  }
  if (status == PH_OK) {
    status = set_mesh(&mesh, arena, data, diag);
  }
  ph_arena_free(&scratch);
  if (status == PH_OK) {
    status = ph_mesh_join(&data->mesh, arena, diag);
  }
  if (status == PH_OK) {
    status = check_edges(data, diag);
  }
  return status == PH_OK && !ph_fields_given(problem, PH_F_NORMALS)
             ? find_normals(arena, data, diag)
             : status;
}
