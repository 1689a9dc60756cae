/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Fuzz target: any data through the spatial Hermite solver.  The outcome is a
 * failure of the record, or a curve: then its certificate passes or is such a
 * failure, and what is printed, with its offsets or Bezier pieces, is finite,
 * interpolates, and is JSON.
 *
 * The bytes of an input:
 *   0      bits 0 closed, 1 atph, 2-3 vectors (absent, tangents, derivatives,
 *          none), 4-5 how points are coded, 6 two coordinates, 7 indented JSON
 *   1      signed: coordinates are scaled by 2 to eight times that
 *   2      bits 0-2 the criterion, or 7 angles; 3-4 the axis (absent, chord, x,
 *          bisector), 5-6 shape (absent, false, true), 7 offsets
 *   3      bits 0-1 alpha (absent, one, one each), 2-3 tension (the same),
 *          4-5 angles (a pair, a list of one, one each), 6 knots, 7 Bezier
 *          pieces
 *   4...   the points: three or two signed bytes, signed 16-bit numbers,
 *          doubles, or steps (turn, rise, length); after each point its vector,
 *          coded alike, where vectors are given, and a byte each for what it
 *          has of alpha, tension and knots, and two for angles
 */
#include "problem.h"

#include "curve/bezier/convert.h"

enum {
  SPATIAL_POINTS_MAX = 100,
  SPATIAL_SEARCHED_MAX = 3, /* where a minimum is searched: it is slow */
  SPATIAL_SHAPED_MAX = 2,   /* and where it is, tension by tension */
  /* The most that any search has taken is a tenth of it. */
  SPATIAL_STEPS_MAX = 100000,
  /* Tensions that are tried, each by a search, where a shape is asked for: one,
   * 81 from 0.95 to 1/64, 3 for each halving from there to 1e-7, one back. */
  SPATIAL_TENSIONS_MAX = 140
};

struct spatial_flags {
  bool closed, atph, flat, pretty, knots, offsets, pieces;
  int vectors, coding, criterion, axis, shape, alpha, tension, angles;
};

struct spatial_input {
  struct fuzz_bytes bytes;
  struct spatial_flags flags;
  double scale; /* of coordinates */
  struct ph_problem problem;
  double points[3 * SPATIAL_POINTS_MAX];
  double vectors[3 * SPATIAL_POINTS_MAX];
  double alpha[SPATIAL_POINTS_MAX], tension[SPATIAL_POINTS_MAX];
  double angles[2 * SPATIAL_POINTS_MAX];
  double knots[SPATIAL_POINTS_MAX + 1];
  struct fuzz_walk walk;
};

/* Whether tensions are reduced for the shape; by default, where derivatives do
 * not say how long tangents are. */
static bool spatial_is_shaped(const struct spatial_flags *f) {
  return f->shape == 2 || (f->shape != 1 && f->vectors != 2);
}

static bool spatial_take_flags(struct spatial_input *in) {
  uint8_t b[4];
  if (!fuzz_take(&in->bytes, b, sizeof b)) {
    return false;
  }
  in->flags = (struct spatial_flags){.closed = b[0] & 1,
                                     .atph = b[0] >> 1 & 1,
                                     .vectors = b[0] >> 2 & 3,
                                     .coding = b[0] >> 4 & 3,
                                     .flat = b[0] >> 6 & 1,
                                     .pretty = b[0] >> 7,
                                     .criterion = b[2] & 7,
                                     .axis = b[2] >> 3 & 3,
                                     .shape = b[2] >> 5 & 3,
                                     .offsets = b[2] >> 7,
                                     .alpha = b[3] & 3,
                                     .tension = b[3] >> 2 & 3,
                                     .angles = b[3] >> 4 & 3,
                                     .knots = b[3] >> 6 & 1,
                                     .pieces = b[3] >> 7};
  in->scale = ldexp(1, 8 * (int8_t)b[1]);
  return true;
}

/* A byte as a number around 1, in steps that are exact. */
static bool spatial_take_small(struct spatial_input *in, bool wanted,
                               double *x) {
  uint8_t byte = 0;
  bool taken = !wanted || fuzz_take(&in->bytes, &byte, 1);
  *x = ldexp(1 + byte % 16, byte / 16 - 12);
  return taken;
}

