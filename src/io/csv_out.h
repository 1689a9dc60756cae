/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Results as CSV tables (INTERFACE: --table).  Quoting as in RFC 4180, lines
 * end in LF; numbers as in JSON. */
#ifndef PH_IO_CSV_OUT_H
#define PH_IO_CSV_OUT_H

#include "base/buf.h"
#include "curve/result.h"
#include "io/json_out.h"

#include <stdbool.h>

/* Tables: X(SYMBOL, "name", "what it lists"). */
#define PH_TABLES(X)                                                       \
  X(CONTROL_POINTS, "control-points", "control points of every segment")   \
  X(LENGTHS, "lengths",                                                    \
    "interval, length, cumulative length of every segment")                \
  X(SAMPLES, "samples", "points, tangents, curvature along every segment") \
  X(OFFSETS, "offsets",                                                    \
    "control points and weights of the offset curves; on a sphere samples")

enum ph_table {
#define X(symbol, name, what) PH_TABLE_##symbol,
  PH_TABLES(X)
#undef X
      PH_TABLE_N
};

/* The first cells of every row. */
struct ph_csv_heading {
  const char *id; /* plain text */
  const struct ph_swept *swept;
  size_t swept_n;
};

/*
 * ph_csv_header: appends the header row.  Swept fields are columns after all
 * others.
 *
 * in  dimension, on_sphere  of the curves
 */
void ph_csv_header(struct ph_buf *buf, enum ph_table table, size_t dimension,
                   bool on_sphere, const struct ph_swept *swept,
                   size_t swept_n);

/* ph_csv_result: appends the rows of a solved problem. */
void ph_csv_result(struct ph_buf *buf, enum ph_table table,
                   const struct ph_csv_heading *heading,
                   const struct ph_result *result);

#endif
