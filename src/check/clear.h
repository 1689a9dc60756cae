/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * How near a curve comes to places, by the boxes of its control points, and by
 * chords: between parameters h apart a segment is no further from its chord
 * than M h^2 / 8, with M the largest |r''|.
 */
#ifndef PH_CHECK_CLEAR_H
#define PH_CHECK_CLEAR_H

#include "check/segment.h"

struct ph_check_tree {
  const struct ph_check *v;
  struct ph_check_box {
    double low[2], high[2];
  } * boxes;
  double *bend; /* [segments] M */
  struct ph_check_segment segment;
};

/* ph_check_tree_of: ret PH_OK | PH_E_NO_MEMORY */
enum ph_status ph_check_tree_of(const struct ph_check *v,
                                struct ph_check_tree *tree);

/*
 * ph_check_nearer: by how much a point of the curve is nearer to a place than a
 * distance; 0 where none is by more than the tolerance.
 */
double ph_check_nearer(struct ph_check_tree *tree, ph_vec3 place,
                       double distance, double tolerance);

#endif
