/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What is derived from a surface (see derive.h). */
#include "cli/derive.h"

#include "curve/kind/kind.h"
#include "curve/surface/area.h"
#include "curve/surface/general.h"
#include "curve/surface/grid.h"
#include "curve/surface/places.h"
#include "curve/surface/strip.h"
#include "curve/surface/tiling.h"
#include "io/stl_out.h"

/* Tolerance of paths of drawings, relative to the size of the surface. */
static const double TOLERANCE_PATH = 1e-6;

/* Steps of each strip, and of each patch both ways, of a mesh, where --sample
 * does not say it. */
enum { STRIP_STEPS = 16, PATCH_STEPS = 8 };

/* How many strips have their vertex within the height, and the first of them.
 */
static size_t folds_of(const struct ph_curve *curve, size_t *first) {
  size_t n = 0;
  for (size_t i = curve->n; i-- > 0;) {
    const struct ph_strip *strip = &curve->surface.strips[i];
    double h[2][2];
    ph_strip_corners(&curve->surface, strip, h);
    if (!strip->directrix && ph_area_folds(strip->k, h)) {
      *first = i;
      n++;
    }
  }
  return n;
}

/* Of the first surface that has one where that which it is parallel to has
 * none. */
static void warn_folds(struct ph_result *r) {
  size_t first = 0;
  if (folds_of(&r->curve, &first)) {
    return;
  }
  for (size_t i = 0; i < r->parallels_n; i++) {
    const size_t n = folds_of(&r->parallels[i].curve, &first);
    if (n) {
      ph_warn(r, first, PH_W_VERTEX_INSIDE,
              "the vertex of strip %zu of the surface at the distance %g is "
              "within the height (such strips: %zu)",
              first, r->parallels[i].distance, n);
      return;
    }
  }
}

/* The same of rulings where strips of circular cones turn back: those beside
 * general ones are no cones. */
static void warn_turns(struct ph_result *r) {
  size_t first = 0;
  if (r->curve.surface.strips->directrix ||
      ph_surface_folds(&r->curve, &first)) {
    return;
  }
  for (size_t i = 0; i < r->parallels_n; i++) {
    const size_t n = ph_surface_folds(&r->parallels[i].curve, &first);
    if (n) {
      ph_warn(r, first, PH_W_FOLDED,
              "the surface at the distance %g turns back on itself at the end "
              "of strip %zu, as one strip there is beyond its vertex (such "
              "rulings: %zu)",
              r->parallels[i].distance, first, n);
      return;
    }
  }
}

static enum ph_status derive_parallels(const struct ph_options *o,
                                       struct ph_arena *arena,
                                       struct ph_result *r,
                                       struct ph_diag *diag) {
  enum ph_status status = PH_OK;
  r->parallels = ph_arena_array(arena, o->offsets_n, sizeof *r->parallels);
  if (!r->parallels) {
    return ph_fail_memory(diag);
  }
  for (size_t i = 0; status == PH_OK && i < o->offsets_n; i++) {
    status =
        ph_parallel_of(&r->curve, o->offsets[i], arena, &r->parallels[i], diag);
  }
  r->parallels_n = o->offsets_n;
  if (status == PH_OK) {
    warn_folds(r);
    warn_turns(r);
  }
  return status;
}

static enum ph_status derive_grids(const struct ph_grid_rules *rules,
                                   struct ph_arena *arena, struct ph_result *r,
                                   struct ph_diag *diag) {
  enum ph_status status = ph_grid_of(&r->curve, rules, arena, &r->grid, diag);
  for (size_t i = 0; status == PH_OK && i < r->parallels_n; i++) {
    status = ph_grid_of(&r->parallels[i].curve, rules, arena,
                        &r->parallels[i].grid, diag);
  }
  return status;
}

