/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Where panels go on a page, and how large page and letters are. */
#ifndef PH_PLOT_LAYOUT_H
#define PH_PLOT_LAYOUT_H

#include "plot/key.h"
#include "plot/panel.h"

struct ph_layout {
  double width, height; /* of the page */
  double em;            /* size of letters */
  size_t columns, rows;
  struct ph_rect *cells; /* [n] */
  double title;          /* its base line, where there is one */
  struct ph_rect key;    /* empty: there is none */
};

/* What is beside the panels: a title above, a key and a note below. */
struct ph_beside {
  bool title, note;
  struct ph_key key;
};

/*
 * ph_layout_make: a grid of n panels, row by row.
 *
 * in   rules   width and height of the page, where they are not 0, are kept;
 *              letters grow and shrink with the page, but stay legible
 * in   beside  what has room above and below the panels
 * ret  PH_OK | PH_E_NO_MEMORY
 */
enum ph_status ph_layout_make(const struct ph_panel *panels, size_t n,
                              const struct ph_figure_rules *rules,
                              const struct ph_beside *beside,
                              struct ph_arena *arena, struct ph_layout *layout,
                              struct ph_diag *diag);

#endif
