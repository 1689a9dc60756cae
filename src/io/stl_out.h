/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Surfaces as meshes in the binary STL format. */
#ifndef PH_IO_STL_OUT_H
#define PH_IO_STL_OUT_H

#include "base/buf.h"
#include "curve/surface/tiling.h"

/*
 * ph_stl_out: appends a file: 80 bytes of text, how many triangles there are,
 * and of each its normal and its corners, in numbers of 32 bits, little endian.
 * A tile is two triangles, cut along its shorter diagonal.
 *
 * Coordinates beyond such numbers are infinite there, as the caller may see
 * before: ph_stl_fits.
 */
void ph_stl_out(struct ph_buf *buf, const struct ph_tiling *tilings, size_t n);

/* ph_stl_fits: whether coordinates and the number of triangles do. */
bool ph_stl_fits(const struct ph_tiling *tilings, size_t n);

#endif
