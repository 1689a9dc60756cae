/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Surfaces in a view: cells between rulings, from the farthest to the nearest,
 * so that each hides what is behind it (the algorithm of the painter); and the
 * same in the development.
 */
#ifndef PH_PLOT_SOLID_H
#define PH_PLOT_SOLID_H

#include "base/diag.h"
#include "base/mem.h"
#include "plot/colour.h"
#include "plot/view.h"

#include <stdbool.h>

struct ph_drawing;
struct ph_look;
struct ph_panel;

/* A line of a cell. */
enum ph_cell_line { PH_CELL_NONE, PH_CELL_RULING, PH_CELL_EDGE };

/* A part of the surface, in the unit of the panel. */
struct ph_cell {
  ph_vec3 corner[4];         /* around it; 0 to 1 and 3 to 2 along rulings */
  enum ph_cell_line line[4]; /* from a corner to the next */
  ph_vec3 contact[2];        /* the contact curve in it */
  bool has_contact, filled;
  struct ph_colour fill, ink, contact_ink; /* ink: of edges */
  double depth;
  size_t number; /* in the order in which they were made */
};

struct ph_cells {
  struct ph_cell *v;
  size_t n;
};

/* ph_solid_view: from where to look at the surfaces of a panel: where the most
 * of them is seen. */
struct ph_view ph_solid_view(const struct ph_panel *panel);

/*
 * ph_solid_make: the cells of all surfaces of a panel: in its views, and of
 * their developments, in the unit panel->flat_unit.
 *
 * ret  PH_OK | PH_E_NO_MEMORY
 */
enum ph_status ph_solid_make(const struct ph_panel *panel,
                             struct ph_arena *arena, struct ph_cells *solid,
                             struct ph_cells *flat, struct ph_diag *diag);

/* ph_solid_arrow: how long the vectors of contact elements are, in the unit of
 * the data. */
double ph_solid_arrow(const struct ph_panel *panel,
                      const struct ph_drawing *drawing);

/* ph_solid_draw: the surfaces of a panel, with contact elements; lines that are
 * hidden are dashed. */
void ph_solid_draw(const struct ph_look *look);

/* ph_solid_flat: the developments; the panel's unit is that of these. */
void ph_solid_flat(const struct ph_look *look);

#endif
