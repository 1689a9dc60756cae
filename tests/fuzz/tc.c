/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Fuzz target: any data through the solver of Tschirnhausen cubics.  The
 * outcome is a failure of the record, or curves: then the certificate of each
 * passes or is such a failure, which it is not where small whole numbers are
 * interpolated, cubics follow one another and go through the points, what is
 * derived from them is sound, and what is printed is JSON.
 *
 * The bytes of an input:
 *   0      bits 0-1 how points are coded (see 6...), 2-3 vectors (none,
 *          tangents, derivatives, both), 4 closed, 5 indented JSON,
 *          6 an offset, 7 blaschke
 *   1      bits 0-2 mode (absent, or by tc_modes), 3-4 solutions (absent,
 *          best, standard, all), 5-6 ends (absent, circle, the first two
 *          vectors as end_tangents or end_derivatives), 7 joint chord
 *   2      signed: lambda is 2^(byte / 32); 0: absent
 *   3      signed: joint_angle in parts of a half turn; 0: absent
 *   4      joint_position in 256ths; 0: absent
 *   5      of what is approximated: bit 0 a curve in place of points,
 *          1 a chain of cubics, 2 pieces in place of a tolerance, 3-7 either;
 *          of the mode spline bit 2: g2 in its place
 *   6...   the points: pairs of signed bytes, signed 16-bit numbers, doubles
 *          as they are, or steps (turn, length); each followed by its vector,
 *          coded likewise, if there are any: after a step an angle from there,
 *          length
 */
#include "problem.h"

#include "curve/offset/blaschke.h"
#include "curve/sample/sample.h"
#include "kernel/cplx.h"
#include "kernel/pi.h"

#include <float.h>

/* Points; fewer where all curves are asked for, up to 4 an interval: each is
 * solved, certified and printed. */
enum { TC_POINTS_MAX = 16, TC_ALL_POINTS_MAX = 4 };

enum tc_mode {
  TC_DEFAULT,
  TC_G1,
  TC_G1_PAIR,
  TC_G1_AUTO,
  TC_G1_FAIR,
  TC_C1,
  TC_SPLINE,
  TC_APPROXIMATE,
  TC_G2
};

static const char *const tc_modes[] = {NULL,      "g1",          "g1-pair",
                                       "g1-auto", "g1-fair",     "c1",
                                       "spline",  "approximate", "g2"};

enum { TC_ALL = 3 };

static const char *const tc_solutions[] = {NULL, "best", "standard", "all"};

struct tc_flags {
  bool tangents, derivatives, closed, pretty, offset, blaschke, chord;
  bool curve, chain, pieces;
  int coding, solutions, ends, amount;
  enum tc_mode mode;
};

struct tc_input {
  struct fuzz_bytes bytes;
  struct tc_flags flags;
  struct ph_problem problem;
  double lambda, joint_angle, joint_position; /* NaN: absent */
  size_t points;
  double point[2 * TC_POINTS_MAX], vector[2 * TC_POINTS_MAX];
  double chain[2 * 2 * TC_POINTS_MAX]; /* joints come twice */
  size_t sizes[TC_POINTS_MAX];
  double heading, at[2];
};

/* ---- the problem ------------------------------------------------------- */

static bool tc_take_flags(struct tc_input *in) {
  uint8_t b[6];
  if (!fuzz_take(&in->bytes, b, sizeof b)) {
    return false;
  }
  in->flags = (struct tc_flags){.coding = b[0] & 3,
                                .tangents = b[0] >> 2 & 1,
                                .derivatives = b[0] >> 3 & 1,
                                .closed = b[0] >> 4 & 1,
                                .pretty = b[0] >> 5 & 1,
                                .offset = b[0] >> 6 & 1,
                                .blaschke = b[0] >> 7,
                                .mode = (enum tc_mode)(b[1] & 7),
                                .solutions = b[1] >> 3 & 3,
                                .ends = b[1] >> 5 & 3,
                                .chord = b[1] >> 7,
                                .curve = b[5] & 1,
                                .chain = b[5] >> 1 & 1,
                                .pieces = b[5] >> 2 & 1,
                                .amount = b[5] >> 3};
  if (in->flags.mode == TC_SPLINE && in->flags.pieces) {
    in->flags.mode = TC_G2;
  }
  in->lambda = b[2] ? exp2((int8_t)b[2] / 32.0) : (double)NAN;
  in->joint_angle = b[3] ? (int8_t)b[3] * PH_PI / 128 : (double)NAN;
  in->joint_position = b[4] ? b[4] / 256.0 : (double)NAN;
  return true;
}

