/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Whether a curve keeps a distance d from places beside it, at d n from its
 * points.
 *
 * Near the point, that follows from curvatures.  With the place at (0, d), the
 * point at 0, its tangent along x, and phi the angle of the tangent: as long as
 * |phi| < pi / 2, the curve has some y at each x, and
 *
 *   d (sin phi) / dx = kappa <= 1 / d,  so that  sin phi <= x / d       (1)
 *
 * where x > 0: it rises by no more than the circle round the place, and is not
 * within it; the same where x < 0.  So segments whose curvature is bounded so,
 * and which turn by little, need no more: the company of a segment.  Where they
 * meet, the tangent may jump, but to the side of the place only by rounding.
 *
 * For others there is a tree of boxes of control points, and chords: between
 * parameters h apart a segment is no further from its chord than M h^2 / 8,
 * with M the largest |r''|.
 */
#ifndef PH_CHECK_CLEAR_H
#define PH_CHECK_CLEAR_H

#include "check/segment.h"
#include "kernel/boxtree.h"

struct ph_check_tree {
  const struct ph_check *v;
  double distance, tolerance;
  struct ph_boxtree boxes;
  double *bend; /* [segments] M */
  struct ph_check_company {
    size_t before, after; /* segments up to it, and from it on; of one that is
                             none itself 0 */
  } * company[2];         /* [segments] of places to the left, to the right */
  struct ph_check_segment segment;
};

/*
 * ph_check_tree_of: the tree.
 *
 * in   tolerance  by which points may be nearer than the distance
 * ret  PH_OK | PH_E_NO_MEMORY
 */
enum ph_status ph_check_tree_of(const struct ph_check *v, double distance,
                                double tolerance, struct ph_check_tree *tree);

/*
 * ph_check_is_clear: whether no point of the curve is nearer to any place of a
 * box than the distance: places beside segment k, at the distance from points
 * of it along their normals.  If not, some may be.
 *
 * in   company  of segment k, to the side of the places
 */
bool ph_check_is_clear(const struct ph_check_tree *tree,
                       const struct ph_boxtree_node *box, size_t k,
                       const struct ph_check_company *company);

/*
 * ph_check_nearer: by how much a point of the curve is nearer to a place than
 * the distance, to half the tolerance; 0 where none is by more than 1.5 times
 * the tolerance; NaN of a place that is none.
 *
 * in   k, company  the same; or NULL: the place is any
 */
double ph_check_nearer(struct ph_check_tree *tree, ph_vec3 place, size_t k,
                       const struct ph_check_company *company);

#endif
