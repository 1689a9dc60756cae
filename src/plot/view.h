/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Views: from the coordinates of the data to a plane that is looked at.
 *
 * First everything is moved and scaled so that the drawing is of size 1 around
 * the origin, whatever its unit; then it is seen from far away in a direction.
 */
#ifndef PH_PLOT_VIEW_H
#define PH_PLOT_VIEW_H

#include "kernel/vec3.h"
#include "plot/clip.h"

#include <stdbool.h>

/* p becomes (p - center) / size: the drawing's box lies in [-1,1]^3. */
struct ph_unit {
  ph_vec3 center;
  double size;
};

/*
 * ph_unit_of: the unit of a box.
 *
 * A box that is a point, or too small for its place, gets a size that can be
 * seen; what is not finite is taken as 0.
 */
struct ph_unit ph_unit_of(ph_vec3 low, ph_vec3 high);

/* ph_unit_in, ph_unit_out: to the unit, and back; no overflow on the way. */
ph_vec3 ph_unit_in(const struct ph_unit *unit, ph_vec3 p);
double ph_unit_out(double center, double size, double x);

/* Orthonormal; toward is where the eye is. */
struct ph_view {
  ph_vec3 right, up, toward;
};

/* ph_view_axes: along the axes: a pair of 0, 1, 2 for x, y, z. */
struct ph_view ph_view_axes(int right, int up);

/* ph_view_from: from a direction, not 0, with the z axis upwards, or from a
 * pole the y axis. */
struct ph_view ph_view_from(ph_vec3 toward);

/* A place seen: in the plane of the view, and how far it is towards the eye. */
struct ph_seen {
  double u, v, depth;
};

struct ph_seen ph_view_see(const struct ph_view *view, ph_vec3 p);

/* ph_view_hidden: whether the unit sphere hides a place on it or outside. */
bool ph_view_hidden(struct ph_seen seen);

/* ph_view_horizon: the place on the line from a visible to a hidden place, or
 * the other way round, where it vanishes: t in [0,1]. */
double ph_view_horizon(struct ph_seen a, struct ph_seen b);

/* What part of the plane of a view is where on the page: the center of the
 * rectangle shows (u, v), and a unit is `scale` points long. */
struct ph_window {
  struct ph_rect rect;
  double u, v, scale;
};

struct ph_spot ph_window_spot(const struct ph_window *window,
                              struct ph_seen seen);

#endif
