/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Cusps of offsets: where 1 - d kappa changes sign. */
#ifndef PH_CURVE_CUSP_H
#define PH_CURVE_CUSP_H

#include "curve/result.h"

/* What ph_cusps_planar finds. */
struct ph_cusps {
  size_t n;       /* how many */
  size_t segment; /* of the first one */
  double u;       /* its local parameter in [0,1] */
};

/*
 * ph_cusps_planar: the cusps of the offset of a planar PH or ATPH curve.
 *
 * None is missed: 1 - d kappa is a form of degree 8 in S0 and S1 over a
 * positive one, whose roots are isolated by the signs of its coefficients.
 *
 * in   distance  signed, positive to the left of travel
 */
struct ph_cusps ph_cusps_planar(const struct ph_curve *curve, double distance);

#endif
