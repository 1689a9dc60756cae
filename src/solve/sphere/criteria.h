/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The shape that data on the sphere suggest, and whether a spline has it
 * [IOR15, sec. 3.3, with the corrections stated in sphere_criteria.c].
 *
 * At node i the data turn by the angle tau_i; its sign is the indicator Q_i, 0
 * where three nodes are on a great circle.
 *   co-circularity  Q_i = 0, and the data go on in their direction:
 *                   |kappa_g| < epsilon on both sides of the node
 *   nodal           Q_i != 0: kappa_g Q_i >= 0 on both sides
 *   segment         Q_i Q_{i+1} > 0: kappa_g Q_i > 0 on the whole segment
 */
#ifndef PH_SOLVE_SPHERE_CRITERIA_H
#define PH_SOLVE_SPHERE_CRITERIA_H

#include "solve/sphere/spline.h"

enum ph_sphere_criterion {
  PH_SPHERE_FINE, /* none is violated */
  PH_SPHERE_COCIRCULARITY,
  PH_SPHERE_NODAL,
  PH_SPHERE_SEGMENT
};

/* What the shape of the data asks for. */
struct ph_sphere_shape {
  const struct ph_sphere_data *data;
  double epsilon; /* bound of |kappa_g| at co-circular nodes */
  bool legacy;    /* the measures of the thesis's code: one side of a node, and
                   * theta(P_0,P_1)^2 |K| in place of |kappa_g|, K by the knots */
  signed char *q; /* [n] indicators; 0 at the ends of open data */
  bool *inorder;  /* [n] Q_i = 0, and co-circularity is asked */
  size_t *before; /* [n] of nodes in order: the last node before their run of */
  size_t *after;  /* [n] such nodes, and the first one after it; SIZE_MAX: the
                   * run is all of closed data */
};

/*
 * ph_sphere_shape_of: the indicators of data.
 *
 * out  shape  arrays in the arena
 * ret  false when memory is exhausted
 */
bool ph_sphere_shape_of(const struct ph_sphere_data *data, double epsilon,
                        bool legacy, struct ph_arena *arena,
                        struct ph_sphere_shape *shape);

/* ph_sphere_node_fails: the criterion of node i that a spline violates, or
 * FINE.  Reads r and l of the two segments at the node. */
enum ph_sphere_criterion
ph_sphere_node_fails(const struct ph_sphere_shape *shape,
                     const struct ph_sphere_spline *s, size_t i);

/* ph_sphere_segment_fails: SEGMENT where the criterion is asked of segment k,
 * and the sign of K cannot be certified on all of it; else FINE. */
enum ph_sphere_criterion
ph_sphere_segment_fails(const struct ph_sphere_shape *shape,
                        const struct ph_sphere_spline *s, size_t k);

/*
 * ph_sphere_touched: the nodes whose tension is raised for a violated
 * criterion.  Only in legacy the ends of open data are among them, whose
 * tension has no effect, and nodes in order, whose curvature grows with it: in
 * their place stands the node beyond their run.
 *
 * in   at       the node, or the segment
 * out  node[4]  at most 4 of them, in the order of the curve
 * ret  how many
 */
size_t ph_sphere_touched(const struct ph_sphere_shape *shape,
                         enum ph_sphere_criterion criterion, size_t at,
                         size_t node[4]);

/* ph_sphere_criterion_name: "co-circularity", "nodal convexity", "segment
 * convexity". */
const char *ph_sphere_criterion_name(enum ph_sphere_criterion criterion);

#endif
