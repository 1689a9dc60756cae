/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Fuzz target: any data through the spherical solver.  The outcome is a failure
 * of the record, or a curve: then its certificate passes or is such a failure,
 * there is a node for each point, its samples are on the sphere, and what is
 * printed, with its offset, is finite and JSON.
 *
 * The bytes of an input:
 *   0      bits 0-1 how points are coded (see 5...), 2 lonlat in place of
 *          points, 3 closed, 4 indented JSON, 5 an offset, 6-7 ends (absent,
 *          natural, rest, clamped by tangents)
 *   1      bits 0-1 knots (absent, uniform, geodesic, numbers), 2 model
 *          nielson, 3 criterion legacy, 4-5 shape (absent, warn, false, true),
 *          6-7 increase (absent, minimal, plus:V, times:V)
 *   2      signed: epsilon is 2^(byte / 4); 0: absent
 *   3      signed: the radius is 2 to six times that, if bit 0 is set the
 *          center is not 0; 0: both are absent
 *   4      tension: bit 0 one for each point; 0: absent
 *   5...   the points: three or two signed bytes, signed 16-bit numbers,
 *          doubles as they are, or steps (turn, length); after each a byte for
 *          its knot and one for its tension, where they are given.  The first
 *          two are the end tangents as well.
 */
#include "problem.h"

#include "curve/sample/sample.h"

enum { SPHERE_POINTS_MAX = 16, SPHERE_STEPS_MAX = 100000 };

struct sphere_flags {
  bool lonlat, closed, pretty, offset, nielson, legacy, tension_each;
  int coding, ends, knots, shape, increase;
};

struct sphere_input {
  struct fuzz_bytes bytes;
  struct sphere_flags flags;
  struct ph_problem problem;
  double epsilon, radius, tension;
  double center[3];
  size_t points;
  double vectors[3 * SPHERE_POINTS_MAX]; /* or longitudes and latitudes */
  double knots[SPHERE_POINTS_MAX + 1];
  double tensions[SPHERE_POINTS_MAX];
  double ends[6];
  double heading, at[3];
};

/* ---- the problem ------------------------------------------------------- */

/* 2^(x / 4), or absent, for which NaN stands. */
static double sphere_power(int8_t x) {
  return x == 0 ? (double)NAN : exp2(x / 4.0);
}

static bool sphere_take_flags(struct sphere_input *in) {
  uint8_t b[5];
  if (!fuzz_take(&in->bytes, b, sizeof b)) {
    return false;
  }
  in->flags = (struct sphere_flags){.coding = b[0] & 3,
                                    .lonlat = b[0] >> 2 & 1,
                                    .closed = b[0] >> 3 & 1,
                                    .pretty = b[0] >> 4 & 1,
                                    .offset = b[0] >> 5 & 1,
                                    .ends = b[0] >> 6,
                                    .knots = b[1] & 3,
                                    .nielson = b[1] >> 2 & 1,
                                    .legacy = b[1] >> 3 & 1,
                                    .shape = b[1] >> 4 & 3,
                                    .increase = b[1] >> 6,
                                    .tension_each = b[4] & 1};
  in->epsilon = sphere_power((int8_t)b[2]);
  in->radius = b[3] == 0 ? (double)NAN : ldexp(1, 6 * (int8_t)b[3]);
  if (b[3] & 1) {
    in->center[0] = in->radius;
    in->center[2] = -4 * in->radius;
  }
  in->tension = b[4] == 0 ? (double)NAN : ldexp(1, b[4] / 8 - 4);
  return true;
}

/* A step from the last point: a turn to the left, and on along a great circle.
 */
