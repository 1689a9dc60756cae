/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Axes: a frame with ticks, numbers and names on its left and lower sides. */
#ifndef PH_PLOT_AXES_H
#define PH_PLOT_AXES_H

#include "plot/page.h"
#include "plot/tick.h"

/* One axis: low at the left or lower end, high at the other, low < high. */
struct ph_axis {
  const char *name;
  double low, high;
  bool bare; /* ticks only: another axis has the numbers */
  struct ph_ticks ticks;
};

struct ph_axes {
  struct ph_rect rect;
  double left; /* from the frame to the left end of it all; 0: as is needed */
  struct ph_axis x, y;
};

/* ph_axes_ticks: chooses ticks that there is room for, with letters of size
 * em. */
void ph_axes_ticks(struct ph_axes *axes, struct ph_page *page, double em);

/* ph_axes_left: how much room numbers and name of the y axis take. */
double ph_axes_left(const struct ph_axes *axes, struct ph_page *page,
                    double em);

/* ph_axes_below: how much room those of an x axis take. */
double ph_axes_below(double em);

/* ph_axes_draw: the frame, every tick a path of its own, and the texts. */
void ph_axes_draw(const struct ph_axes *axes, struct ph_page *page, double em);

/* ph_axis_name: its name, centred, with what its numbers are multiplied by; in
 * smaller letters where there is no room for it (room 0: there is). */
void ph_axis_name(const struct ph_axis *axis, struct ph_page *page, double em,
                  double room, struct ph_spot at, bool up);

/* ph_axis_place: 0 .. 1 from low to high. */
double ph_axis_place(const struct ph_axis *axis, double value);

#endif
