/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Curvature-continuous splines of Tschirnhausen cubics: that the curvature is
 * the same on both sides of every joint but those that are listed.
 *
 * From the legs of the control points, h0 and h1 at the start of a cubic and h2
 * and h1 at its end: curvature = 2 (h0 x h1)/|h0|^3.
 */
#ifndef PH_CHECK_TC_G2_H
#define PH_CHECK_TC_G2_H

#include "check/certify.h"
#include "check/checks.h"

/* ph_check_tc_g2: ph_check_tc of the mode g2. */
ph_promise_fn ph_check_tc_g2;

/* ph_check_curvature: the same of a record, with what it lists. */
void ph_check_curvature(struct ph_check *v);

#endif
