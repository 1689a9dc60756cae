/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Lines cut to a rectangle, before they get to cairo: its coordinates are
 * fixed-point numbers that overflow at 8 million.
 */
#ifndef PH_PLOT_CLIP_H
#define PH_PLOT_CLIP_H

#include <stdbool.h>

/* A place on the page: y downwards. */
struct ph_spot {
  double x, y;
};

struct ph_rect {
  double x, y, w, h;
};

/* ph_rect_has: whether the spot is in the rectangle, or within `more` of it. */
bool ph_rect_has(const struct ph_rect *rect, struct ph_spot spot, double more);

/*
 * ph_clip: the part of a line in a rectangle (Liang and Barsky 1984).
 *
 * inout  a, b  the ends of the line; what is not finite is nowhere
 * ret    false: no part of it is in there
 */
bool ph_clip(const struct ph_rect *rect, struct ph_spot *a, struct ph_spot *b);

#endif
