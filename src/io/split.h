/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The splitter: a sequence of input files, JSON, CSV, GeoJSON, SVG, GPX or OBJ,
 * cut into records.
 *
 * Memory is proportional to the largest record, or to the largest that there
 * may be, time to the bytes read.  A record is handed out as soon as its last
 * byte is there, so that a program at the other end of a pipe can wait for the
 * answer to each problem.
 *
 * A record that is longer than it may be is read to its end, but not kept: it
 * has the status PH_E_LIMIT.  One that is broken is that in the first place.
 * Nor are blanks kept, wherever there are more than that.
 */
#ifndef PH_IO_SPLIT_H
#define PH_IO_SPLIT_H

#include "base/buf.h"
#include "io/csv_in.h"
#include "io/geojson.h"
#include "io/json_scan.h"
#include "io/record.h"

#include <stdbool.h>
#include <stddef.h>

/* What the input is: X(SYMBOL, "name"), FIRST of the first. */
#define PH_SPLIT_FORMATS(FIRST, X) \
  FIRST(AUTO, "auto")              \
  X(JSON, "json")                  \
  X(CSV, "csv")                    \
  X(TEXT, "text")                  \
  X(GEOJSON, "geojson")            \
  X(SVG, "svg")                    \
  X(GPX, "gpx")                    \
  X(OBJ, "obj")

/* Before each text of a sequence of GeoJSON (RFC 8142). */
#define PH_RECORD_SEPARATOR '\x1e'

/* Buffers that are no larger are kept. */
enum { PH_SPLIT_KEEP = 1 << 20 };

enum ph_split_format {
#define X(symbol, name) PH_SPLIT_##symbol,
  PH_SPLIT_FORMATS(X, X)
#undef X
      PH_SPLIT_XML /* one of these */
};

/* A part of the input: the records that begin in a range of its bytes, those
 * of all files one after another. */
struct ph_split_part {
  enum { PH_PART_ALL, PH_PART_SHARD, PH_PART_RANGE } how;
  size_t shard, shards; /* the range is one of so many equal ones, from 0 */
  size_t begin, end;    /* or this one; of a shard found by ph_split_init */
};

struct ph_split_options {
  enum ph_split_format format; /* AUTO: by suffix, else by the first byte */
  char delimiter;              /* of CSV; 0: tab for .tsv, else as the first
                                  row has it; PH_CSV_WORDS: blanks and tabs */
  const char *columns;         /* names of the CSV columns, or of some in the
                                  header, NAME=HEADER,...; or NULL */
  size_t most;                 /* bytes of a record; 0: any number */
  bool ignore_columns;         /* that are unknown */
  struct ph_split_part part;   /* of regular files: JSON Lines and CSV */
};

enum ph_split_state {
  PH_SPLIT_RECORD, /* a record; its status tells whether it can be read */
  PH_SPLIT_WAIT,   /* no whole record is there, and none may be waited for */
  PH_SPLIT_END,    /* the end of the last file, or of what could be split */
  PH_SPLIT_FAILED /* PH_E_INPUT, PH_E_NO_MEMORY in diag; PH_SPLIT_END follows */
};

/* A place in a file. */
struct ph_split_place {
  size_t line;   /* from 1 */
  size_t column; /* in bytes, from 1 */
};

/* A record that is longer than it may be. */
struct ph_split_over {
  bool on;
  struct ph_split_place place; /* where it begins */
  size_t byte;                 /* the same */
  struct ph_buf kept;          /* of its text, see ph_split_next */
  /* JSON */
  enum { PH_OVER_VALUE, PH_OVER_LINE, PH_OVER_FOLLOWING } part; /* is read */
  bool one_line;                                                /* so far */
  bool blank;                   /* only blanks stand before the window in its
                                   line, which the record did not begin in */
  struct ph_split_place broken; /* where it is */
  /* CSV */
  bool inside;                 /* a row, of which some is gone */
  bool nameless;               /* its id was too long to be read */
  struct ph_split_place quote; /* of that row, if it is gone */
};

