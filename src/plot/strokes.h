/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * What a view of a panel shows: curves, polygons, offsets, tangents and points,
 * as one looks at them through a window.
 */
#ifndef PH_PLOT_STROKES_H
#define PH_PLOT_STROKES_H

#include "plot/panel.h"

/* A view, where it goes. */
struct ph_look {
  const struct ph_panel *panel;
  struct ph_view view;
  struct ph_window window;
  struct ph_page *page;
  double em;
};

/* Which parts: on a sphere those behind it come first, dashed. */
enum ph_side { PH_SIDE_ALL, PH_SIDE_HIDDEN, PH_SIDE_VISIBLE };

/* ph_strokes_draw: all strokes of all drawings, then their points. */
void ph_strokes_draw(const struct ph_look *look, enum ph_side side);

/* Numbers of points that are there; {.n = 0}: none yet. */
struct ph_labels {
  size_t n;
  struct ph_spot at[PH_DRAWING_SEGMENTS + 1];
};

/* ph_strokes_label: the number of a point beside its spot, unless it would
 * cover another one or leave the window. */
void ph_strokes_label(const struct ph_look *look, struct ph_labels *labels,
                      struct ph_spot spot, size_t number);

/* ph_strokes_line: any polyline in space, in the unit, with the pen as it is:
 * one path. */
void ph_strokes_line(const struct ph_look *look, enum ph_side side,
                     const ph_vec3 *places, size_t n);

/* ph_strokes_arrow: a thin arrow in space, in the unit, with the pen as it is.
 */
void ph_strokes_arrow(const struct ph_look *look, const ph_vec3 ends[2]);

#endif
