/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Curves whose curvature is continuous but where they say that it is not. */
#ifndef PH_CURVE_G2_H
#define PH_CURVE_G2_H

#include <stddef.h>

/*
 * Why the curvature jumps at a joint: X(SYMBOL, "name in records").  TANGENT: a
 * point of the data that has the tangent of the mode spline; PAIR: the joint of
 * a pair of that mode.
 */
#define PH_JOINTS(X)          \
  X(INFLECTION, "inflection") \
  X(STRAIGHT, "straight")     \
  X(TANGENT, "tangent")       \
  X(PAIR, "pair")

enum ph_joint_kind {
#define X(symbol, name) PH_JOINT_##symbol,
  PH_JOINTS(X)
#undef X
      PH_JOINT_N
};

/* A joint where it jumps, from one side to the other, signed. */
struct ph_joint {
  size_t segment; /* that begins there */
  double point[2];
  double curvature[2];
  enum ph_joint_kind kind;
};

/*
 * Of curves whose curvature is continuous but where it says (solve/tc/g2.h).
 *
 * joints     in the order of segments
 * auxiliary  segments that begin at points which were added, increasing
 */
struct ph_g2 {
  struct ph_joint *joints;
  size_t joints_n;
  size_t *auxiliary;
  size_t auxiliary_n;
};

#endif