static void sphere_step(struct sphere_input *in, double turn, double length) {
  const double unit = 3.141592653589793 / 128;
  double angle = length < 0 ? exp2(length / 8) : length * unit;
  double lat = asin(in->at[2]), lon = atan2(in->at[1], in->at[0]), east, north;
  in->heading += turn * unit;
  north = sin(lat) * cos(angle) + cos(lat) * sin(angle) * cos(in->heading);
  east = atan2(sin(in->heading) * sin(angle) * cos(lat),
               cos(angle) - sin(lat) * north);
  lat = asin(fmin(1, fmax(-1, north)));
  lon += east;
  in->at[0] = cos(lat) * cos(lon);
  in->at[1] = cos(lat) * sin(lon);
  in->at[2] = sin(lat);
}

/* A vector of bytes to the sphere; doubles are taken as they are. */
static void sphere_place(struct sphere_input *in, double *p) {
  double radius = isnan(in->radius) ? 1 : in->radius;
  double size = hypot(hypot(p[0], p[1]), p[2]);
  if (in->flags.coding == 2) {
    return;
  }
  for (size_t i = 0; i < 3; i++) {
    p[i] = in->center[i] + radius * (size > 0 ? p[i] / size : 0);
  }
}

/* Bytes to degrees, of which one is a little more than the largest. */
static void sphere_degrees(const struct sphere_input *in, double *p) {
  const double most = in->flags.coding == 1 ? 32767 : 127;
  if (in->flags.coding != 2) {
    p[0] *= 360 / most;
    p[1] *= 90 / most;
  }
}

static bool sphere_take_point(struct sphere_input *in, size_t k) {
  const struct sphere_flags *f = &in->flags;
  size_t dimension = f->lonlat ? 2 : 3, given = f->coding == 3 ? 2 : dimension;
  double v[3] = {0, 0, 0}, *p = in->vectors + dimension * k, knot;
  if (!fuzz_take_vector(&in->bytes, f->coding, given, v) ||
      !fuzz_take_small(&in->bytes, f->knots == 3, &knot) ||
      !fuzz_take_small(&in->bytes, f->tension_each, &in->tensions[k])) {
    return false;
  }
  if (f->coding == 3) {
    sphere_step(in, v[0], v[1]);
    memcpy(v, in->at, sizeof v);
  }
  if (k < 2) {
    memcpy(in->ends + 3 * k, v, sizeof v);
  }
  if (!f->lonlat) {
    sphere_place(in, v);
  } else if (f->coding == 3) {
    v[0] = atan2(v[1], v[0]) * 57.29577951308232;
    v[1] = asin(fmin(1, fmax(-1, v[2]))) * 57.29577951308232;
  } else {
    sphere_degrees(in, v);
  }
  memcpy(p, v, dimension * sizeof *p);
  in->tensions[k] *= in->tension;
  in->knots[k + 1] = in->knots[k] + knot;
  return true;
}

static void sphere_set_data(struct sphere_input *in) {
  const struct sphere_flags *f = &in->flags;
  struct ph_value *field = in->problem.field;
  field[f->lonlat ? PH_F_LONLAT : PH_F_POINTS] =
      fuzz_array(in->vectors, in->points, f->lonlat ? 2 : 3);
  fuzz_set_flag(&in->problem, PH_F_CLOSED, f->closed);
  fuzz_set_number(&in->problem, PH_F_RADIUS, in->radius);
  fuzz_set_number(&in->problem, PH_F_EPSILON, in->epsilon);
  if (!isnan(in->radius)) {
    field[PH_F_CENTER] = fuzz_array(in->center, 3, 1);
  }
  if (!isnan(in->tension)) {
    field[PH_F_TENSION] = f->tension_each
                              ? fuzz_array(in->tensions, in->points, 1)
                              : fuzz_number(in->tension);
  }
}