/* From the last point on, after a turn to the left. */
static void tc_step(struct tc_input *in, double *p) {
  ph_cplx go;
  in->heading += p[0] * PH_PI / 128;
  go = ph_cplx_scale(p[1], ph_cplx_polar(in->heading));
  in->at[0] += go.re;
  in->at[1] += go.im;
  memcpy(p, in->at, sizeof in->at);
}

static bool tc_take_point(struct tc_input *in, size_t k) {
  const struct tc_flags *f = &in->flags;
  bool has_vector = f->tangents || f->derivatives || f->ends > 1;
  double *p = in->point + 2 * k, *v = in->vector + 2 * k;
  if (!fuzz_take_vector(&in->bytes, f->coding, 2, p) ||
      (has_vector && !fuzz_take_vector(&in->bytes, f->coding, 2, v))) {
    return false;
  }
  if (f->coding == 3) {
    ph_cplx direction;
    tc_step(in, p);
    direction = ph_cplx_polar(in->heading + v[0] * PH_PI / 128);
    direction = ph_cplx_scale(exp2(v[1] / 16), direction);
    v[0] = direction.re;
    v[1] = direction.im;
  }
  return true;
}

/* The points as cubics, each from the last point of the one before; the last
 * one of what is left. */
static void tc_set_chain(struct tc_input *in) {
  struct ph_value *value = &in->problem.field[PH_F_CURVE];
  size_t pieces = 0, n = 0;
  for (size_t from = 0; from == 0 || from + 1 < in->points; from += 3) {
    size_t size = in->points - from < 4 ? in->points - from : 4;
    memcpy(in->chain + 2 * n, in->point + 2 * from,
           2 * size * sizeof *in->chain);
    in->sizes[pieces++] = size;
    n += size;
  }
  *value = fuzz_array(in->chain, n, 2);
  value->kind = PH_POLYLINE;
  value->sizes = in->sizes;
  value->sizes_n = pieces;
}

static void tc_set_data(struct tc_input *in) {
  const struct tc_flags *f = &in->flags;
  struct ph_value *field = in->problem.field;
  if (f->chain) {
    tc_set_chain(in);
  } else {
    field[f->curve ? PH_F_CURVE : PH_F_POINTS] =
        fuzz_array(in->point, in->points, 2);
  }
  if (f->tangents) {
    field[PH_F_TANGENTS] = fuzz_array(in->vector, in->points, 2);
  }
  if (f->derivatives) {
    field[PH_F_DERIVATIVES] = fuzz_array(in->vector, in->points, 2);
  }
  if (f->ends > 1) {
    field[f->ends == 2 ? PH_F_END_TANGENTS : PH_F_END_DERIVATIVES] =
        fuzz_array(in->vector, 2, 2);
  } else if (f->ends) {
    field[PH_F_ENDS] = fuzz_word("circle");
  }
  if (f->curve || f->chain || f->mode == TC_APPROXIMATE) {
    fuzz_set_number(&in->problem, f->pieces ? PH_F_PIECES : PH_F_TOLERANCE,
                    f->pieces ? 1 + f->amount : ldexp(64, -f->amount));
  }
}

static void tc_set_choices(struct tc_input *in) {
  const struct tc_flags *f = &in->flags;
  fuzz_set_word(&in->problem, PH_F_MODE, tc_modes[f->mode]);
  fuzz_set_word(&in->problem, PH_F_SOLUTIONS, tc_solutions[f->solutions]);
  fuzz_set_word(&in->problem, PH_F_JOINT, f->chord ? "chord" : NULL);
  fuzz_set_number(&in->problem, PH_F_LAMBDA, in->lambda);
  fuzz_set_number(&in->problem, PH_F_JOINT_ANGLE, in->joint_angle);
  fuzz_set_number(&in->problem, PH_F_JOINT_POSITION, in->joint_position);
  fuzz_set_flag(&in->problem, PH_F_CLOSED, f->closed);
  fuzz_set_flag(&in->problem, PH_F_BLASCHKE, f->blaschke);
}

/* Sets the problem; false when the bytes are none. */
static bool tc_set(struct tc_input *in) {
  size_t most;
  if (!tc_take_flags(in)) {
    return false;
  }
  most = in->flags.solutions == TC_ALL ? TC_ALL_POINTS_MAX : TC_POINTS_MAX;
  while (in->points < most && tc_take_point(in, in->points)) {
    in->points++;
  }
  if (in->points == 0 || !fuzz_is_finite(in->point, 2 * TC_POINTS_MAX) ||
      !fuzz_is_finite(in->vector, 2 * TC_POINTS_MAX)) {
    return false;
  }
  tc_set_data(in);
  tc_set_choices(in);
  return true;
}

