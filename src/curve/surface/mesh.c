/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The edges of a mesh (see mesh.h): O(n), by a hash table. */
#include "curve/surface/mesh.h"

#include <string.h>

static void sort_faces(struct ph_mesh *mesh) {
  size_t *first = mesh->first;
  memset(first, 0, (mesh->points_n + 1) * sizeof *first);
  for (size_t i = 0; i < 4 * mesh->faces_n; i++) {
    first[mesh->face[i / 4][i % 4] + 1]++;
  }
  for (size_t i = 0; i < mesh->points_n; i++) {
    first[i + 1] += first[i];
  }
  for (size_t i = 4 * mesh->faces_n; i-- > 0;) { /* from behind, so that */
    mesh->around[--first[mesh->face[i / 4][i % 4] + 1]] = i / 4;
  }
  /* first[i + 1] now is where those of i begin */
  memmove(first, first + 1, mesh->points_n * sizeof *first);
  first[mesh->points_n] = 4 * mesh->faces_n;
}

/* A hash table of the edges so far: [mask + 1], SIZE_MAX is nothing. */
struct table {
  size_t *edge;
  size_t mask;
};

/* The place of the edge of two points, or of the one that it takes. */
static size_t place_of(const struct ph_mesh *mesh, const struct table *table,
                       size_t low, size_t high) {
  uint64_t hash = (uint64_t)low * 0x9e3779b97f4a7c15u + (uint64_t)high;
  size_t at;
  hash *= 0xd1342543de82ef95u;
  at = (size_t)(hash >> 20) & table->mask;
  while (table->edge[at] != SIZE_MAX &&
         (mesh->edge[table->edge[at]].point[0] != low ||
          mesh->edge[table->edge[at]].point[1] != high)) {
    at = (at + 1) & table->mask;
  }
  return at;
}

static enum ph_status add_side(struct ph_mesh *mesh, size_t i, size_t k,
                               const struct table *table,
                               struct ph_diag *diag) {
  const size_t a = mesh->face[i][k], b = mesh->face[i][(k + 1) % 4];
  const size_t low = a < b ? a : b, high = a < b ? b : a;
  const size_t at = place_of(mesh, table, low, high);
  size_t e = table->edge[at];
  if (e == SIZE_MAX) {
    e = table->edge[at] = mesh->edges_n++;
    mesh->edge[e] = (struct ph_mesh_edge){{low, high}, {i, PH_NO_FACE}};
  } else if (mesh->edge[e].face[1] == PH_NO_FACE) {
    mesh->edge[e].face[1] = i;
  } else {
    return ph_fail_at(diag, PH_E_BAD_VALUE, "faces", i,
                      "is the third one at the edge of points %zu and %zu, "
                      "after faces %zu and %zu; two are allowed",
                      low, high, mesh->edge[e].face[0], mesh->edge[e].face[1]);
  }
  mesh->side[i][k] = e;
  return PH_OK;
}

enum ph_status ph_mesh_join(struct ph_mesh *mesh, struct ph_arena *arena,
                            struct ph_diag *diag) {
  const size_t sides = 4 * mesh->faces_n;
  enum ph_status status = PH_OK;
  struct table table = {NULL, 1};
  struct ph_mark mark;
  while (table.mask < 2 * sides && table.mask < SIZE_MAX / 4) {
    table.mask = 2 * table.mask + 1;
  }
  mesh->edges_n = 0;
  mesh->side = ph_arena_array(arena, mesh->faces_n, sizeof *mesh->side);
  mesh->edge = ph_arena_array(arena, sides, sizeof *mesh->edge);
  mesh->first = ph_arena_array(arena, mesh->points_n + 1, sizeof *mesh->first);
  mesh->around = ph_arena_array(arena, sides, sizeof *mesh->around);
  mark = ph_arena_mark(arena);
  table.edge = ph_arena_array(arena, table.mask + 1, sizeof *table.edge);
  if (!mesh->side || !mesh->edge || !mesh->first || !mesh->around ||
      !table.edge) {
    return ph_fail_memory(diag);
  }
  memset(table.edge, 0xff, (table.mask + 1) * sizeof *table.edge);
  for (size_t i = 0; status == PH_OK && i < sides; i++) {
    status = add_side(mesh, i / 4, i % 4, &table, diag);
  }
  ph_arena_release(arena, mark);
  if (status != PH_OK) {
    return status;
  }
  sort_faces(mesh);
  for (size_t i = 0; i < mesh->points_n; i++) {
    if (mesh->first[i] == mesh->first[i + 1]) {
      return ph_fail_at(diag, PH_E_BAD_VALUE, "points", i,
                        "belongs to no face");
    }
  }
  return PH_OK;
}

bool ph_mesh_is_closed(const struct ph_mesh *mesh) {
  size_t i = 0;
  while (i < mesh->edges_n && mesh->edge[i].face[1] != PH_NO_FACE) {
    i++;
  }
  return i == mesh->edges_n;
}

/* ---- orientation --------------------------------------------------------- */

/* Whether face i has edge e from its smaller point to the larger one. */
static bool is_upward(const struct ph_mesh *mesh, size_t i, size_t e) {
  size_t k = 0;
  while (mesh->side[i][k] != e) {
    k++;
  }
  return mesh->face[i][k] == mesh->edge[e].point[0];
}

/* Gives a sign to the neighbours of face i, and puts the new ones on the stack
 * of n. */
static enum ph_status spread(const struct ph_mesh *mesh, size_t i,
                             signed char *sign, size_t *stack, size_t *n,
                             struct ph_diag *diag) {
  for (size_t k = 0; k < 4; k++) {
    const size_t e = mesh->side[i][k];
    const struct ph_mesh_edge *edge = &mesh->edge[e];
    const size_t to = edge->face[edge->face[0] == i];
    signed char wanted;
    if (to == PH_NO_FACE) {
      continue;
    }
    wanted =
        is_upward(mesh, i, e) == is_upward(mesh, to, e) ? -sign[i] : sign[i];
    if (sign[to] == 0) {
      sign[to] = wanted;
      stack[(*n)++] = to;
    } else if (sign[to] != wanted) {
      return ph_fail_at(diag, PH_E_BAD_VALUE, "faces", to,
                        "closes a surface that has one side only, so that the "
                        "faces do not say where normals point; give normals");
    }
  }
  return PH_OK;
}

enum ph_status ph_mesh_orient(const struct ph_mesh *mesh,
                              struct ph_arena *scratch, signed char *sign,
                              struct ph_diag *diag) {
  struct ph_mark mark = ph_arena_mark(scratch);
  size_t *stack = ph_arena_array(scratch, mesh->faces_n, sizeof *stack);
  enum ph_status status = stack ? PH_OK : ph_fail_memory(diag);
  memset(sign, 0, mesh->faces_n);
  for (size_t i = 0; status == PH_OK && i < mesh->faces_n; i++) {
    size_t n = 0;
    if (sign[i] == 0) {
      sign[i] = 1;
      stack[n++] = i;
    }
    while (status == PH_OK && n > 0) {
      n--;
      status = spread(mesh, stack[n], sign, stack, &n, diag);
    }
  }
  ph_arena_release(scratch, mark);
  return status;
}
