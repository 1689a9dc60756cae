/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Criteria that choose a member of a family by an extremum [FAR15, sec. 6]:
 * the longest curve (HC), and the middle coefficient of the preimage nearest to
 * the mean of the outer ones (BV).  For CC see spatial_family.h.
 *
 * In both the best phi for a given b is 0, and what remains is a function of b
 * alone.  For plane data these are chosen among the curves in their plane, b =
 * 0 and b = pi.
 */
#ifndef PH_SOLVE_SPATIAL_CRITERIA_H
#define PH_SOLVE_SPATIAL_CRITERIA_H

#include "solve/spatial/family.h"

/*
 * ph_spatial_hc: the member with the greatest arc length.
 *
 * All stationary points of the length are roots of a quartic in tan(b/2), and
 * all of these are found: the maximum is global.
 */
struct ph_spatial_member ph_spatial_hc(const struct ph_spatial_family *family);

/*
 * ph_spatial_bv: the member with the least |A1 - (A0 + A2) / 2|.
 *
 * Local minima are bracketed by 64 values of b; two that lie between the same
 * two of these could be missed.
 */
struct ph_spatial_member ph_spatial_bv(const struct ph_spatial_family *family);

#endif
