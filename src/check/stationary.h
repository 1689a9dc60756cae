/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Whether a curve is what it claims to be: stationary for the functional F
 * [HUA14, (19)] under what is prescribed, and a minimum.  Found from the
 * preimage alone, with multipliers of its own.
 *
 * First order.  With g the gradient of F, and of the penalty of soft lengths,
 * by the nodes and J that of the rows, the multipliers are those with the
 * smallest |g + J^T y|_2, from the QR factors of J^T.  kkt_error is what is
 * left, relative to the largest terms that g is the sum of; what rounding can
 * make of g and J^T y counts among these times the root of epsilon, so that the
 * number is below some 1e-8 for a curve that is as right as its digits, also if
 * it is straight or nearly so.  A preimage that is not one C1 spline has no
 * such gradient: by how much it is not counts as an error, too.
 *
 * Second order.  H is the Hessian of F + y . c, c the rows.  F has no direction
 * of descent within the rows if the matrix [H + delta, J^T; J, 0] has as many
 * negative eigenvalues as there are rows; they are counted by kernel/inertia.h.
 * No penalty is involved, so that nearly dependent rows do no harm; delta is
 * what rounding can make of H: curvature of less than that has no sign, nor has
 * that about the axis of data in a line, which is 0.  The common phase of the
 * nodes is fixed.
 */
#ifndef PH_CHECK_STATIONARY_H
#define PH_CHECK_STATIONARY_H

#include "check/spinor.h"

/* Lengths in the sense of least squares: F + f_relaxed / (9 n) sum
 * ((L_i - length[i]) / (sigma length[i]))^2. */
struct ph_stationary_soft {
  const double *length; /* [n], NULL: there is nothing like that */
  double sigma;
  double f_relaxed;
  const double *stiffness; /* [n + 1] of directions that were measured, else 0,
                            * or NULL: what is minimised has stiffness[j]
                            * (|r'| - toward[j] . r') at knot j, r' where the
                            * mean interval has length and spacing 1 */
};

struct ph_stationary {
  double f;          /* in the unit of the data */
  double f_rounding; /* of it */
  double kkt_error;
  bool minimiser;
};

/*
 * ph_stationary_of: what a curve is.
 *
 * ret  PH_OK | PH_E_NO_MEMORY
 */
enum ph_status ph_stationary_of(const struct ph_curve *curve,
                                const struct ph_spinor_rows *rows,
                                const struct ph_stationary_soft *soft,
                                struct ph_arena *arena,
                                struct ph_stationary *stationary,
                                struct ph_diag *diag);

#endif
