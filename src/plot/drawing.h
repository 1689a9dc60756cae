/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * What a result looks like: polylines and profiles in the unit of the data,
 * kept after the record that they are of has gone.  No library is involved.
 *
 * A drawing is bounded, whatever the curve: see the limits below.
 */
#ifndef PH_PLOT_DRAWING_H
#define PH_PLOT_DRAWING_H

#include "base/diag.h"
#include "base/mem.h"
#include "curve/problem.h"
#include "curve/result.h"
#include "kernel/vec3.h"
#include "plot/quilt.h"
#include "plot/sheet.h"

/*
 * Up to PH_DRAWING_SEGMENTS segments are drawn one by one.  Of more, so many
 * neighbours as are needed share a stroke and a profile that there are no more
 * than that of either, and there are no control polygons, data points and
 * tangents: nobody could tell them apart.
 *
 * Curves and offsets are cubics, which are halved until they are near enough or
 * there may be PH_DRAWING_POINTS of their control points, and chords where
 * there are more segments than a third of that; profiles have up to
 * PH_DRAWING_INTERVALS + 1 places a segment, fewer when there would be more
 * than PH_DRAWING_PLACES.  Of still more segments than these, every so many-th
 * counts, and what was trimmed of offsets is not drawn.
 */
enum {
  PH_DRAWING_SEGMENTS = 1000,
  PH_DRAWING_POINTS = 100000,
  PH_DRAWING_PLACES = 20000,
  PH_DRAWING_INTERVALS = 64
};

/* What a stroke is. */
enum ph_stroke_role {
  PH_STROKE_CURVE,   /* one segment of the curve, or more */
  PH_STROKE_POLYGON, /* its control polygon; on a sphere, of great circles */
  PH_STROKE_TRIMMED, /* a connected part of an offset that no loop has */
  PH_STROKE_OFFSET,  /* a connected part of an offset, from end to end */
  PH_STROKE_TANGENT, /* a given tangent or derivative: from its point on */
  PH_STROKE_N
};

/* A polyline, fine enough to be drawn as it is, or cubics from point to point.
 */
struct ph_stroke {
  enum ph_stroke_role role;
  size_t index; /* segment (the first of them), offset or data point, from 0 */
  size_t n;     /* 2 at least */
  ph_vec3 *points;  /* z = 0 in the plane; finite */
  ph_vec3 *handles; /* [2 (n - 1)]: the two inner control points of the cubic
                       from each point to the next; NULL: a polyline */
};

/* Curvature, and in space torsion, over arc length from the start of the curve:
 * of a segment, or of neighbours one after the other, with both ends of each.
 * What is not defined is NaN. */
struct ph_profile {
  size_t n;
  double *s, *curvature, *torsion; /* torsion NULL in the plane, on a sphere */
};

/* One result. */
struct ph_drawing {
  struct ph_arena arena; /* holds all of it */
  const char *title;     /* id of the problem, or NULL */
  const char *label;     /* "lengths[1] = 2.5", or NULL: no sweep */
  size_t record;         /* number of the problem: its sweep is one panel */
  enum ph_space space;
  bool closed;
  double center[3], radius;  /* of the sphere; radius 0: there is none */
  ph_vec3 low, high;         /* bounding box of all but control polygons and
                                what was trimmed */
  struct ph_stroke *strokes; /* in the order in which they are drawn: control
                                polygons, what was trimmed, offsets, the curve,
                                tangents */
  size_t strokes_n;
  ph_vec3 *data; /* [data_n], the points that the curve goes through */
  size_t data_n;
  size_t *numbers; /* [data_n] of the data, or of the elements of a surface,
                      where some were merged; or NULL */
  struct ph_profile *profiles; /* [segments_n] */
  size_t segments_n;           /* as many as strokes of the curve */
  struct ph_sheet *sheets; /* [sheets_n] of a surface: itself, then those that
                              are parallel to it; and no strokes and data */
  size_t sheets_n;
  const struct ph_quilt *quilt; /* of a surface of patches; and nothing else */
  double length;
  size_t places; /* points of strokes and places of profiles, all together */
};

/* Names of a drawing: UTF-8 without control characters, copied. */
struct ph_drawing_names {
  const char *title, *label;
  size_t record;
};

/*
 * ph_drawing_make: draws a result.
 *
 * Cubics leave curves and offsets by no more than 1e-6 of the size of the data
 * and the greatest offset, chords by 1/4000, within the limits above; a cubic
 * is drawn as itself.  Given tangents have one length, derivatives are in
 * proportion; on a sphere they follow great circles.  Surfaces have sheets, and
 * profiles of normal and of geodesic curvature, in the place of torsion.
 *
 * in   problem  tangents or derivatives of it are drawn
 * out  drawing  to be freed; NULL on failure
 * ret  PH_OK | PH_E_NO_MEMORY | what ph_sampler_enter returns
 */
enum ph_status ph_drawing_make(const struct ph_problem *problem,
                               const struct ph_result *result,
                               const struct ph_drawing_names *names,
                               struct ph_drawing **drawing,
                               struct ph_diag *diag);

/* ph_drawing_free: drawing may be NULL. */
void ph_drawing_free(struct ph_drawing *drawing);

#endif
