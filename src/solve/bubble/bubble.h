/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Bubble patches: a smooth surface over a mesh of quadrilaterals, a patch for
 * each face, each from what is near it alone [BYR11, ch. 6]; curve/surface/
 * ribbon.h says what they are.
 *
 *   data.c    the mesh of a problem, and its normals
 *   subdivide.c  steps of Catmull and Clark before
 *   fit.c     a quadric at each point
 *   blend.c   derivatives across sides as polynomials
 *   patch.c   four sides into control points
 *   build.c   all patches into a surface, and what is told of it
 *   method.c  the fields
 *
 * All lengths are at unit scale: those of the data times 2^exponent.
 */
#ifndef PH_SOLVE_BUBBLE_BUBBLE_H
#define PH_SOLVE_BUBBLE_BUBBLE_H

#include "base/diag.h"
#include "base/mem.h"
#include "curve/problem.h"
#include "curve/result.h"
#include "curve/surface/exact.h"
#include "kernel/pow2.h"
#include "kernel/quad.h"

/* ---- data ---------------------------------------------------------------- */

/* What the fields are where they are absent. */
#define PH_BUBBLE_TOLERANCE 1e-6

/* Of blending functions: that of the field degree, auto: from the first on by
 * steps of 2. */
enum { PH_BLEND_FIRST = 9, PH_BLEND_MAX = 31 };

struct ph_bubble_data {
  struct ph_mesh mesh;
  struct ph_quadric *at; /* [mesh.points_n] points and unit normals */
  size_t continuity;     /* 0, 1 or 2 */
  size_t degree;         /* 0: auto, */
  bool exact;            /* or none at all */
  double tolerance;
  size_t subdivide; /* steps */
  bool fixed;       /* the boundary is, of these */
  int exponent;
};

/*
 * ph_bubble_data_of: checks the fields of a problem; normals that are not given
 * are those of the faces around each point.
 *
 * ret  PH_OK | PH_E_BAD_SHAPE | PH_E_BAD_VALUE | PH_E_COINCIDENT_POINTS |
 *      PH_E_ZERO_TANGENT | PH_E_NO_MEMORY
 */
enum ph_status ph_bubble_data_of(const struct ph_problem *problem,
                                 struct ph_arena *arena,
                                 struct ph_bubble_data *data,
                                 struct ph_diag *diag);

/* ---- subdivision --------------------------------------------------------- */

/* Polygons: face f has the points corner[first[f]] to corner[first[f + 1] - 1].
 */
struct ph_polygons {
  size_t points_n, faces_n;
  size_t *first, *corner;
  double (*x)[6]; /* points, and normals or zeros */
};

/* The most steps: each makes four faces of one. */
enum { PH_SUBDIVIDE_MAX = 10 };

/*
 * ph_bubble_subdivide: one step of Catmull and Clark (subdivide.c).
 *
 * in   fixed  points at boundaries stay
 * out  to     quadrilaterals; four for each of these, n for an n-gon
 * ret  PH_OK | PH_E_BAD_VALUE (an edge of three faces) | PH_E_NO_MEMORY
 */
enum ph_status ph_bubble_subdivide(const struct ph_polygons *from, bool fixed,
                                   struct ph_arena *arena,
                                   struct ph_polygons *to,
                                   struct ph_diag *diag);

/* ---- quadrics ------------------------------------------------------------ */

/*
 * ph_bubble_fit: the Hessians of the quadrics at all points: those of least
 * norm that fit best, by points and normals, what shares a face with each; the
 * same after rotation and scaling.
 *
 * ret  PH_OK | PH_E_NO_CONVERGENCE (of the singular values at a point)
 *      | PH_E_NO_MEMORY
 */
enum ph_status ph_bubble_fit(struct ph_bubble_data *data,
                             struct ph_arena *scratch, struct ph_diag *diag);

/* ---- blending functions -------------------------------------------------- */

/*
 * Derivatives across a side are quotients of high degree; those of patches are
 * polynomials that have the same derivatives along the side at both ends, of
 * orders up to the continuity, and are else the nearest in the least squares
 * sense at the nodes of a Gauss rule.
 */
