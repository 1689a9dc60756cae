/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Solutions of the arc-length equations from afar: whitened rows, twisted
 * phases and an augmented Lagrangian.  They lead into the region
 * where Newton's method on the KKT system converges.
 *
 * With one segment in an interval the rows are nearly dependent wherever the
 * curve is smooth [HUA14, 4.5], so that a line search on a merit function
 * stalls.  What is here asks for no rank of the rows: every step is the minimum
 * of a model within a trusted radius, corrected for the curvature of the rows.
 */
#ifndef PH_SOLVE_ARCLENGTH_PENALTY_H
#define PH_SOLVE_ARCLENGTH_PENALTY_H

#include "solve/arclength/region.h"
#include "solve/arclength/system.h"

/*
 * ph_arc_whiten: takes the rows of an interval to the entries of
 * M^-1/2 (integral of w w^H - M) M^-1/2, M = (length + step . sigma) / 2, the
 * Pauli matrices sigma.  With the unit vector u of the step, L = (length +
 * chord) / 2, e = (length - chord) / 2 and t across u, they are
 *
 *   (c_0 + u . c) / 2 L,  (c_0 - u . c) / 2 e,  t . c / sqrt(2 L e).
 *
 * They are relative, and the same wherever the data are turned.  Lengths near
 * their chords weigh more, as they leave less room.  Systems other than of
 * points with exact lengths stay as they are.
 *
 * ret  false when memory is exhausted
 */
bool ph_arc_whiten(struct ph_arc_system *system, struct ph_arena *arena);

/* ph_arc_plain: multipliers of the rows as they are, of those of the whitened
 * ones.  out plain[y_n], may be y */
void ph_arc_plain(const struct ph_arc_system *system, const double *y,
                  double *plain);

/* ph_arc_whitened: and back.  out white[y_n], may be y */
void ph_arc_whitened(const struct ph_arc_system *system, const double *y,
                     double *white);

/*
 * ph_arc_twist: turns the phases of the nodes by angle and -angle in turn.
 *
 * With one segment in an interval, smooth curves are too short for the exact
 * lengths of a smooth curve; those that are long enough have such phases, of
 * about a tenth of the turning of an interval.  inout x of a system in space
 */
void ph_arc_twist(const struct ph_arc_system *system, double angle, double *x);

/* What the search works in, for systems of one size. */
struct ph_arc_work {
  const struct ph_arena *arena; /* of all this; knows how much time there is */
  struct ph_arc_linear linear;
  struct ph_arc_region region;
  double *ordered;                 /* [x_n] in the order of matrices */
  double *step;                    /* [x_n] */
  double *to, *better;             /* [x_n] points tried */
  double *c, *c_to, *c_better, *y; /* [y_n] */
};

/* ph_arc_work_alloc: ret false when memory is exhausted. */
bool ph_arc_work_alloc(const struct ph_arc_system *system,
                       struct ph_arena *arena, struct ph_arc_work *work);

struct ph_arc_penalty_options {
  double rho;        /* first weight of the squared rows */
  double rho_max;    /* and the last */
  double tolerance;  /* of the rows */
  size_t iterations; /* steps, at most */
};

struct ph_arc_penalty_report {
  size_t iterations; /* steps made */
  size_t factors;    /* Cholesky factors tried */
  double rows;       /* the largest |c_k| */
};

/*
 * ph_arc_penalty: minimises F + y . c + rho / 2 |c|^2, then y += rho c, and so
 * on until the rows are met.
 *
 * inout x
 * inout y  multipliers of the rows of the system, whitened if they are
 * ret   whether the tolerance was reached
 *
 * Rows with a compliance are taken as exact.
 */
bool ph_arc_penalty(const struct ph_arc_system *system,
                    const struct ph_arc_penalty_options *options,
                    struct ph_arc_work *work, double *x, double *y,
                    struct ph_arc_penalty_report *report);

#endif
