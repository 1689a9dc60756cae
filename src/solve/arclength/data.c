/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The fields of the arc-length problem (see system.h). */
#include "solve/arclength/system.h"

#include "base/sum.h"
#include "kernel/pow2.h"
#include "solve/common/fields.h"

#include <float.h>
#include <math.h>
#include <string.h>

/* A length within this of its chord, relative, is the chord. */
static const double STRAIGHT = 1e-12;

/* Points nearer than this, relative to their coordinates, coincide. */
static const double COINCIDENT = 4 * DBL_EPSILON;

/* Rounding of a coordinate, with a margin for the turn to our frame. */
static const double ROUNDING = 16 * DBL_EPSILON;

/* Below, lengths are exact; above, they are free. */
static const double SIGMA_MIN = 1e-9, SIGMA_MAX = 1e3;

/* A direction that is as uncertain as this, in radians, says nothing. */
static const double ANGLE_MAX = 10;

/* Farther from the origin a curve of mean length 1 loses its digits. */
static const double FAR = 1e12;

struct reading {
  const struct ph_problem *problem;
  struct ph_arc_data *data;
  struct ph_arena *arena;
  struct ph_diag *diag;
  const struct ph_value *vectors; /* points, derivatives or tangents */
  const char *name;               /* of these */
  struct ph_pow2 scale;           /* brings all numbers near 1 */
  double largest;                 /* of the vectors, scaled */
};

static const struct ph_value *field(const struct reading *r,
                                    enum ph_field_id id) {
  return &r->problem->field[id];
}

/* ---- what is given ------------------------------------------------------- */

static enum ph_status find_vectors(struct reading *r) {
  static const struct {
    enum ph_field_id id;
    enum ph_arc_mode mode;
  } modes[] = {{PH_F_POINTS, PH_ARC_POINTS},
               {PH_F_DERIVATIVES, PH_ARC_DERIVATIVES},
               {PH_F_TANGENTS, PH_ARC_TANGENTS}};
  for (size_t i = 0; i < 3; i++) {
    const char *name = ph_field_name(modes[i].id);
    if (!ph_fields_given(r->problem, modes[i].id)) {
      continue;
    }
    if (r->vectors) {
      return ph_fail(r->diag, PH_E_BAD_VALUE, name,
                     "excludes %s: give one of them", r->name);
    }
    r->vectors = field(r, modes[i].id);
    r->name = name;
    r->data->mode = modes[i].mode;
  }
  return r->vectors ? PH_OK
                    : ph_fail(r->diag, PH_E_MISSING_FIELD, "points",
                              "or derivatives or tangents must be given");
}

/* Fields that have a meaning only beside another. */
static enum ph_status check_company(struct reading *r) {
  bool points = r->data->mode == PH_ARC_POINTS;
  bool lengths = ph_fields_given(r->problem, PH_F_LENGTHS);
  if (field(r, PH_F_CLOSED)->flag && !points) {
    return ph_fail(r->diag, PH_E_BAD_VALUE, "closed",
                   "needs points: %s do not say where the curve comes back",
                   r->name);
  }
  if (ph_fields_given(r->problem, PH_F_START) && points) {
    return ph_fail(r->diag, PH_E_BAD_VALUE, "start",
                   "is the first of the points");
  }
  if (ph_fields_given(r->problem, PH_F_MAGNITUDES) &&
      r->data->mode != PH_ARC_TANGENTS) {
    return ph_fail(r->diag, PH_E_BAD_VALUE, "magnitudes",
                   "needs tangents: %s have theirs", r->name);
  }
  if (!lengths && !points) {
    return ph_fail(r->diag, PH_E_MISSING_FIELD, "lengths",
                   "must be given with %s", r->name);
  }
  if (ph_fields_given(r->problem, PH_F_LENGTH_SIGMA) && !lengths) {
    return ph_fail(r->diag, PH_E_BAD_VALUE, "length_sigma",
                   "needs lengths: without them they are free");
  }
  if (ph_fields_given(r->problem, PH_F_TANGENT_SIGMA) &&
      r->data->mode != PH_ARC_TANGENTS) {
    return ph_fail(r->diag, PH_E_BAD_VALUE, "tangent_sigma",
                   "needs tangents: %s have none", r->name);
  }
  if (ph_fields_given(r->problem, PH_F_TANGENT_SIGMA) &&
      ph_value_is(field(r, PH_F_MAGNITUDES), "mean")) {
    return ph_fail(r->diag, PH_E_BAD_VALUE, "tangent_sigma",
                   "needs magnitudes free");
  }
  if (ph_fields_given(r->problem, PH_F_LENGTH_SIGMA) &&
      r->data->mode == PH_ARC_TANGENTS &&
      !ph_fields_given(r->problem, PH_F_TANGENT_SIGMA) &&
      !ph_value_is(field(r, PH_F_MAGNITUDES), "mean")) {
    return ph_fail(r->diag, PH_E_BAD_VALUE, "length_sigma",
                   "needs points or derivatives, or tangent_sigma: exact "
                   "tangents contradict no lengths");
  }
  return PH_OK;
}

