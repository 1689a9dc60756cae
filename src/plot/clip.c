/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Lines cut to a rectangle (see clip.h). */
#include "plot/clip.h"

#include <math.h>

bool ph_rect_has(const struct ph_rect *rect, struct ph_spot spot, double more) {
  return spot.x >= rect->x - more && spot.x <= rect->x + rect->w + more &&
         spot.y >= rect->y - more && spot.y <= rect->y + rect->h + more;
}

/* Cuts [t0,t1] to where a + t d is in [low,high]; t for both ends inside is
 * left as it is. */
static bool cut(double a, double d, double low, double high, double t[2]) {
  double at_low, at_high;
  if (!(d < 0 || d > 0)) {
    return a >= low && a <= high;
  }
  at_low = (low - a) / d;
  at_high = (high - a) / d;
  t[0] = fmax(t[0], fmin(at_low, at_high));
  t[1] = fmin(t[1], fmax(at_low, at_high));
  return t[0] <= t[1];
}

bool ph_clip(const struct ph_rect *rect, struct ph_spot *a, struct ph_spot *b) {
  double t[2] = {0, 1}, dx = b->x - a->x, dy = b->y - a->y;
  struct ph_spot from = *a;
  if (!(isfinite(from.x) && isfinite(from.y) && isfinite(dx) && isfinite(dy)) ||
      !cut(from.x, dx, rect->x, rect->x + rect->w, t) ||
      !cut(from.y, dy, rect->y, rect->y + rect->h, t)) {
    return false;
  }
  if (t[0] > 0) {
    a->x = from.x + t[0] * dx;
    a->y = from.y + t[0] * dy;
  }
  if (t[1] < 1) {
    b->x = from.x + t[1] * dx;
    b->y = from.y + t[1] * dy;
  }
  return true;
}
