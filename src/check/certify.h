/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Certificates: what a curve promises, recomputed from its control points by
 * code that does not know how it was found (verify.h says what it shares), by
 * fixed rules.
 *
 * Errors are reported relative to the size of the data (half the diagonal of
 * the bounding box) or as each one says.  A curve is accepted when every error
 * is within its tolerance plus what rounding of the control points to doubles
 * can make of it; the latter matters where segments are tiny beside the whole
 * (a second derivative is a second difference of control points).
 */
#ifndef PH_CHECK_CERTIFY_H
#define PH_CHECK_CERTIFY_H

#include "check/promise.h"

/*
 * ph_certify: whether a curve is what its command promises (promise.h), by the
 * fixed rules of its row below.
 *
 * in   diagnostics  claims that a row below says it looks at
 * out  diagnostics  what was found
 * ret  PH_OK | PH_E_INTERNAL (the command promises nothing, or the curve is of
 *      no kind, dimension or degree that it makes) | PH_E_TOO_LARGE (something
 *      is not finite) | PH_E_NO_CONVERGENCE (an error exceeds its tolerance;
 *      says which and where) | PH_E_NO_MEMORY
 */
enum ph_status ph_certify(const char *command, const struct ph_problem *problem,
                          const struct ph_curve *curve,
                          struct ph_arena *scratch,
                          struct ph_diagnostics *diagnostics,
                          struct ph_diag *diag);

/*
 * ---- what is promised of all curves whose hodographs are squares -----------
 *
 * planar (C2, PH quintic or ATPH), spatial-hermite (PH quintic or ATPH) and
 * arclength (C2, PH quintic), by the tolerances of their rows (promise.c):
 *
 *   interpolation_error   distance of the ends of segments, or of intervals of
 *                         the data, from the points, or of the start, / size
 *   tangent_error         |t - given| of unit tangents, or |r' - d| / |d| of
 *                         derivatives, these by the knots, or s^2 d with the
 *                         tension s; unknown if neither is given
 *   end_derivative_error  the same at the ends, where d is given
 *   pythagorean_error     |r' - w^2| or |r' - A i A*| at the nodes of a Gauss
 *                         rule
 *   continuity_error      jumps at the joints as promised: of r by the knots
 *                         over the size; of r' over |r'|, and of r'' over |r'|
 *                         per shorter neighbouring interval; of the unit
 *                         tangent, and of r', relative, where derivatives are
 *                         given and both tensions are the same
 *   length_error          of segments and the whole against Gauss quadrature of
 *                         |r'|, of intervals against what is prescribed
 *
 * pythagorean_error and length_error are relative to the size and the length of
 * the curve (planar), to the speed and the length of the segment
 * (spatial-hermite) or to the mean length of an interval (arclength); size is
 * half the diagonal of the points, arclength: of the control points.
 *
 * Not checked here: how fair the curve is and whether it crosses itself, which
 * curve/fair/describe.h tells, and functional, which the solver does, all by
 * curve/fair/fair3.h.  `phspline verify' finds them by a quadrature of its own
 * (check/fair.c).
 *
 * ret  PH_OK | PH_E_TOO_LARGE (something is not finite) | PH_E_NO_CONVERGENCE
 *      (an error exceeds its tolerance; says which and where) | PH_E_INTERNAL
 *      (segments and data do not fit together) | PH_E_NO_MEMORY
 *
 * ---- the rows of the table: what else, of curves that are what ph_certify
 * says
 */

/* ph_check_spatial_shape: whether a segment that claims to keep the shape of
 * the data does (check/shape_spatial.h). */
void ph_check_spatial_shape(struct ph_check *v,
                            const struct ph_check_segment *s);

/*
 * ph_check_spatial_hermite:
 *
 *   shape_ok  whether all segments claim to keep the shape of the data; where
 *             one does not keep what it claims, the curve is refused
 */
ph_promise_fn ph_check_spatial_hermite;

/*
 * ph_check_arclength: one to three segments for each interval of the data.
 *
 *   min_speed     the smallest |A|^2 by the global parameter, relative to the
 *                 mean speed, to 1e-13
 *   F, kkt_error  anew, in place of those of the solver (check/stationary.h)
 *
 * A curve is refused, too, when F is not what it was said to be, when it is
 * not stationary, or when it is claimed to be a minimiser and F can fall; that
 * it is a saddle is believed.
 *
 * in   diagnostics  F and second_order as claimed, or unknown; F_relaxed, which
 *                   soft lengths are weighed by
 */
ph_promise_fn ph_check_arclength;

