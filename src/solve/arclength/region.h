/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Steps within a trusted radius: the minimum of g . s + s . A s / 2 for
 * |s| <= radius, with a symmetric band matrix A that need not be positive
 * definite.  It solves (A + shift) s = -g with the least shift >= 0 that makes
 * A + shift positive definite and s short enough [MOR83, sec. 3].
 *
 * Where A is not positive definite the step goes along its lowest direction up
 * to the radius, even if g vanishes: nothing is lost near a saddle.
 */
#ifndef PH_SOLVE_ARCLENGTH_REGION_H
#define PH_SOLVE_ARCLENGTH_REGION_H

#include "base/mem.h"

#include <stdbool.h>
#include <stddef.h>

struct ph_arc_region {
  size_t n, band;
  double *matrix; /* A, as in kernel/band.h: set by the caller */
  double *factor; /* of A + shift, after a step */
  double *g;      /* [n] set by the caller */
  double *step;   /* [n] s */
  double *other;  /* [n] */
  double shift;   /* of the last step */
  double hint;    /* the last that was not 0 */
  double length;  /* |s| */
  double fall;    /* by how much the model falls along s */
  size_t factors; /* tried so far */
};

/* ph_arc_region_alloc: false when memory is exhausted. */
bool ph_arc_region_alloc(size_t n, size_t band, struct ph_arena *arena,
                         struct ph_arc_region *region);

/*
 * ph_arc_region_step: the step.  Its length is within 0.5 to 1.6 of the radius,
 * or less if A is positive definite.
 *
 * in   above  a shift known to be too small, or 0
 * ret  false when none was found, as of a matrix that is not finite
 */
bool ph_arc_region_step(struct ph_arc_region *region, double radius,
                        double above);

/* ph_arc_region_solve: v = -(A + shift)^-1 v, after a step. */
void ph_arc_region_solve(const struct ph_arc_region *region, double *v);

#endif
