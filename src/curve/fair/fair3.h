/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Fairness of spatial PH and ATPH segments [GON18, sec. 3.6].
 *
 *   bending  = integral of kappa^2 ds
 *   varying  = integral of (dkappa/ds)^2 ds
 *   twisting = integral of (dtau/ds)^2 ds
 *   F1 = L bending,  F2 = L^3 varying,  F3 = F2 + L^3 twisting
 *
 * with L the length; F1, F2, F3 are the same for every scale.
 *
 * kappa is not negative, and its slope jumps at an inflection, which does no
 * harm to `varying`: for a plane curve it is that of the signed curvature.  The
 * torsion of a plane curve is 0, and so is that of a straight line.  That of a
 * space curve with an inflection is finite on either side of it, and these
 * sides count; curves near to it have a peak there, the higher the nearer they
 * are.
 */
#ifndef PH_CURVE_FAIR_FAIR3_H
#define PH_CURVE_FAIR_FAIR3_H

#include "kernel/atph.h"
#include "kernel/quad.h"
#include "kernel/quat.h"

#include <stdbool.h>

/* The rule of all intervals, of 16 nodes. */
struct ph_fair3_rules {
  struct ph_quad rule;
};

struct ph_fair3 {
  double bending, varying, twisting;
  bool inflected; /* twists, and has an inflection: an isolated case */
};

/* ph_fair3_begin: false when memory is exhausted. */
bool ph_fair3_begin(struct ph_fair3_rules *rules);

/*
 * ph_fair3_of: the three integrals of a segment, in the unit of its points, to
 * 1e-9 relative; `twisting` next to an inflection to 1e-8.
 *
 * Adaptive Gauss quadrature: more nodes where the curve is more uneven, within
 * bounds.  No trigonometric function is called.  Measured by t_fair3_poles.c
 * for end derivatives of 1e-6 to 10 of the chord, and curves that nearly stop:
 * the error is that of the quadrature, as long as rounding of the preimage does
 * not change the integrals themselves by as much.
 *
 * in   a[3]  preimage, near unit scale
 * ret  infinite where there is no such value: the curve stands still, or as
 *      good as that
 */
struct ph_fair3 ph_fair3_of(const struct ph_fair3_rules *rules,
                            const struct ph_atph *space, const ph_quat a[3]);

/* ph_fair3_functional: F1, F2 or F3 for k = 1, 2, 3. */
double ph_fair3_functional(const struct ph_fair3 *fair, double length, int k);

#endif
