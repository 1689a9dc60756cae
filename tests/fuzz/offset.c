/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Fuzz target: joined and trimmed offsets of any curve in the plane.  The
 * outcome is a failure of the record, or loops: then their certificates pass or
 * are such a failure, `verify' accepts what is printed, and samples bear it
 * out, by bounds that hold between them too (see below).
 *
 * The bytes of an input:
 *   0      bits 0-1 the curve (ph, atph, cubics through points, cubics along
 *          straight lines), 2-3 how points are coded (see 7...), 4 closed,
 *          5 joined in place of trimmed, 6 miters, 7 round ends
 *   1      bits 0 both sides, 1 touching parts are kept, 2 samples in the
 *          record, 3 B-splines, 4 indented JSON, 5-6 distances, less one,
 *          7 verify is not asked
 *   2, 3   signed: the first distance and the step to the next, in quarters;
 *          of doubles in 64ths of the largest coordinate
 *   4      signed: coordinates and distances are scaled by 2 to eight times it
 *   5      signed: added to the first distance in parts of 2^-40 of a quarter,
 *          so that touches are missed by little
 *   6      the limit of miters, 1 and more in 16ths
 *   7...   the points: pairs of signed bytes, signed 16-bit numbers, doubles
 *          as they are, or steps (turn, length)
 */
#include "problem.h"

#include "check/loop.h"
#include "cli/derive.h"
#include "cli/verify.h"
#include "curve/sample/sample.h"

#include <float.h>

enum {
  OFFSET_POINTS_MAX = 12,
  OFFSET_DISTANCES_MAX = 4,
  OFFSET_SAMPLES = 8, /* of a segment, and of a piece */
  OFFSET_GRID = 9     /* places in either direction */
};

/* Of the size: what is compared may be rounded by that. */
static const double OFFSET_ROUNDING = 1e-9;

enum offset_curve { OFFSET_PH, OFFSET_ATPH, OFFSET_CUBICS, OFFSET_LINES };

struct offset_flags {
  bool closed, joined, miter, round, both, keep;
  bool samples, nurbs, pretty, unverified;
  int coding;
  enum offset_curve curve;
};

struct offset_input {
  struct fuzz_bytes bytes;
  struct offset_flags flags;
  struct ph_problem problem;
  size_t points, distances;
  double point[2 * OFFSET_POINTS_MAX];
  double line[2 * 2 * OFFSET_POINTS_MAX]; /* corners come twice */
  size_t sizes[OFFSET_POINTS_MAX];
  double distance[OFFSET_DISTANCES_MAX];
  double limit;
  struct fuzz_walk walk;
};

/* ---- the problem ------------------------------------------------------- */

static bool offset_take_points(struct offset_input *in, int exponent,
                               double *largest) {
  const int coding = in->flags.coding;
  while (in->points < OFFSET_POINTS_MAX) {
    double *p = in->point + 2 * in->points;
    if (!fuzz_take_vector(&in->bytes, coding, 2, p)) {
      break;
    }
    if (coding == 3) {
      fuzz_step(&in->walk, 2, p);
    }
    for (size_t i = 0; i < 2; i++) {
      p[i] = ldexp(p[i], 8 * exponent);
      *largest = fmax(*largest, fabs(p[i]));
    }
    in->points++;
  }
  return in->points > 0 && fuzz_is_finite(in->point, 2 * in->points);
}

/* One line after the other, and back where they are closed. */
static void offset_set_lines(struct offset_input *in) {
  struct ph_value *value = &in->problem.field[PH_F_CURVE];
  const size_t n = in->flags.closed ? in->points : in->points - 1;
  for (size_t i = 0; i < n; i++) {
    const size_t ends[] = {i, (i + 1) % in->points};
    for (size_t k = 0; k < 2; k++) {
      memcpy(in->line + 2 * (2 * i + k), in->point + 2 * ends[k],
             2 * sizeof *in->line);
    }
    in->sizes[i] = 2;
  }
  *value = fuzz_array(in->line, 2 * n, 2);
  value->kind = PH_POLYLINE;
  value->sizes = in->sizes;
  value->sizes_n = n;
}

static void offset_set_data(struct offset_input *in, double largest) {
  const enum offset_curve curve = in->flags.curve;
  fuzz_set_flag(&in->problem, PH_F_CLOSED, in->flags.closed);
  if (curve == OFFSET_LINES) {
    offset_set_lines(in);
    fuzz_set_number(&in->problem, PH_F_TOLERANCE, 1e-3 * largest);
  } else {
    in->problem.field[PH_F_POINTS] = fuzz_array(in->point, in->points, 2);
    fuzz_set_word(&in->problem, PH_F_BASIS,
                  curve == OFFSET_ATPH ? "atph" : NULL);
  }
}

/* Sets the problem and the distances; false when the bytes are none. */
static bool offset_set(struct offset_input *in) {
  uint8_t b[7];
  double largest = 0, unit;
  if (!fuzz_take(&in->bytes, b, sizeof b)) {
    return false;
  }
  in->flags = (struct offset_flags){.curve = (enum offset_curve)(b[0] & 3),
                                    .coding = b[0] >> 2 & 3,
                                    .closed = b[0] >> 4 & 1,
                                    .joined = b[0] >> 5 & 1,
                                    .miter = b[0] >> 6 & 1,
                                    .round = b[0] >> 7,
                                    .both = b[1] & 1,
                                    .keep = b[1] >> 1 & 1,
                                    .samples = b[1] >> 2 & 1,
                                    .nurbs = b[1] >> 3 & 1,
                                    .pretty = b[1] >> 4 & 1,
                                    .unverified = b[1] >> 7};
  in->distances = 1 + (b[1] >> 5 & 3);
  in->limit = 1 + b[6] / 16.0;
  if (!offset_take_points(in, (int8_t)b[4], &largest)) {
    return false;
  }
  unit = in->flags.coding == 2 ? largest / 64 : ldexp(1, 8 * (int8_t)b[4] - 2);
  for (size_t i = 0; i < in->distances; i++) {
    in->distance[i] = unit * ((int8_t)b[2] + (double)i * (int8_t)b[3] +
                              ldexp((int8_t)b[5], -40));
  }
  offset_set_data(in, largest);
  return fuzz_is_finite(in->distance, in->distances);
}

/* What the options say. */
static struct ph_options offset_options(struct offset_input *in) {
  const struct offset_flags *f = &in->flags;
  const struct ph_sample_rules samples = {.how = PH_SAMPLE_PARAMETER,
                                          .n = OFFSET_SAMPLES};
  return (struct ph_options){
      .command = ph_command_find(f->curve < OFFSET_CUBICS ? "planar" : "tc"),
      .nurbs = f->nurbs,
      .offsets = in->distance,
      .offsets_n = in->distances,
      .offset = {.mode = f->joined ? PH_OFFSET_JOINED : PH_OFFSET_TRIMMED,
                 .miter = f->miter ? in->limit : 0,
                 .round_ends = f->round && !f->closed,
                 .both = f->both && f->closed,
                 .keep = f->keep},
      .samples = samples};
}

/* ---- what samples bear out ------------------------------------------------
 *
 * Between two samples that are h apart along an arc, it stays in an ellipse:
 * its places are within h / 2 of one of them, it goes round a place that is
 * farther away as its chord does, and between it and its chord there is no more
 * than h^2 / (2 pi).
 */

struct offset_arcs {
  const struct ph_samples *samples;
  double step; /* the largest h */
};

static struct offset_arcs offset_arcs_of(const struct ph_samples *samples) {
  struct offset_arcs arcs = {samples, 0};
  for (size_t i = 1; i < samples->n; i++) {
    arcs.step = fmax(arcs.step, samples->s[i] - samples->s[i - 1]);
  }
  return arcs;
}

/* From a place to the nearest sample. */
static double offset_nearest(const struct offset_arcs *arcs, const double *p) {
  double least = HUGE_VAL;
  for (size_t i = 0; i < arcs->samples->n; i++) {
    const double *q = arcs->samples->point + 2 * i;
    least = fmin(least, hypot(q[0] - p[0], q[1] - p[1]));
  }
  return least;
}

/* How often the chords go round a place, closed: by those that cross the ray
 * from it to the right. */
static int offset_around(const struct offset_arcs *arcs, const double *p) {
  const struct ph_samples *s = arcs->samples;
  int around = 0;
  for (size_t i = 0; i < s->n; i++) {
    const double *a = s->point + 2 * i, *b = s->point + 2 * ((i + 1) % s->n);
    const double side =
        (b[0] - a[0]) * (p[1] - a[1]) - (p[0] - a[0]) * (b[1] - a[1]);
    around += a[1] <= p[1] && b[1] > p[1] && side > 0;
    around -= a[1] > p[1] && b[1] <= p[1] && side < 0;
  }
  return around;
}

/* The area of a loop is that of its chords and of what is beside them; its
 * length is no less than theirs. */
static void offset_check_area(const struct ph_loop *loop, double size) {
  const struct ph_samples *s = &loop->samples;
  double area = 0, beside = 0, length = 0;
  for (size_t i = 0; i + 1 < s->n; i++) {
    const double *a = s->point + 2 * i, *b = a + 2, *o = s->point;
    const double h = s->s[i + 1] - s->s[i];
    const double chord = hypot(b[0] - a[0], b[1] - a[1]);
    FUZZ_REQUIRE(h >= chord - OFFSET_ROUNDING * size);
    area += ((a[0] - o[0]) * (b[1] - o[1]) - (b[0] - o[0]) * (a[1] - o[1])) / 2;
    beside += h * h / 6;
    length += h;
  }
  FUZZ_REQUIRE(fabs(length - loop->length) <= OFFSET_ROUNDING * size);
  FUZZ_REQUIRE(!loop->closed || fabs(area - loop->area) <=
                                    beside + OFFSET_ROUNDING * size * size);
}

struct offset_check {
  const struct offset_input *in;
  const struct ph_curve *curve;
  struct offset_arcs curve_arcs;
  bool simple;     /* the curve is closed and does not meet itself */
  int orientation; /* then, 1: counterclockwise */
  double size;     /* and the distance */
};

/* How often loops go round a place that is surely in, or not in, what they
 * bound; false where neither is sure. */
static bool offset_expected(const struct offset_check *check, double distance,
                            const double *p, int *expected) {
  const struct offset_flags *f = &check->in->flags;
  const double reach = fabs(distance), h = check->curve_arcs.step;
  const double most = offset_nearest(&check->curve_arcs, p);
  const double least = most - h / 2, slack = OFFSET_ROUNDING * check->size;
  const bool near = most < reach - slack;
  /* a miter goes farther */
  const bool far = least > reach * (f->miter ? check->in->limit : 1) + slack;
  bool left;
  if (!near && !far) {
    return false;
  }
  if (f->both || !f->closed) {
    *expected = near;
    return true;
  }
  if (!near && !(least > slack)) {
    return false;
  }
  /* of places that are near, the side does not matter */
  left = near ? distance < 0
              : (offset_around(&check->curve_arcs, p) != 0) ==
                    (check->orientation > 0);
  *expected = left - (check->orientation < 0);
  return true;
}

/* Loops go round places as often as they should; no place of them is nearer
 * to the curve than the distance. */
static void offset_check_places(const struct offset_check *check,
                                const struct ph_offset *o) {
  const struct ph_loops *loops = &o->loops;
  const double *box = check->curve_arcs.samples->point;
  double low[2] = {box[0], box[1]}, high[2] = {box[0], box[1]};
  for (size_t i = 0; i < check->curve_arcs.samples->n; i++) {
    for (size_t k = 0; k < 2; k++) {
      low[k] = fmin(low[k], box[2 * i + k]);
      high[k] = fmax(high[k], box[2 * i + k]);
    }
  }
  for (size_t i = 0; i < (size_t)OFFSET_GRID * OFFSET_GRID; i++) {
    const size_t at[] = {i % OFFSET_GRID, i / OFFSET_GRID};
    const double reach = 1.25 * fabs(o->distance);
    double p[2];
    int expected, around = 0;
    bool sure = true;
    for (size_t k = 0; k < 2; k++) {
      const double part = ((double)at[k] + 0.47) / OFFSET_GRID;
      p[k] = low[k] - reach + part * (high[k] - low[k] + 2 * reach);
    }
    if (!offset_expected(check, o->distance, p, &expected)) {
      continue;
    }
    for (size_t l = 0; sure && l < loops->n; l++) {
      const struct offset_arcs arcs = offset_arcs_of(&loops->v[l].samples);
      sure = loops->v[l].closed && offset_nearest(&arcs, p) > arcs.step / 2;
      around += sure ? offset_around(&arcs, p) : 0;
    }
    FUZZ_REQUIRE(!sure || around == expected);
  }
}

static void offset_check_distance(const struct offset_check *check,
                                  const struct ph_offset *o) {
  const double least = fabs(o->distance) - OFFSET_ROUNDING * check->size;
  for (size_t l = 0; l < o->loops.n; l++) {
    const struct ph_samples *s = &o->loops.v[l].samples;
    for (size_t i = 0; i < s->n; i++) {
      FUZZ_REQUIRE(offset_nearest(&check->curve_arcs, s->point + 2 * i) >=
                   least);
    }
  }
}

/* Around a loop is only one of the distance before. */
static void offset_check_nest(const struct ph_result *result, size_t at) {
  const struct ph_offset *o = &result->offsets[at];
  for (size_t i = 0; i < o->loops.n; i++) {
    bool found = o->loops.v[i].parent == PH_NO_SEGMENT;
    for (size_t k = 0; !found && k < result->offsets_n; k++) {
      const struct ph_offset *other = &result->offsets[k];
      found = other->distance * o->distance > 0 &&
              fabs(other->distance) < fabs(o->distance) &&
              o->loops.v[i].parent < other->loops.n;
    }
    FUZZ_REQUIRE(found);
  }
}

/* Which way a curve goes round, 0 where that is not sure. */
static int offset_orientation(const struct offset_arcs *arcs) {
  const struct ph_samples *s = arcs->samples;
  double area = 0, beside = 0;
  for (size_t i = 0; i + 1 < s->n; i++) {
    const double *a = s->point + 2 * i, *b = a + 2, *o = s->point;
    const double h = s->s[i + 1] - s->s[i];
    area += ((a[0] - o[0]) * (b[1] - o[1]) - (b[0] - o[0]) * (a[1] - o[1])) / 2;
    beside += h * h / 6;
  }
  return fabs(area) > beside ? (area > 0 ? 1 : -1) : 0;
}

static void offset_check_loops(struct offset_check *check,
                               const struct ph_offset *o) {
  const struct offset_flags *f = &check->in->flags;
  const bool bounds = f->both || (f->closed ? check->simple : f->round);
  double area = 0;
  check->size = ph_curve_size(check->curve) + fabs(o->distance);
  for (size_t i = 0; i < o->loops.n; i++) {
    offset_check_area(&o->loops.v[i], check->size);
    area += o->loops.v[i].area;
  }
  FUZZ_REQUIRE(isnan(area) ? isnan(o->loops.area)
                           : fabs(area - o->loops.area) <=
                                 OFFSET_ROUNDING * check->size * check->size);
  if (!f->joined) {
    offset_check_distance(check, o);
  }
  if (!f->joined && !f->keep && bounds &&
      (f->both || !f->closed || check->orientation)) {
    offset_check_places(check, o);
  }
}

/* What is printed is right, says verify. */
static void offset_verify(const struct offset_input *in,
                          const struct ph_result *result, const char *command) {
  static const struct ph_worker none;
  const struct ph_options options = {.command = ph_command_find("verify")};
  const struct ph_echo echo = {0};
  const struct ph_heading heading = {.echo = &echo, .command = command};
  struct ph_worker worker = none;
  struct ph_item item = {.record = {.file = "-", .line = 1, .number = 1}};
  struct ph_buf text = {0}, out = {0}, err = {0};
  ph_json_result(&text, &heading, result, in->flags.pretty);
  FUZZ_REQUIRE(!text.failed);
  item.record.text = text.data;
  item.record.n = text.n;
  ph_verify_work(&options, &worker, &item, &out, &err);
  if (item.status != PH_OK) {
    fprintf(stderr, "%.*s", (int)err.n, err.data);
  }
  FUZZ_REQUIRE(item.status == PH_OK);
  ph_buf_free(&text);
  ph_buf_free(&out);
  ph_buf_free(&err);
  ph_worker_free(&worker);
}

/* Loops that are certified. */
static void offset_check_result(const struct offset_input *in,
                                const struct ph_derived *derived,
                                struct fuzz_run *run, const char *command) {
  struct ph_result *result = &run->result;
  struct offset_check check = {
      in, &derived->exact, offset_arcs_of(&result->samples), false, 0, 0};
  check.simple = result->diagnostics.known >> PH_D_SIMPLE & 1 &&
                 result->diagnostics.value[PH_D_SIMPLE] > 0;
  check.orientation = offset_orientation(&check.curve_arcs);
  for (size_t i = 0; i < result->offsets_n; i++) {
    FUZZ_REQUIRE(result->offsets[i].loops.trimming.certified);
    offset_check_loops(&check, &result->offsets[i]);
    offset_check_nest(result, i);
  }
  if (!in->flags.samples) {
    result->samples.n = 0;
    for (size_t i = 0; i < result->offsets_n; i++) {
      for (size_t k = 0; k < result->offsets[i].loops.n; k++) {
        result->offsets[i].loops.v[k].samples.n = 0;
      }
    }
  }
  if (!in->flags.unverified) {
    offset_verify(in, result, command);
  }
}

FUZZ_TARGET(offset, data, n) {
  static struct offset_input in;
  struct ph_options options;
  struct fuzz_run run = {0};
  struct ph_derived derived = {.paths_n = 0};
  in = (struct offset_input){.bytes = {data, n, 0}};
  if (!offset_set(&in)) {
    return 0;
  }
  options = offset_options(&in);
  fuzz_solve(&run, options.command->method, &in.problem);
  if (run.status == PH_OK) {
    fuzz_certify(&run, options.command->method->schema.command, &in.problem,
                 in.flags.curve < OFFSET_CUBICS ? ph_describe_planar
                                                : ph_describe_cubics);
  }
  if (run.status == PH_OK) {
    run.status = ph_derive(&options, &in.problem, &run.out, &run.result,
                           &derived, &run.diag);
  }
  if (run.status == PH_OK) {
    run.status =
        ph_certify_loops(&derived.exact, run.result.offsets,
                         run.result.offsets_n, &run.scratch, &run.diag);
  }
  if (run.status == PH_OK) {
    offset_check_result(&in, &derived, &run,
                        options.command->method->schema.command);
  }
  fuzz_end(&run);
  return 0;
}