/* How far the JSON of a file is split. */
struct ph_split_json {
  struct ph_json_scan scan; /* of the value at the start of the window */
  enum {
    PH_ARRAY_NONE,
    PH_ARRAY_BEGUN,
    PH_ARRAY_VALUE,
    PH_ARRAY_COMMA,
    PH_ARRAY_TAIL /* behind the features of a collection, in its object */
  } array;
  bool line_start; /* only blanks stand before the window in its line */
  bool broken;     /* the scan has failed */
  bool lines;      /* all values so far stood on lines of their own */
  size_t values;   /* so far in this file */
  size_t line_n;   /* broken: length of the first line; 0: not known yet */
  size_t look;     /* broken: how far the lines are looked through */
};

/* How far the GeoJSON of a file is split: its texts are split as JSON. */
struct ph_split_geojson {
  bool told;                   /* whether the file is GeoJSON */
  struct ph_geojson_head head; /* of the text at the window */
  bool whole;                  /* that text is no collection */
  bool collection;             /* the array is the features of one */
  bool sequence;               /* the file is one */
  bool skip;                   /* to its next text */
  struct ph_geojson text;      /* whose lines are handed out, if it has more */
  struct ph_record record;     /* that text */
  struct ph_buf problem;       /* a line as such */
};

/* How far the CSV of a file is split. */
struct ph_split_csv {
  struct ph_csv_scan scan; /* of the row at `row` */
  size_t row;              /* offset in the window of the row that is read */
  bool open;               /* rows of a record stand before that row */
  bool blanks; /* that row begins with more blanks than a record may have, of
                  which some are gone */
  struct ph_csv_columns *columns; /* NULL: not known yet */
  struct ph_buf id;               /* of the open record */
  double at[2];                   /* of results: where its last row is */
  size_t line_end;                /* of a part: offset behind the row's line, or
                                     behind the window */
};

/* The part of a file that is split.  There a line is a text of JSON or a row
 * of CSV, whatever it holds: what a record is does not depend on the bytes
 * before its line but for the head of the file and, of CSV, the line before. */
struct ph_split_cut {
  bool sought;       /* past the head of the file */
  size_t before;     /* bytes of the files before it */
  size_t size;       /* of it */
  size_t begin, end; /* of the range, in it */
};

/* The files without any record: the names of the first ones. */
#define PH_SPLIT_EMPTY_NAMES 10
struct ph_split_empty {
  const char *names[PH_SPLIT_EMPTY_NAMES];
  size_t n; /* of all */
};

/*
 * A splitter.  Its bytes are a window [start, fill) of a buffer: what was read
 * and not handed out yet.  Everything in it is private to io/split*.c.
 */
struct ph_split {
  const char *const *files;
  size_t files_n;
  size_t next_file;
  struct ph_split_options options;
  const struct ph_schema *schema;
  /* the file */
  const char *name;
  int fd; /* -1: none is open */
  bool end_of_file;
  bool begun;        /* past a byte-order mark */
  bool lines_suffix; /* .ndjson or .jsonl */
  char delimiter;
  enum ph_split_format format; /* AUTO: not known yet */
  bool guessed;                /* the format, by the first byte */
  size_t blanks;               /* AUTO: so many blanks begin the window */
  /* the window */
  char *data;
  size_t capacity;
  size_t start;
  size_t fill;
  struct ph_split_place place; /* of the window's first byte */
  size_t offset;               /* the same, from the start of the file */
  size_t done;                 /* bytes of the window that were handed out */
  /* the stream */
  size_t number; /* of the last record */
  size_t before; /* the same, when the file was opened */
  struct ph_split_empty empty;
  size_t passed; /* bytes of all files that are behind the window */
  bool stopped;
  bool ended;
  struct ph_split_json json;
  struct ph_split_csv csv;
  struct ph_split_geojson geojson;
  struct ph_split_xml *xml; /* NULL: none is open */
  struct ph_split_over over;
  struct ph_split_cut cut;
  struct ph_csv_columns *all_columns;
};

