/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A result: the curve, what was derived from it, and its certificate, as plain
 * arrays that belong to the record's arena.  The shared vocabulary of solvers,
 * certificates and writers.
 */
#ifndef PH_CURVE_RESULT_H
#define PH_CURVE_RESULT_H

#include "base/diag.h"
#include "base/mem.h"
#include "curve/bezier/splines.h"
#include "curve/g2.h"
#include "curve/offset/loops.h"
#include "curve/sample/samples.h"
#include "curve/surface/surface.h"

#include <math.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* Curve kinds: X(SYMBOL, its ph_kind_..., "name in records"); a kind is a row
 * here and a file in curve/kind (curve/kind/kind.h). */
#define PH_CURVES(X)                            \
  X(PH, ph, "ph")                               \
  X(ATPH, atph, "atph")                         \
  X(BEZIER, bezier, "bezier")                   \
  X(TC, tc, "tc")                               \
  X(SPHERICAL_NU, spherical_nu, "spherical-nu") \
  X(CONE, cone, "cone-spline")                  \
  X(BUBBLE, bubble, "bubble")

enum ph_curve_kind {
#define X(symbol, kind, name) PH_CURVE_##symbol,
  PH_CURVES(X)
#undef X
      PH_CURVE_N
};

/*
 * What PH and ATPH curves and Tschirnhausen cubics have: the hodograph is a
 * square.
 *
 * v[curve.n][n][dimension]
 *      planar: complex w, r' = w^2 with respect to the local parameter, u in
 *      [0,1] or t; spatial: quaternions A, r' = A i A*; coefficients in the
 *      segment's space; unit^(1/2)
 * alpha[curve.n]  atph: the angles, segment k has t in [0, alpha[k]]; else NULL
 */
struct ph_preimage {
  size_t n, dimension; /* 0: there is none */
  double *v;
  double *alpha;
};

/*
 * What was chosen for the segments of spatial Hermite interpolants, else NULL
 * (solve/spatial/method.c).
 *
 * tension[curve.n]    by its square the derivatives at both ends were scaled
 * angles[curve.n][2]  theta and beta; NaN where there are none
 * shape_ok[curve.n]   whether the segment keeps the shape of its data
 */
struct ph_choice {
  double *tension;
  double *angles;
  bool *shape_ok;
};

/*
 * Of spherical nu-splines: control points of de Casteljau's algorithm by great
 * circles (curve/segment/spherical.h), on the sphere, degree 3.
 *
 * tensions    nu at the nodes, as many as the data have: curve.n, and one more
 *             unless it is closed
 * indicators  the sign of the turn of the data at the nodes, 0 where they are
 *             on a great circle (and at the ends of an open curve)
 * waived      nodes, increasing, where the shape of the data is not kept: a
 *             criterion of the node, or of the segment that begins there, was
 *             gone on without
 */
struct ph_sphere {
  double center[3];
  double radius; /* 0: the curve is on none */
  double *tensions;
  signed char *indicators;
  size_t *waived; /* [waived_n] */
  size_t waived_n;
};

/*
 * A piece of the image of a plane curve on the Blaschke cylinder, a rational
 * Bezier curve of degree 5 (curve/offset/blaschke.h).
 */
struct ph_blaschke {
  size_t segment;     /* of the curve; pieces are in its order */
  double interval[2]; /* the part of it, in its local parameter [0,1] */
  double control_points[6][3];
  double weights[6]; /* > 0 */
};

/* The images of cubics, where asked for. */
struct ph_images {
  struct ph_blaschke *v;
  size_t n;
};

/*
 * A spline of n segments, and what its kind has besides.  Coordinates are in
 * the unit of the data.
 *
 * control_points[n][degree + 1][dimension]   Bernstein-Bezier, on [0,1];
 *      atph: the normalised B-basis of <1, t, sin t, cos t, sin 2t, cos 2t>
 *      bezier: plain Bezier points, no preimage
 *      tc: Tschirnhausen cubics, degree 3, preimages of degree 1
 *      (curve/segment/tc.h)
 * joined          control_points[n * degree + 1][dimension]: what a segment
 *      ends with is what the next one begins with, and stands there once
 * knots[n + 1]    global parameter at the joints, increasing
 * lengths[n]      exact arc lengths; length is their sum
 */
