/* SPDX-License-Identifier: GPL-3.0-or-later */
/* How far chords are from a spherical curve (see bend.h). */
#include "curve/bend.h"

double ph_bend_spherical(const struct ph_spherical *segment, double distance,
                         double u0, double u1) {
  (void)segment, (void)distance, (void)u0, (void)u1;
  return (double)INFINITY;
}
