/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Cusps of offsets: where they turn back along the curve. */
#ifndef PH_CURVE_OFFSET_CUSP_H
#define PH_CURVE_OFFSET_CUSP_H

#include "base/diag.h"
#include "base/mem.h"
#include "curve/result.h"
#include "curve/segment/seg3.h"

/* The degree of the speed of offsets, as a form. */
enum { PH_CUSP_DEGREE = 8 };

/* Bernstein coefficients in v (kernel/form.h) of forms whose quotient is what
 * turns: in the plane, bend over square is the curvature times 2^exponent. */
struct ph_cusp_forms {
  double square[PH_CUSP_DEGREE + 1]; /* sigma^2 > 0, but for a stop */
  double bend[PH_CUSP_DEGREE + 1];
  int exponent;
};

/* ph_cusp_forms_of: these of a segment, along a normal. */
void ph_cusp_forms_of(const struct ph_seg3 *seg, enum ph_normal normal,
                      struct ph_cusp_forms *forms);

/*
 * ph_cusps_of: the cusps of the offset of a PH or ATPH curve, or of cubics.
 *
 * None is missed: the speed of the offset along the curve's tangent, which is
 * 1 - d kappa times that of the curve in the plane, is a form of degree 8 in S0
 * and S1 over a positive one, whose roots are isolated by the signs of its
 * coefficients.  In space the offset may move sideways there, and is no cusp in
 * the strict sense.
 *
 * in   distance  signed, along the normal
 * in   normal    of a planar curve E2, which is to the left of travel
 * out  cusps     from the arena; one at the joint of a closed curve is the last
 * ret  PH_OK | PH_E_NO_MEMORY
 */
enum ph_status ph_cusps_of(const struct ph_curve *curve, double distance,
                           enum ph_normal normal, struct ph_arena *arena,
                           struct ph_cusps *cusps, struct ph_diag *diag);

#endif
