/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * General strips (surface.h): the cone of a vertex over a segment of an ATPH
 * curve.
 *
 * All but the length of the contact curve is by quadrature: phi, and with the
 * geodesic curvature kg of the spherical image w / rho, by which its tangents
 * turn,
 *
 *   phi' = |w x r'| / rho^2,
 *   kg phi' = [w, r', r''] rho / |w x r'|^2.                            (1)
 *
 * The surface at the distance D along the normals has the same rulings, frames
 * and phi.  With the parts vd and ve of r' along d and e,
 *
 *   r_D = r + D n,   r_D' = (vd - D b) d + ve e,   b = +- kg phi',        (2)
 *
 * where b / vd is the normal curvature kn of the contact curve; laid flat it
 * has the same derivative, in frames that turn by phi.  It is no cone.
 *
 * [GON18, sec. 4.4; (1) derived from the derivatives of w / rho, (2) from n' =
 * -b d]
 */
#ifndef PH_CURVE_SURFACE_GENERAL_H
#define PH_CURVE_SURFACE_GENERAL_H

#include "base/diag.h"
#include "base/mem.h"
#include "curve/result.h"
#include "curve/segment/seg3_fast.h"
#include "curve/surface/ruling.h"
#include "kernel/quad.h"

/* A directrix, prepared; u is its parameter in [0,1]. */
struct ph_directrix {
  const struct ph_quad *rule;
  struct ph_fast3 fast;
  ph_vec3 vertex;
  double side;      /* 1, or -1: rulings point to the vertex */
  size_t n;         /* parts of [0,1], short enough for the rule: */
  double *u;        /* [n + 1] */
  double *phi;      /* [n + 1] there */
  double turn;      /* integral of |kg| phi' */
  double range;     /* the largest turn of tangents from one place to another */
  size_t bends;     /* how often kg changes its sign */
  double near, far; /* rho, of the places where it was evaluated */
  double length;    /* of the contact curve of the cone, in the data's unit */
  double distance;  /* D; 0: the cone itself, else */
  double (*moved)[3]; /* [n + 1] at u: by which the development has moved, in
                         the frame of its start, and arc length (2) */
};

/* What there is at a place; lengths are by the unit of `fast', which is `grow'
 * of the data's. */
struct ph_general_place {
  ph_vec3 w, first; /* first: r' */
  double rho, rate; /* phi' */
  double bend;      /* kg phi' */
};

/*
 * ph_general_of: prepares the directrices of all strips of a surface, whose
 * curve has their control points and whose strips have their vertices.
 *
 * ret  PH_OK | PH_E_NO_CONVERGENCE (a tangent is, or is nearly, along its
 *      ruling, or the curve meets the vertex) | PH_E_NO_MEMORY
 */
enum ph_status ph_general_of(struct ph_curve *curve, struct ph_arena *arena,
                             struct ph_diag *diag);

/*
 * ph_general_beside: a strip at a distance from another one, without its place
 * in the development, and with the same rulings at all u.
 *
 * in   height  from where to where there is such a strip
 * out  to      control points, preimage and angles are NULL, there is no vertex
 * ret  PH_OK | PH_E_INFEASIBLE (1 - kn D is not above 0 somewhere within the
 *      height) | PH_E_NO_CONVERGENCE | PH_E_NO_MEMORY
 */
enum ph_status ph_general_beside(const struct ph_curve *curve, size_t i,
                                 double distance, struct ph_arena *arena,
                                 struct ph_strip *to, struct ph_diag *diag);

/* ph_general_moved: at u, of what `moved' has. */
void ph_general_moved(const struct ph_directrix *directrix, double u,
                      double moved[3]);

/* ph_general_at: what there is at u. */
struct ph_general_place ph_general_at(const struct ph_directrix *directrix,
                                      double u);

/* ph_general_phi: phi at u. */
double ph_general_phi(const struct ph_directrix *directrix, double u);

/* ph_general_ruling: the ruling at u. */
struct ph_ruling ph_general_ruling(const struct ph_strip *strip, double u);

/* ph_general_parameter: u where the arc length of the directrix is that part of
 * the whole. */
double ph_general_parameter(const struct ph_strip *strip, double part);

/* ph_general_edge: the point of the development at u and h, and its derivative
 * by u. */
void ph_general_edge(const struct ph_strip *strip, double u, double h,
                     double at[2], double by[2]);

/*
 * ph_general_locate: the place at a point of the development.
 *
 * in   height  within which it is to be
 * in   near    how far from the strip a point is still on its edge
 * ret  whether there is one; of several that where rulings have turned least
 */
bool ph_general_locate(const struct ph_strip *strip, const double height[2],
                       const double flat[2], double near, double *u, double *h);

/* ph_general_area: of a strip between two heights. */
double ph_general_area(const struct ph_strip *strip, const double height[2]);

/*
 * ph_general_flat: samples of the development of a strip, chords between which
 * leave it by less than the tolerance.
 *
 * ret  PH_OK | PH_E_LIMIT | PH_E_NO_MEMORY
 */
enum ph_status ph_general_flat(struct ph_strip *strip, double tolerance,
                               struct ph_arena *arena, struct ph_diag *diag);

#endif
