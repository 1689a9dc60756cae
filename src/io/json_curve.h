/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Curves and what is derived from them as JSON: members of a record. */
#ifndef PH_IO_JSON_CURVE_H
#define PH_IO_JSON_CURVE_H

#include "curve/result.h"
#include "io/json_write.h"

/* ph_write_segments: "segments" */
void ph_write_segments(struct ph_json_writer *w, const struct ph_curve *curve);

/* ph_write_sphere: "center", "radius", and what a spherical nu-spline has at
 * its nodes: "tensions", "indicators" */
void ph_write_sphere(struct ph_json_writer *w, const struct ph_curve *curve);

/* ph_write_offsets: "offsets" */
void ph_write_offsets(struct ph_json_writer *w, const struct ph_offset *offsets,
                      size_t n);

/* ph_write_samples: "samples", without tangents, curvatures and torsions that
 * are not finite */
void ph_write_samples(struct ph_json_writer *w,
                      const struct ph_samples *samples);

#endif
