/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The method `spatial-hermite`: local interpolation of points in space, with
 * tangents or without, by PH quintic and ATPH segments [FAR15; GON18, ch. 3].
 */
#ifndef PH_SOLVE_SPATIAL_METHOD_H
#define PH_SOLVE_SPATIAL_METHOD_H

#include "solve/method.h"

extern const struct ph_method ph_method_spatial_hermite;

#endif