static void sphere_set_choices(struct sphere_input *in) {
  const struct sphere_flags *f = &in->flags;
  struct ph_value *field = in->problem.field;
  if (f->knots == 3) {
    field[PH_F_KNOTS] = fuzz_array(in->knots, in->points + f->closed, 1);
  } else if (f->knots) {
    field[PH_F_KNOTS] = fuzz_word(f->knots == 1 ? "uniform" : "geodesic");
  }
  if (f->ends == 3) {
    field[PH_F_END_TANGENTS] = fuzz_array(in->ends, 2, 3);
  } else if (f->ends) {
    field[PH_F_ENDS] = fuzz_word(f->ends == 1 ? "natural" : "rest");
  }
  fuzz_set_word(&in->problem, PH_F_MODEL, f->nielson ? "nielson" : NULL);
  fuzz_set_word(&in->problem, PH_F_CRITERION, f->legacy ? "legacy" : NULL);
  if (f->shape) {
    field[PH_F_SHAPE] =
        f->shape == 1 ? fuzz_word("warn") : fuzz_flag(f->shape == 3);
  }
  if (f->increase) {
    static const char *const words[] = {NULL, "minimal", "plus:10", "times:2"};
    static const double by[] = {0, 0, 10, 2};
    field[PH_F_INCREASE] = fuzz_word(words[f->increase]);
    field[PH_F_INCREASE].number = by[f->increase];
  }
}

/* Sets the problem; false when the bytes are none. */
static bool sphere_set(struct sphere_input *in) {
  in->at[0] = 1;
  if (!sphere_take_flags(in)) {
    return false;
  }
  while (in->points < SPHERE_POINTS_MAX && sphere_take_point(in, in->points)) {
    in->points++;
  }
  if (in->points == 0 || !fuzz_is_finite(in->vectors, 3 * SPHERE_POINTS_MAX) ||
      !fuzz_is_finite(in->ends, 6)) {
    return false;
  }
  sphere_set_data(in);
  sphere_set_choices(in);
  return true;
}

/* ---- what holds for a curve --------------------------------------------- */

/* By how much of its radius a point is off the sphere of a curve. */
static double sphere_off(const struct ph_curve *curve, const double *p) {
  double d = 0;
  for (size_t i = 0; i < 3; i++) {
    d = hypot(d, p[i] / curve->sphere.radius -
                     curve->sphere.center[i] / curve->sphere.radius);
  }
  return fabs(d - 1);
}

static void sphere_check_segment(const struct ph_curve *curve, size_t k) {
  const double *p = curve->control_points + 12 * k;
  const double *next = p + (k + 1 < curve->n ? 12 : 0);
  FUZZ_REQUIRE(curve->knots[k] < curve->knots[k + 1]);
  FUZZ_REQUIRE(curve->lengths[k] > 0);
  FUZZ_REQUIRE(next == p || memcmp(p + 9, next, 3 * sizeof *p) == 0);
  for (size_t i = 0; i < 4; i++) {
    FUZZ_REQUIRE(sphere_off(curve, p + 3 * i) < 1e-13);
  }
}

static void sphere_check_nodes(const struct sphere_input *in,
                               const struct ph_curve *curve) {
  size_t nodes = curve->n + !curve->closed;
  FUZZ_REQUIRE(nodes == in->points ||
               (curve->closed && nodes + 1 == in->points));
  for (size_t i = 0; i < nodes; i++) {
    FUZZ_REQUIRE(curve->sphere.tensions[i] >= 0 &&
                 isfinite(curve->sphere.tensions[i]));
    FUZZ_REQUIRE(curve->sphere.indicators[i] >= -1 &&
                 curve->sphere.indicators[i] <= 1);
  }
}

static void sphere_check_curve(const struct sphere_input *in,
                               const struct ph_curve *curve) {
  FUZZ_REQUIRE(curve->kind == PH_CURVE_SPHERICAL_NU && curve->degree == 3);
  FUZZ_REQUIRE(curve->dimension == 3 && curve->closed == in->flags.closed);
  FUZZ_REQUIRE(curve->n > 0 && curve->sphere.radius > 0);
  FUZZ_REQUIRE(fuzz_is_finite(curve->control_points, 12 * curve->n));
  FUZZ_REQUIRE(isfinite(curve->length));
  for (size_t k = 0; k < curve->n; k++) {
    sphere_check_segment(curve, k);
  }
  sphere_check_nodes(in, curve);
}

