/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The box of what is seen from an angle: its edges, and at three of them in
 * front ticks, numbers and names of the axes. */
#ifndef PH_PLOT_BOX_H
#define PH_PLOT_BOX_H

#include "plot/strokes.h"

/* ph_box_draw: inout look  its window is moved and scaled to show all of it. */
void ph_box_draw(struct ph_look *look);

#endif
