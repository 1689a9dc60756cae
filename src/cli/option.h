/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The command line: one table of common options, the fields of the command as
 * further options, and what a command line means once read.
 *
 * A common option with the name of a field of the command also sets the field.
 */
#ifndef PH_CLI_OPTION_H
#define PH_CLI_OPTION_H

#include "base/diag.h"
#include "base/mem.h"
#include "cli/command.h"
#include "cli/sweep.h"
#include "curve/offset/offset.h"
#include "curve/sample/sample.h"
#include "curve/surface/grid.h"
#include "curve/surface/volume.h"
#include "io/format.h"
#include "io/split.h"

#include <stdbool.h>
#include <stddef.h>

/* What --tolerance is where it is absent: of the size of the curve; of verify;
 * of the size of a surface.
 */
#define PH_TOLERANCE 1e-9
#define PH_TOLERANCE_VERIFY 1e-9
#define PH_TOLERANCE_FLAT 1e-6

/* X(SYMBOL, USE, 'short' or 0, "long", "ARGUMENT" or NULL, "help").  USE is the
 * commands that have the option (enum ph_use).  Help
 * texts are broken into lines where they are printed. */
#define PH_OPTIONS(X)                                                          \
  X(INPUT_FORMAT, SOLVE, 'i', "input-format", PH_WORDS(PH_SPLIT_FORMATS),      \
    "what the input is; auto (default): by the suffix of the file (.json "     \
    ".ndjson .jsonl .geojson .svg .gpx .obj .csv .tsv), else by how it "       \
    "begins; text: numbers between blanks")                                    \
  X(PROBLEMS, VERIFY, 0, "problems", "FILE",                                   \
    "the problems that the results solve, to check these as well: the same "   \
    "id, or else the same order")                                              \
  X(PROBLEMS_FORMAT, VERIFY, 'i', "input-format", PH_WORDS(PH_SPLIT_FORMATS),  \
    "what the file of problems is; auto (default): by its suffix, else by "    \
    "how it begins")                                                           \
  X(COLUMNS, ALL, 0, "columns", "NAME,...",                                    \
    "what the columns of CSV input are, in order (-: skip), or by their "      \
    "names in the header, NAME=HEADER,...")                                    \
  X(IGNORE_COLUMNS, ALL, 0, "ignore-columns", NULL,                            \
    "skip columns of CSV input whose names are unknown")                       \
  X(DELIMITER, ALL, 0, "delimiter", "C",                                       \
    "separator of CSV input (default: a tab in .tsv files, else what the "     \
    "first row has); a blank: any number of blanks and tabs")                  \
  X(SHARD, ALL, 0, "shard", "K/N",                                             \
    "only the records that begin in the K-th (from 0) of N equal ranges of "   \
    "the bytes of all FILEs, which are JSON Lines or CSV; outputs in order "   \
    "make one")                                                                \
  X(RANGE, ALL, 0, "range", "FROM:TO",                                         \
    "the same of bytes FROM (from 0) to TO, without TO to the end")            \
  X(FORMAT, SOLVE, 'f', "format", PH_WORDS(PH_FORMATS),                        \
    "json (default): one object a line; csv (with --table the default): one "  \
    "table; text: the same in columns, for gnuplot and awk; npy: the same as " \
    "an array for NumPy, in a file; svg-path: paths of cubic Bezier curves; "  \
    "svg: a drawing of these; geojson: features of samples, without other "    \
    "options within 1e-6 of the size; dxf: a drawing for CAD, of B-splines; "  \
    "obj, stl: the mesh of a surface; opendrive: roads along plane cubics; "   \
    "gcode: moves along plane curves")                                         \
  X(FEED, CURVE, 0, "feed", "F",                                               \
    "how fast the moves of --format=gcode are, in mm a minute")                \
  X(UNIT, SOLVE, 0, "unit", PH_WORDS(PH_SHEET_UNITS),                          \
    "what the numbers of --format=svg and dxf count, so that the drawing is "  \
    "printed and cut in its true size")                                        \
  X(TABLE, SOLVE, 0, "table", "NAME",                                          \
    "what --format=csv, text and npy print (default: control-points, of "      \
    "surfaces "                                                                \
    "strips or patches):")                                                     \
  X(WITH_FILE, SOLVE, 0, "with-file", NULL,                                    \
    "add the file of the problem to the rows of --table")                      \
  X(FIELDS, SOLVE, 0, "fields", "NAME,...",                                    \
    "write only these members of JSON records, of objects in them as "         \
    "NAME.NAME, beside id, command, status and error")                         \
  X(PRETTY, ALL, 0, "pretty", NULL, "indented JSON")                           \
  X(OUTPUT, ALL, 'o', "output", "FILE",                                        \
    "write FILE, replaced only when everything was written")                   \
  X(IF_CHANGED, ALL, 0, "if-changed", NULL,                                    \
    "leave the FILE of --output as it is where it has the same bytes")         \
  X(NO_SYNC, ALL, 0, "no-sync", NULL, "do not wait for the disk")              \
  X(SET, ALL, 's', "set", "FIELD=VALUE",                                       \
    "set a field of the problems that lack it; VALUE is JSON or a word")       \
  X(OVERRIDE, ALL, 0, "override", "FIELD=VALUE",                               \
    "set a field of every problem")                                            \
  X(SWEEP, SOLVE, 'S', "sweep", "FIELD=RANGE",                                 \
    "solve every problem once for each value of RANGE: V1,V2,... or "          \
    "START:STOP:COUNT, with :log at equal ratios; FIELD may be an element, "   \
    "points[2][0]; FIELD*=RANGE multiplies what is there")                     \
  X(OFFSET, CURVE, 'd', "offset", "D[,D...]",                                  \
    "add offset curves at these distances, positive to the left of travel; a " \
    "range is START:STOP:COUNT")                                               \
  X(OFFSET_MODE, CURVE, 0, "offset-mode", PH_WORDS(PH_OFFSET_MODES),           \
    "raw (default): the offset of each segment; joined: these with joins at "  \
    "outer corners; trimmed: of these what keeps the distance from the whole " \
    "curve, as loops (in the plane)")                                          \
  X(OFFSET_JOIN, CURVE, 0, "offset-join", "round|miter[:LIMIT]",               \
    "joins: arcs (default), or tips up to LIMIT (default: 4) times the "       \
    "distance, and arcs beyond")                                               \
  X(OFFSET_ENDS, CURVE, 0, "offset-ends", "none|round",                        \
    "open curves: one side (default), or both, joined by half circles")        \
  X(OFFSET_SIDES, CURVE, 0, "offset-sides", "one|both",                        \
    "closed curves: one side (default), or the outline of all that is nearer") \
  X(OFFSET_TOUCHING, CURVE, 0, "offset-touching", "split|keep",                \
    "parts of trimmed offsets with nothing between them: left out (default), " \
    "or there once")                                                           \
  X(PARALLEL, ANY_SURFACE, 'd', "offset", "D[,D...]",                          \
    "add parallel surfaces at these distances along the normals")              \
  X(SAMPLE, CURVE, 'n', "sample", "N",                                         \
    "add N+1 samples per segment, equally spaced in the segment's parameter")  \
  X(GRID, SURFACE, 'n', "sample", "N[xM]",                                     \
    "add samples: N steps along each strip and M over the height")             \
  X(PATCH_GRID, PATCHES, 'n', "sample", "N",                                   \
    "add samples, or of a mesh the tiles: N by N steps of each patch")         \
  X(EDGES, PATCHES, 0, "edges", NULL,                                          \
    "add the edges of the mesh, with what the patches on both sides differ "   \
    "by")                                                                      \
  X(SPACING, CURVE, 0, "spacing", "DS",                                        \
    "add samples equally spaced by arc length along the whole curve")          \
  X(CHORD_ERROR, CURVE, 0, "chord-error", "E",                                 \
    "add samples such that no chord leaves the curve by more than E")          \
  X(FRAME, CURVE, 0, "frame", PH_WORDS(PH_FRAMES),                             \
    "add normal and binormal to samples of curves in space")                   \
  X(PLOT, SOLVE, 'p', "plot", "FILE",                                          \
    "draw data, results, offsets and curvature of the whole run: FILE.svg, "   \
    "FILE.pdf or FILE.png")                                                    \
  X(PLOT_SIZE, SOLVE, 0, "plot-size", "WIDTHxHEIGHT",                          \
    "size of the figure, in pixels (.png) or points of 1/72 inch")             \
  X(TITLE, SOLVE, 0, "title", "TEXT", "a title for the figure")                \
  X(LABELS, DRAW, 0, "labels", NULL,                                           \
    "number the points in the figure, from 0, as messages count them")         \
  X(VOLUME_OF, VERIFY, 0, "volume", "FILE.nrrd",                               \
    "the volume of the panoramas of results, to check these as well")          \
  X(VOLUME, SURFACE, 0, "volume", "FILE.nrrd",                                 \
    "the volume that --panorama shows")                                        \
  X(PANORAMA, SURFACE, 0, "panorama", "FILE",                                  \
    "the volume on the surface, laid flat: FILE.png or FILE.nrrd")             \
  X(RESOLUTION, SURFACE, 0, "resolution", "R",                                 \
    "points of the panorama over the unit of length")                          \
  X(FILL, SURFACE, 0, "fill", "X",                                             \
    "what the panorama has beside the surface and the volume (default: 0)")    \
  X(CONVERT, CURVE, 0, "convert", "bezier",                                    \
    "write atph segments as polynomial quintic Bezier segments")               \
  X(OFFSET_RANGE, CURVE, 0, "offset-range", NULL,                              \
    "add the distances up to which offsets of the whole curve have no cusp "   \
    "(in the plane)")                                                          \
  X(NURBS, CURVE, 0, "nurbs", NULL,                                            \
    "add curves and offsets as B-splines, rational where they must be")        \
  X(TOLERANCE, CURVE, 0, "tolerance", "E",                                     \
    "greatest distance of Bezier pieces from the exact curve "                 \
    "(default: " PH_TEXT(PH_TOLERANCE) " of its size, or the rounding of its " \
                                       "coordinates)")                         \
  X(FLAT, SURFACE, 0, "tolerance", "E",                                        \
    "greatest distance of a general cone laid flat from chords of its "        \
    "samples (default: " PH_TEXT(PH_TOLERANCE_FLAT) " of the size)")           \
  X(LIMIT, VERIFY, 0, "tolerance", "E",                                        \
    "greatest relative error of what is right (default: " PH_TEXT(             \
        PH_TOLERANCE_VERIFY) ")")                                              \
  X(JOBS, ALL, 'j', "jobs", "N",                                               \
    "worker threads (default: the processors); for every N the results are "   \
    "the same, in the same order")                                             \
  X(MAX_SAMPLES, SOLVE, 0, "max-samples", "N",                                 \
    "the most samples that a curve may have (default: " PH_TEXT(               \
        PH_SAMPLES_MAX) ")")                                                   \
  X(MAX_MEMORY, ALL, 0, "max-memory", "BYTES",                                 \
    "the most memory that a record may take: a number, or one with K, M or "   \
    "G (default: a quarter of the machine's)")                                 \
  X(MAX_RECORD_BYTES, ALL, 0, "max-record-bytes", "BYTES",                     \
    "the longest text that a record may have (default: as --max-memory)")      \
  X(TIME_LIMIT, ALL, 0, "time-limit", "SECONDS",                               \
    "the longest time that a record may take (default: any)")                  \
  X(STRICT, SOLVE, 0, "strict", NULL, "a warning is an error")                 \
  X(FAIL_FAST, ALL, 0, "fail-fast", NULL, "stop at the first failure")         \
  X(PROGRESS, ALL, 0, "progress", NULL, "report progress on standard error")   \
  X(QUIET, ALL, 'q', "quiet", NULL, "no warnings, no summary of failures")     \
  X(VERBOSE, SOLVE, 'v', "verbose", NULL,                                      \
    "a line for each problem solved: iterations, residual, time")              \
  X(VERBOSE_VERIFY, VERIFY, 'v', "verbose", NULL,                              \
    "a line for each result that is right: its worst error, time")             \
  X(HELP, ALL, 'h', "help", NULL, "this text")                                 \
  X(VERSION, ALL, 'V', "version", NULL, "the version")

