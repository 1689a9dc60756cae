/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The one list of outcomes: every fallible function returns one of these.
 *
 * A row is X(SYMBOL, "code", CLASS, "meaning").  The code is the stable name
 * that users see in records and messages; the class decides the exit status
 * (enum ph_class).  An error, PH_E_..., fails its record; a warning, PH_W_...,
 * does so only under --strict.  Adding an outcome is adding a row.
 */
#ifndef PH_BASE_STATUS_H
#define PH_BASE_STATUS_H

#include <stdbool.h>

/* Classes double as exit statuses of the program; the highest one wins. */
enum ph_class {
  PH_CLASS_OK = 0,
  PH_CLASS_RECORD = 1,
  PH_CLASS_USAGE = 2,
  PH_CLASS_INPUT = 3,
  PH_CLASS_OUTPUT = 4,
  PH_CLASS_INTERNAL = 5
};

#define PH_ERRORS(X)                                                           \
  X(E_SYNTAX, "syntax", RECORD, "the text is not JSON or CSV")                 \
  X(E_UNKNOWN_FIELD, "unknown-field", RECORD, "the command has no such field") \
  X(E_MISSING_FIELD, "missing-field", RECORD, "a required field is absent")    \
  X(E_BAD_TYPE, "bad-type", RECORD, "a value of the wrong type")               \
  X(E_BAD_VALUE, "bad-value", RECORD, "a value that is not allowed")           \
  X(E_BAD_SHAPE, "bad-shape", RECORD, "array lengths disagree")                \
  X(E_NOT_FINITE, "not-finite", RECORD, "a number is not finite")              \
  X(E_TOO_FEW_POINTS, "too-few-points", RECORD, "not enough points")           \
  X(E_COINCIDENT_POINTS, "coincident-points", RECORD,                          \
    "two consecutive points are equal")                                        \
  X(E_ZERO_TANGENT, "zero-tangent", RECORD, "a derivative or tangent is zero") \
  X(E_ANTIPODAL_POINTS, "antipodal-points", RECORD,                            \
    "two consecutive points are opposite to each other on the sphere")         \
  X(E_NOT_ON_SPHERE, "not-on-sphere", RECORD, "a point is not on the sphere")  \
  X(E_INFEASIBLE, "infeasible", RECORD, "proved to have no solution")          \
  X(E_NO_CONVERGENCE, "no-convergence", RECORD,                                \
    "the solver did not reach its tolerance")                                  \
  X(E_TOO_LARGE, "too-large", RECORD,                                          \
    "a result exceeds the range of a double")                                  \
  X(E_LIMIT, "limit", RECORD, "a record needs more than an option allows")     \
  X(E_NOT_VERIFIED, "not-verified", RECORD,                                    \
    "a result is not what it says, or solves none of the problems")            \
  X(E_USAGE, "usage", USAGE, "the command line is wrong")                      \
  X(E_INPUT, "input", INPUT, "the input cannot be read")                       \
  X(E_OUTPUT, "output", OUTPUT, "the output cannot be written")                \
  X(E_NO_MEMORY, "out-of-memory", INTERNAL, "memory is exhausted")             \
  X(E_INTERNAL, "internal", INTERNAL, "a broken invariant of the program")

#define PH_WARNINGS(X)                                                     \
  X(W_REVERSAL, "reversal", RECORD,                                        \
    "the data turn back by exactly 180 degrees")                           \
  X(W_LOOP, "loop", RECORD, "a segment turns by more than 180 degrees")    \
  X(W_OFFSET_CUSP, "offset-cusp", RECORD, "an offset has cusps")           \
  X(W_OFFSET_GAP, "offset-gap", RECORD, "an offset has gaps")              \
  X(W_OFFSET_EMPTY, "offset-empty", RECORD,                                \
    "nothing is left of a trimmed offset")                                 \
  X(W_OFFSET_TOUCH, "offset-touch", RECORD,                                \
    "a trimmed offset comes to touch itself")                              \
  X(W_SELF_CROSSING, "self-crossing", RECORD,                              \
    "a curve whose offset is trimmed crosses itself")                      \
  X(W_LARGE_ALPHA, "large-alpha", RECORD, "an alpha above 2 pi/3")         \
  X(W_AMBIGUOUS, "ambiguous", RECORD, "another good curve exists")         \
  X(W_CUT_SHORT, "cut-short", RECORD,                                      \
    "the search for a minimum ended at its limit of steps")                \
  X(W_SHAPE_UNSATISFIABLE, "shape-unsatisfiable", RECORD,                  \
    "no tension keeps the shape of the data")                              \
  X(W_INFINITE_FUNCTIONAL, "infinite-functional", RECORD,                  \
    "of a segment F2 or F3 is infinite, and F1 the least")                 \
  X(W_WIGGLE, "wiggle", RECORD,                                            \
    "lengths that differ from the natural ones make the curve wiggle")     \
  X(W_INCONSISTENT_LENGTHS, "inconsistent-lengths", RECORD,                \
    "the lengths fit no smooth curve through the points")                  \
  X(W_SADDLE, "saddle", RECORD, "the curve is stationary, but no minimum") \
  X(W_LEAVES_PLANE, "leaves-plane", RECORD,                                \
    "no plane curve was found for data in a plane")                        \
  X(W_NATURAL_UNKNOWN, "natural-unknown", RECORD,                          \
    "the curve with free lengths was not found")                           \
  X(W_SHARP_CORNERS, "sharp-corners", RECORD,                              \
    "the curve is nearly a polygon with sharp corners")                    \
  X(W_MOVED_POINTS, "moved-points", RECORD,                                \
    "points were moved onto the sphere")                                   \
  X(W_DEGREES, "degrees", RECORD,                                          \
    "longitudes and latitudes were taken as x and y")                      \
  X(W_MERGED_POINTS, "merged-points", RECORD,                              \
    "points that are near each other were joined")                         \
  X(W_FAR_CONTACT, "far-contact", RECORD,                                  \
    "contact points are far from the given points")                        \
  X(W_VERTEX_INSIDE, "vertex-inside", RECORD,                              \
    "the vertex of a cone is within the height")                           \
  X(W_SIGN_CHANGE, "sign-change", RECORD,                                  \
    "the normal curvature of a surface changes its sign")                  \
  X(W_LARGE_ARC, "large-arc", RECORD,                                      \
    "a strip turns by more than 180 degrees")                              \
  X(W_OUTSIDE, "outside", RECORD,                                          \
    "points are outside of the flat pattern of a surface")                 \
  X(W_G1_JOINTS, "g1-joints", RECORD, "the curvature jumps at joints")     \
  X(W_AUXILIARY_POINTS, "auxiliary-points", RECORD,                        \
    "points were added to the data")                                       \
  X(W_NEAR_CUSP, "near-cusp", RECORD, "a cubic is nearly a cusp")          \
  X(W_SPLINE_PAIRS, "spline-pairs", RECORD,                                \
    "intervals have curves whose curvature jumps, which bend less")        \
  X(W_UNEVEN_CHORDS, "uneven-chords", RECORD,                              \
    "chords are so uneven that the command planar is better")              \
  X(W_FOLDED, "folded", RECORD, "a surface is folded")

#define PH_STATUS(X) X(OK, "ok", OK, "solved") PH_ERRORS(X) PH_WARNINGS(X)

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

/* ph_status_is_warning: whether it is a row of PH_WARNINGS. */
bool ph_status_is_warning(enum ph_status status);

/* ph_status_class: the class of a status, which is its exit status. */
enum ph_class ph_status_class(enum ph_status status);

#endif
