/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * How a segment bends and twists at a place, and by how much that may be off.
 * With sigma = |r'|, C = r' x r'' and primes by u,
 *
 *   kappa = |C| / sigma^3,  kappa' = |C|' / sigma^3 - 3 kappa sigma' / sigma,
 *   tau = C . r''' / |C|^2,
 *   tau' = C . r'''' / |C|^2 - 2 tau C . C' / |C|^2,  C' = r' x r'''     (1)
 *
 * from the claimed preimage where it fits the control points to their rounding,
 * and knows more than these, or is less work; else from these.  Errors are
 * those of (1) to the first order.
 */
#ifndef PH_CHECK_BEND_H
#define PH_CHECK_BEND_H

#include "check/root.h"

/* A segment that is looked at. */
struct ph_check_bent {
  const struct ph_check_segment *s;
  struct ph_check_dips slow; /* as ph_check_slow_of */
  struct ph_check_root root; /* where rooted */
  bool rooted, plane;
  bool twists; /* torsion is wanted, too */
};

struct ph_check_bend {
  double speed, kappa, rate, twist; /* kappa signed in the plane; rate, twist:
                                       kappa', tau' */
  double kappa_error, rate_error, twist_error;
};

/* ph_check_bent_of: of a segment of a curve of PH_CHECK_SQUARE. */
struct ph_check_bent ph_check_bent_of(const struct ph_check *v,
                                      const struct ph_check_segment *s);

/* ph_check_bend_at: (1). */
struct ph_check_bend ph_check_bend_at(const struct ph_check_bent *bent,
                                      double u);

/* ph_check_bent_stands: whether rounding may make it stand still or turn back:
 * then energies are anything, and the tangent turns by half a turn to either
 * side. */
bool ph_check_bent_stands(const struct ph_check_bent *bent);

/* ph_check_bent_length: its length.
 * out  error  by how much that may be off */
double ph_check_bent_length(const struct ph_check *v,
                            const struct ph_check_bent *bent, double *error);

/* ph_check_bending: (|C| / sigma^2)^2, of a ph_check_bent. */
double ph_check_bending(const void *bent, double u);

/* ph_check_bent_straight: whether rounding may make a segment straight at a
 * place: then its torsion is anything there. */
bool ph_check_bent_straight(const struct ph_check_bent *bent, double u);

#endif
