/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A drawing while it is made (see pen.h). */
#include "plot/pen.h"

#include <math.h>
#include <string.h>

static bool is_finite(ph_vec3 p) {
  return isfinite(p.x) && isfinite(p.y) && isfinite(p.z);
}

static bool is_same(ph_vec3 a, ph_vec3 b) {
  return memcmp(&a, &b, sizeof a) == 0;
}

void ph_pen_box(struct ph_drawing *d, ph_vec3 p) {
  d->low =
      ph_vec3_of(fmin(d->low.x, p.x), fmin(d->low.y, p.y), fmin(d->low.z, p.z));
  d->high = ph_vec3_of(fmax(d->high.x, p.x), fmax(d->high.y, p.y),
                       fmax(d->high.z, p.z));
}

void ph_pen_to(struct ph_pen *pen, ph_vec3 p) {
  ph_vec3 *grown;
  if (pen->failed || !is_finite(p) ||
      (pen->n > 0 && is_same(pen->points[pen->n - 1], p))) {
    return;
  }
  grown = ph_arena_grow(&pen->scratch, pen->points, pen->n, sizeof p, 64,
                        &pen->room);
  if (!grown) {
    pen->failed = true;
    return;
  }
  pen->points = grown;
  pen->points[pen->n++] = p;
  if (pen->box) {
    ph_pen_box(pen->drawing, p);
  }
}

void ph_pen_lift(struct ph_pen *pen, enum ph_stroke_role role, size_t index) {
  struct ph_drawing *d = pen->drawing;
  size_t n = pen->n < 2 ? 2 : pen->n;
  struct ph_stroke stroke = {role, index, n, NULL};
  if (pen->failed || pen->n == 0) {
    return;
  }
  stroke.points = ph_arena_array(&d->arena, n, sizeof *stroke.points);
  if (!stroke.points) {
    pen->failed = true;
    return;
  }
  stroke.points[1] = pen->points[0];
  memcpy(stroke.points, pen->points, pen->n * sizeof *stroke.points);
  d->strokes[d->strokes_n++] = stroke;
  d->places += n;
  pen->n = 0;
}
