/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Results as tables (INTERFACE: --table), in one of three forms, the first two
 * with numbers as in JSON and lines that end in LF:
 *
 *   CSV   quoting as in RFC 4180; what is not defined is an empty cell
 *   text  for gnuplot and awk: cells between blanks, _ for what would break or
 *         quote a word, - for an empty one, NaN where something is not defined;
 *         the names of the columns in a line that begins with #; an empty line
 *         between curves and at gaps of offsets, two between problems
 *   binary  rows of doubles as they are in memory (npy_out.h)
 */
#ifndef PH_IO_CSV_OUT_H
#define PH_IO_CSV_OUT_H

#include "base/buf.h"
#include "curve/result.h"
#include "io/json_out.h"

#include <stdbool.h>

/* Tables: X(SYMBOL, "name", "what it lists"). */
#define PH_TABLES(X)                                                          \
  X(CONTROL_POINTS, "control-points", "control points of every segment")      \
  X(LENGTHS, "lengths",                                                       \
    "interval, length, cumulative length of every segment")                   \
  X(SAMPLES, "samples", "points, tangents, curvature along every segment")    \
  X(OFFSETS, "offsets",                                                       \
    "control points and weights of the offset curves; on a sphere samples")   \
  X(STRIPS, "strips", "frames, curvatures and vertices of a surface")         \
  X(PATCHES, "patches", "control points of the patches of a surface")         \
  X(EDGES, "edges", "edges of a surface of patches, and jumps there")         \
  X(DEVELOPMENT, "development",                                               \
    "control points and weights of the development of a surface; of general " \
    "cones samples")                                                          \
  X(LOCATED, "located", "points of a development, on the surface")

enum ph_table {
#define X(symbol, name, what) PH_TABLE_##symbol,
  PH_TABLES(X)
#undef X
      PH_TABLE_N
};

/* ph_csv_has: whether there is such a table of what lies there. */
bool ph_csv_has(enum ph_table table, enum ph_space space);

/* What decides about the columns. */
struct ph_csv_shape {
  enum ph_table table;
  bool text;           /* the second form */
  enum ph_space space; /* of the curves */
  bool offsets;        /* there are some */
  bool loops;          /* that are loops */
  bool frame;          /* of samples */
  bool file;           /* of the problem */
  bool binary;         /* the third form */
};

/* The first cells of every row. */
struct ph_csv_heading {
  const char *id; /* plain text */
  const struct ph_swept *swept;
  size_t swept_n;
  const char *file; /* of the problem, for shapes that have it */
  size_t number;    /* of the result, for binary ones */
};

/*
 * ph_csv_header: appends the header row.  Of samples, what was asked for comes
 * after what there always is: the frame; distance, and in space vector, of the
 * offset that a row is of (0 and nothing: of the curve); of loops the loop, and
 * of their control points the piece.  Swept fields are
 * columns after all others, and the file after these.
 */
void ph_csv_header(struct ph_buf *buf, const struct ph_csv_shape *shape,
                   const struct ph_swept *swept, size_t swept_n);

/* ph_csv_result: appends the rows of a solved problem. */
void ph_csv_result(struct ph_buf *buf, const struct ph_csv_shape *shape,
                   const struct ph_csv_heading *heading,
                   const struct ph_result *result);

#endif
