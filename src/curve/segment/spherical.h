/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A cubic spherical Bezier segment: de Casteljau's algorithm with great-circle
 * interpolation in place of straight lines [IOR15, sec. 2.4], on the unit
 * sphere, t in [0,1].  Derivatives are exact, by jets: products and quotients
 * of (value, ', '', '''), no differences.
 *
 * K = S . (S' x S'') is the numerator of the geodesic curvature
 *   kappa_g = K / |S'|^3,   K' = S . (S' x S'''),
 * positive where the curve turns to the left seen from outside.
 */
#ifndef PH_CURVE_SEGMENT_SPHERICAL_H
#define PH_CURVE_SEGMENT_SPHERICAL_H

#include "curve/result.h"
#include "kernel/primitive.h"
#include "kernel/vec3.h"

/* Control points, unit vectors; no two neighbours antipodal. */
struct ph_spherical {
  ph_vec3 p[4];
};

/* A segment with the differences of its control points, for when more is known
 * of them than their rounding leaves. */
struct ph_spherical_legs {
  struct ph_spherical s;
  ph_vec3 leg[3];
};

/* ph_spherical_legs_of: the differences as they are. */
static inline struct ph_spherical_legs
ph_spherical_legs_of(const struct ph_spherical *s) {
  struct ph_spherical_legs legs = {.s = *s};
  for (int i = 0; i < 3; i++) {
    legs.leg[i] = ph_vec3_sub(s->p[i + 1], s->p[i]);
  }
  return legs;
}

/* ph_spherical_of: segment k of a PH_CURVE_SPHERICAL_NU curve, brought to the
 * unit sphere. */
struct ph_spherical ph_spherical_of(const struct ph_curve *curve, size_t k);

/* ph_spherical_jet: S, of unit length to rounding, S', S'', S''' at t.
 * out  jet[4] */
void ph_spherical_jet(const struct ph_spherical *s, double t, ph_vec3 jet[4]);

/* ph_spherical_numerator: K and K' at t, for control points taken as exact to a
 * few roundings of |S'| (|S'| + |S''|) and |S'| (|S'| + |S'''|); out  k[2] */
void ph_spherical_numerator(const struct ph_spherical *s, double t,
                            double k[2]);

/* ph_spherical_numerator_start: K at t = 0, in closed form: with the angles th
 * from p0 to p1 and om from p1 to p2, and f_0 of s2.h,
 *   K = 18 [p0, p1, p2] / (f_0(th^2)^2 f_0(om^2));
 * 0 where p1 = p0.  By legs also at t = 1. */
double ph_spherical_numerator_start(const struct ph_spherical *s);

double ph_spherical_legs_numerator_start(const struct ph_spherical_legs *s);
double ph_spherical_legs_numerator_end(const struct ph_spherical_legs *s);

/* kappa_g at t = 0 and t = 1 in closed form, K / (27 th^3); not
 * finite where p1 = p0 or p2 = p3. */
double ph_spherical_curvature_start(const struct ph_spherical *s);
double ph_spherical_curvature_end(const struct ph_spherical *s);
double ph_spherical_legs_curvature_start(const struct ph_spherical_legs *s);
double ph_spherical_legs_curvature_end(const struct ph_spherical_legs *s);

/*
 * ph_spherical_length: the arc length, to 1e-13 relative, also where control
 * points nearly coincide.  A segment that hardly bends, with little change of
 * speed, takes 5 values of S'.
 *
 * io   table  workspace, zeroed at first; its memory is used again
 * ret  PH_OK | PH_E_NO_MEMORY | PH_E_NO_CONVERGENCE (as of what is not finite)
 */
enum ph_status ph_spherical_length(const struct ph_spherical *s,
                                   struct ph_primitive *table,
                                   struct ph_arena *arena, double *length);

/*
 * ph_spherical_corners: the places within, about, that 16 values of the speed
 * may step over: where a curve runs back for a short way, its speed has two
 * corners near each other.  None of most segments.
 *
 * out  at[PH_SPHERICAL_CORNERS]  the first of it, increasing
 * ret  how many
 */
enum { PH_SPHERICAL_CORNERS = 3 };
size_t ph_spherical_corners(const struct ph_spherical *s,
                            double at[PH_SPHERICAL_CORNERS]);

#endif
