/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Exact patches, recomputed from what a record has of them: the points and
 * normals of the mesh, and of each edge the Bernstein coefficients of height,
 * gradient and Hessian (curve/surface/surface.h) [BYR11, (6.19), (6.24)].
 *
 * With q = p' along the edge, n the normals between its ends, and d and e how
 * points and normals change to the opposite side,
 *
 *   g = g^ - (g^.q) q / q.q
 *   r = g' - H^ q,  H = H^ + (r q^T + q r^T) / q.q - (q.r) q q^T / (q.q)^2
 *   h_w = -(g.d + h g.e) / g.n,  b_w = d + h_w n + h e
 *   h_ww = -(b_w^T H b_w + 2 h_w g.e) / g.n
 *
 * and the height over the face is the Coons patch of all four sides.  Here
 * these are power series in the parameter, five terms of each; all is at unit
 * scale.
 */
#ifndef PH_CHECK_BUBBLE_EXACT_H
#define PH_CHECK_BUBBLE_EXACT_H

#include "check/bubble.h"

/* Coefficients of a record's edge, by its continuity at most. */
enum {
  PH_CHECK_HEIGHTS = 10,
  PH_CHECK_GRADIENTS = 8,
  PH_CHECK_HESSIANS = 6,
  PH_CHECK_ORDERS = 3, /* derivatives of the orders 0 to 2 */
  PH_CHECK_LIKE = 16   /* as polynomials of such degrees do, quotients round */
};

/* At a place of a side, the Taylor coefficients of w^j s^k of the height: s
 * along it, w across. */
struct ph_check_cross {
  double h[PH_CHECK_ORDERS][PH_CHECK_ORDERS]; /* [j][k] */
};

struct ph_check_strip {
  double height[PH_CHECK_HEIGHTS];
  double gradient[3][PH_CHECK_GRADIENTS];
  double hessian[6][PH_CHECK_HESSIANS];
  ph_vec3 p[2], g[2];     /* at both ends */
  ph_vec3 to[2], turn[2]; /* d and e there */
  struct ph_check_cross end[2];
};

/* A patch: corners k + 2 l at u = k, v = l; sides 0 and 1 at v = 0 and 1, along
 * u, sides 2 and 3 at u = 0 and 1, along v. */
struct ph_check_quotient {
  size_t continuity;
  ph_vec3 p[4], g[4];
  struct ph_check_strip side[4];
};

/* What depends on a parameter alone: the Taylor coefficients of the polynomials
 * of degree 2 n + 1 that have the Taylor coefficient j = 1 at an end. */
struct ph_check_node {
  double t;
  double hermite[2][PH_CHECK_ORDERS][PH_CHECK_ORDERS]; /* [end][j][order] */
};

/* ph_check_patch_strips: whether a record of exact patches has vertices and
 * edges that say what they are; sets w->edges, from w->sides.
 * ret  PH_OK | PH_E_NO_MEMORY */
enum ph_status ph_check_patch_strips(struct ph_check_patchwork *w, bool *good);

/* ph_check_quotient_begin: patch i of the record. */
void ph_check_quotient_begin(const struct ph_check_patchwork *w, size_t i,
                             struct ph_check_quotient *patch);

void ph_check_node_at(size_t continuity, double t, struct ph_check_node *node);

/* ph_check_quotient_cross: a side at a parameter; nothing of continuity 0. */
void ph_check_quotient_cross(const struct ph_check_quotient *patch, size_t side,
                             double t, struct ph_check_cross *cross);

/* ph_check_quotient_at: derivatives at (u, v).
 * in  by_u, by_v  sides 0 and 1 at u, sides 2 and 3 at v */
void ph_check_quotient_at(const struct ph_check_quotient *patch,
                          const struct ph_check_node *u,
                          const struct ph_check_cross by_u[2],
                          const struct ph_check_node *v,
                          const struct ph_check_cross by_v[2],
                          struct ph_check_place *place);

/* ph_check_quotient_place: the same of one place. */
void ph_check_quotient_place(const struct ph_check_quotient *patch, double u,
                             double v, struct ph_check_place *place);

#endif
