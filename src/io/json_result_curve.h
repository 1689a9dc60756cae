/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The curve of a result record, and what was derived from it, read back: the
 * counterpart of json_curve.h. */
#ifndef PH_IO_JSON_RESULT_CURVE_H
#define PH_IO_JSON_RESULT_CURVE_H

#include "curve/result.h"
#include "io/json_read.h"

/* No curve or offset that is written has a higher degree, by far. */
enum { PH_CLAIM_DEGREE_MAX = 15 };

/*
 * ph_read_segments: "segments", of which there must be one at least.
 *
 * Members that the first segment has, all must have, and no other.
 *
 * inout curve  kind, dimension, degree, closed are given
 */
void ph_read_segments(struct ph_json_reader *r, const struct ph_json_item *item,
                      struct ph_curve *curve);

/* ph_read_sphere: what a record has beside the segments, if it has a radius.
 *
 * in  items[4]  center, radius, tensions, indicators */
void ph_read_sphere(struct ph_json_reader *r, const struct ph_json_item *items,
                    struct ph_curve *curve);

/* ph_read_samples: "samples"; none if it is absent. */
void ph_read_samples(struct ph_json_reader *r, const struct ph_json_item *item,
                     const struct ph_curve *curve, struct ph_samples *samples);

/* ph_read_offsets: "offsets"; none if it is absent. */
void ph_read_offsets(struct ph_json_reader *r, const struct ph_json_item *item,
                     const struct ph_curve *curve, struct ph_offset **offsets,
                     size_t *offsets_n);

#endif