static enum ph_status count(struct reading *r) {
  if (r->data->mode == PH_ARC_POINTS) {
    r->data->closed = field(r, PH_F_CLOSED)->flag;
    return ph_fields_segments(r->problem, &r->data->n, r->diag);
  }
  if (r->vectors->n < 2) {
    return ph_fail(r->diag, PH_E_TOO_FEW_POINTS, r->name,
                   "must be at least 2, found %zu", r->vectors->n);
  }
  r->data->n = r->vectors->n - 1;
  return PH_OK;
}

static enum ph_status allocate(struct reading *r) {
  struct ph_arc_data *d = r->data;
  bool points = d->mode == PH_ARC_POINTS;
  d->h = ph_arena_array(r->arena, d->n, sizeof *d->h);
  d->knots = ph_arena_array(r->arena, d->n + 1, sizeof *d->knots);
  if (ph_fields_given(r->problem, PH_F_LENGTHS)) {
    d->length = ph_arena_array(r->arena, d->n, sizeof *d->length);
    if (!d->length) {
      return ph_fail_memory(r->diag);
    }
  }
  if (points) {
    d->chord = ph_arena_array(r->arena, d->n, sizeof *d->chord);
    d->step = ph_arena_array(r->arena, d->n, sizeof *d->step);
  } else {
    d->given = ph_arena_array(r->arena, d->n + 1, sizeof *d->given);
  }
  return d->h && d->knots && (points ? d->chord && d->step : !!d->given)
             ? PH_OK
             : ph_fail_memory(r->diag);
}

/* ---- lengths and vectors ------------------------------------------------- */

static enum ph_status read_lengths(struct reading *r) {
  const struct ph_value *sigma = field(r, PH_F_LENGTH_SIGMA);
  const struct ph_value *lengths = field(r, PH_F_LENGTHS);
  double most = 0;
  enum ph_status status;
  if (sigma->kind != PH_ABSENT) {
    r->data->sigma = sigma->number;
    if (!(sigma->number >= SIGMA_MIN && sigma->number <= SIGMA_MAX)) {
      return ph_fail(r->diag, PH_E_BAD_VALUE, "length_sigma",
                     "must be between %g and %g, found %.17g", SIGMA_MIN,
                     SIGMA_MAX, sigma->number);
    }
  }
  if (!r->data->length) {
    return PH_OK;
  }
  if (lengths->kind == PH_NUMBERS && lengths->n != r->data->n) {
    return ph_fail(r->diag, PH_E_BAD_SHAPE, "lengths",
                   "must have %zu numbers, one from datum to datum, found %zu",
                   r->data->n, lengths->n);
  }
  status = ph_fields_each(lengths, "lengths", r->data->n, (double)INFINITY,
                          "greater than 0", r->data->length, r->diag);
  most = ph_fields_largest(r->data->length, status == PH_OK ? r->data->n : 0);
  for (size_t i = 0; status == PH_OK && i < r->data->n; i++) {
    if (!(r->data->length[i] > most * 1e-12)) {
      return ph_fail_at(r->diag, PH_E_TOO_LARGE, "lengths", i,
                        "must be above 1e-12 of the largest, %.17g, found "
                        "%.17g",
                        most, r->data->length[i]);
    }
  }
  return status;
}

