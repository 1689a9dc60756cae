/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The rulings of a strip, whatever it was found by: all that samples, figures
 * and volumes ask of one.
 */
#ifndef PH_CURVE_SURFACE_RULING_H
#define PH_CURVE_SURFACE_RULING_H

#include "curve/surface/strip.h"

/* A ruling: arc length of the contact curve from the start of the strip, frame
 * on it, the same in the development, geodesic and normal curvature there. */
struct ph_ruling {
  double s;
  struct ph_strip_place at;
  struct ph_flat_place flat;
  double k, kn;
};

/* ph_ruling_at: that at u, from 0 to 1 along the strip, by arc length; of a
 * strip at a distance from a general one, by that of the latter. */
struct ph_ruling ph_ruling_at(const struct ph_strip *strip, double u);

/* ph_ruling_point: the point of a ruling at h. */
static inline ph_vec3 ph_ruling_point(const struct ph_ruling *ruling,
                                      double h) {
  return ph_vec3_along(ruling->at.c, h, ruling->at.e);
}

/* ph_ruling_flat: the same in the development. */
static inline void ph_ruling_flat(const struct ph_ruling *ruling, double h,
                                  double flat[2]) {
  flat[0] = ruling->flat.c[0] - h * sin(ruling->flat.angle);
  flat[1] = ruling->flat.c[1] + h * cos(ruling->flat.angle);
}

#endif