/* Samples are on the sphere: less so where control points are nearly opposite
 * to each other, and an arc between them is worth few digits. */
static void sphere_check_samples(const struct ph_curve *curve,
                                 const struct ph_samples *samples) {
  FUZZ_REQUIRE(fuzz_is_finite(samples->point, 3 * samples->n));
  FUZZ_REQUIRE(fuzz_is_finite(samples->s, samples->n));
  for (size_t i = 0; i < samples->n; i++) {
    const double *t = samples->tangent + 3 * i;
    FUZZ_REQUIRE(sphere_off(curve, samples->point + 3 * i) < 1e-9);
    FUZZ_REQUIRE(fabs(hypot(hypot(t[0], t[1]), t[2]) - 1) < 1e-13);
  }
}

/* Along the curve it is no nearer than straight on.  (An offset leaps where the
 * curve turns back.) */
static void sphere_check_lengths(const struct ph_curve *curve,
                                 const struct ph_samples *samples) {
  for (size_t i = 1; i < samples->n; i++) {
    const double *p = samples->point + 3 * i;
    double step = samples->s[i] - samples->s[i - 1], chord = 0;
    for (size_t j = 0; j < 3; j++) {
      chord = hypot(chord, p[j] - *(p + j - 3));
    }
    FUZZ_REQUIRE(step >=
                 (1 - 1e-9) * chord -
                     1e-14 * (samples->s[i] + 8 * curve->sphere.radius));
  }
}

static void sphere_check_offset(const struct sphere_input *in,
                                struct ph_result *result,
                                struct ph_arena *arena) {
  const struct ph_offset_rules rules = {
      .tolerance = 1e-9, .samples = {.how = PH_SAMPLE_PARAMETER, .n = 3}};
  const struct ph_offset *offset =
      fuzz_check_offsets(result, 1, 0.125 * result->curve.sphere.radius, &rules,
                         arena, "sphere", in->flags.pretty);
  if (offset) {
    FUZZ_REQUIRE(offset->samples.n == 4 * result->curve.n);
    FUZZ_REQUIRE(offset->length >= 0 && isfinite(offset->length));
    sphere_check_samples(&result->curve, &offset->samples);
  }
}

/* A curve that its certificate accepts. */
static void sphere_check_result(const struct sphere_input *in,
                                struct ph_result *result,
                                struct ph_arena *arena) {
  const struct ph_sample_rules rules = {.how = PH_SAMPLE_PARAMETER, .n = 4};
  struct ph_diag diag;
  sphere_check_curve(in, &result->curve);
  fuzz_check_diagnostics(&result->diagnostics);
  FUZZ_REQUIRE(ph_sample_curve(&result->curve, &rules, arena, &result->samples,
                               &diag) == PH_OK);
  FUZZ_REQUIRE(result->samples.n == 5 * result->curve.n);
  sphere_check_samples(&result->curve, &result->samples);
  sphere_check_lengths(&result->curve, &result->samples);
  fuzz_check_output(result, "sphere", in->flags.pretty);
  if (in->flags.offset) {
    sphere_check_offset(in, result, arena);
  }
}

FUZZ_TARGET(sphere, data, n) {
  static struct sphere_input in;
  struct fuzz_run run = {0};
  in = (struct sphere_input){.bytes = {data, n, 0}};
  if (!sphere_set(&in)) {
    return 0;
  }
  fuzz_solve(&run, &ph_method_sphere, &in.problem);
  if (run.status == PH_OK) {
    FUZZ_REQUIRE(run.result.diagnostics.value[PH_D_ITERATIONS] <=
                 SPHERE_STEPS_MAX);
    fuzz_certify(&run, "sphere", &in.problem, NULL);
  }
  if (run.status == PH_OK) {
    sphere_check_result(&in, &run.result, &run.out);
  }
  fuzz_end(&run);
  return 0;
}
