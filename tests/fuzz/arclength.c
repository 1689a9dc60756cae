/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Fuzz target: any data through the arc-length solver.  The outcome is a
 * failure of the record, or a curve: then its certificate passes or is such a
 * failure, its joints are the data, its lengths those that were asked for, and
 * what is printed, with its offsets, is finite and JSON.
 *
 * The bytes of an input:
 *   0      bits 0-1 what is given (points, closed points, derivatives,
 *          tangents), 2-3 how it is coded, 4 two coordinates, 5 indented JSON,
 *          6 lengths, 7 offsets
 *   1      signed: coordinates are scaled by 2 to eight times that
 *   2      bits 0-2 refine (absent, 1, 2, 3, auto, absent), 3-4 knots (absent,
 *          uniform, chordal, numbers), 5 length_sigma, 6 magnitudes mean, 7
 *          planar free
 *   3      bits 0-1 starts, 2 all_minima, 3 start
 *   4...   the points, or in their place the derivatives or tangents: three or
 *          two signed bytes, signed 16-bit numbers, doubles, or steps (turn,
 *          rise, length); after each a byte for its knot and one for the length
 *          of the interval that ends in it, where they are given
 */
#include "problem.h"

enum {
  ARCLENGTH_POINTS_MAX = 6, /* where all starts fail these are thousands of
                             * steps, each of so many points */
  ARCLENGTH_STEPS_MAX = 20000
};

enum arclength_mode {
  ARCLENGTH_POINTS,
  ARCLENGTH_CLOSED,
  ARCLENGTH_DERIVATIVES,
  ARCLENGTH_TANGENTS
};

struct arclength_flags {
  enum arclength_mode mode;
  bool flat, pretty, lengths, offsets, sigma, mean, leave, all, start;
  int coding, refine, knots, starts;
};

struct arclength_input {
  struct fuzz_bytes bytes;
  struct arclength_flags flags;
  double scale; /* of coordinates */
  struct ph_problem problem;
  size_t points; /* or vectors */
  double vectors[3 * ARCLENGTH_POINTS_MAX];
  double more[ARCLENGTH_POINTS_MAX];        /* the bytes of lengths */
  double lengths[ARCLENGTH_POINTS_MAX + 1]; /* [k]: of the interval before k */
  double knots[ARCLENGTH_POINTS_MAX + 1];
  double start[3];
  struct fuzz_walk walk;
};

/* ---- the problem ------------------------------------------------------- */

static bool arclength_take_flags(struct arclength_input *in) {
  uint8_t b[4];
  if (!fuzz_take(&in->bytes, b, sizeof b)) {
    return false;
  }
  in->flags = (struct arclength_flags){.mode = (enum arclength_mode)(b[0] & 3),
                                       .coding = b[0] >> 2 & 3,
                                       .flat = b[0] >> 4 & 1,
                                       .pretty = b[0] >> 5 & 1,
                                       .lengths = b[0] >> 6 & 1,
                                       .offsets = b[0] >> 7,
                                       .refine = b[2] & 7,
                                       .knots = b[2] >> 3 & 3,
                                       .sigma = b[2] >> 5 & 1,
                                       .mean = b[2] >> 6 & 1,
                                       .leave = b[2] >> 7,
                                       .starts = b[3] & 3,
                                       .all = b[3] >> 2 & 1,
                                       .start = b[3] >> 3 & 1};
  in->scale = ldexp(1, 8 * (int8_t)b[1]);
  return true;
}

/* How far vector k is from vector `from`, or (the same) from 0. */
static double arclength_distance(const struct arclength_input *in, size_t from,
                                 size_t k) {
  size_t dimension = in->flags.flat ? 2 : 3;
  double distance = 0;
  for (size_t i = 0; i < dimension; i++) {
    double base = from == k ? 0 : in->vectors[dimension * from + i];
    distance = hypot(distance, in->vectors[dimension * k + i] - base);
  }
  return distance;
}

/* The length of the interval that ends in vector k: of points close to the
 * chord, now and then below it. */
static double arclength_length(const struct arclength_input *in, size_t from,
                               size_t k, double more) {
  return in->flags.mode == ARCLENGTH_TANGENTS ? more * in->scale
         : in->flags.mode == ARCLENGTH_DERIVATIVES
             ? more * arclength_distance(in, k, k)
             : (1 + more - 1.0 / 1024) * arclength_distance(in, from, k);
}

