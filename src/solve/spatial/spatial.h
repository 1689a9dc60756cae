/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Internal declarations of the method `spatial-hermite`. */
#ifndef PH_SOLVE_SPATIAL_SPATIAL_H
#define PH_SOLVE_SPATIAL_SPATIAL_H

#include "base/diag.h"
#include "base/mem.h"
#include "base/status.h"
#include "curve/problem.h"
#include "curve/result.h"
#include "kernel/atph.h"
#include "kernel/quat.h"
#include "kernel/vec3.h"

#include <stdbool.h>
#include <stddef.h>

/* ---- the family of one segment ------------------------------------------- */

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

/* The data of a segment at unit scale: |dp| about 1. */
struct ph_spatial_data {
  ph_vec3 dp;       /* from the first point to the last */
  ph_vec3 ti, tf;   /* unit tangents */
  double ni, nf;    /* |Di|, |Df|: derivatives by u in [0,1] */
  double noise;     /* what rounding of the points can make of dp */
  double planarity; /* out of a plane by less of |dp|: in the plane */
  ph_vec3 normal;   /* unit, of the plane of all data; 0: they have none */
};

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

/*
 * ph_spatial_family_round: a family whose invariants have few digits, and
 * whose |dp| is 1: what rounding leaves of the same data moved or scaled does
 * not show.  Flat data stay as they are, as they may be flat by little.
 *
 * Its members are those of the family, by b and phi, nearly.
 */
void ph_spatial_family_round(struct ph_spatial_family *family);

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

/* ---- shape --------------------------------------------------------------- */

/*
 * The shape of a spatial Hermite segment: whether it bends and twists as its
 * data do, and the tension at which it does [FAR15, sec. 2 and 4].
 *
 * With g1, ..., g5 the legs of the control polygon, Ni = ti x dp, Nf = dp x tf
 * and tau = [ti, dp, tf], the constraints are
 *
 *   [g1, g2, Ni] > 0 and [g4, g5, Nf] > 0     [FAR15, (21)]              (1)
 *   torsion(u) tau > 0 for all u in [0,1]                                 (2)
 *
 * (1) says how the curve leaves its ends.  (2) is exact, where [FAR15, (22)]
 * is sufficient: the torsion has the sign of
 *
 *   N = sigma Im(conj(z) z') + 2 x |z|^2                                  (3)
 *
 * of curve/segment/seg3.h, a form of degree 6 in S0 and S1 (kernel/form.h),
 * which is written out in shape.c.
 *
 * A constraint is void where the data give no sign: (1) at an end whose tangent
 * is parallel to dp, (2) where they are planar.  In the place of (2), the curve
 * has to be in their plane then, with normal n, unless they are straight:
 *
 *   g2.n = g4.n = 0                                                     (4)
 */

/* Constraints, as the bits of a set. */
enum {
  PH_SHAPE_START = 1,   /* convexity (1) at the start */
  PH_SHAPE_END = 2,     /* convexity (1) at the end */
  PH_SHAPE_TORSION = 4, /* (2) */
  PH_SHAPE_PLANE = 8,   /* (4) */
  PH_SHAPE_NOTHING = 16 /* the choice has no segment at a reduced tension */
};

/* ph_spatial_constraints: those that are not void for the data. */
unsigned ph_spatial_constraints(const struct ph_spatial_family *family);

/*
 * ph_spatial_violations: those of ph_spatial_constraints that a member of the
 * family breaks.
 *
 * in   a[3]  its preimage (ph_spatial_preimage)
 */
unsigned ph_spatial_violations(const struct ph_spatial_family *family,
                               const ph_quat a[3]);

/* ph_spatial_torsion_form: sinc^3 / 4 times (3), sinc > 0 that of the space.
 * out form[7]  in S0 and S1 */
void ph_spatial_torsion_form(const struct ph_atph *space, const ph_quat a[3],
                             double form[7]);

/* ph_spatial_is_forward: (ti + tf).dp > 0 [FAR15, (52)].  With
 * ph_spatial_is_acute, CC keeps the shape if the tension is small enough. */
static inline bool ph_spatial_is_forward(const struct ph_spatial_data *data) {
  return ph_vec3_dot(ph_vec3_add(data->ti, data->tf), data->dp) > 0;
}

/* ph_spatial_is_acute: ti.tf > 0 [FAR15, (59)]. */
static inline bool ph_spatial_is_acute(const struct ph_spatial_data *data) {
  return ph_vec3_dot(data->ti, data->tf) > 0;
}

