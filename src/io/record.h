/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A record: the bytes of one problem and where they came from.
 *
 * The splitter (io/split.h) cuts the stream into records without interpreting
 * them; a worker turns one into a ph_problem (io/json_in.h, io/csv_in.h).
 */
#ifndef PH_IO_RECORD_H
#define PH_IO_RECORD_H

#include "base/diag.h"
#include "curve/problem.h"

#include <stdbool.h>
#include <stddef.h>

/* The meaning of the columns of one CSV file (io/csv_in.h). */
struct ph_csv_columns;

struct ph_record {
  const char *text; /* one JSON value, or whole CSV rows */
  size_t n;
  const char *file; /* name for messages, "-" is standard input */
  size_t line;      /* line of text[0] in the file, from 1 */
  size_t number;    /* 1, 2, ... in the whole stream */
  const struct ph_csv_columns *columns; /* CSV; NULL: the text is JSON */
  enum ph_status status; /* not PH_OK: broken text, diag says why */
  bool downward;         /* y points that way, as in SVG */
  bool named;            /* ... but the text is an object with the id */
};

/* The members of a record that are echoed into its result: JSON texts without
 * line breaks, not NUL-terminated, NULL where there is none.  They lie in the
 * record's text or in the arena of the reader. */
struct ph_echo {
  const char *id;
  size_t id_n;
  const char *meta;
  size_t meta_n;
};

#endif
