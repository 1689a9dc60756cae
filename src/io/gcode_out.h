/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Plane curves and their offsets as moves of a machine: G-code of RS-274/NGC,
 * absolute, in mm, in the plane XY, without Z, tool or spindle.
 *
 *   G0       to the start of each chain
 *   G5       a cubic: its end, X and Y; from its start to its first inner
 *            control point, I and J; from its end to the second, P and Q
 *   G1       straight cubics; chords of all that is no cubic, between samples
 *   G2, G3   joins of loops that are arcs of more than one chord, to the right
 *            and to the left: the end, X and Y; from the start to the center, I
 *            and J
 *
 * G-code has plain decimals alone: as many as 1e-12 of the size of the curve
 * takes.
 */
#ifndef PH_IO_GCODE_OUT_H
#define PH_IO_GCODE_OUT_H

#include "base/buf.h"
#include "base/diag.h"
#include "curve/result.h"

/* ph_gcode_header: units, plane, feed in mm a minute.  Footer: the end. */
void ph_gcode_header(struct ph_buf *buf, double feed);
void ph_gcode_footer(struct ph_buf *buf);

/* ph_gcode_fits: whether a curve can be written so: a line has 255 characters
 * at most.  ret PH_OK | PH_E_TOO_LARGE (also where it is too small) */
enum ph_status ph_gcode_fits(const struct ph_result *result,
                             struct ph_diag *diag);

/*
 * ph_gcode_out: appends the moves of a curve, then of its offsets, each after a
 * comment.
 *
 * in   id        of the problem; in comments
 * in   downward  y points that way in the data, as in SVG; in moves, up
 * in   result    of a plane curve, with samples: of the curve unless it is of
 *                cubics, and at all ends of pieces of loops (PH_SAMPLE_CHORD)
 */
void ph_gcode_out(struct ph_buf *buf, const char *id, bool downward,
                  const struct ph_result *result);

#endif
