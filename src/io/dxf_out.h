/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Curves and offsets as a drawing for CAD: DXF of AutoCAD 2000 (AC1015), with
 * an entity SPLINE for each chain, on the layers "curve" and "offset"; of a
 * surface its flat pattern, whose rulings are LINE, on the layer "ruling".
 */
#ifndef PH_IO_DXF_OUT_H
#define PH_IO_DXF_OUT_H

#include "base/buf.h"
#include "curve/result.h"

/* ph_dxf_header: all that is before the entities.  unit: the value of
 * $INSUNITS; NULL: the drawing does not say its unit. */
void ph_dxf_header(struct ph_buf *buf, const char *unit);

/*
 * ph_dxf_out: the entities of a result whose nurbs are there.
 *
 * in  id      of the problem: in the extended data of each entity, with the
 *             distance of an offset
 * in  paths   of a surface: its flat pattern, then those of its parallels
 * in  number  of the result, from 1; handles follow from it
 * in  downward  y points that way in the data, as in SVG; in drawings, up
 */
void ph_dxf_out(struct ph_buf *buf, const char *id, size_t number,
                bool downward, const struct ph_result *result,
                const struct ph_pieces *paths);

/* ph_dxf_footer: all that is behind them. */
void ph_dxf_footer(struct ph_buf *buf);

#endif
