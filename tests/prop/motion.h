/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Motions of data in space, as the tests of properties have them. */
#ifndef PH_TESTS_PROP_MOTION_H
#define PH_TESTS_PROP_MOTION_H

#include "spatial_unit.h"

/* v -> scale times the turn of v, or of its mirror image in z = 0, plus shift;
 * then backwards from datum `first`, or on from it. */
struct motion {
  ph_quat turn;
  double scale;
  ph_vec3 shift;
  bool mirror, reverse;
  size_t first;
};

static const struct motion REST = {.turn = {1, 0, 0, 0}, .scale = 1};

static inline ph_vec3 turned(const struct motion *m, ph_vec3 v) {
  ph_quat q = m->turn;
  ph_vec3 w;
  v.z = m->mirror ? -v.z : v.z;
  w = ph_vec3_scale(v.x, ph_quat_i(q, q));
  w = ph_vec3_along(w, v.y, ph_quat_j(q, q));
  return ph_vec3_scale(m->scale, ph_vec3_along(w, v.z, ph_quat_k(q, q)));
}

static inline ph_vec3 moved(const struct motion *m, ph_vec3 v) {
  return ph_vec3_add(turned(m, v), m->shift);
}

static inline void turn(struct unit_random *r, struct motion *m) {
  m->turn = unit_random_turn(r);
}

static inline void mirror(struct unit_random *r, struct motion *m) {
  turn(r, m);
  m->mirror = true;
}

#endif
