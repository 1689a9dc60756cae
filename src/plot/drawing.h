/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * What a result looks like: polylines and profiles in the unit of the data,
 * kept after the record that they are of has gone.  No library is involved.
 */
#ifndef PH_PLOT_DRAWING_H
#define PH_PLOT_DRAWING_H

#include "base/diag.h"
#include "base/mem.h"
#include "curve/problem.h"
#include "curve/result.h"
#include "kernel/vec3.h"

enum ph_drawing_space { PH_DRAWING_PLANE, PH_DRAWING_SPACE, PH_DRAWING_SPHERE };

/* What a stroke is. */
enum ph_stroke_role {
  PH_STROKE_CURVE,   /* one segment of the curve */
  PH_STROKE_POLYGON, /* its control polygon; on a sphere, of great circles */
  PH_STROKE_OFFSET,  /* one offset, from end to end */
  PH_STROKE_TANGENT  /* a given tangent or derivative: from its point on */
};

/* A polyline, fine enough to be drawn as it is. */
struct ph_stroke {
  enum ph_stroke_role role;
  size_t index; /* segment, offset or data point, from 0 */
  size_t n;
  ph_vec3 *points; /* z = 0 in the plane */
};

/* Curvature, and in space torsion, over arc length from the start: one for each
 * segment.  What is not defined is NaN. */
struct ph_profile {
  size_t n;
  double *s, *curvature, *torsion; /* torsion NULL in the plane, on a sphere */
};

/* One result. */
struct ph_drawing {
  struct ph_arena arena; /* holds all of it */
  const char *title;     /* id of the problem, or "record N" */
  const char *label;     /* "lengths[1] = 2.5", or NULL: no sweep */
  size_t record;         /* number of the problem: its sweep is one panel */
  enum ph_drawing_space space;
  bool closed;
  double center[3], radius;  /* of the sphere */
  ph_vec3 low, high;         /* bounding box of all but control polygons */
  struct ph_stroke *strokes; /* in the order in which they are drawn */
  size_t strokes_n;
  ph_vec3 *data; /* the points that the curve goes through */
  size_t data_n;
  struct ph_profile *profiles; /* [segments_n] */
  size_t segments_n;
  double length;
};

/* Names of a drawing. */
struct ph_drawing_names {
  const char *title, *label;
  size_t record;
};

/*
 * ph_drawing_make: draws a result.
 *
 * Curves and offsets are sampled so that chords leave them by no more than
 * 1/4000 of the size of the drawing.
 *
 * in   problem  tangents or derivatives of it are drawn
 * out  drawing  to be freed; NULL on failure
 * ret  PH_OK | PH_NO_MEMORY | what ph_sample_curve returns
 */
enum ph_status ph_drawing_make(const struct ph_problem *problem,
                               const struct ph_result *result,
                               const struct ph_drawing_names *names,
                               struct ph_drawing **drawing,
                               struct ph_diag *diag);

void ph_drawing_free(struct ph_drawing *drawing);

#endif