struct ph_curve {
  enum ph_curve_kind kind;
  bool closed;
  bool joined;
  size_t dimension;
  size_t degree;
  size_t n;
  double *knots;
  double *control_points;
  double *lengths;
  double length;
  struct ph_preimage preimage;
  struct ph_choice choice;
  struct ph_images blaschke;
  struct ph_g2 g2;
  struct ph_sphere sphere;
  struct ph_surface surface;
};

/* Where a curve lies; PH_SURFACE, PH_PATCHWORK: it is a surface itself, of
 * strips or of patches. */
enum ph_space { PH_PLANE, PH_SPACE, PH_SPHERE, PH_SURFACE, PH_PATCHWORK };

enum { PH_SPACES = PH_PATCHWORK + 1 };

/*
 * Polynomial Bezier pieces of a curve or offset.
 *
 * segment[n]       the curve segment that the piece belongs to
 * interval[n][2]   the part of that segment, in its local parameter [0,1]
 * control_points[n][degree + 1][dimension]
 */
struct ph_pieces {
  size_t degree;
  size_t dimension;
  size_t n;
  size_t *segment;
  double *interval;
  double *control_points;
  double error; /* greatest distance from the exact curve */
};

/* A place on a curve. */
struct ph_place {
  size_t segment;
  double u; /* its local parameter, brought to [0,1] */
  double t; /* its local parameter: in [0,1], atph: [0, alpha] */
};

/* Where an offset turns back along its curve (curve/offset/cusp.h), in order.
 */
struct ph_cusps {
  size_t n;
  struct ph_place *at; /* [n]; NULL if n = 0 */
};

/* Where an offset jumps from one segment to the next (curve/offset/gap.h). */
struct ph_gaps {
  size_t n;
  size_t *before; /* [n] the segments that follow, increasing; NULL if n = 0 */
};

/*
 * One offset curve: n rational Bezier pieces of a PH curve, or n quotients of
 * an ATPH curve and its approximation by polynomial pieces
 * (curve/offset/offset.h); on a sphere, samples alone
 * (curve/kind/spherical.c).
 *
 * segment[n]       the curve segment that the piece belongs to
 * interval[n][2]   the part of that segment, in its local parameter [0,1]
 * control_points[n][degree + 1][dimension], weights[n][degree + 1] > 0
 */
struct ph_offset {
  double distance;    /* signed, positive to the left of travel */
  const char *vector; /* in space: of the frame, "e2" or "e3"; else NULL */
  size_t degree;
  size_t dimension;
  size_t n;
  size_t *segment;
  double *interval;
  double *control_points; /* NULL for an ATPH curve */
  double *weights;
  double *numerator;   /* ATPH: [n][5][dimension] of the displacement */
  double *denominator; /* ATPH: [n][5] */
  struct ph_pieces pieces;
  struct ph_cusps cusps;
  struct ph_gaps gaps;
  struct ph_samples samples; /* n = 0: none; on a sphere there are always */
  double length;             /* NaN unless there are samples, or loops */
  struct ph_loops loops;     /* in place of pieces, n = 0 */
  struct ph_splines nurbs;   /* of pieces */
};

/*
 * Diagnostics: X(SYMBOL, "name in records", "type", "what it is"); a type is
 * number, flag (1 or 0) or a list of words (ph_words), one by its index.
 */
