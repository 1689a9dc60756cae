/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Fairness of planar PH and ATPH splines [GON18, sec. 2.5].
 *
 *   bending  E   = integral of kappa^2 ds
 *   varying  MV  = integral of (dkappa/ds)^2 ds
 *   IES = E L,  IMV = MV L^3      the same for every scale
 *   rotation, absolute_rotation   turns of the tangent, R and R_abs
 */
#ifndef PH_CURVE_ENERGY_H
#define PH_CURVE_ENERGY_H

#include "curve/result.h"

#include <stdbool.h>

struct ph_energy {
  double bending;
  double varying;
  double rotation;
  double absolute_rotation;
};

/*
 * ph_energy_planar: the energies of a curve, in its unit, to 1e-12 relative.
 *
 * Adaptive Gauss quadrature; the rotations are in closed form.  O(n), with
 * more nodes where a segment bends more.
 *
 * ret  false when memory is exhausted; an energy is not finite where the
 *      curve stands still
 */
bool ph_energy_planar(const struct ph_curve *curve, struct ph_energy *energy);

#endif
