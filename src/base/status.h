/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The one list of outcomes: every fallible function returns one of these.
 *
 * A row is X(SYMBOL, "code", CLASS, "meaning").  The code is the stable name
 * that users see in records and messages; the class decides the exit status
 * (enum ph_class).  A warning is an outcome that fails its record only under
 * --strict.  Adding an outcome is adding a row.
 */
#ifndef PH_BASE_STATUS_H
#define PH_BASE_STATUS_H

/* Classes double as exit statuses of the program; the highest one wins. */
enum ph_class {
  PH_CLASS_OK = 0,
  PH_CLASS_RECORD = 1,
  PH_CLASS_USAGE = 2,
  PH_CLASS_INPUT = 3,
  PH_CLASS_OUTPUT = 4,
  PH_CLASS_INTERNAL = 5
};

#define PH_STATUS(X)                                                           \
  X(OK, "ok", OK, "solved")                                                    \
  X(SYNTAX, "syntax", RECORD, "the text is not JSON or CSV")                   \
  X(UNKNOWN_FIELD, "unknown-field", RECORD, "the command has no such field")   \
  X(MISSING_FIELD, "missing-field", RECORD, "a required field is absent")      \
  X(BAD_TYPE, "bad-type", RECORD, "a value of the wrong type")                 \
  X(BAD_VALUE, "bad-value", RECORD, "a value that is not allowed")             \
  X(BAD_SHAPE, "bad-shape", RECORD, "array lengths disagree")                  \
  X(NOT_FINITE, "not-finite", RECORD, "a number is not finite")                \
  X(TOO_FEW_POINTS, "too-few-points", RECORD, "not enough points")             \
  X(COINCIDENT_POINTS, "coincident-points", RECORD,                            \
    "two consecutive points are equal")                                        \
  X(ZERO_TANGENT, "zero-tangent", RECORD, "a derivative or tangent is zero")   \
  X(ANTIPODAL_POINTS, "antipodal-points", RECORD,                              \
    "two consecutive points are opposite to each other on the sphere")         \
  X(NOT_ON_SPHERE, "not-on-sphere", RECORD, "a point is not on the sphere")    \
  X(INFEASIBLE, "infeasible", RECORD, "proved to have no solution")            \
  X(NO_CONVERGENCE, "no-convergence", RECORD,                                  \
    "the solver did not reach its tolerance")                                  \
  X(TOO_LARGE, "too-large", RECORD, "a result exceeds the range of a double")  \
  X(LIMIT, "limit", RECORD, "a record needs more than an option allows")       \
  X(NOT_VERIFIED, "not-verified", RECORD,                                      \
    "a result is not what it says, or solves none of the problems")            \
  X(REVERSAL, "reversal", RECORD,                                              \
    "warning: the data turn back by exactly 180 degrees")                      \
  X(LOOP, "loop", RECORD, "warning: a segment turns by more than 180 degrees") \
  X(OFFSET_CUSP, "offset-cusp", RECORD, "warning: an offset has cusps")        \
  X(OFFSET_GAP, "offset-gap", RECORD, "warning: an offset has gaps")           \
  X(LARGE_ALPHA, "large-alpha", RECORD, "warning: an alpha above 2 pi/3")      \
  X(AMBIGUOUS, "ambiguous", RECORD, "warning: another good curve exists")      \
  X(SHAPE_UNSATISFIABLE, "shape-unsatisfiable", RECORD,                        \
    "warning: no tension keeps the shape of the data")                         \
  X(WIGGLE, "wiggle", RECORD,                                                  \
    "warning: lengths that differ from the natural ones make the curve "       \
    "wiggle")                                                                  \
  X(INCONSISTENT_LENGTHS, "inconsistent-lengths", RECORD,                      \
    "warning: the lengths fit no smooth curve through the points")             \
  X(SADDLE, "saddle", RECORD,                                                  \
    "warning: the curve is stationary, but no minimum")                        \
  X(LEAVES_PLANE, "leaves-plane", RECORD,                                      \
    "warning: no plane curve was found for data in a plane")                   \
  X(NATURAL_UNKNOWN, "natural-unknown", RECORD,                                \
    "warning: the curve with free lengths was not found")                      \
  X(SHARP_CORNERS, "sharp-corners", RECORD,                                    \
    "warning: the curve is nearly a polygon with sharp corners")               \
  X(MOVED_POINTS, "moved-points", RECORD,                                      \
    "warning: points were moved onto the sphere")                              \
  X(MERGED_POINTS, "merged-points", RECORD,                                    \
    "warning: points that are near each other were joined")                    \
  X(FAR_CONTACT, "far-contact", RECORD,                                        \
    "warning: contact points are far from the given points")                   \
  X(VERTEX_INSIDE, "vertex-inside", RECORD,                                    \
    "warning: the vertex of a cone is within the height")                      \
  X(SIGN_CHANGE, "sign-change", RECORD,                                        \
    "warning: the normal curvature of a surface changes its sign")             \
  X(LARGE_ARC, "large-arc", RECORD,                                            \
    "warning: a strip turns by more than 180 degrees")                         \
  X(USAGE, "usage", USAGE, "the command line is wrong")                        \
  X(INPUT, "input", INPUT, "the input cannot be read")                         \
  X(OUTPUT, "output", OUTPUT, "the output cannot be written")                  \
  X(NO_MEMORY, "out-of-memory", INTERNAL, "memory is exhausted")               \
  X(INTERNAL, "internal", INTERNAL, "a broken invariant of the program")

enum ph_status {
#define X(symbol, code, class, meaning) PH_##symbol,
  PH_STATUS(X)
#undef X
      PH_STATUS_N
};

/* ph_status_code: the stable name of a status, as in error records. */
const char *ph_status_code(enum ph_status status);

/* ph_status_meaning: one line on a status, for the documentation. */
const char *ph_status_meaning(enum ph_status status);

/* ph_status_class: the class of a status, which is its exit status. */
enum ph_class ph_status_class(enum ph_status status);

#endif
