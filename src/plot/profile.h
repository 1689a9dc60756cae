/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Profiles: curvature or torsion over arc length, within a range that a few
 * places where they are very large do not spoil.
 */
#ifndef PH_PLOT_PROFILE_H
#define PH_PLOT_PROFILE_H

#include "base/mem.h"
#include "plot/axes.h"
#include "plot/drawing.h"

#include <stdbool.h>

enum ph_profile_of { PH_PROFILE_CURVATURE, PH_PROFILE_TORSION };

/* low < high, both finite; whether there is any value. */
struct ph_range {
  double low, high;
  bool any;
};

/*
 * ph_profile_range: the range in which profiles are drawn.
 *
 * All values, if the largest are not much larger than those on 84 % of the
 * length; else what is a few times as far from the middle as those.  What is
 * zero or constant but for rounding is drawn as a straight line.
 *
 * in   length   the largest of the drawings: > 0
 * in   scratch  memory is given back
 * ret  PH_OK | PH_E_NO_MEMORY
 */
enum ph_status ph_profile_range(const struct ph_drawing *const *drawings,
                                size_t n, enum ph_profile_of of, double length,
                                struct ph_arena *scratch,
                                struct ph_range *range, struct ph_diag *diag);

/*
 * ph_profile_draw: profiles in axes: one path for each segment, thin lines at
 * the joints of a single drawing, and small triangles at the edge where values
 * leave the range.
 */
void ph_profile_draw(const struct ph_drawing *const *drawings, size_t n,
                     enum ph_profile_of of, const struct ph_axes *axes,
                     struct ph_page *page, double em);

#endif
