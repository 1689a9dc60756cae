/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * All PH quintic and ATPH segments that join two points in space with given end
 * derivatives: a family with two angles, (b, phi) [FAR15, sec. 4; GON18,
 * sec. 3.4].
 *
 * The data are seen from their own frame.  With unit tangents ti, tf at an
 * angle 2 psi of each other,
 *
 *   g+ = (ti + tf) / (2 cos psi),  g- = (tf - ti) / (2 sin psi),
 *   gh = g+ x g-                                                        (1)
 *
 * are the axes i, j, k, so that ti = (c, -s, 0) and tf = (c, s, 0) with
 * c = cos psi, s = sin psi.  The axis i of r' = A i A* is never opposite to a
 * tangent then, and no case is singular.
 *
 *   A0 = sqrt|Di| ni exp(-b/2 i),  A2 = sqrt|Df| nf exp(b/2 i)          (2)
 *   ni = cos(psi/2) i - sin(psi/2) j,  nf = cos(psi/2) i + sin(psi/2) j
 *   D i D* = d = d0 + 2 k m E(b),  E(b) = (cos b, 0, -s sin b)          (3)
 *   D = e A1 + m01 (A0 + A2) = D(0) exp(phi i)                          (4)
 *
 * where D(0) is the solution of (3) nearest to A0 + A2 (of plane data, of those
 * that lie in their plane where A0 and A2 do), m = sqrt(|Di| |Df|), and k,
 * d0 and e follow from the integrals of the basis (kernel/atph.h); the
 * identities are tested by t_spatial_family.c.  [FAR15] writes (alpha, beta),
 * [GON18] (theta, beta), with respect to an axis u of their own: see
 * ph_spatial_angles.
 */
#ifndef PH_SOLVE_SPATIAL_FAMILY_H
#define PH_SOLVE_SPATIAL_FAMILY_H

#include "kernel/atph.h"
#include "kernel/quat.h"

#include <stdbool.h>

/* The data of a segment at unit scale: |dp| about 1. */
struct ph_spatial_data {
  ph_vec3 dp;       /* from the first point to the last */
  ph_vec3 ti, tf;   /* unit tangents */
  double ni, nf;    /* |Di|, |Df|: derivatives by u in [0,1] */
  double noise;     /* what rounding of the points can make of dp */
  double planarity; /* out of a plane by less of |dp|: in the plane */
  ph_vec3 normal;   /* unit, of the plane of all data; 0: they have none */
};

/* ph_spatial_noise: what is no direction of dp, beyond doubt. */
double ph_spatial_noise(const struct ph_spatial_data *data);

/* ph_spatial_flatness: how far dp may be out of a plane that it is in. */
double ph_spatial_flatness(const struct ph_spatial_data *data);

/* The family of some data: frame and invariants. */
struct ph_spatial_family {
  struct ph_atph space;
  ph_vec3 axis[3];           /* g+, g-, gh */
  double c, s;               /* cos psi, sin psi */
  double half[2];            /* cos(psi/2), sin(psi/2) */
  double ni, nf, m;          /* |Di|, |Df|, their geometric mean */
  double root[2];            /* sqrt|Di|, sqrt|Df| */
  double h;                  /* |dp| */
  ph_vec3 dp;                /* in the frame, as all that follows */
  ph_vec3 sum;               /* Di + Df */
  double m00, m01, m02, m11; /* integrals of products of basis functions */
  double k;                  /* m01^2 - m02 m11 > 0 */
  double vanishing;          /* |d| that is 0 */
  ph_vec3 d0;                /* m11 dp + (m01^2 - m11 m00)(Di + Df) */
  double noise;              /* of dp, beyond doubt */
  double flatness;           /* noise, or what counts as such by planarity */
  bool planar;               /* s dp.gh is noise: b = 0 or b = pi is plane */
  bool flat;                 /* within the flatness in a plane, or on a line */
  bool has_plane;            /* flat, and it is known in which plane: */
  ph_vec3 normal;            /* of that plane, unit; gh of data on a line */
  double away;               /* how far the data leave it, of unit vectors */
  ph_cplx plane_b;           /* exp(i b) in that plane, up to its sign */
};