#define PH_DIAGNOSTICS(X)                                                      \
  X(ITERATIONS, "iterations", "number",                                        \
    "steps of the iteration of the solver, or how often it evaluated")         \
  X(RESIDUAL, "residual", "number",                                            \
    "what remains of the equations of the solver, relative to the data")       \
  X(INTERPOLATION_ERROR, "interpolation_error", "number",                      \
    "the largest distance of a joint from its point, relative")                \
  X(END_DERIVATIVE_ERROR, "end_derivative_error", "number",                    \
    "the largest difference of the end derivatives from those asked for")      \
  X(TANGENT_ERROR, "tangent_error", "number",                                  \
    "the largest difference of a tangent from that asked for")                 \
  X(PYTHAGOREAN_ERROR, "pythagorean_error", "number",                          \
    "the largest difference of the derivative from that of the preimage")      \
  X(CONTINUITY_ERROR, "continuity_error", "number",                            \
    "the largest jump of the derivatives at a knot, relative")                 \
  X(LENGTH_ERROR, "length_error", "number",                                    \
    "the largest difference of a length from quadrature, relative")            \
  X(DISTANCE, "distance", "number",                                            \
    "a bound of the Hausdorff distance from what is approximated")             \
  X(CONVERSION_ERROR, "conversion_error", "number",                            \
    "the greatest distance of a Bezier segment from the exact curve")          \
  X(F, "F", "number", "the functional that is minimised")                      \
  X(F_RELAXED, "F_relaxed", "number",                                          \
    "the same of the curve whose lengths are free")                            \
  X(KKT_ERROR, "kkt_error", "number",                                          \
    "what is left of the gradient at the minimum, relative")                   \
  X(SECOND_ORDER, "second_order", "outcome",                                   \
    "what the curve was proved to be: a minimum, or a saddle")                 \
  X(G2_ERROR, "g2_error", "number",                                            \
    "the largest jump of the curvature where none is listed, over the "        \
    "largest curvature at a joint")                                            \
  X(PLANAR, "planar", "flag",                                                  \
    "whether the curve lies in the plane of its data")                         \
  X(LENGTH_RMS, "length_rms", "number",                                        \
    "root mean square of the differences of lengths, in deviations")           \
  X(TANGENT_RMS, "tangent_rms", "number",                                      \
    "root mean square of the angles to the tangents, in deviations")           \
  X(TANGENT_WEIGHT, "tangent_weight", "number",                                \
    "of the squares of these angles beside F")                                 \
  X(MIN_SPEED, "min_speed", "number",                                          \
    "the smallest speed, relative to the mean")                                \
  X(FUNCTIONAL, "functional", "number",                                        \
    "the least value of the functional that was found")                        \
  X(FUNCTIONAL_START, "functional_start", "number",                            \
    "its value where the search began")                                        \
  X(AT_BOUND, "at_bound", "flag",                                              \
    "whether an angle or knot is at a bound of what is allowed")               \
  X(SPHERE_ERROR, "sphere_error", "number",                                    \
    "the largest distance of a control point from the sphere, relative")       \
  X(CURVATURE_JUMP, "curvature_jump", "number",                                \
    "the largest jump of the curvature at a point or edge, relative")          \
  X(MAX_CURVATURE, "max_curvature", "number",                                  \
    "the largest size of the curvature")                                       \
  X(TENSION_SUM, "tension_sum", "number", "the sum of the tensions")           \
  X(TENSION_RELATIVE_SUM, "tension_relative_sum", "number",                    \
    "the sum of the tensions, each times the spacing around it")               \
  X(MAX_TENSION_RELATIVE, "max_tension_relative", "number",                    \
    "the largest of the tensions, each times the spacing around it")           \
  X(SHAPE_OK, "shape_ok", "flag",                                              \
    "whether the curve keeps the shape of its data")                           \
  X(REDUCED, "reduced", "number",                                              \
    "how many segments had their tension reduced for the shape")               \
  X(FRAME_TURN, "frame_turn", "number",                                        \
    "the angle by which the frame of a closed curve comes back turned")        \
  X(REGULAR, "regular", "flag", "whether the curve stands still nowhere")      \
  X(ROOT, "root", "root",                                                      \
    "which solution it is, if there is one interval only")                     \
  X(RATIO, "D", "number", "of the one cubic, if there is one interval only")   \
  X(LAMBDA, "lambda", "number",                                                \
    "length of the derivatives over that of the chord")                        \
  X(LOOPS, "loops", "number",                                                  \
    "how many segments meet themselves, or stand still")                       \
  X(SIMPLE, "simple", "flag", "whether the curve has no two points that meet") \
  X(ENERGY, "energy", "number",                                                \
    "the integral of the squared curvature by arc length")                     \
  X(MV, "MV", "number",                                                        \
    "the integral of the squared derivative of the curvature")                 \
  X(IES, "IES", "number", "the energy times the length")                       \
  X(IMV, "IMV", "number", "MV times the cube of the length")                   \
  X(F1, "F1", "number", "the sum of the functional F1 over all segments")      \
  X(F2, "F2", "number", "the sum of the functional F2 over all segments")      \
  X(F3, "F3", "number", "the sum of the functional F3 over all segments")      \
  X(ROTATION_INDEX, "rotation_index", "number",                                \
    "by how many turns the tangent rotates, to the left")                      \
  X(ABSOLUTE_ROTATION_INDEX, "absolute_rotation_index", "number",              \
    "the same, with turns to the right counted like those to the left")        \
  X(FRAME_ERROR, "frame_error", "number",                                      \
    "the largest difference of a frame at the end of a strip, relative")       \
  X(ISOMETRY_ERROR, "isometry_error", "number",                                \
    "the largest difference of the development from the surface, relative")    \
  X(SHIFT, "shift", "number",                                                  \
    "the largest distance of a contact point from its given point")            \
  X(VERTICES_INSIDE, "vertices_inside", "number",                              \
    "how many strips have their vertex within the height")                     \
  X(SIGN_CHANGES, "sign_changes", "number",                                    \
    "across how many rulings the normal curvature changes its sign")           \
  X(LARGE_ARCS, "large_arcs", "number",                                        \
    "how many strips turn by more than 180 degrees about their axis")          \
  X(INFLECTIONS, "inflections", "number",                                      \
    "how often strips of general cones begin to bend to the other side")       \
  X(NORMAL_ERROR, "normal_error", "number",                                    \
    "the largest angle between a normal and that of its point")                \
  X(NORMAL_JUMP, "normal_jump", "number",                                      \
    "the largest angle between the normals on both sides of an edge")          \
  X(DEGREE, "degree", "number", "the highest of the blending functions")       \
  X(FOLDED, "folded", "number",                                                \
    "how many patches are folded, or rulings between strips")                  \
  X(AREA, "area", "number", "of the surface")

