/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A drawing while it is made, for drawing.c and drawing_data.c.  Strokes grow
 * in a scratch arena and are copied to the drawing's when their size is known.
 */
#ifndef PH_PLOT_PEN_H
#define PH_PLOT_PEN_H

#include "curve/sample/sample.h"
#include "plot/drawing.h"

/* A drawing while it is made. */
struct ph_pen {
  struct ph_drawing *drawing;
  const struct ph_problem *problem;
  const struct ph_result *result;
  struct ph_arena scratch;
  ph_vec3 *points;  /* of the stroke that is being drawn, in scratch */
  ph_vec3 *handles; /* [2 n]: those of the cubic that ends in each point */
  size_t n, room, handles_room;
  bool curved;      /* some of it is no chord */
  bool box;         /* they count for the bounding box */
  bool failed;      /* for want of memory */
  double tolerance; /* of chords */
  double near;      /* of cubics */
  struct ph_diag *diag;
};

/* ph_pen_box: the bounding box holds the point, too. */
void ph_pen_box(struct ph_drawing *drawing, ph_vec3 p);

/* ph_pen_to: draws on to a point, unless the pen is there already. */
void ph_pen_to(struct ph_pen *pen, ph_vec3 p);

/*
 * ph_pen_along: draws on to the place u1 of a segment, by cubics from u0, where
 * the pen is.  They have the tangents of the curve at their ends, and are
 * halved until five places between are within half of pen->near, `depth' times
 * at most.
 * One that is then farther than a chord may be is drawn as a chord.
 */
void ph_pen_along(struct ph_pen *pen, const struct ph_sampler *sampler,
                  double u0, double u1, int depth);

/* ph_pen_lift: ends a stroke; what has no length is a stroke of two equal
 * points. */
void ph_pen_lift(struct ph_pen *pen, enum ph_stroke_role role, size_t index);

/* ph_pen_data: the ends of the intervals of the data, or the joints. */
void ph_pen_data(struct ph_pen *pen);

/* ph_pen_numbers: which of the given data n points are, where others were
 * joined to them. */
void ph_pen_numbers(struct ph_pen *pen, size_t n);

/* ph_pen_polygons: control polygons of all segments. */
void ph_pen_polygons(struct ph_pen *pen);

/* ph_pen_vectors: tangents or derivatives that are given; after the data. */
void ph_pen_vectors(struct ph_pen *pen);

/* ph_pen_vectors_n: how many of them there are at most. */
size_t ph_pen_vectors_n(const struct ph_pen *pen);

#endif
