/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * SVG path data (SVG 1.1, sec. 8.3) as chains of Bezier curves.
 *
 * Lines, quadratic and cubic curves are given as they are.  An elliptical arc
 * is cut into pieces of a right angle or less, and each is the curve of degree
 * 15 that has the derivatives of the arc up to the seventh at both ends: with
 * the half angle a of the piece it is within a^16 / 16!, 1e-15 of the radius.
 */
#ifndef PH_IO_SVG_PATH_H
#define PH_IO_SVG_PATH_H

#include "base/diag.h"
#include "base/mem.h"
#include "curve/problem.h"

#include <stdbool.h>
#include <stddef.h>

/* A subpath that draws something. */
struct ph_trace_part {
  size_t piece, point; /* its first ones */
  bool closed;         /* by Z, or a shape that is */
};

/* What is drawn; {.arena, .affine} at first. */
struct ph_trace {
  struct ph_arena *arena;
  double affine[6]; /* a b c d e f: x' = a x + c y + e, y' = b x + d y + f */
  double *v;        /* [n][2] control points, transformed */
  size_t n, room;
  size_t *sizes; /* [pieces_n] points of each piece */
  size_t pieces_n, sizes_room;
  struct ph_trace_part *part; /* [parts_n] */
  size_t parts_n, parts_room;
  double at[2], start[2]; /* the pen, and the start of the subpath */
  bool drawing;           /* the last part goes on */
  bool failed;            /* memory is exhausted */
};

#define PH_TRACE_AS_IS \
  { 1, 0, 0, 1, 0, 0 }

/* Each goes on from the pen, which is moved; pieces that are a point are left
 * out.  Coordinates are absolute, before the transformation. */
void ph_trace_move(struct ph_trace *trace, double x, double y);
void ph_trace_line(struct ph_trace *trace, double x, double y);

/* ph_trace_arc: with radii and rotation (degrees) as of the command A. */
void ph_trace_arc(struct ph_trace *trace, const double radii[2],
                  double rotation, bool large, bool sweep, double x, double y);

/* ph_trace_close: with a line to the start, unless the pen is there. */
void ph_trace_close(struct ph_trace *trace);

/*
 * ph_svg_path_read: draws path data, all commands from M to Z.
 *
 * in   text[n]
 * in   field  for messages
 * ret  PH_OK | PH_E_SYNTAX | PH_E_NOT_FINITE | PH_E_NO_MEMORY
 */
enum ph_status ph_svg_path_read(struct ph_trace *trace, const char *text,
                                size_t n, const char *field,
                                struct ph_diag *diag);

/*
 * ph_svg_path_value: the same as a value: one subpath, of kind PH_POLYLINE,
 * with the text as its word, and flag if it is closed.
 *
 * ret  the same; PH_E_BAD_VALUE: it draws nothing, or several subpaths
 */
enum ph_status ph_svg_path_value(const char *text, size_t n, const char *field,
                                 struct ph_arena *arena, struct ph_value *value,
                                 struct ph_diag *diag);

#endif