/* The developments of a surface and of those parallel to it. */
static enum ph_status derive_flat(struct ph_arena *arena,
                                  const struct ph_result *r,
                                  struct ph_derived *derived,
                                  struct ph_diag *diag) {
  const size_t n = r->parallels_n + 1;
  enum ph_status status = PH_OK;
  derived->paths = ph_arena_array(arena, n, sizeof *derived->paths);
  if (!derived->paths) {
    return ph_fail_memory(diag);
  }
  for (size_t i = 0; status == PH_OK && i < n; i++) {
    const struct ph_curve *c = i ? &r->parallels[i - 1].curve : &r->curve;
    status = ph_flat_paths(c, TOLERANCE_PATH * ph_surface_size(c), arena,
                           &derived->paths[i], diag);
  }
  derived->paths_n = n;
  return status;
}

/* The developments of general cones as polygons. */
static enum ph_status derive_polygons(const struct ph_options *o,
                                      struct ph_arena *arena,
                                      const struct ph_curve *curve,
                                      struct ph_diag *diag) {
  const double tolerance = o->tolerance > 0
                               ? o->tolerance
                               : PH_TOLERANCE_FLAT * ph_surface_size(curve);
  enum ph_status status = PH_OK;
  for (size_t i = 0; status == PH_OK && i < curve->n; i++) {
    struct ph_strip *strip = &curve->surface.strips[i];
    if (strip->directrix) {
      status = ph_general_flat(strip, tolerance, arena, diag);
    }
  }
  return status;
}

static enum ph_status derive_panorama(const struct ph_options *o,
                                      struct ph_arena *arena,
                                      struct ph_result *r,
                                      struct ph_diag *diag) {
  struct ph_panorama *p = &r->panorama;
  enum ph_status status;
  if (!(r->curve.surface.height[1] > r->curve.surface.height[0])) {
    return ph_fail(diag, PH_E_BAD_VALUE, "height",
                   "must have an extent for --panorama, as in "
                   "--height=[-1,1]");
  }
  status = ph_panorama_of(&r->curve, &o->volume, o->resolution, o->grid.most,
                          arena, p, diag);
  if (status == PH_OK && p->outside) {
    ph_warn(r, PH_NO_SEGMENT, PH_W_OUTSIDE,
            "%zu of %zu points of the panorama are outside of the volume",
            p->outside, p->points);
  }
  return status;
}

static enum ph_status derive_strips(const struct ph_options *o,
                                    struct ph_arena *arena, struct ph_result *r,
                                    struct ph_derived *derived,
                                    struct ph_diag *diag) {
  const struct ph_format_row *format = &ph_formats[o->format];
  struct ph_grid_rules rules = o->grid;
  enum ph_status status = derive_parallels(o, arena, r, diag);
  for (size_t i = 0; status == PH_OK && i <= r->parallels_n; i++) {
    status = derive_polygons(o, arena,
                             i ? &r->parallels[i - 1].curve : &r->curve, diag);
  }
  if (format->is_mesh && status == PH_OK) {
    rules.along = rules.along ? rules.along : STRIP_STEPS;
    if (!ph_grid_across(&r->curve, &rules)) {
      return ph_fail(diag, PH_E_BAD_VALUE, "height",
                     "must have an extent for --format=%s, as in "
                     "--height=[-1,1]",
                     ph_format_name(o->format));
    }
  }
  if (status == PH_OK && o->panorama) {
    status = derive_panorama(o, arena, r, diag);
  }
  if (status == PH_OK && (format->is_cubics || format->is_nurbs)) {
    return derive_flat(arena, r, derived, diag);
  }
  if (status == PH_OK && rules.along) {
    status = derive_grids(&rules, arena, r, diag);
  }
  for (size_t i = 0; status == PH_OK && i < derived->tilings_n; i++) {
    const struct ph_parallel *p = i ? &r->parallels[i - 1] : NULL;
    status =
        ph_tiling_of_strips(p ? &p->curve : &r->curve, p ? &p->grid : &r->grid,
                            arena, &derived->tilings[i], diag);
    derived->tilings[i].distance = p ? p->distance : 0;
  }
  return status;
}

