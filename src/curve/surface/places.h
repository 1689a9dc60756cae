/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Places of a surface of patches that was solved, polynomial or exact: on a
 * grid of the same parameters by u and by v, patch by patch, at unit scale;
 * with samples of them, surfaces at a distance, and what neighbours differ by
 * at their edges, in the unit of the data.
 */
#ifndef PH_CURVE_SURFACE_PLACES_H
#define PH_CURVE_SURFACE_PLACES_H

#include "base/diag.h"
#include "curve/result.h"
#include "curve/surface/exact.h"
#include "kernel/pow2.h"

struct ph_places {
  const struct ph_curve *curve;
  const double *at; /* [n] parameters */
  size_t n;
  struct ph_pow2 to_unit, from_unit;
  size_t patch; /* that it is in */
  /* polynomial: */
  struct ph_patch_rows *rows[PH_PATCH_DEGREE_MAX + 1]; /* by degree, or NULL */
  struct ph_patch_line *line;
  double *points; /* of the patch */
  /* exact: */
  struct ph_exact_rows *exact_rows; /* [n] */
  struct ph_exact_patch *exact;
  struct ph_cross (*cross[2])[2]; /* [n] by u, and by v */
  size_t j;
};

/*
 * ph_places_spread: calls look(context, places) for each patch, in threads that
 * are spare, by the parameters at[n] in it; where it returns false, patches
 * that come later may be left out, and none before.
 *
 * ret  PH_OK | PH_E_NO_MEMORY
 */
enum ph_status ph_places_spread(const struct ph_curve *curve, const double *at,
                                size_t n, struct ph_arena *arena,
                                bool (*look)(void *context,
                                             struct ph_places *places),
                                void *context, struct ph_diag *diag);

/* ph_places_line: v is number j; then ph_places_jet: u is number i, with all
 * derivatives to the order 2. */
void ph_places_line(struct ph_places *places, size_t j);
void ph_places_jet(const struct ph_places *places, size_t i,
                   struct ph_patch_jet *jet);

/*
 * ph_patch_normal: the unit normal of a place at (u,v), on the side of b_u x
 * b_v; where that is 0, as at a corner whose sides are in line, what it tends
 * to from inside.  NaN where that is 0, too.
 */
ph_vec3 ph_patch_normal(const struct ph_patch_jet *jet, double u, double v);

/* ph_patch_bend: the second fundamental form by an orthonormal basis of the
 * tangent plane, L, M and N, positive towards the normal. */
void ph_patch_bend(const struct ph_patch_jet *jet, ph_vec3 normal,
                   double form[3]);

/*
 * ph_patch_grid_of: samples of all patches at a distance along the normals, 0:
 * on them; steps + 1 by u of each of as many v.  Curvatures that are beyond all
 * numbers are NaN.
 *
 * in   most  samples of a surface
 * out  back  the first patch that turns back on itself there, as curvatures
 *            are too large; PH_NO_SEGMENT: none does
 * ret  PH_OK | PH_E_LIMIT | PH_E_TOO_LARGE | PH_E_NO_MEMORY
 */
enum ph_status ph_patch_grid_of(const struct ph_curve *curve, double distance,
                                size_t steps, size_t most,
                                struct ph_arena *arena,
                                struct ph_patch_samples *grid, size_t *back,
                                struct ph_diag *diag);

/*
 * ph_patch_edges_of: all edges of a surface that was solved, with their jumps
 * as the certificate has them (check/bubble.h), at the same places.
 *
 * ret  PH_OK | PH_E_NO_MEMORY
 */
enum ph_status ph_patch_edges_of(const struct ph_curve *curve,
                                 struct ph_arena *arena,
                                 struct ph_patch_edges *edges,
                                 struct ph_diag *diag);

#endif
