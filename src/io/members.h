/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The members of the objects that results consist of: what reads results
 * (json_result*.c) has their names from here, and what describes them
 * (cli/schema.c) all the rest; tests/cli/schema.t holds what is written
 * (json_out.c, json_curve.c) to it.
 *
 * A row is X(SYMBOL, "name", NEED, OF, "type", "what it is").  NEED is MUST of
 * what is never left out, else MAY; OF are the curves that have it, as
 * cli/schema_table.c says, ANY if all.  A type is
 *
 *   number, positive, whole (not negative), flag, text, any, a word list of
 *   cli/schema.c, or the name of an object;
 *   [N]TYPE, an array of N, [+]TYPE, of one or more, []TYPE, of any number
 *
 * where N is a number, or D, the dimension of the curve; P, a segment's control
 * points; W, the coefficients of its preimage, of Q numbers each; O, the
 * control points of an offset's piece.
 */
#ifndef PH_IO_MEMBERS_H
#define PH_IO_MEMBERS_H

/* Of every record. */
#define PH_HEADING_MEMBERS(X)                                      \
  X(ID, "id", MAY, ANY, "id", "that of the problem")               \
  X(META, "meta", MAY, ANY, "any", "that of the problem")          \
  X(COMMAND, "command", MUST, ANY, "command", "the command")       \
  X(STATUS, "status", MUST, ANY, "status", "whether it succeeded") \
  X(SWEEP, "sweep", MAY, ANY, "sweep",                             \
    "the value of each field that is swept, of FIELD* the factor") \
  X(SET, "set", MAY, ANY, "set",                                   \
    "the value of each field that options have set")

/* Of what is solved; CENTER to INDICATORS as ph_read_sphere has them. */
#define PH_RESULT_MEMBERS(X)                                                 \
  X(CURVE, "curve", MUST, ANY, "curve", "the kind of curve")                 \
  X(DIMENSION, "dimension", MUST, ANY, "D", "2 in the plane, 3 in space")    \
  X(DEGREE, "degree", MUST, ANY, "degree",                                   \
    "of the segments: the number of their control points less one")          \
  X(CLOSED, "closed", MUST, ANY, "flag", "whether the curve is closed")      \
  X(SEGMENTS, "segments", MUST, ANY, "[+]segment", "the curve")              \
  X(CENTER, "center", MUST, SPHERE, "[3]number", "of the sphere")            \
  X(RADIUS, "radius", MUST, SPHERE, "positive", "of the sphere")             \
  X(TENSIONS, "tensions", MUST, SPHERE, "[+]number", "of each point")        \
  X(INDICATORS, "indicators", MUST, SPHERE, "[+]sign",                       \
    "at each point: 1 where the data turn left, -1 right, else 0")           \
  X(INTERVALS, "intervals", MAY, INTERVALS, "[+]interval",                   \
    "between consecutive data, or of each curve that is approximated")       \
  X(LENGTH, "length", MUST, ANY, "number", "the arc length of the curve")    \
  X(OFFSETS, "offsets", MAY, ANY, "[+]offset",                               \
    "one for each distance, in space four")                                  \
  X(FRAME, "frame", MAY, SPACE, "frame", "which frame the samples have")     \
  X(SAMPLES, "samples", MAY, ANY, "[+]sample", "of the curve, in its order") \
  X(DIAGNOSTICS, "diagnostics", MUST, ANY, "certificate",                    \
    "the certificate of the curve, and how it was found")                    \
  X(SOLUTIONS, "solutions", MAY, ANY, "[+]solution",                         \
    "all curves that were found, the first is that of the record")           \
  X(WARNINGS, "warnings", MAY, ANY, "[+]warning", "if there are any")

#define PH_SEGMENT_MEMBERS(X)                                               \
  X(INTERVAL, "interval", MUST, ANY, "[2]number",                           \
    "the knots between which the segment lies")                             \
  X(ALPHA, "alpha", MUST, ATPH, "positive", "the angle of the segment")     \
  X(CONTROL_POINTS, "control_points", MUST, ANY, "[P][D]number",            \
    "the Bezier points; of atph the coefficients in its B-basis")           \
  X(PREIMAGE, "preimage", MUST, SQUARE, "[W][Q]number",                     \
    "coefficients of the function whose square is the derivative")          \
  X(LENGTH, "length", MUST, ANY, "number", "the arc length of the segment") \
  X(TENSION, "tension", MUST, TENSION, "number",                            \
    "by its square the derivatives at both ends were scaled")               \
  X(ANGLES, "angles", MAY, TENSION, "[2]number", "theta and beta")          \
  X(SHAPE_OK, "shape_ok", MUST, TENSION, "flag",                            \
    "whether the segment keeps the shape of its data")                      \
  X(BLASCHKE, "blaschke", MAY, CUBIC, "[]image",                            \
    "the image of the segment on the Blaschke cylinder")

