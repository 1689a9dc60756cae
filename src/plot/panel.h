/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A panel: one problem, with its views above and its profiles below.
 */
#ifndef PH_PLOT_PANEL_H
#define PH_PLOT_PANEL_H

#include "base/mem.h"
#include "plot/drawing.h"
#include "plot/page.h"
#include "plot/profile.h"
#include "plot/solid.h"
#include "plot/text.h"
#include "plot/view.h"

#include <stdbool.h>

enum { PH_PANEL_PROFILES_MAX = 2, PH_PANEL_VIEWS_MAX = 4 };

struct ph_panel {
  const struct ph_drawing *const *drawings; /* [n], of the same space */
  size_t n;
  char title[PH_PLOT_TEXT_MAX]; /* clean; "": none */
  struct ph_unit unit;
  ph_vec3 low, high; /* what is seen, in the unit */
  struct ph_view views[PH_PANEL_VIEWS_MAX];
  size_t views_n;
  struct ph_cells solid, flat; /* of surfaces, and of their developments, */
  struct ph_unit flat_unit;    /* in this unit of its own, */
  ph_vec3 flat_low, flat_high; /* in this box */
  double length;               /* of the longest curve, > 0 */
  struct ph_range ranges[PH_PANEL_PROFILES_MAX]; /* by enum ph_profile_of */
  size_t profiles_n;
  bool labels; /* points have their numbers */
};

/*
 * ph_panel_make: looks through the drawings of a problem.
 *
 * in   drawings[n]  n > 0, all of the same space
 * ret  PH_OK | PH_E_NO_MEMORY
 */
enum ph_status ph_panel_make(const struct ph_drawing *const *drawings, size_t n,
                             struct ph_arena *scratch, struct ph_panel *panel,
                             struct ph_diag *diag);

/* ph_panel_height: of a panel of a width that shows everything well, with
 * letters of size em. */
double ph_panel_height(const struct ph_panel *panel, double width, double em);

/* ph_panel_draw: draws the panel in its place on the page. */
void ph_panel_draw(const struct ph_panel *panel, struct ph_page *page,
                   const struct ph_rect *cell, double em);

#endif
