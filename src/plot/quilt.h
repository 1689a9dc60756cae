/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Surfaces of patches in a row of three views from one direction: shaded, with
 * the borders of patches; isophotes, stripes of equal angle between normal and
 * light, which break where normals jump and have kinks where curvatures do; and
 * bands of equal mean curvature.
 */
#ifndef PH_PLOT_QUILT_H
#define PH_PLOT_QUILT_H

#include "base/diag.h"
#include "base/mem.h"
#include "curve/result.h"
#include "kernel/vec3.h"

#include <stdbool.h>

struct ph_drawing;
struct ph_drawing_names;
struct ph_panel;
struct ph_page;
struct ph_rect;

/* A place of a patch. */
struct ph_quilt_place {
  ph_vec3 p, normal; /* in the unit of the data */
  double mean;       /* curvature; NaN: none */
};

/* Places of all patches, (steps + 1)^2 of each. */
struct ph_quilt {
  struct ph_quilt_place *at;
  size_t patches_n, steps;
  double range[2]; /* of most mean curvatures */
};

/* A figure has no more tiles, or one for each patch, of a surface. */
enum { PH_QUILT_TILES = 12000, PH_QUILT_STEPS = 24 };

/* Results of a sweep that are shown, each as a row. */
enum { PH_QUILT_ROWS = 12 };

/* ph_quilt_drawing: the drawing of such a surface, as ph_drawing_make. */
enum ph_status ph_quilt_drawing(const struct ph_result *result,
                                const struct ph_drawing_names *names,
                                struct ph_drawing **drawing,
                                struct ph_diag *diag);

/* ph_quilt_rows: of a panel. */
size_t ph_quilt_rows(const struct ph_panel *panel);

/* ph_quilt_draw: the rows of a panel; no memory: fewer of them. */
void ph_quilt_draw(const struct ph_panel *panel, struct ph_page *page,
                   const struct ph_rect *rect, double em);

#endif
