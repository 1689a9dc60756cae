/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The shape of a spatial Hermite segment: whether it bends and twists as its
 * data do, and the tension at which it does [FAR15, sec. 2 and 4].
 *
 * With g1, ..., g5 the legs of the control polygon, Ni = ti x dp, Nf = dp x tf
 * and tau = [ti, dp, tf], the constraints are
 *
 *   [g1, g2, Ni] > 0 and [g4, g5, Nf] > 0     [FAR15, (21)]              (1)
 *   torsion(u) tau > 0 for all u in [0,1]                                 (2)
 *
 * (1) says how the curve leaves its ends.  (2) is exact, where [FAR15, (22)]
 * is sufficient: the torsion has the sign of
 *
 *   N = sigma Im(conj(z) z') + 2 x |z|^2                                  (3)
 *
 * of curve/seg3.h, a form of degree 6 in S0 and S1 (kernel/form.h), which is
 * written out in spatial_shape.c.
 *
 * A constraint is void where the data give no sign: (1) at an end whose tangent
 * is parallel to dp, (2) where they are planar.  In the place of (2), the curve
 * has to be in their plane then, with normal n, unless they are straight:
 *
 *   g2.n = g4.n = 0                                                     (4)
 */
#ifndef PH_SOLVE_SPATIAL_SHAPE_H
#define PH_SOLVE_SPATIAL_SHAPE_H

#include "base/status.h"
#include "solve/spatial/family.h"

#include <stdbool.h>
#include <stddef.h>

/* Constraints, as the bits of a set. */
enum {
  PH_SHAPE_START = 1,   /* convexity (1) at the start */
  PH_SHAPE_END = 2,     /* convexity (1) at the end */
  PH_SHAPE_TORSION = 4, /* (2) */
  PH_SHAPE_PLANE = 8,   /* (4) */
  PH_SHAPE_NOTHING = 16 /* the choice has no segment at a reduced tension */
};

/* ph_spatial_constraints: those that are not void for the data. */
unsigned ph_spatial_constraints(const struct ph_spatial_family *family);

/*
 * ph_spatial_violations: those of ph_spatial_constraints that a member of the
 * family breaks.
 *
 * in   a[3]  its preimage (ph_spatial_preimage)
 */
unsigned ph_spatial_violations(const struct ph_spatial_family *family,
                               const ph_quat a[3]);

/* ph_spatial_torsion_form: sinc^3 / 4 times (3), sinc > 0 that of the space.
 * out form[7]  in S0 and S1 */
void ph_spatial_torsion_form(const struct ph_atph *space, const ph_quat a[3],
                             double form[7]);

/* ph_spatial_is_forward: (ti + tf).dp > 0 [FAR15, (52)].  With
 * ph_spatial_is_acute, CC keeps the shape if the tension is small enough. */
static inline bool ph_spatial_is_forward(const struct ph_spatial_data *data) {
  return ph_vec3_dot(ph_vec3_add(data->ti, data->tf), data->dp) > 0;
}

/* ph_spatial_is_acute: ti.tf > 0 [FAR15, (59)]. */
static inline bool ph_spatial_is_acute(const struct ph_spatial_data *data) {
  return ph_vec3_dot(data->ti, data->tf) > 0;
}

/*
 * How a member of a family is chosen: a criterion, or given angles.
 *
 * io   family   of the data at some tension; a criterion that chooses the space
 *               too changes it (ph_spatial_family_space)
 * in   context  what else it needs, such as where to start
 * ret  another status than PH_OK ends the search for a tension, but
 *      PH_INFEASIBLE only where it is not reduced: there is no segment then
 */
typedef enum ph_status ph_spatial_choice(struct ph_spatial_family *family,
                                         void *context,
                                         struct ph_spatial_member *member);

/* A segment that was chosen. */
struct ph_spatial_fit {
  struct ph_spatial_family family;
  struct ph_spatial_member member;
  ph_quat a[3];      /* preimage in the frame of the data */
  unsigned violated; /* constraints */
};

/* ph_spatial_fit_of: the segment chosen for some data, and its violations. */
enum ph_status ph_spatial_fit_of(const struct ph_spatial_data *data,
                                 const struct ph_atph *space,
                                 ph_spatial_choice *choose, void *context,
                                 struct ph_spatial_fit *fit);

/* What ph_spatial_tension finds. */
struct ph_spatial_tension {
  struct ph_spatial_fit fit;
  double factor;    /* on the tension: |Di| and |Df| are its square times those
                       of the data; 1 unless the tension was reduced */
  unsigned without; /* constraints violated for the factor 1 */
  size_t tried;     /* segments chosen */
};

/*
 * ph_spatial_tension: the segment at the largest tension, not above that of the
 * data, at which it violates nothing.
 *
 * Powers of 0.95 are tried as factors down to 1/64, then the last interval is
 * narrowed to the tolerance, and the factor is reduced by as much: what holds
 * need not hold for all factors below, so that this is the definition of the
 * result.
 *
 * in   data       ni and nf at the initial tension
 * in   space      where the choice starts
 * in   tolerance  of factors: how well the choice lets them be told
 * ret  PH_OK, also where no factor is found: then fit is that of the factor 1,
 *      and fit.violated == without > 0; or the status of a choice that failed
 */
enum ph_status ph_spatial_tension(const struct ph_spatial_data *data,
                                  const struct ph_atph *space,
                                  ph_spatial_choice *choose, void *context,
                                  double tolerance,
                                  struct ph_spatial_tension *tension);

#endif
