/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Spatial PH quintic and ATPH segments (see ph3.h). */
#include "curve/segment/ph3.h"

void ph_ph3_speed(const ph_quat a[3], double speed[5]) {
  speed[0] = ph_quat_dot(a[0], a[0]);
  speed[1] = ph_quat_dot(a[0], a[1]);
  speed[2] = (2 * ph_quat_dot(a[1], a[1]) + ph_quat_dot(a[0], a[2])) / 3;
  speed[3] = ph_quat_dot(a[1], a[2]);
  speed[4] = ph_quat_dot(a[2], a[2]);
}

double ph_ph3_length(const struct ph_atph *space, const ph_quat a[3]) {
  const double *q = space->q;
  return q[0] * (ph_quat_dot(a[0], a[0]) + ph_quat_dot(a[2], a[2])) +
         q[1] * (ph_quat_dot(a[0], a[1]) + ph_quat_dot(a[1], a[2])) +
         q[2] * ph_quat_dot(a[1], a[1]) + q[3] * ph_quat_dot(a[0], a[2]);
}

void ph_ph3_control_points(const struct ph_atph *space, const ph_quat a[3],
                           ph_vec3 start, ph_vec3 end, ph_vec3 p[6]) {
  double outer = space->q[0], inner = space->q[1];
  p[0] = start;
  p[1] = ph_vec3_along(start, outer, ph_quat_i(a[0], a[0]));
  p[2] = ph_vec3_along(p[1], inner, ph_quat_i(a[0], a[1]));
  p[4] = ph_vec3_along(end, -outer, ph_quat_i(a[2], a[2]));
  p[3] = ph_vec3_along(p[4], -inner, ph_quat_i(a[1], a[2]));
  p[5] = end;
}