static bool spatial_take_point(struct spatial_input *in, size_t k) {
  const struct spatial_flags *f = &in->flags;
  size_t dimension = f->flat ? 2 : 3;
  double *p = in->points + dimension * k, *v = in->vectors + dimension * k;
  double knot;
  if (!fuzz_take_vector(&in->bytes, f->coding, dimension, p) ||
      (f->vectors % 3 &&
       !fuzz_take_vector(&in->bytes, f->coding, dimension, v)) ||
      !spatial_take_small(in, f->alpha % 3, &in->alpha[k]) ||
      !spatial_take_small(in, f->tension % 3, &in->tension[k]) ||
      !spatial_take_small(in, f->knots, &knot) ||
      (f->criterion == 7 &&
       !fuzz_take_vector(&in->bytes, 0, 2, in->angles + 2 * k))) {
    return false;
  }
  if (f->coding == 3) {
    fuzz_step(&in->walk, dimension, p);
  }
  for (size_t i = 0; i < dimension; i++) {
    p[i] *= in->scale;
    v[i] *= f->vectors == 2 ? in->scale : 1;
  }
  in->angles[2 * k] /= 16;
  in->angles[2 * k + 1] /= 16;
  in->knots[k + 1] = in->knots[k] + knot * in->scale;
  return true;
}

/* A number for all segments, or one each. */
static struct ph_value spatial_each(int how, double *v, size_t n) {
  if (how == 1) {
    return fuzz_number(v[0]);
  }
  return (struct ph_value){.kind = how == 2 ? PH_NUMBERS : PH_ABSENT,
                           .v = v,
                           .n = n,
                           .dimension = 1};
}

static void spatial_set_vectors(struct spatial_input *in, size_t points) {
  static const enum ph_field_id ids[] = {PH_F_POINTS, PH_F_TANGENTS,
                                         PH_F_DERIVATIVES};
  const struct spatial_flags *f = &in->flags;
  size_t dimension = f->flat ? 2 : 3;
  in->problem.field[PH_F_POINTS] = fuzz_array(in->points, points, dimension);
  if (f->vectors % 3) {
    in->problem.field[ids[f->vectors]] =
        fuzz_array(in->vectors, points, dimension);
  }
}

static void spatial_set_fields(struct spatial_input *in, size_t points) {
  static const char *const criteria[] = {"cc", "hc", "bv", "zero",
                                         "F1", "F2", "F3"};
  static const char *const axes[] = {NULL, "chord", "x", "bisector"};
  const struct spatial_flags *f = &in->flags;
  struct ph_value *field = in->problem.field;
  size_t segments = f->closed ? points : points - 1;
  field[PH_F_CLOSED] = fuzz_flag(f->closed);
  field[PH_F_BASIS] = fuzz_word(f->atph ? "atph" : "ph");
  fuzz_set_word(&in->problem, PH_F_AXIS, axes[f->axis]);
  if (f->shape) {
    field[PH_F_SHAPE] = fuzz_flag(f->shape == 2);
  }
  field[PH_F_ALPHA] = spatial_each(f->alpha, in->alpha, segments);
  field[PH_F_TENSION] = spatial_each(f->tension, in->tension, segments);
  if (f->knots) {
    field[PH_F_KNOTS] = spatial_each(2, in->knots, segments + 1);
  }
  if (f->criterion < 7) {
    field[PH_F_CRITERION] = fuzz_word(criteria[f->criterion]);
  } else {
    field[PH_F_ANGLES] =
        f->angles == 0
            ? fuzz_array(in->angles, 2, 1)
            : fuzz_array(in->angles, f->angles == 1 ? 1 : segments, 2);
  }
}

/* Sets the problem; false when the bytes are none. */
static bool spatial_set(struct spatial_input *in) {
  size_t n = 0, most = SPATIAL_POINTS_MAX;
  if (!spatial_take_flags(in)) {
    return false;
  }
  if (in->flags.criterion > 3 && in->flags.criterion < 7) {
    most = spatial_is_shaped(&in->flags) ? SPATIAL_SHAPED_MAX
                                         : SPATIAL_SEARCHED_MAX;
  }
  while (n < most && spatial_take_point(in, n)) {
    n++;
  }
  if (n == 0 || !fuzz_is_finite(in->points, 3 * SPATIAL_POINTS_MAX) ||
      !fuzz_is_finite(in->vectors, 3 * SPATIAL_POINTS_MAX) ||
      !fuzz_is_finite(in->knots, SPATIAL_POINTS_MAX + 1)) {
    return false;
  }
  spatial_set_vectors(in, n);
  spatial_set_fields(in, n);
  return true;
}

/* ---- what holds for a curve ------------------------------------------ */

/* A segment begins and ends in its points, exactly. */
static void spatial_check_ends(const struct spatial_input *in,
                               const struct ph_curve *curve, size_t k) {
  size_t dimension = in->flags.flat ? 2 : 3;
  size_t to = k + 1 < (curve->closed ? curve->n : curve->n + 1) ? k + 1 : 0;
  const double *p = ph_curve_points(curve, k);
  size_t size = dimension * sizeof *p;
  FUZZ_REQUIRE(memcmp(p, in->points + dimension * k, size) == 0);
  FUZZ_REQUIRE(memcmp(p + 15, in->points + dimension * to, size) == 0);
}

