/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Meshes of quadrilaterals: which edges their faces have, and what is around
 * a point.
 */
#ifndef PH_CURVE_SURFACE_MESH_H
#define PH_CURVE_SURFACE_MESH_H

#include "base/diag.h"
#include "base/mem.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#define PH_NO_FACE SIZE_MAX

/* An edge: its points, the smaller number first, and its faces, the second
 * PH_NO_FACE at the boundary. */
struct ph_mesh_edge {
  size_t point[2];
  size_t face[2];
};

struct ph_mesh {
  size_t points_n, faces_n, edges_n;
  size_t (*face)[4];         /* points, in cyclic order */
  size_t (*side)[4];         /* edges: side k is from point k to the next */
  struct ph_mesh_edge *edge; /* [edges_n] in the order of the faces */
  size_t *first;             /* [points_n + 1] the faces of point i are those */
  size_t *around;            /* around[first[i]] to around[first[i + 1] - 1] */
};

/*
 * ph_mesh_join: finds the edges of faces, and the faces of points.
 *
 * inout mesh  points_n, faces_n and face are given; no face has a point twice
 * ret   PH_OK | PH_E_BAD_VALUE (an edge of three faces, a point of none) |
 *       PH_E_NO_MEMORY
 */
enum ph_status ph_mesh_join(struct ph_mesh *mesh, struct ph_arena *arena,
                            struct ph_diag *diag);

/* ph_mesh_is_closed: whether every edge has two faces. */
bool ph_mesh_is_closed(const struct ph_mesh *mesh);

/*
 * ph_mesh_orient: signs of faces such that neighbours whose sign is the same
 * run along their edge in opposite directions; the first face of every
 * connected part has 1.
 *
 * out  sign[faces_n]
 * ret  PH_OK | PH_E_BAD_VALUE (there are none: the mesh has one side) |
 *      PH_E_NO_MEMORY
 */
enum ph_status ph_mesh_orient(const struct ph_mesh *mesh,
                              struct ph_arena *scratch, signed char *sign,
                              struct ph_diag *diag);

#endif