/* ---- what holds for a curve --------------------------------------------- */

/* A cubic begins where the one before ends, and is no shorter than straight
 * on, but for the rounding of its ends: by the largest coordinate given. */
static void tc_check_segment(const struct ph_curve *curve, size_t k,
                             double largest) {
  const double *p = ph_curve_points(curve, k);
  double chord = hypot(p[6] - p[0], p[7] - p[1]);
  double rounding = 4 * DBL_EPSILON * largest;
  FUZZ_REQUIRE(curve->knots[k] < curve->knots[k + 1]);
  FUZZ_REQUIRE(curve->lengths[k] > 0);
  FUZZ_REQUIRE(curve->lengths[k] >= chord * (1 - 1e-9) - rounding);
  FUZZ_REQUIRE(k + 1 == curve->n || memcmp(p + 6, ph_curve_points(curve, k + 1),
                                           2 * sizeof *p) == 0);
}

static void tc_check_curve(const struct tc_input *in,
                           const struct ph_curve *curve) {
  double largest = 0;
  FUZZ_REQUIRE(curve->kind == PH_CURVE_TC && curve->degree == 3);
  FUZZ_REQUIRE(curve->dimension == 2 && curve->n > 0);
  FUZZ_REQUIRE(curve->preimage.n == 2 && curve->preimage.dimension == 2);
  FUZZ_REQUIRE(
      fuzz_is_finite(curve->control_points, 2 * ph_curve_points_n(curve)));
  FUZZ_REQUIRE(fuzz_is_finite(curve->preimage.v, 4 * curve->n));
  FUZZ_REQUIRE(isfinite(curve->length));
  FUZZ_REQUIRE(!curve->closed || in->flags.closed);
  for (size_t i = 0; i < 2 * TC_POINTS_MAX; i++) {
    largest = fmax(largest, fabs(in->point[i]));
  }
  for (size_t k = 0; k < curve->n; k++) {
    tc_check_segment(curve, k, largest);
  }
}

/* Of points, each interval begins at one of them, and the last one ends at the
 * last, or the first. */
static void tc_check_points(const struct tc_input *in,
                            const struct ph_result *result) {
  const struct ph_value *points = &in->problem.field[PH_F_POINTS];
  size_t n = result->intervals_n;
  const struct ph_curve *curve = &result->curve;
  if (points->kind == PH_ABSENT || in->flags.mode == TC_APPROXIMATE) {
    return;
  }
  FUZZ_REQUIRE(n + 1 == points->n || (in->flags.closed && n <= points->n));
  for (size_t i = 0; i < n; i++) {
    const double *begin = ph_curve_points(curve, result->intervals[i].first);
    const double *end = ph_curve_points(curve, result->intervals[i].last) + 6;
    const double *next =
        i + 1 < points->n ? points->v + 2 * (i + 1) : points->v;
    FUZZ_REQUIRE(memcmp(begin, points->v + 2 * i, 2 * sizeof *begin) == 0);
    FUZZ_REQUIRE(memcmp(end, next, 2 * sizeof *end) == 0);
  }
}

static void tc_check_samples(const struct ph_samples *samples) {
  FUZZ_REQUIRE(fuzz_is_finite(samples->point, 2 * samples->n));
  FUZZ_REQUIRE(fuzz_is_finite(samples->s, samples->n));
  for (size_t i = 0; i < samples->n; i++) {
    const double *t = samples->tangent + 2 * i;
    FUZZ_REQUIRE(fabs(hypot(t[0], t[1]) - 1) < 1e-13);
    FUZZ_REQUIRE(i == 0 || samples->s[i] >= samples->s[i - 1]);
  }
}

/* Rational pieces without a pole, on the cylinder. */
static void tc_check_blaschke(const struct ph_curve *curve) {
  FUZZ_REQUIRE(curve->blaschke.n >= curve->n);
  for (size_t i = 0; i < curve->blaschke.n; i++) {
    const struct ph_blaschke *piece = &curve->blaschke.v[i];
    FUZZ_REQUIRE(piece->segment < curve->n);
    FUZZ_REQUIRE(piece->interval[0] < piece->interval[1]);
    FUZZ_REQUIRE(fuzz_is_finite(&piece->control_points[0][0], 18));
    for (size_t k = 0; k < 6; k++) {
      FUZZ_REQUIRE(piece->weights[k] > 0 && isfinite(piece->weights[k]));
    }
    for (size_t k = 0; k < 6; k += 5) {
      const double *n = piece->control_points[k];
      /* subnormal weights have few digits */
      FUZZ_REQUIRE(fabs(hypot(n[0], n[1]) - 1) < 1e-9 ||
                   piece->weights[k] < DBL_MIN);
    }
  }
}