enum ph_diagnostic {
#define X(symbol, name, type, what) PH_D_##symbol,
  PH_DIAGNOSTICS(X)
#undef X
      PH_DIAGNOSTIC_N
};

struct ph_diagnostics {
  double value[PH_DIAGNOSTIC_N];
  uint64_t known; /* bit i: value[i] was computed */
  uint64_t
      unasked; /* bit i: nobody looks at value[i], which need not be; bit
                  PH_DIAGNOSTIC_N: the same of the theorem of Kantorovich */
};

/* ph_diagnostics_asked: whether somebody looks at one of some, one bit each. */
static inline bool
ph_diagnostics_asked(const struct ph_diagnostics *diagnostics, uint64_t some) {
  return (some & ~diagnostics->unasked) != 0;
}

#define PH_BIT(diagnostic) ((uint64_t)1 << (diagnostic))

/* ph_are_finite: whether n numbers are: x - x is 0, or else NaN. */
static inline bool ph_are_finite(const double *v, size_t n) {
  double sum = 0;
  for (size_t i = 0; i < n; i++) {
    sum += v[i] - v[i];
  }
  return sum >= 0;
}

/* ph_diagnostics_set: stores one value and marks it as known. */
static inline void ph_diagnostics_set(struct ph_diagnostics *diagnostics,
                                      enum ph_diagnostic which, double value) {
  diagnostics->value[which] = value;
  diagnostics->known |= (uint64_t)1 << which;
}

/* ph_diagnostics_known: whether one was computed. */
static inline bool
ph_diagnostics_known(const struct ph_diagnostics *diagnostics,
                     enum ph_diagnostic which) {
  return diagnostics->known >> which & 1;
}

/* ph_diagnostics_set_finite: the same; not known where it is not finite. */
static inline void ph_diagnostics_set_finite(struct ph_diagnostics *diagnostics,
                                             enum ph_diagnostic which,
                                             double value) {
  if (isfinite(value)) {
    ph_diagnostics_set(diagnostics, which, value);
  }
}

#define PH_NO_SEGMENT SIZE_MAX

/* Something that a user should know but that breaks no promise. */
struct ph_warning {
  size_t segment; /* PH_NO_SEGMENT if it concerns the whole curve */
  struct ph_diag diag;
};

/* One warning for each code at most: its message counts the segments. */
enum { PH_WARNINGS_MAX = 8 };

