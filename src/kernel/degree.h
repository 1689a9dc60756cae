/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Longitude and latitude in degrees, and unit vectors:
 *   x = cos lat cos lon,  y = cos lat sin lon,  z = sin lat.            (1)
 */
#ifndef PH_KERNEL_DEGREE_H
#define PH_KERNEL_DEGREE_H

#include "kernel/vec3.h"

/*
 * ph_degree_to_unit: (1), to rounding for angles of any size.
 *
 * Exact at multiples of 90 degrees, and exactly symmetric (-lon, 180 - lon,
 * -lat): degrees are reduced to [-45,45] before they become radians.
 */
ph_vec3 ph_degree_to_unit(double lon, double lat);

/*
 * ph_degree_of_unit: the way back, also for vectors of other lengths.
 *
 * out  lonlat[2]  longitude in (-180,180], 0 at the poles; latitude in [-90,90]
 */
void ph_degree_of_unit(ph_vec3 u, double lonlat[2]);

#endif
