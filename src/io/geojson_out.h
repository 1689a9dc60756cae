/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Curves and offsets as GeoJSON (RFC 7946), from their samples. */
#ifndef PH_IO_GEOJSON_OUT_H
#define PH_IO_GEOJSON_OUT_H

#include "base/buf.h"
#include "curve/result.h"
#include "io/json_out.h"

/* What stands before each text of ph_geojson_out, but not before the first. */
#define PH_GEOJSON_JOINT ",\n"

/* ph_geojson_header, ph_geojson_footer: what stands around all features. */
void ph_geojson_header(struct ph_buf *buf);
void ph_geojson_footer(struct ph_buf *buf);

/*
 * ph_geojson_out: appends a Feature for a curve and one for each of its
 * offsets, each on a line of its own.
 *
 *   positions   on a sphere longitude and latitude, else the coordinates
 *   geometry    of a closed curve in the plane that does not meet itself, and
 *               of offsets that were put together to closed loops, Polygon or
 *               MultiPolygon: the outer rings counter-clockwise, the others
 *               clockwise; a loop inside an odd number of others is a hole.
 *               Else LineString or MultiLineString, cut at gaps of offsets and,
 *               on a sphere, at longitude 180; null where there is nothing
 *   properties  id, length, of offsets distance and vector, sweep, meta
 *
 * The feature of a curve has its id, unless it is one of a sweep.
 */
void ph_geojson_out(struct ph_buf *buf, const struct ph_heading *heading,
                    const struct ph_result *result);

#endif