/* One for all, or one each; 0 is exact. */
static enum ph_status read_tangent_sigma(struct reading *r) {
  const struct ph_value *sigma = field(r, PH_F_TANGENT_SIGMA);
  size_t n = r->data->n + 1;
  bool any = false;
  if (sigma->kind == PH_ABSENT) {
    return PH_OK;
  }
  if (sigma->kind == PH_NUMBERS && sigma->n != n) {
    return ph_fail(r->diag, PH_E_BAD_SHAPE, "tangent_sigma",
                   "must have %zu numbers, one for each tangent, found %zu", n,
                   sigma->n);
  }
  r->data->tangent_sigma = ph_arena_array(r->arena, n, sizeof(double));
  if (!r->data->tangent_sigma) {
    return ph_fail_memory(r->diag);
  }
  for (size_t j = 0; j < n; j++) {
    bool each = sigma->kind == PH_NUMBERS;
    double s = each ? sigma->v[j] : sigma->number;
    r->data->tangent_sigma[j] = s;
    any = any || s > 0;
    if (!((s >= SIGMA_MIN && s <= ANGLE_MAX) || (s >= 0 && s <= 0))) {
      const char *range = "must be 0 or between %g and %g, found %.17g";
      return each ? ph_fail_at(r->diag, PH_E_BAD_VALUE, "tangent_sigma", j,
                               range, SIGMA_MIN, ANGLE_MAX, s)
                  : ph_fail(r->diag, PH_E_BAD_VALUE, "tangent_sigma", range,
                            SIGMA_MIN, ANGLE_MAX, s);
    }
  }
  r->data->tangent_sigma = any ? r->data->tangent_sigma : NULL;
  return any || !(r->data->sigma > 0)
             ? PH_OK
             : ph_fail(r->diag, PH_E_BAD_VALUE, "length_sigma",
                       "needs a tangent_sigma above 0: exact tangents "
                       "contradict no lengths");
}

static ph_vec3 vector(const struct reading *r, size_t j) {
  size_t dimension = r->vectors->dimension;
  const double *v = r->vectors->v + dimension * j;
  return ph_vec3_of(ph_pow2_apply(r->scale, v[0]),
                    ph_pow2_apply(r->scale, v[1]),
                    dimension > 2 ? ph_pow2_apply(r->scale, v[2]) : 0);
}

static enum ph_status read_points(struct reading *r) {
  struct ph_arc_data *d = r->data;
  d->points = r->vectors->v;
  d->dimension = r->vectors->dimension;
  for (size_t i = 0; i < d->n; i++) {
    size_t to = d->closed && i + 1 == d->n ? 0 : i + 1;
    d->step[i] = ph_vec3_sub(vector(r, to), vector(r, i));
    d->chord[i] = ph_vec3_abs(d->step[i]);
    if (!(d->chord[i] > COINCIDENT * r->largest)) {
      return ph_fields_coincide(r->diag, "points", i, to);
    }
  }
  return PH_OK;
}

/* Of tangents the directions, each brought to length 1 at its own scale. */
static enum ph_status read_given(struct reading *r) {
  struct ph_arc_data *d = r->data;
  for (size_t j = 0; j <= d->n; j++) {
    const double *v = r->vectors->v + r->vectors->dimension * j;
    double most = ph_fields_largest(v, r->vectors->dimension);
    if (!(most > 0)) {
      return ph_fail_at(r->diag, PH_E_ZERO_TANGENT, r->name, j,
                        "must not be zero");
    }
    if (d->mode == PH_ARC_TANGENTS) {
      d->given[j] = ph_fields_unit(ph_fields_vector(r->vectors, j));
    } else {
      d->given[j] = vector(r, j);
      if (!(ph_vec3_abs(d->given[j]) > COINCIDENT)) {
        return ph_fail_at(r->diag, PH_E_TOO_LARGE, r->name, j,
                          "is too small beside the other numbers");
      }
    }
  }
  return PH_OK;
}

/* All numbers near 1, then divided by the mean length. */
static enum ph_status read_numbers(struct reading *r) {
  struct ph_arc_data *d = r->data;
  size_t n = r->vectors->n * r->vectors->dimension;
  bool directions = d->mode == PH_ARC_TANGENTS;
  double most = directions ? 0 : ph_fields_largest(r->vectors->v, n);
  double longest = d->length ? ph_fields_largest(d->length, d->n) : 0;
  int exponent;
  if (d->mode == PH_ARC_POINTS && longest > FAR * most && most > 0) {
    return ph_fail(r->diag, PH_E_TOO_LARGE, "lengths",
                   "must be within %g of the coordinates", FAR);
  }
  most = most > longest ? most : longest;
  if (!(most > 0)) {
    return d->mode == PH_ARC_POINTS
               ? ph_fields_coincide(r->diag, r->name, 0, 1)
               : ph_fail_at(r->diag, PH_E_ZERO_TANGENT, r->name, 0,
                            "must not be zero");
  }
  exponent = ph_pow2_exponent(most);
  exponent -= exponent & 1; /* its half is the root's */
  r->scale = ph_pow2_of(-exponent);
  r->largest = directions ? 1 : ph_pow2_apply(r->scale, most);
  d->root = ldexp(1, exponent / 2);
  for (size_t i = 0; d->length && i < d->n; i++) {
    d->length[i] = ph_pow2_apply(r->scale, d->length[i]);
  }
  return d->mode == PH_ARC_POINTS ? read_points(r) : read_given(r);
}