/* A member of a family: exp(i b) and exp(i phi). */
struct ph_spatial_member {
  ph_cplx b, phi;
};

/*
 * ph_spatial_family_of: the family of some data.
 *
 * in   data   dp, ni, nf > 0
 * in   space  of the preimage
 * ret  for parallel tangents g- is the direction of the part of dp normal to
 *      them, for opposite ones g+ is; where that vanishes too, any normal
 */
struct ph_spatial_family
ph_spatial_family_of(const struct ph_spatial_data *data,
                     const struct ph_atph *space);

/* ph_spatial_is_twisted: whether [ti, dp, tf] = -dp.(ti x tf) has a sign,
 * beyond the flatness; ti x tf is 2 s c gh. */
static inline bool
ph_spatial_is_twisted(const struct ph_spatial_family *family) {
  return family->s * family->c * fabs(family->dp.z) > family->flatness;
}

/* ph_spatial_family_space: the same data, another space of preimages. */
void ph_spatial_family_space(struct ph_spatial_family *family,
                             const struct ph_atph *space);

/* ph_spatial_d: d of (3). */
static inline ph_vec3 ph_spatial_d(const struct ph_spatial_family *f,
                                   ph_cplx b) {
  double k = 2 * f->k * f->m;
  return ph_vec3_of(f->d0.x + k * b.re, f->d0.y, f->d0.z - k * f->s * b.im);
}

/* ph_spatial_length: the exact arc length, which depends on b alone. */
double ph_spatial_length(const struct ph_spatial_family *family, ph_cplx b);

/*
 * ph_spatial_in_plane: whether data are flat, and b one of the two angles of
 * members in their plane: 0 or pi, up to the flatness of the data.
 *
 * out  angle  b; where it is one of these, without rounding of exp(i b)
 */
bool ph_spatial_in_plane(const struct ph_spatial_family *family, ph_cplx b,
                         double *angle);

/*
 * ph_spatial_is_plane: whether a curve leaves the plane of its data by no more
 * than a few times what these do.
 *
 * in   family  has_plane
 * in   a[3]    preimage of a member
 */
bool ph_spatial_is_plane(const struct ph_spatial_family *family,
                         const ph_quat a[3]);

/*
 * ph_spatial_preimage: the preimage of a member, in the frame of the data.
 *
 * out  a[3]  coefficients in the space, r' = A i A* by u in [0,1]
 */
void ph_spatial_preimage(const struct ph_spatial_family *family,
                         struct ph_spatial_member member, ph_quat a[3]);

/* Axes for angles. */
enum ph_spatial_axis {
  PH_SPATIAL_CHORD,   /* u = dp / |dp| [FAR15, (34)] */
  PH_SPATIAL_X,       /* u = i, the first coordinate [GON18] */
  PH_SPATIAL_BISECTOR /* (phi, b) themselves */
};

/*
 * ph_spatial_angles: theta (alpha in [FAR15]) and beta of a member.
 *
 *   A0 = sqrt|Di| ni exp((theta - beta/2) u),  A2 = sqrt|Df| nf exp((theta +
 *   beta/2) u),  D = sqrt|d| nd,  n. the bisector of u and its vector
 *
 * out  angles[2]  in (-pi, pi]
 * ret  false where a vector is opposite to the axis: there are none
 */
bool ph_spatial_angles(const struct ph_spatial_family *family,
                       struct ph_spatial_member member,
                       enum ph_spatial_axis axis, double angles[2]);

/* ph_spatial_member_of: the inverse of ph_spatial_angles. */
bool ph_spatial_member_of(const struct ph_spatial_family *family,
                          const double angles[2], enum ph_spatial_axis axis,
                          struct ph_spatial_member *member);

/*
 * ph_spatial_cc: the member of the criterion CC [FAR15, (25)-(32)]: a cubic
 * where the data are those of a PH cubic.  No trigonometric function is called.
 *
 * Discontinuous where ti = tf and dp is not parallel to them: b tends to a
 * right angle on either side.
 */
struct ph_spatial_member ph_spatial_cc(const struct ph_spatial_family *family);

#endif