/* Of a piece of an image on the Blaschke cylinder. */
#define PH_IMAGE_MEMBERS(X)                                    \
  X(IMAGE_INTERVAL, "interval", MUST, ANY, "[2]number",        \
    "the part of the segment, in its local parameter")         \
  X(IMAGE_POINTS, "control_points", MUST, ANY, "[6][3]number", \
    "of a rational Bezier curve")                              \
  X(IMAGE_WEIGHTS, "weights", MUST, ANY, "[6]positive", "of the points")

#define PH_INTERVAL_MEMBERS(X)                                \
  X(LENGTH, "length", MUST, ANY, "number",                    \
    "the arc length of the curve in this interval")           \
  X(NATURAL_LENGTH, "natural_length", MAY, LENGTHS, "number", \
    "what it is on the curve whose lengths are free")         \
  X(SEGMENTS, "segments", MUST, ANY, "[2]whole",              \
    "the first and the last of its segments")                 \
  X(ROOT, "root", MAY, CUBIC, "root", "which solution it is") \
  X(RATIO, "D", MAY, CUBIC, "number", "of one cubic")         \
  X(LAMBDA, "lambda", MAY, CUBIC, "number",                   \
    "length of the derivatives over that of the chord")       \
  X(JOINT_ANGLE, "joint_angle", MAY, CUBIC, "number",         \
    "from the chord to the curve, at a joint on it")          \
  X(JOINT_POSITION, "joint_position", MAY, CUBIC, "number",   \
    "the part of the chord before a joint on it")

#define PH_SOLUTION_MEMBERS(X)                                            \
  X(GOOD, "good", MUST, ANY, "flag",                                      \
    "whether it is the curve that would be given alone")                  \
  X(SEGMENTS, "segments", MUST, ANY, "[+]segment", "the curve")           \
  X(INTERVALS, "intervals", MAY, INTERVALS, "[+]interval",                \
    "if the record has them")                                             \
  X(LENGTH, "length", MUST, ANY, "number", "the arc length of the curve") \
  X(DIAGNOSTICS, "diagnostics", MUST, ANY, "diagnostics", "of this curve")

#define PH_OFFSET_MEMBERS(X)                                              \
  X(DISTANCE, "distance", MUST, ANY, "number",                            \
    "in the plane and on a sphere positive to the left of travel")        \
  X(VECTOR, "vector", MUST, SPACE, "vector",                              \
    "of the frame, along which the distance is measured")                 \
  X(DEGREE, "degree", MUST, FLAT, "offset-degree", "of its segments")     \
  X(SEGMENTS, "segments", MUST, FLAT, "[+]piece", "the offset")           \
  X(BEZIERS, "beziers", MUST, QUOTIENT, "[+]bezier",                      \
    "polynomial Bezier pieces of the offset, within the tolerance")       \
  X(ERROR, "error", MUST, QUOTIENT, "number",                             \
    "the greatest distance of these from the offset that was found")      \
  X(LENGTH, "length", MAY, ANY, "number", "the arc length of the offset") \
  X(CUSPS, "cusps", MUST, ANY, "[]cusp", "where the offset turns back")   \
  X(GAPS, "gaps", MUST, ANY, "[]whole",                                   \
    "the segments before which the offset jumps")                         \
  X(SAMPLES, "samples", MAY, ANY, "[+]sample", "of the offset, in its order")

/* Of a piece of an offset: rational, or a quotient. */
#define PH_PIECE_MEMBERS(X)                                             \
  X(PIECE_SEGMENT, "segment", MUST, ANY, "whole", "of the curve")       \
  X(INTERVAL, "interval", MUST, ANY, "[2]number",                       \
    "the part of the segment, in its local parameter")                  \
  X(CONTROL_POINTS, "control_points", MUST, RATIONAL, "[O][D]number",   \
    "of a rational Bezier curve")                                       \
  X(WEIGHTS, "weights", MUST, RATIONAL, "[O]positive", "of the points") \
  X(NUMERATOR, "numerator", MUST, QUOTIENT, "[O][D]number",             \
    "of what has to be added to the curve, in its B-basis")             \
  X(DENOMINATOR, "denominator", MUST, QUOTIENT, "[O]number", "of the same")

/* Of a polynomial piece of an offset. */
#define PH_BEZIER_MEMBERS(X)                                      \
  X(PIECE_SEGMENT, "segment", MUST, ANY, "whole", "of the curve") \
  X(INTERVAL, "interval", MUST, ANY, "[2]number",                 \
    "the part of the segment, in its local parameter")            \
  X(CONTROL_POINTS, "control_points", MUST, ANY, "[P][D]number",  \
    "the Bezier points")

#define PH_CUSP_MEMBERS(X)                                            \
  X(SEGMENT, "segment", MUST, ANY, "whole", "of the curve beside it") \
  X(T, "t", MUST, ANY, "number", "the local parameter in the segment")