/* A length is at least its chord; one that is the chord leaves its interval so
 * little freedom that the rows are dependent there. */
static enum ph_status check_chords(const struct reading *r, bool all) {
  const struct ph_arc_data *d = r->data;
  size_t straight = 0, first = 0;
  if (!d->chord || !d->length || d->sigma > 0) {
    return PH_OK;
  }
  for (size_t shown = 0; shown < d->n; shown++) {
    size_t i = ph_arc_data_ours(d, shown);
    double back = d->root * d->root;
    if (!(d->length[i] >= d->chord[i] * (1 - STRAIGHT))) {
      return ph_fail_at(r->diag, PH_E_INFEASIBLE, "lengths", shown,
                        "is %.15g, below the chord %.15g of interval %zu; "
                        "length_sigma allows for lengths that were measured",
                        d->length[i] * back, d->chord[i] * back, shown);
    }
    if (d->length[i] - d->chord[i] <= STRAIGHT * d->length[i] &&
        straight++ == 0) {
      first = shown;
    }
  }
  if (straight > 0 && !all) {
    double length = d->length[ph_arc_data_ours(d, first)];
    return ph_fail_at(r->diag, PH_E_BAD_VALUE, "lengths", first,
                      "is %.15g, the chord of interval %zu: that would have "
                      "to be straight and others not, which is not looked "
                      "for; length_sigma allows for lengths that were measured",
                      length * d->root * d->root, first);
  }
  return PH_OK;
}

/* ---- knots --------------------------------------------------------------- */

/* Spacings in proportion to v, their mean 1. */
static void set_spacings(struct ph_arc_data *d, const double *v) {
  double mean = ph_fields_sum(v, d->n) / (double)d->n;
  for (size_t i = 0; i < d->n; i++) {
    d->h[i] = v[i] / mean;
  }
}

/* Knots given as numbers: derivatives are by them. */
static enum ph_status read_knot_numbers(struct reading *r) {
  struct ph_arc_data *d = r->data;
  const struct ph_value *knots = field(r, PH_F_KNOTS);
  enum ph_status status =
      ph_fields_knots(knots, d->n, d->closed, d->h, r->diag);
  double period;
  if (status != PH_OK) {
    return status;
  }
  memcpy(d->knots, knots->v, (d->n + 1) * sizeof *d->knots);
  period = (d->knots[d->n] - d->knots[0]) / (double)d->n;
  if (!isfinite(period)) {
    return ph_fail(r->diag, PH_E_TOO_LARGE, "knots",
                   "their range is more than a double can hold");
  }
  set_spacings(d, d->h);
  for (size_t i = 0; i < d->n; i++) {
    if (!(d->h[i] > 1e-12)) {
      return ph_fail_at(r->diag, PH_E_TOO_LARGE, "knots", i + 1,
                        "must be more than 1e-12 of the mean spacing after "
                        "the knot before");
    }
  }
  for (size_t j = 0; d->mode == PH_ARC_DERIVATIVES && j <= d->n; j++) {
    d->given[j] = ph_vec3_scale(period, d->given[j]);
  }
  return PH_OK;
}

static enum ph_status read_knots(struct reading *r) {
  struct ph_arc_data *d = r->data;
  const struct ph_value *knots = field(r, PH_F_KNOTS);
  if (knots->kind == PH_NUMBERS) {
    return read_knot_numbers(r);
  }
  if (ph_value_is(knots, "chordal") && !d->chord) {
    return ph_fail(r->diag, PH_E_BAD_VALUE, "knots",
                   "chordal needs points: %s have no chords", r->name);
  }
  if (ph_value_is(knots, "lengths") && !d->length) {
    return ph_fail(r->diag, PH_E_BAD_VALUE, "knots",
                   "lengths needs lengths, which are not given");
  }
  if (ph_value_is(knots, "uniform")) {
    for (size_t i = 0; i < d->n; i++) {
      d->h[i] = 1;
    }
  } else if (ph_value_is(knots, "chordal") || !d->length) {
    set_spacings(d, d->chord);
  } else {
    set_spacings(d, d->length);
  }
  ph_fields_sums(d->h, d->n, d->knots);
  d->knots[d->n] = (double)d->n;
  return PH_OK;
}

/* ---- the whole ----------------------------------------------------------- */