/* ---- patches ------------------------------------------------------------- */

/* Surfaces beside one of patches, as samples. */
static enum ph_status derive_beside(const struct ph_options *o, size_t steps,
                                    struct ph_arena *arena, struct ph_result *r,
                                    struct ph_diag *diag) {
  enum ph_status status = PH_OK;
  size_t back;
  if (o->offsets_n && r->curve.surface.continuity == 0) {
    return ph_fail(diag, PH_E_BAD_VALUE, "continuity",
                   "must be 1 or 2 for --offset: of 0 normals jump at edges");
  }
  r->parallels = ph_arena_array(arena, o->offsets_n, sizeof *r->parallels);
  if (!r->parallels) {
    return ph_fail_memory(diag);
  }
  for (size_t i = 0; status == PH_OK && i < o->offsets_n; i++) {
    struct ph_parallel *p = &r->parallels[i];
    *p = (struct ph_parallel){.distance = o->offsets[i]};
    status = ph_patch_grid_of(&r->curve, p->distance, steps, o->grid.most,
                              arena, &p->places, &back, diag);
    if (status == PH_OK && back != PH_NO_SEGMENT) {
      ph_warn(r, back, PH_W_OFFSET_CUSP,
              "the surface at distance %g turns back, where radii of curvature "
              "towards it are smaller: first in patches[%zu]",
              p->distance, back);
    }
  }
  r->parallels_n = o->offsets_n;
  return status;
}

static enum ph_status derive_patches(const struct ph_options *o,
                                     struct ph_arena *arena,
                                     struct ph_result *r,
                                     struct ph_derived *derived,
                                     struct ph_diag *diag) {
  const bool is_mesh = ph_formats[o->format].is_mesh;
  const size_t steps = o->grid.along ? o->grid.along
                       : is_mesh     ? PATCH_STEPS
                                     : 0;
  enum ph_status status = PH_OK;
  size_t back;
  if (o->edges && !r->curve.surface.edges.n) {
    status = ph_patch_edges_of(&r->curve, arena, &r->curve.surface.edges, diag);
  }
  if (status == PH_OK && steps) {
    status = ph_patch_grid_of(&r->curve, 0, steps, o->grid.most, arena,
                              &r->places, &back, diag);
  }
  if (status == PH_OK && steps) {
    status = derive_beside(o, steps, arena, r, diag);
  }
  for (size_t i = 0; status == PH_OK && i < derived->tilings_n; i++) {
    const struct ph_parallel *p = i ? &r->parallels[i - 1] : NULL;
    status = ph_tiling_of_patches(&r->curve, p ? &p->places : &r->places, steps,
                                  arena, &derived->tilings[i], diag);
    derived->tilings[i].distance = p ? p->distance : 0;
  }
  return status;
}

enum ph_status ph_derive_surface(const struct ph_options *o,
                                 struct ph_arena *arena, struct ph_result *r,
                                 struct ph_derived *derived,
                                 struct ph_diag *diag) {
  enum ph_status status;
  if (ph_formats[o->format].is_mesh) {
    derived->tilings_n = o->offsets_n + 1;
    derived->tilings =
        ph_arena_array(arena, derived->tilings_n, sizeof *derived->tilings);
    if (!derived->tilings) {
      return ph_fail_memory(diag);
    }
  }
  status = ph_kind_of(&r->curve)->parts == PH_STRIPS_PARTS
               ? derive_strips(o, arena, r, derived, diag)
               : derive_patches(o, arena, r, derived, diag);
  if (status == PH_OK && o->format == PH_FORMAT_STL &&
      !ph_stl_fits(derived->tilings, derived->tilings_n)) {
    return ph_fail(diag, PH_E_BAD_VALUE, "points",
                   "are beyond the numbers of --format=stl, or the triangles "
                   "are too many");
  }
  return status;
}
