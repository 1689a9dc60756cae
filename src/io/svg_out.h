/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Curves as the text of SVG paths: the attribute d of a path element. */
#ifndef PH_IO_SVG_OUT_H
#define PH_IO_SVG_OUT_H

#include "base/buf.h"
#include "curve/result.h"

#include "io/json_out.h"

#include <math.h>
#include <stdbool.h>

/*
 * ph_svg_path: appends cubics as M and C commands, absolute, in the unit of the
 * data and with its direction of y.
 *
 * A piece that does not begin where the one before ends begins a subpath.
 *
 * in   cubics  degree 3, dimension 2
 * in   closed  a curve of one subpath that ends where it began is closed by Z
 */
void ph_svg_path(struct ph_buf *buf, const struct ph_pieces *cubics,
                 bool closed);

/* What is drawn: x from box[0] to box[2], y from box[1] to box[3]; of nothing
 * box[0] is above box[2]. */
#define PH_SVG_NOTHING \
  { HUGE_VAL, HUGE_VAL, -HUGE_VAL, -HUGE_VAL }

/* ph_svg_join: makes a box as large as it takes to hold the other one. */
void ph_svg_join(double box[4], const double other[4]);

/* What a path is, as its attributes tell. */
struct ph_svg_name {
  const char *id;
  const double *distance; /* of an offset; NULL: it is none */
  bool rulings;           /* between strips, of the flat pattern id */
  const struct ph_swept *swept;
  size_t swept_n;
};

/* ph_svg_name_put: appends a name as part of an attribute: that of the curve,
 * of a sweep with the values, of offsets with @ and the distance; blanks and
 * what XML cannot have are _; then /rulings, of rulings */
void ph_svg_name_put(struct ph_buf *buf, const struct ph_svg_name *name);

/*
 * ph_svg_element: appends a path element, on a line of its own; none without
 * cubics.
 *
 * in    name  its id
 * in    up    y points upward: the element turns it
 * inout box   as the drawing has it, with y downward
 */
void ph_svg_element(struct ph_buf *buf, const struct ph_svg_name *name,
                    const struct ph_pieces *cubics, bool closed, bool up,
                    double box[4]);

/* ph_svg_header, ph_svg_footer: what stands around all elements.  unit: the
 * millimetres that a drawing has for one of the data; 0: it does not say. */
void ph_svg_header(struct ph_buf *buf, const double box[4], double unit);
void ph_svg_footer(struct ph_buf *buf);

#endif
