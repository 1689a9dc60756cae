/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * One segment as its control points say it is, for u in [0,1], at unit scale:
 * points and derivatives.
 *
 * Of a polynomial or an ATPH segment the derivative is a form
 *
 *   r'(u) = sum_j h_j S0^(m-j) S1^j,  h_j = (p_(j+1) - p_j) / mu_j,     (1)
 *   mu_j = integral of S0^(m-j) S1^j over [0,1],
 *
 * with m the degree less 1 and S0 = 1 - u, S1 = u; ATPH: S0 = sin(a (1-u)/2) /
 * sin(a/2), S1 = sin(a u/2) / sin(a/2), whose products of degree m = 4 span
 * <1, sin t, cos t, sin 2t, cos 2t>, t = a u.  The B-basis of the control
 * points is that whose derivatives are these products, each of integral 1.
 *
 * A spherical segment is de Casteljau's algorithm by great circles
 * (spherical.h); its m is 0.
 */
#ifndef PH_CHECK_SEGMENT_H
#define PH_CHECK_SEGMENT_H

#include "check/note.h"

struct ph_check_kind;

enum { PH_CHECK_FORM_MAX = PH_CHECK_DEGREE_MAX };

/* Nodes: exact for degree 11, as |r'| has 4 and mu_j has 4; for angles below pi
 * 12 nodes reach rounding. */
enum { PH_CHECK_NODES_PH = 6, PH_CHECK_NODES_ATPH = 12 };

/* A space of r' and of preimages, at the nodes of a Gauss rule, which
 * integrates mu too. */
struct ph_check_space {
  size_t m;                /* degree of r' */
  double angle, c;         /* and its cos(angle / 2) */
  double normal[5];        /* binomial(m, j) */
  double mu[5], per_mu[5]; /* of (1), and 1 / mu */
  double weight[5];        /* normal mu: of |leg| for |r'| */
  double outer, inner; /* r''(0) = inner (p[2] - p[1]) - outer (p[1] - p[0]) */
  double leg[PH_CHECK_NODES_ATPH][5];    /* S0^(m-j) S1^j / mu_j */
  double square[PH_CHECK_NODES_ATPH][3]; /* S0^2, 2 c S0 S1, S1^2, or S0, S1 */
};

/* ph_check_space_of: the space of an angle in [0, pi), m = 2 or 4; any other
 * angle gives what no curve agrees with. */
struct ph_check_space ph_check_space_of(const struct ph_quad *rule, size_t m,
                                        double angle);

/* Terms of power series: a value and up to 3 derivatives. */
enum { PH_CHECK_JET = 4 };

struct ph_check_segment {
  const struct ph_check_kind *kind;
  size_t k;
  size_t m;                           /* degree of r' */
  bool plane;                         /* z is 0 */
  double angle;                       /* ATPH: a; else 0 */
  double unit;                        /* u to the local parameter: a; else 1 */
  ph_vec3 p[PH_CHECK_DEGREE_MAX + 1]; /* control points; of spherical
                                          segments on the unit sphere */
  ph_vec3 leg[PH_CHECK_FORM_MAX];     /* p_(j+1) - p_j */
  ph_vec3 h[PH_CHECK_FORM_MAX];       /* of (1) */
  double speed;   /* the largest coefficient of r', of the size of r' */
  double reach;   /* the rounding that may be in one of its coordinates */
  double noise;   /* by how much r' may be off, by rounding and because the
                     preimage that was meant is another */
  bool rooted;    /* the claimed preimage fits to rounding of these */
  double spacing; /* of its knots */
  ph_vec3 end[2]; /* the first and the last control point, and there */
  ph_vec3 first[2], second[2]; /* r' and r'' by u */
  ph_vec3 center;              /* of the sphere */
  double x[3];                 /* of spherical.h */
  double radius;
};

/* ph_check_load: segment k of the curve; all arrays are there (arrays.c). */
void ph_check_load(const struct ph_check *v, size_t k,
                   struct ph_check_segment *s);

/* ph_check_rounding: by how much r' of a segment may be off by rounding of the
 * coordinates. */
double ph_check_rounding(const struct ph_check *v,
                         const struct ph_check_segment *s);

/* ph_check_basis: S0 and S1 at u with their first n - 1 derivatives over
 * factorials, n <= PH_CHECK_JET.
 * out  series[2][PH_CHECK_JET] */
void ph_check_basis(double angle, double u, size_t n,
                    double series[2][PH_CHECK_JET]);

/* ph_check_jet: r', r'', ... by u.
 * out  jet[n]  n <= PH_CHECK_JET; of spherical segments n <= 2 */
void ph_check_jet(const struct ph_check_segment *s, double u, ph_vec3 *jet,
                  size_t n);

/* ph_check_point: r(u), from the nearer end: exact at u = 0 and u = 1. */
ph_vec3 ph_check_point(const struct ph_check *v,
                       const struct ph_check_segment *s, double u);

/* The same of forms (1), for their rows in kind.c. */
void ph_check_form_load(const struct ph_check *v, struct ph_check_segment *s);
void ph_check_form_jet(const struct ph_check_segment *s, double u, ph_vec3 *jet,
                       size_t n);
ph_vec3 ph_check_form_point(const struct ph_check *v,
                            const struct ph_check_segment *s, double u);

/* ph_check_uncertain: by how much derivative d >= 1 may be off. */
static inline double ph_check_uncertain(const struct ph_check_segment *s,
                                        size_t d) {
  double noise = s->noise;
  while (d-- > 1) {
    noise *= PH_CHECK_ROUND_NEXT;
  }
  return noise;
}

/*
 * ph_check_length_of: the length of the part [from,to] of a segment, by
 * adaptive quadrature to 1e-13 relative and what r' is uncertain by, where that
 * does not do in each place.
 *
 * ret  NaN where that is not reached
 */
double ph_check_length_of(const struct ph_check *v,
                          const struct ph_check_segment *s, double from,
                          double to);

#endif
