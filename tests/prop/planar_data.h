/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Random problems of planar splines, in four families.
 *
 *   smooth, rough, sharp   polygons with sides of 0.5 to 2 that turn by at
 *                          most 60, 90, 150 degrees at each point; closed ones
 *                          turn by 360 degrees in all
 *   random                 points anywhere in the unit square
 */
#ifndef PH_TESTS_PROP_PLANAR_DATA_H
#define PH_TESTS_PROP_PLANAR_DATA_H

#include "planar_unit.h"
#include "unit.h"

enum { PROP_POINTS_MAX = 1001 };

enum prop_family {
  PROP_SMOOTH,
  PROP_ROUGH,
  PROP_SHARP,
  PROP_RANDOM,
  PROP_FAMILY_N
};

struct prop_data {
  size_t n; /* points */
  bool closed;
  const char *rule; /* NULL: none given */
  bool has_knots, has_ends;
  ph_cplx point[PROP_POINTS_MAX];
  double knots[PROP_POINTS_MAX + 1];
  ph_cplx end[2];
};

/* prop_name: the name of a family. */
const char *prop_name(enum prop_family family);

/* prop_points: points of a family with n segments; no knots, no ends. */
void prop_points(struct unit_random *r, enum prop_family family, size_t n,
                 bool closed, struct prop_data *data);

/* prop_any: a problem of any family with 2 to segments_max segments, open or
 * closed, with knots of every kind, and with ends or without. */
void prop_any(struct unit_random *r, size_t segments_max,
              struct prop_data *data);

/* prop_segments: the number of segments. */
size_t prop_segments(const struct prop_data *data);

/* prop_problem: the problem, for unit_planar_solve; failures name it. */
struct unit_solution prop_problem(const struct prop_data *data, size_t which);

#endif
