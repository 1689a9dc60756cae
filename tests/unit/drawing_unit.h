/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Drawings made by hand, as ph_drawing_make makes them of results. */
#ifndef PH_TESTS_DRAWING_UNIT_H
#define PH_TESTS_DRAWING_UNIT_H

#include "plot/drawing.h"

/* What a drawing is of. */
struct unit_drawing {
  enum ph_space space;
  size_t segments;
  bool closed;
  bool polygon, tangents; /* one for each segment, point */
  size_t offsets;
  double turn;   /* angle of the arc that the curve is */
  double size;   /* its radius; on a sphere that of the sphere */
  ph_vec3 place; /* of its center */
};

/*
 * unit_drawing: an arc of a circle about the z axis; in space of a helix; on
 * the sphere the parallel of z = 0.2.  Fails the test when memory
 * is exhausted.
 *
 * ret  to be freed by ph_drawing_free
 */
struct ph_drawing *unit_drawing(const struct unit_drawing *of);

#endif
