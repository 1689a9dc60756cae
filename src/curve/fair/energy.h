/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Fairness of planar PH and ATPH splines and of Tschirnhausen cubics [GON18,
 * sec. 2.5].
 *
 *   bending  E   = integral of kappa^2 ds
 *   varying  MV  = integral of (dkappa/ds)^2 ds
 *   IES = E L,  IMV = MV L^3      the same for every scale
 *   rotation, absolute_rotation   turns of the tangent, R and R_abs
 */
#ifndef PH_CURVE_FAIR_ENERGY_H
#define PH_CURVE_FAIR_ENERGY_H

#include "base/sum.h"
#include "curve/fair/pieces.h"
#include "curve/result.h"
#include "curve/segment/seg2.h"

#include <stdbool.h>

/* The energies of segments that are added one after another. */
struct ph_energy_sum {
  struct ph_quad rule[PH_PIECE_RULES];
  struct ph_sum bending, varying;
  size_t halved; /* intervals of the last segment */
};

struct ph_energy {
  double bending;
  double varying;
  double ies;
  double imv;
  double rotation;
  double absolute_rotation;
};

/* ph_energy_begin: no segments yet; false when memory is exhausted. */
bool ph_energy_begin(struct ph_energy_sum *sum);

/* ph_energy_clear: no segments again. */
void ph_energy_clear(struct ph_energy_sum *sum);

/* ph_energy_add: one more segment, in its unit, to 1e-12 relative; false, and
 * NaN, if it stands still (seg2.h). */
bool ph_energy_add(struct ph_energy_sum *sum, const struct ph_seg2 *seg);

/*
 * Parts of PH_ENERGY_PART segments each, of which several can be added at the
 * same time: what is joined in order does not depend on who has added it.
 */
enum { PH_ENERGY_PART = 1024 };

struct ph_energy_part {
  struct ph_energy_sum sum;
  struct ph_sum rotation, absolute;
  int exponent; /* of 2, of what the preimage is multiplied by */
  bool still;   /* the curve stands still there */
};

/* ph_energy_part_begin: an empty part of a curve; a copy is another one.  False
 * when memory is exhausted. */
bool ph_energy_part_begin(struct ph_energy_part *part,
                          const struct ph_curve *curve);

/* ph_energy_part_add: the segments of a part from `first' on; a multiple. */
void ph_energy_part_add(struct ph_energy_part *part,
                        const struct ph_curve *curve, size_t first);

/* ph_energy_part_join: the next part, too. */
void ph_energy_part_join(struct ph_energy_part *part,
                         const struct ph_energy_part *next);

/* ph_energy_of: the energies of all parts; as ph_energy_planar. */
struct ph_energy ph_energy_of(const struct ph_energy_part *part,
                              const struct ph_curve *curve);

/*
 * ph_energy_planar: the energies of a curve, in its unit, to 1e-12 relative.
 *
 * Adaptive Gauss quadrature at unit scale; the rotations are in closed form.
 * O(n), with more nodes where a segment bends more.
 *
 * ret  false when memory is exhausted; all are NaN where the curve stands still
 *      (seg2.h), and E and MV not finite where they leave the range of a
 * double: either end of it, as less than DBL_MIN is not known to 1e-12
 */
bool ph_energy_planar(const struct ph_curve *curve, struct ph_energy *energy);

#endif
