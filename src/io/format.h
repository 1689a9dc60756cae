/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The formats that results are printed in, as one table.  A new format is a row
 * of PH_FORMATS, a row of ph_formats and the file of its functions.
 */
#ifndef PH_IO_FORMAT_H
#define PH_IO_FORMAT_H

#include "curve/surface/tiling.h"
#include "io/csv_out.h"
#include "io/json_out.h"

/* X(SYMBOL, "name"), FIRST(SYMBOL, "name") of the default. */
#define PH_FORMATS(FIRST, X) \
  FIRST(JSON, "json")        \
  X(CSV, "csv")              \
  X(TEXT, "text")            \
  X(NPY, "npy")              \
  X(SVG_PATH, "svg-path")    \
  X(SVG, "svg")              \
  X(GEOJSON, "geojson")      \
  X(DXF, "dxf")              \
  X(OBJ, "obj")              \
  X(STL, "stl")              \
  X(OPENDRIVE, "opendrive")  \
  X(GCODE, "gcode")

/* What the numbers of a drawing count. */
#define PH_SHEET_UNITS(FIRST, X) \
  FIRST(MM, "mm")                \
  X(CM, "cm")                    \
  X(M, "m")                      \
  X(INCH, "in")

enum ph_sheet_unit {
  PH_SHEET_NONE, /* it does not say */
#define X(symbol, name) PH_SHEET_##symbol,
  PH_SHEET_UNITS(X, X)
#undef X
      PH_SHEET_N
};

enum ph_format {
#define X(symbol, name) PH_FORMAT_##symbol,
  PH_FORMATS(X, X)
#undef X
      PH_FORMAT_N
};

/* PH_WORDS: "json|csv|...", the names of such a list. */
#define PH_FIRST_WORD(symbol, name) name
#define PH_NEXT_WORD(symbol, name) "|" name
#define PH_WORDS(list) list(PH_FIRST_WORD, PH_NEXT_WORD)

/* How a run prints its results. */
struct ph_print {
  struct ph_csv_shape shape; /* of formats that are tables */
  bool pretty;               /* of formats that are objects */
  double feed;               /* of formats that are moves: mm a minute */
  enum ph_sheet_unit unit;   /* of formats that are sheets */
};

/* A solved problem. */
struct ph_solved {
  const char *id; /* plain text: the id, or the number of the record */
  size_t number;  /* of the result, from 1: of all records, swept or not */
  const struct ph_heading *heading;
  const struct ph_result *result;
  const struct ph_pieces *paths; /* of formats that are cubics, and of flat
                                    patterns in those that are B-splines: the
                                    curve, then its offsets; else NULL */
  size_t paths_n;
  bool downward; /* y points that way in the input, as in SVG */
  double *box;   /* [4] out: what was drawn (svg_out.h) */
  const struct ph_tiling *tilings; /* of formats that are meshes: the surface,
                                      then those beside it; else NULL */
  size_t tilings_n;
};

struct ph_format_row {
  bool is_objects; /* takes --pretty */
  bool is_table;   /* takes --table */
  bool is_mesh;    /* has the samples of a surface */
  bool is_single;  /* has room for one problem */
  bool is_parted;  /* outputs one after another are one, but for the header */
  bool is_binary;  /* a table in the third form, into a file */
  bool is_text;    /* a table in the second form (csv_out.h) */
  bool is_drawing; /* of cubics within --tolerance, if it is given */
  bool is_nurbs;   /* has neither samples nor --convert: B-splines */
  bool is_cubics;  /* has neither samples nor --convert; --chord-error is how
                      near the cubics are to the curve */
  bool is_lines;   /* of samples of curves, which it has without being asked */
  bool is_sheet;   /* may say in which unit it is */
  bool is_road;    /* of plane cubics alone, without samples and offsets */
  bool is_moves;   /* of a machine: plane curves, samples as is_lines, but only
                      of --chord-error */
  size_t joint;    /* bytes before each record that are none before the first */
  /* before all records; NULL: nothing */
  void (*header)(struct ph_buf *buf, const struct ph_print *print,
                 const struct ph_swept *swept, size_t swept_n);
  /* the same of a format that is kept in memory to its end: about what was
   * drawn */
  void (*frame)(struct ph_buf *buf, const struct ph_print *print,
                const double box[4]);
  /* after all records; NULL: nothing */
  void (*footer)(struct ph_buf *buf);
  /* what the header is when so many bytes stand behind it, in the place of
   * which it is written; NULL: what it was */
  void (*finish)(struct ph_buf *buf, const struct ph_print *print,
                 size_t bytes);
  void (*solved)(struct ph_buf *buf, const struct ph_print *print,
                 const struct ph_solved *solved);
  /* NULL: the message on standard error is all; file may be NULL */
  void (*failed)(struct ph_buf *buf, const struct ph_print *print,
                 const struct ph_heading *heading, const struct ph_diag *diag,
                 const char *file);
};

extern const struct ph_format_row ph_formats[PH_FORMAT_N];

/* ph_format_name: as in --format. */
const char *ph_format_name(enum ph_format format);

#endif