struct ph_blend {
  size_t degree;
  const double *fixed; /* [nodes][2 (n + 1)] of the coefficients at the ends */
  const double *free;  /* [degree - 2 n - 1][nodes] from residuals to inner */
  const double *inner; /* [nodes][degree - 2 n - 1] and back */
  const double *elevate; /* [degree + 1][4 n + 2] of heights */
  const double *hermite; /* [n + 1][degree + 1]: the polynomial of degree
                            2 n + 1 that has Taylor coefficient j = 1 at 0 */
};

/* What blending functions of one continuity share: made as they are needed. */
struct ph_blends {
  size_t continuity;
  struct ph_arena *arena;
  struct ph_blend of[PH_BLEND_MAX + 1]; /* by degree; degree 0: not yet made */
  struct ph_quad gauss;
  struct ph_ribbon_rows *rows[2]; /* at the nodes of both rules */
};

/* Nodes of a Gauss rule, and of the same on both halves, for high degrees. */
enum { PH_BLEND_NODES = PH_QUAD_MAX, PH_BLEND_MORE = 2 * PH_QUAD_MAX };

/* ph_blend_rule: which of both rules a degree has, 0 or 1. */
static inline size_t ph_blend_rule(size_t degree) {
  return degree > 15;
}
static inline size_t ph_blend_nodes(size_t rule) {
  return rule ? PH_BLEND_MORE : PH_BLEND_NODES;
}

/* ph_blends_begin: ret PH_OK | PH_E_NO_MEMORY */
enum ph_status ph_blends_begin(struct ph_blends *blends, size_t continuity,
                               struct ph_arena *arena, struct ph_diag *diag);

/* ph_blend_of: that of a degree; NULL: no memory. */
const struct ph_blend *ph_blend_of(struct ph_blends *blends, size_t degree);

/*
 * ph_blend_fit: a derivative across a side as a polynomial.
 *
 * in   ends[2][n + 1]  its Taylor coefficients at both ends, inwards
 * in   at[nodes]       its values at the nodes
 * out  c[degree + 1]   Bernstein coefficients
 * out  miss[nodes]     what is left at the nodes
 */
void ph_blend_fit(const struct ph_blend *blend, size_t continuity,
                  const double ends[2][PH_CROSS_MAX], const double *at,
                  double *c, double *miss);

/* ---- patches ------------------------------------------------------------- */

/* A patch on its way. */
struct ph_blend_side {
  double at[PH_CROSS_MAX][PH_BLEND_MORE];
  double tilt[PH_BLEND_MORE], across[PH_BLEND_MORE];
  double c[PH_CROSS_MAX][PH_BLEND_MAX + 1];
};

struct ph_bubble_patch {
  struct ph_exact_patch exact;
  struct ph_blend_side blend[4];
};

/*
 * ph_bubble_patch_fit: the degree of its blending functions, and these.
 *
 * in   degree     0: the first for which tangent planes along the sides are
 *                 within a quarter of the tolerance, and curvatures within
 *                 PH_BUBBLE_CURVATURE times that
 * out  degree     PH_BLEND_MAX + 2: none is
 * ret  PH_OK | PH_E_NO_MEMORY
 */
enum ph_status ph_bubble_patch_fit(struct ph_bubble_patch *patch,
                                   struct ph_blends *blends, double tolerance,
                                   size_t *degree, double *miss,
                                   struct ph_diag *diag);

/* Curvatures may jump by so many times the tolerance, over the length of the
 * edge. */
enum { PH_BUBBLE_CURVATURE = 1000 };

/* ph_bubble_patch_points: its control points, (degree + 2)^2 of them; of
 * continuity 0, four.
 * in   net[(degree + 1)^2]  room
 * out  points[][3]          at unit scale */
void ph_bubble_patch_points(const struct ph_bubble_patch *patch,
                            const struct ph_blend *blend, double *net,
                            double *points);

/* ---- surfaces ------------------------------------------------------------ */

/*
 * ph_bubble_build: the surface of a result, its area and volume, diagnostics of
 * the solver, and warnings.
 *
 * ret  PH_OK | PH_E_BAD_VALUE (normals of an edge) | PH_E_NO_CONVERGENCE (no
 *      degree is high enough) | PH_E_NO_MEMORY
 */
enum ph_status ph_bubble_build(struct ph_bubble_data *data,
                               struct ph_arena *arena, struct ph_arena *scratch,
                               struct ph_result *result, struct ph_diag *diag);

#endif