static bool arclength_take_vector(struct arclength_input *in, size_t k) {
  const struct arclength_flags *f = &in->flags;
  size_t dimension = f->flat ? 2 : 3;
  double *p = in->vectors + dimension * k;
  double knot, more;
  if (!fuzz_take_vector(&in->bytes, f->coding, dimension, p) ||
      !fuzz_take_small(&in->bytes, f->knots == 3, &knot) ||
      !fuzz_take_small(&in->bytes, f->lengths, &more)) {
    return false;
  }
  if (f->coding == 3) {
    fuzz_step(&in->walk, dimension, p);
  }
  for (size_t i = 0; i < dimension; i++) {
    p[i] *= f->mode == ARCLENGTH_TANGENTS ? 1 : in->scale;
  }
  in->more[k] = more;
  in->lengths[k] = arclength_length(in, k > 0 ? k - 1 : 0, k, more);
  in->knots[k + 1] = in->knots[k] + knot * in->scale;
  return true;
}

static size_t arclength_intervals(const struct arclength_input *in) {
  return in->flags.mode == ARCLENGTH_CLOSED ? in->points : in->points - 1;
}

static void arclength_set_data(struct arclength_input *in) {
  static const enum ph_field_id ids[] = {PH_F_POINTS, PH_F_POINTS,
                                         PH_F_DERIVATIVES, PH_F_TANGENTS};
  const struct arclength_flags *f = &in->flags;
  struct ph_value *field = in->problem.field;
  field[ids[f->mode]] = fuzz_array(in->vectors, in->points, f->flat ? 2 : 3);
  fuzz_set_flag(&in->problem, PH_F_CLOSED, f->mode == ARCLENGTH_CLOSED);
  if (f->lengths) {
    in->lengths[in->points] =
        arclength_length(in, in->points - 1, 0, in->more[0]);
    field[PH_F_LENGTHS] =
        fuzz_array(in->lengths + 1, arclength_intervals(in), 1);
  }
}

static void arclength_set_fields(struct arclength_input *in) {
  static const char *const knots[] = {NULL, "uniform", "chordal"};
  const struct arclength_flags *f = &in->flags;
  struct ph_value *field = in->problem.field;
  if (f->refine >= 1 && f->refine <= 3) {
    field[PH_F_REFINE] = fuzz_number(f->refine);
  } else if (f->refine == 4) {
    field[PH_F_REFINE] = fuzz_word("auto");
  }
  if (f->knots == 3) {
    field[PH_F_KNOTS] = fuzz_array(in->knots, arclength_intervals(in) + 1, 1);
  } else if (f->knots) {
    field[PH_F_KNOTS] = fuzz_word(knots[f->knots]);
  }
  fuzz_set_number(&in->problem, PH_F_LENGTH_SIGMA,
                  f->sigma ? ldexp(1, -7) : (double)NAN);
  fuzz_set_word(&in->problem, PH_F_MAGNITUDES, f->mean ? "mean" : NULL);
  fuzz_set_word(&in->problem, PH_F_PLANAR, f->leave ? "free" : NULL);
  fuzz_set_number(&in->problem, PH_F_STARTS,
                  f->starts ? f->starts : (double)NAN);
  fuzz_set_flag(&in->problem, PH_F_ALL_MINIMA, f->all);
  if (f->start) {
    in->start[0] = in->start[2] = in->scale;
    field[PH_F_START] = fuzz_array(in->start, f->flat ? 2 : 3, 1);
  }
}

/* Sets the problem; false when the bytes are none. */
static bool arclength_set(struct arclength_input *in) {
  if (!arclength_take_flags(in)) {
    return false;
  }
  while (in->points < ARCLENGTH_POINTS_MAX &&
         arclength_take_vector(in, in->points)) {
    in->points++;
  }
  if (in->points == 0 ||
      !fuzz_is_finite(in->vectors, 3 * ARCLENGTH_POINTS_MAX) ||
      !fuzz_is_finite(in->lengths, ARCLENGTH_POINTS_MAX) ||
      !fuzz_is_finite(in->knots, ARCLENGTH_POINTS_MAX + 1)) {
    return false;
  }
  arclength_set_data(in);
  arclength_set_fields(in);
  return true;
}