/* The unit is the mean length, or chord. */
static void normalise(struct reading *r) {
  struct ph_arc_data *d = r->data;
  const double *v = d->length ? d->length : d->chord;
  double mean = ph_fields_sum(v, d->n) / (double)d->n, per = 1 / mean;
  d->root *= sqrt(mean);
  r->largest *= per;
  for (size_t i = 0; i < d->n; i++) {
    if (d->length) {
      d->length[i] *= per;
    }
    if (d->chord) {
      d->chord[i] *= per;
      d->step[i] = ph_vec3_scale(per, d->step[i]);
    }
  }
  for (size_t j = 0; d->mode == PH_ARC_DERIVATIVES && j <= d->n; j++) {
    d->given[j] = ph_vec3_scale(per, d->given[j]);
  }
}

double ph_arc_data_speed(const struct ph_arc_data *d, size_t j) {
  size_t before = j > 0 ? j - 1 : 0, after = j < d->n ? j : d->n - 1;
  return (d->length[before] / d->h[before] + d->length[after] / d->h[after]) /
         2;
}

static void set_magnitudes(struct reading *r) {
  struct ph_arc_data *d = r->data;
  if (d->mode == PH_ARC_TANGENTS &&
      ph_value_is(field(r, PH_F_MAGNITUDES), "mean")) {
    for (size_t j = 0; j <= d->n; j++) {
      d->given[j] = ph_vec3_scale(ph_arc_data_speed(d, j), d->given[j]);
    }
    d->mode = PH_ARC_DERIVATIVES;
  }
}

static void read_start(struct reading *r) {
  const struct ph_value *start = field(r, PH_F_START);
  memset(r->data->start, 0, sizeof r->data->start);
  if (r->data->mode == PH_ARC_POINTS) {
    memcpy(r->data->start, r->vectors->v,
           r->vectors->dimension * sizeof(double));
  } else if (start->kind != PH_ABSENT) {
    memcpy(r->data->start, start->v, start->n * sizeof(double));
  }
}

static enum ph_status check_distance(const struct reading *r) {
  const struct ph_arc_data *d = r->data;
  for (size_t k = 0; d->mode != PH_ARC_POINTS && k < 3; k++) {
    if (!(fabs(d->start[k]) / d->root / d->root <= FAR)) {
      return ph_fail(r->diag, PH_E_TOO_LARGE, "start",
                     "must be within %g mean lengths of the origin", FAR);
    }
  }
  return PH_OK;
}

static enum ph_status check_start(struct reading *r) {
  const struct ph_value *start = field(r, PH_F_START);
  return start->kind != PH_ABSENT && start->n != 2 && start->n != 3
             ? ph_fail(r->diag, PH_E_BAD_SHAPE, "start",
                       "must have 2 or 3 numbers, found %zu", start->n)
             : PH_OK;
}

/* Of points by their coordinates, of other vectors by the largest of them. */
static void set_rounding(struct reading *r) {
  struct ph_arc_data *d = r->data;
  double most = r->largest;
  for (size_t j = 0; d->given && j <= d->n; j++) {
    double size = ph_vec3_abs(d->given[j]);
    most = j == 0 || size > most ? size : most;
  }
  d->rounding = ROUNDING * (most > 1 || d->given ? most : 1);
}

static bool lengths_are_chords(const struct ph_arc_data *d) {
  bool all = true;
  for (size_t i = 0; d->length && d->chord && i < d->n; i++) {
    all = all && fabs(d->length[i] - d->chord[i]) <= STRAIGHT * d->length[i];
  }
  return all;
}

enum ph_status ph_arc_data_read(const struct ph_problem *problem,
                                struct ph_arena *arena, struct ph_arc_data *d,
                                struct ph_diag *diag) {
  static enum ph_status (*const steps[])(struct reading *) = {
      find_vectors, check_company,      check_start,  count,     allocate,
      read_lengths, read_tangent_sigma, read_numbers, read_knots};
  struct reading r = {
      .problem = problem, .data = d, .arena = arena, .diag = diag};
  enum ph_status status = PH_OK;
  memset(d, 0, sizeof *d);
  for (size_t i = 0; status == PH_OK && i < sizeof steps / sizeof *steps; i++) {
    status = steps[i](&r);
  }
  if (status != PH_OK) {
    return status;
  }
  read_start(&r);
  normalise(&r);
  set_magnitudes(&r);
  set_rounding(&r);
  ph_arc_data_pose(d);
  d->straight = d->straight && lengths_are_chords(d);
  status = check_distance(&r);
  return status == PH_OK ? check_chords(&r, d->straight) : status;
}