/*
 * ph_check_sphere: a spherical nu-spline through the problem's points, of the
 * model, the ends, the knots, the tensions and the shape that it claims.  All
 * is brought to the unit sphere first.
 *
 *   sphere_error          | |p - center| / radius - 1 | of control points
 *   interpolation_error   distance of the joints from the points, these
 *                         projected onto the sphere / half the diagonal of the
 *                         control points, or the radius if that is smaller;
 *                         how far points were moved is bounded, too
 *   continuity_error      jump of the velocity with respect to the knots /
 *                         the larger speed, where it is not 0
 *   curvature_jump        jump of kappa_g / max(1, |kappa_g| on both sides);
 *                         1e-10 is allowed of the model `exact', beside what
 *                         rounding of control points makes of it; of `nielson'
 *                         it is a number and no promise
 *   max_curvature         the largest |kappa_g| at a node between two segments,
 *                         1/unit
 *   end_derivative_error  of open curves: distance of the second control point
 *                         from where the ends put it / angle of the segment
 *   length_error          lengths against sums of distances of points,
 *                         extrapolated, / total
 *   tension_sum           of the nodes where a tension has an effect
 *   shape_ok              whether all criteria of shape hold
 *                         (check/shape_sphere.h); where the problem asks for
 *                         that and one does not, the curve is refused
 *
 * A curve is refused, too, when its knots are not those of the problem, when
 * it is not the curve of its tensions, or with shape=false when these are not
 * those of the problem, and when an indicator is not the turn of the data.
 *
 * ret  as above; PH_E_INTERNAL when segments, sphere and problem do not fit
 *      together
 */
ph_promise_fn ph_check_sphere;

/*
 * ph_check_tc: planar Tschirnhausen cubics, one or two for each interval of
 * the data as the mode of the problem says, or for a chain of Bezier curves.
 *
 *   interpolation_error   distance of the ends of intervals from the points,
 *                         and of joints that are to be on the chord from it /
 *                         size; of approximations: of ends of cubics, but for
 *                         inner joints of pairs, from the curve at their knots
 *   tangent_error         |t - wanted| of unit tangents: given ones, those of
 *                         [BYR11, (5.24)] anew, or of the curve
 *   end_derivative_error  |r' - wanted| / |wanted| at the ends of pairs, where
 *                         derivatives or lambda are given, and of splines
 *   pythagorean_error     |r' - w^2|, and of h0, h1, h2, the coefficients of r'
 *                         from the control points alone, |h1^2 - h0 h2| / |r'|;
 *                         / largest coefficient of r', each cubic by itself
 *   continuity_error      gaps at the joints / size; jumps of the unit tangent;
 *                         |jump of r'| / |r'| within pairs whose joint is free,
 *                         and between intervals where derivatives are wanted;
 *                         of chains, gaps alone where two given curves meet
 *   length_error          lengths against Gauss quadrature of |r'| / length
 *   regular               |w| is nowhere below 1e-12 of its larger end
 *   distance              of approximations: an upper bound of the Hausdorff
 *                         distance, in the unit of the data (tc_distance.h)
 *
 * Not checked here: how fair the curve is, its largest curvature and whether it
 * crosses itself, which curve/fair/describe.h tells.  An irregular curve is
 * refused unless all solutions are asked for.  An approximation is refused,
 * too, when its distance exceeds the tolerance and when it has too many cubics.
 * The distance that is told is the bound found here, or the claim where this
 * bound confirms it but for rounding; no claim is refused.
 *
 * in   diagnostics  distance as claimed, or unknown: what is looked for
 * ret  as above; PH_E_INTERNAL when segments, knots and problem do not fit
 *      together
 */
ph_promise_fn ph_check_tc;

/*
 * ph_check_cone: a surface of strips of circular cones through the contact
 * elements of the problem.
 *
 *   interpolation_error, frame_error, isometry_error, length_error
 *                         as cone.h says; 1e-10 is allowed of frames, and ten
 *                         times degenerate_tolerance where that is given
 */
ph_promise_fn ph_check_cone;

/*
 * ph_check_bubble: a surface of patches over the faces of the problem.
 *
 *   interpolation_error  distance of corners from the points / size
 *   continuity_error     gaps between patches along edges / size
 *   normal_error         angle of normals at corners to those that are given;
 *                        1e-9 is allowed
 *   normal_jump, curvature_jump
 *                        as bubble.h says; where no degree is given, the field
 *                        tolerance is allowed, and 1000 times that of
 *                        curvatures of continuity 2
 */
ph_promise_fn ph_check_bubble;

#endif
