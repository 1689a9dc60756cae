/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Volumes, numbers at the points of a lattice, and panoramas: what a surface
 * meets of one, laid flat.
 */
#ifndef PH_CURVE_SURFACE_VOLUME_H
#define PH_CURVE_SURFACE_VOLUME_H

#include "base/diag.h"
#include "base/mem.h"
#include "curve/result.h"

/*
 * ph_panorama_of: the points of the development at multiples of 1/resolution
 * from the upper left corner of its bounding box on, row by row downwards, and
 * what the volume has there.  What is beside the development, or the volume, is
 * NaN.
 *
 * in   most  points of a panorama
 * ret  PH_OK | PH_E_LIMIT | PH_E_NO_MEMORY
 */
enum ph_status ph_panorama_of(const struct ph_curve *curve,
                              const struct ph_volume *volume, double resolution,
                              size_t most, struct ph_arena *arena,
                              struct ph_panorama *panorama,
                              struct ph_diag *diag);

#endif
