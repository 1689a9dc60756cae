/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A place on a curve or on an offset of it: point, direction, curvature,
 * torsion, and by how much each may be off because control points are rounded.
 *
 * With o = r + d e, e a unit vector across the curve,
 *
 *   plane    e = i r' / |r'|, from the control points
 *   space    e = A j A* / |A|^2 or A k A* / |A|^2, A the claimed preimage
 *
 * derivatives of o are those of power series, and what bends follows from them.
 * On the unit sphere O = cos d S + sin d S x T, with T the unit tangent of S:
 *
 *   O' = g T,  g = cos d |S'| - sin d K / |S'|^2,  K = S . (S' x S'')   (1)
 *
 * and a curve that bends as a circle of radius rho, kappa = cot rho, has a
 * parallel that bends as one of radius rho - d.
 */
#ifndef PH_CHECK_LOCAL_H
#define PH_CHECK_LOCAL_H

#include "check/dips.h"

/* What is looked at: a segment, or the offset of it.  The length of an offset
 * is integrated from cusp to cusp: two of them may be nearer to each other than
 * the places where the speed is looked at, which has a kink at each. */
struct ph_check_path {
  const struct ph_check *v;
  const struct ph_check_segment *s;
  double distance; /* at unit scale; on a sphere the angle; 0: the curve */
  bool binormal;   /* in space: along e3 */
  const struct ph_cusps *cusps; /* of an offset, as listed; or NULL */
};

struct ph_check_local {
  ph_vec3 point, tangent;
  double side_error; /* of the unit vector along which an offset is, at most 2:
                        to any side */
  double point_error, tangent_error; /* the latter is not finite where the
                                        curve stands still */
  double speed, speed_error;         /* |o'| by u */
  double along; /* o' in the direction of the curve: < 0 where the offset
                   turned back */
  double along_error;
  double curvature, curvature_error; /* signed in the plane, geodesic on the
                                        sphere; that of another who is right
                                        is at most twice the error away */
  double torsion, torsion_error;     /* in space */
  double flat; /* in space: the relative error of r' x r'' */
};

/* ph_check_local_at: the place at u in [0,1]. */
struct ph_check_local ph_check_local_at(const struct ph_check_path *path,
                                        double u);

/* ph_check_local_beside: the same, for what was found there: where the curve
 * has no direction, as far as it is known, its offset is at the distance to the
 * side on which it was found. */
struct ph_check_local ph_check_local_beside(const struct ph_check_path *path,
                                            double u, ph_vec3 found);

/* The same of forms and of segments on a sphere, for the rows of kind.c. */
struct ph_check_local ph_check_form_local(const struct ph_check_path *path,
                                          double u);
struct ph_check_local ph_check_great_local(const struct ph_check_path *path,
                                           double u);

/* ph_check_across: e. */
ph_vec3 ph_check_across(const struct ph_check_path *path, double u);

/* ph_check_path_slow: where the curve of an offset all but stands still, as
 * exactly as its preimage knows it: control points do to the root of their
 * rounding, and the curve may turn in less. */
struct ph_check_dips ph_check_path_slow(const struct ph_check_path *path);

/*
 * ph_check_path_length: the length of the path between two places, NaN where
 * it is not found; as ph_check_length_of.
 *
 * in    slow   ph_check_path_slow, of offsets and on spheres: each place may be
 *              an end of a short turn, which is not seen from elsewhere
 * inout error  grows by how much that of an offset is uncertain
 */
double ph_check_path_length(const struct ph_check_path *path,
                            const struct ph_check_dips *slow, double from,
                            double to, double *error);

#endif
