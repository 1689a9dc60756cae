/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Bounds of pieces of plane curves: boxes for where a piece is, cones for where
 * it goes.
 *
 * A cone is the set of directions of travel along a piece, from the direction
 * `low` counterclockwise to `high`; lengths do not matter.  One that is below a
 * half turn is narrow.  All of a piece with a narrow cone moves forward along
 * some axis: it cannot meet itself.
 */
#ifndef PH_CURVE_CROSS_BOUND2_H
#define PH_CURVE_CROSS_BOUND2_H

#include "kernel/cplx.h"

#include <stdbool.h>
#include <stddef.h>

struct ph_box2 {
  double low[2], high[2];
};

/* ph_box2_of: the box of n >= 1 points. */
static inline struct ph_box2 ph_box2_of(const ph_cplx *p, size_t n) {
  struct ph_box2 box = {{p[0].re, p[0].im}, {p[0].re, p[0].im}};
  for (size_t i = 1; i < n; i++) {
    box.low[0] = p[i].re < box.low[0] ? p[i].re : box.low[0];
    box.low[1] = p[i].im < box.low[1] ? p[i].im : box.low[1];
    box.high[0] = p[i].re > box.high[0] ? p[i].re : box.high[0];
    box.high[1] = p[i].im > box.high[1] ? p[i].im : box.high[1];
  }
  return box;
}

/* ph_box2_join: the box of two. */
static inline struct ph_box2 ph_box2_join(const struct ph_box2 *a,
                                          const struct ph_box2 *b) {
  struct ph_box2 box = *a;
  for (size_t i = 0; i < 2; i++) {
    box.low[i] = b->low[i] < a->low[i] ? b->low[i] : a->low[i];
    box.high[i] = b->high[i] > a->high[i] ? b->high[i] : a->high[i];
  }
  return box;
}

/* ph_box2_apart: whether two boxes are further than `distance` apart along an
 * axis. */
static inline bool ph_box2_apart(const struct ph_box2 *a,
                                 const struct ph_box2 *b, double distance) {
  return a->low[0] - b->high[0] > distance ||
         b->low[0] - a->high[0] > distance ||
         a->low[1] - b->high[1] > distance || b->low[1] - a->high[1] > distance;
}

/* ph_box2_size: the longer side. */
static inline double ph_box2_size(const struct ph_box2 *box) {
  double x = box->high[0] - box->low[0], y = box->high[1] - box->low[1];
  return x > y ? x : y;
}

enum ph_cone_kind {
  PH_CONE_EMPTY, /* of no piece at all */
  PH_CONE_NARROW,
  PH_CONE_WIDE /* or unknown */
};

struct ph_cone {
  ph_cplx low, high;
  enum ph_cone_kind kind;
};

static const struct ph_cone PH_CONE_NONE = {{0, 0}, {0, 0}, PH_CONE_EMPTY};
static const struct ph_cone PH_CONE_ALL = {{0, 0}, {0, 0}, PH_CONE_WIDE};

/*
 * ph_cone_of: the cone between two directions.
 *
 * Rounding may swap directions that are equal: that much of a negative angle
 * is none.  An angle is narrow only if it stays clear of the half turn by much
 * more than rounding, so that the sum of two narrow ones cannot pass for none.
 */
static inline struct ph_cone ph_cone_of(ph_cplx low, ph_cplx high) {
  const double none = 1e-12, clear = 1e-9;
  double dot = ph_cplx_dot(low, high), cross = ph_cplx_cross(low, high);
  bool narrow = dot > 0 ? cross >= -none * dot : cross > -clear * dot;
  struct ph_cone cone = {low, high, narrow ? PH_CONE_NARROW : PH_CONE_WIDE};
  return cone;
}

/* ph_cone_turn: the cone of a turn on the spot, the shorter way. */
static inline struct ph_cone ph_cone_turn(ph_cplx from, ph_cplx to) {
  return ph_cplx_cross(from, to) >= 0 ? ph_cone_of(from, to)
                                      : ph_cone_of(to, from);
}

/* ph_cone_join: the cone of two pieces together; where the one ends the other
 * begins, so that they have a direction in common. */
static inline struct ph_cone ph_cone_join(const struct ph_cone *a,
                                          const struct ph_cone *b) {
  if (a->kind == PH_CONE_EMPTY || b->kind == PH_CONE_WIDE) {
    return *b;
  }
  if (b->kind == PH_CONE_EMPTY || a->kind == PH_CONE_WIDE) {
    return *a;
  }
  /* Both lows lie less than a half turn clockwise of the common direction:
   * one of them is clockwise of the other.  Likewise the highs. */
  return ph_cone_of(ph_cplx_cross(a->low, b->low) >= 0 ? a->low : b->low,
                    ph_cplx_cross(a->high, b->high) >= 0 ? b->high : a->high);
}

#endif
