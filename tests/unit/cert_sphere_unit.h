/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Problems on the sphere for tests, and curves that solve them: the splines of
 * sphere_table.h, circles of latitude and arcs.
 */
#ifndef PH_TESTS_CERT_SPHERE_UNIT_H
#define PH_TESTS_CERT_SPHERE_UNIT_H

#include "sphere_table.h"

#include "curve/problem.h"
#include "curve/result.h"
#include "kernel/vec3.h"

enum { UNIT_SPHERE_MAX = 200 };

/* A problem and its curve. */
struct unit_sphere {
  struct ph_problem problem;
  struct ph_curve curve;
  double points[3 * UNIT_SPHERE_MAX], lonlat[2 * UNIT_SPHERE_MAX], center[3];
  double knots[UNIT_SPHERE_MAX + 1], given_knots[UNIT_SPHERE_MAX + 1];
  double control_points[12 * UNIT_SPHERE_MAX], lengths[UNIT_SPHERE_MAX];
  double tensions[UNIT_SPHERE_MAX], given_tensions[UNIT_SPHERE_MAX],
      end_tangents[6];
  signed char indicators[UNIT_SPHERE_MAX];
};

/* Where the sphere is. */
struct unit_ball {
  double center[3], radius;
};

/* Fields of the problem. */
void unit_sphere_word(struct unit_sphere *u, enum ph_field_id id,
                      const char *word);
void unit_sphere_number(struct unit_sphere *u, enum ph_field_id id,
                        double number);
void unit_sphere_flag(struct unit_sphere *u, enum ph_field_id id, bool flag);
void unit_sphere_numbers(struct unit_sphere *u, enum ph_field_id id, double *v,
                         size_t n);
void unit_sphere_vectors(struct unit_sphere *u, enum ph_field_id id, double *v,
                         size_t n, size_t dimension);

/* unit_sphere_put: a point of the unit sphere, on this one.  out  v[3] */
void unit_sphere_put(const struct unit_ball *sphere, ph_vec3 p, double *v);

/* unit_cert_sphere_of: a spline of the table, with shape=warn. */
void unit_cert_sphere_of(struct unit_sphere *u, const struct unit_spline *s,
                         const struct unit_ball *sphere);

/*
 * unit_sphere_latitude: a circle at z = sin(lat) through n points; its legs are
 * an angle in the horizontal direction, and by symmetry the velocity and what
 * is normal to it are continuous, so that it is the curve of the tension
 *   nu = 2 (S''.T) / (h^2 v),  v = 3 leg / h.
 */
void unit_sphere_latitude(struct unit_sphere *u, size_t n, double lat,
                          double leg, const struct unit_ball *sphere);

/* unit_sphere_arc: two points; the velocities at the ends are turned by these
 * angles from the great circle.  out  end_tangents, no field yet */
void unit_sphere_arc(struct unit_sphere *u, double angle, double turn_from,
                     double turn_to, const struct unit_ball *sphere);

#endif
