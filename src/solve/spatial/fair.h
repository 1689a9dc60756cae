/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * F1, F2 and F3 of members of a family by a fixed quadrature, with gradients:
 * what a minimisation evaluates over and over.  curve/fair3.h has the
 * functions, and the values that count.
 */
#ifndef PH_SOLVE_SPATIAL_FAIR_H
#define PH_SOLVE_SPATIAL_FAIR_H

#include "kernel/quad.h"
#include "solve/spatial/family.h"

enum { PH_SPATIAL_FAIR_NODES = 16 };

/* The variables of a gradient. */
enum { PH_SPATIAL_B, PH_SPATIAL_PHI, PH_SPATIAL_ALPHA, PH_SPATIAL_VARIABLES };

struct ph_spatial_point {
  double b, phi; /* angles of the member */
  double alpha;  /* angle of the space */
};

/* What is minimised. */
struct ph_spatial_target {
  const struct ph_quad *rule;             /* of PH_SPATIAL_FAIR_NODES nodes */
  const struct ph_spatial_family *family; /* where it is scaled: at alpha = 1 */
  bool scaled;    /* |Di|, |Df| are proportional to alpha */
  int functional; /* 1, 2, 3: which F */
};

/* ph_spatial_fair_family: the family at alpha. */
struct ph_spatial_family
ph_spatial_fair_family(const struct ph_spatial_target *target, double alpha);

/*
 * ph_spatial_fair: the functional at a point.
 *
 * in   panels    parts of [0,1] with a rule each
 * out  gradient  [PH_SPATIAL_VARIABLES], NULL: not wanted; for alpha = 0 the
 *                last is not finite
 * ret  not finite where there is none
 */
double ph_spatial_fair(const struct ph_spatial_target *target, size_t panels,
                       const struct ph_spatial_point *at, double *gradient);

#endif
