/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Bubble patches as the quotients that they are (ribbon.h): the height over a
 * face is the Coons patch of its four sides [BYR11, (6.24)],
 *
 *   h(u,v) = sum_kj H_kj(v) S_kj(u) + sum_kj H_kj(u) T_kj(v)
 *            - sum_kilj H_ki(u) H_lj(v) h_ij(k,l),
 *
 * with S_kj the Taylor coefficient j of h by v along the side v = k, T_kj the
 * same by u along u = k, h_ij(k,l) both at corners, and the polynomials H_kj of
 * degree 2 n + 1 that have the Taylor coefficient j = 1 at k, and none else up
 * to n at 0 and 1; n is the continuity.
 *
 * All is at unit scale.
 */
#ifndef PH_CURVE_SURFACE_EXACT_H
#define PH_CURVE_SURFACE_EXACT_H

#include "curve/surface/mesh.h"
#include "curve/surface/patch.h"
#include "curve/surface/ribbon.h"

/* What all patches of a surface are made of. */
struct ph_patchwork {
  struct ph_mesh mesh;
  const struct ph_quadric *at;     /* [mesh.points_n] */
  const struct ph_ribbon *ribbons; /* [mesh.edges_n]; continuity 0: NULL */
  size_t continuity;
  int exponent; /* lengths are those of the data times 2^exponent */
};

/*
 * A patch: sides 0 and 1 at v = 0 and 1, along u; 2 and 3 at u = 0 and 1, along
 * v; corners k + 2 l at u = k, v = l.
 */
struct ph_exact_patch {
  size_t continuity;
  struct ph_quadric corner[4];
  struct ph_side side[4];
  /* Taylor coefficients of the height at the corners, of u^i v^j */
  double jet[4][PH_CROSS_MAX][PH_CROSS_MAX];
};

/* ph_side_corner: the corner at an end, 0 or 1, of side k. */
static inline size_t ph_side_corner(size_t k, size_t end) {
  return k < 2 ? 2 * k + end : k - 2 + 2 * end;
}

/* ph_exact_begin: the patch of a face. */
void ph_exact_begin(const struct ph_patchwork *work, size_t face,
                    struct ph_exact_patch *patch);

/* What is the same of all patches at a parameter. */
struct ph_exact_rows {
  double at;
  struct ph_ribbon_rows ribbon;
  /* Taylor coefficients of H_kj: [k][j][order] */
  double hermite[2][PH_CROSS_MAX][PH_CROSS_MAX];
};

void ph_exact_rows_at(size_t continuity, double at, struct ph_exact_rows *rows);

/* ph_exact_cross: sides 2 d and 2 d + 1 of a patch at a parameter. */
void ph_exact_cross(const struct ph_exact_patch *patch, size_t d,
                    const struct ph_exact_rows *rows, struct ph_cross cross[2]);

/* ph_exact_jet_at: the place at u and v.
 * in  by_u, by_v  as of ph_exact_cross, of d = 0 at u and of d = 1 at v */
void ph_exact_jet_at(const struct ph_exact_patch *patch,
                     const struct ph_exact_rows *u,
                     const struct ph_cross by_u[2],
                     const struct ph_exact_rows *v,
                     const struct ph_cross by_v[2], struct ph_patch_jet *jet);

#endif
