/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Fuzz target: any data through the planar solver.  The outcome is a failure
 * of the record, or a curve: then its certificate passes or is such a failure,
 * and what is printed is finite, interpolates, and is JSON.  The same holds of
 * a trimmed offset and its own certificate.
 *
 * The bytes of an input:
 *   0      bits 0 closed, 1-2 knots (absent, uniform, centripetal, given),
 *          3 end derivatives given, 4-5 how points are coded, 6 indented JSON,
 *          7 the offset is trimmed
 *   1      signed: coordinates are scaled by 2 to eight times that
 *   2-5    end derivatives, signed bytes; 16 is the speed of a step of length 1
 *   6...   the points: pairs of signed bytes, of signed 16-bit numbers, of
 *          doubles, or (turn, length) of steps; where knots are given, each
 *          point is followed by a byte, its knot's distance from the one before
 */
#include "problem.h"

#include "check/loop.h"

/* Two runs of at most 60 Newton steps, then a continuation.  The most that any
 * input has taken is 72: a thousand would be a loop. */
enum { PLANAR_POINTS_MAX = 200, PLANAR_STEPS_MAX = 1000 };

struct planar_input {
  struct fuzz_bytes bytes;
  struct ph_problem problem;
  double points[PLANAR_POINTS_MAX][2];
  double knots[PLANAR_POINTS_MAX + 1];
  double ends[2][2];
  double heading;
};

static bool planar_take_point(struct planar_input *in, size_t k, int coding) {
  double *p = in->points[k];
  if (!fuzz_take_vector(&in->bytes, coding, 2, p)) {
    return false;
  }
  if (coding == 3) {
    double length = exp2(p[1] / 8);
    in->heading += p[0] * 3.141592653589793 / 128;
    p[0] = length * cos(in->heading) + (k > 0 ? in->points[k - 1][0] : 0);
    p[1] = length * sin(in->heading) + (k > 0 ? in->points[k - 1][1] : 0);
  }
  return true;
}

static size_t planar_take_points(struct planar_input *in, int coding,
                                 bool knots) {
  size_t n = 0;
  uint8_t spacing = 0;
  in->knots[0] = 0;
  while (n < PLANAR_POINTS_MAX && planar_take_point(in, n, coding) &&
         (!knots || fuzz_take(&in->bytes, &spacing, 1))) {
    n++;
    in->knots[n] = in->knots[n - 1] + ldexp(1 + spacing % 16, spacing / 16 - 8);
  }
  return n;
}

/* Sets the problem; false when the bytes are none. */
static bool planar_set(struct planar_input *in) {
  static const char *const rules[] = {"chordal", "uniform", "centripetal"};
  struct ph_value *field = in->problem.field;
  uint8_t flags;
  int8_t exponent, ends[4];
  size_t n;
  int unit; /* of the derivatives: that of chord / knot spacing */
  if (!fuzz_take(&in->bytes, &flags, 1) ||
      !fuzz_take(&in->bytes, &exponent, 1) || !fuzz_take(&in->bytes, ends, 4)) {
    return false;
  }
  unit = (flags >> 1 & 3) == 0 ? 0 : (flags >> 1 & 3) == 2 ? 4 : 8;
  n = planar_take_points(in, flags >> 4 & 3, (flags >> 1 & 3) == 3);
  for (size_t i = 0; i < 2 * n; i++) {
    in->points[i / 2][i % 2] = ldexp(in->points[i / 2][i % 2], 8 * exponent);
    if (!isfinite(in->points[i / 2][i % 2])) {
      return false;
    }
  }
  for (size_t i = 0; i < 4; i++) {
    in->ends[i / 2][i % 2] = ldexp(ends[i] / 16.0, unit * exponent);
  }
  field[PH_F_POINTS] = fuzz_array(in->points[0], n, 2);
  field[PH_F_CLOSED] = fuzz_flag(flags & 1);
  if ((flags >> 1 & 3) == 3) {
    field[PH_F_KNOTS] = fuzz_array(in->knots, n + (flags & 1), 1);
  } else if (flags >> 1 & 3) {
    field[PH_F_KNOTS] = fuzz_word(rules[flags >> 1 & 3]);
  }
  if (flags >> 3 & 1) {
    field[PH_F_END_DERIVATIVES] = fuzz_array(in->ends[0], 2, 2);
  }
  return true;
}

/* The segments begin and end in the points, exactly. */
static void planar_check_curve(const struct planar_input *in,
                               const struct ph_curve *curve) {
  size_t points_n = curve->closed ? curve->n : curve->n + 1;
  for (size_t k = 0; k < curve->n; k++) {
    const double *p = ph_curve_points(curve, k);
    const double *from = in->points[k];
    const double *to = in->points[k + 1 < points_n ? k + 1 : 0];
    FUZZ_REQUIRE(memcmp(p, from, 2 * sizeof *p) == 0);
    FUZZ_REQUIRE(memcmp(p + 10, to, 2 * sizeof *p) == 0);
    FUZZ_REQUIRE(curve->knots[k] < curve->knots[k + 1]);
    FUZZ_REQUIRE(curve->lengths[k] >= 0);
    for (int i = 0; i < 12; i++) {
      FUZZ_REQUIRE(isfinite(p[i]));
    }
  }
  FUZZ_REQUIRE(isfinite(curve->length));
}

/* A curve that its certificate accepts. */
static void planar_check_result(const struct planar_input *in,
                                struct ph_result *result,
                                struct ph_arena *arena) {
  struct ph_diag diag;
  struct ph_offset offset;
  const bool trimmed = in->bytes.data[0] >> 7;
  const struct ph_offset_rules rules = {
      .mode = trimmed ? PH_OFFSET_TRIMMED : PH_OFFSET_RAW,
      .crosses = !(result->diagnostics.value[PH_D_SIMPLE] > 0),
      .tolerance = 1e-9};
  double size = fabs(in->points[1][0] - in->points[0][0]);
  enum ph_status status =
      ph_offset(&result->curve, size, &rules, arena, &offset, &diag);
  if (status == PH_OK && trimmed) {
    struct ph_arena scratch = {.chunks = NULL};
    status = ph_certify_loops(&result->curve, &offset, 1, &scratch, &diag);
    FUZZ_REQUIRE((status == PH_OK) == offset.loops.trimming.certified);
    ph_arena_free(&scratch);
  }
  planar_check_curve(in, &result->curve);
  fuzz_check_diagnostics(&result->diagnostics);
  if (status == PH_OK) {
    fuzz_check_offset(&offset);
    result->offsets = &offset;
    result->offsets_n = 1;
  } else {
    fuzz_check_failure(&diag, status);
  }
  fuzz_check_output(result, "planar", in->bytes.data[0] >> 6 & 1);
}

FUZZ_TARGET(planar, data, n) {
  struct planar_input in = {.bytes = {data, n, 0}};
  struct fuzz_run run = {0};
  if (!planar_set(&in)) {
    return 0;
  }
  fuzz_solve(&run, &ph_method_planar, &in.problem);
  if (run.status == PH_OK) {
    double steps = run.result.diagnostics.value[PH_D_ITERATIONS];
    FUZZ_REQUIRE(steps >= 0 && steps <= PLANAR_STEPS_MAX);
    fuzz_certify(&run, "planar", &in.problem, ph_describe_planar);
  }
  if (run.status == PH_OK) {
    planar_check_result(&in, &run.result, &run.out);
  }
  fuzz_end(&run);
  return 0;
}
