/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Surfaces of Bezier patches, as checks see them: each patch by its control
 * points, and by the points of the mesh that its corners are.
 *
 * Of a side, three layers of control points say what is along it and across:
 * the boundary, the tangent plane, the second fundamental form.
 */
#ifndef PH_CHECK_BUBBLE_H
#define PH_CHECK_BUBBLE_H

#include "check/checks.h"

/* A side of a patch: from one point of the mesh to another. */
struct ph_check_side {
  size_t low, high; /* these points, the smaller number first */
  size_t patch, k;  /* side k is from vertex k to the next */
};

/* An edge of two patches, and what these differ by there: normals, and second
 * fundamental forms. */
struct ph_check_seam {
  size_t low, high;
  size_t side; /* the first of both, in sides */
  double length;
  double gap;
  double value[2], noise[2]; /* at most, and how uncertain that is */
  double worst[2], doubt[2]; /* where it exceeds by most what is allowed */
};

/* A place of a patch: derivatives to the order 2, by u and v. */
struct ph_check_place {
  ph_vec3 x[3][3];
};

/* Control points by one parameter at most; of points, in the rounding of
 * coordinates. */
enum { PH_CHECK_PATCH_MOST = 64, PH_CHECK_PATCH_ROUND = 64 };

/* What the checks of such a surface share. */
struct ph_check_patchwork {
  struct ph_check *v;
  const struct ph_curve *curve;
  size_t *edges; /* [4 curve.n] of exact patches: which edge of the record a
                    side has; else NULL */
  struct ph_check_side *sides; /* [4 curve.n] in order of their points */
  struct ph_check_seam *seams; /* [seams_n] in the same order */
  size_t seams_n;
  bool closed;   /* every edge has two patches, */
  bool oriented; /* which run along it in opposite directions */
  double jump_allowed, bend_allowed; /* infinite: any */
  /* as of a certificate; reported: the largest of all */
  struct ph_check_error normal, jump, bend;
};

/* ph_check_patch_point: the point of vertex k of patch i, in the unit of the
 * data. */
const double *ph_check_patch_point(const struct ph_curve *curve, size_t i,
                                   size_t k);

/* ph_check_patch_where: where a patch is told. */
struct ph_check_where ph_check_patch_where(const struct ph_check_patchwork *w,
                                           size_t patch);

/* ph_check_patch_sides: all sides in their order.  ret PH_OK | PH_E_NO_MEMORY
 */
enum ph_status ph_check_patch_sides(struct ph_check_patchwork *w);

/*
 * ph_check_patch_edges: what both patches of every edge share.
 *
 *   continuity_error  gaps along edges / size
 *   jump              the angle between the tangent planes at 16 places of an
 *                     edge, of all continuities
 *   bend              |S - S'| times the length of the edge, S the second
 *                     fundamental form as a symmetric tensor in space, of
 *                     continuity 1 and 2
 *
 * ret  PH_OK | PH_E_NO_MEMORY
 */
enum ph_status ph_check_patch_edges(struct ph_check_patchwork *w);

/* ph_check_patch_told: area, volume, degree and jumps as a record tells them.
 * ret  PH_OK | PH_E_NO_MEMORY */
enum ph_status ph_check_patch_told(struct ph_check_patchwork *w);

/* ph_check_patch_claim: samples and edges, as a record has them. */
void ph_check_patch_claim(struct ph_check_patchwork *w);

/* ph_check_patchwork: all of these, of the record of v; for verify.c.  ret
 * PH_OK | PH_E_NO_MEMORY */
enum ph_status ph_check_patchwork(struct ph_check *v);

#endif
