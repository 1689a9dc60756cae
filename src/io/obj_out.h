/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Surfaces as meshes in the OBJ format. */
#ifndef PH_IO_OBJ_OUT_H
#define PH_IO_OBJ_OUT_H

#include "base/buf.h"
#include "curve/result.h"

/*
 * ph_obj_out: appends an object for a surface and one for each of its parallel
 * surfaces, from their samples: points (v), of the development (vt), normals
 * (vn), and a face for each cell, counter-clockwise as seen from where the
 * normals point to.  Strips share the points of the rulings between them.
 *
 * in  first  numbers of points count from 1; else backward from the last one,
 *            since other objects may stand before
 */
void ph_obj_out(struct ph_buf *buf, const char *id, bool first,
                const struct ph_result *result);

#endif
