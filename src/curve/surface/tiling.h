/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Surfaces as meshes of quadrilaterals, whatever they consist of: what formats
 * of meshes are written from (io/obj_out.h, io/stl_out.h).
 */
#ifndef PH_CURVE_SURFACE_TILING_H
#define PH_CURVE_SURFACE_TILING_H

#include "base/diag.h"
#include "base/mem.h"
#include "curve/result.h"

/* A corner of a tile: its point, its flat point, its normal, each by number. */
struct ph_tile_corner {
  size_t point, flat, normal;
};

/* Points are shared wherever parts of the surface meet. */
struct ph_tiling {
  double distance; /* of a parallel surface; 0: of the surface itself */
  double (*points)[3];
  double (*flats)[2]; /* of the development; flats_n = 0: there is none */
  double (*normals)[3];
  size_t points_n, flats_n, normals_n;
  struct ph_tile_corner (*tiles)[4]; /* counter-clockwise as seen from where
                                        the normals point to */
  size_t tiles_n;
};

/*
 * ph_tiling_of_strips: by the samples of a surface of strips, a tile for each
 * cell of them.  Strips share the points of the rulings between them.
 *
 * ret  PH_OK | PH_E_NO_MEMORY
 */
enum ph_status ph_tiling_of_strips(const struct ph_curve *curve,
                                   const struct ph_surface_samples *grid,
                                   struct ph_arena *arena,
                                   struct ph_tiling *tiling,
                                   struct ph_diag *diag);

/*
 * ph_tiling_of_patches: by the samples of a surface of patches that was solved.
 * Neighbours share the points of their edge, and, unless the continuity is 0,
 * its normals.
 *
 * ret  PH_OK | PH_E_NO_MEMORY
 */
enum ph_status ph_tiling_of_patches(const struct ph_curve *curve,
                                    const struct ph_patch_samples *grid,
                                    size_t steps, struct ph_arena *arena,
                                    struct ph_tiling *tiling,
                                    struct ph_diag *diag);

#endif
