/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Surfaces of strips of circular cones, as checks see them.
 *
 * A strip's frame (e, d, n) turns about the constant axis w = kn e - k n by the
 * angle |w| s, and the chord of its contact curve is along the tangent in its
 * middle: rotations say where a strip ends, and where its sides go.
 */
#ifndef PH_CHECK_CONE_H
#define PH_CHECK_CONE_H

#include "check/checks.h"

/* A frame, at unit scale. */
struct ph_check_frame {
  ph_vec3 c, e, d, n;
};

/* What the checks of a surface share. */
struct ph_check_cone {
  struct ph_check *v;
  const struct ph_curve *curve;       /* the surface, or one parallel to it */
  double frame;                       /* allowed of frames, relative */
  double flat;                        /* rounding of the development */
  const struct ph_check_cone *beside; /* of a parallel surface: which one, */
  double distance;                    /* and how far, in the unit of the data */
};

/* ph_check_cone_point: point j of the problem, moved as it says. */
ph_vec3 ph_check_cone_point(const struct ph_check *v, size_t j);

/* ph_check_cone_frame: the frame of strip i at the part u of its length. */
struct ph_check_frame ph_check_cone_frame(const struct ph_check_cone *cone,
                                          size_t i, double u);

/* ph_check_cone_is_finite: of a surface that is certified, whether length and
 * area are; else it fails. */
bool ph_check_cone_is_finite(struct ph_check *v, const struct ph_curve *curve);

/* ph_check_cone_arrays: whether a surface is one, with finite numbers. */
bool ph_check_cone_arrays(struct ph_check *v, const struct ph_curve *curve);

/*
 * ph_check_cone_strips: what is promised of the strips of a surface: frames at
 * the ends of all strips, arcs, and the development.
 *
 *   frame_error     of directions, and of points over the length of the pair:
 *                   frames at the ends of strips from those of the next ones,
 *                   and between pairs from the contact elements; control points
 *                   from the arc
 *   isometry_error  of lengths and angles of the arcs of the development from
 *                   those of the contact curve, relative, and of its joints
 *   length_error    of lengths of strips from those of their arcs
 */
void ph_check_cone_strips(struct ph_check_cone *cone);

/* ph_check_cone_told: all that a record says besides: numbers of strips, pairs
 * and diagnostics, parallel surfaces, samples.  ret PH_OK | PH_E_NO_MEMORY */
enum ph_status ph_check_cone_told(struct ph_check_cone *cone);

/* ph_check_cone_folds: the diagnostics folded and regular.  inside: how many
 * strips have a vertex within the height. */
void ph_check_cone_folds(struct ph_check *v, const struct ph_curve *curve,
                         double inside);

/* ph_check_cone_scale: sets the scale to that of both ends of all arcs; false
 * where there is none, or, which is the status, no memory. */
bool ph_check_cone_scale(struct ph_check_cone *cone, enum ph_status *status);

/* ph_check_cone_located: whether place i of the development is on a strip, and
 * within its length and the height; that it is of the problem's point. */
bool ph_check_cone_located(const struct ph_check_cone *cone,
                           const struct ph_located_list *list, size_t i);

/*
 * ph_check_cone_general: all of a surface of strips of general cones, v->curve.
 *
 *   pythagorean_error, continuity_error, length_error
 *                   of the directrices, as of ATPH curves in space
 *   interpolation_error, tangent_error
 *                   of the problem: points, vertices, contact points on common
 *                   rulings; derivatives at both ends of all strips
 *   frame_error     directions of rulings and normals at the ends of all strips
 *                   against those of the next ones, and of the elements
 *   isometry_error  of the angles of rulings, of all samples of the development
 *                   and of its joints
 *
 * ret  PH_OK | PH_E_NO_MEMORY
 */
enum ph_status ph_check_cone_general(struct ph_check *v);

/* ph_check_surface: all of these, of the record of v; for verify.c.  ret PH_OK
 * | PH_E_NO_MEMORY */
enum ph_status ph_check_surface(struct ph_check *v);

#endif