/* The theorem of Kantorovich at a solution of nonlinear equations: solve/ says
 * of which (solve/planar/c2.h). */
struct ph_kantorovich {
  double b, c, k, h;
  double radius;  /* infinite unless certified */
  bool certified; /* h <= 1/2 */
};

/* One of several solutions of a problem. */
struct ph_solution {
  struct ph_curve curve;
  struct ph_diagnostics diagnostics;
  struct ph_interval *intervals; /* as of ph_result; or NULL */
  bool good;                     /* the one that would have been given alone */
};

/*
 * Roots of the equations of Tschirnhausen cubics: X(SYMBOL, "name in records").
 * Of one cubic, the sign of D (solve/tc/tc.h); of a pair, the sign of w2 and
 * that of rho (solve/tc/tc.h), of which "++" is the standard pair.
 */
#define PH_ROOTS(X)    \
  X(PLUS, "+")         \
  X(MINUS, "-")        \
  X(PLUS_PLUS, "++")   \
  X(PLUS_MINUS, "+-")  \
  X(MINUS_PLUS, "-+")  \
  X(MINUS_MINUS, "--") \
  X(ON_CHORD, "chord") \
  X(STRAIGHT, "straight")

enum ph_root {
#define X(symbol, name) PH_ROOT_##symbol,
  PH_ROOTS(X)
#undef X
      PH_ROOT_N
};

/*
 * One data interval of a curve that is found with several segments in each
 * (solve/arclength/method.c), or with one or two cubics (solve/tc/method.h).
 * What there is not is NaN, of root PH_ROOT_N.
 */
struct ph_interval {
  double length;         /* of the curve between its two data */
  double natural_length; /* of the curve with free lengths */
  size_t first, last;    /* the segments it consists of */
  enum ph_root root;
  double ratio;          /* D of one cubic */
  double lambda;         /* of a pair, |derivative| at its ends / chord */
  double joint_angle;    /* of two cubics with their joint on the chord: the */
  double joint_position; /* angle to it, and the part of it before the joint */
};

/* What became of one start of an iteration: X(SYMBOL, "name in records"). */
#define PH_OUTCOMES(X)      \
  X(MINIMISER, "minimiser") \
  X(SADDLE, "saddle")       \
  X(NO_SOLUTION, "no-convergence")

enum ph_outcome {
#define X(symbol, name) PH_OUTCOME_##symbol,
  PH_OUTCOMES(X)
#undef X
      PH_OUTCOME_N
};

struct ph_start {
  const char *name; /* which start: static text */
  enum ph_outcome outcome;
  double f;          /* the functional it led to; NaN: no solution */
  size_t iterations; /* that it took */
};

/* A surface at a distance along the normals of another one. */
struct ph_parallel {
  double distance;
  struct ph_curve curve;
  struct ph_surface_samples grid;
  struct ph_patch_samples places; /* of patches, in place of the curve */
};

struct ph_result {
  struct ph_curve curve;
  double area;          /* inside of a closed curve in the plane; else NaN */
  double *offset_range; /* [2] curve/offset/range.h; NULL: not asked for */
  struct ph_offset *offsets;
  size_t offsets_n;
  struct ph_samples samples;     /* n = 0: they were not asked for */
  struct ph_splines nurbs;       /* likewise */
  struct ph_parallel *parallels; /* of a surface */
  size_t parallels_n;
  struct ph_surface_samples grid; /* of a surface */
  struct ph_patch_samples places; /* of patches */
  struct ph_located_list located; /* of a surface */
  struct ph_panorama panorama;    /* of a surface */
  struct ph_diagnostics diagnostics;
  struct ph_warning warnings[PH_WARNINGS_MAX];
  size_t warnings_n;
  bool has_kantorovich;
  struct ph_kantorovich kantorovich;
  const size_t *merged; /* data that were joined to others */
  size_t merged_n;
  struct ph_solution *solutions; /* best first; the curve is the first */
  size_t solutions_n;            /* 0: they were not asked for */
  struct ph_interval *intervals; /* in the order of the data */
  size_t intervals_n;            /* 0: an interval is a segment */
  double *deviations;            /* angles to the tangents, if measured */
  size_t deviations_n;
  struct ph_start *starts; /* in the order they were tried */
  size_t starts_n;         /* 0: there was no choice of starts */
  size_t start;            /* the one that led to the curve */
};

