/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * What a record says of a curve beside what it promises: how fair it is, and
 * whether it crosses itself.  A curve is described after its certificate was
 * found good, by the closed forms and the quadrature of this room; `phspline
 * verify' finds the same numbers by its own (check/fair.c).
 */
#ifndef PH_CURVE_FAIR_DESCRIBE_H
#define PH_CURVE_FAIR_DESCRIBE_H

#include "base/diag.h"
#include "base/mem.h"
#include "curve/result.h"

/*
 * ph_describe_fn: sets diagnostics; a number that there is none of, as of a
 * curve that stands still, stays unknown, and so may one that nobody asked for
 * (diagnostics->unasked).
 *
 * ret  PH_OK | PH_E_NO_MEMORY | what ph_cross_planar returns
 */
typedef enum ph_status ph_describe_fn(const struct ph_curve *curve,
                                      struct ph_arena *scratch,
                                      struct ph_diagnostics *diagnostics,
                                      struct ph_diag *diag);

/* ph_describe_planar: planar PH and ATPH splines: loops, simple, energies by
 * curve/fair/energy.h and rotations. */
ph_describe_fn ph_describe_planar;

/*
 * ph_describe_spatial: segments in space that were found one by one
 * (fair3.h): energy is the integral of kappa^2 ds; F1, F2 and F3 are sums
 * of those of the segments.  Of more than 1000 segments the sums say little,
 * and take as long as the solution: they are left out.
 */
ph_describe_fn ph_describe_spatial;

/*
 * ph_describe_cubics: Tschirnhausen cubics, by their closed forms: loops, one
 * that has shrunk to a point among them; simple; of a curve that does not
 * stand still the energy, the largest curvature and rotations.
 *
 * in   diagnostics  regular, as the certificate found it
 */
ph_describe_fn ph_describe_cubics;

#endif
