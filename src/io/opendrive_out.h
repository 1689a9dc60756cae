/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Plane cubics as the reference lines of roads: ASAM OpenDRIVE 1.7, one
 * document with a road for each result, whose geometries are the segments.
 */
#ifndef PH_IO_OPENDRIVE_OUT_H
#define PH_IO_OPENDRIVE_OUT_H

#include "base/buf.h"
#include "io/svg_out.h"

/* ph_opendrive_header, ph_opendrive_footer: what stands around the roads. */
void ph_opendrive_header(struct ph_buf *buf);
void ph_opendrive_footer(struct ph_buf *buf);

/*
 * ph_opendrive_out: appends a road, with its center lane alone.
 *
 * Along the tangent at its start, u, and to the left of it, v, a segment with
 * the preimage w0 (1-p) + w1 p (curve/segment/tc.h) is
 *
 *   u + i v = A p + c p^2 + c^2/(3 A) p^3,
 *   A = |w0|^2, c = conj(w0) (w1 - w0), hdg = 2 arg w0.
 *
 * One that is straight to rounding is a line.  s is the sum of the lengths.
 *
 * in  name      the name of the road; its id is the number
 * in  number    of the result, from 1
 * in  downward  y points that way in the data, as in SVG; in roads, up
 * in  curve     of Tschirnhausen cubics that stand still at no end
 */
void ph_opendrive_out(struct ph_buf *buf, const struct ph_svg_name *name,
                      size_t number, bool downward,
                      const struct ph_curve *curve);

#endif
