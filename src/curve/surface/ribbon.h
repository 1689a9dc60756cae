/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Bubble patches [BYR11, ch. 6]: what is known at the points of a mesh, along
 * its edges, and across them.
 *
 * A patch over the face V, W, Y, X is the graph of a height h over the bilinear
 * interpolants d of its points and n of its unit normals,
 *
 *   b(u,v) = d(u,v) + h(u,v) n(u,v).
 *
 * At a point is a quadric f(Z) = g.(Z - V) + (Z - V)^T H (Z - V) / 2 with the
 * unit gradient g, the normal of the point: around it, f = 0 is the surface
 * that is meant [BYR11, (6.1)].  Along an edge is a ribbon: a curve on the
 * surface, p(t) = (1-t) V + t W + h(t) ((1-t) g_V + t g_W), and along it a
 * gradient, which is normal to p', and for continuity 2 a Hessian.  Patches on
 * both sides follow it: their derivatives across have b_v . g = 0 and
 * b_v^T H b_v + g . b_vv = 0, and so they share tangent planes and curvatures.
 *
 * Height, gradient and Hessian of a ribbon are in Bernstein form, of degrees
 * 5 and 3 for continuity 1; 9, 7 and 5 for 2.  That gradient is corrected to
 * be normal to p', and that Hessian by (6.19) to agree with the change of the
 * gradient along p.
 */
#ifndef PH_CURVE_SURFACE_RIBBON_H
#define PH_CURVE_SURFACE_RIBBON_H

#include "kernel/vec3.h"

#include <stddef.h>

/* Symmetric: xx, yy, zz, xy, xz, yz. */
struct ph_sym3 {
  double c[6];
};

/* ph_sym3_apply: H x. */
static inline ph_vec3 ph_sym3_apply(const struct ph_sym3 *H, ph_vec3 x) {
  const double *c = H->c;
  return ph_vec3_of(c[0] * x.x + c[3] * x.y + c[4] * x.z,
                    c[3] * x.x + c[1] * x.y + c[5] * x.z,
                    c[4] * x.x + c[5] * x.y + c[2] * x.z);
}

/* A point with its quadric. */
struct ph_quadric {
  ph_vec3 p, g; /* g is a unit vector */
  struct ph_sym3 H;
};

enum {
  PH_RIBBON_ORDER = 2,    /* the highest continuity */
  PH_RIBBON_HEIGHT = 10,  /* most coefficients of the height, */
  PH_RIBBON_GRADIENT = 8, /* of the gradient, */
  PH_RIBBON_HESSIAN = 6,  /* of the Hessian */
  PH_CROSS_MAX = 3,       /* derivatives across, and along: of order 0 to 2 */
  PH_RIBBON_HEIGHT_ROWS = 5, /* Taylor rows that these take */
  PH_RIBBON_GRADIENT_ROWS = 4,
  PH_RIBBON_HESSIAN_ROWS = 3
};

/* In Bernstein form, from the start of an edge to its end. */
struct ph_ribbon {
  double height[PH_RIBBON_HEIGHT];
  double gradient[3][PH_RIBBON_GRADIENT];
  double hessian[6][PH_RIBBON_HESSIAN];
};

/* ph_ribbon_height_degree, ph_ribbon_gradient_degree: by the continuity; that
 * of the Hessian is 5. */
static inline size_t ph_ribbon_height_degree(size_t continuity) {
  return 4 * continuity + 1;
}
static inline size_t ph_ribbon_gradient_degree(size_t continuity) {
  return 4 * continuity - 1;
}

/* ph_ribbon_of: the ribbon from a to b, of continuity 1 or 2. */
void ph_ribbon_of(const struct ph_quadric *a, const struct ph_quadric *b,
                  size_t continuity, struct ph_ribbon *ribbon);

/* ph_ribbon_reverse: the same from b to a. */
void ph_ribbon_reverse(const struct ph_ribbon *ribbon, size_t continuity,
                       struct ph_ribbon *reversed);

/* What coefficients are multiplied by for their Taylor coefficients at a place
 * s of a ribbon. */
struct ph_ribbon_rows {
  double s;
  double height[PH_RIBBON_HEIGHT_ROWS][PH_RIBBON_HEIGHT];
  double gradient[PH_RIBBON_GRADIENT_ROWS][PH_RIBBON_GRADIENT];
  double hessian[PH_RIBBON_HESSIAN_ROWS][PH_RIBBON_HESSIAN];
};

/* ph_ribbon_rows_at: those for derivatives along the ribbon up to `order',
 * 0 to 2, of what is across. */
void ph_ribbon_rows_at(size_t continuity, double s, size_t order,
                       struct ph_ribbon_rows *rows);

/* One side of a patch: its ribbon, the points and normals at both ends, and
 * how these change to the opposite side. */
struct ph_side {
  struct ph_ribbon ribbon;
  ph_vec3 p[2], g[2];
  ph_vec3 to[2], turn[2];
};

/* What is at a place of a side, as Taylor coefficients: h[j][k] is that of w^j
 * s^k, w the parameter across. */
struct ph_cross {
  double h[PH_CROSS_MAX][PH_CROSS_MAX];
  double cosine; /* of gradient and interpolated normal */
  double speed;  /* |p'| */
  double tilt;   /* angle of the tangent plane about p' for each unit of h_w */
  double across; /* the part of b_w that is normal to p' */
};

/*
 * ph_side_at: of continuity 1 or 2, with derivatives along it up to `order';
 * infinite or NaN where the ribbon stands still or its gradient is normal to
 * the interpolated normal.
 */
void ph_side_at(const struct ph_side *side, size_t continuity,
                const struct ph_ribbon_rows *rows, size_t order,
                struct ph_cross *cross);

#endif