/* A segment that was chosen. */
struct ph_spatial_fit {
  struct ph_spatial_family family;
  struct ph_spatial_member member;
  int functional;    /* 1, 2, 3: the F that is least; 0: none is sought */
  bool cut_short;    /* others may be fairer: not all were looked for */
  ph_quat a[3];      /* preimage in the frame of the data */
  unsigned violated; /* constraints */
};

/*
 * How a member of a family is chosen: a criterion, or given angles.
 *
 * io   fit      family, of the data at some tension; a criterion that chooses
 *               the space too changes it (ph_spatial_family_space)
 * out  fit      member, and functional unless it is 0
 * in   context  what else it needs, such as where to start
 * ret  another status than PH_OK ends the search for a tension, but
 *      PH_E_INFEASIBLE and PH_E_NO_CONVERGENCE only where it is not reduced:
 *      there is no segment then
 */
typedef enum ph_status ph_spatial_choice(struct ph_spatial_fit *fit,
                                         void *context);

/* ph_spatial_fit_of: the segment chosen for some data, and its violations. */
enum ph_status ph_spatial_fit_of(const struct ph_spatial_data *data,
                                 const struct ph_atph *space,
                                 ph_spatial_choice *choose, void *context,
                                 struct ph_spatial_fit *fit);

/* What ph_spatial_tension finds. */
struct ph_spatial_tension {
  struct ph_spatial_fit fit;
  double factor;    /* on the tension: |Di| and |Df| are its square times those
                       of the data; 1 unless the tension was reduced */
  unsigned without; /* constraints violated for the factor 1 */
  size_t tried;     /* segments chosen */
};

/*
 * ph_spatial_tension: the segment at the largest tension, not above that of the
 * data, at which it violates nothing.
 *
 * Powers of 0.95 are tried as factors down to 1/64, then the last interval is
 * narrowed to the tolerance, and the factor is reduced by as much: what holds
 * need not hold for all factors below, so that this is the definition of the
 * result.
 *
 * in   data       ni and nf at the initial tension
 * in   space      where the choice starts
 * in   tolerance  of factors: how well the choice lets them be told
 * ret  PH_OK, also where no factor is found: then fit is that of the factor 1,
 *      and fit.violated == without > 0; or the status of a choice that failed
 */
enum ph_status ph_spatial_tension(const struct ph_spatial_data *data,
                                  const struct ph_atph *space,
                                  ph_spatial_choice *choose, void *context,
                                  double tolerance,
                                  struct ph_spatial_tension *tension);

/* ---- the criteria HC and BV ---------------------------------------------- */

/*
 * Criteria that choose a member of a family by an extremum [FAR15, sec. 6]:
 * the longest curve (HC), and the middle coefficient of the preimage nearest to
 * the mean of the outer ones (BV).  For CC see above.
 *
 * In both the best phi for a given b is 0, and what remains is a function of b
 * alone.  For plane data these are chosen among the curves in their plane, b =
 * 0 and b = pi.
 */

/*
 * ph_spatial_hc: the member with the greatest arc length.
 *
 * All stationary points of the length are roots of a quartic in tan(b/2), and
 * all of these are found: the maximum is global.
 */
struct ph_spatial_member ph_spatial_hc(const struct ph_spatial_family *family);

/*
 * ph_spatial_bv: the member with the least |A1 - (A0 + A2) / 2|.
 *
 * Local minima are bracketed by 64 values of b; two that lie between the same
 * two of these could be missed.
 */
struct ph_spatial_member ph_spatial_bv(const struct ph_spatial_family *family);

/* ---- tangents ------------------------------------------------------------ */

/*
 * Unit tangents at points in space, from the points alone.
 *
 * At p[j] the tangent of the circle through p[j-1], p[j], p[j+1] is taken: with
 * d[j] = p[j+1] - p[j] and h[j] = |d[j]|, the direction of
 *
 *   (h[j] / h[j-1]) d[j-1] + (h[j-1] / h[j]) d[j]                         (1)
 *
 * Sums of d[j-1] and d[j] with positive factors have the shape of the polygon,
 * whatever the factors: [FAR15, (63)] holds identically.  An open polygon is
 * continued at its ends by the mirror image of the third point in the plane
 * that bisects the first chord, so that t[0] is the mirror image of t[1] and
 * the ends are those of plane arcs.  Two points have the tangents of the chord.
 *
 * (1) vanishes where the polygon turns back on itself with equal chords.  The
 * tangent is normal to them there, to the side from which the polygon comes and
 * to which it goes on; to the former if these are opposite, and on a straight
 * line to some side.
 */

