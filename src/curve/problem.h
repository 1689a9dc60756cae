/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A problem: the typed values of its fields, whatever text they came from.
 *
 * PH_FIELDS is the one list of field names of all commands.  What a field may
 * hold depends on the command: every method (solve/method.h) has a table of
 * struct ph_field rows, from which reading, checking, the long options and the
 * help text are derived.  Adding a field is adding a name here and a row there.
 */
#ifndef PH_CURVE_PROBLEM_H
#define PH_CURVE_PROBLEM_H

#include <stdbool.h>
#include <stddef.h>

#define PH_FIELDS(X)                      \
  X(POINTS, "points")                     \
  X(CLOSED, "closed")                     \
  X(MERGE, "merge")                       \
  X(BASIS, "basis")                       \
  X(KNOTS, "knots")                       \
  X(ALPHA, "alpha")                       \
  X(END_DERIVATIVES, "end_derivatives")   \
  X(SOLUTIONS, "solutions")               \
  X(MINIMIZE, "minimize")                 \
  X(FREE, "free")                         \
  X(TANGENTS, "tangents")                 \
  X(DERIVATIVES, "derivatives")           \
  X(CRITERION, "criterion")               \
  X(ANGLES, "angles")                     \
  X(AXIS, "axis")                         \
  X(TENSION, "tension")                   \
  X(SHAPE, "shape")                       \
  X(PLANARITY, "planarity")               \
  X(LENGTHS, "lengths")                   \
  X(REFINE, "refine")                     \
  X(LENGTH_SIGMA, "length_sigma")         \
  X(TANGENT_SIGMA, "tangent_sigma")       \
  X(MAGNITUDES, "magnitudes")             \
  X(PLANAR, "planar")                     \
  X(STARTS, "starts")                     \
  X(ALL_MINIMA, "all_minima")             \
  X(START, "start")                       \
  X(LONLAT, "lonlat")                     \
  X(CENTER, "center")                     \
  X(RADIUS, "radius")                     \
  X(RADIUS_TOLERANCE, "radius_tolerance") \
  X(MODEL, "model")                       \
  X(ENDS, "ends")                         \
  X(END_TANGENTS, "end_tangents")         \
  X(INCREASE, "increase")                 \
  X(EPSILON, "epsilon")                   \
  X(MODE, "mode")                         \
  X(LAMBDA, "lambda")                     \
  X(JOINT, "joint")                       \
  X(JOINT_ANGLE, "joint_angle")           \
  X(JOINT_POSITION, "joint_position")     \
  X(BLASCHKE, "blaschke")                 \
  X(CURVE, "curve")                       \
  X(PATH, "path")                         \
  X(TOLERANCE, "tolerance")               \
  X(PIECES, "pieces")                     \
  X(RULINGS, "rulings")                   \
  X(NORMALS, "normals")                   \
  X(METHOD, "method")                     \
  X(DEGENERATE, "degenerate_tolerance")   \
  X(HEIGHT, "height")                     \
  X(FLAT, "flat")                         \
  X(TRANSLATE, "translate")               \
  X(AUXILIARY, "auxiliary")               \
  X(APEXES, "apexes")                     \
  X(CONTACT_POINT, "contact_point")       \
  X(TANGENT_SCALE, "tangent_scale")       \
  X(FACES, "faces")                       \
  X(CONTINUITY, "continuity")             \
  X(DEGREE, "degree")                     \
  X(SUBDIVIDE, "subdivide")               \
  X(BOUNDARY, "boundary")                 \
  X(AT, "at")

enum ph_field_id {
#define X(symbol, name) PH_F_##symbol,
  PH_FIELDS(X)
#undef X
      PH_FIELD_N
};

/* Kinds of values; a row allows several (bits). */
enum ph_value_kind {
  PH_ABSENT = 0,
  PH_BOOL = 1,
  PH_NUMBER = 2,
  PH_WORD = 4,      /* one of the row's words */
  PH_NUMBERS = 8,   /* array of numbers */
  PH_VECTORS = 16,  /* array of arrays of 2 or 3 numbers, all of one size */
  PH_SEGMENTS = 32, /* of a row: its numbers belong to segments, not points */
  PH_POLYLINE = 64, /* array of arrays of vectors: control points of pieces;
                       of a row: beside PH_VECTORS, those of one piece */
  PH_DATUM = 128,   /* of a row: its numbers or vectors belong to points */
  PH_LISTS = 256,   /* array of arrays of numbers, of any sizes */
  PH_PATH = 512     /* of a row: SVG path data, whose value is PH_POLYLINE */
};

struct ph_value {
  enum ph_value_kind kind;
  bool flag;        /* PH_BOOL; of a path: it is closed */
  double number;    /* PH_NUMBER; PH_WORD: V of a word "name:V", else 0 */
  const char *word; /* PH_WORD, NUL-terminated; of a path: its data */
  double *v;        /* PH_NUMBERS, PH_LISTS: v[n]; PH_VECTORS, PH_POLYLINE:
                       v[n][dimension] */
  size_t n;
  size_t dimension; /* of vectors: 2 or 3; else 1 */
  size_t *sizes;    /* PH_POLYLINE: sizes[sizes_n] vectors of each piece, one
                       piece after another in v, n in all; PH_LISTS: the same
                       of numbers */
  size_t sizes_n;
};

struct ph_field {
  enum ph_field_id id;
  unsigned kinds;       /* allowed kinds, or-ed */
  unsigned dimensions;  /* of vectors: allowed sizes, bit 2 and bit 3 */
  bool required;        /* absent is an error */
  const char *words;    /* PH_WORD: allowed words, "a|b|c:V", V a number */
  const char *standard; /* what an absent field means, for the help */
  const char *help;     /* one line for the help, lower case, no full stop */
};

/* What a problem may say: the fields of one command. */
struct ph_schema {
  const char *command; /* its name, also for messages */
  const struct ph_field *fields;
  size_t fields_n;
};

/* PH_PLANARITY: what the field planarity is where it is absent.  Points of a
 * plane that were written with six digits are in it to this. */
#define PH_PLANARITY 1e-5

/* PH_SPHERE_EPSILON: what the field epsilon is where it is absent. */
#define PH_SPHERE_EPSILON 0.01

struct ph_problem {
  struct ph_value field[PH_FIELD_N]; /* by enum ph_field_id */
};

/* ph_value_is: whether a value is this word. */
bool ph_value_is(const struct ph_value *value, const char *word);

/* ph_field_name: the name of a field, as in JSON. */
const char *ph_field_name(enum ph_field_id id);

/* ph_field_find: the schema's row of the name of n bytes, or NULL. */
const struct ph_field *ph_field_find(const struct ph_schema *schema,
                                     const char *name, size_t n);

#endif