enum ph_option_id {
#define X(symbol, use, letter, name, argument, help) PH_O_##symbol,
  PH_OPTIONS(X)
#undef X
      PH_OPTION_N
};

struct ph_option {
  enum ph_use use;
  char letter;
  const char *name;
  const char *argument;
  const char *help;
};

extern const struct ph_option ph_option_table[PH_OPTION_N];

/* --set, --override and the field options.  Which field is meant, verify knows
 * of each result only: ph_option_assign. */
struct ph_assignment {
  const char *text; /* FIELD=VALUE; NULL: a field option */
  enum ph_field_id field;
  struct ph_value value;
  const char *json; /* the value, on one line */
  bool override;
};

/* A command line, read.  Its memory is its arena's. */
struct ph_options {
  struct ph_arena arena;
  const struct ph_command *command;
  bool help, version;
  const char *const *files;
  size_t files_n;
  bool files_given; /* not standard input for want of a file */
  struct ph_split_options input;
  enum ph_format format;
  enum ph_table table;
  struct ph_chosen *chosen; /* members that are written; NULL: all */
  uint64_t unasked;         /* as of struct ph_diagnostics */
  bool edges;               /* of surfaces of patches */
  bool with_file, pretty, strict, fail_fast, progress, quiet, verbose, no_sync,
      if_changed;
  const char *output; /* NULL: standard output */
  size_t jobs;
  size_t max_memory; /* bytes */
  double time_limit; /* seconds; 0: none */
  struct ph_assignment *assignments;
  size_t assignments_n;
  struct ph_sweep *sweeps;
  size_t sweeps_n;
  size_t sweep_count; /* results for each problem */
  bool convert, nurbs, offset_range;
  double tolerance; /* 0: the default */
  double feed;      /* 0: not given */
  enum ph_sheet_unit unit;
  const char *problems; /* of the results that verify looks at; NULL: none */
  struct ph_split_options problems_input;
  double *offsets;
  size_t offsets_n;
  struct ph_offset_rules offset; /* but for tolerance and samples */
  struct ph_sample_rules samples;
  struct ph_grid_rules grid;          /* of surfaces; along 0: none */
  const char *panorama, *volume_file; /* NULL: none */
  double resolution, fill;
  bool fill_given;
  struct ph_volume volume;        /* read by cli/panorama.h */
  const char *plot;               /* NULL: none */
  size_t plot_width, plot_height; /* 0: the default */
  const char *title;              /* of the figure; NULL: none */
  bool labels;                    /* its points have numbers */
};

/*
 * ph_options_read: reads the command line of one command.
 *
 * in    argc, argv   argv[0] is the command's name; argv is permuted
 * inout options      zeroed, but for command
 * ret   PH_OK | PH_E_USAGE | PH_E_NO_MEMORY
 */
enum ph_status ph_options_read(int argc, char **argv,
                               struct ph_options *options,
                               struct ph_diag *diag);

/* ph_options_print: how results are printed. */
struct ph_print ph_options_print(const struct ph_options *options);

/* ph_option_assign: reads the FIELD=VALUE of --set or --override as of one
 * command.  ret PH_OK | PH_E_USAGE | PH_E_NO_MEMORY */
enum ph_status ph_option_assign(const struct ph_schema *schema,
                                struct ph_arena *arena,
                                struct ph_assignment *assignment,
                                struct ph_diag *diag);

/* ph_option_no_field: the failure of an option that is about a field which the
 * command does not have; name[n] is not NUL-terminated. */
enum ph_status ph_option_no_field(const struct ph_schema *schema,
                                  const char *option, const char *name,
                                  size_t n, struct ph_diag *diag);

void ph_options_free(struct ph_options *options);

#endif
