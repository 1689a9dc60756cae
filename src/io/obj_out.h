/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Surfaces as meshes in the OBJ format. */
#ifndef PH_IO_OBJ_OUT_H
#define PH_IO_OBJ_OUT_H

#include "base/buf.h"
#include "curve/surface/tiling.h"

/*
 * ph_obj_out: appends an object for each mesh, those of parallel surfaces named
 * by their distance: points (v), of a development (vt), normals (vn), and a
 * face for each tile.
 *
 * in  first  numbers of points count from 1; else backward from the last one,
 *            since other objects may stand before
 */
void ph_obj_out(struct ph_buf *buf, const char *id, bool first,
                const struct ph_tiling *tilings, size_t n);

#endif