#define PH_SAMPLE_MEMBERS(X)                                               \
  X(SEGMENT, "segment", MUST, ANY, "whole", "of the curve")                \
  X(T, "t", MUST, ANY, "number",                                           \
    "the local parameter in the segment, from 0 to 1, for atph to alpha")  \
  X(S, "s", MUST, ANY, "number", "the arc length from the beginning")      \
  X(POINT, "point", MUST, ANY, "[D]number", "the point")                   \
  X(TANGENT, "tangent", MAY, ANY, "[D]number", "the unit tangent")         \
  X(CURVATURE, "curvature", MAY, ANY, "number",                            \
    "in the plane and on a sphere positive where the curve turns left")    \
  X(TORSION, "torsion", MAY, SPACE, "number", "the torsion")               \
  X(LONLAT, "lonlat", MUST, SPHERE, "[2]number",                           \
    "longitude and latitude in degrees, as seen from the center")          \
  X(NORMAL, "normal", MAY, SPACE, "[3]number", "unit vector of the frame") \
  X(BINORMAL, "binormal", MAY, SPACE, "[3]number", "unit vector of the frame")

/* Of the member diagnostics, besides the rows of PH_DIAGNOSTICS. */
#define PH_CERTIFICATE_MEMBERS(X)                                            \
  X(KANTOROVICH, "kantorovich", MAY, ANY, "kantorovich",                     \
    "the theorem of Kantorovich for the equations of the solver")            \
  X(START, "start", MAY, LENGTHS, "text", "the start that led to the curve") \
  X(STARTS, "starts", MAY, LENGTHS, "[+]start", "that were tried, in order") \
  X(NATURAL_LENGTHS, "natural_lengths", MAY, LENGTHS, "[+]number",           \
    "the lengths of the curve whose lengths are free")

#define PH_KANTOROVICH_MEMBERS(X)                                         \
  X(B, "B", MAY, ANY, "number", "a bound of the inverse of the Jacobian") \
  X(C, "C", MAY, ANY, "number", "the length of the next step of Newton")  \
  X(K, "K", MAY, ANY, "number", "a Lipschitz constant of the Jacobian")   \
  X(H, "h", MAY, ANY, "number", "the product of these")                   \
  X(RADIUS, "radius", MAY, ANY, "number",                                 \
    "of a ball around the unknowns that contains an exact solution")      \
  X(CERTIFIED, "certified", MUST, ANY, "flag", "whether h is at most 1/2")

#define PH_START_MEMBERS(X)                                        \
  X(START, "start", MUST, ANY, "text", "its name")                 \
  X(OUTCOME, "outcome", MUST, ANY, "outcome", "what became of it") \
  X(F, "F", MAY, ANY, "number", "the functional it led to")        \
  X(ITERATIONS, "iterations", MUST, ANY, "whole", "the steps that it took")

#define PH_WARNING_MEMBERS(X)                                         \
  X(CODE, "code", MUST, ANY, "warning-code", "what it is about")      \
  X(SEGMENT, "segment", MAY, ANY, "whole", "the first one concerned") \
  X(MESSAGE, "message", MUST, ANY, "text", "what was found")

/* Of a record that failed, besides its heading. */
#define PH_FAILURE_MEMBERS(X) \
  X(ERROR, "error", MUST, ANY, "error", "why there is no result")

#define PH_ERROR_MEMBERS(X)                                                 \
  X(CODE, "code", MUST, ANY, "code", "what it is about")                    \
  X(MESSAGE, "message", MUST, ANY, "text", "what was found and is allowed") \
  X(FIELD, "field", MAY, ANY, "text", "which field, or element of it")      \
  X(FILE, "file", MAY, ANY, "text", "that the problem stands in, or -")     \
  X(LINE, "line", MAY, ANY, "whole", "in the file, from 1")                 \
  X(COLUMN, "column", MAY, ANY, "whole", "in the line, in bytes, from 1")

/* Of what verify says of a result: what it is of, in failures as it stands
 * there; and what was found. */
#define PH_OF_MEMBERS(X) \
  X(OF, "of", MUST, ANY, "method", "the command of the result")

#define PH_NAMED_MEMBERS(X) \
  X(OF, "of", MUST, ANY, "text", "what the result has as its command")

#define PH_CLAIMS_MEMBERS(X)                  \
  X(CLAIMS, "claims", MUST, ANY, "no-claims", \
    "the result is an error record, which claims no curve")

#define PH_VERDICT_MEMBERS(X)                                           \
  X(CURVE, "curve", MUST, ANY, "kind", "the kind of curve")             \
  X(SEGMENTS, "segments", MUST, ANY, "whole", "how many the curve has") \
  X(WORST, "worst", MAY, ANY, "worst", "the largest of all errors")     \
  X(CHECKS, "checks", MUST, ANY, "checks", "the largest error of each check")

#define PH_WORST_MEMBERS(X)                          \
  X(CHECK, "check", MUST, ANY, "check", "its check") \
  X(ERROR, "error", MUST, ANY, "number", "the error, relative")

#endif
