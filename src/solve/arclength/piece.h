/* SPDX-License-Identifier: GPL-3.0-or-later */
/* One interval of the equations: its nodes, with those of a closed curve beyond
 * the seam turned or reversed (see arclength_system.h). */
#ifndef PH_SOLVE_ARCLENGTH_PIECE_H
#define PH_SOLVE_ARCLENGTH_PIECE_H

#include "solve/arclength/system.h"

struct ph_arc_piece {
  size_t interval;
  size_t inside;              /* its nodes before the seam */
  double cosine, sine;        /* of chi */
  double w[4 * PH_ARC_SPAN];  /* nodes [span][dim] */
  double gw[4 * PH_ARC_SPAN]; /* G w */
};

/* ph_arc_piece_of: an interval at x. */
void ph_arc_piece_of(const struct ph_arc_system *system, const double *x,
                     size_t interval, struct ph_arc_piece *piece);

/* ph_arc_piece_row: w . S_k G w.
 * out gradient  [span][dim] its derivative by the nodes; or NULL */
double ph_arc_piece_row(const struct ph_arc_system *system,
                        const struct ph_arc_piece *piece, int form,
                        double *gradient);

/* ph_arc_piece_back: derivatives by the nodes become derivatives by the
 * unknowns.  inout v[local] */
void ph_arc_piece_back(const struct ph_arc_system *system,
                       const struct ph_arc_piece *piece, double *v);

#endif