static void tc_check_offset(const struct tc_input *in, struct ph_result *result,
                            struct ph_arena *arena) {
  double size = ph_curve_size(&result->curve);
  const struct ph_offset_rules rules = {.tolerance = 1e-3 * size};
  const struct ph_offset *offset = fuzz_check_offsets(
      result, 1, 0.125 * size, &rules, arena, "tc", in->flags.pretty);
  FUZZ_REQUIRE(!offset ||
               (offset->degree == 5 && offset->n >= result->curve.n));
}

/* What was asked of an approximation. */
static void tc_check_approximation(const struct tc_input *in,
                                   const struct ph_result *result) {
  const struct ph_value *tolerance = &in->problem.field[PH_F_TOLERANCE];
  const struct ph_value *pieces = &in->problem.field[PH_F_PIECES];
  if (tolerance->kind != PH_ABSENT) {
    FUZZ_REQUIRE(result->diagnostics.known >> PH_D_DISTANCE & 1);
    FUZZ_REQUIRE(result->diagnostics.value[PH_D_DISTANCE] <= tolerance->number);
  }
  if (pieces->kind != PH_ABSENT) {
    FUZZ_REQUIRE((double)result->curve.n <= pieces->number);
  }
}

/* Curves that their certificates accept. */
static void tc_check_result(const struct tc_input *in, struct ph_result *result,
                            struct ph_arena *arena) {
  const struct ph_sample_rules rules = {.how = PH_SAMPLE_PARAMETER, .n = 4};
  struct ph_diag diag;
  enum ph_status status = PH_OK;
  tc_check_curve(in, &result->curve);
  fuzz_check_diagnostics(&result->diagnostics);
  fuzz_check_intervals(result);
  tc_check_points(in, result);
  tc_check_approximation(in, result);
  for (size_t i = 0; i < result->solutions_n; i++) {
    tc_check_curve(in, &result->solutions[i].curve);
    fuzz_check_diagnostics(&result->solutions[i].diagnostics);
  }
  FUZZ_REQUIRE(ph_sample_curve(&result->curve, &rules, arena, &result->samples,
                               &diag) == PH_OK);
  FUZZ_REQUIRE(result->samples.n == 5 * result->curve.n);
  tc_check_samples(&result->samples);
  if (in->flags.blaschke) {
    status = ph_blaschke_curve(&result->curve, arena, &diag);
  }
  if (status != PH_OK) {
    fuzz_check_failure(&diag, status);
  } else if (in->flags.blaschke) {
    tc_check_blaschke(&result->curve);
  }
  fuzz_check_output(result, "tc", in->flags.pretty);
  if (in->flags.offset) {
    tc_check_offset(in, result, arena);
  }
}

/* Whether points and vectors are interpolated that are signed bytes. */
static bool tc_is_moderate(const struct tc_input *in) {
  const struct ph_value *field = in->problem.field;
  return in->flags.coding == 0 && field[PH_F_CURVE].kind == PH_ABSENT &&
         field[PH_F_TOLERANCE].kind == PH_ABSENT &&
         field[PH_F_PIECES].kind == PH_ABSENT;
}

static void tc_certify(const struct tc_input *in, struct fuzz_run *run) {
  fuzz_certify(run, "tc", &in->problem, ph_describe_cubics);
  for (size_t i = 0; run->status == PH_OK && i < run->result.solutions_n; i++) {
    struct ph_solution *solution = &run->result.solutions[i];
    run->status = ph_certify("tc", &in->problem, &solution->curve,
                             &run->scratch, &solution->diagnostics, &run->diag);
  }
}

FUZZ_TARGET(tc, data, n) {
  static struct tc_input in;
  struct fuzz_run run = {0};
  in = (struct tc_input){.bytes = {data, n, 0}};
  if (!tc_set(&in)) {
    return 0;
  }
  fuzz_solve(&run, &ph_method_tc, &in.problem);
  if (run.status == PH_OK) {
    tc_certify(&in, &run);
    FUZZ_REQUIRE(run.status != PH_E_NO_CONVERGENCE || !tc_is_moderate(&in));
  }
  if (run.status == PH_OK) {
    tc_check_result(&in, &run.result, &run.out);
  }
  fuzz_end(&run);
  return 0;
}
