/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The data of spatial Hermite interpolation: points, tangents, derivatives,
 * knots, alpha and tensions of a problem, checked, with what is absent filled
 * in by its rule.
 */
#ifndef PH_SOLVE_SPATIAL_DATA_H
#define PH_SOLVE_SPATIAL_DATA_H

#include "base/diag.h"
#include "base/mem.h"
#include "curve/problem.h"
#include "solve/spatial/family.h"

struct ph_spatial_points {
  size_t n;        /* segments */
  size_t points_n; /* n if closed, else n + 1 */
  bool closed;
  bool atph;
  bool derivatives; /* given: what ends have is a promise */
  bool estimated;   /* tangents, from the points */
  double planarity;
  ph_vec3 normal;    /* unit, of the plane of all data; 0: they have none */
  double *points;    /* [points_n][3] */
  ph_vec3 *tangents; /* [points_n], unit */
  double *speeds;    /* [points_n] |derivative|, or NULL */
  double *knots;     /* [n + 1] */
  double *lambda;    /* [n] |Di| and |Df| at tension 1, from the knots */
  double *tension;   /* [n] initial s */
  double *alpha;     /* [n]; NULL: 0, or to be chosen */
};

/*
 * ph_spatial_points_of: reads and checks a problem.
 *
 * ret  PH_OK | PH_TOO_FEW_POINTS | PH_COINCIDENT_POINTS | PH_BAD_SHAPE |
 *      PH_BAD_VALUE | PH_ZERO_TANGENT | PH_TOO_LARGE | PH_NO_MEMORY
 */
enum ph_status ph_spatial_points_of(const struct ph_problem *problem,
                                    struct ph_arena *arena,
                                    struct ph_spatial_points *points,
                                    struct ph_diag *diag);

/*
 * ph_spatial_segment: the data of segment k at unit scale.
 *
 * in   tension  both end derivatives are scaled by its square
 * out  data     speeds by u in [0,1], but of given derivatives of atph by t
 * ret  the root of the scale, a power of two: data are the user's times its
 *      square
 */
double ph_spatial_segment(const struct ph_spatial_points *points, size_t k,
                          double tension, struct ph_spatial_data *data);

#endif
