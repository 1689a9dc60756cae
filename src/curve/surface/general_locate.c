/* SPDX-License-Identifier: GPL-3.0-or-later */
/* From the development to general strips (see general.h). */
#include "curve/surface/general.h"
#include "kernel/pi.h"

#include <float.h>

/* u where the rulings have turned by phi, which is within the whole. */
static double parameter_of(const struct ph_directrix *d, double phi) {
  enum { STEPS = 60 };
  size_t part = 0, behind = d->n;
  double low, high, u;
  while (behind - part > 1) {
    const size_t middle = (part + behind) / 2;
    *(d->phi[middle] <= phi ? &part : &behind) = middle;
  }
  low = d->u[part];
  high = d->u[part + 1];
  u = low +
      (high - low) * ((phi - d->phi[part]) / (d->phi[part + 1] - d->phi[part]));
  for (int i = 0; i < STEPS && high > low; i++) {
    double off, next;
    u = u >= low && u <= high ? u : low + (high - low) / 2;
    off = ph_general_phi(d, u) - phi;
    next = u - off / ph_general_at(d, u).rate;
    *(off > 0 ? &high : &low) = u;
    if (fabs(next - u) <= 2 * DBL_EPSILON) {
      break;
    }
    u = next;
  }
  return u;
}

/* What is looked for: a place at R from the vertex of the development, in the
 * direction of a ruling or, if R is negative, opposite to it. */
struct sought {
  const struct ph_strip *strip;
  double height[2], near;
  double R, angle; /* of the direction, against that of the first ruling */
};

/* Whether there is one where the rulings have turned by the angle and so many
 * turns. */
static bool is_there(const struct sought *at, double turns, double *u,
                     double *h) {
  const struct ph_directrix *d = at->strip->directrix;
  const double whole = d->phi[d->n];
  const double phi = at->angle + 2 * PH_PI * turns;
  const double within = fmin(fmax(phi, 0), whole);
  if (!(fabs(at->R * (phi - within)) <= at->near)) {
    return false;
  }
  *u = parameter_of(d, within);
  *h = at->R - d->side * ph_pow2_apply(d->fast.grow, ph_general_at(d, *u).rho);
  return *h >= at->height[0] - at->near && *h <= at->height[1] + at->near;
}

bool ph_general_locate(const struct ph_strip *strip, const double height[2],
                       const double flat[2], double near, double *u,
                       double *h) {
  const struct ph_directrix *d = strip->directrix;
  const struct ph_flat_place start = ph_flat_start(strip);
  const double first =
      d->side * ph_pow2_apply(d->fast.grow, ph_general_at(d, 0).rho);
  const double x = flat[0] - start.c[0] - first * sin(start.angle);
  const double y = flat[1] - start.c[1] + first * cos(start.angle);
  for (int i = 0; i < 2; i++) {
    const double sign = i ? -d->side : d->side;
    const double angle = d->side * (start.angle - atan2(-sign * x, sign * y));
    const struct sought at = {strip,
                              {height[0], height[1]},
                              near,
                              sign * hypot(x, y),
                              angle - 2 * PH_PI * floor(angle / (2 * PH_PI))};
    /* just before the first ruling is nearly a whole turn behind it */
    for (double turns = -1; turns <= d->phi[d->n] / (2 * PH_PI); turns++) {
      if (is_there(&at, turns, u, h)) {
        return true;
      }
    }
  }
  return false;
}
