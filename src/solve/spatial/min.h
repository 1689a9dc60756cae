/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The fairest members of a family of spatial Hermite interpolants: the angles
 * (b, phi), and the angle of the space unless it is given, that minimise F1, F2
 * or F3 of curve/fair3.h [GON18, sec. 3.6].
 *
 * The functions have many local minima.  The global search evaluates them on a
 * grid and descends from the best of its local minima; it is deterministic, and
 * t_spatial_min.c and bench/spatial_min.c compare it with far denser grids.
 */
#ifndef PH_SOLVE_SPATIAL_MIN_H
#define PH_SOLVE_SPATIAL_MIN_H

#include "base/mem.h"
#include "base/status.h"
#include "curve/fair3.h"
#include "solve/spatial/family.h"

#include <stdbool.h>
#include <stddef.h>

/* What is sought. */
struct ph_spatial_search {
  const struct ph_spatial_data *data;
  bool scaled; /* data->ni, nf are derivatives by t in [0,alpha]: those by u are
                  alpha times as long */
  double alpha_lower, alpha_upper; /* the same: alpha is given, 0 for PH */
  int functional;                  /* 1, 2, 3: F1, F2, F3 */
  bool plane; /* plane data: of the members in their plane alone */
};

/* The bounds of a free alpha. */
#define PH_SPATIAL_ALPHA_MIN 1e-3
#define PH_SPATIAL_ALPHA_MAX 2.0943951023931953 /* 2 pi / 3 */

/* What was found. */
struct ph_spatial_minimum {
  struct ph_spatial_member member;
  double alpha;
  double value; /* of the functional, by ph_fair3_of */
  size_t evaluations;
  bool at_bound; /* alpha is free and on a bound: the minimum moves with it */
};

/*
 * ph_spatial_minimize: the global minimum.
 *
 * ret  PH_OK | PH_NO_MEMORY; the value is not finite where the functional is
 *      not, for all members
 */
enum ph_status ph_spatial_minimize(const struct ph_spatial_search *search,
                                   const struct ph_fair3_rules *rules,
                                   struct ph_arena *scratch,
                                   struct ph_spatial_minimum *found);

/*
 * ph_spatial_descend: a local minimum.
 *
 * inout found  member and alpha of the start, the latter within its bounds
 */
enum ph_status ph_spatial_descend(const struct ph_spatial_search *search,
                                  const struct ph_fair3_rules *rules,
                                  struct ph_arena *scratch,
                                  struct ph_spatial_minimum *found);

#endif
