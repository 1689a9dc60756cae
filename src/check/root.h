/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The claimed preimage A of a segment, r' = A i A*, in the plane r' = A^2.
 *
 * Where a curve nearly stops r' is rounding of the control points before A is:
 * A is known to its own rounding, r' = A i A* to |A| times that.
 */
#ifndef PH_CHECK_ROOT_H
#define PH_CHECK_ROOT_H

#include "check/dips.h"
#include "kernel/quat.h"

struct ph_check_root {
  size_t n; /* coefficients, 2 or 3 */
  double angle, middle;
  ph_quat a[3];
  double error; /* by how much A may be off */
};

/* ph_check_root_of: of a segment whose curve claims a preimage. */
void ph_check_root_of(const struct ph_check *v,
                      const struct ph_check_segment *s,
                      struct ph_check_root *root);

/* ph_check_root_at: A at u as a power series.
 * out  a[PH_CHECK_JET] */
void ph_check_root_at(const struct ph_check_root *root, double u, ph_quat *a);

/*
 * ph_check_root_jet: r', r'', ... by u.
 *
 * out  jet[n]    n <= PH_CHECK_JET
 * out  error[n]  by how much each may be off
 */
void ph_check_root_jet(const struct ph_check_root *root, double u, ph_vec3 *jet,
                       double *error, size_t n);

/* ph_check_root_slow: dips, if there are any, as exactly as A knows them:
 * control points do to the root of their rounding. */
void ph_check_root_slow(const struct ph_check_root *root,
                        struct ph_check_dips *slow);

#endif
