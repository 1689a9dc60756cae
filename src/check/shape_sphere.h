/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Whether a spherical spline has the shape of its data: the turns of the data,
 * and the criteria of shape at nodes and on segments [IOR15, sec. 3.3], with
 * what rounding of the control points can do allowed for.
 */
#ifndef PH_CHECK_SHAPE_SPHERE_H
#define PH_CHECK_SHAPE_SPHERE_H

#include "base/sum.h"
#include "check/sphere_segment.h"
#include "curve/result.h"

#include <stdbool.h>

enum ph_check_nu_fault {
  PH_CHECK_NU_NO_FAULT,
  PH_CHECK_NU_COCIRCULARITY, /* it bends at a node where the data do not */
  PH_CHECK_NU_NODAL,         /* it bends to the other side at a node */
  PH_CHECK_NU_CONVEXITY      /* or somewhere on a segment */
};

/* What is asked for. */
struct ph_check_nu_rule {
  double epsilon; /* bound of |kappa_g| on the unit sphere */
  bool legacy;    /* of theta(P_0,P_1)^2 |K| after the node, K by the knots */
  double first;   /* theta(P_0,P_1) */
};

/* A node and what is on both sides of it. */
struct ph_check_nu_node {
  const struct ph_check_nu_segment *left, *right;
  double spacing;      /* of the knots on the right */
  double sine, cosine; /* of the angle by which the data turn */
  double limit;        /* |sine| below which they do not, and */
  double limit_unsure; /* by how much rounding may move this limit */
  bool told;           /* by the data, not by rounding, whether they turn */
  int indicator;       /* as recorded */
};

/* ph_check_nu_node_turn: sets sine, cosine and limits from left and right. */
void ph_check_nu_node_turn(struct ph_check_nu_node *node, double epsilon);

/* ph_check_nu_node_indicates: whether the indicator is the sign of the turn. */
bool ph_check_nu_node_indicates(const struct ph_check_nu_node *node);

/* ph_check_nu_node_fault: what the curve violates at a node. */
enum ph_check_nu_fault
ph_check_nu_node_fault(const struct ph_check_nu_node *node,
                       const struct ph_check_nu_rule *rule);

/* ph_check_nu_segment_fault: and on a segment between nodes with these
 * indicators. */
enum ph_check_nu_fault
ph_check_nu_segment_fault(const struct ph_check_nu_segment *s, int from,
                          int to);

/* ph_check_nu_is_waived: whether the criteria of node i, and of the segment
 * that begins there, were gone on without. */
bool ph_check_nu_is_waived(const struct ph_sphere *sphere, size_t i);

/* ph_check_nu_waived_fit: whether the nodes of a list are increasing, and below
 * n. */
bool ph_check_nu_waived_fit(const struct ph_sphere *sphere, size_t n);

/* Tensions, as they are and relative: times the harmonic mean of the spacings
 * beside the node, of the knots that are printed (of a short segment these are
 * nearer to those that it was found for than the angle of rounded points). */
struct ph_check_nu_tensions {
  struct ph_sum sum, relative;
  double largest; /* relative */
};

/* ph_check_nu_add_tension: that of node i; ret  the relative one. */
double ph_check_nu_add_tension(struct ph_check_nu_tensions *tensions,
                               const struct ph_curve *curve, size_t i);

/* ph_check_nu_fault_name: what is not kept, for messages. */
const char *ph_check_nu_fault_name(enum ph_check_nu_fault fault);

#endif
