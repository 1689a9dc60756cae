/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Arcs of strands: parts that go one way along the curve, of curvature of one
 * sign, and turn by little.
 *
 * An arc of length l between points c apart lies in the ellipse round both of
 * them as foci with axes l and sqrt(l^2 - c^2), and no two of its tangents are
 * further apart than those at its ends.
 */
#ifndef PH_CURVE_OFFSET_ARC_H
#define PH_CURVE_OFFSET_ARC_H

#include "curve/offset/strand.h"

/* Arcs turn by less than that. */
#define PH_ARC_TURN 0.4

/* Parts of an offset that are shorter are no parts of it; of the size. */
#define PH_ARC_LEAST 1e-11

/* A part of a strand. */
struct ph_bit {
  double u[2];
  struct ph_spot end[2];
  double turn;   /* signed */
  double length; /* not less than that of the chord; < 0 if it goes back along
                    the curve */
};

struct ph_arc {
  size_t strand;
  struct ph_bit bit;
  size_t next; /* the one that begins where it ends, or none */
  bool smooth; /* it goes on to that one in its own direction */
};

struct ph_arcs {
  struct ph_arc *v;
  size_t n;
};

/*
 * ph_arcs_of: all arcs of strands, of which backward ones are no part of the
 * trimmed offset.
 *
 * in   forward  only those that go forward
 * ret  PH_OK | PH_E_INFEASIBLE (the curve stands still somewhere: no normal
 *      there; names the segment) | PH_E_NO_MEMORY
 */
enum ph_status ph_arcs_of(const struct ph_strands *strands, bool forward,
                          struct ph_arcs *arcs, struct ph_diag *diag);

/* ph_bit_of: the part between two places of a strand. */
struct ph_bit ph_bit_of(double distance, double u0, const struct ph_spot *a,
                        double u1, const struct ph_spot *b);

#endif