/*
 * ph_split_init: begins to split the files, one stream in the order given.
 * Nothing is opened yet.
 *
 * in   files    names, "-" is standard input; n = 0: standard input alone;
 *               must live as long as the splitter, like the options' strings
 * in   schema   decides which CSV columns are known; must live as long
 * ret  PH_OK; PH_E_USAGE, with the option as field of diag, for a column name
 *      or a delimiter that cannot be; of a part PH_E_INPUT for what is no
 *      regular file; PH_E_NO_MEMORY.  ph_split_free is allowed after any.
 */
enum ph_status ph_split_init(struct ph_split *split, const char *const *files,
                             size_t n, const struct ph_split_options *options,
                             const struct ph_schema *schema,
                             struct ph_diag *diag);

/*
 * ph_split_next: the next record.
 *
 * in   may_wait  false: PH_SPLIT_WAIT rather than block in a read
 * out  record    on PH_SPLIT_RECORD; its text is valid until the next call, its
 *                columns until ph_split_free.  When its status is not PH_OK,
 *                diag has message, line and, if it is broken, column; the text
 *                is what was broken, or nothing if that is too long, but with
 *                PH_E_LIMIT what reads as a record with nothing but the id and,
 *                of JSON, the command, or empty if neither is known.
 */
enum ph_split_state ph_split_next(struct ph_split *split, bool may_wait,
                                  struct ph_record *record,
                                  struct ph_diag *diag);

/* ph_split_release: the text of the last record is no longer needed: memory of
 * a large one is given back now, not when the next one is asked for. */
void ph_split_release(struct ph_split *split);

/* ph_split_stopped: whether the stream was cut off at the last record, whose
 * text was broken in such a way that nothing behind it can be trusted. */
bool ph_split_stopped(const struct ph_split *split);

/* ph_split_free: closes the file, gives all memory back. */
void ph_split_free(struct ph_split *split);

/* ---- between the parts of the splitter ------------------------------- */

/* ph_split_fill: reads more bytes into the window.
 * ret  PH_SPLIT_RECORD: some came, the window may have moved;
 *      PH_SPLIT_END: there are no more; PH_SPLIT_WAIT, PH_SPLIT_FAILED */
enum ph_split_state ph_split_fill(struct ph_split *split, bool may_wait,
                                  struct ph_diag *diag);

/* ph_split_drop: takes n bytes away from the front of the window. */
void ph_split_drop(struct ph_split *split, size_t n);

/* ph_split_give: hands out the first n bytes of the window as a record; `taken`
 * bytes of the window, at least n, are dropped before the next one. */
void ph_split_give(struct ph_split *split, size_t n, size_t taken,
                   struct ph_record *record);

/* ph_split_over: the record that begins at the window turns out to be longer
 * than it may be. */
void ph_split_over(struct ph_split *split);

/* ph_split_give_over: the same for that record, of which nothing is left in
 * the window. */
void ph_split_give_over(struct ph_split *split, size_t taken,
                        struct ph_record *record, struct ph_diag *diag);

/* ph_split_cut_init: finds the range of a part.  ret  PH_OK | PH_E_INPUT */
enum ph_status ph_split_cut_init(struct ph_split *split, struct ph_diag *diag);

/* ph_split_cut_skip: the next file is due; passes over those of which nothing
 * is in the part.  ret  whether one is left */
bool ph_split_cut_skip(struct ph_split *split);

/* ph_split_cut_seek: reads what all parts need of the beginning of a file, and
 * goes to the line that the part begins with.
 * ret  PH_SPLIT_RECORD: it is there; else as ph_split_fill */
enum ph_split_state ph_split_cut_seek(struct ph_split *split, bool may_wait,
                                      struct ph_diag *diag);

/* ph_split_is_part: whether a part is split, by lines. */
bool ph_split_is_part(const struct ph_split *split);

/* ph_split_locate: puts the place of a byte of the window into diag, so many
 * bytes after the window's first one. */
void ph_split_locate(const struct ph_split *split, size_t offset,
                     struct ph_diag *diag);

