/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Curves as the text of SVG paths: the attribute d of a path element. */
#ifndef PH_IO_SVG_OUT_H
#define PH_IO_SVG_OUT_H

#include "base/buf.h"
#include "curve/result.h"

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

#endif