/* Those that are given; or a choice, where the axis has such angles. */
static void spatial_check_angles(const struct spatial_input *in,
                                 const double *angles, size_t k) {
  const double pi = 3.14159265358979323846;
  if (in->flags.criterion == 7) {
    const double *given = in->angles + (in->flags.angles > 1 ? 2 * k : 0);
    FUZZ_REQUIRE(memcmp(angles, given, 2 * sizeof *given) == 0);
  } else {
    FUZZ_REQUIRE(isnan(angles[0])
                     ? isnan(angles[1])
                     : fabs(angles[0]) <= pi && fabs(angles[1]) <= pi);
  }
}

static void spatial_check_segment(const struct spatial_input *in,
                                  const struct ph_curve *curve, size_t k) {
  const struct ph_value *tension = &in->problem.field[PH_F_TENSION];
  double most = tension->kind == PH_ABSENT   ? 1
                : tension->kind == PH_NUMBER ? tension->number
                                             : tension->v[k];
  spatial_check_ends(in, curve, k);
  FUZZ_REQUIRE(curve->knots[k] < curve->knots[k + 1]);
  FUZZ_REQUIRE(curve->lengths[k] > 0);
  FUZZ_REQUIRE(curve->choice.tension[k] <= most);
  FUZZ_REQUIRE(curve->choice.tension[k] >= most / 64.0001);
  spatial_check_angles(in, curve->choice.angles + 2 * k, k);
  if (curve->preimage.alpha) {
    FUZZ_REQUIRE(curve->preimage.alpha[k] > 0 &&
                 curve->preimage.alpha[k] < 3.1415927);
  }
}

static void spatial_check_curve(const struct spatial_input *in,
                                const struct ph_curve *curve) {
  FUZZ_REQUIRE(
      fuzz_is_finite(curve->control_points, 3 * ph_curve_points_n(curve)));
  FUZZ_REQUIRE(fuzz_is_finite(curve->preimage.v, 12 * curve->n));
  FUZZ_REQUIRE(isfinite(curve->length));
  for (size_t k = 0; k < curve->n; k++) {
    spatial_check_segment(in, curve, k);
  }
}

static void spatial_check_pieces(const struct spatial_input *in,
                                 struct ph_result *result,
                                 struct ph_arena *arena) {
  struct ph_curve pieces;
  struct ph_diag diag;
  double tolerance = 1e-3 * result->curve.length, error;
  enum ph_status status =
      ph_bezier_curve(&result->curve, tolerance, arena, &pieces, &error, &diag);
  if (status != PH_OK) {
    fuzz_check_failure(&diag, status);
    return;
  }
  FUZZ_REQUIRE(error <= tolerance);
  FUZZ_REQUIRE(fuzz_is_finite(pieces.control_points, 18 * pieces.n));
  result->curve = pieces;
  fuzz_check_output(result, "spatial-hermite", in->flags.pretty);
}

/* Each segment is searched at most so often, and no search is without end. */
static void spatial_check_steps(const struct spatial_input *in,
                                const struct ph_result *result) {
  double steps = result->diagnostics.value[PH_D_ITERATIONS];
  double searches = spatial_is_shaped(&in->flags) ? SPATIAL_TENSIONS_MAX : 1;
  FUZZ_REQUIRE(steps > 0 &&
               steps <= SPATIAL_STEPS_MAX * searches * (double)result->curve.n);
}

/* A curve that its certificate accepts. */
static void spatial_check_result(const struct spatial_input *in,
                                 struct ph_result *result,
                                 struct ph_arena *arena) {
  spatial_check_curve(in, &result->curve);
  fuzz_check_diagnostics(&result->diagnostics);
  fuzz_check_output(result, "spatial-hermite", in->flags.pretty);
  if (in->flags.offsets) {
    fuzz_check_offsets3(result, arena, "spatial-hermite", in->flags.pretty);
  }
  if (in->flags.pieces) {
    spatial_check_pieces(in, result, arena);
  }
}

FUZZ_TARGET(spatial, data, n) {
  static struct spatial_input in;
  struct fuzz_run run = {0};
  in = (struct spatial_input){.bytes = {data, n, 0}};
  if (!spatial_set(&in)) {
    return 0;
  }
  fuzz_solve(&run, &ph_method_spatial_hermite, &in.problem);
  if (run.status == PH_OK) {
    spatial_check_steps(&in, &run.result);
    fuzz_certify(&run, "spatial-hermite", &in.problem, ph_describe_spatial);
  }
  if (run.status == PH_OK) {
    spatial_check_result(&in, &run.result, &run.out);
  }
  fuzz_end(&run);
  return 0;
}