/* ph_split_obj: the file is one record. */
enum ph_split_state ph_split_obj(struct ph_split *split, bool may_wait,
                                 struct ph_record *record,
                                 struct ph_diag *diag);

/* ph_split_json, ph_split_csv, ...: ph_split_next for the current file, which
 * PH_SPLIT_END ends; a new file begins with split->json, split->csv zeroed.  In
 * the head of a file, of a part, ph_split_csv gives PH_SPLIT_RECORD, and none,
 * when it knows the columns; the window then begins behind the header. */
enum ph_split_state ph_split_json(struct ph_split *split, bool may_wait,
                                  struct ph_record *record,
                                  struct ph_diag *diag);
enum ph_split_state ph_split_csv(struct ph_split *split, bool may_wait,
                                 struct ph_record *record,
                                 struct ph_diag *diag);

enum ph_split_state ph_split_geojson(struct ph_split *split, bool may_wait,
                                     struct ph_record *record,
                                     struct ph_diag *diag);

enum ph_split_state ph_split_xml(struct ph_split *split, bool may_wait,
                                 struct ph_record *record,
                                 struct ph_diag *diag);

/* ph_split_xml_can: whether the program was built with expat. */
bool ph_split_xml_can(void);

/* ph_split_xml_close: gives back what ph_split_xml has opened. */
void ph_split_xml_close(struct ph_split *split);

/* ph_split_geojson_line: the next line of the text that split->geojson has. */
enum ph_split_state ph_split_geojson_line(struct ph_split *split,
                                          struct ph_record *record,
                                          struct ph_diag *diag);

/* ph_split_tell_geojson: finds out whether a file of JSON is GeoJSON, and makes
 * that its format.  ret  PH_SPLIT_RECORD: it is known; as ph_split_fill */
enum ph_split_state ph_split_tell_geojson(struct ph_split *split, bool may_wait,
                                          struct ph_diag *diag);

/* ph_split_collection: whether the text at the window is a FeatureCollection,
 * of which all is then dropped before its first feature.
 * out  state  PH_JSON_MORE: more is needed to tell */
bool ph_split_collection(struct ph_split *split, enum ph_json_state *state);

/* ph_split_pass_text: drops the rest of a broken text of a sequence.
 * ret  PH_SPLIT_RECORD: it did; or as ph_split_fill */
enum ph_split_state ph_split_pass_text(struct ph_split *split, bool may_wait,
                                       struct ph_diag *diag);

/*
 * ph_split_columns: the columns of a list of names.
 *
 * in   names, n   cells between separators
 * in   option     the names are those of --columns, which may skip a column
 * out  columns    a new node of split->all_columns, for the current delimiter
 * ret  PH_OK; PH_E_UNKNOWN_FIELD, PH_E_BAD_VALUE (a name twice),
 *      PH_E_MISSING_FIELD (x without y), with the column of the name in diag;
 *      PH_E_NO_MEMORY
 */
enum ph_status ph_split_columns(struct ph_split *split, const char *names,
                                size_t n, char separator, bool option,
                                struct ph_csv_columns **columns,
                                struct ph_diag *diag);

/* ph_split_find_columns: the window has a whole row, the first one of the file
 * that is no comment; finds split->csv.columns.
 * out  data  the row is to be read as data
 * ret  PH_OK; what is wrong, and where in the row */
enum ph_status ph_split_find_columns(struct ph_split *split, bool *data,
                                     struct ph_diag *diag);

/* ph_split_is_foreign: whether the first row [p,end) tells that the file is
 * neither JSON nor a table; why, with what helps, in diag. */
bool ph_split_is_foreign(const char *p, const char *end, struct ph_diag *diag);

/* ph_split_find_delimiter: makes up split->delimiter, which is not known, by
 * the row [p,end), the first one of the file that is no comment. */
void ph_split_find_delimiter(struct ph_split *split, const char *p,
                             const char *end);

/* ph_split_is_header: whether a comment [p,end), without its #, is a header:
 * all of its words are names of columns.
 * out  separator  what is between them */
bool ph_split_is_header(const struct ph_split *split, const char *p,
                        const char *end, char *separator);

#endif
