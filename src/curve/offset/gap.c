/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Gaps of offsets (see gap.h). */
#include "curve/offset/gap.h"

/* Of the size of the curve and the distance together: a jump that is less comes
 * of the tolerances that joints are made with. */
static const double LEAST = 1e-9;

/* Gaps that there is room for at first. */
enum { ROOM = 16 };

/* Unit vectors across a segment at its ends. */
struct ends {
  ph_vec3 first, last;
};

/* The normal of the frame, A j A* or A k A* of a unit A. */
static ph_vec3 normal_at(ph_quat a, enum ph_normal normal) {
  const ph_quat unit = ph_quat_scale(1 / ph_quat_abs(a), a);
  return ph_normal_between(normal, unit, unit);
}

static struct ends ends_of(const struct ph_curve *curve, size_t k,
                           enum ph_normal normal) {
  const struct ph_seg3 seg = ph_seg3_of(curve, k);
  return (struct ends){normal_at(seg.a[0], normal),
                       normal_at(seg.a[2], normal)};
}

enum ph_status ph_gaps_of(const struct ph_curve *curve, double distance,
                          enum ph_normal normal, struct ph_arena *arena,
                          struct ph_gaps *gaps, struct ph_diag *diag) {
  const double least = LEAST * (ph_curve_size(curve) + fabs(distance));
  size_t room = 0;
  struct ends before = ends_of(curve, curve->n - 1, normal);
  *gaps = (struct ph_gaps){0, NULL};
  for (size_t k = 0; k < curve->n; k++) {
    const struct ends ends = ends_of(curve, k, normal);
    const double jump = ph_vec3_abs(ph_vec3_sub(ends.first, before.last));
    if ((k > 0 || curve->closed) && !(fabs(distance) * jump <= least)) {
      gaps->before = ph_arena_grow(arena, gaps->before, gaps->n,
                                   sizeof *gaps->before, ROOM, &room);
      if (!gaps->before) {
        return ph_fail_memory(diag);
      }
      gaps->before[gaps->n++] = k;
    }
    before = ends;
  }
  return PH_OK;
}
