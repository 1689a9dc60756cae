/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A panel: what there is to show, and how high it wants to be (see panel.h;
 * panel_draw.c draws it). */
#include "plot/panel.h"

#include "plot/globe.h"

#include <float.h>
#include <math.h>

/* Polygons are shown up to so far out of the box of all else, of its size. */
#define POLYGON_REACH 0.5

static void extend(ph_vec3 *low, ph_vec3 *high, ph_vec3 p) {
  low->x = fmin(low->x, p.x);
  low->y = fmin(low->y, p.y);
  low->z = fmin(low->z, p.z);
  high->x = fmax(high->x, p.x);
  high->y = fmax(high->y, p.y);
  high->z = fmax(high->z, p.z);
}

static bool is_finite(ph_vec3 p) {
  return isfinite(p.x) && isfinite(p.y) && isfinite(p.z);
}

/* The box of all drawings but their polygons, and its unit. */
static void find_unit(struct ph_panel *panel) {
  const struct ph_drawing *first = panel->drawings[0];
  ph_vec3 low = ph_vec3_of(DBL_MAX, DBL_MAX, DBL_MAX);
  ph_vec3 high = ph_vec3_scale(-1, low);
  for (size_t i = 0; i < panel->n; i++) {
    const struct ph_drawing *d = panel->drawings[i];
    if (is_finite(d->low) && is_finite(d->high)) {
      extend(&low, &high, d->low);
      extend(&low, &high, d->high);
    }
  }
  if (!(low.x <= high.x && low.y <= high.y && low.z <= high.z)) {
    low = high = ph_vec3_of(0, 0, 0);
  }
  panel->unit = ph_unit_of(low, high);
  if (first->space == PH_SPHERE) {
    panel->unit.center = ph_vec3_get(first->center, 3);
    panel->unit.size = first->radius > 0 ? first->radius : 1;
  }
  panel->low = ph_unit_in(&panel->unit, low);
  panel->high = ph_unit_in(&panel->unit, high);
}

/* Polygons, as far as they are near the curve. */
static void include_polygons(struct ph_panel *panel) {
  const struct ph_drawing *d = panel->drawings[0];
  double reach = POLYGON_REACH;
  ph_vec3 low = panel->low, high = panel->high;
  for (size_t i = 0; panel->n == 1 && i < d->strokes_n; i++) {
    const struct ph_stroke *s = &d->strokes[i];
    for (size_t k = 0; s->role == PH_STROKE_POLYGON && k < s->n; k++) {
      ph_vec3 p = ph_unit_in(&panel->unit, s->points[k]);
      if (is_finite(p)) {
        extend(&low, &high, p);
      }
    }
  }
  panel->low.x = fmax(low.x, panel->low.x - reach);
  panel->low.y = fmax(low.y, panel->low.y - reach);
  panel->low.z = fmax(low.z, panel->low.z - reach);
  panel->high.x = fmin(high.x, panel->high.x + reach);
  panel->high.y = fmin(high.y, panel->high.y + reach);
  panel->high.z = fmin(high.z, panel->high.z + reach);
}

static void find_views(struct ph_panel *panel) {
  switch (panel->drawings[0]->space) {
  case PH_PLANE:
    panel->views[0] = ph_view_axes(0, 1);
    panel->views_n = 1;
    break;
  case PH_SPACE:
    panel->views[0] = ph_view_axes(0, 1);
    panel->views[1] = ph_view_axes(0, 2);
    panel->views[2] = ph_view_axes(1, 2);
    panel->views[3] = ph_view_from(ph_vec3_of(0.5, -0.76, 0.42));
    panel->views_n = 4;
    break;
  case PH_SPHERE:
    panel->views_n = ph_globe_views(panel, panel->views);
    break;
  case PH_SURFACE:
    panel->views[0] = ph_solid_view(panel);
    panel->views_n = 1;
    break;
  case PH_PATCHWORK: /* plot/quilt.c has them */
    break;
  }
}

/* The box of all developments, and its unit. */
static void find_flat(struct ph_panel *panel) {
  ph_vec3 low = ph_vec3_of(DBL_MAX, DBL_MAX, 0), high = ph_vec3_scale(-1, low);
  for (size_t i = 0; i < panel->n; i++) {
    const struct ph_sheet *sheet = &panel->drawings[i]->sheets[0];
    for (size_t k = 0; k < sheet->ribs_n; k++) {
      extend(&low, &high, sheet->ribs[k].flat[0]);
      extend(&low, &high, sheet->ribs[k].flat[1]);
    }
    for (size_t k = 0; k < sheet->elements_n; k++) {
      const struct ph_element *e = &sheet->elements[k];
      extend(&low, &high, e->flat);
      extend(&low, &high,
             ph_vec3_along(e->flat, ph_solid_arrow(panel, panel->drawings[i]),
                           e->flat_tangent));
    }
  }
  panel->flat_unit = ph_unit_of(low, high);
  panel->flat_low = ph_unit_in(&panel->flat_unit, low);
  panel->flat_high = ph_unit_in(&panel->flat_unit, high);
}

static bool has_torsion(const struct ph_panel *panel) {
  for (size_t i = 0; i < panel->n; i++) {
    const struct ph_drawing *d = panel->drawings[i];
    for (size_t k = 0; k < d->segments_n; k++) {
      if (d->profiles[k].torsion) {
        return true;
      }
    }
  }
  return false;
}

enum ph_status ph_panel_make(const struct ph_drawing *const *drawings, size_t n,
                             struct ph_arena *scratch, struct ph_panel *panel,
                             struct ph_diag *diag) {
  enum ph_status status = PH_OK;
  *panel = (struct ph_panel){.drawings = drawings, .n = n};
  find_unit(panel);
  include_polygons(panel);
  find_views(panel);
  for (size_t i = 0; i < n; i++) {
    double length = drawings[i]->length;
    panel->length =
        isfinite(length) ? fmax(panel->length, length) : panel->length;
  }
  if (!(panel->length > 0)) {
    panel->length = panel->unit.size;
  }
  panel->profiles_n = drawings[0]->space == PH_PATCHWORK ? 0
                      : has_torsion(panel)               ? 2
                                                         : 1;
  for (size_t i = 0; status == PH_OK && i < panel->profiles_n; i++) {
    status = ph_profile_range(drawings, n, (enum ph_profile_of)i, panel->length,
                              scratch, &panel->ranges[i], diag);
  }
  if (status == PH_OK && drawings[0]->space == PH_SURFACE) {
    find_flat(panel);
    status = ph_solid_make(panel, scratch, &panel->solid, &panel->flat, diag);
  }
  return status;
}
