/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A record: the bytes of one problem and where they came from.
 *
 * The splitter (io/split.h) cuts the stream into records without interpreting
 * them; a worker turns one into a ph_problem (ph_record_read).
 */
#ifndef PH_IO_RECORD_H
#define PH_IO_RECORD_H

#include "base/diag.h"
#include "base/mem.h"
#include "curve/problem.h"

#include <stdbool.h>
#include <stddef.h>

/* The meaning of the columns of one CSV file (io/csv_in.h). */
struct ph_csv_columns;

struct ph_record {
  const char *text; /* one JSON value, whole CSV rows, or an OBJ file */
  size_t n;
  const char *file; /* name for messages, "-" is standard input */
  size_t line;      /* line of text[0] in the file, from 1 */
  size_t byte;      /* offset of text[0] in the file */
  size_t number;    /* 1, 2, ... in the whole stream */
  const struct ph_csv_columns *columns; /* CSV; NULL: the text is JSON */
  bool mesh;                            /* the text is OBJ */
  enum ph_status status; /* not PH_OK: broken text, diag says why */
  bool downward;         /* y points that way, as in SVG */
  bool degrees;          /* points are longitudes and latitudes, as in GPX */
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

/* ph_record_read: reads one problem of any format, as ph_json_in, ph_csv_in or
 * ph_obj_in. */
enum ph_status ph_record_read(const struct ph_record *record,
                              const struct ph_schema *schema,
                              struct ph_arena *arena,
                              struct ph_problem *problem, struct ph_echo *echo,
                              struct ph_diag *diag);

/* ph_record_keep: what is echoed goes to the arena.
 * ret  false: memory is exhausted, and it stays where it is */
bool ph_record_keep(struct ph_echo *echo, struct ph_arena *arena);

/*
 * ph_record_forget: the text of a record that was read will not be there any
 * more; what is echoed goes to the arena, and lines are known without it.
 *
 * ret  false: it has to stay, for the lines, or as memory is exhausted
 */
bool ph_record_forget(struct ph_record *record, struct ph_echo *echo,
                      struct ph_arena *arena);

/*
 * ph_record_line: the line in the file of the element that a path names,
 * points[3][1] or end_derivatives; of the innermost part that exists, at least
 * the record's first line.  Walks through the record: for failures only.
 *
 * in   record  with status PH_OK
 */
size_t ph_record_line(const struct ph_record *record, const char *path);

#endif
