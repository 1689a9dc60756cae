/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Random problems of spatial Hermite interpolation, in families that are named
 * for what is hard about them, and their solutions.
 */
#ifndef PH_TESTS_PROP_SPATIAL_DATA_H
#define PH_TESTS_PROP_SPATIAL_DATA_H

#include "problem_unit.h"
#include "unit.h"

#include "kernel/vec3.h"

enum { SPATIAL_POINTS_MAX = 40 };

enum spatial_family {
  SPATIAL_RANDOM,   /* points of a cube, tangents of the sphere */
  SPATIAL_WALK,     /* steps of 0.5 to 2 anywhere */
  SPATIAL_HELIX,    /* points and tangents of a helix, unevenly spaced */
  SPATIAL_FLAT,     /* a walk in the plane z = 0, and so its tangents */
  SPATIAL_TILTED,   /* the same in another plane */
  SPATIAL_STRAIGHT, /* one after the other on a line, tangents along it */
  SPATIAL_REVERSED, /* the same, to and fro */
  SPATIAL_PARALLEL, /* a walk; tangents parallel but for 1 to 1e-16 */
  SPATIAL_OPPOSITE, /* a walk; neighbouring tangents opposite, as nearly */
  SPATIAL_NEAR,     /* some points within 1e-12 to 1 of the one before */
  SPATIAL_MIXED,    /* steps of 1e-9 to 1 */
  SPATIAL_FAR,      /* a walk 1e3 to 1e12 away from the origin */
  SPATIAL_FAST,     /* derivatives of 1 to 1e8 times the chords */
  SPATIAL_SLOW,     /* derivatives of 1e-8 to 1 times the chords */
  SPATIAL_FAMILY_N
};

/* What is given beside the points. */
enum spatial_given { SPATIAL_POINTS, SPATIAL_TANGENTS, SPATIAL_DERIVATIVES };

struct spatial_data {
  enum spatial_family family;
  size_t n; /* points */
  bool closed;
  ph_vec3 point[SPATIAL_POINTS_MAX];
  enum spatial_given given;
  ph_vec3 vector[SPATIAL_POINTS_MAX]; /* tangents or derivatives */
  const char *criterion;              /* NULL: by default */
  bool has_angles;
  double angles[2 * SPATIAL_POINTS_MAX];
  const char *axis; /* NULL: by default */
  bool atph;
  double alpha[SPATIAL_POINTS_MAX];
  bool has_knots;
  double knots[SPATIAL_POINTS_MAX + 1];
  bool has_tension;
  double tension[SPATIAL_POINTS_MAX];
  const char *shape; /* "true", "false", NULL: by default */
};

/* spatial_name: the name of a family. */
const char *spatial_name(enum spatial_family family);

/* spatial_points: n points with unit tangents, everything else by default. */
void spatial_points(struct unit_random *r, enum spatial_family family, size_t n,
                    bool closed, struct spatial_data *data);

/* spatial_of: a problem of a family, with 2 (closed: 3) to points_max points,
 * open or closed, and of the other fields any; but no functional. */
void spatial_of(struct unit_random *r, enum spatial_family family,
                size_t points_max, struct spatial_data *data);

/* spatial_any: the same of any family. */
void spatial_any(struct unit_random *r, size_t points_max,
                 struct spatial_data *data);

/* spatial_segments: the number of segments. */
size_t spatial_segments(const struct spatial_data *data);

/* spatial_chord: from point k to the next. */
ph_vec3 spatial_chord(const struct spatial_data *data, size_t k);

/*
 * spatial_solve: solves, then certifies; the memory of the solver that is to
 * be given back is checked.
 *
 * inout solution  what it held is given back
 */
enum ph_status spatial_solve(const struct spatial_data *data, size_t which,
                             struct unit_solution *solution);

/* spatial_is_chosen: whether the problem names this criterion. */
bool spatial_is_chosen(const struct spatial_data *data, const char *criterion);

/* spatial_answer: the same; fails unless the curve passes its certificate, or
 * is refused for a reason that the data have: then false. */
bool spatial_answer(const struct spatial_data *data, size_t which,
                    struct unit_solution *solution);

/* spatial_point: control point i of segment k. */
ph_vec3 spatial_point(const struct ph_curve *curve, size_t k, size_t i);

/* spatial_segment_size: the length of the control polygon of segment k. */
double spatial_segment_size(const struct ph_curve *curve, size_t k);

/* spatial_rounding: of coordinates of the control points of segment k. */
double spatial_rounding(const struct ph_curve *curve, size_t k);

#endif
