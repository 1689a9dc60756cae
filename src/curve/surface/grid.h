/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Samples, parallel surfaces and paths of the development of a surface
 * (surface.h).
 */
#ifndef PH_CURVE_SURFACE_GRID_H
#define PH_CURVE_SURFACE_GRID_H

#include "base/diag.h"
#include "base/mem.h"
#include "curve/result.h"

/* How fine a grid is. */
struct ph_grid_rules {
  size_t along;  /* steps of each strip, > 0 */
  size_t across; /* steps over the height, at equal distances; 0: where there is
                    a height, 1 */
  size_t most;   /* samples of a surface */
};

/* ph_grid_across: the steps over the height: none where there is no height. */
size_t ph_grid_across(const struct ph_curve *curve,
                      const struct ph_grid_rules *rules);

/*
 * ph_grid_of: samples of all strips: along + 1 rulings of each, at equal
 * distances, and across + 1 points of each of these.  A ruling between two
 * strips is there twice.
 *
 * ret  PH_OK | PH_E_LIMIT | PH_E_NO_MEMORY
 */
enum ph_status ph_grid_of(const struct ph_curve *curve,
                          const struct ph_grid_rules *rules,
                          struct ph_arena *arena,
                          struct ph_surface_samples *grid,
                          struct ph_diag *diag);

/*
 * ph_parallel_of: the surface at a distance along the normals.  Where f = 1 -
 * distance kn, a strip has k/f and kn/f and the length f s: it is one of a
 * circular cone again, with the same rulings.  For general ones see general.h.
 *
 * ret  PH_OK | PH_E_INFEASIBLE (f is not above 0) | PH_E_NO_CONVERGENCE |
 *      PH_E_NO_MEMORY
 */
enum ph_status ph_parallel_of(const struct ph_curve *curve, double distance,
                              struct ph_arena *arena,
                              struct ph_parallel *parallel,
                              struct ph_diag *diag);

/*
 * ph_flat_paths: cubic Bezier pieces of the development, within the tolerance:
 * of its outline and of the rulings at all ends of strips, or, where there is
 * no height, of the contact curve.  Pieces that follow one another are joined
 * where they share a point.
 *
 * out  path  segment and interval are not filled
 * ret  PH_OK | PH_E_LIMIT | PH_E_NO_MEMORY
 */
enum ph_status ph_flat_paths(const struct ph_curve *curve, double tolerance,
                             struct ph_arena *arena, struct ph_pieces *path,
                             struct ph_diag *diag);

/* ph_flat_rulings: how many pieces of that, the last ones, are rulings between
 * strips, each one piece; before them is the outline. */
size_t ph_flat_rulings(const struct ph_curve *curve);

/* ph_surface_size: half the diagonal of the bounding box of the contact curves'
 * ends. */
double ph_surface_size(const struct ph_curve *curve);

#endif
