/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Segments of PH curves in pieces over which rational curves along the normal
 * are written: offsets (offset.h) and images on the Blaschke cylinder
 * (blaschke.h).
 *
 * The weights of such a curve are the Bernstein coefficients of the parametric
 * speed sigma, raised to its degree: 9 for a quintic, 5 for a Tschirnhausen
 * cubic.  A segment that turns by more than about a half turn has weights that
 * are not positive.  It is cut, so that a renderer meets no pole and the convex
 * hull property holds: a quintic into halves and those into halves again; a
 * cubic once, at its vertex.  There its preimage is the foot m of the origin on
 * the line of w, and with <w0, m> = <m, w1> = |m|^2 both parts have positive
 * coefficients (|w0|^2, |m|^2, |m|^2) and (|m|^2, |m|^2, |w1|^2).
 */
#ifndef PH_CURVE_OFFSET_RATIONAL_H
#define PH_CURVE_OFFSET_RATIONAL_H

#include "base/diag.h"
#include "curve/result.h"
#include "curve/segment/seg3.h"

/*
 * A piece, in space; planar curves have z = 0.  Preimages are with respect to
 * the parameter of the segment.  Of cubics, arrays are filled to their degree.
 */
struct ph_rational {
  size_t degree;     /* of the points, n = 5 or 3; of what is written 2 n - 1 */
  size_t segment;    /* of the curve */
  double from, to;   /* the part of it, in its local parameter [0,1] */
  ph_quat a[3];      /* preimage, of degree (n - 1)/2 */
  ph_vec3 p[6];      /* control points */
  double unit;       /* the largest coefficient of sigma, which bounds it */
  double speed[5];   /* coefficients of sigma / unit, of degree n - 1 */
  double weight[10]; /* the same of degree 2 n - 1, all > 0 */
  const double *product; /* [n][n + 1]: how much coefficients j and i of degrees
                            n - 1 and n give to j + i of their product */
};

/* What is done with each piece. */
typedef void ph_rational_visit(void *context, const struct ph_rational *piece);

/*
 * ph_rational_walk: visits the pieces of segments first to end - 1 in order.
 *
 * in   curve  PH_CURVE_PH or PH_CURVE_TC
 * in   what   is written over them: for the message
 * ret  PH_OK | PH_E_INFEASIBLE (the curve stands still somewhere: no normal
 *      there; names the segment) | PH_E_TOO_LARGE (its speed; likewise)
 */
enum ph_status ph_rational_walk(const struct ph_curve *curve, size_t first,
                                size_t end, const char *what,
                                ph_rational_visit *visit, void *context,
                                struct ph_diag *diag);

/*
 * ph_rational_part: the same of a part of segment k, between two of its local
 * parameters; without a message.
 */
enum ph_status ph_rational_part(const struct ph_curve *curve, size_t k,
                                double from, double to,
                                ph_rational_visit *visit, void *context);

/* ph_rational_arc: the same of an arc round a point, as of a segment of degree
 * 5 or 3 that is this point: its preimage is linear between w. */
enum ph_status ph_rational_arc(size_t degree, ph_cplx point, const ph_cplx w[2],
                               ph_rational_visit *visit, void *context);

/*
 * ph_rational_points: control points and weights of the offset of a piece.
 *
 * out  p[2 degree][dimension], weights[2 degree]
 */
void ph_rational_points(const struct ph_rational *piece, enum ph_normal normal,
                        double distance, size_t dimension, double *p,
                        double *weights);

/*
 * ph_rational_turned: coefficients of A j A* or A k A*, in the B-basis of
 * products of two functions of the space of A.
 *
 * in   a[n]  n = 3: of the space with this c; n = 2: of degree 1
 * out  out[2 n - 1]
 */
void ph_rational_turned(enum ph_normal normal, const ph_quat *a, size_t n,
                        double c, ph_vec3 *out);

#endif