/* ---- what holds for a curve --------------------------------------------- */

/* Of points the ends of an interval are those, exactly. */
static void arclength_check_ends(const struct arclength_input *in,
                                 const struct ph_curve *curve,
                                 const struct ph_interval *interval, size_t i) {
  size_t dimension = in->flags.flat ? 2 : 3;
  size_t to = i + 1 < in->points ? i + 1 : 0;
  const double *p = curve->control_points + 18 * interval->first;
  const double *q = curve->control_points + 18 * interval->last + 15;
  size_t size = dimension * sizeof *p;
  FUZZ_REQUIRE(memcmp(p, in->vectors + dimension * i, size) == 0);
  FUZZ_REQUIRE(memcmp(q, in->vectors + dimension * to, size) == 0);
}

static void arclength_check_interval(const struct arclength_input *in,
                                     const struct ph_curve *curve,
                                     const struct ph_interval *interval,
                                     size_t i) {
  const double spacing = 5e-324; /* of subnormal numbers */
  double sum = 0;
  if (in->flags.mode <= ARCLENGTH_CLOSED) {
    arclength_check_ends(in, curve, interval, i);
  }
  for (size_t k = interval->first; k <= interval->last; k++) {
    FUZZ_REQUIRE(curve->knots[k] < curve->knots[k + 1]);
    FUZZ_REQUIRE(curve->lengths[k] > 0);
    sum += curve->lengths[k];
  }
  FUZZ_REQUIRE(fabs(sum - interval->length) <= 1e-14 * sum + 4 * spacing);
}

static void arclength_check_curve(const struct arclength_input *in,
                                  const struct ph_result *result,
                                  const struct ph_curve *curve) {
  size_t intervals = result->intervals_n;
  FUZZ_REQUIRE(curve->kind == PH_CURVE_PH && curve->degree == 5);
  FUZZ_REQUIRE(curve->dimension == 3 && curve->preimage.n == 3);
  FUZZ_REQUIRE(curve->closed == (in->flags.mode == ARCLENGTH_CLOSED));
  FUZZ_REQUIRE(fuzz_is_finite(curve->control_points, 18 * curve->n));
  FUZZ_REQUIRE(fuzz_is_finite(curve->preimage.v, 12 * curve->n));
  FUZZ_REQUIRE(isfinite(curve->length));
  FUZZ_REQUIRE(intervals > 0 && curve->n % intervals == 0);
}

/* A curve that its certificate accepts. */
static void arclength_check_result(const struct arclength_input *in,
                                   struct ph_result *result,
                                   struct ph_arena *arena) {
  arclength_check_curve(in, result, &result->curve);
  FUZZ_REQUIRE(result->intervals_n <= in->points);
  fuzz_check_intervals(result);
  fuzz_check_starts(result);
  for (size_t i = 0; i < result->intervals_n; i++) {
    arclength_check_interval(in, &result->curve, &result->intervals[i], i);
  }
  for (size_t i = 0; i < result->solutions_n; i++) {
    arclength_check_curve(in, result, &result->solutions[i].curve);
    fuzz_check_diagnostics(&result->solutions[i].diagnostics);
  }
  fuzz_check_diagnostics(&result->diagnostics);
  fuzz_check_output(result, "arclength", in->flags.pretty);
  if (in->flags.offsets) {
    fuzz_check_offsets3(result, arena, "arclength", in->flags.pretty);
  }
}

FUZZ_TARGET(arclength, data, n) {
  static struct arclength_input in;
  struct fuzz_run run = {0};
  in = (struct arclength_input){.bytes = {data, n, 0}};
  if (!arclength_set(&in)) {
    return 0;
  }
  fuzz_solve(&run, &ph_method_arclength, &in.problem);
  if (run.status == PH_OK) {
    FUZZ_REQUIRE(run.result.diagnostics.value[PH_D_ITERATIONS] <=
                 ARCLENGTH_STEPS_MAX);
    fuzz_certify(&run, "arclength", &in.problem, NULL);
  }
  if (run.status == PH_OK) {
    arclength_check_result(&in, &run.result, &run.out);
  }
  fuzz_end(&run);
  return 0;
}