/* PH_INTERVAL_NONE: an interval of which nothing is known. */
#define PH_INTERVAL_NONE                                           \
  ((struct ph_interval){(double)NAN, (double)NAN, 0, 0, PH_ROOT_N, \
                        (double)NAN, (double)NAN, (double)NAN, (double)NAN})

/* ph_parts_name: the member of a record that has the parts of a curve. */
const char *ph_parts_name(enum ph_parts parts);

/* ph_words: the words of a type in records, "kind" of curves, "frame" from
 * PH_FRAME_FRENET on, "root", "outcome", "strip_method", "case" of pairs or
 * "joint", in the order of the enum and ended by NULL; NULL: the type is no
 * list of words. */
const char *const *ph_words(const char *type);

/* ph_outcome_name: the name of an outcome, as in records. */
const char *ph_outcome_name(enum ph_outcome outcome);

/* ph_warn: adds a warning about a segment, or PH_NO_SEGMENT; the message is a
 * sentence without a field. */
void ph_warn(struct ph_result *result, size_t segment, enum ph_status status,
             const char *format, ...) PH_PRINTF(4, 5);

/*
 * ph_curve_alloc: the arrays of a curve that all kinds have, and its preimage.
 *
 * inout curve  kind, n, joined and dimensions are given; and knots, or NULL
 * ret   PH_OK | PH_E_NO_MEMORY
 */
enum ph_status ph_curve_alloc(struct ph_curve *curve, struct ph_arena *arena,
                              struct ph_diag *diag);

/* ph_curve_angle: the angle of the space of segment k: alpha, else 0. */
static inline double ph_curve_angle(const struct ph_curve *curve, size_t k) {
  return curve->preimage.alpha ? curve->preimage.alpha[k] : 0;
}

/* ph_curve_range: the local parameter of segment k has t in [0, that]. */
static inline double ph_curve_range(const struct ph_curve *curve, size_t k) {
  return curve->preimage.alpha ? curve->preimage.alpha[k] : 1;
}

/* ph_curve_stride: from the numbers of a segment's control points to those of
 * the next one's. */
static inline size_t ph_curve_stride(const struct ph_curve *curve) {
  return (curve->degree + !curve->joined) * curve->dimension;
}

/* ph_curve_points: the control points of segment k, (degree + 1) of them. */
static inline const double *ph_curve_points(const struct ph_curve *curve,
                                            size_t k) {
  return curve->control_points + ph_curve_stride(curve) * k;
}

/* ph_curve_points_n: how many control points a curve has in memory. */
static inline size_t ph_curve_points_n(const struct ph_curve *curve) {
  return curve->joined ? curve->n * curve->degree + 1
                       : curve->n * (curve->degree + 1);
}

/* ph_curve_preimage: the coefficients of the preimage of segment k. */
static inline const double *ph_curve_preimage(const struct ph_curve *curve,
                                              size_t k) {
  return curve->preimage.v + curve->preimage.n * curve->preimage.dimension * k;
}

/* ph_curve_size: half the diagonal of the bounding box of the curve's knots. */
double ph_curve_size(const struct ph_curve *curve);

/* ph_curve_rounding: by how much points of the curve are off, at most, as its
 * coordinates are rounded: no approximation is nearer. */
double ph_curve_rounding(const struct ph_curve *curve);

/* ph_rounding_allows: whether an approximation can be so near to the curve at
 * all.
 *
 * in   rounding  as above; who asks often finds it once
 * ret  PH_OK | PH_E_NO_CONVERGENCE, with the message */
enum ph_status ph_rounding_allows(double rounding, double tolerance,
                                  struct ph_diag *diag);

/* ph_curve_name: the name of a curve kind, as in records. */
const char *ph_curve_name(enum ph_curve_kind kind);

/* ph_diagnostic_type, ph_diagnostic_meaning: of its row. */
const char *ph_diagnostic_type(enum ph_diagnostic which);
const char *ph_diagnostic_meaning(enum ph_diagnostic which);

/* ph_diagnostic_name: the name of a diagnostic, as in records. */
const char *ph_diagnostic_name(enum ph_diagnostic which);

#endif
