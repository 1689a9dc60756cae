/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Views of the data (see view.h). */
#include "plot/view.h"

#include <float.h>

/* Halves: the difference of two doubles may be too large for one. */
static double half_of(double low, double high) {
  return 0.5 * high - 0.5 * low;
}

static double middle_of(double low, double high) {
  double m = 0.5 * high + 0.5 * low;
  return isfinite(m) ? m : 0;
}

struct ph_unit ph_unit_of(ph_vec3 low, ph_vec3 high) {
  struct ph_unit unit;
  double size = 0, far;
  unit.center = ph_vec3_of(middle_of(low.x, high.x), middle_of(low.y, high.y),
                           middle_of(low.z, high.z));
  far =
      fmax(fabs(unit.center.x), fmax(fabs(unit.center.y), fabs(unit.center.z)));
  size = fmax(half_of(low.x, high.x),
              fmax(half_of(low.y, high.y), half_of(low.z, high.z)));
  if (!(size > 1e-13 * far && isfinite(size))) {
    size = far > 0 ? 0.1 * far : 1;
  }
  unit.size = fmax(size, DBL_MIN); /* half of it must not be 0 */
  return unit;
}

static double in(double x, double center, double size) {
  return (0.5 * x - 0.5 * center) / (0.5 * size);
}

ph_vec3 ph_unit_in(const struct ph_unit *unit, ph_vec3 p) {
  return ph_vec3_of(in(p.x, unit->center.x, unit->size),
                    in(p.y, unit->center.y, unit->size),
                    in(p.z, unit->center.z, unit->size));
}

double ph_unit_out(double center, double size, double x) {
  return 2 * (0.5 * center + 0.5 * size * x);
}

static ph_vec3 axis(int i) {
  return ph_vec3_of(i == 0, i == 1, i == 2);
}

struct ph_view ph_view_axes(int right, int up) {
  struct ph_view view = {axis(right), axis(up), {0, 0, 0}};
  view.toward = ph_vec3_cross(view.right, view.up);
  return view;
}

struct ph_view ph_view_from(ph_vec3 toward) {
  struct ph_view view;
  ph_vec3 pole = ph_vec3_of(0, 0, 1);
  view.toward = ph_vec3_unit(toward);
  if (!(hypot(view.toward.x, view.toward.y) > 0.05)) {
    pole = ph_vec3_of(0, view.toward.z > 0 ? 1 : -1, 0);
  }
  view.right = ph_vec3_unit(ph_vec3_cross(pole, view.toward));
  view.up = ph_vec3_cross(view.toward, view.right);
  return view;
}

struct ph_seen ph_view_see(const struct ph_view *view, ph_vec3 p) {
  struct ph_seen seen = {ph_vec3_dot(p, view->right), ph_vec3_dot(p, view->up),
                         ph_vec3_dot(p, view->toward)};
  return seen;
}

bool ph_view_hidden(struct ph_seen seen) {
  return seen.depth < 0 && seen.u * seen.u + seen.v * seen.v < 1 + 1e-6;
}

double ph_view_horizon(struct ph_seen a, struct ph_seen b) {
  double t = a.depth / (a.depth - b.depth);
  return t >= 0 && t <= 1 ? t : 0.5;
}

struct ph_spot ph_window_spot(const struct ph_window *window,
                              struct ph_seen seen) {
  struct ph_spot spot = {window->rect.x + 0.5 * window->rect.w +
                             window->scale * (seen.u - window->u),
                         window->rect.y + 0.5 * window->rect.h -
                             window->scale * (seen.v - window->v)};
  return spot;
}