/*
 * ph_spatial_tangents: unit tangents at n >= 2 points.
 *
 * The tangents turn with the points, change their signs when the points are
 * reversed, and do not depend on the scale; scaling by powers of two keeps
 * every digit.  Where a polygon turns back and no side is distinguished, the
 * choice depends on the axes.  Points of a plane have tangents in that plane,
 * exactly so where z = 0.  O(n).
 *
 * in   points[n][dimension]  finite; neighbours (if closed, also the last and
 * the first) differ by more than rounding of the largest one; of 2 coordinates:
 * z = 0 out  tangents[n]
 */
void ph_spatial_tangents(const double *points, size_t n, size_t dimension,
                         bool closed, ph_vec3 *tangents);

/* ---- data ---------------------------------------------------------------- */

/*
 * The data of spatial Hermite interpolation: points, tangents, derivatives,
 * knots, alpha and tensions of a problem, checked, with what is absent filled
 * in by its rule.
 */

struct ph_spatial_points {
  size_t n;        /* segments */
  size_t points_n; /* n if closed, else n + 1 */
  bool closed;
  bool atph;
  bool derivatives; /* given: what ends have is a promise */
  bool estimated;   /* tangents, from the points */
  double planarity;
  ph_vec3 normal;       /* unit, of the plane of all data; 0: they have none */
  const double *points; /* [points_n][dimension], those of the problem */
  size_t dimension;     /* 2: in the plane z = 0; or 3 */
  ph_vec3 *tangents;    /* [points_n], unit */
  double *speeds;       /* [points_n] |derivative|, or NULL */
  double *knots;        /* [n + 1] */
  double *lambda;       /* [n] |Di| and |Df| at tension 1; NULL: the chords */
  double *tension;      /* [n] initial s, or NULL: everywhere */
  double same;          /* this */
  double *alpha;        /* [n]; NULL: 0, or to be chosen */
};

/*
 * ph_spatial_points_of: reads and checks a problem.
 *
 * in   keep  memory of the knots; arena  of all else
 * ret  PH_OK | PH_E_TOO_FEW_POINTS | PH_E_COINCIDENT_POINTS | PH_E_BAD_SHAPE |
 *      PH_E_BAD_VALUE | PH_E_ZERO_TANGENT | PH_E_TOO_LARGE | PH_E_NO_MEMORY
 */
enum ph_status ph_spatial_points_of(const struct ph_problem *problem,
                                    struct ph_arena *keep,
                                    struct ph_arena *arena,
                                    struct ph_spatial_points *points,
                                    struct ph_diag *diag);

/* ph_spatial_warn_reversals: where the data turn back, of tangents that were
 * found others are as good. */
void ph_spatial_warn_reversals(const struct ph_spatial_points *points,
                               struct ph_result *result);

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

/* ph_spatial_double: data twice as large where the largest coordinate of dp is
 * below 1/4.  What is done with them is then the same, to the last digit, for
 * the user's times any power of two: of ph_spatial_segment, times any of four.
 * ret  1 | 2 */
double ph_spatial_double(struct ph_spatial_data *data);

/* ---- the curve ----------------------------------------------------------- */

/* What was chosen for a segment. */
struct ph_spatial_chosen {
  const struct ph_spatial_fit *fit;
  double root,
      twice; /* unit scale = the user's times root^2, and twice: 1, 2 */
  double tension;
  double angles[2]; /* as the record has them, NaN: there are none */
};

/* ph_spatial_tension_of: initial s of segment k. */
static inline double
ph_spatial_tension_of(const struct ph_spatial_points *points, size_t k) {
  return points->tension ? points->tension[k] : points->same;
}

/* ph_spatial_curve_alloc: a curve of p->n segments with their knots.
 * ret  PH_OK | PH_E_NO_MEMORY */
enum ph_status ph_spatial_curve_alloc(const struct ph_spatial_points *p,
                                      struct ph_arena *arena,
                                      struct ph_curve *curve,
                                      struct ph_diag *diag);

/*
 * ph_spatial_put: puts segment k into the curve, after segments 0..k-1.
 *
 * The Euler-Rodrigues frame goes on where the segment before left it: the
 * preimage is turned by the free factor exp(x i) at the right.  In the first
 * point it is upright (solve/common/frame.h).
 *
 * inout end  A at the end of the segment before, and of this one, of any size
 * ret   by how much the segment misses its last point, relative to its size
 */
double ph_spatial_put(const struct ph_spatial_points *p, size_t k,
                      const struct ph_spatial_chosen *chosen, ph_quat *end,
                      struct ph_curve *curve);

#endif
