/* SPDX-License-Identifier: GPL-3.0-or-later */
/* How far chords are from a curve (see bend.h). */
#include "curve/bend.h"

double ph_bend_ph(const struct ph_seg3 *seg, double u0, double u1) {
  (void)seg, (void)u0, (void)u1;
  return (double)INFINITY;
}
double ph_bend_bezier(const ph_vec3 *p, size_t degree, double u0, double u1) {
  (void)p, (void)degree, (void)u0, (void)u1;
  return (double)INFINITY;
}
