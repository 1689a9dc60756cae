/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Meshes of surfaces (see tiling.h). */
#include "curve/surface/tiling.h"

#include "curve/surface/exact.h"

#include <string.h>

static enum ph_status allocate(struct ph_tiling *t, size_t points_n,
                               size_t flats_n, size_t normals_n, size_t tiles_n,
                               struct ph_arena *arena, struct ph_diag *diag) {
  *t = (struct ph_tiling){.points_n = points_n,
                          .flats_n = flats_n,
                          .normals_n = normals_n,
                          .tiles_n = tiles_n};
  t->points = ph_arena_array(arena, points_n, sizeof *t->points);
  t->flats = ph_arena_array(arena, flats_n, sizeof *t->flats);
  t->normals = ph_arena_array(arena, normals_n, sizeof *t->normals);
  t->tiles = ph_arena_array(arena, tiles_n, sizeof *t->tiles);
  return t->points && t->flats && t->normals && t->tiles ? PH_OK
                                                         : ph_fail_memory(diag);
}

/* ---- strips -------------------------------------------------------------- */

/* A grid of samples as rulings. */
struct rulings {
  const struct ph_surface_samples *grid;
  size_t strips, along, across; /* steps of each strip */
  size_t n;
  size_t distinct; /* points of their own: the last ruling of a closed surface
                      is the first again, but not in the development */
};

/* The steps of a grid, which knows them no more. */
static struct rulings rulings_of(const struct ph_curve *curve,
                                 const struct ph_surface_samples *grid) {
  struct rulings r = {.grid = grid, .strips = curve->n};
  const struct ph_surface_sample *v = grid->v;
  while (r.across + 1 < grid->n && !(v[r.across + 1].s > v[r.across].s) &&
         v[r.across + 1].strip == v[0].strip) {
    r.across++;
  }
  r.along = grid->n / r.strips / (r.across + 1) - 1;
  r.n = r.strips * r.along + 1;
  r.distinct = r.n - (curve->closed ? 1 : 0);
  return r;
}

/* The samples of a ruling: that which two strips share is the start of the
 * second, but at the end. */
static const struct ph_surface_sample *ruling(const struct rulings *r,
                                              size_t i) {
  const size_t strip = i / r->along < r->strips ? i / r->along : r->strips - 1;
  return r->grid->v +
         (strip * (r->along + 1) + i - strip * r->along) * (r->across + 1);
}

static struct ph_tile_corner strip_corner(const struct rulings *r, size_t i,
                                          size_t j) {
  const size_t each = r->across + 1, own = i < r->distinct ? i : 0;
  return (struct ph_tile_corner){own * each + j, i * each + j, own};
}

enum ph_status ph_tiling_of_strips(const struct ph_curve *curve,
                                   const struct ph_surface_samples *grid,
                                   struct ph_arena *arena, struct ph_tiling *t,
                                   struct ph_diag *diag) {
  const struct rulings r = rulings_of(curve, grid);
  const size_t each = r.across + 1;
  struct ph_tile_corner(*to)[4];
  if (allocate(t, r.distinct * each, r.n * each, r.distinct,
               (r.n - 1) * r.across, arena, diag) != PH_OK) {
    return diag->status;
  }
  for (size_t i = 0; i < r.n; i++) {
    const struct ph_surface_sample *from = ruling(&r, i);
    for (size_t j = 0; j < each; j++) {
      memcpy(t->flats[i * each + j], from[j].flat, sizeof *t->flats);
      if (i < r.distinct) {
        memcpy(t->points[i * each + j], from[j].point, sizeof *t->points);
      }
    }
    if (i < r.distinct) {
      memcpy(t->normals[i], from->normal, sizeof *t->normals);
    }
  }
  to = t->tiles;
  for (size_t i = 0; i + 1 < r.n; i++) {
    for (size_t j = 0; j < r.across; j++, to++) {
      (*to)[0] = strip_corner(&r, i, j);
      (*to)[1] = strip_corner(&r, i, j + 1);
      (*to)[2] = strip_corner(&r, i + 1, j + 1);
      (*to)[3] = strip_corner(&r, i + 1, j);
    }
  }
  return PH_OK;
}

/* ---- patches ------------------------------------------------------------- */

/* The point of the mesh that sample (i,j) of a face is. */
static size_t welded(const struct ph_mesh *mesh, size_t face, size_t steps,
                     size_t i, size_t j) {
  const size_t inner = steps - 1;
  const bool low = i == 0, left = j == 0, high = i == steps, top = j == steps;
  size_t k, along;
  if ((low || high) && (left || top)) {
    return mesh->face[face][left ? (low ? 0 : 1) : (low ? 3 : 2)];
  }
  if (!low && !high && !left && !top) {
    return mesh->points_n + mesh->edges_n * inner +
           (face * inner + j - 1) * inner + i - 1;
  }
  k = left ? 0 : high ? 1 : top ? 2 : 3;
  along = k == 0 ? i : k == 1 ? j : k == 2 ? steps - i : steps - j;
  if (mesh->edge[mesh->side[face][k]].point[0] != mesh->face[face][k]) {
    along = steps - along;
  }
  return mesh->points_n + mesh->side[face][k] * inner + along - 1;
}

static void add_tiles(const struct ph_curve *curve, size_t face, size_t steps,
                      struct ph_tiling *t) {
  const struct ph_surface *s = &curve->surface;
  static const size_t at[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  const size_t each = (steps + 1) * (steps + 1);
  const bool turned = s->patches[face].side < 0;
  struct ph_tile_corner(*to)[4] = t->tiles + face * steps * steps;
  for (size_t j = 0; j < steps; j++) {
    for (size_t i = 0; i < steps; i++, to++) {
      for (size_t k = 0; k < 4; k++) {
        const size_t *corner = at[turned ? 3 - k : k];
        const size_t a = i + corner[0], b = j + corner[1];
        const size_t point = welded(&s->base->mesh, face, steps, a, b);
        (*to)[k] = (struct ph_tile_corner){
            point, 0,
            s->continuity ? point : face * each + b * (steps + 1) + a};
      }
    }
  }
}

enum ph_status ph_tiling_of_patches(const struct ph_curve *curve,
                                    const struct ph_patch_samples *grid,
                                    size_t steps, struct ph_arena *arena,
                                    struct ph_tiling *t, struct ph_diag *diag) {
  const struct ph_surface *s = &curve->surface;
  const struct ph_mesh *mesh = &s->base->mesh;
  const size_t inner = steps - 1;
  const size_t points =
      mesh->points_n + mesh->edges_n * inner + mesh->faces_n * inner * inner;
  const struct ph_patch_sample *from = grid->v;
  if (allocate(t, points, 0, s->continuity ? points : grid->n,
               mesh->faces_n * steps * steps, arena, diag) != PH_OK) {
    return diag->status;
  }
  for (size_t face = 0; face < curve->n; face++) {
    for (size_t j = 0; j <= steps; j++) {
      for (size_t i = 0; i <= steps; i++, from++) {
        const size_t point = welded(mesh, face, steps, i, j);
        const size_t normal = s->continuity ? point : (size_t)(from - grid->v);
        memcpy(t->points[point], from->point, sizeof *t->points);
        memcpy(t->normals[normal], from->normal, sizeof *t->normals);
      }
    }
    add_tiles(curve, face, steps, t);
  }
  return PH_OK;
}
