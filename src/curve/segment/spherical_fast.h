/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Many places of one spherical Bezier segment: S, S' and S'', as those of
 * ph_spherical_jet, in a fraction of the time.
 */
#ifndef PH_CURVE_SEGMENT_SPHERICAL_FAST_H
#define PH_CURVE_SEGMENT_SPHERICAL_FAST_H

#include "curve/segment/spherical.h"

/* Coefficients of the weights of an arc, at most. */
enum { PH_SPHERICAL_FAST_TERMS = 16 };

/* Two neighbouring control points: (6) and (7) of spherical_fast.c. */
struct ph_spherical_fast_arc {
  double a[PH_SPHERICAL_FAST_TERMS], b[PH_SPHERICAL_FAST_TERMS];
  ph_vec3 dm, dd; /* what B and A are multiplied by in derivatives */
  double square;  /* of the angle */
};

/* A segment, prepared. */
struct ph_spherical_fast {
  struct ph_spherical segment;
  ph_vec3 at[2][4]; /* control points seen from the first, from the last one */
  struct ph_spherical_fast_arc arc[3];
  size_t arc_terms; /* of a and b that are needed */
  size_t terms;     /* of power series in E */
};

void ph_spherical_fast_of(const struct ph_spherical *segment,
                          struct ph_spherical_fast *fast);

/* ph_spherical_fast_jet: S, S', S'' at t; out  jet[3] */
void ph_spherical_fast_jet(const struct ph_spherical_fast *fast, double t,
                           ph_vec3 jet[3]);

/* ph_spherical_fast_jets: the same, to the last bit, at several places at once;
 * least work where they are near each other.  in  t[PH_SPHERICAL_FAST_LANES] */
enum { PH_SPHERICAL_FAST_LANES = 2 };
void ph_spherical_fast_jets(const struct ph_spherical_fast *fast,
                            const double t[], ph_vec3 jet[][3]);

#endif
